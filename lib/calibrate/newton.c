/* SPDX-License-Identifier: MIT */
/* Gauss-Newton steps within bounds. */
#include "calibrate/calibrate.h"

#include "linalg/small.h"

#include <math.h>

void trk_fit_hold(const trk_calibration *calibration, const double *u, const double *r,
                  const double *jacobian, bool *out_held)
{
    int32_t n = trk_fit_parameter_count(calibration);
    for (int32_t j = 0; j < n; j++) {
        const trk_parameter_options *o = &calibration->parameters[j].options;
        double slope = 0;
        for (int32_t i = 0; i < calibration->value_count; i++)
            slope += jacobian[(int64_t)i * n + j] * r[i];
        out_held[j] = (u[j] <= log(o->lower) + TRK_AT_BOUND && slope > 0) ||
                      (u[j] >= log(o->upper) - TRK_AT_BOUND && slope < 0);
    }
}

bool trk_fit_gauss_newton(const trk_calibration *calibration, const double *u, const double *r,
                          const double *jacobian, double *out_step)
{
    double a[TRK_MAX_PARAMETERS * TRK_MAX_PARAMETERS], b[TRK_MAX_PARAMETERS];
    int32_t n = trk_fit_parameter_count(calibration), m = calibration->value_count;
    int32_t list[TRK_MAX_PARAMETERS], count = 0;
    bool held[TRK_MAX_PARAMETERS];
    trk_fit_hold(calibration, u, r, jacobian, held);
    for (int32_t j = 0; j < n; j++) {
        out_step[j] = 0;
        if (!held[j])
            list[count++] = j;
    }
    for (int32_t k = 0; k < count; k++) {
        b[k] = 0;
        for (int32_t i = 0; i < m; i++)
            b[k] -= jacobian[(int64_t)i * n + list[k]] * r[i];
        for (int32_t l = 0; l < count; l++) {
            double sum = 0;
            for (int32_t i = 0; i < m; i++)
                sum += jacobian[(int64_t)i * n + list[k]] * jacobian[(int64_t)i * n + list[l]];
            a[k * count + l] = sum;
        }
    }
    if (count > 0 && !trk_small_solve(count, a, b))
        return false;
    for (int32_t k = 0; k < count; k++) {
        const trk_parameter_options *o = &calibration->parameters[list[k]].options;
        double to = fmin(fmax(u[list[k]] + b[k], log(o->lower)), log(o->upper));
        out_step[list[k]] = to - u[list[k]];
    }
    return true;
}
