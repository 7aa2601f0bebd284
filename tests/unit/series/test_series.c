/* SPDX-License-Identifier: MIT */
/* Channels, labels, questions. */
#include "support.h"

#include <truckride/series.h>

static void test_new_series(void **state)
{
    trk_series *series;
    assert_ok(*state, trk_series_create(*state, 3, 5, 200.0, -1.5, &series));
    assert_int_equal(trk_series_channels(series), 3);
    assert_int_equal(trk_series_samples(series), 5);
    assert_true(trk_series_rate(series) == 200.0 && trk_series_start(series) == -1.5);
    assert_string_equal(trk_series_name(series, 3), "3");
    assert_string_equal(trk_series_unit(series, 3), "");
    assert_int_equal(trk_series_find(series, "2"), 2);
    for (int32_t c = 1; c <= 3; c++)
        for (int k = 0; k < 5; k++) {
            assert_true(trk_series_data(series, c)[k] == 0.0);
            trk_series_data_mutable(series, c)[k] = 10.0 * c + k;
        }
    assert_true(trk_series_data(series, 2)[4] == 24.0);
    for (int32_t c = 0; c <= 4; c += 4) {
        assert_null(trk_series_name(series, c));
        assert_null(trk_series_unit(series, c));
        assert_null(trk_series_data(series, c));
        assert_null(trk_series_data_mutable(series, c));
    }
    trk_series_destroy(series);
    trk_series_destroy(NULL);
}

static void test_labels(void **state)
{
    trk_series *series;
    assert_ok(*state, trk_series_create(*state, 2, 1, 1.0, 0.0, &series));
    assert_ok(*state, trk_series_label(series, 1, "seat", "m/s^2"));
    assert_ok(*state, trk_series_label(series, 1, "seat", "m/s"));
    assert_string_equal(trk_series_unit(series, 1), "m/s");
    assert_int_equal(trk_series_find(series, "seat"), 1);
    assert_int_equal(trk_series_find(series, "1"), 0);
    assert_int_equal(trk_series_find(series, NULL), 0);
    assert_status(*state, trk_series_label(series, 2, "seat", "m"), TRK_E_NAME);
    assert_message(*state, "'seat' for channel 2 is the name of channel 1");
    assert_status(*state, trk_series_label(series, 2, "", "m"), TRK_E_NAME);
    assert_status(*state, trk_series_label(series, 3, "a", "m"), TRK_E_ARGUMENT);
    assert_message(*state, "no channel 3, expected 1 to 2");
    assert_status(*state, trk_series_label(series, 1, NULL, "m"), TRK_E_ARGUMENT);
    assert_status(*state, trk_series_label(series, 1, "a", NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_series_label(NULL, 1, "a", "m"), TRK_E_ARGUMENT);
    assert_string_equal(trk_series_name(series, 2), "2");
    trk_series_destroy(series);
}

static void refuse(trk_context *context, int32_t channels, int64_t samples, double rate,
                   double start, const char *message)
{
    trk_series *series = (trk_series *)context;
    assert_status(context, trk_series_create(context, channels, samples, rate, start, &series),
                  TRK_E_RANGE);
    assert_null(series);
    assert_message(context, message);
}

static void test_errors(void **state)
{
    trk_series *series;
    refuse(*state, 0, 1, 1.0, 0.0, "0 channels");
    refuse(*state, 1, 0, 1.0, 0.0, "0 samples");
    refuse(*state, 1, 1, 0.0, 0.0, "sample_rate is 0 Hz");
    refuse(*state, 1, 1, NAN, 0.0, "sample_rate is nan");
    refuse(*state, 1, 1, 1.0, INFINITY, "start is inf");
    assert_status(*state, trk_series_create(*state, 1, INT64_MAX, 1.0, 0.0, &series), TRK_E_MEMORY);
    assert_null(series);
    assert_status(*state, trk_series_create(*state, 1, 1, 1.0, 0.0, NULL), TRK_E_ARGUMENT);
    assert_status(NULL, trk_series_create(NULL, 1, 1, 1.0, 0.0, &series), TRK_E_ARGUMENT);
}

static trk_status work(trk_context *context)
{
    trk_series *series, *other = NULL;
    trk_status status = trk_series_create(context, 2, 10, 100.0, 0.0, &series);
    if (status == TRK_OK)
        status = trk_series_label(series, 1, "seat", "m");
    if (status == TRK_OK)
        status = trk_series_resample(context, series, 50.0, &other);
    trk_series_destroy(other);
    trk_series_destroy(series);
    return status;
}

static void test_out_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(work);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_new_series),
        cmocka_unit_test(test_labels),
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_out_of_memory),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
