/* SPDX-License-Identifier: MIT */
/* Tire in contact with the road or off it (LAW.10). */
#include "law/law.h"

#include <math.h>

typedef struct tire {
    trk_law base;
    trk_tire_options options;
    double deflection; /* d_0 [m], that of the preload */
} tire;

static const trk_tire_options defaults = {.struct_size = sizeof defaults};

static const trk_tire_options *of(const trk_law *law)
{
    return &((const tire *)law)->options;
}

/* Force of the spring at the deflection d and its slope over d. */
typedef struct spring {
    double deflection, force, slope;
} spring;

static spring spring_at(const trk_law *law, double e)
{
    const trk_tire_options *o = of(law);
    double d = ((const tire *)law)->deflection - e;
    if (d <= 0)
        return (spring){d, 0, 0};
    return (spring){d, d * (o->stiffness + o->stiffening * d),
                    o->stiffness + 2 * o->stiffening * d};
}

static void evaluate(const trk_law *law, const double *z, double e, double v, double h,
                     trk_law_point *out, double *z_next)
{
    spring s = spring_at(law, e);
    double damper = of(law)->damping * v;
    (void)z, (void)h, (void)z_next;
    if (s.deflection <= 0 || damper >= s.force)
        *out = (trk_law_point){0};
    else if (damper <= -s.force)
        *out = (trk_law_point){-2 * s.force, 2 * s.slope, 0};
    else
        *out = (trk_law_point){damper - s.force, s.slope, of(law)->damping};
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
    const trk_tire_options *o = of(law);
    double d = fmax(0, ((const tire *)law)->deflection - e);
    (void)z;
    return d * d * (o->stiffness / 2 + o->stiffening * d / 3);
}

static double lost(const trk_law *law, const double *z, double e, double v)
{
    double most = spring_at(law, e).force;
    (void)z;
    return fmin(most, of(law)->damping * fabs(v)) * fabs(v);
}

/* A tire without linear stiffness is given the slope at 10 mm. */
static void steepest(const trk_law *law, double *out_stiffness, double *out_damping)
{
    const trk_tire_options *o = of(law);
    double d = fmax(((const tire *)law)->deflection, 0.01);
    *out_stiffness = o->stiffness + 2 * o->stiffening * d;
    *out_damping = o->damping;
}

static trk_status copy(trk_context *context, const trk_law *law, trk_law **out_law)
{
    return trk_law_create_tire(context, law->name, of(law), out_law);
}

static const trk_law_ops ops = {.kind = TRK_LAW_TIRE,
                                .word = "tire",
                                .states = 0,
                                .relax = relax,
                                .evaluate = evaluate,
                                .rest = rest,
                                .stored = stored,
                                .lost = lost,
                                .steepest = steepest,
                                .copy = copy};

void trk_tire_options_init(trk_tire_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status check(trk_context *context, const char *name, const trk_tire_options *o)
{
    const char *fields[] = {"stiffness", "stiffening", "damping", "preload"};
    const double values[] = {o->stiffness, o->stiffening, o->damping, o->preload};
    for (int k = 0; k < 4; k++) {
        trk_status status = trk_law_check_not_negative(context, &ops, name, fields[k], values[k]);
        if (status)
            return status;
    }
    if (o->stiffness == 0 && o->stiffening == 0)
        return trk_fail(context, TRK_E_RANGE,
                        "tire '%s': stiffness and stiffening are 0; one of them must be > 0", name);
    return TRK_OK;
}

/* The positive root of k d + k_2 d^2 = preload, without cancellation. */
static double deflection_of(const trk_tire_options *o)
{
    if (o->preload == 0)
        return 0;
    double root = sqrt(o->stiffness * o->stiffness + 4 * o->stiffening * o->preload);
    return 2 * o->preload / (o->stiffness + root);
}

trk_status trk_law_create_tire(trk_context *context, const char *name,
                               const trk_tire_options *options, trk_law **out_law)
{
    trk_tire_options o = defaults;
    trk_status status = trk_law_begin(context, &ops, name, options, &o, sizeof o, out_law);
    if (status == TRK_OK)
        status = check(context, name, &o);
    if (status == TRK_OK)
        status = trk_law_allocate(context, &ops, name, sizeof(tire), out_law);
    if (status == TRK_OK) {
        ((tire *)*out_law)->options = o;
        ((tire *)*out_law)->deflection = deflection_of(&o);
    }
    return status;
}

trk_status trk_law_get_tire(const trk_law *law, trk_tire_options *out_options)
{
    return trk_law_read(law, TRK_LAW_TIRE, law ? of(law) : NULL, sizeof defaults, out_options);
}
