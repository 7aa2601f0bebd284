/* SPDX-License-Identifier: MIT */
/* Accurate roots of one: exact integer reduction to the first octant, then symmetry. */
#include "spectrum/roots.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

/* cos and sin of 2 pi k / n for 0 <= k <= n / 2. */
static void half_turn(int64_t k, int64_t n, double *c, double *s)
{
    /* An angle is a multiple of 2 pi / (8 n); an octant is n of them. */
    const int64_t octant = 8 * k / n;
    const int64_t rest = octant % 2 ? (octant + 1) * n - 8 * k : 8 * k - octant * n;
    const double angle = pi * (double)rest / (4.0 * (double)n);
    const double a = cos(angle), b = sin(angle);
    switch (octant) {
    case 0:
        *c = a;
        *s = b;
        break;
    case 1:
        *c = b;
        *s = a;
        break;
    case 2:
        *c = -b;
        *s = a;
        break;
    case 3:
        *c = -a;
        *s = b;
        break;
    default:
        *c = -1;
        *s = 0;
        break;
    }
}

void trk_roots_fill(int64_t n, double *root)
{
    /* Lengths divisible by 8 need sines and cosines in one octant only: a plan is made for
     * each spectrum, so its price counts. */
    const int64_t last = n % 8 == 0 ? n / 8 : n / 2;
    for (int64_t k = 0; k <= last; k++) {
        double c, s;
        half_turn(k, n, &c, &s);
        root[2 * k] = c;
        root[2 * k + 1] = -s;
    }
    for (int64_t k = last + 1; k <= n / 4; k++) { /* mirror at pi/4 */
        root[2 * k] = -root[2 * (n / 4 - k) + 1];
        root[2 * k + 1] = -root[2 * (n / 4 - k)];
    }
    for (int64_t k = last > n / 4 ? last + 1 : n / 4 + 1; k <= n / 2; k++) { /* at pi/2 */
        root[2 * k] = -root[2 * (n / 2 - k)];
        root[2 * k + 1] = root[2 * (n / 2 - k) + 1];
    }
    for (int64_t k = n / 2 + 1; k < n; k++) { /* at pi */
        root[2 * k] = root[2 * (n - k)];
        root[2 * k + 1] = -root[2 * (n - k) + 1];
    }
}
