/* SPDX-License-Identifier: MIT */
/* Calibrations of the tests: vehicles, parameters and targets in a line each. */
#ifndef TRK_TESTS_CALIBRATE_FIT_H
#define TRK_TESTS_CALIBRATE_FIT_H

#include "support.h"
#include "vehicles.h"

#include <truckride/calibrate.h>

enum { FIT_MAXIMUM = 8 }; /* parameters or targets of any calibration here */

static inline trk_calibration *fit_create(trk_context *context, trk_vehicle vehicle)
{
    trk_calibration *calibration;
    trk_spec *spec = support_spec(context, vehicle, TRK_VARIANT_LINEAR);
    assert_ok(context, trk_calibration_create(context, spec, NULL, &calibration));
    trk_spec_destroy(spec);
    return calibration;
}

/* A factor on the stiffness of links, named after its pattern. */
static inline void fit_stiffness(trk_context *context, trk_calibration *c, const char *pattern)
{
    int32_t id;
    assert_ok(context, trk_calibration_add_parameter(c, pattern, NULL, &id));
    assert_ok(context, trk_calibration_act_on(c, id, TRK_FIELD_STIFFNESS, pattern, 1, NULL));
}

/* A target on the mode of a coordinate, named after it. */
static inline void fit_mode(trk_context *context, trk_calibration *c, const char *coordinate,
                            double value)
{
    trk_target_options o;
    trk_target_options_init(&o, sizeof o);
    o.coordinate = coordinate;
    o.value = value;
    assert_ok(context, trk_calibration_add_target(c, coordinate, &o, NULL));
}

static inline double fit_fitted(trk_calibration *c, int32_t parameter)
{
    trk_parameter_result r = {.struct_size = sizeof r};
    assert_int_equal(trk_calibration_get_parameter(c, parameter, &r), TRK_OK);
    return r.fitted;
}

/* Uniform in [0, 1), the same everywhere: multiplicative congruential, Park and Miller, CACM 31 (1988). */
static inline double fit_uniform(int64_t *state)
{
    *state = *state * 48271 % 2147483647;
    return (double)*state / 2147483647.0;
}

/* Standard normal, by Box and Muller. */
static inline double fit_normal(int64_t *state)
{
    double radius = sqrt(-2 * log(1 - fit_uniform(state)));
    return radius * cos(6.283185307179586 * fit_uniform(state));
}

#endif
