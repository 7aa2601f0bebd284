/* SPDX-License-Identifier: MIT */
/* OpenCRG surfaces: measured ones, every data format, evaluation by hand, faults with places. */
#include "../files/shared.h"

#include <stdbool.h>
#include <truckride/crg.h>

static const char here[] = "tests/unit/crg/test_crg.c";

static trk_status parse(trk_context *c, const char *text, const trk_crg_options *options,
                        trk_crg **out)
{
    return trk_crg_parse(c, "x.crg", text, strlen(text), options, out);
}

/* 10 m of Belgian block; heights from NumPy: >f4, 342 columns, the first one phi. */
static void belgian_block(void **state)
{
    trk_context *c = *state;
    size_t size;
    char *bytes = shared_file(__FILE__, here, "belgian_block.crg", &size);
    if (!bytes)
        skip();
    trk_crg *crg;
    assert_ok(c, trk_crg_parse(c, "belgian", bytes, size, NULL, &crg));
    free(bytes);
    double u, step, right, left;
    assert_ok(c, trk_crg_extent(crg, &u, &step, &right, &left));
    assert_int_equal(trk_crg_rows(crg), 1001);
    assert_int_equal(trk_crg_columns(crg), 341);
    assert_near(u, 730, 0);
    assert_near(step, 0.01, 0);
    assert_near(right, -1.7, 0);
    assert_near(left, 1.7, 1e-12);
    assert_near(trk_crg_height(crg, 730, 0), 2.1315932273864746, 1e-10);
    assert_near(trk_crg_height(crg, 735, -0.9), 2.0860025882720947, 1e-9);
    assert_near(trk_crg_height(crg, 735, 0.9), 2.1507272720336914, 1e-9);
    assert_near(trk_crg_height(crg, 740, 1.7), 2.1580088138580322, 1e-10);
    assert_near(trk_crg_height(crg, 740, -0.01), 2.137620687484741, 1e-9);
    assert_near(trk_crg_height(crg, 735.123, 0.8045), 2.1441491580009355, 1e-9);
    assert_near(trk_crg_height(crg, 738.5049, -1.2333), 2.1396564429998373, 1e-9);
    assert_true(isfinite(trk_crg_height(crg, 730, -1.7))); /* missing, from its neighbour */
    trk_crg_destroy(crg);
}

/* Three equal sections of an RMS course; its title says 0.96944 in over the undulated 304.8 m. */
static void rms_course(void **state)
{
    trk_context *c = *state;
    size_t size;
    char *bytes = shared_file(__FILE__, here, "detrended_rms_course_1in.crg", &size);
    if (!bytes)
        skip();
    trk_crg *crg;
    trk_series *s;
    assert_ok(c, trk_crg_parse(c, "rms", bytes, size, NULL, &crg));
    assert_int_equal(trk_crg_rows(crg), 10096);
    const double v[] = {-1, 1};
    assert_ok(c, trk_crg_sample(c, crg, 2, v, 100, 0.05, 6096, &s));
    double square = 0;
    for (int k = 0; k < 6096; k++) {
        square += pow(trk_series_data(s, 1)[k], 2) / 6096;
        assert_near(trk_series_data(s, 1)[k], trk_series_data(s, 2)[k], 1e-15);
    }
    assert_near(sqrt(square) / 0.0254, 0.9573952975506561, 1e-9); /* NumPy */
    assert_near(sqrt(square) / 0.0254, 0.96944, 0.015);           /* before they cut the trend */
    assert_string_equal(trk_series_name(s, 2), "v=1");
    trk_series_destroy(s);
    trk_crg_destroy(crg);
    assert_status(c, trk_crg_parse(c, "rms", bytes, size - 80, NULL, &crg), TRK_E_SYNTAX);
    free(bytes);
    assert_message(c, "bytes of data follow, expected 10096 rows of 12 bytes");
}

#define HEAD(road)                                                                                 \
    "$CT\ntitle\n$\n$ROAD_CRG ! comment\nREFERENCE_LINE_INCREMENT = 1.0 ! m\n" road "$\n"
#define COLUMNS3                                                                                   \
    "$KD_Definition\n#:LRFI\nD:long section 1,m\nD:long section 2,m\nD:long section "              \
    "3,m\n$\n$$$$\n"

/* The layout of ASAM's handmade samples: fields that touch, missing heights. */
static void handmade(void **state)
{
    trk_context *c = *state;
    static const char text[] =
        HEAD("LONG_SECTION_V_RIGHT = -0.5\nLONG_SECTION_V_INCREMENT = 0.50\n") COLUMNS3
        " 0.0000000 0.0000000 0.0000000\n"
        " 0.0111111-0.0111111-0.0222222\n"
        " *missing* 0.0111111 *missing*\n"
        " *missing* *missing* *missing*\n";
    trk_crg *crg;
    trk_crg_options o;
    trk_crg_options_init(&o, sizeof o);
    assert_ok(c, parse(c, text, NULL, &crg));
    assert_near(trk_crg_height(crg, 1, -0.5), 0.0111111, 0);
    assert_near(trk_crg_height(crg, 1, 0.5), -0.0222222, 0);
    assert_near(trk_crg_height(crg, 0.5, 0.25), (-0.0111111 - 0.0222222) / 4, 1e-17);
    assert_near(trk_crg_height(crg, 2, -0.5), 0.0111111, 0);
    assert_near(trk_crg_height(crg, 2, 0.5), 0.0111111, 0);
    assert_true(isnan(trk_crg_height(crg, 3, 0)));
    trk_signal *s;
    assert_status(c, trk_crg_profile(c, crg, 0, 0, &s), TRK_E_RANGE);
    assert_message(c, "no height at u = 3 m, v = 0 m");
    trk_crg_destroy(crg);
    o.missing = TRK_CRG_MISSING_KEEP;
    assert_ok(c, parse(c, text, &o, &crg));
    assert_true(isnan(trk_crg_height(crg, 2, -0.5)));
    trk_crg_destroy(crg);
    o.missing = TRK_CRG_MISSING_ZERO;
    assert_ok(c, parse(c, text, &o, &crg));
    assert_near(trk_crg_height(crg, 3, 0.1), 0, 0);
    trk_crg_destroy(crg);
}

/* Slope, banking, start height and explicit sections out of order: CRG.1 by hand. */
static void slope_and_banking(void **state)
{
    trk_context *c = *state;
    static const char text[] = HEAD(
        "reference_line_start_u = 10\nreference_line_start_z = 5\n") "$ROAD_CRG_OPTS\nborder_mode_"
                                                                     "u = 0\nborder_mode_v = "
                                                                     "2\nborder_offset_v = 0.5\n$\n"
                                                                     "$ROAD_CRG_MODS\nscale_z_grid "
                                                                     "= 2\nrefline_offset_phi = "
                                                                     "1\n$\n"
                                                                     "$KD_Definition\n#:LDFI\nD:"
                                                                     "reference line "
                                                                     "phi,rad\nD:reference line "
                                                                     "banking,m/m\n"
                                                                     "D:reference line "
                                                                     "slope,m/m\nD:long section at "
                                                                     "v = 1.0,m\nD:long section at "
                                                                     "v = -2,m\n"
                                                                     "D:long section at v = "
                                                                     "0,m\n$\n$$$$\n"
                                                                     "          **unused**         "
                                                                     "        0.1          "
                                                                     "**unused**                   "
                                                                     "1\n"
                                                                     "                   2         "
                                                                     "          3\n"
                                                                     "                 0.0         "
                                                                     "        0.2                 "
                                                                     "0.5                   4\n"
                                                                     "                   5         "
                                                                     "          6\n"
                                                                     "                 0.0         "
                                                                     "        0.3                 "
                                                                     "1.0                   7\n"
                                                                     "                   8         "
                                                                     "          9\n";
    trk_crg *crg;
    assert_ok(c, parse(c, text, NULL, &crg));
    /* line: 5, 5.5, 6.5; grid (x2) by v = -2, 0, 1: 4 6 2, 10 12 8, 16 18 14 */
    assert_near(trk_crg_height(crg, 10, 1), 2 + 5 + 0.1, 1e-15);
    assert_near(trk_crg_height(crg, 11, -2), 10 + 5.5 - 0.4, 1e-14);
    assert_near(trk_crg_height(crg, 11.5, -0.5), 14.5 + 6.0 - 0.125, 1e-14);
    assert_near(trk_crg_height(crg, 12, 3), 14 + 6.5 + 0.3 + 0.5, 1e-14); /* kept, and offset */
    assert_true(isnan(trk_crg_height(crg, 9.9, 0)));
    assert_true(isfinite(trk_crg_height(crg, 10 - 1e-9, 0)));
    assert_true(isnan(trk_crg_height(crg, 12.1, 0)));
    trk_crg_destroy(crg);
}

/* Given end: where slopes do not lead there, blended as the C library of ASAM does. */
static void given_end(void **state)
{
    trk_crg *crg;
    static const char text[] =
        HEAD("REFERENCE_LINE_START_Z = 0\nREFERENCE_LINE_END_Z = "
             "0.9\nLONG_SECTION_V_INCREMENT=1\n") "$KD_Definition\n#:LRFI\nD:reference "
                                                  "line slope,m/m\nD:long section 1,m\n"
                                                  "D:long section 2,m\n$\n$$$$\n"
                                                  "**unused** 0.0000000 0.0000000\n       "
                                                  "0.1 0.0000000 0.0000000\n"
                                                  "       0.2 0.0000000 0.0000000\n      "
                                                  "-0.1 0.0000000 0.0000000\n"
                                                  "       0.3 0.0000000 0.0000000\n";
    /* back from 0.9: 0.6, 0.7, 0.5; blended 0.1, then 3/4 0.3 + 1/4 0.7, 1/2 0.3 + 1/2 0.6 */
    const double want[] = {0, 0.1, 0.4, 0.45, 0.9};
    assert_ok(*state, parse(*state, text, NULL, &crg));
    for (int k = 0; k < 5; k++)
        assert_near(trk_crg_height(crg, k, 0.5), want[k], 1e-15);
    trk_crg_destroy(crg);
    static const char constant[] =
        HEAD("REFERENCE_LINE_START_S = 0.25\nLONG_SECTION_V_RIGHT = -1\nLONG_SECTION_V_RIGHT = 1\n"
             "REFERENCE_LINE_START_B = 0.5\n") COLUMNS3
        "         0         0         0\n         0         0         0\n";
    assert_ok(*state, parse(*state, constant, NULL, &crg));
    assert_near(trk_crg_height(crg, 0.5, 0.5), 0.125 + 0.25, 1e-16);
    trk_crg_destroy(crg);
}

static size_t binary(char *out, const char *format, double increment, int rows, int size, bool pad)
{
    size_t at = (size_t)snprintf(
        out, 2000,
        HEAD("REFERENCE_LINE_START_U = 0\nREFERENCE_LINE_END_U = %d\n"
             "LONG_SECTION_V_LEFT = 1\nLONG_SECTION_V_INCREMENT = %g\n") "$KD_DEFINITION\n#:%s\nD:"
                                                                         "long section 1,m\nD:long "
                                                                         "section 2,m\n"
                                                                         "D:long section "
                                                                         "3,m\n$\n$$$$\n",
        rows - 1, increment, format);
    const size_t begin = at;
    for (int i = 0; i < 3 * rows; i++) {
        const double x = 0.5 * i;
        const float y = (float)x;
        unsigned char bytes[8];
        memcpy(bytes, size == 4 ? (const void *)&y : (const void *)&x, (size_t)size);
        for (int k = 0; k < size; k++) /* big-endian, from the little one of the test machine */
            out[at++] = (char)bytes[size - 1 - k];
        while (pad && i % 3 == 2 && (at - begin) % 80)
            out[at++] = 0;
    }
    while ((at - begin) % 80)
        out[at++] = '\xff';
    return at;
}

static void binary_formats(void **state)
{
    static const char *const format[] = {"KRBI", "KDBI", "LRBI", "LDBI"};
    static char file[8000];
    for (int k = 0; k < 4; k++) {
        trk_crg *crg;
        const size_t size = binary(file, format[k], 0.5, 12, k % 2 ? 8 : 4, k > 1);
        assert_ok(*state, trk_crg_parse(*state, "x", file, size, NULL, &crg));
        assert_int_equal(trk_crg_rows(crg), 12);
        assert_near(trk_crg_height(crg, 7, 0.5), 0.5 * (3 * 7 + 1), 0);
        trk_crg_destroy(crg);
    }
}

static void borders(void **state)
{
    static char file[8000];
    static const struct {
        trk_crg_border u, v;
        double at_u, at_v, height;
    } row[] = {{3, 3, -5, 0, 0},      {3, 3, 99, 9, 17.5},  {1, 3, -5, 0, NAN},
               {3, 1, 1, -1, NAN},    {2, 3, -1, 0.5, 0},   {3, 2, 4, 5, 0},
               {4, 3, 11.5, 0, 0.75}, {4, 3, -1, 0, 15},    {5, 3, 12, 0, 15},
               {5, 3, -2.5, 0, 3.75}, {3, 4, 0, 1.5, 0.5},  {3, 4, 0, -0.25, 0.75},
               {3, 5, 0, 1.25, 0.75}, {3, 5, 0, -0.5, 0.5}, {5, 5, 1e300, -1e300, NAN}};
    const size_t size = binary(file, "KDBI", 0.5, 12, 8, false);
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        trk_crg *crg;
        trk_crg_options o;
        trk_crg_options_init(&o, sizeof o);
        o.border_u = row[k].u;
        o.border_v = row[k].v;
        assert_ok(*state, trk_crg_parse(*state, "x", file, size, &o, &crg));
        const double z = trk_crg_height(crg, row[k].at_u, row[k].at_v);
        if (row[k].at_u > 1e200)
            assert_true(isfinite(z));
        else if (isnan(row[k].height))
            assert_true(isnan(z));
        else
            assert_near(z, row[k].height, 1e-12);
        assert_true(isnan(trk_crg_height(crg, NAN, 0)) && isnan(trk_crg_height(crg, 0, NAN)));
        trk_crg_destroy(crg);
    }
    assert_true(isnan(trk_crg_height(NULL, 0, 0)));
}

/* The signal is the surface, and its rate that of the straight lines. */
static void profiles(void **state)
{
    trk_context *c = *state;
    static char file[8000];
    trk_crg *crg;
    trk_signal *s;
    const size_t size = binary(file, "KDBI", 0.5, 12, 8, false);
    assert_ok(c, trk_crg_parse(c, "x", file, size, NULL, &crg));
    for (int smooth = 0; smooth < 2; smooth++) {
        assert_ok(c, trk_crg_profile(c, crg, 0.3, smooth, &s));
        for (double u = -1; u < 13; u += 0.25) {
            assert_near(trk_signal_value(s, u), trk_crg_height(crg, u, 0.3), 1e-13);
            if (u != 11)
                assert_near(trk_signal_rate(s, u), u < 0 || u > 11 ? 0 : 1.5, 1e-12);
        }
        assert_true(isnan(trk_signal_value(s, NAN)));
        trk_signal_destroy(s);
    }
    trk_series *series;
    const double v[] = {0.1, 0.1}, bad[] = {NAN};
    assert_status(c, trk_crg_profile(c, crg, INFINITY, 0, &s), TRK_E_RANGE);
    assert_status(c, trk_crg_profile(c, crg, 0, 2, &s), TRK_E_RANGE);
    assert_status(c, trk_crg_profile(NULL, crg, 0, 0, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_crg_profile(c, NULL, 0, 0, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_crg_profile(c, crg, 0, 0, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_crg_sample(c, crg, 2, v, 0, 0.1, 5, &series), TRK_E_RANGE);
    assert_message(c, "v[1] is 0.1 m");
    assert_status(c, trk_crg_sample(c, crg, 1, bad, 0, 0.1, 5, &series), TRK_E_RANGE);
    assert_status(c, trk_crg_sample(c, crg, 1, v, 0, 0, 5, &series), TRK_E_RANGE);
    assert_status(c, trk_crg_sample(c, crg, 1, v, NAN, 1, 5, &series), TRK_E_RANGE);
    assert_status(c, trk_crg_sample(c, crg, 0, v, 0, 1, 5, &series), TRK_E_RANGE);
    assert_status(c, trk_crg_sample(NULL, crg, 1, v, 0, 1, 5, &series), TRK_E_ARGUMENT);
    assert_status(c, trk_crg_sample(c, NULL, 1, v, 0, 1, 5, &series), TRK_E_ARGUMENT);
    assert_status(c, trk_crg_sample(c, crg, 1, NULL, 0, 1, 5, &series), TRK_E_ARGUMENT);
    assert_status(c, trk_crg_sample(c, crg, 1, v, 0, 1, 5, NULL), TRK_E_ARGUMENT);
    trk_crg_destroy(crg);
}

/* What an editor or a transfer in text mode does to a binary file. */
static void converted_line_ends(void **state)
{
    static char file[8000], out[16000];
    size_t size = binary(file, "KRBI", 0.5, 30, 4, false), used = 0;
    memcpy(file + size - 300, "\n\n\n\n\n\n\n\n\n\n", 10); /* whatever the heights are there */
    trk_crg *crg;
    assert_ok(*state, trk_crg_parse(*state, "x", file, size, NULL, &crg));
    trk_crg_destroy(crg);
    for (size_t k = 0; k < size; k++) {
        if (file[k] == '\n')
            out[used++] = '\r';
        out[used++] = file[k];
    }
    assert_status(*state, trk_crg_parse(*state, "x", out, used, NULL, &crg), TRK_E_SYNTAX);
    assert_message(*state, "line ends may have been converted");
    for (size_t k = used = 0; k < size; k++)
        if (k < 300 || file[k] != '\n')
            out[used++] = file[k];
    assert_status(*state, trk_crg_parse(*state, "x", out, used, NULL, &crg), TRK_E_SYNTAX);
}

static void faults(void **state)
{
#define GRID COLUMNS3 "         0         0         0\n         0         0         0\n"
#define V "LONG_SECTION_V_INCREMENT = 1\n"
    static const struct {
        const char *text, *message;
        trk_status status;
    } row[] = {
        {"", "x.crg:1:1: no OpenCRG file", TRK_E_SYNTAX},
        {"$CT\n$\n" GRID, "x.crg:9:1: the header ends without section $ROAD_CRG", TRK_E_SYNTAX},
        {"$ROAD_CRG\n" V "$\n" GRID, "without key REFERENCE_LINE_INCREMENT", TRK_E_SYNTAX},
        {HEAD(V) "$$$$\n", "without data format", TRK_E_SYNTAX},
        {HEAD("LONG_SECTION_V_LEFT = 1\n") GRID, "expected LONG_SECTION_V_INCREMENT", TRK_E_SYNTAX},
        {HEAD(V "LONG_SECTION_V_LEFT = 1\nLONG_SECTION_V_RIGHT = 0\n") GRID, "end at 2 m, but",
         TRK_E_SYNTAX},
        {HEAD(V V) GRID, "x.crg:7:1: 'LONG_SECTION_V_INCREMENT' is given twice", TRK_E_SYNTAX},
        {HEAD("LONG_SECTION_V_INCREMENT = 0,5\n") GRID, "x.crg:6:28: expected a number, not '0,5'",
         TRK_E_SYNTAX},
        {HEAD("LONG_SECTION_V_INCREMENT 5\n") GRID, "x.crg:6:1: expected 'KEY = value'",
         TRK_E_SYNTAX},
        {HEAD("LONG_SECTION_V_INCREMENT = -1\n") GRID, "expected 1e-6 m between", TRK_E_SYNTAX},
        {HEAD(V "REFERENCE_LINE_END_U = 5\n") GRID, "the data end after 2 rows, expected 6",
         TRK_E_SYNTAX},
        {HEAD(V "REFERENCE_LINE_END_U = 1\n") GRID "         0         0         0\n",
         "here is row 3, but the reference line has 2", TRK_E_SYNTAX},
        {HEAD(V "REFERENCE_LINE_END_U = 1e12\n") GRID, "the data end after 2 rows", TRK_E_SYNTAX},
        {HEAD(V "REFERENCE_LINE_END_U = 0\n") GRID, "expected at least 2 rows", TRK_E_SYNTAX},
        {HEAD(V) GRID "         0         0\n", "x.crg:17:21: expected a number, not ''",
         TRK_E_SYNTAX},
        {HEAD(V) GRID "         0       0,5         0\n", "x.crg:17:11: expected a number",
         TRK_E_SYNTAX},
        {HEAD(V) GRID "         0         0         0 7\n", "x.crg:17:32: expected the end of the",
         TRK_E_SYNTAX},
        {HEAD(V) "$KD_Definition\n#:XRFI\n", "x.crg:9:3: 'XRFI' is no data format", TRK_E_SYNTAX},
        {HEAD(V) "$KD_Definition\n#:LRFI\n#:LRFI\n", "is a second data format", TRK_E_SYNTAX},
        {HEAD(V) "$KD_Definition\n#:LRFI\nD:long section 1,mm\n", "expected the unit m",
         TRK_E_SYNTAX},
        {HEAD(V) "$KD_Definition\n#:LRFI\nD:long section x,m\n", "expected the number of a long",
         TRK_E_SYNTAX},
        {HEAD(V) "$KD_Definition\n#:LRFI\nD:long section at v 1,m\n", "expected 'long section at v",
         TRK_E_SYNTAX},
        {HEAD(V) "$KD_Definition\n#:LRFI\nD:long section 1,m\n$\n$$$$\n", "1 long sections",
         TRK_E_SYNTAX},
        {HEAD(V) "$KD_Definition\n#:LRFI\nD:long section 1,m\nD:long section 3,m\n$\n$$$$\n",
         "x.crg:11:1: long section 3, expected the numbers 1 to 2", TRK_E_SYNTAX},
        {HEAD(V) "$KD_Definition\n#:LRFI\nD:long section 1,m\nD:long section at v = 3,m\n$\n$$$$\n",
         "with a number among those with a place", TRK_E_SYNTAX},
        {HEAD(V) "$ROAD_CRG_OPTS\nBORDER_MODE_U = 7\n$\n" GRID, "BORDER_MODE_U is 7", TRK_E_SYNTAX},
        {HEAD(V) "$ROAD_CRG_OPTS\nBORDER_MODE_U = 0.5\n$\n" GRID, "expected a whole number",
         TRK_E_SYNTAX},
        {HEAD(V) "$ROAD_CRG_MODS\nGRID_NAN_MODE = -3\n$\n" GRID, "GRID_NAN_MODE is -3",
         TRK_E_SYNTAX},
        {HEAD(V) "$ROAD_CRG_MODS\nSCALE_LENGTH = 2\n$\n" GRID, "x.crg:9:1: SCALE_LENGTH changes",
         TRK_E_UNSUPPORTED},
        {HEAD(V) "$ROAD_CRG_FILE\nother.crg\n$\n" GRID, "x.crg:8:1: the road data stand in another",
         TRK_E_UNSUPPORTED},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        trk_crg *crg;
        assert_status(*state, parse(*state, row[k].text, NULL, &crg), row[k].status);
        assert_message(*state, row[k].message);
        assert_null(crg);
    }
}

static void wrong_arguments(void **state)
{
    trk_context *c = *state;
    trk_crg *crg;
    trk_crg_options o;
    assert_status(c, trk_crg_parse(NULL, "x", "", 0, NULL, &crg), TRK_E_ARGUMENT);
    assert_status(c, trk_crg_parse(c, NULL, "", 0, NULL, &crg), TRK_E_ARGUMENT);
    assert_status(c, trk_crg_parse(c, "x", NULL, 1, NULL, &crg), TRK_E_ARGUMENT);
    assert_status(c, trk_crg_parse(c, "x", "", 0, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_crg_read(NULL, "x", NULL, &crg), TRK_E_ARGUMENT);
    assert_status(c, trk_crg_read(c, NULL, NULL, &crg), TRK_E_ARGUMENT);
    assert_status(c, trk_crg_read(c, "x", NULL, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_crg_read(c, "/does/not/exist", NULL, &crg), TRK_E_FILE);
    for (int k = 0; k < 5; k++) {
        trk_crg_options_init(&o, sizeof o);
        o.border_u = k == 0 ? 6 : 0;
        o.border_v = k == 1 ? -1 : 0;
        o.missing = k == 2 ? 4 : 0;
        o.reserved = k == 3;
        if (k == 4)
            o.struct_size = 1;
        assert_status(c, parse(c, "", &o, &crg), k == 4 ? TRK_E_OPTIONS : TRK_E_RANGE);
    }
    assert_int_equal(trk_crg_rows(NULL), 0);
    assert_int_equal(trk_crg_columns(NULL), 0);
    assert_int_equal(trk_crg_extent(NULL, NULL, NULL, NULL, NULL), TRK_E_ARGUMENT);
    trk_crg_destroy(NULL);
}

static trk_status use_memory(trk_context *c)
{
    static char file[8000];
    const double v[] = {0, 1};
    trk_crg *crg;
    trk_signal *s;
    trk_series *series;
    trk_status status =
        trk_crg_parse(c, "x", file, binary(file, "KDBI", 0.5, 12, 8, false), NULL, &crg);
    if (status)
        return status;
    status = trk_crg_profile(c, crg, 0, 0, &s);
    trk_signal_destroy(s);
    if (status == TRK_OK) {
        status = trk_crg_sample(c, crg, 2, v, 0, 0.1, 5, &series);
        trk_series_destroy(series);
    }
    trk_crg_destroy(crg);
    if (status)
        return status;
    status = parse(c, HEAD(V "REFERENCE_LINE_START_B = 1\n") GRID, NULL, &crg);
    trk_crg_destroy(crg);
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
        TEST(belgian_block),
        TEST(rms_course),
        TEST(handmade),
        TEST(slope_and_banking),
        TEST(given_end),
        TEST(binary_formats),
        TEST(borders),
        TEST(profiles),
        TEST(converted_line_ends),
        TEST(faults),
        TEST(wrong_arguments),
        cmocka_unit_test(memory_runs_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
