/* SPDX-License-Identifier: MIT */
/* Studies over the fields of laws and beams: every case is the run of a spec varied by hand. */
#include "cases.h"
#include "laws.h"

#include <math.h>
#include <string.h>

enum { FIELDS = 4, SENSORS = 2 };

/* Two fields of one law, the spring beside it, and a beam. */
static const struct {
    const char *name, *pattern;
    trk_field field;
} fields[FIELDS] = {{"friction", "front_*_spring", TRK_FIELD_FRICTION},
                    {"approach", "*_spring", TRK_FIELD_APPROACH},
                    {"spring", "front_*_spring", TRK_FIELD_STIFFNESS},
                    {"tail", "tail", TRK_FIELD_BENDING}};

static const char *const sensors[SENSORS] = {"front_left_tire_force", "cab_front_left_z"};

typedef struct laboratory {
    trk_context *context;
    trk_spec *spec;
    trk_model *model;
    trk_signal *sine;
    trk_excitation *road;
    trk_study *study;
} laboratory;

/* The spec is destroyed with the rest. */
static laboratory open_study(trk_context *context, trk_spec *spec)
{
    laboratory l = {.context = context, .spec = spec};
    trk_study_options o;
    trk_study_parameter_options p;
    trk_study_output_options out;
    trk_study_options_init(&o, sizeof o);
    trk_study_parameter_options_init(&p, sizeof p);
    trk_study_output_options_init(&out, sizeof out);
    o.points = 6;
    o.duration = 0.8;
    p.lower = 0.5;
    p.upper = 2;
    out.kind = TRK_OUTPUT_PEAK;
    assert_ok(context, trk_model_compile(context, l.spec, NULL, &l.model));
    assert_ok(context, trk_signal_create_sine(context, 0.008, 4, 0, 0, &l.sine));
    assert_ok(context, trk_excitation_create(context, l.model, &l.road));
    assert_ok(context, trk_excitation_add_motion(l.road, TRK_ROAD_ALL, l.sine, 1, 0));
    assert_ok(context, trk_study_create(context, l.spec, NULL, &o, &l.study));
    assert_ok(context, trk_study_add_excitation(l.study, "sine", l.road, NULL));
    for (int k = 0; k < FIELDS; k++) {
        int32_t id;
        assert_ok(context, trk_study_add_parameter(l.study, fields[k].name, &p, &id));
        assert_ok(context,
                  trk_study_act_on(l.study, id, fields[k].field, fields[k].pattern, 1, NULL));
    }
    for (int k = 0; k < SENSORS; k++) {
        out.sensor = sensors[k];
        assert_ok(context, trk_study_add_output(l.study, sensors[k], &out, NULL));
    }
    return l;
}

static void close_study(laboratory *l)
{
    trk_study_destroy(l->study);
    trk_excitation_destroy(l->road);
    trk_signal_destroy(l->sine);
    trk_model_destroy(l->model);
    trk_spec_destroy(l->spec);
}

/* Peaks of the sensors with the fields multiplied. */
static void run_by_hand(const laboratory *l, const double *factor, double *peak)
{
    trk_spec *spec;
    trk_model *model;
    trk_series *series;
    trk_simulate_options o;
    trk_simulate_options_init(&o, sizeof o);
    o.duration = 0.8;
    assert_ok(l->context, trk_spec_copy(l->context, l->spec, &spec));
    for (int k = 0; k < FIELDS; k++)
        assert_ok(l->context, trk_spec_vary(spec, fields[k].field, fields[k].pattern,
                                            TRK_MEANING_FACTOR, factor[k], NULL));
    assert_ok(l->context, trk_model_compile(l->context, spec, NULL, &model));
    assert_ok(l->context, trk_simulate(l->context, model, l->road, NULL, &o, NULL, NULL, &series));
    for (int k = 0; k < SENSORS; k++) {
        const double *x =
            trk_series_data(series, trk_model_find(model, TRK_PART_SENSOR, sensors[k]));
        peak[k] = 0;
        for (int64_t j = 0; j < trk_series_samples(series); j++)
            peak[k] = fmax(peak[k], fabs(x[j]));
    }
    trk_series_destroy(series);
    trk_model_destroy(model);
    trk_spec_destroy(spec);
}

static void cases_are_runs_of_varied_specs(void **state)
{
    laboratory l = open_study(*state, support_truck_with_tail(*state));
    trk_study_run_options run;
    trk_study_run_options_init(&run, sizeof run);
    run.threads = 2;
    assert_ok(*state, trk_study_run(l.study, &run, NULL, NULL));
    double least = INFINITY, most = 0;
    for (int64_t number = 0; number < trk_study_cases(l.study); number++) {
        double factor[FIELDS], got[SENSORS], expected[SENSORS];
        int32_t road;
        assert_int_equal(trk_study_get_case(l.study, number, factor, &road), TRK_OK);
        assert_int_equal(trk_study_get_outputs(l.study, number, got, NULL), TRK_OK);
        run_by_hand(&l, factor, expected);
        for (int k = 0; k < SENSORS; k++)
            assert_near(got[k] / expected[k], 1, 1e-8);
        least = fmin(least, got[0]);
        most = fmax(most, got[0]);
    }
    assert_true(most > 1.02 * least); /* the parameters do act */
    close_study(&l);
}

static int64_t fingerprint(trk_context *context, double friction, double bending)
{
    int64_t number;
    trk_spec *spec = support_truck_with_tail(context);
    assert_ok(context, trk_spec_vary(spec, TRK_FIELD_FRICTION, "rear_left_spring",
                                     TRK_MEANING_FACTOR, friction, NULL));
    assert_ok(context,
              trk_spec_vary(spec, TRK_FIELD_BENDING, "tail", TRK_MEANING_FACTOR, bending, NULL));
    laboratory l = open_study(context, spec);
    assert_ok(context, trk_study_get_fingerprint(l.study, &number));
    close_study(&l);
    return number;
}

/* A journal of another friction or another beam is refused. */
static void laws_and_beams_are_in_the_fingerprint(void **state)
{
    int64_t number = fingerprint(*state, 1, 1);
    assert_true(number == fingerprint(*state, 1, 1));
    assert_true(number != fingerprint(*state, 1.001, 1));
    assert_true(number != fingerprint(*state, 1, 1.001));
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(cases_are_runs_of_varied_specs),
        TEST(laws_and_beams_are_in_the_fingerprint),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
