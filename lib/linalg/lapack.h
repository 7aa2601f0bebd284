/* SPDX-License-Identifier: MIT */
/* The LAPACK routines this room calls, as Fortran compilers export them (LP64). */
#ifndef TRK_LINALG_LAPACK_H
#define TRK_LINALG_LAPACK_H

#include <stddef.h>
#include <stdint.h>

/* The trailing size_t are the hidden lengths of the character arguments: always 1. */

/* K phi = lambda M phi, symmetric, M positive definite, divide and conquer. */
void dsygvd_(const int32_t *itype, const char *jobz, const char *uplo, const int32_t *n, double *a,
             const int32_t *lda, double *b, const int32_t *ldb, double *w, double *work,
             const int32_t *lwork, int32_t *iwork, const int32_t *liwork, int32_t *info,
             size_t jobz_length, size_t uplo_length);

/* General real eigenproblem, with balancing. */
void dgeev_(const char *jobvl, const char *jobvr, const int32_t *n, double *a, const int32_t *lda,
            double *wr, double *wi, double *vl, const int32_t *ldvl, double *vr,
            const int32_t *ldvr, double *work, const int32_t *lwork, int32_t *info,
            size_t jobvl_length, size_t jobvr_length);

/* Complex linear system by LU; a and b interleaved (re, im). */
void zgesv_(const int32_t *n, const int32_t *nrhs, double *a, const int32_t *lda, int32_t *ipiv,
            double *b, const int32_t *ldb, int32_t *info);

/* Singular value decomposition. */
void dgesvd_(const char *jobu, const char *jobvt, const int32_t *m, const int32_t *n, double *a,
             const int32_t *lda, double *s, double *u, const int32_t *ldu, double *vt,
             const int32_t *ldvt, double *work, const int32_t *lwork, int32_t *info,
             size_t jobu_length, size_t jobvt_length);

#endif
