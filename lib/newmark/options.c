/* SPDX-License-Identifier: MIT */
/* Options of the stepper: defaults, the named methods, checks. */
#include "newmark/options.h"

#include <math.h>

static const trk_newmark_options defaults = {.struct_size = sizeof defaults,
                                             .step = 1e-3,
                                             .beta = 0.25,
                                             .gamma = 0.5,
                                             .tolerance = 1e-10,
                                             .max_iterations = 100};

void trk_newmark_options_init(trk_newmark_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static void set_method(trk_newmark_options *options, double alpha_m, double alpha_f)
{
    if (!options)
        return;
    double shift = 1 - alpha_m + alpha_f;
    options->alpha_m = alpha_m;
    options->alpha_f = alpha_f;
    options->gamma = shift - 0.5;
    options->beta = shift * shift / 4;
}

void trk_newmark_options_adams(trk_newmark_options *options)
{
    set_method(options, 0, 0);
    if (options) {
        options->beta = 0.36;
        options->gamma = 0.7;
    }
}

void trk_newmark_options_hht(trk_newmark_options *options, double alpha)
{
    set_method(options, 0, -alpha);
}

void trk_newmark_options_generalized_alpha(trk_newmark_options *options, double rho_infinity)
{
    set_method(options, (2 * rho_infinity - 1) / (rho_infinity + 1),
               rho_infinity / (rho_infinity + 1));
}

static trk_status check_range(trk_context *context, const char *field, double value, double low,
                              double high)
{
    if (value >= low && value <= high)
        return TRK_OK;
    return trk_fail(context, TRK_E_RANGE, "trk_newmark_options: %s is %g; %g to %g is needed",
                    field, value, low, high);
}

trk_status trk_newmark_read_options(trk_context *context, const trk_newmark_options *options,
                                    trk_newmark_options *out)
{
    *out = defaults;
    trk_status status = trk_read_options(context, "trk_newmark_options", options, out, sizeof *out);
    if (status != TRK_OK)
        return status;
    if (!isfinite(out->step) || out->step <= 0)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_newmark_options: step is %g s; a finite number > 0 is needed",
                        out->step);
    if (!isfinite(out->tolerance) || out->tolerance <= 0 || out->tolerance > 0.01)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_newmark_options: tolerance is %g; above 0, at most 0.01 is needed",
                        out->tolerance);
    if (out->max_iterations < 1)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_newmark_options: max_iterations is %d; at least 1 is needed",
                        out->max_iterations);
    status = check_range(context, "beta", out->beta, 0, 1);
    if (status == TRK_OK)
        status = check_range(context, "gamma", out->gamma, 0.5, 1.5);
    if (status == TRK_OK)
        status = check_range(context, "alpha_f", out->alpha_f, 0, 0.5);
    if (status == TRK_OK)
        status = check_range(context, "alpha_m", out->alpha_m, -1, out->alpha_f);
    return status;
}
