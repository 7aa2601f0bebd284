/* SPDX-License-Identifier: MIT */
/* What a track is as a signal: the same bits in any order, derivative, contact, ramp, far places. */
#include "profile.h"

enum { COUNT = 1000 };

static trk_signal *new_track(trk_context *context, const trk_road_options *o, bool right)
{
    trk_signal *left, *other;
    assert_ok(context, trk_road_create(context, o, &left, &other));
    trk_signal_destroy(right ? left : other);
    return right ? other : left;
}

/* Contact and ramp or not, both tracks. */
static trk_signal *new_variant(trk_context *context, int variant)
{
    trk_road_options o = road_options();
    o.seed = 5 + variant;
    if (variant & 1) {
        o.contact_length = 0.31;
        o.ramp_start = -3;
        o.ramp_length = 20;
    }
    return new_track(context, &o, variant > 1);
}

static void test_any_block_and_order(void **state)
{
    static const double spacings[] = {0.02, -0.07, 1.3, 40, 0};
    double value[COUNT], rate[COUNT];
    for (int variant = 0; variant < 4; variant++) {
        trk_signal *track = new_variant(*state, variant);
        for (int j = 0; j < 5; j++) {
            trk_signal_evaluate(track, COUNT, 7.7, spacings[j], value, rate);
            for (int k = 0; k < COUNT; k++) {
                const int i = k * 387 % COUNT; /* in another order */
                const double x = 7.7 + i * spacings[j];
                assert_true(value[i] == trk_signal_value(track, x));
                assert_true(rate[i] == trk_signal_rate(track, x));
            }
            for (int k = 0; k < COUNT; k += 37) { /* other blocks; same places if start is exact */
                double v[37], r[37];
                const int n = COUNT - k < 37 ? COUNT - k : 37;
                for (int i = 0; i < n; i++)
                    trk_signal_evaluate(track, 1, 7.7 + (k + i) * spacings[j], 1, &v[i], &r[i]);
                assert_memory_equal(v, value + k, (size_t)n * sizeof *v);
                assert_memory_equal(r, rate + k, (size_t)n * sizeof *r);
            }
        }
        trk_signal_destroy(track);
    }
}

/* Fourth-order difference quotient; the road has continuous fourth derivatives. */
static void test_rate_is_the_derivative(void **state)
{
    const double h = 2e-3;
    for (int variant = 0; variant < 4; variant++) {
        trk_signal *track = new_variant(*state, variant);
        double worst = 0;
        for (double x = -4; x < 60; x += 0.0173) {
            const double near = trk_signal_value(track, x + h) - trk_signal_value(track, x - h);
            const double far =
                trk_signal_value(track, x + 2 * h) - trk_signal_value(track, x - 2 * h);
            const double quotient = (8 * near - far) / (12 * h);
            /* the second derivative of a ramp jumps at its ends */
            const bool corner = variant & 1 && (fabs(x + 3) < 0.01 || fabs(x - 17) < 0.01);
            if (!corner)
                worst = fmax(worst, fabs(quotient - trk_signal_rate(track, x)));
        }
        print_message("variant %d: rate within %.2g of slopes of 4e-3\n", variant, worst);
        assert_true(worst < 2e-9);
        trk_signal_destroy(track);
    }
}

/* Integral of a track from a to b by 4-point Gauss rules. */
static double integral(const trk_signal *track, double a, double b)
{
    static const double at[] = {0.33998104358485626, 0.86113631159405258};
    static const double weight[] = {0.65214515486254614, 0.34785484513745386};
    const int parts = 100 + (int)(80 * (b - a));
    double sum = 0;
    for (int part = 0; part < parts; part++) {
        const double h = (b - a) / parts / 2, centre = a + (2 * part + 1) * h;
        for (int k = 0; k < 2; k++)
            sum += weight[k] * h *
                   (trk_signal_value(track, centre - at[k] * h) +
                    trk_signal_value(track, centre + at[k] * h));
    }
    return sum;
}

/* The contact is the mean over its length, to rounding, short and long; slope = difference. */
static void test_contact_is_the_moving_average(void **state)
{
    static const double lengths[] = {0.0005, 0.05, 0.3, 5, 30};
    trk_road_options o = road_options();
    for (int right = 0; right < 2; right++) {
        o.contact_length = 0;
        trk_signal *point = new_track(*state, &o, right);
        for (int j = 0; j < 5; j++) {
            const double l = o.contact_length = lengths[j];
            trk_signal *contact = new_track(*state, &o, right);
            for (double x = -300; x < 300; x += 61.7) {
                const double mean = integral(point, x - l / 2, x + l / 2) / l;
                assert_near(trk_signal_value(contact, x), mean, 1e-12);
                const double step =
                    trk_signal_value(point, x + l / 2) - trk_signal_value(point, x - l / 2);
                assert_near(trk_signal_rate(contact, x), step / l, 1e-15 / l + 1e-13);
            }
            trk_signal_destroy(contact);
        }
        trk_signal_destroy(point);
    }
}

/* Its effect on the PSD is that on a sine: (sin(pi n l) / (pi n l))^2. */
static void test_density_of_the_contact(void **state)
{
    trk_road_options o = road_options();
    o.waviness = 2.4;
    for (int k = 0; k < 50; k++) {
        const double n = 0.011 + k * 0.05, l = 0.9, turn = pi * n * l;
        double point, contact;
        o.contact_length = 0;
        assert_ok(*state, trk_road_density(*state, &o, 1, &n, &point));
        assert_near(point / (o.unevenness * pow(n / 0.1, -2.4)), 1, 1e-14);
        o.contact_length = l;
        assert_ok(*state, trk_road_density(*state, &o, 1, &n, &contact));
        assert_near(contact / point, pow(sin(turn) / turn, 2), 1e-14);
    }
    const double outside[] = {0, 0.0109, 2.84, 1e300};
    double density[4];
    assert_ok(*state, trk_road_density(*state, &o, 4, outside, density));
    for (int k = 0; k < 4; k++)
        assert_true(density[k] == 0);
}

static void test_ramp(void **state)
{
    trk_road_options o = road_options();
    trk_signal *whole = new_track(*state, &o, false);
    o.ramp_start = 12;
    o.ramp_length = 30;
    trk_signal *ramped = new_track(*state, &o, false);
    for (double x = -20; x < 80; x += 0.73) {
        const double u = fmin(fmax((x - 12) / 30, 0), 1), share = 0.5 * (1 - cos(pi * u));
        const double growth = 0.5 * pi / 30 * sin(pi * u);
        const double height = trk_signal_value(whole, x), rate = trk_signal_rate(whole, x);
        assert_near(trk_signal_value(ramped, x), share * height, 1e-16);
        assert_near(trk_signal_rate(ramped, x), share * rate + growth * height, 1e-16);
        if (x <= 12)
            assert_true(trk_signal_value(ramped, x) == 0 && trk_signal_rate(ramped, x) == 0);
        if (x >= 42)
            assert_true(trk_signal_value(ramped, x) == height);
    }
    trk_signal_destroy(whole);
    trk_signal_destroy(ramped);
}

/* Level where a double no longer resolves a wave; NaN for what is no place. */
static void test_far_places(void **state)
{
    for (int variant = 0; variant < 4; variant++) {
        trk_signal *track = new_variant(*state, variant);
        assert_true(trk_signal_value(track, 1e15) == 0 && trk_signal_rate(track, 1e300) == 0);
        assert_true(trk_signal_value(track, -1e15) == 0);
        assert_true(trk_signal_value(track, 1e12) != 0);
        assert_true(isnan(trk_signal_value(track, NAN)) && isnan(trk_signal_rate(track, NAN)));
        assert_true(isnan(trk_signal_value(track, INFINITY)));
        trk_signal_destroy(track);
    }
}

/* FNV-1a of the bits of heights and slopes: the same on every machine and compiler. */
static uint64_t checksum(const trk_signal *track)
{
    static const double starts[] = {0, -5000.3, 12345678.9};
    double value[COUNT], rate[COUNT];
    uint64_t sum = 0xcbf29ce484222325;
    for (int j = 0; j < 3; j++) {
        trk_signal_evaluate(track, COUNT, starts[j], 0.0625, value, rate);
        for (int k = 0; k < 2 * COUNT; k++) {
            uint64_t bits;
            memcpy(&bits, k < COUNT ? &value[k] : &rate[k - COUNT], sizeof bits);
            for (int byte = 0; byte < 8; byte++)
                sum = (sum ^ (bits >> 8 * byte & 0xff)) * 0x100000001b3;
        }
    }
    return sum;
}

static void test_golden_checksums(void **state)
{
    static const uint64_t golden[4][2] = {{0xfda54c6e5ace7299, 0x43ad5fb52aba3a75},
                                          {0x4c72be1799d7e66b, 0x7a67270fd42a71d8},
                                          {0xe104cf7c7f9bd15b, 0xe104cf7c7f9bd15b},
                                          {0xe3a6048d32430205, 0x69381f929f722233}};
    bool same = true;
    for (int k = 0; k < 4; k++) {
        trk_road_options o = road_options();
        o.seed = INT64_C(0x123456789abcdef) * k - 1;
        o.tracks = k;
        o.waviness = 2 + 0.17 * k;
        o.contact_length = k & 1 ? 0.21 : 0;
        o.ramp_length = k & 2 ? 33 : 0;
        for (int right = 0; right < 2; right++) {
            trk_signal *track = new_track(*state, &o, right);
            const uint64_t sum = checksum(track);
            if (sum != golden[k][right])
                print_message("road %d track %d: 0x%016llx\n", k, right, (unsigned long long)sum);
            same &= sum == golden[k][right];
            trk_signal_destroy(track);
        }
    }
    assert_true(same);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_any_block_and_order),
        cmocka_unit_test(test_rate_is_the_derivative),
        cmocka_unit_test(test_contact_is_the_moving_average),
        cmocka_unit_test(test_density_of_the_contact),
        cmocka_unit_test(test_ramp),
        cmocka_unit_test(test_far_places),
        cmocka_unit_test(test_golden_checksums),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
