/* SPDX-License-Identifier: MIT */
/* Sparse backend: CHOLMOD, simplicial L L^T with AMD ordering. The only user of cholmod.h. */
#include "linalg/backend.h"

#ifdef TRUCKRIDE_WITH_CHOLMOD

/* Without the declarations of the GPL modules, nobody can call them by accident. */
#define NSUPERNODAL
#define NMODIFY
#define NMATRIXOPS
#include <cholmod.h>
#include <math.h>

typedef struct sparse {
    trk_context *context;
    const trk_pattern *pattern;
    cholmod_common common; /* one per solver, so solvers do not share anything between threads */
    cholmod_sparse matrix; /* view of the pattern and of the values being factorized */
    cholmod_factor *factor;
    double *reciprocal; /* 1 / diagonal of L, in its order */
    double *work;       /* n, of solve() */
} sparse;

/* Status and message for the last call, which failed. */
static trk_status cholmod_failure(sparse *s, const char *what)
{
    switch (s->common.status) {
    case CHOLMOD_OUT_OF_MEMORY:
    case CHOLMOD_TOO_LARGE:
        return trk_fail(s->context, TRK_E_MEMORY, "out of memory: %s of %d unknowns in CHOLMOD",
                        what, (int)s->pattern->n);
    default:
        return trk_fail(s->context, TRK_E_INTERNAL, "solver: %s of %d unknowns: CHOLMOD status %d",
                        what, (int)s->pattern->n, s->common.status);
    }
}

static void destroy(void *state)
{
    sparse *s = state;
    if (!s)
        return;
    cholmod_free_factor(&s->factor, &s->common);
    cholmod_finish(&s->common);
    trk_free(s->context, s->reciprocal);
    trk_free(s->context, s->work);
    trk_free(s->context, s);
}

static void configure(cholmod_common *common)
{
    cholmod_start(common);
    common->print = 0;
    common->error_handler = NULL;
    common->supernodal = CHOLMOD_SIMPLICIAL;
    common->nmethods = 1;
    common->method[0].ordering = CHOLMOD_AMD;
    common->postorder = 1;
    common->final_ll = 1; /* L D L^T would go on through negative pivots */
    /* Columns get exactly the room they need and stay where they are: factorizing again,
     * also after a failure, moves nothing. */
    common->grow2 = 0;
    common->final_pack = 0;
}

static trk_status create(trk_context *context, const trk_pattern *pattern, void **out_state)
{
    sparse *s = trk_new(context, 1, sizeof *s);
    if (!s)
        return TRK_E_MEMORY;
    s->context = context;
    s->pattern = pattern;
    configure(&s->common);
    s->matrix = (cholmod_sparse){
        .nrow = (size_t)pattern->n,
        .ncol = (size_t)pattern->n,
        .nzmax = (size_t)pattern->start[pattern->n],
        .p = pattern->start,
        .i = pattern->row,
        .stype = -1, /* lower triangle */
        .itype = CHOLMOD_INT,
        .xtype = CHOLMOD_PATTERN,
        .dtype = CHOLMOD_DOUBLE,
        .sorted = 1,
        .packed = 1,
    };
    s->reciprocal = trk_new(context, pattern->n, sizeof *s->reciprocal);
    s->work = s->reciprocal ? trk_new(context, pattern->n, sizeof *s->work) : NULL;
    trk_status status = s->work ? TRK_OK : TRK_E_MEMORY;
    if (status == TRK_OK) {
        s->factor = cholmod_analyze(&s->matrix, &s->common);
        if (!s->factor)
            status = cholmod_failure(s, "analysis");
    }
    if (status != TRK_OK) {
        destroy(s);
        return status;
    }
    *out_state = s;
    return TRK_OK;
}

/*
 * Invert the diagonal of L. Returns the first row, in CHOLMOD's order, whose pivot the rule
 * (LINALG.2) rejects; n if none.
 */
static size_t invert_diagonal(const sparse *s, const double *values)
{
    const cholmod_factor *f = s->factor;
    const int *permutation = f->Perm, *start = f->p;
    const double *l = f->x;
    double tolerance = trk_pivot_tolerance(s->pattern->n);
    for (size_t k = 0; k < f->minor; k++) {
        double root = l[start[k]]; /* a column of L starts with its diagonal */
        double diagonal = values[s->pattern->start[permutation[k]]];
        if (!(root * root > tolerance * diagonal)) /* also when it is NaN */
            return k;
        s->reciprocal[k] = 1.0 / root;
    }
    return f->minor;
}

static trk_status factorize(void *state, double *values, int32_t *out_bad)
{
    sparse *s = state;
    s->matrix.x = values;
    s->matrix.xtype = CHOLMOD_REAL;
    if (!cholmod_factorize(&s->matrix, s->factor, &s->common) || s->common.status < CHOLMOD_OK)
        return cholmod_failure(s, "factorization");
    /* The call also succeeds when the matrix is not positive definite; minor < n tells. */
    size_t bad = invert_diagonal(s, values);
    if (bad == s->factor->n)
        return TRK_OK;
    *out_bad = ((const int *)s->factor->Perm)[bad];
    return TRK_E_SINGULAR;
}

/*
 * L y = P b by columns, L^T z = y by dot products, x = P^T z. Not cholmod_solve2(): it takes
 * new workspace at every call even when handed the last one (SuiteSparse issue 45).
 */
static trk_status solve(void *state, double *x)
{
    sparse *s = state;
    const int *permutation = s->factor->Perm, *start = s->factor->p, *row = s->factor->i;
    const int *length = s->factor->nz;
    const double *l = s->factor->x;
    double *y = s->work;
    int32_t n = s->pattern->n;
    for (int32_t k = 0; k < n; k++)
        y[k] = x[permutation[k]];
    for (int32_t k = 0; k < n; k++) {
        double known = y[k] *= s->reciprocal[k];
        for (int32_t p = start[k] + 1; p < start[k] + length[k]; p++)
            y[row[p]] -= l[p] * known;
    }
    for (int32_t k = n; k-- > 0;) {
        double sum = y[k];
        for (int32_t p = start[k] + 1; p < start[k] + length[k]; p++)
            sum -= l[p] * y[row[p]];
        y[k] = sum * s->reciprocal[k];
    }
    for (int32_t k = 0; k < n; k++)
        x[permutation[k]] = y[k];
    return TRK_OK;
}

static int64_t factor_entries(const void *state)
{
    const sparse *s = state;
    const int *count = s->factor->ColCount;
    int64_t entries = 0;
    for (size_t k = 0; k < s->factor->n; k++)
        entries += count[k];
    return entries;
}

/* Signs of D and growth of L D L^T, whose columns begin with the entry of D. */
static void read_inertia(const cholmod_factor *f, const double *scale, int32_t *out_count,
                         double *out_growth)
{
    const int *permutation = f->Perm, *start = f->p, *row = f->i, *length = f->nz;
    const double *l = f->x;
    for (size_t k = 0; k < f->n; k++) {
        double pivot = l[start[k]];
        *out_count += pivot < 0;
        *out_growth = fmax(*out_growth, fabs(pivot) / scale[permutation[k]]);
        for (int32_t p = start[k] + 1; p < start[k] + length[k]; p++)
            *out_growth = fmax(*out_growth, fabs(l[p] * pivot * l[p]) / scale[permutation[row[p]]]);
    }
}

/* L D L^T in the place of L L^T, which is taken down before and after. */
static trk_status count_negative(void *state, double *values, const double *scale,
                                 int32_t *out_count, double *out_growth)
{
    sparse *s = state;
    s->matrix.x = values;
    s->matrix.xtype = CHOLMOD_REAL;
    s->common.final_ll = 0;
    bool good = cholmod_change_factor(CHOLMOD_PATTERN, 0, 0, 0, 0, s->factor, &s->common) &&
                cholmod_factorize(&s->matrix, s->factor, &s->common) &&
                s->common.status >= CHOLMOD_OK;
    trk_status status = good ? TRK_OK : cholmod_failure(s, "inertia");
    if (good && s->factor->minor < s->factor->n)
        status = TRK_E_SINGULAR;
    if (status == TRK_OK)
        read_inertia(s->factor, scale, out_count, out_growth);
    s->common.final_ll = 1;
    cholmod_change_factor(CHOLMOD_PATTERN, 1, 0, 0, 0, s->factor, &s->common);
    return status;
}

const trk_solver_ops trk_cholmod_ops = {
    .backend = TRK_BACKEND_SPARSE,
    .name = "sparse",
    .create = create,
    .destroy = destroy,
    .factorize = factorize,
    .solve = solve,
    .factor_entries = factor_entries,
    .count_negative = count_negative,
};

#endif
