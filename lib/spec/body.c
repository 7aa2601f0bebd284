/* SPDX-License-Identifier: MIT */
/* Bodies, point masses and road inputs of a spec. */
#include "spec/spec.h"

#include <math.h>
#include <string.h>

enum {
    TRANSLATIONS = TRK_FREE_X | TRK_FREE_Y | TRK_FREE_Z,
    ALL_FREEDOMS = TRANSLATIONS | TRK_FREE_ROLL | TRK_FREE_PITCH | TRK_FREE_YAW
};

static const trk_body_options defaults = {sizeof defaults, TRK_FREE_Z, 0, {0, 0, 0}, {0, 0, 0}};

void trk_body_options_init(trk_body_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

/* Zero mass is legal here: point masses may supply it. Compiling checks the sum. */
trk_status trk_check_body(trk_context *context, const char *name, const trk_body_options *body)
{
    static const char *const inertia[] = {"roll inertia", "pitch inertia", "yaw inertia"};
    if (body->freedoms == 0 || (body->freedoms & ~ALL_FREEDOMS))
        return trk_fail(context, TRK_E_ARGUMENT,
                        "body '%s': freedoms is %d; a sum of TRK_FREE_... values is needed", name,
                        body->freedoms);
    trk_status status = trk_check_not_negative(context, "body", name, "mass", body->mass);
    for (int k = 0; status == TRK_OK && k < 3; k++)
        status = trk_check_not_negative(context, "body", name, inertia[k], body->inertia[k]);
    if (status == TRK_OK)
        status = trk_check_finite(context, "body", name, "centre of gravity", 3, body->cg);
    return status;
}

static trk_status read_body(trk_context *context, const char *name, const trk_body_options *options,
                            trk_body_options *out)
{
    *out = defaults;
    trk_status status = trk_read_options(context, "trk_body_options", options, out, sizeof *out);
    return status == TRK_OK ? trk_check_body(context, name, out) : status;
}

trk_status trk_spec_add_body(trk_spec *spec, const char *name, const trk_body_options *options,
                             int32_t *out_body)
{
    TRK_REQUIRE(NULL, spec, "trk_spec_add_body");
    TRK_REQUIRE(spec->context, options, "trk_spec_add_body");
    trk_body_options body;
    trk_status status = read_body(spec->context, name ? name : "", options, &body);
    if (status == TRK_OK)
        status = trk_spec_append(spec, TRK_PART_BODY, name, (void **)&spec->bodies, sizeof body);
    if (status != TRK_OK)
        return status;
    int32_t id = trk_spec_count(spec, TRK_PART_BODY);
    spec->bodies[id - 1] = body;
    if (out_body)
        *out_body = id;
    return TRK_OK;
}

trk_status trk_spec_get_body(const trk_spec *spec, int32_t body, trk_body_options *out_options)
{
    if (!out_options || body < 1 || body > trk_spec_count(spec, TRK_PART_BODY))
        return TRK_E_ARGUMENT;
    return trk_write_options(out_options, &spec->bodies[body - 1], sizeof *spec->bodies);
}

trk_status trk_spec_set_body(trk_spec *spec, int32_t body, const trk_body_options *options)
{
    TRK_REQUIRE(NULL, spec, "trk_spec_set_body");
    TRK_REQUIRE(spec->context, options, "trk_spec_set_body");
    trk_status status = trk_check_id(spec, "trk_spec_set_body", spec->name, TRK_PART_BODY, body);
    if (status != TRK_OK)
        return status;
    trk_body_options changed;
    status =
        read_body(spec->context, trk_spec_part_name(spec, TRK_PART_BODY, body), options, &changed);
    if (status == TRK_OK)
        spec->bodies[body - 1] = changed;
    return status;
}

trk_status trk_spec_add_mass(trk_spec *spec, const char *name, int32_t body, double mass,
                             const double *point, int32_t *out_mass)
{
    TRK_REQUIRE(NULL, spec, "trk_spec_add_mass");
    TRK_REQUIRE(spec->context, point, "trk_spec_add_mass");
    const char *shown = name ? name : "";
    trk_status status = trk_check_id(spec, "mass", shown, TRK_PART_BODY, body);
    if (status != TRK_OK)
        return status;
    if (!isfinite(mass) || mass <= 0)
        return trk_fail(spec->context, TRK_E_RANGE,
                        "mass '%s': mass is %g; a finite number > 0 is needed", shown, mass);
    status = trk_check_finite(spec->context, "mass", shown, "point", 3, point);
    if (status == TRK_OK)
        status = trk_spec_append(spec, TRK_PART_MASS, name, (void **)&spec->masses,
                                 sizeof *spec->masses);
    if (status != TRK_OK)
        return status;
    int32_t id = trk_spec_count(spec, TRK_PART_MASS);
    spec->masses[id - 1] = (trk_point_mass){body, mass, {point[0], point[1], point[2]}};
    if (out_mass)
        *out_mass = id;
    return TRK_OK;
}

trk_status trk_spec_get_mass(const trk_spec *spec, int32_t mass, int32_t *out_body,
                             double *out_mass, double *out_point)
{
    if (mass < 1 || mass > trk_spec_count(spec, TRK_PART_MASS))
        return TRK_E_ARGUMENT;
    const trk_point_mass *m = &spec->masses[mass - 1];
    if (out_body)
        *out_body = m->body;
    if (out_mass)
        *out_mass = m->mass;
    if (out_point)
        memcpy(out_point, m->point, sizeof m->point);
    return TRK_OK;
}

trk_status trk_spec_add_road(trk_spec *spec, const char *name, double x, double y,
                             int32_t *out_road)
{
    TRK_REQUIRE(NULL, spec, "trk_spec_add_road");
    double place[2] = {x, y};
    trk_status status =
        trk_check_finite(spec->context, "road", name ? name : "", "place", 2, place);
    if (status == TRK_OK)
        status =
            trk_spec_append(spec, TRK_PART_ROAD, name, (void **)&spec->roads, sizeof *spec->roads);
    if (status != TRK_OK)
        return status;
    int32_t id = trk_spec_count(spec, TRK_PART_ROAD);
    spec->roads[id - 1] = (trk_road_place){x, y};
    if (out_road)
        *out_road = id;
    return TRK_OK;
}

trk_status trk_spec_get_road(const trk_spec *spec, int32_t road, double *out_x, double *out_y)
{
    if (road < 1 || road > trk_spec_count(spec, TRK_PART_ROAD))
        return TRK_E_ARGUMENT;
    if (out_x)
        *out_x = spec->roads[road - 1].x;
    if (out_y)
        *out_y = spec->roads[road - 1].y;
    return TRK_OK;
}
