/* SPDX-License-Identifier: MIT */
/* Rows of a beam element against the classical matrices of 12 freedoms. */
#include "support.h"

#include "system/beam.h"

#include <stdbool.h>

enum { N = TRK_BEAM_ENDS };

static trk_beam_options make_beam(bool timoshenko)
{
    trk_beam_options o;
    trk_beam_options_init(&o, sizeof o);
    o.axial = 3e8;
    o.torsion = 2e5;
    o.bending_y = 7e6;
    o.bending_z = 1.3e6;
    o.mass_per_length = 41;
    o.inertia_x = 0.7;
    if (timoshenko) {
        o.shear_y = 5e7;
        o.shear_z = 9e7;
        o.inertia_y = 0.5;
        o.inertia_z = 0.2;
    }
    return o;
}

static void sum_squares(int count, const trk_beam_row *rows, double out[N][N])
{
    memset(out, 0, N * sizeof *out);
    for (int k = 0; k < count; k++) {
        assert_true(rows[k].factor > 0);
        for (int i = 0; i < N; i++)
            for (int j = 0; j < N; j++)
                out[i][j] += rows[k].factor * rows[k].row[i] * rows[k].row[j];
    }
}

/* Entry of a plane with freedoms w_1, s_1, w_2, s_2 and its mirror image. */
static void set(double a[N][N], const int *place, double sign, int i, int j, double value)
{
    if ((i + j) % 2)
        value *= sign;
    a[place[i]][place[j]] = a[place[j]][place[i]] = value;
}

static const int planes[2][4] = {{2, 4, 8, 10}, {1, 5, 7, 11}};
static const double signs[2] = {-1, 1};

static void set_rod(double a[N][N], int place, double own, double other)
{
    a[place][place] = a[place + 6][place + 6] = own;
    a[place][place + 6] = a[place + 6][place] = other;
}

/* J. S. Przemieniecki, Theory of Matrix Structural Analysis (1968), equation (5.116). */
static void write_stiffness(const trk_beam_options *o, double l, double a[N][N])
{
    memset(a, 0, N * sizeof *a);
    set_rod(a, 0, o->axial / l, -o->axial / l);
    set_rod(a, 3, o->torsion / l, -o->torsion / l);
    const double bending[2] = {o->bending_y, o->bending_z}, shear[2] = {o->shear_z, o->shear_y};
    for (int p = 0; p < 2; p++) {
        double phi = shear[p] > 0 ? 12 * bending[p] / (shear[p] * l * l) : 0,
               c = bending[p] / (l * l * l * (1 + phi));
        set(a, planes[p], signs[p], 0, 0, 12 * c);
        set(a, planes[p], signs[p], 0, 1, 6 * l * c);
        set(a, planes[p], signs[p], 0, 2, -12 * c);
        set(a, planes[p], signs[p], 0, 3, 6 * l * c);
        set(a, planes[p], signs[p], 1, 1, (4 + phi) * l * l * c);
        set(a, planes[p], signs[p], 1, 2, -6 * l * c);
        set(a, planes[p], signs[p], 1, 3, (2 - phi) * l * l * c);
        set(a, planes[p], signs[p], 2, 2, 12 * c);
        set(a, planes[p], signs[p], 2, 3, -6 * l * c);
        set(a, planes[p], signs[p], 3, 3, (4 + phi) * l * l * c);
    }
}

/* The same book, equation (11.31): consistent mass with shear and rotary inertia. */
static void write_mass(const trk_beam_options *o, double l, double a[N][N])
{
    memset(a, 0, N * sizeof *a);
    set_rod(a, 0, o->mass_per_length * l / 3, o->mass_per_length * l / 6);
    set_rod(a, 3, o->inertia_x * l / 3, o->inertia_x * l / 6);
    const double bending[2] = {o->bending_y, o->bending_z}, shear[2] = {o->shear_z, o->shear_y},
                 rotary[2] = {o->inertia_y, o->inertia_z};
    for (int p = 0; p < 2; p++) {
        double f = shear[p] > 0 ? 12 * bending[p] / (shear[p] * l * l) : 0, f2 = f * f,
               t = o->mass_per_length * l / ((1 + f) * (1 + f)),
               r = rotary[p] / (l * (1 + f) * (1 + f));
        const double own = t * (13. / 35 + 7 * f / 10 + f2 / 3) + r * 6 / 5,
                     cross =
                         t * (11. / 210 + 11 * f / 120 + f2 / 24) * l + r * (1. / 10 - f / 2) * l,
                     far = t * (9. / 70 + 3 * f / 10 + f2 / 6) - r * 6 / 5,
                     far_cross =
                         -t * (13. / 420 + 3 * f / 40 + f2 / 24) * l + r * (1. / 10 - f / 2) * l,
                     slope = t * (1. / 105 + f / 60 + f2 / 120) * l * l +
                             r * (2. / 15 + f / 6 + f2 / 3) * l * l,
                     far_slope = -t * (1. / 140 + f / 60 + f2 / 120) * l * l -
                                 r * (1. / 30 + f / 6 - f2 / 6) * l * l;
        set(a, planes[p], signs[p], 0, 0, own);
        set(a, planes[p], signs[p], 0, 1, cross);
        set(a, planes[p], signs[p], 0, 2, far);
        set(a, planes[p], signs[p], 0, 3, far_cross);
        set(a, planes[p], signs[p], 1, 1, slope);
        set(a, planes[p], signs[p], 1, 2, -far_cross);
        set(a, planes[p], signs[p], 1, 3, far_slope);
        set(a, planes[p], signs[p], 2, 2, own);
        set(a, planes[p], signs[p], 2, 3, -cross);
        set(a, planes[p], signs[p], 3, 3, slope);
    }
}

static void compare(double got[N][N], double wanted[N][N])
{
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            assert_near(got[i][j], wanted[i][j], 2e-15 * sqrt(wanted[i][i] * wanted[j][j]));
}

static void stiffness(void **state)
{
    (void)state;
    for (int timoshenko = 0; timoshenko < 2; timoshenko++) {
        trk_beam_options o = make_beam(timoshenko);
        trk_beam_row rows[TRK_BEAM_STIFFNESS_ROWS];
        double got[N][N], wanted[N][N];
        int count = trk_beam_stiffness_rows(&o, 0.83, rows);
        assert_int_equal(count, 6);
        sum_squares(count, rows, got);
        write_stiffness(&o, 0.83, wanted);
        compare(got, wanted);
    }
}

static void mass(void **state)
{
    (void)state;
    for (int timoshenko = 0; timoshenko < 2; timoshenko++) {
        trk_beam_options o = make_beam(timoshenko);
        trk_beam_row rows[TRK_BEAM_INERTIA_ROWS];
        double got[N][N], wanted[N][N];
        int count = trk_beam_inertia_rows(&o, 0.83, rows);
        assert_int_equal(count, 12);
        sum_squares(count, rows, got);
        write_mass(&o, 0.83, wanted);
        compare(got, wanted);
    }
}

/* Moved without deforming, an element carries no force. */
static void rigid_motion(void **state)
{
    (void)state;
    const double l = 1.7;
    trk_beam_options o = make_beam(true);
    trk_beam_row rows[TRK_BEAM_STIFFNESS_ROWS];
    int count = trk_beam_stiffness_rows(&o, l, rows);
    const double motions[6][N] = {
        {1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0},  {0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0},
        {0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0},  {0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0},
        {0, 0, 0, 0, 1, 0, 0, 0, -l, 0, 1, 0}, {0, 0, 0, 0, 0, 1, 0, l, 0, 0, 0, 1}};
    for (int m = 0; m < 6; m++)
        for (int k = 0; k < count; k++) {
            double e = 0;
            for (int i = 0; i < N; i++)
                e += rows[k].row[i] * motions[m][i];
            assert_near(e, 0, 4e-16);
        }
}

/* What is zero leaves no row: a rod, a beam without mass, one with rotary inertia alone. */
static void absent_parts(void **state)
{
    (void)state;
    trk_beam_row rows[TRK_BEAM_INERTIA_ROWS];
    trk_beam_options o;
    trk_beam_options_init(&o, sizeof o);
    assert_int_equal(trk_beam_stiffness_rows(&o, 1, rows), 0);
    assert_int_equal(trk_beam_inertia_rows(&o, 1, rows), 0);
    o.bending_z = 1;
    assert_int_equal(trk_beam_stiffness_rows(&o, 1, rows), 2);
    o.inertia_z = 1;
    assert_int_equal(trk_beam_inertia_rows(&o, 1, rows), 3); /* rotations: quadratic in x */
    double got[N][N];
    sum_squares(3, rows, got);
    assert_near(got[1][1], 6. / 5, 1e-15);
    assert_near(got[11][11], 2. / 15, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stiffness),
        cmocka_unit_test(mass),
        cmocka_unit_test(rigid_motion),
        cmocka_unit_test(absent_parts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
