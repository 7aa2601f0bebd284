/* SPDX-License-Identifier: MIT */
/* Newton with the line search of (NEWMARK.21): steep dampers, corners, falling laws, long steps. */
#include "laws.h"
#include "support.h"
#include "vehicles.h"

static const double pi = 3.14159265358979323846;

/* The truck with a law on its axle springs. */
static trk_model *truck_with(trk_context *context, const trk_law *law)
{
    trk_spec *spec = support_truck_on_leaves(context);
    trk_model *model;
    for (int32_t id = 1; id <= trk_spec_count(spec, TRK_PART_LINK); id++) {
        trk_link_options link;
        trk_link_options_init(&link, sizeof link);
        assert_ok(context, trk_spec_get_link(spec, id, &link));
        if (!link.law)
            continue;
        link.law = law;
        assert_ok(context, trk_spec_set_link(spec, id, &link));
    }
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

/* A sweep of some 10 mm, 0.5 to 10 Hz in 30 s, another one under each wheel. */
static void sweep(double t, double *height, double *velocity)
{
    static const double gain[] = {0.010, 0.006, -0.008, 0.005};
    double phase = 2 * pi * (0.5 * t + 0.16 * t * t), rate = 2 * pi * (0.5 + 0.32 * t);
    for (int k = 0; k < 4; k++) {
        height[k] = gain[k] * sin(phase);
        velocity[k] = gain[k] * cos(phase) * rate;
    }
}

/* Every step converges; on average and at worst within so many iterations. */
static void drive(trk_context *context, const trk_law *law, double step, double mean, int32_t most)
{
    trk_model *model = truck_with(context, law);
    trk_newmark_options options;
    trk_newmark *stepper;
    trk_newmark_statistics did = {.struct_size = sizeof did};
    support_method(0, step, &options);
    assert_ok(context, trk_newmark_create(context, model, &options, &stepper));
    for (int k = 1; k * step < 30; k++) {
        double height[4], velocity[4];
        sweep(k * step, height, velocity);
        assert_ok(context, trk_newmark_step(stepper, height, velocity, NULL));
    }
    assert_ok(context, trk_newmark_get_statistics(stepper, &did));
    double on_average = (double)did.iterations / (double)did.steps;
    print_message("%-5s step %g s: %.2f iterations a step, at most %d\n", trk_law_name(law), step,
                  on_average, did.max_iterations);
    assert_true(on_average <= mean && did.max_iterations <= most);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
}

/* 4 kN within 1, 0.1 and 0.01 mm/s; with `fall`, twice that before it slides. */
static void drive_seal(trk_context *context, double fall, double step, double mean, int32_t most)
{
    for (double creep = 1e-3; creep > 5e-6; creep /= 10) {
        trk_seal_options o;
        trk_law *law;
        trk_seal_options_init(&o, sizeof o);
        o.sliding = 4000;
        o.breakaway = fall * 4000;
        o.creep = creep;
        assert_ok(context, trk_law_create_seal(context, "seal", &o, &law));
        drive(context, law, step, mean, most);
        trk_law_destroy(law);
    }
}

static void steep_dampers(void **state)
{
    drive_seal(*state, 1, 5e-3, 8, 30);
    drive_seal(*state, 1, 2e-2, 12, 40);
}

/* Its force falls with speed: several answers may exist, one is found. */
static void falling_friction(void **state)
{
    drive_seal(*state, 2, 5e-3, 14, 60);
}

static void corners_of_dry_friction(void **state)
{
    for (double stiffness = 1e6; stiffness < 1e9; stiffness *= 10) {
        trk_friction_options o;
        trk_law *law;
        trk_friction_options_init(&o, sizeof o);
        o.friction = 4000;
        o.stiffness = stiffness;
        assert_ok(*state, trk_law_create_friction(*state, "pad", &o, &law));
        drive(*state, law, 5e-3, 6, 20);
        trk_law_destroy(law);
    }
}

static void short_leaves(void **state)
{
    for (double approach = 2e-3; approach > 1e-5; approach /= 10) {
        trk_leaf_options o;
        trk_law *law;
        trk_leaf_options_init(&o, sizeof o);
        o.friction = 4000;
        o.approach_bump = approach;
        assert_ok(*state, trk_law_create_leaf(*state, "leaf", &o, &law));
        drive(*state, law, 5e-3, 6, 25);
        trk_law_destroy(law);
    }
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(steep_dampers),
        TEST(falling_friction),
        TEST(corners_of_dry_friction),
        TEST(short_leaves),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
