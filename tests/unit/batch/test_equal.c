/* SPDX-License-Identifier: MIT */
/* Every variant of a batch gets what trk_simulate() gives it alone, with every kernel. */
#include "fleet.h"

enum { VARIANTS = 9 }; /* a whole group of the widest registers and a rest */

static void check(fleet *f, const char *what)
{
    for (f->kernel = TRK_BATCH_KERNEL_NONE; f->kernel < TRK_BATCH_KERNEL_BEST; f->kernel++) {
        if (!fleet_has_kernel(f, f->kernel))
            continue;
        assert_ok(f->context, fleet_run(f, NULL, NULL));
        for (int32_t k = 0; k < f->count; k++) {
            assert_int_equal(f->status[k], TRK_OK);
            assert_int_equal(f->received[k], f->samples);
            double difference = fleet_difference(f, k);
            if (!(difference <= 1e-9))
                print_error("%s, kernel %d, variant %d\n", what, f->kernel, k);
            assert_near(difference, 0, 1e-9);
        }
    }
}

static void test_vehicles(void **state)
{
    for (trk_vehicle vehicle = 1; vehicle < SUPPORT_VEHICLES; vehicle++)
        for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++) {
            fleet f;
            fleet_create(&f, *state, vehicle, variant, 0, VARIANTS, 3);
            check(&f, support_vehicle_name(vehicle));
            fleet_destroy(&f);
        }
}

static void test_gravity(void **state)
{
    for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++) {
        fleet f;
        fleet_create(&f, *state, TRK_VEHICLE_REFERENCE_TRUCK, variant, TRK_STANDARD_GRAVITY, 3, 1);
        check(&f, "under gravity");
        fleet_destroy(&f);
    }
}

/* A start other than 0, samples that do not fall on ends of blocks, other methods and steps. */
static void test_options(void **state)
{
    static const int64_t every[] = {7, 128, 5, 1};
    for (int method = 0; method < SUPPORT_METHODS; method++) {
        fleet f;
        fleet_create(&f, *state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_NONLINEAR, 0, 3, 2);
        support_method(method, method == 1 ? 4e-4 : 2e-3, &f.newmark);
        f.options.record_every = every[method];
        f.options.start = 0.11;
        f.options.duration = 0.9;
        check(&f, support_method_name(method));
        fleet_destroy(&f);
    }
}

/* Some variants have a linear damper where others have none: they do not share a group. */
static void test_mixed(void **state)
{
    fleet f;
    fleet_create(&f, *state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_LINEAR, 0, VARIANTS, 1);
    for (int32_t k = 0; k < VARIANTS; k += 2) {
        trk_spec *spec = support_spec(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_LINEAR);
        for (int32_t j = 1; j <= trk_spec_count(spec, TRK_PART_LINK); j++) {
            trk_link_options link;
            trk_link_options_init(&link, sizeof link);
            assert_ok(*state, trk_spec_get_link(spec, j, &link));
            if (j % 2 || k % 4 == 0)
                link.damping = 0;
            assert_ok(*state, trk_spec_set_link(spec, j, &link));
        }
        trk_model_destroy(f.model[k]);
        assert_ok(*state, trk_model_compile(*state, spec, NULL, &f.model[k]));
        trk_spec_destroy(spec);
    }
    check(&f, "dampers here and there");
    fleet_destroy(&f);
}

/* Some sensors in an order of one's own are those of all, bit by bit, in lanes and alone. */
static void test_chosen_sensors(void **state)
{
    static const int32_t chosen[] = {30, 2, 2, 17};
    enum { CHOSEN = sizeof chosen / sizeof *chosen };
    for (int way = 0; way < 2; way++) {
        fleet all, some;
        fleet_create(&all, *state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, 0, 5,
                     5);
        fleet_create(&some, *state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, 0, 5,
                     5);
        all.kernel = some.kernel = way ? TRK_BATCH_KERNEL_NONE : TRK_BATCH_KERNEL_BEST;
        some.options.sensors = chosen;
        some.options.sensor_count = some.sensors = CHOSEN;
        assert_ok(*state, fleet_run(&all, NULL, NULL));
        assert_ok(*state, fleet_run(&some, NULL, NULL));
        for (int32_t v = 0; v < all.count; v++)
            for (int j = 0; j < CHOSEN; j++)
                assert_memory_equal(some.recorded[v] + j * some.samples,
                                    all.recorded[v] + (chosen[j] - 1) * all.samples,
                                    (size_t)all.samples * sizeof(double));
        fleet_destroy(&all);
        fleet_destroy(&some);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_vehicles, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_gravity, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_options, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_chosen_sensors, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_mixed, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
