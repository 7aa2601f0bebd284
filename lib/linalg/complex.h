/* SPDX-License-Identifier: MIT */
/* Complex numbers from their parts: C11's CMPLX(), which not every compiler's library has. */
#ifndef TRK_LINALG_COMPLEX_H
#define TRK_LINALG_COMPLEX_H

#include <complex.h>
#include <string.h>

static inline double complex trk_complex(double re, double im)
{
    const double parts[2] = {re, im};
    double complex z;
    memcpy(&z, parts, sizeof z);
    return z;
}

#endif
