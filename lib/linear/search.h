/* SPDX-License-Identifier: MIT */
/* A search for the lowest modes of a large model, step by step (LINEAR.20 to LINEAR.22). */
#ifndef TRK_LINEAR_SEARCH_H
#define TRK_LINEAR_SEARCH_H

#include "linear/vibration.h"
#include "system/assembly.h"

enum { TRK_SEARCH_SPARE = 3 }; /* modes found beyond those asked for: a gap to count in */

typedef struct trk_search {
    trk_context *context;
    const trk_vibration *rows;
    int32_t wanted, count; /* modes asked for; modes found                                */
    trk_assembly assembly; /* of S = K + sigma M                                          */
    double *mass;          /* values of M in the pattern of the assembly                  */
    double *scale;         /* diagonal of S, n                                            */
    double stiffest;       /* largest K_ii / M_ii: rounding of K moves lambda by eps times it */
    double sigma;
    double *lambda, *phi; /* of the modes found, phi count x n; room for 2 wanted + spare */
    double *next;         /* after an inverse iteration, as phi                           */
    double *work;         /* 2 n                                                          */
} trk_search;

/* The least sigma that makes S safely definite; S factorized. */
trk_status trk_search_choose_shift(trk_search *s);

/* With free bodies a larger one, which serves all modes. */
trk_status trk_search_raise_shift(trk_search *s);

/* S with the present sigma. */
trk_status trk_search_factorize(trk_search *s);

/* `more` modes beside those found, of which the lowest stay. */
trk_status trk_search_extend(trk_search *s, int32_t more);

/* Search on until as many are found as there are; ends with S factorized (LINEAR.21). */
trk_status trk_search_complete(trk_search *s);

/* Inverse iterations until each residual is small. */
trk_status trk_search_polish(trk_search *s);

#endif
