/* SPDX-License-Identifier: MIT */
/* The 95 % intervals cover the truth in 95 of 100 noisy fits. Needs NLOPT, Needs LAPACK */
#include "fit.h"

enum { TRIALS = 500, REPEATS = 2 };

typedef struct setup {
    const char *name;
    trk_vehicle vehicle;
    const char *parameter[3], *target[5];
    double uncertainty, weight[2]; /* [-] of the value; of first and second reading */
} setup;

/* Every target twice, so that there are more targets than parameters. */
static trk_calibration *build(trk_context *context, const setup *s, const double *value,
                              double noise, int64_t *seed)
{
    trk_calibration *c = fit_create(context, s->vehicle);
    for (int j = 0; s->parameter[j]; j++)
        fit_stiffness(context, c, s->parameter[j]);
    for (int i = 0; s->target[i]; i++)
        for (int k = 0; k < REPEATS; k++) {
            trk_target_options o;
            trk_target_options_init(&o, sizeof o);
            char name[64];
            snprintf(name, sizeof name, "%s %d", s->target[i], k + 1);
            o.coordinate = s->target[i];
            double size = s->uncertainty * value[REPEATS * i + k];
            o.uncertainty = size * (k + 1); /* the second reading is the worse one */
            o.value = value[REPEATS * i + k] + noise * o.uncertainty * fit_normal(seed);
            o.weight = s->weight[k];
            assert_ok(context, trk_calibration_add_target(c, name, &o, NULL));
        }
    return c;
}

static void coverage(trk_context *context, const setup *s)
{
    static const double truth[] = {1.3, 0.8, 1.2};
    double value[16];
    int64_t seed = 4711;
    int covered[3] = {0}, parameters = 0, solved = 0;
    while (s->parameter[parameters])
        parameters++;
    for (int k = 0; k < 16; k++)
        value[k] = 1;
    trk_calibration *c = build(context, s, value, 0, &seed);
    assert_ok(context, trk_calibration_evaluate(c, truth, value, NULL));
    trk_calibration_destroy(c);
    for (int trial = 0; trial < TRIALS; trial++) {
        c = build(context, s, value, 1, &seed);
        trk_solve_options o;
        trk_solve_options_init(&o, sizeof o);
        o.met = 6; /* noise of several standard uncertainties is no miss here */
        solved += trk_calibration_solve(c, &o, NULL, NULL) == TRK_OK;
        for (int j = 0; j < parameters; j++) {
            trk_parameter_result r = {.struct_size = sizeof r};
            assert_ok(context, trk_calibration_get_parameter(c, j + 1, &r));
            covered[j] += r.low95 <= truth[j] && truth[j] <= r.high95;
        }
        trk_calibration_destroy(c);
    }
    for (int j = 0; j < parameters; j++) {
        printf("%s, %s: %.1f %% of %d covered\n", s->name, s->parameter[j],
               100.0 * covered[j] / TRIALS, TRIALS);
        assert_true(covered[j] >= 0.90 * TRIALS && covered[j] <= 0.99 * TRIALS);
    }
    printf("%s: %d solved\n", s->name, solved);
    assert_true(solved >= 0.98 * TRIALS); /* noise may lie in the gap of two hops */
}

static void intervals_cover(void **state)
{
    static const setup setups[] = {{"quarter car",
                                    TRK_VEHICLE_REFERENCE_FRONT,
                                    {"tire"},
                                    {"unsprung.z", "sprung.z"},
                                    0.005,
                                    {1, 1}},
                                   {"half car",
                                    SUPPORT_HALF_CAR,
                                    {"front_tire", "rear_tire"},
                                    {"front_axle.z", "rear_axle.z"},
                                    0.005,
                                    {1, 1}},
                                   {"half car, unequal weights",
                                    SUPPORT_HALF_CAR,
                                    {"front_tire", "rear_tire"},
                                    {"front_axle.z", "rear_axle.z"},
                                    0.005,
                                    {0.5, 3}}};
    for (size_t k = 0; k < sizeof setups / sizeof *setups; k++)
        coverage(*state, &setups[k]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(intervals_cover)};
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
