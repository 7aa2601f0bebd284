/* SPDX-License-Identifier: MIT */
/* CSV files: exact text, quoting, locale, and what happens when the disk refuses. */
#include "support.h"

#include <locale.h>
#include <signal.h>
#include <sys/resource.h>
#include <truckride/series.h>
#include <unistd.h>

static const char path[] = "test_csv_output.csv";

static char *read_back(char *text, size_t size)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    text[fread(text, 1, size - 1, file)] = '\0';
    fclose(file);
    return text;
}

static trk_series *new_example(trk_context *context)
{
    trk_series *series;
    assert_ok(context, trk_series_create(context, 3, 3, 4.0, -0.25, &series));
    assert_ok(context, trk_series_label(series, 1, "seat", "m/s^2"));
    assert_ok(context, trk_series_label(series, 2, "cab, \"front\"", "N"));
    const double data[3][3] = {{1.0 / 3.0, -2e-20, 123456789.5}, {0.0, -0.5, 1e300}, {1, 2, 3}};
    for (int32_t c = 0; c < 3; c++)
        memcpy(trk_series_data_mutable(series, c + 1), data[c], sizeof data[c]);
    return series;
}

static const char whole[] = "time [s],seat [m/s^2],\"cab, \"\"front\"\" [N]\",3\n"
                            "-0.25,0.333333333,0,1\n"
                            "0,-2e-20,-0.5,2\n"
                            "0.25,123456790,1e+300,3\n";

static void test_text_of_the_file(void **state)
{
    char text[512];
    trk_series *series = new_example(*state);
    assert_ok(*state, trk_series_write_csv(*state, series, path, 1));
    assert_string_equal(read_back(text, sizeof text), whole);
    assert_ok(*state, trk_series_write_csv(*state, series, path, 2));
    assert_null(strstr(read_back(text, sizeof text), "\n0,"));
    assert_non_null(strstr(text, "\n0.25,"));
    assert_ok(*state, trk_series_write_csv(*state, series, path, INT64_MAX));
    assert_null(strstr(read_back(text, sizeof text), "\n0.25,"));
    remove(path);
    trk_series_destroy(series);
}

static void test_decimal_comma_locale(void **state)
{
    const char *names[] = {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8"};
    const char *found = NULL;
    for (int k = 0; k < 4 && !found; k++)
        found = setlocale(LC_ALL, names[k]);
    if (!found) {
        print_message("no locale with a decimal comma on this system: test skipped\n");
        skip();
    }
    char text[512], number[16];
    snprintf(number, sizeof number, "%.1f", 0.5);
    assert_string_equal(number, "0,5");
    trk_series *series = new_example(*state);
    assert_ok(*state, trk_series_write_csv(*state, series, path, 1));
    assert_string_equal(read_back(text, sizeof text), whole);
    snprintf(number, sizeof number, "%.1f", 0.5);
    assert_string_equal(number, "0,5"); /* the caller's locale is back */
    setlocale(LC_ALL, "C");
    remove(path);
    trk_series_destroy(series);
}

static void test_more_than_one_buffer(void **state)
{
    trk_series *series;
    enum { COUNT = 20000 };
    assert_ok(*state, trk_series_create(*state, 2, COUNT, 1000.0, 0.0, &series));
    for (int k = 0; k < COUNT; k++) {
        trk_series_data_mutable(series, 1)[k] = sin(k);
        trk_series_data_mutable(series, 2)[k] = k;
    }
    assert_ok(*state, trk_series_write_csv(*state, series, path, 1));
    FILE *file = fopen(path, "rb");
    char line[128];
    assert_non_null(fgets(line, sizeof line, file));
    for (int k = 0; k < COUNT; k++) {
        double t, a, b;
        assert_non_null(fgets(line, sizeof line, file));
        assert_int_equal(sscanf(line, "%lf,%lf,%lf", &t, &a, &b), 3);
        assert_near(t, 0.001 * k, 1e-8);
        assert_near(a, sin(k), 1e-9);
        assert_true(b == k);
    }
    assert_null(fgets(line, sizeof line, file));
    fclose(file);
    remove(path);
    trk_series_destroy(series);
}

static void test_refusals(void **state)
{
    trk_series *series = new_example(*state);
    assert_status(*state, trk_series_write_csv(*state, series, "no such folder/a.csv", 1),
                  TRK_E_FILE);
    assert_message(*state, "no such folder/a.csv: cannot be written (No such file or directory)");
    assert_status(*state, trk_series_write_csv(*state, series, path, 0), TRK_E_RANGE);
    assert_message(*state, "every is 0");
    assert_status(*state, trk_series_write_csv(*state, NULL, path, 1), TRK_E_ARGUMENT);
    assert_status(*state, trk_series_write_csv(*state, series, NULL, 1), TRK_E_ARGUMENT);
    assert_status(NULL, trk_series_write_csv(NULL, series, path, 1), TRK_E_ARGUMENT);
    assert_int_equal(access(path, F_OK), -1);
    trk_series_destroy(series);
}

static void test_full_disk(void **state)
{
    if (access("/dev/full", W_OK) != 0) {
        print_message("no /dev/full on this system: test skipped\n");
        skip();
    }
    trk_series *series = new_example(*state);
    assert_status(*state, trk_series_write_csv(*state, series, "/dev/full", 1), TRK_E_FILE);
    assert_message(*state, "/dev/full: cannot be written (No space left on device)");
    assert_int_equal(access("/dev/full", W_OK), 0); /* only ordinary files are removed */
    trk_series_destroy(series);
}

/* The system refuses to let the file grow beyond a limit, as a full disk would. */
static void test_incomplete_file_is_removed(void **state)
{
    trk_series *series;
    assert_ok(*state, trk_series_create(*state, 1, 50000, 1.0, 0.0, &series));
    struct rlimit before, small;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    small = before;
    small.rlim_cur = 100000;
    void (*handler)(int) = signal(SIGXFSZ, SIG_IGN);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
    trk_status status = trk_series_write_csv(*state, series, path, 1);
    setrlimit(RLIMIT_FSIZE, &before);
    signal(SIGXFSZ, handler);
    assert_int_equal(status, TRK_E_FILE);
    assert_message(*state, "cannot be written (File too large)");
    assert_int_equal(access(path, F_OK), -1);
    trk_series_destroy(series);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_text_of_the_file),
        cmocka_unit_test(test_decimal_comma_locale),
        cmocka_unit_test(test_more_than_one_buffer),
        cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_full_disk),
        cmocka_unit_test(test_incomplete_file_is_removed),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
