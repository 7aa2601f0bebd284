/* SPDX-License-Identifier: MIT */
/* Averaged periodograms: segments side by side in the lanes of the FFT. */
#include "spectrum/welch.h"
#include "spectrum/detrend.h"
#include "spectrum/window.h"

#include <math.h>

enum { MAX_LANES = 8 };

void trk_welch_free(trk_welch *welch)
{
    trk_free(welch->context, welch->xy);
    trk_free(welch->context, welch->yy);
    trk_free(welch->context, welch->xx);
    for (int i = 0; i < 4; i++)
        trk_free(welch->context, welch->buffer[i]);
    trk_free(welch->context, welch->window);
    trk_real_fft_destroy(welch->fft);
    *welch = (trk_welch){.context = welch->context};
}

/* NULL stays NULL if not wanted; false when out of memory. */
static bool allocate(trk_welch *welch, bool wanted, int64_t count, double **out)
{
    if (wanted)
        *out = trk_new(welch->context, count, sizeof **out);
    return !wanted || *out;
}

static trk_status prepare(trk_welch *welch, bool two, int wanted)
{
    const trk_spectrum_options *o = &welch->settings.options;
    trk_status status =
        trk_real_fft_create(welch->context, o->segment_length, welch->kernel, &welch->fft);
    if (status != TRK_OK)
        return status;
    const int64_t buffer = trk_real_fft_buffer(welch->fft);
    const int64_t sums = welch->settings.length * welch->kernel->lanes;
    if (!allocate(welch, true, o->segment_length, &welch->window) ||
        !allocate(welch, true, buffer, &welch->buffer[0]) ||
        !allocate(welch, true, buffer, &welch->buffer[1]) ||
        !allocate(welch, two, buffer, &welch->buffer[2]) ||
        !allocate(welch, two, buffer, &welch->buffer[3]) ||
        !allocate(welch, wanted & TRK_WELCH_XX, sums, &welch->xx) ||
        !allocate(welch, wanted & TRK_WELCH_YY, sums, &welch->yy) ||
        !allocate(welch, wanted & TRK_WELCH_XY, 2 * sums, &welch->xy))
        return TRK_E_MEMORY;
    return trk_window_fill(welch->context, o->window, o->kaiser_beta, o->segment_length,
                           welch->window);
}

/* Spectra of the segments first, first + 1, ... in the lanes; lanes beyond the last are 0. */
static const double *transform(const trk_welch *welch, int64_t first, const double *x,
                               double *const buffer[2])
{
    const trk_spectrum_settings *settings = &welch->settings;
    const int64_t n = settings->options.segment_length;
    trk_fft_segment segment[MAX_LANES];
    for (int64_t l = 0; l < welch->kernel->lanes; l++) {
        if (first + l < settings->segments)
            segment[l] =
                trk_detrend_fit(settings->options.detrend, n, x + (first + l) * settings->step);
        else
            segment[l] = (trk_fft_segment){.x = x, .mean = 0, .slope = 0, .gain = 0};
    }
    welch->kernel->load(n, segment, welch->window, buffer[0]);
    return trk_real_fft_forward(welch->fft, buffer[0], buffer[1]);
}

static void accumulate(trk_welch *welch, const double *x, const double *y)
{
    const trk_fft_kernel *kernel = welch->kernel;
    const int64_t length = welch->settings.length;
    for (int64_t first = 0; first < welch->settings.segments; first += kernel->lanes) {
        const double *X = transform(welch, first, x, welch->buffer);
        const double *Y = y ? transform(welch, first, y, welch->buffer + 2) : NULL;
        if (welch->xx)
            kernel->add_power(length, X, welch->xx);
        if (welch->yy)
            kernel->add_power(length, Y, welch->yy);
        if (welch->xy)
            kernel->add_cross(length, X, Y, welch->xy);
    }
}

/* Sums of the lanes become averages over the segments, in place; false if one overflowed. */
static bool reduce(const trk_welch *welch, int64_t count, double *sum)
{
    const int64_t lanes = welch->kernel->lanes;
    bool finite = true;
    for (int64_t k = 0; sum && k < count; k++) {
        double total = 0;
        for (int64_t l = 0; l < lanes; l++)
            total += sum[k * lanes + l];
        sum[k] = total / (double)welch->settings.segments;
        finite = finite && isfinite(sum[k]);
    }
    return finite;
}

trk_status trk_welch_average(trk_context *context, const char *what, int64_t count, const double *x,
                             const double *y, const trk_spectrum_options *options, int wanted,
                             trk_welch *out_welch)
{
    *out_welch = (trk_welch){.context = context};
    trk_spectrum_settings *settings = &out_welch->settings;
    trk_status status = trk_spectrum_resolve(context, what, options, count, settings);
    if (status == TRK_OK)
        status = trk_check_samples(context, what, "x", count, x);
    if (status == TRK_OK && y)
        status = trk_check_samples(context, what, "y", count, y);
    if (status != TRK_OK)
        return status;
    out_welch->kernel = settings->segments > 1 ? trk_fft_kernel_widest() : &trk_fft_kernel_scalar;
    status = prepare(out_welch, y != NULL, wanted);
    if (status == TRK_OK) {
        accumulate(out_welch, x, y);
        const int64_t length = settings->length;
        const bool finite = reduce(out_welch, length, out_welch->xx) &&
                            reduce(out_welch, length, out_welch->yy) &&
                            reduce(out_welch, 2 * length, out_welch->xy);
        if (!finite)
            status =
                trk_fail(context, TRK_E_RANGE,
                         "%s: the square of a sample overflows, expected smaller samples", what);
    }
    if (status != TRK_OK)
        trk_welch_free(out_welch);
    return status;
}

double trk_welch_scale(const trk_welch *welch, double sample_rate)
{
    double sum = 0, squares = 0;
    for (int64_t i = 0; i < welch->settings.options.segment_length; i++) {
        sum += welch->window[i];
        squares += welch->window[i] * welch->window[i];
    }
    return welch->settings.options.scaling == TRK_SCALING_DENSITY ? 1 / (sample_rate * squares)
                                                                  : 1 / (sum * sum);
}

double trk_welch_sides(const trk_welch *welch, int64_t k)
{
    /* 0 and, for an even length, the Nyquist frequency have no mirror image. */
    return k == 0 || 2 * k == welch->settings.options.segment_length ? 1 : 2;
}
