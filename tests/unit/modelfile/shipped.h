/* SPDX-License-Identifier: MIT */
/* The tractors of examples/models, and sums over the tires of a model. */
#ifndef TRK_TESTS_MODELFILE_SHIPPED_H
#define TRK_TESTS_MODELFILE_SHIPPED_H

#include <stdbool.h>

#include <truckride/model.h>
#include <truckride/modelfile.h>

#include "support.h"

#define SHIPPED_FOUR_BY_TWO "tractor_4x2"
#define SHIPPED_WALKING_BEAM "tractor_6x4"
#define SHIPPED_FOUR_SPRING "tractor_6x4_four_spring"
#define SHIPPED_SEMITRAILER "tractor_semitrailer"

enum { SHIPPED = 4 };
static const char *const shipped_name[SHIPPED] = {SHIPPED_FOUR_BY_TWO, SHIPPED_WALKING_BEAM,
                                                  SHIPPED_FOUR_SPRING, SHIPPED_SEMITRAILER};

static inline trk_spec *shipped_spec(trk_context *context, const char *name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/examples/models/%s.json", SUPPORT_ROOT, name);
    trk_spec *spec;
    assert_ok(context, trk_model_file_read(context, path, &spec));
    return spec;
}

static inline trk_model *shipped_compile(trk_context *context, trk_spec *spec, double gravity)
{
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.gravity = gravity;
    trk_model *model;
    assert_ok(context, trk_model_compile(context, spec, &options, &model));
    trk_spec_destroy(spec);
    return model;
}

static inline trk_model *shipped_model(trk_context *context, const char *name)
{
    return shipped_compile(context, shipped_spec(context, name), TRK_STANDARD_GRAVITY);
}

static inline bool shipped_ends(const char *name, const char *tail)
{
    size_t length = strlen(name), rest = strlen(tail);
    return length >= rest && strcmp(name + length - rest, tail) == 0;
}

static inline bool shipped_is_tire(const trk_model *model, int32_t link)
{
    return shipped_ends(trk_model_part_name(model, TRK_PART_LINK, link), "tire");
}

/* Force of every link at rest, minus the load for a tire; to be freed. */
static inline double *shipped_static(const trk_model *model)
{
    double *force = malloc((size_t)trk_model_count(model, TRK_PART_LINK) * sizeof *force);
    assert_non_null(force);
    trk_model_get_static(model, NULL, force);
    return force;
}

#endif
