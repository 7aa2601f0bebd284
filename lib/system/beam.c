/* SPDX-License-Identifier: MIT */
/* Stiffness and inertia rows of a beam element. */
#include "system/beam.h"

#include <float.h>
#include <string.h>

enum { PLANE = 4 }; /* freedoms of bending in one plane: w and slope of each end */

/* What bends in one plane: where its freedoms stand among those of the ends. */
typedef struct plane {
    int place[PLANE];   /* of w_1, s_1, w_2, s_2                                    */
    double slope_sign;  /* s = dw/dx = sign theta                                   */
    double bending;     /* E I [N m^2]                                              */
    double shear;       /* phi = 12 E I / (k G A L^2) (SPEC.6)                      */
    double translation; /* [kg/m]                                                   */
    double rotary;      /* [kg m]                                                   */
} plane;

/* Deflection along z with rotation about y, and along y with rotation about z. */
static void get_planes(const trk_beam_options *b, double length, plane out[2])
{
    out[0] = (plane){{2, 4, 8, 10}, -1, b->bending_y, 0, b->mass_per_length, b->inertia_y};
    out[1] = (plane){{1, 5, 7, 11}, 1, b->bending_z, 0, b->mass_per_length, b->inertia_z};
    const double shear[2] = {b->shear_z, b->shear_y};
    for (int k = 0; k < 2; k++)
        if (shear[k] > 0)
            out[k].shear = 12 * out[k].bending / (shear[k] * length * length);
}

static trk_beam_row *new_row(trk_beam_row *rows, int *count, double factor)
{
    trk_beam_row *row = &rows[(*count)++];
    memset(row, 0, sizeof *row);
    row->factor = factor;
    return row;
}

/* Stretch and twist: motion of the second end less that of the first. */
static void add_rod_stiffness(int place, double factor, trk_beam_row *out, int *count)
{
    if (factor == 0)
        return;
    trk_beam_row *row = new_row(out, count, factor);
    row->row[place] = -1;
    row->row[place + TRK_BEAM_ENDS / 2] = 1;
}

/* With t = s - (w_2 - w_1) / L, the slope of an end against the chord: t_2 - t_1 and t_1 + t_2. */
static void add_bending_stiffness(const plane *p, double length, trk_beam_row *out, int *count)
{
    if (p->bending == 0)
        return;
    trk_beam_row *symmetric = new_row(out, count, p->bending / length);
    symmetric->row[p->place[1]] = -p->slope_sign;
    symmetric->row[p->place[3]] = p->slope_sign;
    trk_beam_row *antisymmetric = new_row(out, count, 3 * p->bending / (length * (1 + p->shear)));
    antisymmetric->row[p->place[0]] = 2 / length;
    antisymmetric->row[p->place[1]] = p->slope_sign;
    antisymmetric->row[p->place[2]] = -2 / length;
    antisymmetric->row[p->place[3]] = p->slope_sign;
}

int trk_beam_stiffness_rows(const trk_beam_options *beam, double length,
                            trk_beam_row out[TRK_BEAM_STIFFNESS_ROWS])
{
    int count = 0;
    plane planes[2];
    get_planes(beam, length, planes);
    add_rod_stiffness(0, beam->axial / length, out, &count);
    add_rod_stiffness(3, beam->torsion / length, out, &count);
    for (int k = 0; k < 2; k++)
        add_bending_stiffness(&planes[k], length, out, &count);
    return count;
}

/* Deflection and rotation of the section at x = xi L per w_1, s_1, w_2, s_2 (SPEC.6). */
static void get_shapes(double xi, double length, double phi, double deflection[PLANE],
                       double rotation[PLANE])
{
    const double d = 1 / (1 + phi), x2 = xi * xi, x3 = x2 * xi;
    deflection[0] = d * (1 - 3 * x2 + 2 * x3 + phi * (1 - xi));
    deflection[1] = d * length * (xi - 2 * x2 + x3 + phi * (xi - x2) / 2);
    deflection[2] = d * (3 * x2 - 2 * x3 + phi * xi);
    deflection[3] = d * length * (x3 - x2 - phi * (xi - x2) / 2);
    rotation[0] = d * 6 / length * (x2 - xi);
    rotation[1] = d * (1 - 4 * xi + 3 * x2 + phi * (1 - xi));
    rotation[2] = -rotation[0];
    rotation[3] = d * (3 * x2 - 2 * xi + phi * xi);
}

/* Consistent mass matrix of one plane, by the Gauss rule that is exact for these polynomials. */
static void get_bending_mass(const plane *p, double length, double m[PLANE][PLANE])
{
    static const double place[4] = {-0.86113631159405257522, -0.33998104358485626480,
                                    0.33998104358485626480, 0.86113631159405257522},
                        weight[4] = {0.34785484513745385737, 0.65214515486254614263,
                                     0.65214515486254614263, 0.34785484513745385737};
    memset(m, 0, PLANE * sizeof *m);
    for (int g = 0; g < 4; g++) {
        double w[PLANE], psi[PLANE], part = weight[g] * length / 2;
        get_shapes((1 + place[g]) / 2, length, p->shear, w, psi);
        for (int i = 0; i < PLANE; i++)
            for (int j = 0; j < PLANE; j++)
                m[i][j] += part * (p->translation * w[i] * w[j] + p->rotary * psi[i] * psi[j]);
    }
}

/*
 * M = L D L^T of a positive semi-definite matrix gives the rows, the columns of L, and their
 * masses D. A pivot that is nothing but rounding, as without mass along the beam, gives none.
 */
static void add_factors(int n, const double *matrix, const int *place, const double *sign,
                        trk_beam_row *out, int *count)
{
    double m[PLANE][PLANE];
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            m[i][j] = matrix[i * n + j];
    for (int j = 0; j < n; j++) {
        double pivot = m[j][j], l[PLANE];
        if (!(pivot > 64 * DBL_EPSILON * matrix[j * n + j]))
            continue;
        trk_beam_row *row = new_row(out, count, pivot);
        for (int i = j; i < n; i++) {
            l[i] = m[i][j] / pivot;
            row->row[place[i]] = sign[i] * l[i];
        }
        for (int i = j + 1; i < n; i++)
            for (int k = j + 1; k < n; k++)
                m[i][k] -= pivot * l[i] * l[k];
    }
}

/* Linear shapes: L / 6 [2 1; 1 2]. */
static void add_rod_inertia(int place, double per_length, double length, trk_beam_row *out,
                            int *count)
{
    const double third = per_length * length / 3, m[4] = {third, third / 2, third / 2, third};
    add_factors(2, m, (const int[]){place, place + TRK_BEAM_ENDS / 2}, (const double[]){1, 1}, out,
                count);
}

int trk_beam_inertia_rows(const trk_beam_options *beam, double length,
                          trk_beam_row out[TRK_BEAM_INERTIA_ROWS])
{
    int count = 0;
    plane planes[2];
    get_planes(beam, length, planes);
    add_rod_inertia(0, beam->mass_per_length, length, out, &count);
    add_rod_inertia(3, beam->inertia_x, length, out, &count);
    for (int k = 0; k < 2; k++) {
        double m[PLANE][PLANE];
        get_bending_mass(&planes[k], length, m);
        add_factors(PLANE, &m[0][0], planes[k].place,
                    (const double[]){1, planes[k].slope_sign, 1, planes[k].slope_sign}, out,
                    &count);
    }
    return count;
}
