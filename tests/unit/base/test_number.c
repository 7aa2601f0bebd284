/* SPDX-License-Identifier: MIT */
/* Decimal text to double: correctly rounded, exact places, no locale (BASE.1). */
#include "support.h"

#include "base/number.h"
#include <inttypes.h>
#include <locale.h>

static double read_all(const char *text)
{
    double value = -77;
    const char *end = trk_number_read(text, text + strlen(text), '.', &value);
    if (!end || *end)
        fail_msg("'%s' was not read to its end", text);
    return value;
}

/* Bits of results from Python's float(), whose conversion is David Gay's. */
static void hard_cases(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        uint64_t bits;
    } row[] = {
        {"0", 0x0000000000000000},
        {"-0", 0x8000000000000000},
        {"9007199254740993", 0x4340000000000000}, /* a tie, to even */
        {"9007199254740993.00000000000000000000000000001", 0x4340000000000001},
        {"2.2250738585072011e-308", 0x000fffffffffffff},
        {"2.2250738585072012e-308", 0x0010000000000000},
        {"4.9e-324", 0x0000000000000001},
        {"2.4703282292062327e-324", 0x0000000000000000}, /* half of it, less a little */
        {"2.4703282292062328e-324", 0x0000000000000001},
        {"1.7976931348623157e308", 0x7fefffffffffffff},
        {"1.7976931348623158e308", 0x7fefffffffffffff},
        {"1.7976931348623159e308", 0x7ff0000000000000},
        {"8.41e21", 0x447c7e83209e90b2},
        {"9.5e-23", 0x3b5cb644dc1633c1},
        {"1e23", 0x44b52d02c7e14af6},
        {"6.02214076e23", 0x44dfe185ca57c517},
        {"0.1", 0x3fb999999999999a},
        {"123456789012345678901234567890", 0x45f8ee90ff6c373e},
        {"1e-999999999999999999999", 0x0000000000000000},
        {"1D3", 0x408f400000000000},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const double value = read_all(row[k].text);
        uint64_t bits;
        memcpy(&bits, &value, sizeof bits);
        if (bits != row[k].bits)
            fail_msg("%s gives %016" PRIx64 ", expected %016" PRIx64, row[k].text, bits,
                     row[k].bits);
    }
    char text[1300];
    snprintf(text, sizeof text, "0.%0*d1e400", 399, 0);
    assert_near(read_all(text), 1, 0);
    snprintf(text, sizeof text, "9007199254740993.%0*d1", 1200, 0); /* beyond all digits kept */
    assert_true(read_all(text) == 9007199254740994.0);
}

/* What is written with 17 digits comes back. */
static void round_trip(void **state)
{
    (void)state;
    uint64_t bits = 88172645463325252u;
    for (int k = 0; k < 100000; k++) {
        bits ^= bits << 13;
        bits ^= bits >> 7;
        bits ^= bits << 17;
        double value;
        memcpy(&value, &bits, sizeof value);
        if (!isfinite(value))
            continue;
        char text[40];
        snprintf(text, sizeof text, k % 2 ? "%.17g" : "%.25e", value);
        const double back = read_all(text);
        if (memcmp(&back, &value, sizeof back) != 0)
            fail_msg("%s gives %.17g", text, back);
    }
}

static void ends_of_numbers(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        int length; /* -1: none */
    } row[] = {{"", -1},    {"-", -1},    {".", -1},   {"+.", -1},    {"e5", -1},   {"nan", -1},
               {"inf", -1}, {" 1", -1},   {"0x10", 1}, {"1,5", 1},    {"1.5.2", 3}, {"1e", 1},
               {"1e+", 1},  {"1e+5x", 4}, {"1.e5", 4}, {".5-0.5", 2}, {"--1", -1},  {"-.5d-3", 6}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        double value;
        const char *end =
            trk_number_read(row[k].text, row[k].text + strlen(row[k].text), '.', &value);
        assert_int_equal(end ? end - row[k].text : -1, row[k].length);
    }
    double value;
    const char text[] = "1,5e1";
    assert_ptr_equal(trk_number_read(text, text + 5, ',', &value), text + 5);
    assert_true(value == 15);
    assert_ptr_equal(trk_number_read(text, text + 3, ',', &value), text + 3); /* not past end */
    assert_true(value == 1.5);
}

static void whole_numbers(void **state)
{
    (void)state;
    int64_t value;
    const char most[] = "9223372036854775807", more[] = "9223372036854775808";
    assert_non_null(trk_integer_read(most, most + 19, &value));
    assert_true(value == INT64_MAX);
    assert_null(trk_integer_read(more, more + 19, &value));
    assert_non_null(trk_integer_read("-12x", "-12x" + 4, &value));
    assert_true(value == -12);
    assert_null(trk_integer_read("x", "x" + 1, &value));
}

static void other_locale(void **state)
{
    (void)state;
    if (!setlocale(LC_ALL, "de_DE.UTF-8")) {
        print_message("skipped: there is no locale de_DE.UTF-8\n");
        skip();
    }
    const double value = read_all("2.5");
    setlocale(LC_ALL, "C");
    assert_true(value == 2.5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hard_cases),      cmocka_unit_test(round_trip),
        cmocka_unit_test(ends_of_numbers), cmocka_unit_test(whole_numbers),
        cmocka_unit_test(other_locale),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
