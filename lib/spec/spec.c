/* SPDX-License-Identifier: MIT */
/* A spec as a whole: create, copy, destroy, names. */
#include "spec/spec.h"

#include <string.h>

trk_status trk_spec_create(trk_context *context, const char *name, trk_spec **out_spec)
{
    TRK_REQUIRE(context, out_spec, "trk_spec_create");
    *out_spec = NULL;
    TRK_REQUIRE(context, context, "trk_spec_create");
    TRK_REQUIRE(context, name, "trk_spec_create");
    trk_spec *spec = trk_new(context, 1, sizeof *spec);
    if (!spec)
        return TRK_E_MEMORY;
    spec->context = context;
    spec->name = trk_copy_text(context, name);
    if (!spec->name) {
        trk_spec_destroy(spec);
        return TRK_E_MEMORY;
    }
    *out_spec = spec;
    return TRK_OK;
}

void trk_spec_destroy(trk_spec *spec)
{
    if (!spec)
        return;
    trk_context *context = spec->context;
    for (int32_t k = 0; k < trk_spec_count(spec, TRK_PART_LINK); k++) {
        trk_curve_destroy((trk_curve *)spec->links[k].spring_curve);
        trk_curve_destroy((trk_curve *)spec->links[k].damper_curve);
        trk_law_destroy((trk_law *)spec->links[k].law);
    }
    trk_free(context, spec->bodies);
    trk_free(context, spec->links);
    trk_free(context, spec->roads);
    trk_free(context, spec->ports);
    trk_free(context, spec->sensors);
    trk_free(context, spec->masses);
    trk_free(context, spec->beams);
    for (trk_part part = 1; part <= TRK_SPEC_PARTS; part++)
        trk_names_clear(context, &spec->names[part]);
    trk_free(context, spec->name);
    trk_free(context, spec);
}

/* Add every part of one spec to another: the checks of the add functions hold for the copy too. */
static trk_status add_all(const trk_spec *from, trk_spec *to)
{
    trk_status status = TRK_OK;
    for (int32_t k = 0; status == TRK_OK && k < trk_spec_count(from, TRK_PART_BODY); k++)
        status = trk_spec_add_body(to, from->names[TRK_PART_BODY].text[k], &from->bodies[k], NULL);
    for (int32_t k = 0; status == TRK_OK && k < trk_spec_count(from, TRK_PART_MASS); k++)
        status = trk_spec_add_mass(to, from->names[TRK_PART_MASS].text[k], from->masses[k].body,
                                   from->masses[k].mass, from->masses[k].point, NULL);
    for (int32_t k = 0; status == TRK_OK && k < trk_spec_count(from, TRK_PART_ROAD); k++)
        status = trk_spec_add_road(to, from->names[TRK_PART_ROAD].text[k], from->roads[k].x,
                                   from->roads[k].y, NULL);
    for (int32_t k = 0; status == TRK_OK && k < trk_spec_count(from, TRK_PART_LINK); k++)
        status = trk_spec_add_link(to, from->names[TRK_PART_LINK].text[k], &from->links[k], NULL);
    for (int32_t k = 0; status == TRK_OK && k < trk_spec_count(from, TRK_PART_BEAM); k++)
        status = trk_spec_add_beam(to, from->names[TRK_PART_BEAM].text[k], &from->beams[k], NULL);
    for (int32_t k = 0; status == TRK_OK && k < trk_spec_count(from, TRK_PART_PORT); k++)
        status = trk_spec_add_port(to, from->names[TRK_PART_PORT].text[k], &from->ports[k], NULL);
    for (int32_t k = 0; status == TRK_OK && k < trk_spec_count(from, TRK_PART_SENSOR); k++)
        status =
            trk_spec_add_sensor(to, from->names[TRK_PART_SENSOR].text[k], &from->sensors[k], NULL);
    return status;
}

trk_status trk_spec_copy(trk_context *context, const trk_spec *spec, trk_spec **out_spec)
{
    TRK_REQUIRE(context, out_spec, "trk_spec_copy");
    *out_spec = NULL;
    TRK_REQUIRE(context, context, "trk_spec_copy");
    TRK_REQUIRE(context, spec, "trk_spec_copy");
    trk_spec *copy;
    trk_status status = trk_spec_create(context, spec->name, &copy);
    if (status != TRK_OK)
        return status;
    status = add_all(spec, copy);
    if (status != TRK_OK) {
        trk_spec_destroy(copy);
        return status;
    }
    *out_spec = copy;
    return TRK_OK;
}

const char *trk_part_word(trk_part part)
{
    static const char *const words[] = {"part",   "body", "link",       "road", "port",
                                        "sensor", "mass", "coordinate", "beam"};
    return part >= TRK_PART_BODY && part <= TRK_PART_BEAM ? words[part] : words[0];
}

trk_status trk_spec_append(trk_spec *spec, trk_part part, const char *name, void **array,
                           size_t element_size)
{
    trk_names *names = &spec->names[part];
    if (name && strlen(name) > TRK_NAME_LENGTH)
        return trk_fail(spec->context, TRK_E_NAME, "%s name '%.40s...' has more than %d characters",
                        trk_part_word(part), name, (int)TRK_NAME_LENGTH);
    trk_status status = trk_grow(spec->context, array, &spec->capacity[part],
                                 (int64_t)names->count + 1, element_size);
    if (status == TRK_OK)
        status = trk_names_add(spec->context, names, trk_part_word(part), name);
    if (status == TRK_OK)
        memset((char *)*array + (size_t)(names->count - 1) * element_size, 0, element_size);
    return status;
}

void trk_spec_shorten(trk_spec *spec, trk_part part, int32_t count)
{
    trk_names_shorten(spec->context, &spec->names[part], count);
}

const char *trk_spec_name(const trk_spec *spec)
{
    return spec ? spec->name : NULL;
}

static const trk_names *names_of(const trk_spec *spec, trk_part part)
{
    static const trk_names none;
    return spec && part >= 1 && part <= TRK_SPEC_PARTS ? &spec->names[part] : &none;
}

int32_t trk_spec_count(const trk_spec *spec, trk_part part)
{
    return names_of(spec, part)->count;
}

int32_t trk_spec_find(const trk_spec *spec, trk_part part, const char *name)
{
    return trk_names_find(names_of(spec, part), name);
}

const char *trk_spec_part_name(const trk_spec *spec, trk_part part, int32_t id)
{
    return trk_names_text(names_of(spec, part), id);
}
