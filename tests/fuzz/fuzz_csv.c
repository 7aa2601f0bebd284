/* SPDX-License-Identifier: MIT */
/* Random bytes as CSV: as a series, as a signal, and with a decimal comma. */
#include "fuzz.h"

#include <math.h>
#include <truckride/files.h>

#define SEED(text)                                                                                 \
    {                                                                                              \
        text, sizeof text - 1                                                                      \
    }
const fuzz_seed fuzz_seeds[] = {
    SEED("time [s],a [m],b\n0,1,2\n0.5,3,4\n1,5,6\n"),
    SEED("\357\273\277t;a;a\r\ns;mm;\r\n0;1,5;2\r\n1;3;4,25\r\n"),
    SEED("# x\n10 1\n10.25 2e-3\n10.5 3\n"),
    SEED("\"t\",\"a, \"\"b\"\"\n(m)\",\n0,\"1\",\n1,-2.5E+3,\n"),
    {NULL, 0},
};

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    trk_context *context = fuzz_begin(size);
    trk_csv_options options;
    trk_csv_options_init(&options, sizeof options);
    for (int32_t comma = 0; comma < 2; comma++) {
        trk_series *series;
        trk_signal *signal;
        options.decimal_comma = comma;
        options.spacing_tolerance = comma ? 0.5 : 0.01;
        if (trk_series_parse_csv(context, "x", bytes, size, &options, &series) == TRK_OK) {
            fuzz_check(trk_series_to_si(series) == TRK_OK, "units are not converted");
            trk_series_destroy(series);
        }
        if (trk_signal_parse_csv(context, "x", bytes, size, &options, 1, &signal) == TRK_OK) {
            fuzz_check(!isnan(trk_signal_value(signal, 0.3)), "a signal that is not a number");
            trk_signal_destroy(signal);
        }
    }
    fuzz_end(context);
    return 0;
}
