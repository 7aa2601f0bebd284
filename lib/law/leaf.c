/* SPDX-License-Identifier: MIT */
/* Inter-leaf friction of a leaf spring (LAW.12), moved exactly along a monotone path. */
#include "law/leaf.h"

#include <math.h>

static const trk_leaf_options defaults = {.struct_size = sizeof defaults};

static const trk_leaf_options *of(const trk_law *law)
{
    return &((const trk_leaf *)law)->options;
}

/* Over the distance x in which R is linear: the target of r falls by `slope` per length from
 * `target` (LAW.12b). By expm1, as a step may be far shorter than beta. */
static double approach(double r, double target, double slope, double beta, double x)
{
    return r - slope * x + (r - target - slope * beta) * expm1(-x / beta);
}

/* r after the monotone path from -> to (LAW.12b). */
static double move(const trk_leaf *leaf, double r, double from, double to)
{
    const trk_leaf_options *o = &leaf->options;
    double sign = to < from ? -1 : 1, end = leaf->end;
    double beta = to < from ? o->approach_bump : o->approach_rebound;
    if (from > end) {
        double next = fmax(to, end);
        r = approach(r, sign * leaf->floor, 0, beta, fabs(next - from));
        from = next;
    }
    if (from < end || to < end) {
        double next = fmin(to, end), width = o->friction - o->friction_slope * from;
        r = approach(r, sign * width, o->friction_slope, beta, fabs(next - from));
        from = next;
    }
    return to > from ? approach(r, leaf->floor, 0, beta, to - from) : r;
}

static void relax(const trk_law *law, double e, double *z)
{
    (void)law;
    z[TRK_LEAF_FORCE] = 0;
    z[TRK_LEAF_PLACE] = e;
}

/* dr/de while extending and while compressing; at a standstill their mean, R / beta. */
static double slope(const trk_leaf *leaf, double r, double e, double from)
{
    const trk_leaf_options *o = &leaf->options;
    double width = trk_leaf_width(leaf, e);
    double extending = (width - r) / o->approach_rebound;
    double compressing = (width + r) / o->approach_bump;
    if (e == from)
        return (extending + compressing) / 2;
    return e > from ? extending : compressing;
}

static void evaluate(const trk_law *law, const double *z, double e, double v, double h,
                     trk_law_point *out, double *z_next)
{
    const trk_leaf *leaf = (const trk_leaf *)law;
    double from = z[TRK_LEAF_PLACE], r = move(leaf, z[TRK_LEAF_FORCE], from, e);
    (void)v, (void)h;
    *out = (trk_law_point){.force = r, .stiffness = slope(leaf, r, e, from)};
    z_next[TRK_LEAF_FORCE] = r;
    z_next[TRK_LEAF_PLACE] = e;
}

static void rest(const trk_law *law, double e, trk_law_point *out)
{
    (void)law, (void)e;
    *out = (trk_law_point){0};
}

static void steepest(const trk_law *law, double *out_stiffness, double *out_damping)
{
    const trk_leaf_options *o = of(law);
    *out_stiffness = 2 * o->friction / fmin(o->approach_bump, o->approach_rebound);
    *out_damping = 0;
}

static trk_status copy(trk_context *context, const trk_law *law, trk_law **out_law)
{
    return trk_law_create_leaf(context, law->name, of(law), out_law);
}

static const trk_law_ops ops = {.kind = TRK_LAW_LEAF,
                                .word = "leaf spring",
                                .states = 2,
                                .relax = relax,
                                .evaluate = evaluate,
                                .rest = rest,
                                .stored = trk_leaf_stored,
                                .lost = trk_leaf_lost,
                                .steepest = steepest,
                                .copy = copy};

void trk_leaf_options_init(trk_leaf_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

/* Narrower, the hysteresis could give more energy than it took (LAW.12e). */
static double floor_of(const trk_leaf_options *o)
{
    return fmax(0, o->friction_slope * (o->approach_rebound - o->approach_bump) / 2);
}

static trk_status check(trk_context *context, const char *name, const trk_leaf_options *o)
{
    trk_status status = trk_law_check_positive(context, &ops, name, "friction", o->friction);
    if (status == TRK_OK)
        status =
            trk_law_check_not_negative(context, &ops, name, "friction_slope", o->friction_slope);
    if (status == TRK_OK)
        status = trk_law_check_positive(context, &ops, name, "approach_bump", o->approach_bump);
    if (status == TRK_OK)
        status =
            trk_law_check_positive(context, &ops, name, "approach_rebound", o->approach_rebound);
    if (status == TRK_OK && o->friction < floor_of(o))
        status =
            trk_fail(context, TRK_E_RANGE,
                     "leaf spring '%s': friction is %g; with this slope and these approaches at "
                     "least %g is needed",
                     name, o->friction, floor_of(o));
    return status;
}

trk_status trk_law_create_leaf(trk_context *context, const char *name,
                               const trk_leaf_options *options, trk_law **out_law)
{
    trk_leaf_options o = defaults;
    trk_status status = trk_law_begin(context, &ops, name, options, &o, sizeof o, out_law);
    if (status == TRK_OK && o.approach_rebound == 0)
        o.approach_rebound = o.approach_bump;
    if (status == TRK_OK)
        status = check(context, name, &o);
    if (status == TRK_OK)
        status = trk_law_allocate(context, &ops, name, sizeof(trk_leaf), out_law);
    if (status == TRK_OK) {
        trk_leaf *leaf = (trk_leaf *)*out_law;
        leaf->options = o;
        leaf->floor = floor_of(&o);
        leaf->end = o.friction_slope > 0 ? (o.friction - leaf->floor) / o.friction_slope : INFINITY;
    }
    return status;
}

trk_status trk_law_get_leaf(const trk_law *law, trk_leaf_options *out_options)
{
    return trk_law_read(law, TRK_LAW_LEAF, law ? of(law) : NULL, sizeof defaults, out_options);
}
