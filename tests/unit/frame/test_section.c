/* SPDX-License-Identifier: MIT */
/* Sections against tables, against integration over their area, and everything they refuse. */
#include "support.h"

#include <truckride/frame.h>

static const double pi = 3.14159265358979323846, E = 2.1e11, G = 8.1e10, RHO = 7850;

static trk_beam_options fresh(void)
{
    trk_beam_options o;
    trk_beam_options_init(&o, sizeof o);
    return o;
}

/* A rectangle of the section: from (y, z) with sizes dy, dz; negative sizes of area are holes. */
typedef struct part {
    double y, z, dy, dz, sign;
} part;

/* A, I_y, I_z about the centroid, of rectangles. */
static void integrate(int count, const part *parts, double *out_area, double *out_y, double *out_z)
{
    double area = 0, moment_y = 0, moment_z = 0, yy = 0, zz = 0;
    for (int k = 0; k < count; k++) {
        const part *p = &parts[k];
        double a = p->sign * p->dy * p->dz, y = p->y + p->dy / 2, z = p->z + p->dz / 2;
        area += a;
        moment_y += a * z;
        moment_z += a * y;
        yy += a * (p->dz * p->dz / 12 + z * z);
        zz += a * (p->dy * p->dy / 12 + y * y);
    }
    *out_area = area;
    *out_y = yy - moment_y * moment_y / area;
    *out_z = zz - moment_z * moment_z / area;
}

static void check_area(const trk_beam_options *o, int count, const part *parts)
{
    double area, y, z;
    integrate(count, parts, &area, &y, &z);
    assert_near(o->axial / (E * area), 1, 1e-14);
    assert_near(o->mass_per_length / (RHO * area), 1, 1e-14);
    assert_near(o->bending_y / (E * y), 1, 1e-12);
    assert_near(o->bending_z / (E * z), 1, 1e-12);
    assert_near(o->inertia_y / (RHO * y), 1, 1e-12);
    assert_near(o->inertia_z / (RHO * z), 1, 1e-12);
    assert_near(o->inertia_x / (RHO * (y + z)), 1, 1e-12);
}

/* A rail of a truck: 270 x 80 x 8 mm. */
static void channel(void **state)
{
    const double h = 0.27, b = 0.08, t = 0.008;
    trk_beam_options o = fresh();
    assert_ok(*state, trk_beam_options_channel(*state, E, G, RHO, h, b, t, t, &o));
    const part parts[] = {
        {0, -h / 2, t, h, 1}, {t, -h / 2, b - t, t, 1}, {t, h / 2 - t, b - t, t, 1}};
    check_area(&o, 3, parts);
    assert_near(o.torsion / (G * (2 * 0.076 + 0.262) * t * t * t / 3), 1, 1e-12);
    assert_near(o.shear_z / (G * 0.262 * t), 1, 1e-12);
    assert_near(o.shear_y / (G * 2 * b * t), 5. / 6, 1e-12);
}

static void box(void **state)
{
    const double h = 0.12, b = 0.1, tw = 0.004, tf = 0.006;
    trk_beam_options o = fresh();
    assert_ok(*state, trk_beam_options_box(*state, E, G, RHO, h, b, tw, tf, &o));
    const part parts[] = {{0, 0, b, h, 1}, {tw, tf, b - 2 * tw, h - 2 * tf, -1}};
    check_area(&o, 2, parts);
    const double enclosed = (b - tw) * (h - tf);
    assert_near(o.torsion / (G * 4 * enclosed * enclosed) * (2 * (b - tw) / tf + 2 * (h - tf) / tw),
                1, 1e-12);
    assert_near(o.shear_z / (G * 2 * tw * (h - tf)), 1, 1e-12);
    assert_near(o.shear_y / (G * 2 * tf * (b - tw)), 1, 1e-12);
}

/* J = beta a b^3: S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, table in section 109. */
static void rectangle(void **state)
{
    const double ratio[] = {1, 1.5, 2, 3, 10}, beta[] = {0.1406, 0.196, 0.229, 0.263, 0.312};
    for (int k = 0; k < 5; k++) {
        const double b = 0.04, a = ratio[k] * b;
        trk_beam_options upright = fresh(), flat = fresh();
        assert_ok(*state, trk_beam_options_rectangle(*state, E, G, RHO, a, b, &upright));
        assert_ok(*state, trk_beam_options_rectangle(*state, E, G, RHO, b, a, &flat));
        check_area(&upright, 1, &(part){0, 0, b, a, 1});
        assert_near(upright.torsion / (G * a * b * b * b), beta[k], 5.1e-4);
        assert_near(flat.torsion / upright.torsion, 1, 1e-14);
        assert_near(flat.bending_z / upright.bending_y, 1, 1e-14);
        assert_near(upright.shear_z / (G * a * b), 5. / 6, 1e-14);
    }
}

/* Full rod and thin wall: shear coefficients 6/7 and 1/2, J = 2 I. */
static void tube(void **state)
{
    trk_beam_options o = fresh();
    assert_ok(*state, trk_beam_options_tube(*state, E, G, RHO, 0.06, 0.03, &o));
    assert_near(o.axial / (E * pi * 9e-4), 1, 1e-12);
    assert_near(o.bending_y / (E * pi * pow(0.06, 4) / 64), 1, 1e-12);
    assert_near(o.bending_z / o.bending_y, 1, 1e-14);
    assert_near(o.torsion / (G * pi * pow(0.06, 4) / 32), 1, 1e-12);
    assert_near(o.shear_y / (G * pi * 9e-4), 6. / 7, 1e-12);
    assert_ok(*state, trk_beam_options_tube(*state, E, G, RHO, 0.1, 1e-6, &o));
    assert_near(o.axial / (E * pi * 0.1 * 1e-6), 1, 1e-4);
    assert_near(o.shear_z / o.axial * E / G, 0.5, 1e-4);
}

/* What a section does not say stays. */
static void other_fields(void **state)
{
    trk_beam_options o = fresh();
    o.from_body = 3;
    o.to_point[1] = 7;
    o.up[0] = 2;
    o.mass_damping = 0.5;
    o.stiffness_damping = 1e-4;
    assert_ok(*state, trk_beam_options_tube(*state, E, G, RHO, 0.06, 0.01, &o));
    assert_int_equal(o.struct_size, sizeof o);
    assert_int_equal(o.from_body, 3);
    assert_true(o.to_point[1] == 7 && o.up[0] == 2);
    assert_true(o.mass_damping == 0.5 && o.stiffness_damping == 1e-4);
}

#define REFUSED(call, status, text)                                                                \
    do {                                                                                           \
        assert_status(*state, call, status);                                                       \
        assert_message(*state, text);                                                              \
        assert_memory_equal(&o, &before, sizeof o);                                                \
    } while (0)

static void refusals(void **state)
{
    trk_context *c = *state;
    trk_beam_options o = fresh(), before = o;
    REFUSED(trk_beam_options_channel(c, 0, G, RHO, .2, .1, .01, .01, &o), TRK_E_RANGE,
            "trk_beam_options_channel: young is 0; a finite number > 0");
    REFUSED(trk_beam_options_channel(c, E, G, RHO, .2, .1, .1, .01, &o), TRK_E_RANGE,
            "web is 0.1 m, too thick for a width of 0.1 m; 1 of them");
    REFUSED(trk_beam_options_channel(c, E, G, RHO, .2, .1, .01, .1, &o), TRK_E_RANGE,
            "flange is 0.1 m, too thick for a height of 0.2 m");
    REFUSED(trk_beam_options_box(c, E, -G, RHO, .2, .1, .01, .01, &o), TRK_E_RANGE,
            "trk_beam_options_box: shear is -8.1e+10");
    REFUSED(trk_beam_options_box(c, E, G, RHO, .2, .1, .05, .01, &o), TRK_E_RANGE,
            "web is 0.05 m, too thick for a width of 0.1 m; 2 of them");
    REFUSED(trk_beam_options_box(c, E, G, RHO, .2, NAN, .05, .01, &o), TRK_E_RANGE, "width is nan");
    REFUSED(trk_beam_options_rectangle(c, E, G, INFINITY, .2, .1, &o), TRK_E_RANGE,
            "trk_beam_options_rectangle: density is inf");
    REFUSED(trk_beam_options_rectangle(c, E, G, RHO, .2, 0, &o), TRK_E_RANGE, "width is 0");
    REFUSED(trk_beam_options_tube(c, E, G, 0, .1, .01, &o), TRK_E_RANGE, "density is 0");
    REFUSED(trk_beam_options_tube(c, E, G, RHO, .1, .06, &o), TRK_E_RANGE,
            "trk_beam_options_tube: wall is 0.06 m; at most half of the outer diameter, 0.05 m");
    REFUSED(trk_beam_options_tube(c, E, G, RHO, .1, -1, &o), TRK_E_RANGE, "wall is -1");
    REFUSED(trk_beam_options_channel(c, E, G, RHO, .2, .1, .01, .01, NULL), TRK_E_ARGUMENT,
            "options is NULL");
    REFUSED(trk_beam_options_box(c, E, G, RHO, .2, .1, .01, .01, NULL), TRK_E_ARGUMENT,
            "options is NULL");
    REFUSED(trk_beam_options_rectangle(c, E, G, RHO, .2, .1, NULL), TRK_E_ARGUMENT,
            "options is NULL");
    REFUSED(trk_beam_options_tube(c, E, G, RHO, .2, .1, NULL), TRK_E_ARGUMENT, "options is NULL");
    assert_int_equal(trk_beam_options_tube(NULL, E, G, RHO, .2, .1, &o), TRK_E_ARGUMENT);
    o.struct_size = before.struct_size = 0;
    REFUSED(trk_beam_options_tube(c, E, G, RHO, .2, .1, &o), TRK_E_OPTIONS, "struct_size is 0");
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {TEST(channel), TEST(box),          TEST(rectangle),
                                       TEST(tube),    TEST(other_fields), TEST(refusals)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
