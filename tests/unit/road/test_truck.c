/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. The linear truck over two tracks: time stepping against spectra. */
#include "profile.h"

#include <truckride/linear.h>
#include <truckride/simulate.h>
#include <truckride/vehicle.h>

enum { COUNT = 6000, SENSORS = 64 };

static const double speed = 20, duration = 900, settle = 20;

/* RMS of each sensor and its relative standard error for a Gaussian record of `duration`. */
static void by_spectra(trk_context *context, const trk_model *model, const trk_road_options *o,
                       double *out_rms, double *out_error)
{
    const int32_t inputs =
        trk_model_count(model, TRK_PART_ROAD) + trk_model_count(model, TRK_PART_PORT);
    const int32_t sensors = trk_model_count(model, TRK_PART_SENSOR);
    assert_true(sensors <= SENSORS);
    double *f = new_profile(COUNT), *n = new_profile(COUNT), *g = new_profile(COUNT);
    double *coherence = new_profile(COUNT), *input = new_profile(2 * COUNT * inputs * inputs);
    double *density = new_profile((int64_t)COUNT * sensors);
    for (int k = 0; k < COUNT; k++) {
        n[k] = o->low * pow(o->high / o->low, k / (COUNT - 1.0));
        n[k] = fmin(n[k], o->high);
        f[k] = n[k] * speed;
    }
    assert_ok(context, trk_road_density(context, o, COUNT, n, g));
    assert_ok(context, trk_road_coherence(context, o, COUNT, n, coherence));
    for (int k = 0; k < COUNT; k++)
        g[k] /= speed;
    assert_ok(context,
              trk_road_cross_spectra(context, model, COUNT, f, g, speed, coherence, input));
    assert_ok(context,
              trk_response_psd(context, model, NULL, NULL, COUNT, f, input, density, out_rms));
    for (int32_t j = 0; j < sensors; j++) {
        double squares = 0;
        for (int k = 1; k < COUNT; k++)
            squares += (f[k] - f[k - 1]) * pow(density[j * COUNT + k], 2);
        out_error[j] = 0.5 * sqrt(squares / duration) / (out_rms[j] * out_rms[j]);
    }
    free(f);
    free(n);
    free(g);
    free(coherence);
    free(input);
    free(density);
}

static void test_truck_in_time_and_frequency(void **state)
{
    trk_context *c = *state;
    trk_spec *spec;
    trk_model *model;
    double rms[SENSORS], error[SENSORS], worst = 0, mean = 0;
    assert_ok(
        c, trk_vehicle_create_builtin(c, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_LINEAR, &spec));
    assert_ok(c, trk_model_compile(c, spec, NULL, &model));
    trk_road_options o = road_options();
    o.unevenness = trk_road_class_unevenness(TRK_ROAD_CLASS_C);
    o.contact_length = 0.2;
    o.track_width = 2.068;
    by_spectra(c, model, &o, rms, error);

    o.ramp_start = 10;
    o.ramp_length = 100;
    trk_signal *left, *right;
    trk_excitation *road;
    trk_simulate_options run;
    trk_series *series;
    assert_ok(c, trk_road_create(c, &o, &left, &right));
    assert_ok(c, trk_excitation_create(c, model, &road));
    assert_ok(c, trk_excitation_add_profile(road, TRK_ROAD_LEFT, left, 1, speed, 0));
    assert_ok(c, trk_excitation_add_profile(road, TRK_ROAD_RIGHT, right, 1, speed, 0));
    trk_simulate_options_init(&run, sizeof run);
    run.duration = duration + settle;
    run.record_every = 5;
    run.method = TRK_METHOD_RUNGE_KUTTA;
    assert_ok(c, trk_simulate(c, model, road, NULL, &run, NULL, NULL, &series));
    const int64_t samples = trk_series_samples(series);
    const int64_t first = (int64_t)(settle * trk_series_rate(series));
    const int32_t sensors = trk_series_channels(series);
    int counted = 0;
    for (int32_t j = 0; j < sensors; j++) {
        const double *x = trk_series_data(series, j + 1);
        double square = 0;
        for (int64_t k = first; k < samples; k++)
            square += x[k] * x[k] / (double)(samples - first);
        if (!(rms[j] > 1e-12))
            continue;
        const double difference = sqrt(square) / rms[j] - 1;
        if (getenv("TRK_SHOW"))
            print_message("%-24s %9.4g difference %7.4f standard error %.4f\n",
                          trk_series_name(series, j + 1), rms[j], difference, error[j]);
        worst = fmax(worst, fabs(difference) / error[j]);
        mean += pow(difference / error[j], 2);
        counted++;
    }
    print_message("%d sensors: largest difference %.2f, RMS %.2f standard errors\n", counted, worst,
                  sqrt(mean / counted));
    assert_true(counted > 10 && worst < 3);
    trk_series_destroy(series);
    trk_excitation_destroy(road);
    trk_signal_destroy(left);
    trk_signal_destroy(right);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_truck_in_time_and_frequency),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
