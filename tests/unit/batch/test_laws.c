/* SPDX-License-Identifier: MIT */
/* Variants with laws, which a batch takes one by one, in several threads. */
#include "fleet.h"
#include "laws.h"

enum { VARIANTS = 5 };

static trk_model *make(trk_context *context, int32_t k)
{
    trk_spec *spec = support_truck_with_tail(context);
    trk_model *model;
    assert_ok(context, trk_spec_vary(spec, TRK_FIELD_FRICTION, "*_spring", TRK_MEANING_FACTOR,
                                     1 + 0.3 * k, NULL));
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

static void create(fleet *f, trk_context *context)
{
    fleet_create(f, context, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, 0, VARIANTS,
                 2);
    f->options.threads = 2;
    for (int32_t k = 0; k < VARIANTS; k++) {
        trk_model_destroy(f->model[k]);
        f->model[k] = make(context, k);
    }
}

static void each_is_run_as_if_alone(void **state)
{
    fleet f;
    create(&f, *state);
    for (f.newmark.alpha_f = 0; f.newmark.alpha_f < 0.2; f.newmark.alpha_f += 0.1) {
        assert_ok(*state, fleet_run(&f, NULL, NULL));
        for (int32_t k = 0; k < VARIANTS; k++)
            assert_near(fleet_difference(&f, k), 0, 1e-8);
    }
    fleet_destroy(&f);
}

/* The friction of one variant does not reach another: the same bits in any company. */
static void company_does_not_matter(void **state)
{
    fleet f;
    create(&f, *state);
    assert_ok(*state, fleet_run(&f, NULL, NULL));
    size_t size = fleet_bytes(&f);
    double *first = malloc(size);
    assert_non_null(first);
    memcpy(first, f.recorded[0], size);
    assert_true(memcmp(first, f.recorded[2], size) != 0); /* the same road, other friction */
    f.options.threads = 1;
    f.count = 1;
    assert_ok(*state, fleet_run(&f, NULL, NULL));
    assert_memory_equal(first, f.recorded[0], size);
    free(first);
    f.count = VARIANTS;
    fleet_destroy(&f);
}

static void another_kind_of_law_is_another_structure(void **state)
{
    fleet f;
    create(&f, *state);
    trk_spec *spec = support_truck_with_tail(*state);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    int32_t id = trk_spec_find(spec, TRK_PART_LINK, "rear_left_spring");
    assert_ok(*state, trk_spec_get_link(spec, id, &link));
    trk_law *law = support_law(*state, TRK_LAW_FRICTION);
    link.law = law;
    assert_ok(*state, trk_spec_set_link(spec, id, &link));
    trk_law_destroy(law);
    trk_model_destroy(f.model[3]);
    assert_ok(*state, trk_model_compile(*state, spec, NULL, &f.model[3]));
    trk_spec_destroy(spec);
    assert_status(*state, fleet_run(&f, NULL, NULL), TRK_E_ARGUMENT);
    assert_message(*state, "rear_left_spring");
    fleet_destroy(&f);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(each_is_run_as_if_alone),
        TEST(company_does_not_matter),
        TEST(another_kind_of_law_is_another_structure),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
