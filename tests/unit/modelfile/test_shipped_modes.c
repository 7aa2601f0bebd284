/* SPDX-License-Identifier: MIT */
/* Modes of the shipped vehicles are where those of trucks are. Needs JSON. */
#include <truckride/linear.h>

#include "shipped.h"

typedef struct band {
    const char *vehicle, *coordinate;
    double share;     /* of the kinetic energy that the coordinate has at least */
    double low, high; /* [Hz] of the first such mode */
} band;

/* Cab 1 to 3 Hz (its pitch on the soft rear springs of the source less), wheel hop 8 to 14 Hz but for the
 * slower tandem, engine 6 to 12 Hz; bodies bounce below 4 Hz, trailers on air near 1 Hz. */
static const band bands[] = {
    {SHIPPED_FOUR_BY_TWO, "cab.z", 0.5, 1, 3},
    {SHIPPED_FOUR_BY_TWO, "cab.pitch", 0.3, 0.7, 3},
    {SHIPPED_FOUR_BY_TWO, "cab.roll", 0.3, 1, 3},
    {SHIPPED_FOUR_BY_TWO, "engine.z", 0.3, 6, 12},
    {SHIPPED_FOUR_BY_TWO, "engine.roll", 0.3, 6, 12},
    {SHIPPED_FOUR_BY_TWO, "front_axle.z", 0.3, 8, 14},
    {SHIPPED_FOUR_BY_TWO, "rear_axle.z", 0.3, 8, 14},
    {SHIPPED_FOUR_BY_TWO, "front_axle.roll", 0.3, 8, 14},
    {SHIPPED_FOUR_BY_TWO, "fuel_tank_left.roll", 0.15, 12, 20},
    {SHIPPED_WALKING_BEAM, "chassis.z", 0.5, 1, 3},
    {SHIPPED_WALKING_BEAM, "chassis.pitch", 0.5, 3, 6},
    {SHIPPED_WALKING_BEAM, "chassis.roll", 0.5, 1, 4},
    {SHIPPED_WALKING_BEAM, "front_axle.z", 0.3, 8, 14},
    {SHIPPED_WALKING_BEAM, "middle_axle.z", 0.4, 6, 10},
    {SHIPPED_FOUR_SPRING, "chassis.z", 0.5, 1, 3},
    {SHIPPED_FOUR_SPRING, "front_axle.z", 0.3, 8, 14},
    {SHIPPED_FOUR_SPRING, "middle_axle.z", 0.3, 6, 14},
    {SHIPPED_SEMITRAILER, "cab.z", 0.5, 1, 3},
    {SHIPPED_SEMITRAILER, "trailer.z", 0.5, 0.8, 1.5},
    {SHIPPED_SEMITRAILER, "trailer.roll", 0.5, 1, 2},
    {SHIPPED_SEMITRAILER, "frame.pitch", 0.3, 2, 4.5},
    {SHIPPED_SEMITRAILER, "front_axle.z", 0.3, 8, 14},
    {SHIPPED_SEMITRAILER, "rear_axle.z", 0.3, 8, 14},
    {SHIPPED_SEMITRAILER, "trailer_rear_axle.z", 0.3, 8, 14},
};

/* NULL in a build without LAPACK. */
static trk_modes *modes_of(trk_context *context, const trk_model *model)
{
    trk_modes *modes;
    trk_status status = trk_modes_create_undamped(context, model, NULL, &modes);
    if (status == TRK_E_UNSUPPORTED)
        return NULL;
    assert_ok(context, status);
    return modes;
}

static void frequencies_lie_in_their_bands(void **state)
{
    for (size_t k = 0; k < sizeof bands / sizeof *bands; k++) {
        const band *b = &bands[k];
        trk_model *model = shipped_model(*state, b->vehicle);
        trk_modes *modes = modes_of(*state, model);
        const int32_t id = trk_model_find(model, TRK_PART_COORDINATE, b->coordinate);
        double share[512] = {0}, frequency = 0;
        assert_true(id > 0 && trk_model_count(model, TRK_PART_COORDINATE) <= 512);
        for (int32_t mode = 1; frequency == 0 && mode <= trk_modes_count(modes); mode++) {
            assert_ok(*state, trk_modes_get_energy(modes, mode, share));
            if (share[id - 1] >= b->share)
                frequency = trk_modes_frequency(modes, mode);
        }
        if (modes && !(frequency >= b->low && frequency <= b->high))
            fail_msg("%s, %s: %g Hz, expected %g to %g", b->vehicle, b->coordinate, frequency,
                     b->low, b->high);
        trk_modes_destroy(modes);
        trk_model_destroy(model);
    }
}

/* By a second program, which reads the files and assembles them in another way [Hz]. */
static void frequencies_are_those_of_another_program(void **state)
{
    static const struct {
        const char *vehicle;
        double tolerance; /* its beams have no shear: it says more for the frame */
        double frequency[8];
    } expected[] = {
        {SHIPPED_FOUR_BY_TWO, 0.003, {0.760, 1.091, 1.463, 1.873, 2.591, 3.416, 4.192, 4.331}},
        {SHIPPED_WALKING_BEAM,
         2e-4,
         {2.1335, 2.9614, 4.4236, 7.4114, 8.4734, 9.5046, 10.2373, 11.1444}},
        {SHIPPED_FOUR_SPRING,
         2e-4,
         {2.1288, 2.9984, 4.4044, 6.2887, 8.9830, 9.6240, 10.2425, 11.2389}},
        {SHIPPED_SEMITRAILER, 1e-3, {0.763, 1.035, 1.201, 1.386, 1.489, 1.862, 2.398, 3.425}},
    };
    for (size_t k = 0; k < sizeof expected / sizeof *expected; k++) {
        trk_model *model = shipped_model(*state, expected[k].vehicle);
        trk_modes *modes = modes_of(*state, model);
        for (int32_t mode = 1; modes && mode <= 8; mode++)
            assert_near(trk_modes_frequency(modes, mode) / expected[k].frequency[mode - 1], 1,
                        expected[k].tolerance);
        trk_modes_destroy(modes);
        trk_model_destroy(model);
    }
}

/* The frame alone: what it carries held fast on it, what carries it and the cab let go. */
static trk_model *bare_frame(trk_context *context)
{
    static const struct {
        trk_field field;
        const char *links;
        double factor;
    } changes[] = {
        {TRK_FIELD_STIFFNESS, "engine_*", 1e3}, {TRK_FIELD_STIFFNESS, "fuel_tank_*", 1e3},
        {TRK_FIELD_STIFFNESS, "cab_*", 1e-9},   {TRK_FIELD_STIFFNESS, "*_spring", 1e-9},
        {TRK_FIELD_FRICTION, "*_spring", 1e-9}, {TRK_FIELD_STIFFNESS, "front_anti_roll_bar", 1e-9},
    };
    trk_spec *spec = shipped_spec(context, SHIPPED_FOUR_BY_TWO);
    for (size_t k = 0; k < sizeof changes / sizeof *changes; k++)
        assert_ok(context, trk_spec_vary(spec, changes[k].field, changes[k].links,
                                         TRK_MEANING_FACTOR, changes[k].factor, NULL));
    return shipped_compile(context, spec, 0);
}

/* Height of both rails at a node in a mode: their mean. */
static double height_of(const trk_model *model, const double *shape, int node)
{
    static const char *const rail[] = {"left", "right"};
    double sum = 0;
    for (int side = 0; side < 2; side++) {
        char name[64];
        snprintf(name, sizeof name, "frame.%s.%d.z", rail[side], node);
        sum += shape[trk_model_find(model, TRK_PART_COORDINATE, name) - 1];
    }
    return sum / 2;
}

static void the_frame_bends_at_9_5_hz(void **state)
{
    enum { FRONT = 1, MIDDLE = 11, REAR = 18 };
    trk_model *model = bare_frame(*state);
    trk_modes *modes = modes_of(*state, model);
    double first = 0, shape[512];
    for (int32_t mode = 1; first == 0 && mode <= trk_modes_count(modes); mode++) {
        assert_ok(*state, trk_modes_get_shape(modes, mode, shape, NULL));
        const double ends = height_of(model, shape, FRONT) + height_of(model, shape, REAR);
        const double bent = height_of(model, shape, MIDDLE) - ends / 2;
        if (trk_modes_frequency(modes, mode) > 3 && fabs(bent) > fmax(1e-3, fabs(ends) / 2))
            first = trk_modes_frequency(modes, mode);
    }
    if (modes)
        assert_near(first, 9.51, 0.02);
    trk_modes_destroy(modes);
    trk_model_destroy(model);
}

int main(void)
{
#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)
    const struct CMUnitTest tests[] = {
        TEST(frequencies_lie_in_their_bands),
        TEST(frequencies_are_those_of_another_program),
        TEST(the_frame_bends_at_9_5_hz),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
