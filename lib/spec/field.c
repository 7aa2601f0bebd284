/* SPDX-License-Identifier: MIT */
/* The numbers of a field of one part: which they are, and others in their place. */
#include "spec/vary.h"

enum { PLAIN = 8, SCALES = 2 }; /* numbers of a field, and scales of curves, at most */

/* A part as numbers. */
typedef struct values {
    trk_link_options link;
    trk_body_options body;
    trk_beam_options beam;
    trk_law_values law;
} values;

/* Places in it that belong to a field, in an order that only the field decides and the law. */
typedef struct places {
    double *plain[PLAIN], *scale[SCALES];
    bool is_scaling[SCALES]; /* is there a curve for the scale? */
    int32_t plains, scales;
} places;

static void read_part(const trk_spec *spec, trk_field field, int32_t part, values *out)
{
    *out = (values){.law = {.kind = 0}};
    switch (trk_field_part(field)) {
    case TRK_PART_LINK:
        out->link = spec->links[part - 1];
        trk_law_values_read(out->link.law, &out->law);
        break;
    case TRK_PART_BEAM: out->beam = spec->beams[part - 1]; break;
    default: out->body = spec->bodies[part - 1]; break;
    }
}

static void add_scale(places *p, double *scale, bool is_scaling)
{
    p->scale[p->scales] = scale;
    p->is_scaling[p->scales++] = is_scaling;
}

static void list_link(trk_field field, values *v, places *p)
{
    if (field == TRK_FIELD_STIFFNESS) {
        p->plain[p->plains++] = &v->link.stiffness;
        add_scale(p, &v->link.spring_scale, v->link.spring_curve != NULL);
        add_scale(p, &v->law.curve_scale, trk_law_values_have_curves(&v->law));
    } else if (field == TRK_FIELD_DAMPING) {
        p->plain[p->plains++] = &v->link.damping;
        add_scale(p, &v->link.damper_scale, v->link.damper_curve != NULL);
    }
    p->plains += trk_law_values_list(&v->law, field, p->plain + p->plains);
}

static void list_beam(values *v, places *p)
{
    double *const numbers[] = {&v->beam.axial,     &v->beam.torsion, &v->beam.bending_y,
                               &v->beam.bending_z, &v->beam.shear_y, &v->beam.shear_z};
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
        p->plain[p->plains++] = numbers[k];
}

static void list_body(trk_field field, values *v, places *p)
{
    if (field != TRK_FIELD_INERTIA)
        p->plain[p->plains++] = &v->body.mass;
    for (int k = 0; k < 3 && field != TRK_FIELD_MASS; k++)
        p->plain[p->plains++] = &v->body.inertia[k];
}

static places list(trk_field field, values *v)
{
    places p = {.plains = 0};
    switch (trk_field_part(field)) {
    case TRK_PART_LINK: list_link(field, v, &p); break;
    case TRK_PART_BEAM: list_beam(v, &p); break;
    default: list_body(field, v, &p); break;
    }
    return p;
}

trk_status trk_spec_check_field(const trk_spec *spec, const char *who, trk_field field,
                                int32_t part, trk_meaning meaning, double *out_value)
{
    values v;
    read_part(spec, field, part, &v);
    const places p = list(field, &v);
    bool has_curve = false;
    int32_t count = 0;
    *out_value = 0;
    for (int32_t k = 0; k < p.scales; k++)
        has_curve = has_curve || (p.is_scaling[k] && *p.scale[k] != 0);
    for (int32_t k = p.plains - 1; k >= 0; k--)
        if (*p.plain[k] != 0) {
            *out_value = *p.plain[k];
            count++;
        }
    const char *name = trk_spec_part_name(spec, trk_field_part(field), part);
    if (count == 0 && !has_curve)
        return trk_fail(spec->context, TRK_E_MODEL, "%s: '%s' has nothing to scale in this field",
                        who, name);
    if (meaning == TRK_MEANING_VALUE && (count != 1 || has_curve || *out_value < 0))
        return trk_fail(spec->context, TRK_E_MODEL,
                        "%s is a value, but '%s' has not one positive number in this field", who,
                        name);
    return TRK_OK;
}

/* The number that a value replaces is the one that is not zero. */
static void change_numbers(trk_field field, trk_meaning meaning, double number, values *to,
                           values *from)
{
    const places t = list(field, to), f = list(field, from);
    for (int32_t k = 0; k < f.scales && meaning == TRK_MEANING_FACTOR; k++)
        *t.scale[k] = number * *f.scale[k];
    for (int32_t k = 0; k < f.plains; k++)
        if (meaning == TRK_MEANING_FACTOR)
            *t.plain[k] = number * *f.plain[k];
        else if (*f.plain[k] != 0)
            *t.plain[k] = number;
    if (to->law.kind == TRK_LAW_STOPS) { /* their scale is that of the curves of `from` */
        to->law.of.stops.bump_curve = from->law.of.stops.bump_curve;
        to->law.of.stops.rebound_curve = from->law.of.stops.rebound_curve;
    }
}

/* Has the law of one of them numbers in the field, and the other is of another kind? */
static bool laws_differ(trk_field field, values *a, values *b)
{
    double *ignored[TRK_LAW_NUMBERS];
    return a->law.kind != b->law.kind && trk_law_values_list(&a->law, field, ignored) +
                                                 trk_law_values_list(&b->law, field, ignored) >
                                             0;
}

/* The law of a link made anew, if the field is one of the law. */
static trk_status make_law(trk_context *context, trk_field field, values *v, trk_varied_part *out)
{
    double *ignored[TRK_LAW_NUMBERS];
    if (trk_law_values_list(&v->law, field, ignored) == 0)
        return TRK_OK;
    trk_law *law;
    trk_status status = trk_law_values_make(context, trk_law_name(v->link.law), &v->law, &law);
    out->link.law = law;
    out->law_is_new = status == TRK_OK;
    return status;
}

trk_status trk_varied_make(const trk_spec *spec, int32_t part, trk_field field, trk_meaning meaning,
                           double number, const trk_spec *base, int32_t base_part,
                           trk_varied_part *out)
{
    trk_context *context = spec->context;
    const trk_part kind = trk_field_part(field);
    const char *name = trk_spec_part_name(spec, kind, part);
    values v, from;
    read_part(spec, field, part, &v);
    read_part(base, field, base_part, &from);
    if (laws_differ(field, &v, &from))
        return trk_fail(context, TRK_E_MODEL,
                        "link '%s': its law is of kind %d, the one to vary of kind %d (0: none)",
                        name, v.law.kind, from.law.kind);
    change_numbers(field, meaning, number, &v, &from);
    *out = (trk_varied_part){.kind = kind, .id = part};
    switch (kind) {
    case TRK_PART_LINK: {
        out->link = v.link;
        trk_status status = trk_check_link_values(context, name, &v.link);
        return status == TRK_OK ? make_law(context, field, &v, out) : status;
    }
    case TRK_PART_BEAM: out->beam = v.beam; return trk_check_beam_values(context, name, &v.beam);
    default: out->body = v.body; return trk_check_body(context, name, &v.body);
    }
}

void trk_varied_put(trk_spec *spec, const trk_varied_part *varied)
{
    switch (varied->kind) {
    case TRK_PART_LINK:
        if (varied->law_is_new)
            trk_law_destroy((trk_law *)spec->links[varied->id - 1].law);
        spec->links[varied->id - 1] = varied->link;
        break;
    case TRK_PART_BEAM: spec->beams[varied->id - 1] = varied->beam; break;
    default: spec->bodies[varied->id - 1] = varied->body; break;
    }
}

void trk_varied_drop(const trk_varied_part *varied)
{
    if (varied->law_is_new)
        trk_law_destroy((trk_law *)varied->link.law);
}

trk_status trk_spec_set_field(trk_spec *spec, int32_t part, trk_field field, trk_meaning meaning,
                              double number, const trk_spec *base, int32_t base_part)
{
    trk_varied_part varied;
    trk_status status =
        trk_varied_make(spec, part, field, meaning, number, base, base_part, &varied);
    if (status == TRK_OK)
        trk_varied_put(spec, &varied);
    return status;
}
