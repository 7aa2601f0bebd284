/* SPDX-License-Identifier: MIT */
/* Power in every third octave over 100 km, distribution, stationarity, no repetition. */
#include "profile.h"

enum { THIRDS = 40 };

static double check_thirds(trk_context *context, const trk_road_options *o, int64_t count,
                           double spacing, int64_t segment)
{
    trk_signal *left, *right;
    double *x = new_profile(count), *y = new_profile(count), worst = 0;
    third t[THIRDS];
    assert_ok(context, trk_road_create(context, o, &left, &right));
    trk_signal_evaluate(left, count, 0, spacing, x, NULL);
    trk_signal_evaluate(right, count, 0, spacing, y, NULL);
    const int thirds = measure_thirds(context, o, count, spacing, segment, x, y, t, THIRDS);
    for (int k = 0; k < thirds; k++)
        worst = fmax(worst, fmax(fabs(t[k].x - 1), fabs(t[k].y - 1)));
    free(x);
    free(y);
    trk_signal_destroy(left);
    trk_signal_destroy(right);
    return worst;
}

/* Both tracks, whole band of ISO 8608, 100 km. */
static void test_thirds_over_100_km(void **state)
{
    trk_road_options o = road_options();
    const double worst = check_thirds(*state, &o, 1000000, 0.1, 250000);
    print_message("third octaves over 100 km: within %.2f %%\n", 100 * worst);
    assert_true(worst < 0.05);
}

/* The low third octaves, of which 100 km hold fewest waves, for many seeds. */
static void test_thirds_for_other_seeds(void **state)
{
    trk_road_options o = road_options();
    o.high /= 8;
    double worst = 0;
    for (o.seed = -5; o.seed < 5; o.seed++)
        worst = fmax(worst, check_thirds(*state, &o, 100000, 1, 50000));
    print_message("10 seeds: within %.2f %%\n", 100 * worst);
    assert_true(worst < 0.05);
}

/* Other waviness, another band that ends within an octave, contact over 0.3 m. */
static void test_thirds_of_other_roads(void **state)
{
    trk_road_options o = road_options();
    o.unevenness = trk_road_class_unevenness(TRK_ROAD_CLASS_D);
    o.low = 0.037;
    o.high = 3.1;
    o.contact_length = 0.2;
    for (o.waviness = 1.5; o.waviness <= 3; o.waviness += 0.5) {
        const double worst = check_thirds(*state, &o, 400000, 0.1, 100000);
        print_message("waviness %.1f: within %.2f %%\n", o.waviness, 100 * worst);
        assert_true(worst < 0.05);
    }
}

static void test_nothing_outside_of_the_band(void **state)
{
    enum { COUNT = 200000, SEGMENT = 20000 };
    trk_road_options o = road_options();
    trk_spectrum_options s;
    trk_signal *road;
    double *x = new_profile(COUNT), *density = new_profile(SEGMENT / 2 + 1), low = 0, high = 0;
    trk_spectrum_options_init(&s, sizeof s);
    s.segment_length = SEGMENT;
    o.low = 0.02;
    assert_ok(*state, trk_road_create(*state, &o, &road, NULL));
    trk_signal_evaluate(road, COUNT, 0, 0.05, x, NULL);
    assert_ok(*state, trk_psd(*state, COUNT, x, 20, &s, density));
    const double dn = 20.0 / SEGMENT;
    for (int k = 0; k <= SEGMENT / 2; k++) {
        const double power_law = 16e-8 / fmax(k * dn * k * dn, dn * dn);
        if (k * dn < 0.9 * o.low)
            low = fmax(low, density[k] * o.low * o.low / 16e-8);
        if (k * dn > 1.1 * o.high)
            high = fmax(high, density[k] / power_law);
    }
    print_message("outside of the band: %.2g of its edge, %.2g of the power law\n", low, high);
    assert_true(low < 0.02 && high < 0.01);
    free(x);
    free(density);
    trk_signal_destroy(road);
}

/* Moments over 400 km of heights and slopes; the variance is that of the band. */
static void test_distribution(void **state)
{
    enum { COUNT = 800000 };
    trk_road_options o = road_options();
    trk_signal *road;
    double *of[2] = {new_profile(COUNT), new_profile(COUNT)};
    assert_ok(*state, trk_road_create(*state, &o, &road, NULL));
    trk_signal_evaluate(road, COUNT, 0, 0.5, of[0], of[1]);
    const double g = 16e-8,
                 variance[2] = {g * (1 / o.low - 1 / o.high), 4 * pi * pi * g * (o.high - o.low)};
    for (int j = 0; j < 2; j++) {
        double m[5] = {0};
        for (int k = 0; k < COUNT; k++)
            for (int power = 1; power <= 4; power++)
                m[power] += pow(of[j][k], power) / COUNT;
        assert_near(m[2] / variance[j], 1, 0.01);
        assert_near(m[1] / sqrt(m[2]), 0, 0.01);
        assert_near(m[3] / pow(m[2], 1.5), 0, 0.05);
        print_message("%s: kurtosis %.3f\n", j ? "slope" : "height", m[4] / (m[2] * m[2]));
        assert_near(m[4] / (m[2] * m[2]), 3, 0.1);
        free(of[j]);
    }
    trk_signal_destroy(road);
}

/* Over many seeds the variance is the same at every place, near and far: 4 standard errors. */
static void test_stationary(void **state)
{
    enum { SEEDS = 1500, PLACES = 8 };
    static const double place[PLACES] = {0, 0.3, 17, 900, 1400, -1e4, 1e6, -3e8};
    double square[PLACES] = {0}, sum[PLACES] = {0};
    trk_road_options o = road_options();
    for (o.seed = 0; o.seed < SEEDS; o.seed++) {
        trk_signal *road;
        assert_ok(*state, trk_road_create(*state, &o, &road, NULL));
        for (int k = 0; k < PLACES; k++) {
            const double height = trk_signal_value(road, place[k]);
            square[k] += height * height / SEEDS;
            sum[k] += height / SEEDS;
        }
        trk_signal_destroy(road);
    }
    const double variance = 16e-8 * (1 / o.low - 1 / o.high);
    for (int k = 0; k < PLACES; k++) {
        assert_near(square[k] / variance, 1, 4 * sqrt(2.0 / SEEDS));
        assert_near(sum[k] / sqrt(variance), 0, 4 * sqrt(1.0 / SEEDS));
    }
}

/* Slopes of 200 m are not found again: on this road up to 1000 km on, by steps of a block of each
 * octave among others, nor on roads of other seeds. */
static void test_does_not_repeat(void **state)
{
    enum { COUNT = 2000, PLACES = 60 };
    static double here[COUNT], there[COUNT], value[COUNT];
    trk_road_options o = road_options();
    trk_signal *road, *other;
    double worst = 0;
    assert_ok(*state, trk_road_create(*state, &o, &road, NULL));
    trk_signal_evaluate(road, COUNT, 0, 0.1, value, here);
    for (int k = 0; k < PLACES; k++) {
        const double block = 64 / o.high;
        const double shift = k < 30 ? block * pow(2, k % 10) * (1 + k / 10) : 1e6 / (PLACES - k);
        o.seed = k < 50 ? 1 : k;
        assert_ok(*state, trk_road_create(*state, &o, &other, NULL));
        trk_signal_evaluate(other, COUNT, k < 50 ? shift : 0, 0.1, value, there);
        double xy = 0, xx = 0, yy = 0;
        for (int i = 0; i < COUNT; i++) {
            xy += here[i] * there[i];
            xx += here[i] * here[i];
            yy += there[i] * there[i];
        }
        worst = fmax(worst, fabs(xy) / sqrt(xx * yy));
        trk_signal_destroy(other);
    }
    print_message("largest correlation %.3f\n", worst);
    assert_true(worst < 4.5 / sqrt(2 * 2.82 * 200)); /* 2 B L independent slopes */
    trk_signal_destroy(road);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_thirds_over_100_km),
        cmocka_unit_test(test_thirds_for_other_seeds),
        cmocka_unit_test(test_thirds_of_other_roads),
        cmocka_unit_test(test_nothing_outside_of_the_band),
        cmocka_unit_test(test_distribution),
        cmocka_unit_test(test_stationary),
        cmocka_unit_test(test_does_not_repeat),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
