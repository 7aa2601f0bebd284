/* SPDX-License-Identifier: MIT */
/*
 * Rows of points (SPEC.1), (SPEC.2) against finite rotations linearised by central differences,
 * and masses at points against the parallel-axis theorem.
 */
#include "support.h"

#include <stdbool.h>
#include <truckride/linear.h>

enum { ALL = 63 };

static uint32_t seed = 7;

static double random_number(void)
{
    seed = seed * 1664525u + 1013904223u;
    return (double)(seed >> 8) / (1 << 24) * 2 - 1;
}

static void random_point(double *p)
{
    for (int k = 0; k < 3; k++)
        p[k] = 3 * random_number();
}

/* out = R(roll, pitch, yaw) r, finite rotations about x, then y, then z. */
static void rotate(const double *angle, const double *r, double *out)
{
    double x = r[0], y = r[1], z = r[2], c, s, t;
    c = cos(angle[0]), s = sin(angle[0]);
    t = c * y - s * z, z = s * y + c * z, y = t;
    c = cos(angle[1]), s = sin(angle[1]);
    t = c * x + s * z, z = -s * x + c * z, x = t;
    c = cos(angle[2]), s = sin(angle[2]);
    t = c * x - s * y, y = s * x + c * y, x = t;
    out[0] = x, out[1] = y, out[2] = z;
}

/* Motion along the direction of point p of a body at q = (x, y, z, roll, pitch, yaw). */
static double motion(const double *cg, const double *p, const double *direction, const double *q)
{
    double r[3], turned[3], sum = 0, length = 0;
    for (int k = 0; k < 3; k++)
        r[k] = p[k] - cg[k];
    rotate(q + 3, r, turned);
    for (int k = 0; k < 3; k++) {
        sum += direction[k] * (q[k] + turned[k] - r[k]);
        length += direction[k] * direction[k];
    }
    return sum / sqrt(length);
}

static void difference_row(const double *cg, const double *p, const double *direction, double *row)
{
    const double h = 1e-5;
    for (int k = 0; k < 6; k++) {
        double q[6] = {0};
        q[k] = h;
        row[k] = motion(cg, p, direction, q);
        q[k] = -h;
        row[k] = (row[k] - motion(cg, p, direction, q)) / (2 * h);
    }
}

static int32_t add_body(trk_context *context, trk_spec *spec, const char *name, const double *cg)
{
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    body.freedoms = ALL;
    body.mass = body.inertia[0] = body.inertia[1] = body.inertia[2] = 1;
    memcpy(body.cg, cg, sizeof body.cg);
    int32_t id;
    assert_ok(context, trk_spec_add_body(spec, name, &body, &id));
    return id;
}

static trk_model *compile(trk_context *context, trk_spec *spec)
{
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.allow_free = 1;
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, &options, &model));
    trk_spec_destroy(spec);
    return model;
}

/* Sensor, port and link at the same points of two bodies. */
static void rows_are_small_rotations(void **state)
{
    for (int round = 0; round < 20; round++) {
        double cg[2][3], p[2][3], direction[3], expected[2][6], row[12], g[1];
        trk_spec *spec;
        assert_ok(*state, trk_spec_create(*state, "free", &spec));
        random_point(direction);
        for (int b = 0; b < 2; b++) {
            random_point(cg[b]);
            random_point(p[b]);
            difference_row(cg[b], p[b], direction, expected[b]);
            (void)add_body(*state, spec, b ? "to" : "from", cg[b]);
        }
        trk_sensor_options sensor;
        trk_sensor_options_init(&sensor, sizeof sensor);
        sensor.body = 2;
        memcpy(sensor.point, p[1], sizeof p[1]);
        memcpy(sensor.direction, direction, sizeof direction);
        assert_ok(*state, trk_spec_add_sensor(spec, "s", &sensor, NULL));
        trk_port_options port;
        trk_port_options_init(&port, sizeof port);
        port.body = 1;
        memcpy(port.point, p[0], sizeof p[0]);
        memcpy(port.direction, direction, sizeof direction);
        assert_ok(*state, trk_spec_add_port(spec, "p", &port, NULL));
        trk_link_options link;
        trk_link_options_init(&link, sizeof link);
        link.from_body = 1;
        link.to_body = 2;
        memcpy(link.from_point, p[0], sizeof p[0]);
        memcpy(link.to_point, p[1], sizeof p[1]);
        memcpy(link.direction, direction, sizeof direction);
        link.stiffness = 1;
        assert_ok(*state, trk_spec_add_link(spec, "k", &link, NULL));
        trk_model *model = compile(*state, spec);
        assert_int_equal(trk_model_count(model, TRK_PART_COORDINATE), 12);
        assert_ok(*state, trk_model_get_row(model, TRK_PART_SENSOR, 1, row));
        for (int k = 0; k < 6; k++) {
            assert_near(row[k], 0, 0);
            assert_near(row[6 + k], expected[1][k], 1e-9);
        }
        assert_ok(*state, trk_model_get_row(model, TRK_PART_PORT, 1, row));
        for (int k = 0; k < 6; k++) {
            assert_near(row[k], expected[0][k], 1e-9);
            assert_near(row[6 + k], 0, 0);
        }
        assert_ok(*state, trk_model_get_link_row(model, 1, row, g));
        for (int k = 0; k < 6; k++) {
            assert_near(row[k], -expected[0][k], 1e-9);
            assert_near(row[6 + k], expected[1][k], 1e-9);
        }
        trk_model_destroy(model);
    }
}

/* e = d . (u_to - u_from): a road below an inclined link enters with its vertical part. */
static void road_enters_with_the_vertical_part(void **state)
{
    const double cg[] = {0, 0, 0};
    trk_spec *spec;
    assert_ok(*state, trk_spec_create(*state, "x", &spec));
    (void)add_body(*state, spec, "b", cg);
    assert_ok(*state, trk_spec_add_road(spec, "other", 0, 0, NULL));
    assert_ok(*state, trk_spec_add_road(spec, "r", 0, 0, NULL));
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.from_road = 2;
    link.to_body = 1;
    link.direction[0] = 3;
    link.direction[2] = 4;
    assert_ok(*state, trk_spec_add_link(spec, "k", &link, NULL));
    trk_model *model = compile(*state, spec);
    double b[6], g[2];
    assert_ok(*state, trk_model_get_link_row(model, 1, b, g));
    assert_near(b[0], 0.6, 1e-15);
    assert_near(b[2], 0.8, 1e-15);
    assert_near(g[0], 0, 0);
    assert_near(g[1], 0.8, 1e-15);
    trk_model_destroy(model);
}

static void rotation_is_the_same_for_all_points(void **state)
{
    const double cg[] = {1, 2, 3};
    trk_spec *spec;
    assert_ok(*state, trk_spec_create(*state, "x", &spec));
    (void)add_body(*state, spec, "b", cg);
    trk_sensor_options sensor;
    trk_sensor_options_init(&sensor, sizeof sensor);
    sensor.body = 1;
    sensor.motion = TRK_MOTION_ROTATION;
    sensor.direction[1] = sensor.direction[2] = 2;
    random_point(sensor.point);
    assert_ok(*state, trk_spec_add_sensor(spec, "s", &sensor, NULL));
    trk_model *model = compile(*state, spec);
    double row[6];
    assert_ok(*state, trk_model_get_row(model, TRK_PART_SENSOR, 1, row));
    const double expected[] = {0, 0, 0, 0, sqrt(0.5), sqrt(0.5)};
    for (int k = 0; k < 6; k++)
        assert_near(row[k], expected[k], 1e-15);
    trk_model_destroy(model);
}

/* A body on three inclined springs; `combined` has the mass within, else at a point. */
static trk_model *mass_on_springs(trk_context *context, bool combined)
{
    const double m = 100, added = 60, arm = 1.5, both = m + added;
    const double inertia[] = {30, 40, 50}, reduced = m * added / both * arm * arm;
    trk_spec *spec;
    assert_ok(context, trk_spec_create(context, "x", &spec));
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    body.freedoms = ALL;
    body.mass = combined ? both : m;
    memcpy(body.inertia, inertia, sizeof inertia);
    if (combined) { /* Steiner: nothing about the axis through both, m arm^2 about the others */
        body.inertia[1] += reduced;
        body.inertia[2] += reduced;
        body.cg[0] = added / both * arm;
    }
    assert_ok(context, trk_spec_add_body(spec, "b", &body, NULL));
    if (!combined)
        assert_ok(context,
                  trk_spec_add_mass(spec, "engine", 1, added, (double[]){arm, 0, 0}, NULL));
    seed = 99;
    for (int k = 0; k < 8; k++) {
        char name[32];
        snprintf(name, sizeof name, "k%d", k);
        trk_link_options link;
        trk_link_options_init(&link, sizeof link);
        link.to_body = 1;
        random_point(link.to_point);
        random_point(link.direction);
        link.stiffness = 1e4 * (k + 1);
        assert_ok(context, trk_spec_add_link(spec, name, &link, NULL));
    }
    return compile(context, spec);
}

/* T^T A T with T from the coordinates about the common cg to those about the body's own. */
static void transform(const double *a, const double *r, double *out)
{
    double t[36] = {0}, half[36] = {0};
    for (int k = 0; k < 6; k++)
        t[7 * k] = 1;
    /* u_own = u_common + theta x r */
    t[0 * 6 + 4] = r[2], t[0 * 6 + 5] = -r[1];
    t[1 * 6 + 3] = -r[2], t[1 * 6 + 5] = r[0];
    t[2 * 6 + 3] = r[1], t[2 * 6 + 4] = -r[0];
    memset(out, 0, 36 * sizeof *out);
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 6; j++)
            for (int k = 0; k < 6; k++)
                half[6 * i + j] += a[6 * i + k] * t[6 * k + j];
    for (int i = 0; i < 6; i++)
        for (int j = 0; j < 6; j++)
            for (int k = 0; k < 6; k++)
                out[6 * i + j] += t[6 * k + i] * half[6 * k + j];
}

static void point_mass_obeys_the_parallel_axis_theorem(void **state)
{
    trk_model *apart = mass_on_springs(*state, false), *combined = mass_on_springs(*state, true);
    const double to_own_cg[] = {-60.0 / 160 * 1.5, 0, 0};
    double m[36], k[36], moved[36], expected[36];
    trk_model_get_mass(apart, m);
    trk_model_get_mass(combined, expected);
    transform(m, to_own_cg, moved);
    for (int i = 0; i < 36; i++)
        assert_near(moved[i], expected[i], 1e-11);
    trk_model_get_tangent(apart, NULL, NULL, NULL, k);
    trk_model_get_tangent(combined, NULL, NULL, NULL, expected);
    transform(k, to_own_cg, moved);
    for (int i = 0; i < 36; i++)
        assert_near(moved[i], expected[i], 1e-8);
    if (trk_has_feature(TRK_FEATURE_LAPACK)) {
        trk_modes *a, *b;
        assert_ok(*state, trk_modes_create_undamped(*state, apart, NULL, &a));
        assert_ok(*state, trk_modes_create_undamped(*state, combined, NULL, &b));
        for (int32_t mode = 1; mode <= 6; mode++)
            assert_near(trk_modes_frequency(a, mode), trk_modes_frequency(b, mode), 1e-9);
        trk_modes_destroy(a);
        trk_modes_destroy(b);
    }
    trk_model_destroy(apart);
    trk_model_destroy(combined);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(rows_are_small_rotations),
        TEST(road_enters_with_the_vertical_part),
        TEST(rotation_is_the_same_for_all_points),
        TEST(point_mass_obeys_the_parallel_axis_theorem),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
