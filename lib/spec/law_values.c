/* SPDX-License-Identifier: MIT */
/* Read the parameters of a law, list those of a field, make the law anew. */
#include "spec/law_values.h"

#include <string.h>

/* Sizes are those of this library and the kinds are right: reading cannot fail. */
void trk_law_values_read(const trk_law *law, trk_law_values *out)
{
    trk_status status = TRK_E_ARGUMENT;
    memset(out, 0, sizeof *out);
    out->curve_scale = 1;
    switch (trk_law_get_kind(law)) {
    case TRK_LAW_TIRE:
        out->of.tire.struct_size = sizeof out->of.tire;
        status = trk_law_get_tire(law, &out->of.tire);
        break;
    case TRK_LAW_STOPS:
        out->of.stops.struct_size = sizeof out->of.stops;
        status = trk_law_get_stops(law, &out->of.stops);
        break;
    case TRK_LAW_LEAF:
        out->of.leaf.struct_size = sizeof out->of.leaf;
        status = trk_law_get_leaf(law, &out->of.leaf);
        if (out->of.leaf.approach_rebound == out->of.leaf.approach_bump)
            out->of.leaf.approach_rebound = 0; /* which says the same with one number */
        break;
    case TRK_LAW_FRICTION:
        out->of.friction.struct_size = sizeof out->of.friction;
        status = trk_law_get_friction(law, &out->of.friction);
        break;
    case TRK_LAW_SEAL:
        out->of.seal.struct_size = sizeof out->of.seal;
        status = trk_law_get_seal(law, &out->of.seal);
        if (out->of.seal.breakaway == out->of.seal.sliding)
            out->of.seal.breakaway = 0;
        break;
    default: break;
    }
    out->kind = status == TRK_OK ? trk_law_get_kind(law) : 0;
}

int32_t trk_law_values_list(trk_law_values *values, trk_field field, double *out[TRK_LAW_NUMBERS])
{
    const struct {
        trk_law_kind kind;
        trk_field field;
        double *number[TRK_LAW_NUMBERS];
    } all[] = {
        {TRK_LAW_TIRE,
         TRK_FIELD_STIFFNESS,
         {&values->of.tire.stiffness, &values->of.tire.stiffening}},
        {TRK_LAW_TIRE, TRK_FIELD_DAMPING, {&values->of.tire.damping}},
        {TRK_LAW_STOPS,
         TRK_FIELD_STIFFNESS,
         {&values->of.stops.bump_stiffness, &values->of.stops.rebound_stiffness}},
        {TRK_LAW_LEAF,
         TRK_FIELD_FRICTION,
         {&values->of.leaf.friction, &values->of.leaf.friction_slope}},
        {TRK_LAW_LEAF,
         TRK_FIELD_APPROACH,
         {&values->of.leaf.approach_bump, &values->of.leaf.approach_rebound}},
        {TRK_LAW_FRICTION, TRK_FIELD_FRICTION, {&values->of.friction.friction}},
        {TRK_LAW_SEAL, TRK_FIELD_FRICTION, {&values->of.seal.sliding, &values->of.seal.breakaway}},
    };
    int32_t count = 0;
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        for (int i = 0; i < TRK_LAW_NUMBERS; i++)
            if (all[k].kind == values->kind && all[k].field == field && all[k].number[i])
                out[count++] = all[k].number[i];
    return count;
}

bool trk_law_values_have_curves(const trk_law_values *values)
{
    return values->kind == TRK_LAW_STOPS &&
           (values->of.stops.bump_curve || values->of.stops.rebound_curve);
}

/* *out is NULL without a curve. */
static trk_status scale_curve(trk_context *context, const trk_curve *curve, double factor,
                              trk_curve **out)
{
    *out = NULL;
    if (!curve)
        return TRK_OK;
    int64_t count = trk_curve_count(curve);
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = trk_curve_interpolation(curve);
    options.extrapolation = trk_curve_extrapolation(curve);
    double *y = trk_new(context, count, sizeof *y);
    if (!y)
        return TRK_E_MEMORY;
    for (int64_t k = 0; k < count; k++)
        y[k] = factor * trk_curve_y(curve)[k];
    trk_status status = trk_curve_create(context, trk_curve_name(curve), count, trk_curve_x(curve),
                                         y, &options, out);
    trk_free(context, y);
    return status;
}

static trk_status make_stops(trk_context *context, const char *name, const trk_law_values *values,
                             trk_law **out_law)
{
    if (values->curve_scale == 1)
        return trk_law_create_stops(context, name, &values->of.stops, out_law);
    trk_stops_options o = values->of.stops;
    trk_curve *bump, *rebound = NULL;
    trk_status status = scale_curve(context, o.bump_curve, values->curve_scale, &bump);
    if (status == TRK_OK)
        status = scale_curve(context, o.rebound_curve, values->curve_scale, &rebound);
    o.bump_curve = bump;
    o.rebound_curve = rebound;
    if (status == TRK_OK)
        status = trk_law_create_stops(context, name, &o, out_law);
    trk_curve_destroy(bump);
    trk_curve_destroy(rebound);
    return status;
}

trk_status trk_law_values_make(trk_context *context, const char *name, const trk_law_values *values,
                               trk_law **out_law)
{
    *out_law = NULL;
    switch (values->kind) {
    case TRK_LAW_TIRE: return trk_law_create_tire(context, name, &values->of.tire, out_law);
    case TRK_LAW_STOPS: return make_stops(context, name, values, out_law);
    case TRK_LAW_LEAF: return trk_law_create_leaf(context, name, &values->of.leaf, out_law);
    case TRK_LAW_FRICTION:
        return trk_law_create_friction(context, name, &values->of.friction, out_law);
    default: return trk_law_create_seal(context, name, &values->of.seal, out_law);
    }
}
