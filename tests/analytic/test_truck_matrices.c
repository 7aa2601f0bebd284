/* SPDX-License-Identifier: MIT */
/* 3D truck: every entry of M, C and K from Lagrange's equation (VEHICLE.4). */
#include "hand.h"

/* Cab x .. yaw; then frame; axle i owns Z1 + 2 i and R1 + 2 i. */
enum { X, Y, Z, ROLL, PITCH, YAW, FZ, FROLL, FPITCH, Z1, R1, Z2, R2, TRUCK };

static const double side_sign[2] = {1, -1};

/* Levers of a point from the cg of cab (a, b, h) and frame (A, B, H): forward, left, up. */
typedef struct levers {
    double a, b, h, A, B, H;
} levers;

static levers levers_of(const trk_truck_parameters *p, double x, double y, double z)
{
    return (levers){x - p->cab_cg[0],   y - p->cab_cg[1],   z - p->cab_cg[2],
                    x - p->frame_cg[0], y - p->frame_cg[1], z - p->frame_cg[2]};
}

/* k/2 (z + b roll - a pitch - zf - B rollf + A pitchf)^2 */
static void add_vertical(hand_matrix m, double k, levers l)
{
    hand_add(m, Z, Z, k);
    hand_add(m, Z, ROLL, k * l.b);
    hand_add(m, Z, PITCH, -k * l.a);
    hand_add(m, Z, FZ, -k);
    hand_add(m, Z, FROLL, -k * l.B);
    hand_add(m, Z, FPITCH, k * l.A);
    hand_add(m, ROLL, ROLL, k * l.b * l.b);
    hand_add(m, ROLL, PITCH, -k * l.a * l.b);
    hand_add(m, ROLL, FZ, -k * l.b);
    hand_add(m, ROLL, FROLL, -k * l.b * l.B);
    hand_add(m, ROLL, FPITCH, k * l.b * l.A);
    hand_add(m, PITCH, PITCH, k * l.a * l.a);
    hand_add(m, PITCH, FZ, k * l.a);
    hand_add(m, PITCH, FROLL, k * l.a * l.B);
    hand_add(m, PITCH, FPITCH, -k * l.a * l.A);
    hand_add(m, FZ, FZ, k);
    hand_add(m, FZ, FROLL, k * l.B);
    hand_add(m, FZ, FPITCH, -k * l.A);
    hand_add(m, FROLL, FROLL, k * l.B * l.B);
    hand_add(m, FROLL, FPITCH, -k * l.A * l.B);
    hand_add(m, FPITCH, FPITCH, k * l.A * l.A);
}

/* k/2 (x + h pitch - b yaw - H pitchf)^2 */
static void add_longitudinal(hand_matrix m, double k, levers l)
{
    hand_add(m, X, X, k);
    hand_add(m, X, PITCH, k * l.h);
    hand_add(m, X, YAW, -k * l.b);
    hand_add(m, X, FPITCH, -k * l.H);
    hand_add(m, PITCH, PITCH, k * l.h * l.h);
    hand_add(m, PITCH, YAW, -k * l.h * l.b);
    hand_add(m, PITCH, FPITCH, -k * l.h * l.H);
    hand_add(m, YAW, YAW, k * l.b * l.b);
    hand_add(m, YAW, FPITCH, k * l.b * l.H);
    hand_add(m, FPITCH, FPITCH, k * l.H * l.H);
}

/* k/2 (y - h roll + a yaw + H rollf)^2 */
static void add_lateral(hand_matrix m, double k, levers l)
{
    hand_add(m, Y, Y, k);
    hand_add(m, Y, ROLL, -k * l.h);
    hand_add(m, Y, YAW, k * l.a);
    hand_add(m, Y, FROLL, k * l.H);
    hand_add(m, ROLL, ROLL, k * l.h * l.h);
    hand_add(m, ROLL, YAW, -k * l.h * l.a);
    hand_add(m, ROLL, FROLL, -k * l.h * l.H);
    hand_add(m, YAW, YAW, k * l.a * l.a);
    hand_add(m, YAW, FROLL, k * l.a * l.H);
    hand_add(m, FROLL, FROLL, k * l.H * l.H);
}

/*
 * Two equal suspensions at +-s and two equal tires at +-t of an axle at lever L:
 * k/2 sum (zf + (+-s - yf) rollf - L pitchf - z_i -+ s roll_i)^2 + kt/2 sum (z_i +- t roll_i)^2
 */
static void add_axle(hand_matrix m, int axle, const trk_truck_parameters *p, double k, double s,
                     double tire)
{
    int z = Z1 + 2 * axle, roll = R1 + 2 * axle;
    double L = p->axle_x[axle] - p->frame_cg[0], yf = p->frame_cg[1], t = p->tire_y[axle];
    hand_add(m, FZ, FZ, 2 * k);
    hand_add(m, FZ, FROLL, -2 * k * yf);
    hand_add(m, FZ, FPITCH, -2 * k * L);
    hand_add(m, FZ, z, -2 * k);
    hand_add(m, FROLL, FROLL, 2 * k * (s * s + yf * yf));
    hand_add(m, FROLL, FPITCH, 2 * k * L * yf);
    hand_add(m, FROLL, z, 2 * k * yf);
    hand_add(m, FROLL, roll, -2 * k * s * s);
    hand_add(m, FPITCH, FPITCH, 2 * k * L * L);
    hand_add(m, FPITCH, z, 2 * k * L);
    hand_add(m, z, z, 2 * k + 2 * tire);
    hand_add(m, roll, roll, 2 * k * s * s + 2 * tire * t * t);
}

/* k/2 (i - j)^2 */
static void add_bar(hand_matrix m, int i, int j, double k)
{
    hand_add(m, i, i, k);
    hand_add(m, i, j, -k);
    hand_add(m, j, j, k);
}

static void add_cab(hand_matrix m, const trk_truck_parameters *p, const double *vertical,
                    const double *longitudinal, const double *lateral)
{
    for (int mount = 0; mount < 4; mount++) {
        int e = mount / 2;
        double side = side_sign[mount % 2];
        add_vertical(m, vertical[mount],
                     levers_of(p, p->cab_mount_x[e], side * p->cab_mount_y[e], p->cab_mount_z[e]));
        add_longitudinal(m, longitudinal[mount],
                         levers_of(p, p->cab_longitudinal_x[e], side * p->cab_longitudinal_y[e],
                                   p->cab_longitudinal_z[e]));
        add_lateral(
            m, lateral[mount],
            levers_of(p, p->cab_lateral_x[e], side * p->cab_lateral_y[e], p->cab_lateral_z[e]));
    }
}

static void check_rows(const trk_model *model, const trk_truck_parameters *p)
{
    const double *ty = p->tire_y, yf = p->frame_cg[1];
    hand_check_row(model, "front_left_tire", (double[TRUCK]){[Z1] = 1, [R1] = ty[0]},
                   (double[]){1, 0, 0, 0});
    hand_check_row(model, "front_right_tire", (double[TRUCK]){[Z1] = 1, [R1] = -ty[0]},
                   (double[]){0, 1, 0, 0});
    hand_check_row(model, "rear_left_tire", (double[TRUCK]){[Z2] = 1, [R2] = ty[1]},
                   (double[]){0, 0, 1, 0});
    hand_check_row(model, "rear_right_tire", (double[TRUCK]){[Z2] = 1, [R2] = -ty[1]},
                   (double[]){0, 0, 0, 1});
    double L = p->axle_x[1] - p->frame_cg[0], s = p->spring_y[1], d = p->damper_y[1];
    hand_check_row(model, "rear_right_spring",
                   (double[TRUCK]){[FZ] = 1, [FROLL] = -s - yf, [FPITCH] = -L, [Z2] = -1, [R2] = s},
                   NULL);
    hand_check_row(model, "rear_left_damper",
                   (double[TRUCK]){[FZ] = 1, [FROLL] = d - yf, [FPITCH] = -L, [Z2] = -1, [R2] = -d},
                   NULL);
    levers v = levers_of(p, p->cab_mount_x[1], -p->cab_mount_y[1], 0);
    hand_check_row(
        model, "cab_rear_right_vertical",
        (double[TRUCK]){
            [Z] = 1, [ROLL] = v.b, [PITCH] = -v.a, [FZ] = -1, [FROLL] = -v.B, [FPITCH] = v.A},
        NULL);
    levers l = levers_of(p, 0, p->cab_longitudinal_y[0], p->cab_longitudinal_z[0]);
    hand_check_row(model, "cab_front_left_longitudinal",
                   (double[TRUCK]){[X] = 1, [PITCH] = l.h, [YAW] = -l.b, [FPITCH] = -l.H}, NULL);
    levers t = levers_of(p, p->cab_lateral_x[1], 0, p->cab_lateral_z[1]);
    hand_check_row(model, "cab_rear_left_lateral",
                   (double[TRUCK]){[Y] = 1, [ROLL] = -t.h, [YAW] = t.a, [FROLL] = t.H}, NULL);
    hand_check_row(model, "front_anti_roll_bar", (double[TRUCK]){[FROLL] = 1, [R1] = -1}, NULL);
}

static void check_truck(trk_context *context, const trk_truck_parameters *p)
{
    const double diagonal[TRUCK] = {p->cab_mass,
                                    p->cab_mass,
                                    p->cab_mass,
                                    p->cab_inertia[0],
                                    p->cab_inertia[1],
                                    p->cab_inertia[2],
                                    p->frame_mass,
                                    p->frame_inertia[0],
                                    p->frame_inertia[1],
                                    p->axle_mass[0],
                                    p->axle_roll_inertia[0],
                                    p->axle_mass[1],
                                    p->axle_roll_inertia[1]};
    hand_matrix m = {{0}}, c = {{0}}, k = {{0}};
    for (int i = 0; i < TRUCK; i++)
        m[i][i] = diagonal[i];
    add_cab(k, p, p->cab_vertical_stiffness, p->cab_longitudinal_stiffness,
            p->cab_lateral_stiffness);
    add_cab(c, p, p->cab_vertical_damping, p->cab_longitudinal_damping, p->cab_lateral_damping);
    add_bar(k, ROLL, FROLL, p->cab_anti_roll_stiffness);
    for (int i = 0; i < 2; i++) {
        add_axle(k, i, p, p->spring_stiffness[i], p->spring_y[i], p->tire_stiffness[i]);
        add_axle(c, i, p, p->damping[i], p->damper_y[i], p->tire_damping[i]);
        add_bar(k, FROLL, R1 + 2 * i, p->anti_roll_stiffness[i]);
    }
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_truck(context, p, &spec));
    trk_model *model = hand_check(context, spec, TRUCK, m, c, k);
    check_rows(model, p);
    trk_model_destroy(model);
}

static void reference_tractor(void **state)
{
    trk_truck_parameters p;
    trk_truck_parameters_init(&p, sizeof p);
    check_truck(*state, &p);
}

static void fill(uint64_t *seed, int count, double low, double high, double *out)
{
    for (int k = 0; k < count; k++)
        out[k] = hand_random(seed, low, high);
}

static void randomise(uint64_t *seed, trk_truck_parameters *p)
{
    fill(seed, 3, 900, 2500, p->cab_inertia);
    fill(seed, 3, -0.3, 2, p->cab_cg);
    fill(seed, 3, -1, 0.5, p->frame_cg);
    fill(seed, 2, 400, 1500, p->axle_mass);
    fill(seed, 2, 300, 900, p->axle_roll_inertia);
    fill(seed, 2, -5, 1, p->axle_x);
    fill(seed, 2, -0.3, 0.3, p->axle_z);
    double *places[] = {p->tire_y,
                        p->spring_y,
                        p->damper_y,
                        p->cab_mount_x,
                        p->cab_mount_y,
                        p->cab_mount_z,
                        p->cab_longitudinal_x,
                        p->cab_longitudinal_y,
                        p->cab_longitudinal_z,
                        p->cab_lateral_x,
                        p->cab_lateral_y,
                        p->cab_lateral_z};
    for (size_t k = 0; k < sizeof places / sizeof *places; k++)
        fill(seed, 2, 0.2, 1.4, places[k]);
    double *pairs[] = {p->tire_stiffness, p->spring_stiffness, p->damping, p->tire_damping,
                       p->anti_roll_stiffness};
    for (size_t k = 0; k < sizeof pairs / sizeof *pairs; k++)
        fill(seed, 2, 1e5, 1e6, pairs[k]);
    double *mounts[] = {p->cab_vertical_stiffness,     p->cab_vertical_damping,
                        p->cab_longitudinal_stiffness, p->cab_longitudinal_damping,
                        p->cab_lateral_stiffness,      p->cab_lateral_damping};
    for (size_t k = 0; k < sizeof mounts / sizeof *mounts; k++)
        fill(seed, 4, 1e4, 5e5, mounts[k]);
    fill(seed, 1, 1e4, 1e5, &p->cab_anti_roll_stiffness);
}

/* Nothing symmetric, every link there, axles not on the drawing's zero line. */
static void any_truck(void **state)
{
    uint64_t seed = 13;
    for (int trial = 0; trial < 20; trial++) {
        trk_truck_parameters p;
        trk_truck_parameters_init(&p, sizeof p);
        randomise(&seed, &p);
        check_truck(*state, &p);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(reference_tractor, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(any_truck, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
