/* SPDX-License-Identifier: MIT */
/* Enveloping: closed forms, brute force, properties, every error path. */
#include "profile.h"

#include <truckride/crg.h>
#include <truckride/excitation.h>
#include <truckride/vehicle.h>

enum { COUNT = 400 };

/* A number in -1 .. 1 from a seed that moves on. */
static double noise(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(int32_t)(*seed >> 32) / 0x1p31;
}

/* Steps, ramps, spikes and dents. */
static void make_profile(uint64_t seed, int64_t count, double scale, double *z)
{
    double level = 0;
    for (int64_t k = 0; k < count; k++) {
        const double choice = noise(&seed);
        level += choice > 0.9 ? 3 * noise(&seed) : 0.2 * noise(&seed);
        z[k] = scale * level + (choice < -0.97 ? scale * 5 * noise(&seed) : 0);
    }
}

static double linear_profile(int64_t count, double spacing, const double *z, double x)
{
    const double s = fmin(fmax(x / spacing, 0), (double)(count - 1));
    const int64_t k = (int64_t)fmin(s, (double)(count - 2));
    return z[k] + (s - (double)k) * (z[k + 1] - z[k]);
}

/* (ROAD.12) over every cell in reach, each by trisection of a concave function. */
static double brute_force(int64_t count, double spacing, const double *z, double radius, int64_t k)
{
    double best = -INFINITY;
    for (int64_t j = -1; j < count; j++) {
        double a = fmax((double)(j - k) * spacing, -radius),
               b = fmin((double)(j + 1 - k) * spacing, radius);
        if (a > b)
            continue;
        for (int i = 0; i < 60; i++) {
            const double u = a + (b - a) / 3, v = b - (b - a) / 3, x = (double)k * spacing;
            const double at_u =
                linear_profile(count, spacing, z, x + u) + sqrt(radius * radius - u * u);
            const double at_v =
                linear_profile(count, spacing, z, x + v) + sqrt(radius * radius - v * v);
            best = fmax(best, fmax(at_u, at_v) - radius);
            if (at_u < at_v)
                a = u;
            else
                b = v;
        }
    }
    return best;
}

static void test_band_against_brute_force(void **state)
{
    static const double radius[] = {0.004, 0.03, 0.5, 1.23, 40};
    double z[COUNT], out[COUNT], worst = 0;
    for (uint64_t seed = 1; seed <= 4; seed++)
        for (int i = 0; i < 5; i++) {
            make_profile(seed, COUNT, 0.003 * (double)seed, z);
            assert_ok(*state,
                      trk_envelope_rigid_band(*state, COUNT, 0.02, z, radius[i], out, NULL));
            for (int64_t k = 0; k < COUNT; k += 7)
                worst = fmax(worst, fabs(out[k] - brute_force(COUNT, 0.02, z, radius[i], k)));
        }
    print_message("largest difference %.2g m\n", worst);
    assert_true(worst < 1e-12);
}

/* A step up and down again: the wheel rises on an arc before it, and leaves on one. */
static void test_band_over_a_cleat(void **state)
{
    enum { UP = 150, DOWN = 170 };
    const double spacing = 0.01, radius = 0.5, high = 0.04;
    double z[COUNT] = {0}, out[COUNT], slope[COUNT];
    for (int k = UP; k <= DOWN; k++)
        z[k] = high;
    assert_ok(*state, trk_envelope_rigid_band(*state, COUNT, spacing, z, radius, out, slope));
    int arcs = 0;
    for (int k = 0; k < COUNT; k++) {
        const double before = (UP - k) * spacing, behind = (k - DOWN) * spacing;
        const double x = fmax(fmax(before, behind), 0), side = before > 0 ? 1 : -1;
        const double arc = x < radius ? high - radius + sqrt(radius * radius - x * x) : -1;
        assert_near(out[k], fmax(arc, 0), 1e-15);
        assert_near(slope[k], arc > 0 ? side * x / sqrt(radius * radius - x * x) : 0, 1e-14);
        arcs += x > 0 && arc > 0;
    }
    assert_int_equal(arcs, 2 * (int)(sqrt(2 * radius * high - high * high) / spacing));
}

/* A trough between two slopes: the wheel stands on both flanks, with its hub over the middle. */
static void test_band_bridges_a_trough(void **state)
{
    enum { MIDDLE = COUNT / 2 };
    const double spacing = 0.01, radius = 0.5, grade = 0.2;
    double z[COUNT], out[COUNT], slope[COUNT];
    for (int k = 0; k < COUNT; k++)
        z[k] = grade * spacing * abs(k - MIDDLE);
    assert_ok(*state, trk_envelope_rigid_band(*state, COUNT, spacing, z, radius, out, slope));
    const double lift = radius * (sqrt(1 + grade * grade) - 1); /* a plane is touched aside */
    for (int k = 60; k < COUNT - 60; k++) {
        assert_near(out[k], z[k] + lift, 1e-15);
        if (k != MIDDLE)
            assert_near(slope[k], k < MIDDLE ? -grade : grade, 1e-14);
    }
}

static void test_band_properties(void **state)
{
    double z[COUNT], out[COUNT], other[COUNT], slope[COUNT], wider[COUNT];
    make_profile(9, COUNT, 0.004, z);
    assert_ok(*state, trk_envelope_rigid_band(*state, COUNT, 0.02, z, 0.5, out, slope));
    assert_ok(*state, trk_envelope_rigid_band(*state, COUNT, 0.02, z, 0.8, wider, NULL));
    for (int k = 0; k < COUNT; k++) {
        assert_true(out[k] >= z[k]); /* no part of the road is in the tire */
        assert_true(wider[k] >= out[k] - 1e-15);
        other[k] = z[k] + 7.25;
    }
    /* curvature upwards has no limit, downwards that of the wheel: the slope falls by at most
     * 1 / (r cos^3), and hub heights lie on the slopes */
    for (int k = 0; k + 1 < COUNT; k++) {
        const double chord = (out[k + 1] - out[k]) / 0.02;
        assert_true(chord >= slope[k] - 0.05 * pow(1 + pow(slope[k], 2), 1.5));
    }
    double lifted[COUNT], again[COUNT];
    assert_ok(*state, trk_envelope_rigid_band(*state, COUNT, 0.02, other, 0.5, lifted, NULL));
    for (int k = 0; k < COUNT; k++) {
        assert_near(lifted[k] - 7.25, out[k], 1e-14);
        other[k] = z[COUNT - 1 - k]; /* driven from the other end */
    }
    assert_ok(*state, trk_envelope_rigid_band(*state, COUNT, 0.02, other, 0.5, again, NULL));
    for (int k = 0; k < COUNT; k++)
        assert_near(again[k], out[COUNT - 1 - k], 1e-15);
}

/* (ROAD.11) by Simpson's rule on each half cell, exact for straight lines. */
static double integral(int64_t count, double spacing, const double *z, double from, double to)
{
    double sum = 0;
    for (double a = from; a < to;) {
        const double b = fmin(to, spacing * (floor(a / spacing + 1e-9) + 1));
        const double middle = linear_profile(count, spacing, z, 0.5 * (a + b));
        sum += (b - a) * middle;
        a = b;
    }
    return sum;
}

static void test_average_is_the_integral(void **state)
{
    static const double length[] = {0.003, 0.02, 0.04, 0.17, 0.2, 3, 8.1, 100};
    const double spacing = 0.02;
    double z[COUNT], out[COUNT], slope[COUNT];
    make_profile(3, COUNT, 0.01, z);
    for (int i = 0; i < 8; i++) {
        assert_ok(*state, trk_envelope_average(*state, COUNT, spacing, z, length[i], out, slope));
        for (int k = 0; k < COUNT; k++) {
            const double a = k * spacing - length[i] / 2, b = k * spacing + length[i] / 2;
            assert_near(out[k], integral(COUNT, spacing, z, a, b) / length[i], 1e-13);
            assert_near(
                slope[k],
                (linear_profile(COUNT, spacing, z, b) - linear_profile(COUNT, spacing, z, a)) /
                    length[i],
                1e-12);
        }
    }
}

/* Far from sea level and after a million samples nothing is lost. */
static void test_average_of_a_long_road(void **state)
{
    enum { LONG = 1000000 };
    double *z = new_profile(LONG), *out = new_profile(LONG), worst = 0;
    for (int64_t k = 0; k < LONG; k++)
        z[k] = 1500 + 1e-3 * (double)(k & 1);
    assert_ok(*state, trk_envelope_average(*state, LONG, 0.01, z, 0.05, out, NULL));
    for (int64_t k = 3; k < LONG - 3;
         k++) /* cells around 1500.0005, one half cell of 1/4 or 3/4 on each side */
        worst = fmax(worst, fabs(out[k] - 1500 - 1e-3 * ((k & 1) ? 0.55 : 0.45)));
    print_message("worst %.2g m\n", worst);
    assert_true(worst < 1e-12);
    free(z);
    free(out);
}

static void test_average_properties(void **state)
{
    double z[COUNT], sine[COUNT], sum[COUNT], a[COUNT], b[COUNT], c[COUNT], slope[COUNT];
    const double n = 0.35, spacing = 0.004, length = 0.3;
    make_profile(5, COUNT, 0.01, z);
    for (int k = 0; k < COUNT; k++) {
        sine[k] = 0.01 * sin(2 * pi * n * spacing * k);
        sum[k] = 2 * z[k] - 3 * sine[k];
    }
    assert_ok(*state, trk_envelope_average(*state, COUNT, spacing, z, length, a, NULL));
    assert_ok(*state, trk_envelope_average(*state, COUNT, spacing, sine, length, b, slope));
    assert_ok(*state, trk_envelope_average(*state, COUNT, spacing, sum, length, c, NULL));
    for (int k = 0; k < COUNT; k++)
        assert_near(c[k], 2 * a[k] - 3 * b[k], 1e-15);
    const double weight = trk_envelope_weight(n, length);
    assert_near(weight, sin(pi * n * length) / (pi * n * length), 1e-15);
    assert_true(trk_envelope_weight(0, 1) == 1 && trk_envelope_weight(1, 0) == 1);
    assert_true(trk_envelope_weight(1.5, 1) < 0);
    for (int k = 40; k < COUNT - 40;
         k++) { /* lines between samples lower a sine by (2 pi n dx)^2 / 12 */
        assert_near(b[k], weight * sine[k], 0.01 * pow(2 * pi * n * spacing, 2) / 10);
        assert_near(slope[k], 0.01 * 2 * pi * n * weight * cos(2 * pi * n * spacing * k), 2e-6);
    }
}

/* Both filters of a profile, driven over by a truck. */
static void test_signal_drives_a_truck(void **state)
{
    enum { SAMPLES = 2001 };
    trk_spec *spec;
    trk_model *model;
    trk_signal *profile, *felt, *plain;
    trk_excitation *drive;
    double z[SAMPLES], hub[SAMPLES], mean[SAMPLES], slope[SAMPLES], height[8], velocity[8];
    static const double x[] = {9.999, 10, 10.2, 10.201}, cleat[] = {0, 0.05, 0.05, 0};
    assert_ok(*state, trk_signal_create_points(*state, 4, x, cleat, &profile));
    assert_ok(*state, trk_envelope_signal(*state, profile, 0, 0.01, SAMPLES, 0.5, 0.2, &felt));
    trk_signal_evaluate(profile, SAMPLES, 0, 0.01, z, NULL);
    assert_ok(*state, trk_envelope_rigid_band(*state, SAMPLES, 0.01, z, 0.5, hub, NULL));
    assert_ok(*state, trk_envelope_average(*state, SAMPLES, 0.01, hub, 0.2, mean, slope));
    for (int k = 0; k < SAMPLES; k++) {
        assert_near(trk_signal_value(felt, 0.01 * k), mean[k], 1e-13);
        if (k + 1 < SAMPLES)
            assert_near(trk_signal_rate(felt, 0.01 * k), slope[k], 1e-10);
    }
    /* one filter alone */
    assert_ok(*state, trk_envelope_signal(*state, profile, 0, 0.01, SAMPLES, 0.5, 0, &plain));
    assert_near(trk_signal_value(plain, 10.1), 0.05, 1e-15);
    assert_true(trk_signal_rate(plain, 9.9) > 0.1);
    trk_signal_destroy(plain);
    assert_ok(*state, trk_envelope_signal(*state, profile, 0, 0.01, SAMPLES, 0, 0.4, &plain));
    assert_near(trk_signal_value(plain, 10.1), 0.05 * 0.21 / 0.4, 1e-14);
    trk_signal_destroy(plain);

    assert_ok(*state, trk_vehicle_create_builtin(*state, TRK_VEHICLE_REFERENCE_TRUCK,
                                                 TRK_VARIANT_LINEAR, &spec));
    assert_ok(*state, trk_model_compile(*state, spec, NULL, &model));
    assert_ok(*state, trk_excitation_create(*state, model, &drive));
    assert_ok(*state, trk_excitation_add_profile(drive, TRK_ROAD_ALL, felt, 1, 10, 0));
    trk_excitation_evaluate(drive, 1, 0.985, 0, height, velocity, NULL);
    double place;
    assert_ok(*state, trk_model_get_road_place(model, 1, &place, NULL));
    assert_near(height[0], trk_signal_value(felt, 9.85 + place), 1e-15);
    assert_near(velocity[0], 10 * trk_signal_rate(felt, 9.85 + place), 1e-12);
    trk_excitation_destroy(drive);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    trk_signal_destroy(felt);
    trk_signal_destroy(profile);
}

static void test_edges(void **state)
{
    const double one[] = {3}, two[] = {1, 2};
    double out[2], slope[2];
    assert_ok(*state, trk_envelope_rigid_band(*state, 1, 0.1, one, 0.5, out, slope));
    assert_true(out[0] == 3 && slope[0] == 0);
    assert_ok(*state, trk_envelope_average(*state, 1, 0.1, one, 0.5, out, slope));
    assert_true(out[0] == 3 && slope[0] == 0);
    assert_ok(*state, trk_envelope_average(*state, 2, 1, two, 6, out, slope));
    assert_near(out[0], (3 * 1 + 1.5 + 2 * 2) / 6, 1e-15); /* ends are held */
    assert_near(slope[0], 1.0 / 6, 1e-15);
    assert_ok(*state, trk_envelope_average(*state, 2, 1e-11, two, 9e11, out, slope));
    assert_near(out[0], 1.5, 1e-12);
    assert_ok(*state, trk_envelope_rigid_band(*state, 2, 1e11, two, 1e-11, out, slope));
    assert_true(out[0] == 1 && out[1] == 2);
    /* a wall higher than the wheel, which stands on its flank */
    double wall[] = {0, 0, 0, 0, 0, 0, 9, 9}, hub[8], path[8];
    assert_ok(*state, trk_envelope_rigid_band(*state, 8, 0.25, wall, 0.5, hub, path));
    assert_near(hub[4], 36 * -0.25 + 0.5 * (sqrt(1 + 36 * 36) - 1), 1e-14);
    assert_true(hub[3] == 0 && path[4] == 36);
    for (int k = 0; k < 8; k++)
        wall[k] = k < 6 ? 9e11 : -9e11;
    assert_ok(*state, trk_envelope_rigid_band(*state, 8, 0.25, wall, 0.5, hub, path));
    for (int k = 0; k < 8; k++)
        assert_true(isfinite(hub[k]) && isfinite(path[k]));
}

static void test_errors(void **state)
{
    double z[] = {0, 1, 2}, out[3];
    static const double bad[] = {0, -1, 1e13, NAN, INFINITY};
    assert_status(*state, trk_envelope_average(*state, 3, 1, z, 1, z, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_envelope_average(*state, 3, 1, z, 1, out, out), TRK_E_ARGUMENT);
    assert_status(*state, trk_envelope_rigid_band(*state, 3, 1, z, 1, z, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_envelope_rigid_band(*state, 3, 1, z, 1, out, z), TRK_E_ARGUMENT);
    for (int k = 0; k < 5; k++) {
        assert_status(*state, trk_envelope_average(*state, 3, bad[k], z, 1, out, NULL),
                      TRK_E_RANGE);
        assert_status(*state, trk_envelope_average(*state, 3, 1, z, bad[k], out, NULL),
                      TRK_E_RANGE);
        assert_message(*state, "length is");
        assert_status(*state, trk_envelope_rigid_band(*state, 3, 1, z, bad[k], out, NULL),
                      TRK_E_RANGE);
        assert_message(*state, "radius is");
        if (k > 1) {
            double high[] = {0, 1, bad[k]};
            assert_status(*state, trk_envelope_average(*state, 3, 1, high, 1, out, NULL),
                          TRK_E_RANGE);
            assert_message(*state, "height[2] is");
            assert_status(*state, trk_envelope_rigid_band(*state, 3, 1, high, 1, out, NULL),
                          TRK_E_RANGE);
        }
    }
    assert_status(*state, trk_envelope_average(*state, 0, 1, z, 1, out, NULL), TRK_E_RANGE);
    assert_status(*state, trk_envelope_rigid_band(*state, -1, 1, z, 1, out, NULL), TRK_E_RANGE);
    assert_status(NULL, trk_envelope_average(NULL, 3, 1, z, 1, out, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_envelope_average(*state, 3, 1, NULL, 1, out, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_envelope_average(*state, 3, 1, z, 1, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(NULL, trk_envelope_rigid_band(NULL, 3, 1, z, 1, out, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_envelope_rigid_band(*state, 3, 1, NULL, 1, out, NULL),
                  TRK_E_ARGUMENT);
    assert_status(*state, trk_envelope_rigid_band(*state, 3, 1, z, 1, NULL, NULL), TRK_E_ARGUMENT);

    trk_signal *profile, *felt = (trk_signal *)z;
    assert_ok(*state, trk_signal_create_step(*state, 0, 1, 0.1, &profile));
    static const struct {
        double start, spacing, radius, length;
        int64_t count;
        const char *message;
    } wrong[] = {{NAN, 1, 1, 1, 3, "start is"},
                 {0, 0, 1, 1, 3, "spacing is"},
                 {0, 1, -1, 1, 3, "radius is"},
                 {0, 1, 1, NAN, 3, "length is"},
                 {0, 1, 0, 0, 3, "radius and length are 0"},
                 {0, 1, 1, 1, 1, "1 samples"},
                 {0, 1, 1e-13, 0, 3, "radius is"}};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        assert_status(*state,
                      trk_envelope_signal(*state, profile, wrong[k].start, wrong[k].spacing,
                                          wrong[k].count, wrong[k].radius, wrong[k].length, &felt),
                      TRK_E_RANGE);
        assert_message(*state, wrong[k].message);
        assert_null(felt);
    }
    assert_status(*state, trk_envelope_signal(*state, NULL, 0, 1, 3, 1, 1, &felt), TRK_E_ARGUMENT);
    assert_status(*state, trk_envelope_signal(*state, profile, 0, 1, 3, 1, 1, NULL),
                  TRK_E_ARGUMENT);
    assert_status(NULL, trk_envelope_signal(NULL, profile, 0, 1, 3, 1, 1, &felt), TRK_E_ARGUMENT);
    trk_signal_destroy(profile);
}

static trk_status envelope(trk_context *context)
{
    trk_signal *profile = NULL, *felt = NULL;
    trk_status status = trk_signal_create_step(context, 0, 1, 0.1, &profile);
    if (status == TRK_OK)
        status = trk_envelope_signal(context, profile, -1, 0.1, 30, 0.5, 0.2, &felt);
    trk_signal_destroy(felt);
    trk_signal_destroy(profile);
    return status;
}

static void test_lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(envelope);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_band_against_brute_force),
        cmocka_unit_test(test_band_over_a_cleat),
        cmocka_unit_test(test_band_bridges_a_trough),
        cmocka_unit_test(test_band_properties),
        cmocka_unit_test(test_average_is_the_integral),
        cmocka_unit_test(test_average_of_a_long_road),
        cmocka_unit_test(test_average_properties),
        cmocka_unit_test(test_signal_drives_a_truck),
        cmocka_unit_test(test_edges),
        cmocka_unit_test(test_errors),
        cmocka_unit_test(test_lack_of_memory),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
