/* SPDX-License-Identifier: MIT */
/* Masses and static loads of a vehicle. */
#include "check.h"
#include "common/text.h"

#include <math.h>
#include <stdlib.h>

static double body_mass(const trk_spec *spec, int32_t body, bool *out_heavy)
{
    trk_body_options o;
    trk_body_options_init(&o, sizeof o);
    if (trk_spec_get_body(spec, body, &o) != TRK_OK)
        o.mass = o.freedoms = 0;
    *out_heavy = (o.freedoms & TRK_FREE_Z) != 0;
    return o.mass;
}

static double beam_mass(const trk_spec *spec, int32_t beam, bool *out_heavy)
{
    trk_beam_options o;
    bool other;
    trk_beam_options_init(&o, sizeof o);
    *out_heavy = false;
    if (trk_spec_get_beam(spec, beam, &o) != TRK_OK)
        return 0;
    double squared = 0;
    for (int k = 0; k < 3; k++)
        squared += (o.to_point[k] - o.from_point[k]) * (o.to_point[k] - o.from_point[k]);
    body_mass(spec, o.from_body, out_heavy);
    body_mass(spec, o.to_body, &other);
    *out_heavy = *out_heavy && other;
    return o.mass_per_length * sqrt(squared);
}

/* All mass, and in *out_heavy that which can move up and down: its weight is carried by links. */
static double total_mass(const trk_spec *spec, double *out_heavy)
{
    double total = 0, mass;
    bool heavy;
    *out_heavy = 0;
    for (int32_t k = 1; k <= trk_spec_count(spec, TRK_PART_BODY); k++) {
        total += mass = body_mass(spec, k, &heavy);
        *out_heavy += heavy ? mass : 0;
    }
    for (int32_t k = 1; k <= trk_spec_count(spec, TRK_PART_MASS); k++) {
        int32_t body = 0;
        if (trk_spec_get_mass(spec, k, &body, &mass, NULL) != TRK_OK)
            continue;
        total += mass;
        body_mass(spec, body, &heavy);
        *out_heavy += heavy ? mass : 0;
    }
    for (int32_t k = 1; k <= trk_spec_count(spec, TRK_PART_BEAM); k++) {
        total += mass = beam_mass(spec, k, &heavy);
        *out_heavy += heavy ? mass : 0;
    }
    return total;
}

/* Upward force [N] on the vehicle from roads (one entry each) and ground. */
static void carry(const check_subject *c, double *road, double *ground)
{
    *ground = 0;
    for (int32_t k = 1; k <= trk_spec_count(c->spec, TRK_PART_LINK); k++) {
        trk_link_options o;
        trk_link_options_init(&o, sizeof o);
        if (trk_spec_get_link(c->spec, k, &o) != TRK_OK || o.motion != TRK_MOTION_TRANSLATION)
            continue;
        const double *d = o.direction;
        const double up = -c->force[k - 1] * d[2] / sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        if (o.from_road > 0)
            road[o.from_road - 1] += up;
        else if (o.from_body == 0)
            *ground += up;
        else if (o.to_body == 0)
            *ground -= up;
    }
}

/* Wheels at the same place along the vehicle are an axle. */
static void add_axles(check_report *r, const check_subject *c, const double *load)
{
    const int32_t roads = trk_model_count(c->model, TRK_PART_ROAD);
    for (int32_t k = 1; k <= roads; k++) {
        double x = 0, other = 0, sum = 0;
        int wheels = 0;
        bool first = true;
        (void)!trk_model_get_road_place(c->model, k, &x, NULL);
        for (int32_t i = 1; i <= roads; i++) {
            (void)!trk_model_get_road_place(c->model, i, &other, NULL);
            if (fabs(other - x) > 1e-6)
                continue;
            first = first && i >= k;
            sum += load[i - 1];
            wheels++;
        }
        if (!first)
            continue;
        table_text(r->axles, c->label);
        table_number(r->axles, x);
        table_number(r->axles, wheels);
        table_number(r->axles, sum);
        table_number(r->axles, c->weight > 0 ? 100 * sum / c->weight : NAN);
    }
}

static void add_tires(check_report *r, check_subject *c, const double *load)
{
    for (int32_t k = 1; k <= trk_model_count(c->model, TRK_PART_ROAD); k++) {
        const char *name = trk_model_part_name(c->model, TRK_PART_ROAD, k);
        double x = NAN, y = NAN;
        (void)!trk_model_get_road_place(c->model, k, &x, &y);
        table_text(r->tires, c->label);
        table_text(r->tires, name);
        table_number(r->tires, x);
        table_number(r->tires, y);
        table_number(r->tires, load[k - 1]);
        table_number(r->tires, c->weight > 0 ? 100 * load[k - 1] / c->weight : NAN);
        c->road += load[k - 1];
        if (load[k - 1] <= 0)
            check_warn(r, c, "the road input %s carries nothing at rest (%.6g N)", name,
                       load[k - 1]);
    }
}

void check_loads(check_report *r, check_subject *c)
{
    double heavy;
    const double mass = total_mass(c->spec, &heavy);
    double *load = need((size_t)trk_model_count(c->model, TRK_PART_ROAD), sizeof *load);
    c->weight = TRK_STANDARD_GRAVITY * heavy;
    carry(c, load, &c->ground);
    add_tires(r, c, load);
    add_axles(r, c, load);
    static const trk_part parts[] = {TRK_PART_COORDINATE, TRK_PART_BODY,  TRK_PART_MASS,
                                     TRK_PART_LINK,       TRK_PART_BEAM,  TRK_PART_ROAD,
                                     TRK_PART_PORT,       TRK_PART_SENSOR};
    table_text(r->vehicles, c->label);
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
        table_number(r->vehicles, parts[k] == TRK_PART_COORDINATE
                                      ? trk_model_count(c->model, parts[k])
                                      : trk_spec_count(c->spec, parts[k]));
    table_number(r->vehicles, mass);
    table_number(r->vehicles, c->weight);
    table_number(r->vehicles, c->road);
    if (fabs(c->road + c->ground - c->weight) > 1e-6 * c->weight)
        check_warn(r, c, "roads and ground carry %.9g N of the weight of %.9g N",
                   c->road + c->ground, c->weight);
    else if (fabs(c->ground) > 1e-6 * c->weight)
        check_warn(r, c, "links to the ground carry %.6g N at rest", c->ground);
    if (heavy < (1 - 1e-12) * mass)
        check_warn(r, c, "%.6g kg cannot move up or down and weigh on nothing", mass - heavy);
    free(load);
}
