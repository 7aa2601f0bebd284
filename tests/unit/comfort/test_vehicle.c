/* SPDX-License-Identifier: MIT */
/* Tire loads, travel, and the free oscillation after a drop, measured and simulated. */
#include "support.h"
#include "vehicles.h"

#include <truckride/comfort.h>

static const double pi = 3.14159265358979323846;

static void loads(void **state)
{
    trk_context *c = *state;
    enum { N = 1000 };
    double left[N], right[N], load[N];
    for (int i = 0; i < N; i++) {
        left[i] = 1000 * sin(2 * pi * i / 100);
        right[i] = 3000 * sin(2 * pi * i / 100);
    }
    const double *force[] = {left, right};
    trk_load_numbers n = {.struct_size = sizeof n};
    assert_ok(c, trk_axle_load(c, 2, N, force, 20000, load));
    assert_near(load[25], 16000, 1e-9); /* tension unloads */
    assert_ok(c, trk_load_measure(c, N, load, &n));
    assert_near(n.mean, 20000, 1e-9);
    assert_near(n.dynamic_load_coefficient, 0.2 / sqrt(2), 1e-14);
    assert_near(n.maximum, 24000, 1e-9);
    assert_near(n.minimum, 16000, 1e-9);
    assert_near(n.impact_factor, 1.2, 1e-13);
    assert_near(n.lift_off, 0, 0);
    assert_ok(c, trk_axle_load(c, 1, N, force, 500, load));
    for (int i = 0; i < N; i++)
        load[i] = fmax(load[i], 0);
    assert_ok(c, trk_load_measure(c, N, load,
                                  &n)); /* sine above 1/2: 60 degrees either side of the top */
    assert_near(n.lift_off, 1.0 / 3, 0.01);
}

static void load_errors(void **state)
{
    trk_context *c = *state;
    double x[2] = {1, NAN}, y[2] = {1, 2};
    const double *force[] = {y, NULL}, *bad[] = {x};
    trk_load_numbers n = {.struct_size = sizeof n};
    assert_status(c, trk_axle_load(NULL, 1, 2, force, 0, y), TRK_E_ARGUMENT);
    assert_status(c, trk_axle_load(c, 1, 2, NULL, 0, y), TRK_E_ARGUMENT);
    assert_status(c, trk_axle_load(c, 1, 2, force, 0, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_axle_load(c, 2, 2, force, 0, x), TRK_E_ARGUMENT);
    assert_status(c, trk_axle_load(c, 0, 2, force, 0, y), TRK_E_RANGE);
    assert_status(c, trk_axle_load(c, 1, -1, force, 0, y), TRK_E_RANGE);
    assert_status(c, trk_axle_load(c, 1, 2, bad, 0, y), TRK_E_RANGE);
    assert_message(c, "force[1] is nan");
    assert_status(c, trk_axle_load(c, 1, 2, force, INFINITY, y), TRK_E_RANGE);
    assert_status(c, trk_load_measure(NULL, 2, y, &n), TRK_E_ARGUMENT);
    assert_status(c, trk_load_measure(c, 2, NULL, &n), TRK_E_ARGUMENT);
    assert_status(c, trk_load_measure(c, 2, y, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_load_measure(c, 0, y, &n), TRK_E_RANGE);
    assert_status(c, trk_load_measure(c, 2, x, &n), TRK_E_RANGE);
    y[0] = -5;
    assert_status(c, trk_load_measure(c, 2, y, &n), TRK_E_RANGE);
    assert_message(c, "is the static load missing?");
    n.struct_size = 3;
    assert_status(c, trk_load_measure(c, 2, y, &n), TRK_E_OPTIONS);
}

static void travel(void **state)
{
    trk_context *c = *state;
    enum { N = 1001 };
    double x[N], out[5];
    for (int i = 0; i < N; i++)
        x[i] = (i * 389 % N) * 1e-4 - 0.02; /* 0 .. 1000 in disorder */
    const double percent[] = {0, 5, 50, 99.95, 100};
    trk_travel_numbers n = {.struct_size = sizeof n};
    assert_ok(c, trk_travel_measure(c, N, x, &n, 5, percent, out));
    const double wanted[] = {-0.02, -0.015, 0.03, 0.07995, 0.08};
    for (int k = 0; k < 5; k++)
        assert_near(out[k], wanted[k], 1e-15);
    assert_near(n.mean, 0.03, 1e-15);
    assert_near(n.rms, 1e-4 * sqrt((N * (double)N - 1) / 12), 1e-15);
    assert_near(n.minimum, -0.02, 0);
    assert_near(n.peak_to_peak, 0.1, 1e-15);
    assert_ok(c, trk_travel_measure(c, 1, x, &n, 5, percent, out));
    assert_true(n.rms == 0 && out[2] == x[0]);
    assert_ok(c, trk_travel_measure(c, N, x, NULL, 0, NULL, NULL));
}

static void travel_errors(void **state)
{
    trk_context *c = *state;
    double x[2] = {1, 2}, bad[2] = {1, INFINITY}, out[1], percent[1] = {101};
    trk_travel_numbers n = {.struct_size = sizeof n};
    assert_status(c, trk_travel_measure(NULL, 2, x, &n, 0, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_travel_measure(c, 2, NULL, &n, 0, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_travel_measure(c, 2, x, &n, 1, NULL, out), TRK_E_ARGUMENT);
    assert_status(c, trk_travel_measure(c, 2, x, &n, 1, percent, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_travel_measure(c, 2, x, &n, 1, percent, out), TRK_E_RANGE);
    assert_message(c, "percent[0] is 101");
    assert_status(c, trk_travel_measure(c, 2, x, &n, -1, percent, out), TRK_E_RANGE);
    assert_status(c, trk_travel_measure(c, 0, x, &n, 0, NULL, NULL), TRK_E_RANGE);
    assert_status(c, trk_travel_measure(c, 2, bad, &n, 0, NULL, NULL), TRK_E_RANGE);
    n.struct_size = 0;
    assert_status(c, trk_travel_measure(c, 2, x, &n, 0, NULL, NULL), TRK_E_OPTIONS);
}

/* x = rest + A exp(-D w0 t) cos(wd t + phase): every number is known. */
static void decaying_cosine(void **state)
{
    trk_context *c = *state;
    enum { N = 4000 };
    static double x[N];
    trk_axle_transient t = {.struct_size = sizeof t};
    for (double d = 0.02; d < 0.55; d += 0.06)
        for (double f0 = 1.1; f0 < 2.6; f0 += 0.7)
            for (double sign = -1; sign <= 1; sign += 2) {
                if (sign < 0 && d > 0.4)
                    continue; /* starts in compression: its second peak inside is lost in noise */
                double w0 = 2 * pi * f0, wd = w0 * sqrt(1 - d * d);
                for (int i = 0; i < N; i++)
                    x[i] = 0.01 + sign * 0.08 * exp(-d * w0 * i * 1e-3) * cos(wd * i * 1e-3);
                assert_ok(c, trk_axle_transient_measure(c, N, x, 1000, 0.01, &t));
                assert_near(t.damping_ratio, d, 2e-5);
                assert_near(t.frequency, f0, 2e-4);
                assert_near(t.damped_frequency, wd / (2 * pi), 2e-4);
                assert_near(t.second_amplitude / t.first_amplitude,
                            exp(-2 * pi * d / sqrt(1 - d * d)), 1e-5);
            }
}

/* Small ripple about the level of rest and on the flanks is no peak. */
static void ripple_is_no_peak(void **state)
{
    trk_context *c = *state;
    enum { N = 4000 };
    static double x[N];
    trk_axle_transient t = {.struct_size = sizeof t};
    for (int i = 0; i < N; i++)
        x[i] = 0.08 * exp(-2 * i * 1e-3) * cos(10 * i * 1e-3) + 1e-4 * sin(300 * i * 1e-3);
    assert_ok(c, trk_axle_transient_measure(c, N, x, 1000, 0, &t));
    assert_near(t.damped_frequency, 10 / (2 * pi), 0.05);
    assert_near(t.damping_ratio, 2 / sqrt(104), 0.01);
}

static void transient_errors(void **state)
{
    trk_context *c = *state;
    double x[5] = {0, -1, 0.5, -2, 0.1}, bad[3] = {1, NAN, 1};
    trk_axle_transient t = {.struct_size = sizeof t};
    assert_status(c, trk_axle_transient_measure(NULL, 5, x, 1, 0, &t), TRK_E_ARGUMENT);
    assert_status(c, trk_axle_transient_measure(c, 5, NULL, 1, 0, &t), TRK_E_ARGUMENT);
    assert_status(c, trk_axle_transient_measure(c, 5, x, 1, 0, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_axle_transient_measure(c, 2, x, 1, 0, &t), TRK_E_RANGE);
    assert_status(c, trk_axle_transient_measure(c, 3, bad, 1, 0, &t), TRK_E_RANGE);
    assert_status(c, trk_axle_transient_measure(c, 5, x, 0, 0, &t), TRK_E_RANGE);
    assert_status(c, trk_axle_transient_measure(c, 5, x, 1, NAN, &t), TRK_E_RANGE);
    assert_status(c, trk_axle_transient_measure(c, 5, x, 1, 0, &t), TRK_E_RANGE); /* grows */
    assert_message(c, "2 compression peaks, expected two of falling height");
    assert_status(c, trk_axle_transient_measure(c, 3, x, 1, 0, &t), TRK_E_RANGE);
    assert_message(c, "1 compression peaks");
    double zero[4] = {0};
    assert_status(c, trk_axle_transient_measure(c, 4, zero, 1, 0, &t), TRK_E_RANGE);
    t.struct_size = 1;
    assert_status(c, trk_axle_transient_measure(c, 5, x, 1, 0, &t), TRK_E_OPTIONS);
}

static void friendliness(void **state)
{
    (void)state;
    assert_int_equal(trk_road_friendliness(2.0, 0.21, 0.1), 0);
    assert_int_equal(trk_road_friendliness(2.01, 0.21, 0.1), TRK_UNFRIENDLY_FREQUENCY);
    assert_int_equal(trk_road_friendliness(1.5, 0.2, 0.1), TRK_UNFRIENDLY_DAMPING);
    assert_int_equal(trk_road_friendliness(1.5, 0.3, 0.16), TRK_UNFRIENDLY_DAMPERS);
    assert_int_equal(trk_road_friendliness(NAN, NAN, NAN), 7);
    assert_int_equal(trk_road_friendliness(1.5, 0.3, NAN), TRK_UNFRIENDLY_DAMPERS);
}

/* Mass on one spring to the road: the drop is a free oscillation with known D and frequency. */
static trk_model *sprung_mass(trk_context *c, double damping)
{
    trk_spec *spec;
    int32_t body, road;
    assert_ok(c, trk_spec_create(c, "mass", &spec));
    trk_body_options b;
    trk_body_options_init(&b, sizeof b);
    b.mass = 1000;
    assert_ok(c, trk_spec_add_body(spec, "mass", &b, &body));
    assert_ok(c, trk_spec_add_road(spec, "road", 0, 0, &road));
    trk_link_options l;
    trk_link_options_init(&l, sizeof l);
    l.from_road = road;
    l.to_body = body;
    l.stiffness = 1000 * 100; /* 10 rad/s */
    l.damping = damping * 2 * 1000 * 10;
    assert_ok(c, trk_spec_add_link(spec, "spring", &l, NULL));
    trk_model *model;
    assert_ok(c, trk_model_compile(c, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

static void drop_of_one_mass(void **state)
{
    trk_context *c = *state;
    const int32_t road[] = {1};
    for (double d = 0.05; d < 0.45; d += 0.1) {
        trk_model *model = sprung_mass(c, d);
        trk_axle_transient t = {.struct_size = sizeof t};
        assert_ok(c, trk_axle_drop(c, model, 1, road, 1, NULL, &t));
        assert_near(t.damping_ratio, d, 2e-3);
        assert_near(t.frequency, 10 / (2 * pi), 2e-3);
        trk_model_destroy(model);
    }
}

/* On a soft spring the body of a quarter car oscillates near the mode of body and tire. */
static void drop_of_the_reference_truck(void **state)
{
    trk_context *c = *state;
    trk_model *model = support_model(c, TRK_VEHICLE_REFERENCE_FRONT, TRK_VARIANT_LINEAR, 0);
    const int32_t road[] = {1};
    int32_t measured = 0;
    for (int32_t link = 1; link <= trk_model_count(model, TRK_PART_LINK); link++) {
        double b[8], g[8];
        assert_ok(c, trk_model_get_link_row(model, link, b, g));
        if (g[0] != 0)
            continue; /* the tire */
        trk_axle_transient t = {.struct_size = sizeof t};
        assert_ok(c, trk_axle_drop(c, model, 1, road, link, NULL, &t));
        assert_true(t.frequency > 0.8 && t.frequency < 3);
        assert_true(t.damping_ratio > 0.02 && t.damping_ratio < 0.6);
        measured++;
    }
    assert_true(measured > 0);
    trk_model_destroy(model);
}

/* Dampers at a fifth: the axle hops on its tire for long, and its peaks are not those asked for. */
static void hop_is_not_taken_for_bounce(void **state)
{
    trk_context *c = *state;
    trk_spec *spec = support_spec(c, TRK_VEHICLE_REFERENCE_REAR, TRK_VARIANT_THESIS_DAMPERS);
    assert_ok(c, trk_spec_vary(spec, TRK_FIELD_DAMPING, "*damper*", TRK_MEANING_FACTOR, 0.2, NULL));
    trk_model *model;
    assert_ok(c, trk_model_compile(c, spec, NULL, &model));
    trk_axle_transient t = {.struct_size = sizeof t, .frequency = 4711};
    const int32_t road[] = {1};
    int32_t link = trk_model_find(model, TRK_PART_LINK, "spring");
    assert_true(link > 0);
    assert_status(c, trk_axle_drop(c, model, 1, road, link, NULL, &t), TRK_E_RANGE);
    assert_message(c, "wheel hop");
    assert_near(t.frequency, 4711, 0);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
}

static void drop_errors(void **state)
{
    trk_context *c = *state;
    trk_model *model = sprung_mass(c, 0.2);
    const int32_t road[] = {1}, none[] = {2};
    trk_axle_transient t = {.struct_size = sizeof t};
    trk_axle_drop_options o;
    trk_axle_drop_options_init(&o, sizeof o);
    assert_near(o.height, 0.08, 0);
    assert_status(c, trk_axle_drop(NULL, model, 1, road, 1, NULL, &t), TRK_E_ARGUMENT);
    assert_status(c, trk_axle_drop(c, NULL, 1, road, 1, NULL, &t), TRK_E_ARGUMENT);
    assert_status(c, trk_axle_drop(c, model, 1, NULL, 1, NULL, &t), TRK_E_ARGUMENT);
    assert_status(c, trk_axle_drop(c, model, 1, road, 1, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_axle_drop(c, model, 0, road, 1, NULL, &t), TRK_E_ARGUMENT);
    assert_status(c, trk_axle_drop(c, model, 1, none, 1, NULL, &t), TRK_E_ARGUMENT);
    assert_message(c, "no road 2, expected 1 to 1");
    assert_status(c, trk_axle_drop(c, model, 1, road, 2, NULL, &t), TRK_E_ARGUMENT);
    assert_message(c, "no link 2");
    const double bad[][3] = {
        {0, 10, 0.001}, {0.08, NAN, 0.001}, {0.08, 10, 0}, {0.08, 1, 0.1}, {0.08, 1e9, 0.001}};
    for (int k = 0; k < 5; k++) {
        o.height = bad[k][0];
        o.duration = bad[k][1];
        o.step = bad[k][2];
        assert_status(c, trk_axle_drop(c, model, 1, road, 1, &o, &t), TRK_E_RANGE);
    }
    o.struct_size = 1;
    assert_status(c, trk_axle_drop(c, model, 1, road, 1, &o, &t), TRK_E_OPTIONS);
    t.struct_size = 0;
    assert_status(c, trk_axle_drop(c, model, 1, road, 1, NULL, &t), TRK_E_OPTIONS);
    t.struct_size = sizeof t;
    trk_model *dead = sprung_mass(c, 2);
    assert_status(c, trk_axle_drop(c, dead, 1, road, 1, NULL, &t), TRK_E_RANGE);
    assert_message(c, "0 compression peaks");
    trk_model_destroy(dead);
    trk_model_destroy(model);
}

static trk_status use_memory(trk_context *c)
{
    double x[3] = {1, 2, 3}, percent[1] = {50}, out[1];
    return trk_travel_measure(c, 3, x, NULL, 1, percent, out);
}

static const trk_model *borrowed;

static trk_status use_memory_for_a_drop(trk_context *c)
{
    const int32_t road[] = {1};
    trk_axle_transient t = {.struct_size = sizeof t};
    return trk_axle_drop(c, borrowed, 1, road, 1, NULL, &t);
}

static void memory_runs_out(void **state)
{
    trk_context *c = *state;
    trk_model *model = sprung_mass(c, 0.2);
    borrowed = model;
    support_exhaust_memory(use_memory);
    support_exhaust_memory(use_memory_for_a_drop);
    trk_model_destroy(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(loads, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(load_errors, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(travel, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(travel_errors, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(decaying_cosine, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(ripple_is_no_peak, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(transient_errors, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(friendliness, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(drop_of_one_mass, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(drop_of_the_reference_truck, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(hop_is_not_taken_for_bounce, support_setup,
                                        support_teardown),
        cmocka_unit_test_setup_teardown(drop_errors, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(memory_runs_out, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
