/* SPDX-License-Identifier: MIT */
/* The longest stable step of a model (RUNGEKUTTA.3), and the link to blame (RUNGEKUTTA.4). */
#include "rungekutta/limit.h"

#include "linalg/complex.h"
#include "model/model.h"

#include <math.h>

/* R(z) of (RUNGEKUTTA.2) does not leave the unit circle. */
static bool is_stable(double complex z)
{
    double complex r = 1 + z * (1 + z / 2 * (1 + z / 3 * (1 + z / 4)));
    return cabs(r) <= 1;
}

double trk_rungekutta_stable_step(double complex lambda)
{
    double size = cabs(lambda);
    if (!(size > 0))
        return INFINITY;
    double complex direction = trk_complex(fmin(creal(lambda) / size, 0), cimag(lambda) / size);
    direction /= cabs(direction) > 0 ? cabs(direction) : 1;
    /* The region holds the left half of this circle, and ends before 3 in every direction. */
    double low = 2.4, high = low;
    while (high < 4 && is_stable(high * direction))
        high += 0.01;
    low = high - 0.01;
    for (int k = 0; k < 40; k++) {
        double middle = (low + high) / 2;
        *(is_stable(middle * direction) ? &low : &high) = middle;
    }
    return low / size;
}

/* Least radius of the region in the left half plane, at 123 degrees (RUNGEKUTTA.3). */
static const double least_radius = 2.6155;

/* Corners of the box of all tangents: which end of the range each kind of curve takes. */
typedef struct corner {
    bool large_stiffness, large_damping;
} corner;

typedef struct limit {
    trk_context *context;
    const trk_model *model;
    trk_spectrum_edge *edge;
    double *stiffness, *damping; /* by link                          */
    double scale;                /* [1/s] largest frequency of one link */
    double step;
    int32_t link;
} limit;

/* One end of the range of the slopes of a curve, scaled. */
static double end_of_range(const trk_curve *curve, double scale, bool large)
{
    double least, most;
    if (!curve)
        return 0;
    trk_curve_slope_range(curve, &least, &most);
    return large ? fmax(scale * least, scale * most) : fmin(scale * least, scale * most);
}

static void set_tangents(limit *l, corner at)
{
    for (int32_t k = 0; k < l->model->links.count; k++) {
        const trk_link_law *law = &l->model->laws[k];
        l->stiffness[k] =
            law->stiffness + end_of_range(law->spring, law->spring_scale, at.large_stiffness);
        l->damping[k] =
            law->damping + end_of_range(law->damper, law->damper_scale, at.large_damping);
    }
}

/* The link whose own oscillator, on the mass that it sees, has the largest eigenvalue. */
static trk_status find_stiffest(limit *l)
{
    double largest = 0;
    for (int32_t k = 0; k < l->model->links.count; k++) {
        double mobility;
        trk_status status = trk_spectrum_edge_mobility(l->edge, k, &mobility);
        if (status != TRK_OK)
            return status;
        double omega_squared = fabs(l->stiffness[k]) * mobility;
        double half = fabs(l->damping[k]) * mobility / 2;
        double size = half * half > omega_squared ? half + sqrt(half * half - omega_squared)
                                                  : sqrt(omega_squared);
        if (size > largest) {
            largest = size;
            l->link = k + 1;
        }
    }
    l->scale = largest > 0 ? largest : 1;
    return TRK_OK;
}

static trk_status try_corner(limit *l, corner at)
{
    set_tangents(l, at);
    const trk_linearised linearised = {l->model, l->stiffness, l->damping, l->scale};
    const double *re, *im;
    int32_t count;
    trk_status status = trk_spectrum_edge_find(l->edge, &linearised, &re, &im, &count);
    for (int32_t k = 0; status == TRK_OK && k < count; k++) {
        double complex lambda = trk_complex(re[k], im[k]);
        /* Between the corners the tangents of curves turn eigenvalues to any angle. */
        double step = l->model->nonlinear_count > 0 ? least_radius / cabs(lambda)
                                                    : trk_rungekutta_stable_step(lambda);
        l->step = fmin(l->step, step);
    }
    return status;
}

static trk_status find(limit *l)
{
    static const corner corners[] = {{true, true}, {false, true}, {true, false}};
    bool has_spring = false, has_damper = false;
    for (int32_t j = 0; j < l->model->nonlinear_count; j++) {
        const trk_link_law *law = &l->model->laws[l->model->nonlinear[j]];
        has_spring |= law->spring != NULL;
        has_damper |= law->damper != NULL;
    }
    set_tangents(l, corners[0]);
    trk_status status = find_stiffest(l);
    if (status == TRK_OK)
        status = try_corner(l, corners[0]);
    if (status == TRK_OK && has_spring)
        status = try_corner(l, corners[1]);
    if (status == TRK_OK && has_damper)
        status = try_corner(l, corners[2]);
    return status;
}

trk_status trk_rungekutta_find_stiffest(trk_context *context, const trk_model *model,
                                        double *out_step, int32_t *out_row)
{
    if (!trk_has_feature(TRK_FEATURE_LAPACK))
        return trk_fail(context, TRK_E_UNSUPPORTED,
                        "%s: the limit of stability of the Runge-Kutta method needs LAPACK, which "
                        "this build was made without; take trk_newmark",
                        trk_model_name(model));
    int64_t links = model->links.count;
    limit l = {.context = context,
               .model = model,
               .stiffness = trk_new(context, links, sizeof(double)),
               .damping = trk_new(context, links, sizeof(double)),
               .step = INFINITY};
    trk_status status =
        l.stiffness && l.damping ? trk_spectrum_edge_create(context, model, &l.edge) : TRK_E_MEMORY;
    if (status == TRK_OK)
        status = find(&l);
    trk_spectrum_edge_destroy(l.edge);
    trk_free(context, l.stiffness);
    trk_free(context, l.damping);
    if (status != TRK_OK)
        return status;
    *out_step = l.step;
    *out_row = l.link;
    return TRK_OK;
}

trk_status trk_rungekutta_find_limit(trk_context *context, const trk_model *model, double *out_step,
                                     int32_t *out_link)
{
    TRK_REQUIRE(context, context, "trk_rungekutta_find_limit");
    TRK_REQUIRE(context, model, "trk_rungekutta_find_limit");
    TRK_REQUIRE(context, out_step, "trk_rungekutta_find_limit");
    int32_t row;
    trk_status status = trk_rungekutta_find_stiffest(context, model, out_step, &row);
    if (status == TRK_OK && out_link)
        *out_link = row <= trk_model_named_links(model) ? row : 0;
    return status;
}
