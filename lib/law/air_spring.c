/* SPDX-License-Identifier: MIT */
/* Air spring with an auxiliary volume behind a throttle (LAW.14). */
#include "law/air.h"

#include <math.h>

static const trk_air_spring_options defaults = {
    .struct_size = sizeof defaults, .exponent = 1.38, .ambient = 101325, .temperature = 293.15};

static const trk_air_spring_options *of(const trk_law *law)
{
    return &((const trk_air *)law)->options;
}

static void relax(const trk_law *law, double e, double *z)
{
    const trk_air *air = (const trk_air *)law;
    double volume = trk_air_volume(air, e);
    z[TRK_AIR_FLOW] = 0;
    z[TRK_AIR_MASS] = air->mass;
    if (air->conductance > 0)
        z[TRK_AIR_MASS] *= (volume + volume * air->ratio) / (volume + of(law)->auxiliary_volume);
}

static void evaluate(const trk_law *law, const double *z, double e, double v, double h,
                     trk_law_point *out, double *z_next)
{
    const trk_air *air = (const trk_air *)law;
    const trk_air_spring_options *o = of(law);
    double area = o->area + o->area_slope * e, volume = trk_air_volume(air, e), mass_slope;
    (void)v;
    if (!(volume > 0 && area > 0)) { /* the bellows is not one there */
        *out = (trk_law_point){NAN, NAN, NAN};
        z_next[TRK_AIR_MASS] = z_next[TRK_AIR_FLOW] = NAN;
        return;
    }
    trk_air_flow(air, z, volume, area, h, z_next, &mass_slope);
    double mass = z_next[TRK_AIR_MASS], p = trk_air_pressure(air, mass, volume);
    double p_slope = o->exponent * p * (mass_slope / mass - area / volume);
    *out = (trk_law_point){.force = -(p - o->ambient) * area,
                           .stiffness = -p_slope * area - (p - o->ambient) * o->area_slope};
}

static void rest(const trk_law *law, double e, trk_law_point *out)
{
    const trk_air *air = (const trk_air *)law;
    const trk_air_spring_options *o = of(law);
    double z[TRK_LAW_STATES], next[TRK_LAW_STATES];
    relax(law, e, z);
    evaluate(law, z, e, 0, 0, out, next);
    if (air->conductance > 0) { /* at rest both volumes are one */
        double area = o->area + o->area_slope * e, volume = trk_air_volume(air, e);
        double p = trk_air_pressure(air, z[TRK_AIR_MASS], volume);
        out->stiffness = o->exponent * p * area * area / (volume + o->auxiliary_volume) -
                         (p - o->ambient) * o->area_slope;
    }
}

static void steepest(const trk_law *law, double *out_stiffness, double *out_damping)
{
    const trk_air_spring_options *o = of(law);
    *out_stiffness = o->exponent * o->pressure * o->area * o->area / o->volume +
                     (o->pressure - o->ambient) * fabs(o->area_slope);
    *out_damping = 0;
}

static trk_status copy(trk_context *context, const trk_law *law, trk_law **out_law)
{
    return trk_law_create_air_spring(context, law->name, of(law), out_law);
}

static const trk_law_ops ops = {.kind = TRK_LAW_AIR_SPRING,
                                .word = "air spring",
                                .states = 2,
                                .relax = relax,
                                .evaluate = evaluate,
                                .rest = rest,
                                .stored = trk_air_stored,
                                .lost = trk_air_lost,
                                .steepest = steepest,
                                .copy = copy};

void trk_air_spring_options_init(trk_air_spring_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status check(trk_context *context, const char *name, const trk_air_spring_options *o)
{
    const char *positive[] = {"ambient", "pressure", "volume", "area", "temperature"};
    const double values[] = {o->ambient, o->pressure, o->volume, o->area, o->temperature};
    trk_status status = TRK_OK;
    for (int k = 0; k < 5 && status == TRK_OK; k++)
        status = trk_law_check_positive(context, &ops, name, positive[k], values[k]);
    if (status == TRK_OK)
        status = trk_law_check_not_negative(context, &ops, name, "auxiliary_volume",
                                            o->auxiliary_volume);
    if (status == TRK_OK)
        status = trk_law_check_not_negative(context, &ops, name, "conductance", o->conductance);
    if (status)
        return status;
    if (!isfinite(o->area_slope))
        return trk_fail(context, TRK_E_RANGE,
                        "air spring '%s': area_slope is %g; a finite number is needed", name,
                        o->area_slope);
    if (o->pressure <= o->ambient)
        return trk_fail(
            context, TRK_E_RANGE,
            "air spring '%s': pressure is %g, absolute; more than ambient, %g, is needed", name,
            o->pressure, o->ambient);
    if (!(o->exponent >= 1 && o->exponent <= 1.6))
        return trk_fail(context, TRK_E_RANGE, "air spring '%s': exponent is %g; 1 to 1.6 is needed",
                        name, o->exponent);
    return TRK_OK;
}

trk_status trk_law_create_air_spring(trk_context *context, const char *name,
                                     const trk_air_spring_options *options, trk_law **out_law)
{
    trk_air_spring_options o = defaults;
    trk_status status = trk_law_begin(context, &ops, name, options, &o, sizeof o, out_law);
    if (status == TRK_OK)
        status = check(context, name, &o);
    if (status == TRK_OK)
        status = trk_law_allocate(context, &ops, name, sizeof(trk_air), out_law);
    if (status == TRK_OK) {
        trk_air *air = (trk_air *)*out_law;
        air->options = o;
        air->heat = TRK_AIR_CONSTANT * o.temperature;
        air->mass = o.pressure * o.volume / air->heat;
        air->ratio = o.auxiliary_volume / o.volume;
        air->conductance = air->ratio > 0 ? o.conductance : 0;
    }
    return status;
}

trk_status trk_law_get_air_spring(const trk_law *law, trk_air_spring_options *out_options)
{
    return trk_law_read(law, TRK_LAW_AIR_SPRING, law ? of(law) : NULL, sizeof defaults,
                        out_options);
}
