/* SPDX-License-Identifier: MIT */
/* Checked settings of a spectrum, and checks that all public functions share. */
#ifndef TRK_SPECTRUM_SETTINGS_H
#define TRK_SPECTRUM_SETTINGS_H

#include "base/base.h"
#include <truckride/spectrum.h>

typedef struct trk_spectrum_settings {
    trk_spectrum_options options; /* segment_length is never 0 here */
    int64_t step;                 /* from one segment to the next    */
    int64_t segments;
    int64_t length; /* number of frequencies           */
} trk_spectrum_settings;

/* what is the public function, in front of messages. context may be NULL. */
trk_status trk_spectrum_resolve(trk_context *context, const char *what,
                                const trk_spectrum_options *options, int64_t count,
                                trk_spectrum_settings *out_settings);

trk_status trk_check_rate(trk_context *context, const char *what, const char *name, double rate);
trk_status trk_check_samples(trk_context *context, const char *what, const char *name,
                             int64_t count, const double *x);
trk_status trk_check_density(trk_context *context, const char *what, int64_t length,
                             const double *density);

#endif
