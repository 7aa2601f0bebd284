/* SPDX-License-Identifier: MIT */
/* Limits, progress, repetition, starts, bounds, memory, and the answer put into a spec. Needs NLOPT, Needs LAPACK */
#include "fit.h"

static trk_calibration *tires(trk_context *context, double front, double rear)
{
    trk_calibration *c = fit_create(context, TRK_VEHICLE_REFERENCE_HALF);
    fit_stiffness(context, c, "front_tire");
    fit_stiffness(context, c, "rear_tire");
    fit_mode(context, c, "front_axle.z", front);
    fit_mode(context, c, "rear_axle.z", rear);
    return c;
}

typedef struct watch {
    int calls, stop_at;
    double last;
} watch;

static int32_t look(void *user, double fraction)
{
    watch *w = user;
    assert_true(fraction >= w->last && fraction <= 1);
    w->last = fraction;
    return ++w->calls == w->stop_at;
}

static void progress_and_cancel(void **state)
{
    trk_calibration *c = tires(*state, 8, 6);
    watch w = {0};
    trk_solve_options o;
    trk_solve_options_init(&o, sizeof o);
    o.starts = 3;
    assert_ok(*state, trk_calibration_solve(c, &o, look, &w));
    assert_true(w.calls > 20);
    for (int k = 1; k < w.calls; k += 5) {
        watch cancel = {0, k, 0};
        trk_status status = trk_calibration_solve(c, &o, look, &cancel);
        assert_int_equal(status, TRK_E_CANCELLED);
        assert_int_equal(cancel.calls, k);
    }
    trk_calibration_destroy(c);
}

static void limits(void **state)
{
    trk_calibration *c = tires(*state, 8, 6);
    trk_solve_options o;
    trk_solve_options_init(&o, sizeof o);
    o.max_evaluations = 3;
    assert_status(*state, trk_calibration_solve(c, &o, NULL, NULL), TRK_E_LIMIT);
    assert_message(*state, "limit of evaluations");
    assert_int_equal(trk_calibration_evaluations(c), 5); /* and one before, one to judge */
    trk_solve_options_init(&o, sizeof o);
    o.max_time = 1e-9;
    assert_status(*state, trk_calibration_solve(c, &o, NULL, NULL), TRK_E_LIMIT);
    trk_calibration_destroy(c);
}

static void same_again(void **state)
{
    trk_parameter_result first[2], second[2];
    double jacobian[2][4], singular[2][2];
    for (int k = 0; k < 2; k++) {
        trk_calibration *c = tires(*state, 8, 6);
        trk_solve_options o;
        trk_solve_options_init(&o, sizeof o);
        o.starts = 4;
        assert_ok(*state, trk_calibration_solve(c, &o, NULL, NULL));
        for (int j = 0; j < 2; j++) {
            trk_parameter_result *r = k ? &second[j] : &first[j];
            memset(r, 0, sizeof *r);
            r->struct_size = sizeof *r;
            assert_ok(*state, trk_calibration_get_parameter(c, j + 1, r));
        }
        assert_ok(*state, trk_calibration_get_jacobian(c, jacobian[k], singular[k]));
        assert_true(singular[k][0] >= singular[k][1] && singular[k][1] > 0);
        trk_calibration_destroy(c);
    }
    assert_memory_equal(first, second, sizeof first);
    assert_memory_equal(jacobian[0], jacobian[1], sizeof jacobian[0]);
}

static void two_answers(void **state)
{
    for (int starts = 1; starts <= 8; starts += 7) {
        trk_calibration *c = fit_create(*state, TRK_VEHICLE_REFERENCE_FRONT);
        fit_stiffness(*state, c, "tire");
        fit_stiffness(*state, c, "spring");
        fit_mode(*state, c, "unsprung.z", 8);
        fit_mode(*state, c, "sprung.z", 1.45);
        trk_solve_options o;
        trk_solve_options_init(&o, sizeof o);
        o.starts = starts;
        assert_status(*state, trk_calibration_solve(c, &o, NULL, NULL), TRK_E_IDENTIFY);
        assert_message(*state, "more than one set");
        trk_calibration_destroy(c);
    }
}

static void apply_by_name(void **state)
{
    trk_context *context = *state;
    trk_calibration *c = tires(context, 8, 6);
    assert_ok(context, trk_calibration_solve(c, NULL, NULL, NULL));
    trk_spec *spec = support_spec(context, SUPPORT_HALF_CAR, 0),
             *quarter = support_spec(context, TRK_VEHICLE_REFERENCE_FRONT, 0);
    assert_ok(context, trk_calibration_apply(c, spec));
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    assert_ok(context,
              trk_spec_get_link(spec, trk_spec_find(spec, TRK_PART_LINK, "front_tire"), &link));
    assert_near(link.stiffness, 817500 * fit_fitted(c, 1), 1e-6);
    assert_status(context, trk_calibration_apply(c, quarter), TRK_E_NAME);
    assert_message(context, "has no link 'front_tire'");
    trk_spec_destroy(spec);
    trk_spec_destroy(quarter);
    trk_calibration_destroy(c);
}

/* All there is, within one block of memory calls. */
static trk_status all_of_it(trk_context *context)
{
    trk_spec *spec = NULL;
    trk_calibration *c = NULL;
    static const double frequency[] = {1, 8}, magnitude[] = {1, 1};
    int32_t id;
    trk_target_options mode, curve;
    trk_target_options_init(&mode, sizeof mode);
    mode.coordinate = "unsprung.z";
    mode.value = 7.5;
    trk_target_options_init(&curve, sizeof curve);
    curve.kind = TRK_TARGET_RESPONSE_CURVE;
    curve.sensor = "sprung_z";
    curve.count = 2;
    curve.frequency = frequency;
    curve.magnitude = magnitude;
    curve.uncertainty = 10;
    trk_status status = trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_FRONT, 0, &spec);
    if (status == TRK_OK)
        status = trk_calibration_create(context, spec, NULL, &c);
    if (status == TRK_OK)
        status = trk_calibration_add_parameter(c, "tire", NULL, &id);
    if (status == TRK_OK)
        status = trk_calibration_act_on(c, 1, TRK_FIELD_STIFFNESS, "tire", 1, NULL);
    if (status == TRK_OK)
        status = trk_calibration_add_target(c, "hop", &mode, NULL);
    if (status == TRK_OK)
        status = trk_calibration_add_target(c, "response", &curve, NULL);
    if (status == TRK_OK) {
        trk_solve_options o;
        trk_solve_options_init(&o, sizeof o);
        o.max_evaluations = 2;
        status = trk_calibration_solve(c, &o, NULL, NULL);
        if (status == TRK_E_LIMIT)
            status = trk_calibration_apply(c, spec);
    }
    trk_calibration_destroy(c);
    trk_spec_destroy(spec);
    return status;
}

static void memory(void **state)
{
    (void)state;
    support_exhaust_memory(all_of_it);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(progress_and_cancel), cmocka_unit_test(limits),
        cmocka_unit_test(same_again),          cmocka_unit_test(two_answers),
        cmocka_unit_test(apply_by_name),       cmocka_unit_test(memory)};
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
