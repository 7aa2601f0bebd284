/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. */
/*
 * Ride comfort and road loads on random roads: the reference tractor with the dampers of the
 * thesis, and with linear ones, over ISO 8608 roads of class B and C at 50, 70 and 90 km/h, with
 * the standard front dampers, harder ones and none.
 *
 *     comfort_study [DIRECTORY]
 *
 * DIRECTORY (default .) receives comfort_table.csv and .txt, agreement.csv, findings.txt and the
 * spectra psd_time.csv, psd_frequency.csv.
 */
#include "comfort_study.h"

#include <stdlib.h>

/* Resonances without front dampers are a few 0.1 Hz wide. */
static const double line_spacing = 0.01; /* [Hz] */

static void judge_runs(trk_context *context, int truck, judgement *out, double **out_density,
                       int64_t *out_length, double *out_step)
{
    int64_t samples, settled = (int64_t)(settling * RATE);
    double *x = drive_all(context, truck, &samples);
    const double *shown =
        x + (case_of(SHOWN_CLASS, SHOWN_SPEED, STANDARD) * CHANNELS + CAB_Z) * samples + settled;
    for (int k = 0; k < CASES; k++)
        judge_run(context, samples, x + k * CHANNELS * samples, &out[k]);
    *out_density = run_psd(context, samples - settled, shown, out_length, out_step);
    free(x);
}

static void judge_computed(trk_context *context, judgement *out, const char *directory)
{
    for (int class = 0; class < CLASSES; class ++)
        for (int speed = 0; speed < SPEEDS; speed++)
            for (int damper = 0; damper < DAMPERS; damper++) {
                int shown = class == SHOWN_CLASS && speed == SHOWN_SPEED && damper == STANDARD;
                double *density = NULL;
                judge_spectra(context, class, speed, damper, line_spacing,
                              &out[case_of(class, speed, damper)], shown ? &density : NULL);
                if (shown)
                    write_computed_psd(road_frequencies(speed, line_spacing), line_spacing, density,
                                       directory);
                free(density);
            }
}

int main(int argc, char **argv)
{
    const char *directory = argc > 1 ? argv[1] : ".";
    trk_context *context;
    study s;
    double *density[TRUCKS], step;
    int64_t length;
    if (argc > 2) {
        fprintf(stderr, "usage: comfort_study [DIRECTORY]\n");
        return 2;
    }
    if (trk_context_create(NULL, NULL, &context) != TRK_OK)
        return 1;
    for (int truck = 0; truck < TRUCKS; truck++)
        judge_runs(context, truck, s.driven[truck], &density[truck], &length, &step);
    judge_computed(context, s.computed, directory);
    write_run_psd(length, step, density, directory);
    write_table(&s, directory);
    write_agreement(&s, directory);
    write_findings(&s, directory);
    for (int truck = 0; truck < TRUCKS; truck++)
        free(density[truck]);
    trk_context_destroy(context);
    return 0;
}
