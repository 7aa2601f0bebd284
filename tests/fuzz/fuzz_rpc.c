/* SPDX-License-Identifier: MIT */
/* Random bytes as RPC III time histories. */
#include "fuzz.h"

#include <truckride/files.h>

/* A record holds 128 bytes: four blocks of header, then the data of 2 channels of 2 points. */
static const struct record {
    char keyword[32], value[96];
} integers[17] = {{"FORMAT", "BINARY_IEEE_LITTLE_END"},
                  {"NUM_HEADER_BLOCKS", "4"},
                  {"NUM_PARAMS", "14"},
                  {"FILE_TYPE", "TIME_HISTORY"},
                  {"DELTA_T", "1.0E-02"},
                  {"CHANNELS", "2"},
                  {"PTS_PER_FRAME", "1"},
                  {"PTS_PER_GROUP", "2"},
                  {"FRAMES", "2"},
                  {"DESC.CHAN_1", "a"},
                  {"UNITS.CHAN_1", "mm"},
                  {"SCALE.CHAN_1", "0.5"},
                  {"SCALE.CHAN_2", "2"},
                  {"DATA_TYPE", "SHORT_INTEGER"},
                  [16] = {"\1\2\3\4\5\6\7\10", ""}},
  floats[9] = {{"FORMAT", "BINARY_IEEE_BIG_END"},
               {"NUM_HEADER_BLOCKS", "2"},
               {"CHANNELS", "1"},
               {"DELTA_T", "1"},
               {"PTS_PER_FRAME", "2"},
               {"PTS_PER_GROUP", "4"},
               {"FRAMES", "3"},
               [8] = {"?abc?bcd?cde?def?efg?fgh?ghi?hij", ""}};

const fuzz_seed fuzz_seeds[] = {
    {(const char *)integers, 4 * 512 + 8},
    {(const char *)floats, 2 * 512 + 32}, /* float32: the size says so */
    {(const char *)floats, 2 * 512 + 16},
    {NULL, 0},
};

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    trk_context *context = fuzz_begin(size);
    trk_series *series;
    if (trk_series_parse_rpc(context, "x", bytes, size, &series) == TRK_OK)
        trk_series_destroy(series);
    fuzz_end(context);
    return 0;
}
