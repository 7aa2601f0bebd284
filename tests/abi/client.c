/* SPDX-License-Identifier: MIT */
/* A program of a user who compiled it once: client.py builds it with older and newer headers and
   runs it with the library of today. Everything it computes has a closed form. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <truckride/truckride.h>

#define MASS 1000.0     /* kg */
#define STIFFNESS 4.0e5 /* N/m */
#define STEP 0.001      /* s */
#define SECONDS 4.0     /* s */
#define START 0.01      /* m */
#define PI 3.14159265358979323846

/* What lies behind a caller's struct is the caller's: the library must not write there. */
#define GUARD 0x5a
#define GUARDED(type, name)                                                                        \
    struct {                                                                                       \
        type options;                                                                              \
        unsigned char behind[64];                                                                  \
    } name;                                                                                        \
    memset(&name, GUARD, sizeof name)
#define TRY(call)                                                                                  \
    do {                                                                                           \
        const trk_status status_ = (call);                                                         \
        if (status_ != TRK_OK)                                                                     \
            return failed(#call, status_, context);                                                \
    } while (0)
#define EXPECT(condition)                                                                          \
    do {                                                                                           \
        if (!(condition))                                                                          \
            return failed(#condition, TRK_OK, context);                                            \
    } while (0)

static int failed(const char *what, trk_status status, const trk_context *context)
{
    printf("%s: %s: %s\n", what, trk_status_text(status), trk_context_message(context));
    return status == TRK_E_OPTIONS ? 3 : 1;
}

static int untouched(const unsigned char *behind)
{
    for (int k = 0; k < 64; k++)
        if (behind[k] != GUARD)
            return 0;
    return 1;
}

/* A mass on a spring with one sensor. */
static int describe(trk_context *context, trk_spec **out_spec)
{
    GUARDED(trk_body_options, body);
    GUARDED(trk_link_options, spring);
    GUARDED(trk_sensor_options, sensor);
    int32_t mass = 0;
    TRY(trk_spec_create(context, "oscillator", out_spec));
    trk_body_options_init(&body.options, sizeof body.options);
    body.options.mass = MASS;
    TRY(trk_spec_add_body(*out_spec, "mass", &body.options, &mass));
    trk_link_options_init(&spring.options, sizeof spring.options);
    spring.options.to_body = mass;
    spring.options.stiffness = STIFFNESS;
    TRY(trk_spec_add_link(*out_spec, "spring", &spring.options, NULL));
    trk_sensor_options_init(&sensor.options, sizeof sensor.options);
    sensor.options.quantity = TRK_QUANTITY_DISPLACEMENT;
    sensor.options.body = mass;
    TRY(trk_spec_add_sensor(*out_spec, "z", &sensor.options, NULL));

    TRY(trk_spec_get_link(*out_spec, 1, &spring.options));
    EXPECT(spring.options.stiffness == STIFFNESS && spring.options.to_body == mass);
    EXPECT(untouched(body.behind) && untouched(spring.behind) && untouched(sensor.behind));
    return 0;
}

/* Average acceleration keeps the amplitude; the frequency is (2/h) atan(w h / 2). */
static int check_run(trk_context *context, const trk_series *series)
{
    const double *z = trk_series_data(series, trk_series_find(series, "z"));
    const int64_t samples = trk_series_samples(series);
    const double turn = 2 * atan(sqrt(STIFFNESS / MASS) * STEP / 2);
    EXPECT(z != NULL && samples == (int64_t)(SECONDS / STEP) + 1);
    for (int64_t k = 0; k < samples; k++)
        EXPECT(fabs(z[k] - START * cos(turn * (double)k)) < 1e-9 * START * (double)(k + 1));

    /* Hann window, segments of 1 s: the level of a sine in the "spectrum" scaling. */
    GUARDED(trk_spectrum_options, spectrum);
    static double density[513];
    double rms = 0;
    trk_spectrum_options_init(&spectrum.options, sizeof spectrum.options);
    spectrum.options.segment_length = 1000;
    EXPECT(trk_psd_length(&spectrum.options, samples) == 501);
    TRY(trk_psd(context, samples, z, 1 / STEP, &spectrum.options, density));
    TRY(trk_band_rms(context, 501, density, 1, 0, 500, &rms));
    EXPECT(fabs(rms / (START / sqrt(2.0)) - 1) < 0.01);
    EXPECT(untouched(spectrum.behind));
    return 0;
}

static int run(trk_context *context, const trk_model *model, const trk_excitation *road)
{
    GUARDED(trk_newmark_options, newmark);
    GUARDED(trk_simulate_options, options);
    GUARDED(trk_newmark_statistics, statistics);
    const double start = START;
    trk_series *series = NULL;
    trk_newmark *stepper = NULL;
    trk_newmark_options_init(&newmark.options, sizeof newmark.options);
    newmark.options.step = STEP;
#ifdef SET_NEWER_FIELD
    newmark.options.newer_field = 1;
#endif
    trk_simulate_options_init(&options.options, sizeof options.options);
    options.options.duration = SECONDS;
    options.options.initial_q = &start;
    TRY(trk_simulate(context, model, road, &newmark.options, &options.options, NULL, NULL,
                     &series));
    if (check_run(context, series) != 0)
        return 1;
    trk_series_destroy(series);

    TRY(trk_newmark_create(context, model, &newmark.options, &stepper));
    TRY(trk_newmark_step(stepper, NULL, NULL, NULL));
    statistics.options.struct_size = sizeof statistics.options;
    TRY(trk_newmark_get_statistics(stepper, &statistics.options));
    EXPECT(statistics.options.steps == 1 && statistics.options.coordinates == 1);
    trk_newmark_destroy(stepper);
    EXPECT(untouched(newmark.behind) && untouched(options.behind) && untouched(statistics.behind));
    return 0;
}

int main(void)
{
    trk_context *context = NULL;
    trk_spec *spec = NULL;
    trk_model *model = NULL;
    trk_excitation *road = NULL;
    int result;
    TRY(trk_context_create(NULL, NULL, &context));
    if (describe(context, &spec) != 0)
        return 1;
    TRY(trk_model_compile(context, spec, NULL, &model));
    TRY(trk_excitation_create(context, model, &road));
    result = run(context, model, road);
#ifdef CALL_NEWER_FUNCTION
    result += trk_newer_function();
#endif
    if (result != 0)
        return result;
    trk_excitation_destroy(road);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    EXPECT(trk_context_blocks(context) == 0);
    trk_context_destroy(context);
    puts("ok");
    return 0;
}
