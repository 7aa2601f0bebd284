/* SPDX-License-Identifier: MIT */
/* Beams in a compiled model: names and lengths of arrays, ties, mass, messages, steps over time. */
#include "support.h"

#include "beams.h"

#include "model/model.h"

#include <truckride/newmark.h>
#include <truckride/rungekutta.h>

#include <stdbool.h>

static const double unset = 12345;

/* A cantilever of two elements along x with a spring under its tip. */
static trk_spec *make(trk_context *context, double mass_damping)
{
    support_line line;
    support_line_init(&line, 2);
    line.first = 0;
    line.section.mass_damping = mass_damping;
    line.section.stiffness_damping = 1e-5;
    trk_spec *spec = support_line_spec(context, &line);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = trk_spec_find(spec, TRK_PART_BODY, "node.2");
    link.to_point[0] = 2;
    link.stiffness = 1e4;
    link.damping = 50;
    assert_ok(context, trk_spec_add_link(spec, "spring", &link, NULL));
    return spec;
}

/* What is told of links is told of those that have a name. */
static void arrays_by_link(void **state)
{
    trk_spec *spec = make(*state, 2);
    trk_model *model = support_line_model(*state, spec, TRK_STANDARD_GRAVITY, 0);
    double force[2] = {unset, unset}, e[2] = {1, unset}, rate[2] = {2, unset}, row[12];
    assert_int_equal(trk_model_count(model, TRK_PART_LINK), 1);
    assert_int_equal(trk_model_count(model, TRK_PART_BEAM), 2);
    assert_int_equal(trk_model_find(model, TRK_PART_BEAM, "beam.2"), 2);
    assert_string_equal(trk_model_part_name(model, TRK_PART_BEAM, 1), "beam.1");
    assert_null(trk_model_unit(model, TRK_PART_BEAM, 1));
    assert_int_equal(model->links.count, 1 + 2 * (6 + 12));
    trk_model_get_static(model, NULL, force);
    assert_true(force[0] < 0 && force[1] == unset);
    trk_model_get_link_force(model, e, rate, force);
    assert_near(force[0], 1e4 + 100, 1e-9);
    assert_true(force[1] == unset);
    assert_int_equal(trk_model_get_link_row(model, 2, row, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_get_row(model, TRK_PART_BEAM, 1, row), TRK_E_ARGUMENT);

    trk_newmark *newmark;
    assert_ok(*state, trk_newmark_create(*state, model, NULL, &newmark));
    e[1] = rate[1] = unset;
    trk_newmark_get_links(newmark, e, rate, force);
    assert_true(force[0] < 0 && force[1] == unset && e[1] == unset && rate[1] == unset);
    trk_newmark_destroy(newmark);
    trk_model_destroy(model);
}

static void row_owners(void **state)
{
    trk_model *model = support_line_model(*state, make(*state, 0), 0, 0);
    const char *word;
    assert_int_equal(model->links.count, 1 + 2 * 6);
    assert_string_equal(trk_model_link_name(model, 0, &word), "spring");
    assert_string_equal(word, "link");
    assert_string_equal(trk_model_link_name(model, 6, &word), "beam.1");
    assert_string_equal(trk_model_link_name(model, 7, &word), "beam.2");
    assert_string_equal(word, "beam");
    trk_model_destroy(model);
}

/* The limit of Runge-Kutta steps is set by the beam, which is no link; the message names it. */
static void limit_of_stability(void **state)
{
    if (!trk_has_feature(TRK_FEATURE_LAPACK))
        skip();
    trk_model *model = support_line_model(*state, make(*state, 0), 0, 0);
    trk_rungekutta *stepper;
    trk_rungekutta_options options;
    trk_rungekutta_options_init(&options, sizeof options);
    double limit, e[2] = {unset, unset}, rate[2] = {unset, unset}, force[2] = {unset, unset};
    int32_t link = 7;
    assert_ok(*state, trk_rungekutta_find_limit(*state, model, &limit, &link));
    assert_int_equal(link, 0);
    assert_status(*state, trk_rungekutta_create(*state, model, &options, &stepper), TRK_E_RANGE);
    assert_message(*state, "set by beams like 'beam.");
    options.step = limit / 2;
    assert_ok(*state, trk_rungekutta_create(*state, model, &options, &stepper));
    trk_rungekutta_get_links(stepper, e, rate, force);
    assert_true(e[0] == 0 && e[1] == unset && rate[1] == unset && force[1] == unset);
    trk_rungekutta_destroy(stepper);
    trk_model_destroy(model);
}

static trk_status try_compile(trk_context *context, const trk_spec *spec)
{
    trk_model *model;
    trk_status status = trk_model_compile(context, spec, NULL, &model);
    trk_model_destroy(model);
    return status;
}

/* Beams tie their bodies together, if they resist something; they hold what they deform along. */
static void ties(void **state)
{
    support_line line;
    support_line_init(&line, 1);
    trk_spec *spec = support_line_spec(*state, &line);
    assert_status(*state, try_compile(*state, spec), TRK_E_MODEL);
    assert_message(*state, "body 'node.0' is not supported: no chain of links");
    trk_spec_destroy(spec);
    line.first = 0;
    spec = support_line_spec(*state, &line);
    assert_ok(*state, try_compile(*state, spec));
    trk_beam_options beam;
    trk_beam_options_init(&beam, sizeof beam);
    assert_ok(*state, trk_spec_get_beam(spec, 1, &beam));
    beam.torsion = 0;
    assert_ok(*state, trk_spec_set_beam(spec, 1, &beam));
    assert_status(*state, try_compile(*state, spec), TRK_E_MODEL);
    assert_message(*state, "coordinate 'node.1.roll' is not supported");
    beam.axial = beam.bending_y = beam.bending_z = 0;
    assert_ok(*state, trk_spec_set_beam(spec, 1, &beam));
    assert_status(*state, try_compile(*state, spec), TRK_E_MODEL);
    assert_message(*state, "body 'node.1' is not supported");
    trk_spec_destroy(spec);
}

/* A node needs no mass of its own, but mass from somewhere. */
static void mass_of_nodes(void **state)
{
    support_line line;
    support_line_init(&line, 1);
    line.first = 0;
    line.section.inertia_x = 0;
    trk_spec *spec = support_line_spec(*state, &line);
    assert_status(*state, try_compile(*state, spec), TRK_E_MODEL);
    assert_message(*state, "coordinate 'node.1.roll' has no moment of inertia");
    trk_spec_destroy(spec);
    line.section.mass_per_length = 0;
    spec = support_line_spec(*state, &line);
    assert_status(*state, try_compile(*state, spec), TRK_E_MODEL);
    assert_message(*state, "coordinate 'node.1.x' has no mass");
    trk_spec_destroy(spec);
}

/* Numbers that overflow are those of the beam. */
static void out_of_range(void **state)
{
    support_line line;
    support_line_init(&line, 1);
    line.first = 0;
    line.length = 0.1;
    line.section.axial = 1e308;
    trk_spec *spec = support_line_spec(*state, &line);
    assert_status(*state, try_compile(*state, spec), TRK_E_RANGE);
    assert_message(*state, "beam 'beam.1': its stiffness inf or damping");
    trk_spec_destroy(spec);
    support_line_init(&line, 1);
    line.first = 0;
    line.offset[1] = 1e308;
    line.section.up[1] = 1;
    spec = support_line_spec(*state, &line);
    assert_status(*state, try_compile(*state, spec), TRK_E_RANGE);
    trk_spec_destroy(spec);
}

static double energy(const trk_model *model, const trk_newmark *stepper, const double *mass,
                     const double *stiffness)
{
    double q[12], v[12], sum = 0;
    const int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
    trk_newmark_get_state(stepper, q, v, NULL);
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++)
            sum += (v[i] * mass[i * n + j] * v[j] + q[i] * stiffness[i * n + j] * q[j]) / 2;
    return sum;
}

/* Left to itself on its spring, a bent beam loses energy in every step, damped by links or by inertia. */
static void dissipation(void **state)
{
    for (int damped = 0; damped < 2; damped++)
        for (int32_t backend = TRK_BACKEND_AUTO; backend <= TRK_BACKEND_DENSE; backend++) {
            trk_model *model = support_line_model(*state, make(*state, damped ? 5 : 0), 0, 0);
            double mass[144], stiffness[144], q[12] = {0};
            q[8] = 0.01;
            trk_model_get_mass(model, mass);
            trk_model_get_tangent(model, NULL, NULL, NULL, stiffness);
            trk_newmark_options options;
            trk_newmark_options_init(&options, sizeof options);
            options.backend = backend;
            trk_newmark *stepper;
            assert_ok(*state, trk_newmark_create(*state, model, &options, &stepper));
            assert_ok(*state, trk_newmark_set_state(stepper, 0, q, NULL, NULL, NULL, NULL));
            double last = energy(model, stepper, mass, stiffness);
            const double start = last;
            for (int k = 0; k < 200; k++) {
                assert_ok(*state, trk_newmark_step(stepper, NULL, NULL, NULL));
                double now = energy(model, stepper, mass, stiffness);
                assert_true(now < last * (1 + 1e-12));
                last = now;
            }
            assert_true(last < 0.9 * start);
            trk_newmark_destroy(stepper);
            trk_model_destroy(model);
        }
}

static trk_status compile_all(trk_context *context)
{
    trk_spec *spec;
    trk_model *model = NULL;
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    trk_beam_options beam;
    trk_beam_options_init(&beam, sizeof beam);
    beam.to_body = 1;
    beam.to_point[0] = 1;
    beam.bending_y = beam.mass_per_length = beam.mass_damping = 1;
    trk_status status = trk_spec_create(context, "line", &spec);
    if (status != TRK_OK)
        return status;
    status = trk_spec_add_body(spec, "node", &body, NULL);
    if (status == TRK_OK)
        status = trk_spec_add_beam(spec, "beam", &beam, NULL);
    if (status == TRK_OK)
        status = trk_model_compile(context, spec, NULL, &model);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    return status;
}

static void out_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(compile_all);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(arrays_by_link), TEST(row_owners),   TEST(limit_of_stability), TEST(ties),
        TEST(mass_of_nodes),  TEST(out_of_range), TEST(dissipation),        TEST(out_of_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
