/* SPDX-License-Identifier: MIT */
/* Points of the design: functions of seed, case and parameter. */
#include "base/random.h"
#include "study/quantile.h"
#include "study/study.h"

double trk_study_quantile(const trk_design_parameter *parameter, double u)
{
    const trk_study_parameter_options *o = &parameter->options;
    double value = o->lower + u * (o->upper - o->lower);
    if (o->distribution == TRK_DISTRIBUTION_LOG_UNIFORM)
        value = o->lower * trk_plain_exp(u * (trk_plain_log(o->upper) - trk_plain_log(o->lower)));
    if (o->distribution == TRK_DISTRIBUTION_NORMAL ||
        o->distribution == TRK_DISTRIBUTION_LOG_NORMAL) {
        const double p = parameter->first + u * (parameter->last - parameter->first);
        value = o->mean + o->deviation * parameter->sign * trk_normal_quantile(p);
        if (o->distribution == TRK_DISTRIBUTION_LOG_NORMAL)
            value = trk_plain_exp(value);
    }
    /* Rounding may lead beyond a bound; the bounds themselves are levels of a factorial. */
    if (u == 0 || value < o->lower)
        return o->lower;
    if (u == 1 || value > o->upper)
        return o->upper;
    return value;
}

/* (STUDY.6) */
static void factorial(const trk_study *study, int64_t point, double *out)
{
    for (int32_t j = trk_study_parameters(study) - 1; j >= 0; j--) {
        const int32_t levels = study->parameters[j].options.levels;
        const int64_t level = point % levels;
        point /= levels;
        out[j] = trk_study_quantile(&study->parameters[j],
                                    levels > 1 ? (double)level / (double)(levels - 1) : 0.5);
    }
}

void trk_study_point(const trk_study *study, int64_t point, double *out_parameters)
{
    const trk_study_options *o = &study->options;
    if (o->design == TRK_DESIGN_FACTORIAL) {
        factorial(study, point, out_parameters);
        return;
    }
    for (int32_t j = 0; j < trk_study_parameters(study); j++) {
        double u = trk_random_uniform(o->seed, (uint64_t)point, (uint32_t)j);
        if (o->design == TRK_DESIGN_LATIN_HYPERCUBE) {
            const uint64_t stratum =
                trk_random_permute(o->seed, (uint32_t)j, (uint64_t)o->points, (uint64_t)point);
            u = ((double)stratum + u) / (double)o->points;
        }
        out_parameters[j] = trk_study_quantile(&study->parameters[j], u);
    }
}

int64_t trk_study_cases(const trk_study *study)
{
    const int32_t roads = trk_study_count(study, TRK_STUDY_EXCITATION);
    return study ? study->points * (roads > 0 ? roads : 1) : 0;
}

trk_status trk_study_get_case(const trk_study *study, int64_t number, double *out_parameters,
                              int32_t *out_excitation)
{
    if (number < 0 || number >= trk_study_cases(study))
        return TRK_E_ARGUMENT;
    const int32_t roads = trk_study_count(study, TRK_STUDY_EXCITATION);
    if (out_parameters)
        trk_study_point(study, roads > 0 ? number / roads : number, out_parameters);
    if (out_excitation)
        *out_excitation = roads > 0 ? (int32_t)(number % roads) + 1 : 0;
    return TRK_OK;
}
