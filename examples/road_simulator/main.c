/* SPDX-License-Identifier: MIT */
/*
 * The road-simulator study of T. Lundberg, Analysis of simplified dynamic truck models
 * for parameter evaluation (KTH, 2013), on the reference tractor.
 *
 *     road_simulator [DIRECTORY [AMPLITUDE]]
 *
 * DIRECTORY (default .) receives CSV files; AMPLITUDE is that of the sweep at 1 Hz in
 * metres (default 0.001, as the thesis's text says; its figure 17 looks like 0.01).
 */
#include "road_simulator.h"

#include <stdlib.h>

int main(int argc, char **argv)
{
    const char *directory = argc > 1 ? argv[1] : ".";
    double amplitude = argc > 2 ? strtod(argv[2], NULL) : 0.001;
    trk_context *context;
    if (argc > 3 || !(amplitude > 0)) {
        fprintf(stderr, "usage: road_simulator [DIRECTORY [AMPLITUDE]]\n");
        return 2;
    }
    if (trk_context_create(NULL, NULL, &context) != TRK_OK)
        return 1;
    run_study(context, directory, amplitude);
    run_verification(context, directory);
    trk_context_destroy(context);
    return 0;
}
