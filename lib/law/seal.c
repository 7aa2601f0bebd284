/* SPDX-License-Identifier: MIT */
/* Friction of seals: Stribeck curve, smooth through zero (LAW.15). */
#include "law/law.h"

#include <math.h>

typedef struct seal {
    trk_law base;
    trk_seal_options options; /* breakaway filled in */
} seal;

static const trk_seal_options defaults = {
    .struct_size = sizeof defaults, .stribeck = 0.1, .creep = 0.001};

static const trk_seal_options *of(const trk_law *law)
{
    return &((const seal *)law)->options;
}

static void evaluate(const trk_law *law, const double *z, double e, double v, double h,
                     trk_law_point *out, double *z_next)
{
    const trk_seal_options *o = of(law);
    double x = v / o->stribeck, t = tanh(v / o->creep);
    double fall = (o->breakaway - o->sliding) * exp(-x * x), height = o->sliding + fall;
    (void)z, (void)e, (void)h, (void)z_next;
    *out = (trk_law_point){.force = height * t,
                           .damping = height * (1 - t * t) / o->creep -
                                      (fall == 0 ? 0 : 2 * x / o->stribeck * fall * t)};
}

static void relax(const trk_law *law, double e, double *z)
{
    (void)law, (void)e, (void)z;
}

static void rest(const trk_law *law, double e, trk_law_point *out)
{
    evaluate(law, NULL, e, 0, 0, out, NULL);
}

static double stored(const trk_law *law, const double *z, double e)
{
    (void)law, (void)z, (void)e;
    return 0;
}

static double lost(const trk_law *law, const double *z, double e, double v)
{
    trk_law_point point;
    evaluate(law, z, e, v, 0, &point, NULL);
    return point.force * v;
}

static void steepest(const trk_law *law, double *out_stiffness, double *out_damping)
{
    *out_stiffness = 0;
    *out_damping = of(law)->breakaway / of(law)->creep;
}

static trk_status copy(trk_context *context, const trk_law *law, trk_law **out_law)
{
    return trk_law_create_seal(context, law->name, of(law), out_law);
}

static const trk_law_ops ops = {.kind = TRK_LAW_SEAL,
                                .word = "seal",
                                .states = 0,
                                .relax = relax,
                                .evaluate = evaluate,
                                .rest = rest,
                                .stored = stored,
                                .lost = lost,
                                .steepest = steepest,
                                .copy = copy};

void trk_seal_options_init(trk_seal_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status check(trk_context *context, const char *name, const trk_seal_options *o)
{
    trk_status status = trk_law_check_not_negative(context, &ops, name, "sliding", o->sliding);
    if (status == TRK_OK)
        status = trk_law_check_not_negative(context, &ops, name, "breakaway", o->breakaway);
    if (status == TRK_OK)
        status = trk_law_check_positive(context, &ops, name, "stribeck", o->stribeck);
    if (status == TRK_OK)
        status = trk_law_check_positive(context, &ops, name, "creep", o->creep);
    if (status == TRK_OK && o->breakaway < o->sliding)
        status = trk_fail(context, TRK_E_RANGE,
                          "seal '%s': breakaway is %g; at least sliding, %g, is needed", name,
                          o->breakaway, o->sliding);
    return status;
}

trk_status trk_law_create_seal(trk_context *context, const char *name,
                               const trk_seal_options *options, trk_law **out_law)
{
    trk_seal_options o = defaults;
    trk_status status = trk_law_begin(context, &ops, name, options, &o, sizeof o, out_law);
    if (status == TRK_OK && o.breakaway == 0)
        o.breakaway = o.sliding;
    if (status == TRK_OK)
        status = check(context, name, &o);
    if (status == TRK_OK)
        status = trk_law_allocate(context, &ops, name, sizeof(seal), out_law);
    if (status == TRK_OK)
        ((seal *)*out_law)->options = o;
    return status;
}

trk_status trk_law_get_seal(const trk_law *law, trk_seal_options *out_options)
{
    return trk_law_read(law, TRK_LAW_SEAL, law ? of(law) : NULL, sizeof defaults, out_options);
}
