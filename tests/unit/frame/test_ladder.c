/* SPDX-License-Identifier: MIT */
/* Nodes and beams of a ladder frame, finding them, refusals, memory that runs out. */
#include "support.h"

#include <truckride/frame.h>

static const double stations[] = {0.8, 0, -2, -5}, crosses[] = {0, -5};

/* What the options of a frame point to. */
typedef struct sections {
    trk_beam_options rail, member;
} sections;

static trk_frame_options make(sections *s)
{
    trk_beam_options_init(&s->rail, sizeof s->rail);
    s->rail.bending_y = 1e6;
    s->rail.mass_per_length = 40;
    trk_beam_options_init(&s->member, sizeof s->member);
    s->member.bending_y = 2e5;
    s->member.stiffness_damping = 1e-4;
    trk_frame_options o;
    trk_frame_options_init(&o, sizeof o);
    o.stations = 4;
    o.station = stations;
    o.crosses = 2;
    o.cross = crosses;
    o.half_width = 0.4;
    o.z = 0.9;
    o.rail = &s->rail;
    o.member = &s->member;
    return o;
}

static trk_spec *empty(trk_context *context)
{
    trk_spec *spec;
    assert_ok(context, trk_spec_create(context, "truck", &spec));
    return spec;
}

static void check_node(const trk_spec *spec, const char *name, double x, double y)
{
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    int32_t id = trk_spec_find(spec, TRK_PART_BODY, name);
    assert_int_equal(trk_spec_get_body(spec, id, &body), TRK_OK);
    assert_near(body.cg[0], x, 1e-15);
    assert_near(body.cg[1], y, 1e-15);
    assert_near(body.cg[2], 0.9, 0);
    assert_true(body.mass == 0);
}

/* A beam runs between the named nodes and has the section with this bending stiffness. */
static void check_beam(const trk_spec *spec, const char *name, const char *from, const char *to,
                       double bending)
{
    trk_beam_options beam;
    trk_beam_options_init(&beam, sizeof beam);
    int32_t id = trk_spec_find(spec, TRK_PART_BEAM, name);
    assert_int_equal(trk_spec_get_beam(spec, id, &beam), TRK_OK);
    assert_string_equal(trk_spec_part_name(spec, TRK_PART_BODY, beam.from_body), from);
    assert_string_equal(trk_spec_part_name(spec, TRK_PART_BODY, beam.to_body), to);
    check_node(spec, from, beam.from_point[0], beam.from_point[1]);
    check_node(spec, to, beam.to_point[0], beam.to_point[1]);
    assert_true(beam.bending_y == bending);
}

static void nodes_and_beams(void **state)
{
    sections s;
    trk_frame_options o = make(&s);
    trk_spec *spec = empty(*state);
    assert_ok(*state, trk_spec_add_frame(spec, "frame", &o));
    assert_int_equal(trk_spec_count(spec, TRK_PART_BODY), 8);
    assert_int_equal(trk_spec_count(spec, TRK_PART_BEAM), 8);
    for (int k = 0; k < 4; k++) {
        char name[32];
        snprintf(name, sizeof name, "frame.left.%d", k + 1);
        check_node(spec, name, stations[k], 0.4);
        snprintf(name, sizeof name, "frame.right.%d", k + 1);
        check_node(spec, name, stations[k], -0.4);
    }
    check_beam(spec, "frame.left.1", "frame.left.1", "frame.left.2", 1e6);
    check_beam(spec, "frame.right.3", "frame.right.3", "frame.right.4", 1e6);
    check_beam(spec, "frame.cross.1.1", "frame.left.2", "frame.right.2", 2e5);
    check_beam(spec, "frame.cross.2.1", "frame.left.4", "frame.right.4", 2e5);
    assert_ok(*state, trk_spec_add_frame(spec, "trailer", &o));
    check_beam(spec, "trailer.cross.2.1", "trailer.left.4", "trailer.right.4", 2e5);
    trk_spec_destroy(spec);
}

/* 0.8, 2 and 3 m in elements of at most 1 m; members in three elements. */
static void division(void **state)
{
    sections s;
    trk_frame_options o = make(&s);
    o.longest = 1;
    o.member_elements = 3;
    trk_spec *spec = empty(*state);
    assert_ok(*state, trk_spec_add_frame(spec, "frame", &o));
    assert_int_equal(trk_spec_count(spec, TRK_PART_BODY), 2 * 7 + 2 * 2);
    assert_int_equal(trk_spec_count(spec, TRK_PART_BEAM), 2 * 6 + 2 * 3);
    check_node(spec, "frame.right.3", -1, -0.4);
    check_node(spec, "frame.left.7", -5, 0.4);
    check_node(spec, "frame.cross.2.1", -5, 0.4 / 3);
    check_beam(spec, "frame.cross.1.1", "frame.left.2", "frame.cross.1.1", 2e5);
    check_beam(spec, "frame.cross.1.2", "frame.cross.1.1", "frame.cross.1.2", 2e5);
    check_beam(spec, "frame.cross.2.3", "frame.cross.2.2", "frame.right.7", 2e5);
    trk_spec_destroy(spec);
    spec = empty(*state); /* 3 m in 30 elements, not 31 */
    o.longest = 0.1;
    assert_ok(*state, trk_spec_add_frame(spec, "frame", &o));
    assert_int_not_equal(trk_spec_find(spec, TRK_PART_BEAM, "frame.left.58"), 0);
    assert_int_equal(trk_spec_find(spec, TRK_PART_BEAM, "frame.left.59"), 0);
    trk_spec_destroy(spec);
}

static void freedoms(void **state)
{
    sections s;
    trk_frame_options o = make(&s);
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    assert_int_equal(o.freedoms, 63);
    o.freedoms = TRK_FREE_Z | TRK_FREE_ROLL | TRK_FREE_PITCH;
    trk_spec *spec = empty(*state);
    assert_ok(*state, trk_spec_add_frame(spec, "frame", &o));
    assert_ok(*state, trk_spec_get_body(spec, 5, &body));
    assert_int_equal(body.freedoms, o.freedoms);
    trk_spec_destroy(spec);
}

static void nearest(void **state)
{
    sections s;
    trk_frame_options o = make(&s);
    trk_spec *spec = empty(*state);
    trk_body_options engine;
    trk_body_options_init(&engine, sizeof engine);
    assert_ok(*state, trk_spec_add_body(spec, "engine", &engine, NULL));
    assert_ok(*state, trk_spec_add_frame(spec, "frame", &o));
    int32_t id;
    assert_ok(*state, trk_spec_nearest_body(spec, "frame.*", (double[]){-1.9, 2, 0}, &id));
    assert_string_equal(trk_spec_part_name(spec, TRK_PART_BODY, id), "frame.left.3");
    assert_ok(*state, trk_spec_nearest_body(spec, "*", (double[]){0, 0, 0.1}, &id));
    assert_int_equal(id, 1);
    assert_ok(*state, trk_spec_nearest_body(spec, "frame.*", (double[]){0, 0, 0}, &id));
    assert_string_equal(trk_spec_part_name(spec, TRK_PART_BODY, id), "frame.left.2"); /* first */
    const double origin[3] = {0, 0, 0};
    assert_status(*state, trk_spec_nearest_body(spec, "chassis", origin, &id), TRK_E_NAME);
    assert_message(*state, "no body of 'truck' is called 'chassis'");
    assert_int_equal(id, 0);
    assert_status(*state, trk_spec_nearest_body(spec, NULL, origin, &id), TRK_E_ARGUMENT);
    assert_status(*state, trk_spec_nearest_body(spec, "*", NULL, &id), TRK_E_ARGUMENT);
    assert_status(*state, trk_spec_nearest_body(spec, "*", (double[]){0, NAN, 0}, &id),
                  TRK_E_RANGE);
    assert_status(*state, trk_spec_nearest_body(spec, "*", origin, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_spec_nearest_body(NULL, "*", origin, &id), TRK_E_ARGUMENT);
    trk_spec_destroy(spec);
}

/* Refused, and nothing of it stays in the spec. */
#define REFUSED(name, status, text)                                                                \
    do {                                                                                           \
        assert_status(*state, trk_spec_add_frame(spec, name, &o), status);                         \
        assert_message(*state, text);                                                              \
        assert_int_equal(trk_spec_count(spec, TRK_PART_BODY), bodies);                             \
        assert_int_equal(trk_spec_count(spec, TRK_PART_BEAM), beams);                              \
        o = make(&s);                                                                              \
    } while (0)

static void refused_numbers(void **state)
{
    sections s;
    trk_frame_options o = make(&s);
    trk_spec *spec = empty(*state);
    const int32_t bodies = 0, beams = 0;
    o.stations = 1;
    REFUSED("f", TRK_E_RANGE, "frame 'f': stations is 1; at least 2 is needed");
    o.crosses = 0;
    REFUSED("f", TRK_E_RANGE, "crosses is 0");
    o.half_width = 0;
    REFUSED("f", TRK_E_RANGE, "half_width is 0; a finite number > 0");
    o.z = NAN;
    REFUSED("f", TRK_E_RANGE, "z is nan");
    o.longest = -1;
    REFUSED("f", TRK_E_RANGE, "longest is -1");
    o.longest = 1e-9;
    REFUSED("f", TRK_E_RANGE, "the number of nodes is");
    o.longest = 1e-320;
    REFUSED("f", TRK_E_RANGE, "the number of nodes is");
    o.member_elements = 0;
    REFUSED("f", TRK_E_RANGE, "member_elements is 0");
    o.reserved = 1;
    REFUSED("f", TRK_E_RANGE, "reserved is 1; 0 is needed");
    o.station = (double[]){0, -1, -0.5, -5};
    REFUSED("f", TRK_E_RANGE, "station 3 is -0.5 m after -1 m; stations must all rise or all fall");
    o.station = (double[]){0, 0, 1, 2};
    REFUSED("f", TRK_E_RANGE, "station 2 is 0 m after 0 m");
    o.station = (double[]){0, 1, INFINITY, 2};
    REFUSED("f", TRK_E_RANGE, "station 3 is inf");
    o.cross = (double[]){0, -3};
    REFUSED("f", TRK_E_RANGE, "cross member 2 at -3 m is not at a station");
    o.cross = (double[]){-2, -2};
    REFUSED("f", TRK_E_RANGE, "cross members 1 and 2 are both at -2 m");
    s.rail.axial = -1;
    REFUSED("f", TRK_E_RANGE, "beam 'f.left.1': axial is -1");
    s.member.torsion = NAN;
    REFUSED("f", TRK_E_RANGE, "beam 'f.cross.1.1': torsion is nan");
    o.freedoms = 64;
    REFUSED("f", TRK_E_ARGUMENT, "body 'f.left.1': freedoms is 64");
    trk_spec_destroy(spec);
}

static void refused_pointers_and_names(void **state)
{
    sections s;
    trk_frame_options o = make(&s);
    trk_spec *spec = empty(*state);
    int32_t bodies = 0, beams = 0;
    o.station = NULL;
    REFUSED("f", TRK_E_ARGUMENT, "station is NULL");
    o.cross = NULL;
    REFUSED("f", TRK_E_ARGUMENT, "cross is NULL");
    o.rail = NULL;
    REFUSED("f", TRK_E_ARGUMENT, "rail is NULL");
    o.member = NULL;
    REFUSED("f", TRK_E_ARGUMENT, "member is NULL");
    o.struct_size = 1;
    REFUSED("f", TRK_E_OPTIONS, "trk_frame_options: struct_size is 1");
    s.rail.struct_size = 2;
    REFUSED("f", TRK_E_OPTIONS, "rail: struct_size is 2");
    s.member.struct_size = 3;
    REFUSED("f", TRK_E_OPTIONS, "member: struct_size is 3");
    REFUSED("", TRK_E_NAME, "has 0 characters; 1 to 100 are needed");
    char name[102];
    memset(name, 'f', 101);
    name[101] = 0;
    REFUSED(name, TRK_E_NAME, "has 101 characters");
    assert_status(*state, trk_spec_add_frame(spec, NULL, &o), TRK_E_ARGUMENT);
    assert_status(*state, trk_spec_add_frame(spec, "f", NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_spec_add_frame(NULL, "f", &o), TRK_E_ARGUMENT);

    /* A name that is taken late: all before it is taken back, and can be added again. */
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    assert_ok(*state, trk_spec_add_body(spec, "f.right.4", &body, NULL));
    bodies = 1;
    REFUSED("f", TRK_E_NAME, "body name 'f.right.4' is already used");
    assert_int_equal(trk_spec_find(spec, TRK_PART_BODY, "f.left.1"), 0);
    assert_int_equal(trk_spec_find(spec, TRK_PART_BODY, "f.right.4"), 1);
    assert_ok(*state, trk_spec_add_body(spec, "f.left.1", &body, NULL));
    name[100] = 0;
    assert_ok(*state, trk_spec_add_frame(spec, name, &o));
    trk_spec_destroy(spec);
}

static trk_status add_twice(trk_context *context)
{
    sections s;
    trk_frame_options o = make(&s);
    o.member_elements = 2;
    trk_spec *spec;
    trk_status status = trk_spec_create(context, "truck", &spec);
    if (status != TRK_OK)
        return status;
    for (int k = 0; status == TRK_OK && k < 2; k++) {
        int32_t bodies = trk_spec_count(spec, TRK_PART_BODY),
                beams = trk_spec_count(spec, TRK_PART_BEAM);
        status = trk_spec_add_frame(spec, k ? "tractor" : "trailer", &o);
        if (status != TRK_OK) {
            assert_int_equal(trk_spec_count(spec, TRK_PART_BODY), bodies);
            assert_int_equal(trk_spec_count(spec, TRK_PART_BEAM), beams);
        }
    }
    trk_spec_destroy(spec);
    return status;
}

static void out_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(add_twice);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {TEST(nodes_and_beams), TEST(division),
                                       TEST(freedoms),        TEST(nearest),
                                       TEST(refused_numbers), TEST(refused_pointers_and_names),
                                       TEST(out_of_memory)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
