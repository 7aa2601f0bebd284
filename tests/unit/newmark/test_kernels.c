/* SPDX-License-Identifier: MIT */
/* Every kernel that this processor has takes the same steps, singly or many in a row. */
#include "newmark/newmark.h"
#include "support.h"
#include "vehicles.h"

enum { STEPS = 400, MAX = 64, BLOCK = 50 };

static const char *const kernel_names[] = {"general", "portable", "AVX2", "AVX-512"};

typedef struct drive {
    int32_t roads, ports;
    double height[STEPS * MAX], velocity[STEPS * MAX], load[STEPS * MAX];
} drive;

/* Some hundred kilobytes: too much for the stack of a thread on some systems. */
static drive input;

static void prepare(const trk_model *model, double step)
{
    input.roads = trk_model_count(model, TRK_PART_ROAD);
    input.ports = trk_model_count(model, TRK_PART_PORT);
    for (int k = 0; k < STEPS; k++) {
        double t = (k + 1) * step;
        support_road(t, input.roads, input.height + k * input.roads,
                     input.velocity + k * input.roads);
        support_load(t, input.ports, input.load + k * input.ports);
    }
}

static trk_status record(trk_newmark *stepper, int64_t first, int64_t count, double *rows,
                         int64_t *taken)
{
    return trk_newmark_record(stepper, count, input.height + first * input.roads,
                              input.velocity + first * input.roads,
                              input.load + first * input.ports, rows, taken);
}

/* q, v, a and link forces after every step; NULL if the kernel is not to be had. */
static double *run(trk_context *context, const trk_model *model, const trk_newmark_options *options,
                   int32_t kernel)
{
    int32_t n = model->n, links = model->links.count;
    trk_newmark *stepper;
    int64_t taken;
    assert_ok(context, trk_newmark_create(context, model, options, &stepper));
    double *out = NULL;
    if (trk_newmark_set_kernel(stepper, kernel)) {
        out = calloc((size_t)(STEPS * (3 * n + links)), sizeof *out);
        assert_non_null(out);
        for (int k = 0; k < STEPS; k++) {
            double *row = out + k * (3 * n + links);
            assert_ok(context, record(stepper, k, 1, NULL, &taken));
            trk_newmark_get_state(stepper, row, row + n, row + 2 * n);
            trk_newmark_get_links(stepper, NULL, NULL, row + 3 * n);
        }
    }
    trk_newmark_destroy(stepper);
    return out;
}

static void compare(trk_context *context, trk_vehicle vehicle, trk_variant variant, int method)
{
    trk_model *model =
        support_model(context, vehicle, variant, method == 1 ? TRK_STANDARD_GRAVITY : 0);
    trk_newmark_options options;
    support_method(method, 1e-3, &options);
    options.tolerance = 1e-14;
    prepare(model, options.step);
    int32_t columns = 3 * model->n + model->links.count;
    double *general = run(context, model, &options, TRK_KERNEL_GENERAL),
           *portable = run(context, model, &options, TRK_KERNEL_PORTABLE);
    assert_non_null(portable);
    double off = support_difference(STEPS, columns, general, portable, 1e-6);
    print_message("%-16s %-15s %-22s portable %8.2g", support_vehicle_name(vehicle),
                  support_variant_name(variant), support_method_name(method), off);
    assert_true(off < 2e-11); /* accelerations of small forces between large ones */
    for (int32_t kernel = TRK_KERNEL_AVX2; kernel <= TRK_KERNEL_AVX512; kernel++) {
        double *other = run(context, model, &options, kernel);
        if (!other)
            continue;
        off = support_difference(STEPS, columns, portable, other, 1e-3);
        print_message(" %s %8.2g", kernel_names[kernel], off);
        assert_true(off < 1e-12);
        free(other);
    }
    print_message("\n");
    free(general);
    free(portable);
    trk_model_destroy(model);
}

static void test_equal(void **state)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++)
        for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++)
            for (int method = 0; method < 2; method++)
                compare(*state, vehicle, variant, method);
}

/* Blocks of steps give the bits of single ones, and sensors out of rows what reading gives. */
static void check_record(trk_context *context, const trk_model *model,
                         const trk_newmark_options *options, int32_t kernel)
{
    trk_newmark *single, *blocks;
    assert_ok(context, trk_newmark_create(context, model, options, &single));
    assert_ok(context, trk_newmark_create(context, model, options, &blocks));
    if (trk_newmark_set_kernel(single, kernel) && trk_newmark_set_kernel(blocks, kernel)) {
        int64_t width = trk_newmark_row_width(blocks), taken;
        int32_t sensors = model->sensors.count, roads = input.roads;
        double *rows = aligned_alloc(64, (size_t)(BLOCK * width) * sizeof *rows),
               *on_row = calloc((size_t)(sensors * width), sizeof *on_row),
               *on_road = calloc((size_t)(2 * sensors * roads), sizeof *on_road);
        double read[MAX], peak[MAX] = {0}, off[MAX] = {0}, q[MAX], block_q[MAX];
        assert_true(rows && on_row && on_road && width % 8 == 0);
        trk_newmark_get_sensor_rows(blocks, on_row, on_road, on_road + sensors * roads);
        for (int k = 0; k < STEPS; k++) {
            if (k % BLOCK == 0) {
                assert_ok(context, record(blocks, k, BLOCK, rows, &taken));
                assert_int_equal(taken, BLOCK);
            }
            assert_ok(context, record(single, k, 1, NULL, &taken));
            trk_newmark_read_sensors(single, read);
            for (int32_t s = 0; s < sensors; s++) {
                double sum = 0;
                for (int64_t i = 0; i < width; i++)
                    sum += on_row[s * width + i] * rows[k % BLOCK * width + i];
                for (int32_t i = 0; i < roads; i++)
                    sum += on_road[s * roads + i] * input.height[k * roads + i] +
                           on_road[(sensors + s) * roads + i] * input.velocity[k * roads + i];
                peak[s] = fmax(peak[s], fabs(read[s]));
                off[s] = fmax(off[s], fabs(sum - read[s]));
            }
        }
        for (int32_t s = 0; s < sensors; s++)
            assert_true(off[s] <= 1e-11 * peak[s] + 1e-300);
        trk_newmark_get_state(single, q, NULL, NULL);
        trk_newmark_get_state(blocks, block_q, NULL, NULL);
        assert_memory_equal(q, block_q, (size_t)model->n * sizeof *q);
        free(rows);
        free(on_row);
        free(on_road);
    }
    trk_newmark_destroy(single);
    trk_newmark_destroy(blocks);
}

static void test_record(void **state)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++)
        for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++)
            for (int method = 0; method < 3; method += 2) { /* the last has no modal form */
                trk_model *model = support_model(*state, vehicle, variant, 0);
                trk_newmark_options options;
                support_method(method, 1e-3, &options);
                options.tolerance = 1e-13;
                prepare(model, options.step);
                for (int32_t kernel = 0; kernel <= TRK_KERNEL_AVX512; kernel++)
                    check_record(*state, model, &options, kernel);
                trk_model_destroy(model);
            }
}

/* A run ends at the step that fails, with the state before it. */
static void test_stops(void **state)
{
    trk_model *model =
        support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, 0);
    trk_newmark_options options;
    support_method(0, 1e-3, &options);
    for (int32_t kernel = 0; kernel <= TRK_KERNEL_AVX512; kernel++) {
        trk_newmark *stepper, *whole;
        int64_t taken;
        double q[MAX], q_whole[MAX];
        prepare(model, options.step);
        assert_ok(*state, trk_newmark_create(*state, model, &options, &stepper));
        assert_ok(*state, trk_newmark_create(*state, model, &options, &whole));
        if (trk_newmark_set_kernel(stepper, kernel) && trk_newmark_set_kernel(whole, kernel)) {
            assert_ok(*state, record(whole, 0, 37, NULL, &taken));
            input.velocity[37 * input.roads + 1] = NAN;
            assert_status(*state, record(stepper, 0, STEPS, NULL, &taken), TRK_E_RANGE);
            assert_message(*state, "road velocity of");
            assert_int_equal(taken, 37);
            assert_near(trk_newmark_time(stepper), 0.037, 1e-15);
            trk_newmark_get_state(stepper, q, NULL, NULL);
            trk_newmark_get_state(whole, q_whole, NULL, NULL);
            assert_memory_equal(q, q_whole, (size_t)model->n * sizeof *q);
        }
        trk_newmark_destroy(stepper);
        trk_newmark_destroy(whole);
    }
    trk_model_destroy(model);
}

/* An alpha method has the general way only; numbers out of the list are refused. */
static void test_choice(void **state)
{
    trk_model *model = support_oscillator(*state, 1, 1, 0);
    trk_newmark_options options;
    trk_newmark *stepper;
    support_method(2, 1e-3, &options);
    assert_ok(*state, trk_newmark_create(*state, model, &options, &stepper));
    assert_false(trk_newmark_set_kernel(stepper, TRK_KERNEL_PORTABLE));
    assert_true(trk_newmark_set_kernel(stepper, TRK_KERNEL_GENERAL));
    trk_newmark_destroy(stepper);
    support_method(0, 1e-3, &options);
    assert_ok(*state, trk_newmark_create(*state, model, &options, &stepper));
    assert_non_null(stepper->kernel);
    assert_false(trk_newmark_set_kernel(stepper, TRK_KERNEL_AVX512 + 1));
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_equal, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_record, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_stops, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_choice, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
