/* SPDX-License-Identifier: MIT */
/* Starts, limits, and the way from minimiser to judgement to report. */
#include "calibrate/calibrate.h"

#include <math.h>
#include <string.h>

static const trk_solve_options defaults = {
    .struct_size = sizeof defaults, .max_evaluations = 200, .starts = 1, .seed = 1, .met = 2};

void trk_solve_options_init(trk_solve_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status check(trk_calibration *c, const trk_solve_options *options)
{
    trk_context *context = c->context;
    trk_solve_options *o = &c->solve_options;
    *o = defaults;
    trk_status status = trk_read_options(context, "trk_solve_options", options, o, sizeof *o);
    if (status != TRK_OK)
        return status;
    if (o->max_evaluations < 1 || o->starts < 1 || !(o->max_time >= 0) || !isfinite(o->met) || o->met <= 0)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_solve_options: %lld evaluations, %d starts, %g s, met within %g: positive "
                        "numbers are needed",
                        (long long)o->max_evaluations, o->starts, o->max_time, o->met);
    if (trk_fit_parameter_count(c) == 0 || trk_fit_target_count(c) == 0)
        return trk_fail(context, TRK_E_ARGUMENT, "the calibration has no %s",
                        trk_fit_parameter_count(c) ? "target" : "parameter");
    if (!trk_fit_has_gradient(c) && !c->excitation)
        return trk_fail(context, TRK_E_ARGUMENT,
                        "a target is taken from a run: call trk_calibration_set_run() first");
    for (int32_t j = 0; j < trk_fit_parameter_count(c); j++) {
        bool acts = false;
        for (int32_t k = 0; k < c->action_count; k++)
            acts |= c->actions[k].parameter == j;
        if (!acts)
            return trk_fail(context, TRK_E_ARGUMENT, "parameter '%s' acts on nothing",
                            trk_names_text(&c->parameter_names, j + 1));
    }
    return TRK_OK;
}

/* Uniform in [0, 1), keyed by seed, start and parameter: the same on every machine.
 * Source: G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014 (SplitMix64). */
static double uniform(int32_t seed, int32_t start, int32_t parameter)
{
    uint64_t z = ((uint64_t)(uint32_t)seed << 32) + (uint64_t)(uint32_t)start * 65536u + (uint32_t)parameter;
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return (double)(z >> 11) * 0x1p-53;
}

static void starting_point(const trk_calibration *c, int32_t start, double *u)
{
    for (int32_t j = 0; j < trk_fit_parameter_count(c); j++) {
        const trk_parameter_options *o = &c->parameters[j].options;
        double low = log(o->lower), high = log(o->upper);
        u[j] = start == 0 ? log(o->start)
                          : low + (high - low) * uniform(c->solve_options.seed, start, j);
    }
}

/* Do two points that both meet the targets differ? Then the targets do not tell them apart. */
static bool ambiguous(const trk_calibration *c, const double *a, double q_a, const double *b, double q_b)
{
    double met = c->solve_options.met * c->solve_options.met / 2, distance = 0;
    for (int32_t j = 0; j < trk_fit_parameter_count(c); j++)
        distance = fmax(distance, fabs(a[j] - b[j]));
    return q_a <= met && q_b <= met && distance > 1e-3;
}

/* What the starts came to. */
typedef struct outcome {
    double u[TRK_MAX_PARAMETERS], q;
    trk_status stopped;
    bool two_answers;
} outcome;

static trk_status run_starts(trk_calibration *c, trk_progress progress, void *user, outcome *best)
{
    const trk_solve_options *o = &c->solve_options;
    double deadline = o->max_time > 0 ? trk_fit_clock() + o->max_time : INFINITY;
    *best = (outcome){.q = INFINITY, .stopped = TRK_E_CONVERGENCE};
    starting_point(c, 0, best->u);
    for (int32_t start = 0; start < o->starts; start++) {
        trk_fit_watch watch = {progress, user, deadline, o->max_evaluations, 0};
        double u[TRK_MAX_PARAMETERS], q = INFINITY;
        starting_point(c, start, u);
        trk_status status = trk_fit_minimise(c, &watch, u, &q);
        if (status == TRK_E_MEMORY || status == TRK_E_UNSUPPORTED)
            return status;
        best->two_answers |= start > 0 && ambiguous(c, u, q, best->u, best->q);
        if (q < best->q || start == 0) {
            best->q = q;
            best->stopped = status;
            memcpy(best->u, u, sizeof u);
        }
        if (status == TRK_E_CANCELLED || (status == TRK_E_LIMIT && trk_fit_clock() > deadline)) {
            best->stopped = status;
            break;
        }
    }
    return TRK_OK;
}

static trk_status values_before(trk_calibration *c)
{
    double u[TRK_MAX_PARAMETERS];
    double *y = trk_new(c->context, c->value_count, sizeof *y);
    if (!y)
        return TRK_E_MEMORY;
    starting_point(c, 0, u);
    trk_status status = trk_fit_evaluate(c, u, y, NULL);
    for (int32_t t = 0; t < trk_fit_target_count(c); t++) {
        trk_fit_target *target = &c->targets[t];
        double square = 0;
        for (int32_t i = target->first; i < target->first + target->count; i++)
            square += y[i] * y[i];
        target->result.before = status != TRK_OK          ? NAN
                                : target->options.frequency ? sqrt(square / target->count)
                                                            : y[target->first];
    }
    trk_free(c->context, y);
    return status;
}

trk_status trk_calibration_solve(trk_calibration *calibration, const trk_solve_options *options,
                                 trk_progress progress, void *user)
{
    TRK_REQUIRE(NULL, calibration, "trk_calibration_solve");
    trk_calibration *c = calibration;
    c->solved = false;
    c->evaluations = c->failures = 0;
    trk_status status = check(c, options);
    if (status != TRK_OK)
        return status;
    status = values_before(c);
    c->evaluations++;
    if (status == TRK_E_MEMORY)
        return status;
    if (status != TRK_OK)
        return trk_fail_within(c->context, TRK_E_CONVERGENCE, "the model cannot be evaluated at the start");
    outcome best;
    status = run_starts(c, progress, user, &best);
    if (status == TRK_OK)
        status = trk_fit_judge(c, best.u, best.stopped);
    if (status == TRK_OK && c->outcome == TRK_OK && best.two_answers) {
        c->outcome = TRK_E_IDENTIFY;
        trk_format(c->verdict, sizeof c->verdict,
                   "the targets are met by more than one set of parameters: two starts ended apart");
    }
    if (status == TRK_OK)
        status = trk_fit_report(c);
    if (status != TRK_OK)
        return status;
    c->solved = true;
    return c->outcome == TRK_OK ? TRK_OK : trk_fail(c->context, c->outcome, "%s", c->verdict);
}
