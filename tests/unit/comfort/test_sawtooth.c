/* SPDX-License-Identifier: MIT */
/*
 * Signal-burst test of ISO 8041-1:2017, 5.9: indications of tables 8 and 9 in answer to the
 * saw-tooth bursts of table 6. The numbers are facts of the standard as transcribed in a public
 * implementation (phonometry, vibration.human, 2026); they are printed with three digits and
 * the standard allows 10 % (VDV 12 %). Here: 2.5 %. That source reports 2.3 % for the exact
 * response too, in the same cells (Wf with 2 cycles, We with 8): the print is not closer.
 */
#include "support.h"

#include <truckride/comfort.h>

enum { ROWS = 6 };
static const double tolerance = 0.025;
static const int cycles[ROWS] = {1, 2, 4, 8, 16, 0}; /* 0: without a break, from t = 0 */

/* Amplitude 1, from zero up, falling at half the cycle; bursts start at `start` every `repeat`. */
static double sawtooth(double t, double angular, double start, double repeat, int count)
{
    double turns = angular * t / (2 * acos(-1));
    if (count > 0) {
        if (t < start)
            return 0;
        turns = angular * fmod(t - start, repeat) / (2 * acos(-1));
        if (turns >= count)
            return 0;
    }
    return 2 * (turns + 0.5 - floor(turns + 0.5)) - 1;
}

static trk_vibration indicate(trk_context *c, trk_weighting w, double rate, double angular,
                              double start, double repeat, double duration, int count)
{
    enum { BLOCK = 1000 };
    double x[BLOCK];
    trk_weighting_filter *filter;
    trk_vibration_meter *meter;
    assert_ok(c, trk_weighting_filter_create(c, w, rate, &filter));
    assert_ok(c, trk_vibration_meter_create(c, rate, 1, &meter));
    for (int64_t i = 0; i < (int64_t)(duration * rate); i += BLOCK) {
        for (int k = 0; k < BLOCK; k++)
            x[k] = sawtooth((double)(i + k) / rate, angular, start, repeat, count);
        assert_ok(c, trk_weighting_filter_process(filter, BLOCK, x, x));
        assert_ok(c, trk_vibration_meter_process(meter, BLOCK, x));
    }
    trk_vibration v = {.struct_size = sizeof v};
    assert_ok(c, trk_vibration_meter_read(meter, &v));
    trk_vibration_meter_destroy(meter);
    trk_weighting_filter_destroy(filter);
    return v;
}

/* Table 8: RMS, VDV, MTVV linear, MTVV exponential. */
static const struct {
    trk_weighting weighting;
    double printed[ROWS][4];
} whole_body[] = {
    {TRK_WEIGHTING_BAND,
     {{0.0433, 0.498, 0.137, 0.135},
      {0.0612, 0.593, 0.193, 0.188},
      {0.0865, 0.705, 0.274, 0.258},
      {0.122, 0.838, 0.387, 0.344},
      {0.173, 0.996, 0.547, 0.437},
      {0.546, 1.77, 0.547, 0.549}}},
    {TRK_WEIGHTING_WB,
     {{0.0314, 0.342, 0.0991, 0.0968},
      {0.0435, 0.403, 0.137, 0.132},
      {0.0614, 0.482, 0.194, 0.182},
      {0.0867, 0.575, 0.274, 0.243},
      {0.123, 0.685, 0.387, 0.309},
      {0.387, 1.22, 0.388, 0.388}}},
    {TRK_WEIGHTING_WC,
     {{0.0222, 0.244, 0.0703, 0.0684},
      {0.0292, 0.275, 0.0923, 0.0885},
      {0.0397, 0.318, 0.126, 0.117},
      {0.055, 0.374, 0.174, 0.153},
      {0.077, 0.445, 0.243, 0.192},
      {0.24, 0.788, 0.243, 0.242}}},
    {TRK_WEIGHTING_WD,
     {{0.00669, 0.0779, 0.0212, 0.0197},
      {0.00906, 0.0852, 0.0286, 0.0264},
      {0.0116, 0.0923, 0.0366, 0.033},
      {0.0148, 0.101, 0.0469, 0.04},
      {0.0197, 0.115, 0.0611, 0.0481},
      {0.059, 0.197, 0.0611, 0.0594}}},
    {TRK_WEIGHTING_WE,
     {{0.00342, 0.0409, 0.0108, 0.00992},
      {0.00478, 0.0452, 0.0151, 0.0135},
      {0.00637, 0.0493, 0.0201, 0.0176},
      {0.00816, 0.0535, 0.0255, 0.0214},
      {0.0102, 0.0592, 0.0311, 0.0244},
      {0.0295, 0.0987, 0.0311, 0.0297}}},
    {TRK_WEIGHTING_WJ,
     {{0.0435, 0.517, 0.138, 0.135},
      {0.0616, 0.609, 0.195, 0.189},
      {0.0874, 0.723, 0.277, 0.261},
      {0.124, 0.859, 0.392, 0.349},
      {0.175, 1.02, 0.554, 0.443},
      {0.554, 1.81, 0.555, 0.557}}},
    {TRK_WEIGHTING_WK,
     {{0.0299, 0.323, 0.0944, 0.0922},
      {0.0411, 0.38, 0.13, 0.125},
      {0.0577, 0.455, 0.182, 0.171},
      {0.0814, 0.543, 0.257, 0.228},
      {0.115, 0.648, 0.363, 0.289},
      {0.362, 1.15, 0.364, 0.363}}},
};

static void whole_body_bursts(void **state)
{
    trk_context *c = *state;
    for (size_t w = 0; w < sizeof whole_body / sizeof *whole_body; w++)
        for (int r = 0; r < ROWS; r++) {
            const double *printed = whole_body[w].printed[r];
            trk_vibration v = indicate(c, whole_body[w].weighting, 4000, 100, 1, 10, 60, cycles[r]);
            assert_near(v.rms / printed[0], 1, tolerance);
            assert_near(v.vdv / printed[1], 1, tolerance);
            assert_near(v.mtvv / printed[2], 1, tolerance);
            assert_near(v.mtvv_exponential / printed[3], 1, tolerance);
        }
}

/* Table 9: RMS, MSDV. */
static void low_frequency_bursts(void **state)
{
    trk_context *c = *state;
    static const double band[ROWS][2] = {{0.0341, 1.671}, {0.0487, 2.386}, {0.069, 3.38},
                                         {0.0982, 4.811}, {0.139, 6.81},   {0.439, 21.51}};
    static const double wf[ROWS][2] = {{0.0197, 0.9651}, {0.0236, 1.156}, {0.0304, 1.489},
                                       {0.0416, 2.038},  {0.0571, 2.797}, {0.176, 8.622}};
    for (int r = 0; r < ROWS; r++) {
        trk_vibration v = indicate(c, TRK_WEIGHTING_BAND_LOW, 200, 2.5, 40, 400, 2400, cycles[r]);
        assert_near(v.rms / band[r][0], 1, tolerance);
        assert_near(v.msdv / band[r][1], 1, tolerance);
        v = indicate(c, TRK_WEIGHTING_WF, 200, 2.5, 40, 400, 2400, cycles[r]);
        assert_near(v.rms / wf[r][0], 1, tolerance);
        assert_near(v.msdv / wf[r][1], 1, tolerance);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(whole_body_bursts, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(low_frequency_bursts, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
