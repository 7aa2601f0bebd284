/* SPDX-License-Identifier: MIT */
/* truckride calibrate: parameters of a vehicle from measured frequencies. */
#include "calibrate.h"
#include "common/text.h"
#include "common/watch.h"
#include "export.h"
#include "output.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct settings {
    run_options run;
    words targets, parameters;
    bool anyway;
    int64_t evaluations;
    int32_t starts;
    const char *model;
} settings;

#define AT(field) offsetof(settings, field)

static const argument own[] = {
    {.help = "Calibration"},
    {"target", 't', ARGUMENT_WORDS, AT(targets), "[KIND:]NAME=VALUE[:uncertainty=X][:weight=X]",
     "a measured value: COORDINATE=HZ, undamped frequency of the mode with most\n"
     "energy there; damped:COORDINATE=HZ; ratio:COORDINATE=X, damping ratio;\n"
     "peak:SENSOR:LOW..HIGH=HZ, highest peak of the PSD on --road. Default\n"
     "uncertainty: 1 %",
     0},
    {"parameter", 'p', ARGUMENT_WORDS, AT(parameters), "PATTERN[,PATTERN...]:FIELD:LOW..HIGH",
     "a factor on stiffness, damping, mass, inertia, mass_inertia, friction,\n"
     "approach or bending of all parts that match; then start=X, value (no\n"
     "factor), name=NAME, each behind a colon",
     0},
    {"starts", 0, ARGUMENT_COUNT, AT(starts), "N", "starting points; default 1", 0},
    {"evaluations", 0, ARGUMENT_WHOLE, AT(evaluations), "N",
     "most evaluations from each; default 200", 0},
    {"out", 'o', ARGUMENT_TEXT, AT(model), "MODEL",
     "write the calibrated model there if all targets are met; with -, the tables\n"
     "go to standard error",
     0},
    {"anyway", 0, ARGUMENT_SWITCH, AT(anyway), NULL, "write it in any case", 0},
    {"format", 'f', ARGUMENT_CHOICE, offsetof(shared, format), "table|csv|json", "default table",
     FORMAT_TABLE},
    {"road", 'r', ARGUMENT_TEXT, offsetof(run_options, road), "ROAD",
     "of targets of the kind peak, see truckride help simulate; default: sweep", 0},
    {"duration", 'd', ARGUMENT_NUMBER, offsetof(run_options, duration), "S",
     "of that run; default 480", 0},
    {0}};
static const argument *const tables[] = {own, shared_model, shared_general, NULL};

static table *parameter_table(trk_calibration *calibration, const settings *o)
{
    table *t = table_create("parameters");
    table_column_add(t, "parameter", "", TABLE_TEXT);
    table_column_add(t, "start", "", TABLE_GENERAL);
    table_column_add(t, "fitted", "", TABLE_GENERAL);
    table_column_add(t, "low 95 %", "", TABLE_GENERAL);
    table_column_add(t, "high 95 %", "", TABLE_GENERAL);
    table_column_add(t, "remark", "", TABLE_TEXT);
    for (int32_t k = 1; k <= o->parameters.count; k++) {
        trk_parameter_result r = {.struct_size = sizeof r};
        if (trk_calibration_get_parameter(calibration, k, &r) != TRK_OK)
            continue;
        table_text(t, o->parameters.word[k - 1]);
        table_number(t, r.start);
        table_number(t, r.fitted);
        table_number(t, r.determined ? r.low95 : NAN);
        table_number(t, r.determined ? r.high95 : NAN);
        table_text(t, !r.determined    ? "not determined"
                      : r.at_bound < 0 ? "at lower bound"
                      : r.at_bound > 0 ? "at upper bound"
                                       : "");
    }
    return t;
}

static table *target_table(trk_calibration *calibration, const settings *o)
{
    table *t = table_create("targets");
    table_column_add(t, "target", "", TABLE_TEXT);
    table_column_add(t, "measured", "", TABLE_GENERAL);
    table_column_add(t, "before", "", TABLE_GENERAL);
    table_column_add(t, "after", "", TABLE_GENERAL);
    table_column_add(t, "residual", "", TABLE_GENERAL);
    table_column_add(t, "met", "", TABLE_TEXT);
    for (int32_t k = 1; k <= o->targets.count; k++) {
        trk_target_result r = {.struct_size = sizeof r};
        if (trk_calibration_get_target(calibration, k, &r) != TRK_OK)
            continue;
        table_text(t, o->targets.word[k - 1]);
        table_number(t, r.measured);
        table_number(t, r.before);
        table_number(t, r.after);
        table_number(t, r.residual);
        table_text(t, r.met ? "yes" : "no");
    }
    return t;
}

/* The tables make way for a model on standard output. */
static int print(session *s, const settings *o, trk_calibration *calibration)
{
    table *t[] = {parameter_table(calibration, o), target_table(calibration, o)};
    int code = EXIT_DONE;
    if (table_rows(t[0]) > 0 && o->model && strcmp(o->model, "-") == 0)
        tables_write(stderr, s->shared->format ? s->shared->format : FORMAT_TABLE, 2, t, s->colour);
    else if (table_rows(t[0]) > 0)
        code = output_tables(s, 2, t);
    table_destroy(t[0]);
    table_destroy(t[1]);
    return code;
}

static int solve(session *s, const settings *o, trk_calibration *calibration, trk_spec *spec)
{
    trk_solve_options options;
    progress bar = {.quiet = s->shared->quiet};
    trk_solve_options_init(&options, sizeof options);
    options.max_evaluations = o->evaluations > 0 ? o->evaluations : options.max_evaluations;
    options.starts = o->starts > 0 ? o->starts : options.starts;
    watch_signals();
    trk_status status = trk_calibration_solve(calibration, &options, progress_step, &bar);
    progress_end(&bar);
    const int solved = status == TRK_OK ? EXIT_DONE : session_fail(s, status);
    if (solved == EXIT_INTERRUPTED)
        return solved;
    int code = print(s, o, calibration);
    if (code != EXIT_DONE || !o->model || (solved != EXIT_DONE && !o->anyway))
        return code != EXIT_DONE ? code : solved;
    status = trk_calibration_apply(calibration, spec);
    code = status == TRK_OK ? export_model(s, spec, o->model) : session_fail(s, status);
    return code != EXIT_DONE ? code : solved;
}

static int give_run(session *s, settings *o, trk_calibration *calibration, const trk_model *model,
                    road *r)
{
    trk_run_options options;
    trk_run_options_init(&options, sizeof options);
    o->run.road = o->run.road ? o->run.road : "sweep";
    o->run.duration = o->run.duration > 0 ? o->run.duration : options.duration;
    const int code = run_road(s, &o->run, model, r);
    if (code != EXIT_DONE)
        return code;
    options.duration = o->run.duration;
    const trk_status status = trk_calibration_set_run(calibration, r->excitation, &options);
    return status == TRK_OK ? EXIT_DONE : session_fail(s, status);
}

static int calibrate(session *s, settings *o, trk_spec *spec, const trk_model *model)
{
    trk_calibration *calibration = NULL;
    trk_model_options compile;
    road r = {0};
    bool needs_run = false;
    trk_model_options_init(&compile, sizeof compile);
    compile.gravity = trk_model_gravity(model);
    const trk_status status = trk_calibration_create(s->context, spec, &compile, &calibration);
    int code = status == TRK_OK ? EXIT_DONE : session_fail(s, status);
    for (int k = 0; k < o->parameters.count && code == EXIT_DONE; k++)
        code = calibrate_parameter(s, calibration, o->parameters.word[k]);
    for (int k = 0; k < o->targets.count && code == EXIT_DONE; k++)
        code = calibrate_target(s, calibration, o->targets.word[k], &needs_run);
    if (code == EXIT_DONE && needs_run)
        code = give_run(s, o, calibration, model, &r);
    if (code == EXIT_DONE)
        code = solve(s, o, calibration, spec);
    trk_calibration_destroy(calibration);
    road_close(&r);
    return code;
}

static int run(session *s, int argc, char **argv)
{
    settings o = {.run = run_defaults()};
    trk_spec *spec = NULL;
    trk_model *model = NULL;
    int code;
    if (session_begin(s, &o, argc, argv, &code) && session_operands(s, 1, 1, "MODEL", &code)) {
        code = o.targets.count == 0      ? session_usage(s, "--target is missing")
               : o.parameters.count == 0 ? session_usage(s, "--parameter is missing")
                                         : output_check(s, o.model);
        if (code == EXIT_DONE)
            code = session_model(s, s->operands.word[0], &spec, &model);
        if (code == EXIT_DONE)
            code = calibrate(s, &o, spec, model);
        trk_model_destroy(model);
        trk_spec_destroy(spec);
    }
    words_free(&o.targets);
    words_free(&o.parameters);
    session_end(s);
    return code;
}

extern const command calibrate_command;
const command calibrate_command = {
    "calibrate",
    "fit parameters to measured frequencies",
    "--target TARGET... --parameter PARAMETER... [OPTION...] MODEL",
    "Fit parameters of a vehicle to measured values, show them with their 95 % intervals and\n"
    "every target before and after, and write the calibrated model. The exit code is 1, and the\n"
    "model is not written, if a target is not met or a parameter is not determined.\n",
    "  truckride calibrate truck.json --target front_axle.z=13.8 --target rear_axle.z=10 \\\n"
    "      --parameter 'front_*_tire:stiffness:0.5..8' \\\n"
    "      --parameter 'rear_*_tire:stiffness:0.5..8' -o calibrated.json\n"
    "  truckride calibrate builtin:reference_truck:linear --target damped:cab.z=1.8 \\\n"
    "      --parameter 'cab_*_vertical:stiffness:0.3..3'\n",
    tables,
    run,
    false,
};
