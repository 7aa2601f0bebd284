/* SPDX-License-Identifier: MIT */
/* Spectra of several channels, wherever they come from. */
#ifndef TRUCKRIDE_CLI_PSD_H
#define TRUCKRIDE_CLI_PSD_H

#include "run.h"

typedef struct psd_settings {
    run_options run;
    bool linear, linearise, rms;
    int64_t segment;
    double overlap, from, to;
    int32_t window, weighting;
} psd_settings;

typedef struct psd_channel {
    const char *name, *unit; /* of the signal; borrowed */
} psd_channel;

typedef struct psd_spectra {
    int64_t length;
    double step; /* [Hz] */
    int channels;
    psd_channel *channel;
    double *density;    /* channels x length */
    trk_series *series; /* owns the names, or */
    trk_model *model;
    road road;
} psd_spectra;

/* Of a recording, of a run, or of a linear model without one; EXIT_DONE or the exit code. */
int psd_of_recording(session *s, const psd_settings *o, psd_spectra *out);
int psd_of_run(session *s, psd_settings *o, psd_spectra *out);
void psd_close(psd_spectra *p);

/* Replace the model by the one linearised for the motion on its road (trk_model_linearise). */
trk_status psd_linearise(session *s, const trk_spectrum_options *options, int64_t samples,
                         double step, psd_spectra *p);

#endif
