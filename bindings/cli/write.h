/* SPDX-License-Identifier: MIT */
/* One table in each of the formats. */
#ifndef TRUCKRIDE_CLI_WRITE_H
#define TRUCKRIDE_CLI_WRITE_H

#include "table.h"

/* Aligned columns under their names and units. */
void table_align(FILE *file, const table *t, bool colour);

#endif
