/* SPDX-License-Identifier: MIT */
/* A run is its stepper called sample by sample; progress, cancelling, refusals, lack of memory. */
#include "support.h"

#include <truckride/simulate.h>
#include <truckride/vehicle.h>

typedef struct fixture {
    trk_model *model;
    trk_signal *step;
    trk_excitation *excitation;
    trk_simulate_options options;
} fixture;

static fixture setup(trk_context *context, trk_vehicle vehicle)
{
    fixture f;
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_builtin(context, vehicle, TRK_VARIANT_NONLINEAR, &spec));
    assert_ok(context, trk_model_compile(context, spec, NULL, &f.model));
    trk_spec_destroy(spec);
    assert_ok(context, trk_signal_create_step(context, 0.05, 0.1, 0.02, &f.step));
    assert_ok(context, trk_excitation_create(context, f.model, &f.excitation));
    assert_ok(context, trk_excitation_add_motion(f.excitation, TRK_ROAD_ALL, f.step, 1, 0));
    trk_simulate_options_init(&f.options, sizeof f.options);
    f.options.duration = 0.5;
    return f;
}

static void clear(fixture *f)
{
    trk_excitation_destroy(f->excitation);
    trk_signal_destroy(f->step);
    trk_model_destroy(f->model);
}

static trk_series *run(trk_context *context, const fixture *f)
{
    trk_series *series;
    assert_ok(context, trk_simulate(context, f->model, f->excitation, NULL, &f->options, NULL, NULL,
                                    &series));
    return series;
}

static void equals_the_stepper_driven_by_hand(void **state)
{
    fixture f = setup(*state, TRK_VEHICLE_REFERENCE_HALF);
    f.options.start = -0.25;
    f.options.duration = 0.75;
    trk_series *series = run(*state, &f);
    int32_t sensors = trk_model_count(f.model, TRK_PART_SENSOR);
    assert_int_equal(trk_series_channels(series), sensors);
    assert_int_equal(trk_series_samples(series), 751);
    assert_near(trk_series_rate(series), 1000, 1e-9);
    assert_near(trk_series_start(series), -0.25, 0);
    trk_newmark *stepper;
    assert_ok(*state, trk_newmark_create(*state, f.model, NULL, &stepper));
    double values[64], height[2], velocity[2], load[2];
    assert_in_range(sensors, 1, 64);
    trk_excitation_evaluate(f.excitation, 1, -0.25, 0, height, velocity, load);
    assert_ok(*state, trk_newmark_set_state(stepper, -0.25, NULL, NULL, height, velocity, load));
    for (int64_t k = 0; k <= 750; k++) {
        if (k > 0) {
            trk_excitation_evaluate(f.excitation, 1, -0.25 + (double)k * 1e-3, 0, height, velocity,
                                    load);
            assert_ok(*state, trk_newmark_step(stepper, height, velocity, load));
        }
        trk_newmark_read_sensors(stepper, values);
        for (int32_t s = 1; s <= sensors; s++)
            assert_near(trk_series_data(series, s)[k], values[s - 1],
                        1e-9 * (1 + fabs(values[s - 1])));
    }
    for (int32_t s = 1; s <= sensors; s++) {
        assert_string_equal(trk_series_name(series, s),
                            trk_model_part_name(f.model, TRK_PART_SENSOR, s));
        assert_string_equal(trk_series_unit(series, s),
                            trk_model_unit(f.model, TRK_PART_SENSOR, s));
    }
    trk_newmark_destroy(stepper);
    trk_series_destroy(series);
    clear(&f);
}

static void record_every_picks_the_same_samples(void **state)
{
    static const int64_t every[] = {2, 7, 256, 300, 500, 501, 1000000};
    fixture f = setup(*state, TRK_VEHICLE_REFERENCE_FRONT);
    trk_series *all = run(*state, &f);
    for (size_t e = 0; e < sizeof every / sizeof *every; e++) {
        f.options.record_every = every[e];
        trk_series *some = run(*state, &f);
        assert_int_equal(trk_series_samples(some), 500 / every[e] + 1);
        assert_near(trk_series_rate(some), 1000.0 / (double)every[e], 1e-9);
        for (int32_t s = 1; s <= trk_series_channels(all); s++)
            for (int64_t k = 0; k < trk_series_samples(some); k++)
                assert_near(trk_series_data(some, s)[k], trk_series_data(all, s)[k * every[e]], 0);
        trk_series_destroy(some);
    }
    trk_series_destroy(all);
    clear(&f);
}

static void long_run_has_all_samples(void **state)
{
    fixture f = setup(*state, TRK_VEHICLE_THESIS_QUARTER);
    f.options.duration = 480;
    trk_series *series = run(*state, &f);
    assert_int_equal(trk_series_samples(series), 480001);
    const double *force = trk_series_data(series, trk_series_find(series, "tire_force"));
    assert_near(force[480000], 0, 1e-3); /* the step is forgotten */
    trk_series_destroy(series);
    clear(&f);
}

static void initial_state_is_used(void **state)
{
    fixture f = setup(*state, TRK_VEHICLE_THESIS_QUARTER);
    const double q[] = {0.01, -0.002}, v[] = {0.3, -0.2};
    f.options.initial_q = q;
    f.options.initial_velocity = v;
    trk_series *series = run(*state, &f);
    /* Tire: 1e6 N/m, 500 N s/m under the unsprung mass. */
    assert_near(trk_series_data(series, trk_series_find(series, "tire_force"))[0], -2000 - 100,
                1e-9);
    trk_series_destroy(series);
    clear(&f);
}

typedef struct listener {
    int calls, cancel_at;
    double last;
} listener;

static int32_t listen(void *user, double fraction)
{
    listener *l = user;
    assert_true(fraction >= 0 && fraction <= 1);
    assert_true(l->calls == 0 || fraction > l->last);
    l->last = fraction;
    return ++l->calls == l->cancel_at;
}

static void progress_rises_to_one(void **state)
{
    static const double duration[] = {0.001, 0.5, 30, 60};
    static const int fewest[] = {2, 3, 60, 80}, most[] = {2, 3, 130, 130};
    fixture f = setup(*state, TRK_VEHICLE_THESIS_QUARTER);
    for (int k = 0; k < 4; k++) {
        listener l = {0, 0, 0};
        trk_series *series;
        f.options.duration = duration[k];
        assert_ok(*state, trk_simulate(*state, f.model, f.excitation, NULL, &f.options, listen, &l,
                                       &series));
        assert_in_range(l.calls, fewest[k], most[k]);
        assert_near(l.last, 1, 0);
        trk_series_destroy(series);
    }
    clear(&f);
}

static void cancelling_leaves_nothing(void **state)
{
    fixture f = setup(*state, TRK_VEHICLE_THESIS_QUARTER);
    f.options.duration = 10;
    int64_t blocks = trk_context_blocks(*state);
    for (int at = 1; at < 4; at++) {
        listener l = {0, at, 0};
        trk_series *series = (trk_series *)&f;
        assert_status(
            *state,
            trk_simulate(*state, f.model, f.excitation, NULL, &f.options, listen, &l, &series),
            TRK_E_CANCELLED);
        assert_null(series);
        assert_message(*state, "quarter car: run cancelled at t = ");
        assert_int_equal(trk_context_blocks(*state), blocks);
        assert_int_equal(l.calls, at);
    }
    clear(&f);
}

static void refuse(trk_context *context, const fixture *f, const trk_newmark_options *newmark,
                   trk_status status, const char *text)
{
    int64_t blocks = trk_context_blocks(context);
    trk_series *series = (trk_series *)&blocks;
    assert_status(
        context,
        trk_simulate(context, f->model, f->excitation, newmark, &f->options, NULL, NULL, &series),
        status);
    assert_null(series);
    assert_message(context, text);
    assert_int_equal(trk_context_blocks(context), blocks);
}

static void options_are_checked(void **state)
{
    fixture f = setup(*state, TRK_VEHICLE_THESIS_QUARTER);
    const trk_simulate_options good = f.options;
    const double bad[] = {NAN, 0};
#define WITH(change, status, text)                                                                 \
    f.options = good;                                                                              \
    f.options.change;                                                                              \
    refuse(*state, &f, NULL, status, text)
    WITH(duration = 0, TRK_E_RANGE, "trk_simulate_options: duration is 0 s");
    WITH(duration = -1, TRK_E_RANGE, "trk_simulate_options: duration is -1 s");
    WITH(duration = NAN, TRK_E_RANGE, "trk_simulate_options: duration is ");
    WITH(duration = 1e-4, TRK_E_RANGE,
         "trk_simulate_options: duration 0.0001 s is 0.1 steps of 0.001 s");
    WITH(duration = 1e300, TRK_E_RANGE, "1 to 1e15 are needed");
    WITH(start = INFINITY, TRK_E_RANGE, "trk_simulate_options: start is inf s");
    WITH(record_every = 0, TRK_E_RANGE, "trk_simulate_options: record_every is 0");
    WITH(record_every = -3, TRK_E_RANGE, "trk_simulate_options: record_every is -3");
    WITH(struct_size = 2, TRK_E_OPTIONS, "trk_simulate_options: struct_size is 2");
    WITH(initial_q = bad, TRK_E_RANGE, "quarter car: displacement of 'sprung.z' is ");
    WITH(initial_velocity = bad, TRK_E_RANGE, "quarter car: velocity of 'sprung.z' is ");
#undef WITH
    f.options = good;
    trk_newmark_options newmark;
    trk_newmark_options_init(&newmark, sizeof newmark);
    newmark.step = -1;
    refuse(*state, &f, &newmark, TRK_E_RANGE, "trk_newmark_options: step is -1 s");
    clear(&f);
}

static void objects_must_fit(void **state)
{
    fixture f = setup(*state, TRK_VEHICLE_THESIS_QUARTER),
            other = setup(*state, TRK_VEHICLE_REFERENCE_HALF);
    fixture mixed = f;
    mixed.excitation = other.excitation;
    refuse(*state, &mixed, NULL, TRK_E_ARGUMENT,
           "quarter car: the excitation has 2 roads and 2 ports, the model 1 and 0");
    mixed.excitation = NULL;
    refuse(*state, &mixed, NULL, TRK_E_ARGUMENT, "trk_simulate: excitation is NULL");
    mixed = f;
    mixed.model = NULL;
    refuse(*state, &mixed, NULL, TRK_E_ARGUMENT, "trk_simulate: model is NULL");
    trk_series *series;
    assert_status(*state, trk_simulate(*state, f.model, f.excitation, NULL, NULL, NULL, NULL, NULL),
                  TRK_E_ARGUMENT);
    assert_int_equal(trk_simulate(NULL, f.model, f.excitation, NULL, NULL, NULL, NULL, &series),
                     TRK_E_ARGUMENT);
    clear(&f);
    clear(&other);
}

static void a_model_without_sensors_is_refused(void **state)
{
    fixture f = {0};
    trk_spec *spec;
    assert_ok(*state, trk_spec_create(*state, "blind", &spec));
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    body.mass = 1;
    assert_ok(*state, trk_spec_add_body(spec, "b", &body, NULL));
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = 1;
    link.stiffness = 1;
    assert_ok(*state, trk_spec_add_link(spec, "k", &link, NULL));
    assert_ok(*state, trk_model_compile(*state, spec, NULL, &f.model));
    assert_ok(*state, trk_excitation_create(*state, f.model, &f.excitation));
    trk_simulate_options_init(&f.options, sizeof f.options);
    refuse(*state, &f, NULL, TRK_E_MODEL, "blind: the model has no sensor");
    trk_spec_destroy(spec);
    clear(&f);
}

static fixture shared;

static trk_status run_once(trk_context *context)
{
    trk_series *series = NULL;
    trk_status status = trk_simulate(context, shared.model, shared.excitation, NULL,
                                     &shared.options, NULL, NULL, &series);
    trk_series_destroy(series);
    return status;
}

static void lack_of_memory(void **state)
{
    shared = setup(*state, TRK_VEHICLE_REFERENCE_FRONT);
    shared.options.duration = 0.01;
    support_exhaust_memory(run_once);
    clear(&shared);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(equals_the_stepper_driven_by_hand),
        TEST(record_every_picks_the_same_samples),
        TEST(long_run_has_all_samples),
        TEST(initial_state_is_used),
        TEST(progress_rises_to_one),
        TEST(cancelling_leaves_nothing),
        TEST(options_are_checked),
        TEST(objects_must_fit),
        TEST(a_model_without_sensors_is_refused),
        TEST(lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
