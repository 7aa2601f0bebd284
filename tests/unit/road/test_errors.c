/* SPDX-License-Identifier: MIT */
/* Hostile arguments, options and memory. */
#include "support.h"

#include <truckride/road.h>

static void test_defaults_and_classes(void **state)
{
    trk_road_options o;
    trk_road_options_init(&o, sizeof o);
    assert_true(o.struct_size == sizeof o && o.unevenness == 16e-6 && o.waviness == 2);
    assert_true(o.low == 0.011 && o.high == 2.83 && o.seed == 1 && o.track_width == 2);
    assert_true(o.contact_length == 0 && o.ramp_length == 0 && o.tracks == 0);
    for (trk_road_class k = TRK_ROAD_CLASS_A; k <= TRK_ROAD_CLASS_H; k++)
        assert_true(trk_road_class_unevenness(k) == 16e-6 * pow(4, k - 1));
    assert_true(trk_road_class_unevenness(0) == 0 && trk_road_class_unevenness(9) == 0);
    assert_true(trk_road_class_unevenness(INT32_MIN) == 0);
    (void)state;
}

/* Each function must refuse the options alike, and leave no track. */
static void refuse(trk_context *context, const trk_road_options *o, trk_status status,
                   const char *message)
{
    trk_signal *left = (trk_signal *)context, *right = left;
    double n = 0.1, out;
    assert_status(context, trk_road_create(context, o, &left, &right), status);
    assert_message(context, message);
    assert_true(!left && !right);
    assert_status(context, trk_road_density(context, o, 1, &n, &out), status);
    assert_status(context, trk_road_coherence(context, o, 1, &n, &out), status);
}

static void test_options_out_of_range(void **state)
{
    static const struct {
        size_t offset;
        const char *name;
        double bad[4];
    } field[] = {
#define FIELD(name) offsetof(trk_road_options, name), "road: " #name
        {FIELD(unevenness), {-1e-300, 1.1e6, NAN, INFINITY}},
        {FIELD(waviness), {0.99, 4.01, NAN, -INFINITY}},
        {FIELD(low), {0, -1, 1e5, NAN}},
        {FIELD(high), {0, 1.1e4, INFINITY, NAN}},
        {FIELD(track_width), {-1, 1e7, NAN, INFINITY}},
        {FIELD(coherence_decay), {-1, 1e7, NAN, INFINITY}},
        {FIELD(contact_length), {-0.1, 1e-5, 100, NAN}},
        {FIELD(ramp_start), {-1e13, 1e13, NAN, INFINITY}},
        {FIELD(ramp_length), {-1, 1e-9, 1e13, NAN}},
#undef FIELD
    };
    trk_road_options o;
    for (size_t k = 0; k < sizeof field / sizeof *field; k++)
        for (int j = 0; j < 4; j++) {
            trk_road_options_init(&o, sizeof o);
            memcpy((char *)&o + field[k].offset, &field[k].bad[j], sizeof(double));
            refuse(*state, &o, TRK_E_RANGE, field[k].name);
        }
    trk_road_options_init(&o, sizeof o);
    o.low = o.high;
    refuse(*state, &o, TRK_E_RANGE, "expected low < high");
    trk_road_options_init(&o, sizeof o);
    o.tracks = 4;
    refuse(*state, &o, TRK_E_ARGUMENT, "tracks is 4");
    o.tracks = -1;
    refuse(*state, &o, TRK_E_ARGUMENT, "tracks is -1");
    o.tracks = 0;
    o.reserved = 1;
    refuse(*state, &o, TRK_E_OPTIONS, "reserved");
    trk_road_options_init(&o, sizeof o);
    o.struct_size = 3;
    refuse(*state, &o, TRK_E_OPTIONS, "struct_size");
}

static void test_arguments(void **state)
{
    trk_context *c = *state;
    trk_signal *left = (trk_signal *)c, *right = left;
    double n[2] = {0.1, 0.2}, out[2];
    assert_status(c, trk_road_create(c, NULL, NULL, &right), TRK_E_ARGUMENT);
    assert_null(right);
    right = left;
    assert_status(c, trk_road_create(NULL, NULL, &left, &right), TRK_E_ARGUMENT);
    assert_true(!left && !right);
    assert_status(c, trk_road_density(NULL, NULL, 1, n, out), TRK_E_ARGUMENT);
    assert_status(c, trk_road_density(c, NULL, 1, NULL, out), TRK_E_ARGUMENT);
    assert_status(c, trk_road_density(c, NULL, 1, n, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_road_coherence(NULL, NULL, 1, n, out), TRK_E_ARGUMENT);
    assert_status(c, trk_road_coherence(c, NULL, 1, NULL, out), TRK_E_ARGUMENT);
    assert_status(c, trk_road_coherence(c, NULL, 1, n, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_road_density(c, NULL, -1, n, out), TRK_E_RANGE);
    assert_ok(c, trk_road_density(c, NULL, 0, n, out));
    n[1] = -0.1;
    assert_status(c, trk_road_density(c, NULL, 2, n, out), TRK_E_RANGE);
    assert_message(c, "wavenumber 2 is -0.1");
    n[1] = NAN;
    assert_status(c, trk_road_coherence(c, NULL, 2, n, out), TRK_E_RANGE);
    n[1] = INFINITY;
    assert_status(c, trk_road_coherence(c, NULL, 2, n, out), TRK_E_RANGE);
}

/* The widest and the narrowest roads there are give finite heights and slopes. */
static void test_extremes(void **state)
{
    trk_road_options o;
    for (int k = 0; k < 64; k++) {
        trk_road_options_init(&o, sizeof o);
        o.unevenness = k & 1 ? 1e6 : 0;
        o.waviness = k & 2 ? 4 : 1;
        o.low = k & 4 ? 1e-6 : nextafter(1e4, 0);
        o.high = 1e4;
        o.seed = k & 8 ? INT64_MIN : INT64_MAX;
        o.track_width = k & 16 ? 1e6 : 0;
        o.contact_length = k & 32 ? 250 / o.high : 0;
        trk_signal *track[2];
        assert_ok(*state, trk_road_create(*state, &o, &track[0], &track[1]));
        for (int j = 0; j < 2; j++) {
            double value[3], rate[3];
            trk_signal_evaluate(track[j], 3, -1e3, 1e3, value, rate);
            for (int i = 0; i < 3; i++) {
                assert_true(isfinite(value[i]) && isfinite(rate[i]));
                assert_true(k & 1 || (value[i] == 0 && rate[i] == 0));
            }
            trk_signal_destroy(track[j]);
        }
    }
}

static trk_status create_both(trk_context *context)
{
    trk_signal *left = NULL, *right = NULL;
    trk_status status = trk_road_create(context, NULL, &left, &right);
    assert_true(status == TRK_OK ? left && right : !left && !right);
    trk_signal_destroy(left);
    trk_signal_destroy(right);
    return status;
}

static void test_memory(void **state)
{
    (void)state;
    support_exhaust_memory(create_both);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_defaults_and_classes),
        cmocka_unit_test(test_options_out_of_range),
        cmocka_unit_test(test_arguments),
        cmocka_unit_test(test_extremes),
        cmocka_unit_test(test_memory),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
