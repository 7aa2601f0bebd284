/* SPDX-License-Identifier: MIT */
/* Lines of beam elements. */
#include "beams.h"

#include "support.h"

#include "base/base.h"

void support_line_init(support_line *line, int32_t elements)
{
    const double young = 2.1e11, density = 7850, height = 0.08, width = 0.05;
    *line = (support_line){.elements = elements,
                           .axis = {1, 0, 0},
                           .length = 2,
                           .first = SUPPORT_ALL,
                           .inner = SUPPORT_ALL,
                           .last = SUPPORT_ALL};
    trk_beam_options *o = &line->section;
    trk_beam_options_init(o, sizeof *o);
    o->axial = young * height * width;
    o->bending_y = young * width * height * height * height / 12;
    o->bending_z = young * height * width * width * width / 12;
    o->torsion = 0.3 * o->bending_z;
    o->mass_per_length = density * height * width;
    o->inertia_x = density * (o->bending_y + o->bending_z) / young;
}

/* Id of the node k, 0 on the ground, and where the axis of the line passes it. */
static int32_t node_at(const trk_spec *spec, const support_line *line, int32_t k, double *point)
{
    char name[32];
    snprintf(name, sizeof name, "node.%d", (int)k);
    for (int i = 0; i < 3; i++)
        point[i] = line->origin[i] + line->axis[i] * line->length * k / line->elements;
    return trk_spec_find(spec, TRK_PART_BODY, name);
}

trk_spec *support_line_spec(trk_context *context, const support_line *line)
{
    trk_spec *spec;
    char name[32];
    assert_ok(context, trk_spec_create(context, "line", &spec));
    for (int32_t k = 0; k <= line->elements; k++) {
        trk_body_options body;
        trk_body_options_init(&body, sizeof body);
        body.freedoms = k == 0 ? line->first : k == line->elements ? line->last : line->inner;
        node_at(spec, line, k, body.cg);
        for (int i = 0; i < 3; i++)
            body.cg[i] += line->offset[i];
        snprintf(name, sizeof name, "node.%d", (int)k);
        if (body.freedoms)
            assert_ok(context, trk_spec_add_body(spec, name, &body, NULL));
    }
    for (int32_t k = 1; k <= line->elements; k++) {
        trk_beam_options beam = line->section;
        beam.from_body = node_at(spec, line, k - 1, beam.from_point);
        beam.to_body = node_at(spec, line, k, beam.to_point);
        snprintf(name, sizeof name, "beam.%d", (int)k);
        assert_ok(context, trk_spec_add_beam(spec, name, &beam, NULL));
    }
    return spec;
}

trk_model *support_line_model(trk_context *context, trk_spec *spec, double gravity,
                              int32_t allow_free)
{
    trk_model *model;
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.gravity = gravity;
    options.allow_free = allow_free;
    assert_ok(context, trk_model_compile(context, spec, &options, &model));
    trk_spec_destroy(spec);
    return model;
}

void support_deflect(trk_context *context, const trk_model *model, double *load)
{
    int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
    double *l = trk_new(context, (int64_t)n * n, sizeof *l);
    assert_non_null(l);
    trk_model_get_tangent(model, NULL, NULL, NULL, l);
    for (int32_t j = 0; j < n; j++) {
        for (int32_t k = 0; k < j; k++)
            for (int32_t i = j; i < n; i++)
                l[i * n + j] -= l[i * n + k] * l[j * n + k];
        assert_true(l[j * n + j] > 0);
        double root = sqrt(l[j * n + j]);
        for (int32_t i = j; i < n; i++)
            l[i * n + j] /= root;
    }
    for (int32_t i = 0; i < n; i++) {
        for (int32_t k = 0; k < i; k++)
            load[i] -= l[i * n + k] * load[k];
        load[i] /= l[i * n + i];
    }
    for (int32_t i = n; i-- > 0;) {
        for (int32_t k = i + 1; k < n; k++)
            load[i] -= l[k * n + i] * load[k];
        load[i] /= l[i * n + i];
    }
    trk_free(context, l);
}
