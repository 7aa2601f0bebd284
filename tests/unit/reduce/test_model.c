/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. Parts, statics, damping and errors of reduced models (REDUCE.2 to REDUCE.4). */
#include "truck.h"

#include <truckride/linear.h>

/* Same parts under the same names, but for the coordinates of the interior. */
static void parts_are_kept(void **state)
{
    trk_context *context = *state;
    trk_model *model = truck(context, 0, 2e-4), *reduced = reduce(context, model, 6, 0);
    for (trk_part part = TRK_PART_BODY; part <= TRK_PART_BEAM; part++) {
        if (part == TRK_PART_COORDINATE)
            continue;
        assert_int_equal(trk_model_count(reduced, part), trk_model_count(model, part));
        for (int32_t id = 1; id <= trk_model_count(model, part); id++) {
            assert_string_equal(trk_model_part_name(reduced, part, id),
                                trk_model_part_name(model, part, id));
            const char *unit = trk_model_unit(model, part, id);
            if (unit)
                assert_string_equal(trk_model_unit(reduced, part, id), unit);
        }
    }
    assert_string_equal(trk_model_name(reduced), "truck");
    for (int32_t id = 1; id <= trk_model_count(reduced, TRK_PART_COORDINATE); id++) {
        const char *name = trk_model_part_name(reduced, TRK_PART_COORDINATE, id);
        if (strncmp(name, "modes.", 6) != 0)
            assert_true(trk_model_find(model, TRK_PART_COORDINATE, name) > 0);
        else
            assert_string_equal(trk_model_unit(reduced, TRK_PART_COORDINATE, id), "m");
    }
    assert_int_equal(trk_model_find(reduced, TRK_PART_COORDINATE, "frame.left.6.z"), 0);
    assert_true(trk_model_find(reduced, TRK_PART_COORDINATE, "frame.left.3.z") > 0);
    double x, y;
    assert_ok(context, trk_model_get_road_place(reduced, 3, &x, &y));
    assert_near(x, 5.5, 0);
    assert_near(y, 0.425, 0);
    trk_model_destroy(model);
    trk_model_destroy(reduced);
}

static double sensor_at_rest(trk_context *context, const trk_model *model, const char *name)
{
    int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
    double *row = calloc(2 * (size_t)n, sizeof *row), sum = 0;
    assert_ok(context, trk_model_get_row(model, TRK_PART_SENSOR,
                                         trk_model_find(model, TRK_PART_SENSOR, name), row));
    trk_model_get_static(model, row + n, NULL);
    for (int32_t i = 0; i < n; i++)
        sum += row[i] * row[n + i];
    free(row);
    return sum;
}

/* Under gravity: forces of links and places of the interior, whatever the number of modes. */
static void statics_are_exact(void **state)
{
    trk_context *context = *state;
    trk_model *model = truck(context, TRK_STANDARD_GRAVITY, 0);
    double wanted[16], force[16], full[512], few[512];
    const char *const sensors[] = {"cab", "end", "middle", "spring", "strut"};
    int32_t named = trk_model_count(model, TRK_PART_LINK);
    trk_model_get_static(model, NULL, full);
    for (int modes = 0; modes <= 20; modes += 5) {
        trk_model *reduced = reduce(context, model, modes, 0);
        trk_model_get_static(reduced, NULL, few);
        for (int k = 0; k < named; k++)
            assert_near(few[k], full[k], 1e-10 * 3e4);
        for (size_t k = 0; k < sizeof sensors / sizeof *sensors; k++) {
            wanted[k] = sensor_at_rest(context, model, sensors[k]);
            force[k] = sensor_at_rest(context, reduced, sensors[k]);
            assert_near(force[k], wanted[k], 1e-10 * 0.1);
        }
        assert_true(fabs(wanted[2]) > 0.01); /* the frame's middle sits lower */
        trk_model_destroy(reduced);
    }
    trk_model_destroy(model);
}

/* A load on a port of the interior at zero frequency. */
static void static_response_is_exact(void **state)
{
    trk_context *context = *state;
    trk_model *model = truck(context, 0, 0);
    double full[5][2], few[5][2], load = 1e4;
    const double zero = 0;
    assert_ok(context, trk_frequency_response(context, model, NULL, NULL, 1, &zero, NULL, NULL,
                                              &load, full[0]));
    for (int modes = 0; modes <= 10; modes += 5) {
        trk_model *reduced = reduce(context, model, modes, 0);
        assert_ok(context, trk_frequency_response(context, reduced, NULL, NULL, 1, &zero, NULL,
                                                  NULL, &load, few[0]));
        for (int s = 2; s < 5; s++)
            assert_near(few[s][0], full[s][0], 1e-10 * fabs(full[s][0]) + 1e-14);
        trk_model_destroy(reduced);
    }
    trk_model_destroy(model);
}

/* c = 2 zeta sqrt(k m) on each mode, and none of the beams' damping beside it. */
static void modal_damping(void **state)
{
    trk_context *context = *state;
    trk_model *model = truck(context, 0, 2e-4), *reduced;
    trk_reduce_options options;
    trk_reduce_options_init(&options, sizeof options);
    options.modes = 6;
    options.pattern = "frame.*";
    options.modal_damping = 0.03;
    assert_ok(context, trk_model_reduce(context, model, &options, &reduced));
    int32_t n = trk_model_count(reduced, TRK_PART_COORDINATE);
    double *m = malloc(3 * (size_t)(n * n) * sizeof *m), *c = m + n * n, *k = c + n * n;
    trk_model_get_mass(reduced, m);
    trk_model_get_tangent(reduced, NULL, NULL, c, k);
    for (int mode = 1; mode <= 6; mode++) {
        char name[32];
        snprintf(name, sizeof name, "modes.%d", mode);
        int32_t i = trk_model_find(reduced, TRK_PART_COORDINATE, name) - 1;
        assert_true(i >= 0);
        int32_t at = i * (n + 1);
        double strut = trk_model_find(reduced, TRK_PART_LINK, "strut") > 0 ? 100 : 0, row[64];
        assert_ok(context,
                  trk_model_get_link_row(reduced, trk_model_find(reduced, TRK_PART_LINK, "strut"),
                                         row, NULL));
        double wanted = 0.06 * sqrt(k[at] * m[at]) + strut * row[i] * row[i];
        assert_near(c[at], wanted, 1e-9 * wanted);
        for (int32_t j = 0; j < n;
             j++) /* K of fixed-interface modes stays apart from the interface */
            if (j != i)
                assert_near(k[i * n + j] / sqrt(k[at] * k[j * (n + 1)]), 0, 1e-9);
    }
    free(m);
    trk_model_destroy(model);
    trk_model_destroy(reduced);
}

/* A chain with both ends in the interface: modes of a chain held at its ends. */
static void check_chain(trk_context *context, int n)
{
    enum { KEPT = 5 };
    trk_spec *spec;
    trk_body_options body;
    trk_link_options link;
    trk_model_options free_chain;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    trk_model_options_init(&free_chain, sizeof free_chain);
    free_chain.allow_free = 1;
    body.mass = 4;
    link.stiffness = 1e4;
    assert_ok(context, trk_spec_create(context, "chain", &spec));
    for (int k = 0; k < n + 4; k++) {
        char name[24];
        snprintf(name, sizeof name, "%s.%d", k > 0 && k < n + 3 ? "inner" : "outer", k);
        link.from_body = link.to_body;
        assert_ok(context, trk_spec_add_body(spec, name, &body, &link.to_body));
        if (k > 0)
            assert_ok(context, trk_spec_add_link(spec, name, &link, NULL));
    }
    trk_model *model, *reduced;
    trk_reduce_options options;
    trk_reduce_options_init(&options, sizeof options);
    options.pattern = "inner.*";
    options.modes = KEPT;
    assert_ok(context, trk_model_compile(context, spec, &free_chain, &model));
    trk_spec_destroy(spec);
    assert_ok(context, trk_model_reduce(context, model, &options, &reduced));
    enum { R = 4 + KEPT };
    assert_int_equal(trk_model_count(reduced, TRK_PART_COORDINATE), R);
    double m[R][R], k[R][R], rigid = 0;
    trk_model_get_mass(reduced, m[0]);
    trk_model_get_tangent(reduced, NULL, NULL, NULL, k[0]);
    for (int j = 0; j < KEPT; j++) {
        double omega = 2 * sqrt(1e4 / 4) * sin((j + 1) * two_pi / (4.0 * (n + 1)));
        assert_near(k[4 + j][4 + j] / m[4 + j][4 + j] / (omega * omega), 1, 1e-10);
    }
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            rigid += m[i][j];
    assert_near(rigid, 4 * (n + 4), 1e-9);
    assert_near(k[1][2], -1e4 / (n + 1), 1e-9 * 1e4); /* springs in series */
    trk_model_destroy(model);
    trk_model_destroy(reduced);
}

static void chain_has_its_closed_form(void **state)
{
    check_chain(*state, 20);
    if (trk_has_feature(TRK_FEATURE_ARPACK) && trk_has_feature(TRK_FEATURE_CHOLMOD))
        check_chain(*state, 400);
}

/* Reducing once more: the first modes stay as they are, new ones are numbered on. */
static void twice(void **state)
{
    trk_context *context = *state;
    trk_model *model = truck(context, 0, 2e-4), *first = NULL, *second = NULL;
    trk_reduce_options options;
    trk_reduce_options_init(&options, sizeof options);
    options.pattern = "frame.right.*";
    options.modes = 1000;
    assert_ok(context, trk_model_reduce(context, model, &options, &first));
    options.pattern = "frame.left.*";
    assert_ok(context, trk_model_reduce(context, first, &options, &second));
    trk_modes *a, *b;
    assert_ok(context, trk_modes_create_damped(context, model, NULL, NULL, &a));
    assert_ok(context, trk_modes_create_damped(context, second, NULL, NULL, &b));
    for (int k = 1; k <= 20; k++)
        assert_near(trk_modes_frequency(a, k) / trk_modes_frequency(b, k), 1, 1e-8);
    trk_modes_destroy(a);
    trk_modes_destroy(b);
    trk_model_destroy(model);
    trk_model_destroy(first);
    trk_model_destroy(second);
}

static void rejects_bad_arguments(void **state)
{
    trk_context *context = *state;
    trk_model *model = truck(context, 0, 0), *out = (trk_model *)state;
    static const struct {
        const char *pattern;
        int32_t modes, interface_modes;
        double damping;
        trk_status status;
        const char *words;
    } wrong[] = {
        {"frame.*", -1, 0, -1, TRK_E_RANGE, "modes is -1"},
        {"frame.*", 5, -2, -1, TRK_E_RANGE, "interface_modes -2"},
        {"frame.*", 5, 0, -0.5, TRK_E_RANGE, "modal_damping is -0.5"},
        {"frame.*", 5, 0, (double)INFINITY, TRK_E_RANGE, "modal_damping"},
        {"boat.*", 5, 0, -1, TRK_E_NAME, "no body matches 'boat.*'"},
        {"wheel*", 5, 0, -1, TRK_E_MODEL, "interface"},
        {NULL, 5, 0, -1, TRK_E_ARGUMENT, "pattern is NULL"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        trk_reduce_options options;
        trk_reduce_options_init(&options, sizeof options);
        options.pattern = wrong[k].pattern;
        options.modes = wrong[k].modes;
        options.interface_modes = wrong[k].interface_modes;
        options.modal_damping = wrong[k].damping;
        assert_status(context, trk_model_reduce(context, model, &options, &out), wrong[k].status);
        assert_message(context, wrong[k].words);
        assert_null(out);
    }
    assert_status(context, trk_model_reduce(context, NULL, NULL, &out), TRK_E_ARGUMENT);
    assert_status(context, trk_model_reduce(context, model, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_reduce(NULL, model, NULL, &out), TRK_E_ARGUMENT);
    trk_model_destroy(model);
}

/* Masses that only a damper holds move freely when the interface is held. */
static void a_free_interior(void **state)
{
    trk_context *context = *state;
    trk_spec *spec;
    trk_body_options body;
    trk_link_options link;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    body.mass = 4;
    assert_ok(context, trk_spec_create(context, "loose", &spec));
    for (int k = 0; k < 4; k++) {
        char name[32];
        snprintf(name, sizeof name, "part.%d", k);
        link.from_body = link.to_body;
        link.stiffness = k == 3 ? 0 : 1e4;
        link.damping = 10;
        assert_ok(context, trk_spec_add_body(spec, name, &body, &link.to_body));
        assert_ok(context, trk_spec_add_link(spec, name, &link, NULL));
    }
    trk_model *model, *out = (trk_model *)state;
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    assert_status(context, trk_model_reduce(context, model, NULL, &out), TRK_E_SINGULAR);
    assert_message(context, "moves freely at 'part.3.z'");
    assert_null(out);
    trk_model_destroy(model);
}

static trk_status full_life(trk_context *context)
{
    trk_model *model = NULL, *reduced = NULL;
    trk_status status = try_truck(context, TRK_STANDARD_GRAVITY, 2e-4, &model);
    trk_reduce_options options;
    trk_reduce_options_init(&options, sizeof options);
    options.modes = 3;
    options.interface_modes = 8;
    options.modal_damping = 0.02;
    if (status == TRK_OK)
        status = trk_model_reduce(context, model, &options, &reduced);
    trk_model_destroy(model);
    trk_model_destroy(reduced);
    return status;
}

static void survives_lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(full_life);
}

int main(void)
{
#define TEST(function) cmocka_unit_test_setup_teardown(function, support_setup, support_teardown)
    const struct CMUnitTest tests[] = {
        TEST(parts_are_kept),
        TEST(statics_are_exact),
        TEST(static_response_is_exact),
        TEST(modal_damping),
        TEST(chain_has_its_closed_form),
        TEST(twice),
        TEST(rejects_bad_arguments),
        TEST(a_free_interior),
        cmocka_unit_test(survives_lack_of_memory),
    };
#undef TEST
    return cmocka_run_group_tests(tests, NULL, NULL);
}
