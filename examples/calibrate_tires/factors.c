/* SPDX-License-Identifier: MIT */
/* Calibration by three methods, and the table of factors. */
#include "calibrate_tires.h"

#include <math.h>
#include <string.h>

const method methods[METHODS] = {{"undamped", TRK_TARGET_UNDAMPED_FREQUENCY},
                                 {"damped", TRK_TARGET_DAMPED_FREQUENCY},
                                 {"psd_peak", TRK_TARGET_PSD_PEAK}};

/* Factors of the thesis, sections 8.1 to 8.3, by model and axle. */
static const double thesis_factor[TRUCK_MODELS][MAX_AXLES] = {
    [QUARTER_FRONT] = {6}, [QUARTER_REAR] = {2.2}, [HALF_TRUCK] = {3, 2.2}, [TRUCK_3D] = {3, 2.2}};

/* A quarter of the time and twice the step of the full run: an eighth of the work. */
static void short_run(trk_run_options *run, trk_sweep_options *sweep)
{
    trk_run_options_init(run, sizeof *run);
    trk_sweep_options_init(sweep, sizeof *sweep);
    run->duration = sweep->duration = 120;
    run->step = 0.002;
    run->segment_length = 2048;
    run->overlap = SMOOTH_OVERLAP;
}

void calibrate(trk_context *context, trimmed *t)
{
    trk_run_options run;
    trk_sweep_options options;
    trk_signal *signal;
    trk_model *model;
    short_run(&run, &options);
    check(context, trk_model_compile(context, t->spec, NULL, &model));
    trk_excitation *sweep = create_sweep(context, model, &options, &signal);
    for (int k = 0; k < METHODS; k++) {
        double start[MAX_AXLES] = {1, 1};
        int runs = methods[k].kind == TRK_TARGET_PSD_PEAK;
        /* Near the answer: each evaluation is a run. The undamped method comes first and always
         * has an answer. */
        for (int32_t a = 0; runs && a < t->model->axles; a++)
            start[a] = t->by[0].factor[a].fitted;
        trim_tires(context, t->model, t->spec, methods[k].kind, start, &run, runs ? sweep : NULL,
                   &t->by[k]);
    }
    trk_excitation_destroy(sweep);
    trk_signal_destroy(signal);
    trk_model_destroy(model);
}

void write_factor_head(FILE *table)
{
    fputs("model,variant,method,axle,target_hz,before_hz,after_hz,factor,low95,high95,"
          "thesis_factor,evaluations,status\n",
          table);
    printf("Tire stiffness factors that bring each axle to its measured frequency\n\n"
           "%-14s %-15s %-9s %-5s %7s %7s %7s %7s %16s %7s %6s  %s\n",
           "model", "variant", "method", "axle", "target", "before", "after", "factor",
           "95 % interval", "thesis", "evals", "status");
}

/* A number, or nothing where there is none. */
static const char *number(char *text, size_t size, const char *format, double value)
{
    snprintf(text, size, format, value);
    return isnan(value) ? "" : text;
}

void write_factors(const trimmed *t, FILE *table)
{
    for (int32_t axle = 0; axle < t->model->axles; axle++)
        for (int k = 0; k < METHODS; k++) {
            const trimming *by = &t->by[k];
            const trk_parameter_result *f = &by->factor[axle];
            const truck_axle *a = &t->model->axle[axle];
            char before[32], after[32], factor[32], low[32], high[32], interval[80];
            double none = by->solved ? 0 : NAN,
                   thesis = thesis_factor[t->model - truck_models][axle];
            const char *text[5] = {number(before, sizeof before, "%.3f", by->before[axle]),
                                   number(after, sizeof after, "%.3f", by->after[axle] + none),
                                   number(factor, sizeof factor, "%.3f", f->fitted + none),
                                   number(low, sizeof low, "%.3f", f->low95 + none),
                                   number(high, sizeof high, "%.3f", f->high95 + none)};
            snprintf(interval, sizeof interval, "%s .. %s", text[3], text[4]);
            fprintf(table, "%s,%s,%s,%s,%.1f,%s,%s,%s,%s,%s,%.1f,%lld,\"%s%s%s%s%s\"\n",
                    t->model->name, t->variant, methods[k].name, a->name, a->measured, text[0],
                    text[1], text[2], text[3], text[4], thesis, (long long)by->evaluations,
                    trk_status_text(by->status), *by->message ? ": " : "", by->message,
                    *by->original ? "; original tires: " : "", by->original);
            printf("%-14s %-15s %-9s %-5s %7.1f %7s %7s %7s %16s %7.1f %6lld  %s%s\n",
                   t->model->name, t->variant, methods[k].name, a->name, a->measured,
                   *text[0] ? text[0] : "none", *text[1] ? text[1] : "none", text[2],
                   by->solved ? interval : "", thesis, (long long)by->evaluations,
                   trk_status_text(by->status), *by->message || *by->original ? " *" : "");
        }
}

void print_remarks(const trimmed *t)
{
    for (int k = 0; k < METHODS; k++) {
        if (*t->by[k].original)
            printf("* %s, %s, %s, original tires: %s.\n", t->model->name, t->variant,
                   methods[k].name, t->by[k].original);
        if (*t->by[k].message)
            printf("* %s, %s, %s: %s.\n", t->model->name, t->variant, methods[k].name,
                   t->by[k].message);
    }
}
