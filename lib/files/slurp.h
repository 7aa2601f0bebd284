/* SPDX-License-Identifier: MIT */
/* A whole file in memory. */
#ifndef TRK_FILES_SLURP_H
#define TRK_FILES_SLURP_H

#include "base/base.h"

/* *out_bytes: to be freed with trk_free(). TRK_E_FILE, TRK_E_MEMORY. */
trk_status trk_slurp(trk_context *context, const char *path, char **out_bytes, size_t *out_size);
/* The same of at most that many bytes, else TRK_E_FILE. */
trk_status trk_slurp_small(trk_context *context, const char *path, int64_t most, char **out_bytes,
                           size_t *out_size);

#endif
