/* SPDX-License-Identifier: MIT */
/* Random bytes as ERD profiles. */
#include "fuzz.h"

#include <truckride/files.h>

#define SEED(text)                                                                                 \
    {                                                                                              \
        text, sizeof text - 1                                                                      \
    }
const fuzz_seed fuzz_seeds[] = {
    SEED("ERDFILEV2.00\n 2, 3,-1,1,5,0.0250,-1,\nTITLE   x\nSHORTNAMa       b\n"
         "UNITSNAMmm      in\nXUNITS  ft\nEND\n1 2 3\n4 5,6\n"),
    SEED("ERDFILEV2.00\r\n1,0,-1,1,5,1,-1\r\nEND\r\n1e3\r\n2\r\n"),
    SEED("ERDFILEV2.00\n2,2,1,8,0,0.1,-1\nGAIN    0.5 2\nOFFSET  1 0\nEND\n\1\2\3\4\5\6\7\10"),
    SEED("ERDFILEV2.00\n1,2,1,8,1,0.1,-1\nEND\n\1\2\3\4\5\6\7\10"),
    {NULL, 0},
};

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    trk_context *context = fuzz_begin(size);
    trk_series *series;
    if (trk_series_parse_erd(context, "x", bytes, size, &series) == TRK_OK)
        trk_series_destroy(series);
    fuzz_end(context);
    return 0;
}
