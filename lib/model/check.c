/* SPDX-License-Identifier: MIT */
/* Is the model complete? Numbers fit, coordinates have inertia and are held, bodies are tied. */
#include "model/model.h"

#include "spec/spec.h"
#include "system/assembly.h"

#include <math.h>

static const char *name_of(const trk_model *model, trk_part part, int32_t row,
                           const char **out_word)
{
    *out_word = trk_part_word(part);
    return part == TRK_PART_LINK ? trk_model_link_name(model, row, out_word)
                                 : trk_names_text(&model->names[part], row + 1);
}

/* Lever arms are differences of points: huge ones overflow. */
static trk_status check_rows(const trk_model *model, const trk_rows *rows, trk_part part)
{
    for (int32_t r = 0; r < rows->count; r++)
        for (int64_t k = rows->start[r]; k < rows->start[r + 1]; k++)
            if (!isfinite(rows->value[k])) {
                const char *word, *name = name_of(model, part, r, &word);
                return trk_fail(
                    model->context, TRK_E_RANGE,
                    "%s '%s': the lever arm about '%s' is %g; a finite number is needed", word,
                    name, trk_names_text(&model->names[TRK_PART_COORDINATE], rows->column[k] + 1),
                    rows->value[k]);
            }
    return TRK_OK;
}

static trk_status check_inertia(const trk_model *model)
{
    for (int32_t r = 0; r < model->inertia.count; r++)
        for (int64_t k = model->inertia.start[r]; k < model->inertia.start[r + 1]; k++) {
            int32_t i = model->inertia.column[k];
            double square = model->mass[r] * model->inertia.value[k] * model->inertia.value[k];
            if (!isfinite(square) || !isfinite(model->weight[i]))
                return trk_fail(
                    model->context, TRK_E_RANGE,
                    "coordinate '%s': its inertia %g or weight %g is not a finite number",
                    trk_names_text(&model->names[TRK_PART_COORDINATE], i + 1), square,
                    model->weight[i]);
        }
    return TRK_OK;
}

trk_status trk_model_check_numbers(const trk_model *model)
{
    trk_status status = check_rows(model, &model->links, TRK_PART_LINK);
    if (status == TRK_OK)
        status = check_rows(model, &model->ports, TRK_PART_PORT);
    if (status == TRK_OK)
        status = check_rows(model, &model->sensors, TRK_PART_SENSOR);
    if (status == TRK_OK)
        status = check_inertia(model);
    for (int32_t k = trk_model_named_links(model); status == TRK_OK && k < model->links.count; k++)
        if (!isfinite(model->laws[k].stiffness) || !isfinite(model->laws[k].damping)) {
            const char *word, *name = trk_model_link_name(model, k, &word);
            status = trk_fail(model->context, TRK_E_RANGE,
                              "%s '%s': its stiffness %g or damping %g is not a finite number",
                              word, name, model->laws[k].stiffness, model->laws[k].damping);
        }
    for (int32_t k = 0; status == TRK_OK && k < trk_model_named_links(model); k++)
        if (!isfinite(trk_link_law_force(&model->laws[k], 0, 0)))
            status = trk_fail(
                model->context, TRK_E_RANGE,
                "link '%s': the force of its curves or law at e = 0 is not a finite number",
                trk_names_text(&model->names[TRK_PART_LINK], k + 1));
    return status;
}

/* Can the link ever carry a force? */
static bool carries(const trk_link_options *link)
{
    return link->stiffness != 0 || link->damping != 0 || link->law ||
           (link->spring_curve && link->spring_scale != 0) ||
           (link->damper_curve && link->damper_scale != 0);
}

/* Does the beam resist some deformation? */
static bool is_stiff(const trk_beam_options *beam)
{
    return beam->axial > 0 || beam->torsion > 0 || beam->bending_y > 0 || beam->bending_z > 0;
}

/* Root of a union-find tree, shortening the way. */
static int32_t root_of(int32_t *parent, int32_t k)
{
    while (parent[k] != k)
        k = parent[k] = parent[parent[k]];
    return k;
}

/* Are all bodies connected to ground or road (node 0)? */
static trk_status check_bodies(const trk_model *model, const trk_spec *spec)
{
    int32_t bodies = trk_spec_count(spec, TRK_PART_BODY);
    int32_t *parent = trk_new(model->context, (int64_t)bodies + 1, sizeof *parent);
    if (!parent)
        return TRK_E_MEMORY;
    for (int32_t b = 0; b <= bodies; b++)
        parent[b] = b;
    for (int32_t k = 0; k < trk_spec_count(spec, TRK_PART_LINK); k++)
        if (carries(&spec->links[k]))
            parent[root_of(parent, spec->links[k].from_body)] =
                root_of(parent, spec->links[k].to_body);
    for (int32_t k = 0; k < trk_spec_count(spec, TRK_PART_BEAM); k++)
        if (is_stiff(&spec->beams[k]))
            parent[root_of(parent, spec->beams[k].from_body)] =
                root_of(parent, spec->beams[k].to_body);
    trk_status status = TRK_OK;
    for (int32_t b = 1; status == TRK_OK && b <= bodies; b++)
        if (root_of(parent, b) != root_of(parent, 0))
            status = trk_fail(
                model->context, TRK_E_MODEL,
                "body '%s' is not supported: no chain of links ties it to the ground or a road",
                trk_spec_part_name(spec, TRK_PART_BODY, b));
    trk_free(model->context, parent);
    return status;
}

/* Does some link act along every coordinate? */
static trk_status check_coordinates(const trk_model *model, const trk_spec *spec)
{
    bool *held = trk_new(model->context, model->n, sizeof *held);
    if (!held)
        return TRK_E_MEMORY;
    for (int32_t k = 0; k < model->links.count; k++)
        for (int64_t j = model->links.start[k]; j < model->links.start[k + 1]; j++)
            held[model->links.column[j]] |= k < trk_model_named_links(model)
                                                ? carries(&spec->links[k])
                                                : model->laws[k].stiffness != 0;
    trk_status status = TRK_OK;
    for (int32_t i = 0; status == TRK_OK && i < model->n; i++)
        if (!held[i])
            status = trk_fail(model->context, TRK_E_MODEL,
                              "coordinate '%s' is not supported: no link acts along it",
                              trk_names_text(&model->names[TRK_PART_COORDINATE], i + 1));
    trk_free(model->context, held);
    return status;
}

trk_status trk_model_check_ties(const trk_model *model, const trk_spec *spec)
{
    trk_status status = check_bodies(model, spec);
    return status == TRK_OK ? check_coordinates(model, spec) : status;
}

trk_status trk_model_check_mass(const trk_model *model)
{
    const trk_rows no_links = {0};
    trk_assembly assembly;
    trk_status status = trk_assembly_create(model->context, TRK_BACKEND_AUTO, model->n,
                                            &model->inertia, model->mass, &no_links, &assembly);
    if (status != TRK_OK)
        return status;
    int32_t bad = 0;
    status = trk_assembly_factorize(&assembly, 1, NULL, &bad);
    trk_assembly_clear(&assembly);
    if (status == TRK_E_SINGULAR)
        return trk_fail(model->context, TRK_E_MODEL, "coordinate '%s' has no %s",
                        trk_names_text(&model->names[TRK_PART_COORDINATE], bad + 1),
                        model->is_rotation[bad] ? "moment of inertia" : "mass");
    return status;
}

int32_t trk_model_blame(const trk_model *model, const double *s, int32_t coordinate)
{
    int32_t worst = -1;
    double most = 0, most_here = 0;
    for (int32_t k = 0; k < model->links.count; k++) {
        if (s[k] >= 0)
            continue;
        double here = 0;
        for (int64_t j = model->links.start[k]; j < model->links.start[k + 1]; j++)
            if (model->links.column[j] == coordinate)
                here = s[k] * model->links.value[j] * model->links.value[j];
        if (here < most_here || (most_here == 0 && s[k] < most)) {
            worst = k;
            most = s[k];
            most_here = here;
        }
    }
    return worst;
}

trk_status trk_model_fail_singular(trk_context *context, const trk_model *model, const char *what,
                                   const double *s, int32_t coordinate)
{
    const char *at = trk_names_text(&model->names[TRK_PART_COORDINATE], coordinate + 1);
    const int32_t link = trk_model_blame(model, s, coordinate);
    if (link < 0) /* what holds a line of very short beams may be less than their rounding */
        return trk_fail(
            context, TRK_E_SINGULAR,
            "the %s is not positive definite: nothing holds coordinate '%s'%s", what, at,
            model->links.count > trk_model_named_links(model) ? ", or beams are divided too finely"
                                                              : "");
    const char *word, *name = trk_model_link_name(model, link, &word);
    return trk_fail(
        context, TRK_E_SINGULAR,
        "the %s is not positive definite at coordinate '%s': %s '%s' adds %g, a negative value",
        what, at, word, name, s[link]);
}
