/* SPDX-License-Identifier: MIT */
/* Deflections of beams against the formulas of strength of materials. */
#include "support.h"

#include "beams.h"

#include <stdbool.h>

static const double pi = 3.14159265358979323846;

/* Axes of a line: x along it, y and z of its section. */
static void find_axes(const support_line *line, double axes[3][3])
{
    const double *x = line->axis, *up = line->section.up;
    double along = x[0] * up[0] + x[1] * up[1] + x[2] * up[2], length = 0;
    for (int k = 0; k < 3; k++) {
        axes[0][k] = x[k];
        axes[2][k] = up[k] - along * x[k];
        length += axes[2][k] * axes[2][k];
    }
    for (int k = 0; k < 3; k++)
        axes[2][k] /= sqrt(length);
    for (int k = 0; k < 3; k++)
        axes[1][k] = axes[2][(k + 1) % 3] * x[(k + 2) % 3] - axes[2][(k + 2) % 3] * x[(k + 1) % 3];
}

/* Id of a port, or a sensor, at the end of the axis of the line. */
static void add_probe(trk_context *context, trk_spec *spec, const support_line *line,
                      trk_motion motion, const double *direction, const char *name)
{
    trk_port_options port;
    trk_port_options_init(&port, sizeof port);
    char node[32];
    snprintf(node, sizeof node, "node.%d", (int)line->elements);
    port.body = trk_spec_find(spec, TRK_PART_BODY, node);
    port.motion = motion;
    memcpy(port.direction, direction, sizeof port.direction);
    for (int k = 0; k < 3; k++)
        port.point[k] = line->origin[k] + line->axis[k] * line->length;
    assert_ok(context, trk_spec_add_port(spec, name, &port, NULL));
}

enum { TIP = 6, MOST = 128 };

/* Compliance of the tip: motion i of 3 displacements and 3 rotations in the axes of the line under load j. */
static void find_compliance(trk_context *context, const support_line *line, double out[TIP][TIP])
{
    double axes[3][3], row[TIP][MOST], q[MOST];
    find_axes(line, axes);
    trk_spec *spec = support_line_spec(context, line);
    for (int i = 0; i < TIP; i++) {
        char name[32];
        snprintf(name, sizeof name, "%d", i);
        add_probe(context, spec, line, i / 3, axes[i % 3], name);
    }
    trk_model *model = support_line_model(context, spec, 0, 0);
    int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
    assert_in_range(n, 1, MOST);
    for (int i = 0; i < TIP; i++)
        assert_ok(context, trk_model_get_row(model, TRK_PART_PORT, i + 1, row[i]));
    for (int j = 0; j < TIP; j++) {
        memcpy(q, row[j], (size_t)n * sizeof *q);
        support_deflect(context, model, q);
        for (int i = 0; i < TIP; i++) {
            out[i][j] = 0;
            for (int32_t k = 0; k < n; k++)
                out[i][j] += row[i][k] * q[k];
        }
    }
    trk_model_destroy(model);
}

/* Cantilever: PL/EA, TL/GJ, PL^3/3EI + PL/GA, PL^2/2EI, ML/EI; within `tolerance`. */
static void check_cantilever(trk_context *context, const support_line *line, double tolerance)
{
    const trk_beam_options *o = &line->section;
    const double l = line->length, by = o->bending_y, bz = o->bending_z;
    double got[TIP][TIP], wanted[TIP][TIP] = {{0}};
    wanted[0][0] = l / o->axial;
    wanted[3][3] = l / o->torsion;
    wanted[2][2] = l * l * l / (3 * by) + (o->shear_z > 0 ? l / o->shear_z : 0);
    wanted[1][1] = l * l * l / (3 * bz) + (o->shear_y > 0 ? l / o->shear_y : 0);
    wanted[2][4] = wanted[4][2] = -l * l / (2 * by);
    wanted[1][5] = wanted[5][1] = l * l / (2 * bz);
    wanted[4][4] = l / by;
    wanted[5][5] = l / bz;
    find_compliance(context, line, got);
    for (int i = 0; i < TIP; i++)
        for (int j = 0; j < TIP; j++) {
            double scale = sqrt(wanted[i][i] * wanted[j][j]);
            assert_near(got[i][j] / scale, wanted[i][j] / scale, tolerance);
        }
}

static support_line cantilever(int32_t elements, bool timoshenko)
{
    support_line line;
    support_line_init(&line, elements);
    line.first = 0;
    if (timoshenko) {
        line.section.shear_y = line.section.shear_z = line.section.axial / 2.6 * 5 / 6;
        line.section.inertia_y = line.section.inertia_z = 0.01;
    }
    return line;
}

static void tip_of_cantilever(void **state)
{
    for (int timoshenko = 0; timoshenko < 2; timoshenko++)
        for (int32_t elements = 1; elements <= 8; elements *= 2) {
            support_line line = cantilever(elements, timoshenko);
            check_cantilever(*state, &line, 1e-10);
        }
}

/* The same in any direction, with sections turned about the beam, anywhere in space. */
static void any_direction(void **state)
{
    for (int k = 0; k < 8; k++) {
        support_line line = cantilever(2, k % 2);
        const double azimuth = 0.4 + k, rise = k * pi / 7 - pi / 2 + 0.02;
        line.axis[0] = cos(rise) * cos(azimuth);
        line.axis[1] = cos(rise) * sin(azimuth);
        line.axis[2] = sin(rise);
        line.section.up[0] = k - 3;
        line.section.up[1] = 0.7;
        line.origin[2] = k;
        check_cantilever(*state, &line, 1e-11);
    }
}

/* Nodes whose centres of gravity lie beside the beam carry its ends by lever arms. */
static void end_offsets(void **state)
{
    support_line line = cantilever(2, true);
    line.offset[0] = 0.3;
    line.offset[1] = -0.7;
    line.offset[2] = 0.4;
    check_cantilever(*state, &line, 1e-10);
}

/* Of a cantilever: tip deflection w L^4 / 8 EI, tip rotation w L^3 / 6 EI. */
static void own_weight(void **state)
{
    const double g = TRK_STANDARD_GRAVITY;
    for (int32_t elements = 1; elements <= 4; elements *= 2) {
        support_line line = cantilever(elements, false);
        trk_model *model = support_line_model(*state, support_line_spec(*state, &line), g, 0);
        double q[MOST], l = line.length, load = line.section.mass_per_length * g;
        trk_model_get_static(model, q, NULL);
        const double *tip = q + trk_model_count(model, TRK_PART_COORDINATE) - TIP;
        assert_near(tip[2] / (-load * pow(l, 4) / (8 * line.section.bending_y)), 1, 1e-10);
        assert_near(tip[4] / (load * pow(l, 3) / (6 * line.section.bending_y)), 1, 1e-10);
        trk_model_destroy(model);
    }
}

/* Elements down to 0.7 mm: their stiffness is 1e12 times that of the line, and rounding with it. */
static void own_weight_of_fine_elements(void **state)
{
    const double g = TRK_STANDARD_GRAVITY;
    for (int32_t elements = 30; elements <= 3000; elements *= 10) {
        support_line line = cantilever(elements, false);
        line.inner = line.last = TRK_FREE_Z | TRK_FREE_PITCH;
        trk_model *model = support_line_model(*state, support_line_spec(*state, &line), g, 0);
        int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
        double *q = test_malloc((size_t)n * sizeof *q), load = line.section.mass_per_length * g;
        trk_model_get_static(model, q, NULL);
        double tip = -load * pow(line.length, 4) / (8 * line.section.bending_y);
        assert_near(q[n - 2] / tip, 1, 1e-11);
        test_free(q);
        trk_model_destroy(model);
    }
}

/* Where rounding is larger than what holds the line, there is no answer, not a wrong one. */
static void elements_too_fine_are_refused(void **state)
{
    if (!trk_has_feature(TRK_FEATURE_CHOLMOD)) /* 60,000 coordinates fit no dense matrix */
        skip();
    support_line line = cantilever(30000, false);
    trk_model_options options;
    trk_model *model;
    trk_model_options_init(&options, sizeof options);
    options.gravity = TRK_STANDARD_GRAVITY;
    line.inner = line.last = TRK_FREE_Z | TRK_FREE_PITCH;
    trk_spec *spec = support_line_spec(*state, &line);
    assert_status(*state, trk_model_compile(*state, spec, &options, &model), TRK_E_SINGULAR);
    assert_message(*state, "divided too finely");
    trk_spec_destroy(spec);
}

/* A sloping beam weighs m L, which a vertical spring under each end carries by halves. */
static void weight_on_springs(void **state)
{
    support_line line;
    support_line_init(&line, 3);
    line.axis[0] = 0.8;
    line.axis[2] = 0.6;
    trk_spec *spec = support_line_spec(*state, &line);
    trk_link_options link;
    static const double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int end = 0; end < 2; end++)
        for (int k = 0; k < TIP; k++) {
            char name[32];
            snprintf(name, sizeof name, "%d.%d", end, k);
            trk_link_options_init(&link, sizeof link);
            link.to_body = trk_spec_find(spec, TRK_PART_BODY, end ? "node.3" : "node.0");
            for (int i = 0; i < 3; i++)
                link.to_point[i] = end * line.axis[i] * line.length;
            link.motion = k / 3;
            memcpy(link.direction, axes[k % 3], sizeof link.direction);
            link.stiffness = k == 2 ? 1e5 : 1; /* others hold it, far softer */
            assert_ok(*state, trk_spec_add_link(spec, name, &link, NULL));
        }
    trk_model *model = support_line_model(*state, spec, TRK_STANDARD_GRAVITY, 0);
    double force[2 * TIP], weight = line.section.mass_per_length * line.length * 9.80665;
    assert_int_equal(trk_model_count(model, TRK_PART_LINK), 2 * TIP);
    trk_model_get_static(model, NULL, force);
    assert_near((force[2] + force[2 + TIP]) / weight, -1, 1e-11);
    trk_model_destroy(model);
}

/* Motion i by load j is motion j by load i. */
static void reciprocity(void **state)
{
    support_line line = cantilever(4, true);
    double c[TIP][TIP];
    line.axis[0] = 0.6;
    line.axis[1] = 0.8;
    find_compliance(*state, &line, c);
    for (int i = 0; i < TIP; i++)
        for (int j = 0; j < i; j++)
            assert_near(c[i][j], c[j][i], 1e-12 * sqrt(c[i][i] * c[j][j]));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(tip_of_cantilever, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(any_direction, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(end_offsets, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(own_weight, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(own_weight_of_fine_elements, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(elements_too_fine_are_refused, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(weight_on_springs, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(reciprocity, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
