/* SPDX-License-Identifier: MIT */
/*
 * Inside of a calibration. Data flows: parameters -> spec -> model -> values of the
 * targets (evaluate.c) -> minimiser (solve.c, the only user of NLopt) -> judgement
 * (judge.c) -> words (report.c). Parameters are varied as u = ln p.
 */
#ifndef TRK_CALIBRATE_CALIBRATE_H
#define TRK_CALIBRATE_CALIBRATE_H

#include "base/names.h"
#include <truckride/calibrate.h>

#define TRK_AT_BOUND 1e-9              /* of u: as near as this is at a bound           */
#define TRK_NORMAL95 1.959963984540054 /* half width of 95 %, standard deviations */

enum {
    TRK_MAX_PARAMETERS = 64,
    TRK_MAX_VALUES = 512 /* the minimiser has one unknown per value */
};

typedef struct trk_fit_parameter {
    trk_parameter_options options;
    trk_parameter_result result;
} trk_fit_parameter;

/* One field of one part that a parameter acts on: field = base * (p^power / reference). */
typedef struct trk_fit_action {
    int32_t parameter; /* 0-based                                     */
    trk_field field;
    int32_t part; /* id of the link or body                      */
    double power;
    double reference; /* 1, or for TRK_MEANING_VALUE the spec's value */
} trk_fit_action;

typedef struct trk_fit_target {
    trk_target_options options; /* arrays owned, names NULL                     */
    int32_t first, count;       /* its values are first .. first + count - 1    */
    double *shape;              /* modes: length coordinates, owned             */
    int32_t sensor;             /* peaks and curves: id                         */
    trk_target_result result;
} trk_fit_target;

struct trk_calibration {
    trk_context *context;
    trk_spec *base, *work; /* as given; with the parameters of the last evaluation */
    trk_model_options model_options;
    trk_model *model; /* of the base spec: names and counts                  */
    trk_names parameter_names, target_names;
    trk_fit_parameter *parameters;
    trk_fit_action *actions;
    trk_fit_target *targets;
    int32_t action_count, value_count;
    int64_t parameter_capacity, action_capacity, target_capacity;
    const trk_excitation *excitation; /* borrowed; NULL: none given */
    trk_run_options run;
    /* The last solve. */
    bool solved;
    int64_t evaluations, failures;
    trk_solve_options solve_options;
    double *jacobian, *singular;        /* values x parameters, row-major; min of both */
    double weakest[TRK_MAX_PARAMETERS]; /* direction of u that the targets see least */
    trk_status outcome;
    char verdict[512]; /* why it stopped, a sentence   */
    char *report;
};

static inline int32_t trk_fit_parameter_count(const trk_calibration *c)
{
    return c->parameter_names.count;
}

static inline int32_t trk_fit_target_count(const trk_calibration *c)
{
    return c->target_names.count;
}

/* Has every target a gradient? */
bool trk_fit_has_gradient(const trk_calibration *calibration);

/* Put parameters u = ln p into a spec that has the parts of the base spec under their ids in
 * part_of (by action), NULL for the same ids. */
trk_status trk_fit_apply(const trk_calibration *calibration, const double *u, trk_spec *spec,
                         const int32_t *part_of);

/*
 * Values y(u) and derivatives dy/du (values x parameters, row-major, NULL to skip).
 * Curves: ln(model / measured). Messages name the target.
 */
trk_status trk_fit_evaluate(trk_calibration *calibration, const double *u, double *out_y,
                            double *out_jacobian);

/* Values and derivatives of all targets on modes, into the places of their values. */
trk_status trk_fit_modal(trk_calibration *calibration, const double *u, const trk_model *model,
                         double *out_y, double *out_jacobian);

/* The same on frequency responses; values, and derivatives. */
trk_status trk_fit_response(trk_calibration *calibration, const trk_model *model, double *out_y);
trk_status trk_fit_response_gradient(trk_calibration *calibration, const double *u,
                                     double *jacobian);

/* Values of all targets on the simulated run. */
trk_status trk_fit_run(trk_calibration *calibration, const trk_model *model, double *out_y);

/* Put the name of a target (0-based) in front of the message. Returns status. */
trk_status trk_fit_fail_at(const trk_calibration *calibration, int32_t target, trk_status status);

/* ln(model / measured) at the points of a curve; out_y may be model. */
void trk_fit_compare(const trk_fit_target *target, const double *model, double *out_y);

/* Compile the model of parameters u; the caller destroys it. */
trk_status trk_fit_compile(trk_calibration *calibration, const double *u, trk_model **out_model);

/* Weighted residuals of (CALIBRATE.1), r = w (y - t) / s, and in place dr/du. */
void trk_fit_residuals(const trk_calibration *calibration, const double *y, double *out_r,
                       double *jacobian);

/* Limits of one start. */
typedef struct trk_fit_watch {
    trk_progress progress;
    void *user;
    double deadline; /* [s] of trk_fit_clock(); infinite: none             */
    int64_t allowed; /* evaluations of this start                          */
    int64_t used;
    double done, share;  /* of all the work: before this start, and by it   */
    const double *known; /* answer that it is useless to find again; or NULL */
} trk_fit_watch;

/* Monotonic time [s]. */
double trk_fit_clock(void);

/* May the model be evaluated once more? Counts it. TRK_E_LIMIT or TRK_E_CANCELLED: no. */
trk_status trk_fit_count(trk_calibration *calibration, trk_fit_watch *watch);

/*
 * Minimise Q from u, in place; *out_q is Q there. TRK_OK: it has converged. A status of
 * trk_fit_count(), TRK_E_CONVERGENCE or TRK_E_MEMORY otherwise; u is the best point seen
 * all the same. Close to watch->known it gives up with TRK_E_CONVERGENCE.
 */
trk_status trk_fit_minimise(trk_calibration *calibration, trk_fit_watch *watch, double *u,
                            double *out_q);

/*
 * Judge the answer u, where the minimiser stopped with a status: residuals, Jacobian,
 * intervals. Sets outcome and verdict; returns the status of this work, not the outcome.
 */
trk_status trk_fit_judge(trk_calibration *calibration, const double *u, trk_status stopped);

/* Say in words what came out: sets outcome and verdict (verdict.c). sigma: of u, by parameter. */
void trk_fit_conclude(trk_calibration *calibration, trk_status stopped, bool minimum,
                      const double *sigma);

/* Parameters at a bound that a step downhill would leave: they stay. */
void trk_fit_hold(const trk_calibration *calibration, const double *u, const double *r,
                  const double *jacobian, bool *out_held);

/* Gauss-Newton step -(J^T J)^-1 J^T r within the bounds of u. false: J has no full rank. */
bool trk_fit_gauss_newton(const trk_calibration *calibration, const double *u, const double *r,
                          const double *jacobian, double *out_step);

/* Write the report (report.c). */
trk_status trk_fit_report(trk_calibration *calibration);

#endif
