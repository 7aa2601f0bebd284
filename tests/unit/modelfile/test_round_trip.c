/* SPDX-License-Identifier: MIT */
/* Needs JSON. What is written reads back as the same spec, to the bit. */
#include "compare.h"

#include <stdbool.h>
#include <float.h>
#include <locale.h>
#include <truckride/vehicle.h>

static void round_trip(trk_context *c, const trk_spec *spec)
{
    trk_spec *back;
    char *text = text_of(c, spec);
    assert_ok(c, trk_model_file_parse(c, text, strlen(text), "x", NULL, &back));
    same_specs(spec, back);
    char *again = text_of(c, back);
    assert_string_equal(text, again);
    free(text);
    free(again);
    trk_spec_destroy(back);
}

static void built_in_vehicles(void **state)
{
    trk_context *c = *state;
    for (trk_vehicle vehicle = 1; vehicle <= TRK_VEHICLE_REFERENCE_TRUCK; vehicle++)
        for (trk_variant variant = 0; variant <= TRK_VARIANT_NONLINEAR; variant++) {
            trk_spec *spec;
            assert_ok(c, trk_vehicle_create_builtin(c, vehicle, variant, &spec));
            round_trip(c, spec);
            trk_spec_destroy(spec);
        }
}

static uint64_t seed;

static uint64_t draw(uint64_t below)
{
    seed = seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (seed >> 33) % below;
}

/* Any double that is not negative: whole, decimal, of all magnitudes, tiny. */
static double positive(void)
{
    static const double odd[] = {DBL_MAX, DBL_MIN, 4.9406564584124654e-324, 1e22,
                                 123456789012345680.0};
    switch (draw(5)) {
    case 0: return (double)(1 + draw(1000));
    case 1: return (double)(1 + draw(100000)) / 1000;
    case 2: return ldexp((double)(1 + draw(UINT64_C(1) << 31)) + 0.1, (int)draw(200) - 100);
    case 3: return odd[draw(5)];
    default: return (1 + (double)draw(UINT64_C(1) << 31)) / 3;
    }
}

static double any(void)
{
    return draw(8) == 0 ? -0.0 : draw(3) == 0 ? 0 : draw(2) ? positive() : -positive();
}

static void fill(double *x, int count, double (*value)(void))
{
    for (int k = 0; k < count; k++)
        x[k] = value();
}

static void direction(double *d)
{
    static const double some[][3] = {
        {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {0.5, 0, 1e-9}, {-0.0, 1, 0}};
    memcpy(d, some[draw(5)], sizeof some[0]);
}

static trk_curve *curve(trk_context *c)
{
    static const char *const names[] = {"damper", "damper", "a \"quoted\" name\n", "", "\303\244"};
    trk_curve_options options;
    trk_curve *out;
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = (trk_interpolation)draw(5);
    options.extrapolation = (trk_extrapolation)draw(2);
    double x[40], y[40];
    const bool alike = draw(3) == 0; /* to another one but for y */
    const int count = alike ? 4 : 4 + (int)draw(37);
    if (alike)
        trk_curve_options_init(&options, sizeof options);
    for (int k = 0; k < count; k++) {
        x[k] = alike ? k : k == 0 ? -(double)draw(9) / 7 : x[k - 1] + (double)(1 + draw(50)) / 300;
        y[k] = ((double)draw(2000) - 1000) / 3;
    }
    assert_ok(c, trk_curve_create(c, names[draw(5)], count, x, y, &options, &out));
    return out;
}

#define MODERATE ((double)(1 + draw(100000)) / 7)

static trk_law *law(trk_context *c)
{
    static const char *const names[] = {"leaf", "stop", "", "cab"};
    const char *name = names[draw(4)];
    trk_law *out;
    switch (draw(6)) {
    case 0: {
        trk_tire_options o;
        trk_tire_options_init(&o, sizeof o);
        o.stiffness = MODERATE;
        o.preload = draw(2) ? 0 : MODERATE;
        assert_ok(c, trk_law_create_tire(c, name, &o, &out));
        break;
    }
    case 1: {
        const double x[] = {0, 0.01, 0.03}, y[] = {0, 100, 500};
        trk_curve *bump = NULL;
        trk_stops_options o;
        trk_stops_options_init(&o, sizeof o);
        o.bump_clearance = MODERATE;
        o.rebound_stiffness = MODERATE;
        if (draw(2))
            assert_ok(c, trk_curve_create(c, "rubber", 3, x, y, NULL, &bump));
        o.bump_curve = bump;
        assert_ok(c, trk_law_create_stops(c, name, &o, &out));
        trk_curve_destroy(bump);
        break;
    }
    case 2: {
        trk_leaf_options o;
        trk_leaf_options_init(&o, sizeof o);
        o.friction = MODERATE;
        o.approach_bump = 0.001;
        o.approach_rebound = draw(2) ? 0 : 0.003;
        assert_ok(c, trk_law_create_leaf(c, name, &o, &out));
        break;
    }
    case 3: {
        trk_friction_options o;
        trk_friction_options_init(&o, sizeof o);
        o.friction = MODERATE;
        o.stiffness = MODERATE;
        assert_ok(c, trk_law_create_friction(c, name, &o, &out));
        break;
    }
    case 4: {
        trk_air_spring_options o;
        trk_air_spring_options_init(&o, sizeof o);
        o.pressure = 5e5;
        o.volume = 0.01;
        o.area = 0.03;
        o.auxiliary_volume = draw(2) ? 0 : 0.02;
        o.exponent = draw(2) ? 1.38 : 1.2;
        assert_ok(c, trk_law_create_air_spring(c, name, &o, &out));
        break;
    }
    default: {
        trk_seal_options o;
        trk_seal_options_init(&o, sizeof o);
        o.sliding = MODERATE;
        o.breakaway = 2 * o.sliding;
        assert_ok(c, trk_law_create_seal(c, name, &o, &out));
    }
    }
    return out;
}

enum { BODIES = 6, LINKS = 9, BEAMS = 4 };

static void name_part(char *out, size_t size, const char *word, int k)
{
    static const char *const odd[] = {"", "*", " \\ ", "\"", "\t", ".left.1", "\360\237\232\233"};
    snprintf(out, size, "%s%s %d", word, odd[draw(7)], k);
}

static void add_bodies(trk_context *c, trk_spec *spec)
{
    char name[64];
    for (int k = 1; k <= BODIES; k++) {
        trk_body_options o;
        trk_body_options_init(&o, sizeof o);
        o.freedoms = 1 + (int32_t)draw(63);
        o.mass = positive();
        fill(o.inertia, 3, positive);
        fill(o.cg, 3, any);
        name_part(name, sizeof name, k == 1 ? "ground" : "body", k);
        assert_ok(c, trk_spec_add_body(spec, k == 2 ? "ground" : name, &o, NULL));
        const double point[3] = {any(), any(), any()};
        name_part(name, sizeof name, "tank", k);
        assert_ok(c, trk_spec_add_mass(spec, name, k, positive(), point, NULL));
        name_part(name, sizeof name, "road", k);
        assert_ok(c, trk_spec_add_road(spec, name, any(), any(), NULL));
    }
}

static void add_link(trk_context *c, trk_spec *spec, int k)
{
    char name[64];
    trk_link_options o;
    trk_link_options_init(&o, sizeof o);
    o.to_body = 1 + (int32_t)draw(BODIES);
    const int kind = (int)draw(3);
    o.from_body = kind == 0 ? 1 + o.to_body % BODIES : 0;
    o.from_road = kind == 1 ? 1 + (int32_t)draw(BODIES) : 0;
    o.motion = kind == 1 ? TRK_MOTION_TRANSLATION : (trk_motion)draw(2);
    fill(o.from_point, 3, any);
    fill(o.to_point, 3, any);
    if (draw(2))
        memcpy(o.to_point, o.from_point, sizeof o.to_point);
    direction(o.direction);
    o.stiffness = any();
    o.damping = draw(2) ? 0 : positive();
    o.spring_scale = draw(2) ? 1 : positive();
    o.spring_offset = any();
    trk_curve *spring = draw(2) ? curve(c) : NULL, *damper = draw(2) ? curve(c) : NULL;
    trk_law *own = draw(3) ? law(c) : NULL;
    o.spring_curve = spring;
    o.damper_curve = damper;
    o.law = own;
    name_part(name, sizeof name, "link", k);
    assert_ok(c, trk_spec_add_link(spec, name, &o, NULL));
    if (draw(2)) {
        name_part(name, sizeof name, "the same once more", k);
        assert_ok(c, trk_spec_add_link(spec, name, &o, NULL));
    }
    trk_curve_destroy(spring);
    trk_curve_destroy(damper);
    trk_law_destroy(own);
}

static void add_beam(trk_context *c, trk_spec *spec, int k)
{
    char name[64];
    trk_beam_options o;
    trk_beam_options_init(&o, sizeof o);
    o.from_body = 1 + (int32_t)draw(BODIES);
    o.to_body = 1 + o.from_body % BODIES;
    o.to_point[0] = 0.1 + (double)draw(30) / 7;
    o.from_point[2] = -(double)draw(3) / 9;
    o.axial = MODERATE;
    o.torsion = draw(2) ? 0 : MODERATE;
    o.bending_y = MODERATE;
    o.shear_z = draw(2) ? 0 : MODERATE;
    o.mass_per_length = MODERATE;
    o.stiffness_damping = 1e-4;
    name_part(name, sizeof name, "beam", k);
    assert_ok(c, trk_spec_add_beam(spec, name, &o, NULL));
}

static void add_outside(trk_context *c, trk_spec *spec, int k)
{
    char name[64];
    trk_port_options port;
    trk_sensor_options sensor;
    trk_port_options_init(&port, sizeof port);
    trk_sensor_options_init(&sensor, sizeof sensor);
    port.body = sensor.body = 1 + (int32_t)draw(BODIES);
    port.motion = sensor.motion = (trk_motion)draw(2);
    fill(port.point, 3, any);
    fill(sensor.point, 3, any);
    direction(port.direction);
    direction(sensor.direction);
    sensor.quantity = (trk_quantity)draw(6);
    sensor.link = sensor.quantity > TRK_QUANTITY_ACCELERATION ? 1 + (int32_t)draw(LINKS) : 0;
    name_part(name, sizeof name, "port", k);
    assert_ok(c, trk_spec_add_port(spec, name, &port, NULL));
    name_part(name, sizeof name, "sensor", k);
    assert_ok(c, trk_spec_add_sensor(spec, name, &sensor, NULL));
}

static trk_spec *random_spec(trk_context *c, uint64_t number)
{
    trk_spec *spec;
    seed = number * 977 + 1;
    assert_ok(c, trk_spec_create(c, number % 3 ? "random \302\265 truck" : "", &spec));
    add_bodies(c, spec);
    for (int k = 1; k <= LINKS; k++)
        add_link(c, spec, k);
    for (int k = 1; k <= BEAMS; k++)
        add_beam(c, spec, k);
    for (int k = 1; k <= 5; k++)
        add_outside(c, spec, k);
    return spec;
}

static void random_specs(void **state)
{
    trk_context *c = *state;
    for (uint64_t number = 0; number < 200; number++) {
        trk_spec *spec = random_spec(c, number);
        round_trip(c, spec);
        trk_spec_destroy(spec);
    }
}

/* Two curves of one name that differ in one thing only: each keeps its own. */
static void curves_of_one_name(void **state)
{
    trk_context *c = *state;
    static const struct {
        int64_t count;
        double x, y;
        trk_interpolation interpolation;
        trk_extrapolation extrapolation;
    } cases[] = {{3, 0.5, 2, 0, 0}, {3, 1, 2.5, 0, 0}, {3, 1, 2, 4, 0},
                 {3, 1, 2, 0, 1},   {2, 1, 2, 0, 0},   {3, 1, 2, 0, 0}};
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        trk_spec *spec;
        trk_curve *one, *other;
        trk_link_options link;
        trk_body_options body;
        trk_curve_options options;
        const double x[] = {0, 1, 2}, y[] = {1, 2, 3};
        const double other_x[] = {0, cases[k].x, 2}, other_y[] = {1, cases[k].y, 3};
        trk_curve_options_init(&options, sizeof options);
        assert_ok(c, trk_curve_create(c, "c", 3, x, y, &options, &one));
        options.interpolation = cases[k].interpolation;
        options.extrapolation = cases[k].extrapolation;
        assert_ok(c, trk_curve_create(c, "c", cases[k].count, other_x, other_y, &options, &other));
        trk_link_options_init(&link, sizeof link);
        trk_body_options_init(&body, sizeof body);
        assert_ok(c, trk_spec_create(c, "x", &spec));
        assert_ok(c, trk_spec_add_body(spec, "a", &body, &link.to_body));
        link.spring_curve = one;
        link.damper_curve = other;
        assert_ok(c, trk_spec_add_link(spec, "l", &link, NULL));
        round_trip(c, spec);
        char *text = text_of(c, spec);
        assert_int_equal(strstr(text, "\"name\": \"c\"") == NULL,
                         k == 5); /* the last are the same */
        free(text);
        trk_curve_destroy(one);
        trk_curve_destroy(other);
        trk_spec_destroy(spec);
    }
}

static void locale_with_a_comma(void **state)
{
    trk_context *c = *state;
    static const char *const names[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "nl_NL.UTF-8"};
    const char *found = NULL;
    for (size_t k = 0; !found && k < sizeof names / sizeof *names; k++)
        found = setlocale(LC_ALL, names[k]);
    if (!found)
        skip();
    trk_spec *spec = random_spec(c, 7);
    round_trip(c, spec);
    trk_spec_destroy(spec);
    setlocale(LC_ALL, "C");
}

static void room_for_the_text(void **state)
{
    trk_context *c = *state;
    trk_spec *spec = random_spec(c, 3);
    size_t length = 0, wanted = 0;
    char *whole = text_of(c, spec), *part;
    assert_int_equal(trk_model_file_format(NULL, 0, NULL, &length), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_file_format(spec, 9, NULL, &length), TRK_E_ARGUMENT);
    wanted = strlen(whole);
    part = malloc(wanted + 1);
    assert_non_null(part);
    for (size_t room = 0; room <= wanted; room += 1 + room / 2) {
        memset(part, 'x', wanted + 1);
        assert_int_equal(trk_model_file_format(spec, room, part, &length), TRK_E_RANGE);
        assert_int_equal(length, wanted);
        if (room) {
            assert_int_equal(strlen(part), room - 1);
            assert_memory_equal(part, whole, room - 1);
        }
        assert_int_equal(part[room], 'x');
    }
    assert_ok(c, trk_model_file_format(spec, wanted + 1, part, NULL));
    assert_string_equal(part, whole);
    free(whole);
    free(part);
    trk_spec_destroy(spec);
}

static void names_that_are_no_text(void **state)
{
    trk_context *c = *state;
    trk_spec *spec;
    size_t length;
    assert_ok(c, trk_spec_create(c, "\377", &spec));
    assert_int_equal(trk_model_file_format(spec, 0, NULL, &length), TRK_E_NAME);
    assert_status(c, trk_model_file_write(c, spec, "not_written.json"), TRK_E_NAME);
    assert_message(c, "no UTF-8");
    assert_null(fopen("not_written.json", "rb"));
    assert_null(fopen("not_written.json.part", "rb"));
    trk_spec_destroy(spec);
}

static void files(void **state)
{
    trk_context *c = *state;
    const char *path = "round_trip.json";
    trk_spec *spec = random_spec(c, 11), *back;
    assert_ok(c, trk_model_file_write(c, spec, path));
    assert_ok(c, trk_model_file_read(c, path, &back));
    same_specs(spec, back);
    trk_spec_destroy(back);
    /* What cannot be written leaves the file that was there. */
    assert_status(c, trk_model_file_write(c, spec, "no_such_folder/x.json"), TRK_E_FILE);
    assert_message(c, "no_such_folder");
    assert_status(c, trk_model_file_write(c, NULL, path), TRK_E_ARGUMENT);
    assert_status(c, trk_model_file_write(c, spec, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_file_write(NULL, spec, path), TRK_E_ARGUMENT);
    assert_status(c, trk_model_file_write(c, spec, "/dev/full"), TRK_E_FILE);
    assert_ok(c, trk_model_file_write(c, spec, "/dev/null"));
    remove(path);
    trk_spec_destroy(spec);
}

static trk_status write_once(trk_context *c)
{
    trk_spec *spec;
    trk_status status = trk_vehicle_create_builtin(c, TRK_VEHICLE_REFERENCE_HALF, 2, &spec);
    if (status)
        return status;
    status = trk_model_file_write(c, spec, "exhaust.json");
    trk_spec_destroy(spec);
    remove("exhaust.json");
    return status;
}

static void memory(void **state)
{
    (void)state;
    support_exhaust_memory(write_once);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(built_in_vehicles, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(random_specs, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(curves_of_one_name, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(locale_with_a_comma, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(room_for_the_text, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(names_that_are_no_text, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(files, support_setup, support_teardown),
        cmocka_unit_test(memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
