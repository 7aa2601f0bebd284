/* SPDX-License-Identifier: MIT */
/* The rule of Gauss and Kronrod with 7 and 15 points (LINEAR.34). */
#ifndef TRK_LINEAR_KRONROD_H
#define TRK_LINEAR_KRONROD_H

/* Points rise from -1 to 1; every second one, from the second on, belongs to Gauss. */
enum { TRK_KRONROD = 15 };

typedef struct trk_kronrod_point {
    double place, weight, gauss;
} trk_kronrod_point;

extern const trk_kronrod_point trk_kronrod[TRK_KRONROD];

/* Three integrals, and what the two rules differ by at most. */
typedef struct trk_integrals {
    double of[3], error;
} trk_integrals;

#endif
