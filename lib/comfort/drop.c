/* SPDX-License-Identifier: MIT */
/* An axle of a model falls off a step (COMFORT.14). */
#include "comfort/check.h"

#include <math.h>
#include <truckride/comfort.h>
#include <truckride/newmark.h>

static const trk_axle_drop_options defaults = {
    .struct_size = sizeof(trk_axle_drop_options),
    .height = 0.08,
    .duration = 10,
    .step = 0.001,
};

void trk_axle_drop_options_init(trk_axle_drop_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static const char what[] = "trk_axle_drop";

static trk_status check_parts(trk_context *context, const trk_model *model, int32_t roads,
                              const int32_t *road, int32_t link)
{
    int32_t all = trk_model_count(model, TRK_PART_ROAD);
    if (roads < 1)
        return trk_fail(context, TRK_E_ARGUMENT, "%s: roads is %d, expected >= 1", what,
                        (int)roads);
    for (int32_t k = 0; k < roads; k++)
        if (road[k] < 1 || road[k] > all)
            return trk_fail(context, TRK_E_ARGUMENT, "%s: no road %d, expected 1 to %d", what,
                            (int)road[k], (int)all);
    int32_t links = trk_model_count(model, TRK_PART_LINK);
    if (link < 1 || link > links)
        return trk_fail(context, TRK_E_ARGUMENT, "%s: no link %d, expected 1 to %d", what,
                        (int)link, (int)links);
    return TRK_OK;
}

static trk_status check_options(trk_context *context, const trk_axle_drop_options *o)
{
    trk_status status = trk_comfort_check_positive(context, what, "height", o->height);
    if (status == TRK_OK)
        status = trk_comfort_check_positive(context, what, "duration", o->duration);
    if (status == TRK_OK)
        status = trk_comfort_check_positive(context, what, "step", o->step);
    if (status == TRK_OK && !(o->duration / o->step >= 100 && o->duration / o->step <= 1e8))
        return trk_fail(context, TRK_E_RANGE,
                        "%s: %g s in steps of %g s, expected 100 to 1e8 steps", what, o->duration,
                        o->step);
    return status;
}

/* Elongation of the link at every step; scratch holds road heights, then links. */
static trk_status run(trk_newmark *stepper, const double *height, int32_t link, int64_t count,
                      double *elongation, double *travel)
{
    trk_status status = trk_newmark_set_state(stepper, 0, NULL, NULL, height, NULL, NULL);
    for (int64_t k = 0; status == TRK_OK && k < count; k++) {
        trk_newmark_get_links(stepper, elongation, NULL, NULL);
        travel[k] = elongation[link - 1];
        status = trk_newmark_step(stepper, height, NULL, NULL);
    }
    return status;
}

/* What a chassis does on its springs is slower, what an axle does on its tires is faster. */
static const double fastest_bounce = 5; /* [Hz] */

/* The second peak may be that of the axle on its tires, where nothing damps it. */
static trk_status check_bounce(trk_context *context, const trk_axle_transient *t)
{
    if (t->damped_frequency <= fastest_bounce)
        return TRK_OK;
    return trk_fail(context, TRK_E_RANGE,
                    "%s: the second compression peak follows at %.3g Hz: weakly damped wheel hop, "
                    "not the motion above the axle (at most %g Hz); take the damping ratio of the "
                    "mode",
                    what, t->damped_frequency, fastest_bounce);
}

static double mean_of_end(int64_t count, const double *x)
{
    int64_t first = count - count / 5;
    double sum = 0;
    for (int64_t k = first; k < count; k++)
        sum += x[k];
    return sum / (double)(count - first);
}

trk_status trk_axle_drop(trk_context *context, const trk_model *model, int32_t roads,
                         const int32_t *road, int32_t link, const trk_axle_drop_options *options,
                         trk_axle_transient *out_transient)
{
    TRK_REQUIRE(context, context, "trk_axle_drop");
    TRK_REQUIRE(context, model, "trk_axle_drop");
    TRK_REQUIRE(context, road, "trk_axle_drop");
    TRK_REQUIRE(context, out_transient, "trk_axle_drop");
    trk_axle_drop_options o = defaults;
    trk_status status = trk_read_options(context, what, options, &o, sizeof o);
    if (status == TRK_OK)
        status = trk_comfort_check_result(context, what, out_transient);
    if (status == TRK_OK)
        status = check_options(context, &o);
    if (status == TRK_OK)
        status = check_parts(context, model, roads, road, link);
    if (status != TRK_OK)
        return status;
    int64_t count = (int64_t)rint(o.duration / o.step);
    int32_t all = trk_model_count(model, TRK_PART_ROAD);
    trk_newmark_options settings;
    trk_newmark_options_init(&settings, sizeof settings);
    settings.step = o.step;
    trk_newmark *stepper = NULL;
    double *height = trk_new(context, all, sizeof *height);
    double *elongation = trk_new(context, trk_model_count(model, TRK_PART_LINK), sizeof *height);
    double *travel = trk_new(context, count, sizeof *travel);
    if (!height || !elongation || !travel)
        status = TRK_E_MEMORY;
    if (status == TRK_OK)
        status = trk_newmark_create(context, model, &settings, &stepper);
    if (status == TRK_OK) {
        for (int32_t k = 0; k < roads; k++)
            height[road[k] - 1] = -o.height;
        status = run(stepper, height, link, count, elongation, travel);
    }
    trk_axle_transient measured = {.struct_size = sizeof measured};
    if (status == TRK_OK)
        status = trk_axle_transient_measure(context, count, travel, 1 / o.step,
                                            mean_of_end(count, travel), &measured);
    if (status == TRK_OK)
        status = check_bounce(context, &measured);
    if (status == TRK_OK)
        status = trk_write_options(out_transient, &measured, sizeof measured);
    trk_newmark_destroy(stepper);
    trk_free(context, travel);
    trk_free(context, elongation);
    trk_free(context, height);
    return status;
}
