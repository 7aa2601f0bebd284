/* SPDX-License-Identifier: MIT */
/* Recorded channels from a file or standard input. */
#ifndef TRUCKRIDE_COMMON_RECORDING_H
#define TRUCKRIDE_COMMON_RECORDING_H

#include <truckride/truckride.h>

/*
 * Read a recording in SI units. kind: "csv", "erd", "rpc" or NULL: by the suffix of the path, CSV
 * for an unknown one. The path "-" is standard input.
 */
trk_status recording_read(trk_context *context, const char *path, const char *kind,
                          trk_series **out_series);

/* All of standard input, to be freed; NULL if there is no memory or it cannot be read. */
void *read_standard_input(size_t *out_size);

#endif
