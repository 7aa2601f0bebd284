/* SPDX-License-Identifier: MIT */
/* Needs NLOPT. */
/*
 * Standard, harder and no front-axle damper on the road simulator: the variation of
 * T. Lundberg, Analysis of simplified dynamic truck models for parameter evaluation (KTH,
 * 2013), section 8.4, on the reference tractor with the thesis's dampers and with tires
 * trimmed to the measured axle frequencies.
 *
 *     damper_study [DIRECTORY]
 *
 * DIRECTORY (default .) receives damper_table.csv, findings.txt and the spectra
 * damper_psd_*.csv.
 */
#include "damper_study.h"

int main(int argc, char **argv)
{
    const char *directory = argc > 1 ? argv[1] : ".";
    trk_context *context;
    study all[STUDIED];
    if (argc > 2) {
        fprintf(stderr, "usage: damper_study [DIRECTORY]\n");
        return 2;
    }
    if (trk_context_create(NULL, NULL, &context) != TRK_OK)
        return 1;
    FILE *table = open_result(directory, "damper_table.csv");
    print_both(table, "model,channel,configuration,eigenfrequency_hz,peak_hz,peak_psd,rms,"
                      "rms_axle_band\n");
    for (int k = 0; k < STUDIED; k++) {
        run_configurations(context, k, directory, &all[k]);
        write_table(&all[k], k, table);
    }
    fclose(table);
    write_damper_curves(context, directory);
    FILE *findings = open_result(directory, "findings.txt");
    write_findings(all, findings);
    fclose(findings);
    trk_context_destroy(context);
    return 0;
}
