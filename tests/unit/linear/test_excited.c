/* SPDX-License-Identifier: MIT */
/* Needs LAPACK.
 * Spectra without time stepping against trk_simulate() and trk_psd() on the sweep of the
 * thesis: within the bound (LINEAR.12), nearer with longer segments, and off where they must be.
 */
#include "models.h"
#include "vehicles.h"

#include "linalg/complex.h"

#include <truckride/simulate.h>

typedef struct trial {
    trk_model *model;
    trk_excitation *road;
    trk_signal *sweep;
    trk_series *series;
    int32_t sensors;
    double gain[8], delay[8];
} trial;

/* The sweep of the thesis, in so many seconds; the right side sees 0.6 of it, the rear is late. */
static trial drive(trk_context *context, trk_vehicle vehicle, trk_variant variant, double duration)
{
    trial t;
    memset(&t, 0, sizeof t);
    t.model = support_model(context, vehicle, variant, 0);
    t.sensors = trk_model_count(t.model, TRK_PART_SENSOR);
    trk_sweep_options sweep;
    trk_simulate_options run;
    trk_sweep_options_init(&sweep, sizeof sweep);
    trk_simulate_options_init(&run, sizeof run);
    run.duration = sweep.duration = duration;
    run.method = TRK_METHOD_RUNGE_KUTTA;
    assert_ok(context, trk_signal_create_sweep(context, &sweep, &t.sweep));
    assert_ok(context, trk_excitation_create(context, t.model, &t.road));
    for (int32_t k = 0; k < trk_model_count(t.model, TRK_PART_ROAD); k++) {
        double x, y;
        assert_int_equal(trk_model_get_road_place(t.model, k + 1, &x, &y), TRK_OK);
        t.gain[k] = y < 0 ? 0.6 : 1;
        t.delay[k] = x < -1 ? 0.25 : 0;
        assert_ok(context,
                  trk_excitation_add_motion(t.road, k + 1, t.sweep, t.gain[k], t.delay[k]));
    }
    assert_ok(context, trk_simulate(context, t.model, t.road, NULL, &run, NULL, NULL, &t.series));
    return t;
}

static void clear(trial *t)
{
    trk_series_destroy(t->series);
    trk_excitation_destroy(t->road);
    trk_signal_destroy(t->sweep);
    trk_model_destroy(t->model);
}

/* (LINEAR.12) at one frequency from responses at f - d, f, f + d. */
static double bound(const double *h, int32_t sensors, double d, double segment)
{
    double complex low = trk_complex(h[0], h[1]),
                   middle = trk_complex(h[2 * sensors], h[2 * sensors + 1]),
                   high = trk_complex(h[4 * sensors], h[4 * sensors + 1]);
    double first = cabs(high - low) / (2 * d) / cabs(middle) / segment;
    double second = cabs(high - 2 * middle + low) / (d * d) / cabs(middle) / (segment * segment);
    double b = first + second / 2; /* 2 pi of the bound and of d/dw cancel */
    return 2 * b + b * b;
}

typedef struct verdict {
    double error, over_bound, rms;
} verdict;

static verdict compare(trk_context *context, const trial *t, int64_t segment)
{
    trk_spectrum_options options;
    trk_spectrum_options_init(&options, sizeof options);
    options.segment_length = segment;
    int64_t samples = trk_series_samples(t->series), length = trk_psd_length(&options, samples);
    double step = 1000.0 / (double)segment, d = 1e-3, rms[64];
    int64_t first = (int64_t)(1 / step) + 1, count = (int64_t)(18 / step) - first;
    double *lane = calloc((size_t)(t->sensors * length), 8), *psd = calloc((size_t)length, 8);
    double *near = calloc((size_t)(3 * count), 8);
    double *h = calloc((size_t)(6 * count * t->sensors), 8);
    for (int64_t k = 0; k < 3 * count; k++)
        near[k] = step * (double)(first + k / 3) + d * (double)(k % 3 - 1);
    assert_ok(context, trk_response_psd_excited(context, t->model, NULL, NULL, t->road, 0, 1e-3,
                                                samples, &options, lane, rms));
    assert_ok(context, trk_frequency_response(context, t->model, NULL, NULL, 3 * count, near,
                                              t->gain, t->delay, NULL, h));
    verdict v = {0, 0, 0};
    for (int32_t s = 0; s < t->sensors; s++) {
        double peak = 0, whole;
        assert_ok(context, trk_psd(context, samples, trk_series_data(t->series, s + 1), 1000,
                                   &options, psd));
        assert_ok(context, trk_band_rms(context, length, psd, step, 0, 1000, &whole));
        v.rms = fmax(v.rms, fabs(rms[s] / whole - 1));
        for (int64_t k = 0; k < length; k++)
            peak = fmax(peak, psd[k]);
        for (int64_t k = 0; k < count; k++) {
            double wanted = psd[first + k], got = lane[s * length + first + k];
            if (wanted < 1e-3 * peak)
                continue;
            double error = fabs(wanted / got - 1);
            v.error = fmax(v.error, error);
            v.over_bound = fmax(v.over_bound, error / bound(h + 2 * (3 * k * t->sensors + s),
                                                            t->sensors, d, 1 / step));
        }
    }
    print_message("  segment %lld: error %.3g, over bound %.3g, RMS %.2g\n", (long long)segment,
                  v.error, v.over_bound, v.rms);
    free(lane);
    free(psd);
    free(near);
    free(h);
    return v;
}

static void test_sweep_of_the_thesis(void **state)
{
    static const trk_vehicle vehicles[] = {TRK_VEHICLE_REFERENCE_FRONT, TRK_VEHICLE_REFERENCE_HALF,
                                           TRK_VEHICLE_REFERENCE_TRUCK};
    for (int k = 0; k < 3; k++) {
        trial t = drive(*state, vehicles[k], TRK_VARIANT_LINEAR, 480);
        verdict v[3];
        print_message("%s\n", support_vehicle_name(vehicles[k]));
        for (int i = 0; i < 3; i++) {
            v[i] = compare(*state, &t, 2048 << i);
            assert_true(v[i].over_bound < 1);
        }
        assert_true(v[1].rms < 0.03 && v[2].rms < 0.01);
        assert_true(v[2].rms < v[1].rms / 2 && v[1].rms < v[0].rms / 2);
        assert_true(v[2].error < v[0].error / 2);
        clear(&t);
    }
}

/* A quick sweep crosses a resonance within a segment: the bound, for slow ones, is left. */
static void test_quick_sweep_is_worse(void **state)
{
    double error[3];
    for (int k = 0; k < 3; k++) {
        trial t = drive(*state, TRK_VEHICLE_REFERENCE_FRONT, TRK_VARIANT_LINEAR, 30 << 2 * k);
        error[k] = compare(*state, &t, 8192).error;
        clear(&t);
    }
    assert_true(error[0] > 4 * error[1] && error[1] > error[2]);
}

/* Curved dampers make other frequencies of one sine: no linear lane can know. */
static void test_curved_dampers_are_not_linear(void **state)
{
    trial t = drive(*state, TRK_VEHICLE_REFERENCE_FRONT, TRK_VARIANT_THESIS_DAMPERS, 120);
    assert_true(compare(*state, &t, 4096).rms > 0.1);
    clear(&t);
}

static void test_errors(void **state)
{
    trk_model *model = builtin(*state, TRK_VEHICLE_REFERENCE_FRONT);
    trk_model *truck = builtin(*state, TRK_VEHICLE_REFERENCE_TRUCK);
    trk_excitation *road;
    trk_spectrum_options options;
    double out[4096];
    assert_ok(*state, trk_excitation_create(*state, model, &road));
    trk_spectrum_options_init(&options, sizeof options);
    options.segment_length = 64;
    assert_ok(*state, trk_response_psd_excited(*state, model, NULL, NULL, road, 0, 1e-3, 200,
                                               &options, out, NULL));
    for (int k = 0; k < 33 * trk_model_count(model, TRK_PART_SENSOR); k++)
        assert_true(out[k] == 0);
    assert_status(*state,
                  trk_response_psd_excited(*state, truck, NULL, NULL, road, 0, 1e-3, 200, &options,
                                           out, NULL),
                  TRK_E_ARGUMENT);
    assert_message(*state, "the excitation has 1 roads");
    assert_status(*state,
                  trk_response_psd_excited(*state, model, NULL, NULL, NULL, 0, 1e-3, 200, &options,
                                           out, NULL),
                  TRK_E_ARGUMENT);
    assert_status(*state,
                  trk_response_psd_excited(*state, model, NULL, NULL, road, NAN, 1e-3, 200,
                                           &options, out, NULL),
                  TRK_E_RANGE);
    assert_status(
        *state,
        trk_response_psd_excited(*state, model, NULL, NULL, road, 0, 0, 200, &options, out, NULL),
        TRK_E_RANGE);
    assert_status(
        *state,
        trk_response_psd_excited(*state, model, NULL, NULL, road, 0, 1e-3, 63, &options, out, NULL),
        TRK_E_RANGE);
    trk_excitation_destroy(road);
    /* 2^62 samples of four roads and two ports: their number leaves 64 bits. */
    assert_ok(*state, trk_excitation_create(*state, truck, &road));
    assert_status(*state,
                  trk_response_psd_excited(*state, truck, NULL, NULL, road, 0, 1e-3,
                                           INT64_MAX / 2 + 1, &options, out, NULL),
                  TRK_E_MEMORY);
    assert_message(*state, "samples of 6 inputs exceed the address space");
    trk_excitation_destroy(road);
    trk_model_destroy(model);
    trk_model_destroy(truck);
}

static trk_status respond(trk_context *context)
{
    double out[16 * 33];
    trk_spec *spec = NULL;
    trk_model *model = NULL;
    trk_signal *sine = NULL;
    trk_excitation *road = NULL;
    trk_spectrum_options options;
    trk_spectrum_options_init(&options, sizeof options);
    options.segment_length = 64;
    trk_status status =
        trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_FRONT, TRK_VARIANT_LINEAR, &spec);
    if (status == TRK_OK)
        status = trk_model_compile(context, spec, NULL, &model);
    if (status == TRK_OK)
        status = trk_signal_create_sine(context, 0.01, 2, 0, 0, &sine);
    if (status == TRK_OK)
        status = trk_excitation_create(context, model, &road);
    if (status == TRK_OK)
        status = trk_excitation_add_motion(road, TRK_ROAD_ALL, sine, 1, 0);
    if (status == TRK_OK)
        status = trk_response_psd_excited(context, model, NULL, NULL, road, 0, 1e-3, 200, &options,
                                          out, NULL);
    trk_excitation_destroy(road);
    trk_signal_destroy(sine);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    return status;
}

static void test_lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(respond);
}

int main(void)
{
    if (!trk_has_feature(TRK_FEATURE_LAPACK))
        return 0;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_sweep_of_the_thesis, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_quick_sweep_is_worse, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_curved_dampers_are_not_linear, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(test_errors, support_setup, support_teardown),
        cmocka_unit_test(test_lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
