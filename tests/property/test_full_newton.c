/* SPDX-License-Identifier: MIT */
/* The condensed Newton of the stepper is exact: it equals Newton on all coordinates. */
#include "full_newton.h"
#include "laws.h"
#include "support.h"
#include "vehicles.h"

enum { STEPS = 400, MAX = 64 };

/* The same run as support_record(), by the oracle. */
static support_run record_full(const trk_model *model, const trk_newmark_options *options)
{
    int32_t wheels = trk_model_count(model, TRK_PART_ROAD),
            ports = trk_model_count(model, TRK_PART_PORT);
    support_run run = {.n = trk_model_count(model, TRK_PART_COORDINATE),
                       .links = trk_model_count(model, TRK_PART_LINK),
                       .steps = STEPS};
    run.q = calloc((size_t)((STEPS + 1) * run.n), sizeof(double));
    run.v = calloc((size_t)((STEPS + 1) * run.n), sizeof(double));
    run.force = calloc((size_t)((STEPS + 1) * run.links), sizeof(double));
    assert_true(run.q && run.v && run.force && wheels <= MAX && ports <= MAX);
    double height[MAX], velocity[MAX], load[MAX];
    full_newton *full = full_newton_create(model, options);
    for (int64_t k = 0; k <= STEPS; k++) {
        double t = (double)k * options->step;
        support_road(t, wheels, height, velocity);
        support_load(t, ports, load);
        if (k == 0)
            full_newton_start(full, height, velocity, load);
        else
            full_newton_step(full, height, velocity, load);
        full_newton_get(full, run.q + k * run.n, run.v + k * run.n, NULL,
                        run.force + k * run.links);
    }
    full_newton_destroy(full);
    return run;
}

static void compare_runs(trk_context *context, const trk_model *model, const char *vehicle,
                         const char *variant, int method)
{
    trk_newmark_options options;
    support_method(method, 1e-3, &options);
    options.tolerance = 1e-13;
    support_run condensed = support_record(context, model, &options, support_road, STEPS);
    support_run full = record_full(model, &options);
    double q = support_difference(STEPS + 1, full.n, full.q, condensed.q, 1e-6);
    double v = support_difference(STEPS + 1, full.n, full.v, condensed.v, 1e-6);
    double f = support_difference(STEPS + 1, full.links, full.force, condensed.force, 1e-6);
    print_message("%-16s %-15s %-22s g %-4.3g q %8.2g v %8.2g f %8.2g\n", vehicle, variant,
                  support_method_name(method), trk_model_gravity(model), q, v, f);
    assert_true(q < 1e-10);
    assert_true(v < 1e-10);
    assert_true(f < 1e-10);
    support_run_free(&condensed);
    support_run_free(&full);
}

static void compare(trk_context *context, trk_vehicle vehicle, trk_variant variant, int method,
                    double gravity)
{
    trk_model *model = support_model(context, vehicle, variant, gravity);
    compare_runs(context, model, support_vehicle_name(vehicle), support_variant_name(variant),
                 method);
    trk_model_destroy(model);
}

/* Laws with memory, on the axles of the truck and all in one car, with every method. */
static void test_with_laws(void **state)
{
    for (int method = 0; method < SUPPORT_METHODS; method++)
        for (int vehicle = 0; vehicle < 2; vehicle++) {
            trk_spec *spec = vehicle ? support_truck_on_leaves(*state) : support_every_law(*state);
            trk_model_options options;
            trk_model *model;
            trk_model_options_init(&options, sizeof options);
            options.gravity = vehicle ? 0 : TRK_STANDARD_GRAVITY;
            assert_ok(*state, trk_model_compile(*state, spec, &options, &model));
            compare_runs(*state, model, trk_spec_name(spec), "laws", method);
            trk_model_destroy(model);
            trk_spec_destroy(spec);
        }
}

static void test_condensed_is_full(void **state)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++)
        for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++)
            for (int method = 0; method < SUPPORT_METHODS; method++)
                compare(*state, vehicle, variant, method, 0);
}

/* With gravity, coordinates count from the drawn position and the weight acts. */
static void test_with_gravity(void **state)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++)
        for (int method = 0; method < SUPPORT_METHODS; method++)
            compare(*state, vehicle, TRK_VARIANT_THESIS_DAMPERS, method, TRK_STANDARD_GRAVITY);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_condensed_is_full, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_with_gravity, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_with_laws, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
