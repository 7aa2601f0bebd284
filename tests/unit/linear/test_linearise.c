/* SPDX-License-Identifier: MIT */
/* Statistical linearisation of models: closed forms, limits, what comes out, every error path. */
#include "models.h"
#include "vehicles.h"

#include "model/model.h"

#include <truckride/newmark.h>

static const double pi = 3.14159265358979323846;

enum { COUNT = 4000 };

/* A mass on a link to ground, pushed by white noise; sensors of its link's elongation and rate. */
typedef struct oscillator {
    double mass;
    trk_link_options link;
    double gravity;
} oscillator;

static oscillator oscillator_of(double mass, double stiffness, double damping)
{
    oscillator o = {.mass = mass};
    trk_link_options_init(&o.link, sizeof o.link);
    o.link.stiffness = stiffness;
    o.link.damping = damping;
    return o;
}

static trk_model *build(trk_context *context, oscillator *o)
{
    trk_spec *spec;
    trk_model *model;
    trk_body_options body;
    trk_port_options port;
    trk_sensor_options sensor;
    trk_model_options options;
    trk_body_options_init(&body, sizeof body);
    trk_port_options_init(&port, sizeof port);
    trk_sensor_options_init(&sensor, sizeof sensor);
    trk_model_options_init(&options, sizeof options);
    body.mass = o->mass;
    options.gravity = o->gravity;
    assert_ok(context, trk_spec_create(context, "oscillator", &spec));
    assert_ok(context, trk_spec_add_body(spec, "mass", &body, &o->link.to_body));
    assert_ok(context, trk_spec_add_link(spec, "link", &o->link, &sensor.link));
    port.body = o->link.to_body;
    assert_ok(context, trk_spec_add_port(spec, "push", &port, NULL));
    sensor.quantity = TRK_QUANTITY_ELONGATION;
    assert_ok(context, trk_spec_add_sensor(spec, "elongation", &sensor, NULL));
    sensor.quantity = TRK_QUANTITY_RATE;
    assert_ok(context, trk_spec_add_sensor(spec, "rate", &sensor, NULL));
    assert_ok(context, trk_model_compile(context, spec, &options, &model));
    trk_spec_destroy(spec);
    return model;
}

/* White noise of one-sided PSD s from 0 Hz to `most`, dense about `peak`. */
static void white_noise(double s, double peak, double most, double *frequency, double *input)
{
    for (int k = 0; k < COUNT; k++) {
        const double u = (double)k / (COUNT - 1);
        frequency[k] =
            u < 0.8 ? 2.5 * peak * u : 2 * peak + (most - 2 * peak) * pow(5 * (u - 0.8), 3);
        input[2 * k] = s;
        input[2 * k + 1] = 0;
    }
}

static trk_curve *cubic(trk_context *context, double factor, double reach)
{
    enum { POINTS = 41 };
    double x[POINTS], y[POINTS];
    trk_curve *curve;
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = TRK_INTERPOLATION_NOT_A_KNOT;
    for (int k = 0; k < POINTS; k++) {
        x[k] = reach * (k - 20) / 20;
        y[k] = factor * pow(x[k], 3);
    }
    assert_ok(context, trk_curve_create(context, "cubic", POINTS, x, y, &options, &curve));
    return curve;
}

/*
 * Duffing's oscillator under white noise S: k_eq = k + 3 k_3 s^2, s^2 = S / (4 c k_eq); the
 * cubic damper: c_eq = c + 3 c_3 s_v^2, s_v^2 = S / (4 m c_eq).
 */
static void test_cubic_spring_and_damper(void **state)
{
    static double frequency[COUNT], input[2 * COUNT];
    oscillator o = oscillator_of(100, 4e4, 300);
    const double s = 400;
    trk_curve *spring = cubic(*state, 4e8, 1), *damper = cubic(*state, 2e4, 5);
    for (int which = 0; which < 2; which++) {
        o.link.spring_curve = which == 0 ? spring : NULL;
        o.link.damper_curve = which == 1 ? damper : NULL;
        trk_model *model = build(*state, &o), *linear;
        double k, c, mean, density[2 * COUNT], rms[2];
        const double factor = which ? 3 * 2e4 : 3 * 4e8;
        const double fixed = which ? o.link.damping : o.link.stiffness;
        const double variance_times = which ? s / (4 * o.mass) : s / (4 * o.link.damping);
        const double closed = 0.5 * (fixed + sqrt(fixed * fixed + 4 * factor * variance_times));
        white_noise(s, sqrt((which ? o.link.stiffness : closed) / o.mass) / (2 * pi), 3000,
                    frequency, input);
        assert_ok(*state, trk_model_linearise(*state, model, COUNT, frequency, input, NULL, &k, &c,
                                              &mean, &linear));
        assert_ok(*state, trk_response_psd(*state, linear, NULL, NULL, COUNT, frequency, input,
                                           density, rms));
        print_message("equivalent over fixed %.4f, closed form %+.1e\n", (which ? c : k) / fixed,
                      (which ? c : k) / closed - 1);
        assert_near(which ? c : k, closed, 2e-4 * closed); /* the noise is not quite white */
        /* with the variance of this noise to the tolerance */
        assert_near(which ? c : k, fixed + factor * rms[which] * rms[which], 1e-5 * closed);
        assert_near(which ? k : c, which ? o.link.stiffness : o.link.damping, 1e-9 * 4e4);
        assert_true(mean == 0);
        trk_model_destroy(linear);
        trk_model_destroy(model);
    }
    trk_curve_destroy(spring);
    trk_curve_destroy(damper);
}

/* Dry friction on a mass: c_eq = c + R sqrt(2 / pi) / s_v, s_v^2 = S / (4 m c_eq). */
static void test_dry_friction(void **state)
{
    static double frequency[COUNT], input[2 * COUNT];
    const double x[] = {-1e-6, 1e-6}, y[] = {-20, 20}, s = 400;
    oscillator o = oscillator_of(100, 4e4, 100);
    trk_curve *curve;
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = TRK_INTERPOLATION_LINEAR;
    options.extrapolation = TRK_EXTRAPOLATION_CLAMP;
    assert_ok(*state, trk_curve_create(*state, "Coulomb", 2, x, y, &options, &curve));
    o.link.damper_curve = curve;
    trk_model *model = build(*state, &o);
    white_noise(s, 20 / (2 * pi), 3000, frequency, input);
    double k, c;
    assert_ok(*state, trk_model_linearise(*state, model, COUNT, frequency, input, NULL, &k, &c,
                                          NULL, NULL));
    /* c = c_0 + g sqrt(c): a square in sqrt(c) */
    const double g = 20 * sqrt(2 / pi) / sqrt(s / (4 * o.mass));
    const double closed = pow(0.5 * (g + sqrt(g * g + 4 * 100)), 2);
    print_message("c %.6g, closed form %+.1e\n", c, c / closed - 1);
    assert_near(c, closed, 2e-4 * closed);
    trk_model_destroy(model);
    trk_curve_destroy(curve);
}

/* Unequal damping in compression and extension shifts the mean: k m + E[d] = 0, and under
 * gravity a stiffening spring settles where E[f] carries the weight. */
static void test_mean_position(void **state)
{
    static double frequency[COUNT], input[2 * COUNT];
    const double x[] = {-10, 0, 10}, y[] = {-3000, 0, 12000};
    oscillator o = oscillator_of(100, 4e4, 0);
    trk_curve_options options;
    trk_curve *damper, *spring = cubic(*state, 4e7, 1);
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = TRK_INTERPOLATION_LINEAR;
    assert_ok(*state, trk_curve_create(*state, "damper", 3, x, y, &options, &damper));
    o.link.damper_curve = damper;
    white_noise(400, 20 / (2 * pi), 3000, frequency, input);
    trk_model *model = build(*state, &o), *linear;
    double k, c, mean, rms[2];
    assert_ok(*state, trk_model_linearise(*state, model, COUNT, frequency, input, NULL, &k, &c,
                                          &mean, &linear));
    assert_ok(*state,
              trk_response_psd(*state, linear, NULL, NULL, COUNT, frequency, input, NULL, rms));
    assert_near(c, (300 + 1200) / 2.0, 1e-6 * c);
    assert_near(mean, -(1200 - 300) * rms[1] / sqrt(2 * pi) / 4e4, 1e-9); /* E|v| / 2 */
    assert_near(k, 4e4, 1e-6);
    trk_model_destroy(linear);
    trk_model_destroy(model);

    o.link.damper_curve = NULL;
    o.link.damping = 300;
    o.link.spring_curve = spring;
    o.gravity = 9.81;
    model = build(*state, &o);
    double still;
    trk_model_get_static(model, &still, NULL);
    assert_ok(*state, trk_model_linearise(*state, model, COUNT, frequency, input, NULL, &k, &c,
                                          &mean, &linear));
    assert_ok(*state,
              trk_response_psd(*state, linear, NULL, NULL, COUNT, frequency, input, NULL, rms));
    const double variance = rms[0] * rms[0];
    assert_near(4e4 * mean + 4e7 * (pow(mean, 3) + 3 * mean * variance), -981, 1e-3);
    assert_near(k, 4e4 + 3 * 4e7 * (mean * mean + variance), 1e-5 * k);
    assert_true(mean > still + 1e-4); /* it stands higher as it moves */
    assert_true(trk_model_gravity(linear) == 0);
    trk_model_destroy(linear);
    trk_model_destroy(model);
    trk_curve_destroy(damper);
    trk_curve_destroy(spring);
}

/* An air spring holds the mean by its slope from rest to rest, its auxiliary volume taking part. */
static void test_air_spring_holds_the_mean(void **state)
{
    static double frequency[COUNT], input[2 * COUNT];
    const double x[] = {-10, 0, 10}, y[] = {-3000, 0, 12000};
    oscillator o = oscillator_of(1000, 0, 0);
    trk_air_spring_options air;
    trk_curve_options options;
    trk_curve *damper;
    trk_law *law;
    trk_air_spring_options_init(&air, sizeof air);
    air.pressure = 6e5;
    air.volume = 0.008;
    air.area = 0.03;
    air.auxiliary_volume = 0.006;
    air.conductance = 4e-7;
    assert_ok(*state, trk_law_create_air_spring(*state, "air", &air, &law));
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = TRK_INTERPOLATION_LINEAR;
    assert_ok(*state, trk_curve_create(*state, "damper", 3, x, y, &options, &damper));
    o.link.law = law;
    o.link.damper_curve = damper;
    trk_model *model = build(*state, &o), *linear;
    white_noise(400, 1, 100, frequency, input);
    double k, c, mean, rms[2];
    assert_ok(*state, trk_model_linearise(*state, model, COUNT, frequency, input, NULL, &k, &c,
                                          &mean, &linear));
    assert_ok(*state,
              trk_response_psd(*state, linear, NULL, NULL, COUNT, frequency, input, NULL, rms));
    const double slow = air.exponent * 6e5 * 0.03 * 0.03 / 0.014, fast = slow * 0.014 / 0.008;
    const double shift = -(1200 - 300) * rms[1] / sqrt(2 * pi) / slow;
    print_message("shift %.3g m, %.3g without curvature; stiffness %.0f of %.0f to %.0f N/m\n",
                  mean, shift, k, slow, fast);
    assert_near(mean, shift, 0.05 * fabs(shift)); /* nearly: the law is curved */
    assert_true(k > slow && k < fast && c > 750);
    trk_model_destroy(linear);
    trk_model_destroy(model);
    trk_curve_destroy(damper);
    trk_law_destroy(law);
}

/* Beams are links without a name: they stay what they are, and no array has them. */
static void test_beams_stay(void **state)
{
    static double frequency[COUNT], input[2 * COUNT];
    trk_spec *spec;
    trk_body_options body;
    trk_beam_options beam;
    trk_link_options link;
    trk_port_options port;
    trk_model *model, *linear;
    trk_curve *spring = cubic(*state, 4e8, 1);
    trk_body_options_init(&body, sizeof body);
    trk_beam_options_init(&beam, sizeof beam);
    trk_link_options_init(&link, sizeof link);
    trk_port_options_init(&port, sizeof port);
    body.mass = 50;
    body.freedoms = TRK_FREE_Z | TRK_FREE_PITCH;
    body.inertia[1] = 5;
    beam.to_point[0] = 1;
    beam.axial = 1e8;
    beam.bending_y = 1e5;
    beam.mass_per_length = 10;
    beam.stiffness_damping = 1e-4;
    beam.mass_damping = 0.1;
    link.stiffness = 4e4;
    link.damping = 300;
    link.spring_curve = spring;
    assert_ok(*state, trk_spec_create(*state, "beam", &spec));
    for (int k = 0; k < 2; k++) {
        body.cg[0] = k;
        assert_ok(*state, trk_spec_add_body(spec, k ? "b" : "a", &body, &link.to_body));
        link.to_point[0] = k;
        assert_ok(*state, trk_spec_add_link(spec, k ? "spring b" : "spring a", &link, NULL));
    }
    beam.from_body = 1;
    beam.to_body = port.body = 2;
    assert_ok(*state, trk_spec_add_beam(spec, "beam", &beam, NULL));
    assert_ok(*state, trk_spec_add_port(spec, "push", &port, NULL));
    assert_ok(*state, trk_model_compile(*state, spec, NULL, &model));
    white_noise(400, 3, 500, frequency, input);
    double k[3] = {0, 0, 7}, c[3] = {0, 0, 7}, a[3][MAXIMUM * MAXIMUM], b[3][MAXIMUM * MAXIMUM];
    assert_ok(*state, trk_model_linearise(*state, model, COUNT, frequency, input, NULL, k, c, NULL,
                                          &linear));
    assert_true(k[0] > 4e4 && k[1] > 4e4 && k[2] == 7 && c[2] == 7);
    const int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
    trk_model_get_mass(model, a[0]);
    trk_model_get_mass(linear, b[0]);
    trk_model_get_tangent(model, NULL, NULL, a[1], a[2]);
    trk_model_get_tangent(linear, NULL, NULL, b[1], b[2]);
    for (int32_t id = 1; id <= 2; id++) { /* what the springs gained is all that differs */
        double row[MAXIMUM];
        assert_ok(*state, trk_model_get_link_row(model, id, row, NULL));
        for (int32_t i = 0; i < n; i++)
            for (int32_t j = 0; j < n; j++)
                a[2][i * n + j] += (k[id - 1] - 4e4) * row[i] * row[j];
    }
    for (int32_t i = 0; i < n * n; i++) {
        assert_true(a[0][i] == b[0][i]);
        assert_near(a[1][i], b[1][i], 1e-9 * fabs(a[1][i]));
        assert_near(a[2][i], b[2][i], 1e-9 * fabs(a[2][i]));
    }
    const char *word;
    assert_int_equal(trk_model_find(linear, TRK_PART_BEAM, "beam"), 1);
    for (int32_t id = 2; id < linear->links.count; id++)
        assert_string_equal(trk_model_link_name(linear, id, &word), "beam");
    trk_model_destroy(linear);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    trk_curve_destroy(spring);
}

/* Roads of the truck: class, at 20 m/s. */
enum { TRUCK_COUNT = 300, TRUCK_INPUTS = 8 };
typedef struct drive {
    double frequency[TRUCK_COUNT], input[2 * TRUCK_COUNT * TRUCK_INPUTS * TRUCK_INPUTS];
} drive;

static drive *drive_of(trk_context *context, const trk_model *model, double unevenness)
{
    drive *d = malloc(sizeof *d);
    trk_road_options road;
    assert_non_null(d);
    assert_true(trk_model_count(model, TRK_PART_ROAD) + trk_model_count(model, TRK_PART_PORT) <=
                TRUCK_INPUTS);
    trk_road_options_init(&road, sizeof road);
    road.unevenness = unevenness;
    for (int k = 0; k < TRUCK_COUNT; k++)
        d->frequency[k] = 0.22 * pow(250, (double)k / (TRUCK_COUNT - 1));
    assert_ok(context, trk_road_input_spectra(context, model, &road, 20, TRUCK_COUNT, d->frequency,
                                              d->input));
    return d;
}

/* No road: the tangents at rest. A tiny one: nearly so. A linear vehicle: itself. */
static void test_limits(void **state)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++)
        for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++)
            for (int weight = 0; weight < 2; weight++) {
                trk_model *model = support_model(*state, vehicle, variant, 9.81 * weight), *linear;
                const int32_t links = trk_model_count(model, TRK_PART_LINK);
                double k[64], c[64], mean[MAXIMUM], still[MAXIMUM];
                assert_true(links <= 64);
                for (double unevenness = 0; unevenness < 1e-4; unevenness += 16e-6) {
                    drive *d =
                        drive_of(*state, model, unevenness < 8e-6 ? unevenness * 1e-20 : 16e-6);
                    if (unevenness > 8e-6 && model->nonlinear_count > 0) {
                        free(d);
                        break;
                    }
                    assert_ok(*state, trk_model_linearise(*state, model, TRUCK_COUNT, d->frequency,
                                                          d->input, NULL, k, c, mean, &linear));
                    trk_model_get_static(model, still, NULL);
                    for (int32_t i = 0; i < links; i++) {
                        double stiffness, damping;
                        trk_model_link_tangent(model, i, NULL, NULL, &stiffness, &damping);
                        assert_near(k[i], stiffness, 1e-8 * fabs(stiffness));
                        assert_near(c[i], damping, 1e-8 * fabs(damping));
                    }
                    for (int32_t i = 0; i < trk_model_count(model, TRK_PART_COORDINATE); i++)
                        assert_near(mean[i], still[i], 1e-9);
                    trk_model_destroy(linear);
                    free(d);
                }
                trk_model_destroy(model);
            }
}

/* What comes out is a model as any: the same parts, rows and matrices, and it runs. */
static void test_model_that_comes_out(void **state)
{
    trk_model *model = support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_LINEAR, 0);
    trk_model *linear;
    drive *d = drive_of(*state, model, 256e-6);
    assert_ok(*state, trk_model_linearise(*state, model, TRUCK_COUNT, d->frequency, d->input, NULL,
                                          NULL, NULL, NULL, &linear));
    const int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
    for (trk_part part = 1; part <= TRK_PART_COORDINATE; part++) {
        assert_int_equal(trk_model_count(linear, part), trk_model_count(model, part));
        for (int32_t id = 1; id <= trk_model_count(model, part); id++) {
            const char *name = trk_model_part_name(model, part, id),
                       *unit = trk_model_unit(model, part, id);
            assert_string_equal(trk_model_part_name(linear, part, id), name);
            assert_int_equal(trk_model_find(linear, part, name), id);
            if (unit)
                assert_string_equal(trk_model_unit(linear, part, id), unit);
        }
    }
    double a[3][MAXIMUM * MAXIMUM], b[3][MAXIMUM * MAXIMUM];
    trk_model_get_mass(model, a[0]);
    trk_model_get_mass(linear, b[0]);
    trk_model_get_tangent(model, NULL, NULL, a[1], a[2]);
    trk_model_get_tangent(linear, NULL, NULL, b[1], b[2]);
    for (int m = 0; m < 3; m++)
        for (int i = 0; i < n * n; i++)
            assert_true(a[m][i] == b[m][i]);
    assert_string_equal(trk_model_name(linear), trk_model_name(model));
    for (int32_t road = 1; road <= trk_model_count(model, TRK_PART_ROAD); road++) {
        double x, y, x2, y2;
        assert_ok(*state, trk_model_get_road_place(model, road, &x, &y));
        assert_ok(*state, trk_model_get_road_place(linear, road, &x2, &y2));
        assert_true(x == x2 && y == y2);
    }
    trk_model_destroy(model); /* it needs the other no more */

    trk_newmark *stepper;
    trk_newmark_options options;
    trk_newmark_options_init(&options, sizeof options);
    assert_ok(*state, trk_newmark_create(*state, linear, &options, &stepper));
    trk_newmark_destroy(stepper);
    trk_modes *modes;
    assert_ok(*state, trk_modes_create_damped(*state, linear, NULL, NULL, &modes));
    trk_modes_destroy(modes);
    trk_model_destroy(linear);
    free(d);
}

/* From any relaxation the same links come out, and more road makes them softer dampers. */
static void test_relaxation_does_not_matter(void **state)
{
    trk_model *model =
        support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_THESIS_DAMPERS, 0);
    const int32_t links = trk_model_count(model, TRK_PART_LINK);
    const int32_t damper = trk_model_find(model, TRK_PART_LINK, "front_left_damper");
    double k[2][64], c[2][64], before = INFINITY;
    assert_true(links <= 64);
    for (int road = 0; road < 4; road++) {
        drive *d = drive_of(*state, model, 16e-6 * pow(4, road));
        trk_linearise_options options;
        trk_linearise_options_init(&options, sizeof options);
        for (int i = 0; i < 2; i++) {
            options.relaxation = i ? 0.3 : 1;
            options.tolerance = 1e-8;
            options.max_iterations = 20;
            assert_ok(*state, trk_model_linearise(*state, model, TRUCK_COUNT, d->frequency,
                                                  d->input, &options, k[i], c[i], NULL, NULL));
        }
        for (int32_t i = 0; i < links; i++) {
            assert_near(k[0][i], k[1][i], 1e-6 * fabs(k[0][i]));
            assert_near(c[0][i], c[1][i], 1e-6 * fabs(c[0][i]));
        }
        assert_true(damper == 0 || c[0][damper - 1] < before);
        if (damper)
            before = c[0][damper - 1];
        free(d);
    }
    trk_model_destroy(model);
}

static void test_errors(void **state)
{
    static double frequency[COUNT], input[2 * COUNT];
    oscillator o = oscillator_of(100, 4e4, 300);
    trk_curve *spring = cubic(*state, 4e8, 1);
    o.link.spring_curve = spring;
    trk_model *model = build(*state, &o), *out = model;
    white_noise(400, 3, 100, frequency, input);
    trk_linearise_options options;
    trk_context *c = *state;
    assert_status(
        NULL, trk_model_linearise(NULL, model, 2, frequency, input, NULL, NULL, NULL, NULL, &out),
        TRK_E_ARGUMENT);
    assert_null(out);
    assert_status(c,
                  trk_model_linearise(c, NULL, 2, frequency, input, NULL, NULL, NULL, NULL, &out),
                  TRK_E_ARGUMENT);
    assert_status(c, trk_model_linearise(c, model, 2, NULL, input, NULL, NULL, NULL, NULL, &out),
                  TRK_E_ARGUMENT);
    assert_status(c,
                  trk_model_linearise(c, model, 2, frequency, NULL, NULL, NULL, NULL, NULL, &out),
                  TRK_E_ARGUMENT);
    assert_status(c,
                  trk_model_linearise(c, model, 0, frequency, input, NULL, NULL, NULL, NULL, &out),
                  TRK_E_RANGE);
    assert_message(c, "trk_model_linearise: count is 0");
    static const double bad[] = {0, -1, 2, NAN};
    for (int k = 0; k < 4; k++) {
        trk_linearise_options_init(&options, sizeof options);
        options.tolerance = bad[k];
        assert_status(
            c, trk_model_linearise(c, model, 2, frequency, input, &options, NULL, NULL, NULL, &out),
            TRK_E_RANGE);
        assert_message(c, "tolerance is");
        trk_linearise_options_init(&options, sizeof options);
        options.relaxation = bad[k];
        assert_status(
            c, trk_model_linearise(c, model, 2, frequency, input, &options, NULL, NULL, NULL, &out),
            TRK_E_RANGE);
        assert_message(c, "relaxation is");
    }
    trk_linearise_options_init(&options, sizeof options);
    options.reserved = 1;
    assert_status(
        c, trk_model_linearise(c, model, 2, frequency, input, &options, NULL, NULL, NULL, &out),
        TRK_E_OPTIONS);
    trk_linearise_options_init(&options, sizeof options);
    options.max_iterations = 0;
    assert_status(
        c, trk_model_linearise(c, model, 2, frequency, input, &options, NULL, NULL, NULL, &out),
        TRK_E_RANGE);
    options.max_iterations = 2;
    assert_status(
        c, trk_model_linearise(c, model, COUNT, frequency, input, &options, NULL, NULL, NULL, &out),
        TRK_E_CONVERGENCE);
    assert_message(c, "link 'link' still changes by");
    assert_null(out);
    trk_model_destroy(model);

    /* nothing holds the mean against a damper that pulls */
    const double x[] = {-10, 0, 10}, y[] = {-3000, 0, 12000};
    trk_curve *damper;
    assert_ok(c, trk_curve_create(c, "damper", 3, x, y, NULL, &damper));
    o.link.spring_curve = NULL;
    o.link.stiffness = 0;
    o.link.damper_curve = damper;
    model = build(c, &o);
    assert_status(c,
                  trk_model_linearise(c, model, COUNT - 1, frequency + 1, input + 2, NULL, NULL,
                                      NULL, NULL, &out),
                  TRK_E_SINGULAR);
    assert_message(c, "against mean forces");
    trk_model_destroy(model);

    /* a damper that drives */
    o.link.stiffness = 4e4;
    const double turned[] = {3000, 0, -12000};
    trk_curve *driver;
    assert_ok(c, trk_curve_create(c, "driver", 3, x, turned, NULL, &driver));
    o.link.damper_curve = driver;
    model = build(c, &o);
    assert_status(
        c, trk_model_linearise(c, model, COUNT, frequency, input, NULL, NULL, NULL, NULL, &out),
        TRK_E_MODEL);
    assert_message(c, "the mode of mass.z");
    trk_model_destroy(model);
    trk_curve_destroy(driver);
    trk_curve_destroy(damper);
    trk_curve_destroy(spring);

    /* an air spring thrown beyond its volume */
    trk_air_spring_options air;
    trk_law *law;
    trk_air_spring_options_init(&air, sizeof air);
    air.pressure = 6e5;
    air.volume = 0.009;
    air.area = 0.03;
    assert_ok(c, trk_law_create_air_spring(c, "air", &air, &law));
    o = oscillator_of(100, 0, 300);
    o.link.law = law;
    model = build(c, &o);
    for (int k = 0; k < COUNT; k++)
        input[2 * k] = 1e8;
    assert_status(
        c, trk_model_linearise(c, model, COUNT, frequency, input, NULL, NULL, NULL, NULL, &out),
        TRK_E_RANGE);
    assert_message(c, "link 'link' leaves what its law can do");
    trk_model_destroy(model);
    trk_law_destroy(law);
}

static trk_status linearise(trk_context *context)
{
    trk_spec *spec = NULL;
    trk_model *model = NULL, *linear = NULL;
    double frequency[] = {1, 2, 3}, input[2 * 3 * 2 * 2] = {0}, k[16], c[16], mean[16];
    for (int j = 0; j < 3; j++)
        input[8 * j] = 1e-5;
    trk_status status = trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_FRONT,
                                                   TRK_VARIANT_THESIS_DAMPERS, &spec);
    if (status == TRK_OK)
        status = trk_model_compile(context, spec, NULL, &model);
    if (status == TRK_OK)
        status =
            trk_model_linearise(context, model, 3, frequency, input, NULL, k, c, mean, &linear);
    trk_model_destroy(linear);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    return status;
}

static void test_lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(linearise);
}

int main(void)
{
    if (!trk_has_feature(TRK_FEATURE_LAPACK))
        return 0;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_cubic_spring_and_damper, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(test_dry_friction, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_mean_position, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_air_spring_holds_the_mean, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(test_beams_stay, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_limits, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_model_that_comes_out, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_relaxation_does_not_matter, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(test_errors, support_setup, support_teardown),
        cmocka_unit_test(test_lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
