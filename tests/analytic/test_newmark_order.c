/* SPDX-License-Identifier: MIT */
/* Order of the stepper on the vehicles: halve the step and compare with the run before. */
#include "support.h"
#include "vehicles.h"

#include <truckride/signal.h>

enum { COARSEST = 500, HALVINGS = 4 }; /* steps a second */

static trk_signal *sweep;

static void sweep_road(double t, int32_t wheels, double *height, double *velocity)
{
    for (int32_t k = 0; k < wheels; k++) {
        double gain = 10 * (k % 2 ? -0.6 : 1);
        height[k] = gain * trk_signal_value(sweep, t);
        velocity[k] = gain * trk_signal_rate(sweep, t);
    }
}

/* Largest difference of q between two runs, the second with twice as many steps. */
static double change(const support_run *coarse, const support_run *fine)
{
    double *same = malloc((size_t)((coarse->steps + 1) * coarse->n) * sizeof *same);
    assert_non_null(same);
    for (int64_t k = 0; k <= coarse->steps; k++)
        memcpy(same + k * coarse->n, fine->q + 2 * k * fine->n, (size_t)fine->n * sizeof *same);
    double worst = support_difference(coarse->steps + 1, coarse->n, coarse->q, same, 1e-3);
    free(same);
    return worst;
}

static void check_order(trk_context *context, trk_vehicle vehicle, trk_variant variant, int method,
                        double wanted, double tolerance)
{
    trk_model *model = support_model(context, vehicle, variant, 0);
    support_run coarse = {0};
    double before = 0;
    for (int k = 0; k <= HALVINGS; k++) {
        int64_t steps = (int64_t)COARSEST << k;
        trk_newmark_options options;
        support_method(method, 1.0 / (double)steps, &options);
        support_run fine = support_record(context, model, &options, sweep_road, steps);
        if (k > 0) {
            double now = change(&coarse, &fine), order = log2(before / now);
            print_message("%-16s %-15s %-22s %9.3g %10.3g %6.3f\n", support_vehicle_name(vehicle),
                          support_variant_name(variant), support_method_name(method),
                          2.0 / (double)steps, now, k > 1 ? order : NAN);
            if (k == HALVINGS)
                assert_near(order, wanted, tolerance);
            before = now;
        }
        support_run_free(&coarse);
        coarse = fine;
    }
    support_run_free(&coarse);
    trk_model_destroy(model);
}

static void test_order(void **state)
{
    static const trk_vehicle vehicles[] = {TRK_VEHICLE_THESIS_QUARTER, SUPPORT_HALF_CAR,
                                           TRK_VEHICLE_REFERENCE_HALF, TRK_VEHICLE_REFERENCE_TRUCK};
    trk_sweep_options options;
    trk_sweep_options_init(&options, sizeof options);
    options.duration = 10;
    assert_ok(*state, trk_signal_create_sweep(*state, &options, &sweep));
    print_message("%-16s %-15s %-22s %9s %10s %6s\n", "vehicle", "variant", "method", "h [s]",
                  "change", "order");
    for (int k = 0; k < 4; k++)
        for (trk_variant variant = 0; variant <= TRK_VARIANT_THESIS_DAMPERS; variant++)
            check_order(*state, vehicles[k], variant, 0, 2, 0.02);
    check_order(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, 1, 1, 0.03);
    check_order(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, 2, 2, 0.02);
    check_order(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, 3, 2, 0.02);
    trk_signal_destroy(sweep);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_order, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
