/* SPDX-License-Identifier: MIT */
/* Random numbers against published vectors, Latin hypercubes, distributions, factorial order. */
#include "base/random.h"
#include "cases.h"
#include "study/quantile.h"

/* kat_vectors of Random123 1.09, philox4x32 10. */
static void philox_gives_the_published_vectors(void **state)
{
    (void)state;
    static const uint32_t vector[3][10] = {
        {0, 0, 0, 0, 0, 0, 0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8},
        {0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff, 0x408f276d,
         0x41c83b0e, 0xa20bc7c6, 0x6d5451fd},
        {0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344, 0xa4093822, 0x299f31d0, 0xd16cfe09,
         0x94fdcceb, 0x5001e420, 0x24126ea1}};
    for (int k = 0; k < 3; k++) {
        uint32_t out[4];
        trk_philox(vector[k], vector[k] + 4, out);
        assert_memory_equal(out, vector[k] + 6, sizeof out);
    }
}

static void permutations_visit_every_place_once(void **state)
{
    (void)state;
    static unsigned char seen[1000000];
    for (uint64_t n = 1; n <= 200; n++)
        for (uint32_t stream = 0; stream < 3; stream++) {
            memset(seen, 0, n);
            for (uint64_t k = 0; k < n; k++) {
                uint64_t place = trk_random_permute(7, stream, n, k);
                assert_true(place < n);
                assert_int_equal(seen[place]++, 0);
            }
        }
    memset(seen, 0, sizeof seen);
    for (uint64_t k = 0; k < sizeof seen; k++)
        assert_int_equal(seen[trk_random_permute(-3, 1, sizeof seen, k)]++, 0);
}

/* All 24 orders of four places are as frequent: chi square of 23 degrees, 1e-6 at 72. */
static void permutations_are_even(void **state)
{
    (void)state;
    enum { SEEDS = 24000 };
    int count[256] = {0};
    for (int64_t seed = 0; seed < SEEDS; seed++) {
        int code = 0;
        for (uint64_t k = 0; k < 4; k++)
            code = 4 * code + (int)trk_random_permute(seed, 0, 4, k);
        count[code]++;
    }
    double chi = 0;
    int kinds = 0;
    for (int k = 0; k < 256; k++)
        if (count[k]) {
            kinds++;
            chi += (count[k] - SEEDS / 24.0) * (count[k] - SEEDS / 24.0) / (SEEDS / 24.0);
        }
    assert_int_equal(kinds, 24);
    assert_true(chi < 72);
}

static void plain_functions_match_the_library(void **state)
{
    (void)state;
    for (double x = 1e-300; x < 1e300; x *= 1.7)
        assert_near(trk_plain_log(x), log(x), 4e-16 * (1 + fabs(log(x))));
    for (double x = 0.5; x < 2; x += 1e-3)
        assert_near(trk_plain_log(x), log(x), 3e-16);
    for (double x = -700; x < 700; x += 0.37)
        assert_near(trk_plain_exp(x) / exp(x), 1, 6e-16);
    assert_near(trk_plain_power(2, 0.5), sqrt(2), 5e-16);
    assert_true(trk_plain_power(0, -2) == INFINITY && trk_plain_power(0, 2) == 0);
    /* The quantile undoes the distribution function, far into the lower tail. */
    for (double z = -37; z < 5; z += 0.013)
        assert_near(trk_normal_quantile(trk_normal_probability(z)), z,
                    z < 0 ? 4e-15 * fabs(z) + 1e-15 : 2e-16 * exp(z * z / 2) * 3 + 1e-15);
    assert_near(trk_normal_quantile(0.975), 1.959963984540054, 1e-15);
}

/* Distribution function of a parameter as the tests know it. */
static double distribution(const trk_study_parameter_options *o, double x)
{
    bool is_log = o->distribution == TRK_DISTRIBUTION_LOG_UNIFORM ||
                  o->distribution == TRK_DISTRIBUTION_LOG_NORMAL;
    double a = is_log ? log(o->lower) : o->lower, b = is_log ? log(o->upper) : o->upper;
    double t = is_log ? log(x) : x;
    if (o->distribution <= TRK_DISTRIBUTION_LOG_UNIFORM)
        return (t - a) / (b - a);
    double scale = o->deviation * sqrt(2);
    double low = erfc((a - o->mean) / scale), high = erfc((b - o->mean) / scale);
    return (low - erfc((t - o->mean) / scale)) / (low - high);
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Kolmogorov and Smirnov: sqrt(n) D exceeds 2.6 once in 4e5; strata bring D below 1 / n. */
static void points_follow_their_distributions(void **state)
{
    enum { POINTS = 4000 };
    static double x[POINTS];
    for (int d = 0; d < 10; d++) {
        trk_study_options o;
        trk_study_parameter_options p;
        trk_study *study;
        study_fixture f = study_open(*state, TRK_DESIGN_MONTE_CARLO, 1, 1);
        trk_study_options_init(&o, sizeof o);
        trk_study_parameter_options_init(&p, sizeof p);
        o.points = POINTS;
        o.design = d % 2 ? TRK_DESIGN_LATIN_HYPERCUBE : TRK_DESIGN_MONTE_CARLO;
        p.distribution = (d / 2) % 4;
        p.mean = d < 8 ? (p.distribution == TRK_DISTRIBUTION_LOG_NORMAL ? 0 : 1.05) : 0.1;
        if (d >= 8)
            p.distribution = TRK_DISTRIBUTION_NORMAL; /* bounds 7 to 11 deviations away */
        assert_ok(*state, trk_study_create(*state, f.spec, NULL, &o, &study));
        assert_ok(*state, trk_study_add_parameter(study, "x", &p, NULL));
        for (int64_t k = 0; k < POINTS; k++) {
            assert_int_equal(trk_study_get_case(study, k, &x[k], NULL), TRK_OK);
            assert_true(x[k] >= p.lower && x[k] <= p.upper);
        }
        qsort(x, POINTS, sizeof *x, by_size);
        double worst = 0;
        for (int k = 0; k < POINTS; k++) {
            double u = distribution(&p, x[k]);
            worst = fmax(worst, fmax(fabs(u - (double)k / POINTS), fabs(u - (k + 1.0) / POINTS)));
        }
        assert_true(worst < (d % 2 ? 1.0001 / POINTS : 2.6 / sqrt(POINTS)));
        trk_study_destroy(study);
        study_close(&f);
    }
}

static void a_factorial_counts_with_the_last_parameter_first(void **state)
{
    study_fixture f = study_open(*state, TRK_DESIGN_FACTORIAL, 0, 1);
    assert_ok(*state, f.status);
    assert_int_equal(trk_study_cases(f.study), 3 * 2 * 2);
    for (int64_t k = 0; k < 12; k++) {
        double p[2];
        int32_t road;
        assert_int_equal(trk_study_get_case(f.study, k, p, &road), TRK_OK);
        assert_near(p[0], 0.8 + 0.2 * (double)(k / 4), 1e-15);
        assert_true(p[1] == (k / 2 % 2 ? 1.2 : 0.8)); /* the bounds, exactly */
        assert_int_equal(road, k % 2 + 1);
    }
    assert_int_equal(trk_study_get_case(f.study, 12, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_get_case(f.study, -1, NULL, NULL), TRK_E_ARGUMENT);
    study_close(&f);
}

static void more_monte_carlo_points_keep_the_first_ones(void **state)
{
    study_fixture a = study_open(*state, TRK_DESIGN_MONTE_CARLO, 10, 1),
                  b = study_open(*state, TRK_DESIGN_MONTE_CARLO, 20, 1);
    int64_t print_a, print_b;
    for (int64_t k = 0; k < 20; k++) {
        double p[2], q[2];
        assert_int_equal(trk_study_get_case(a.study, k, p, NULL), TRK_OK);
        assert_int_equal(trk_study_get_case(b.study, k, q, NULL), TRK_OK);
        assert_memory_equal(p, q, sizeof p);
    }
    assert_ok(*state, trk_study_get_fingerprint(a.study, &print_a));
    assert_ok(*state, trk_study_get_fingerprint(b.study, &print_b));
    assert_true(print_a == print_b);
    study_close(&a);
    study_close(&b);
}

/* A study like the others but in one thing; its fingerprint. */
static int64_t print_of(trk_context *context, int change)
{
    study_fixture f =
        study_open(context, change == 1 ? TRK_DESIGN_MONTE_CARLO : TRK_DESIGN_LATIN_HYPERCUBE,
                   change == 2 ? 5 : 4, change == 3 ? 1.1 : 1);
    trk_newmark_options n;
    trk_spectrum_options s;
    trk_newmark_options_init(&n, sizeof n);
    trk_spectrum_options_init(&s, sizeof s);
    s.segment_length = 256;
    if (change == 4)
        n.tolerance = 1e-9;
    if (change == 5)
        n.gamma = 0.6;
    if (change == 6)
        s.window = TRK_WINDOW_HAMMING;
    if (change >= 4 && change <= 6) {
        assert_ok(context, trk_study_set_newmark(f.study, &n));
        assert_ok(context, trk_study_set_spectrum(f.study, &s));
    }
    if (change == 7)
        study_add_output(&f, "more", TRK_OUTPUT_RMS, "sprung_z", 0, 0);
    if (change == 8)
        assert_ok(context, trk_study_act_on(f.study, 2, TRK_FIELD_MASS, "unsprung", -1, NULL));
    if (change == 9)
        assert_ok(context, trk_study_act_on(f.study, 2, TRK_FIELD_MASS, "unsprung", 1, NULL));
    if (change == 10) /* the 400th step of one road moves by 1e-9 of its height */
        assert_ok(context, trk_excitation_add_motion(f.bump, TRK_ROAD_ALL, f.step, 1e-9, 0.3));
    if (change == 11)
        assert_ok(context, trk_study_add_excitation(f.study, "again", f.bump, NULL));
    int64_t print;
    assert_ok(context, trk_study_get_fingerprint(f.study, &print));
    study_close(&f);
    return print;
}

/* The same for the spec, whose copy the study hashes. */
static int64_t print_of_spec(trk_context *context, int change)
{
    study_fixture f = study_open(context, TRK_DESIGN_LATIN_HYPERCUBE, 4, 1);
    trk_study *study;
    trk_study_output_options o;
    trk_study_output_options_init(&o, sizeof o);
    o.sensor = trk_model_part_name(f.model, TRK_PART_SENSOR, 1);
    static const struct {
        trk_field field;
        const char *pattern;
    } part[] = {{TRK_FIELD_MASS, "sprung"},
                {TRK_FIELD_MASS, "unsprung"},
                {TRK_FIELD_STIFFNESS, "tire"},
                {TRK_FIELD_STIFFNESS, "spring"},
                {TRK_FIELD_DAMPING, "damper"}};
    if (change)
        assert_ok(context, trk_spec_vary(f.spec, part[change - 1].field, part[change - 1].pattern,
                                         TRK_MEANING_FACTOR, 1 + 1e-15, NULL));
    assert_ok(context, trk_study_create(context, f.spec, NULL, NULL, &study));
    assert_ok(context, trk_study_add_excitation(study, "step", f.bump, NULL));
    assert_ok(context, trk_study_add_output(study, "rms", &o, NULL));
    int64_t print;
    assert_ok(context, trk_study_get_fingerprint(study, &print));
    trk_study_destroy(study);
    study_close(&f);
    return print;
}

static void the_fingerprint_sees_every_change(void **state)
{
    int64_t print[12];
    for (int k = 0; k < 12; k++) {
        print[k] = print_of(*state, k);
        for (int i = 0; i < k; i++)
            assert_true(print[k] != print[i]);
    }
    assert_true(print_of(*state, 0) == print[0]);
    for (int k = 0; k < 6; k++) {
        print[k] = print_of_spec(*state, k);
        for (int i = 0; i < k; i++)
            assert_true(print[k] != print[i]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(philox_gives_the_published_vectors),
        cmocka_unit_test(permutations_visit_every_place_once),
        cmocka_unit_test(permutations_are_even),
        cmocka_unit_test(plain_functions_match_the_library),
        cmocka_unit_test(points_follow_their_distributions),
        cmocka_unit_test(a_factorial_counts_with_the_last_parameter_first),
        cmocka_unit_test(more_monte_carlo_points_keep_the_first_ones),
        cmocka_unit_test(the_fingerprint_sees_every_change),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
