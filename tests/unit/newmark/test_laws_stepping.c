/* SPDX-License-Identifier: MIT */
/* Steps with a law of every kind in the vehicle: energy, order, failure, allocation, sensors. */
#include "laws.h"
#include "support.h"
#include "vehicles.h"

#include "newmark/newmark.h"
#include <truckride/rungekutta.h>

static const double pi = 3.14159265358979323846;

static trk_model *every_law(trk_context *context, double gravity)
{
    trk_spec *spec = support_every_law(context);
    trk_model_options options;
    trk_model *model;
    trk_model_options_init(&options, sizeof options);
    options.gravity = gravity;
    assert_ok(context, trk_model_compile(context, spec, &options, &model));
    trk_spec_destroy(spec);
    return model;
}

static trk_newmark *stepper_on(trk_context *context, const trk_model *model, double step)
{
    trk_newmark_options options;
    trk_newmark *stepper;
    support_method(0, step, &options);
    options.tolerance = 1e-13;
    assert_ok(context, trk_newmark_create(context, model, &options, &stepper));
    return stepper;
}

/* Rough: the wheel lifts off, and both stops are hit. */
static void road(double t, double *height, double *velocity)
{
    double ramp = t < 1 ? (1 - cos(pi * t)) / 2 : 1, rise = t < 1 ? pi * sin(pi * t) / 2 : 0;
    double a = 2 * pi * 1.3, b = 2 * pi * 7.1;
    double wave = 0.05 * sin(a * t) + 0.03 * sin(b * t),
           rate = 0.05 * a * cos(a * t) + 0.03 * b * cos(b * t);
    *height = ramp * wave;
    *velocity = ramp * rate + rise * wave;
}

/* What kinetic energy, springs, laws and height have [J], and what dampers and laws burn [W]. */
static double energy(const trk_newmark *stepper, double *out_lost)
{
    const trk_model *model = stepper->model;
    double q[3], v[3], e[6], rate[6], mass[9], sum = 0;
    trk_newmark_get_state(stepper, q, v, NULL);
    trk_newmark_get_links(stepper, e, rate, NULL);
    trk_model_get_mass(model, mass);
    *out_lost = 0;
    for (int k = 0; k < 3; k++)
        sum += mass[4 * k] * (v[k] * v[k] / 2 + TRK_STANDARD_GRAVITY * q[k]);
    for (int k = 0; k < 6; k++) {
        const trk_link_law *link = &model->laws[k];
        const double *z = stepper->now.memory + model->memory[k];
        sum += link->stiffness * e[k] * e[k] / 2 + link->law->ops->stored(link->law, z, e[k]);
        *out_lost +=
            link->damping * rate[k] * rate[k] + link->law->ops->lost(link->law, z, e[k], rate[k]);
    }
    return sum;
}

/*
 * Work of the road = change of energy + loss. Work and loss are sums by the trapezoidal rule; the
 * error left is that of corners inside of steps, O(h).
 */
static void road_work_is_stored_or_lost(void **state)
{
    const double h = 1e-5, duration = 3;
    trk_model *model = every_law(*state, TRK_STANDARD_GRAVITY);
    trk_newmark *stepper = stepper_on(*state, model, h);
    double lost_before, lost, force[6], force_before,
        height_before = 0, before, work = 0, turnover = 0, burnt = 0, least_tire = -INFINITY,
        deepest = 0;
    before = energy(stepper, &lost_before);
    trk_newmark_get_links(stepper, NULL, NULL, force);
    force_before = force[0];
    for (int64_t k = 1; (double)k * h < duration; k++) {
        double height, velocity;
        road((double)k * h, &height, &velocity);
        assert_ok(*state, trk_newmark_step(stepper, &height, &velocity, NULL));
        energy(stepper, &lost);
        trk_newmark_get_links(stepper, NULL, NULL, force);
        double part = -(force[0] + force_before) / 2 * (height - height_before);
        work += part;
        turnover += fabs(part);
        burnt += (lost + lost_before) / 2 * h;
        least_tire = fmax(least_tire, force[0]);
        deepest = fmax(deepest, fabs(force[2]));
        lost_before = lost;
        force_before = force[0];
        height_before = height;
    }
    double change = energy(stepper, &lost) - before;
    print_message("tire %g N, stop %g N, work %.6g J, turnover %.6g J, change %.6g J, lost %.6g J, "
                  "off %.3g\n",
                  least_tire, deepest, work, turnover, change, burnt,
                  (work - change - burnt) / work);
    assert_true(least_tire > -1e-6 && deepest > 1000); /* lift-off and stops took part */
    assert_true(burnt > 0.8 * work);
    assert_near(work, change + burnt, 1e-6 * work);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
}

/* A smooth law with memory, the air spring, keeps second order. */
static double cab_after(trk_context *context, const trk_model *model, double h, double duration)
{
    trk_newmark *stepper = stepper_on(context, model, h);
    double q;
    for (int k = 1; k <= (int)(duration / h + 0.5); k++) {
        double t = k * h, height = 0.02 * (1 - cos(2 * pi * t)),
               velocity = 0.02 * 2 * pi * sin(2 * pi * t);
        assert_ok(context, trk_newmark_step(stepper, &height, &velocity, NULL));
    }
    trk_newmark_get_state(stepper, &q, NULL, NULL);
    trk_newmark_destroy(stepper);
    return q;
}

static void air_spring_keeps_second_order(void **state)
{
    trk_law *law = support_law(*state, TRK_LAW_AIR_SPRING);
    trk_spec *spec;
    trk_body_options body;
    trk_link_options link;
    trk_model *model;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    body.mass = 400;
    link.law = law;
    link.damping = 300;
    assert_ok(*state, trk_spec_create(*state, "cab", &spec));
    assert_ok(*state, trk_spec_add_road(spec, "frame", 0, 0, &link.from_road));
    assert_ok(*state, trk_spec_add_body(spec, "cab", &body, &link.to_body));
    assert_ok(*state, trk_spec_add_link(spec, "air", &link, NULL));
    assert_ok(*state, trk_model_compile(*state, spec, NULL, &model));
    const double fine = cab_after(*state, model, 1.25e-5, 1.28);
    double error[4];
    for (int k = 0; k < 4; k++)
        error[k] = fabs(cab_after(*state, model, 1.6e-3 / (1 << k), 1.28) - fine);
    for (int k = 0; k < 3; k++)
        assert_near(log2(error[k] / error[k + 1]), 2, 0.01);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    trk_law_destroy(law);
}

/* A step that fails leaves motion and memory: the run goes on as if it had not been tried. */
static void failure_changes_nothing(void **state)
{
    trk_model *model = every_law(*state, TRK_STANDARD_GRAVITY);
    trk_newmark_options options;
    trk_newmark *a, *b;
    support_method(0, 1e-3, &options);
    assert_ok(*state, trk_newmark_create(*state, model, &options, &a));
    assert_ok(*state, trk_newmark_create(*state, model, &options, &b));
    int64_t failures = 0;
    for (int k = 1; k <= 1500; k++) {
        double height, velocity, far = 1e7, qa[3], qb[3], fa[6], fb[6];
        road(k * 1e-3, &height, &velocity);
        if (k % 100 == 0) { /* an air spring pulled beyond its volume */
            trk_newmark_get_links(b, NULL, NULL, fa);
            failures += trk_newmark_step(b, &far, &far, NULL) != TRK_OK;
            trk_newmark_get_links(b, NULL, NULL, fb);
            assert_memory_equal(fa, fb, sizeof fa);
        }
        assert_ok(*state, trk_newmark_step(a, &height, &velocity, NULL));
        assert_ok(*state, trk_newmark_step(b, &height, &velocity, NULL));
        trk_newmark_get_state(a, qa, NULL, NULL);
        trk_newmark_get_state(b, qb, NULL, NULL);
        assert_memory_equal(qa, qb, sizeof qa);
    }
    assert_int_equal(failures, 15);
    trk_newmark_destroy(a);
    trk_newmark_destroy(b);
    trk_model_destroy(model);
}

/* Setting a state forgets: the run is that of a new stepper. */
static void setting_a_state_relaxes(void **state)
{
    trk_model *model = every_law(*state, TRK_STANDARD_GRAVITY);
    trk_newmark *stepper = stepper_on(*state, model, 1e-3);
    double q[2][3], force[6], still[6];
    trk_model_get_static(model, NULL, still);
    for (int run = 0; run < 2; run++) {
        assert_ok(*state, trk_newmark_set_state(stepper, 0, NULL, NULL, NULL, NULL, NULL));
        trk_newmark_get_links(stepper, NULL, NULL, force);
        for (int k = 0; k < 6; k++)
            assert_near(force[k], still[k], 1e-9);
        for (int k = 1; k <= 500; k++) {
            double height, velocity;
            road(k * 1e-3, &height, &velocity);
            assert_ok(*state, trk_newmark_step(stepper, &height, &velocity, NULL));
        }
        trk_newmark_get_state(stepper, q[run], NULL, NULL);
    }
    assert_memory_equal(q[0], q[1], sizeof q[0]);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
}

/* Allocation refused from the first step on: steps do not notice. */
static void steps_allocate_nothing(void **state)
{
    (void)state;
    support_memory memory = {0, 0, 0};
    trk_context *context;
    assert_int_equal(trk_context_create(support_allocate, &memory, &context), TRK_OK);
    trk_model *model = every_law(context, TRK_STANDARD_GRAVITY);
    trk_newmark *stepper = stepper_on(context, model, 1e-3);
    int64_t calls = memory.calls;
    for (int k = 1; k <= 3000; k++) {
        double height, velocity;
        road(k * 1e-3, &height, &velocity);
        assert_ok(context, trk_newmark_step(stepper, &height, &velocity, NULL));
    }
    assert_int_equal(memory.calls, calls);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
    trk_context_destroy(context);
    assert_int_equal(memory.live, 0);
}

/* Sensors, and rows with their matrices, show the forces of the links, laws included. */
static void sensors_show_the_laws(void **state)
{
    trk_model *model = every_law(*state, TRK_STANDARD_GRAVITY);
    trk_newmark *stepper = stepper_on(*state, model, 1e-3);
    assert_false(trk_newmark_set_kernel(stepper, TRK_KERNEL_PORTABLE)); /* no modal way with laws */
    int64_t width = trk_newmark_row_width(stepper);
    double *row = calloc((size_t)width, sizeof *row),
           *on_row = calloc((size_t)(4 * width), sizeof *on_row), on_height[4], on_velocity[4];
    assert_true(row && on_row);
    trk_newmark_get_sensor_rows(stepper, on_row, on_height, on_velocity);
    for (int k = 1; k <= 1500; k++) {
        double height, velocity, force[6], value[4], a[3];
        road(k * 1e-3, &height, &velocity);
        assert_ok(*state, trk_newmark_step(stepper, &height, &velocity, NULL));
        trk_newmark_get_links(stepper, NULL, NULL, force);
        trk_newmark_get_state(stepper, NULL, NULL, a);
        trk_newmark_read_sensors(stepper, value);
        assert_true(value[0] == force[0] && value[1] == force[1]);
        assert_true(value[2] == force[4] && value[3] == a[2]);
        trk_newmark_get_row(stepper, row);
        for (int s = 0; s < 4; s++) {
            double sum = on_height[s] * height + on_velocity[s] * velocity;
            for (int64_t i = 0; i < width; i++)
                sum += on_row[s * width + i] * row[i];
            assert_near(sum, value[s], 1e-8);
        }
    }
    free(row);
    free(on_row);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
}

static void explicit_steps_refuse(void **state)
{
    trk_model *model = every_law(*state, 0);
    trk_rungekutta *stepper;
    assert_status(*state, trk_rungekutta_create(*state, model, NULL, &stepper), TRK_E_UNSUPPORTED);
    assert_message(*state, "every law: link 'tire' has the law 'tire'");
    assert_message(*state, "trk_newmark");
    assert_null(stepper);
    trk_model_destroy(model);
}

static trk_status work(trk_context *context)
{
    trk_spec *spec = NULL;
    trk_model *model = NULL;
    trk_newmark *stepper = NULL;
    trk_leaf_options o;
    trk_law *law = NULL;
    trk_body_options body;
    trk_link_options link;
    trk_leaf_options_init(&o, sizeof o);
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    o.friction = o.approach_bump = body.mass = link.stiffness = 1;
    link.to_body = 1;
    trk_status status = trk_law_create_leaf(context, "leaf", &o, &law);
    link.law = law;
    if (status == TRK_OK)
        status = trk_spec_create(context, "s", &spec);
    if (status == TRK_OK)
        status = trk_spec_add_body(spec, "b", &body, NULL);
    if (status == TRK_OK)
        status = trk_spec_add_link(spec, "k", &link, NULL);
    if (status == TRK_OK)
        status = trk_model_compile(context, spec, NULL, &model);
    if (status == TRK_OK)
        status = trk_newmark_create(context, model, NULL, &stepper);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    trk_law_destroy(law);
    return status;
}

static void lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(work);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(road_work_is_stored_or_lost),
        TEST(air_spring_keeps_second_order),
        TEST(failure_changes_nothing),
        TEST(setting_a_state_relaxes),
        cmocka_unit_test(steps_allocate_nothing),
        TEST(sensors_show_the_laws),
        TEST(explicit_steps_refuse),
        cmocka_unit_test(lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
