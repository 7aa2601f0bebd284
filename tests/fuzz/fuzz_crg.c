/* SPDX-License-Identifier: MIT */
/* Random bytes as OpenCRG surfaces, evaluated here and there. */
#include "fuzz.h"

#include <math.h>
#include <truckride/crg.h>

#define SEED(text)                                                                                 \
    {                                                                                              \
        text, sizeof text - 1                                                                      \
    }
#define ROAD "$CT\nt\n$\n$ROAD_CRG\nREFERENCE_LINE_INCREMENT = 1.0 ! m\n"
const fuzz_seed fuzz_seeds[] = {
    SEED(ROAD "LONG_SECTION_V_INCREMENT = 0.50\n$\n$KD_Definition\n#:LRFI\nD:long section 1,m\n"
              "D:long section 2,m\n$\n$$$$\n 0.0000000-0.0111111\n *missing* 0.0222222\n"),
    SEED(ROAD "REFERENCE_LINE_START_Z=1\nREFERENCE_LINE_END_Z=2\n$\n$ROAD_CRG_OPTS\n"
              "BORDER_MODE_U = 3\nBORDER_MODE_V = 4\n$\n$ROAD_CRG_MODS\nGRID_NAN_MODE = 2\n$\n"
              "$KD_Definition\n#:LRFI\nD:reference line phi,rad\nD:reference line banking,m/m\n"
              "D:reference line slope,m/m\nD:long section at v = -1,m\n"
              "D:long section at v = 0.1,m\nD:long section at v = 2,m\n$\n$$$$\n"
              "**unused**        .1**unused**         1         2         3\n"
              "         0        .1         1         1         2         3\n"
              "         0        .1         1         1 *missing*         3\n"),
    SEED(ROAD "REFERENCE_LINE_END_U = 2\nLONG_SECTION_V_LEFT = 1\nLONG_SECTION_V_RIGHT = 0\n$\n"
              "$KD_DEFINITION\n#:KRBI\nD:long section 1,m\nD:long section 2,m\n$\n$$$$\n"
              "?abc?bcd?cde?def?efg?fgh"),
    {NULL, 0},
};

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static const double place[] = {0, 0.5, -1e300, 1e300, 1.75, -3.3, INFINITY, NAN};
    trk_context *context = fuzz_begin(size);
    trk_crg *crg;
    volatile double sum = 0; /* heights may be anything; computing them must be harmless */
    if (trk_crg_parse(context, "x", bytes, size, NULL, &crg) == TRK_OK) {
        for (int k = 0; k < 64; k++)
            sum += trk_crg_height(crg, place[k % 8], place[k / 8]);
        trk_signal *signal;
        for (int32_t smooth = 0; smooth < 2; smooth++)
            if (trk_crg_profile(context, crg, 0.25, smooth, &signal) == TRK_OK) {
                sum += trk_signal_rate(signal, 0.7) + trk_signal_value(signal, 1e300);
                trk_signal_destroy(signal);
            }
        trk_crg_destroy(crg);
    }
    fuzz_end(context);
    return 0;
}
