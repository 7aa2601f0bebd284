/* SPDX-License-Identifier: MIT */
/* Dense and sparse steppers go the same way, and refuse the same models. Needs CHOLMOD. */
#include "support.h"
#include "vehicles.h"

static support_run run_by(trk_context *context, const trk_model *model, trk_backend backend,
                          int64_t steps)
{
    trk_newmark_options options;
    support_method(0, 1e-3, &options);
    options.backend = backend;
    options.tolerance = 1e-13;
    return support_record(context, model, &options, support_road, steps);
}

static double compare(trk_context *context, const trk_model *model, int64_t steps)
{
    support_run dense = run_by(context, model, TRK_BACKEND_DENSE, steps);
    support_run sparse = run_by(context, model, TRK_BACKEND_SPARSE, steps);
    double off = support_difference(steps + 1, dense.n, dense.q, sparse.q, 1e-9);
    support_run_free(&dense);
    support_run_free(&sparse);
    return off;
}

static void test_vehicles(void **state)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++)
        for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++) {
            trk_model *model = support_model(*state, vehicle, variant, 0);
            double off = compare(*state, model, 1000);
            print_message("dense and sparse, %s %s: %.2g\n", support_vehicle_name(vehicle),
                          support_variant_name(variant), off);
            assert_true(off < 1e-10);
            trk_model_destroy(model);
        }
}

/* Masses between a road and the ground; each 150th link has a damper curve. */
static trk_model *chain(trk_context *context, int32_t masses)
{
    trk_spec *spec;
    trk_curve *damper;
    trk_body_options body;
    trk_link_options link;
    char name[16];
    assert_ok(context, trk_spec_create(context, "chain", &spec));
    assert_ok(context,
              trk_vehicle_create_curve(context, TRK_TABLE_THESIS_REAR_AXLE_DAMPER, NULL, &damper));
    trk_body_options_init(&body, sizeof body);
    assert_ok(context, trk_spec_add_road(spec, "road", 0, 0, NULL));
    for (int32_t k = 0; k <= masses; k++) {
        snprintf(name, sizeof name, "%d", k);
        body.mass = 50 + 10 * (k % 7);
        if (k < masses)
            assert_ok(context, trk_spec_add_body(spec, name, &body, NULL));
        trk_link_options_init(&link, sizeof link);
        link.from_road = k == 0 ? 1 : 0;
        link.from_body = k;
        link.to_body = k < masses ? k + 1 : 0;
        link.stiffness = 1e5 * (1 + k % 3);
        link.damping = 100;
        link.damper_curve = k % 150 == 20 ? damper : NULL;
        assert_ok(context, trk_spec_add_link(spec, name, &link, NULL));
    }
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_curve_destroy(damper);
    trk_spec_destroy(spec);
    return model;
}

static void test_chain(void **state)
{
    trk_model *model = chain(*state, 3000);
    double off = compare(*state, model, 100);
    print_message("dense and sparse, chain of 3000: %.2g\n", off);
    assert_true(off < 1e-10);
    trk_newmark *stepper;
    trk_newmark_statistics statistics = {.struct_size = sizeof statistics};
    assert_ok(*state, trk_newmark_create(*state, model, NULL, &stepper));
    assert_ok(*state, trk_newmark_get_statistics(stepper, &statistics));
    assert_int_equal(statistics.backend, TRK_BACKEND_SPARSE);
    assert_int_equal(statistics.nonlinear_links, 20);
    assert_int_equal(statistics.coordinates, 3000);
    assert_true(statistics.factor_entries < 3 * 3000); /* no fill in a chain */
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
}

/* -k so large that M + beta h^2 K is indefinite: a status that names the link, on both backends. */
static void test_not_positive_definite(void **state)
{
    static const trk_backend backends[] = {TRK_BACKEND_DENSE, TRK_BACKEND_SPARSE};
    trk_spec *spec = support_spec(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS);
    int32_t id = trk_spec_find(spec, TRK_PART_LINK, "rear_right_spring");
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    assert_ok(*state, trk_spec_get_link(spec, id, &link));
    link.stiffness = -1e11;
    assert_ok(*state, trk_spec_set_link(spec, id, &link));
    trk_model *model;
    assert_ok(*state, trk_model_compile(*state, spec, NULL, &model));
    for (int k = 0; k < 2; k++) {
        trk_newmark_options options;
        support_method(0, 1e-3, &options);
        options.backend = backends[k];
        trk_newmark *stepper;
        assert_status(*state, trk_newmark_create(*state, model, &options, &stepper),
                      TRK_E_SINGULAR);
        assert_null(stepper);
        assert_message(*state, "link 'rear_right_spring'");
        options.step =
            1e-6; /* h^2 k is small beside the mass: the motion grows, but it can be computed */
        assert_ok(*state, trk_newmark_create(*state, model, &options, &stepper));
        trk_newmark_destroy(stepper);
    }
    trk_model_destroy(model);
    trk_spec_destroy(spec);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_vehicles, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_chain, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_not_positive_definite, support_setup,
                                        support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
