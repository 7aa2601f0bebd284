/* SPDX-License-Identifier: MIT */
/* Starts, limits, and the way from minimiser to judgement to report. */
#include "calibrate/calibrate.h"

#include <math.h>
#include <string.h>

static const trk_solve_options defaults = {
    .struct_size = sizeof defaults, .max_evaluations = 200, .starts = 1, .seed = 1, .met = 2};

static const double reach[] = {0.35, 1.4}; /* of u, for the search of a second answer           */
static const double apart_gradient = 1e-3; /* of u: no rounding, but another minimum            */
static const double apart_run = 0.02;      /* the same where the minimiser knows no gradient    */

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
    if (o->max_evaluations < 1 || o->starts < 1 || !(o->max_time >= 0) || !isfinite(o->met) ||
        o->met <= 0)
        return trk_fail(
            context, TRK_E_RANGE,
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
    uint64_t z =
        ((uint64_t)(uint32_t)seed << 32) + (uint64_t)(uint32_t)start * 65536u + (uint32_t)parameter;
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

/* What the starts came to. */
typedef struct outcome {
    double u[TRK_MAX_PARAMETERS], q;
    trk_status stopped;
    bool two_answers;
} outcome;

/*
 * Keep the better one of two ends. Two minima apart from each other that the targets do not
 * tell apart, by the limit that a target is met within, are two answers.
 */
static void keep_better(const trk_calibration *c, outcome *best, const outcome *other)
{
    double met = c->solve_options.met * c->solve_options.met / 2, distance = 0;
    for (int32_t j = 0; j < trk_fit_parameter_count(c); j++)
        distance = fmax(distance, fabs(other->u[j] - best->u[j]));
    bool apart = distance > (trk_fit_has_gradient(c) ? apart_gradient : apart_run);
    if (best->stopped == TRK_OK && other->stopped == TRK_OK && fabs(other->q - best->q) <= met)
        best->two_answers |= apart;
    else if (other->q < best->q)
        best->two_answers = false;
    if (other->q < best->q) {
        best->q = other->q;
        best->stopped = other->stopped;
        memcpy(best->u, other->u, sizeof best->u);
    }
}

/* Minimise from other->u and keep the better one; *out_end: that was the last start. */
static trk_status run_start(trk_calibration *c, trk_fit_watch *watch, outcome *other, outcome *best,
                            bool *out_end)
{
    watch->used = 0;
    other->stopped = trk_fit_minimise(c, watch, other->u, &other->q);
    watch->done += watch->share;
    if (other->stopped == TRK_E_MEMORY || other->stopped == TRK_E_UNSUPPORTED)
        return other->stopped;
    keep_better(c, best, other);
    bool late = other->stopped == TRK_E_LIMIT && trk_fit_clock() > watch->deadline;
    *out_end = other->stopped == TRK_E_CANCELLED || late;
    if (*out_end)
        best->stopped = other->stopped;
    return TRK_OK;
}

static trk_status run_starts(trk_calibration *c, trk_fit_watch *watch, outcome *best)
{
    trk_status status = TRK_OK;
    bool end = false;
    *best = (outcome){.q = INFINITY, .stopped = TRK_E_CONVERGENCE};
    starting_point(c, 0, best->u);
    for (int32_t start = 0; status == TRK_OK && !end && start < c->solve_options.starts; start++) {
        outcome other = {.q = INFINITY};
        starting_point(c, start, other.u);
        status = run_start(c, watch, &other, best, &end);
    }
    return status;
}

/*
 * Start again from both sides of an answer, away from it in the direction that the targets
 * see least: where equations have two solutions, this is the way from one to the other.
 */
static trk_status look_beyond(trk_calibration *c, trk_fit_watch *watch, outcome *best)
{
    double centre[TRK_MAX_PARAMETERS], weakest[TRK_MAX_PARAMETERS], largest = 0;
    int32_t n = trk_fit_parameter_count(c);
    memcpy(centre, best->u, sizeof centre);
    memcpy(weakest, c->weakest, sizeof weakest);
    for (int32_t j = 0; j < n; j++)
        largest = fmax(largest, fabs(weakest[j]));
    watch->known = centre;
    trk_status status = TRK_OK;
    bool end = false;
    for (int k = 0; k < 4 && status == TRK_OK && !end && !best->two_answers; k++) {
        double step = (k % 2 ? 1 : -1) * reach[k / 2] / largest;
        outcome other = {.q = INFINITY};
        for (int32_t j = 0; j < n; j++) {
            const trk_parameter_options *o = &c->parameters[j].options;
            other.u[j] = fmin(fmax(centre[j] + step * weakest[j], log(o->lower)), log(o->upper));
        }
        status = run_start(c, watch, &other, best, &end);
    }
    return status;
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
        target->result.before = status != TRK_OK            ? NAN
                                : target->options.frequency ? sqrt(square / target->count)
                                                            : y[target->first];
    }
    trk_free(c->context, y);
    return status;
}

/* Starts, judgement, and of a good answer the question whether it is the only one. */
static trk_status find_answer(trk_calibration *c, trk_progress progress, void *user)
{
    const trk_solve_options *o = &c->solve_options;
    bool gradient = trk_fit_has_gradient(c);
    trk_fit_watch watch = {.progress = progress,
                           .user = user,
                           .deadline = o->max_time > 0 ? trk_fit_clock() + o->max_time : INFINITY,
                           .allowed = o->max_evaluations,
                           .share = 1.0 / (gradient ? o->starts + 4.0 : o->starts)};
    outcome best;
    trk_status status = run_starts(c, &watch, &best);
    if (status == TRK_OK)
        status = trk_fit_judge(c, best.u, best.stopped);
    if (status == TRK_OK && c->outcome == TRK_OK && gradient && !best.two_answers) {
        double q = best.q;
        status = look_beyond(c, &watch, &best);
        if (status == TRK_OK && (best.q < q || best.stopped == TRK_E_CANCELLED))
            status = trk_fit_judge(c, best.u, best.stopped);
    }
    if (status == TRK_OK && c->outcome == TRK_OK && best.two_answers) {
        c->outcome = TRK_E_IDENTIFY;
        trk_format(
            c->verdict, sizeof c->verdict,
            "the targets are met by more than one set of parameters: two starts ended apart");
    }
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
        return trk_fail_within(c->context, TRK_E_CONVERGENCE,
                               "the model cannot be evaluated at the start");
    status = find_answer(c, progress, user);
    if (status == TRK_OK)
        status = trk_fit_report(c);
    if (status != TRK_OK)
        return status;
    c->solved = true;
    return c->outcome == TRK_OK ? TRK_OK : trk_fail(c->context, c->outcome, "%s", c->verdict);
}
