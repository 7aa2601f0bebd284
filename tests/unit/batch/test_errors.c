/* SPDX-License-Identifier: MIT */
/* Arguments that are refused, with a message that names the variant and the part; no memory. */
#include "fleet.h"

enum { VARIANTS = 3, LAST = VARIANTS - 1 };

typedef void (*change)(trk_context *context, trk_spec *spec);

static void add_body(trk_context *context, trk_spec *spec)
{
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    body.mass = 10;
    assert_ok(context, trk_spec_add_body(spec, "box", &body, NULL));
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = trk_spec_find(spec, TRK_PART_BODY, "box");
    link.stiffness = 1000;
    assert_ok(context, trk_spec_add_link(spec, "strap", &link, NULL));
}

static void add_sensor(trk_context *context, trk_spec *spec)
{
    trk_sensor_options sensor;
    trk_sensor_options_init(&sensor, sizeof sensor);
    sensor.body = 1;
    sensor.quantity = TRK_QUANTITY_VELOCITY;
    assert_ok(context, trk_spec_add_sensor(spec, "extra", &sensor, NULL));
}

static void add_curve(trk_context *context, trk_spec *spec)
{
    static const double x[] = {-1, 0, 1}, y[] = {-1e4, 0, 1e4};
    trk_curve *curve;
    assert_ok(context, trk_curve_create(context, "more", 3, x, y, NULL, &curve));
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    assert_ok(context, trk_spec_get_link(spec, 1, &link));
    link.spring_curve = curve;
    assert_ok(context, trk_spec_set_link(spec, 1, &link));
    trk_curve_destroy(curve);
}

static void test_structure(void **state)
{
    static const struct {
        change make;
        const char *message;
    } cases[] = {{add_body, "trk_batch_run: variant 2: it has 8 coordinates, variant 0 has 7"},
                 {add_sensor, "trk_batch_run: variant 2: it has 12 sensors, variant 0 has 11"},
                 {add_curve, "variant 2: spring curve of link '"}};
    fleet f;
    fleet_create(&f, *state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_LINEAR, 0, VARIANTS, 1);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        trk_spec *spec = support_spec(*state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_LINEAR);
        cases[k].make(*state, spec);
        trk_model_destroy(f.model[LAST]);
        assert_ok(*state, trk_model_compile(*state, spec, NULL, &f.model[LAST]));
        trk_spec_destroy(spec);
        assert_status(*state, fleet_run(&f, NULL, NULL), TRK_E_ARGUMENT);
        assert_message(*state, cases[k].message);
        assert_int_equal(f.received[0], 0);
        assert_int_equal(f.status[0], -1); /* not written */
    }
    fleet_destroy(&f);
}

/* A half truck with one more sensor of that name. */
static trk_model *with_sensor(trk_context *context, const char *name, trk_quantity quantity)
{
    trk_spec *spec = support_spec(context, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_LINEAR);
    trk_sensor_options sensor;
    trk_sensor_options_init(&sensor, sizeof sensor);
    sensor.body = 1;
    sensor.quantity = quantity;
    assert_ok(context, trk_spec_add_sensor(spec, name, &sensor, NULL));
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, NULL, &model));
    trk_spec_destroy(spec);
    return model;
}

/* Same counts, but another name, another quantity, another number of roads. */
static void test_names(void **state)
{
    fleet f;
    fleet_create(&f, *state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_LINEAR, 0, VARIANTS, 1);
    for (int32_t k = 0; k < VARIANTS; k++)
        trk_model_destroy(f.model[k]);
    f.model[0] = with_sensor(*state, "extra", TRK_QUANTITY_VELOCITY);
    f.model[1] = with_sensor(*state, "extra", TRK_QUANTITY_VELOCITY);
    f.model[LAST] = with_sensor(*state, "other", TRK_QUANTITY_VELOCITY);
    assert_status(*state, fleet_run(&f, NULL, NULL), TRK_E_ARGUMENT);
    assert_message(*state, "variant 2: its sensor 12 is 'other', that of variant 0 'extra'");
    trk_model_destroy(f.model[1]);
    f.model[1] = with_sensor(*state, "extra", TRK_QUANTITY_ACCELERATION);
    assert_status(*state, fleet_run(&f, NULL, NULL), TRK_E_ARGUMENT);
    assert_message(*state, "variant 1: sensor 'extra' reads something else");
    fleet g;
    fleet_create(&g, *state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_LINEAR, 0, 2, 2);
    trk_excitation *kept = g.road[1];
    g.road[1] = f.road[0];
    assert_status(*state, fleet_run(&g, NULL, NULL), TRK_E_ARGUMENT);
    assert_message(*state, "variant 1: its excitation has 2 roads and 2 ports, the model 4 and 2");
    g.road[1] = kept;
    fleet_destroy(&g);
    fleet_destroy(&f);
}

static trk_status call(fleet *f, int32_t count, const trk_model *const *models,
                       const trk_excitation *const *roads, trk_batch_sink sink)
{
    return trk_batch_run(f->context, count, models, roads, &f->newmark, &f->options, sink, f, NULL,
                         NULL, NULL);
}

static void test_hostile(void **state)
{
    fleet f;
    fleet_create(&f, *state, TRK_VEHICLE_THESIS_QUARTER, TRK_VARIANT_LINEAR, 0, 2, 1);
    const trk_model *const models[] = {f.model[0], NULL};
    const trk_excitation *const roads[] = {f.road[0], f.road[0]};
    const trk_excitation *const holes[] = {f.road[0], NULL};
    const trk_model *const twins[] = {f.model[0], f.model[0]};
    f.samples = trk_batch_samples(&f.newmark, &f.options);
    assert_status(*state, call(&f, 2, NULL, roads, fleet_sink), TRK_E_ARGUMENT);
    assert_status(*state, call(&f, 2, models, NULL, fleet_sink), TRK_E_ARGUMENT);
    assert_status(*state, call(&f, 2, models, roads, NULL), TRK_E_ARGUMENT);
    assert_status(*state, call(&f, 0, models, roads, fleet_sink), TRK_E_ARGUMENT);
    assert_status(*state, call(&f, -1, models, roads, fleet_sink), TRK_E_ARGUMENT);
    assert_status(*state, call(&f, INT32_MAX, models, roads, fleet_sink), TRK_E_ARGUMENT);
    assert_status(*state, call(&f, 2, models, roads, fleet_sink), TRK_E_ARGUMENT);
    assert_message(*state, "variant 1: its model is NULL");
    assert_status(*state, call(&f, 2, twins, holes, fleet_sink), TRK_E_ARGUMENT);
    assert_message(*state, "variant 1: its excitation is NULL");
    assert_int_equal(
        trk_batch_run(NULL, 2, twins, roads, NULL, NULL, fleet_sink, NULL, NULL, NULL, NULL),
        TRK_E_ARGUMENT);
    trk_model *blind = support_oscillator(*state, 100, 1e4, 10);
    trk_excitation *still;
    assert_ok(*state, trk_excitation_create(*state, blind, &still));
    assert_status(
        *state,
        call(&f, 1, &(const trk_model *){blind}, &(const trk_excitation *){still}, fleet_sink),
        TRK_E_MODEL);
    trk_excitation_destroy(still);
    trk_model_destroy(blind);
    fleet_destroy(&f);
}

static void test_options(void **state)
{
    fleet f;
    fleet_create(&f, *state, TRK_VEHICLE_THESIS_QUARTER, TRK_VARIANT_LINEAR, 0, 1, 1);
    trk_batch_options good = f.options;
    assert_int_equal(trk_batch_samples(&f.newmark, &good), 701);
    assert_int_equal(trk_batch_samples(NULL, NULL), 10001);
#define REFUSED(field, value, status)                                                              \
    f.options = good;                                                                              \
    f.options.field = value;                                                                       \
    assert_int_equal(trk_batch_samples(&f.newmark, &f.options), 0);                                \
    assert_status(*state, fleet_run(&f, NULL, NULL), status);                                      \
    assert_message(*state, #field)
    REFUSED(duration, 0, TRK_E_RANGE);
    REFUSED(duration, NAN, TRK_E_RANGE);
    REFUSED(duration, 1e-9, TRK_E_RANGE);
    REFUSED(duration, 1e18, TRK_E_RANGE);
    REFUSED(start, INFINITY, TRK_E_RANGE);
    REFUSED(record_every, 0, TRK_E_RANGE);
    REFUSED(threads, 0, TRK_E_RANGE);
    REFUSED(threads, -3, TRK_E_RANGE);
    REFUSED(sensor_count, 1, TRK_E_ARGUMENT);
    REFUSED(sensor_count, -1, TRK_E_ARGUMENT);
    REFUSED(struct_size, 3, TRK_E_OPTIONS);
    const int32_t sensors[] = {1, 99};
    f.options = good;
    f.options.sensors = sensors;
    assert_status(*state, fleet_run(&f, NULL, NULL), TRK_E_ARGUMENT);
    f.options.sensor_count = 2;
    assert_status(*state, fleet_run(&f, NULL, NULL), TRK_E_ARGUMENT);
    assert_message(*state, "sensors[1] is 99");
    f.options = good;
    f.newmark.step = -1;
    assert_int_equal(trk_batch_samples(&f.newmark, &f.options), 0);
    assert_status(*state, fleet_run(&f, NULL, NULL), TRK_E_RANGE);
    trk_newmark_options_init(&f.newmark, sizeof f.newmark);
    f.options.threads = INT32_MAX; /* as many as there are groups */
    f.options.record_every = INT64_MAX;
    assert_ok(*state, fleet_run(&f, NULL, NULL));
    assert_int_equal(f.received[0], 1);
    fleet_destroy(&f);
}

/* Memory is refused inside of the batch only: all else is made in a context of its own. */
static fleet exhausted;

static trk_status run_in(trk_context *context)
{
    fleet f = exhausted;
    f.context = context;
    trk_status status = fleet_run(&f, NULL, NULL);
    for (int32_t k = 0; status == TRK_E_MEMORY && k < f.count; k++)
        assert_true(f.status[k] == TRK_E_MEMORY || f.status[k] == -1);
    fleet_forget(&f);
    return status;
}

static void test_memory(void **state)
{
    for (int32_t kernel = 0; kernel <= TRK_BATCH_KERNEL_BEST; kernel += TRK_BATCH_KERNEL_BEST) {
        fleet_create(&exhausted, *state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_NONLINEAR, 0,
                     FLEET_MOST, 2);
        exhausted.kernel = kernel;
        exhausted.options.threads = 2;
        exhausted.options.duration = 0.005;
        support_exhaust_memory(run_in);
        fleet_destroy(&exhausted);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_structure, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_names, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_hostile, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_options, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_memory, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
