/* SPDX-License-Identifier: MIT */
/* The table of modes, for all who print one. */
#ifndef TRUCKRIDE_CLI_MODES_H
#define TRUCKRIDE_CLI_MODES_H

#include "table.h"

/* An empty table of modes, with a column for the vehicle if labelled. */
table *modes_table(bool labelled);

/* Add the lowest `count` modes; label NULL if the table has no column for it. */
void modes_rows(table *t, const char *label, const trk_model *model, const trk_modes *modes,
                int32_t count);

#endif
