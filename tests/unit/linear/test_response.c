/* SPDX-License-Identifier: MIT */
/* Needs LAPACK. Frequency response (LINEAR.3) against closed forms of the quarter car. */
#include "models.h"

#include <complex.h>

/* Sensors in this order on the quarter car of quarter_spec(). */
enum {
    DISPLACEMENT,
    VELOCITY,
    ACCELERATION,
    ELONGATION,
    RATE,
    FORCE,
    TIRE_FORCE,
    UNSPRUNG,
    SENSORS
};

static const double ms = 4200, mu = 520, ks = 260e3, cs = 17e3, kt = 810e3, ct = 900;

/* Quarter car with spring and damper in one link, all six quantities, and a load on the body. */
static trk_spec *quarter_spec(trk_context *context)
{
    trk_spec *spec;
    assert_ok(context, trk_spec_create(context, "quarter", &spec));
    trk_body_options body;
    trk_link_options tire, strut;
    trk_sensor_options sensor;
    trk_port_options port;
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&tire, sizeof tire);
    trk_link_options_init(&strut, sizeof strut);
    trk_sensor_options_init(&sensor, sizeof sensor);
    trk_port_options_init(&port, sizeof port);
    body.mass = ms;
    assert_ok(context, trk_spec_add_body(spec, "sprung", &body, &strut.to_body));
    body.mass = mu;
    assert_ok(context, trk_spec_add_body(spec, "unsprung", &body, &tire.to_body));
    assert_ok(context, trk_spec_add_road(spec, "road", 0, 0, &tire.from_road));
    tire.stiffness = kt;
    tire.damping = ct;
    strut.from_body = tire.to_body;
    strut.stiffness = ks;
    strut.damping = cs;
    int32_t tire_id;
    assert_ok(context, trk_spec_add_link(spec, "tire", &tire, &tire_id));
    assert_ok(context, trk_spec_add_link(spec, "strut", &strut, &sensor.link));
    const char *const names[] = {"displacement", "velocity", "acceleration",
                                 "elongation",   "rate",     "force"};
    for (trk_quantity q = TRK_QUANTITY_DISPLACEMENT; q <= TRK_QUANTITY_FORCE; q++) {
        sensor.quantity = q;
        sensor.body = q <= TRK_QUANTITY_ACCELERATION ? strut.to_body : 0;
        sensor.link = q <= TRK_QUANTITY_ACCELERATION ? 0 : 2;
        assert_ok(context, trk_spec_add_sensor(spec, names[q], &sensor, NULL));
    }
    sensor.link = tire_id;
    assert_ok(context, trk_spec_add_sensor(spec, "tire_force", &sensor, NULL));
    sensor.link = 0;
    sensor.quantity = TRK_QUANTITY_DISPLACEMENT;
    sensor.body = tire.to_body;
    assert_ok(context, trk_spec_add_sensor(spec, "unsprung", &sensor, NULL));
    port.body = strut.to_body;
    assert_ok(context, trk_spec_add_port(spec, "load", &port, NULL));
    return spec;
}

/* By Cramer's rule: zs, zu for road height u and load p on the body. */
static void closed_form(double omega, double complex u, double p, double complex *y)
{
    double complex strut = ks + I * omega * cs, tire = kt + I * omega * ct;
    double complex a = strut - omega * omega * ms, d = strut + tire - omega * omega * mu;
    double complex determinant = a * d - strut * strut;
    double complex zs = (p * d + strut * tire * u) / determinant;
    double complex zu = (a * tire * u + strut * p) / determinant;
    y[DISPLACEMENT] = zs;
    y[VELOCITY] = I * omega * zs;
    y[ACCELERATION] = -omega * omega * zs;
    y[ELONGATION] = zs - zu;
    y[RATE] = I * omega * (zs - zu);
    y[FORCE] = strut * (zs - zu);
    y[TIRE_FORCE] = tire * (zu - u);
    y[UNSPRUNG] = zu;
}

static void quarter_car(void **state)
{
    trk_context *context = *state;
    trk_model *model = compile(context, quarter_spec(context));
    const double frequency[] = {0, 1e-3, 0.5, 1.2, 3, 6.5, 13, 40, 1e3}, gain = 0.02, delay = 0.3,
                 load = 800;
    enum { COUNT = sizeof frequency / sizeof *frequency };
    double got[COUNT][SENSORS][2];
    assert_ok(context, trk_frequency_response(context, model, NULL, NULL, COUNT, frequency, &gain,
                                              &delay, &load, &got[0][0][0]));
    for (int f = 0; f < COUNT; f++) {
        double complex wanted[SENSORS];
        double omega = two_pi * frequency[f];
        closed_form(omega, gain * cexp(-I * omega * delay), load, wanted);
        for (int k = 0; k < SENSORS; k++) {
            double complex error = got[f][k][0] + I * got[f][k][1] - wanted[k];
            double scale = k == TIRE_FORCE ? kt * gain : cabs(wanted[k]);
            assert_near(cabs(error), 0, 1e-12 * scale + 1e-25);
        }
    }
    trk_model_destroy(model);
}

/* NULL gains are zero; the two inputs add up. */
static void superposition(void **state)
{
    trk_context *context = *state;
    trk_model *model = compile(context, quarter_spec(context));
    const double f = 4, gain = 0.01, load = 500;
    double road[2 * SENSORS], port[2 * SENSORS], both[2 * SENSORS], none[2 * SENSORS];
    assert_ok(context,
              trk_frequency_response(context, model, NULL, NULL, 1, &f, &gain, NULL, NULL, road));
    assert_ok(context,
              trk_frequency_response(context, model, NULL, NULL, 1, &f, NULL, NULL, &load, port));
    assert_ok(context,
              trk_frequency_response(context, model, NULL, NULL, 1, &f, &gain, NULL, &load, both));
    assert_ok(context,
              trk_frequency_response(context, model, NULL, NULL, 1, &f, NULL, NULL, NULL, none));
    for (int k = 0; k < 2 * SENSORS; k++) {
        assert_near(both[k], road[k] + port[k], 1e-12 * (fabs(road[k]) + fabs(port[k])));
        assert_near(none[k], 0, 0);
    }
    trk_model_destroy(model);
}

/*
 * The sum of both equations, ms zs" + mu zu" = kt (u - zu), loses zu where w^2 = kt/mu:
 * there the body's acceleration is kt/ms u whatever the suspension.
 */
static void invariant_point(void **state)
{
    trk_context *context = *state;
    for (double stiffness = 1e4; stiffness < 2e7; stiffness *= 7)
        for (double damping = 1e2; damping < 2e6; damping *= 9) {
            trk_quarter_car_parameters p;
            trk_quarter_car_parameters_init(&p, sizeof p);
            p.tire_damping = 0;
            p.spring_stiffness = stiffness;
            p.damping = damping;
            trk_spec *spec;
            assert_ok(context, trk_vehicle_create_quarter_car(context, &p, &spec));
            trk_model *model = compile(context, spec);
            double f = sqrt(p.tire_stiffness / p.unsprung_mass) / two_pi, one = 1, y[3][2];
            assert_ok(context, trk_frequency_response(context, model, NULL, NULL, 1, &f, &one, NULL,
                                                      NULL, &y[0][0]));
            double wanted = p.tire_stiffness / p.sprung_mass;
            int sprung = trk_model_find(model, TRK_PART_SENSOR, "sprung_z") - 1;
            assert_near(hypot(y[sprung][0] - wanted, y[sprung][1]), 0, 1e-12 * wanted);
            trk_model_destroy(model);
        }
}

/* Response of the quarter car, with the forces of spring and damper, at a working point. */
static void respond(trk_context *context, const trk_quarter_car_parameters *p, const double *q,
                    const double *v, double (*out)[2])
{
    const double f = 7, one = 1;
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_quarter_car(context, p, &spec));
    trk_sensor_options sensor;
    trk_sensor_options_init(&sensor, sizeof sensor);
    sensor.quantity = TRK_QUANTITY_FORCE;
    sensor.link = trk_spec_find(spec, TRK_PART_LINK, "damper");
    assert_ok(context, trk_spec_add_sensor(spec, "damper_force", &sensor, NULL));
    sensor.link = trk_spec_find(spec, TRK_PART_LINK, "spring");
    assert_ok(context, trk_spec_add_sensor(spec, "spring_force", &sensor, NULL));
    trk_model *model = compile(context, spec);
    assert_ok(context,
              trk_frequency_response(context, model, q, v, 1, &f, &one, NULL, NULL, &out[0][0]));
    trk_model_destroy(model);
}

/* A damper curve counts with its slope at the given velocity, a spring curve with that at q. */
static void working_point(void **state)
{
    trk_context *context = *state;
    trk_curve *curve;
    trk_quarter_car_parameters p;
    trk_quarter_car_parameters_init(&p, sizeof p);
    assert_ok(context,
              trk_vehicle_create_curve(context, TRK_TABLE_THESIS_FRONT_AXLE_DAMPER, NULL, &curve));
    const double q[] = {0.02, 0.07}, v[] = {0.3, 0.12};
    double wanted[5][2], got[5][2];
    p.damping = trk_curve_slope(curve, v[0] - v[1]);
    p.spring_stiffness = 3e5 + trk_curve_slope(curve, q[0] - q[1]);
    respond(context, &p, NULL, NULL, wanted);
    p.damping = 0;
    p.damper_curve = curve;
    p.spring_stiffness = 3e5;
    p.spring_curve = curve;
    respond(context, &p, q, v, got);
    trk_curve_destroy(curve);
    for (int k = 0; k < 5; k++)
        for (int part = 0; part < 2; part++)
            assert_near(got[k][part], wanted[k][part], 1e-12 * fabs(wanted[k][part]));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(quarter_car, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(superposition, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(invariant_point, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(working_point, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
