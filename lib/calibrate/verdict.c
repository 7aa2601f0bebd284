/* SPDX-License-Identifier: MIT */
/* What came out of a calibration, in a status and a sentence. */
#include "calibrate/calibrate.h"

#include <math.h>

static const char *parameter_name(const trk_calibration *c, int32_t j)
{
    return trk_names_text(&c->parameter_names, j + 1);
}

/* A target is missed at a minimum: out of reach within the bounds, or contradicted by others. */
static void say_missed(trk_calibration *c, int32_t worst)
{
    const trk_target_result *result = &c->targets[worst].result;
    char why[256] = "the targets contradict each other or the model cannot follow them";
    for (int32_t j = 0; j < trk_fit_parameter_count(c); j++)
        if (c->parameters[j].result.at_bound)
            trk_format(why, sizeof why, "parameter '%s' is at its %s bound %g",
                       parameter_name(c, j),
                       c->parameters[j].result.at_bound < 0 ? "lower" : "upper",
                       c->parameters[j].result.fitted);
    trk_format(c->verdict, sizeof c->verdict,
               "target '%s' cannot be reached: %g at best, %g measured, %.1f standard "
               "uncertainties off; %s",
               trk_names_text(&c->target_names, worst + 1), result->after, result->measured,
               fabs(result->residual), why);
}

void trk_fit_conclude(trk_calibration *calibration, trk_status stopped, bool minimum,
                      const double *sigma)
{
    trk_calibration *c = calibration;
    int32_t worst = 0, unknown = -1;
    for (int32_t t = 1; t < trk_fit_target_count(c); t++)
        if (fabs(c->targets[t].result.residual) > fabs(c->targets[worst].result.residual))
            worst = t;
    for (int32_t j = trk_fit_parameter_count(c) - 1; j >= 0; j--)
        if (!c->parameters[j].result.determined)
            unknown = j;
    c->outcome = TRK_OK;
    bool found = minimum && trk_fit_has_gradient(c); /* then the limit came after the minimum */
    if ((stopped == TRK_E_LIMIT && !found) || stopped == TRK_E_CANCELLED) {
        c->outcome = stopped;
        trk_format(c->verdict, sizeof c->verdict,
                   "%s after %lld evaluations; target '%s' is %.3g standard uncertainties off",
                   stopped == TRK_E_LIMIT ? "stopped by the limit of evaluations or time"
                                          : "cancelled",
                   (long long)c->evaluations, trk_names_text(&c->target_names, worst + 1),
                   fabs(c->targets[worst].result.residual));
    } else if (!minimum) {
        c->outcome = TRK_E_CONVERGENCE;
        trk_format(
            c->verdict, sizeof c->verdict,
            "no minimum was reached in %lld evaluations, %lld of which failed; target '%s' is "
            "%.3g standard uncertainties off; its mode or peak may change abruptly there",
            (long long)c->evaluations, (long long)c->failures,
            trk_names_text(&c->target_names, worst + 1), fabs(c->targets[worst].result.residual));
    } else if (!c->targets[worst].result.met) {
        c->outcome = TRK_E_TARGET;
        say_missed(c, worst);
    } else if (unknown >= 0) {
        c->outcome = TRK_E_IDENTIFY;
        trk_format(c->verdict, sizeof c->verdict,
                   isfinite(sigma[unknown])
                       ? "parameter '%s' is not determined: the targets leave it a factor of %.3g "
                         "up or down"
                       : "parameter '%s' is not determined: the targets do not depend on it alone",
                   parameter_name(c, unknown), exp(TRK_NORMAL95 * sigma[unknown]));
    } else {
        trk_format(c->verdict, sizeof c->verdict,
                   "all targets are met and all parameters are determined");
    }
}
