/* SPDX-License-Identifier: MIT */
/* Physical parameters, within published ranges, fitted to the measured peaks. */
#include "thesis_revisited.h"

#include <math.h>
#include <string.h>

/* Ranges of heavy trucks' single tires and multi-leaf springs, of the order that P. S. Fancher et
 * al., A factbook of the mechanical properties of the components for single-unit and articulated
 * heavy trucks (UMTRI-86-12, 1986), and D. Cebon, Vehicle System Dynamics 15 (1986), give. */
const range published[PARAMETERS] = {
    [TIRE] = {"tire stiffness", "N/m", 0.8e6, 1.25e6},
    [FRONT_FRICTION] = {"front friction", "N", 900, 3500},
    [FRONT_APPROACH] = {"front approach", "m", 1e-3, 5e-3},
    [REAR_FRICTION] = {"rear friction", "N", 1000, 6000},
    [REAR_APPROACH] = {"rear approach", "m", 1e-3, 5e-3},
};

/* Where the fit begins: a stiff tire, and the friction that a hand-made probe found. */
static const double start[PARAMETERS] = {1.2e6, 2000, 1.2e-3, 1500, 2e-3};

/* In calibrations the sweep takes a quarter of the time: peaks agree within 0.1 Hz. */
static const double short_sweep = 120, short_step = 0.002; /* [s] */

/* The peaks of a run with friction scatter by about this much with its details. */
static const double uncertainty = 0.3; /* [Hz] */

static void add_leaf_law(trk_context *context, trk_spec *spec, int32_t spring, double friction,
                         double approach)
{
    trk_leaf_options leaf;
    trk_link_options link;
    trk_law *law;
    trk_leaf_options_init(&leaf, sizeof leaf);
    trk_link_options_init(&link, sizeof link);
    leaf.friction = friction;
    leaf.approach_bump = approach;
    check(context, trk_law_create_leaf(context, "leaf spring", &leaf, &law));
    check(context, trk_spec_get_link(spec, spring, &link));
    link.law = law;
    check(context, trk_spec_set_link(spec, spring, &link));
    trk_law_destroy(law);
}

void add_leaf_laws(trk_context *context, const truck_model *m, trk_spec *spec, const double *value)
{
    for (int32_t k = 1; k <= trk_spec_count(spec, TRK_PART_LINK); k++) {
        const char *name = trk_spec_part_name(spec, TRK_PART_LINK, k);
        if (!strstr(name, "spring") || strstr(name, "cab"))
            continue;
        int is_rear = strstr(name, "rear") || m == &truck_models[QUARTER_REAR];
        add_leaf_law(context, spec, k, value[is_rear ? REAR_FRICTION : FRONT_FRICTION],
                     value[is_rear ? REAR_APPROACH : FRONT_APPROACH]);
    }
}

static int has_front(const truck_model *m)
{
    return m != &truck_models[QUARTER_REAR];
}

static int has_rear(const truck_model *m)
{
    return m != &truck_models[QUARTER_FRONT];
}

/* A parameter by its value, within its published range. */
static int32_t add_parameter(trk_context *context, trk_calibration *calibration, int which,
                             trk_field field, const char *pattern)
{
    trk_parameter_options options;
    int32_t id;
    trk_parameter_options_init(&options, sizeof options);
    options.meaning = TRK_MEANING_VALUE;
    options.start = start[which];
    options.lower = published[which].low;
    options.upper = published[which].high;
    check(context,
          trk_calibration_add_parameter(calibration, published[which].name, &options, &id));
    check(context, trk_calibration_act_on(calibration, id, field, pattern, 1, NULL));
    return id;
}

static void add_target(trk_context *context, trk_calibration *calibration, const char *name,
                       const char *sensor, double measured)
{
    trk_target_options target;
    trk_target_options_init(&target, sizeof target);
    target.kind = TRK_TARGET_PSD_PEAK;
    target.sensor = sensor;
    target.value = measured;
    target.uncertainty = uncertainty;
    target.low = axle_band[0];
    target.high = axle_band[1];
    check(context, trk_calibration_add_target(calibration, name, &target, NULL));
}

/* The truck and, beside it on the same cylinders, its twin without front damper. */
static trk_spec *create_pair(trk_context *context, const truck_model *m)
{
    trk_spec *pair, *twin;
    check(context,
          trk_vehicle_create_builtin(context, m->vehicle, TRK_VARIANT_THESIS_DAMPERS, &pair));
    add_leaf_laws(context, m, pair, start);
    if (has_front(m)) {
        check(context, trk_spec_copy(context, pair, &twin));
        scale_front_dampers(context, m, twin, 0);
        add_twin(context, pair, twin, "bare_");
        trk_spec_destroy(twin);
    }
    return pair;
}

static void solve(trk_context *context, trk_calibration *calibration, const int32_t *id, fit *out)
{
    trk_solve_options options;
    trk_solve_options_init(&options, sizeof options);
    options.max_evaluations = 120; /* further starts found nothing better */
    out->status = trk_calibration_solve(calibration, &options, NULL, NULL);
    snprintf(out->message, sizeof out->message, "%s",
             out->status == TRK_OK ? "" : trk_context_message(context));
    out->evaluations = trk_calibration_evaluations(calibration);
    for (int k = 0; k < PARAMETERS; k++) {
        out->parameter[k] = (trk_parameter_result){.struct_size = sizeof *out->parameter};
        if (id[k])
            check(context, trk_calibration_get_parameter(calibration, id[k], &out->parameter[k]));
    }
}

/* The short run on all wheels of the model of a spec. */
typedef struct rig {
    trk_run_options run;
    trk_signal *signal;
    trk_model *model;
    trk_excitation *excitation;
} rig;

static void rig_up(trk_context *context, const trk_spec *spec, rig *r)
{
    trk_sweep_options sweep;
    trk_sweep_options_init(&sweep, sizeof sweep);
    trk_run_options_init(&r->run, sizeof r->run);
    sweep.amplitude = sweep_amplitude;
    sweep.duration = r->run.duration = short_sweep;
    r->run.step = short_step;
    r->run.segment_length = 4096;
    check(context, trk_model_compile(context, spec, NULL, &r->model));
    r->excitation = create_sweep(context, r->model, &sweep, &r->signal);
}

static void take_down(rig *r)
{
    trk_excitation_destroy(r->excitation);
    trk_signal_destroy(r->signal);
    trk_model_destroy(r->model);
}

void trim_only_tires(trk_context *context, const truck_model *m, double *out_factor)
{
    const double factor[MAX_AXLES] = {m->axles == 1 && !has_front(m) ? 2.4 : 4.7, 2.4};
    trimming trimmed;
    trk_spec *spec;
    rig r;
    check(context,
          trk_vehicle_create_builtin(context, m->vehicle, TRK_VARIANT_THESIS_DAMPERS, &spec));
    rig_up(context, spec, &r);
    trim_tires(context, m, spec, TRK_TARGET_PSD_PEAK, factor, &r.run, r.excitation, &trimmed);
    for (int32_t k = 0; k < m->axles; k++)
        out_factor[k] = trimmed.factor[k].fitted;
    take_down(&r);
    trk_spec_destroy(spec);
}

/* The parameters that a model has, on the links whose names end so. */
static void add_parameters(trk_context *context, const truck_model *m, trk_calibration *calibration,
                           int32_t *id)
{
    const char *front = has_rear(m) ? "*front_*spring" : "*spring";
    const char *rear = has_front(m) ? "*rear_*spring" : "*spring";
    id[TIRE] = add_parameter(context, calibration, TIRE, TRK_FIELD_STIFFNESS, "*tire");
    if (has_front(m)) {
        id[FRONT_FRICTION] =
            add_parameter(context, calibration, FRONT_FRICTION, TRK_FIELD_FRICTION, front);
        id[FRONT_APPROACH] =
            add_parameter(context, calibration, FRONT_APPROACH, TRK_FIELD_APPROACH, front);
    }
    if (has_rear(m)) {
        id[REAR_FRICTION] =
            add_parameter(context, calibration, REAR_FRICTION, TRK_FIELD_FRICTION, rear);
        id[REAR_APPROACH] =
            add_parameter(context, calibration, REAR_APPROACH, TRK_FIELD_APPROACH, rear);
    }
}

void fit_leaf(trk_context *context, const truck_model *m, fit *out)
{
    trk_calibration *calibration;
    int32_t id[PARAMETERS] = {0};
    rig r;
    trk_spec *pair = create_pair(context, m);
    check(context, trk_calibration_create(context, pair, NULL, &calibration));
    add_parameters(context, m, calibration, id);
    for (int32_t k = 0; k < m->axles; k++)
        add_target(context, calibration, m->axle[k].name, m->axle[k].sensor, m->axle[k].measured);
    if (has_front(m)) {
        char twin[128];
        snprintf(twin, sizeof twin, "bare_%s", m->axle[0].sensor);
        add_target(context, calibration, "front, no damper", twin, measured_undamped);
    }
    rig_up(context, pair, &r);
    check(context, trk_calibration_set_run(calibration, r.excitation, &r.run));
    solve(context, calibration, id, out);
    take_down(&r);
    trk_calibration_destroy(calibration);
    trk_spec_destroy(pair);
}
