/* SPDX-License-Identifier: MIT */
/* Lowest modes of a large pencil by shift-invert Lanczos (LINALG.7). The only user of ARPACK. */
#include "linalg/eigen.h"

#ifdef TRUCKRIDE_WITH_ARPACK

#include "base/random.h"

#include <math.h>
#include <pthread.h>
#include <string.h>

/* ARPACK as Fortran compilers export it (LP64); trailing size_t: lengths of the characters. */
void dsaupd_(int32_t *ido, const char *bmat, const int32_t *n, const char *which,
             const int32_t *nev, const double *tol, double *resid, const int32_t *ncv, double *v,
             const int32_t *ldv, int32_t *iparam, int32_t *ipntr, double *workd, double *workl,
             const int32_t *lworkl, int32_t *info, size_t bmat_length, size_t which_length);
void dseupd_(const int32_t *rvec, const char *howmny, int32_t *select, double *d, double *z,
             const int32_t *ldz, const double *sigma, const char *bmat, const int32_t *n,
             const char *which, const int32_t *nev, const double *tol, double *resid,
             const int32_t *ncv, double *v, const int32_t *ldv, int32_t *iparam, int32_t *ipntr,
             double *workd, double *workl, const int32_t *lworkl, int32_t *info,
             size_t howmny_length, size_t bmat_length, size_t which_length);

enum { SHIFT_INVERT = 3, MOST_RESTARTS = 300, START_SEED = 1 };

/* Residual of S^-1 M phi = nu phi, over nu. */
static const double tolerance = 1e-12;

/* dsaupd, dseupd and what they call have SAVE variables and common blocks. */
static pthread_mutex_t arpack_lock = PTHREAD_MUTEX_INITIALIZER;

typedef struct lanczos {
    const trk_pencil *pencil;
    int32_t n, known, count, basis, work_size; /* basis: Lanczos vectors kept          */
    const double *known_phi;
    double *start, *vectors, *workd, *workl, *ritz, *product;
    int32_t *select, iparam[11], ipntr[11];
} lanczos;

static void mass_times(const lanczos *z, const double *x, double *y)
{
    trk_pattern_multiply(trk_solver_pattern(z->pencil->solver), z->pencil->mass, x, y);
}

/* x := (I - Phi Phi^T M) x over the known modes. */
static void remove_known(lanczos *z, double *x)
{
    if (z->known == 0)
        return;
    mass_times(z, x, z->product);
    for (int32_t k = 0; k < z->known; k++) {
        const double *phi = z->known_phi + (int64_t)k * z->n;
        double share = 0;
        for (int32_t i = 0; i < z->n; i++)
            share += phi[i] * z->product[i];
        for (int32_t i = 0; i < z->n; i++)
            x[i] -= share * phi[i];
    }
}

/* No symmetry of a structure makes such a start miss a mode, and every run has the same. */
static void set_start(lanczos *z)
{
    for (int32_t i = 0; i < z->n; i++)
        z->start[i] = 2 * trk_random_uniform(START_SEED, (uint64_t)i, (uint32_t)z->known) - 1;
    remove_known(z, z->start);
}

/* What ARPACK asks for, until it is done: y = S^-1 M x (ido -1, M x at hand: 1) or y = M x (2). */
static trk_status iterate(lanczos *z, int32_t *out_info)
{
    int32_t ido = 0, info = 1; /* the start is given */
    size_t size = (size_t)z->n * sizeof(double);
    for (;;) {
        dsaupd_(&ido, "G", &z->n, "LM", &z->count, &tolerance, z->start, &z->basis, z->vectors,
                &z->n, z->iparam, z->ipntr, z->workd, z->workl, &z->work_size, &info, 1, 2);
        double *x = z->workd + z->ipntr[0] - 1, *y = z->workd + z->ipntr[1] - 1;
        if (ido == 2) {
            mass_times(z, x, y);
            continue;
        }
        *out_info = info;
        if (ido != 1 && ido != -1)
            return TRK_OK;
        if (ido == -1)
            mass_times(z, x, y);
        else
            memcpy(y, z->workd + z->ipntr[2] - 1, size);
        trk_status status = trk_solver_solve(z->pencil->solver, y);
        if (status != TRK_OK)
            return status;
        remove_known(z, y);
    }
}

/* Eigenpairs of the pencil from the Lanczos basis, whose place the vectors take. */
static int32_t extract(lanczos *z)
{
    int32_t wanted = 1, info = 0;
    double shift = -z->pencil->sigma;
    dseupd_(&wanted, "A", z->select, z->ritz, z->vectors, &z->n, &shift, "G", &z->n, "LM",
            &z->count, &tolerance, z->start, &z->basis, z->vectors, &z->n, z->iparam, z->ipntr,
            z->workd, z->workl, &z->work_size, &info, 1, 1, 2);
    return info;
}

/* By rising lambda, an order that ARPACK does not promise. */
static void copy_sorted(const lanczos *z, double *lambda, double *phi)
{
    for (int32_t k = 0; k < z->count; k++) {
        int32_t place = 0;
        for (int32_t j = 0; j < z->count; j++)
            place += z->ritz[j] < z->ritz[k] || (z->ritz[j] == z->ritz[k] && j < k);
        lambda[place] = z->ritz[k];
        memcpy(phi + (int64_t)place * z->n, z->vectors + (int64_t)k * z->n,
               (size_t)z->n * sizeof(double));
    }
}

static trk_status run(trk_context *context, lanczos *z, double *lambda, double *phi)
{
    int32_t info = 0, extract_info = 0;
    set_start(z);
    pthread_mutex_lock(&arpack_lock);
    trk_status status = iterate(z, &info);
    if (status == TRK_OK && info == 0)
        extract_info = extract(z);
    pthread_mutex_unlock(&arpack_lock);
    if (status != TRK_OK)
        return status;
    if (info != 0 || extract_info != 0)
        return trk_fail(context, TRK_E_CONVERGENCE,
                        "eigenproblem: ARPACK found %d of %d modes of %d unknowns (info %d, %d)",
                        (int)z->iparam[4], (int)z->count, (int)z->n, (int)info, (int)extract_info);
    copy_sorted(z, lambda, phi);
    return TRK_OK;
}

static trk_status allocate(trk_context *context, lanczos *z)
{
    int64_t n = z->n, basis = z->basis;
    z->start = trk_new(context, n, sizeof(double));
    z->vectors = trk_new(context, n * basis, sizeof(double));
    z->workd = trk_new(context, 3 * n, sizeof(double));
    z->workl = trk_new(context, z->work_size, sizeof(double));
    z->ritz = trk_new(context, z->count, sizeof(double));
    z->product = trk_new(context, n, sizeof(double));
    z->select = trk_new(context, basis, sizeof *z->select);
    return z->start && z->vectors && z->workd && z->workl && z->ritz && z->product && z->select
               ? TRK_OK
               : TRK_E_MEMORY;
}

trk_status trk_eigen_lowest(trk_context *context, const trk_pencil *pencil, int32_t known,
                            const double *known_phi, int32_t count, double *out_lambda,
                            double *out_phi)
{
    int32_t n = trk_solver_pattern(pencil->solver)->n;
    if (count < 1 || known < 0 || count > (n - known - 1) / 2)
        return trk_fail(context, TRK_E_RANGE,
                        "eigenproblem: %d modes beside %d of %d unknowns, expected 1 to %d",
                        (int)count, (int)known, (int)n, (int)((n - known - 1) / 2));
    lanczos z = {.pencil = pencil, .n = n, .known = known, .count = count, .known_phi = known_phi};
    z.basis = 2 * count + 20 < n - known ? 2 * count + 20 : n - known;
    z.work_size = z.basis * (z.basis + 8);
    z.iparam[0] = 1; /* exact shifts */
    z.iparam[2] = MOST_RESTARTS;
    z.iparam[3] = 1;
    z.iparam[6] = SHIFT_INVERT;
    trk_status status = allocate(context, &z);
    if (status == TRK_OK)
        status = run(context, &z, out_lambda, out_phi);
    void *blocks[] = {z.start, z.vectors, z.workd, z.workl, z.ritz, z.product, z.select};
    for (size_t k = 0; k < sizeof blocks / sizeof *blocks; k++)
        trk_free(context, blocks[k]);
    return status;
}

#else

trk_status trk_eigen_lowest(trk_context *context, const trk_pencil *pencil, int32_t known,
                            const double *known_phi, int32_t count, double *out_lambda,
                            double *out_phi)
{
    (void)pencil, (void)known, (void)known_phi, (void)count, (void)out_lambda, (void)out_phi;
    return trk_fail(context, TRK_E_UNSUPPORTED,
                    "modes of large models need ARPACK, which this build was made without");
}

#endif
