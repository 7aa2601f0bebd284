/* SPDX-License-Identifier: MIT */
/* Needs NLOPT. */
/*
 * Tires of the reference tractor trimmed to the axle frequencies that were measured on the
 * road simulator, 13.8 Hz in front and 10 Hz at the rear, as T. Lundberg, Analysis of
 * simplified dynamic truck models for parameter evaluation (KTH, 2013), section 8, trims
 * his; but by three different readings of "frequency of the axle", on four models in three
 * variants, with a confidence interval.
 *
 *     calibrate_tires [DIRECTORY]
 *
 * DIRECTORY (default .) receives factors.csv, peaks.csv and the spectra psd_*.csv.
 */
#include "calibrate_tires.h"

static const struct {
    const char *name;
    trk_variant variant;
} variants[VARIANTS] = {{"linear", TRK_VARIANT_LINEAR},
                        {"thesis_dampers", TRK_VARIANT_THESIS_DAMPERS},
                        {"nonlinear", TRK_VARIANT_NONLINEAR}};

int main(int argc, char **argv)
{
    const char *directory = argc > 1 ? argv[1] : ".";
    trk_context *context;
    static trimmed all[VARIANTS][TRUCK_MODELS];
    if (argc > 2) {
        fprintf(stderr, "usage: calibrate_tires [DIRECTORY]\n");
        return 2;
    }
    if (trk_context_create(NULL, NULL, &context) != TRK_OK)
        return 1;
    FILE *factors = open_result(directory, "factors.csv");
    write_factor_head(factors);
    for (int v = 0; v < VARIANTS; v++)
        for (int m = 0; m < TRUCK_MODELS; m++) {
            trimmed *t = &all[v][m];
            t->model = &truck_models[m];
            t->variant = variants[v].name;
            check(context, trk_vehicle_create_builtin(context, t->model->vehicle,
                                                      variants[v].variant, &t->spec));
            calibrate(context, t);
            write_factors(t, factors);
            fflush(stdout);
        }
    fclose(factors);
    for (int v = 0; v < VARIANTS; v++)
        for (int m = 0; m < TRUCK_MODELS; m++)
            print_remarks(&all[v][m]);

    FILE *peaks = open_result(directory, "peaks.csv");
    double difference = 0;
    write_peaks_head(peaks);
    for (int v = 0; v < VARIANTS; v++)
        for (int m = 0; m < TRUCK_MODELS; m++) {
            double d = write_spectra(context, &all[v][m], directory, peaks);
            difference = d > difference ? d : difference;
            trk_spec_destroy(all[v][m].spec);
        }
    fclose(peaks);
    printf(
        "\nThe peaks of the calibrations (sweep of 120 s, steps of 2 ms) differ from those of the\n"
        "full run (480 s, 1 ms) by at most %.2f %%.\n",
        100 * difference);
    trk_context_destroy(context);
    return 0;
}
