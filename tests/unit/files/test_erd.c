/* SPDX-License-Identifier: MIT */
/* ERD profiles: text and binary, units, faults with their places. */
#include "support.h"

#include <truckride/files.h>

static trk_status parse(trk_context *c, const char *text, trk_series **out)
{
    return trk_series_parse_erd(c, "x.erd", text, strlen(text), out);
}

/* Header of the layout of LTPP's files; 3 channels in mm every 25 mm. */
static const char text_file[] = "ERDFILEV2.00\r\n"
                                "      3,      4,     -1,      1,      5,       0.0250,     -1,\r\n"
                                "TITLE   LTPP SPS Section: Run 1\r\n"
                                "SHORTNAMLElev.  RElev.  Slope\r\n"
                                "UNITSNAMmm      mm      m/km\r\n"
                                "XUNITS  m\r\n"
                                "END\r\n"
                                "  1.0  -2.0  3.0\r\n"
                                "  10.0 20.0 30.0 1e2,2E2\r\n"
                                ",3D2\r\n 0 0 0\r\n";

static void text_data(void **state)
{
    trk_series *s;
    assert_ok(*state, parse(*state, text_file, &s));
    assert_int_equal(trk_series_channels(s), 3);
    assert_int_equal(trk_series_samples(s), 4);
    assert_near(trk_series_rate(s), 40, 0);
    assert_string_equal(trk_series_name(s, 1), "LElev.");
    assert_string_equal(trk_series_unit(s, 2), "m");
    assert_string_equal(trk_series_unit(s, 3), "m/km");
    const double want[3][3] = {{0.001, 0.010, 0.1}, {-0.002, 0.020, 0.2}, {3, 30, 300}};
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < 3; i++)
            assert_near(trk_series_data(s, c + 1)[i], want[c][i], 1e-15);
    trk_series_destroy(s);
}

/* As many samples as there are; feet and inches. */
static void open_end(void **state)
{
    trk_series *s;
    assert_ok(*state, parse(*state,
                            "ERDFILEV2.00\n1,-1,-1,1,5,0.5,-1,\nUNITSNAMin\nXUNITS  ft\nEND\n"
                            "1\n2\n3\n",
                            &s));
    assert_int_equal(trk_series_samples(s), 3);
    assert_near(trk_series_rate(s), 1 / 0.1524, 1e-12);
    assert_near(trk_series_data(s, 1)[2], 0.0762, 1e-15);
    assert_string_equal(trk_series_name(s, 1), "column 1");
    trk_series_destroy(s);
}

static void binary_data(void **state)
{
    char file[256];
    const char head[] = "ERDFILEV2.00\n2, 2, 2, 8, %d, 0.1, -1\nUNITSNAMmm      V\nXUNITS  m\n"
                        "GAIN       0.5       2\nOFFSET       1       0\nEND\n";
    trk_series *s;
    int length = snprintf(file, sizeof file, head, 0);
    memcpy(file + length, "\x02\x00\xff\xff\x10\x01\x00\x80", 8);
    assert_ok(*state, trk_series_parse_erd(*state, "x", file, (size_t)length + 8, &s));
    assert_near(trk_series_data(s, 1)[0], 0.002, 1e-15); /* 1 + 0.5 * 2 mm */
    assert_near(trk_series_data(s, 1)[1], 0.137, 1e-15);
    assert_near(trk_series_data(s, 2)[0], -2, 0);
    assert_near(trk_series_data(s, 2)[1], -65536, 0);
    trk_series_destroy(s);
    assert_status(*state, trk_series_parse_erd(*state, "x", file, (size_t)length + 7, &s),
                  TRK_E_SYNTAX);
    assert_message(*state, "x: the data end after 7 bytes, expected 2 samples of 2 channels");
    length = snprintf(file, sizeof file, head, 1);
    const float number[4] = {1, -2, 3, 4};
    memcpy(file + length, number, 16);
    assert_ok(*state, trk_series_parse_erd(*state, "x", file, (size_t)length + 16, &s));
    assert_near(trk_series_data(s, 1)[1], 0.003, 1e-15); /* the gain is for integers */
    assert_near(trk_series_data(s, 2)[1], 4, 0);
    trk_series_destroy(s);
    memcpy(file + length, "\0\0\x80\x7f", 4);
    assert_status(*state, trk_series_parse_erd(*state, "x", file, (size_t)length + 16, &s),
                  TRK_E_SYNTAX);
    assert_message(*state, "sample 0 of channel 1 is not finite");
}

static void faults(void **state)
{
    static const struct {
        const char *text, *message;
        trk_status status;
    } row[] = {
        {"", "x.erd:1:1: no ERD file", TRK_E_SYNTAX},
        {"ERDFILEV2.00", "x.erd:2:1: the file ends", TRK_E_SYNTAX},
        {"ERDFILEV2.00\n1,x,-1,1,5,1,-1\n", "x.erd:2:3: number of samples: expected a number",
         TRK_E_SYNTAX},
        {"ERDFILEV2.00\n1,2,-1,1,5\n", "step: expected a number, not ''", TRK_E_SYNTAX},
        {"ERDFILEV2.00\n0,2,-1,1,5,1,-1\n", "0 channels, expected 1 to 4096", TRK_E_SYNTAX},
        {"ERDFILEV2.00\n1,2,-1,1,5,0,-1\n", "the step is 0", TRK_E_SYNTAX},
        {"ERDFILEV2.00\n1,2,-1,1,15,1,-1\n", "the data key is 15", TRK_E_UNSUPPORTED},
        {"ERDFILEV2.00\n1,2,-1,1,5,1,-1\nTITLE   x\n",
         "x.erd:4:1: the file ends, expected a line END", TRK_E_SYNTAX},
        {"ERDFILEV2.00\n1,2,-1,1,5,1,-1\nEND\n1\n", "the data end after 1 numbers", TRK_E_SYNTAX},
        {"ERDFILEV2.00\n1,2,-1,1,5,1,-1\nEND\n1\n0.5x\n",
         "x.erd:5:1: expected a number, not '0.5x'", TRK_E_SYNTAX},
        {"ERDFILEV2.00\n1,2,-1,1,5,1,-1\nEND\n1\n0,5\n", "x.erd:5:1: more numbers than 2 samples",
         TRK_E_SYNTAX},
        {"ERDFILEV2.00\n2,0,-1,1,5,1,-1\nEND\n1 2\n3\n", "the data end after 3 numbers",
         TRK_E_SYNTAX},
        {"ERDFILEV2.00\n1,0,-1,1,5,1,-1\nEND\n", "the data end after 0 numbers", TRK_E_SYNTAX},
        {"ERDFILEV2.00\n4096,900000000000000,-1,1,5,1,-1\nEND\n1\n", "the data end", TRK_E_SYNTAX},
        {"ERDFILEV2.00\n4096,900000000000000,-1,1,1,1,-1\nEND\n1\n", "the data end", TRK_E_SYNTAX},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        trk_series *s;
        assert_status(*state, parse(*state, row[k].text, &s), row[k].status);
        assert_message(*state, row[k].message);
        assert_null(s);
    }
}

static void wrong_arguments(void **state)
{
    trk_context *c = *state;
    trk_series *s;
    assert_status(c, trk_series_parse_erd(NULL, "x", "", 0, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_parse_erd(c, NULL, "", 0, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_parse_erd(c, "x", NULL, 1, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_parse_erd(c, "x", "", 0, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_series_read_erd(NULL, "x", &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_read_erd(c, NULL, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_read_erd(c, "x", NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_series_read_erd(c, "/does/not/exist", &s), TRK_E_FILE);
}

static trk_status use_memory(trk_context *c)
{
    trk_series *s;
    trk_status status = parse(c, text_file, &s);
    trk_series_destroy(s);
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
        TEST(text_data), TEST(open_end),        TEST(binary_data),
        TEST(faults),    TEST(wrong_arguments), cmocka_unit_test(memory_runs_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
