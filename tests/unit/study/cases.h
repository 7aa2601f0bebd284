/* SPDX-License-Identifier: MIT */
/* A small study that the tests of the room share: the thesis's quarter car over two roads. */
#ifndef TRK_TESTS_STUDY_CASES_H
#define TRK_TESTS_STUDY_CASES_H

#include "support.h"

#include <truckride/simulate.h>
#include <truckride/study.h>
#include <truckride/vehicle.h>

typedef struct study_fixture {
    trk_spec *spec;
    trk_model *model;
    trk_signal *sweep, *step;
    trk_excitation *rough, *bump;
    trk_study *study;
    trk_status status; /* of the first call that failed */
} study_fixture;

#define STUDY_TRY(f, call)                                                                         \
    do {                                                                                           \
        if ((f)->status == TRK_OK)                                                                 \
            (f)->status = (call);                                                                  \
    } while (0)

static inline void study_add_output(study_fixture *f, const char *name, trk_output kind,
                                    const char *sensor, double low, double high)
{
    static const double frequency[] = {0.5, 4, 8, 80}, weight[] = {0.4, 1, 1, 0.1};
    trk_study_output_options o;
    trk_study_output_options_init(&o, sizeof o);
    o.kind = kind;
    o.sensor = sensor;
    o.low = low;
    o.high = high;
    o.count = 4;
    o.frequency = frequency;
    o.weight = weight;
    STUDY_TRY(f, trk_study_add_output(f->study, name, &o, NULL));
}

/* Points of a design over both roads, `duration` seconds each; all kinds of outputs. */
static inline study_fixture study_open(trk_context *context, trk_design design, int64_t points,
                                       double duration)
{
    study_fixture f = {0};
    trk_sweep_options sweep;
    trk_sweep_options_init(&sweep, sizeof sweep);
    sweep.duration = duration;
    STUDY_TRY(&f, trk_vehicle_create_builtin(context, TRK_VEHICLE_THESIS_QUARTER, 0, &f.spec));
    STUDY_TRY(&f, trk_model_compile(context, f.spec, NULL, &f.model));
    STUDY_TRY(&f, trk_signal_create_sweep(context, &sweep, &f.sweep));
    STUDY_TRY(&f, trk_signal_create_step(context, 0.1, 0.2, 0.02, &f.step));
    STUDY_TRY(&f, trk_excitation_create(context, f.model, &f.rough));
    STUDY_TRY(&f, trk_excitation_create(context, f.model, &f.bump));
    STUDY_TRY(&f, trk_excitation_add_motion(f.rough, TRK_ROAD_ALL, f.sweep, 1, 0));
    STUDY_TRY(&f, trk_excitation_add_motion(f.bump, TRK_ROAD_ALL, f.step, 1, 0));
    trk_study_options o;
    trk_study_options_init(&o, sizeof o);
    o.design = design;
    o.points = points;
    o.duration = duration;
    o.settle = 0.1 * duration;
    STUDY_TRY(&f, trk_study_create(context, f.spec, NULL, &o, &f.study));
    trk_spectrum_options spectrum;
    trk_spectrum_options_init(&spectrum, sizeof spectrum);
    spectrum.segment_length = 256;
    spectrum.overlap = 0.7;
    STUDY_TRY(&f, trk_study_set_spectrum(f.study, &spectrum));
    trk_study_parameter_options p;
    trk_study_parameter_options_init(&p, sizeof p);
    STUDY_TRY(&f, trk_study_add_parameter(f.study, "tire", &p, NULL));
    p.distribution = TRK_DISTRIBUTION_LOG_NORMAL;
    p.mean = 0;
    p.levels = 2;
    STUDY_TRY(&f, trk_study_add_parameter(f.study, "body, mass", &p, NULL));
    STUDY_TRY(&f, trk_study_act_on(f.study, 1, TRK_FIELD_STIFFNESS, "*tire", 1, NULL));
    STUDY_TRY(&f, trk_study_act_on(f.study, 2, TRK_FIELD_MASS, "sprung", 1, NULL));
    STUDY_TRY(&f, trk_study_add_excitation(f.study, "sweep", f.rough, NULL));
    STUDY_TRY(&f, trk_study_add_excitation(f.study, "step", f.bump, NULL));
    const char *a = trk_model_part_name(f.model, TRK_PART_SENSOR, 1),
               *b = trk_model_part_name(f.model, TRK_PART_SENSOR, 2);
    study_add_output(&f, "max", TRK_OUTPUT_MAXIMUM, a, 0, 0);
    study_add_output(&f, "min", TRK_OUTPUT_MINIMUM, b, 0, 0);
    study_add_output(&f, "peak", TRK_OUTPUT_PEAK, a, 0, 0);
    study_add_output(&f, "mean", TRK_OUTPUT_MEAN, a, 0, 0);
    study_add_output(&f, "rms", TRK_OUTPUT_RMS, b, 0, 0);
    study_add_output(&f, "std", TRK_OUTPUT_DEVIATION, a, 0, 0);
    study_add_output(&f, "band", TRK_OUTPUT_BAND_RMS, b, 2, 12);
    study_add_output(&f, "f", TRK_OUTPUT_PSD_PEAK_FREQUENCY, a, 0.5, 30);
    study_add_output(&f, "height", TRK_OUTPUT_PSD_PEAK_HEIGHT, a, 0.5, 30);
    study_add_output(&f, "weighted", TRK_OUTPUT_WEIGHTED_RMS, a, 0, 0);
    return f;
}

static inline void study_close(study_fixture *f)
{
    trk_study_destroy(f->study);
    trk_excitation_destroy(f->bump);
    trk_excitation_destroy(f->rough);
    trk_signal_destroy(f->step);
    trk_signal_destroy(f->sweep);
    trk_model_destroy(f->model);
    trk_spec_destroy(f->spec);
}

/* A whole file, 0-terminated; the caller frees it. */
static inline char *study_read_file(const char *path, size_t *out_size)
{
    FILE *file = fopen(path, "rb");
    char *text = NULL;
    *out_size = 0;
    if (!file)
        return NULL;
    fseek(file, 0, SEEK_END);
    *out_size = (size_t)ftell(file);
    rewind(file);
    text = malloc(*out_size + 1);
    if (text && fread(text, 1, *out_size, file) == *out_size)
        text[*out_size] = 0;
    fclose(file);
    return text;
}

static inline void study_write_file(const char *path, const char *text, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(text, 1, size, file), size);
    fclose(file);
}

static inline void study_same_files(const char *a, const char *b)
{
    size_t size_a, size_b;
    char *text_a = study_read_file(a, &size_a), *text_b = study_read_file(b, &size_b);
    assert_non_null(text_a);
    assert_non_null(text_b);
    assert_int_equal(size_a, size_b);
    assert_memory_equal(text_a, text_b, size_a);
    free(text_a);
    free(text_b);
}

#endif
