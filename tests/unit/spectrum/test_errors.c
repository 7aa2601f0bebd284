/* SPDX-License-Identifier: MIT */
/* Every way in which a spectrum function can fail, and that it leaves nothing behind. */
#include "support.h"

#include <truckride/spectrum.h>

enum { N = 300 };
static double x[N], y[N], out[2 * N];

static int setup(void **state)
{
    for (int i = 0; i < N; i++) {
        x[i] = i % 7;
        y[i] = i % 5;
        out[2 * i] = out[2 * i + 1] = -1;
    }
    return support_setup(state);
}

/* All four estimators with these options fail alike and write nothing. */
static void all_fail(trk_context *c, const trk_spectrum_options *o, int64_t n, trk_status status,
                     const char *text)
{
    assert_status(c, trk_psd(c, n, x, 100, o, out), status);
    assert_message(c, "trk_psd: ");
    assert_message(c, text);
    assert_status(c, trk_csd(c, n, x, y, 100, o, out), status);
    assert_message(c, text);
    assert_status(c, trk_coherence(c, n, x, y, o, out), status);
    assert_message(c, text);
    assert_status(c, trk_frf_h1(c, n, x, y, o, out), status);
    assert_message(c, text);
    assert_int_equal(trk_context_blocks(c), 0);
    for (int i = 0; i < 2 * N; i++)
        assert_true(out[i] == -1);
}

static void options_out_of_range(void **state)
{
    trk_context *c = *state;
    const struct {
        int64_t segment;
        double overlap, beta;
        int32_t window, detrend, scaling, reserved;
        trk_status status;
        const char *text;
    } bad[] = {
        {-1, 0.5, 1, 0, 0, 0, 0, TRK_E_RANGE, "segment_length is -1"},
        {N + 1, 0.5, 1, 0, 0, 0, 0, TRK_E_RANGE,
         "count is 300 samples, expected at least one segment of 301"},
        {64, 1.0, 1, 0, 0, 0, 0, TRK_E_RANGE, "overlap is 1,"},
        {64, -0.1, 1, 0, 0, 0, 0, TRK_E_RANGE, "overlap is -0.1"},
        {64, NAN, 1, 0, 0, 0, 0, TRK_E_RANGE, "overlap is"},
        {64, 0.5, -1, 0, 0, 0, 0, TRK_E_RANGE, "kaiser_beta is -1"},
        {64, 0.5, 701, 0, 0, 0, 0, TRK_E_RANGE, "kaiser_beta is 701"},
        {64, 0.5, 1, 7, 0, 0, 0, TRK_E_ARGUMENT, "window is 7, expected 0 to 6"},
        {64, 0.5, 1, -1, 0, 0, 0, TRK_E_ARGUMENT, "window is -1"},
        {64, 0.5, 1, 0, 3, 0, 0, TRK_E_ARGUMENT, "detrend is 3"},
        {64, 0.5, 1, 0, 0, 2, 0, TRK_E_ARGUMENT, "scaling is 2"},
        {64, 0.5, 1, 0, 0, 0, 1, TRK_E_ARGUMENT, "reserved is 1"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        trk_spectrum_options o = {sizeof o,       bad[i].segment, bad[i].overlap,  bad[i].window,
                                  bad[i].detrend, bad[i].scaling, bad[i].reserved, bad[i].beta};
        all_fail(c, &o, N, bad[i].status, bad[i].text);
        assert_int_equal(trk_psd_length(&o, N), 0);
        assert_int_equal(trk_psd_segments(&o, N), 0);
        assert_status(c, trk_psd_frequencies(c, N, 100, &o, out), bad[i].status);
    }
    all_fail(c, NULL, 0, TRK_E_RANGE, "count is 0");
    const trk_spectrum_options unset = {0, 64, 0.5, 0, 0, 0, 0, 1};
    all_fail(c, &unset, N, TRK_E_OPTIONS, "struct_size is 0");
}

static void samples_and_rates(void **state)
{
    trk_context *c = *state;
    const double rates[] = {0, -1, NAN, INFINITY};
    for (int i = 0; i < 4; i++) {
        assert_status(c, trk_psd(c, N, x, rates[i], NULL, out), TRK_E_RANGE);
        assert_message(c, "sample_rate is");
        assert_status(c, trk_csd(c, N, x, y, rates[i], NULL, out), TRK_E_RANGE);
        assert_status(c, trk_psd_frequencies(c, N, rates[i], NULL, out), TRK_E_RANGE);
    }
    x[17] = NAN;
    all_fail(c, NULL, N, TRK_E_RANGE, "x[17] is");
    x[17] = 0;
    y[299] = -INFINITY;
    assert_status(c, trk_csd(c, N, x, y, 1, NULL, out), TRK_E_RANGE);
    assert_message(c, "y[299] is -inf");
    x[17] = 1e200;
    y[299] = 0;
    assert_status(c, trk_psd(c, N, x, 100, NULL, out), TRK_E_RANGE);
    assert_message(c, "trk_psd: the square of a sample overflows");
    assert_status(c, trk_coherence(c, N, x, y, NULL, out), TRK_E_RANGE);
    assert_status(c, trk_frf_h1(c, N, x, y, NULL, out), TRK_E_RANGE);
    y[17] = 1e200;
    assert_status(c, trk_csd(c, N, x, y, 100, NULL, out), TRK_E_RANGE);
    x[17] = 1e150;
    assert_status(c, trk_psd(c, N, x, 1e-300, NULL, out), TRK_E_RANGE);
    assert_message(c, "overflows at a sample_rate of 1e-300 Hz");
}

static void null_pointers(void **state)
{
    trk_context *c = *state;
    int64_t count;
    const trk_status e = TRK_E_ARGUMENT;
    assert_status(c, trk_psd(NULL, N, x, 1, NULL, out), e);
    assert_status(c, trk_psd(c, N, NULL, 1, NULL, out), e);
    assert_message(c, "trk_psd: x is NULL");
    assert_status(c, trk_psd(c, N, x, 1, NULL, NULL), e);
    assert_status(c, trk_csd(NULL, N, x, y, 1, NULL, out), e);
    assert_status(c, trk_csd(c, N, NULL, y, 1, NULL, out), e);
    assert_status(c, trk_csd(c, N, x, NULL, 1, NULL, out), e);
    assert_status(c, trk_csd(c, N, x, y, 1, NULL, NULL), e);
    assert_status(c, trk_coherence(NULL, N, x, y, NULL, out), e);
    assert_status(c, trk_coherence(c, N, NULL, y, NULL, out), e);
    assert_status(c, trk_coherence(c, N, x, NULL, NULL, out), e);
    assert_status(c, trk_coherence(c, N, x, y, NULL, NULL), e);
    assert_status(c, trk_frf_h1(NULL, N, x, y, NULL, out), e);
    assert_status(c, trk_frf_h1(c, N, NULL, y, NULL, out), e);
    assert_status(c, trk_frf_h1(c, N, x, NULL, NULL, out), e);
    assert_status(c, trk_frf_h1(c, N, x, y, NULL, NULL), e);
    assert_status(c, trk_psd_frequencies(NULL, N, 1, NULL, out), e);
    assert_status(c, trk_psd_frequencies(c, N, 1, NULL, NULL), e);
    assert_status(c, trk_psd_normalise(NULL, N, x, 0, out, NULL), e);
    assert_status(c, trk_psd_normalise(c, N, NULL, 0, out, NULL), e);
    assert_status(c, trk_psd_normalise(c, N, x, 0, NULL, NULL), e);
    assert_status(c, trk_band_rms(NULL, N, x, 1, 0, 1, out), e);
    assert_status(c, trk_band_rms(c, N, NULL, 1, 0, 1, out), e);
    assert_status(c, trk_band_rms(c, N, x, 1, 0, 1, NULL), e);
    assert_status(c, trk_psd_peaks(NULL, N, x, 1, NULL, 0, NULL, NULL, NULL, &count), e);
    assert_status(c, trk_psd_peaks(c, N, NULL, 1, NULL, 0, NULL, NULL, NULL, &count), e);
    assert_status(c, trk_psd_peaks(c, N, x, 1, NULL, 0, NULL, NULL, NULL, NULL), e);
    trk_spectrum_options_init(NULL, sizeof(trk_spectrum_options));
    trk_peak_options_init(NULL, sizeof(trk_peak_options));
}

static void numbers_from_densities(void **state)
{
    trk_context *c = *state;
    const double zero[2] = {0, 0}, large[2] = {1e308, 1e308}, bad[2] = {1, -1};
    const trk_status e = TRK_E_RANGE;
    int64_t count;
    assert_status(c, trk_psd_normalise(c, 2, zero, 0, out, NULL), e);
    assert_message(c, "density is 0 everywhere");
    assert_status(c, trk_psd_normalise(c, 2, bad, 0, out, NULL), e);
    assert_message(c, "density[1] is -1");
    assert_status(c, trk_psd_normalise(c, 0, x, 0, out, NULL), e);
    assert_status(c, trk_psd_normalise(c, N, x, -1, out, NULL), e);
    assert_status(c, trk_psd_normalise(c, 2, large, 1e-10, out, NULL), e);
    assert_message(c, "overflows");
    assert_status(c, trk_band_rms(c, N, x, 0, 0, 1, out), e);
    assert_message(c, "frequency_step is 0 Hz");
    assert_status(c, trk_band_rms(c, N, x, 1, -1, 1, out), e);
    assert_status(c, trk_band_rms(c, N, x, 1, 2, 1, out), e);
    assert_status(c, trk_band_rms(c, N, x, 1, 0, INFINITY, out), e);
    assert_status(c, trk_band_rms(c, 2, bad, 1, 0, 1, out), e);
    assert_status(c, trk_band_rms(c, 2, large, 1, 0, 9, out), e);
    assert_message(c, "overflows");
    const trk_peak_options wrong[] = {
        {sizeof *wrong, -1, 0, 0, 0, 0},       {sizeof *wrong, 0, NAN, 0, 0, 0},
        {sizeof *wrong, 0, 0, INFINITY, 0, 0}, {sizeof *wrong, 0, 0, 0, 2, 0},
        {sizeof *wrong, 0, 0, 0, 0, 1},        {1, 0, 0, 0, 0, 0},
    };
    const trk_status status[] = {e, e, e, TRK_E_ARGUMENT, TRK_E_ARGUMENT, TRK_E_OPTIONS};
    for (int i = 0; i < 6; i++)
        assert_status(c, trk_psd_peaks(c, N, x, 1, &wrong[i], 0, NULL, NULL, NULL, &count),
                      status[i]);
    assert_status(c, trk_psd_peaks(c, N, x, 1, NULL, -1, NULL, NULL, NULL, &count), e);
    assert_message(c, "capacity is -1");
    assert_status(c, trk_psd_peaks(c, N, x, NAN, NULL, 0, NULL, NULL, NULL, &count), e);
    assert_status(c, trk_psd_peaks(c, 2, bad, 1, NULL, 0, NULL, NULL, NULL, &count), e);
    assert_status(c, trk_psd_peaks(c, 0, x, 1, NULL, 0, NULL, NULL, NULL, &count), e);
    assert_true(out[0] == -1);
}

static trk_status estimate_all(trk_context *c)
{
    trk_spectrum_options o;
    trk_spectrum_options_init(&o, sizeof o);
    o.segment_length = 74; /* 2 * 37: Bluestein */
    trk_peak_options p;
    trk_peak_options_init(&p, sizeof p);
    p.minimum_distance = 3;
    int64_t count;
    trk_status status = trk_psd(c, N, x, 100, &o, out);
    if (status == TRK_OK)
        status = trk_csd(c, N, x, y, 100, &o, out);
    if (status == TRK_OK)
        status = trk_coherence(c, N, x, y, &o, out);
    if (status == TRK_OK)
        status = trk_frf_h1(c, N, x, y, &o, out);
    if (status == TRK_OK)
        status = trk_psd_peaks(c, N, x, 1, &p, 0, NULL, NULL, NULL, &count);
    return status;
}

static void survives_lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(estimate_all);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(options_out_of_range, setup, support_teardown),
        cmocka_unit_test_setup_teardown(samples_and_rates, setup, support_teardown),
        cmocka_unit_test_setup_teardown(null_pointers, setup, support_teardown),
        cmocka_unit_test_setup_teardown(numbers_from_densities, setup, support_teardown),
        cmocka_unit_test_setup_teardown(survives_lack_of_memory, setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
