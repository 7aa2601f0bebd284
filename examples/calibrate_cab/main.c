/* SPDX-License-Identifier: MIT */
/* Needs NLOPT. */
/*
 * Vertical cab mounts of the reference tractor, front and rear tied by one factor, trimmed to
 * the 1.8 Hz at which the cab of T. Lundberg's truck peaked on the road simulator (KTH, 2013,
 * section 7.2). The tires are trimmed to its axle frequencies first.
 *
 *     calibrate_cab [DIRECTORY]
 *
 * DIRECTORY (default .) receives cab_factors.csv and the frequency responses response_*.csv.
 */
#include "common/trim.h"

#include <math.h>
#include <stdlib.h>

enum { METHODS = 3, VARIANTS = 2, POINTS = 400, SENSORS = 2 };

static const double measured = 1.8, run_duration = 240;
static const double cab_band[2] = {0.9, 4}; /* [Hz] where the cab's peak is looked for */

static const struct {
    const char *name, *title;
    trk_target kind;
} methods[METHODS] = {{"undamped", "by undamped frequency", TRK_TARGET_UNDAMPED_FREQUENCY},
                      {"damped", "by damped frequency", TRK_TARGET_DAMPED_FREQUENCY},
                      {"psd_peak", "by PSD peak", TRK_TARGET_PSD_PEAK}};

static const struct {
    const char *name;
    trk_variant variant;
} variants[VARIANTS] = {{"linear", TRK_VARIANT_LINEAR},
                        {"thesis_dampers", TRK_VARIANT_THESIS_DAMPERS}};

static const struct {
    int model;
    const char *sensors[SENSORS]; /* of the cab, front and rear */
} trucks[] = {{HALF_TRUCK, {"cab_front_z", "cab_rear_z"}},
              {TRUCK_3D, {"cab_front_left_z", "cab_rear_left_z"}}};
enum { TRUCKS = sizeof trucks / sizeof *trucks };

/* Mounts of one method, or the original ones, in the frequency response. */
typedef struct fit {
    char title[64];
    double curve[POINTS * SENSORS]; /* |cab over road| [-] */
} fit;

static trk_spec *create_truck(trk_context *context, const truck_model *m, trk_variant variant)
{
    const double start[MAX_AXLES] = {1, 1};
    double factor[MAX_AXLES];
    trk_spec *spec;
    trimming tires;
    check(context, trk_vehicle_create_builtin(context, m->vehicle, variant, &spec));
    trim_tires(context, m, spec, TRK_TARGET_UNDAMPED_FREQUENCY, start, NULL, NULL, &tires);
    check(context, tires.status);
    for (int32_t k = 0; k < m->axles; k++)
        factor[k] = tires.factor[k].fitted;
    scale_tires(context, m, spec, factor);
    return spec;
}

static trk_calibration *describe(trk_context *context, const trk_spec *spec, trk_target kind,
                                 const char *sensor)
{
    trk_calibration *calibration;
    trk_parameter_options factor;
    trk_target_options target;
    int32_t mounts;
    trk_parameter_options_init(&factor, sizeof factor);
    factor.lower = 0.1;
    factor.upper = 10; /* stiffer is no suspension any more: cab and frame move as one */
    check(context, trk_calibration_create(context, spec, NULL, &calibration));
    check(context, trk_calibration_add_parameter(calibration, "cab mounts", &factor, &mounts));
    check(context, trk_calibration_act_on(calibration, mounts, TRK_FIELD_STIFFNESS,
                                          "cab_*_vertical", 1, NULL));
    trk_target_options_init(&target, sizeof target);
    target.kind = kind;
    target.value = measured;
    target.uncertainty = peak_uncertainty;
    if (kind == TRK_TARGET_PSD_PEAK) {
        target.sensor = sensor;
        target.low = cab_band[0];
        target.high = cab_band[1];
    } else {
        target.coordinate = "cab.z";
    }
    check(context, trk_calibration_add_target(calibration, "cab heave", &target, NULL));
    return calibration;
}

/* 16 s segments: 0.06 Hz apart. Half the time of the full sweep and steps of 2 ms change the
 * peak by less than 0.1 % at these frequencies. */
static void set_run(trk_context *context, trk_calibration *calibration, const trk_excitation *sweep)
{
    trk_run_options run;
    trk_run_options_init(&run, sizeof run);
    run.duration = run_duration;
    run.step = 0.002;
    run.segment_length = 8192;
    run.overlap = SMOOTH_OVERLAP;
    check(context, trk_calibration_set_run(calibration, sweep, &run));
}

/* One line of the table; the report of the library. Applies the answer to a spec. */
static void report(trk_context *context, trk_calibration *calibration, const char *place,
                   trk_status status, const char *message, FILE *table, trk_spec *fitted,
                   double *out_factor)
{
    trk_parameter_result factor = {.struct_size = sizeof factor};
    trk_target_result frequency = {.struct_size = sizeof frequency};
    if (*trk_calibration_report(calibration) == '\0') /* no answer, not even a missed one */
        check(context, status);
    check(context, trk_calibration_get_parameter(calibration, 1, &factor));
    check(context, trk_calibration_get_target(calibration, 1, &frequency));
    check(context, trk_calibration_apply(calibration, fitted));
    printf("%s\n%s\n", place, trk_calibration_report(calibration));
    fprintf(table, "%s,%.1f,%.3f,%.3f,%.3f,%.3f,%.3f,%lld,\"%s%s%s\"\n", place, measured,
            frequency.before, frequency.after, factor.fitted, factor.low95, factor.high95,
            (long long)trk_calibration_evaluations(calibration), trk_status_text(status),
            *message ? ": " : "", message);
    *out_factor = factor.fitted;
}

/* |cab over road| of both ends of the cab, all wheels in phase: POINTS x SENSORS. */
static void respond(trk_context *context, const trk_spec *spec, const char *const *sensors,
                    const double *frequency, double *out)
{
    const double gain[] = {1, 1, 1, 1}, two_pi = 6.283185307179586;
    trk_model *model;
    check(context, trk_model_compile(context, spec, NULL, &model));
    int32_t count = trk_model_count(model, TRK_PART_SENSOR);
    double *all = allocate(2 * (size_t)count * POINTS * sizeof *all);
    check(context, trk_frequency_response(context, model, NULL, NULL, POINTS, frequency, gain, NULL,
                                          NULL, all));
    for (int i = 0; i < POINTS; i++)
        for (int k = 0; k < SENSORS; k++) {
            int32_t sensor = trk_model_find(model, TRK_PART_SENSOR, sensors[k]) - 1;
            const double *z = all + 2 * ((size_t)i * (size_t)count + (size_t)sensor);
            out[i * SENSORS + k] = hypot(z[0], z[1]) / pow(two_pi * frequency[i], 2);
        }
    free(all);
    trk_model_destroy(model);
}

static void write_responses(FILE *file, const double *frequency, const fit *fits)
{
    fputs("frequency_hz", file);
    for (int k = 0; k < SENSORS; k++)
        for (int s = 0; s <= METHODS; s++)
            fprintf(file, ",%s", fits[s].title);
    fputc('\n', file);
    for (int i = 0; i < POINTS; i++) {
        fprintf(file, "%.6g", frequency[i]);
        for (int k = 0; k < SENSORS; k++)
            for (int s = 0; s <= METHODS; s++)
                fprintf(file, ",%.6g", fits[s].curve[i * SENSORS + k]);
        fputc('\n', file);
    }
    fclose(file);
}

static void trim_mounts(trk_context *context, int truck, int variant, int method, trk_spec *fitted,
                        const trk_excitation *sweep, FILE *table, char *title, size_t size)
{
    char place[128], message[512] = "";
    double factor;
    trk_calibration *calibration =
        describe(context, fitted, methods[method].kind, trucks[truck].sensors[0]);
    set_run(context, calibration, sweep);
    snprintf(place, sizeof place, "%s,%s,%s", truck_models[trucks[truck].model].name,
             variants[variant].name, methods[method].name);
    trk_status status = trk_calibration_solve(calibration, NULL, NULL, NULL);
    if (status != TRK_OK)
        snprintf(message, sizeof message, "%s", trk_context_message(context));
    report(context, calibration, place, status, message, table, fitted, &factor);
    snprintf(title, size, "%s: x %.1f%s", methods[method].title, factor,
             status == TRK_OK ? "" : " (not reached)");
    trk_calibration_destroy(calibration);
}

static void study(trk_context *context, int truck, int variant, const char *directory, FILE *table)
{
    static fit fits[METHODS + 1];
    const truck_model *m = &truck_models[trucks[truck].model];
    double frequency[POINTS];
    trk_spec *spec = create_truck(context, m, variants[variant].variant);
    trk_sweep_options options;
    trk_signal *signal;
    trk_model *model;
    trk_sweep_options_init(&options, sizeof options);
    options.duration = run_duration;
    check(context, trk_model_compile(context, spec, NULL, &model));
    trk_excitation *sweep = create_sweep(context, model, &options, &signal);
    for (int i = 0; i < POINTS; i++)
        frequency[i] = 0.5 * pow(40, i / (POINTS - 1.0));
    for (int s = 0; s <= METHODS; s++) {
        trk_spec *fitted;
        check(context, trk_spec_copy(context, spec, &fitted));
        snprintf(fits[s].title, sizeof fits[s].title, "original mounts");
        if (s > 0)
            trim_mounts(context, truck, variant, s - 1, fitted, sweep, table, fits[s].title,
                        sizeof fits[s].title);
        respond(context, fitted, trucks[truck].sensors, frequency, fits[s].curve);
        trk_spec_destroy(fitted);
    }
    char name[128];
    snprintf(name, sizeof name, "response_%s_%s.csv", m->name, variants[variant].name);
    write_responses(open_result(directory, name), frequency, fits);
    trk_excitation_destroy(sweep);
    trk_signal_destroy(signal);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
}

int main(int argc, char **argv)
{
    const char *directory = argc > 1 ? argv[1] : ".";
    trk_context *context;
    if (argc > 2) {
        fprintf(stderr, "usage: calibrate_cab [DIRECTORY]\n");
        return 2;
    }
    if (trk_context_create(NULL, NULL, &context) != TRK_OK)
        return 1;
    FILE *table = open_result(directory, "cab_factors.csv");
    fputs("model,variant,method,target_hz,before_hz,after_hz,factor,low95,high95,evaluations,"
          "status\n",
          table);
    for (int truck = 0; truck < TRUCKS; truck++)
        for (int variant = 0; variant < VARIANTS; variant++)
            study(context, truck, variant, directory, table);
    fclose(table);
    trk_context_destroy(context);
    return 0;
}
