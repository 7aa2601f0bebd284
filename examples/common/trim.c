/* SPDX-License-Identifier: MIT */
/* Tires trimmed to measured axle frequencies, as the thesis does in its sections 8.1 to 8.3. */
#include "common/trim.h"

#include <math.h>
#include <string.h>

#define FRONT(...)                                                                                 \
    {                                                                                              \
        "front", 13.8, __VA_ARGS__                                                                 \
    }
#define REAR(...)                                                                                  \
    {                                                                                              \
        "rear", 10.0, __VA_ARGS__                                                                  \
    }

const truck_model truck_models[TRUCK_MODELS] = {
    [QUARTER_FRONT] = {"quarter_front",
                       "front quarter car",
                       TRK_VEHICLE_REFERENCE_FRONT,
                       1,
                       {FRONT("tire", {"damper", NULL}, "unsprung.z", "unsprung_z")}},
    [QUARTER_REAR] = {"quarter_rear",
                      "rear quarter car",
                      TRK_VEHICLE_REFERENCE_REAR,
                      1,
                      {REAR("tire", {"damper", NULL}, "unsprung.z", "unsprung_z")}},
    [HALF_TRUCK] = {"half_truck",
                    "half truck",
                    TRK_VEHICLE_REFERENCE_HALF,
                    2,
                    {FRONT("front_tire", {"front_damper", NULL}, "front_axle.z", "front_axle_z"),
                     REAR("rear_tire", {"rear_damper", NULL}, "rear_axle.z", "rear_axle_z")}},
    [TRUCK_3D] = {"truck_3d",
                  "3D truck",
                  TRK_VEHICLE_REFERENCE_TRUCK,
                  2,
                  {FRONT("front_*_tire", {"front_left_damper", "front_right_damper"},
                         "front_axle.z", "front_axle_left_z"),
                   REAR("rear_*_tire", {"rear_left_damper", "rear_right_damper"}, "rear_axle.z",
                        "rear_axle_left_z")}},
};

const double peak_uncertainty = 0.1, axle_band[2] = {4, 20};

static void add_axle(trk_context *context, trk_calibration *calibration, const truck_axle *axle,
                     trk_target kind, double start)
{
    trk_parameter_options factor;
    trk_target_options target;
    int32_t id;
    trk_parameter_options_init(&factor, sizeof factor);
    factor.start = start;
    check(context, trk_calibration_add_parameter(calibration, axle->name, &factor, &id));
    check(context,
          trk_calibration_act_on(calibration, id, TRK_FIELD_STIFFNESS, axle->tires, 1, NULL));
    trk_target_options_init(&target, sizeof target);
    target.kind = kind;
    target.value = axle->measured;
    target.uncertainty = peak_uncertainty;
    if (kind == TRK_TARGET_PSD_PEAK) {
        target.sensor = axle->sensor;
        target.low = axle_band[0];
        target.high = axle_band[1];
    } else {
        target.coordinate = axle->coordinate;
    }
    check(context, trk_calibration_add_target(calibration, axle->name, &target, NULL));
}

static void read_answer(trk_context *context, trk_calibration *calibration, const truck_model *m,
                        trimming *out)
{
    for (int32_t k = 0; k < m->axles; k++) {
        trk_target_result frequency = {.struct_size = sizeof frequency};
        out->factor[k].struct_size = sizeof out->factor[k];
        check(context, trk_calibration_get_parameter(calibration, k + 1, &out->factor[k]));
        check(context, trk_calibration_get_target(calibration, k + 1, &frequency));
        out->after[k] = frequency.after;
    }
}

void trim_tires(trk_context *context, const truck_model *m, const trk_spec *spec, trk_target kind,
                const double *start, const trk_run_options *run, const trk_excitation *sweep,
                trimming *out)
{
    const double original[MAX_AXLES] = {1, 1};
    trk_calibration *calibration;
    memset(out, 0, sizeof *out);
    check(context, trk_calibration_create(context, spec, NULL, &calibration));
    for (int32_t k = 0; k < m->axles; k++)
        add_axle(context, calibration, &m->axle[k], kind, start[k]);
    if (sweep)
        check(context, trk_calibration_set_run(calibration, sweep, run));
    if (trk_calibration_evaluate(calibration, original, out->before, NULL) != TRK_OK) {
        snprintf(out->original, sizeof out->original, "%s", trk_context_message(context));
        for (int32_t k = 0; k < m->axles; k++)
            out->before[k] = NAN;
    }
    out->status = trk_calibration_solve(calibration, NULL, NULL, NULL);
    if (out->status != TRK_OK)
        snprintf(out->message, sizeof out->message, "%s", trk_context_message(context));
    out->evaluations = trk_calibration_evaluations(calibration);
    out->solved = *trk_calibration_report(calibration) != '\0';
    if (out->solved)
        read_answer(context, calibration, m, out);
    trk_calibration_destroy(calibration);
}

/* Does a name match a pattern with at most one '*'? */
static int matches(const char *name, const char *pattern)
{
    const char *star = strchr(pattern, '*');
    if (!star)
        return strcmp(name, pattern) == 0;
    size_t head = (size_t)(star - pattern), tail = strlen(star + 1), length = strlen(name);
    return length >= head + tail && strncmp(name, pattern, head) == 0 &&
           strcmp(name + length - tail, star + 1) == 0;
}

void scale_tires(trk_context *context, const truck_model *m, trk_spec *spec, const double *factor)
{
    for (int32_t id = 1; id <= trk_spec_count(spec, TRK_PART_LINK); id++)
        for (int32_t k = 0; k < m->axles; k++) {
            if (!matches(trk_spec_part_name(spec, TRK_PART_LINK, id), m->axle[k].tires))
                continue;
            trk_link_options tire;
            trk_link_options_init(&tire, sizeof tire);
            check(context, trk_spec_get_link(spec, id, &tire));
            tire.stiffness *= factor[k];
            check(context, trk_spec_set_link(spec, id, &tire));
        }
}

void scale_front_dampers(trk_context *context, const truck_model *m, trk_spec *spec, double scale)
{
    for (int side = 0; side < SIDES && m->axle[0].dampers[side]; side++)
        set_damper_scale(context, spec, m->axle[0].dampers[side], scale);
}
