/* SPDX-License-Identifier: MIT */
/* Create an explicit stepper: options, memory, factors of M, check of the step. */
#include "rungekutta/limit.h"
#include "rungekutta/rungekutta.h"

#include <math.h>

static const trk_rungekutta_options defaults = {.struct_size = sizeof defaults, .step = 1e-3};

void trk_rungekutta_options_init(trk_rungekutta_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

/* Every array starts on a cache line. */
static int64_t padded(int64_t count)
{
    return (count + 7) / 8 * 8;
}

/* Deal out the block; counts only while there is none. */
static int64_t deal(trk_rungekutta *s, int64_t n, int64_t roads, int64_t ports)
{
    struct {
        double **array;
        int64_t count;
    } arrays[] = {{&s->q, n},
                  {&s->v, n},
                  {&s->a, n},
                  {&s->next_q, n},
                  {&s->next_v, n},
                  {&s->next_a, n},
                  {&s->now.height, roads},
                  {&s->now.velocity, roads},
                  {&s->now.load, ports},
                  {&s->middle.height, roads},
                  {&s->middle.velocity, roads},
                  {&s->middle.load, ports},
                  {&s->end.height, roads},
                  {&s->end.velocity, roads},
                  {&s->end.load, ports},
                  {&s->v2, n},
                  {&s->v3, n},
                  {&s->v4, n},
                  {&s->q_stage, n},
                  {&s->a2, n},
                  {&s->a3, n},
                  {&s->a4, n},
                  {&s->out_q, n},
                  {&s->out_v, n},
                  {&s->out_a, n}};
    int64_t used = 0;
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++) {
        *arrays[k].array = s->block ? s->block + used : NULL;
        used += padded(arrays[k].count);
    }
    return used;
}

static trk_status prepare(trk_rungekutta *stepper)
{
    trk_context *context = stepper->context;
    const trk_model *model = stepper->model;
    int64_t n = model->n, roads = model->names[TRK_PART_ROAD].count, ports = model->ports.count;
    stepper->block = trk_new(context, deal(stepper, n, roads, ports), sizeof *stepper->block);
    stepper->hints = trk_new(context, model->links.count, sizeof *stepper->hints);
    stepper->spring_column = trk_new(context, model->links.count, sizeof(int32_t));
    stepper->damper_column = trk_new(context, model->links.count, sizeof(int32_t));
    if (!stepper->block || !stepper->hints || !stepper->spring_column || !stepper->damper_column)
        return TRK_E_MEMORY;
    deal(stepper, n, roads, ports);
    trk_status status = trk_assembly_create(context, TRK_BACKEND_AUTO, model->n, &model->inertia,
                                            model->mass, &stepper->no_links, &stepper->assembly);
    int32_t bad = 0;
    if (status == TRK_OK)
        status = trk_assembly_factorize(&stepper->assembly, 1, NULL, &bad);
    if (status == TRK_OK)
        status = trk_explicit_create(context, model, stepper->step, &stepper->modal);
    stepper->kernel = trk_explicit_choose_kernel();
    return status == TRK_OK ? trk_rungekutta_set_state(stepper, 0, NULL, NULL, NULL, NULL, NULL)
                            : status;
}

trk_status trk_rungekutta_build(trk_context *context, const trk_model *model, double step,
                                trk_rungekutta **out_stepper)
{
    trk_rungekutta *stepper = trk_new(context, 1, sizeof *stepper);
    if (!stepper)
        return TRK_E_MEMORY;
    stepper->context = context;
    stepper->model = model;
    stepper->step = step;
    trk_status status = prepare(stepper);
    if (status == TRK_OK)
        *out_stepper = stepper;
    else
        trk_rungekutta_destroy(stepper);
    return status;
}

static trk_status check_laws(trk_context *context, const trk_model *model)
{
    int32_t link = trk_model_find_law(model);
    if (link < 0)
        return TRK_OK;
    return trk_fail(context, TRK_E_UNSUPPORTED,
                    "%s: link '%s' has the law '%s', which the Runge-Kutta method does not know; "
                    "take trk_newmark",
                    trk_model_name(model), trk_model_part_name(model, TRK_PART_LINK, link + 1),
                    trk_law_name(model->laws[link].law));
}

static trk_status check_step(trk_context *context, const trk_model *model, double step)
{
    double limit;
    int32_t row;
    if (!isfinite(step) || step <= 0)
        return trk_fail(context, TRK_E_RANGE,
                        "trk_rungekutta_options: step is %g s; a finite number > 0 is needed",
                        step);
    trk_status status = trk_rungekutta_find_stiffest(context, model, &limit, &row);
    if (status != TRK_OK || step <= limit)
        return status;
    const char *word, *name = trk_model_link_name(model, row - 1, &word);
    return trk_fail(context, TRK_E_RANGE,
                    "%s: a step of %g s is beyond the limit of stability of the Runge-Kutta "
                    "method, %.6g s, set by %ss like '%s'; take shorter steps or trk_newmark",
                    trk_model_name(model), step, limit, word, name);
}

trk_status trk_rungekutta_create(trk_context *context, const trk_model *model,
                                 const trk_rungekutta_options *options,
                                 trk_rungekutta **out_stepper)
{
    TRK_REQUIRE(context, out_stepper, "trk_rungekutta_create");
    *out_stepper = NULL;
    TRK_REQUIRE(context, context, "trk_rungekutta_create");
    TRK_REQUIRE(context, model, "trk_rungekutta_create");
    trk_rungekutta_options known = defaults;
    trk_status status =
        trk_read_options(context, "trk_rungekutta_options", options, &known, sizeof known);
    if (status == TRK_OK)
        status = check_laws(context, model);
    if (status == TRK_OK)
        status = check_step(context, model, known.step);
    return status == TRK_OK ? trk_rungekutta_build(context, model, known.step, out_stepper)
                            : status;
}

void trk_rungekutta_destroy(trk_rungekutta *stepper)
{
    if (!stepper)
        return;
    trk_context *context = stepper->context;
    if (stepper->assembly.context)
        trk_assembly_clear(&stepper->assembly);
    trk_explicit_destroy(stepper->modal);
    trk_free(context, stepper->block);
    trk_free(context, stepper->hints);
    trk_free(context, stepper->spring_column);
    trk_free(context, stepper->damper_column);
    trk_free(context, stepper);
}
