/* SPDX-License-Identifier: MIT */
/* A variant that fails or is cancelled does so alone. */
#include "fleet.h"

enum { VARIANTS = 11, BAD = 4, WORSE = 9 };

/* All variants but BAD and WORSE have what they have in a batch without failures. */
static void check_others(const fleet *f, const fleet *good)
{
    for (int32_t k = 0; k < VARIANTS; k++) {
        if (k == BAD || k == WORSE)
            continue;
        assert_int_equal(f->status[k], TRK_OK);
        assert_int_equal(f->received[k], f->samples);
        assert_memory_equal(f->recorded[k], good->recorded[k], fleet_bytes(f));
    }
}

static fleet again(const fleet *good)
{
    fleet f = *good;
    memset(f.recorded, 0, sizeof f.recorded);
    return f;
}

/* A road whose signal overflows from 0.3 s on. */
static trk_excitation *endless_road(const fleet *f, trk_signal **out_signal)
{
    static const double x[] = {0, 0.3, 0.30001, 1}, y[] = {0, 0, 1e200, 1e200};
    trk_excitation *road;
    assert_ok(f->context, trk_signal_create_points(f->context, 4, x, y, out_signal));
    assert_ok(f->context, trk_excitation_create(f->context, f->model[0], &road));
    assert_ok(f->context, trk_excitation_add_motion(road, 1, *out_signal, 1e200, 0));
    return road;
}

static void test_overflow(void **state)
{
    fleet good;
    fleet_create(&good, *state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_THESIS_DAMPERS, 0, VARIANTS,
                 VARIANTS);
    assert_ok(*state, fleet_run(&good, NULL, NULL));
    for (int32_t kernel = 0; kernel <= TRK_BATCH_KERNEL_BEST; kernel += TRK_BATCH_KERNEL_BEST) {
        trk_signal *signal;
        fleet f = again(&good);
        f.kernel = kernel;
        f.road[BAD] = f.road[WORSE] = endless_road(&f, &signal);
        assert_status(*state, fleet_run(&f, NULL, NULL), TRK_E_RANGE);
        assert_message(*state, "variant 4: ");
        assert_message(*state, " at t = 0.3 s");
        assert_int_equal(f.status[BAD], TRK_E_RANGE);
        assert_int_equal(f.status[WORSE], TRK_E_RANGE);
        assert_int_equal(f.received[BAD], 301);
        if (kernel == TRK_BATCH_KERNEL_BEST)
            check_others(&f, &good);
        trk_excitation_destroy(f.road[BAD]);
        trk_signal_destroy(signal);
        fleet_forget(&f);
    }
    fleet_destroy(&good);
}

/* Dampers far beyond what the sweeps contract go on with the stepper, which solves them. */
static trk_model *stiff_model(trk_context *context)
{
    trk_spec *spec = support_spec(context, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_THESIS_DAMPERS);
    for (int32_t j = 1; j <= trk_spec_count(spec, TRK_PART_LINK); j++) {
        trk_link_options link;
        trk_link_options_init(&link, sizeof link);
        assert_ok(context, trk_spec_get_link(spec, j, &link));
        link.damper_scale *= 3000;
        assert_ok(context, trk_spec_set_link(spec, j, &link));
    }
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

static void test_handed_over(void **state)
{
    fleet good;
    fleet_create(&good, *state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_THESIS_DAMPERS, 0, VARIANTS,
                 2);
    assert_ok(*state, fleet_run(&good, NULL, NULL));
    fleet f = again(&good);
    f.model[BAD] = f.model[WORSE] = stiff_model(*state);
    f.road[WORSE] = f.road[BAD];
    assert_ok(*state, fleet_run(&f, NULL, NULL));
    check_others(&f, &good);
    assert_int_equal(f.received[BAD], f.samples);
    assert_memory_equal(f.recorded[BAD], f.recorded[WORSE], fleet_bytes(&f));
    f.kernel = TRK_BATCH_KERNEL_NONE; /* the stepper is its own oracle to its tolerance */
    assert_near(fleet_difference(&f, BAD), 0, 1e-7);
    trk_model_destroy(f.model[BAD]);
    fleet_forget(&f);
    fleet_destroy(&good);
}

/* What the stepper refuses to start with. */
static void test_refused(void **state)
{
    fleet good;
    fleet_create(&good, *state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_LINEAR, 0, VARIANTS, 1);
    assert_ok(*state, fleet_run(&good, NULL, NULL));
    trk_spec *spec = support_spec(*state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_LINEAR);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    assert_ok(*state, trk_spec_get_link(spec, 1, &link));
    link.stiffness = -1e13;
    assert_ok(*state, trk_spec_set_link(spec, 1, &link));
    fleet f = again(&good);
    assert_ok(*state, trk_model_compile(*state, spec, NULL, &f.model[BAD]));
    f.model[WORSE] = f.model[BAD];
    assert_status(*state, fleet_run(&f, NULL, NULL), TRK_E_SINGULAR);
    assert_message(*state, "trk_batch_run: variant 4: ");
    assert_message(*state, trk_model_part_name(f.model[BAD], TRK_PART_LINK, 1));
    check_others(&f, &good);
    assert_int_equal(f.received[BAD], 0);
    trk_model_destroy(f.model[BAD]);
    trk_spec_destroy(spec);
    fleet_forget(&f);
    fleet_destroy(&good);
}

static void test_sink_cancels(void **state)
{
    fleet good;
    fleet_create(&good, *state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_NONLINEAR, 0, VARIANTS, 1);
    assert_ok(*state, fleet_run(&good, NULL, NULL));
    for (int32_t kernel = 0; kernel <= TRK_BATCH_KERNEL_BEST; kernel += TRK_BATCH_KERNEL_BEST)
        for (int64_t sample = 0; sample <= 300; sample += 300) {
            fleet f = again(&good);
            f.kernel = kernel;
            f.cancel_variant = BAD;
            f.cancel_sample = sample;
            assert_status(*state, fleet_run(&f, NULL, NULL), TRK_E_CANCELLED);
            assert_message(*state, "variant 4: cancelled by the sink");
            assert_int_equal(f.status[BAD], TRK_E_CANCELLED);
            assert_true(f.received[BAD] < f.samples);
            if (kernel == TRK_BATCH_KERNEL_BEST)
                check_others(&f, &good);
            fleet_forget(&f);
        }
    fleet_destroy(&good);
}

static int32_t stop_after(void *user, double fraction)
{
    return fraction >= *(const double *)user;
}

static void test_progress_cancels(void **state)
{
    static const double limits[] = {0, 0.4, 1};
    fleet f;
    fleet_create(&f, *state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_THESIS_DAMPERS, 0, FLEET_MOST,
                 1);
    for (int32_t kernel = 0; kernel <= TRK_BATCH_KERNEL_BEST; kernel += TRK_BATCH_KERNEL_BEST)
        for (int k = 0; k < 3; k++) {
            double limit = limits[k];
            f.kernel = kernel;
            trk_status wanted = limit < 1 ? TRK_E_CANCELLED : TRK_OK;
            assert_status(*state, fleet_run(&f, stop_after, &limit), wanted);
            int finished = 0;
            for (int32_t j = 0; j < f.count; j++) {
                finished += f.status[j] == TRK_OK;
                assert_true(f.status[j] == TRK_OK || f.status[j] == TRK_E_CANCELLED);
                assert_true((f.received[j] == f.samples) == (f.status[j] == TRK_OK));
            }
            assert_true(limit == 0  ? finished == 0
                        : limit < 1 ? finished < f.count && finished > 0
                                    : finished == f.count);
        }
    fleet_destroy(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_overflow, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_handed_over, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_refused, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_sink_cancels, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_progress_cancels, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
