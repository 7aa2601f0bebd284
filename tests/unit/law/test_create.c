/* SPDX-License-Identifier: MIT */
/* Life of a law: refused values, reading back, copies, scaled copies, memory, traces. */
#include "support.h"

#include "law/law.h"

static trk_curve *rubber(trk_context *context, double at_zero, double lowest, double last)
{
    const double x[] = {-0.01, 0, 0.01, 0.02, 0.03};
    const double y[] = {-10, at_zero, 1000 + lowest, lowest, last};
    trk_curve_options o;
    trk_curve *curve;
    trk_curve_options_init(&o, sizeof o);
    o.interpolation = TRK_INTERPOLATION_LINEAR;
    assert_ok(context, trk_curve_create(context, "rubber", 5, x, y, &o, &curve));
    return curve;
}

/* One refused value: the status and what the message says. */
#define REFUSE(kind, field, value, text)                                                           \
    do {                                                                                           \
        trk_law *law = (trk_law *)1;                                                               \
        trk_##kind##_options bad = good;                                                           \
        bad.field = (value);                                                                       \
        assert_status(context, trk_law_create_##kind(context, "x", &bad, &law), TRK_E_RANGE);      \
        assert_message(context, text);                                                             \
        assert_null(law);                                                                          \
    } while (0)

static void tire_refuses(void **state)
{
    trk_context *context = *state;
    trk_tire_options good;
    trk_tire_options_init(&good, sizeof good);
    REFUSE(tire, damping, 1, "tire 'x': stiffness and stiffening are 0");
    good.stiffness = 1e6;
    REFUSE(tire, stiffness, -1, "stiffness is -1");
    REFUSE(tire, stiffness, INFINITY, "stiffness is inf");
    REFUSE(tire, stiffening, -1, "stiffening is -1");
    REFUSE(tire, damping, NAN, "damping is nan");
    REFUSE(tire, preload, -1, "tire 'x': preload is -1; a finite number >= 0 is needed");
}

static void stops_refuse(void **state)
{
    trk_context *context = *state;
    trk_stops_options good;
    trk_stops_options_init(&good, sizeof good);
    REFUSE(stops, bump_clearance, -1, "bump_clearance is -1");
    REFUSE(stops, bump_stiffness, -1, "bump_stiffness is -1");
    REFUSE(stops, rebound_clearance, NAN, "rebound_clearance is nan");
    REFUSE(stops, rebound_stiffness, -1, "stops 'x': rebound_stiffness is -1");
    trk_curve *preloaded = rubber(context, 5, 0, 2000), *pulls = rubber(context, 0, -5, 2000),
              *falls = rubber(context, 0, 2000, 1500);
    REFUSE(stops, bump_curve, preloaded, "bump_curve is 5 at 0; 0 is needed");
    REFUSE(stops, rebound_curve, pulls, "rebound_curve falls to -5 between 0.01 and 0.02");
    REFUSE(stops, bump_curve, falls, "bump_curve falls beyond its last point, slope -50000");
    trk_curve_destroy(preloaded);
    trk_curve_destroy(pulls);
    trk_curve_destroy(falls);
}

/* A cubic that dips below zero only between its points is found too. */
static void stops_refuse_a_dip_between_points(void **state)
{
    trk_context *context = *state;
    const double x[] = {0, 0.01, 0.02, 0.021}, y[] = {0, 1, 1, 2000};
    trk_curve_options o;
    trk_curve *curve;
    trk_stops_options good;
    trk_curve_options_init(&o, sizeof o);
    o.interpolation = TRK_INTERPOLATION_NATURAL;
    assert_ok(context, trk_curve_create(context, "spline", 4, x, y, &o, &curve));
    double lowest = 0;
    for (int k = 0; k <= 100000; k++)
        lowest = fmin(lowest, trk_curve_value(curve, 0.021 * k / 100000));
    char text[64];
    snprintf(text, sizeof text, "falls to %d.", (int)lowest);
    assert_true(lowest < -1);
    trk_stops_options_init(&good, sizeof good);
    REFUSE(stops, bump_curve, curve, text);
    trk_curve_destroy(curve);
}

static void friction_laws_refuse(void **state)
{
    trk_context *context = *state;
    {
        trk_leaf_options good;
        trk_leaf_options_init(&good, sizeof good);
        good.friction = 100;
        good.approach_bump = 0.001;
        REFUSE(leaf, friction, 0, "leaf spring 'x': friction is 0; a finite number > 0");
        REFUSE(leaf, friction_slope, -1, "friction_slope is -1");
        REFUSE(leaf, approach_bump, 0, "approach_bump is 0");
        REFUSE(leaf, approach_rebound, -1, "approach_rebound is -1");
        good.friction_slope = 1e6;
        REFUSE(leaf, approach_rebound, 0.002, "friction is 100; with this slope");
    }
    {
        trk_friction_options good;
        trk_friction_options_init(&good, sizeof good);
        good.friction = 100;
        good.stiffness = 1e5;
        REFUSE(friction, friction, 0, "dry friction 'x': friction is 0");
        REFUSE(friction, stiffness, INFINITY, "stiffness is inf");
    }
    {
        trk_seal_options good;
        trk_seal_options_init(&good, sizeof good);
        good.sliding = 100;
        REFUSE(seal, sliding, -1, "sliding is -1");
        REFUSE(seal, breakaway, -1, "breakaway is -1");
        REFUSE(seal, breakaway, 99, "seal 'x': breakaway is 99; at least sliding, 100");
        REFUSE(seal, stribeck, 0, "stribeck is 0");
        REFUSE(seal, creep, 0, "creep is 0");
    }
}

static void air_spring_refuses(void **state)
{
    trk_context *context = *state;
    trk_air_spring_options good;
    trk_air_spring_options_init(&good, sizeof good);
    good.pressure = 5e5;
    good.volume = 0.01;
    good.area = 0.04;
    REFUSE(air_spring, pressure, 0, "pressure is 0");
    REFUSE(air_spring, pressure, 101325, "pressure is 101325, absolute; more than ambient");
    REFUSE(air_spring, volume, 0, "volume is 0");
    REFUSE(air_spring, area, -1, "area is -1");
    REFUSE(air_spring, area_slope, NAN, "area_slope is nan");
    REFUSE(air_spring, exponent, 0.99, "exponent is 0.99; 1 to 1.6 is needed");
    REFUSE(air_spring, exponent, 1.61, "exponent is 1.61");
    REFUSE(air_spring, ambient, 0, "ambient is 0");
    REFUSE(air_spring, auxiliary_volume, -1, "auxiliary_volume is -1");
    REFUSE(air_spring, conductance, -1, "conductance is -1");
    REFUSE(air_spring, temperature, 0, "air spring 'x': temperature is 0");
}

/* One of each kind, every option set. */
typedef struct zoo {
    trk_law *law[6];
} zoo;

static trk_status fill(trk_context *context, trk_curve *curve, zoo *z)
{
    trk_tire_options tire;
    trk_stops_options stops;
    trk_leaf_options leaf;
    trk_friction_options friction;
    trk_air_spring_options air;
    trk_seal_options seal;
    trk_tire_options_init(&tire, sizeof tire);
    tire = (trk_tire_options){sizeof tire, 1e6, 2e6, 500, 3e4};
    stops = (trk_stops_options){sizeof stops, 0.04, 1e5, curve, 0.03, 2e5, curve};
    leaf = (trk_leaf_options){sizeof leaf, 2500, 1e4, 0.002, 0.001};
    friction = (trk_friction_options){sizeof friction, 800, 4e5};
    air = (trk_air_spring_options){sizeof air, 5e5, 0.012, 0.045, 0.1, 1.3, 1e5, 0.02, 1e-6, 300};
    seal = (trk_seal_options){sizeof seal, 40, 90, 0.05, 0.004};
    *z = (zoo){{NULL}};
    trk_status status = trk_law_create_tire(context, "a", &tire, &z->law[0]);
    if (!status)
        status = trk_law_create_stops(context, "b", &stops, &z->law[1]);
    if (!status)
        status = trk_law_create_leaf(context, "c", &leaf, &z->law[2]);
    if (!status)
        status = trk_law_create_friction(context, "d", &friction, &z->law[3]);
    if (!status)
        status = trk_law_create_air_spring(context, "e", &air, &z->law[4]);
    if (!status)
        status = trk_law_create_seal(context, "f", &seal, &z->law[5]);
    return status;
}

static void empty(zoo *z)
{
    for (int k = 0; k < 6; k++)
        trk_law_destroy(z->law[k]);
}

static void reads_back(void **state)
{
    trk_curve *curve = rubber(*state, 0, 0, 2000);
    zoo z;
    assert_ok(*state, fill(*state, curve, &z));
    trk_curve_destroy(curve); /* the law has its own */
    for (int copied = 0; copied < 2; copied++) {
        for (int k = 0; k < 6; k++) {
            const char name[] = {(char)('a' + k), 0};
            assert_int_equal(trk_law_get_kind(z.law[k]), k + 1);
            assert_string_equal(trk_law_name(z.law[k]), name);
        }
        trk_tire_options tire = {.struct_size = sizeof tire};
        assert_ok(*state, trk_law_get_tire(z.law[0], &tire));
        assert_near(tire.stiffness + tire.stiffening + tire.damping + tire.preload, 3030500, 0);
        trk_stops_options stops = {.struct_size = sizeof stops};
        assert_ok(*state, trk_law_get_stops(z.law[1], &stops));
        assert_near(trk_curve_value(stops.bump_curve, 0.01), 1000, 0);
        assert_near(trk_curve_value(stops.rebound_curve, 0.03), 2000, 0);
        assert_near(stops.bump_clearance + stops.rebound_clearance, 0.07, 1e-15);
        assert_near(stops.bump_stiffness + 2 * stops.rebound_stiffness, 5e5, 0);
        trk_leaf_options leaf = {.struct_size = sizeof leaf};
        assert_ok(*state, trk_law_get_leaf(z.law[2], &leaf));
        assert_near(leaf.friction + leaf.friction_slope, 12500, 0);
        assert_near(leaf.approach_bump + 2 * leaf.approach_rebound, 0.004, 0);
        trk_friction_options friction = {.struct_size = sizeof friction};
        assert_ok(*state, trk_law_get_friction(z.law[3], &friction));
        assert_near(friction.friction + friction.stiffness, 400800, 0);
        trk_air_spring_options air = {.struct_size = sizeof air};
        assert_ok(*state, trk_law_get_air_spring(z.law[4], &air));
        assert_near(air.pressure + air.ambient + air.temperature, 600300, 0);
        assert_near(air.volume + air.area + air.area_slope + air.auxiliary_volume, 0.177, 1e-15);
        assert_near(air.exponent + 1e6 * air.conductance, 2.3, 1e-15);
        trk_seal_options seal = {.struct_size = sizeof seal};
        assert_ok(*state, trk_law_get_seal(z.law[5], &seal));
        assert_near(seal.sliding + seal.breakaway + seal.stribeck + seal.creep, 130.054, 1e-12);
        assert_int_equal(trk_law_get_tire(z.law[5], &tire), TRK_E_ARGUMENT);
        assert_int_equal(trk_law_get_seal(z.law[5], NULL), TRK_E_ARGUMENT);
        assert_int_equal(trk_law_get_seal(NULL, &seal), TRK_E_ARGUMENT);
        seal.struct_size = 0;
        assert_int_equal(trk_law_get_seal(z.law[5], &seal), TRK_E_OPTIONS);
        for (int k = 0; k < 6 && !copied; k++) {
            trk_law *copy;
            assert_ok(*state, trk_law_copy(*state, z.law[k], &copy));
            trk_law_destroy(z.law[k]);
            z.law[k] = copy;
        }
    }
    empty(&z);
    assert_int_equal(trk_law_get_kind(NULL), 0);
    assert_null(trk_law_name(NULL));
    trk_law_destroy(NULL);
}

static void defaults_fill_in(void **state)
{
    trk_leaf_options leaf;
    trk_seal_options seal;
    trk_law *law;
    trk_leaf_options_init(&leaf, sizeof leaf);
    leaf.friction = 100;
    leaf.approach_bump = 0.001;
    assert_ok(*state, trk_law_create_leaf(*state, "leaf", &leaf, &law));
    assert_ok(*state, trk_law_get_leaf(law, &leaf));
    assert_near(leaf.approach_rebound, 0.001, 0);
    trk_law_destroy(law);
    trk_seal_options_init(&seal, sizeof seal);
    seal.sliding = 40;
    assert_ok(*state, trk_law_create_seal(*state, "seal", &seal, &law));
    assert_ok(*state, trk_law_get_seal(law, &seal));
    assert_near(seal.breakaway, 40, 0);
    assert_near(seal.creep, 0.001, 0);
    trk_law_destroy(law);
    trk_stops_options stops; /* stops that do nothing are allowed: a study may stiffen them */
    trk_stops_options_init(&stops, sizeof stops);
    assert_ok(*state, trk_law_create_stops(*state, "stops", &stops, &law));
    trk_law_destroy(law);
}

static void null_pointers_are_refused(void **state)
{
    trk_seal_options o;
    trk_law *law = NULL;
    trk_seal_options_init(&o, sizeof o);
    assert_status(*state, trk_law_create_seal(*state, "x", &o, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_law_create_seal(*state, NULL, &o, &law), TRK_E_ARGUMENT);
    assert_message(*state, "name is NULL");
    assert_status(*state, trk_law_create_seal(*state, "x", NULL, &law), TRK_E_ARGUMENT);
    assert_message(*state, "seal 'x': options is NULL");
    assert_int_equal(trk_law_create_seal(NULL, "x", &o, &law), TRK_E_ARGUMENT);
    o.struct_size = 3;
    assert_status(*state, trk_law_create_seal(*state, "x", &o, &law), TRK_E_OPTIONS);
    assert_message(*state, "law 'x'");
    assert_status(*state, trk_law_copy(*state, NULL, &law), TRK_E_ARGUMENT);
    assert_null(law);
}

static trk_status everything(trk_context *context)
{
    const double x[] = {0, 1}, y[] = {0, 1e5};
    trk_curve *curve = NULL;
    trk_law *copy = NULL;
    zoo z = {{NULL}};
    trk_status status = trk_curve_create(context, "rubber", 2, x, y, NULL, &curve);
    if (!status)
        status = fill(context, curve, &z);
    if (!status)
        status = trk_law_copy(context, z.law[1], &copy);
    trk_law_destroy(copy);
    empty(&z);
    trk_curve_destroy(curve);
    return status;
}

static void memory_may_end_anywhere(void **state)
{
    (void)state;
    support_exhaust_memory(everything);
}

static void trace_refuses(void **state)
{
    trk_friction_options o = {sizeof o, 800, 4e5};
    trk_law *law;
    const double e[] = {0, 0.01, NAN};
    double force[3];
    assert_ok(*state, trk_law_create_friction(*state, "dry", &o, &law));
    assert_status(*state, trk_law_trace(*state, NULL, 2, 1, e, force, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_law_trace(*state, law, 2, 1, NULL, force, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_law_trace(*state, law, 2, 1, e, NULL, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_law_trace(*state, law, 0, 1, e, force, NULL), TRK_E_ARGUMENT);
    assert_message(*state, "count is 0");
    assert_status(*state, trk_law_trace(*state, law, 2, 0, e, force, NULL), TRK_E_RANGE);
    assert_message(*state, "step is 0");
    assert_status(*state, trk_law_trace(*state, law, 3, 1, e, force, NULL), TRK_E_RANGE);
    assert_message(*state, "e of point 3 is nan");
    assert_ok(*state, trk_law_trace(*state, law, 1, 1, e, force, NULL));
    assert_near(force[0], 0, 0);
    assert_int_equal(trk_law_trace(NULL, law, 2, 1, e, force, NULL), TRK_E_ARGUMENT);
    trk_law_destroy(law);
    /* A force of 1e200 N over 1e110 m is finite; the work of it is not. */
    const double far[] = {0, 1e110};
    double lost[2];
    o = (trk_friction_options){sizeof o, 1e200, 1e200};
    assert_ok(*state, trk_law_create_friction(*state, "dry", &o, &law));
    assert_status(*state, trk_law_trace(*state, law, 2, 1, far, force, lost), TRK_E_RANGE);
    assert_message(*state, "the energy of the dry friction 'dry' overflows at point 2");
    trk_law_destroy(law);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(tire_refuses),
        TEST(stops_refuse),
        TEST(stops_refuse_a_dip_between_points),
        TEST(friction_laws_refuse),
        TEST(air_spring_refuses),
        TEST(reads_back),
        TEST(defaults_fill_in),
        TEST(null_pointers_are_refused),
        cmocka_unit_test(memory_may_end_anywhere),
        TEST(trace_refuses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
