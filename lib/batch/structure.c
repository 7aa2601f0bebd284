/* SPDX-License-Identifier: MIT */
/* Variants must be the same but for numbers. */
#include "batch/batch.h"

#include <string.h>

static const struct {
    trk_part part;
    const char *plural, *name;
} kinds[] = {{TRK_PART_COORDINATE, "coordinates", "coordinate"},
             {TRK_PART_LINK, "links", "link"},
             {TRK_PART_BEAM, "beams", "beam"},
             {TRK_PART_ROAD, "roads", "road"},
             {TRK_PART_PORT, "force ports", "force port"},
             {TRK_PART_SENSOR, "sensors", "sensor"}};

static trk_status check_names(trk_context *context, const trk_model *a, const trk_model *b)
{
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++) {
        int32_t wanted = trk_model_count(a, kinds[k].part),
                count = trk_model_count(b, kinds[k].part);
        if (count != wanted)
            return trk_fail(context, TRK_E_ARGUMENT, "it has %d %s, variant 0 has %d", count,
                            kinds[k].plural, wanted);
        for (int32_t id = 1; id <= count; id++) {
            const char *name = trk_model_part_name(b, kinds[k].part, id),
                       *other = trk_model_part_name(a, kinds[k].part, id);
            if (strcmp(name, other) != 0)
                return trk_fail(context, TRK_E_ARGUMENT,
                                "its %s %d is '%s', that of variant 0 '%s'", kinds[k].name, id,
                                name, other);
        }
    }
    return TRK_OK;
}

static bool same_road(const trk_rows *a, const trk_rows *b, int32_t link)
{
    int64_t count = a->start[link + 1] - a->start[link];
    if (count != b->start[link + 1] - b->start[link])
        return false;
    return count == 0 || a->column[a->start[link]] == b->column[b->start[link]];
}

static const char *has(const void *curve)
{
    return curve ? "has one" : "has none";
}

static trk_status check_links(trk_context *context, const trk_model *a, const trk_model *b)
{
    if (a->links.count != b->links.count)
        return trk_fail(context, TRK_E_ARGUMENT,
                        "its links and beams have %d rows, those of variant 0 have %d: a stiffness "
                        "or damping of a beam is zero in one of them",
                        b->links.count, a->links.count);
    for (int32_t k = 0; k < trk_model_named_links(a); k++) {
        const trk_link_law *x = &a->laws[k], *y = &b->laws[k];
        const char *name = trk_model_part_name(b, TRK_PART_LINK, k + 1);
        if (!x->spring != !y->spring)
            return trk_fail(context, TRK_E_ARGUMENT,
                            "spring curve of link '%s': it %s, variant 0 %s", name, has(y->spring),
                            has(x->spring));
        if (!x->damper != !y->damper)
            return trk_fail(context, TRK_E_ARGUMENT,
                            "damper curve of link '%s': it %s, variant 0 %s", name, has(y->damper),
                            has(x->damper));
        if (trk_law_get_kind(x->law) != trk_law_get_kind(y->law))
            return trk_fail(context, TRK_E_ARGUMENT,
                            "law of link '%s': it is of kind %d, in variant 0 of kind %d (0: none)",
                            name, trk_law_get_kind(y->law), trk_law_get_kind(x->law));
        if (!same_road(&a->roads, &b->roads, k))
            return trk_fail(context, TRK_E_ARGUMENT,
                            "link '%s' stands on another road than in variant 0", name);
    }
    return TRK_OK;
}

static trk_status check_sensors(trk_context *context, const trk_model *a, const trk_model *b)
{
    for (int32_t k = 0; k < a->sensors.count; k++)
        if (a->sensor_quantity[k] != b->sensor_quantity[k] ||
            a->sensor_link[k] != b->sensor_link[k])
            return trk_fail(context, TRK_E_ARGUMENT,
                            "sensor '%s' reads something else than in variant 0",
                            trk_model_part_name(b, TRK_PART_SENSOR, k + 1));
    return TRK_OK;
}

static trk_status check_excitation(trk_context *context, const trk_model *model,
                                   const trk_excitation *excitation)
{
    int32_t roads = trk_excitation_roads(excitation), ports = trk_excitation_ports(excitation);
    if (roads == trk_model_count(model, TRK_PART_ROAD) &&
        ports == trk_model_count(model, TRK_PART_PORT))
        return TRK_OK;
    return trk_fail(context, TRK_E_ARGUMENT,
                    "its excitation has %d roads and %d ports, the model %d and %d", roads, ports,
                    trk_model_count(model, TRK_PART_ROAD), trk_model_count(model, TRK_PART_PORT));
}

static trk_status check_variant(const trk_batch *batch, int32_t variant)
{
    trk_context *context = batch->context;
    const trk_model *first = batch->models[0], *model = batch->models[variant];
    if (!model)
        return trk_fail(context, TRK_E_ARGUMENT, "its model is NULL");
    if (!batch->excitations[variant])
        return trk_fail(context, TRK_E_ARGUMENT, "its excitation is NULL");
    trk_status status = TRK_OK;
    if (model != first)
        status = check_names(context, first, model);
    if (status == TRK_OK && model != first)
        status = check_links(context, first, model);
    if (status == TRK_OK && model != first)
        status = check_sensors(context, first, model);
    return status == TRK_OK ? check_excitation(context, model, batch->excitations[variant])
                            : status;
}

trk_status trk_batch_check_structure(const trk_batch *batch)
{
    for (int32_t k = 0; k < batch->count; k++) {
        trk_status status = check_variant(batch, k);
        if (status != TRK_OK)
            return trk_fail_within(batch->context, status, "trk_batch_run: variant %d", k);
    }
    if (batch->models[0]->sensors.count == 0)
        return trk_fail(batch->context, TRK_E_MODEL,
                        "%s: the models have no sensor, nothing would be recorded",
                        trk_model_name(batch->models[0]));
    return TRK_OK;
}
