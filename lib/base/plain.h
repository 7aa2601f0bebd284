/* SPDX-License-Identifier: MIT */
/*
 * Elementary functions from operations that every processor rounds alike (+ - * /), none of
 * the C library's that do not: the same bits everywhere.
 */
#ifndef TRK_BASE_PLAIN_H
#define TRK_BASE_PLAIN_H

/* Natural logarithm of x > 0 and exponential, within 1 unit in the last place or so. */
double trk_plain_log(double x);
double trk_plain_exp(double x);

/* x^power for x >= 0. */
double trk_plain_power(double x, double power);

#endif
