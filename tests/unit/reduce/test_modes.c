/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. Frequencies and responses of reduced models against the full one (REDUCE.1). */
#include "truck.h"

#include <truckride/linear.h>

enum { ALL = 1000000, SENSORS = 5 };

/* Frequency [Hz] of fixed interface of the last kept mode, from its coordinate. */
static double cut_off(const trk_model *model, int modes)
{
    int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
    double *matrix = malloc(2 * (size_t)(n * n) * sizeof *matrix);
    trk_model_get_mass(model, matrix);
    trk_model_get_tangent(model, NULL, NULL, NULL, matrix + n * n);
    char name[32];
    snprintf(name, sizeof name, "modes.%d", modes);
    int32_t place = (trk_model_find(model, TRK_PART_COORDINATE, name) - 1) * (n + 1);
    double square = matrix[n * n + place] / matrix[place];
    free(matrix);
    return sqrt(square) / two_pi;
}

/* Largest relative error of a frequency up to a limit; *out_count: how many these are. */
static double frequency_error(trk_context *context, const trk_model *model,
                              const trk_model *reduced, double limit, int *out_count)
{
    trk_modes *full, *few;
    double worst = 0;
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &full));
    assert_ok(context, trk_modes_create_undamped(context, reduced, NULL, &few));
    *out_count = 0;
    for (int k = 1; k <= trk_modes_count(few); k++) {
        double f = trk_modes_frequency(full, k);
        if (f > limit)
            break;
        worst = fmax(worst, fabs(trk_modes_frequency(few, k) / f - 1));
        (*out_count)++;
    }
    trk_modes_destroy(full);
    trk_modes_destroy(few);
    return worst;
}

/* Largest difference of the sensors' responses to roads and port over their largest size. */
static double response_error(trk_context *context, const trk_model *model, const trk_model *reduced,
                             double limit)
{
    enum { COUNT = 60 };
    static double full[COUNT][SENSORS][2], few[COUNT][SENSORS][2];
    double frequency[COUNT], gain[WHEELS] = {1e-2, 5e-3, -4e-3, 8e-3}, load = 100, worst = 0;
    for (int k = 0; k < COUNT; k++)
        frequency[k] = limit * (k + 1) / COUNT;
    assert_ok(context, trk_frequency_response(context, model, NULL, NULL, COUNT, frequency, gain,
                                              NULL, &load, full[0][0]));
    assert_ok(context, trk_frequency_response(context, reduced, NULL, NULL, COUNT, frequency, gain,
                                              NULL, &load, few[0][0]));
    for (int s = 0; s < SENSORS; s++) {
        double difference = 0, size = 0;
        for (int k = 0; k < COUNT; k++) {
            difference =
                fmax(difference, hypot(few[k][s][0] - full[k][s][0], few[k][s][1] - full[k][s][1]));
            size = fmax(size, hypot(full[k][s][0], full[k][s][1]));
        }
        worst = fmax(worst, difference / size);
    }
    return worst;
}

static void all_modes_are_the_full_model(void **state)
{
    trk_context *context = *state;
    for (int gravity = 0; gravity <= 1; gravity++) {
        trk_model *model = truck(context, gravity * TRK_STANDARD_GRAVITY, 2e-4);
        trk_model *reduced = reduce(context, model, ALL, 0);
        int count;
        assert_int_equal(trk_model_count(reduced, TRK_PART_COORDINATE),
                         trk_model_count(model, TRK_PART_COORDINATE));
        assert_near(frequency_error(context, model, reduced, INFINITY, &count), 0, 1e-9);
        assert_int_equal(count, trk_model_count(model, TRK_PART_COORDINATE));
        assert_near(response_error(context, model, reduced, 200), 0, 1e-9);
        trk_model_destroy(reduced);
        trk_model_destroy(model);
    }
}

/* The table of docs/theory/reduce.md: errors fall with the number of modes. */
static void frequencies_converge(void **state)
{
    trk_context *context = *state;
    static const struct {
        int modes;
        double of_low, of_response;
    } bound[] = {
        {4, 6e-3, 0.4}, {8, 3e-3, 0.1}, {16, 2e-3, 0.1}, {32, 5e-5, 8e-3}, {48, 1e-5, 5e-3}};
    trk_model *model = truck(context, 0, 2e-4);
    for (size_t k = 0; k < sizeof bound / sizeof *bound; k++) {
        trk_model *reduced = reduce(context, model, bound[k].modes, 0);
        int below, low;
        double limit = cut_off(reduced, bound[k].modes) / 2,
               error = frequency_error(context, model, reduced, limit, &below),
               of_low = frequency_error(context, model, reduced, 30, &low),
               of_response = response_error(context, model, reduced, 30);
        print_message("| %d | %d | %.0f Hz | %.1e | %.1e | %.1e |\n", bound[k].modes,
                      (int)trk_model_count(reduced, TRK_PART_COORDINATE), 2 * limit, error, of_low,
                      of_response);
        assert_true(error < 1e-2);
        assert_true(of_low < bound[k].of_low && of_response < bound[k].of_response);
        trk_model_destroy(reduced);
    }
    trk_model_destroy(model);
}

/* Free modes of the whole frame in place of its interface: fewer than 32 coordinates. */
static void few_coordinates(void **state)
{
    trk_context *context = *state;
    trk_model *model = truck(context, 0, 2e-4);
    double before = INFINITY;
    for (int modes = 8; modes <= 24; modes += 8) {
        trk_model *reduced = reduce(context, model, 40, modes);
        int count;
        double error = frequency_error(context, model, reduced, 20, &count);
        print_message("| %d | %d | %.1e | %.1e |\n", modes,
                      (int)trk_model_count(reduced, TRK_PART_COORDINATE), error,
                      response_error(context, model, reduced, 10));
        assert_int_equal(trk_model_count(reduced, TRK_PART_COORDINATE), WHEELS + 2 + modes);
        assert_true(error < before);
        before = error;
        trk_model_destroy(reduced);
    }
    assert_true(before < 3e-3);
    trk_model_destroy(model);
}

int main(void)
{
#define TEST(function) cmocka_unit_test_setup_teardown(function, support_setup, support_teardown)
    const struct CMUnitTest tests[] = {
        TEST(all_modes_are_the_full_model),
        TEST(frequencies_converge),
        TEST(few_coordinates),
    };
#undef TEST
    return cmocka_run_group_tests(tests, NULL, NULL);
}
