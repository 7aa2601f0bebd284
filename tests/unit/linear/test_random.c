/* SPDX-License-Identifier: MIT */
/* Random response: closed forms, modes against direct solutions, roads, every error path. */
#include "models.h"
#include "vehicles.h"

#include "linalg/complex.h"
#include "linear/superposition.h"

/* Largest difference over the largest response, of all unit inputs at `count` frequencies. */
static double compare_with_direct(trk_superposition *s, int count)
{
    enum { MOST = MAXIMUM * 8 };
    double complex modal[MOST];
    double worst = 0;
    assert_true(s->n * s->inputs <= MOST);
    for (int k = 0; k < count; k++) {
        double omega = two_pi * 0.05 * pow(1e4, (double)k / count), largest = 0, difference = 0;
        assert_int_equal(trk_superposition_solve(s, omega), TRK_OK);
        memcpy(modal, s->q, (size_t)(s->n * s->inputs) * sizeof *modal);
        assert_int_equal(trk_superposition_solve_directly(s, omega), TRK_OK);
        for (int32_t i = 0; i < s->n * s->inputs; i++) {
            largest = fmax(largest, cabs(s->q[i]));
            difference = fmax(difference, cabs(s->q[i] - modal[i]));
        }
        worst = fmax(worst, difference / largest);
    }
    return worst;
}

static void test_modes_equal_direct_solution(void **state)
{
    for (trk_vehicle vehicle = 1; vehicle <= SUPPORT_VEHICLES; vehicle++)
        for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++) {
            trk_model *model = support_model(*state, vehicle, variant, 0);
            trk_superposition s;
            assert_ok(*state, trk_superposition_create(*state, model, NULL, NULL, &s));
            double difference = compare_with_direct(&s, 300);
            print_message("%s, %s: %.2g\n", support_vehicle_name(vehicle),
                          support_variant_name(variant), difference);
            assert_true(difference < 1e-10);
            assert_int_equal(s.direct, 300); /* those of the comparison itself */
            trk_superposition_clear(&s);
            trk_model_destroy(model);
        }
}

/* Critical damping makes two modes one; the answer does not suffer, it is solved for. */
static void test_defective_modes_fall_back(void **state)
{
    trk_spec *spec;
    trk_body_options body;
    trk_link_options link;
    assert_ok(*state, trk_spec_create(*state, "critical", &spec));
    trk_body_options_init(&body, sizeof body);
    trk_link_options_init(&link, sizeof link);
    body.mass = 1;
    assert_ok(*state, trk_spec_add_body(spec, "mass", &body, &link.to_body));
    assert_ok(*state, trk_spec_add_road(spec, "road", 0, 0, &link.from_road));
    link.stiffness = 4;
    link.damping = 4;
    assert_ok(*state, trk_spec_add_link(spec, "strut", &link, NULL));
    trk_model *model = compile(*state, spec);
    trk_superposition s;
    assert_ok(*state, trk_superposition_create(*state, model, NULL, NULL, &s));
    assert_true(compare_with_direct(&s, 100) < 1e-10);
    assert_true(s.direct > 100);
    assert_int_equal(trk_superposition_solve(&s, 3), TRK_OK);
    double complex wanted = trk_complex(4, 12) / trk_complex(4 - 9, 12);
    assert_true(cabs(s.q[0] - wanted) < 1e-14);
    trk_superposition_clear(&s);
    trk_model_destroy(model);
}

/* Quarter car without tire damping, the rate of the road white with one-sided PSD s. */
static void test_white_noise_variances(void **state)
{
    const double mass = 400, wheel = 50, k = 2e4, c = 1500, tire = 2e5, s = 1e-3;
    enum { COUNT = 60000 };
    trk_quarter_car_parameters p;
    trk_spec *spec;
    trk_quarter_car_parameters_init(&p, sizeof p);
    p.sprung_mass = mass;
    p.unsprung_mass = wheel;
    p.spring_stiffness = k;
    p.damping = c;
    p.tire_stiffness = tire;
    p.tire_damping = 0;
    assert_ok(*state, trk_vehicle_create_quarter_car(*state, &p, &spec));
    trk_sensor_options sensor;
    trk_sensor_options_init(&sensor, sizeof sensor);
    sensor.link = trk_spec_find(spec, TRK_PART_LINK, "damper");
    sensor.quantity = TRK_QUANTITY_ELONGATION;
    int32_t travel_id;
    assert_ok(*state, trk_spec_add_sensor(spec, "travel", &sensor, &travel_id));
    trk_model *model = compile(*state, spec);
    int32_t sensors = trk_model_count(model, TRK_PART_SENSOR);
    int32_t body_id = trk_model_find(model, TRK_PART_SENSOR, "sprung_z");
    double *frequency = calloc(COUNT, sizeof *frequency), *input = calloc(2 * COUNT, sizeof *input);
    double *density = calloc((size_t)(COUNT * sensors), sizeof *density), rms[16];
    for (int f = 0; f < COUNT; f++) {
        frequency[f] = 1e-5 * pow(1e10, f / (COUNT - 1.0));
        input[2 * f] = s / pow(two_pi * frequency[f], 2);
    }
    assert_ok(*state,
              trk_response_psd(*state, model, NULL, NULL, COUNT, frequency, input, density, rms));
    double sum = mass + wheel;
    double acceleration = s / 4 * (sum * k * k / (c * mass * mass) + tire * c / (mass * mass));
    double travel = s / 4 * sum / c;
    assert_near(pow(rms[body_id - 1], 2) / acceleration, 1, 1e-6);
    assert_near(pow(rms[travel_id - 1], 2) / travel, 1, 1e-6);
    free(frequency);
    free(input);
    free(density);
    trk_model_destroy(model);
}

/* One signal that reaches the wheels with gains and delays: S_y is |H|^2 of the response to it. */
static void test_equals_frequency_response(void **state)
{
    trk_model *model = builtin(*state, TRK_VEHICLE_REFERENCE_TRUCK);
    enum { COUNT = 40, MOST = 64 };
    int32_t roads = trk_model_count(model, TRK_PART_ROAD),
            ports = trk_model_count(model, TRK_PART_PORT), inputs = roads + ports,
            sensors = trk_model_count(model, TRK_PART_SENSOR);
    double gain[8], delay[8] = {0}, load[8], frequency[COUNT], density[COUNT * MOST];
    double response[2 * COUNT * MOST], *input = calloc((size_t)(2 * COUNT * inputs * inputs), 8);
    assert_true(sensors <= MOST);
    for (int32_t j = 0; j < roads; j++) {
        gain[j] = 1 - 0.3 * j;
        delay[j] = 0.05 * j;
    }
    for (int32_t j = 0; j < ports; j++)
        load[j] = 1e4 * (j + 1);
    for (int f = 0; f < COUNT; f++) {
        frequency[f] = 0.5 * (f + 1);
        for (int32_t i = 0; i < inputs; i++)
            for (int32_t j = 0; j < inputs; j++) {
                double complex u[2];
                for (int a = 0; a < 2; a++) {
                    int32_t at = a == 0 ? i : j;
                    double angle = at < roads ? -two_pi * frequency[f] * delay[at] : 0;
                    u[a] = (at < roads ? gain[at] : load[at - roads]) *
                           trk_complex(cos(angle), sin(angle));
                }
                double complex cross = conj(u[0]) * u[1];
                double *entry = input + 2 * ((f * inputs + i) * inputs + j);
                entry[0] = creal(cross);
                entry[1] = cimag(cross);
            }
    }
    assert_ok(*state,
              trk_response_psd(*state, model, NULL, NULL, COUNT, frequency, input, density, NULL));
    assert_ok(*state, trk_frequency_response(*state, model, NULL, NULL, COUNT, frequency, gain,
                                             delay, load, response));
    for (int32_t k = 0; k < sensors; k++) {
        double peak = 0;
        for (int f = 0; f < COUNT; f++)
            peak = fmax(peak, density[k * COUNT + f]);
        for (int f = 0; f < COUNT; f++) {
            const double *h = response + 2 * (f * sensors + k);
            assert_near(density[k * COUNT + f], h[0] * h[0] + h[1] * h[1], 1e-10 * peak);
        }
    }
    free(input);
    trk_model_destroy(model);
}

static void test_road_spectra(void **state)
{
    trk_model *model = builtin(*state, TRK_VEHICLE_REFERENCE_TRUCK);
    int32_t roads = trk_model_count(model, TRK_PART_ROAD),
            inputs = roads + trk_model_count(model, TRK_PART_PORT);
    double frequency = 1.7, density = 3e-4, speed = 20, coherence = 0.4, out[2 * 16 * 16];
    assert_true(inputs <= 16);
    assert_ok(*state, trk_road_cross_spectra(*state, model, 1, &frequency, &density, speed,
                                             &coherence, out));
    for (int32_t i = 0; i < inputs; i++)
        for (int32_t j = 0; j < inputs; j++) {
            const double *s = out + 2 * (i * inputs + j);
            if (i >= roads || j >= roads) {
                assert_true(s[0] == 0 && s[1] == 0);
                continue;
            }
            double x[2], y[2];
            assert_int_equal(trk_model_get_road_place(model, i + 1, &x[0], &y[0]), TRK_OK);
            assert_int_equal(trk_model_get_road_place(model, j + 1, &x[1], &y[1]), TRK_OK);
            /* the wheel in front leads: input j lags input i by (x_i - x_j) / speed */
            double lag = two_pi * frequency * (x[0] - x[1]) / speed;
            double size = density * (y[0] * y[1] > 0 ? 1 : 0.4);
            assert_near(s[0], size * cos(lag), 1e-18);
            assert_near(s[1], -size * sin(lag), 1e-18);
        }
    const double bad[] = {-1, NAN, INFINITY};
    for (int k = 0; k < 3; k++) {
        assert_status(*state,
                      trk_road_cross_spectra(*state, model, 1, &bad[k], &density, speed, NULL, out),
                      TRK_E_RANGE);
        assert_status(
            *state, trk_road_cross_spectra(*state, model, 1, &frequency, &bad[k], speed, NULL, out),
            TRK_E_RANGE);
        assert_status(
            *state,
            trk_road_cross_spectra(*state, model, 1, &frequency, &density, bad[k], NULL, out),
            TRK_E_RANGE);
        assert_status(
            *state,
            trk_road_cross_spectra(*state, model, 1, &frequency, &density, speed, &bad[k], out),
            TRK_E_RANGE);
    }
    assert_status(*state,
                  trk_road_cross_spectra(*state, NULL, 1, &frequency, &density, speed, NULL, out),
                  TRK_E_ARGUMENT);
    trk_model_destroy(model);
}

/* A road of ISO 8608 in one call, from standstill of the waves to beyond its band. */
static void test_road_by_options(void **state)
{
    enum { COUNT = 40 };
    trk_model *model = builtin(*state, TRK_VEHICLE_REFERENCE_TRUCK);
    const int32_t inputs =
        trk_model_count(model, TRK_PART_ROAD) + trk_model_count(model, TRK_PART_PORT);
    const double speed = 80 / 3.6;
    double f[COUNT], n[COUNT], density[COUNT], coherence[COUNT];
    double out[2 * COUNT * 8 * 8], expected[2 * COUNT * 8 * 8];
    assert_true(inputs <= 8);
    trk_road_options road;
    trk_road_options_init(&road, sizeof road);
    road.unevenness = trk_road_class_unevenness(TRK_ROAD_CLASS_C);
    road.contact_length = 0.2;
    for (int k = 0; k < COUNT; k++) {
        f[k] = 2 * k; /* 0 Hz, too */
        n[k] = f[k] / speed;
    }
    assert_ok(*state, trk_road_density(*state, &road, COUNT, n, density));
    assert_ok(*state, trk_road_coherence(*state, &road, COUNT, n, coherence));
    for (int k = 0; k < COUNT; k++)
        density[k] /= speed;
    assert_ok(*state,
              trk_road_cross_spectra(*state, model, COUNT, f, density, speed, coherence, expected));
    assert_ok(*state, trk_road_input_spectra(*state, model, &road, speed, COUNT, f, out));
    assert_memory_equal(out, expected, sizeof(double) * 2 * COUNT * (size_t)(inputs * inputs));
    assert_true(out[0] == 0 && out[2 * inputs * inputs] > 0);
    assert_true(out[2 * (COUNT - 1) * inputs * inputs] == 0); /* 3.5 cycles/m */
    /* a finite density at 0 Hz is one, in phase under all wheels */
    const double still = 0, one = 1;
    assert_ok(*state, trk_road_cross_spectra(*state, model, 1, &still, &one, speed, NULL, out));
    for (int32_t k = 0; k < trk_model_count(model, TRK_PART_ROAD); k++)
        assert_true(out[2 * k] == 1 && out[2 * k + 1] == 0);

    assert_ok(*state, trk_road_input_spectra(*state, model, NULL, speed, COUNT, f, out));
    static const double bad[] = {-1, NAN, INFINITY};
    for (int k = 0; k < 3; k++) {
        assert_status(*state, trk_road_input_spectra(*state, model, &road, bad[k], 1, f, out),
                      TRK_E_RANGE);
        assert_message(*state, "speed is");
        assert_status(*state, trk_road_input_spectra(*state, model, &road, speed, 1, &bad[k], out),
                      TRK_E_RANGE);
        assert_message(*state, "frequency[0] is");
    }
    assert_status(*state, trk_road_input_spectra(*state, model, &road, 0, 1, f, out), TRK_E_RANGE);
    assert_status(*state, trk_road_input_spectra(*state, model, &road, speed, -1, f, out),
                  TRK_E_RANGE);
    road.waviness = 9;
    assert_status(*state, trk_road_input_spectra(*state, model, &road, speed, 1, f, out),
                  TRK_E_RANGE);
    assert_message(*state, "waviness is 9");
    assert_status(NULL, trk_road_input_spectra(NULL, model, NULL, speed, 1, f, out),
                  TRK_E_ARGUMENT);
    assert_status(*state, trk_road_input_spectra(*state, NULL, NULL, speed, 1, f, out),
                  TRK_E_ARGUMENT);
    assert_status(*state, trk_road_input_spectra(*state, model, NULL, speed, 1, NULL, out),
                  TRK_E_ARGUMENT);
    assert_status(*state, trk_road_input_spectra(*state, model, NULL, speed, 1, f, NULL),
                  TRK_E_ARGUMENT);
    trk_model_destroy(model);
}

/* RMS values alone are those that come with the spectra. */
static void test_rms_without_spectra(void **state)
{
    enum { COUNT = 50 };
    trk_model *model = builtin(*state, TRK_VEHICLE_REFERENCE_FRONT);
    double f[COUNT], input[2 * COUNT * 4 * 4], density[COUNT * 8], with[8], without[8];
    const int32_t sensors = trk_model_count(model, TRK_PART_SENSOR);
    assert_true(sensors <= 8);
    for (int k = 0; k < COUNT; k++)
        f[k] = 0.3 * (k + 1);
    assert_ok(*state, trk_road_input_spectra(*state, model, NULL, 20, COUNT, f, input));
    assert_ok(*state, trk_response_psd(*state, model, NULL, NULL, COUNT, f, input, density, with));
    assert_ok(*state, trk_response_psd(*state, model, NULL, NULL, COUNT, f, input, NULL, without));
    for (int32_t k = 0; k < sensors; k++)
        assert_true(with[k] == without[k] && with[k] > 0);
    trk_model_destroy(model);
}

static void test_errors(void **state)
{
    trk_model *model = builtin(*state, TRK_VEHICLE_REFERENCE_FRONT);
    double frequency[] = {1, 2}, input[2 * 2 * 4 * 4] = {0}, out[64], bad[] = {2, 1};
    assert_status(*state,
                  trk_response_psd(*state, NULL, NULL, NULL, 2, frequency, input, out, NULL),
                  TRK_E_ARGUMENT);
    assert_status(*state, trk_response_psd(*state, model, NULL, NULL, 2, NULL, input, out, NULL),
                  TRK_E_ARGUMENT);
    assert_status(*state,
                  trk_response_psd(*state, model, NULL, NULL, 2, frequency, NULL, out, NULL),
                  TRK_E_ARGUMENT);
    assert_status(*state,
                  trk_response_psd(*state, model, NULL, NULL, 2, frequency, input, NULL, NULL),
                  TRK_E_ARGUMENT);
    assert_status(*state,
                  trk_response_psd(*state, model, NULL, NULL, 0, frequency, input, out, NULL),
                  TRK_E_RANGE);
    assert_status(*state, trk_response_psd(*state, model, NULL, NULL, 2, bad, input, out, NULL),
                  TRK_E_RANGE);
    assert_message(*state, "frequency[1] is 1 Hz");
    double place[] = {NAN, 0};
    assert_status(*state,
                  trk_response_psd(*state, model, place, NULL, 2, frequency, input, out, NULL),
                  TRK_E_RANGE);
    input[0] = -1;
    assert_status(*state,
                  trk_response_psd(*state, model, NULL, NULL, 2, frequency, input, out, NULL),
                  TRK_E_RANGE);
    assert_message(*state, "the PSD of input 1 at 1 Hz is -1");
    input[0] = NAN;
    assert_status(*state,
                  trk_response_psd(*state, model, NULL, NULL, 2, frequency, input, out, NULL),
                  TRK_E_RANGE);
    assert_message(*state, "input[0] is");
    trk_model_destroy(model);
}

static trk_status respond(trk_context *context)
{
    trk_spec *spec = NULL;
    trk_model *model = NULL;
    double frequency[] = {1, 2}, input[2 * 2 * 4 * 4] = {1}, out[64], rms[16];
    trk_status status =
        trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_FRONT, TRK_VARIANT_LINEAR, &spec);
    if (status == TRK_OK)
        status = trk_model_compile(context, spec, NULL, &model);
    if (status == TRK_OK)
        status = trk_response_psd(context, model, NULL, NULL, 2, frequency, input, out, rms);
    if (status == TRK_OK)
        status = trk_road_cross_spectra(context, model, 2, frequency, frequency, 20, NULL, input);
    if (status == TRK_OK)
        status = trk_road_input_spectra(context, model, NULL, 20, 2, frequency, input);
    if (status == TRK_OK)
        status = trk_response_psd(context, model, NULL, NULL, 2, frequency, input, NULL, rms);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    return status;
}

static void test_lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(respond);
}

int main(void)
{
    if (!trk_has_feature(TRK_FEATURE_LAPACK))
        return 0;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_modes_equal_direct_solution, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(test_defective_modes_fall_back, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(test_white_noise_variances, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(test_equals_frequency_response, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(test_road_spectra, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_road_by_options, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_rms_without_spectra, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_errors, support_setup, support_teardown),
        cmocka_unit_test(test_lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
