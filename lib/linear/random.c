/* SPDX-License-Identifier: MIT */
/* Spectra of the sensors from spectra of the inputs (LINEAR.6). */
#include "linear/random.h"

#include "linalg/complex.h"
#include "model/model.h"

#include <math.h>

static const double two_pi = 6.283185307179586476925286766559;

/* row . x for a complex x. */
static double complex dot(const trk_rows *rows, int32_t row, const double complex *x)
{
    double complex sum = 0;
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        sum += rows->value[k] * x[rows->column[k]];
    return sum;
}

double complex trk_random_elongation(const trk_superposition *s, int32_t link, int32_t input)
{
    const trk_rows *roads = &s->model->roads;
    double complex e = dot(&s->model->links, link, s->q + (int64_t)input * s->n);
    for (int64_t k = roads->start[link]; k < roads->start[link + 1]; k++)
        if (roads->column[k] == input)
            e -= roads->value[k];
    return e;
}

/* Sensor for unit input j at omega, whose coordinates are q. */
static double complex sensor_value(const trk_superposition *s, int32_t sensor, int32_t input,
                                   double omega)
{
    const trk_model *model = s->model;
    int32_t link = model->sensor_link[sensor];
    double complex iw = trk_complex(0, omega);
    if (link < 0) {
        double complex x = dot(&model->sensors, sensor, s->q + (int64_t)input * s->n);
        switch (model->sensor_quantity[sensor]) {
        case TRK_QUANTITY_DISPLACEMENT: return x;
        case TRK_QUANTITY_VELOCITY: return iw * x;
        default: return -omega * omega * x;
        }
    }
    double complex e = trk_random_elongation(s, link, input);
    switch (model->sensor_quantity[sensor]) {
    case TRK_QUANTITY_ELONGATION: return e;
    case TRK_QUANTITY_RATE: return iw * e;
    default: return trk_complex(s->link_stiffness[link], omega * s->link_damping[link]) * e;
    }
}

double trk_random_form(int32_t inputs, const double complex *h, const double *input)
{
    double sum = 0;
    for (int32_t i = 0; i < inputs; i++)
        for (int32_t j = i; j < inputs; j++) {
            const double *s = input + 2 * ((int64_t)i * inputs + j);
            double re = creal(h[i]) * creal(h[j]) + cimag(h[i]) * cimag(h[j]);
            double im = creal(h[i]) * cimag(h[j]) - cimag(h[i]) * creal(h[j]);
            sum += i == j ? re * s[0] : 2 * (re * s[0] - im * s[1]);
        }
    return fmax(sum, 0); /* rounding of a sum that is not negative */
}

trk_status trk_random_response(trk_superposition *s, int64_t count, const double *frequency,
                               const double *input, double *out_density)
{
    int32_t inputs = s->inputs, sensors = s->model->sensors.count;
    double complex *h = trk_new(s->context, inputs, sizeof *h);
    trk_status status = h ? TRK_OK : TRK_E_MEMORY;
    for (int64_t f = 0; status == TRK_OK && f < count; f++) {
        double omega = two_pi * frequency[f];
        status = trk_superposition_solve(s, omega);
        for (int32_t k = 0; status == TRK_OK && k < sensors; k++) {
            for (int32_t j = 0; j < inputs; j++)
                h[j] = sensor_value(s, k, j, omega);
            out_density[k * count + f] =
                trk_random_form(inputs, h, input + 2 * f * (int64_t)inputs * inputs);
        }
    }
    trk_free(s->context, h);
    return status;
}

trk_status trk_random_check(trk_context *context, const char *what, const trk_model *model,
                            int64_t count, const double *frequency, const double *input)
{
    int64_t inputs = (int64_t)trk_model_count(model, TRK_PART_ROAD) + model->ports.count;
    if (count < 1)
        return trk_fail(context, TRK_E_RANGE, "%s: count is %lld; at least 1 is needed", what,
                        (long long)count);
    for (int64_t k = 0; k < count; k++)
        if (!isfinite(frequency[k]) || frequency[k] < 0 ||
            (k > 0 && !(frequency[k] > frequency[k - 1])))
            return trk_fail(context, TRK_E_RANGE,
                            "%s: frequency[%lld] is %g Hz; a finite number >= 0 above the one "
                            "before is needed",
                            what, (long long)k, frequency[k]);
    for (int64_t k = 0; k < 2 * count * inputs * inputs; k++)
        if (!isfinite(input[k]))
            return trk_fail(context, TRK_E_RANGE,
                            "%s: input[%lld] is %g; a finite number is needed", what, (long long)k,
                            input[k]);
    for (int64_t k = 0; k < count * inputs; k++) {
        double density = input[2 * (k / inputs * inputs * inputs + k % inputs * (inputs + 1))];
        if (density < 0)
            return trk_fail(context, TRK_E_RANGE,
                            "%s: the PSD of input %lld at %g Hz is %g; a number >= 0 is needed",
                            what, (long long)(k % inputs + 1), frequency[k / inputs], density);
    }
    return TRK_OK;
}

/* Trapezoidal rule over the frequencies (LINEAR.10). */
static double find_rms(int64_t count, const double *frequency, const double *density)
{
    double sum = 0;
    for (int64_t k = 1; k < count; k++)
        sum += (frequency[k] - frequency[k - 1]) * (density[k] + density[k - 1]) / 2;
    return sqrt(sum);
}

static trk_status respond(trk_context *context, const trk_model *model, const double *q,
                          const double *v, int64_t count, const double *frequency,
                          const double *input, double *out_density, double *out_rms)
{
    trk_superposition s;
    trk_status status = trk_superposition_create(context, model, q, v, &s);
    if (status == TRK_OK)
        status = trk_random_response(&s, count, frequency, input, out_density);
    trk_superposition_clear(&s);
    for (int32_t k = 0; status == TRK_OK && out_rms && k < model->sensors.count; k++)
        out_rms[k] = find_rms(count, frequency, out_density + k * count);
    return status;
}

trk_status trk_response_psd(trk_context *context, const trk_model *model, const double *q,
                            const double *v, int64_t count, const double *frequency,
                            const double *input, double *out_density, double *out_rms)
{
    TRK_REQUIRE(context, context, "trk_response_psd");
    TRK_REQUIRE(context, model, "trk_response_psd");
    TRK_REQUIRE(context, frequency, "trk_response_psd");
    TRK_REQUIRE(context, input, "trk_response_psd");
    if (!out_density && !out_rms)
        return trk_fail(context, TRK_E_ARGUMENT,
                        "trk_response_psd: out_density and out_rms are NULL");
    trk_status status =
        trk_random_check(context, "trk_response_psd", model, count, frequency, input);
    if (status != TRK_OK)
        return status;
    double *density = out_density;
    if (!density && !(density = trk_new(context, model->sensors.count * count, sizeof *density)))
        return TRK_E_MEMORY;
    status = respond(context, model, q, v, count, frequency, input, density, out_rms);
    if (!out_density)
        trk_free(context, density);
    return status;
}
