/* SPDX-License-Identifier: MIT */
/* Built-in damper and spring tables, force positive in extension. */
#include "base/base.h"

#include <truckride/vehicle.h>

#include <math.h>

#define COUNT(array) ((int64_t)(sizeof(array) / sizeof *(array)))

/* Thesis, table 1. */
static const double example_v[] = {-1.5, -1, -0.5, -0.1, 0, 0.1, 0.5, 1, 1.5};
static const double example_f[] = {-3000, -2000, -1000, -500, 0, 700, 1500, 3000, 5000};

/* Thesis, tables 3 and C3. */
static const double front_axle_v[] = {-0.5, -0.4, -0.3, -0.2, -0.1, -0.05, 0,
                                      0.05, 0.1,  0.2,  0.3,  0.4,  0.5};
static const double front_axle_f[] = {-3500, -3000, -2700, -2500, -2000, -1000, 0,
                                      100,   200,   250,   300,   400,   500};
static const double rear_axle_v[] = {-1.5, -1,  -0.5, -0.4, -0.3, -0.1, -0.05, 0,
                                     0.05, 0.1, 0.3,  0.4,  0.5,  1,    1.5};
static const double rear_axle_f[] = {-3000, -2000, -1000, -800,  -600,  -400,  -200, 0,
                                     700,   4500,  9000,  10000, 10500, 12000, 14000};
static const double cab_v[] = {-0.5, -0.4, -0.3, -0.1, -0.05, 0, 0.05, 0.1, 0.3, 0.4, 0.5};
static const double front_cab_f[] = {-250, -200, -150, -100, -30, 0, 10, 40, 130, 250, 300};
static const double rear_cab_f[] = {-90, -80, -60, -40, -10, 0, 5, 20, 60, 120, 180};

/* MAN KAT1 bump stop: force over compression, turned round; free beyond contact. */
static const double bump_e[] = {-0.05,  -0.04,  -0.03,  -0.02, -0.01, -0.008,
                                -0.006, -0.004, -0.002, 0,     0.01,  0.02};
static const double bump_f[] = {-12500, -7500, -4500, -2500, -1000, -800,
                                -600,   -400,  -200,  0,     0,     0};

/* European cab suspension: springs over compression, turned round; dampers with the stiff
 * side taken as extension. */
static const double front_spring_e[] = {-0.035, -0.030, -0.025, -0.020, -0.010, 0, 0.037, 0.040};
static const double front_spring_f[] = {-9000, -5700, -4500, -4000, -3400, -3000, -2500, 1000};
static const double rear_spring_e[] = {-0.040, -0.035, -0.030, -0.017, -0.010,
                                       0,      0.020,  0.030,  0.040};
static const double rear_spring_f[] = {-7000, -5100, -4450, -3350, -3200,
                                       -3000, -2725, -2600, 2000};
static const double cab_damper_v[] = {-0.390, -0.260, -0.130, -0.052, 0,
                                      0.052,  0.130,  0.260,  0.390};
static const double front_damper_f[] = {-2060, -1320, -550, -200, 0, 300, 1270, 2390, 3960};
static const double rear_damper_f[] = {-660, -420, -170, -80, 0, 160, 720, 1820, 2340};

typedef struct table {
    const char *name;
    int64_t count;
    const double *x, *y;
} table;

static const table tables[] = {
    [TRK_TABLE_THESIS_EXAMPLE_DAMPER] = {"thesis example damper", COUNT(example_v), example_v,
                                         example_f},
    [TRK_TABLE_THESIS_FRONT_AXLE_DAMPER] = {"thesis front axle damper", COUNT(front_axle_v),
                                            front_axle_v, front_axle_f},
    [TRK_TABLE_THESIS_REAR_AXLE_DAMPER] = {"thesis rear axle damper", COUNT(rear_axle_v),
                                           rear_axle_v, rear_axle_f},
    [TRK_TABLE_THESIS_FRONT_CAB_DAMPER] = {"thesis front cab damper", COUNT(cab_v), cab_v,
                                           front_cab_f},
    [TRK_TABLE_THESIS_REAR_CAB_DAMPER] = {"thesis rear cab damper", COUNT(cab_v), cab_v,
                                          rear_cab_f},
    [TRK_TABLE_REFERENCE_BUMP_STOP] = {"reference bump stop", COUNT(bump_e), bump_e, bump_f},
    [TRK_TABLE_REFERENCE_FRONT_CAB_SPRING] = {"reference front cab spring", COUNT(front_spring_e),
                                              front_spring_e, front_spring_f},
    [TRK_TABLE_REFERENCE_REAR_CAB_SPRING] = {"reference rear cab spring", COUNT(rear_spring_e),
                                             rear_spring_e, rear_spring_f},
    [TRK_TABLE_REFERENCE_FRONT_CAB_DAMPER] = {"reference front cab damper", COUNT(cab_damper_v),
                                              cab_damper_v, front_damper_f},
    [TRK_TABLE_REFERENCE_REAR_CAB_DAMPER] = {"reference rear cab damper", COUNT(cab_damper_v),
                                             cab_damper_v, rear_damper_f},
};

enum { SAMPLES = 161 }; /* of a formula, enough for 0.1 % */

/* MAN KAT1 shock absorber: c v / (1 + d |v|), other constants in compression; up to 3 m/s.
 * The points crowd where the curve has its corner, at rest: a smooth curve rounds it. */
static void sample_axle_damper(double *v, double *f)
{
    const double c[2] = {52526.6, 98727.9}, d[2] = {3.0, 4.77954}, limit = 3;
    for (int k = 0; k < SAMPLES; k++) {
        double part = (double)(k - SAMPLES / 2) / (SAMPLES / 2);
        int side = part > 0;
        double s = part * fabs(part) * d[side] * limit / (1 + d[side] * limit);
        v[k] = s / (d[side] * (1 - fabs(s)));
        f[k] = c[side] / d[side] * s;
    }
}

/* MAN KAT1 axle spring: k1 x + k2 x |x| over compression x from the free length, turned round. */
static void sample_spring(double k1, double k2, double longest, double *e, double *f)
{
    for (int k = 0; k < SAMPLES; k++) {
        e[k] = longest * ((double)k / (SAMPLES - 1) - 1);
        f[k] = k1 * e[k] - k2 * e[k] * e[k];
    }
}

trk_status trk_vehicle_create_curve(trk_context *context, trk_table id,
                                    const trk_curve_options *options, trk_curve **out_curve)
{
    TRK_REQUIRE(context, out_curve, "trk_vehicle_create_curve");
    *out_curve = NULL;
    TRK_REQUIRE(context, context, "trk_vehicle_create_curve");
    if (id < TRK_TABLE_THESIS_EXAMPLE_DAMPER || id > TRK_TABLE_REFERENCE_REAR_CAB_DAMPER)
        return trk_fail(context, TRK_E_ARGUMENT, "trk_vehicle_create_curve: there is no table %d",
                        id);
    double x[SAMPLES], y[SAMPLES];
    table sampled = {NULL, SAMPLES, x, y};
    trk_curve_options exact;
    trk_curve_options_init(&exact, sizeof exact);
    if (id == TRK_TABLE_REFERENCE_AXLE_DAMPER) {
        sampled.name = "reference axle damper";
        sample_axle_damper(x, y);
    } else if (id == TRK_TABLE_REFERENCE_FRONT_SPRING || id == TRK_TABLE_REFERENCE_REAR_SPRING) {
        bool front = id == TRK_TABLE_REFERENCE_FRONT_SPRING;
        sampled.name = front ? "reference front spring" : "reference rear spring";
        sample_spring(front ? 85490 : 178892, front ? 495208 : 621618, 0.4, x, y);
        exact.interpolation = TRK_INTERPOLATION_NOT_A_KNOT;
    }
    const table *t = sampled.name ? &sampled : &tables[id];
    return trk_curve_create(context, t->name, t->count, t->x, t->y, options ? options : &exact,
                            out_curve);
}
