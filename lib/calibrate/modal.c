/* SPDX-License-Identifier: MIT */
/*
 * Eigenfrequencies and damping ratios of modes picked by what they are, with their
 * derivatives (CALIBRATE.2, CALIBRATE.3):
 *
 *     undamped  d lambda = phi^T (dK - lambda dM) phi,   phi^T M phi = 1
 *     damped    d lambda = -phi^T (lambda^2 dM + lambda dC + dK) phi
 *                          / (phi^T (2 lambda M + C) phi)
 *
 * The matrices are affine in stiffness, damping and mass, so their derivatives are
 * central differences without truncation error. Where several undamped modes have one
 * frequency up to rounding, any mixture is a mode: the one most like the shape is taken.
 */
#include "calibrate/calibrate.h"

#include <truckride/linear.h>

#include <complex.h>
#include <math.h>
#include <string.h>

static const double two_pi = 6.283185307179586476925286766559;
static const double difference_step = 1e-5; /* of u */
static const double same_frequency = 1e-9;  /* relative difference of one frequency */

/* A picked mode. */
typedef struct pick {
    double complex lambda;
    double complex *phi;
} pick;

typedef struct matrices {
    double *mass, *damping, *stiffness; /* n x n, in one block */
} matrices;

typedef struct modal {
    trk_calibration *c;
    int32_t n;
    matrices now, high, low;
    double *re, *im;
    double complex *phi; /* of the picked modes, targets x n */
    pick *picks;         /* by target                        */
} modal;

static void get_matrices(const trk_model *model, matrices *m)
{
    trk_model_get_mass(model, m->mass);
    trk_model_get_tangent(model, NULL, NULL, m->damping, m->stiffness);
}

/* a^T S b for a symmetric S */
static double complex form(int32_t n, const double complex *a, const double *s,
                           const double complex *b)
{
    double complex sum = 0;
    for (int32_t i = 0; i < n; i++) {
        double complex row = 0;
        for (int32_t j = 0; j < n; j++)
            row += s[(int64_t)i * n + j] * b[j];
        sum += a[i] * row;
    }
    return sum;
}

/* s^T M phi of a mode for a real shape s */
static double complex overlap(const modal *w, const trk_modes *modes, int32_t mode,
                              const double *shape)
{
    (void)!trk_modes_get_shape(modes, mode, w->re, w->im);
    double complex sum = 0;
    for (int32_t i = 0; i < w->n; i++) {
        double row = 0;
        for (int32_t j = 0; j < w->n; j++)
            row += w->now.mass[(int64_t)i * w->n + j] * shape[j];
        sum += row * (w->re[i] + I * w->im[i]);
    }
    return sum;
}

/* Mode with the largest MAC: phi^H M phi is 1 for all, so |s^T M phi| decides. 0: none. */
static int32_t find_mode(const modal *w, const trk_modes *modes, bool damped, const double *shape)
{
    int32_t best = 0;
    double most = 0;
    for (int32_t mode = 1; mode <= trk_modes_count(modes); mode++) {
        bool oscillates = damped ? trk_modes_damped_frequency(modes, mode) > 0
                                 : trk_modes_frequency(modes, mode) > 0;
        double size = oscillates ? cabs(overlap(w, modes, mode, shape)) : 0;
        if (size > most * (1 + 1e-12)) {
            most = size;
            best = mode;
        }
    }
    return best;
}

/* phi = sum over modes of the same frequency of (s^T M phi_j) phi_j, normalised. */
static void mix_equal(const modal *w, const trk_modes *modes, int32_t mode, const double *shape,
                      double complex *phi)
{
    double frequency = trk_modes_frequency(modes, mode), norm = 0;
    memset(phi, 0, (size_t)w->n * sizeof *phi);
    for (int32_t k = 1; k <= trk_modes_count(modes); k++) {
        if (fabs(trk_modes_frequency(modes, k) - frequency) > same_frequency * frequency)
            continue;
        double factor = creal(overlap(w, modes, k, shape));
        for (int32_t i = 0; i < w->n; i++)
            phi[i] += factor * w->re[i];
        norm += factor * factor;
    }
    for (int32_t i = 0; i < w->n; i++)
        phi[i] /= sqrt(norm);
}

static trk_status pick_mode(modal *w, const trk_modes *modes, bool damped, int32_t t)
{
    const double *shape = w->c->targets[t].shape;
    pick *p = &w->picks[t];
    int32_t mode = find_mode(w, modes, damped, shape);
    p->phi = w->phi + (int64_t)t * w->n;
    if (!mode)
        return trk_fail(w->c->context, TRK_E_TARGET,
                        "target '%s': no mode of the model oscillates there",
                        trk_names_text(&w->c->target_names, t + 1));
    if (!damped) {
        p->lambda = I * two_pi * trk_modes_frequency(modes, mode);
        mix_equal(w, modes, mode, shape, p->phi);
        return TRK_OK;
    }
    double size = two_pi * trk_modes_frequency(modes, mode),
           ratio = trk_modes_damping_ratio(modes, mode);
    p->lambda = -ratio * size + I * two_pi * trk_modes_damped_frequency(modes, mode);
    (void)!trk_modes_get_shape(modes, mode, w->re, w->im);
    for (int32_t i = 0; i < w->n; i++)
        p->phi[i] = w->re[i] + I * w->im[i];
    return TRK_OK;
}

static double value_of(trk_target kind, double complex lambda)
{
    return kind == TRK_TARGET_DAMPING_RATIO ? -creal(lambda) / cabs(lambda)
                                            : cimag(lambda) / two_pi;
}

/* d value, given d lambda. */
static double slope_of(trk_target kind, double complex lambda, double complex slope)
{
    if (kind != TRK_TARGET_DAMPING_RATIO)
        return cimag(slope) / two_pi;
    double size = cabs(lambda), size_slope = creal(conj(lambda) * slope) / size;
    return -creal(slope) / size + creal(lambda) * size_slope / (size * size);
}

/* Pick the modes of all targets that are damped, or that are not. */
static trk_status pick_all(modal *w, const trk_model *model, bool damped, double *out_y)
{
    trk_calibration *c = w->c;
    trk_modes *modes = NULL;
    trk_status status = TRK_OK;
    for (int32_t t = 0; status == TRK_OK && t < trk_fit_target_count(c); t++) {
        trk_target kind = c->targets[t].options.kind;
        if (kind > TRK_TARGET_DAMPING_RATIO || (kind != TRK_TARGET_UNDAMPED_FREQUENCY) != damped)
            continue;
        if (!modes)
            status = damped ? trk_modes_create_damped(c->context, model, NULL, NULL, &modes)
                            : trk_modes_create_undamped(c->context, model, NULL, &modes);
        if (status == TRK_OK)
            status = pick_mode(w, modes, damped, t);
        if (status == TRK_OK)
            out_y[c->targets[t].first] = value_of(kind, w->picks[t].lambda);
    }
    trk_modes_destroy(modes);
    return status;
}

/* d lambda, given the derivatives of the matrices in w->high. */
static double complex lambda_slope(const modal *w, trk_target kind, const pick *p)
{
    const matrices *d = &w->high;
    double complex l = p->lambda, k = form(w->n, p->phi, d->stiffness, p->phi);
    double complex m = form(w->n, p->phi, d->mass, p->phi);
    if (kind == TRK_TARGET_UNDAMPED_FREQUENCY) /* of omega = Im l: d(omega^2) = 2 omega d omega */
        return I * (k + l * l * m) / (2 * cimag(l));
    double complex cc = form(w->n, p->phi, d->damping, p->phi);
    return -(l * l * m + l * cc + k) / (2 * l * form(w->n, p->phi, w->now.mass, p->phi) +
                                        form(w->n, p->phi, w->now.damping, p->phi));
}

static trk_status matrices_at(modal *w, double *u, int32_t parameter, double step, matrices *out)
{
    trk_model *model;
    double centre = u[parameter];
    u[parameter] = centre + step;
    trk_status status = trk_fit_compile(w->c, u, &model);
    u[parameter] = centre;
    if (status != TRK_OK)
        return status;
    get_matrices(model, out);
    trk_model_destroy(model);
    return TRK_OK;
}

static trk_status gradient(modal *w, double *u, int32_t parameter, double *jacobian)
{
    trk_calibration *c = w->c;
    trk_status status = matrices_at(w, u, parameter, difference_step, &w->high);
    if (status == TRK_OK)
        status = matrices_at(w, u, parameter, -difference_step, &w->low);
    if (status != TRK_OK)
        return status;
    for (int64_t k = 0; k < 3 * (int64_t)w->n * w->n; k++)
        w->high.mass[k] = (w->high.mass[k] - w->low.mass[k]) / (2 * difference_step);
    for (int32_t t = 0; t < trk_fit_target_count(c); t++) {
        trk_target kind = c->targets[t].options.kind;
        if (kind <= TRK_TARGET_DAMPING_RATIO)
            jacobian[(int64_t)c->targets[t].first * trk_fit_parameter_count(c) + parameter] =
                slope_of(kind, w->picks[t].lambda, lambda_slope(w, kind, &w->picks[t]));
    }
    return TRK_OK;
}

static trk_status run(modal *w, const double *u, const trk_model *model, double *out_y,
                      double *out_jacobian)
{
    double moved[TRK_MAX_PARAMETERS];
    int32_t parameters = trk_fit_parameter_count(w->c);
    get_matrices(model, &w->now);
    trk_status status = pick_all(w, model, false, out_y);
    if (status == TRK_OK)
        status = pick_all(w, model, true, out_y);
    memcpy(moved, u, (size_t)parameters * sizeof *moved);
    for (int32_t j = 0; status == TRK_OK && out_jacobian && j < parameters; j++)
        status = gradient(w, moved, j, out_jacobian);
    return status;
}

static trk_status new_matrices(trk_context *context, int32_t n, matrices *m)
{
    int64_t square = (int64_t)n * n;
    m->mass = trk_new(context, 3 * square, sizeof *m->mass);
    if (!m->mass)
        return TRK_E_MEMORY;
    m->damping = m->mass + square;
    m->stiffness = m->damping + square;
    return TRK_OK;
}

trk_status trk_fit_modal(trk_calibration *calibration, const double *u, const trk_model *model,
                         double *out_y, double *out_jacobian)
{
    trk_context *context = calibration->context;
    int32_t targets = trk_fit_target_count(calibration);
    modal w = {.c = calibration, .n = trk_model_count(model, TRK_PART_COORDINATE)};
    w.re = trk_new(context, w.n, sizeof *w.re);
    w.im = trk_new(context, w.n, sizeof *w.im);
    w.phi = trk_new(context, (int64_t)targets * w.n, sizeof *w.phi);
    w.picks = trk_new(context, targets, sizeof *w.picks);
    trk_status status = w.re && w.im && w.phi && w.picks ? TRK_OK : TRK_E_MEMORY;
    if (status == TRK_OK)
        status = new_matrices(context, w.n, &w.now);
    if (status == TRK_OK)
        status = new_matrices(context, w.n, &w.high);
    if (status == TRK_OK)
        status = new_matrices(context, w.n, &w.low);
    if (status == TRK_OK)
        status = run(&w, u, model, out_y, out_jacobian);
    void *blocks[] = {w.re, w.im, w.phi, w.picks, w.now.mass, w.high.mass, w.low.mass};
    for (size_t k = 0; k < sizeof blocks / sizeof *blocks; k++)
        trk_free(context, blocks[k]);
    return status;
}
