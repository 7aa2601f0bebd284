/* SPDX-License-Identifier: MIT */
/* Reading and checking the options of the stepper. */
#ifndef TRK_NEWMARK_OPTIONS_H
#define TRK_NEWMARK_OPTIONS_H

#include "base/base.h"
#include <truckride/newmark.h>

trk_status trk_newmark_read_options(trk_context *context, const trk_newmark_options *options,
                                    trk_newmark_options *out);

#endif
