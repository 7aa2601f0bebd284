/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. The explicit stepper: order, energy, both paths alike, repeats, errors, memory. */
#include "support.h"
#include "vehicles.h"

#include "rungekutta/rungekutta.h"

#include <truckride/newmark.h>

enum { MAX = 32, WHEELS = 8 };

static trk_rungekutta *create(trk_context *context, const trk_model *model, double step)
{
    trk_rungekutta *stepper;
    trk_rungekutta_options options;
    trk_rungekutta_options_init(&options, sizeof options);
    options.step = step;
    assert_ok(context, trk_rungekutta_create(context, model, &options, &stepper));
    return stepper;
}

/* Over the uneven road with loads, for `steps` steps from level ground. */
static trk_status drive(trk_rungekutta *stepper, int64_t steps)
{
    const trk_model *model = stepper->model;
    int32_t roads = trk_model_count(model, TRK_PART_ROAD);
    int32_t ports = trk_model_count(model, TRK_PART_PORT);
    double height[2][WHEELS], velocity[2][WHEELS], load[2][WHEELS], h = stepper->step;
    trk_status status = TRK_OK;
    for (int64_t k = 0; k < steps && status == TRK_OK; k++) {
        for (int i = 0; i < 2; i++) {
            double t = trk_rungekutta_time(stepper) + h / (2 - i);
            support_road(t, roads, height[i], velocity[i]);
            support_load(t, ports, load[i]);
        }
        status = trk_rungekutta_step(stepper, height[0], velocity[0], load[0], height[1],
                                     velocity[1], load[1]);
    }
    return status;
}

static void end_state(trk_context *context, const trk_model *model, double step, bool modal,
                      double *q)
{
    trk_rungekutta *stepper = create(context, model, step);
    if (!modal) {
        trk_explicit_destroy(stepper->modal);
        stepper->modal = NULL;
        assert_ok(context, trk_rungekutta_set_state(stepper, 0, NULL, NULL, NULL, NULL, NULL));
    }
    assert_ok(context, drive(stepper, (int64_t)(1.6 / step + 0.5)));
    trk_rungekutta_get_state(stepper, q, NULL, NULL);
    trk_rungekutta_destroy(stepper);
}

static void test_order_four(void **state)
{
    for (trk_vehicle vehicle = 2; vehicle <= SUPPORT_VEHICLES; vehicle++) {
        trk_model *model = support_model(*state, vehicle, TRK_VARIANT_LINEAR, 0);
        int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
        double q[4][MAX], error[3] = {0};
        for (int k = 0; k < 4; k++)
            end_state(*state, model, 0.008 / (1 << k), true, q[k]);
        for (int k = 0; k < 3; k++)
            for (int32_t i = 0; i < n; i++)
                error[k] = fmax(error[k], fabs(q[k][i] - q[k + 1][i]));
        print_message("%s: order %.3f\n", support_vehicle_name(vehicle), log2(error[1] / error[2]));
        assert_near(log2(error[1] / error[2]), 4, 0.1);
        trk_model_destroy(model);
    }
}

static void test_modal_equals_general(void **state)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++)
        for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++)
            for (int gravity = 0; gravity < 2; gravity++) {
                trk_model *model =
                    support_model(*state, vehicle, variant, gravity * TRK_STANDARD_GRAVITY);
                int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
                double fast[MAX], plain[MAX], largest = 0;
                end_state(*state, model, 1e-3, true, fast);
                end_state(*state, model, 1e-3, false, plain);
                for (int32_t i = 0; i < n; i++)
                    largest = fmax(largest, fabs(plain[i]));
                for (int32_t i = 0; i < n; i++)
                    assert_near(fast[i], plain[i], 1e-10 * largest);
                trk_model_destroy(model);
            }
}

/* All kernels that this processor has do the same up to rounding. */
static void test_kernels_agree(void **state)
{
    trk_explicit_kernel kernels[] = {trk_explicit_kernel_base, trk_explicit_choose_kernel(),
                                     trk_explicit_kernel_base};
#ifdef __x86_64__
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        kernels[2] = trk_explicit_kernel_avx2;
#endif
    for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++) {
        trk_model *model = support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, variant, 0);
        double q[3][MAX];
        for (int k = 0; k < 3; k++) {
            trk_rungekutta *stepper = create(*state, model, 1e-3);
            stepper->kernel = kernels[k];
            assert_ok(*state, drive(stepper, 1000));
            trk_rungekutta_get_state(stepper, q[k], NULL, NULL);
            trk_rungekutta_destroy(stepper);
        }
        for (int32_t i = 0; i < 13; i++) {
            assert_near(q[0][i], q[1][i], 1e-13);
            assert_near(q[0][i], q[2][i], 1e-13);
        }
        trk_model_destroy(model);
    }
}

/* A spring curve on a link that stands on the road: shift, rest and offset all count. */
static void test_curves_on_the_road(void **state)
{
    static const double x[] = {-0.1, -0.02, 0, 0.03, 0.1}, y[] = {-9e3, -1e3, 0, 2e3, 8e3};
    trk_curve *curve;
    trk_spec *spec;
    trk_body_options body;
    trk_link_options link;
    trk_model *model;
    assert_ok(*state, trk_curve_create(*state, "tire", 5, x, y, NULL, &curve));
    assert_ok(*state, trk_spec_create(*state, "wheel", &spec));
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    body.mass = 40;
    assert_ok(*state, trk_spec_add_body(spec, "wheel", &body, &link.to_body));
    assert_ok(*state, trk_spec_add_road(spec, "road", 0, 0, &link.from_road));
    link.spring_curve = link.damper_curve = curve;
    link.spring_offset = -0.01;
    link.spring_scale = 2;
    link.damper_scale = 0.1;
    link.stiffness = 3e3;
    link.damping = 11;
    assert_ok(*state, trk_spec_add_link(spec, "tire", &link, NULL));
    assert_ok(*state, trk_model_compile(*state, spec, NULL, &model));
    double fast, plain;
    end_state(*state, model, 1e-3, true, &fast);
    end_state(*state, model, 1e-3, false, &plain);
    assert_true(fabs(plain) > 1e-4);
    assert_near(fast, plain, 1e-14);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    trk_curve_destroy(curve);
}

/* Free vibration loses (omega h)^6 / 72 of its energy in a step, and nothing else. */
static void test_energy(void **state)
{
    trk_model *model = support_oscillator(*state, 2, 800, 0); /* omega = 20 */
    const double q0 = 0.1, h = 0.01;
    double q, v;
    trk_rungekutta *stepper = create(*state, model, h);
    assert_ok(*state, trk_rungekutta_set_state(stepper, 0, &q0, NULL, NULL, NULL, NULL));
    for (int k = 0; k < 1000; k++)
        assert_ok(*state, trk_rungekutta_step(stepper, NULL, NULL, NULL, NULL, NULL, NULL));
    trk_rungekutta_get_state(stepper, &q, &v, NULL);
    double x = 20 * h, energy = (q * q + v * v / 400) / (q0 * q0);
    assert_near(log(energy), 1000 * log(1 - pow(x, 6) / 72 + pow(x, 8) / 576), 1e-12);
    trk_rungekutta_destroy(stepper);
    trk_model_destroy(model);
}

static void test_state_and_sensors(void **state)
{
    trk_model *model =
        support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_NONLINEAR, 9.81);
    trk_rungekutta *stepper = create(*state, model, 1e-3);
    trk_newmark *newmark;
    assert_ok(*state, trk_newmark_create(*state, model, NULL, &newmark));
    double q[MAX], v[MAX], height[WHEELS], velocity[WHEELS], ours[256], theirs[256];
    for (int i = 0; i < MAX; i++) {
        q[i] = -0.1 + 0.003 * i;
        v[i] = 0.2 - 0.02 * i;
    }
    support_road(0.7, 4, height, velocity);
    assert_ok(*state, trk_rungekutta_set_state(stepper, 3, q, v, height, velocity, NULL));
    assert_ok(*state, trk_newmark_set_state(newmark, 3, q, v, height, velocity, NULL));
    assert_true(trk_rungekutta_time(stepper) == 3 && trk_rungekutta_step_size(stepper) == 1e-3);
    trk_rungekutta_read_sensors(stepper, ours);
    trk_newmark_read_sensors(newmark, theirs);
    for (int32_t k = 0; k < trk_model_count(model, TRK_PART_SENSOR); k++)
        assert_near(ours[k], theirs[k], 1e-11 * (1 + fabs(theirs[k])));
    double e[2][64], rate[2][64], force[2][64];
    trk_rungekutta_get_links(stepper, e[0], rate[0], force[0]);
    trk_newmark_get_links(newmark, e[1], rate[1], force[1]);
    for (int32_t k = 0; k < trk_model_count(model, TRK_PART_LINK); k++) {
        assert_near(e[0][k], e[1][k], 1e-13);
        assert_near(rate[0][k], rate[1][k], 1e-12);
        assert_near(force[0][k], force[1][k], 1e-11 * (1e3 + fabs(force[1][k])));
    }
    trk_newmark_destroy(newmark);
    trk_rungekutta_destroy(stepper);
    trk_model_destroy(model);
}

static void test_repeats_bit_by_bit_without_memory(void **state)
{
    support_memory memory = {0, 0, 0};
    trk_context *context;
    (void)state;
    assert_int_equal(trk_context_create(support_allocate, &memory, &context), TRK_OK);
    trk_model *model =
        support_model(context, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_NONLINEAR, 0);
    double q[2][MAX];
    for (int modal = 0; modal < 2; modal++)
        for (int k = 0; k < 2; k++) {
            trk_rungekutta *stepper = create(context, model, 1e-3);
            if (!modal) {
                trk_explicit_destroy(stepper->modal);
                stepper->modal = NULL;
            }
            if (k == 1) { /* a past that the second run must not remember */
                assert_ok(context, drive(stepper, 333));
                assert_ok(context,
                          trk_rungekutta_set_state(stepper, 0, NULL, NULL, NULL, NULL, NULL));
            }
            int64_t before = memory.calls;
            assert_ok(context, drive(stepper, 2000));
            assert_int_equal(memory.calls, before);
            trk_rungekutta_get_state(stepper, q[k], NULL, NULL);
            trk_rungekutta_destroy(stepper);
            if (k == 1)
                assert_memory_equal(q[0], q[1], 13 * sizeof(double));
        }
    trk_model_destroy(model);
    trk_context_destroy(context);
    assert_int_equal(memory.live, 0);
}

static void test_bad_inputs_leave_the_state(void **state)
{
    trk_model *model =
        support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, 0);
    trk_rungekutta *stepper = create(*state, model, 1e-3);
    double before[MAX], after[MAX], bad[MAX] = {0, INFINITY}, huge[MAX] = {1e308, 1e308};
    assert_ok(*state, drive(stepper, 100));
    trk_rungekutta_get_state(stepper, before, NULL, NULL);
    const double *arguments[6][6] = {{bad},          {NULL, bad},       {0, 0, bad},
                                     {0, 0, 0, bad}, {0, 0, 0, 0, bad}, {0, 0, 0, 0, 0, bad}};
    for (int k = 0; k < 6; k++) {
        const double *const *a = arguments[k];
        assert_status(*state, trk_rungekutta_step(stepper, a[0], a[1], a[2], a[3], a[4], a[5]),
                      TRK_E_RANGE);
        assert_message(*state, "is inf");
    }
    assert_status(*state, trk_rungekutta_step(stepper, huge, NULL, NULL, huge, huge, NULL),
                  TRK_E_RANGE);
    assert_message(*state, "left the range");
    assert_status(*state, trk_rungekutta_set_state(stepper, NAN, NULL, NULL, NULL, NULL, NULL),
                  TRK_E_RANGE);
    assert_status(*state, trk_rungekutta_set_state(stepper, 0, bad, NULL, NULL, NULL, NULL),
                  TRK_E_RANGE);
    assert_status(*state, trk_rungekutta_set_state(stepper, 0, NULL, bad, NULL, NULL, NULL),
                  TRK_E_RANGE);
    assert_status(*state, trk_rungekutta_set_state(stepper, 0, NULL, NULL, huge, huge, NULL),
                  TRK_E_RANGE);
    trk_rungekutta_get_state(stepper, after, NULL, NULL);
    assert_memory_equal(before, after, 13 * sizeof(double));
    assert_near(trk_rungekutta_time(stepper), 0.1, 1e-15);
    assert_ok(*state, drive(stepper, 100));
    trk_rungekutta *fresh = create(*state, model, 1e-3);
    assert_ok(*state, drive(fresh, 200));
    trk_rungekutta_get_state(stepper, before, NULL, NULL);
    trk_rungekutta_get_state(fresh, after, NULL, NULL);
    assert_memory_equal(before, after, 13 * sizeof(double));
    trk_rungekutta_destroy(fresh);
    trk_rungekutta_destroy(stepper);
    trk_model_destroy(model);
}

static void test_options(void **state)
{
    static const double bad[] = {0, -1, NAN, INFINITY};
    trk_model *model = support_oscillator(*state, 1, 1, 0);
    trk_rungekutta *stepper;
    struct {
        trk_rungekutta_options options;
        double unknown;
    } newer = {.unknown = 1};
    trk_rungekutta_options_init(&newer.options, sizeof newer.options);
    for (int k = 0; k < 4; k++) {
        trk_rungekutta_options options = newer.options;
        options.step = bad[k];
        assert_status(*state, trk_rungekutta_create(*state, model, &options, &stepper),
                      TRK_E_RANGE);
        assert_message(*state, "step is");
        assert_null(stepper);
    }
    newer.options.struct_size = sizeof newer;
    assert_status(*state, trk_rungekutta_create(*state, model, &newer.options, &stepper),
                  TRK_E_OPTIONS);
    assert_status(*state, trk_rungekutta_create(*state, NULL, NULL, &stepper), TRK_E_ARGUMENT);
    assert_status(*state, trk_rungekutta_create(NULL, model, NULL, &stepper), TRK_E_ARGUMENT);
    assert_status(*state, trk_rungekutta_create(*state, model, NULL, NULL), TRK_E_ARGUMENT);
    double x = 7;
    assert_int_equal(trk_rungekutta_step(NULL, &x, &x, &x, &x, &x, &x), TRK_E_ARGUMENT);
    assert_int_equal(trk_rungekutta_set_state(NULL, 0, &x, &x, &x, &x, &x), TRK_E_ARGUMENT);
    assert_true(isnan(trk_rungekutta_time(NULL)) && isnan(trk_rungekutta_step_size(NULL)));
    trk_rungekutta_get_state(NULL, &x, &x, &x);
    trk_rungekutta_get_links(NULL, &x, &x, &x);
    trk_rungekutta_read_sensors(NULL, &x);
    assert_true(x == 7);
    trk_rungekutta_destroy(NULL);
    trk_model_destroy(model);
}

static trk_status create_in_little_memory(trk_context *context)
{
    static const double x[] = {-1, 0, 1}, y[] = {-2e3, 0, 1e3};
    trk_curve *curve = NULL;
    trk_spec *spec = NULL;
    trk_model *model = NULL;
    trk_rungekutta *stepper = NULL;
    trk_body_options body;
    trk_link_options link;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    body.mass = 10;
    trk_status status = trk_curve_create(context, "damper", 3, x, y, NULL, &curve);
    if (status == TRK_OK)
        status = trk_spec_create(context, "oscillator", &spec);
    if (status == TRK_OK)
        status = trk_spec_add_body(spec, "mass", &body, &link.to_body);
    link.stiffness = 1e3;
    link.damper_curve = curve;
    if (status == TRK_OK)
        status = trk_spec_add_link(spec, "strut", &link, NULL);
    if (status == TRK_OK)
        status = trk_model_compile(context, spec, NULL, &model);
    if (status == TRK_OK)
        status = trk_rungekutta_create(context, model, NULL, &stepper);
    trk_rungekutta_destroy(stepper);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    trk_curve_destroy(curve);
    return status;
}

static void test_lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(create_in_little_memory);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_order_four, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_modal_equals_general, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_kernels_agree, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_curves_on_the_road, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_energy, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_state_and_sensors, support_setup, support_teardown),
        cmocka_unit_test(test_repeats_bit_by_bit_without_memory),
        cmocka_unit_test_setup_teardown(test_bad_inputs_leave_the_state, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(test_options, support_setup, support_teardown),
        cmocka_unit_test(test_lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
