/* SPDX-License-Identifier: MIT */
/* What compiling refuses, by the words that name the culprit; memory that runs out. */
#include "support.h"

#include <truckride/model.h>
#include <truckride/vehicle.h>

static int32_t add_body(trk_context *context, trk_spec *spec, const char *name, int32_t freedoms,
                        double mass, double inertia)
{
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    body.freedoms = freedoms;
    body.mass = mass;
    body.inertia[0] = body.inertia[1] = body.inertia[2] = inertia;
    int32_t id;
    assert_ok(context, trk_spec_add_body(spec, name, &body, &id));
    return id;
}

static void add_spring(trk_context *context, trk_spec *spec, const char *name, int32_t from,
                       int32_t to, double stiffness)
{
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.from_body = from;
    link.to_body = to;
    link.stiffness = stiffness;
    assert_ok(context, trk_spec_add_link(spec, name, &link, NULL));
}

static trk_spec *empty(trk_context *context)
{
    trk_spec *spec;
    assert_ok(context, trk_spec_create(context, "van", &spec));
    return spec;
}

/* Compiling fails with this status and words; the spec is freed. */
static void refuse(trk_context *context, trk_spec *spec, double gravity, trk_status status,
                   const char *text)
{
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.gravity = gravity;
    trk_model *model = (trk_model *)spec;
    assert_status(context, trk_model_compile(context, spec, &options, &model), status);
    assert_null(model);
    assert_message(context, text);
    trk_spec_destroy(spec);
}

static void arguments_and_options(void **state)
{
    trk_spec *spec = empty(*state);
    trk_model *model;
    assert_status(*state, trk_model_compile(*state, NULL, NULL, &model), TRK_E_ARGUMENT);
    assert_message(*state, "trk_model_compile: spec is NULL");
    assert_status(*state, trk_model_compile(*state, spec, NULL, NULL), TRK_E_ARGUMENT);
    assert_message(*state, "trk_model_compile: out_model is NULL");
    assert_int_equal(trk_model_compile(NULL, spec, NULL, &model), TRK_E_ARGUMENT);
    trk_model_options options = {.struct_size = 0};
    assert_status(*state, trk_model_compile(*state, spec, &options, &model), TRK_E_OPTIONS);
    assert_message(*state, "trk_model_options: struct_size is 0");
    trk_spec_destroy(spec);
    refuse(*state, empty(*state), -1, TRK_E_RANGE, "trk_model_options: gravity is -1 m/s^2");
    refuse(*state, empty(*state), NAN, TRK_E_RANGE, "trk_model_options: gravity is ");
    refuse(*state, empty(*state), INFINITY, TRK_E_RANGE, "trk_model_options: gravity is inf");
}

static void missing_parts(void **state)
{
    refuse(*state, empty(*state), 0, TRK_E_MODEL, "van: the spec has no body");

    trk_spec *spec = empty(*state);
    add_body(*state, spec, "cab", TRK_FREE_Z, 0, 0);
    add_spring(*state, spec, "k", 0, 1, 1);
    refuse(*state, spec, 0, TRK_E_MODEL, "van: coordinate 'cab.z' has no mass");

    spec = empty(*state);
    add_body(*state, spec, "cab", TRK_FREE_Z | TRK_FREE_PITCH, 5, 0);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = 1;
    link.to_point[0] = 1;
    link.stiffness = 1;
    assert_ok(*state, trk_spec_add_link(spec, "k", &link, NULL));
    refuse(*state, spec, 0, TRK_E_MODEL, "van: coordinate 'cab.pitch' has no moment of inertia");

    spec = empty(*state);
    add_body(*state, spec, "cab", TRK_FREE_Z, 1, 0);
    add_body(*state, spec, "a", TRK_FREE_Z, 1, 0);
    add_body(*state, spec, "b", TRK_FREE_Z, 1, 0);
    add_spring(*state, spec, "k", 0, 1, 1);
    add_spring(*state, spec, "ab", 2, 3, 1);
    add_spring(*state, spec, "nothing", 0, 2, 0);
    refuse(*state, spec, 0, TRK_E_MODEL, "van: body 'a' is not supported");

    spec = empty(*state);
    add_body(*state, spec, "cab", TRK_FREE_Z | TRK_FREE_YAW, 1, 1);
    add_spring(*state, spec, "k", 0, 1, 1);
    refuse(*state, spec, 0, TRK_E_MODEL, "van: coordinate 'cab.yaw' is not supported");
}

static void point_mass_supplies_mass_and_inertia(void **state)
{
    trk_spec *spec = empty(*state);
    add_body(*state, spec, "cab", TRK_FREE_Z | TRK_FREE_PITCH, 0, 0);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = 1;
    link.to_point[0] = 1;
    link.stiffness = 1;
    assert_ok(*state, trk_spec_add_link(spec, "k", &link, NULL));
    assert_ok(*state, trk_spec_add_mass(spec, "m", 1, 2, (double[]){3, 0, 0}, NULL));
    trk_model *model;
    assert_status(*state, trk_model_compile(*state, spec, NULL, &model),
                  TRK_E_MODEL); /* rank one */
    assert_ok(*state, trk_spec_add_mass(spec, "n", 1, 2, (double[]){-3, 0, 0}, NULL));
    assert_ok(*state, trk_model_compile(*state, spec, NULL, &model));
    double m[4];
    trk_model_get_mass(model, m);
    assert_memory_equal(m, ((double[]){4, 0, 0, 36}), sizeof m);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
}

static void free_bodies_when_allowed(void **state)
{
    trk_spec *spec = empty(*state);
    add_body(*state, spec, "cab", TRK_FREE_Z, 1, 0);
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.allow_free = 1;
    trk_model *model;
    assert_ok(*state, trk_model_compile(*state, spec, &options, &model));
    assert_int_equal(trk_model_count(model, TRK_PART_LINK), 0);
    trk_model_destroy(model);
    options.gravity = 9.81;
    assert_status(*state, trk_model_compile(*state, spec, &options, &model), TRK_E_SINGULAR);
    assert_message(*state,
                   "van: the stiffness under gravity is not positive definite: nothing holds");
    assert_message(*state, "'cab.z'");
    trk_spec_destroy(spec);
}

static void negative_spring_under_gravity(void **state)
{
    trk_spec *spec = empty(*state);
    add_body(*state, spec, "cab", TRK_FREE_Z, 1, 0);
    add_spring(*state, spec, "good", 0, 1, 5);
    add_spring(*state, spec, "bad", 0, 1, -7);
    refuse(*state, spec, 9.81, TRK_E_SINGULAR, "at coordinate 'cab.z': link 'bad' adds -7");
}

/* Finite numbers whose products are not. */
static void overflow(void **state)
{
    const double huge[] = {1.5e308, 0, 0};
    for (int which = 0; which < 3; which++) {
        trk_spec *spec = empty(*state);
        trk_body_options body;
        trk_body_options_init(&body, sizeof body);
        body.freedoms = TRK_FREE_Z | TRK_FREE_PITCH;
        body.mass = body.inertia[1] = 1;
        body.cg[0] = -1.5e308;
        assert_ok(*state, trk_spec_add_body(spec, "cab", &body, NULL));
        trk_link_options link;
        trk_link_options_init(&link, sizeof link);
        link.to_body = 1;
        memcpy(link.to_point, which == 0 ? huge : body.cg, sizeof huge);
        link.stiffness = 1;
        assert_ok(*state, trk_spec_add_link(spec, "k", &link, NULL));
        trk_sensor_options sensor;
        trk_sensor_options_init(&sensor, sizeof sensor);
        sensor.body = 1;
        memcpy(sensor.point, which == 1 ? huge : body.cg, sizeof huge);
        assert_ok(*state, trk_spec_add_sensor(spec, "s", &sensor, NULL));
        trk_port_options port;
        trk_port_options_init(&port, sizeof port);
        port.body = 1;
        memcpy(port.point, which == 2 ? huge : body.cg, sizeof huge);
        assert_ok(*state, trk_spec_add_port(spec, "p", &port, NULL));
        static const char *const text[] = {"van: link 'k': the lever arm about 'cab.pitch' is ",
                                           "van: sensor 's': the lever arm about 'cab.pitch' is ",
                                           "van: port 'p': the lever arm about 'cab.pitch' is "};
        trk_model_options options;
        trk_model_options_init(&options, sizeof options);
        options.allow_free = 1;
        trk_model *model;
        assert_status(*state, trk_model_compile(*state, spec, &options, &model), TRK_E_RANGE);
        assert_message(*state, text[which]);
        trk_spec_destroy(spec);
    }
}

static void overflow_of_mass_and_force(void **state)
{
    trk_spec *spec = empty(*state);
    add_body(*state, spec, "cab", TRK_FREE_Z, 1e308, 0);
    add_spring(*state, spec, "k", 0, 1, 1);
    refuse(*state, spec, 1e3, TRK_E_RANGE,
           "van: coordinate 'cab.z': its inertia 1e+308 or weight -inf");

    spec = empty(*state);
    add_body(*state, spec, "cab", TRK_FREE_Z | TRK_FREE_PITCH, 1, 1);
    add_spring(*state, spec, "k", 0, 1, 1);
    assert_ok(*state, trk_spec_add_mass(spec, "m", 1, 1, (double[]){1e200, 0, 0}, NULL));
    refuse(*state, spec, 0, TRK_E_RANGE, "van: coordinate 'cab.pitch': its inertia inf");

    const double x[] = {0, 1}, y[] = {0, 1e10};
    trk_curve *curve;
    assert_ok(*state, trk_curve_create(*state, "c", 2, x, y, NULL, &curve));
    spec = empty(*state);
    add_body(*state, spec, "cab", TRK_FREE_Z, 1, 0);
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = 1;
    link.spring_curve = curve;
    link.spring_offset = 1e300;
    assert_ok(*state, trk_spec_add_link(spec, "k", &link, NULL));
    trk_curve_destroy(curve);
    refuse(*state, spec, 0, TRK_E_RANGE, "van: link 'k': the force of its curves or law at e = 0");
}

static trk_status compile_with_gravity(trk_context *context)
{
    trk_spec *spec = NULL;
    trk_model *model = NULL;
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.gravity = TRK_STANDARD_GRAVITY;
    trk_status status = trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_FRONT,
                                                   TRK_VARIANT_NONLINEAR, &spec);
    if (status == TRK_OK)
        status = trk_model_compile(context, spec, &options, &model);
    trk_spec_destroy(spec);
    trk_model_destroy(model);
    return status;
}

static void lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(compile_with_gravity);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(arguments_and_options),
        TEST(missing_parts),
        TEST(point_mass_supplies_mass_and_inertia),
        TEST(free_bodies_when_allowed),
        TEST(negative_spring_under_gravity),
        TEST(overflow),
        TEST(overflow_of_mass_and_force),
        TEST(lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
