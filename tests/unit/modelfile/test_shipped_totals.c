/* SPDX-License-Identifier: MIT */
/* The parts on the flexible frame add up to the frame of the reference tractor. Needs JSON. */
#include <truckride/vehicle.h>

#include "shipped.h"

typedef struct total {
    double mass, first[3], second[3]; /* [kg], [kg m], [kg m^2]: of m, m p and m p_k^2 */
    double own[3];                    /* [kg m^2] of the parts about their own centres */
} total;

static void add(total *t, double mass, const double *point, const double *inertia)
{
    t->mass += mass;
    for (int k = 0; k < 3; k++) {
        t->first[k] += mass * point[k];
        t->second[k] += mass * point[k] * point[k];
        t->own[k] += inertia[k];
    }
}

/* A slender beam along x or y with rotary inertia about its axis. */
static void add_beam(total *t, const trk_beam_options *beam)
{
    double d[3], centre[3], inertia[3], length2 = 0;
    for (int k = 0; k < 3; k++) {
        d[k] = beam->to_point[k] - beam->from_point[k];
        centre[k] = (beam->to_point[k] + beam->from_point[k]) / 2;
        length2 += d[k] * d[k];
    }
    const double length = sqrt(length2), mass = beam->mass_per_length * length;
    for (int k = 0; k < 3; k++)
        inertia[k] = mass * (length2 - d[k] * d[k]) / 12 + beam->inertia_x * d[k] * d[k] / length;
    add(t, mass, centre, inertia);
}

/* All but the cab and the axles. */
static total total_of(const trk_spec *spec)
{
    total t = {0};
    trk_body_options body;
    trk_beam_options beam;
    trk_body_options_init(&body, sizeof body);
    trk_beam_options_init(&beam, sizeof beam);
    for (int32_t id = 1; id <= trk_spec_count(spec, TRK_PART_BODY); id++) {
        const char *name = trk_spec_part_name(spec, TRK_PART_BODY, id);
        assert_int_equal(trk_spec_get_body(spec, id, &body), TRK_OK);
        if (strcmp(name, "cab") != 0 && !shipped_ends(name, "_axle"))
            add(&t, body.mass, body.cg, body.inertia);
    }
    for (int32_t id = 1; id <= trk_spec_count(spec, TRK_PART_MASS); id++) {
        double mass, point[3];
        assert_int_equal(trk_spec_get_mass(spec, id, NULL, &mass, point), TRK_OK);
        add(&t, mass, point, (double[3]){0});
    }
    for (int32_t id = 1; id <= trk_spec_count(spec, TRK_PART_BEAM); id++) {
        assert_int_equal(trk_spec_get_beam(spec, id, &beam), TRK_OK);
        add_beam(&t, &beam);
    }
    return t;
}

static void frame_is_that_of_the_reference(void **state)
{
    trk_truck_parameters reference;
    trk_truck_parameters_init(&reference, sizeof reference);
    trk_spec *spec = shipped_spec(*state, SHIPPED_FOUR_BY_TWO);
    const total t = total_of(spec);
    double about_cg[3];
    assert_near(t.mass, reference.frame_mass, 0.01);
    for (int k = 0; k < 3; k++) {
        assert_near(t.first[k] / t.mass, reference.frame_cg[k], 1e-5);
        about_cg[k] = t.second[k] - t.first[k] * t.first[k] / t.mass;
    }
    assert_near(t.own[0] + about_cg[1] + about_cg[2], reference.frame_inertia[0], 0.05);
    assert_near(t.own[1] + about_cg[0] + about_cg[2], reference.frame_inertia[1], 0.1);
    trk_spec_destroy(spec);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(frame_is_that_of_the_reference, support_setup,
                                        support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
