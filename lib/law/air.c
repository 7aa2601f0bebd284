/* SPDX-License-Identifier: MIT */
/* State of the air in an air spring, flow through its throttle, energy (LAW.14). */
#include "law/air.h"

#include <math.h>

/* ln of the density over that at rest at e = 0. */
static double log_density(const trk_air *air, double mass, double volume)
{
    return log(mass / air->mass * (air->options.volume / volume));
}

static double auxiliary_mass(const trk_air *air, double mass)
{
    return air->mass * (1 + air->ratio) - mass;
}

static double auxiliary_log_density(const trk_air *air, double mass)
{
    return log(auxiliary_mass(air, mass) / (air->mass * air->ratio));
}

static double pressure(const trk_air *air, double log_of_density)
{
    return air->options.pressure * exp(air->options.exponent * log_of_density);
}

double trk_air_pressure(const trk_air *air, double mass, double volume)
{
    return pressure(air, log_density(air, mass, volume));
}

/* Flow into the bellows at a mass in it; its slope over the mass, and over the volume. */
typedef struct flow {
    double value, over_mass, over_volume;
} flow;

static flow flow_at(const trk_air *air, double mass, double volume)
{
    double n = air->options.exponent, c = air->conductance;
    double p = trk_air_pressure(air, mass, volume);
    double p_auxiliary = pressure(air, auxiliary_log_density(air, mass));
    return (flow){.value = c * (p_auxiliary - p),
                  .over_mass = -c * n * (p_auxiliary / auxiliary_mass(air, mass) + p / mass),
                  .over_volume = c * n * p / volume};
}

/*
 * The root of mass - start - (h / 2) flow(mass), which rises with the mass: Newton's method, kept
 * by bisection between no air in the bellows and all of it. Its error squares from step to step:
 * after one of 1e-9 nothing is left to do.
 */
static double solve(const trk_air *air, double start, double volume, double h, double mass,
                    flow *out_flow)
{
    double all = air->mass * (1 + air->ratio), low = 0, high = all;
    for (int k = 0; k < 100; k++) {
        *out_flow = flow_at(air, mass, volume);
        double excess = mass - start - h / 2 * out_flow->value;
        double step = -excess / (1 - h / 2 * out_flow->over_mass);
        if (excess > 0)
            high = mass;
        else
            low = mass;
        bool done = fabs(step) <= 1e-9 * all;
        mass += step;
        if (done)
            break;
        if (!(mass > low && mass < high))
            mass = low + (high - low) / 2;
    }
    *out_flow = flow_at(air, mass, volume);
    return mass;
}

void trk_air_flow(const trk_air *air, const double *z, double volume, double area, double h,
                  double *z_next, double *out_mass_slope)
{
    double mass = z[TRK_AIR_MASS], start = mass + h / 2 * z[TRK_AIR_FLOW];
    flow now = {0, 0, 0};
    if (air->conductance > 0 && h > 0)
        mass = solve(air, start, volume, h, mass, &now);
    else if (air->conductance > 0)
        now = flow_at(air, mass, volume);
    *out_mass_slope = h / 2 * now.over_volume * area / (1 - h / 2 * now.over_mass);
    z_next[TRK_AIR_MASS] = mass;
    z_next[TRK_AIR_FLOW] = now.value;
}

/* (1 - exp(-(n - 1) y)) / (n - 1), which is y for n = 1. */
static double shifted(double n, double y)
{
    return n == 1 ? y : -expm1(-(n - 1) * y) / (n - 1);
}

/* The internal energy p V / (n - 1), less a constant per mass so that n may be 1. */
static double energy(const trk_air *air, double y, double volume)
{
    return pressure(air, y) * volume * shifted(air->options.exponent, y);
}

double trk_air_stored(const trk_law *law, const double *z, double e)
{
    const trk_air *air = (const trk_air *)law;
    const trk_air_spring_options *o = &air->options;
    double volume = trk_air_volume(air, e);
    double sum = energy(air, log_density(air, z[TRK_AIR_MASS], volume), volume) +
                 o->ambient * (volume - o->volume);
    if (air->conductance > 0)
        sum += energy(air, auxiliary_log_density(air, z[TRK_AIR_MASS]), o->auxiliary_volume);
    return sum;
}

/* The air falls from one enthalpy, n / (n - 1) p / density, to the other. */
double trk_air_lost(const trk_law *law, const double *z, double e, double v)
{
    const trk_air *air = (const trk_air *)law;
    double n = air->options.exponent, mass = z[TRK_AIR_MASS], volume = trk_air_volume(air, e);
    (void)v;
    if (air->conductance == 0)
        return 0;
    double y = log_density(air, mass, volume), y_auxiliary = auxiliary_log_density(air, mass);
    double fall = n * air->heat * exp((n - 1) * y_auxiliary) * shifted(n, y_auxiliary - y);
    return fall * flow_at(air, mass, volume).value;
}
