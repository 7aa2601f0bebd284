/* SPDX-License-Identifier: MIT */
/* Sections of a digital weighting: exact poles, matched zeros (COMFORT.5). */
#include "comfort/design.h"
#include "comfort/shape.h"

#include <math.h>

static const double pi = 3.14159265358979323846, root_half = 0.70710678118654752440;

/* exp(s) - 1 without cancellation near 0. */
static double complex expm1_complex(double complex s)
{
    double a = creal(s), b = cimag(s), half = sin(b / 2);
    return expm1(a) * cos(b) - 2 * half * half + I * exp(a) * sin(b);
}

/* z - 1 of the upper root of s^2 + s w / Q + w^2 after z = exp(s T); all Q here exceed 1/2. */
static double complex root(double corner, double q, double sample_rate)
{
    double w = 2 * pi * corner / sample_rate, damping = 1 / (2 * q);
    return expm1_complex(w * (-damping + I * sqrt((1 - damping) * (1 + damping))));
}

/* direct times the monic numerator, whose value at the pole is given, over the pole pair. */
static void add(trk_design *design, double complex pole_minus_1, double direct,
                double complex numerator)
{
    double complex pole = 1 + pole_minus_1;
    double complex residue = direct * numerator / (2 * I * cimag(pole));
    design->section[design->sections++] =
        (trk_section){creal(pole), cimag(pole), direct, creal(residue), cimag(residue)};
}

static double squared_magnitude(double complex z)
{
    return creal(z) * creal(z) + cimag(z) * cimag(z);
}

static void add_sections(trk_design *design, const trk_weighting_parameters *p, double rate)
{
    double complex pole = root(p->f1, root_half, rate);
    add(design, pole, 1, pole * pole); /* zeros at z = 1, exactly */
    if (p->f5 > 0) {
        pole = root(p->f6, p->q6, rate);
        double complex zero = root(p->f5, p->q5, rate);
        add(design, pole, 1, (pole - zero) * (pole - conj(zero)));
    }
    if (p->f4 > 0) {
        pole = root(p->f4, p->q4, rate);
        double gain = squared_magnitude(pole);
        if (p->f3 > 0) {
            double zero = expm1(-2 * pi * p->f3 / rate);
            add(design, pole, -gain / zero, (1 + pole) * (pole - zero));
        } else {
            add(design, pole, gain, (1 + pole) * (1 + pole));
        }
    }
    pole = root(p->f2, root_half, rate);
    add(design, pole, squared_magnitude(pole), (1 + pole) * (1 + pole));
}

double complex trk_design_response(const trk_design *design, double angle)
{
    double half = sin(angle / 2);
    double complex z_minus_1 = -2 * half * half + I * sin(angle), z = 1 + z_minus_1, h = 1;
    for (int32_t k = 0; k < design->sections; k++) {
        const trk_section *s = &design->section[k];
        double complex pole = s->pole_re + I * s->pole_im;
        double complex residue = s->residue_re + I * s->residue_im;
        h *= s->direct + residue / (z - pole) + conj(residue) / (z - conj(pole));
    }
    double complex numerator = 0;
    for (int k = TRK_SHAPE_TAPS - 1; k >= 0; k--)
        numerator = numerator / z + design->shape[k];
    return h * numerator / (1 + (TRK_SHAPE_A1 + TRK_SHAPE_A2 / z) / z);
}

trk_status trk_design_weighting(trk_context *context, const trk_weighting_parameters *p,
                                double sample_rate, trk_design *out_design)
{
    *out_design = (trk_design){.sections = 0, .shape = {1}};
    add_sections(out_design, p, sample_rate);
    enum { NODES = 200 };
    double angle[NODES], power[NODES];
    for (int k = 0; k < NODES; k++) {
        angle[k] = pi * (k + 0.5) / NODES;
        double complex wanted = trk_weighting_analogue(p, angle[k] * sample_rate / (2 * pi));
        double complex ratio = wanted / trk_design_response(out_design, angle[k]);
        power[k] = squared_magnitude(ratio);
    }
    if (trk_shape_fit(NODES, angle, power, out_design->shape))
        return TRK_OK;
    return trk_fail(context, TRK_E_INTERNAL,
                    "trk_weighting_filter_create: no filter for %s at %g Hz was found", p->name,
                    sample_rate);
}
