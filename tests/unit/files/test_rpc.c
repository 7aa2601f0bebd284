/* SPDX-License-Identifier: MIT */
/* MTS RPC III: a measured file, round trips, faults of the header and of the size. */
#include "shared.h"

#include <truckride/files.h>

static const char path[] = "test_rpc.rsp";

/*
 * The five channels of nCode's file. The header holds maximum, minimum, mean, standard deviation
 * and RMS of each before it was rounded to integers; first and last sample from NumPy.
 */
static void measured_file(void **state)
{
    static const struct {
        const char *name, *unit;
        double step, statistics[5], first, last;
        int highest, lowest;
    } row[] = {
        {"FDO_54xLoc_sh",
         "N",
         7.384259E-03,
         {241.96741, -220.72052, 12.878231, 68.956131, 70.131844},
         19.656897458,
         5.98124979,
         530,
         1962},
        {"ACC_76zGlob",
         "m/s^2",
         3.518849E-03,
         {115.30565, 88.132278, 99.733269, 5.3578715, 99.877014},
         98.900769994,
         107.046905429,
         438,
         169},
        {"FFG_78zGlob",
         "N",
         3.784186E-03,
         {124.0002, 93.504211, 107.84266, 6.0654321, 108.01302},
         107.913632162,
         113.514227442,
         259,
         170},
        {"FAD_7yknc",
         "N",
         4.735968E-03,
         {155.1882, 103.83976, 125.40952, 8.79245, 125.71721},
         128.401564416,
         135.988585152,
         1149,
         1237},
        {"D_23magLo",
         "mm",
         3.056326E-02,
         {1001.4969, -85.588654, 392.0845, 196.32199, 438.46753},
         440.35545007999997,
         519.4226037,
         1605,
         1625},
    };
    trk_context *c = *state;
    size_t size;
    char *bytes =
        shared_file(__FILE__, "tests/unit/files/test_rpc.c", "sample_mts_rpc3_int16.rsp", &size);
    if (!bytes)
        skip();
    trk_series *s;
    assert_ok(c, trk_series_parse_rpc(c, "sample", bytes, size, &s));
    free(bytes);
    assert_int_equal(trk_series_channels(s), 5);
    assert_int_equal(trk_series_samples(s), 2048);
    assert_near(trk_series_rate(s), 250, 0);
    for (int k = 0; k < 5; k++) {
        const double *x = trk_series_data(s, k + 1), step = row[k].step;
        assert_string_equal(trk_series_name(s, k + 1), row[k].name);
        assert_string_equal(trk_series_unit(s, k + 1), row[k].unit);
        double mean = 0, square = 0, variance = 0;
        for (int i = 0; i < 2048; i++) {
            mean += x[i] / 2048;
            square += x[i] * x[i] / 2048;
        }
        for (int i = 0; i < 2048; i++)
            variance += (x[i] - mean) * (x[i] - mean) / 2047;
        assert_near(x[row[k].highest], row[k].statistics[0], 1.1 * step);
        assert_near(x[row[k].lowest], row[k].statistics[1], 2 * step);
        assert_near(mean, row[k].statistics[2], 0.1 * step);
        assert_near(sqrt(variance), row[k].statistics[3], 0.1 * step);
        assert_near(sqrt(square), row[k].statistics[4], 0.1 * step);
        assert_near(x[0], row[k].first, 1e-12 * fabs(row[k].first));
        assert_near(x[2047], row[k].last, 1e-12 * fabs(row[k].last));
    }
    trk_series_destroy(s);
}

static trk_series *example(trk_context *c, int32_t channels, int64_t samples)
{
    trk_series *s;
    assert_ok(c, trk_series_create(c, channels, samples, 512, 0, &s));
    for (int32_t k = 1; k <= channels; k++) {
        char name[32];
        snprintf(name, sizeof name, "channel %d \xc2\xb0", (int)k);
        assert_ok(c, trk_series_label(s, k, name, k % 2 ? "mm" : "m/s\xc2\xb2"));
        for (int64_t i = 0; i < samples; i++)
            trk_series_data_mutable(s, k)[i] = (k - 2) * sin(0.37 * (double)i + k) * pow(10, k);
    }
    return s;
}

static void round_trips(void **state)
{
    trk_context *c = *state;
    static const int64_t samples[] = {1, 1024, 1025, 2048, 5000};
    for (int k = 0; k < 20; k++) {
        trk_series *s = example(c, 3, samples[k / 4]), *back;
        trk_rpc_options o;
        trk_rpc_options_init(&o, sizeof o);
        o.type = k % 2;
        o.big_endian = k / 2 % 2;
        assert_ok(c, trk_series_write_rpc(c, s, path, &o));
        assert_ok(c, trk_series_read_rpc(c, path, &back));
        assert_int_equal(trk_series_samples(back), samples[k / 4]);
        assert_near(trk_series_rate(back), 512, 0);
        for (int32_t n = 1; n <= 3; n++) {
            const double *x = trk_series_data(s, n), *y = trk_series_data(back, n);
            assert_string_equal(trk_series_name(back, n), trk_series_name(s, n));
            assert_string_equal(trk_series_unit(back, n), trk_series_unit(s, n));
            double peak = 0;
            for (int64_t i = 0; i < samples[k / 4]; i++)
                peak = fmax(peak, fabs(x[i]));
            for (int64_t i = 0; i < samples[k / 4]; i++) {
                if (o.type == TRK_RPC_FLOATING_POINT)
                    assert_true(y[i] == (double)(float)x[i]);
                else
                    assert_near(y[i], x[i], 0.5000001 * peak / 32752);
            }
        }
        trk_series_destroy(back);
        trk_series_destroy(s);
    }
    remove(path);
}

/* Header of `count` records with `data` bytes behind it, each the low byte of its place. */
static size_t make(char *out, const char *(*record)[2], int count, size_t data)
{
    const size_t blocks = ((size_t)count + 3) / 4;
    memset(out, 0, blocks * 512);
    for (int k = 0; k < count; k++) {
        strcpy(out + 128 * k, record[k][0]);
        strcpy(out + 128 * k + 32, record[k][1]);
    }
    for (size_t k = 0; k < data; k++)
        out[blocks * 512 + k] = (char)(k % 61);
    return blocks * 512 + data;
}

enum { RECORDS = 12 };
static const char *good[RECORDS][2] = {{"FORMAT", "BINARY_IEEE_LITTLE_END"},
                                       {"NUM_HEADER_BLOCKS", "3"},
                                       {"NUM_PARAMS", "12"},
                                       {"FILE_TYPE", "TIME_HISTORY"},
                                       {"DELTA_T", "1.0E-02"},
                                       {"CHANNELS", "2"},
                                       {"PTS_PER_FRAME", "4"},
                                       {"PTS_PER_GROUP", "8"},
                                       {"FRAMES", "3"},
                                       {"DESC.CHAN_1", "a"},
                                       {"SCALE.CHAN_1", "0.5"},
                                       {"SCALE.CHAN_2", "2"}};

static char file[1 << 16];

/* 2 groups of 8 points of 2 channels: 64 bytes are int16, 128 float32; without DATA_TYPE. */
static void type_from_the_size(void **state)
{
    trk_context *c = *state;
    trk_series *s;
    assert_ok(c, trk_series_parse_rpc(c, "x", file, make(file, good, RECORDS, 64), &s));
    assert_int_equal(trk_series_samples(s), 12); /* 3 frames, the group filled up to 16 */
    assert_near(trk_series_data(s, 1)[1], 0.5 * (2 + 256 * 3), 0);
    assert_near(trk_series_data(s, 2)[0], 2.0 * (16 + 256 * 17), 0);
    assert_near(trk_series_data(s, 2)[8], 2.0 * (48 + 256 * 49), 0); /* second group */
    assert_string_equal(trk_series_name(s, 1), "a");
    assert_string_equal(trk_series_name(s, 2), "column 2");
    trk_series_destroy(s);
    const size_t size = make(file, good, RECORDS, 128);
    const float number = -1.25f;
    memcpy(file + 3 * 512 + 4 * 8, &number, 4);
    assert_ok(c, trk_series_parse_rpc(c, "x", file, size, &s));
    assert_near(trk_series_data(s, 2)[0], -1.25, 0);
    trk_series_destroy(s);
    static const size_t wrong[] = {0, 63, 64 + 512 + 511 + 1};
    for (int k = 0; k < 3; k++) {
        assert_status(c,
                      trk_series_parse_rpc(c, "x", file, make(file, good, RECORDS, wrong[k]), &s),
                      TRK_E_SYNTAX);
        assert_message(c, "bytes of");
    }
}

static void faults_of_the_header(void **state)
{
    static const struct {
        int record;
        const char *keyword, *value, *message;
        trk_status status;
    } row[] = {
        {0, "FROMAT", "BINARY", "x: no RPC III file", TRK_E_SYNTAX},
        {0, "FORMAT", "ASCII", "FORMAT is ASCII", TRK_E_UNSUPPORTED},
        {0, "FORMAT", "VAX", "x: byte 32: FORMAT is 'VAX', expected", TRK_E_SYNTAX},
        {1, "NUM_HEADER_BLOCKS", "0", "byte 160: NUM_HEADER_BLOCKS is '0'", TRK_E_SYNTAX},
        {1, "NUM_HEADER_BLOCKS", "257", "from 1 to 256", TRK_E_SYNTAX},
        {1, "NUM_HEADER_BLOCKS", "200", "its header of 200 blocks alone needs", TRK_E_SYNTAX},
        {1, "HEADER", "3", "x: the header has no NUM_HEADER_BLOCKS", TRK_E_SYNTAX},
        {3, "FILE_TYPE", "SPECTRUM", "FILE_TYPE is 'SPECTRUM'", TRK_E_UNSUPPORTED},
        {4, "DELTA_T", "0", "DELTA_T is '0'", TRK_E_SYNTAX},
        {4, "DELTA_T", "0,01", "DELTA_T is '0,01', expected seconds", TRK_E_SYNTAX},
        {4, "DT", "1", "x: the header has no DELTA_T", TRK_E_SYNTAX},
        {5, "CHANNELS", "257", "byte 672: CHANNELS is '257'", TRK_E_SYNTAX},
        {5, "CHANNELS", "-1", "CHANNELS is '-1'", TRK_E_SYNTAX},
        {5, "CHANNELS", "2.5", "CHANNELS is '2.5'", TRK_E_SYNTAX},
        {5, "CHANNELS", "", "CHANNELS is ''", TRK_E_SYNTAX},
        {6, "PTS_PER_FRAME", "3", "PTS_PER_GROUP is 8, expected a multiple", TRK_E_SYNTAX},
        {7, "PTS_PER_GROUP", "2", "PTS_PER_GROUP is '2'", TRK_E_SYNTAX},
        {7, "PTS_PER_GROUP", "2000000000", "more than the", TRK_E_SYNTAX},
        {8, "FRAMES", "2000000000", "more than the", TRK_E_SYNTAX},
        {8, "FRAMES", "1e300", "FRAMES is '1e300'", TRK_E_SYNTAX},
        {9, "DATA_TYPE", "DOUBLE", "DATA_TYPE is 'DOUBLE'", TRK_E_SYNTAX},
        {9, "DATA_TYPE", "FLOATING_POINT", "64 bytes of data, expected 128", TRK_E_SYNTAX},
        {9, "TRUCKRIDE_SAMPLES", "13", "TRUCKRIDE_SAMPLES is '13'", TRK_E_SYNTAX},
        {10, "SCALE.CHAN_1", "x", "SCALE.CHAN_1 is 'x'", TRK_E_SYNTAX},
        {11, "SCALE.CHAN_3", "1", "x: the header has no SCALE.CHAN_2", TRK_E_SYNTAX},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const char *record[RECORDS][2];
        memcpy(record, good, sizeof record);
        record[row[k].record][0] = row[k].keyword;
        record[row[k].record][1] = row[k].value;
        const size_t size = make(file, record, RECORDS, 64);
        trk_series *s;
        assert_status(*state, trk_series_parse_rpc(*state, "x", file, size, &s), row[k].status);
        assert_message(*state, row[k].message);
        assert_null(s);
    }
}

static void not_finite(void **state)
{
    trk_series *s;
    const size_t size = make(file, good, RECORDS, 128);
    const float number = NAN;
    memcpy(file + 1536 + 4 * 9, &number, 4);
    assert_status(*state, trk_series_parse_rpc(*state, "x", file, size, &s), TRK_E_SYNTAX);
    assert_message(*state, "x: byte 1572: sample 1 of channel 2 is not finite");
}

static void wrong_arguments(void **state)
{
    trk_context *c = *state;
    trk_series *s;
    trk_rpc_options o;
    assert_status(c, trk_series_parse_rpc(NULL, "x", "", 0, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_parse_rpc(c, NULL, "", 0, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_parse_rpc(c, "x", NULL, 9, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_parse_rpc(c, "x", NULL, 0, &s), TRK_E_SYNTAX);
    assert_status(c, trk_series_parse_rpc(c, "x", "", 0, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_series_read_rpc(NULL, "x", &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_read_rpc(c, NULL, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_read_rpc(c, "x", NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_series_read_rpc(c, "/does/not/exist", &s), TRK_E_FILE);
    s = example(c, 1, 3);
    assert_status(c, trk_series_write_rpc(NULL, s, path, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_series_write_rpc(c, NULL, path, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_series_write_rpc(c, s, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_series_write_rpc(c, s, "/does/not/exist", NULL), TRK_E_FILE);
    assert_status(c, trk_series_write_rpc(c, s, "/dev/full", NULL), TRK_E_FILE);
    assert_message(c, "No space left");
    for (int k = 0; k < 5; k++) {
        trk_rpc_options_init(&o, sizeof o);
        o.type = k == 0 ? 2 : 0;
        o.big_endian = k == 1 ? 2 : 0;
        o.drive = k == 2 ? -1 : 0;
        o.reserved = k == 3;
        if (k == 4)
            o.struct_size = 3;
        assert_status(c, trk_series_write_rpc(c, s, path, &o),
                      k == 4 ? TRK_E_OPTIONS : TRK_E_RANGE);
    }
    const double bad[] = {NAN, INFINITY, 1e39};
    for (int k = 0; k < 3; k++) {
        trk_series_data_mutable(s, 1)[2] = bad[k];
        assert_status(c, trk_series_write_rpc(c, s, path, NULL), TRK_E_RANGE);
        assert_message(c, "test_rpc.rsp: sample 2 of channel 'channel 1");
    }
    trk_series_destroy(s);
    s = example(c, 129, 1);
    assert_status(c, trk_series_write_rpc(c, s, path, NULL), TRK_E_RANGE);
    assert_message(c, "129 channels");
    trk_series_destroy(s);
    assert_null(fopen(path, "rb"));
}

static trk_status use_memory(trk_context *c)
{
    trk_series *s = NULL;
    trk_status status = trk_series_parse_rpc(c, "x", file, make(file, good, RECORDS, 64), &s);
    if (status == TRK_OK)
        status = trk_series_write_rpc(c, s, path, NULL);
    if (status == TRK_OK)
        status = trk_series_write_mat(c, s, path);
    trk_series_destroy(s);
    if (status == TRK_OK)
        remove(path);
    return status;
}

static void memory_runs_out(void **state)
{
    (void)state;
    support_exhaust_memory(use_memory);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(measured_file),
        TEST(round_trips),
        TEST(type_from_the_size),
        TEST(faults_of_the_header),
        TEST(not_finite),
        TEST(wrong_arguments),
        cmocka_unit_test(memory_runs_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
