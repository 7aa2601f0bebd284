/* SPDX-License-Identifier: MIT */
/* Every refusal of a spec, by the words that name the culprit; memory that runs out. */
#include "support.h"

#include <truckride/vehicle.h>

/* A spec with bodies "a", "b" and road "r". */
static trk_spec *make(trk_context *context)
{
    trk_spec *spec;
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    body.mass = 1;
    assert_ok(context, trk_spec_create(context, "van", &spec));
    assert_ok(context, trk_spec_add_body(spec, "a", &body, NULL));
    assert_ok(context, trk_spec_add_body(spec, "b", &body, NULL));
    assert_ok(context, trk_spec_add_road(spec, "r", 0, 0, NULL));
    return spec;
}

#define REFUSED(call, status, text)                                                                \
    do {                                                                                           \
        assert_status(*state, call, status);                                                       \
        assert_message(*state, text);                                                              \
    } while (0)

static void creation(void **state)
{
    trk_spec *spec = (trk_spec *)state;
    REFUSED(trk_spec_create(*state, NULL, &spec), TRK_E_ARGUMENT, "trk_spec_create: name is NULL");
    assert_null(spec);
    REFUSED(trk_spec_create(*state, "x", NULL), TRK_E_ARGUMENT,
            "trk_spec_create: out_spec is NULL");
    assert_int_equal(trk_spec_create(NULL, "x", &spec), TRK_E_ARGUMENT);
    REFUSED(trk_spec_copy(*state, NULL, &spec), TRK_E_ARGUMENT, "trk_spec_copy: spec is NULL");
    assert_null(trk_spec_name(NULL));
    assert_int_equal(trk_spec_count(NULL, TRK_PART_BODY), 0);
}

static void names(void **state)
{
    trk_spec *spec = make(*state);
    char name[200];
    memset(name, 'n', sizeof name);
    name[128] = 0;
    REFUSED(trk_spec_add_road(spec, name, 0, 0, NULL), TRK_E_NAME, "road name 'nnnnnn");
    assert_message(*state, "more than 127 characters");
    name[127] = 0;
    assert_ok(*state, trk_spec_add_road(spec, name, 0, 0, NULL));
    REFUSED(trk_spec_add_road(spec, "r", 0, 0, NULL), TRK_E_NAME, "road name 'r' is already used");
    REFUSED(trk_spec_add_road(spec, "", 0, 0, NULL), TRK_E_NAME, "a road needs a name");
    REFUSED(trk_spec_add_road(spec, NULL, 0, 0, NULL), TRK_E_NAME, "a road needs a name");
    assert_ok(*state,
              trk_spec_add_road(spec, "a", 0, 0, NULL)); /* a body's name is another kind's */
    assert_int_equal(trk_spec_count(spec, TRK_PART_ROAD), 3);
    trk_spec_destroy(spec);
}

static void bodies(void **state)
{
    trk_spec *spec = make(*state);
    trk_body_options body;
#define WITH(change, status, text)                                                                 \
    trk_body_options_init(&body, sizeof body);                                                     \
    body.change;                                                                                   \
    REFUSED(trk_spec_add_body(spec, "cab", &body, NULL), status, text)
    WITH(freedoms = 0, TRK_E_ARGUMENT, "body 'cab': freedoms is 0");
    WITH(freedoms = 64, TRK_E_ARGUMENT, "body 'cab': freedoms is 64");
    WITH(freedoms = -1, TRK_E_ARGUMENT, "body 'cab': freedoms is -1");
    WITH(mass = -1, TRK_E_RANGE, "body 'cab': mass is -1");
    WITH(mass = NAN, TRK_E_RANGE, "body 'cab': mass is ");
    WITH(mass = INFINITY, TRK_E_RANGE, "body 'cab': mass is inf");
    WITH(inertia[0] = -1, TRK_E_RANGE, "body 'cab': roll inertia is -1");
    WITH(inertia[1] = -1, TRK_E_RANGE, "body 'cab': pitch inertia is -1");
    WITH(inertia[2] = NAN, TRK_E_RANGE, "body 'cab': yaw inertia is ");
    WITH(cg[1] = INFINITY, TRK_E_RANGE, "body 'cab': centre of gravity is inf");
    WITH(struct_size = 3, TRK_E_OPTIONS, "trk_body_options: struct_size is 3");
#undef WITH
    REFUSED(trk_spec_add_body(spec, "cab", NULL, NULL), TRK_E_ARGUMENT, "options is NULL");
    assert_int_equal(trk_spec_add_body(NULL, "cab", &body, NULL), TRK_E_ARGUMENT);
    REFUSED(trk_spec_set_body(spec, 3, &body), TRK_E_ARGUMENT,
            "there is no body 3 (ids run from 1 to 2)");
    REFUSED(trk_spec_set_body(spec, 1, NULL), TRK_E_ARGUMENT, "options is NULL");
    assert_int_equal(trk_spec_count(spec, TRK_PART_BODY), 2);
    trk_spec_destroy(spec);
}

static void masses_and_roads(void **state)
{
    const double point[] = {0, 0, 0}, wrong[] = {0, NAN, 0};
    trk_spec *spec = make(*state);
    REFUSED(trk_spec_add_mass(spec, "m", 3, 1, point, NULL), TRK_E_ARGUMENT,
            "mass 'm': there is no body 3");
    REFUSED(trk_spec_add_mass(spec, "m", 0, 1, point, NULL), TRK_E_ARGUMENT,
            "mass 'm': there is no body 0");
    REFUSED(trk_spec_add_mass(spec, "m", 1, 0, point, NULL), TRK_E_RANGE, "mass 'm': mass is 0");
    REFUSED(trk_spec_add_mass(spec, "m", 1, NAN, point, NULL), TRK_E_RANGE, "mass 'm': mass is ");
    REFUSED(trk_spec_add_mass(spec, "m", 1, 1, wrong, NULL), TRK_E_RANGE, "mass 'm': point is ");
    REFUSED(trk_spec_add_mass(spec, "m", 1, 1, NULL, NULL), TRK_E_ARGUMENT, "point is NULL");
    REFUSED(trk_spec_add_road(spec, "q", NAN, 0, NULL), TRK_E_RANGE, "road 'q': place is ");
    REFUSED(trk_spec_add_road(spec, "q", 0, -INFINITY, NULL), TRK_E_RANGE,
            "road 'q': place is -inf");
    assert_int_equal(trk_spec_count(spec, TRK_PART_MASS), 0);
    assert_int_equal(trk_spec_count(spec, TRK_PART_ROAD), 1);
    trk_spec_destroy(spec);
}

static void links(void **state)
{
    trk_spec *spec = make(*state);
    trk_link_options link;
#define WITH(change, status, text)                                                                 \
    trk_link_options_init(&link, sizeof link);                                                     \
    link.from_body = 1;                                                                            \
    link.to_body = 2;                                                                              \
    change;                                                                                        \
    REFUSED(trk_spec_add_link(spec, "k", &link, NULL), status, text)
    WITH(link.motion = 2, TRK_E_ARGUMENT, "link 'k': there is no motion 2");
    WITH(link.from_body = 3, TRK_E_ARGUMENT, "link 'k': there is no body 3");
    WITH(link.from_body = -1, TRK_E_ARGUMENT, "link 'k': there is no body -1");
    WITH(link.to_body = 9, TRK_E_ARGUMENT, "link 'k': there is no body 9");
    WITH(link.from_road = 2, TRK_E_ARGUMENT, "link 'k': there is no road 2");
    WITH(link.from_road = 1, TRK_E_ARGUMENT, "starts on body 'a' and on road 'r'");
    WITH((link.from_road = 1, link.from_body = 0, link.motion = 1), TRK_E_ARGUMENT,
         "link 'k': a road does not rotate");
    WITH((link.from_road = 1, link.from_body = link.to_body = 0), TRK_E_ARGUMENT,
         "link 'k': runs from road 'r' to the ground");
    WITH(link.to_body = 1, TRK_E_ARGUMENT, "link 'k': both ends are on body 'a'");
    WITH(link.from_body = link.to_body = 0, TRK_E_ARGUMENT,
         "link 'k': both ends are on the ground");
    WITH(link.direction[2] = 0, TRK_E_RANGE, "link 'k': direction has length 0");
    WITH(link.direction[0] = NAN, TRK_E_RANGE, "link 'k': direction is ");
    WITH(link.direction[0] = link.direction[1] = 1.7e308, TRK_E_RANGE,
         "link 'k': direction has length inf");
    WITH(link.from_point[2] = NAN, TRK_E_RANGE, "link 'k': from_point is ");
    WITH(link.to_point[0] = INFINITY, TRK_E_RANGE, "link 'k': to_point is inf");
    WITH(link.stiffness = NAN, TRK_E_RANGE, "link 'k': stiffness is ");
    WITH(link.spring_offset = INFINITY, TRK_E_RANGE, "link 'k': spring_offset is inf");
    WITH(link.damping = -1, TRK_E_RANGE, "link 'k': damping is -1");
    WITH(link.spring_scale = -1, TRK_E_RANGE, "link 'k': spring_scale is -1");
    WITH(link.damper_scale = NAN, TRK_E_RANGE, "link 'k': damper_scale is ");
    WITH(link.struct_size = 0, TRK_E_OPTIONS, "trk_link_options: struct_size is 0");
#undef WITH
    REFUSED(trk_spec_add_link(spec, "k", NULL, NULL), TRK_E_ARGUMENT, "options is NULL");
    REFUSED(trk_spec_set_link(spec, 1, &link), TRK_E_ARGUMENT,
            "there is no link 1 (ids run from 1 to 0)");
    trk_link_options_init(&link, sizeof link);
    link.to_body = 1;
    link.stiffness = -5; /* legal: an unstable spring is a question for compiling */
    assert_ok(*state, trk_spec_add_link(spec, "k", &link, NULL));
    trk_spec_destroy(spec);
}

static void sensors_and_ports(void **state)
{
    trk_spec *spec = make(*state);
    trk_sensor_options sensor;
    trk_port_options port;
#define WITH(change, status, text)                                                                 \
    trk_sensor_options_init(&sensor, sizeof sensor);                                               \
    sensor.body = 1;                                                                               \
    change;                                                                                        \
    REFUSED(trk_spec_add_sensor(spec, "s", &sensor, NULL), status, text)
    WITH(sensor.quantity = 6, TRK_E_ARGUMENT, "sensor 's': there is no quantity 6");
    WITH(sensor.quantity = -1, TRK_E_ARGUMENT, "sensor 's': there is no quantity -1");
    WITH(sensor.body = 0, TRK_E_ARGUMENT, "sensor 's': there is no body 0");
    WITH(sensor.motion = 7, TRK_E_ARGUMENT, "sensor 's': there is no motion 7");
    WITH(sensor.point[1] = NAN, TRK_E_RANGE, "sensor 's': point is ");
    WITH(sensor.direction[2] = 0, TRK_E_RANGE, "sensor 's': direction has length 0");
    WITH(sensor.quantity = TRK_QUANTITY_RATE, TRK_E_ARGUMENT, "sensor 's': there is no link 0");
    WITH(sensor.struct_size = 1, TRK_E_OPTIONS, "trk_sensor_options: struct_size is 1");
#undef WITH
#define WITH(change, status, text)                                                                 \
    trk_port_options_init(&port, sizeof port);                                                     \
    port.body = 1;                                                                                 \
    change;                                                                                        \
    REFUSED(trk_spec_add_port(spec, "p", &port, NULL), status, text)
    WITH(port.body = 5, TRK_E_ARGUMENT, "port 'p': there is no body 5");
    WITH(port.motion = -1, TRK_E_ARGUMENT, "port 'p': there is no motion -1");
    WITH(port.point[0] = INFINITY, TRK_E_RANGE, "port 'p': point is inf");
    WITH(port.direction[2] = 0, TRK_E_RANGE, "port 'p': direction has length 0");
    WITH(port.struct_size = 70000, TRK_E_OPTIONS, "trk_port_options: struct_size is 70000");
#undef WITH
    REFUSED(trk_spec_add_sensor(spec, "s", NULL, NULL), TRK_E_ARGUMENT, "options is NULL");
    REFUSED(trk_spec_add_port(spec, "p", NULL, NULL), TRK_E_ARGUMENT, "options is NULL");
    trk_spec_destroy(spec);
}

static void reading_back(void **state)
{
    trk_spec *spec = make(*state);
    trk_body_options body = {.struct_size = 0};
    trk_link_options link;
    trk_sensor_options sensor;
    trk_port_options port;
    trk_link_options_init(&link, sizeof link);
    trk_sensor_options_init(&sensor, sizeof sensor);
    trk_port_options_init(&port, sizeof port);
    assert_int_equal(trk_spec_get_body(spec, 1, &body), TRK_E_OPTIONS);
    assert_int_equal(trk_spec_get_body(spec, 0, &body), TRK_E_ARGUMENT);
    assert_int_equal(trk_spec_get_body(spec, 1, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_spec_get_body(NULL, 1, &body), TRK_E_ARGUMENT);
    assert_int_equal(trk_spec_get_link(spec, 1, &link), TRK_E_ARGUMENT);
    assert_int_equal(trk_spec_get_sensor(spec, 1, &sensor), TRK_E_ARGUMENT);
    assert_int_equal(trk_spec_get_port(spec, -1, &port), TRK_E_ARGUMENT);
    assert_int_equal(trk_spec_get_road(spec, 2, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_spec_get_road(NULL, 1, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_spec_get_mass(spec, 1, NULL, NULL, NULL), TRK_E_ARGUMENT);
    trk_spec_destroy(spec);
}

/* A built-in vehicle has every kind of part; a mass is added. */
static trk_status build_and_copy(trk_context *context)
{
    trk_spec *spec = NULL, *copy = NULL;
    trk_status status = trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_HALF,
                                                   TRK_VARIANT_NONLINEAR, &spec);
    if (status == TRK_OK)
        status = trk_spec_add_mass(spec, "tank", 1, 300, (double[]){0, 1, 0}, NULL);
    if (status == TRK_OK)
        status = trk_spec_copy(context, spec, &copy);
    if (status == TRK_OK) {
        trk_link_options link;
        trk_link_options_init(&link, sizeof link);
        status = trk_spec_get_link(spec, trk_spec_find(spec, TRK_PART_LINK, "front_spring"), &link);
        assert_int_equal(status, TRK_OK);
        status = trk_spec_set_link(copy, 1, &link);
    }
    trk_spec_destroy(spec);
    trk_spec_destroy(copy);
    return status;
}

static void lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(build_and_copy);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(creation),         TEST(names),          TEST(bodies),
        TEST(masses_and_roads), TEST(links),          TEST(sensors_and_ports),
        TEST(reading_back),     TEST(lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
