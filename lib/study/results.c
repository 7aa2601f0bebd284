/* SPDX-License-Identifier: MIT */
/* Results of a study: kept, handed in, read back. */
#include "study/study.h"

#include <math.h>

bool trk_study_is_outcome(trk_status status)
{
    return status == TRK_OK || status == TRK_E_RANGE || status == TRK_E_MODEL ||
           status == TRK_E_SINGULAR || status == TRK_E_CONVERGENCE;
}

trk_status trk_study_check_case(const trk_study *study, const char *function, int64_t number)
{
    const int64_t cases = trk_study_cases(study);
    if (number >= 0 && number < cases)
        return TRK_OK;
    return trk_fail(study->context, TRK_E_ARGUMENT,
                    "%s: there is no case %lld; they run from 0 to %lld", function,
                    (long long)number, (long long)cases - 1);
}

static double *values_of(const trk_study *study, int64_t number)
{
    return study->values + number * trk_study_outputs(study);
}

void trk_study_store(trk_study *study, int64_t number, trk_status status, const double *values)
{
    double *to = values_of(study, number);
    for (int32_t k = 0; k < trk_study_outputs(study); k++)
        to[k] = status == TRK_OK && !isnan(values[k]) ? values[k] : NAN;
    study->finished += study->state[number] == 0;
    study->state[number] = status + 1;
}

bool trk_study_agrees(const trk_study *study, int64_t number, trk_status status,
                      const double *values)
{
    const double *kept = values_of(study, number);
    bool same = study->state[number] == status + 1;
    for (int32_t k = 0; same && status == TRK_OK && k < trk_study_outputs(study); k++)
        same = kept[k] == values[k] || (isnan(kept[k]) && isnan(values[k]));
    return same;
}

trk_status trk_study_set_outputs(trk_study *study, int64_t number, trk_status status,
                                 const double *values)
{
    static const char what[] = "trk_study_set_outputs";
    TRK_REQUIRE(NULL, study, "trk_study_set_outputs");
    TRK_REQUIRE(study->context, values, "trk_study_set_outputs");
    trk_status result = trk_study_check_case(study, what, number);
    if (result == TRK_OK)
        result = trk_study_prepare(study, what);
    if (result != TRK_OK)
        return result;
    bool valid = trk_study_is_outcome(status);
    for (int32_t k = 0; valid && status == TRK_OK && k < trk_study_outputs(study); k++)
        valid = !isinf(values[k]);
    if (!valid)
        return trk_fail(study->context, TRK_E_ARGUMENT,
                        "%s: case %lld: status %d or a value is none that a case can have", what,
                        (long long)number, status);
    if (study->state[number]) {
        if (trk_study_agrees(study, number, status, values))
            return TRK_OK;
        return trk_fail(study->context, TRK_E_ARGUMENT,
                        "%s: case %lld is finished with another result", what, (long long)number);
    }
    trk_study_store(study, number, status, values);
    result = trk_journal_append(study, number);
    return result == TRK_OK ? trk_journal_flush(study) : result;
}

int64_t trk_study_finished(const trk_study *study)
{
    return study ? study->finished : 0;
}

int32_t trk_study_is_finished(const trk_study *study, int64_t number)
{
    return study && study->ready && number >= 0 && number < trk_study_cases(study) &&
           study->state[number] != 0;
}

trk_status trk_study_get_outputs(const trk_study *study, int64_t number, double *out_values,
                                 trk_status *out_status)
{
    if (!trk_study_is_finished(study, number))
        return TRK_E_ARGUMENT;
    for (int32_t k = 0; out_values && k < trk_study_outputs(study); k++)
        out_values[k] = values_of(study, number)[k];
    if (out_status)
        *out_status = study->state[number] - 1;
    return TRK_OK;
}
