/* SPDX-License-Identifier: MIT */
/* Coherence of the tracks: formula against Bessel functions, and as measured on the road. */
#include "profile.h"

static double coherence(trk_context *context, const trk_road_options *o, double n)
{
    double out;
    assert_ok(context, trk_road_coherence(context, o, 1, &n, &out));
    return out;
}

/* 2 (z/2)^m K_m(z) / Gamma(m), m = waviness / 2, by SciPy 1.10 (kv, gamma). */
static void test_isotropic_is_bessel(void **state)
{
    static const struct {
        double waviness, z, value;
    } row[] = {
        {2, 0.1, 0.9853844780870606},   {2, 1, 0.6019072301972346},   {2, 5, 0.02022306722726082},
        {2.3, 0.7, 0.7770331203845606}, {1.5, 2, 0.2087501800356926}, {4, 3, 0.2767970631228392},
        {2, 1e-06, 0.9999999999927843},
    };
    trk_road_options o = road_options();
    o.track_width = 1;
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        o.waviness = row[k].waviness;
        assert_near(coherence(*state, &o, row[k].z / (2 * pi)), row[k].value, 2e-13);
    }
    for (double z = 0.01; z < 30; z *= 1.7) { /* half-integer orders */
        o.waviness = 1;
        assert_near(coherence(*state, &o, z / (2 * pi)), exp(-z), 2e-13);
        o.waviness = 3;
        assert_near(coherence(*state, &o, z / (2 * pi)), (1 + z) * exp(-z), 2e-13);
    }
    assert_near(coherence(*state, &o, 0), 1, 1e-12);
    assert_true(coherence(*state, &o, 1e300) == 0);
}

static void test_other_models(void **state)
{
    trk_road_options o = road_options();
    o.tracks = TRK_ROAD_TRACKS_EXPONENTIAL;
    o.coherence_decay = 0.7;
    o.track_width = 1.8;
    assert_near(coherence(*state, &o, 0.3), exp(-2 * pi * 0.7 * 0.3 * 1.8), 1e-15);
    o.tracks = TRK_ROAD_TRACKS_EQUAL;
    assert_true(coherence(*state, &o, 0.3) == 1);
    o.tracks = TRK_ROAD_TRACKS_INDEPENDENT;
    assert_true(coherence(*state, &o, 0.3) == 0);
}

/* Largest difference of the measured complex coherence from the model, and of the PSDs from 1. */
static void measure(trk_context *context, const trk_road_options *o, int64_t count, double spacing,
                    int64_t segment, double *out_coherence)
{
    third t[40];
    trk_signal *left, *right;
    double *x = new_profile(count), *y = new_profile(count);
    assert_ok(context, trk_road_create(context, o, &left, &right));
    trk_signal_evaluate(left, count, -1000, spacing, x, NULL);
    trk_signal_evaluate(right, count, -1000, spacing, y, NULL);
    const int thirds = measure_thirds(context, o, count, spacing, segment, x, y, t, 40);
    for (int k = 0; k < thirds; k++) {
        const double size = sqrt(t[k].x * t[k].y), model = coherence(context, o, t[k].centre);
        *out_coherence = fmax(*out_coherence, hypot(t[k].re / size - model, t[k].im / size));
    }
    free(x);
    free(y);
    trk_signal_destroy(left);
    trk_signal_destroy(right);
}

/* The whole band over 100 km for the isotropic model, and for each model 1000 km for what is
 * below 0.354 and 60 km for what is above 0.088 cycles/m. */
static void test_coherence_of_the_road(void **state)
{
    trk_road_options o = road_options();
    double worst = 0;
    measure(*state, &o, 500000, 0.17, 50000, &worst);
    print_message("isotropic, 85 km: within %.3f\n", worst);
    assert_true(worst < 0.05);
    for (o.tracks = 0; o.tracks < 4; o.tracks++) {
        double low = 0, high = 0;
        trk_road_options part = o;
        part.high = o.high / 8;
        measure(*state, &part, 700000, 1.4, 20000, &low);
        part = o;
        part.low = o.high / 32;
        measure(*state, &part, 350000, 0.17, 20000, &high);
        print_message("model %d: within %.3f and %.3f\n", o.tracks, low, high);
        assert_true(low < 0.05 && high < 0.05);
    }
}

static void test_equal_tracks_are_equal(void **state)
{
    enum { COUNT = 500 };
    double x[COUNT], y[COUNT], dx[COUNT], dy[COUNT];
    trk_signal *left, *right;
    trk_road_options o = road_options();
    o.tracks = TRK_ROAD_TRACKS_EQUAL;
    assert_ok(*state, trk_road_create(*state, &o, &left, &right));
    trk_signal_evaluate(left, COUNT, -3, 0.37, x, dx);
    trk_signal_evaluate(right, COUNT, -3, 0.37, y, dy);
    assert_memory_equal(x, y, sizeof x);
    assert_memory_equal(dx, dy, sizeof x);
    trk_signal_destroy(left);
    trk_signal_destroy(right);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_isotropic_is_bessel),
        cmocka_unit_test(test_other_models),
        cmocka_unit_test(test_coherence_of_the_road),
        cmocka_unit_test(test_equal_tracks_are_equal),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
