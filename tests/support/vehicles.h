/* SPDX-License-Identifier: MIT */
/* Vehicles and roads that the tests of the stepper run over. */
#ifndef TRK_TESTS_VEHICLES_H
#define TRK_TESTS_VEHICLES_H

#include <truckride/newmark.h>
#include <truckride/vehicle.h>

/* Beside TRK_VEHICLE_...: the half car, whose dampers follow the variant as those of the truck. */
enum { SUPPORT_HALF_CAR = 6, SUPPORT_VEHICLES = 6, SUPPORT_VARIANTS = 3 };

const char *support_vehicle_name(trk_vehicle vehicle);
const char *support_variant_name(trk_variant variant);

/* Spec and model of a vehicle; every status is checked. */
trk_spec *support_spec(trk_context *context, trk_vehicle vehicle, trk_variant variant);
trk_model *support_model(trk_context *context, trk_vehicle vehicle, trk_variant variant,
                         double gravity);

/* Spec without sensors whose only body has mass m [kg] on a link to ground. */
trk_model *support_oscillator(trk_context *context, double mass, double stiffness, double damping);

/*
 * Uneven road for wheel k: two sines of some 20 mm at 1 to 7 Hz, other ones for every
 * wheel, analytic in t and level with its rate at t = 0.
 */
void support_road(double t, int32_t wheels, double *height, double *velocity);

/* The same height and rate under all wheels: those of wheel 0. */
void support_even_road(double t, int32_t wheels, double *height, double *velocity);

/* Loads on the force ports: smooth pulses of some kN. */
void support_load(double t, int32_t ports, double *load);

/* Newmark's methods by number. */
enum { SUPPORT_METHODS = 4 };
const char *support_method_name(int method);
void support_method(int method, double step, trk_newmark_options *options);

/* A run recorded: q, v of every coordinate and the force of every link after each step. */
typedef struct support_run {
    int32_t n, links;
    int64_t steps;
    double *q, *v, *force; /* (steps + 1) x n, n, links */
} support_run;

typedef void (*support_drive)(double t, int32_t wheels, double *height, double *velocity);

support_run support_record(trk_context *context, const trk_model *model,
                           const trk_newmark_options *options, support_drive road, int64_t steps);
void support_run_free(support_run *run);

/*
 * Largest difference of two runs, each column over its own peak in run a. Columns whose
 * peak is below `floor` times the largest peak among the columns count over that.
 */
double support_difference(int64_t rows, int32_t columns, const double *a, const double *b,
                          double floor);

#endif
