/* SPDX-License-Identifier: MIT */
/* Static equilibrium (MODEL.5) of the built-in vehicles and of springs with known answers. */
#include "support.h"

#include <truckride/model.h>
#include <truckride/vehicle.h>

enum { LINKS = 60, COORDINATES = 20 };

static trk_model *compile(trk_context *context, const trk_spec *spec, double gravity)
{
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.gravity = gravity;
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, &options, &model));
    return model;
}

static trk_spec *builtin(trk_context *context, trk_vehicle vehicle, trk_variant variant)
{
    trk_spec *spec;
    assert_ok(context, trk_vehicle_create_builtin(context, vehicle, variant, &spec));
    return spec;
}

/* Load on each tire, by where it stands; expected by the lever rule. */
static void check_tire_loads(const trk_spec *spec, const trk_model *model)
{
    const double g = TRK_STANDARD_GRAVITY;
    double force[LINKS], total = 0, front_x = -INFINITY, rear_x = INFINITY, moment = 0, weight = 0;
    int32_t links = trk_spec_count(spec, TRK_PART_LINK);
    assert_in_range(links, 1, LINKS);
    trk_model_get_static(model, NULL, force);
    for (int32_t r = 1; r <= trk_spec_count(spec, TRK_PART_ROAD); r++) {
        double x;
        assert_int_equal(trk_model_get_road_place(model, r, &x, NULL), TRK_OK);
        front_x = fmax(front_x, x);
        rear_x = fmin(rear_x, x);
    }
    for (int32_t b = 1; b <= trk_spec_count(spec, TRK_PART_BODY); b++) {
        trk_body_options body;
        trk_body_options_init(&body, sizeof body);
        assert_int_equal(trk_spec_get_body(spec, b, &body), TRK_OK);
        weight += body.mass * g;
        moment += body.mass * g * (body.cg[0] - rear_x);
    }
    double front = 0;
    for (int32_t k = 1; k <= links; k++) {
        trk_link_options link;
        trk_link_options_init(&link, sizeof link);
        assert_int_equal(trk_spec_get_link(spec, k, &link), TRK_OK);
        if (!link.from_road)
            continue;
        total -= force[k - 1];
        if (link.to_point[0] == front_x)
            front -= force[k - 1];
    }
    assert_near(total, weight, 1e-12 * weight);
    if (front_x > rear_x)
        assert_near(front, moment / (front_x - rear_x), 1e-11 * weight);
}

/* The same on every coordinate: B^T f = w, with w from masses and rows alone. */
static void check_balance(const trk_spec *spec, const trk_model *model)
{
    int32_t n = trk_model_count(model, TRK_PART_COORDINATE),
            links = trk_model_count(model, TRK_PART_LINK);
    double force[LINKS], row[COORDINATES], rest[COORDINATES] = {0}, largest = 0;
    assert_in_range(n, 1, COORDINATES);
    trk_model_get_static(model, NULL, force);
    for (int32_t k = 0; k < links; k++) {
        assert_int_equal(trk_model_get_link_row(model, k + 1, row, NULL), TRK_OK);
        for (int32_t i = 0; i < n; i++)
            rest[i] += row[i] * force[k];
        largest = fmax(largest, fabs(force[k]));
    }
    for (int32_t b = 1; b <= trk_spec_count(spec, TRK_PART_BODY); b++) {
        trk_body_options body;
        trk_body_options_init(&body, sizeof body);
        assert_int_equal(trk_spec_get_body(spec, b, &body), TRK_OK);
        char name[64];
        snprintf(name, sizeof name, "%s.z", trk_spec_part_name(spec, TRK_PART_BODY, b));
        rest[trk_model_find(model, TRK_PART_COORDINATE, name) - 1] +=
            body.mass * TRK_STANDARD_GRAVITY;
    }
    for (int32_t i = 0; i < n; i++)
        assert_near(rest[i], 0, 1e-11 * largest);
}

static void loads_of_builtin_vehicles_are_their_weight(void **state)
{
    for (trk_vehicle v = TRK_VEHICLE_THESIS_QUARTER; v <= TRK_VEHICLE_REFERENCE_TRUCK; v++)
        for (trk_variant variant = TRK_VARIANT_LINEAR; variant <= TRK_VARIANT_NONLINEAR;
             variant++) {
            trk_spec *spec = builtin(*state, v, variant);
            trk_model *model = compile(*state, spec, TRK_STANDARD_GRAVITY);
            assert_near(trk_model_gravity(model), TRK_STANDARD_GRAVITY, 0);
            check_tire_loads(spec, model);
            check_balance(spec, model);
            trk_model_destroy(model);
            trk_spec_destroy(spec);
        }
}

/* Drawn in static equilibrium: under gravity only tires deflect. */
static void nonlinear_variant_is_drawn_at_rest(void **state)
{
    for (trk_vehicle v = TRK_VEHICLE_REFERENCE_FRONT; v <= TRK_VEHICLE_REFERENCE_TRUCK; v++) {
        trk_spec *spec = builtin(*state, v, TRK_VARIANT_NONLINEAR);
        trk_model *model = compile(*state, spec, TRK_STANDARD_GRAVITY);
        double q[COORDINATES], row[COORDINATES];
        int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
        trk_model_get_static(model, q, NULL);
        for (int32_t k = 1; k <= trk_model_count(model, TRK_PART_LINK); k++) {
            double e = 0;
            assert_ok(*state, trk_model_get_link_row(model, k, row, NULL));
            for (int32_t i = 0; i < n; i++)
                e += row[i] * q[i];
            if (strstr(trk_model_part_name(model, TRK_PART_LINK, k), "tire"))
                assert_true(e < -0.01);
            else
                assert_near(e, 0, 1e-9);
        }
        trk_model_destroy(model);
        trk_spec_destroy(spec);
    }
}

/* Published linear rates are tangents of the published springs; the source took g = 9.81. */
static void tangent_rates_are_the_published_linear_ones(void **state)
{
    static const char *const name[] = {"front_left_spring", "rear_right_spring"};
    static const double rate[] = {222276, 256061.9};
    trk_spec *spec = builtin(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_NONLINEAR);
    for (int gravity = 0; gravity < 2; gravity++) {
        trk_model *model = compile(*state, spec, gravity * TRK_STANDARD_GRAVITY);
        for (int end = 0; end < 2; end++) {
            const double h = 1e-5;
            double e[LINKS] = {0}, v[LINKS] = {0}, more[LINKS], less[LINKS];
            int32_t link = trk_model_find(model, TRK_PART_LINK, name[end]) - 1;
            e[link] = h;
            trk_model_get_link_force(model, e, v, more);
            e[link] = -h;
            trk_model_get_link_force(model, e, v, less);
            assert_near((more[link] - less[link]) / (2 * h) / rate[end], 1, 2e-4);
        }
        trk_model_destroy(model);
    }
    trk_spec_destroy(spec);
}

static void without_gravity_nothing_moves(void **state)
{
    trk_spec *spec = builtin(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_NONLINEAR);
    trk_model *model;
    assert_ok(*state, trk_model_compile(*state, spec, NULL, &model));
    double q[COORDINATES], force[LINKS];
    trk_model_get_static(model, q, force);
    for (int32_t k = 0; k < trk_model_count(model, TRK_PART_COORDINATE); k++)
        assert_near(q[k], 0, 0);
    for (int32_t k = 0; k < trk_model_count(model, TRK_PART_LINK); k++)
        assert_near(force[k], 0, 0);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
}

/* 20 kg hung on a spring with the table as its curve. */
static trk_spec *hung(trk_context *context, trk_interpolation interpolation,
                      trk_extrapolation extrapolation, int64_t count, const double *x,
                      const double *y)
{
    trk_curve_options options;
    trk_curve_options_init(&options, sizeof options);
    options.interpolation = interpolation;
    options.extrapolation = extrapolation;
    trk_curve *curve;
    assert_ok(context, trk_curve_create(context, "s", count, x, y, &options, &curve));
    trk_spec *spec;
    assert_ok(context, trk_spec_create(context, "scale", &spec));
    trk_body_options body;
    trk_body_options_init(&body, sizeof body);
    body.mass = 20;
    assert_ok(context, trk_spec_add_body(spec, "pan", &body, NULL));
    trk_link_options link;
    trk_link_options_init(&link, sizeof link);
    link.to_body = 1;
    link.spring_curve = curve;
    assert_ok(context, trk_spec_add_link(spec, "spring", &link, NULL));
    trk_curve_destroy(curve);
    return spec;
}

static void progressive_spring(void **state)
{
    const double x[] = {-3, -2, -1, 0, 1}, y[] = {-1800, -200, -20, 0, 20};
    trk_spec *spec = hung(*state, TRK_INTERPOLATION_PCHIP, TRK_EXTRAPOLATION_SLOPE, 5, x, y);
    trk_model *model = compile(*state, spec, 10);
    double q, f;
    trk_model_get_static(model, &q, &f);
    assert_near(q, -2, 1e-13);
    assert_near(f, -200, 1e-12);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
}

/* A tire that can only push, drawn just touching the road: its curve is level there. */
static void tire_that_just_touches(void **state)
{
    const double x[] = {-0.2, -0.1, 0, 1}, y[] = {-400, -200, 0, 0};
    for (trk_interpolation kind = 0; kind <= TRK_INTERPOLATION_LINEAR;
         kind += TRK_INTERPOLATION_LINEAR) {
        trk_spec *spec = hung(*state, kind, TRK_EXTRAPOLATION_SLOPE, 4, x, y);
        trk_model *model = compile(*state, spec, 10);
        double force;
        trk_model_get_static(model, NULL, &force);
        assert_near(force, -200, 1e-9);
        trk_model_destroy(model);
        trk_spec_destroy(spec);
    }
}

/* Two bodies held together by a nearly rigid link: rounding of q alone is many newtons. */
static void nearly_rigid_links(void **state)
{
    for (double stiffness = 1e8; stiffness <= 1e13; stiffness *= 10) {
        trk_spec *spec;
        trk_body_options body;
        trk_link_options link;
        trk_body_options_init(&body, sizeof body);
        trk_link_options_init(&link, sizeof link);
        body.mass = 250;
        assert_ok(*state, trk_spec_create(*state, "pair", &spec));
        assert_ok(*state, trk_spec_add_body(spec, "a", &body, NULL));
        assert_ok(*state, trk_spec_add_body(spec, "b", &body, NULL));
        link.to_body = 1;
        link.stiffness = 1e4;
        assert_ok(*state, trk_spec_add_link(spec, "soft", &link, NULL));
        link.from_body = 1;
        link.to_body = 2;
        link.stiffness = stiffness;
        assert_ok(*state, trk_spec_add_link(spec, "rigid", &link, NULL));
        trk_model *model = compile(*state, spec, 9.81);
        double q[2];
        trk_model_get_static(model, q, NULL);
        assert_near(q[0], -500 * 9.81 / 1e4, 1e-8); /* as well as the matrix is conditioned */
        assert_near(q[1], q[0], 1e-4);
        trk_model_destroy(model);
        trk_spec_destroy(spec);
    }
}

static void no_equilibrium_is_a_status(void **state)
{
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.gravity = 10;
    trk_model *model;
    /* Level beyond -100 N, but 200 N must be carried. */
    const double x[] = {-1, 0, 1}, y[] = {-100, 0, 100};
    trk_spec *spec = hung(*state, TRK_INTERPOLATION_PCHIP, TRK_EXTRAPOLATION_CLAMP, 3, x, y);
    assert_status(*state, trk_model_compile(*state, spec, &options, &model), TRK_E_CONVERGENCE);
    assert_null(model);
    assert_message(*state, "scale: no static equilibrium found: 100 N out of balance");
    trk_spec_destroy(spec);
    /* A corner at -100 N beyond which the spring turns back: no descent from there. */
    const double back[] = {-1, -0.5, 0}, force[] = {0, -100, 0};
    spec = hung(*state, TRK_INTERPOLATION_LINEAR, TRK_EXTRAPOLATION_SLOPE, 3, back, force);
    assert_status(*state, trk_model_compile(*state, spec, &options, &model), TRK_E_CONVERGENCE);
    assert_message(*state, "scale: no static equilibrium found");
    assert_message(*state, "out of balance");
    trk_spec_destroy(spec);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

static double between(uint32_t *seed, double low, double high)
{
    *seed = *seed * 1664525u + 1013904223u;
    return low + (high - low) * (*seed >> 8) / 16777216.0;
}

/* Two springs under a body with three freedoms: whatever the geometry, nothing holds it. */
static void two_springs_never_carry_three_freedoms(void **state)
{
    uint32_t seed = 7;
    for (int trial = 0; trial < 400; trial++) {
        trk_spec *spec;
        trk_body_options body;
        trk_link_options link;
        trk_body_options_init(&body, sizeof body);
        trk_link_options_init(&link, sizeof link);
        body.freedoms = TRK_FREE_Z | TRK_FREE_ROLL | TRK_FREE_PITCH;
        body.mass = 1000;
        body.inertia[0] = body.inertia[1] = 500;
        body.cg[0] = between(&seed, -2, 2);
        assert_ok(*state, trk_spec_create(*state, "stool", &spec));
        assert_ok(*state, trk_spec_add_road(spec, "floor", 0, 0, &link.from_road));
        assert_ok(*state, trk_spec_add_body(spec, "seat", &body, &link.to_body));
        for (int leg = 0; leg < 2; leg++) {
            link.to_point[0] = between(&seed, -2, 2);
            link.to_point[1] = between(&seed, -1, 1);
            link.stiffness = pow(10, between(&seed, 4, 6));
            assert_ok(*state, trk_spec_add_link(spec, leg ? "left" : "right", &link, NULL));
        }
        trk_model_options options;
        trk_model *model;
        trk_model_options_init(&options, sizeof options);
        options.gravity = TRK_STANDARD_GRAVITY;
        /* Singular, or out of balance when rounding leaves a pivot: but never an answer. */
        assert_true(trk_model_compile(*state, spec, &options, &model) != TRK_OK);
        assert_null(model);
        trk_spec_destroy(spec);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(loads_of_builtin_vehicles_are_their_weight),
        TEST(nonlinear_variant_is_drawn_at_rest),
        TEST(tangent_rates_are_the_published_linear_ones),
        TEST(without_gravity_nothing_moves),
        TEST(progressive_spring),
        TEST(tire_that_just_touches),
        TEST(nearly_rigid_links),
        TEST(two_springs_never_carry_three_freedoms),
        TEST(no_equilibrium_is_a_status),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
