/* SPDX-License-Identifier: MIT */
/* Decimal text to the nearest double, in every locale. */
#ifndef TRK_BASE_NUMBER_H
#define TRK_BASE_NUMBER_H

#include "base/base.h"

/*
 * Read [sign] digits [point digits] [e [sign] digits] at text, not going past end; e may be
 * e, E, d or D (Fortran), one digit is needed. Neither blanks, nor nan, inf or hexadecimal.
 * The result is correctly rounded (BASE.1): what was written with 17 digits comes back
 * exactly. Too large a number gives an infinity.
 *
 * Returns the place behind the number, or NULL if there is none at text.
 */
const char *trk_number_read(const char *text, const char *end, char point, double *out_value);

/* Whole number that fits into int64_t; returns as above, NULL also when it does not fit. */
const char *trk_integer_read(const char *text, const char *end, int64_t *out_value);

#endif
