/* SPDX-License-Identifier: MIT */
/* Inside of the air spring: state of the air, flow through the throttle, energy. */
#ifndef TRK_LAW_AIR_H
#define TRK_LAW_AIR_H

#include "law/law.h"

/* Specific gas constant of dry air [J/(kg K)]. */
#define TRK_AIR_CONSTANT 287.05

typedef struct trk_air {
    trk_law base;
    trk_air_spring_options options;
    double heat;        /* p / density = R T [J/kg] at rest at e = 0           */
    double mass;        /* [kg] in the bellows at rest at e = 0                */
    double ratio;       /* auxiliary volume over volume, of their masses too   */
    double conductance; /* [kg/(s Pa)] 0 without an auxiliary volume           */
} trk_air;

/* Memory: mass in the bellows and flow into it [kg/s]. The auxiliary volume has the rest of the
 * mass, so none is lost. */
enum { TRK_AIR_MASS, TRK_AIR_FLOW };

static inline double trk_air_volume(const trk_air *air, double e)
{
    const trk_air_spring_options *o = &air->options;
    return o->volume + e * (o->area + e * (o->area_slope / 2));
}

/* Pressure of a mass of air in the bellows (LAW.14a). */
double trk_air_pressure(const trk_air *air, double mass, double volume);

/*
 * Mass and flow after the time h by the trapezoidal rule (LAW.14c), and the slope of the mass
 * over e there.
 */
void trk_air_flow(const trk_air *air, const double *z, double volume, double area, double h,
                  double *z_next, double *out_mass_slope);

/* Energy (LAW.14d) and loss in the throttle (LAW.14e). */
double trk_air_stored(const trk_law *law, const double *z, double e);
double trk_air_lost(const trk_law *law, const double *z, double e, double v);

#endif
