/* SPDX-License-Identifier: MIT */
/* Shipped vehicles stand on their tires with their whole weight, where it ought to be. Needs JSON. */
#include <truckride/vehicle.h>

#include "shipped.h"
#include "vehicles.h"

/* Mass by which all bodies lift as one: 1' M 1 over the coordinates z. */
static double total_mass(const trk_model *model)
{
    const int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
    double *mass = malloc((size_t)n * (size_t)n * sizeof *mass), total = 0;
    assert_non_null(mass);
    trk_model_get_mass(model, mass);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++)
            if (shipped_ends(trk_model_part_name(model, TRK_PART_COORDINATE, i + 1), ".z") &&
                shipped_ends(trk_model_part_name(model, TRK_PART_COORDINATE, j + 1), ".z"))
                total += mass[i * n + j];
    free(mass);
    return total;
}

/* Load of all tires whose name begins so [N]. */
static double load_of(const trk_model *model, const char *begin)
{
    double *force = shipped_static(model), load = 0;
    for (int32_t link = 1; link <= trk_model_count(model, TRK_PART_LINK); link++) {
        const char *name = trk_model_part_name(model, TRK_PART_LINK, link);
        if (shipped_is_tire(model, link) && strncmp(name, begin, strlen(begin)) == 0)
            load -= force[link - 1];
    }
    free(force);
    return load;
}

static void check_weight(const trk_model *model)
{
    const double weight = total_mass(model) * trk_model_gravity(model);
    assert_true(weight > 0);
    assert_near(load_of(model, "") / weight, 1, 1e-9);
}

static void tires_carry_the_weight(void **state)
{
    for (int k = 0; k < SHIPPED; k++) {
        trk_model *model = shipped_model(*state, shipped_name[k]);
        check_weight(model);
        trk_model_destroy(model);
    }
}

static void tires_of_ready_made_vehicles_carry_the_weight(void **state)
{
    for (trk_vehicle vehicle = TRK_VEHICLE_THESIS_QUARTER; vehicle <= SUPPORT_HALF_CAR; vehicle++)
        for (trk_variant variant = TRK_VARIANT_LINEAR; variant <= TRK_VARIANT_NONLINEAR;
             variant++) {
            trk_model *model = support_model(*state, vehicle, variant, TRK_STANDARD_GRAVITY);
            check_weight(model);
            trk_model_destroy(model);
        }
}

static void left_is_as_right(void **state)
{
    for (int k = 0; k < SHIPPED; k++) {
        trk_model *model = shipped_model(*state, shipped_name[k]);
        const double weight = load_of(model, "");
        double *force = shipped_static(model);
        for (int32_t link = 1; link <= trk_model_count(model, TRK_PART_LINK); link++) {
            const char *name = trk_model_part_name(model, TRK_PART_LINK, link);
            const char *left = strstr(name, "left");
            char mirrored[160];
            if (!left)
                continue;
            snprintf(mirrored, sizeof mirrored, "%.*sright%s", (int)(left - name), name, left + 4);
            int32_t other = trk_model_find(model, TRK_PART_LINK, mirrored);
            assert_true(other > 0);
            /* Lateral arms point the same way on both sides and would pull apart. */
            assert_near(fabs(force[link - 1]), fabs(force[other - 1]), 1e-9 * weight);
        }
        free(force);
        trk_model_destroy(model);
    }
}

/* Loads [kg] by a second program, which reads the files and assembles them in another way. */
static void axle_loads(void **state)
{
    static const struct {
        const char *vehicle, *axle;
        double load;
    } expected[] = {{SHIPPED_FOUR_BY_TWO, "front_", 5417.66},
                    {SHIPPED_FOUR_BY_TWO, "rear_", 3849.71},
                    {SHIPPED_WALKING_BEAM, "front_", 6812.31},
                    {SHIPPED_WALKING_BEAM, "middle_", 3368.46},
                    {SHIPPED_WALKING_BEAM, "rear_", 3368.46},
                    {SHIPPED_FOUR_SPRING, "front_", 6812.31},
                    {SHIPPED_FOUR_SPRING, "middle_", 3348.46},
                    {SHIPPED_FOUR_SPRING, "rear_", 3348.46},
                    {SHIPPED_SEMITRAILER, "front_", 5894.21},
                    {SHIPPED_SEMITRAILER, "rear_", 7662.15},
                    {SHIPPED_SEMITRAILER, "trailer_front_", 5982.8},
                    {SHIPPED_SEMITRAILER, "trailer_middle_", 5965},
                    {SHIPPED_SEMITRAILER, "trailer_rear_", 5947.3}};
    for (size_t k = 0; k < sizeof expected / sizeof *expected; k++) {
        trk_model *model = shipped_model(*state, expected[k].vehicle);
        assert_near(load_of(model, expected[k].axle) / TRK_STANDARD_GRAVITY, expected[k].load, 0.2);
        trk_model_destroy(model);
    }
}

/* Raise the road under the middle axle by 20 mm: a preload of the tires says the same. */
static double share_of_middle_axle(trk_context *context, const char *name)
{
    trk_spec *spec = shipped_spec(context, name);
    static const char *const tires[] = {"middle_left_tire", "middle_right_tire"};
    for (int side = 0; side < 2; side++) {
        const int32_t id = trk_spec_find(spec, TRK_PART_LINK, tires[side]);
        trk_link_options link;
        trk_link_options_init(&link, sizeof link);
        assert_ok(context, trk_spec_get_link(spec, id, &link));
        trk_tire_options tire;
        trk_tire_options_init(&tire, sizeof tire);
        assert_ok(context, trk_law_get_tire(link.law, &tire));
        tire.preload += 0.02 * tire.stiffness;
        trk_law *raised;
        assert_ok(context, trk_law_create_tire(context, "raised", &tire, &raised));
        link.law = raised;
        assert_ok(context, trk_spec_set_link(spec, id, &link));
        trk_law_destroy(raised);
    }
    trk_model *model = shipped_compile(context, spec, TRK_STANDARD_GRAVITY);
    const double middle = load_of(model, "middle_"), rear = load_of(model, "rear_");
    check_weight(model);
    trk_model_destroy(model);
    return middle / (middle + rear);
}

static void tandems_share_their_load(void **state)
{
    assert_near(share_of_middle_axle(*state, SHIPPED_WALKING_BEAM), 0.5, 1e-9);
    assert_near(share_of_middle_axle(*state, SHIPPED_FOUR_SPRING), 0.5, 0.02);
}

int main(void)
{
#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)
    const struct CMUnitTest tests[] = {
        TEST(tires_carry_the_weight),   TEST(tires_of_ready_made_vehicles_carry_the_weight),
        TEST(left_is_as_right),         TEST(axle_loads),
        TEST(tandems_share_their_load),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
