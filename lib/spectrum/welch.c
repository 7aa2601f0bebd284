/* SPDX-License-Identifier: MIT */
/* Averaged periodograms: segments side by side in the lanes of the FFT. */
#include "spectrum/welch.h"
#include "spectrum/detrend.h"
#include "spectrum/window.h"

#include <math.h>

enum { MAX_LANES = 8 };

void trk_welch_plan_free(trk_welch_plan *plan)
{
    trk_free(plan->context, plan->window);
    trk_real_fft_destroy(plan->fft);
    *plan = (trk_welch_plan){.context = plan->context};
}

trk_status trk_welch_plan_create(trk_context *context, const char *what, int64_t count,
                                 const trk_spectrum_options *options, trk_welch_plan *out_plan)
{
    *out_plan = (trk_welch_plan){.context = context};
    trk_status status = trk_spectrum_resolve(context, what, options, count, &out_plan->settings);
    if (status != TRK_OK)
        return status;
    const trk_spectrum_options *o = &out_plan->settings.options;
    const int64_t n = o->segment_length;
    out_plan->kernel =
        out_plan->settings.segments > 1 ? trk_fft_kernel_widest() : &trk_fft_kernel_scalar;
    status = trk_real_fft_create(context, n, out_plan->kernel, &out_plan->fft);
    if (status == TRK_OK) {
        out_plan->window = trk_new(context, n, sizeof *out_plan->window);
        status = out_plan->window
                     ? trk_window_fill(context, o->window, o->kaiser_beta, n, out_plan->window)
                     : TRK_E_MEMORY;
    }
    if (status != TRK_OK)
        trk_welch_plan_free(out_plan);
    return status;
}

const double *trk_welch_transform(const trk_welch_plan *plan, int64_t count, const double *x,
                                  double *const buffer[2])
{
    const trk_spectrum_settings *settings = &plan->settings;
    const int64_t n = settings->options.segment_length;
    trk_fft_segment segment[MAX_LANES];
    for (int64_t l = 0; l < plan->kernel->lanes; l++) {
        if (l < count)
            segment[l] = trk_detrend_fit(settings->options.detrend, n, x + l * settings->step);
        else
            segment[l] = (trk_fft_segment){.x = x, .mean = 0, .slope = 0, .gain = 0};
    }
    plan->kernel->load(n, segment, plan->window, buffer[0]);
    return trk_real_fft_forward(plan->fft, buffer[0], buffer[1]);
}

bool trk_welch_reduce(const trk_welch_plan *plan, int64_t count, double *sum)
{
    const int64_t lanes = plan->kernel->lanes;
    bool finite = true;
    for (int64_t k = 0; sum && k < count; k++) {
        double total = 0;
        for (int64_t l = 0; l < lanes; l++)
            total += sum[k * lanes + l];
        sum[k] = total / (double)plan->settings.segments;
        finite = finite && isfinite(sum[k]);
    }
    return finite;
}

static double scale_of(const trk_welch_plan *plan, double sample_rate)
{
    double sum = 0, squares = 0;
    for (int64_t i = 0; i < plan->settings.options.segment_length; i++) {
        sum += plan->window[i];
        squares += plan->window[i] * plan->window[i];
    }
    return plan->settings.options.scaling == TRK_SCALING_DENSITY ? 1 / (sample_rate * squares)
                                                                 : 1 / (sum * sum);
}

/* 0 and, for an even length, the Nyquist frequency have no mirror image. */
static double sides(const trk_welch_plan *plan, int64_t k)
{
    return k == 0 || 2 * k == plan->settings.options.segment_length ? 1 : 2;
}

trk_status trk_welch_write(const trk_welch_plan *plan, const char *what, double sample_rate,
                           int64_t parts, const double *average, double *out)
{
    const double scale = scale_of(plan, sample_rate);
    const int64_t count = parts * plan->settings.length;
    for (int64_t i = 0; i < count; i++)
        if (!isfinite(average[i] * (2 * scale)))
            return trk_fail(plan->context, TRK_E_RANGE,
                            "%s: the spectrum overflows at a sample_rate of %g Hz", what,
                            sample_rate);
    for (int64_t i = 0; i < count; i++)
        out[i] = average[i] * (sides(plan, i / parts) * scale);
    return TRK_OK;
}

void trk_welch_free(trk_welch *welch)
{
    trk_context *context = welch->plan.context;
    trk_free(context, welch->xy);
    trk_free(context, welch->yy);
    trk_free(context, welch->xx);
    for (int i = 0; i < 4; i++)
        trk_free(context, welch->buffer[i]);
    trk_welch_plan_free(&welch->plan);
    *welch = (trk_welch){.plan = {.context = context}};
}

/* NULL stays NULL if not wanted; false when out of memory. */
static bool allocate(trk_welch *welch, bool wanted, int64_t count, double **out)
{
    if (wanted)
        *out = trk_new(welch->plan.context, count, sizeof **out);
    return !wanted || *out;
}

static trk_status prepare(trk_welch *welch, bool two, int wanted)
{
    const int64_t buffer = trk_real_fft_buffer(welch->plan.fft);
    const int64_t sums = welch->plan.settings.length * welch->plan.kernel->lanes;
    if (!allocate(welch, true, buffer, &welch->buffer[0]) ||
        !allocate(welch, true, buffer, &welch->buffer[1]) ||
        !allocate(welch, two, buffer, &welch->buffer[2]) ||
        !allocate(welch, two, buffer, &welch->buffer[3]) ||
        !allocate(welch, wanted & TRK_WELCH_XX, sums, &welch->xx) ||
        !allocate(welch, wanted & TRK_WELCH_YY, sums, &welch->yy) ||
        !allocate(welch, wanted & TRK_WELCH_XY, 2 * sums, &welch->xy))
        return TRK_E_MEMORY;
    return TRK_OK;
}

static void accumulate(trk_welch *welch, const double *x, const double *y)
{
    const trk_welch_plan *plan = &welch->plan;
    const trk_fft_kernel *kernel = plan->kernel;
    const int64_t length = plan->settings.length, segments = plan->settings.segments;
    for (int64_t first = 0; first < segments; first += kernel->lanes) {
        const int64_t count = segments - first < kernel->lanes ? segments - first : kernel->lanes;
        const int64_t at = first * plan->settings.step;
        const double *X = trk_welch_transform(plan, count, x + at, welch->buffer);
        const double *Y = y ? trk_welch_transform(plan, count, y + at, welch->buffer + 2) : NULL;
        if (welch->xx)
            kernel->add_power(length, X, welch->xx);
        if (welch->yy)
            kernel->add_power(length, Y, welch->yy);
        if (welch->xy)
            kernel->add_cross(length, X, Y, welch->xy);
    }
}

trk_status trk_welch_average(trk_context *context, const char *what, int64_t count, const double *x,
                             const double *y, const trk_spectrum_options *options, int wanted,
                             trk_welch *out_welch)
{
    *out_welch = (trk_welch){.plan = {.context = context}};
    trk_spectrum_settings settings;
    trk_status status = trk_spectrum_resolve(context, what, options, count, &settings);
    if (status == TRK_OK)
        status = trk_check_samples(context, what, "x", count, x);
    if (status == TRK_OK && y)
        status = trk_check_samples(context, what, "y", count, y);
    if (status == TRK_OK)
        status = trk_welch_plan_create(context, what, count, options, &out_welch->plan);
    if (status != TRK_OK)
        return status;
    status = prepare(out_welch, y != NULL, wanted);
    if (status == TRK_OK) {
        accumulate(out_welch, x, y);
        const trk_welch_plan *plan = &out_welch->plan;
        const int64_t length = settings.length;
        const bool finite = trk_welch_reduce(plan, length, out_welch->xx) &&
                            trk_welch_reduce(plan, length, out_welch->yy) &&
                            trk_welch_reduce(plan, 2 * length, out_welch->xy);
        if (!finite)
            status =
                trk_fail(context, TRK_E_RANGE,
                         "%s: the square of a sample overflows, expected smaller samples", what);
    }
    if (status != TRK_OK)
        trk_welch_free(out_welch);
    return status;
}
