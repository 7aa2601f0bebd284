/* SPDX-License-Identifier: MIT */
/* Twin experiments: fits to the frequencies of a model with known factors return these. Needs NLOPT, Needs LAPACK */
#include "fit.h"

typedef struct set {
    const char *name;
    trk_vehicle vehicle;
    const char *parameter[FIT_MAXIMUM], *target[FIT_MAXIMUM];
} set;

enum { CASES = 100 };

static const double accuracy = 1e-6;

static trk_calibration *build(trk_context *context, const set *s, const double *value)
{
    trk_calibration *c = fit_create(context, s->vehicle);
    for (int j = 0; s->parameter[j]; j++)
        fit_stiffness(context, c, s->parameter[j]);
    for (int i = 0; s->target[i]; i++)
        fit_mode(context, c, s->target[i], value[i]);
    return c;
}

/* 0.4 .. 6, evenly in the logarithm. */
static int draw(const set *s, int64_t *seed, double *factor)
{
    int count = 0;
    for (; s->parameter[count]; count++)
        factor[count] = 0.4 * pow(6 / 0.4, fit_uniform(seed));
    return count;
}

static int by_size(const void *a, const void *b)
{
    int64_t x = *(const int64_t *)a, y = *(const int64_t *)b;
    return (x > y) - (x < y);
}

typedef struct tally {
    int ok, wrong, identify, target, convergence;
    int64_t evaluations[CASES];
    double worst;
} tally;

static void run_case(trk_context *context, const set *s, int64_t *seed, int number, tally *t)
{
    double factor[FIT_MAXIMUM], value[FIT_MAXIMUM] = {1, 1, 1, 1, 1, 1, 1, 1}, error = 0;
    int count = draw(s, seed, factor);
    trk_calibration *c = build(context, s, value);
    assert_ok(context, trk_calibration_evaluate(c, factor, value, NULL));
    trk_calibration_destroy(c);
    c = build(context, s, value);
    trk_status status = trk_calibration_solve(c, NULL, NULL, NULL);
    for (int j = 0; j < count; j++)
        error = fmax(error, fabs(fit_fitted(c, j + 1) / factor[j] - 1));
    t->evaluations[number] = trk_calibration_evaluations(c);
    t->ok += status == TRK_OK;
    t->wrong += status == TRK_OK && error > accuracy;
    t->identify += status == TRK_E_IDENTIFY;
    t->target += status == TRK_E_TARGET;
    t->convergence += status == TRK_E_CONVERGENCE;
    if (status == TRK_OK)
        t->worst = fmax(t->worst, error);
    trk_calibration_destroy(c);
}

static void run_set(trk_context *context, const set *s, tally *t)
{
    int64_t seed = 20240101;
    *t = (tally){0};
    for (int k = 0; k < CASES; k++)
        run_case(context, s, &seed, k, t);
    qsort(t->evaluations, CASES, sizeof *t->evaluations, by_size);
    printf(
        "%-44s %3d returned, worst error %.1e, %d wrong, %d ambiguous, %d out of reach, %d without "
        "convergence; evaluations: median %lld, most %lld\n",
        s->name, t->ok, t->worst, t->wrong, t->identify, t->target, t->convergence,
        (long long)t->evaluations[CASES / 2], (long long)t->evaluations[CASES - 1]);
}

static const set well_posed[] = {
    {"quarter car front: tire", TRK_VEHICLE_REFERENCE_FRONT, {"tire"}, {"unsprung.z"}},
    {"quarter car rear: spring", TRK_VEHICLE_REFERENCE_REAR, {"spring"}, {"sprung.z"}},
    {"quarter car rear: tire, two targets",
     TRK_VEHICLE_REFERENCE_REAR,
     {"tire"},
     {"unsprung.z", "sprung.z"}},
    {"half car: tires",
     SUPPORT_HALF_CAR,
     {"front_tire", "rear_tire"},
     {"front_axle.z", "rear_axle.z"}},
    {"half truck: tires",
     TRK_VEHICLE_REFERENCE_HALF,
     {"front_tire", "rear_tire"},
     {"front_axle.z", "rear_axle.z"}},
    {"3D truck: tires",
     TRK_VEHICLE_REFERENCE_TRUCK,
     {"front_*_tire", "rear_*_tire"},
     {"front_axle.z", "rear_axle.z"}}};

/* Here modes change their place over the range of factors, or two solutions exist: not every
 * fit can succeed, but none may say that it did and be wrong. */
static const set hard[] = {
    {"quarter car front: tire and spring",
     TRK_VEHICLE_REFERENCE_FRONT,
     {"tire", "spring"},
     {"unsprung.z", "sprung.z"}},
    {"half car: tires and springs",
     SUPPORT_HALF_CAR,
     {"front_tire", "rear_tire", "*_spring"},
     {"front_axle.z", "rear_axle.z", "body.z", "body.pitch"}},
    {"half truck: tires and cab mounts",
     TRK_VEHICLE_REFERENCE_HALF,
     {"front_tire", "rear_tire", "cab_*_vertical"},
     {"cab.z", "front_axle.z", "rear_axle.z"}},
    {"half truck: tires, mounts, springs",
     TRK_VEHICLE_REFERENCE_HALF,
     {"front_tire", "rear_tire", "cab_*_vertical", "*_spring"},
     {"cab.z", "cab.pitch", "frame.z", "frame.pitch", "front_axle.z", "rear_axle.z"}},
    {"3D truck: tires and roll bar",
     TRK_VEHICLE_REFERENCE_TRUCK,
     {"front_*_tire", "rear_*_tire", "front_anti_roll_bar"},
     {"front_axle.z", "rear_axle.z", "front_axle.roll", "rear_axle.roll"}},
    {"3D truck: tires, mounts, springs",
     TRK_VEHICLE_REFERENCE_TRUCK,
     {"front_*_tire", "rear_*_tire", "cab_*_vertical", "*_spring"},
     {"cab.z", "cab.pitch", "frame.z", "frame.pitch", "front_axle.z", "rear_axle.z",
      "frame.roll"}}};

static void well_posed_twins_are_returned(void **state)
{
    for (size_t k = 0; k < sizeof well_posed / sizeof *well_posed; k++) {
        tally t;
        run_set(*state, &well_posed[k], &t);
        assert_int_equal(t.ok, CASES);
        assert_int_equal(t.wrong, 0);
        assert_true(t.evaluations[CASES / 2] <= 30);
    }
}

static void no_twin_is_wrong_in_silence(void **state)
{
    for (size_t k = 0; k < sizeof hard / sizeof *hard; k++) {
        tally t;
        run_set(*state, &hard[k], &t);
        assert_int_equal(t.wrong, 0);
        assert_int_equal(t.ok + t.identify + t.target + t.convergence, CASES);
        if (k == 0)
            assert_true(t.identify >= 90); /* two exact solutions, found from either one */
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(well_posed_twins_are_returned),
                                       cmocka_unit_test(no_twin_is_wrong_in_silence)};
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
