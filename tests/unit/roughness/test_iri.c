/* SPDX-License-Identifier: MIT */
/* The standard car's matrices, IRI of sines, steps of a measured profile, MRI, HRI, ISO roads. */
#include "roughness/golden.h"
#include "support.h"

#include <truckride/roughness.h>

static const double pi = 3.14159265358979323846;

/* World Bank Technical Paper 46 (1986), table for dx = 0.25 m, to the digits printed. */
static void matrices_of_the_world_bank(void **state)
{
    (void)state;
    static const double st[4][4] = {{0.99660707, 0.010915144, -0.0020832747, 0.00031901453},
                                    {-0.55630449, 0.94387679, -0.83247210, 0.050647009},
                                    {0.021531759, 0.0021267635, 0.75087136, 0.0082218887},
                                    {3.3350129, 0.33764672, -39.127635, 0.43475640}};
    static const double pr[4] = {0.0054762056, 1.3887766, 0.22759688, 35.792622};
    trk_golden_step step;
    trk_golden_create(0.25, &step);
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++)
            assert_near(step.transition[i][j], st[i][j], 6e-9 * fmax(fabs(st[i][j]), 1));
        assert_near(step.input[i], pr[i], 6e-9 * fmax(pr[i], 1));
    }
}

/* Two half steps are one step; at a constant slope the car settles on it. */
static void steps_compose(void **state)
{
    (void)state;
    trk_golden_step one, half;
    for (double dx = 0.3; dx > 1e-4; dx /= 3) {
        trk_golden_create(dx, &one);
        trk_golden_create(dx / 2, &half);
        for (int i = 0; i < 4; i++) {
            double input = half.input[i];
            for (int k = 0; k < 4; k++)
                input += half.transition[i][k] * half.input[k];
            assert_near(one.input[i], input, 1e-13 * fmax(1, fabs(input)));
            for (int j = 0; j < 4; j++) {
                double sum = 0;
                for (int k = 0; k < 4; k++)
                    sum += half.transition[i][k] * half.transition[k][j];
                assert_near(one.transition[i][j], sum, 1e-12);
            }
            assert_near(one.transition[i][0] + one.transition[i][2] + one.input[i], i % 2 ? 0 : 1,
                        1e-12);
        }
    }
}

enum { LONG = 400000 };
static double profile[LONG];

/* Steady sine of 1 mm: 2/pi of the amplitude that gain and 250 mm average leave of its slope. */
static void sines(void **state)
{
    trk_context *c = *state;
    const struct {
        double wavelength, m_per_km;
    } row[] = {{15, 0.4071}, {10, 0.5034}, {5, 0.9319}, {2.4, 2.724}};
    const double dx = 0.05;
    for (int k = 0; k < 4; k++) {
        double n = 1 / row[k].wavelength, iri;
        for (int i = 0; i < LONG; i++)
            profile[i] = 1e-3 * sin(2 * pi * n * dx * i);
        assert_ok(c, trk_iri(c, LONG, profile, dx, NULL, &iri));
        assert_near(iri * 1000, row[k].m_per_km, 1e-3 * row[k].m_per_km);
        double average = sin(pi * n * 0.25) / (pi * n * 0.25);
        average *= sin(pi * n * dx) / (pi * n * dx); /* slope held over a sample */
        double theory = 2 / pi * 1e-3 * 2 * pi * n * average * trk_iri_gain(n);
        assert_near(iri, theory, 4e-4 * theory);
        /* 400 m from a start at the mean slope */
        const double short_run[] = {0.4017, 0.5024, 0.9309, 2.714};
        assert_ok(c, trk_iri(c, 8001, profile, dx, NULL, &iri));
        assert_near(iri * 1000, short_run[k], 5e-4);
    }
}

static void gain_peaks(void **state)
{
    (void)state;
    assert_near(trk_iri_gain(0.0634), 1.5376, 1e-4);
    assert_near(trk_iri_gain(0.4363), 1.6765, 1e-4);
    assert_true(trk_iri_gain(0.0634) > trk_iri_gain(0.062));
    assert_true(trk_iri_gain(0.0634) > trk_iri_gain(0.065));
    assert_true(trk_iri_gain(0) == 0);
    assert_true(trk_iri_gain(1e300) >= 0 && trk_iri_gain(1e300) < 1e-300);
    assert_near(trk_iri_gain(1.0001e7) / trk_iri_gain(0.9999e7), 1, 1e-3);
    assert_true(isnan(trk_iri_gain(-1)) && isnan(trk_iri_gain(NAN)));
    assert_true(isnan(trk_iri_gain(INFINITY)));
}

static void roads_of_iso_8608(void **state)
{
    trk_context *c = *state;
    double iri, part[2];
    for (int k = 0; k < 8; k++) {
        assert_ok(c, trk_iri_of_road(c, 16e-6 * pow(4, k), 2, 0, INFINITY, &iri));
        assert_near(iri * 1000 / (2.22 * pow(2, k)), 1, 1e-3);
    }
    /* White slope: variance from the Lyapunov equation of the car, closed form. */
    const double k1 = 653, k2 = 63.3, d = 6, mu = 0.15, v = 80 / 3.6, slope = 4 * pi * pi * 16e-8;
    /* x = |k1 s^2 / (mu s^4 + d(1+mu) s^3 + (k1 + k2(1+mu)) s^2 + d k1 s + k1 k2)|, the integral
     * I4 of James, Nichols and Phillips with numerator k1 s^2 */
    const double a4 = mu, a3 = d * (1 + mu), a2 = k1 + k2 * (1 + mu), a1 = d * k1, a0 = k1 * k2;
    double integral =
        k1 * k1 * a0 * a1 * a4 / (2 * a0 * a4 * (a1 * a2 * a3 - a0 * a3 * a3 - a1 * a1 * a4));
    double sigma = sqrt(slope / 2 * integral / v); /* two-sided, per cycle/m at speed v */
    assert_ok(c, trk_iri_of_road(c, 16e-6, 2, 0, INFINITY, &iri));
    assert_near(iri, sqrt(2 / pi) * sigma, 1e-6 * iri);
    assert_ok(c, trk_iri_of_road(c, 16e-6, 2.3, 0.01, 0.3, &part[0]));
    assert_ok(c, trk_iri_of_road(c, 16e-6, 2.3, 0.3, 10, &part[1]));
    assert_ok(c, trk_iri_of_road(c, 16e-6, 2.3, 0.01, 10, &iri));
    assert_near(iri, hypot(part[0], part[1]), 1e-9 * iri);
    assert_ok(c, trk_iri_of_road(c, 16e-6, 2, 1e-9, 1e-8, &iri));
    assert_true(iri == 0);
    assert_status(c, trk_iri_of_road(NULL, 1, 2, 0, 1, &iri), TRK_E_ARGUMENT);
    assert_status(c, trk_iri_of_road(c, 1, 2, 0, 1, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_iri_of_road(c, -1, 2, 0, 1, &iri), TRK_E_RANGE);
    assert_status(c, trk_iri_of_road(c, 1, 0.9, 0, 1, &iri), TRK_E_RANGE);
    assert_status(c, trk_iri_of_road(c, 1, NAN, 0, 1, &iri), TRK_E_RANGE);
    assert_status(c, trk_iri_of_road(c, 1, 2, 1, 1, &iri), TRK_E_RANGE);
    assert_status(c, trk_iri_of_road(c, 1, 2, -1, 1, &iri), TRK_E_RANGE);
}

/* A plane has no roughness once the car rides on its slope; offset and slope do not matter. */
static void planes(void **state)
{
    trk_context *c = *state;
    double iri, other;
    trk_iri_options o;
    trk_iri_options_init(&o, sizeof o);
    for (int i = 0; i < 20000; i++)
        profile[i] = 500 + 0.03 * 0.1 * i;
    assert_ok(c, trk_iri(c, 20000, profile, 0.1, NULL, &iri));
    assert_near(iri, 0, 5e-6); /* the start divides by one spacing too much, as published */
    for (int i = 0; i < 2000; i++)
        profile[i] = 0.01 * sin(0.3 * i);
    assert_ok(c, trk_iri(c, 2000, profile, 0.1, NULL, &iri));
    for (int i = 0; i < 2000; i++)
        profile[i] *= -3;
    assert_ok(c, trk_iri(c, 2000, profile, 0.1, NULL, &other));
    assert_near(other, 3 * iri, 1e-13);
    o.smoothed = 1; /* nothing averaged: more is left of a short wave */
    for (int i = 0; i < 2000; i++)
        profile[i] = 0.001 * sin(2 * pi * 0.1 * i);
    assert_ok(c, trk_iri(c, 2000, profile, 0.1, NULL, &iri));
    assert_ok(c, trk_iri(c, 2000, profile, 0.1, &o, &other));
    assert_true(other > 1.05 * iri);
}

static void segments_average_to_the_whole(void **state)
{
    trk_context *c = *state;
    double iri, part[10], sum = 0;
    for (int i = 0; i < 2001; i++)
        profile[i] = 0.01 * sin(0.3 * i) + 0.002 * cos(0.01 * i * i);
    assert_int_equal(trk_iri_segment_count(2001, 0.25, NULL, 50), 10);
    assert_ok(c, trk_iri(c, 2001, profile, 0.25, NULL, &iri));
    assert_ok(c, trk_iri_segments(c, 2001, profile, 0.25, NULL, 50, 10, part));
    for (int k = 0; k < 10; k++)
        sum += part[k] / 10;
    assert_near(sum, iri, 1e-14);
    part[4] = 77;
    assert_ok(c, trk_iri_segments(c, 2001, profile, 0.25, NULL, 50, 4, part));
    assert_true(part[4] == 77);
    assert_int_equal(trk_iri_segment_count(2000, 0.25, NULL, 50), 9);
    assert_int_equal(trk_iri_segment_count(2001, 0.25, NULL, 0.1), 0);
    assert_int_equal(trk_iri_segment_count(2001, 0.25, NULL, NAN), 0);
    assert_int_equal(trk_iri_segment_count(2001, 0.5, NULL, 50), 0);
}

static void both_tracks(void **state)
{
    trk_context *c = *state;
    static double left[2000], right[2000];
    for (int i = 0; i < 2000; i++) {
        left[i] = 0.01 * sin(0.3 * i);
        right[i] = -left[i];
    }
    double iri, mri, hri;
    assert_ok(c, trk_iri(c, 2000, left, 0.1, NULL, &iri));
    assert_ok(c, trk_mri(c, 2000, left, right, 0.1, NULL, &mri));
    assert_ok(c, trk_hri(c, 2000, left, right, 0.1, NULL, &hri));
    assert_near(mri, iri, 1e-17);
    assert_near(hri, 0, 0); /* pure roll */
    assert_ok(c, trk_hri(c, 2000, left, left, 0.1, NULL, &hri));
    assert_near(hri, iri, 0);
}

/* Profile 1 of Sroubek, Sorel and Zak (2021): what their program gives with the method of Sayers,
 * one segment over everything. It starts the car on 0.5 s, interpolated; 3e-5 lies in that. */
static void measured_profile(void **state)
{
    trk_context *c = *state;
    /* Beside the project, which this source names: tests run in the build directory. */
    static const char source[] = __FILE__, below[] = "tests/unit/roughness/test_iri.c";
    char path[4096];
    snprintf(path, sizeof path, "%.*s../shared/data/iri_profile_1.txt",
             (int)(sizeof source - sizeof below), source);
    FILE *file = fopen(path, "r");
    if (!file) {
        print_message("skipped: iri_profile_1.txt is not there\n");
        skip();
    }
    int count = 0;
    double x;
    while (count < LONG && fscanf(file, "%lf %lf", &x, &profile[count]) == 2)
        count++;
    fclose(file);
    assert_int_equal(count, 2177);
    double iri;
    assert_ok(c, trk_iri(c, count, profile, 0.25, NULL, &iri));
    assert_near(iri * 1000, 3.3354610112466467, 1e-4 * 3.335);
    assert_near(iri * 1000, 3.3353526708494377, 1e-11); /* SciPy's expm and the same start */
}

static void wrong_arguments(void **state)
{
    trk_context *c = *state;
    double x[10] = {0}, bad[10] = {0, 1, NAN}, out;
    trk_iri_options o;
    assert_status(c, trk_iri(NULL, 10, x, 0.1, NULL, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_iri(c, 10, NULL, 0.1, NULL, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_iri(c, 10, x, 0.1, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_iri(c, 10, bad, 0.1, NULL, &out), TRK_E_RANGE);
    assert_message(c, "height[2] is nan m");
    assert_status(c, trk_iri(c, 2, x, 0.1, NULL, &out), TRK_E_RANGE);
    assert_message(c, "count is 2 heights, expected more than 3");
    assert_status(c, trk_iri(c, 1, x, 0.3, NULL, &out), TRK_E_RANGE);
    const double spacing[] = {0, -0.1, 0.31, NAN};
    for (int k = 0; k < 4; k++)
        assert_status(c, trk_iri(c, 10, x, spacing[k], NULL, &out), TRK_E_RANGE);
    assert_message(c, "at most 0.3 m");
    for (int k = 0; k < 4; k++) {
        trk_iri_options_init(&o, sizeof o);
        o.start_length = k == 0 ? 0 : 11;
        o.smoothed = k == 1 ? 2 : 0;
        o.reserved = k == 2;
        if (k == 3)
            o.struct_size = 2;
        assert_status(c, trk_iri(c, 10, x, 0.1, &o, &out), k == 3 ? TRK_E_OPTIONS : TRK_E_RANGE);
    }
    assert_status(c, trk_iri_segments(NULL, 10, x, 0.1, NULL, 1, 1, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_iri_segments(c, 10, NULL, 0.1, NULL, 1, 1, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_iri_segments(c, 10, x, 0.1, NULL, 1, 1, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_iri_segments(c, 10, x, 0.1, NULL, 0.01, 1, &out), TRK_E_RANGE);
    assert_message(c, "segment_length is 0.01 m");
    assert_status(c, trk_iri_segments(c, 10, x, 0.1, NULL, 1, -1, &out), TRK_E_RANGE);
    assert_status(c, trk_iri_segments(c, 10, bad, 0.1, NULL, 1, 1, &out), TRK_E_RANGE);
    assert_status(c, trk_iri_segments(c, 10, x, 1, NULL, 1, 1, &out), TRK_E_RANGE);
    assert_status(c, trk_mri(NULL, 10, x, x, 0.1, NULL, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_mri(c, 10, NULL, x, 0.1, NULL, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_mri(c, 10, x, NULL, 0.1, NULL, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_mri(c, 10, x, x, 0.1, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_mri(c, 10, bad, x, 0.1, NULL, &out), TRK_E_RANGE);
    assert_message(c, "trk_mri: left track");
    assert_status(c, trk_mri(c, 10, x, bad, 0.1, NULL, &out), TRK_E_RANGE);
    assert_message(c, "trk_mri: right track");
    assert_status(c, trk_hri(NULL, 10, x, x, 0.1, NULL, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_hri(c, 10, NULL, x, 0.1, NULL, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_hri(c, 10, x, NULL, 0.1, NULL, &out), TRK_E_ARGUMENT);
    assert_status(c, trk_hri(c, 10, x, x, 0.1, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_hri(c, 10, bad, x, 0.1, NULL, &out), TRK_E_RANGE);
    assert_status(c, trk_hri(c, 10, x, bad, 0.1, NULL, &out), TRK_E_RANGE);
    assert_message(c, "right[2] is nan");
    assert_status(c, trk_hri(c, 10, x, x, 0.4, NULL, &out), TRK_E_RANGE);
}

static void extreme_heights_stay_finite(void **state)
{
    trk_context *c = *state;
    double iri;
    for (int i = 0; i < 1000; i++)
        profile[i] = i % 7 < 3 ? 1e75 : -1e75;
    assert_ok(c, trk_iri(c, 1000, profile, 1e-3, NULL, &iri));
    assert_true(isfinite(iri));
}

static trk_status use_memory(trk_context *c)
{
    double x[10] = {0}, out;
    return trk_hri(c, 10, x, x, 0.1, NULL, &out);
}

static void memory_runs_out(void **state)
{
    (void)state;
    support_exhaust_memory(use_memory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(matrices_of_the_world_bank, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(steps_compose, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(sines, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(gain_peaks, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(roads_of_iso_8608, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(planes, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(segments_average_to_the_whole, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(both_tracks, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(measured_profile, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(wrong_arguments, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(extreme_heights_stay_finite, support_setup,
                                        support_teardown),
        cmocka_unit_test(memory_runs_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
