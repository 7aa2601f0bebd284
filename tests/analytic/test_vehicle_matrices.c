/* SPDX-License-Identifier: MIT */
/* Quarter car, half car and half truck: matrices from Lagrange's equation (VEHICLE.1 to 3). */
#include "hand.h"

/* V = ks (zs - zu)^2 / 2 + kt (zu - u)^2 / 2, D alike, T = (ms zs'^2 + mu zu'^2) / 2. */
static void check_quarter_car(trk_context *context, const trk_quarter_car_parameters *p)
{
    hand_matrix m = {{p->sprung_mass, 0}, {0, p->unsprung_mass}};
    hand_matrix k = {{p->spring_stiffness, -p->spring_stiffness},
                     {-p->spring_stiffness, p->spring_stiffness + p->tire_stiffness}};
    hand_matrix c = {{p->damping, -p->damping}, {-p->damping, p->damping + p->tire_damping}};
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_quarter_car(context, p, &spec));
    trk_model *model = hand_check(context, spec, 2, m, c, k);
    hand_check_row(model, "tire", (double[]){0, 1}, (double[]){1});
    hand_check_row(model, "spring", (double[]){1, -1}, NULL);
    trk_model_destroy(model);
}

static void quarter_car(void **state)
{
    trk_quarter_car_parameters p;
    trk_quarter_car_parameters_init(&p, sizeof p);
    check_quarter_car(*state, &p);
    p.sprung_mass = 3211;
    p.unsprung_mass = 617;
    p.spring_stiffness = 271e3;
    p.damping = 13e3;
    p.tire_damping = 777;
    check_quarter_car(*state, &p);
}

/*
 * Coordinates z, angle, z1, z2. A wheel at p in front or on the left lifts the body by
 * z + s p angle there, with s = -1 for pitch (nose down positive), +1 for roll (left up).
 */
static void fill_half_car(const trk_half_car_parameters *p, double s, const double *rate,
                          const double *tire_rate, hand_matrix a)
{
    const double *l = p->position;
    a[0][0] = rate[0] + rate[1];
    hand_add(a, 0, 1, s * (rate[0] * l[0] + rate[1] * l[1]));
    hand_add(a, 0, 2, -rate[0]);
    hand_add(a, 0, 3, -rate[1]);
    a[1][1] = rate[0] * l[0] * l[0] + rate[1] * l[1] * l[1];
    hand_add(a, 1, 2, -s * rate[0] * l[0]);
    hand_add(a, 1, 3, -s * rate[1] * l[1]);
    a[2][2] = rate[0] + tire_rate[0];
    a[3][3] = rate[1] + tire_rate[1];
}

static void check_half_car(trk_context *context, const trk_half_car_parameters *p)
{
    bool pitch = p->layout == TRK_HALF_CAR_PITCH;
    double s = pitch ? -1 : 1;
    hand_matrix m = {{0}}, c = {{0}}, k = {{0}};
    m[0][0] = p->body_mass;
    m[1][1] = p->body_inertia;
    m[2][2] = p->unsprung_mass[0];
    m[3][3] = p->unsprung_mass[1];
    fill_half_car(p, s, p->spring_stiffness, p->tire_stiffness, k);
    fill_half_car(p, s, p->damping, p->tire_damping, c);
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_half_car(context, p, &spec));
    trk_model *model = hand_check(context, spec, 4, m, c, k);
    hand_check_row(model, pitch ? "front_tire" : "left_tire", (double[]){0, 0, 1, 0},
                   (double[]){1, 0});
    hand_check_row(model, pitch ? "rear_tire" : "right_tire", (double[]){0, 0, 0, 1},
                   (double[]){0, 1});
    hand_check_row(model, pitch ? "front_spring" : "left_spring",
                   (double[]){1, s * p->position[0], -1, 0}, NULL);
    hand_check_row(model, pitch ? "rear_damper" : "right_damper",
                   (double[]){1, s * p->position[1], 0, -1}, NULL);
    trk_model_destroy(model);
}

static void half_car(void **state)
{
    trk_half_car_parameters p;
    trk_half_car_parameters_init(&p, sizeof p);
    check_half_car(*state, &p);
    for (p.layout = TRK_HALF_CAR_PITCH; p.layout <= TRK_HALF_CAR_ROLL; p.layout++) {
        uint64_t seed = 20130069;
        for (int k = 0; k < 2; k++) {
            p.position[k] = hand_random(&seed, 0.3, 4) * (k == 0 ? 1 : -1);
            p.spring_stiffness[k] = hand_random(&seed, 1e5, 9e5);
            p.damping[k] = hand_random(&seed, 1e3, 4e4);
            p.tire_stiffness[k] = hand_random(&seed, 5e5, 3e6);
            p.tire_damping[k] = hand_random(&seed, 1e2, 2e3);
            p.unsprung_mass[k] = hand_random(&seed, 200, 900);
        }
        check_half_car(*state, &p);
    }
}

/* Half truck: rates of the four links at one end of the cab, of one suspension. */
typedef struct rates {
    double vertical[2], longitudinal[2], suspension[2], tire[2];
} rates;

enum { X, Z, PITCH, FRAME_Z, FRAME_PITCH, AXLE, HALF_TRUCK = AXLE + 2 };

/*
 * Elongations, with levers a, h of the cab and A, H of the frame:
 * mount     z - a pitch - zf + A pitchf,    arm   x + h pitch - H pitchf,
 * suspension  zf - L pitchf - z_i,          tire  z_i - u_i.
 */
static void fill_half_truck(const trk_truck_parameters *p, const rates *r, hand_matrix m)
{
    for (int end = 0; end < 2; end++) {
        double k = r->vertical[end], l = r->longitudinal[end], s = r->suspension[end];
        double a = p->cab_mount_x[end] - p->cab_cg[0], A = p->cab_mount_x[end] - p->frame_cg[0];
        double h = p->cab_longitudinal_z[end] - p->cab_cg[2];
        double H = p->cab_longitudinal_z[end] - p->frame_cg[2];
        double L = p->axle_x[end] - p->frame_cg[0];
        hand_add(m, X, X, l);
        hand_add(m, X, PITCH, l * h);
        hand_add(m, X, FRAME_PITCH, -l * H);
        hand_add(m, Z, Z, k);
        hand_add(m, Z, PITCH, -k * a);
        hand_add(m, Z, FRAME_Z, -k);
        hand_add(m, Z, FRAME_PITCH, k * A);
        hand_add(m, PITCH, PITCH, k * a * a + l * h * h);
        hand_add(m, PITCH, FRAME_Z, k * a);
        hand_add(m, PITCH, FRAME_PITCH, -k * a * A - l * h * H);
        hand_add(m, FRAME_Z, FRAME_Z, k + s);
        hand_add(m, FRAME_Z, FRAME_PITCH, -k * A - s * L);
        hand_add(m, FRAME_Z, AXLE + end, -s);
        hand_add(m, FRAME_PITCH, FRAME_PITCH, k * A * A + l * H * H + s * L * L);
        hand_add(m, FRAME_PITCH, AXLE + end, s * L);
        hand_add(m, AXLE + end, AXLE + end, s + r->tire[end]);
    }
}

static double mean(const double *of_four, int end)
{
    return (of_four[2 * end] + of_four[2 * end + 1]) / 2;
}

static void check_half_truck(trk_context *context, const trk_truck_parameters *p)
{
    hand_matrix m = {{0}}, c = {{0}}, k = {{0}};
    const double half[HALF_TRUCK] = {
        p->cab_mass / 2,         p->cab_mass / 2,     p->cab_inertia[1] / 2, p->frame_mass / 2,
        p->frame_inertia[1] / 2, p->axle_mass[0] / 2, p->axle_mass[1] / 2};
    for (int i = 0; i < HALF_TRUCK; i++)
        m[i][i] = half[i];
    rates spring, damper;
    for (int e = 0; e < 2; e++) {
        spring.vertical[e] = mean(p->cab_vertical_stiffness, e);
        spring.longitudinal[e] = mean(p->cab_longitudinal_stiffness, e);
        spring.suspension[e] = p->spring_stiffness[e];
        spring.tire[e] = p->tire_stiffness[e];
        damper.vertical[e] = mean(p->cab_vertical_damping, e);
        damper.longitudinal[e] = mean(p->cab_longitudinal_damping, e);
        damper.suspension[e] = p->damping[e];
        damper.tire[e] = p->tire_damping[e];
    }
    fill_half_truck(p, &spring, k);
    fill_half_truck(p, &damper, c);
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_half_truck(context, p, &spec));
    trk_model *model = hand_check(context, spec, HALF_TRUCK, m, c, k);
    hand_check_row(model, "front_tire", (double[]){0, 0, 0, 0, 0, 1, 0}, (double[]){1, 0});
    hand_check_row(model, "rear_tire", (double[]){0, 0, 0, 0, 0, 0, 1}, (double[]){0, 1});
    trk_model_destroy(model);
}

static void half_truck(void **state)
{
    trk_truck_parameters p;
    trk_truck_parameters_init(&p, sizeof p);
    check_half_truck(*state, &p);
    uint64_t seed = 7;
    for (int e = 0; e < 2; e++) {
        p.cab_longitudinal_x[e] = hand_random(&seed, -1, 2);
        p.cab_longitudinal_z[e] = hand_random(&seed, 0.2, 1);
        p.axle_z[e] = hand_random(&seed, -0.2, 0.2);
    }
    for (int k = 0; k < 4; k++) {
        p.cab_vertical_stiffness[k] = hand_random(&seed, 1e4, 9e4);
        p.cab_vertical_damping[k] = hand_random(&seed, 1e3, 9e3);
        p.cab_longitudinal_stiffness[k] = hand_random(&seed, 1e5, 9e5);
        p.cab_longitudinal_damping[k] = hand_random(&seed, 1e3, 9e3);
    }
    check_half_truck(*state, &p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(quarter_car, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(half_car, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(half_truck, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
