/* SPDX-License-Identifier: MIT */
/* CSV tables: separators, headers, units, axes, places in messages, locales, memory. */
#include "shared.h"

#include <locale.h>
#include <truckride/files.h>

static trk_status parse(trk_context *c, const char *text, const trk_csv_options *options,
                        trk_series **out)
{
    return trk_series_parse_csv(c, "x.csv", text, strlen(text), options, out);
}

static void separators_and_line_ends(void **state)
{
    static const char *const text[] = {
        "t [s],a [m],b\n0,1,2\n0.5,3,4\n1,5,6\n",
        "\357\273\277t [s];a [m];b\r\n0;1;2\r\n0.5;3;4\r\n1;5;6",
        "# made by hand\n\nt (s)\ta(m)\tb\n0\t1\t2\n\n0.5\t3\t4\n# here, too\n1\t5\t6\n\n",
        "t,a,b\n[s],[m],\n0,1,2\n0.5,3,4\n1,5,6\n",
        "t,a,b\ns,m,-\n 0 ,+1,2\n5e-1,\"3\",4.\n1,5, 6\t\n",
        "\"t [s]\",\"a [m]\",b,\n0,1,2,\n0.5,3,4,\n1,5,6,\n",
        "ms   a\t b\r\n 0   1  2 \n 0.5 3  4\n1 5 6  \n",
    };
    for (size_t k = 0; k < sizeof text / sizeof *text; k++) {
        trk_series *s;
        assert_ok(*state, parse(*state, text[k], NULL, &s));
        assert_int_equal(trk_series_channels(s), 2);
        assert_int_equal(trk_series_samples(s), 3);
        assert_near(trk_series_rate(s), 2, 0);
        assert_near(trk_series_start(s), 0, 0);
        assert_string_equal(trk_series_name(s, 1), "a");
        assert_string_equal(trk_series_unit(s, 1), k == 6 ? "" : "m");
        for (int c = 1; c <= 2; c++)
            for (int i = 0; i < 3; i++)
                assert_near(trk_series_data(s, c)[i], 2 * i + c, 0);
        trk_series_destroy(s);
    }
}

static void without_header(void **state)
{
    trk_series *s;
    assert_ok(*state, parse(*state, "10 1\n10.25 2\n10.5 3\n", NULL, &s));
    assert_string_equal(trk_series_name(s, 1), "column 2");
    assert_near(trk_series_rate(s), 4, 0);
    assert_near(trk_series_start(s), 10, 0);
    trk_series_destroy(s);
}

static void labels(void **state)
{
    trk_series *s;
    assert_ok(*state, parse(*state,
                            "x [mm],\"a, \"\"b\"\" [m/s^2]\",2,2,,\"two\nlines\",gr\xfc\xdf"
                            "e,[m],4 [N]\n0,1,2,3,4,5,6,7,8\n50,1,2,3,4,5,6,7,8\n",
                            NULL, &s));
    static const char *const name[] = {"a, \"b\"",  "2",     "2 (4)",    "column 5",
                                       "two lines", "grüße", "column 8", "4"};
    for (int c = 1; c <= 8; c++)
        assert_string_equal(trk_series_name(s, c), name[c - 1]);
    assert_string_equal(trk_series_unit(s, 1), "m/s^2");
    assert_string_equal(trk_series_unit(s, 7), "m");
    assert_near(trk_series_rate(s), 20, 1e-12); /* 50 mm */
    trk_series_destroy(s);
}

static void decimal_comma(void **state)
{
    trk_context *c = *state;
    trk_series *s;
    trk_csv_options o;
    trk_csv_options_init(&o, sizeof o);
    assert_status(c, parse(c, "t;a\n0,0;1,5\n0,5;2,5\n", NULL, &s), TRK_E_SYNTAX);
    assert_message(c, "x.csv:2:1: '0,0' has a decimal comma");
    assert_null(s);
    o.decimal_comma = 1;
    assert_ok(c, parse(c, "t;a\n0,0;1,5\n0,5;2,5\n", &o, &s));
    assert_near(trk_series_data(s, 1)[1], 2.5, 0);
    trk_series_destroy(s);
    o.separator = ',';
    assert_status(c, parse(c, "t;a\n0,0;1,5\n", &o, &s), TRK_E_RANGE);
    assert_message(c, "decimal_comma needs ';'");
}

static void caller_in_german(void **state)
{
    trk_series *s;
    if (!setlocale(LC_ALL, "de_DE.UTF-8")) {
        print_message("skipped: there is no locale de_DE.UTF-8\n");
        skip();
    }
    const trk_status status = parse(*state, "t,a\n0.0,1.5\n0.5,2.5\n", NULL, &s);
    setlocale(LC_ALL, "C");
    assert_int_equal(status, TRK_OK);
    assert_near(trk_series_data(s, 1)[1], 2.5, 0);
    assert_near(trk_series_rate(s), 2, 0);
    trk_series_destroy(s);
}

/* Each fault with its place. */
static void faults(void **state)
{
    static const struct {
        const char *text, *message;
        trk_status status;
    } row[] = {
        {"", "x.csv: the file has no rows", TRK_E_SYNTAX},
        {"# only\n\n", "x.csv: the file has no rows", TRK_E_SYNTAX},
        {"1\n2\n3\n", "x.csv:1:1: there is one column", TRK_E_SYNTAX},
        {"t,a\n0,1\n", "expected at least 2", TRK_E_SYNTAX},
        {"t,a\n", "expected at least 2", TRK_E_SYNTAX},
        {"t,a\n0,1\n1,x2\n", "x.csv:3:3: expected a number, not 'x2'", TRK_E_SYNTAX},
        {"t,a\n0,1\n1,\n", "x.csv:3:3: the field is empty", TRK_E_SYNTAX},
        {"t,a,b\n0,1,2\n1,,2\n", "x.csv:3:3: the field is empty", TRK_E_SYNTAX},
        {"t,a,b\n0,1,2\n1,2\n", "x.csv:3:3: the row has 2 fields, expected 3", TRK_E_SYNTAX},
        {"t,a\n0,1\n1,2,3\n", "x.csv:3:5: the row has more than 2 fields", TRK_E_SYNTAX},
        {"t,a\n0,1\n1,nan\n", "x.csv:3:3: 'nan' is not finite", TRK_E_SYNTAX},
        {"t,a\n0,1\n1,1e999\n", "x.csv:3:3: '1e999' is too large", TRK_E_SYNTAX},
        {"t,a\n0,1\n1,\"2\n", "x.csv:3:3: this quote is not closed", TRK_E_SYNTAX},
        {"t,a\n0,1\n1,\"2\"2\n", "x.csv:3:6: expected a separator", TRK_E_SYNTAX},
        {"t,a\n0,1\n1,2\n2.2,3\n3,4\n", "x.csv:4:1: the axis is 2.2, even spacing", TRK_E_RANGE},
        {"t,a\n1,1\n0,2\n", "expected it to increase", TRK_E_RANGE},
        {"t,a\n0,1\n1,\0012\n", "x.csv:3:3: expected a number, not '?2'", TRK_E_SYNTAX},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        trk_series *s;
        assert_status(*state, parse(*state, row[k].text, NULL, &s), row[k].status);
        assert_message(*state, row[k].message);
        assert_null(s);
    }
}

static void uneven_profile_as_signal(void **state)
{
    trk_context *c = *state;
    const char text[] = "x [m],left [mm],right\n0,10,1\n1,30,2\n3,20,4\n";
    trk_signal *s;
    assert_ok(c, trk_signal_parse_csv(c, "p", text, sizeof text - 1, NULL, 1, &s));
    assert_near(trk_signal_value(s, 1), 0.030, 1e-15);
    assert_near(trk_signal_value(s, 99), 0.020, 1e-15);
    trk_signal_destroy(s);
    assert_ok(c, trk_signal_parse_csv(c, "p", text, sizeof text - 1, NULL, 2, &s));
    assert_near(trk_signal_value(s, 3), 4, 0); /* unknown unit: as it is */
    trk_signal_destroy(s);
    assert_status(c, trk_signal_parse_csv(c, "p", text, sizeof text - 1, NULL, 3, &s), TRK_E_RANGE);
    assert_message(c, "p: column is 3, expected 1 to 2");
    assert_status(c, trk_signal_parse_csv(c, "p", text, sizeof text - 1, NULL, 0, &s), TRK_E_RANGE);
    assert_status(c, trk_signal_parse_csv(c, "p", "x,y\n0,1\n0,2\n", 12, NULL, 1, &s), TRK_E_RANGE);
    assert_message(c, "p: ");
}

/* What trk_series_write_csv() writes comes back with its 9 digits. */
static void own_files(void **state)
{
    trk_context *c = *state;
    static const char path[] = "test_csv_read.csv";
    trk_series *s, *back;
    assert_ok(c, trk_series_create(c, 2, 5000, 1000, 3.5, &s));
    assert_ok(c, trk_series_label(s, 1, "cab, \"front\"", "m/s^2"));
    for (int k = 0; k < 5000; k++)
        trk_series_data_mutable(s, 1)[k] = sin(0.01 * k);
    assert_ok(c, trk_series_write_csv(c, s, path, 1));
    assert_ok(c, trk_series_read_csv(c, path, NULL, &back));
    remove(path);
    assert_near(trk_series_rate(back), 1000, 0);
    assert_near(trk_series_start(back), 3.5, 0);
    assert_string_equal(trk_series_name(back, 1), "cab, \"front\"");
    assert_string_equal(trk_series_unit(back, 1), "m/s^2");
    for (int k = 0; k < 5000; k++)
        assert_near(trk_series_data(back, 1)[k], sin(0.01 * k), 5e-10);
    trk_series_destroy(back);
    trk_series_destroy(s);
}

/* Profile 1 of Sroubek, Sorel and Zak (2021). */
static void measured_profile(void **state)
{
    size_t size;
    char *bytes =
        shared_file(__FILE__, "tests/unit/files/test_csv_read.c", "iri_profile_1.txt", &size);
    if (!bytes)
        skip();
    trk_series *s;
    assert_ok(*state, trk_series_parse_csv(*state, "iri", bytes, size, NULL, &s));
    free(bytes);
    assert_int_equal(trk_series_samples(s), 2177);
    assert_near(trk_series_rate(s), 4, 0);
    assert_near(trk_series_start(s), 478, 0);
    assert_near(trk_series_data(s, 1)[0], 583.1370, 0);
    assert_near(trk_series_data(s, 1)[4], 583.1425, 0);
    trk_series_destroy(s);
}

static void to_si(void **state)
{
    trk_series *s;
    assert_ok(*state, parse(*state,
                            "t,a [mm],b [g],c [kN],d [deg],e [furlong],f [m/s2],h [m]\n"
                            "0,1,1,1,180,1,1,1\n1,2,2,2,2,2,2,2\n",
                            NULL, &s));
    assert_ok(*state, trk_series_to_si(s));
    static const struct {
        const char *unit;
        double value;
    } row[] = {{"m", 1e-3},    {"m/s^2", 9.80665}, {"N", 1000}, {"rad", 3.14159265358979312},
               {"furlong", 1}, {"m/s^2", 1},       {"m", 1}};
    for (int c = 0; c < 7; c++) {
        assert_string_equal(trk_series_unit(s, c + 1), row[c].unit);
        assert_near(trk_series_data(s, c + 1)[0], row[c].value, 0);
    }
    trk_series_destroy(s);
    assert_int_equal(trk_series_to_si(NULL), TRK_E_ARGUMENT);
}

static void wrong_arguments(void **state)
{
    trk_context *c = *state;
    trk_series *s;
    trk_signal *g;
    trk_csv_options o;
    assert_status(c, trk_series_parse_csv(NULL, "x", "", 0, NULL, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_parse_csv(c, NULL, "", 0, NULL, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_parse_csv(c, "x", NULL, 1, NULL, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_parse_csv(c, "x", NULL, 0, NULL, &s), TRK_E_SYNTAX);
    assert_status(c, trk_series_parse_csv(c, "x", "", 0, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_series_read_csv(NULL, "x", NULL, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_read_csv(c, NULL, NULL, &s), TRK_E_ARGUMENT);
    assert_status(c, trk_series_read_csv(c, "x", NULL, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_series_read_csv(c, "/does/not/exist", NULL, &s), TRK_E_FILE);
    assert_message(c, "/does/not/exist: cannot be read (No such file");
    assert_status(c, trk_series_read_csv(c, ".", NULL, &s), TRK_E_FILE);
    assert_status(c, trk_signal_read_csv(NULL, "x", NULL, 1, &g), TRK_E_ARGUMENT);
    assert_status(c, trk_signal_read_csv(c, NULL, NULL, 1, &g), TRK_E_ARGUMENT);
    assert_status(c, trk_signal_read_csv(c, "x", NULL, 1, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_signal_read_csv(c, "/does/not/exist", NULL, 1, &g), TRK_E_FILE);
    assert_status(c, trk_signal_parse_csv(NULL, "x", "", 0, NULL, 1, &g), TRK_E_ARGUMENT);
    assert_status(c, trk_signal_parse_csv(c, NULL, "", 0, NULL, 1, &g), TRK_E_ARGUMENT);
    assert_status(c, trk_signal_parse_csv(c, "x", NULL, 2, NULL, 1, &g), TRK_E_ARGUMENT);
    assert_status(c, trk_signal_parse_csv(c, "x", "", 0, NULL, 1, NULL), TRK_E_ARGUMENT);
    for (int k = 0; k < 4; k++) {
        trk_csv_options_init(&o, sizeof o);
        o.separator = k == 0 ? 'x' : 0;
        o.decimal_comma = k == 1 ? 2 : 0;
        o.spacing_tolerance = k == 2 ? NAN : 0.01;
        if (k == 3)
            o.struct_size = 1;
        assert_status(c, parse(c, "0,1\n1,2\n", &o, &s), k == 3 ? TRK_E_OPTIONS : TRK_E_RANGE);
    }
}

static trk_status use_memory(trk_context *c)
{
    trk_series *s;
    trk_signal *g;
    const char text[] = "t [ms],a,a\ns,m,m\n0,1,2\n1,2,3\n2,3,4\n3,4,5\n";
    trk_status status = trk_series_parse_csv(c, "x", text, sizeof text - 1, NULL, &s);
    trk_series_destroy(s);
    if (status)
        return status;
    status = trk_signal_parse_csv(c, "x", text, sizeof text - 1, NULL, 1, &g);
    trk_signal_destroy(g);
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
        TEST(separators_and_line_ends),
        TEST(without_header),
        TEST(labels),
        TEST(decimal_comma),
        TEST(caller_in_german),
        TEST(faults),
        TEST(uneven_profile_as_signal),
        TEST(own_files),
        TEST(measured_profile),
        TEST(to_si),
        TEST(wrong_arguments),
        cmocka_unit_test(memory_runs_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
