/* SPDX-License-Identifier: MIT */
/* Dry friction: elastic up to the friction force, then sliding at it (LAW.13). */
#include "law/law.h"

#include <math.h>

typedef struct friction {
    trk_law base;
    trk_friction_options options;
} friction;

static const trk_friction_options defaults = {.struct_size = sizeof defaults};

/* Memory: the friction force, and where it acted. */
enum { FORCE, PLACE };

static const trk_friction_options *of(const trk_law *law)
{
    return &((const friction *)law)->options;
}

static void relax(const trk_law *law, double e, double *z)
{
    (void)law;
    z[FORCE] = 0;
    z[PLACE] = e;
}

static void evaluate(const trk_law *law, const double *z, double e, double v, double h,
                     trk_law_point *out, double *z_next)
{
    const trk_friction_options *o = of(law);
    double sticking = z[FORCE] + o->stiffness * (e - z[PLACE]);
    bool slides = fabs(sticking) > o->friction;
    (void)v, (void)h;
    *out = (trk_law_point){.force = slides ? copysign(o->friction, sticking) : sticking,
                           .stiffness = slides ? 0 : o->stiffness};
    z_next[FORCE] = out->force;
    z_next[PLACE] = e;
}

static void rest(const trk_law *law, double e, trk_law_point *out)
{
    (void)law, (void)e;
    *out = (trk_law_point){0};
}

static double stored(const trk_law *law, const double *z, double e)
{
    (void)e;
    return z[FORCE] * z[FORCE] / (2 * of(law)->stiffness);
}

static double lost(const trk_law *law, const double *z, double e, double v)
{
    (void)e;
    bool slides = fabs(z[FORCE]) >= of(law)->friction && z[FORCE] * v > 0;
    return slides ? z[FORCE] * v : 0;
}

static void steepest(const trk_law *law, double *out_stiffness, double *out_damping)
{
    *out_stiffness = of(law)->stiffness;
    *out_damping = 0;
}

static trk_status copy(trk_context *context, const trk_law *law, trk_law **out_law)
{
    return trk_law_create_friction(context, law->name, of(law), out_law);
}

static const trk_law_ops ops = {.kind = TRK_LAW_FRICTION,
                                .word = "dry friction",
                                .states = 2,
                                .relax = relax,
                                .evaluate = evaluate,
                                .rest = rest,
                                .stored = stored,
                                .lost = lost,
                                .steepest = steepest,
                                .copy = copy};

void trk_friction_options_init(trk_friction_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

trk_status trk_law_create_friction(trk_context *context, const char *name,
                                   const trk_friction_options *options, trk_law **out_law)
{
    trk_friction_options o = defaults;
    trk_status status = trk_law_begin(context, &ops, name, options, &o, sizeof o, out_law);
    if (status == TRK_OK)
        status = trk_law_check_positive(context, &ops, name, "friction", o.friction);
    if (status == TRK_OK)
        status = trk_law_check_positive(context, &ops, name, "stiffness", o.stiffness);
    if (status == TRK_OK)
        status = trk_law_allocate(context, &ops, name, sizeof(friction), out_law);
    if (status == TRK_OK)
        ((friction *)*out_law)->options = o;
    return status;
}

trk_status trk_law_get_friction(const trk_law *law, trk_friction_options *out_options)
{
    return trk_law_read(law, TRK_LAW_FRICTION, law ? of(law) : NULL, sizeof defaults, out_options);
}
