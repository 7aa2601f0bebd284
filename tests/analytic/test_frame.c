/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. Ladder frames: the rigid limit of a whole truck, grillages, inertia, weight. */
#include "support.h"

#include "beams.h"

#include <truckride/frame.h>
#include <truckride/linear.h>
#include <truckride/vehicle.h>

#include <stdbool.h>

enum { MOST = 400, GRILLAGE = TRK_FREE_Z | TRK_FREE_ROLL | TRK_FREE_PITCH };

static const double frame_height = 0.56823; /* of the centre of gravity of the reference frame */

/* 270 x 80 x 8 rails and members of half their height, all stiffnesses times a factor. */
static void add_frame(trk_context *context, trk_spec *spec, int32_t freedoms, double factor)
{
    static const double stations[] = {1.4, 0, -0.475, -2.2, -4.5, -5.6},
                        crosses[] = {1.4, -0.475, -2.2, -4.5, -5.6};
    trk_beam_options rail, member;
    trk_beam_options_init(&rail, sizeof rail);
    trk_beam_options_init(&member, sizeof member);
    const double young = 2.1e11 * factor, shear = 8.1e10 * factor;
    assert_ok(context, trk_beam_options_channel(context, young, shear, 7850, 0.27, 0.08, 0.008,
                                                0.008, &rail));
    assert_ok(context, trk_beam_options_channel(context, young, shear, 7850, 0.14, 0.06, 0.006,
                                                0.006, &member));
    trk_frame_options o;
    trk_frame_options_init(&o, sizeof o);
    o.freedoms = freedoms;
    o.stations = 6;
    o.station = stations;
    o.crosses = 5;
    o.cross = crosses;
    o.half_width = 0.4;
    o.z = frame_height;
    o.longest = 0.8;
    o.rail = &rail;
    o.member = &member;
    assert_ok(context, trk_spec_add_frame(spec, "frame", &o));
    const double engine[3] = {0.6, 0, frame_height}, load[3] = {-3, 0, frame_height};
    int32_t body;
    for (int side = -1; side <= 1; side += 2) {
        double at[3] = {engine[0], 0.4 * side, frame_height};
        assert_ok(context, trk_spec_nearest_body(spec, "frame.*", at, &body));
        assert_ok(context, trk_spec_add_mass(spec, side < 0 ? "engine right" : "engine left", body,
                                             600, at, NULL));
        at[0] = load[0];
        assert_ok(context, trk_spec_nearest_body(spec, "frame.*", at, &body));
        assert_ok(context, trk_spec_add_mass(spec, side < 0 ? "load right" : "load left", body,
                                             1500, at, NULL));
    }
}

/* Inertia of a compiled grillage as one rigid body: mass, cg x, roll and pitch inertia about it. */
static void find_rigid(trk_context *context, double out[4])
{
    trk_spec *spec;
    assert_ok(context, trk_spec_create(context, "frame", &spec));
    add_frame(context, spec, GRILLAGE, 1);
    int32_t nodes = trk_spec_count(spec, TRK_PART_BODY), n = 3 * nodes;
    double motion[3][MOST], sum[3][3] = {{0}};
    assert_in_range(n, 1, MOST);
    for (int32_t b = 0; b < nodes; b++) {
        trk_body_options node;
        trk_body_options_init(&node, sizeof node);
        assert_ok(context, trk_spec_get_body(spec, b + 1, &node));
        const double rows[3][3] = {{1, 0, 0}, {node.cg[1], 1, 0}, {-node.cg[0], 0, 1}};
        for (int k = 0; k < 3; k++)
            memcpy(&motion[k][3 * b], rows[k], sizeof rows[k]);
    }
    trk_model *model = support_line_model(context, spec, 0, 1);
    double *mass = calloc((size_t)n * (size_t)n, sizeof *mass);
    assert_non_null(mass);
    trk_model_get_mass(model, mass);
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++)
            for (int32_t i = 0; i < n; i++)
                for (int32_t j = 0; j < n; j++)
                    sum[a][b] += motion[a][i] * mass[i * n + j] * motion[b][j];
    free(mass);
    trk_model_destroy(model);
    assert_near(sum[0][1], 0, 1e-9 * sum[0][0]);
    assert_near(sum[1][2], 0, 1e-9 * sum[1][1]);
    out[0] = sum[0][0];
    out[1] = -sum[0][2] / sum[0][0];
    out[2] = sum[1][1];
    out[3] = sum[2][2] - out[0] * out[1] * out[1];
}

/* The end of a link that was on the rigid frame. */
static void attach(trk_context *context, const trk_spec *flexible, const trk_spec *rigid,
                   int32_t *body, const double *point)
{
    const char *name = trk_spec_part_name(rigid, TRK_PART_BODY, *body);
    if (*body && strcmp(name, "frame") == 0)
        assert_ok(context, trk_spec_nearest_body(flexible, "frame.*", point, body));
    else if (*body)
        *body = trk_spec_find(flexible, TRK_PART_BODY, name);
}

/* The reference truck with its frame replaced. */
static trk_spec *make_flexible(trk_context *context, const trk_spec *rigid, double factor)
{
    trk_spec *spec;
    assert_ok(context, trk_spec_create(context, "flexible", &spec));
    for (int32_t b = 1; b <= trk_spec_count(rigid, TRK_PART_BODY); b++) {
        trk_body_options body;
        trk_body_options_init(&body, sizeof body);
        assert_ok(context, trk_spec_get_body(rigid, b, &body));
        const char *name = trk_spec_part_name(rigid, TRK_PART_BODY, b);
        if (strcmp(name, "frame") != 0)
            assert_ok(context, trk_spec_add_body(spec, name, &body, NULL));
    }
    add_frame(context, spec, GRILLAGE, factor);
    for (int32_t r = 1; r <= trk_spec_count(rigid, TRK_PART_ROAD); r++)
        assert_ok(context,
                  trk_spec_add_road(spec, trk_spec_part_name(rigid, TRK_PART_ROAD, r), 0, 0, NULL));
    for (int32_t k = 1; k <= trk_spec_count(rigid, TRK_PART_LINK); k++) {
        trk_link_options link;
        trk_link_options_init(&link, sizeof link);
        assert_ok(context, trk_spec_get_link(rigid, k, &link));
        attach(context, spec, rigid, &link.from_body, link.from_point);
        attach(context, spec, rigid, &link.to_body, link.to_point);
        assert_ok(context, trk_spec_add_link(spec, trk_spec_part_name(rigid, TRK_PART_LINK, k),
                                             &link, NULL));
    }
    return spec;
}

static void find_frequencies(trk_context *context, trk_spec *spec, int32_t allow_free,
                             int32_t count, double *out)
{
    trk_model *model = support_line_model(context, spec, 0, allow_free);
    trk_modes *modes;
    assert_ok(context, trk_modes_create_undamped(context, model, NULL, &modes));
    for (int32_t k = 0; k < count; k++)
        out[k] = trk_modes_frequency(modes, k + 1);
    trk_modes_destroy(modes);
    trk_model_destroy(model);
}

/* The stiffer, the nearer to the truck with a rigid frame: as 1 / stiffness. */
static void rigid_limit(void **state)
{
    enum { FREQUENCIES = 13 };
    trk_context *context = *state;
    trk_spec *rigid;
    /* Beyond, rounding of the stiff eigenvalues shows in the low ones. */
    const double factor[4] = {100, 300, 1000, 3000};
    double inertia[4], wanted[FREQUENCIES], got[FREQUENCIES], error[4];
    assert_ok(context, trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_TRUCK,
                                                  TRK_VARIANT_LINEAR, &rigid));
    const int32_t id = trk_spec_find(rigid, TRK_PART_BODY, "frame");
    trk_body_options frame;
    trk_body_options_init(&frame, sizeof frame);
    assert_ok(context, trk_spec_get_body(rigid, id, &frame));
    assert_near(frame.cg[2], frame_height, 1e-5);
    find_rigid(context, inertia);
    frame.mass = inertia[0];
    frame.cg[0] = inertia[1];
    frame.cg[2] = frame_height;
    frame.inertia[0] = inertia[2];
    frame.inertia[1] = inertia[3];
    assert_ok(context, trk_spec_set_body(rigid, id, &frame));
    for (int s = 0; s < 4; s++) {
        error[s] = 0;
        find_frequencies(context, make_flexible(context, rigid, factor[s]), 0, FREQUENCIES, got);
        if (s == 0) {
            trk_spec *copy;
            assert_ok(context, trk_spec_copy(context, rigid, &copy));
            find_frequencies(context, copy, 0, FREQUENCIES, wanted);
        }
        for (int k = 0; k < FREQUENCIES; k++)
            error[s] = fmax(error[s], fabs(got[k] / wanted[k] - 1));
    }
    for (int s = 2; s < 4; s++)
        assert_near(error[s - 1] / error[s] / (factor[s] / factor[s - 1]), 1, 0.06);
    assert_near(error[3], 0, 7e-4);
    trk_spec_destroy(rigid);
}

/* Vertical springs at the ends of the rails, and soft ties of the other motions of a node in space. */
static void add_springs(trk_context *context, trk_spec *spec, bool in_space)
{
    static const double axes[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const double corner[4][3] = {{1.4, 0.4}, {1.4, -0.4}, {-5.6, 0.4}, {-5.6, -0.4}};
    trk_link_options link;
    for (int k = 0; k < 4 + (in_space ? 3 : 0); k++) {
        char name[32];
        snprintf(name, sizeof name, "spring.%d", k);
        trk_link_options_init(&link, sizeof link);
        const double at[3] = {corner[k % 4][0], corner[k % 4][1], frame_height};
        memcpy(link.to_point, at, sizeof at);
        assert_ok(context, trk_spec_nearest_body(spec, "frame.*", at, &link.to_body));
        memcpy(link.direction, axes[k < 4 ? 2 : (k - 3) % 2], sizeof link.direction);
        link.stiffness = k < 4 ? 1e6 : 3e5;
        assert_ok(context, trk_spec_add_link(spec, name, &link, NULL));
    }
}

static trk_spec *frame_on_springs(trk_context *context, int32_t freedoms)
{
    trk_spec *spec;
    assert_ok(context, trk_spec_create(context, "frame", &spec));
    add_frame(context, spec, freedoms, 1);
    add_springs(context, spec, freedoms == SUPPORT_ALL);
    return spec;
}

/* A flat frame does not mix motions in its plane with those across it: z, roll and pitch suffice. */
static void grillage(void **state)
{
    trk_context *context = *state;
    double deflection[2];
    for (int space = 0; space < 2; space++) {
        trk_spec *spec = frame_on_springs(context, space ? SUPPORT_ALL : GRILLAGE);
        trk_port_options port;
        trk_port_options_init(&port, sizeof port);
        const double at[3] = {-2.2, 0.4, frame_height};
        memcpy(port.point, at, sizeof at);
        assert_ok(context, trk_spec_nearest_body(spec, "frame.*", at, &port.body));
        assert_ok(context, trk_spec_add_port(spec, "load", &port, NULL));
        trk_model *model = support_line_model(context, spec, 0, 0);
        double row[MOST], q[MOST];
        const int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
        assert_in_range(n, 1, MOST);
        assert_ok(context, trk_model_get_row(model, TRK_PART_PORT, 1, row));
        memcpy(q, row, sizeof q);
        support_deflect(context, model, q);
        deflection[space] = 0;
        for (int32_t i = 0; i < n; i++)
            deflection[space] += row[i] * q[i];
        trk_model_destroy(model);
    }
    assert_true(deflection[0] > 0);
    assert_near(deflection[1] / deflection[0], 1, 1e-11);
}

/* Every frequency of the grillage is one of the frame in space. */
static void grillage_modes(void **state)
{
    enum { PLANAR = 12, SPATIAL = 40 };
    double planar[PLANAR], spatial[SPATIAL];
    find_frequencies(*state, frame_on_springs(*state, GRILLAGE), 0, PLANAR, planar);
    find_frequencies(*state, frame_on_springs(*state, SUPPORT_ALL), 0, SPATIAL, spatial);
    for (int k = 0; k < PLANAR; k++) {
        double nearest = INFINITY;
        for (int j = 0; j < SPATIAL; j++)
            nearest = fmin(nearest, fabs(spatial[j] / planar[k] - 1));
        assert_near(nearest, 0, 1e-8);
    }
}

/* The springs carry the weight of beams and masses, with its moment about y. */
static void weight(void **state)
{
    double rigid[4], force[7], sum = 0, moment = 0;
    find_rigid(*state, rigid);
    trk_model *model =
        support_line_model(*state, frame_on_springs(*state, SUPPORT_ALL), TRK_STANDARD_GRAVITY, 0);
    assert_int_equal(trk_model_count(model, TRK_PART_LINK), 7);
    trk_model_get_static(model, NULL, force);
    for (int k = 0; k < 4; k++) {
        sum -= force[k];
        moment -= force[k] * (k < 2 ? 1.4 : -5.6);
    }
    const double wanted = rigid[0] * TRK_STANDARD_GRAVITY;
    assert_near(sum / wanted, 1, 1e-11);
    assert_near(moment / wanted, rigid[1], 1e-10);
    trk_model_destroy(model);
}

/* m L, its first and second moment: a beam moved as a rigid body has the inertia of a rod, exactly. */
static void rod_inertia(void **state)
{
    support_line line;
    support_line_init(&line, 3);
    line.section.inertia_y = 0.3;
    line.section.inertia_z = 0.1;
    line.section.shear_y = line.section.shear_z = 1e8;
    line.origin[0] = 0.7;
    const double m = line.section.mass_per_length, a = 0.7, b = a + line.length,
                 wanted[3] = {m * (b - a), -m * (b * b - a * a) / 2,
                              m * (b * b * b - a * a * a) / 3 + 0.3 * (b - a)};
    trk_model *model = support_line_model(*state, support_line_spec(*state, &line), 0, 1);
    double mass[24 * 24], motion[2][24] = {{0}}, got[3] = {0};
    trk_model_get_mass(model, mass);
    for (int node = 0; node < 4; node++) {
        motion[0][6 * node + 2] = 1; /* up, and pitch about the origin */
        motion[1][6 * node + 2] = -(a + (b - a) * node / 3);
        motion[1][6 * node + 4] = 1;
    }
    for (int i = 0; i < 24; i++)
        for (int j = 0; j < 24; j++) {
            got[0] += motion[0][i] * mass[24 * i + j] * motion[0][j];
            got[1] += motion[0][i] * mass[24 * i + j] * motion[1][j];
            got[2] += motion[1][i] * mass[24 * i + j] * motion[1][j];
        }
    for (int k = 0; k < 3; k++)
        assert_near(got[k] / wanted[k], 1, 1e-13);
    trk_model_destroy(model);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {TEST(rigid_limit), TEST(grillage), TEST(grillage_modes),
                                       TEST(weight), TEST(rod_inertia)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
