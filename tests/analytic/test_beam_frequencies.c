/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. Frequencies of beams and rods against closed forms, with the order in the element length. */
#include "support.h"

#include "beams.h"

#include <truckride/linear.h>

static const double pi = 3.14159265358979323846;

enum { MODES = 3, PLANAR = TRK_FREE_Z | TRK_FREE_PITCH };

/* Natural frequencies [rad/s] of a line after the first `skip`. */
static void find_modes(trk_context *context, const support_line *line, int32_t skip, double *out)
{
    trk_model *model = support_line_model(context, support_line_spec(context, line), 0, 1);
    trk_modes *modes;
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &modes));
    const double largest = trk_modes_frequency(modes, trk_modes_count(modes));
    for (int32_t k = 1; k <= skip; k++)
        assert_near(trk_modes_frequency(modes, k) / largest, 0, 1e-7);
    for (int32_t k = 0; k < MODES; k++)
        out[k] = 2 * pi * trk_modes_frequency(modes, skip + k + 1);
    trk_modes_destroy(modes);
    trk_model_destroy(model);
}

/* Errors fall with the given power of the length of an element, to `last` on the finest mesh. */
static void check_order(trk_context *context, support_line line, int32_t skip, const double *exact,
                        double order, double last)
{
    double error[4][MODES];
    for (int r = 0; r < 4; r++) {
        line.elements = 8 << r;
        double omega[MODES];
        find_modes(context, &line, skip, omega);
        for (int k = 0; k < MODES; k++)
            error[r][k] = omega[k] / exact[k] - 1;
    }
    for (int k = 0; k < MODES; k++) {
        for (int r = 2; r < 4; r++)
            if (fabs(error[r][k]) > 5e-7) /* below, rounding of the eigenvalues shows */
                assert_near(log2(error[r - 1][k] / error[r][k]), order, 0.08);
        assert_near(error[3][k], 0, last);
    }
}

/* omega of a bending mode with the given root beta L. */
static void thin(const support_line *line, const double *root, double *out)
{
    for (int k = 0; k < MODES; k++)
        out[k] = pow(root[k] / line->length, 2) *
                 sqrt(line->section.bending_y / line->section.mass_per_length);
}

static support_line planar(int32_t first, int32_t last)
{
    support_line line;
    support_line_init(&line, 1);
    line.first = first;
    line.inner = PLANAR;
    line.last = last;
    return line;
}

/* Roots of cos cosh = -1. */
static void cantilever(void **state)
{
    const double root[MODES] = {1.8751040687119611664, 4.6940911329741745764,
                                7.8547574382376125649};
    double exact[MODES];
    support_line line = planar(0, PLANAR);
    thin(&line, root, exact);
    check_order(*state, line, 0, exact, 4, 1e-6);
}

/* Roots of cos cosh = 1, after two modes that do not bend it. */
static void free_free(void **state)
{
    const double root[MODES] = {4.7300407448627040260, 7.8532046240958375565,
                                10.995607838001670907};
    double exact[MODES];
    support_line line = planar(PLANAR, PLANAR);
    thin(&line, root, exact);
    check_order(*state, line, 2, exact, 4, 1e-6);
}

static void simply_supported(void **state)
{
    const double root[MODES] = {pi, 2 * pi, 3 * pi};
    double exact[MODES];
    support_line line = planar(TRK_FREE_PITCH, TRK_FREE_PITCH);
    thin(&line, root, exact);
    check_order(*state, line, 0, exact, 4, 1e-6);
}

/*
 * Simply supported with shear and rotary inertia: sin(k x), k = n pi / L, in the equations of
 * S. P. Timoshenko, Phil. Mag. 41 (1921) 744-746, gives
 * (m J / S) w^4 - (m + k^2 (J + m B / S)) w^2 + B k^4 = 0. The order is 2 where elements are as
 * short as the section is high: their shapes bend under end forces, not under the inertia of the
 * element, whose shear is of the order (length of element)^2.
 */
static void timoshenko(void **state)
{
    support_line line = planar(TRK_FREE_PITCH, TRK_FREE_PITCH);
    trk_beam_options *o = &line.section;
    line.length = 0.8; /* ten heights */
    o->shear_z = o->axial / 2.6 * 5 / 6;
    o->inertia_y = o->mass_per_length * 0.08 * 0.08 / 12;
    const double m = o->mass_per_length, j = o->inertia_y, s = o->shear_z, b = o->bending_y;
    double exact[MODES];
    for (int n = 1; n <= MODES; n++) {
        double k2 = pow(n * pi / line.length, 2), p = m + k2 * (j + m * b / s);
        exact[n - 1] = sqrt(2 * b * k2 * k2 / (p + sqrt(p * p - 4 * m * j / s * b * k2 * k2)));
    }
    check_order(*state, line, 0, exact, 2, 1.6e-4);
}

/* Clamped at one end: (n - 1/2) pi / L times the speed of the waves, from linear elements. */
static void rods(void **state)
{
    for (int twist = 0; twist < 2; twist++) {
        support_line line;
        support_line_init(&line, 1);
        line.first = 0;
        line.inner = line.last = twist ? TRK_FREE_ROLL : TRK_FREE_X;
        double speed = twist ? sqrt(line.section.torsion / line.section.inertia_x)
                             : sqrt(line.section.axial / line.section.mass_per_length);
        double exact[MODES];
        for (int n = 0; n < MODES; n++)
            exact[n] = (n + 0.5) * pi / line.length * speed;
        check_order(*state, line, 0, exact, 2, 1e-3);
    }
}

/* Six motions of a free beam in space do not strain it; then come the bending frequencies of both planes. */
static void free_in_space(void **state)
{
    support_line line;
    support_line_init(&line, 16);
    line.axis[0] = 2. / 3;
    line.axis[1] = -1. / 3;
    line.axis[2] = 2. / 3;
    line.origin[1] = 5;
    double omega[MODES];
    find_modes(*state, &line, 6, omega);
    const double factor =
        pow(4.7300407448627040260 / line.length, 2) / sqrt(line.section.mass_per_length);
    assert_near(omega[0] / (factor * sqrt(line.section.bending_z)), 1, 1e-5);
    assert_near(omega[1] / (factor * sqrt(line.section.bending_y)), 1, 1e-5);
}

/* C = alpha M + beta K: damping ratios alpha / 2 w + beta w / 2. */
static void rayleigh_damping(void **state)
{
    support_line line = planar(0, PLANAR);
    line.elements = 4;
    line.section.mass_damping = 3;
    line.section.stiffness_damping = 2e-5;
    trk_model *model = support_line_model(*state, support_line_spec(*state, &line), 0, 0);
    trk_modes *undamped, *damped;
    assert_ok(*state, trk_modes_create_undamped(*state, model, NULL, &undamped));
    assert_ok(*state, trk_modes_create_damped(*state, model, NULL, NULL, &damped));
    for (int32_t k = 1; k <= MODES; k++) {
        double omega = 2 * pi * trk_modes_frequency(undamped, k);
        assert_near(trk_modes_frequency(damped, k) / trk_modes_frequency(undamped, k), 1, 1e-9);
        assert_near(trk_modes_damping_ratio(damped, k) / (3 / (2 * omega) + 2e-5 * omega / 2), 1,
                    1e-8);
    }
    trk_modes_destroy(undamped);
    trk_modes_destroy(damped);
    trk_model_destroy(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(cantilever, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(free_free, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(simply_supported, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(timoshenko, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(rods, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(free_in_space, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(rayleigh_damping, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
