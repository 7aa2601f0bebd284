/* SPDX-License-Identifier: MIT */
/* Dose values and ratios of a weighted acceleration, block by block (COMFORT.6, COMFORT.7). */
#include "comfort/check.h"
#include "comfort/running.h"
#include "comfort/sum.h"

#include <math.h>

struct trk_vibration_meter {
    trk_context *context;
    double sample_rate;
    int64_t samples;
    trk_sum square, fourth;
    double peak, mtvv, mtvv_exponential; /* the last two squared */
    trk_running running;
};

trk_status trk_vibration_meter_create(trk_context *context, double sample_rate,
                                      double integration_time, trk_vibration_meter **out_meter)
{
    TRK_REQUIRE(context, out_meter, "trk_vibration_meter_create");
    *out_meter = NULL;
    TRK_REQUIRE(context, context, "trk_vibration_meter_create");
    trk_running running;
    trk_status status = trk_running_create(context, "trk_vibration_meter_create", sample_rate,
                                           integration_time, &running);
    if (status != TRK_OK)
        return status;
    trk_vibration_meter *meter = trk_new(context, 1, sizeof *meter);
    if (!meter) {
        trk_running_destroy(context, &running);
        return TRK_E_MEMORY;
    }
    *meter =
        (trk_vibration_meter){.context = context, .sample_rate = sample_rate, .running = running};
    *out_meter = meter;
    return TRK_OK;
}

void trk_vibration_meter_destroy(trk_vibration_meter *meter)
{
    if (!meter)
        return;
    trk_running_destroy(meter->context, &meter->running);
    trk_free(meter->context, meter);
}

void trk_vibration_meter_reset(trk_vibration_meter *meter)
{
    if (!meter)
        return;
    trk_running_reset(&meter->running);
    *meter = (trk_vibration_meter){
        .context = meter->context, .sample_rate = meter->sample_rate, .running = meter->running};
}

trk_status trk_vibration_meter_process(trk_vibration_meter *meter, int64_t count, const double *x)
{
    if (!meter)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(meter->context, x, "trk_vibration_meter_process");
    trk_status status =
        trk_comfort_check_samples(meter->context, "trk_vibration_meter_process", "x", 0, count, x);
    if (status != TRK_OK)
        return status;
    for (int64_t i = 0; i < count; i++) {
        double square = x[i] * x[i];
        trk_sum_add(&meter->square, square);
        trk_sum_add(&meter->fourth, square * square);
        meter->peak = fmax(meter->peak, fabs(x[i]));
        meter->mtvv = fmax(meter->mtvv, trk_running_linear(&meter->running, x[i]));
        meter->mtvv_exponential =
            fmax(meter->mtvv_exponential, trk_running_exponential(&meter->running, x[i]));
    }
    meter->samples += count;
    return TRK_OK;
}

/* Limits of ISO 2631-1:1997, 6.2.1 and 6.3.3. */
static int32_t additional_reasons(const trk_vibration *v)
{
    return (v->crest_factor > 9 ? TRK_ADDITIONAL_CREST : 0) |
           (v->mtvv_ratio > 1.5 ? TRK_ADDITIONAL_MTVV : 0) |
           (v->vdv_ratio > 1.75 ? TRK_ADDITIONAL_VDV : 0);
}

trk_status trk_vibration_meter_read(const trk_vibration_meter *meter, trk_vibration *out_vibration)
{
    if (!meter || !out_vibration)
        return TRK_E_ARGUMENT;
    if (meter->samples == 0)
        return TRK_E_RANGE;
    trk_vibration v = {.struct_size = sizeof v, .reserved = 0};
    v.duration = (double)meter->samples / meter->sample_rate;
    double root = sqrt(sqrt(v.duration));
    v.rms = sqrt(trk_sum_value(&meter->square) / (double)meter->samples);
    v.peak = meter->peak;
    v.mtvv = sqrt(meter->mtvv);
    v.mtvv_exponential = sqrt(meter->mtvv_exponential);
    v.vdv = sqrt(sqrt(trk_sum_value(&meter->fourth) / meter->sample_rate));
    v.evdv = 1.4 * v.rms * root;
    v.msdv = v.rms * sqrt(v.duration);
    v.crest_factor = v.peak / v.rms;
    v.mtvv_ratio = v.mtvv / v.rms;
    v.vdv_ratio = v.vdv / (v.rms * root);
    v.additional = additional_reasons(&v);
    return trk_write_options(out_vibration, &v, sizeof v);
}

trk_status trk_vibration_measure(trk_context *context, int64_t count, const double *x,
                                 double sample_rate, trk_vibration *out_vibration)
{
    static const char what[] = "trk_vibration_measure";
    TRK_REQUIRE(context, context, "trk_vibration_measure");
    TRK_REQUIRE(context, x, "trk_vibration_measure");
    TRK_REQUIRE(context, out_vibration, "trk_vibration_measure");
    trk_status status = trk_comfort_check_result(context, what, out_vibration);
    if (status == TRK_OK)
        status = trk_comfort_check_samples(context, what, "x", 1, count, x);
    if (status != TRK_OK)
        return status;
    trk_vibration_meter *meter;
    status = trk_vibration_meter_create(context, sample_rate, 1, &meter);
    if (status == TRK_OK)
        status = trk_vibration_meter_process(meter, count, x);
    if (status == TRK_OK)
        status = trk_vibration_meter_read(meter, out_vibration);
    trk_vibration_meter_destroy(meter);
    return status;
}
