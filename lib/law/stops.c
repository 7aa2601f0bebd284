/* SPDX-License-Identifier: MIT */
/* Bump and rebound stop (LAW.11). */
#include "curve/curve.h"
#include "law/stop_curve.h"

#include <math.h>

typedef struct stops {
    trk_law base;
    trk_stops_options options;
    trk_curve *bump, *rebound; /* owned; those of the options */
} stops;

static const trk_stops_options defaults = {.struct_size = sizeof defaults};

static const trk_stops_options *of(const trk_law *law)
{
    return &((const stops *)law)->options;
}

/* Force of one stop over its own compression x, slope and energy. */
static void press(double stiffness, const trk_curve *curve, double x, double *out_force,
                  double *out_slope)
{
    *out_force = *out_slope = 0;
    if (x <= 0)
        return;
    if (curve) {
        int32_t hint = 0;
        trk_curve_point(curve, x, &hint, out_force, out_slope);
    }
    *out_force += stiffness * x;
    *out_slope += stiffness;
}

static void evaluate(const trk_law *law, const double *z, double e, double v, double h,
                     trk_law_point *out, double *z_next)
{
    const trk_stops_options *o = of(law);
    double bump, bump_slope, rebound, rebound_slope;
    (void)z, (void)v, (void)h, (void)z_next;
    press(o->bump_stiffness, o->bump_curve, -e - o->bump_clearance, &bump, &bump_slope);
    press(o->rebound_stiffness, o->rebound_curve, e - o->rebound_clearance, &rebound,
          &rebound_slope);
    *out = (trk_law_point){.force = rebound - bump, .stiffness = rebound_slope + bump_slope};
}

static void relax(const trk_law *law, double e, double *z)
{
    (void)law, (void)e, (void)z;
}

static void rest(const trk_law *law, double e, trk_law_point *out)
{
    evaluate(law, NULL, e, 0, 0, out, NULL);
}

static double energy(double stiffness, const trk_curve *curve, double x)
{
    if (!(x > 0))
        return 0;
    return stiffness * x * x / 2 + (curve ? trk_stop_curve_area(curve, x) : 0);
}

static double stored(const trk_law *law, const double *z, double e)
{
    const trk_stops_options *o = of(law);
    (void)z;
    return energy(o->bump_stiffness, o->bump_curve, -e - o->bump_clearance) +
           energy(o->rebound_stiffness, o->rebound_curve, e - o->rebound_clearance);
}

static double lost(const trk_law *law, const double *z, double e, double v)
{
    (void)law, (void)z, (void)e, (void)v;
    return 0;
}

static double steepest_of(double stiffness, const trk_curve *curve)
{
    return stiffness + (curve ? fmax(0, curve->slope_maximum) : 0);
}

static void steepest(const trk_law *law, double *out_stiffness, double *out_damping)
{
    const trk_stops_options *o = of(law);
    *out_stiffness = fmax(steepest_of(o->bump_stiffness, o->bump_curve),
                          steepest_of(o->rebound_stiffness, o->rebound_curve));
    *out_damping = 0;
}

static trk_status copy(trk_context *context, const trk_law *law, trk_law **out_law)
{
    return trk_law_create_stops(context, law->name, of(law), out_law);
}

static void release(trk_law *law)
{
    trk_curve_destroy(((stops *)law)->rebound);
    trk_curve_destroy(((stops *)law)->bump);
}

static const trk_law_ops ops = {.kind = TRK_LAW_STOPS,
                                .word = "stops",
                                .states = 0,
                                .relax = relax,
                                .evaluate = evaluate,
                                .rest = rest,
                                .stored = stored,
                                .lost = lost,
                                .steepest = steepest,
                                .copy = copy,
                                .release = release};

void trk_stops_options_init(trk_stops_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status check(trk_context *context, const char *name, const trk_stops_options *o)
{
    const char *fields[] = {"bump_clearance", "bump_stiffness", "rebound_clearance",
                            "rebound_stiffness"};
    const double values[] = {o->bump_clearance, o->bump_stiffness, o->rebound_clearance,
                             o->rebound_stiffness};
    trk_status status = TRK_OK;
    for (int k = 0; k < 4 && status == TRK_OK; k++)
        status = trk_law_check_not_negative(context, &ops, name, fields[k], values[k]);
    if (status == TRK_OK)
        status = trk_stop_curve_check(context, &ops, name, "bump_curve", o->bump_curve);
    if (status == TRK_OK)
        status = trk_stop_curve_check(context, &ops, name, "rebound_curve", o->rebound_curve);
    return status;
}

static trk_status fill(trk_context *context, const trk_stops_options *o, stops *s)
{
    trk_status status = TRK_OK;
    s->options = *o;
    if (o->bump_curve)
        status = trk_curve_copy(context, o->bump_curve, &s->bump);
    if (status == TRK_OK && o->rebound_curve)
        status = trk_curve_copy(context, o->rebound_curve, &s->rebound);
    s->options.bump_curve = s->bump;
    s->options.rebound_curve = s->rebound;
    return status;
}

trk_status trk_law_create_stops(trk_context *context, const char *name,
                                const trk_stops_options *options, trk_law **out_law)
{
    trk_stops_options o = defaults;
    trk_law *law = NULL;
    trk_status status = trk_law_begin(context, &ops, name, options, &o, sizeof o, out_law);
    if (status == TRK_OK)
        status = check(context, name, &o);
    if (status == TRK_OK)
        status = trk_law_allocate(context, &ops, name, sizeof(stops), &law);
    if (status == TRK_OK)
        status = fill(context, &o, (stops *)law);
    if (status)
        trk_law_destroy(law);
    else
        *out_law = law;
    return status;
}

trk_status trk_law_get_stops(const trk_law *law, trk_stops_options *out_options)
{
    return trk_law_read(law, TRK_LAW_STOPS, law ? of(law) : NULL, sizeof defaults, out_options);
}
