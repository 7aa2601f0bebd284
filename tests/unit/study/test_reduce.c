/* SPDX-License-Identifier: MIT */
/* Outputs computed on the way against trk_simulate() and trk_psd() computed afterwards. */
#include "cases.h"
#include "study/reduce.h"

#include <math.h>

/* Pieces of 1, 2, 3, ... samples or all at once: the same bits as trk_psd(). */
static void a_stream_is_trk_psd_bit_for_bit(void **state)
{
    enum { COUNT = 5000 };
    static double x[COUNT], expected[COUNT], got[COUNT];
    uint32_t noise = 1;
    for (int k = 0; k < COUNT; k++) {
        noise = noise * 1664525u + 1013904223u;
        x[k] = sin(0.05 * k) + 1e-9 * noise + 3;
    }
    static const int64_t segments[] = {1, 2, 7, 64, 100, 256, 997, 1000, 2500, 4999, 5000};
    for (size_t s = 0; s < sizeof segments / sizeof *segments; s++)
        for (int variant = 0; variant < 6; variant++) {
            trk_spectrum_options o;
            trk_spectrum_options_init(&o, sizeof o);
            o.segment_length = segments[s];
            o.overlap = (double[]){0, 0.5, 0.9}[variant % 3];
            o.detrend = variant / 2;
            trk_welch_plan plan;
            trk_welch_stream stream;
            assert_ok(*state, trk_psd(*state, COUNT, x, 100, &o, expected));
            assert_ok(*state, trk_welch_plan_create(*state, "test", COUNT, &o, &plan));
            assert_ok(*state, trk_welch_stream_create(&plan, &stream));
            int64_t room = trk_real_fft_buffer(plan.fft);
            double *buffer[2] = {trk_new(*state, room, 8), trk_new(*state, room, 8)};
            for (int64_t done = 0, piece = 1; done < COUNT; done += piece, piece += variant * 50) {
                piece = piece < COUNT - done ? piece : COUNT - done;
                trk_welch_stream_push(&plan, &stream, piece, x + done, buffer);
            }
            assert_ok(*state, trk_welch_stream_density(&plan, "test", 100, &stream, got));
            assert_memory_equal(got, expected, (size_t)(segments[s] / 2 + 1) * sizeof *got);
            trk_free(*state, buffer[0]);
            trk_free(*state, buffer[1]);
            trk_welch_stream_free(&plan, &stream);
            trk_welch_plan_free(&plan);
        }
}

/* Mean 1e8 times the deviation; variance in long double in two passes. */
static void moments_survive_a_large_mean(void **state)
{
    (void)state;
    enum { COUNT = 100001 };
    static double x[COUNT];
    long double sum = 0, squares = 0;
    for (int k = 0; k < COUNT; k++)
        sum += x[k] = 1e8 + sin(0.7 * k);
    for (int k = 0; k < COUNT; k++)
        squares += (x[k] - sum / COUNT) * (x[k] - sum / COUNT);
    trk_moments m;
    trk_moments_reset(&m);
    for (int k = 0; k < COUNT; k += 7)
        trk_moments_push(&m, k + 7 < COUNT ? 7 : COUNT - k, x + k);
    trk_moments_finish(&m);
    assert_int_equal(m.count, COUNT);
    assert_near(m.mean, (double)(sum / COUNT), 3e-8);
    assert_near(m.squares / (double)squares, 1, 1e-12);
}

/* Neither in a block nor at its ends, whatever comes after it. */
static void moments_keep_a_nan(void **state)
{
    (void)state;
    enum { COUNT = 300 };
    static const int places[] = {0, 3, 127, 128, COUNT - 1};
    for (size_t p = 0; p < sizeof places / sizeof *places; p++) {
        double x[COUNT];
        for (int k = 0; k < COUNT; k++)
            x[k] = k == places[p] ? NAN : k;
        trk_moments m;
        trk_moments_reset(&m);
        trk_moments_push(&m, COUNT, x);
        trk_moments_finish(&m);
        assert_true(isnan(m.minimum) && isnan(m.maximum) && isnan(m.mean));
    }
}

/* The run of one case by trk_batch_run() alone, its samples in a row. */
typedef struct recording {
    double *samples; /* sensors x total */
    int32_t sensors;
    int64_t total;
} recording;

static int32_t record(void *user, int32_t variant, int64_t first, int64_t count,
                      const double *values)
{
    recording *r = user;
    (void)variant;
    for (int32_t s = 0; s < r->sensors; s++)
        memcpy(r->samples + s * r->total + first, values + s * count, (size_t)count * 8);
    return 0;
}

static void check_case(trk_context *context, const study_fixture *f, int64_t number)
{
    double parameters[2], out[10];
    int32_t road;
    trk_spec *spec;
    trk_model *model;
    trk_series *series;
    trk_simulate_options so;
    trk_batch_options bo;
    trk_simulate_options_init(&so, sizeof so);
    trk_batch_options_init(&bo, sizeof bo);
    so.duration = bo.duration = 4;
    assert_int_equal(trk_study_get_case(f->study, number, parameters, &road), TRK_OK);
    assert_int_equal(trk_study_get_outputs(f->study, number, out, NULL), TRK_OK);
    assert_ok(context, trk_spec_copy(context, f->spec, &spec));
    assert_ok(context, trk_spec_vary(spec, TRK_FIELD_STIFFNESS, "*tire", TRK_MEANING_FACTOR,
                                     parameters[0], NULL));
    assert_ok(context, trk_spec_vary(spec, TRK_FIELD_MASS, "sprung", TRK_MEANING_FACTOR,
                                     parameters[1], NULL));
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    const trk_excitation *excitation = road == 1 ? f->rough : f->bump;
    assert_ok(context, trk_simulate(context, model, excitation, NULL, &so, NULL, NULL, &series));
    recording r = {NULL, trk_model_count(model, TRK_PART_SENSOR), trk_series_samples(series)};
    r.samples = calloc((size_t)(r.sensors * r.total), 8);
    assert_ok(context, trk_batch_run(context, 1, (const trk_model *const *)&model, &excitation,
                                     NULL, &bo, record, &r, NULL, NULL, NULL));
    int64_t skip = 400, n = r.total - skip;
    const double *a = r.samples + skip, *b = r.samples + r.total + skip;
    double scale = 0;
    long double sum = 0, sum2 = 0, sum2b = 0;
    double max = -INFINITY, min = INFINITY, peak = 0;
    for (int64_t k = 0; k < n; k++) {
        scale = fmax(scale, fabs(a[k]));
        max = fmax(max, a[k]);
        min = fmin(min, b[k]);
        peak = fmax(peak, fabs(a[k]));
        sum += a[k];
        sum2b += (long double)b[k] * b[k];
        assert_near(a[k], trk_series_data(series, 1)[k + skip], 1e-7 * (1 + scale));
    }
    for (int64_t k = 0; k < n; k++)
        sum2 += (a[k] - sum / n) * (a[k] - sum / n);
    assert_true(out[0] == max && out[1] == min && out[2] == peak);
    assert_near(out[3], (double)(sum / n), 1e-12 * scale);
    assert_near(out[4] / (double)sqrtl(sum2b / n), 1, 1e-12);
    assert_near(out[5] / (double)sqrtl(sum2 / n), 1, 1e-12);

    trk_spectrum_options po;
    trk_spectrum_options_init(&po, sizeof po);
    po.segment_length = 256;
    po.overlap = 0.7;
    double density[129], rms, frequency[64], height[64];
    int64_t count;
    assert_ok(context, trk_psd(context, n, b, 1000, &po, density));
    assert_ok(context, trk_band_rms(context, 129, density, 1000.0 / 256, 2, 12, &rms));
    assert_true(out[6] == rms);
    assert_ok(context, trk_psd(context, n, a, 1000, &po, density));
    assert_ok(context, trk_psd_peaks(context, 129, density, 1000.0 / 256, NULL, 64, frequency,
                                     height, NULL, &count));
    int64_t at = 0;
    while (at < count && at < 64 && frequency[at] > 30)
        at++;
    if (at < count) {
        assert_near(out[7], frequency[at], 1e-12 * frequency[at]);
        assert_true(out[8] == height[at]);
    } else {
        assert_true(isnan(out[7]) && isnan(out[8]));
    }
    double weighted = 0;
    for (int k = 1; k < 129; k++) {
        double hz = k * 1000.0 / 256, w = 0;
        if (hz >= 0.5 && hz < 4)
            w = exp(log(0.4) * (log(4) - log(hz)) / (log(4) - log(0.5)));
        else if (hz >= 4 && hz <= 8)
            w = 1;
        else if (hz > 8 && hz <= 80)
            w = exp(log(0.1) * (log(hz) - log(8)) / (log(80) - log(8)));
        weighted += w * w * density[k] * 1000.0 / 256;
    }
    assert_near(out[9] / sqrt(weighted), 1, 1e-12);
    free(r.samples);
    trk_series_destroy(series);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
}

static void outputs_are_those_of_the_recorded_run(void **state)
{
    study_fixture f = study_open(*state, TRK_DESIGN_LATIN_HYPERCUBE, 3, 4);
    assert_ok(*state, f.status);
    assert_ok(*state, trk_study_run(f.study, NULL, NULL, NULL));
    assert_int_equal(trk_study_finished(f.study), 6);
    for (int64_t k = 0; k < 6; k++)
        check_case(*state, &f, k);
    assert_string_equal(trk_study_output_unit(f.study, 1), "m/s^2");
    assert_string_equal(trk_study_output_unit(f.study, 8), "Hz");
    assert_string_equal(trk_study_output_unit(f.study, 9), "(m/s^2)^2/Hz");
    study_close(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_stream_is_trk_psd_bit_for_bit),
        cmocka_unit_test(moments_survive_a_large_mean),
        cmocka_unit_test(moments_keep_a_nan),
        cmocka_unit_test(outputs_are_those_of_the_recorded_run),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
