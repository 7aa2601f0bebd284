/* SPDX-License-Identifier: MIT */
/* Stiffness and mass per length of common sections (FRAME.1). */
#include "base/base.h"
#include <truckride/frame.h>

#include <math.h>

static const double pi = 3.14159265358979323846;

/* Part of a full rectangle's area that carries shear. */
static const double rectangle_shear = 5.0 / 6;

/* Geometry of a section about its centroid. */
typedef struct section {
    double area;             /* [m^2]                            */
    double inertia_y;        /* [m^4] of bending along z         */
    double inertia_z;        /* [m^4] of bending along y         */
    double torsion;          /* [m^4] J of Saint-Venant          */
    double shear_y, shear_z; /* [m^2] area times coefficient     */
} section;

typedef struct material {
    double young, shear, density;
} material;

typedef struct dimension {
    const char *name;
    double value;
} dimension;

static trk_status check_positive(trk_context *context, const char *function, int count,
                                 const dimension *list)
{
    for (int k = 0; k < count; k++)
        if (!isfinite(list[k].value) || list[k].value <= 0)
            return trk_fail(context, TRK_E_RANGE, "%s: %s is %g; a finite number > 0 is needed",
                            function, list[k].name, list[k].value);
    return TRK_OK;
}

static trk_status check_material(trk_context *context, const char *function, const material *m)
{
    const dimension list[] = {{"young", m->young}, {"shear", m->shear}, {"density", m->density}};
    return check_positive(context, function, 3, list);
}

static trk_status write_section(trk_context *context, const char *function, const material *m,
                                const section *s, trk_beam_options *options)
{
    trk_beam_options beam;
    trk_beam_options_init(&beam, sizeof beam);
    trk_status status = trk_read_options(context, function, options, &beam, sizeof beam);
    if (status != TRK_OK)
        return status;
    beam.axial = m->young * s->area;
    beam.torsion = m->shear * s->torsion;
    beam.bending_y = m->young * s->inertia_y;
    beam.bending_z = m->young * s->inertia_z;
    beam.shear_y = m->shear * s->shear_y;
    beam.shear_z = m->shear * s->shear_z;
    beam.mass_per_length = m->density * s->area;
    beam.inertia_x = m->density * (s->inertia_y + s->inertia_z);
    beam.inertia_y = m->density * s->inertia_y;
    beam.inertia_z = m->density * s->inertia_z;
    return trk_write_options(options, &beam, sizeof beam);
}

static trk_status check_walls(trk_context *context, const char *function, double height,
                              double width, double web, double flange, int webs)
{
    const dimension list[] = {
        {"height", height}, {"width", width}, {"web", web}, {"flange", flange}};
    trk_status status = check_positive(context, function, 4, list);
    if (status == TRK_OK && webs * web >= width)
        status =
            trk_fail(context, TRK_E_RANGE,
                     "%s: web is %g m, too thick for a width of %g m; %d of them must fit in it",
                     function, web, width, webs);
    if (status == TRK_OK && 2 * flange >= height)
        status =
            trk_fail(context, TRK_E_RANGE,
                     "%s: flange is %g m, too thick for a height of %g m; 2 of them must fit in it",
                     function, flange, height);
    return status;
}

trk_status trk_beam_options_channel(trk_context *context, double young, double shear,
                                    double density, double height, double width, double web,
                                    double flange, trk_beam_options *options)
{
    static const char function[] = "trk_beam_options_channel";
    const material steel = {young, shear, density};
    TRK_REQUIRE(context, context, "trk_beam_options_channel");
    TRK_REQUIRE(context, options, "trk_beam_options_channel");
    trk_status status = check_material(context, function, &steel);
    if (status == TRK_OK)
        status = check_walls(context, function, height, width, web, flange, 1);
    if (status != TRK_OK)
        return status;
    const double inside = height - 2 * flange, wings = 2 * width * flange, back = inside * web,
                 centroid = (wings * width / 2 + back * web / 2) / (wings + back),
                 wing_arm = width / 2 - centroid, back_arm = web / 2 - centroid;
    const section s = {
        .area = wings + back,
        .inertia_y = (width * pow(height, 3) - (width - web) * pow(inside, 3)) / 12,
        .inertia_z = wings * (width * width / 12 + wing_arm * wing_arm) +
                     back * (web * web / 12 + back_arm * back_arm),
        /* open and thin: sum of length thickness^3 / 3 along the middle of the walls */
        .torsion = (2 * (width - web / 2) * pow(flange, 3) + (height - flange) * pow(web, 3)) / 3,
        .shear_y = rectangle_shear * wings,
        .shear_z = (height - flange) * web,
    };
    return write_section(context, function, &steel, &s, options);
}

trk_status trk_beam_options_box(trk_context *context, double young, double shear, double density,
                                double height, double width, double web, double flange,
                                trk_beam_options *options)
{
    static const char function[] = "trk_beam_options_box";
    const material steel = {young, shear, density};
    TRK_REQUIRE(context, context, "trk_beam_options_box");
    TRK_REQUIRE(context, options, "trk_beam_options_box");
    trk_status status = check_material(context, function, &steel);
    if (status == TRK_OK)
        status = check_walls(context, function, height, width, web, flange, 2);
    if (status != TRK_OK)
        return status;
    const double inner_height = height - 2 * flange, inner_width = width - 2 * web,
                 middle_height = height - flange, middle_width = width - web;
    const section s = {
        .area = height * width - inner_height * inner_width,
        .inertia_y = (width * pow(height, 3) - inner_width * pow(inner_height, 3)) / 12,
        .inertia_z = (height * pow(width, 3) - inner_height * pow(inner_width, 3)) / 12,
        /* Bredt: 4 (area within the middle line)^2 / sum of length / thickness */
        .torsion = 2 * pow(middle_height * middle_width, 2) /
                   (middle_width / flange + middle_height / web),
        .shear_y = 2 * middle_width * flange,
        .shear_z = 2 * middle_height * web,
    };
    return write_section(context, function, &steel, &s, options);
}

/* Saint-Venant's series for a long side a and a short side b. */
static double rectangle_torsion(double a, double b)
{
    double sum = 0;
    for (int n = 1; n < 200; n += 2)
        sum += tanh(n * pi * a / (2 * b)) / pow(n, 5);
    return a * pow(b, 3) / 3 * (1 - 192 / pow(pi, 5) * b / a * sum);
}

trk_status trk_beam_options_rectangle(trk_context *context, double young, double shear,
                                      double density, double height, double width,
                                      trk_beam_options *options)
{
    static const char function[] = "trk_beam_options_rectangle";
    const material steel = {young, shear, density};
    const dimension list[] = {{"height", height}, {"width", width}};
    TRK_REQUIRE(context, context, "trk_beam_options_rectangle");
    TRK_REQUIRE(context, options, "trk_beam_options_rectangle");
    trk_status status = check_material(context, function, &steel);
    if (status == TRK_OK)
        status = check_positive(context, function, 2, list);
    if (status != TRK_OK)
        return status;
    const section s = {
        .area = height * width,
        .inertia_y = width * pow(height, 3) / 12,
        .inertia_z = height * pow(width, 3) / 12,
        .torsion = rectangle_torsion(fmax(height, width), fmin(height, width)),
        .shear_y = rectangle_shear * height * width,
        .shear_z = rectangle_shear * height * width,
    };
    return write_section(context, function, &steel, &s, options);
}

trk_status trk_beam_options_tube(trk_context *context, double young, double shear, double density,
                                 double outer, double wall, trk_beam_options *options)
{
    static const char function[] = "trk_beam_options_tube";
    const material steel = {young, shear, density};
    const dimension list[] = {{"outer", outer}, {"wall", wall}};
    TRK_REQUIRE(context, context, "trk_beam_options_tube");
    TRK_REQUIRE(context, options, "trk_beam_options_tube");
    trk_status status = check_material(context, function, &steel);
    if (status == TRK_OK)
        status = check_positive(context, function, 2, list);
    if (status == TRK_OK && 2 * wall > outer)
        status = trk_fail(context, TRK_E_RANGE,
                          "%s: wall is %g m; at most half of the outer diameter, %g m, is needed",
                          function, wall, outer / 2);
    if (status != TRK_OK)
        return status;
    const double inner = outer - 2 * wall, ratio = inner / outer,
                 hollow = pow(1 + ratio * ratio, 2);
    section s = {
        .area = pi / 4 * (outer * outer - inner * inner),
        .inertia_y = pi / 64 * (pow(outer, 4) - pow(inner, 4)),
    };
    s.inertia_z = s.inertia_y;
    s.torsion = 2 * s.inertia_y;
    s.shear_y = s.shear_z = 6 * hollow / (7 * hollow + 20 * ratio * ratio) * s.area;
    return write_section(context, function, &steel, &s, options);
}
