/* SPDX-License-Identifier: MIT */
/* A ladder frame as nodes and beams of a spec (FRAME.2). */
#include "frame/ladder.h"

#include "spec/spec.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LONGEST_NAME = 100, NUMBERED_NAME = LONGEST_NAME + 40 };

static const trk_frame_options defaults = {.struct_size = sizeof defaults,
                                           .freedoms = TRK_FREE_X | TRK_FREE_Y | TRK_FREE_Z |
                                                       TRK_FREE_ROLL | TRK_FREE_PITCH |
                                                       TRK_FREE_YAW,
                                           .member_elements = 1};

void trk_frame_options_init(trk_frame_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

/* A frame being added. */
typedef struct ladder {
    trk_spec *spec;
    const char *name;
    const trk_frame_options *o;
    trk_beam_options rail, member;
    int32_t first; /* id of the first node; those of the left and right rail take turns */
    int32_t nodes; /* of one rail */
} ladder;

/* Elements of a rail between a station and the next. */
static double divide(const trk_frame_options *o, int32_t station)
{
    const double gap = fabs(o->station[station + 1] - o->station[station]);
    /* A gap of two elements is not three because it rounds up. */
    return o->longest > 0 ? fmax(1, ceil(gap / o->longest * (1 - 1e-12))) : 1;
}

double trk_frame_count(const trk_frame_options *o)
{
    double count = 1;
    for (int32_t k = 0; k + 1 < o->stations; k++)
        count += divide(o, k);
    return 2 * count;
}

static trk_status add_node(const ladder *l, const char *name, double x, double y, int32_t *out_id)
{
    trk_body_options node;
    trk_body_options_init(&node, sizeof node);
    node.freedoms = l->o->freedoms;
    node.cg[0] = x;
    node.cg[1] = y;
    node.cg[2] = l->o->z;
    return trk_spec_add_body(l->spec, name, &node, out_id);
}

/* A beam between two nodes, whose ends are their centres of gravity. */
static trk_status add_beam(const ladder *l, const char *name, const trk_beam_options *section,
                           int32_t from, int32_t to)
{
    trk_beam_options beam = *section;
    beam.from_body = from;
    beam.to_body = to;
    memcpy(beam.from_point, l->spec->bodies[from - 1].cg, sizeof beam.from_point);
    memcpy(beam.to_point, l->spec->bodies[to - 1].cg, sizeof beam.to_point);
    memcpy(beam.up, (const double[]){0, 0, 1}, sizeof beam.up);
    return trk_spec_add_beam(l->spec, name, &beam, NULL);
}

/* Left and right node at x, called by their number. */
static trk_status add_pair(ladder *l, double x)
{
    char name[NUMBERED_NAME];
    int32_t id;
    l->nodes++;
    snprintf(name, sizeof name, "%s.left.%d", l->name, (int)l->nodes);
    trk_status status = add_node(l, name, x, l->o->half_width, &id);
    if (status != TRK_OK)
        return status;
    if (l->nodes == 1)
        l->first = id;
    snprintf(name, sizeof name, "%s.right.%d", l->name, (int)l->nodes);
    return add_node(l, name, x, -l->o->half_width, NULL);
}

static trk_status add_rail_nodes(ladder *l)
{
    const trk_frame_options *o = l->o;
    trk_status status = add_pair(l, o->station[0]);
    for (int32_t k = 0; status == TRK_OK && k + 1 < o->stations; k++) {
        const int32_t parts = (int32_t)divide(o, k);
        for (int32_t p = 1; status == TRK_OK && p < parts; p++)
            status = add_pair(l, o->station[k] + (o->station[k + 1] - o->station[k]) * p / parts);
        if (status == TRK_OK)
            status = add_pair(l, o->station[k + 1]);
    }
    return status;
}

static trk_status add_rails(ladder *l)
{
    static const char *const side[2] = {"left", "right"};
    trk_status status = TRK_OK;
    for (int32_t k = 0; k + 1 < l->nodes; k++)
        for (int s = 0; status == TRK_OK && s < 2; s++) {
            char name[NUMBERED_NAME];
            snprintf(name, sizeof name, "%s.%s.%d", l->name, side[s], (int)k + 1);
            const int32_t node = l->first + 2 * k + s;
            status = add_beam(l, name, &l->rail, node, node + 2);
        }
    return status;
}

/* Id of the left node at a station. */
static int32_t left_node(const ladder *l, int32_t station)
{
    int32_t node = l->first;
    for (int32_t k = 0; k < station; k++)
        node += 2 * (int32_t)divide(l->o, k);
    return node;
}

/* From the left rail to the right one. */
static trk_status add_cross(ladder *l, int32_t cross)
{
    const trk_frame_options *o = l->o;
    const int32_t left = left_node(l, trk_frame_station(o, o->cross[cross])),
                  elements = o->member_elements;
    const double x = l->spec->bodies[left - 1].cg[0];
    int32_t from = left;
    trk_status status = TRK_OK;
    for (int32_t k = 1; status == TRK_OK && k <= elements; k++) {
        char name[NUMBERED_NAME];
        snprintf(name, sizeof name, "%s.cross.%d.%d", l->name, (int)cross + 1, (int)k);
        int32_t to = left + 1;
        if (k < elements)
            status = add_node(l, name, x, o->half_width * (1 - 2.0 * k / elements), &to);
        if (status == TRK_OK)
            status = add_beam(l, name, &l->member, from, to);
        from = to;
    }
    return status;
}

static trk_status add_all(ladder *l)
{
    trk_status status = add_rail_nodes(l);
    if (status == TRK_OK)
        status = add_rails(l);
    for (int32_t k = 0; status == TRK_OK && k < l->o->crosses; k++)
        status = add_cross(l, k);
    return status;
}

static trk_status check_pointers(trk_context *context, const trk_frame_options *o)
{
    const double *station = o->station, *cross = o->cross;
    const trk_beam_options *rail = o->rail, *member = o->member;
    TRK_REQUIRE(context, station, "trk_frame_options");
    TRK_REQUIRE(context, cross, "trk_frame_options");
    TRK_REQUIRE(context, rail, "trk_frame_options");
    TRK_REQUIRE(context, member, "trk_frame_options");
    return TRK_OK;
}

static trk_status read_options(trk_context *context, const char *name,
                               const trk_frame_options *options, trk_frame_options *o, ladder *l)
{
    *o = defaults;
    trk_status status = trk_read_options(context, "trk_frame_options", options, o, sizeof *o);
    if (status == TRK_OK)
        status = check_pointers(context, o);
    trk_beam_options_init(&l->rail, sizeof l->rail);
    trk_beam_options_init(&l->member, sizeof l->member);
    if (status == TRK_OK)
        status = trk_read_options(context, "rail", o->rail, &l->rail, sizeof l->rail);
    if (status == TRK_OK)
        status = trk_read_options(context, "member", o->member, &l->member, sizeof l->member);
    return status == TRK_OK ? trk_frame_check(context, name, o) : status;
}

trk_status trk_spec_add_frame(trk_spec *spec, const char *name, const trk_frame_options *options)
{
    TRK_REQUIRE(NULL, spec, "trk_spec_add_frame");
    trk_context *context = spec->context;
    TRK_REQUIRE(context, name, "trk_spec_add_frame");
    TRK_REQUIRE(context, options, "trk_spec_add_frame");
    if (!*name || strlen(name) > LONGEST_NAME)
        return trk_fail(context, TRK_E_NAME,
                        "frame name '%.40s' has %zu characters; 1 to %d are needed", name,
                        strlen(name), (int)LONGEST_NAME);
    trk_frame_options known;
    ladder l = {.spec = spec, .name = name, .o = &known};
    trk_status status = read_options(context, name, options, &known, &l);
    if (status != TRK_OK)
        return status;
    const int32_t bodies = trk_spec_count(spec, TRK_PART_BODY),
                  beams = trk_spec_count(spec, TRK_PART_BEAM);
    status = add_all(&l);
    if (status != TRK_OK) {
        trk_spec_shorten(spec, TRK_PART_BODY, bodies);
        trk_spec_shorten(spec, TRK_PART_BEAM, beams);
    }
    return status;
}
