/* SPDX-License-Identifier: MIT */
/* Axes, totals, reactions, exposure, SEAT factors, third octaves. */
#include "support.h"

#include <truckride/comfort.h>
#include <truckride/spectrum.h>

static void axes_of_the_standard(void **state)
{
    (void)state;
    const trk_weighting weighting[] = {2, 2, 1, 4, 4, 4, 3, 2, 2, 1, 1, 1};
    const double k[] = {1, 1, 1, 0.63, 0.4, 0.2, 0.8, 0.5, 0.4, 0.25, 0.25, 0.4};
    for (trk_axis axis = 1; axis <= 12; axis++) {
        trk_weighting w;
        double m;
        assert_int_equal(trk_axis_get(axis, TRK_PURPOSE_COMFORT, &w, &m), TRK_OK);
        assert_int_equal(w, weighting[axis - 1]);
        assert_near(m, k[axis - 1], 0);
        int known = axis <= TRK_AXIS_SEAT_Z;
        assert_int_equal(trk_axis_get(axis, TRK_PURPOSE_HEALTH, NULL, &m),
                         known ? TRK_OK : TRK_E_ARGUMENT);
        if (known)
            assert_near(m, axis == TRK_AXIS_SEAT_Z ? 1 : 1.4, 0);
    }
    assert_int_equal(trk_axis_get(0, 0, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_axis_get(13, 0, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_axis_get(1, 2, NULL, NULL), TRK_E_ARGUMENT);
}

static void totals(void **state)
{
    trk_context *c = *state;
    const trk_axis axis[] = {TRK_AXIS_SEAT_X, TRK_AXIS_SEAT_Y, TRK_AXIS_SEAT_Z,
                             TRK_AXIS_BACK_X, TRK_AXIS_FEET_Z, TRK_AXIS_SEAT_PITCH};
    const double rms[] = {0.3, 0.4, 1.2, 0.5, 1, 2};
    double sum;
    assert_ok(c, trk_vibration_total(c, TRK_PURPOSE_COMFORT, 3, axis, rms, &sum));
    assert_near(sum, 1.3, 1e-15);
    assert_ok(c, trk_vibration_total(c, TRK_PURPOSE_HEALTH, 3, axis, rms, &sum));
    assert_near(sum, sqrt(1.96 * 0.25 + 1.44), 1e-15);
    assert_ok(c, trk_vibration_total(c, TRK_PURPOSE_COMFORT, 6, axis, rms, &sum));
    assert_near(sum, sqrt(1.69 + 0.16 + 0.16 + 0.64), 1e-15);
    assert_status(c, trk_vibration_total(c, TRK_PURPOSE_HEALTH, 4, axis, rms, &sum),
                  TRK_E_ARGUMENT);
    assert_message(c, "axis 7 has no factor for purpose 1");
    const trk_axis twice[] = {1, 2, 1};
    assert_status(c, trk_vibration_total(c, 0, 3, twice, rms, &sum), TRK_E_ARGUMENT);
    assert_message(c, "axis 1 comes twice");
    const double bad[] = {1, -1, 1};
    assert_status(c, trk_vibration_total(c, 0, 3, axis, bad, &sum), TRK_E_RANGE);
    assert_message(c, "rms is -1");
    assert_status(c, trk_vibration_total(c, 0, 0, axis, rms, &sum), TRK_E_RANGE);
    assert_status(c, trk_vibration_total(NULL, 0, 1, axis, rms, &sum), TRK_E_ARGUMENT);
    assert_status(c, trk_vibration_total(c, 0, 1, NULL, rms, &sum), TRK_E_ARGUMENT);
    assert_status(c, trk_vibration_total(c, 0, 1, axis, NULL, &sum), TRK_E_ARGUMENT);
    assert_status(c, trk_vibration_total(c, 0, 1, axis, rms, NULL), TRK_E_ARGUMENT);
}

static void reactions_overlap(void **state)
{
    (void)state;
    const struct {
        double total;
        int32_t reactions;
    } row[] = {{0, 1},        {0.3, 1},       {0.315, 1 | 2}, {0.4, 2},
               {0.55, 2 | 4}, {0.7, 4},       {0.9, 4 | 8},   {1.1, 8},
               {1.3, 8 | 16}, {1.6, 8 | 16},  {1.8, 16},      {2.2, 16 | 32},
               {3, 32},       {INFINITY, 32}, {-1, 0},        {NAN, 0}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++)
        assert_int_equal(trk_comfort_reactions(row[k].total), row[k].reactions);
    assert_string_equal(trk_comfort_text(TRK_REACTION_NOT_UNCOMFORTABLE), "not uncomfortable");
    assert_string_equal(trk_comfort_text(TRK_REACTION_VERY_UNCOMFORTABLE), "very uncomfortable");
    assert_string_equal(trk_comfort_text(32), "extremely uncomfortable");
    assert_null(trk_comfort_text(0));
    assert_null(trk_comfort_text(3));
    assert_null(trk_comfort_text(64));
}

static void daily_exposure(void **state)
{
    trk_context *c = *state;
    const double rms[] = {0.8, 0.5}, hours[] = {4 * 3600, 2 * 3600}, vdv[] = {10, 5},
                 measured[] = {600, 600};
    double a8, dose;
    assert_ok(c, trk_daily_a8(c, TRK_AXIS_SEAT_Z, 2, rms, hours, &a8));
    assert_near(a8, sqrt(0.64 / 2 + 0.25 / 4), 1e-15);
    assert_ok(c, trk_daily_a8(c, TRK_AXIS_SEAT_X, 2, rms, hours, &a8));
    assert_near(a8, 1.4 * sqrt(0.64 / 2 + 0.25 / 4), 1e-15);
    assert_ok(c, trk_daily_vdv(c, TRK_AXIS_SEAT_Y, 2, vdv, measured, hours, &dose));
    assert_near(dose, 1.4 * pow(1e4 * 24 + 625 * 12, 0.25), 1e-13);
    assert_int_equal(trk_exposure_of_a8(0.5), TRK_EXPOSURE_BELOW_ACTION);
    assert_int_equal(trk_exposure_of_a8(0.51), TRK_EXPOSURE_ABOVE_ACTION);
    assert_int_equal(trk_exposure_of_a8(1.15), TRK_EXPOSURE_ABOVE_ACTION);
    assert_int_equal(trk_exposure_of_a8(1.16), TRK_EXPOSURE_ABOVE_LIMIT);
    assert_int_equal(trk_exposure_of_a8(NAN), TRK_EXPOSURE_ABOVE_LIMIT);
    assert_int_equal(trk_exposure_of_vdv(9.1), TRK_EXPOSURE_BELOW_ACTION);
    assert_int_equal(trk_exposure_of_vdv(9.2), TRK_EXPOSURE_ABOVE_ACTION);
    assert_int_equal(trk_exposure_of_vdv(21.1), TRK_EXPOSURE_ABOVE_LIMIT);
}

static void daily_exposure_errors(void **state)
{
    trk_context *c = *state;
    double x[1] = {1}, bad[1] = {-1}, zero[1] = {0}, large[1] = {1e75}, out;
    assert_status(c, trk_daily_a8(NULL, 3, 1, x, x, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_daily_a8(c, 3, 1, NULL, x, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_daily_a8(c, 3, 1, x, NULL, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_daily_a8(c, 3, 1, x, x, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_daily_a8(c, 4, 1, x, x, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_daily_a8(c, 3, 0, x, x, &out), TRK_E_RANGE);
    assert_status(c, trk_daily_a8(c, 3, 1, bad, x, &out), TRK_E_RANGE);
    assert_message(c, "rms is -1");
    assert_status(c, trk_daily_a8(c, 3, 1, x, bad, &out), TRK_E_RANGE);
    assert_message(c, "duration is -1");
    assert_status(c, trk_daily_vdv(NULL, 3, 1, x, x, x, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_daily_vdv(c, 3, 1, NULL, x, x, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_daily_vdv(c, 3, 1, x, NULL, x, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_daily_vdv(c, 3, 1, x, x, NULL, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_daily_vdv(c, 3, 1, x, x, x, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_daily_vdv(c, 12, 1, x, x, x, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_daily_vdv(c, 3, -1, x, x, x, &out), TRK_E_RANGE);
    assert_status(c, trk_daily_vdv(c, 3, 1, bad, x, x, &out), TRK_E_RANGE);
    assert_status(c, trk_daily_vdv(c, 3, 1, x, zero, x, &out), TRK_E_RANGE);
    assert_message(c, "measured is 0");
    assert_status(c, trk_daily_vdv(c, 3, 1, x, x, bad, &out), TRK_E_RANGE);
    double tiny[1] = {1e-300};
    assert_status(c, trk_daily_vdv(c, 3, 1, large, tiny, large, &out), TRK_E_RANGE);
    assert_message(c, "overflows");
}

/* A seat that halves everything, on an offset that the weighting takes away. */
static void seat_factor(void **state)
{
    trk_context *c = *state;
    enum { N = 4000 };
    static double seat[N], base[N];
    for (int i = 0; i < N; i++) {
        base[i] = 9.81 + sin(0.05 * i) + sin(0.31 * i);
        seat[i] = 3 + base[i] / 2;
    }
    double rms, vdv;
    assert_ok(c, trk_seat_factor(c, TRK_WEIGHTING_WK, N, seat, base, 400, &rms, &vdv));
    assert_near(rms, 0.5, 1e-9);
    assert_near(vdv, 0.5, 1e-9);
    assert_ok(c, trk_seat_factor(c, TRK_WEIGHTING_WK, N, seat, base, 400, NULL, NULL));
    double zero[3] = {0}, bad[3] = {1, 2, INFINITY};
    assert_status(c, trk_seat_factor(c, 1, 3, seat, zero, 400, &rms, NULL), TRK_E_RANGE);
    assert_message(c, "floor does not vibrate");
    assert_status(c, trk_seat_factor(c, 1, 3, bad, base, 400, &rms, NULL), TRK_E_RANGE);
    assert_status(c, trk_seat_factor(c, 1, 3, seat, bad, 400, &rms, NULL), TRK_E_RANGE);
    assert_message(c, "floor[2] is inf");
    assert_status(c, trk_seat_factor(c, 1, 0, seat, base, 400, &rms, NULL), TRK_E_RANGE);
    assert_status(c, trk_seat_factor(c, 1, 3, seat, base, 100, &rms, NULL), TRK_E_RANGE);
    assert_status(c, trk_seat_factor(c, 99, 3, seat, base, 400, &rms, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_seat_factor(NULL, 1, 3, seat, base, 400, &rms, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_seat_factor(c, 1, 3, NULL, base, 400, &rms, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_seat_factor(c, 1, 3, seat, NULL, 400, &rms, NULL), TRK_E_ARGUMENT);
}

/* White noise: a band has the width of its band; all bands together have everything. */
static void third_octaves(void **state)
{
    trk_context *c = *state;
    enum { N = 4001, BANDS = 31 };
    static double density[N], weighted[N];
    double rms[BANDS], sum = 0, whole, from_bands, from_bins;
    for (int k = 0; k < N; k++)
        density[k] = 4;
    assert_ok(c, trk_third_octave_rms(c, N, density, 0.05, -10, BANDS, rms));
    for (int k = 0; k < BANDS; k++) {
        double centre = trk_third_octave_centre(k - 10);
        assert_near(rms[k], 2 * sqrt(centre * (pow(10, 0.05) - pow(10, -0.05))), 1e-12 * rms[k]);
        sum += rms[k] * rms[k];
    }
    assert_near(trk_third_octave_centre(19), 79.43282347242815, 1e-13);
    double low = pow(10, -1.05), high = pow(10, 2.05);
    assert_ok(c, trk_band_rms(c, N, density, 0.05, low, high, &whole));
    assert_near(sum, whole * whole, 1e-12 * sum);
    assert_ok(c, trk_psd_weight(c, TRK_WEIGHTING_WK, N, density, 0.05, weighted));
    assert_ok(c, trk_band_rms(c, N, weighted, 0.05, low, high, &from_bins));
    assert_ok(c, trk_third_octave_weight(c, TRK_WEIGHTING_WK, -10, BANDS, rms, &from_bands));
    assert_near(from_bands, from_bins, 3e-3 * from_bins);
    assert_near(weighted[200], 4 * pow(trk_weighting_factor(1, 10), 2), 1e-13);
    double tone[1] = {2};
    assert_ok(c, trk_third_octave_weight(c, TRK_WEIGHTING_WD, 3, 1, tone, &whole));
    assert_near(whole, 2 * trk_weighting_factor(TRK_WEIGHTING_WD, pow(10, 0.3)), 1e-15);
}

static void third_octave_errors(void **state)
{
    trk_context *c = *state;
    double d[3] = {1, 1, 1}, bad[3] = {1, -1, 1}, r[200], out;
    assert_status(c, trk_psd_weight(NULL, 1, 3, d, 1, r), TRK_E_ARGUMENT);
    assert_status(c, trk_psd_weight(c, 1, 3, NULL, 1, r), TRK_E_ARGUMENT);
    assert_status(c, trk_psd_weight(c, 1, 3, d, 1, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_psd_weight(c, 0, 3, d, 1, r), TRK_E_ARGUMENT);
    assert_status(c, trk_psd_weight(c, 1, 0, d, 1, r), TRK_E_RANGE);
    assert_status(c, trk_psd_weight(c, 1, 3, bad, 1, r), TRK_E_RANGE);
    assert_status(c, trk_psd_weight(c, 1, 3, d, 0, r), TRK_E_RANGE);
    assert_status(c, trk_third_octave_rms(NULL, 3, d, 1, 0, 1, r), TRK_E_ARGUMENT);
    assert_status(c, trk_third_octave_rms(c, 3, NULL, 1, 0, 1, r), TRK_E_ARGUMENT);
    assert_status(c, trk_third_octave_rms(c, 3, d, 1, 0, 1, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_third_octave_rms(c, 3, d, 1, -61, 1, r), TRK_E_RANGE);
    assert_status(c, trk_third_octave_rms(c, 3, d, 1, 60, 2, r), TRK_E_RANGE);
    assert_message(c, "bands is 2, expected 1 to 1");
    assert_status(c, trk_third_octave_rms(c, 3, d, 1, 0, 0, r), TRK_E_RANGE);
    assert_status(c, trk_third_octave_rms(c, 3, bad, 1, 0, 1, r), TRK_E_RANGE);
    assert_message(c, "trk_third_octave_rms");
    assert_ok(c, trk_third_octave_rms(c, 3, d, 1, -60, 121, r));
    assert_status(c, trk_third_octave_weight(NULL, 1, 0, 1, d, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_third_octave_weight(c, 1, 0, 1, NULL, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_third_octave_weight(c, 1, 0, 1, d, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_third_octave_weight(c, -1, 0, 1, d, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_third_octave_weight(c, 1, 61, 1, d, &out), TRK_E_RANGE);
    assert_status(c, trk_third_octave_weight(c, 1, 0, 2, bad, &out), TRK_E_RANGE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(axes_of_the_standard, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(totals, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(reactions_overlap, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(daily_exposure, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(daily_exposure_errors, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(seat_factor, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(third_octaves, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(third_octave_errors, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
