/* SPDX-License-Identifier: MIT */
/* Jacobians against central differences, also where modes come close or cross. Needs NLOPT, Needs LAPACK */
#include "fit.h"

enum { MOST = 32 }; /* values of any calibration here */

/* Largest difference from central differences, relative to the largest slope of the value. */
static double worst_slope(trk_context *context, trk_calibration *c, int n, const double *p)
{
    double exact[MOST * FIT_MAXIMUM], y[MOST], high[MOST], low[MOST], worst = 0, step = 1e-4;
    int m = trk_calibration_values(c);
    assert_true(m <= MOST);
    assert_ok(context, trk_calibration_evaluate(c, p, y, exact));
    for (int i = 0; i < m; i++) {
        double largest = 0, error = 0;
        for (int j = 0; j < n; j++) {
            double moved[FIT_MAXIMUM], slope[2];
            memcpy(moved, p, (size_t)n * sizeof *moved);
            for (int k = 0; k < 2; k++) { /* Richardson: fourth order */
                double h = step * p[j] * (k + 1);
                moved[j] = p[j] + h;
                assert_ok(context, trk_calibration_evaluate(c, moved, high, NULL));
                moved[j] = p[j] - h;
                assert_ok(context, trk_calibration_evaluate(c, moved, low, NULL));
                slope[k] = (high[i] - low[i]) / (2 * h);
            }
            double difference = (4 * slope[0] - slope[1]) / 3;
            largest = fmax(largest, fabs(difference * p[j]));
            error = fmax(error, fabs(exact[i * n + j] - difference) * p[j]);
        }
        worst = fmax(worst, error / fmax(largest, 1e-3 * (1 + fabs(y[i]))));
    }
    return worst;
}

static void add(trk_context *context, trk_calibration *c, trk_field field, const char *pattern,
                double power, trk_meaning meaning)
{
    trk_parameter_options o;
    trk_parameter_options_init(&o, sizeof o);
    o.meaning = meaning;
    char name[64];
    int32_t id;
    snprintf(name, sizeof name, "%s of %s", field <= TRK_FIELD_DAMPING ? "link" : "body", pattern);
    snprintf(name + strlen(name), 4, " %d", (int)field);
    if (meaning == TRK_MEANING_VALUE) {
        o.upper = 1e9;
        o.start = 1e3;
    }
    assert_ok(context, trk_calibration_add_parameter(c, name, &o, &id));
    assert_ok(context, trk_calibration_act_on(c, id, field, pattern, power, NULL));
}

/* All kinds of modal targets on some coordinates, and a response. */
static void add_targets(trk_context *context, trk_calibration *c, const char *const *coordinate,
                        const char *sensor)
{
    static const double frequency[] = {0.7, 2.3, 7.1, 12}, magnitude[] = {1, 1, 1, 1};
    for (int k = 0; coordinate[k]; k++)
        for (int32_t kind = 1; kind <= TRK_TARGET_DAMPING_RATIO; kind++) {
            trk_target_options o;
            trk_target_options_init(&o, sizeof o);
            char name[64];
            snprintf(name, sizeof name, "%s %d", coordinate[k], (int)kind);
            o.kind = kind;
            o.coordinate = coordinate[k];
            o.value = 1;
            assert_ok(context, trk_calibration_add_target(c, name, &o, NULL));
        }
    trk_target_options o;
    trk_target_options_init(&o, sizeof o);
    o.kind = TRK_TARGET_RESPONSE_CURVE;
    o.sensor = sensor;
    o.count = 4;
    o.frequency = frequency;
    o.magnitude = magnitude;
    assert_ok(context, trk_calibration_add_target(c, "response", &o, NULL));
}

static trk_calibration *create(trk_context *context, trk_vehicle vehicle, trk_variant variant,
                               double gravity)
{
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.gravity = gravity;
    trk_spec *spec = support_spec(context, vehicle, variant);
    trk_calibration *c;
    assert_ok(context, trk_calibration_create(context, spec, &options, &c));
    trk_spec_destroy(spec);
    return c;
}

static void check(trk_context *context, trk_calibration *c, int n, const double *p,
                  const char *what)
{
    double worst = worst_slope(context, c, n, p);
    printf("%-60s %.1e\n", what, worst);
    assert_true(worst < 1e-6);
    trk_calibration_destroy(c);
}

static const char *const hops[] = {"front_axle.z", "rear_axle.z", NULL};
static const char *const half[] = {"cab.z", "frame.z", "front_axle.z", "rear_axle.z", NULL};

/* Stiffness and damping with curves, mass, both of a body, tied parts, powers, a value. */
static void all_kinds_of_parameters(void **state)
{
    static const double p[] = {1.3, 0.8, 0.9, 1.2, 1.1, 900e3, 0.7};
    for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++)
        for (int heavy = 0; heavy < 2; heavy++) {
            trk_calibration *c =
                create(*state, TRK_VEHICLE_REFERENCE_HALF, variant, heavy ? 9.81 : 0);
            add(*state, c, TRK_FIELD_STIFFNESS, "*_spring", 1, TRK_MEANING_FACTOR);
            add(*state, c, TRK_FIELD_DAMPING, "*_damper", 1, TRK_MEANING_FACTOR);
            add(*state, c, TRK_FIELD_MASS, "cab", 2, TRK_MEANING_FACTOR);
            add(*state, c, TRK_FIELD_MASS_INERTIA, "frame", -0.5, TRK_MEANING_FACTOR);
            add(*state, c, TRK_FIELD_INERTIA, "cab", 1, TRK_MEANING_FACTOR);
            add(*state, c, TRK_FIELD_STIFFNESS, "*_tire", 1, TRK_MEANING_VALUE);
            add(*state, c, TRK_FIELD_DAMPING, "cab_*", 1.5, TRK_MEANING_FACTOR);
            add_targets(*state, c, half, "cab_front_z");
            char what[96];
            snprintf(what, sizeof what, "half truck, %s, %s gravity", support_variant_name(variant),
                     heavy ? "with" : "without");
            check(*state, c, 7, p, what);
        }
}

/* The hops of the reference tractor lie 1.5 % apart. */
static void nearly_equal_frequencies(void **state)
{
    static const double p[] = {1, 1, 1};
    for (trk_vehicle vehicle = TRK_VEHICLE_REFERENCE_HALF; vehicle <= SUPPORT_HALF_CAR; vehicle++) {
        trk_calibration *c = create(*state, vehicle, TRK_VARIANT_LINEAR, 0);
        int three = vehicle == TRK_VEHICLE_REFERENCE_TRUCK;
        add(*state, c, TRK_FIELD_STIFFNESS, three ? "front_*_tire" : "front_tire", 1, 0);
        add(*state, c, TRK_FIELD_STIFFNESS, three ? "rear_*_tire" : "rear_tire", 1, 0);
        add(*state, c, TRK_FIELD_MASS, "front_axle", 1, 0);
        add_targets(*state, c, hops, three ? "front_axle_left_z" : "front_axle_z");
        check(*state, c, 3, p, support_vehicle_name(vehicle));
    }
}

/*
 * Symmetric and antisymmetric modes of the 3D truck do not know each other: the front hop passes
 * through the rolls without a trace. Across a sweep in which they cross, value and slope agree.
 */
static void crossing_modes(void **state)
{
    trk_context *context = *state;
    trk_calibration *c = create(context, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_LINEAR, 0);
    fit_stiffness(context, c, "front_*_tire");
    fit_mode(context, c, "front_axle.z", 7);
    fit_mode(context, c, "rear_axle.roll", 8);
    double y[2], j[2], before = 0, slope = 0, jump = 0, step = 2e-3;
    int signs[2] = {0};
    for (int k = 0; k <= 400; k++) {
        double p = 1.1 + step * k;
        assert_ok(context, trk_calibration_evaluate(c, &p, y, j));
        signs[y[0] > y[1]]++;
        if (k > 0) /* trapezoidal rule: O(step^3) */
            jump = fmax(jump, fabs(y[0] - before - step * (j[0] + slope) / 2));
        before = y[0];
        slope = j[0];
    }
    printf("front hop through the rear roll: %d steps below, %d above, largest jump %.1e Hz\n",
           signs[0], signs[1], jump);
    assert_true(signs[0] > 20 && signs[1] > 20);
    assert_true(jump < 1e-6);
    /* At the crossing itself, to rounding. */
    double low = 1.1, high = 1.9;
    for (int k = 0; k < 60; k++) {
        double middle = (low + high) / 2;
        assert_ok(context, trk_calibration_evaluate(c, &middle, y, NULL));
        *(y[0] < y[1] ? &low : &high) = middle;
    }
    double at[2], left[2], right[2], p = low - 1e-3;
    assert_ok(context, trk_calibration_evaluate(c, &low, y, at));
    assert_ok(context, trk_calibration_evaluate(c, &p, y, left));
    p = low + 1e-3;
    assert_ok(context, trk_calibration_evaluate(c, &p, y, right));
    printf("slope of the front hop at the crossing %.9g, beside it %.9g\n", at[0],
           (left[0] + right[0]) / 2);
    assert_near(at[0], (left[0] + right[0]) / 2, 1e-6);
    assert_near(at[1], (left[1] + right[1]) / 2, 1e-6);
    trk_calibration_destroy(c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(all_kinds_of_parameters),
                                       cmocka_unit_test(nearly_equal_frequencies),
                                       cmocka_unit_test(crossing_modes)};
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
