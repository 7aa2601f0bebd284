/* SPDX-License-Identifier: MIT */
/*
 * From probabilities to values. Only operations that every processor rounds alike are used
 * (+ - * / sqrt), none of the C library, so that a case has the same parameters everywhere.
 */
#ifndef TRK_STUDY_QUANTILE_H
#define TRK_STUDY_QUANTILE_H

#include "base/base.h"
#include "base/plain.h"

/*
 * z with P(Z <= z) = p for a standard normal Z, 0 < p < 1 (STUDY.5), relative error 1e-15.
 * M. J. Wichura, Algorithm AS 241, Appl. Statist. 37 (1988) 477-484.
 */
double trk_normal_quantile(double p);

/* P(Z <= z); accurate relative to itself for z <= 0. Uses erfc() of the C library. */
double trk_normal_probability(double z);

#endif
