/* SPDX-License-Identifier: MIT */
/* Life of a curve: options, checks, copies, questions. */
#include "curve/curve.h"
#include "curve/pieces.h"

#include <string.h>

static const trk_curve_options defaults = {sizeof defaults, TRK_INTERPOLATION_PCHIP,
                                           TRK_EXTRAPOLATION_SLOPE};

void trk_curve_options_init(trk_curve_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status check_options(trk_context *context, const char *name, const trk_curve_options *o)
{
    if (o->interpolation < TRK_INTERPOLATION_PCHIP || o->interpolation > TRK_INTERPOLATION_LINEAR)
        return trk_fail(context, TRK_E_ARGUMENT,
                        "curve '%s': interpolation is %d, expected 0 to %d", name,
                        (int)o->interpolation, TRK_INTERPOLATION_LINEAR);
    if (o->extrapolation < TRK_EXTRAPOLATION_SLOPE || o->extrapolation > TRK_EXTRAPOLATION_CLAMP)
        return trk_fail(context, TRK_E_ARGUMENT,
                        "curve '%s': extrapolation is %d, expected 0 to %d", name,
                        (int)o->extrapolation, TRK_EXTRAPOLATION_CLAMP);
    return TRK_OK;
}

static trk_status check_table(trk_context *context, const char *name, int64_t count,
                              const double *x, const double *y)
{
    if (count < 2 || count >= INT32_MAX)
        return trk_fail(context, TRK_E_RANGE, "curve '%s': %lld points, expected 2 to %d", name,
                        (long long)count, INT32_MAX - 1);
    for (int64_t k = 0; k < count; k++) {
        if (!isfinite(x[k]) || !isfinite(y[k]))
            return trk_fail(context, TRK_E_RANGE,
                            "curve '%s': point %lld is (%g, %g), expected finite values", name,
                            (long long)k + 1, x[k], y[k]);
        if (k > 0 && !(x[k] > x[k - 1]))
            return trk_fail(context, TRK_E_RANGE,
                            "curve '%s': x must increase (point %lld: %g after %g)", name,
                            (long long)k + 1, x[k], x[k - 1]);
    }
    return TRK_OK;
}

static trk_status fill(trk_context *context, const char *name, const double *x, const double *y,
                       trk_curve *c)
{
    int64_t n = c->count;
    c->name = trk_copy_text(context, name);
    c->x = trk_new(context, n, sizeof *c->x);
    c->y = trk_new(context, n, sizeof *c->y);
    if (!c->name || !c->x || !c->y)
        return TRK_E_MEMORY;
    memcpy(c->x, x, (size_t)n * sizeof *x);
    memcpy(c->y, y, (size_t)n * sizeof *y);
    return trk_curve_set_pieces(context, c);
}

/* A table that only rises or falls should give such a curve; say so where it does not. */
static void note_overshoot(const trk_curve *c)
{
    if (trk_curve_monotone(c) != 0)
        return;
    bool rises = false, falls = false;
    for (int32_t k = 1; k < c->count; k++) {
        rises |= c->y[k] > c->y[k - 1];
        falls |= c->y[k] < c->y[k - 1];
    }
    if (rises != falls)
        trk_note(c->context,
                 "curve '%s': the table is monotone, the curve is not (slopes %g to %g)", c->name,
                 c->slope_minimum, c->slope_maximum);
}

trk_status trk_curve_create(trk_context *context, const char *name, int64_t count, const double *x,
                            const double *y, const trk_curve_options *options,
                            trk_curve **out_curve)
{
    TRK_REQUIRE(context, out_curve, "trk_curve_create");
    *out_curve = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    TRK_REQUIRE(context, name, "trk_curve_create");
    TRK_REQUIRE(context, x, "trk_curve_create");
    TRK_REQUIRE(context, y, "trk_curve_create");
    trk_curve_options o = defaults;
    trk_status status = trk_read_options(context, "trk_curve_options", options, &o, sizeof o);
    if (status == TRK_OK)
        status = check_options(context, name, &o);
    if (status == TRK_OK)
        status = check_table(context, name, count, x, y);
    if (status)
        return status;
    trk_curve *curve = trk_new(context, 1, sizeof *curve);
    if (!curve)
        return TRK_E_MEMORY;
    curve->context = context;
    curve->interpolation = o.interpolation;
    curve->extrapolation = o.extrapolation;
    curve->count = (int32_t)count;
    status = fill(context, name, x, y, curve);
    if (status) {
        trk_curve_destroy(curve);
        return status;
    }
    note_overshoot(curve);
    *out_curve = curve;
    return TRK_OK;
}

trk_status trk_curve_copy(trk_context *context, const trk_curve *curve, trk_curve **out_curve)
{
    TRK_REQUIRE(context, out_curve, "trk_curve_copy");
    *out_curve = NULL;
    TRK_REQUIRE(context, curve, "trk_curve_copy");
    trk_curve_options o = {sizeof o, curve->interpolation, curve->extrapolation};
    return trk_curve_create(context, curve->name, curve->count, curve->x, curve->y, &o, out_curve);
}

void trk_curve_destroy(trk_curve *curve)
{
    if (!curve)
        return;
    trk_context *context = curve->context;
    trk_free(context, curve->pieces);
    trk_free(context, curve->y);
    trk_free(context, curve->x);
    trk_free(context, curve->name);
    trk_free(context, curve);
}

int64_t trk_curve_count(const trk_curve *curve)
{
    return curve ? curve->count : 0;
}

const double *trk_curve_x(const trk_curve *curve)
{
    return curve ? curve->x : NULL;
}

const double *trk_curve_y(const trk_curve *curve)
{
    return curve ? curve->y : NULL;
}

const char *trk_curve_name(const trk_curve *curve)
{
    return curve ? curve->name : NULL;
}

trk_interpolation trk_curve_interpolation(const trk_curve *curve)
{
    return curve ? curve->interpolation : 0;
}

trk_extrapolation trk_curve_extrapolation(const trk_curve *curve)
{
    return curve ? curve->extrapolation : 0;
}
