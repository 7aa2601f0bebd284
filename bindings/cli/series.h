/* SPDX-License-Identifier: MIT */
/* Recorded channels as files. */
#ifndef TRUCKRIDE_CLI_SERIES_H
#define TRUCKRIDE_CLI_SERIES_H

#include "session.h"

enum { SERIES_AUTO = 0, SERIES_CSV = 1, SERIES_JSON = 2, SERIES_MAT = 3, SERIES_RPC = 4 };

/* Write to --out, by format or, with SERIES_AUTO, by suffix. */
int series_write(session *s, const trk_series *series, int32_t format);

#endif
