/* SPDX-License-Identifier: MIT */
/*
 * A hostile caller: NULL for every pointer, every number not finite, negative or huge, ids and
 * names that do not exist. Each call gives a status with a sentence or a neutral value; nothing
 * crashes, nothing leaks, and what was there before still works. Run it under sanitizers.
 */
#include "support.h"

#include "base/base.h"
#include <truckride/linear.h>
#include <truckride/simulate.h>
#include <truckride/vehicle.h>

static const double bad_numbers[] = {NAN, INFINITY, -INFINITY, -1, 0, 1e308, -1e308, 1e200, 5e-324};
static const int32_t bad_ids[] = {0, -1, -1000, 1000, INT32_MAX, INT32_MIN};
enum { NUMBERS = sizeof bad_numbers / sizeof *bad_numbers, IDS = sizeof bad_ids / sizeof *bad_ids };

/* Sanitizers take a request for a terabyte for a bug of the caller; so does a small machine. */
static void *allocate(void *user, void *block, size_t old_size, size_t new_size)
{
    (void)user;
    (void)old_size;
    if (new_size == 0) {
        free(block);
        return NULL;
    }
    return new_size > 100000000 ? NULL : realloc(block, new_size);
}

static int setup(void **state)
{
    trk_context *context = NULL;
    if (trk_context_create(allocate, NULL, &context) != TRK_OK)
        return -1;
    *state = context;
    return 0;
}

/* A failure must leave a new sentence. Ask with hush() before. */
static trk_context *hush(trk_context *context)
{
    (void)trk_fail(context, TRK_OK, "-");
    return context;
}

static bool worked(trk_context *context, trk_status status)
{
    if (status == TRK_OK)
        return true;
    assert_string_not_equal(trk_status_text(status), "unknown status");
    assert_true(strlen(trk_context_message(context)) > 10);
    return false;
}

#define REFUSED(context, call) assert_false(WORKED(context, call))
#define WORKED(context, call) (hush(context), worked((context), (call)))

static trk_model *make_model(trk_context *context, trk_vehicle vehicle)
{
    trk_spec *spec;
    trk_model *model;
    assert_ok(context, trk_vehicle_create_builtin(context, vehicle, TRK_VARIANT_NONLINEAR, &spec));
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

/* ---- numbers: curve, signal, series ------------------------------------------------------- */

static void curves(void **state)
{
    trk_context *c = *state;
    trk_curve *curve;
    const double good_x[] = {-1, 0, 1, 2}, good_y[] = {-2, 0, 1, 3};
    trk_curve_options options;
    for (trk_interpolation i = TRK_INTERPOLATION_PCHIP; i <= TRK_INTERPOLATION_LINEAR; i++)
        for (int n = 0; n < NUMBERS; n++)
            for (int place = 0; place < 8; place++) {
                double x[4], y[4];
                memcpy(x, good_x, sizeof x);
                memcpy(y, good_y, sizeof y);
                (place < 4 ? x : y)[place % 4] = bad_numbers[n];
                trk_curve_options_init(&options, sizeof options);
                options.interpolation = i;
                if (!WORKED(c, trk_curve_create(c, "c", 4, x, y, &options, &curve))) {
                    assert_null(curve);
                    continue;
                }
                assert_true(isfinite(bad_numbers[n]));
                for (int k = 0; k < NUMBERS; k++) {
                    double found, value = trk_curve_value(curve, bad_numbers[k]);
                    assert_true(isnan(value) || !isnan(bad_numbers[k]));
                    (void)WORKED(c, trk_curve_solve(c, curve, bad_numbers[k], &found));
                }
                trk_curve_destroy(curve);
            }
    const double unsorted[] = {0, 2, 1, 3};
    REFUSED(c, trk_curve_create(c, "c", 4, unsorted, good_y, NULL, &curve));
    REFUSED(c, trk_curve_create(c, NULL, 4, good_x, good_y, NULL, &curve));
    REFUSED(c, trk_curve_create(c, "c", 4, NULL, good_y, NULL, &curve));
    REFUSED(c, trk_curve_create(c, "c", 4, good_x, NULL, NULL, &curve));
    REFUSED(c, trk_curve_create(c, "c", 4, good_x, good_y, NULL, NULL));
    REFUSED(c, trk_curve_copy(c, NULL, &curve));
    for (int64_t count = -1; count < 2; count++)
        REFUSED(c, trk_curve_create(c, "c", count, good_x, good_y, NULL, &curve));
    REFUSED(c, trk_curve_create(c, "c", INT64_MAX, good_x, good_y, NULL, &curve));
    REFUSED(c, trk_curve_create(c, "c", INT64_MIN, good_x, good_y, NULL, &curve));
    for (int k = 0; k < IDS; k++) {
        trk_curve_options_init(&options, sizeof options);
        options.interpolation = bad_ids[k] ? bad_ids[k] : 5;
        REFUSED(c, trk_curve_create(c, "c", 4, good_x, good_y, &options, &curve));
        options.interpolation = 0;
        options.extrapolation = bad_ids[k] ? bad_ids[k] : 2;
        REFUSED(c, trk_curve_create(c, "c", 4, good_x, good_y, &options, &curve));
    }
    double x;
    REFUSED(c, trk_curve_solve(c, NULL, 0, &x));
    assert_int_not_equal(trk_curve_create(NULL, "c", 4, good_x, good_y, NULL, &curve), TRK_OK);
    double slope;
    assert_true(isnan(trk_curve_value(NULL, 0)) && isnan(trk_curve_slope(NULL, 0)));
    trk_curve_evaluate(NULL, 1, &x, &x, NULL);
    assert_int_equal(trk_curve_monotone(NULL), 0);
    trk_curve_slope_range(NULL, &x, &slope);
    assert_true(isnan(x) && isnan(slope));
    assert_int_equal(trk_curve_count(NULL), 0);
    assert_null(trk_curve_x(NULL));
    assert_null(trk_curve_y(NULL));
    assert_null(trk_curve_name(NULL));
    assert_int_equal(trk_curve_interpolation(NULL) + trk_curve_extrapolation(NULL), 0);
    trk_curve_destroy(NULL);
}

/* The kind-th signal with the place-th number replaced; false: there is no such number. */
static bool create_signal(trk_context *c, int kind, int place, double bad, trk_status *status,
                          trk_signal **out)
{
    static const int arguments[] = {3, 4, 7, 6, 8};
    double a[8] = {0.1, 2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8};
    if (place >= arguments[kind])
        return false;
    a[place] = bad;
    trk_sweep_options sweep;
    trk_sweep_options_init(&sweep, sizeof sweep);
    double *const field[] = {
        &sweep.start_frequency,    &sweep.end_frequency, &sweep.duration, &sweep.amplitude,
        &sweep.amplitude_exponent, &sweep.phase,         &sweep.start};
    if (kind == 2)
        *field[place] = bad;
    double x[4] = {0, 1, 2, 3};
    if (kind == 4 && place >= 4)
        x[place - 4] = bad;
    switch (kind) {
    case 0: *status = trk_signal_create_step(c, a[0], a[1], a[2], out); break;
    case 1: *status = trk_signal_create_sine(c, a[0], a[1], a[2], a[3], out); break;
    case 2: *status = trk_signal_create_sweep(c, &sweep, out); break;
    case 3: *status = trk_signal_create_samples(c, 4, a[0], a[1], a + 2, NULL, out); break;
    default: *status = trk_signal_create_points(c, 4, x, a, out); break;
    }
    return true;
}

static void signals(void **state)
{
    trk_context *c = *state;
    trk_signal *signal;
    trk_status status;
    for (int kind = 0; kind < 5; kind++)
        for (int n = 0; n < NUMBERS; n++)
            for (int place = 0;
                 create_signal(hush(c), kind, place, bad_numbers[n], &status, &signal); place++) {
                if (!worked(c, status)) {
                    assert_null(signal);
                    continue;
                }
                assert_true(isfinite(bad_numbers[n]));
                double value[NUMBERS], rate[NUMBERS];
                for (int k = 0; k < NUMBERS; k++)
                    trk_signal_evaluate(signal, 3, bad_numbers[k], bad_numbers[NUMBERS - 1 - k],
                                        value, rate);
                trk_signal_destroy(signal);
            }
    const double v[] = {0, 1, 2, 3};
    REFUSED(c, trk_signal_create_step(c, 0, 1, 1, NULL));
    REFUSED(c, trk_signal_create_sine(c, 0, 1, 1, 1, NULL));
    REFUSED(c, trk_signal_create_sweep(c, NULL, NULL));
    REFUSED(c, trk_signal_create_samples(c, 4, 0, 1, NULL, NULL, &signal));
    REFUSED(c, trk_signal_create_samples(c, 4, 0, 1, v, NULL, NULL));
    REFUSED(c, trk_signal_create_points(c, 4, NULL, v, &signal));
    REFUSED(c, trk_signal_create_points(c, 4, v, NULL, &signal));
    for (int64_t count = -1; count < 2; count++) {
        REFUSED(c, trk_signal_create_samples(c, count, 0, 1, v, NULL, &signal));
        REFUSED(c, trk_signal_create_points(c, count, v, v, &signal));
    }
    REFUSED(c, trk_signal_create_samples(c, INT64_MIN, 0, 1, v, NULL, &signal));
    REFUSED(c, trk_signal_create_points(c, INT64_MAX, v, v, &signal));
    REFUSED(c, trk_signal_create_samples(c, INT64_MAX, 0, 1, v, NULL, &signal));
    assert_true(isnan(trk_signal_value(NULL, 0)) && isnan(trk_signal_rate(NULL, 0)));
    trk_signal_evaluate(NULL, 1, 0, 1, NULL, NULL);
    trk_signal_destroy(NULL);
}

static void series(void **state)
{
    trk_context *c = *state;
    trk_series *s, *other;
    for (int n = 0; n < NUMBERS; n++) {
        if (WORKED(c, trk_series_create(c, 1, 10, bad_numbers[n], 0, &s)))
            trk_series_destroy(s);
        if (WORKED(c, trk_series_create(c, 1, 10, 10, bad_numbers[n], &s)))
            trk_series_destroy(s);
    }
    for (int k = 0; k < IDS; k++) {
        if (WORKED(c, trk_series_create(c, bad_ids[k], 2, 1, 0, &s)))
            trk_series_destroy(s); /* a thousand channels are fine */
        if (WORKED(c, trk_series_create(c, 1, (int64_t)bad_ids[k] * 4294967296, 1, 0, &s)))
            fail();
    }
    REFUSED(c, trk_series_create(c, 1, INT64_MAX, 1, 0, &s));
    REFUSED(c, trk_series_create(c, 1, 10, 1, 0, NULL));
    assert_ok(c, trk_series_create(c, 2, 10, 1, 0, &s));
    for (int k = 0; k < IDS; k++) {
        REFUSED(c, trk_series_label(s, bad_ids[k], "x", ""));
        assert_null(trk_series_name(s, bad_ids[k]));
        assert_null(trk_series_unit(s, bad_ids[k]));
        assert_null(trk_series_data(s, bad_ids[k]));
        assert_null(trk_series_data_mutable(s, bad_ids[k]));
        if (bad_ids[k] < 1)
            REFUSED(c, trk_series_write_csv(c, s, "never.csv", bad_ids[k]));
    }
    REFUSED(c, trk_series_label(s, 1, NULL, ""));
    REFUSED(c, trk_series_label(s, 1, "x", NULL));
    REFUSED(c, trk_series_label(s, 1, "2", ""));
    REFUSED(c, trk_series_write_csv(c, NULL, "never.csv", 1));
    REFUSED(c, trk_series_write_csv(c, s, NULL, 1));
    REFUSED(c, trk_series_write_csv(c, s, "no such folder/never.csv", 1));
    REFUSED(c, trk_series_resample(c, NULL, 1, &other));
    REFUSED(c, trk_series_resample(c, s, 1, NULL));
    for (int n = 0; n < NUMBERS; n++)
        REFUSED(c, trk_series_resample(c, s, bad_numbers[n], &other));
    assert_int_equal(trk_series_find(s, NULL), 0);
    assert_int_equal(trk_series_find(s, "nobody"), 0);
    assert_ok(c, trk_series_label(s, 1, "still", "m"));
    trk_series_destroy(s);
    assert_int_equal(trk_series_channels(NULL) + trk_series_samples(NULL), 0);
    assert_true(isnan(trk_series_rate(NULL)) && isnan(trk_series_start(NULL)));
    assert_int_equal(trk_series_find(NULL, "a"), 0);
    assert_null(trk_series_name(NULL, 1));
    assert_null(trk_series_unit(NULL, 1));
    assert_null(trk_series_data(NULL, 1));
    assert_null(trk_series_data_mutable(NULL, 1));
    trk_series_destroy(NULL);
}

/* ---- vehicles ------------------------------------------------------------------------------ */

/* Compile, step and analyse what a hostile spec became; free it. */
static void use(trk_context *c, trk_spec *spec, double gravity)
{
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.gravity = gravity;
    trk_model *model;
    trk_newmark *stepper;
    if (WORKED(c, trk_model_compile(c, spec, &options, &model))) {
        if (WORKED(c, trk_newmark_create(c, model, NULL, &stepper))) {
            const double height[16] = {0.01, -0.01, 0.01, 0.02};
            assert_in_range(trk_model_count(model, TRK_PART_ROAD), 1, 16);
            double q[13], v[13], a[13];
            assert_in_range(trk_model_count(model, TRK_PART_COORDINATE), 1, 13);
            for (int k = 0; k < 3; k++)
                (void)WORKED(c, trk_newmark_step(stepper, height, NULL, NULL));
            trk_newmark_get_state(stepper, q, v, a);
            for (int32_t i = 0; i < trk_model_count(model, TRK_PART_COORDINATE); i++)
                assert_true(isfinite(q[i]) && isfinite(v[i]) && isfinite(a[i]));
            trk_newmark_destroy(stepper);
        }
        trk_modes *modes;
        if (WORKED(c, trk_modes_create_undamped(c, model, NULL, &modes)))
            trk_modes_destroy(modes);
        trk_model_destroy(model);
    }
    trk_spec_destroy(spec);
}

/* Every number of a parameter struct in turn; those between the first and the last field given. */
#define SWEEP(type, init, create, first, last)                                                     \
    for (size_t at = offsetof(type, first); at <= offsetof(type, last); at += sizeof(double))      \
        for (int n = 0; n < NUMBERS; n++) {                                                        \
            type p;                                                                                \
            init(&p, sizeof p);                                                                    \
            memcpy((char *)&p + at, &bad_numbers[n], sizeof(double));                              \
            trk_spec *spec;                                                                        \
            if (WORKED(c, create(c, &p, &spec)))                                                   \
                use(c, spec, n % 2 ? 9.81 : 0);                                                    \
            else                                                                                   \
                assert_null(spec);                                                                 \
        }

static void vehicle_parameters(void **state)
{
    trk_context *c = *state;
    SWEEP(trk_quarter_car_parameters, trk_quarter_car_parameters_init,
          trk_vehicle_create_quarter_car, sprung_mass, tire_damping)
    SWEEP(trk_half_car_parameters, trk_half_car_parameters_init, trk_vehicle_create_half_car,
          body_mass, tire_damping)
    SWEEP(trk_truck_parameters, trk_truck_parameters_init, trk_vehicle_create_half_truck, cab_mass,
          cab_anti_roll_stiffness)
    SWEEP(trk_truck_parameters, trk_truck_parameters_init, trk_vehicle_create_truck, cab_mass,
          cab_anti_roll_stiffness)
}

static void vehicle_ids(void **state)
{
    trk_context *c = *state;
    trk_spec *spec;
    trk_curve *curve;
    for (int k = 0; k < IDS; k++) {
        REFUSED(c, trk_vehicle_create_builtin(c, bad_ids[k], 0, &spec));
        REFUSED(c, trk_vehicle_create_builtin(c, 1, bad_ids[k] ? bad_ids[k] : 3, &spec));
        REFUSED(c, trk_vehicle_create_curve(c, bad_ids[k], NULL, &curve));
        REFUSED(c, trk_vehicle_create_axle_quarter(c, NULL, bad_ids[k] ? bad_ids[k] : 2, &spec));
        trk_half_car_parameters half;
        trk_half_car_parameters_init(&half, sizeof half);
        half.layout = bad_ids[k] ? bad_ids[k] : 2;
        REFUSED(c, trk_vehicle_create_half_car(c, &half, &spec));
    }
    REFUSED(c, trk_vehicle_create_builtin(c, 1, 0, NULL));
    REFUSED(c, trk_vehicle_create_curve(c, 1, NULL, NULL));
    REFUSED(c, trk_vehicle_create_quarter_car(c, NULL, NULL));
    REFUSED(c, trk_vehicle_create_half_car(c, NULL, NULL));
    REFUSED(c, trk_vehicle_create_half_truck(c, NULL, NULL));
    REFUSED(c, trk_vehicle_create_truck(c, NULL, NULL));
    REFUSED(c, trk_vehicle_create_axle_quarter(c, NULL, 0, NULL));
    assert_int_not_equal(trk_vehicle_create_truck(NULL, NULL, &spec), TRK_OK);
    trk_quarter_car_parameters_init(NULL, 8);
    trk_half_car_parameters_init(NULL, 8);
    trk_truck_parameters_init(NULL, 8);
}

/* ---- spec ---------------------------------------------------------------------------------- */

/* Every byte pattern of a link, sensor or port that can be said in one field. */
static void spec_fields(void **state)
{
    trk_context *c = *state;
    trk_spec *spec;
    for (int n = 0; n < NUMBERS; n++)
        for (int place = 0; place < 13; place++) {
            assert_ok(c, trk_vehicle_create_builtin(c, TRK_VEHICLE_THESIS_QUARTER, 0, &spec));
            trk_link_options link;
            trk_link_options_init(&link, sizeof link);
            link.from_body = 1;
            link.to_body = 2;
            double *const field[] = {link.from_point,    link.from_point + 1, link.from_point + 2,
                                     link.to_point,      link.to_point + 1,   link.to_point + 2,
                                     link.direction,     link.direction + 2,  &link.stiffness,
                                     &link.damping,      &link.spring_scale,  &link.damper_scale,
                                     &link.spring_offset};
            *field[place] = bad_numbers[n];
            (void)WORKED(c, trk_spec_add_link(spec, "hostile", &link, NULL));
            use(c, spec, place % 2 ? 9.81 : 0);
        }
    assert_ok(c, trk_vehicle_create_builtin(c, TRK_VEHICLE_THESIS_QUARTER, 0, &spec));
    for (int n = 0; n < NUMBERS; n++) {
        const double point[] = {0, bad_numbers[n], 0};
        char name[16];
        snprintf(name, sizeof name, "n%d", n);
        (void)WORKED(c, trk_spec_add_mass(spec, name, 1, 1, point, NULL));
        (void)WORKED(c, trk_spec_add_road(spec, name, bad_numbers[n], 0, NULL));
    }
    for (int k = 0; k < IDS; k++) {
        trk_body_options body;
        trk_body_options_init(&body, sizeof body);
        body.mass = 1;
        REFUSED(c, trk_spec_set_body(spec, bad_ids[k], &body));
        REFUSED(c, trk_spec_add_mass(spec, "m", bad_ids[k], 1, (double[]){0, 0, 0}, NULL));
        assert_int_equal(trk_spec_count(spec, bad_ids[k]), 0);
        assert_null(trk_spec_part_name(spec, TRK_PART_BODY, bad_ids[k]));
        assert_int_equal(trk_spec_find(spec, bad_ids[k], "sprung"), 0);
    }
    use(c, spec, 9.81);
}

/* ---- model, excitation, stepper ------------------------------------------------------------ */

static void model_questions(void **state)
{
    trk_context *c = *state;
    trk_model *model = make_model(c, TRK_VEHICLE_REFERENCE_HALF);
    double x[64];
    for (int k = 0; k < IDS; k++) {
        assert_int_not_equal(trk_model_get_road_place(model, bad_ids[k], x, x), TRK_OK);
        assert_int_not_equal(trk_model_get_link_row(model, bad_ids[k], x, NULL), TRK_OK);
        assert_int_not_equal(trk_model_get_row(model, TRK_PART_PORT, bad_ids[k], x), TRK_OK);
        assert_int_not_equal(trk_model_get_row(model, bad_ids[k], 1, x), TRK_OK);
        assert_null(trk_model_unit(model, TRK_PART_SENSOR, bad_ids[k]));
        assert_null(trk_model_unit(model, bad_ids[k], 1));
        assert_null(trk_model_part_name(model, bad_ids[k], 1));
        assert_null(trk_model_part_name(model, TRK_PART_LINK, bad_ids[k]));
        assert_int_equal(trk_model_count(model, bad_ids[k]), 0);
        assert_int_equal(trk_model_find(model, bad_ids[k], "cab"), 0);
    }
    assert_null(trk_model_name(NULL));
    assert_int_equal(trk_model_count(NULL, TRK_PART_BODY), 0);
    assert_int_equal(trk_model_find(NULL, TRK_PART_BODY, "cab"), 0);
    assert_int_equal(trk_model_find(model, TRK_PART_BODY, NULL), 0);
    assert_null(trk_model_part_name(NULL, TRK_PART_BODY, 1));
    assert_near(trk_model_gravity(NULL), 0, 0);
    trk_model_get_static(NULL, x, x);
    trk_model_get_static(model, NULL, NULL);
    trk_model_get_mass(NULL, x);
    trk_model_get_mass(model, NULL);
    trk_model_get_tangent(NULL, x, x, x, x);
    trk_model_get_link_force(NULL, x, x, x);
    trk_model_get_link_force(model, NULL, x, x);
    trk_model_get_link_force(model, x, NULL, x);
    trk_model_get_link_force(model, x, x, NULL);
    trk_model_destroy(NULL);
    trk_model_destroy(model);
}

static void excitations(void **state)
{
    trk_context *c = *state;
    trk_model *model = make_model(c, TRK_VEHICLE_REFERENCE_HALF);
    trk_excitation *x;
    trk_signal *s;
    assert_ok(c, trk_signal_create_step(c, 0, 1, 1, &s));
    assert_ok(c, trk_excitation_create(c, model, &x));
    for (int n = 0; n < NUMBERS; n++) {
        (void)WORKED(c, trk_excitation_add_motion(x, 1, s, bad_numbers[n], 0));
        (void)WORKED(c, trk_excitation_add_motion(x, 1, s, 1, bad_numbers[n]));
        (void)WORKED(c, trk_excitation_add_profile(x, TRK_ROAD_ALL, s, bad_numbers[n], 1, 0));
        (void)WORKED(c, trk_excitation_add_profile(x, TRK_ROAD_ALL, s, 1, bad_numbers[n], 0));
        (void)WORKED(c, trk_excitation_add_profile(x, TRK_ROAD_ALL, s, 1, 1, bad_numbers[n]));
        (void)WORKED(c, trk_excitation_add_load(x, 1, s, bad_numbers[n], 0));
        (void)WORKED(c, trk_excitation_add_load(x, 1, s, 1, bad_numbers[n]));
    }
    double height[8], velocity[8], load[8];
    for (int n = 0; n < NUMBERS; n++)
        for (int m = 0; m < NUMBERS; m++)
            trk_excitation_evaluate(x, 4, bad_numbers[n], bad_numbers[m], height, velocity, load);
    /* Gains of 1e308 times speeds of 1e308 are no longer numbers: the run says so. */
    trk_series *series;
    REFUSED(c, trk_simulate(c, model, x, NULL, NULL, NULL, NULL, &series));
    trk_excitation_destroy(x);
    trk_signal_destroy(s);
    trk_model_destroy(model);
}

static void stepper_numbers(void **state)
{
    trk_context *c = *state;
    trk_model *model = make_model(c, TRK_VEHICLE_REFERENCE_HALF);
    trk_newmark *stepper;
    trk_newmark_options options;
    for (size_t at = offsetof(trk_newmark_options, step);
         at <= offsetof(trk_newmark_options, tolerance); at += sizeof(double))
        for (int n = 0; n < NUMBERS; n++) {
            trk_newmark_options_init(&options, sizeof options);
            memcpy((char *)&options + at, &bad_numbers[n], sizeof(double));
            if (!WORKED(c, trk_newmark_create(c, model, &options, &stepper))) {
                assert_null(stepper);
                continue;
            }
            assert_true(isfinite(bad_numbers[n]));
            (void)WORKED(c, trk_newmark_step(stepper, (double[]){0.01, 0}, NULL, NULL));
            trk_newmark_destroy(stepper);
        }
    for (int k = 0; k < IDS; k++) {
        trk_newmark_options_init(&options, sizeof options);
        options.backend = bad_ids[k] ? bad_ids[k] : 3;
        REFUSED(c, trk_newmark_create(c, model, &options, &stepper));
        trk_newmark_options_init(&options, sizeof options);
        options.max_iterations = bad_ids[k] < 1 ? bad_ids[k] : 0;
        REFUSED(c, trk_newmark_create(c, model, &options, &stepper));
    }
    for (int n = 0; n < NUMBERS; n++) {
        trk_newmark_options_init(&options, sizeof options);
        trk_newmark_options_hht(&options, bad_numbers[n]);
        if (WORKED(c, trk_newmark_create(c, model, &options, &stepper)))
            trk_newmark_destroy(stepper);
        trk_newmark_options_generalized_alpha(&options, bad_numbers[n]);
        if (WORKED(c, trk_newmark_create(c, model, &options, &stepper)))
            trk_newmark_destroy(stepper);
    }
    trk_newmark_options_init(NULL, 8);
    trk_newmark_options_adams(NULL);
    trk_newmark_options_hht(NULL, 0);
    trk_newmark_options_generalized_alpha(NULL, 1);
    trk_model_destroy(model);
}

/* After every refusal the stepper goes on as if it had not been asked. */
static void stepper_keeps_its_state(void **state)
{
    trk_context *c = *state;
    trk_model *model = make_model(c, TRK_VEHICLE_REFERENCE_HALF);
    int32_t n_q = trk_model_count(model, TRK_PART_COORDINATE);
    assert_int_equal(n_q, 7);
    const double good[] = {0.01, -0.005};
    trk_newmark *stepper, *calm;
    assert_ok(c, trk_newmark_create(c, model, NULL, &stepper));
    assert_ok(c, trk_newmark_create(c, model, NULL, &calm));
    for (int n = 0; n < NUMBERS; n++)
        for (int place = 0; place < 6; place++) {
            double q[7] = {0}, before[21], after[21];
            double two[2] = {0, bad_numbers[n]};
            trk_newmark_get_state(stepper, before, before + 7, before + 14);
            q[6] = bad_numbers[n];
            hush(c);
            trk_status status =
                place == 0
                    ? trk_newmark_set_state(stepper, bad_numbers[n], NULL, NULL, NULL, NULL, NULL)
                : place == 1 ? trk_newmark_set_state(stepper, 0, q, NULL, NULL, NULL, NULL)
                : place == 2 ? trk_newmark_set_state(stepper, 0, NULL, q, NULL, NULL, NULL)
                : place == 3 ? trk_newmark_step(stepper, two, NULL, NULL)
                : place == 4 ? trk_newmark_step(stepper, NULL, two, NULL)
                             : trk_newmark_step(stepper, NULL, NULL, two);
            trk_newmark_get_state(stepper, after, after + 7, after + 14);
            if (worked(c, status)) {
                for (int i = 0; i < 21; i++)
                    assert_true(isfinite(after[i]));
                assert_ok(c, trk_newmark_set_state(stepper, 0, NULL, NULL, NULL, NULL, NULL));
                assert_ok(c, trk_newmark_set_state(calm, 0, NULL, NULL, NULL, NULL, NULL));
            } else {
                assert_memory_equal(before, after, sizeof before);
            }
            assert_ok(c, trk_newmark_step(stepper, good, NULL, NULL));
            assert_ok(c, trk_newmark_step(calm, good, NULL, NULL));
            trk_newmark_get_state(stepper, after, after + 7, after + 14);
            trk_newmark_get_state(calm, before, before + 7, before + 14);
            for (int i = 0; i < 21; i++)
                assert_near(after[i], before[i], 1e-9 * (1 + fabs(before[i])));
        }
    trk_newmark_destroy(stepper);
    trk_newmark_destroy(calm);
    trk_model_destroy(model);
}

static void stepper_pointers(void **state)
{
    trk_context *c = *state;
    trk_model *model = make_model(c, TRK_VEHICLE_REFERENCE_HALF);
    trk_newmark *stepper;
    REFUSED(c, trk_newmark_create(c, NULL, NULL, &stepper));
    REFUSED(c, trk_newmark_create(c, model, NULL, NULL));
    assert_int_not_equal(trk_newmark_create(NULL, model, NULL, &stepper), TRK_OK);
    assert_int_not_equal(trk_newmark_step(NULL, NULL, NULL, NULL), TRK_OK);
    assert_int_not_equal(trk_newmark_set_state(NULL, 0, NULL, NULL, NULL, NULL, NULL), TRK_OK);
    assert_true(isnan(trk_newmark_step_size(NULL)));
    assert_true(isnan(trk_newmark_time(NULL)));
    double x[64];
    trk_newmark_get_state(NULL, x, x, x);
    trk_newmark_get_links(NULL, x, x, x);
    trk_newmark_read_sensors(NULL, x);
    trk_newmark_statistics statistics = {.struct_size = 0};
    assert_int_not_equal(trk_newmark_get_statistics(NULL, &statistics), TRK_OK);
    assert_ok(c, trk_newmark_create(c, model, NULL, &stepper));
    assert_int_not_equal(trk_newmark_get_statistics(stepper, NULL), TRK_OK);
    assert_int_equal(trk_newmark_get_statistics(stepper, &statistics), TRK_E_OPTIONS);
    trk_newmark_get_state(stepper, NULL, NULL, NULL);
    trk_newmark_get_links(stepper, NULL, NULL, NULL);
    trk_newmark_read_sensors(stepper, NULL);
    assert_ok(c, trk_newmark_step(stepper, NULL, NULL, NULL));
    trk_newmark_destroy(stepper);
    trk_newmark_destroy(NULL);
    trk_model_destroy(model);
}

/* ---- linear analysis ------------------------------------------------------------------------ */

static void linear_analysis(void **state)
{
    trk_context *c = *state;
    trk_model *model = make_model(c, TRK_VEHICLE_REFERENCE_HALF);
    trk_modes *modes;
    double q[7] = {0}, row[7], response[2 * 64], one = 1;
    assert_in_range(trk_model_count(model, TRK_PART_SENSOR), 1, 64);
    REFUSED(c, trk_modes_create_undamped(c, NULL, NULL, &modes));
    REFUSED(c, trk_modes_create_undamped(c, model, NULL, NULL));
    REFUSED(c, trk_modes_create_damped(c, NULL, NULL, NULL, &modes));
    REFUSED(c, trk_modes_create_damped(c, model, NULL, NULL, NULL));
    REFUSED(c, trk_frequency_response(c, NULL, NULL, NULL, 1, &one, NULL, NULL, NULL, response));
    REFUSED(c, trk_frequency_response(c, model, NULL, NULL, 1, NULL, NULL, NULL, NULL, response));
    REFUSED(c, trk_frequency_response(c, model, NULL, NULL, 1, &one, NULL, NULL, NULL, NULL));
    assert_int_not_equal(trk_modes_create_undamped(NULL, model, NULL, &modes), TRK_OK);
    for (int n = 0; n < NUMBERS; n++) {
        const double two[] = {1, bad_numbers[n]};
        q[3] = bad_numbers[n];
        if (WORKED(c, trk_modes_create_undamped(c, model, q, &modes)))
            trk_modes_destroy(modes);
        if (WORKED(c, trk_modes_create_damped(c, model, q, q, &modes)))
            trk_modes_destroy(modes);
        (void)WORKED(
            c, trk_frequency_response(c, model, q, NULL, 1, &one, NULL, NULL, NULL, response));
        (void)WORKED(
            c, trk_frequency_response(c, model, NULL, q, 1, &one, NULL, NULL, NULL, response));
        (void)WORKED(
            c, trk_frequency_response(c, model, NULL, NULL, 1, two + 1, two, NULL, NULL, response));
        (void)WORKED(
            c, trk_frequency_response(c, model, NULL, NULL, 1, &one, two, NULL, NULL, response));
        (void)WORKED(
            c, trk_frequency_response(c, model, NULL, NULL, 1, &one, two, two, NULL, response));
        (void)WORKED(
            c, trk_frequency_response(c, model, NULL, NULL, 1, &one, two, NULL, two, response));
    }
    if (trk_has_feature(TRK_FEATURE_LAPACK)) {
        assert_ok(c, trk_modes_create_undamped(c, model, NULL, &modes));
        for (int k = 0; k < IDS; k++) {
            assert_true(isnan(trk_modes_frequency(modes, bad_ids[k])));
            assert_true(isnan(trk_modes_damped_frequency(modes, bad_ids[k])));
            assert_true(isnan(trk_modes_damping_ratio(modes, bad_ids[k])));
            assert_null(trk_modes_label(modes, bad_ids[k]));
            assert_int_equal(trk_modes_dominant(modes, bad_ids[k]), 0);
            assert_int_not_equal(trk_modes_get_shape(modes, bad_ids[k], row, row), TRK_OK);
            assert_int_not_equal(trk_modes_get_energy(modes, bad_ids[k], row), TRK_OK);
        }
        assert_int_not_equal(trk_modes_get_energy(modes, 1, NULL), TRK_OK);
        assert_int_equal(trk_modes_get_shape(modes, 1, NULL, NULL), TRK_OK);
        trk_modes_destroy(modes);
    }
    assert_int_equal(trk_modes_count(NULL), 0);
    assert_true(isnan(trk_modes_frequency(NULL, 1)));
    assert_null(trk_modes_label(NULL, 1));
    trk_modes_destroy(NULL);
    trk_model_destroy(model);
}

/* ---- simulate -------------------------------------------------------------------------------- */

static void simulations(void **state)
{
    trk_context *c = *state;
    trk_model *model = make_model(c, TRK_VEHICLE_REFERENCE_FRONT);
    trk_excitation *x;
    trk_series *out;
    assert_ok(c, trk_excitation_create(c, model, &x));
    trk_simulate_options options;
    for (int n = 0; n < NUMBERS; n++)
        for (int place = 0; place < 4; place++) {
            const double initial[] = {0, bad_numbers[n]};
            trk_simulate_options_init(&options, sizeof options);
            options.duration = place == 0 ? bad_numbers[n] : 0.01;
            options.start = place == 1 ? bad_numbers[n] : 0;
            options.initial_q = place == 2 ? initial : NULL;
            options.initial_velocity = place == 3 ? initial : NULL;
            if (WORKED(c, trk_simulate(c, model, x, NULL, &options, NULL, NULL, &out)))
                trk_series_destroy(out);
            else
                assert_null(out);
        }
    trk_simulate_options_init(&options, sizeof options);
    options.duration = 9e11; /* fewer steps than 1e15, but more than any memory holds */
    REFUSED(c, trk_simulate(c, model, x, NULL, &options, NULL, NULL, &out));
    options.duration = 0.01;
    options.record_every = INT64_MAX;
    assert_ok(c, trk_simulate(c, model, x, NULL, &options, NULL, NULL, &out));
    assert_int_equal(trk_series_samples(out), 1);
    trk_series_destroy(out);
    options.record_every = INT64_MIN;
    REFUSED(c, trk_simulate(c, model, x, NULL, &options, NULL, NULL, &out));
    trk_simulate_options_init(NULL, 8);
    trk_excitation_destroy(x);
    trk_model_destroy(model);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(curves),
        TEST(signals),
        TEST(series),
        TEST(vehicle_ids),
        TEST(vehicle_parameters),
        TEST(spec_fields),
        TEST(model_questions),
        TEST(excitations),
        TEST(stepper_numbers),
        TEST(stepper_keeps_its_state),
        TEST(stepper_pointers),
        TEST(linear_analysis),
        TEST(simulations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
