/* SPDX-License-Identifier: MIT */
/* A weighting that runs over samples, block by block (COMFORT.5). */
#include "comfort/check.h"
#include "comfort/design.h"

#include <math.h>

enum { SHAPE_STATES = TRK_SHAPE_TAPS - 1 };

struct trk_weighting_filter {
    trk_context *context;
    trk_design design;
    double re[TRK_SECTIONS_MAX], im[TRK_SECTIONS_MAX]; /* states of the sections */
    double shape[SHAPE_STATES];                        /* transposed direct form */
};

trk_status trk_weighting_filter_create(trk_context *context, trk_weighting weighting,
                                       double sample_rate, trk_weighting_filter **out_filter)
{
    static const char what[] = "trk_weighting_filter_create";
    TRK_REQUIRE(context, out_filter, "trk_weighting_filter_create");
    *out_filter = NULL;
    TRK_REQUIRE(context, context, "trk_weighting_filter_create");
    const trk_weighting_parameters *p;
    trk_status status = trk_weighting_check(context, what, weighting, &p);
    if (status != TRK_OK)
        return status;
    if (!(sample_rate >= TRK_WEIGHTING_RATE_MINIMUM && sample_rate <= TRK_WEIGHTING_RATE_MAXIMUM))
        return trk_fail(context, TRK_E_RANGE,
                        "%s: sample_rate is %g Hz, expected %g to %g; below, weight the PSD", what,
                        sample_rate, TRK_WEIGHTING_RATE_MINIMUM, TRK_WEIGHTING_RATE_MAXIMUM);
    trk_weighting_filter *filter = trk_new(context, 1, sizeof *filter);
    if (!filter)
        return TRK_E_MEMORY;
    filter->context = context;
    status = trk_design_weighting(context, p, sample_rate, &filter->design);
    if (status != TRK_OK) {
        trk_free(context, filter);
        return status;
    }
    *out_filter = filter;
    return TRK_OK;
}

void trk_weighting_filter_destroy(trk_weighting_filter *filter)
{
    if (filter)
        trk_free(filter->context, filter);
}

void trk_weighting_filter_reset(trk_weighting_filter *filter, double level)
{
    if (!filter)
        return;
    /* At constant input s = x / (1 - pole); the first section has its zeros there and passes
     * nothing on, so that all others are at rest. */
    const trk_section *first = &filter->design.section[0];
    double a = 1 - first->pole_re, b = -first->pole_im, square = a * a + b * b;
    if (!(fabs(level) <= TRK_COMFORT_LARGEST))
        level = 0;
    for (int k = 0; k < TRK_SECTIONS_MAX; k++)
        filter->re[k] = filter->im[k] = 0;
    filter->re[0] = level * a / square;
    filter->im[0] = -level * b / square;
    for (int k = 0; k < SHAPE_STATES; k++)
        filter->shape[k] = 0;
}

/* x <- section of x, over a chunk short enough to stay in the cache. */
static void run_section(const trk_section *s, double *re, double *im, int64_t count, double *x)
{
    double u = *re, v = *im;
    for (int64_t i = 0; i < count; i++) {
        double input = x[i];
        x[i] = s->direct * input + 2 * (s->residue_re * u - s->residue_im * v);
        double next = s->pole_re * u - s->pole_im * v + input;
        v = s->pole_re * v + s->pole_im * u;
        u = next;
    }
    *re = u;
    *im = v;
}

static void run_shape(const double *b, double *state, int64_t count, double *x)
{
    for (int64_t i = 0; i < count; i++) {
        double input = x[i], y = b[0] * input + state[0];
        state[0] = b[1] * input - TRK_SHAPE_A1 * y + state[1];
        state[1] = b[2] * input - TRK_SHAPE_A2 * y + state[2];
        state[2] = b[3] * input + state[3];
        state[3] = b[4] * input;
        x[i] = y;
    }
}

trk_status trk_weighting_filter_process(trk_weighting_filter *filter, int64_t count,
                                        const double *x, double *out_y)
{
    if (!filter)
        return TRK_E_ARGUMENT;
    trk_context *context = filter->context;
    TRK_REQUIRE(context, x, "trk_weighting_filter_process");
    TRK_REQUIRE(context, out_y, "trk_weighting_filter_process");
    trk_status status =
        trk_comfort_check_samples(context, "trk_weighting_filter_process", "x", 0, count, x);
    if (status != TRK_OK)
        return status;
    enum { CHUNK = 512 };
    for (int64_t start = 0; start < count; start += CHUNK) {
        int64_t length = count - start < CHUNK ? count - start : CHUNK;
        double *y = out_y + start;
        for (int64_t i = 0; i < length; i++)
            y[i] = x[start + i];
        for (int32_t k = 0; k < filter->design.sections; k++)
            run_section(&filter->design.section[k], &filter->re[k], &filter->im[k], length, y);
        run_shape(filter->design.shape, filter->shape, length, y);
    }
    return TRK_OK;
}

trk_status trk_weighting_apply(trk_context *context, trk_weighting weighting, int64_t count,
                               const double *x, double sample_rate, double *out_y)
{
    TRK_REQUIRE(context, context, "trk_weighting_apply");
    TRK_REQUIRE(context, x, "trk_weighting_apply");
    TRK_REQUIRE(context, out_y, "trk_weighting_apply");
    trk_weighting_filter *filter;
    trk_status status = trk_weighting_filter_create(context, weighting, sample_rate, &filter);
    if (status == TRK_OK)
        status = trk_weighting_filter_process(filter, count, x, out_y);
    trk_weighting_filter_destroy(filter);
    return status;
}
