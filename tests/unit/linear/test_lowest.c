/* SPDX-License-Identifier: MIT */
/* Needs ARPACK. Lowest modes of large models (LINEAR.20-22): closed forms, dense modes, copies. */
#include "models.h"

#include <pthread.h>
#include <stdbool.h>

/* `copies` chains of `length` masses of 10 kg on springs of 1e5 N/m, on the ground or free. */
static trk_status try_chains(trk_context *context, int copies, int length, bool is_free,
                             trk_model **out_model)
{
    trk_spec *spec;
    trk_status status = trk_spec_create(context, "chains", &spec);
    trk_body_options body;
    trk_link_options link;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    body.mass = 10;
    link.stiffness = 1e5;
    for (int k = 0; status == TRK_OK && k < copies * length; k++) {
        char name[32];
        snprintf(name, sizeof name, "m%d", k);
        link.from_body = k % length == 0 ? 0 : link.to_body;
        status = trk_spec_add_body(spec, name, &body, &link.to_body);
        if (status == TRK_OK && (link.from_body || !is_free))
            status = trk_spec_add_link(spec, name, &link, NULL);
    }
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.allow_free = is_free;
    if (status == TRK_OK)
        status = trk_model_compile(context, spec, &options, out_model);
    trk_spec_destroy(spec);
    return status;
}

static trk_model *chains(trk_context *context, int copies, int length, bool is_free)
{
    trk_model *model;
    assert_ok(context, try_chains(context, copies, length, is_free, &model));
    return model;
}

/* One end held: sin((2 j - 1) pi / (2 (2 n + 1))), j = 1, 2, ... Free: sin((j - 1) pi / 2 n). */
static double exact(int mode, int length, bool is_free)
{
    double angle = is_free ? (mode - 1) * two_pi / (4 * length)
                           : (2 * mode - 1) * two_pi / (4.0 * (2 * length + 1));
    return 2 * sqrt(1e5 / 10) * sin(angle) / two_pi;
}

static void closed_forms(void **state)
{
    trk_context *context = *state;
    const int lengths[] = {101, 1000, 10000};
    enum { COUNT = 20 };
    for (size_t k = 0; k < 3; k++)
        for (int is_free = 0; is_free <= 1; is_free++) {
            trk_model *model = chains(context, 1, lengths[k], is_free);
            trk_modes *modes;
            assert_ok(context, trk_modes_create_lowest(context, model, NULL, COUNT, &modes));
            assert_int_equal(trk_modes_count(modes), COUNT);
            for (int j = 1; j <= COUNT; j++) {
                double f = exact(j, lengths[k], is_free);
                assert_near(trk_modes_frequency(modes, j), f, 1e-9 * f);
            }
            assert_true(isnan(trk_modes_frequency(modes, COUNT + 1)));
            assert_null(trk_modes_label(modes, COUNT + 1));
            trk_modes_destroy(modes);
            trk_model_destroy(model);
        }
}

/*
 * Cantilever: beta L of cos cosh = -1. Elements of 2.5 mm, whose largest eigenvalue is so high that
 * eps times it is above the lowest: frequencies come from elongations (LINEAR.22).
 */
static void fine_mesh_of_beams(void **state)
{
    trk_context *context = *state;
    enum { ELEMENTS = 2000 };
    const double exact_beta[] = {1.8751040687119611, 4.6940911329741745, 7.8547574382376126};
    const double length = 5, bending = 2e6, mass = 30;
    trk_spec *spec;
    trk_body_options node;
    trk_beam_options beam;
    trk_body_options_init(&node, sizeof node);
    trk_beam_options_init(&beam, sizeof beam);
    node.freedoms = TRK_FREE_Z | TRK_FREE_PITCH;
    beam.bending_y = bending;
    beam.mass_per_length = mass;
    assert_ok(context, trk_spec_create(context, "cantilever", &spec));
    for (int k = 1; k <= ELEMENTS; k++) {
        char name[32];
        snprintf(name, sizeof name, "n%d", k);
        beam.from_body = beam.to_body;
        beam.from_point[0] = node.cg[0];
        node.cg[0] = beam.to_point[0] = length * k / ELEMENTS;
        assert_ok(context, trk_spec_add_body(spec, name, &node, &beam.to_body));
        assert_ok(context, trk_spec_add_beam(spec, name, &beam, NULL));
    }
    trk_model *model = compile(context, spec);
    trk_modes *modes;
    assert_ok(context, trk_modes_create_lowest(context, model, NULL, 3, &modes));
    for (int k = 0; k < 3; k++) {
        double beta = exact_beta[k] / length, f = beta * beta * sqrt(bending / mass) / two_pi;
        assert_near(trk_modes_frequency(modes, k + 1) / f, 1, 1e-9);
    }
    trk_modes_destroy(modes);
    trk_model_destroy(model);
}

/* Shapes are orthonormal, and each copy of a multiple frequency is found. */
static void copies_are_all_found(void **state)
{
    trk_context *context = *state;
    const int cases[][3] = {{4, 100, 20}, {4, 100, 22}, {30, 20, 25}, {7, 150, 200}};
    for (size_t c = 0; c < sizeof cases / sizeof *cases; c++)
        for (int is_free = 0; is_free <= 1; is_free++) {
            int copies = cases[c][0], length = cases[c][1], count = cases[c][2],
                n = copies * length;
            trk_model *model = chains(context, copies, length, is_free);
            trk_modes *modes;
            double *phi = malloc((size_t)(count * n) * sizeof *phi);
            assert_ok(context, trk_modes_create_lowest(context, model, NULL, count, &modes));
            for (int k = 0; k < count; k++) {
                double f = exact(k / copies + 1, length, is_free);
                assert_near(trk_modes_frequency(modes, k + 1), f, 1e-9 * f);
                assert_ok(context, trk_modes_get_shape(modes, k + 1, phi + k * n, NULL));
                for (int j = 0; j <= k; j++) {
                    double sum = 0;
                    for (int i = 0; i < n; i++)
                        sum += 10 * phi[j * n + i] * phi[k * n + i];
                    assert_near(sum, j == k, 1e-10);
                }
            }
            free(phi);
            trk_modes_destroy(modes);
            trk_model_destroy(model);
        }
}

/* Frequencies, shapes, energies and labels are those of the dense path. */
static void agrees_with_all_modes(void **state)
{
    trk_context *context = *state;
    enum { LENGTH = 300, COUNT = 15 };
    trk_model *model = chains(context, 1, LENGTH, false);
    trk_modes *few, *all;
    double x[LENGTH], y[LENGTH], share[LENGTH];
    assert_ok(context, trk_modes_create_lowest(context, model, NULL, COUNT, &few));
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &all));
    for (int k = 1; k <= COUNT; k++) {
        double f = trk_modes_frequency(all, k), total = 0;
        assert_near(trk_modes_frequency(few, k), f, 1e-9 * f);
        assert_int_equal(trk_modes_dominant(few, k), trk_modes_dominant(all, k));
        assert_string_equal(trk_modes_label(few, k), trk_modes_label(all, k));
        assert_ok(context, trk_modes_get_shape(few, k, x, NULL));
        assert_ok(context, trk_modes_get_shape(all, k, y, NULL));
        assert_ok(context, trk_modes_get_energy(few, k, share));
        for (int i = 0; i < LENGTH; i++) {
            assert_near(x[i], y[i], 1e-9);
            total += share[i];
        }
        assert_near(total, 1, 1e-12);
    }
    trk_modes_destroy(few);
    trk_modes_destroy(all);
    trk_model_destroy(model);
}

/* Few coordinates, or most of the modes: all are found, those asked for stay. */
static void small_models(void **state)
{
    trk_context *context = *state;
    trk_model *model = builtin(context, TRK_VEHICLE_REFERENCE_TRUCK);
    trk_modes *few, *all;
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &all));
    for (int count = 1; count <= trk_modes_count(all); count++) {
        assert_ok(context, trk_modes_create_lowest(context, model, NULL, count, &few));
        assert_int_equal(trk_modes_count(few), count);
        for (int k = 1; k <= count; k++)
            assert_near(trk_modes_frequency(few, k), trk_modes_frequency(all, k), 0);
        trk_modes_destroy(few);
    }
    trk_modes_destroy(all);
    trk_model_destroy(model);
}

/* Negative springs to the ground make omega^2 negative: sigma grows until S is definite. */
static void unstable_working_point(void **state)
{
    trk_context *context = *state;
    enum { LENGTH = 150 };
    trk_spec *spec;
    assert_ok(context, trk_spec_create(context, "inverted", &spec));
    trk_body_options body;
    trk_link_options link;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    body.mass = 10;
    for (int k = 0; k < LENGTH; k++) {
        char name[32];
        snprintf(name, sizeof name, "m%d", k);
        link.from_body = link.to_body;
        link.stiffness = 1e5;
        assert_ok(context, trk_spec_add_body(spec, name, &body, &link.to_body));
        if (k > 0)
            assert_ok(context, trk_spec_add_link(spec, name, &link, NULL));
    }
    link.from_body = 0;
    link.stiffness = -3e4;
    assert_ok(context, trk_spec_add_link(spec, "inverted", &link, NULL));
    trk_model *model = compile(context, spec);
    trk_modes *few, *all;
    assert_ok(context, trk_modes_create_lowest(context, model, NULL, 5, &few));
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &all));
    assert_true(trk_modes_frequency(few, 1) < -1);
    for (int k = 1; k <= 5; k++)
        assert_near(trk_modes_frequency(few, k), trk_modes_frequency(all, k), 1e-8);
    trk_modes_destroy(few);
    trk_modes_destroy(all);
    trk_model_destroy(model);
}

static void rejects_bad_arguments(void **state)
{
    trk_context *context = *state;
    trk_model *model = chains(context, 1, 120, false);
    trk_modes *modes = (trk_modes *)state;
    const int32_t wrong[] = {0, -1, 121};
    for (int k = 0; k < 3; k++) {
        assert_status(context, trk_modes_create_lowest(context, model, NULL, wrong[k], &modes),
                      TRK_E_RANGE);
        assert_message(context, "modes of 120 coordinates, expected 1 to 120");
        assert_null(modes);
    }
    double q[120] = {0, (double)NAN};
    assert_status(context, trk_modes_create_lowest(context, model, q, 5, &modes), TRK_E_RANGE);
    assert_message(context, "m1.z");
    assert_status(context, trk_modes_create_lowest(context, NULL, NULL, 5, &modes), TRK_E_ARGUMENT);
    assert_status(context, trk_modes_create_lowest(context, model, NULL, 5, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_modes_create_lowest(NULL, model, NULL, 5, &modes), TRK_E_ARGUMENT);
    trk_model_destroy(model);
}

static trk_status full_life(trk_context *context)
{
    trk_model *model = NULL;
    trk_modes *modes = NULL;
    trk_status status = try_chains(context, 2, 60, true, &model);
    if (status == TRK_OK)
        status = trk_modes_create_lowest(context, model, NULL, 6, &modes);
    trk_modes_destroy(modes);
    trk_model_destroy(model);
    return status;
}

static void survives_lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(full_life);
}

/* Each thread has its context and the model in common; ARPACK's variables must not mix. */
static void *search(void *argument)
{
    const trk_model *model = argument;
    trk_context *context = NULL;
    intptr_t wrong = trk_context_create(NULL, NULL, &context) != TRK_OK;
    for (int round = 0; !wrong && round < 5; round++) {
        trk_modes *modes = NULL;
        wrong = trk_modes_create_lowest(context, model, NULL, 10, &modes) != TRK_OK;
        for (int k = 1; !wrong && k <= 10; k++)
            wrong = !(fabs(trk_modes_frequency(modes, k) / exact(k, 500, false) - 1) < 1e-9);
        trk_modes_destroy(modes);
    }
    trk_context_destroy(context);
    return (void *)wrong;
}

static void threads_take_turns(void **state)
{
    trk_context *context = *state;
    trk_model *model = chains(context, 1, 500, false);
    pthread_t thread[4];
    for (int k = 0; k < 4; k++)
        assert_int_equal(pthread_create(&thread[k], NULL, search, model), 0);
    for (int k = 0; k < 4; k++) {
        void *wrong;
        assert_int_equal(pthread_join(thread[k], &wrong), 0);
        assert_null(wrong);
    }
    trk_model_destroy(model);
}

int main(void)
{
#define TEST(function) cmocka_unit_test_setup_teardown(function, support_setup, support_teardown)
    const struct CMUnitTest tests[] = {
        TEST(closed_forms),
        TEST(fine_mesh_of_beams),
        TEST(copies_are_all_found),
        TEST(agrees_with_all_modes),
        TEST(small_models),
        TEST(unstable_working_point),
        TEST(rejects_bad_arguments),
        TEST(threads_take_turns),
        cmocka_unit_test(survives_lack_of_memory),
    };
#undef TEST
    return cmocka_run_group_tests(tests, NULL, NULL);
}
