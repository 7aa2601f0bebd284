/* SPDX-License-Identifier: MIT */
/* Statistical linearisation against long runs: RMS of every sensor, beside the tangents at rest. */
#include "support.h"

#include <stdbool.h>

#include <truckride/linear.h>
#include <truckride/simulate.h>
#include <truckride/vehicle.h>

enum { COUNT = 800, SENSORS = 64, INPUTS = 8, SETTLE = 20 };

static const double speed = 20; /* m/s */

/* Errors [-] of RMS values over all sensors: mean square, largest. */
typedef struct errors {
    double mean, largest;
} errors;

static trk_road_options road_of(trk_road_class road_class)
{
    trk_road_options road;
    trk_road_options_init(&road, sizeof road);
    road.unevenness = trk_road_class_unevenness(road_class);
    road.contact_length = 0.2;
    road.track_width = 2.07;
    return road;
}

/* By the model as it is at rest, then by that of its motion. */
static void by_spectra(trk_context *context, const trk_model *model, const trk_road_options *road,
                       double *at_rest, double *in_motion)
{
    double frequency[COUNT];
    double *input = malloc(sizeof(double) * 2 * COUNT * INPUTS * INPUTS);
    trk_model *linear;
    assert_non_null(input);
    for (int k = 0; k < COUNT; k++)
        frequency[k] =
            speed * fmin(road->low * pow(road->high / road->low, k / (COUNT - 1.0)), road->high);
    assert_ok(context,
              trk_road_input_spectra(context, model, road, speed, COUNT, frequency, input));
    assert_ok(context,
              trk_response_psd(context, model, NULL, NULL, COUNT, frequency, input, NULL, at_rest));
    assert_ok(context, trk_model_linearise(context, model, COUNT, frequency, input, NULL, NULL,
                                           NULL, NULL, &linear));
    assert_ok(context, trk_response_psd(context, linear, NULL, NULL, COUNT, frequency, input, NULL,
                                        in_motion));
    trk_model_destroy(linear);
    free(input);
}

/* Standard deviation of each sensor in a run. */
static void by_run(trk_context *context, const trk_model *model, trk_road_options road,
                   double duration, double *out)
{
    trk_signal *left, *right;
    trk_excitation *drive;
    trk_simulate_options options;
    trk_series *run;
    const bool one_track = trk_model_count(model, TRK_PART_ROAD) == 1;
    road.ramp_start = 10;
    road.ramp_length = 100;
    assert_ok(context, trk_road_create(context, &road, &left, &right));
    assert_ok(context, trk_excitation_create(context, model, &drive));
    assert_ok(context, trk_excitation_add_profile(drive, one_track ? TRK_ROAD_ALL : TRK_ROAD_LEFT,
                                                  left, 1, speed, 0));
    if (!one_track)
        assert_ok(context, trk_excitation_add_profile(drive, TRK_ROAD_RIGHT, right, 1, speed, 0));
    trk_simulate_options_init(&options, sizeof options);
    options.duration = duration + SETTLE;
    options.record_every = 2;
    assert_ok(context, trk_simulate(context, model, drive, NULL, &options, NULL, NULL, &run));
    const int64_t first = (int64_t)(SETTLE * trk_series_rate(run)),
                  samples = trk_series_samples(run);
    for (int32_t j = 0; j < trk_series_channels(run); j++) {
        const double *x = trk_series_data(run, j + 1);
        double sum = 0, square = 0;
        for (int64_t k = first; k < samples; k++) {
            sum += x[k];
            square += x[k] * x[k];
        }
        const double n = (double)(samples - first);
        out[j] = sqrt(square / n - sum / n * (sum / n));
    }
    trk_series_destroy(run);
    trk_excitation_destroy(drive);
    trk_signal_destroy(left);
    trk_signal_destroy(right);
}

static errors compare(const trk_model *model, const double *computed, const double *stepped,
                      const char *what)
{
    errors e = {0, 0};
    int moving = 0;
    for (int32_t j = 0; j < trk_model_count(model, TRK_PART_SENSOR); j++) {
        if (stepped[j] < 1e-9) /* a place that does not move that way */
            continue;
        const double error = computed[j] / stepped[j] - 1;
        if (getenv("TRK_SHOW"))
            print_message("%-8s %-26s %10.4g %+6.1f %%\n", what,
                          trk_model_part_name(model, TRK_PART_SENSOR, j + 1), stepped[j],
                          100 * error);
        e.mean += error * error;
        moving++;
        e.largest = fmax(e.largest, fabs(error));
    }
    e.mean = sqrt(e.mean / moving);
    return e;
}

/* Errors in motion on a road; those at rest beside. */
static errors judge(trk_context *context, const trk_model *model, trk_road_class road_class,
                    double duration, errors *out_at_rest)
{
    double at_rest[SENSORS], in_motion[SENSORS], stepped[SENSORS];
    const trk_road_options road = road_of(road_class);
    assert_true(trk_model_count(model, TRK_PART_SENSOR) <= SENSORS);
    assert_true(trk_model_count(model, TRK_PART_ROAD) + trk_model_count(model, TRK_PART_PORT) <=
                INPUTS);
    by_spectra(context, model, &road, at_rest, in_motion);
    by_run(context, model, road, duration, stepped);
    *out_at_rest = compare(model, at_rest, stepped, "at rest");
    const errors e = compare(model, in_motion, stepped, "motion");
    print_message(
        "class %c: errors in motion %4.1f %% (largest %4.1f %%), at rest %5.1f %% (%5.1f %%)\n",
        '@' + road_class, 100 * e.mean, 100 * e.largest, 100 * out_at_rest->mean,
        100 * out_at_rest->largest);
    return e;
}

/* Damper tables of the thesis, on whole trucks. */
static void test_truck_with_damper_tables(void **state)
{
    trk_spec *spec;
    trk_model *truck;
    errors at_rest;
    assert_ok(*state, trk_vehicle_create_builtin(*state, TRK_VEHICLE_REFERENCE_TRUCK,
                                                 TRK_VARIANT_THESIS_DAMPERS, &spec));
    assert_ok(*state, trk_model_compile(*state, spec, NULL, &truck));
    for (trk_road_class k = TRK_ROAD_CLASS_A; k <= TRK_ROAD_CLASS_D; k++) {
        const errors e = judge(*state, truck, k, 120, &at_rest);
        assert_true(e.mean < 0.08 && e.largest < 0.22);
        assert_true(e.mean < 0.6 * at_rest.mean);
    }
    trk_model_destroy(truck);
    trk_spec_destroy(spec);
}

/* A quarter car on a leaf spring: at rest its friction sticks, and the tangents are of no use. */
static void test_leaf_spring(void **state)
{
    static const double limit[] = {0.24, 0.2, 0.12, 0.06};
    trk_quarter_car_parameters p;
    trk_leaf_options friction;
    trk_link_options link;
    trk_sensor_options sensor;
    trk_spec *spec;
    trk_model *car;
    trk_law *leaf;
    errors at_rest;
    trk_quarter_car_parameters_init(&p, sizeof p);
    p.sprung_mass = 3000;
    p.unsprung_mass = 540;
    p.spring_stiffness = 250e3;
    p.damping = 15e3;
    assert_ok(*state, trk_vehicle_create_quarter_car(*state, &p, &spec));
    trk_leaf_options_init(&friction, sizeof friction);
    friction.friction = 2500;
    friction.approach_bump = 2e-3;
    assert_ok(*state, trk_law_create_leaf(*state, "leaf", &friction, &leaf));
    trk_link_options_init(&link, sizeof link);
    trk_sensor_options_init(&sensor, sizeof sensor);
    sensor.link = trk_spec_find(spec, TRK_PART_LINK, "spring");
    assert_ok(*state, trk_spec_get_link(spec, sensor.link, &link));
    link.law = leaf;
    assert_ok(*state, trk_spec_set_link(spec, sensor.link, &link));
    sensor.quantity = TRK_QUANTITY_ELONGATION;
    assert_ok(*state, trk_spec_add_sensor(spec, "travel", &sensor, NULL));
    assert_ok(*state, trk_model_compile(*state, spec, NULL, &car));
    for (trk_road_class k = TRK_ROAD_CLASS_A; k <= TRK_ROAD_CLASS_D; k++) {
        const errors e = judge(*state, car, k, 300, &at_rest);
        assert_true(e.mean < limit[k - 1] && at_rest.mean > 0.5);
    }
    trk_model_destroy(car);
    trk_spec_destroy(spec);
    trk_law_destroy(leaf);
}

int main(void)
{
    if (!trk_has_feature(TRK_FEATURE_LAPACK))
        return 0;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_truck_with_damper_tables),
        cmocka_unit_test(test_leaf_spring),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
