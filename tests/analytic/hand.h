/* SPDX-License-Identifier: MIT */
/* Matrices written out by hand, and their comparison with those of a model. */
#ifndef TRK_TESTS_HAND_H
#define TRK_TESTS_HAND_H

#include "support.h"

#include <truckride/model.h>
#include <truckride/vehicle.h>

#include <stdbool.h>

enum { HAND_MAXIMUM = 13 };

typedef double hand_matrix[HAND_MAXIMUM][HAND_MAXIMUM];

/* Add to an entry and its mirror image. */
static inline void hand_add(hand_matrix a, int i, int j, double value)
{
    a[i][j] += value;
    if (i != j)
        a[j][i] += value;
}

/* Within 1e-13 of the largest entry. */
static inline void hand_compare(int n, hand_matrix wanted, const double *got)
{
    double largest = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            largest = fmax(largest, fabs(wanted[i][j]));
    assert_true(largest > 0);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            assert_near(got[i * n + j], wanted[i][j], 1e-13 * largest);
}

/* M, C, K of the model of a spec, which is destroyed, are the given ones. Returns the model. */
static inline trk_model *hand_check(trk_context *context, trk_spec *spec, int n, hand_matrix m,
                                    hand_matrix c, hand_matrix k)
{
    trk_model *model;
    double mass[HAND_MAXIMUM * HAND_MAXIMUM], damping[HAND_MAXIMUM * HAND_MAXIMUM];
    double stiffness[HAND_MAXIMUM * HAND_MAXIMUM];
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    assert_int_equal(trk_model_count(model, TRK_PART_COORDINATE), n);
    trk_model_get_mass(model, mass);
    trk_model_get_tangent(model, NULL, NULL, damping, stiffness);
    hand_compare(n, m, mass);
    hand_compare(n, c, damping);
    hand_compare(n, k, stiffness);
    return model;
}

/* Row of B, and of G, of the link called `name`. */
static inline void hand_check_row(const trk_model *model, const char *name, const double *b,
                                  const double *g)
{
    double row[HAND_MAXIMUM], road[4];
    int32_t link = trk_model_find(model, TRK_PART_LINK, name);
    if (!link)
        print_error("there is no link %s\n", name);
    assert_true(link > 0);
    assert_int_equal(trk_model_get_link_row(model, link, row, road), TRK_OK);
    for (int i = 0; i < trk_model_count(model, TRK_PART_COORDINATE); i++)
        assert_near(row[i], b[i], 1e-13 * (1 + fabs(b[i])));
    for (int i = 0; i < trk_model_count(model, TRK_PART_ROAD); i++)
        assert_near(road[i], g ? g[i] : 0, 0);
}

/* Repeatable numbers between low and high: the minimal standard generator of Park and Miller. */
static inline double hand_random(uint64_t *seed, double low, double high)
{
    *seed = *seed * 48271 % 2147483647;
    return low + (high - low) * (double)*seed / 2147483647;
}

#endif
