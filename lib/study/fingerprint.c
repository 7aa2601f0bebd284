/* SPDX-License-Identifier: MIT */
/* Everything that determines the results of a study, in 64 bits. */
#include "curve/curve.h"
#include "spec/spec.h"
#include "study/study.h"

#include <string.h>

enum { BLOCK = 256 }; /* steps of a road that are evaluated at once */

/* The finaliser of SplitMix64 over state and word: every bit reaches every bit. */
static void word(uint64_t *hash, uint64_t value)
{
    uint64_t z = (*hash ^ value) + 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    *hash = z ^ (z >> 31);
}

static void integer(uint64_t *hash, int64_t value)
{
    word(hash, (uint64_t)value);
}

static void numbers(uint64_t *hash, int64_t count, const double *values)
{
    for (int64_t k = 0; k < count; k++) {
        uint64_t bits;
        memcpy(&bits, &values[k], sizeof bits);
        word(hash, bits);
    }
}

static void number(uint64_t *hash, double value)
{
    numbers(hash, 1, &value);
}

static void text(uint64_t *hash, const char *value)
{
    for (; *value; value++)
        word(hash, (unsigned char)*value);
    word(hash, 0);
}

static void names(uint64_t *hash, const trk_names *list)
{
    integer(hash, list->count);
    for (int32_t k = 0; k < list->count; k++)
        text(hash, list->text[k]);
}

static void curve(uint64_t *hash, const trk_curve *c)
{
    integer(hash, c ? c->count : -1);
    for (int32_t k = 0; c && k <= c->count; k++) {
        const trk_piece *p = &c->pieces[k];
        const double piece[] = {p->lower, p->upper, p->origin, p->c0, p->c1, p->c2, p->c3};
        numbers(hash, 7, piece);
    }
}

static void stops(uint64_t *hash, const trk_law *law)
{
    trk_stops_options o;
    trk_stops_options_init(&o, sizeof o);
    if (trk_law_get_stops(law, &o) != TRK_OK)
        return;
    const double values[] = {o.bump_clearance, o.bump_stiffness, o.rebound_clearance,
                             o.rebound_stiffness};
    numbers(hash, 4, values);
    curve(hash, o.bump_curve);
    curve(hash, o.rebound_curve);
}

/* Parameters of a law; of the other kinds they are numbers all, behind struct_size. */
static void law(uint64_t *hash, const trk_law *l)
{
    union {
        size_t struct_size;
        trk_tire_options tire;
        trk_leaf_options leaf;
        trk_friction_options friction;
        trk_air_spring_options air_spring;
        trk_seal_options seal;
        double number[16];
    } o = {.number = {0}};
    trk_status status = TRK_E_ARGUMENT;
    o.struct_size = sizeof o; /* a newer header would ask for more: the rest stays zero */
    integer(hash, trk_law_get_kind(l));
    switch (trk_law_get_kind(l)) {
    case TRK_LAW_TIRE: status = trk_law_get_tire(l, &o.tire); break;
    case TRK_LAW_STOPS: stops(hash, l); break;
    case TRK_LAW_LEAF: status = trk_law_get_leaf(l, &o.leaf); break;
    case TRK_LAW_FRICTION: status = trk_law_get_friction(l, &o.friction); break;
    case TRK_LAW_AIR_SPRING: status = trk_law_get_air_spring(l, &o.air_spring); break;
    case TRK_LAW_SEAL: status = trk_law_get_seal(l, &o.seal); break;
    default: break;
    }
    if (status == TRK_OK)
        numbers(hash, 15, o.number + 1);
}

static void links(uint64_t *hash, const trk_spec *spec)
{
    for (int32_t k = 0; k < trk_spec_count(spec, TRK_PART_LINK); k++) {
        const trk_link_options *o = &spec->links[k];
        const int64_t ids[] = {o->motion, o->from_body, o->from_road, o->to_body};
        const double values[] = {o->stiffness, o->damping, o->spring_scale, o->damper_scale,
                                 o->spring_offset};
        for (int i = 0; i < 4; i++)
            integer(hash, ids[i]);
        numbers(hash, 3, o->from_point);
        numbers(hash, 3, o->to_point);
        numbers(hash, 3, o->direction);
        numbers(hash, 5, values);
        curve(hash, o->spring_curve);
        curve(hash, o->damper_curve);
        law(hash, o->law);
    }
}

static void beams(uint64_t *hash, const trk_spec *spec)
{
    for (int32_t k = 0; k < trk_spec_count(spec, TRK_PART_BEAM); k++) {
        const trk_beam_options *o = &spec->beams[k];
        const double values[] = {o->axial,           o->torsion,      o->bending_y,
                                 o->bending_z,       o->shear_y,      o->shear_z,
                                 o->mass_per_length, o->inertia_x,    o->inertia_y,
                                 o->inertia_z,       o->mass_damping, o->stiffness_damping};
        integer(hash, o->from_body);
        integer(hash, o->to_body);
        numbers(hash, 3, o->from_point);
        numbers(hash, 3, o->to_point);
        numbers(hash, 3, o->up);
        numbers(hash, sizeof values / sizeof *values, values);
    }
}

static void spec(uint64_t *hash, const trk_spec *s)
{
    for (trk_part part = 1; part <= TRK_SPEC_PARTS; part++)
        names(hash, &s->names[part]);
    for (int32_t k = 0; k < trk_spec_count(s, TRK_PART_BODY); k++) {
        integer(hash, s->bodies[k].freedoms);
        number(hash, s->bodies[k].mass);
        numbers(hash, 3, s->bodies[k].inertia);
        numbers(hash, 3, s->bodies[k].cg);
    }
    for (int32_t k = 0; k < trk_spec_count(s, TRK_PART_MASS); k++) {
        integer(hash, s->masses[k].body);
        number(hash, s->masses[k].mass);
        numbers(hash, 3, s->masses[k].point);
    }
    for (int32_t k = 0; k < trk_spec_count(s, TRK_PART_PORT); k++) {
        integer(hash, s->ports[k].body);
        integer(hash, s->ports[k].motion);
        numbers(hash, 3, s->ports[k].point);
        numbers(hash, 3, s->ports[k].direction);
    }
    for (int32_t k = 0; k < trk_spec_count(s, TRK_PART_SENSOR); k++) {
        const trk_sensor_options *o = &s->sensors[k];
        const int64_t ids[] = {o->quantity, o->body, o->link, o->motion};
        for (int i = 0; i < 4; i++)
            integer(hash, ids[i]);
        numbers(hash, 3, o->point);
        numbers(hash, 3, o->direction);
    }
    links(hash, s);
    beams(hash, s);
}

static void settings(uint64_t *hash, const trk_study *study)
{
    const trk_study_options *o = &study->options;
    const trk_newmark_options *n = &study->newmark;
    const trk_spectrum_options *s = &study->spectrum;
    const double values[] = {study->model_options.gravity,
                             o->duration,
                             o->start,
                             o->settle,
                             n->step,
                             n->beta,
                             n->gamma,
                             n->alpha_f,
                             n->alpha_m,
                             n->tolerance,
                             s->overlap,
                             s->kaiser_beta};
    const int64_t choices[] = {study->model_options.allow_free, o->design, o->seed, o->record_every,
                               n->max_iterations, n->backend, s->segment_length, s->window,
                               s->detrend,
                               /* A longer Monte Carlo study continues a shorter one. */
                               o->design == TRK_DESIGN_LATIN_HYPERCUBE ? o->points : 0};
    numbers(hash, (int64_t)(sizeof values / sizeof *values), values);
    for (size_t k = 0; k < sizeof choices / sizeof *choices; k++)
        integer(hash, choices[k]);
}

static void parts(uint64_t *hash, const trk_study *study)
{
    for (trk_study_part part = 1; part <= TRK_STUDY_PARTS; part++)
        names(hash, &study->names[part]);
    for (int32_t k = 0; k < trk_study_parameters(study); k++) {
        const trk_study_parameter_options *o = &study->parameters[k].options;
        const double values[] = {o->lower, o->upper, o->mean, o->deviation};
        numbers(hash, 4, values);
        integer(hash, o->distribution);
        integer(hash, o->meaning);
        integer(hash, o->levels);
    }
    for (int32_t k = 0; k < study->action_count; k++) {
        integer(hash, study->actions[k].parameter);
        integer(hash, study->actions[k].field);
        integer(hash, study->actions[k].part);
        number(hash, study->actions[k].power);
    }
    for (int32_t k = 0; k < trk_study_outputs(study); k++) {
        const trk_design_output *output = &study->outputs[k];
        integer(hash, output->options.kind);
        integer(hash, output->sensor);
        number(hash, output->options.low);
        number(hash, output->options.high);
        const int64_t count = output->options.weight ? output->options.count : 0;
        integer(hash, count);
        numbers(hash, count, output->options.frequency);
        numbers(hash, count, output->options.weight);
    }
}

/* Heights, rates and loads at every step. */
static trk_status road(uint64_t *hash, const trk_study *study, const trk_excitation *excitation)
{
    const int32_t roads = trk_excitation_roads(excitation),
                  ports = trk_excitation_ports(excitation);
    const double step = study->newmark.step;
    const int64_t steps = (study->skipped + study->samples) * study->options.record_every;
    double *height = trk_new(study->context, (int64_t)BLOCK * (2 * roads + ports), sizeof *height);
    if (!height)
        return TRK_E_MEMORY;
    double *velocity = height + BLOCK * roads, *load = velocity + BLOCK * roads;
    for (int64_t done = 0; done < steps; done += BLOCK) {
        const int64_t count = steps - done < BLOCK ? steps - done : BLOCK;
        trk_excitation_evaluate(excitation, count, study->options.start + (double)done * step, step,
                                height, velocity, load);
        numbers(hash, count * roads, height);
        numbers(hash, count * roads, velocity);
        numbers(hash, count * ports, load);
    }
    trk_free(study->context, height);
    return TRK_OK;
}

trk_status trk_study_hash(trk_study *study, uint64_t *out_fingerprint)
{
    uint64_t hash = 0;
    integer(&hash, trk_version());
    spec(&hash, study->base);
    settings(&hash, study);
    parts(&hash, study);
    trk_status status = TRK_OK;
    for (int32_t k = 0; status == TRK_OK && k < trk_study_count(study, TRK_STUDY_EXCITATION); k++)
        status = road(&hash, study, study->excitations[k]);
    *out_fingerprint = hash;
    return status;
}
