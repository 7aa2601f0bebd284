/* SPDX-License-Identifier: MIT */
/* Vehicles as model files. */
#ifndef TRUCKRIDE_CLI_EXPORT_H
#define TRUCKRIDE_CLI_EXPORT_H

#include "session.h"

/* Write a spec to `path`, "-" or NULL for standard output; the exit code. */
int export_model(session *s, const trk_spec *spec, const char *path);

#endif
