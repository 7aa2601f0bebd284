/* SPDX-License-Identifier: MIT */
/* Built-in tables: their printed points, the formulas behind the sampled ones, errors. */
#include "support.h"

#include <truckride/vehicle.h>

static trk_curve *table(trk_context *context, trk_table id)
{
    trk_curve *curve;
    assert_ok(context, trk_vehicle_create_curve(context, id, NULL, &curve));
    return curve;
}

/* The curve has these points, and sign = -1: printed over compression. */
static void expect(trk_context *context, trk_table id, int count, double sign,
                   const double (*points)[2])
{
    trk_curve *curve = table(context, id);
    assert_true(trk_curve_count(curve) >= count);
    for (int k = 0; k < count; k++)
        assert_near(trk_curve_value(curve, sign * points[k][0]), sign * points[k][1],
                    1e-12 * 14000);
    assert_int_equal(trk_curve_monotone(curve), 1);
    trk_curve_destroy(curve);
}

#define EXPECT(context, id, sign, ...)                                                             \
    do {                                                                                           \
        static const double points[][2] = {__VA_ARGS__};                                           \
        expect(context, id, (int)(sizeof points / sizeof *points), sign, points);                  \
    } while (0)

/* Typed from the thesis. */
static void thesis(void **state)
{
    trk_context *context = *state;
    EXPECT(context, TRK_TABLE_THESIS_EXAMPLE_DAMPER, 1, {-1.5, -3000}, {-1, -2000}, {-0.5, -1000},
           {-0.1, -500}, {0, 0}, {0.1, 700}, {0.5, 1500}, {1, 3000}, {1.5, 5000});
    EXPECT(context, TRK_TABLE_THESIS_FRONT_AXLE_DAMPER, 1, {-0.5, -3500}, {-0.4, -3000},
           {-0.3, -2700}, {-0.2, -2500}, {-0.1, -2000}, {-0.05, -1000}, {0, 0}, {0.05, 100},
           {0.1, 200}, {0.2, 250}, {0.3, 300}, {0.4, 400}, {0.5, 500});
    EXPECT(context, TRK_TABLE_THESIS_REAR_AXLE_DAMPER, 1, {-1.5, -3000}, {-1, -2000}, {-0.5, -1000},
           {-0.4, -800}, {-0.3, -600}, {-0.1, -400}, {-0.05, -200}, {0, 0}, {0.05, 700},
           {0.1, 4500}, {0.3, 9000}, {0.4, 10000}, {0.5, 10500}, {1, 12000}, {1.5, 14000});
    EXPECT(context, TRK_TABLE_THESIS_FRONT_CAB_DAMPER, 1, {-0.5, -250}, {-0.4, -200}, {-0.3, -150},
           {-0.1, -100}, {-0.05, -30}, {0, 0}, {0.05, 10}, {0.1, 40}, {0.3, 130}, {0.4, 250},
           {0.5, 300});
    EXPECT(context, TRK_TABLE_THESIS_REAR_CAB_DAMPER, 1, {-0.5, -90}, {-0.4, -80}, {-0.3, -60},
           {-0.1, -40}, {-0.05, -10}, {0, 0}, {0.05, 5}, {0.1, 20}, {0.3, 60}, {0.4, 120},
           {0.5, 180});
}

/* Typed from the published tables (docs/theory/vehicle.md names them), over compression. */
static void reference(void **state)
{
    trk_context *context = *state;
    EXPECT(context, TRK_TABLE_REFERENCE_BUMP_STOP, -1, {-0.01, 0}, {0, 0}, {0.002, 200},
           {0.004, 400}, {0.006, 600}, {0.008, 800}, {0.01, 1000}, {0.02, 2500}, {0.03, 4500},
           {0.04, 7500}, {0.05, 12500});
    EXPECT(context, TRK_TABLE_REFERENCE_FRONT_CAB_SPRING, -1, {-0.040, -1000}, {-0.037, 2500},
           {0, 3000}, {0.010, 3400}, {0.020, 4000}, {0.025, 4500}, {0.030, 5700}, {0.035, 9000});
    EXPECT(context, TRK_TABLE_REFERENCE_REAR_CAB_SPRING, -1, {-0.040, -2000}, {-0.030, 2600},
           {-0.020, 2725}, {0, 3000}, {0.010, 3200}, {0.017, 3350}, {0.030, 4450}, {0.035, 5100},
           {0.040, 7000});
    /* the stiff side is extension */
    EXPECT(context, TRK_TABLE_REFERENCE_FRONT_CAB_DAMPER, -1, {-0.390, -3960}, {-0.260, -2390},
           {-0.130, -1270}, {-0.052, -300}, {0, 0}, {0.052, 200}, {0.130, 550}, {0.260, 1320},
           {0.390, 2060});
    EXPECT(context, TRK_TABLE_REFERENCE_REAR_CAB_DAMPER, -1, {-0.390, -2340}, {-0.260, -1820},
           {-0.130, -720}, {-0.052, -160}, {0, 0}, {0.052, 80}, {0.130, 170}, {0.260, 420},
           {0.390, 660});
}

/* c v / (1 + d |v|) from a crawl to 3 m/s, both ways. */
static void axle_damper(void **state)
{
    trk_curve *curve = table(*state, TRK_TABLE_REFERENCE_AXLE_DAMPER);
    for (double v = 2e-4; v <= 3; v *= 1.003) {
        double extension = 98727.9 * v / (1 + 4.77954 * v),
               compression = 52526.6 * v / (1 + 3.0 * v);
        assert_near(trk_curve_value(curve, v), extension, 1e-3 * extension);
        assert_near(trk_curve_value(curve, -v), -compression, 1e-3 * compression);
    }
    assert_near(trk_curve_value(curve, 0), 0, 0);
    assert_int_equal(trk_curve_monotone(curve), 1);
    trk_curve_destroy(curve);
}

/* k1 x + k2 x^2 over compression x, to the shortest length and beyond the free one's slope. */
static void axle_springs(void **state)
{
    const double rate[2][2] = {{85490, 495208}, {178892, 621618}};
    for (int end = 0; end < 2; end++) {
        trk_curve *curve = table(*state, TRK_TABLE_REFERENCE_FRONT_SPRING + end);
        for (double x = 0; x < 0.4; x += 0.00037) {
            double force = rate[end][0] * x + rate[end][1] * x * x;
            double slope = rate[end][0] + 2 * rate[end][1] * x;
            assert_near(trk_curve_value(curve, -x), -force, 1e-12 * 2e5);
            assert_near(trk_curve_slope(curve, -x), slope, 1e-11 * slope);
        }
        assert_near(trk_curve_value(curve, 0.1), 0.1 * rate[end][0], 1e-11 * 1e5);
        assert_int_equal(trk_curve_monotone(curve), 1);
        assert_int_equal(trk_curve_interpolation(curve), TRK_INTERPOLATION_NOT_A_KNOT);
        trk_curve_destroy(curve);
    }
}

/* All tables exist, have distinct names, and take other options. */
static void options(void **state)
{
    trk_context *context = *state;
    trk_curve_options linear;
    trk_curve_options_init(&linear, sizeof linear);
    linear.interpolation = TRK_INTERPOLATION_LINEAR;
    linear.extrapolation = TRK_EXTRAPOLATION_CLAMP;
    char seen[1024] = "|";
    for (trk_table id = TRK_TABLE_THESIS_EXAMPLE_DAMPER; id <= TRK_TABLE_REFERENCE_REAR_CAB_DAMPER;
         id++) {
        trk_curve *curve;
        assert_ok(context, trk_vehicle_create_curve(context, id, &linear, &curve));
        assert_int_equal(trk_curve_interpolation(curve), TRK_INTERPOLATION_LINEAR);
        assert_int_equal(trk_curve_extrapolation(curve), TRK_EXTRAPOLATION_CLAMP);
        char name[64];
        snprintf(name, sizeof name, "%s|", trk_curve_name(curve));
        assert_null(strstr(seen, name));
        strcat(seen, name);
        trk_curve_destroy(curve);
    }
    linear.interpolation = 99;
    trk_curve *curve = (trk_curve *)state;
    assert_status(context, trk_vehicle_create_curve(context, 1, &linear, &curve), TRK_E_ARGUMENT);
    assert_null(curve);
}

static void errors(void **state)
{
    trk_context *context = *state;
    const trk_table wrong[] = {0, -1, TRK_TABLE_REFERENCE_REAR_CAB_DAMPER + 1};
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        trk_curve *curve = (trk_curve *)state;
        assert_status(context, trk_vehicle_create_curve(context, wrong[k], NULL, &curve),
                      TRK_E_ARGUMENT);
        assert_null(curve);
        assert_message(context, "there is no table");
    }
    trk_curve *curve;
    assert_status(context, trk_vehicle_create_curve(context, 1, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_vehicle_create_curve(NULL, 1, NULL, &curve), TRK_E_ARGUMENT);
}

static trk_status work(trk_context *context)
{
    for (trk_table id = TRK_TABLE_THESIS_EXAMPLE_DAMPER; id <= TRK_TABLE_REFERENCE_REAR_CAB_DAMPER;
         id++) {
        trk_curve *curve;
        trk_status status = trk_vehicle_create_curve(context, id, NULL, &curve);
        if (status != TRK_OK) {
            assert_null(curve);
            return status;
        }
        trk_curve_destroy(curve);
    }
    return TRK_OK;
}

static void out_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(work);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(thesis, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(reference, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(axle_damper, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(axle_springs, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(options, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(errors, support_setup, support_teardown),
        cmocka_unit_test(out_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
