/* SPDX-License-Identifier: MIT */
/* Frequency response of all sensors (LINEAR.3). */
#include "linear/tangent.h"

#include "linalg/eigen.h"
#include "model/model.h"
#include <truckride/linear.h>

#include <complex.h>
#include <math.h>
#include <string.h>

static const double two_pi = 6.283185307179586476925286766559;

/* One call. */
typedef struct response {
    trk_context *context;
    const trk_model *model;
    trk_tangent tangent;
    double *link_stiffness, *link_damping; /* tangents, by link         */
    const double *road_gain, *road_delay, *load_gain;
    double complex *road;   /* u at this frequency       */
    double complex *q;      /* response of coordinates   */
    double complex *matrix; /* K + i w C - w^2 M         */
} response;

/* row . x for a complex x. */
static double complex dot(const trk_rows *rows, int32_t row, const double complex *x)
{
    double complex sum = 0;
    for (int64_t k = rows->start[row]; k < rows->start[row + 1]; k++)
        sum += rows->value[k] * x[rows->column[k]];
    return sum;
}

static trk_status solve_at(response *r, double omega)
{
    const trk_model *model = r->model;
    int32_t n = model->n;
    for (int32_t k = 0; k < model->names[TRK_PART_ROAD].count; k++) {
        double gain = r->road_gain ? r->road_gain[k] : 0;
        r->road[k] = gain * cexp(-I * omega * (r->road_delay ? r->road_delay[k] : 0));
    }
    memset(r->q, 0, (size_t)n * sizeof *r->q);
    for (int32_t k = 0; k < model->links.count; k++) {
        double complex f = (r->link_stiffness[k] + I * omega * r->link_damping[k]) *
                           dot(&model->roads, k, r->road);
        for (int64_t j = model->links.start[k]; j < model->links.start[k + 1]; j++)
            r->q[model->links.column[j]] += model->links.value[j] * f;
    }
    for (int32_t k = 0; r->load_gain && k < model->ports.count; k++)
        for (int64_t j = model->ports.start[k]; j < model->ports.start[k + 1]; j++)
            r->q[model->ports.column[j]] += model->ports.value[j] * r->load_gain[k];
    for (int64_t k = 0; k < (int64_t)n * n; k++)
        r->matrix[k] = r->tangent.stiffness[k] - omega * omega * r->tangent.mass[k] +
                       I * omega * r->tangent.damping[k];
    return trk_complex_solve(r->context, n, 1, (double *)r->matrix, (double *)r->q);
}

static double complex sensor_value(const response *r, int32_t sensor, double omega)
{
    const trk_model *model = r->model;
    int32_t link = model->sensor_link[sensor];
    double complex iw = I * omega;
    if (link < 0) {
        double complex x = dot(&model->sensors, sensor, r->q);
        switch (model->sensor_quantity[sensor]) {
        case TRK_QUANTITY_DISPLACEMENT: return x;
        case TRK_QUANTITY_VELOCITY: return iw * x;
        default: return iw * iw * x;
        }
    }
    double complex e = dot(&model->links, link, r->q) - dot(&model->roads, link, r->road);
    switch (model->sensor_quantity[sensor]) {
    case TRK_QUANTITY_ELONGATION: return e;
    case TRK_QUANTITY_RATE: return iw * e;
    default: return (r->link_stiffness[link] + iw * r->link_damping[link]) * e;
    }
}

static trk_status sweep(response *r, int64_t count, const double *frequency, double *out)
{
    int32_t sensors = r->model->sensors.count;
    for (int64_t f = 0; f < count; f++) {
        double omega = two_pi * frequency[f];
        trk_status status = solve_at(r, omega);
        if (status == TRK_E_SINGULAR)
            return trk_fail(r->context, status, "%s: an undamped resonance lies at %.9g Hz",
                            trk_model_name(r->model), frequency[f]);
        if (status != TRK_OK)
            return status;
        for (int32_t k = 0; k < sensors; k++) {
            double complex y = sensor_value(r, k, omega);
            *out++ = creal(y);
            *out++ = cimag(y);
        }
    }
    return TRK_OK;
}

static trk_status check(trk_context *context, const char *what, int64_t count, const double *values,
                        double low)
{
    for (int64_t k = 0; values && k < count; k++)
        if (!isfinite(values[k]) || values[k] < low)
            return trk_fail(
                context, TRK_E_RANGE, "trk_frequency_response: %s[%lld] is %g; %s is needed", what,
                (long long)k, values[k], low == 0 ? "a finite number >= 0" : "a finite number");
    return TRK_OK;
}

static trk_status run(response *r, const double *q, const double *v, int64_t count,
                      const double *frequency, double *out)
{
    const trk_model *model = r->model;
    r->link_stiffness = trk_new(r->context, model->links.count, sizeof(double));
    r->link_damping = trk_new(r->context, model->links.count, sizeof(double));
    r->road = trk_new(r->context, model->names[TRK_PART_ROAD].count, sizeof *r->road);
    r->q = trk_new(r->context, model->n, sizeof *r->q);
    r->matrix = trk_new(r->context, (int64_t)model->n * model->n, sizeof *r->matrix);
    if (!r->link_stiffness || !r->link_damping || !r->road || !r->q || !r->matrix)
        return TRK_E_MEMORY;
    for (int32_t k = 0; k < model->links.count; k++)
        trk_model_link_tangent(model, k, q, v, &r->link_stiffness[k], &r->link_damping[k]);
    return sweep(r, count, frequency, out);
}

trk_status trk_frequency_response(trk_context *context, const trk_model *model, const double *q,
                                  const double *v, int64_t count, const double *frequency,
                                  const double *road_gain, const double *road_delay,
                                  const double *load_gain, double *out_response)
{
    TRK_REQUIRE(context, context, "trk_frequency_response");
    TRK_REQUIRE(context, model, "trk_frequency_response");
    TRK_REQUIRE(context, frequency, "trk_frequency_response");
    TRK_REQUIRE(context, out_response, "trk_frequency_response");
    int32_t roads = trk_model_count(model, TRK_PART_ROAD),
            ports = trk_model_count(model, TRK_PART_PORT);
    response r = {.context = context,
                  .model = model,
                  .road_gain = road_gain,
                  .road_delay = road_delay,
                  .load_gain = load_gain};
    trk_status status = check(context, "frequency", count, frequency, 0);
    if (status == TRK_OK)
        status = check(context, "road_gain", roads, road_gain, -INFINITY);
    if (status == TRK_OK)
        status = check(context, "road_delay", roads, road_delay, -INFINITY);
    if (status == TRK_OK)
        status = check(context, "load_gain", ports, load_gain, -INFINITY);
    if (status == TRK_OK)
        status = trk_tangent_create(context, model, q, v, &r.tangent);
    if (status != TRK_OK)
        return status;
    status = run(&r, q, v, count, frequency, out_response);
    trk_free(context, r.tangent.mass);
    trk_free(context, r.link_stiffness);
    trk_free(context, r.link_damping);
    trk_free(context, r.road);
    trk_free(context, r.q);
    trk_free(context, r.matrix);
    return status;
}
