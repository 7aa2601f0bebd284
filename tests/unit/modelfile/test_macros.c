/* SPDX-License-Identifier: MIT */
/* Needs JSON. Axles, mounts, mirrored parts, frames and tables against the parts they stand for. */
#include "compare.h"

#include <truckride/vehicle.h>

static trk_spec *parse(trk_context *c, const char *text)
{
    trk_spec *spec;
    assert_ok(c, trk_model_file_parse(c, text, strlen(text), "x", ".", &spec));
    return spec;
}

#define FILE_OF(sections) "{\"truckride_model\": 1, \"name\": \"x\", " sections "}"

/* The same part of two specs whose ids differ: both are said to be equal by their text. */
static void same_link_by_name(const trk_spec *x, const trk_spec *y, const char *name)
{
    trk_link_options a, b;
    trk_link_options_init(&a, sizeof a);
    trk_link_options_init(&b, sizeof b);
    const int32_t i = trk_spec_find(x, TRK_PART_LINK, name),
                  j = trk_spec_find(y, TRK_PART_LINK, name);
    if (!i || !j)
        fail_msg("no link '%s'", name);
    assert_int_equal(trk_spec_get_link(x, i, &a), TRK_OK);
    assert_int_equal(trk_spec_get_link(y, j, &b), TRK_OK);
    const char *ends[2][3] = {{trk_spec_part_name(x, TRK_PART_BODY, a.from_body),
                               trk_spec_part_name(x, TRK_PART_BODY, a.to_body),
                               trk_spec_part_name(x, TRK_PART_ROAD, a.from_road)},
                              {trk_spec_part_name(y, TRK_PART_BODY, b.from_body),
                               trk_spec_part_name(y, TRK_PART_BODY, b.to_body),
                               trk_spec_part_name(y, TRK_PART_ROAD, b.from_road)}};
    for (int k = 0; k < 3; k++) {
        assert_int_equal(ends[0][k] == NULL, ends[1][k] == NULL);
        if (ends[0][k])
            assert_string_equal(ends[0][k], ends[1][k]);
    }
    SAME(motion);
    SAME(direction);
    SAME(stiffness);
    SAME(damping);
    if (a.motion == TRK_MOTION_TRANSLATION) {
        SAME(from_point);
        SAME(to_point);
    }
}

/* The reference tractor in the words of engineers is that of vehicle.h: other order, same parts. */
static void reference_truck(void **state)
{
    trk_context *c = *state;
    trk_spec *built_in,
        *file = parse(
            c,
            FILE_OF(
                "\"bodies\": {"
                " \"cab\": {\"mass\": 1242.63, \"inertia\": [1490, 1273, 1476.4], \"cg\": [0.4969, "
                "0, 1.5704],"
                "   \"freedoms\": [\"x\", \"y\", \"z\", \"roll\", \"pitch\", \"yaw\"]},"
                " \"frame\": {\"mass\": 5842.370, \"inertia\": [921.863, 18588.582, 20324.320],"
                "   \"cg\": [-2.22547, 0, 0.56823], \"freedoms\": [\"z\", \"roll\", \"pitch\"]}},"
                "\"axles\": {"
                " \"front\": {\"x\": 0, \"mass\": 1084.781, \"roll_inertia\": 733.815, \"frame\": "
                "\"frame\","
                "   \"tires\": {\"y\": 1.033, \"stiffness\": 817500, \"damping\": 500},"
                "   \"springs\": {\"y\": 0.571, \"stiffness\": 222276}, \"dampers\": {\"y\": "
                "0.5425, \"damping\": 20000},"
                "   \"anti_roll_bar\": 145900},"
                " \"rear\": {\"x\": -4.5, \"mass\": 1097.581, \"roll_inertia\": 782.728, "
                "\"frame\": \"frame\","
                "   \"tires\": {\"y\": 1.035, \"stiffness\": 817500, \"damping\": 500},"
                "   \"springs\": {\"y\": 0.62, \"stiffness\": 256061.9}, \"dampers\": {\"y\": "
                "0.625, \"damping\": 20000}}},"
                "\"mounts\": {"
                " \"cab_front\": {\"mirror\": true, \"from\": \"frame\", \"to\": \"cab\", "
                "\"point\": [1.325, 0.655, 0.387],"
                "   \"vertical\": {\"stiffness\": 40000, \"damping\": 4807.69},"
                "   \"longitudinal\": {\"point\": [1.035, 0.505, 0.596], \"stiffness\": 4e5, "
                "\"damping\": 2000}},"
                " \"cab_rear\": {\"mirror\": true, \"from\": \"frame\", \"to\": \"cab\", "
                "\"point\": [-0.475, 0.5625, 0.35],"
                "   \"vertical\": {\"stiffness\": 13750, \"damping\": 2307.69},"
                "   \"lateral\": {\"point\": [-0.475, 0.35, 0.56], \"stiffness\": 1.5e5, "
                "\"damping\": 1000}}}"));
    assert_ok(c, trk_vehicle_create_builtin(c, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_LINEAR,
                                            &built_in));
    assert_int_equal(trk_spec_count(file, TRK_PART_LINK), trk_spec_count(built_in, TRK_PART_LINK));
    for (int32_t id = 1; id <= trk_spec_count(file, TRK_PART_LINK); id++)
        same_link_by_name(built_in, file, trk_spec_part_name(file, TRK_PART_LINK, id));
    assert_int_equal(trk_spec_count(file, TRK_PART_BODY), 4);
    for (int32_t id = 1; id <= 4; id++)
        same_part(built_in, file, TRK_PART_BODY, id);
    for (int32_t id = 1; id <= 4; id++)
        same_part(built_in, file, TRK_PART_ROAD, id);
    trk_spec_destroy(built_in);
    trk_spec_destroy(file);
}

/* Left and right: names, points, references, and directions as a mirror shows them. */
static void mirrored_parts(void **state)
{
    trk_context *c = *state;
    trk_spec *short_form = parse(
        c, FILE_OF("\"bodies\": {\"cab\": {\"mass\": 1}, \"beam_*_1\": {\"mirror\": true, "
                   "\"mass\": 3, \"cg\": [1, 2, 3]},"
                   "  \"seat\": {\"mirror\": true, \"mass\": 9, \"cg\": [0, 0, 1]}},"
                   "\"masses\": {\"*_tank\": {\"mirror\": true, \"body\": \"beam_*_1\", \"mass\": "
                   "5, \"point\": [1, 2, 3]}},"
                   "\"roads\": {\"r\": {\"mirror\": true, \"x\": 1, \"y\": 2}},"
                   "\"links\": {\"k_*\": {\"mirror\": true, \"from\": {\"road\": \"r_*\"}, \"to\": "
                   "{\"body\": \"seat_*\","
                   "   \"point\": [0, 1, 0]}, \"direction\": [0, 0.6, 0.8]},"
                   " \"t\": {\"mirror\": true, \"from\": \"ground\", \"to\": \"seat_*\", "
                   "\"motion\": \"rotation\","
                   "   \"direction\": [1, 2, 3], \"law\": {\"seal\": {\"sliding\": 3}}}},"
                   "\"ports\": {\"p\": {\"mirror\": true, \"body\": \"cab\", \"point\": [1, 2, 3], "
                   "\"direction\": \"y\"}},"
                   "\"sensors\": {\"s_*_y\": {\"mirror\": true, \"body\": \"seat_*\", \"point\": "
                   "[1, 2, 3], \"direction\": \"y\"},"
                   " \"f\": {\"mirror\": true, \"quantity\": \"force\", \"link\": \"k_*\"}}"));
    trk_spec *long_form = parse(
        c,
        FILE_OF(
            "\"bodies\": {\"cab\": {\"mass\": 1}, \"beam_left_1\": {\"mass\": 3, \"cg\": [1, 2, "
            "3]},"
            "  \"beam_right_1\": {\"mass\": 3, \"cg\": [1, -2, 3]},"
            "  \"seat_left\": {\"mass\": 9, \"cg\": [0, 0, 1]}, \"seat_right\": {\"mass\": 9, "
            "\"cg\": [0, 0, 1]}},"
            "\"masses\": {\"left_tank\": {\"body\": \"beam_left_1\", \"mass\": 5, \"point\": [1, "
            "2, 3]},"
            "  \"right_tank\": {\"body\": \"beam_right_1\", \"mass\": 5, \"point\": [1, -2, 3]}},"
            "\"roads\": {\"r_left\": {\"x\": 1, \"y\": 2}, \"r_right\": {\"x\": 1, \"y\": -2}},"
            "\"links\": {\"k_left\": {\"from\": {\"road\": \"r_left\"}, \"to\": {\"body\": "
            "\"seat_left\","
            "   \"point\": [0, 1, 0]}, \"direction\": [0, 0.6, 0.8]},"
            " \"k_right\": {\"from\": {\"road\": \"r_right\"}, \"to\": {\"body\": \"seat_right\","
            "   \"point\": [0, -1, 0]}, \"direction\": [0, -0.6, 0.8]},"
            " \"t_left\": {\"from\": \"ground\", \"to\": \"seat_left\", \"motion\": \"rotation\","
            "   \"direction\": [1, 2, 3], \"law\": {\"name\": \"t\", \"seal\": {\"sliding\": 3}}},"
            " \"t_right\": {\"from\": \"ground\", \"to\": \"seat_right\", \"motion\": \"rotation\","
            "   \"direction\": [-1, 2, -3], \"law\": {\"name\": \"t\", \"seal\": {\"sliding\": "
            "3}}}},"
            "\"ports\": {\"p_left\": {\"body\": \"cab\", \"point\": [1, 2, 3], \"direction\": "
            "\"y\"},"
            "  \"p_right\": {\"body\": \"cab\", \"point\": [1, -2, 3], \"direction\": \"y\"}},"
            "\"sensors\": {\"s_left_y\": {\"body\": \"seat_left\", \"point\": [1, 2, 3], "
            "\"direction\": \"y\"},"
            "  \"s_right_y\": {\"body\": \"seat_right\", \"point\": [1, -2, 3], \"direction\": "
            "\"y\"},"
            "  \"f_left\": {\"quantity\": \"force\", \"link\": \"k_left\"},"
            "  \"f_right\": {\"quantity\": \"force\", \"link\": \"k_right\"}}"));
    same_specs(short_form, long_form);
    trk_spec_destroy(short_form);
    trk_spec_destroy(long_form);
}

static void write_file(const char *path, const char *text)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

/* The spring curve of the only link of a file. */
static const double *curve_of(trk_context *c, const char *curve, trk_spec **out_spec,
                              int64_t *count, const double **out_x)
{
    char text[1024];
    trk_link_options link;
    snprintf(
        text, sizeof text,
        FILE_OF("\"bodies\": {\"a\": {}}, \"links\": {\"l\": {\"from\": \"ground\", \"to\": \"a\","
                " \"spring_curve\": {%s}}}"),
        curve);
    trk_link_options_init(&link, sizeof link);
    *out_spec = parse(c, text);
    assert_int_equal(trk_spec_get_link(*out_spec, 1, &link), TRK_OK);
    *count = trk_curve_count(link.spring_curve);
    *out_x = trk_curve_x(link.spring_curve);
    return trk_curve_y(link.spring_curve);
}

static void tables(void **state)
{
    trk_context *c = *state;
    static const struct {
        const char *curve;
        int64_t count;
        double x[5], y[5];
    } cases[] = {
        {"\"csv\": \"table.csv\"", 3, {-0.1, 0, 0.2}, {-3000, 0, 1000}},
        {"\"csv\": \"table.csv\", \"x\": \"velocity\", \"y\": \"warm\"",
         3,
         {-0.1, 0, 0.2},
         {-2000, 5, 900}},
        {"\"csv\": \"table.csv\", \"x\": 1, \"y\": 3", 3, {-0.1, 0, 0.2}, {-2000, 5, 900}},
        {"\"csv\": \"table.csv\", \"x_scale\": -1, \"y_scale\": -2",
         3,
         {-0.2, 0, 0.1},
         {-2000, 0, 6000}},
        {"\"points\": [[0, 1], [1, 2], [2, 5]], \"x_scale\": -0.5", 3, {-1, -0.5, 0}, {5, 2, 1}},
        {"\"points\": [[0, 1], [1, 2], [2, 5], [3, 7], [4, 9]], \"x_scale\": -1",
         5,
         {-4, -3, -2, -1, 0},
         {9, 7, 5, 2, 1}},
    };
    write_file("table.csv",
               "velocity [mm/s],cold [kN],warm [N]\n-100,-3,-2000\n0,0,5\n200,1,900\n");
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        trk_spec *spec;
        int64_t count;
        const double *x, *y = curve_of(c, cases[k].curve, &spec, &count, &x);
        assert_int_equal(count, cases[k].count);
        for (int64_t i = 0; i < count; i++) {
            assert_near(x[i], cases[k].x[i], 1e-15);
            assert_near(y[i], cases[k].y[i], 1e-11);
        }
        trk_spec_destroy(spec);
    }
    remove("table.csv");
}

static void refuse_table(trk_context *c, const char *curve, const char *folder, trk_status status,
                         const char *message)
{
    char text[1024];
    trk_spec *spec;
    snprintf(text, sizeof text, FILE_OF("\"curves\": {\n\"d\": {%s}}"), curve);
    assert_status(c, trk_model_file_parse(c, text, strlen(text), "x", folder, &spec), status);
    assert_message(c, message);
    assert_null(spec);
}

static void tables_that_are_wrong(void **state)
{
    trk_context *c = *state;
    refuse_table(c, "\"csv\": \"none.csv\"", ".", TRK_E_FILE, "x:2:14: none.csv: cannot be read");
    refuse_table(c, "\"csv\": \"none.csv\"", "no/where", TRK_E_FILE, "x:2:14: no/where/none.csv: ");
    refuse_table(c, "\"csv\": \"none.csv\"", NULL, TRK_E_FILE,
                 "x:2:14: curve 'd' is in 'none.csv'");
    refuse_table(c, "\"csv\": \"/etc/passwd\"", ".", TRK_E_FILE, "relative to the folder");
    refuse_table(c, "\"csv\": \"\"", ".", TRK_E_FILE, "relative to the folder");
    write_file("bad.csv", "v,f\n1,2\n2,x\n");
    refuse_table(c, "\"csv\": \"bad.csv\"", ".", TRK_E_SYNTAX,
                 "x:2:14: bad.csv:3:3: expected a number");
    write_file("bad.csv", "v,force\n0,1\n2,2\n1,3\n");
    refuse_table(c, "\"csv\": \"bad.csv\"", ".", TRK_E_RANGE,
                 "bad.csv:4: column 1 goes from 2 to 1");
    refuse_table(
        c, "\"csv\": \"bad.csv\", \"y\": \"forc\"", ".", TRK_E_NAME,
        "x:2:30: bad.csv has no column 'forc', which curve 'd' names; did you mean 'force'?");
    refuse_table(c, "\"csv\": \"bad.csv\", \"y\": 3", ".", TRK_E_RANGE, "columns 1 to 2");
    refuse_table(c, "\"csv\": \"bad.csv\", \"y\": []", ".", TRK_E_SYNTAX, "x:2:30: ");
    refuse_table(c, "\"csv\": \"bad.csv\", \"decimal_comma\": 1", ".", TRK_E_SYNTAX,
                 "true or false");
    write_file("bad.csv", "v;f\n0,5;1\n1;2\n");
    refuse_table(c, "\"csv\": \"bad.csv\"", ".", TRK_E_SYNTAX, "decimal comma");
    trk_spec *spec;
    int64_t count;
    const double *x,
        *y = curve_of(c, "\"csv\": \"bad.csv\", \"decimal_comma\": true", &spec, &count, &x);
    assert_true(x[0] == 0.5 && y[1] == 2);
    trk_spec_destroy(spec);
    remove("bad.csv");
}

static const char frame_text[] = FILE_OF(
    "\"materials\": {\"steel\": {\"young\": 2.1e11, \"shear\": 8.1e10, \"density\": 7850}},"
    "\"sections\": {\"u\": {\"channel\": {\"height\": 0.27, \"width\": 0.08, \"web\": 0.007, "
    "\"flange\": 0.008},"
    "  \"material\": \"steel\"}},"
    "\"frames\": {\"frame\": {\"stations\": [1, 0, -4.5], \"cross_members\": [1, -4.5], "
    "\"half_width\": 0.4, \"z\": 0.6,"
    "  \"longest\": 2, \"member_elements\": 2, \"rail\": {\"section\": \"u\", \"torsion\": 5e4},"
    "  \"member\": {\"section\": {\"tube\": {\"outer\": 0.1, \"wall\": 0.005}, \"material\": "
    "\"steel\"}, \"stiffness_damping\": 1e-4}}},"
    "\"axles\": {\"rear\": {\"x\": -4.5, \"mass\": 1000, \"roll_inertia\": 700, \"frame\": "
    "\"frame\","
    "  \"tires\": {\"y\": [0.8, 1.1], \"stiffness\": 8e5}, \"springs\": {\"y\": 0.5, "
    "\"stiffness\": 2e5}}},"
    "\"masses\": {\"engine\": {\"frame\": \"frame\", \"mass\": 900, \"point\": [0.2, 0.3, 0.6]}},"
    "\"sensors\": {\"s\": {\"frame\": \"frame\", \"point\": [-4.5, -0.4, 0.6]}}");

static void frames(void **state)
{
    trk_context *c = *state;
    trk_spec *file = parse(c, frame_text), *by_hand;
    trk_frame_options frame;
    trk_beam_options rail, member;
    const double station[] = {1, 0, -4.5}, cross[] = {1, -4.5};
    trk_frame_options_init(&frame, sizeof frame);
    trk_beam_options_init(&rail, sizeof rail);
    trk_beam_options_init(&member, sizeof member);
    assert_ok(c,
              trk_beam_options_channel(c, 2.1e11, 8.1e10, 7850, 0.27, 0.08, 0.007, 0.008, &rail));
    assert_ok(c, trk_beam_options_tube(c, 2.1e11, 8.1e10, 7850, 0.1, 0.005, &member));
    rail.torsion = 5e4;
    member.stiffness_damping = 1e-4;
    frame.stations = 3;
    frame.station = station;
    frame.crosses = 2;
    frame.cross = cross;
    frame.half_width = 0.4;
    frame.z = 0.6;
    frame.longest = 2;
    frame.member_elements = 2;
    frame.rail = &rail;
    frame.member = &member;
    assert_ok(c, trk_spec_create(c, "x", &by_hand));
    assert_ok(c, trk_spec_add_frame(by_hand, "frame", &frame));
    for (int32_t id = 1; id <= trk_spec_count(by_hand, TRK_PART_BODY); id++)
        same_part(by_hand, file, TRK_PART_BODY, id);
    assert_int_equal(trk_spec_count(by_hand, TRK_PART_BEAM), trk_spec_count(file, TRK_PART_BEAM));
    for (int32_t id = 1; id <= trk_spec_count(by_hand, TRK_PART_BEAM); id++)
        same_part(by_hand, file, TRK_PART_BEAM, id);

    trk_link_options spring;
    trk_link_options_init(&spring, sizeof spring);
    assert_int_equal(
        trk_spec_get_link(file, trk_spec_find(file, TRK_PART_LINK, "rear_right_spring"), &spring),
        TRK_OK);
    int32_t node = 0, body = 0;
    assert_ok(c,
              trk_spec_nearest_body(by_hand, "frame.*", (const double[]){-4.5, -0.4, 0.6}, &node));
    assert_int_equal(spring.to_body, node);
    assert_int_equal(trk_spec_get_mass(file, 1, &body, NULL, NULL), TRK_OK);
    assert_string_equal(trk_spec_part_name(file, TRK_PART_BODY, body), "frame.left.2");
    static const char *const roads[] = {"rear_left_1", "rear_left_2", "rear_right_1",
                                        "rear_right_2"};
    for (int32_t id = 1; id <= 4; id++)
        assert_string_equal(trk_spec_part_name(file, TRK_PART_ROAD, id), roads[id - 1]);
    trk_spec_destroy(by_hand);
    trk_spec_destroy(file);
}

static trk_status parse_once(trk_context *c)
{
    static const char text[] = FILE_OF(
        "\"curves\": {\"c\": {\"csv\": \"oom.csv\"}}, \"laws\": {\"l\": {\"stops\": "
        "{\"bump_stiffness\": 5}}},"
        "\"bodies\": {\"a\": {\"mass\": 1}, \"b\": {\"mirror\": true, \"mass\": 2}},"
        "\"links\": {\"l\": {\"mirror\": true, \"from\": \"a\", \"to\": \"b_*\", \"spring_curve\": "
        "\"c\", \"law\": \"l\","
        "  \"damper_curve\": {\"points\": [[0, 0], [1, 1]]}}, \"m\": {\"from\": \"ground\", "
        "\"to\": \"a\","
        "  \"law\": {\"leaf\": {\"friction\": 1, \"approach_bump\": 1}}}},"
        "\"frames\": {\"f\": {\"stations\": [0, 1], \"cross_members\": [0], \"half_width\": 1,"
        "  \"rail\": {\"axial\": 1, \"mass_per_length\": 1}, \"member\": {\"axial\": 1}}}");
    trk_spec *spec;
    const trk_status status = trk_model_file_parse(c, text, strlen(text), "x", ".", &spec);
    trk_spec_destroy(spec);
    return status;
}

static trk_status read_once(trk_context *c)
{
    trk_spec *spec;
    const trk_status status = trk_model_file_read(c, "oom.json", &spec);
    trk_spec_destroy(spec);
    return status;
}

static void memory(void **state)
{
    (void)state;
    write_file("oom.csv", "a,b\n0,1\n1,2\n2,3\n");
    write_file("oom.json", FILE_OF("\"bodies\": {\"a\": {}}"));
    support_exhaust_memory(parse_once);
    support_exhaust_memory(read_once);
    remove("oom.csv");
    remove("oom.json");
}

static void arguments(void **state)
{
    trk_context *c = *state;
    trk_spec *spec = (trk_spec *)c;
    assert_status(c, trk_model_file_parse(c, NULL, 1, "x", NULL, &spec), TRK_E_ARGUMENT);
    assert_null(spec);
    assert_status(c, trk_model_file_parse(c, NULL, 0, "x", NULL, &spec), TRK_E_SYNTAX);
    assert_status(c, trk_model_file_parse(c, "{}", 2, NULL, NULL, &spec), TRK_E_ARGUMENT);
    assert_status(c, trk_model_file_parse(c, "{}", 2, "x", NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_file_parse(NULL, "{}", 2, "x", NULL, &spec), TRK_E_ARGUMENT);
    assert_status(c, trk_model_file_read(c, NULL, &spec), TRK_E_ARGUMENT);
    assert_status(c, trk_model_file_read(c, "x", NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_model_file_read(NULL, "x", &spec), TRK_E_ARGUMENT);
    assert_status(c, trk_model_file_read(c, "no/such.json", &spec), TRK_E_FILE);
    assert_message(c, "no/such.json: cannot be read");
    assert_status(c, trk_model_file_read(c, ".", &spec), TRK_E_FILE);
    /* Not more than length is read. */
    static const char text[] = "{\"truckride_model\": 1, \"name\": \"x\"}rubbish";
    assert_ok(c, trk_model_file_parse(c, text, sizeof text - 8, "x", NULL, &spec));
    trk_spec_destroy(spec);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(reference_truck, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(mirrored_parts, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(tables, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(tables_that_are_wrong, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(frames, support_setup, support_teardown),
        cmocka_unit_test(memory),
        cmocka_unit_test_setup_teardown(arguments, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
