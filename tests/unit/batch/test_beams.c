/* SPDX-License-Identifier: MIT */
/* Variants whose frame has a flexible tail: rows of beams in the lanes of a batch. */
#include "fleet.h"

enum { VARIANTS = 5 };

/* The half truck with a beam of damped steel behind its frame, other ones for every k. */
static trk_model *make(trk_context *context, int32_t k, double mass_damping)
{
    trk_spec *spec = support_spec(context, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_NONLINEAR);
    trk_body_options tail;
    trk_beam_options beam;
    trk_body_options_init(&tail, sizeof tail);
    trk_beam_options_init(&beam, sizeof beam);
    tail.freedoms = TRK_FREE_Z | TRK_FREE_PITCH;
    tail.cg[0] = -6;
    beam.from_body = trk_spec_find(spec, TRK_PART_BODY, "frame");
    beam.from_point[0] = -5;
    beam.to_point[0] = -6;
    beam.bending_y = 2e5 * (1 + 0.1 * k);
    beam.mass_per_length = 60;
    beam.stiffness_damping = 1e-4;
    beam.mass_damping = mass_damping;
    assert_ok(context, trk_spec_add_body(spec, "tail", &tail, &beam.to_body));
    assert_ok(context, trk_spec_add_beam(spec, "tail", &beam, NULL));
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

static void create(fleet *f, trk_context *context)
{
    fleet_create(f, context, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_NONLINEAR, 0, VARIANTS, 2);
    for (int32_t k = 0; k < VARIANTS; k++) {
        trk_model_destroy(f->model[k]);
        f->model[k] = make(context, k, 2);
    }
}

static void test_equal(void **state)
{
    fleet f;
    create(&f, *state);
    for (f.kernel = TRK_BATCH_KERNEL_NONE; f.kernel < TRK_BATCH_KERNEL_BEST; f.kernel++) {
        if (!fleet_has_kernel(&f, f.kernel))
            continue;
        assert_ok(*state, fleet_run(&f, NULL, NULL));
        for (int32_t k = 0; k < VARIANTS; k++)
            assert_near(fleet_difference(&f, k), 0, 1e-9);
    }
    fleet_destroy(&f);
}

/* A beam without damping by mass has fewer rows. */
static void test_structure(void **state)
{
    fleet f;
    create(&f, *state);
    trk_model_destroy(f.model[VARIANTS - 1]);
    f.model[VARIANTS - 1] = make(*state, 1, 0);
    assert_status(*state, fleet_run(&f, NULL, NULL), TRK_E_ARGUMENT);
    assert_message(*state, "variant 4: its links and beams have ");
    fleet_destroy(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_equal, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_structure, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
