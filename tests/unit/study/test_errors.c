/* SPDX-License-Identifier: MIT */
/* Arguments that a study refuses, and what it says. */
#include "cases.h"

static void null_pointers(void **state)
{
    study_fixture f = study_open(*state, TRK_DESIGN_LATIN_HYPERCUBE, 2, 1);
    trk_study *none = (trk_study *)1;
    int64_t print;
    double value[16] = {0};
    assert_status(*state, trk_study_create(NULL, f.spec, NULL, NULL, &none), TRK_E_ARGUMENT);
    assert_null(none);
    assert_status(*state, trk_study_create(*state, NULL, NULL, NULL, &none), TRK_E_ARGUMENT);
    assert_status(*state, trk_study_create(*state, f.spec, NULL, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_set_newmark(NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_set_spectrum(NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_add_parameter(NULL, "a", NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_act_on(NULL, 1, 1, "a", 1, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_study_act_on(f.study, 1, 1, NULL, 1, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_add_output(NULL, "a", NULL, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_study_add_output(f.study, "a", NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_add_excitation(NULL, "a", f.bump, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_study_add_excitation(f.study, "a", NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_run(NULL, NULL, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_run_cases(NULL, 0, NULL, NULL, NULL, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_set_outputs(NULL, 0, 0, value), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_get_fingerprint(NULL, &print), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_get_case(NULL, 0, value, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_get_outputs(NULL, 0, value, NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_open_journal(NULL, "a"), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_close_journal(NULL), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_load(NULL, "a"), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_write_csv(NULL, "a"), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_cases(NULL) + trk_study_finished(NULL), 0);
    assert_int_equal(trk_study_is_finished(NULL, 0) + trk_study_count(NULL, 1), 0);
    assert_null(trk_study_part_name(NULL, 1, 1));
    assert_null(trk_study_output_unit(NULL, 1));
    trk_study_destroy(NULL);
    study_close(&f);
}

static void options_out_of_range(void **state)
{
    study_fixture f = study_open(*state, TRK_DESIGN_LATIN_HYPERCUBE, 2, 1);
    trk_study *study;
    trk_study_options o;
#define REFUSE(field, bad, expected)                                                               \
    trk_study_options_init(&o, sizeof o);                                                          \
    o.field = bad;                                                                                 \
    assert_status(*state, trk_study_create(*state, f.spec, NULL, &o, &study), expected)
    REFUSE(design, 0, TRK_E_ARGUMENT);
    REFUSE(design, 4, TRK_E_ARGUMENT);
    REFUSE(reserved, 1, TRK_E_ARGUMENT);
    REFUSE(points, 0, TRK_E_RANGE);
    REFUSE(points, INT64_MAX, TRK_E_RANGE);
    REFUSE(duration, NAN, TRK_E_RANGE);
    REFUSE(duration, -1, TRK_E_RANGE);
    REFUSE(start, INFINITY, TRK_E_RANGE);
    REFUSE(settle, 10, TRK_E_RANGE);
    REFUSE(settle, NAN, TRK_E_RANGE);
    REFUSE(record_every, 0, TRK_E_RANGE);
    REFUSE(struct_size, 3, TRK_E_OPTIONS);
#undef REFUSE
    trk_study_parameter_options p;
#define REFUSE(field, bad, expected)                                                               \
    trk_study_parameter_options_init(&p, sizeof p);                                                \
    p.distribution = TRK_DISTRIBUTION_LOG_NORMAL;                                                  \
    p.mean = 0;                                                                                    \
    p.field = bad;                                                                                 \
    assert_status(*state, trk_study_add_parameter(f.study, "p", &p, NULL), expected)
    REFUSE(distribution, 4, TRK_E_ARGUMENT);
    REFUSE(meaning, 2, TRK_E_ARGUMENT);
    REFUSE(reserved, 1, TRK_E_ARGUMENT);
    REFUSE(lower, 0, TRK_E_RANGE);
    REFUSE(lower, 1.2, TRK_E_RANGE);
    REFUSE(lower, NAN, TRK_E_RANGE);
    REFUSE(upper, INFINITY, TRK_E_RANGE);
    REFUSE(mean, 1e6, TRK_E_RANGE);
    REFUSE(deviation, 0, TRK_E_RANGE);
    REFUSE(levels, 0, TRK_E_RANGE);
#undef REFUSE
    assert_status(*state, trk_study_add_parameter(f.study, "tire", NULL, NULL), TRK_E_NAME);
    assert_status(*state, trk_study_add_parameter(f.study, "", NULL, NULL), TRK_E_NAME);
    assert_status(*state, trk_study_add_parameter(f.study, NULL, NULL, NULL), TRK_E_NAME);
    assert_status(*state, trk_study_act_on(f.study, 3, 1, "*", 1, NULL), TRK_E_ARGUMENT);
    assert_status(*state, trk_study_act_on(f.study, 1, TRK_FIELD_BENDING + 1, "*", 1, NULL),
                  TRK_E_ARGUMENT);
    assert_status(*state, trk_study_act_on(f.study, 1, 2, "*", 0, NULL), TRK_E_RANGE);
    assert_status(*state, trk_study_act_on(f.study, 1, 2, "no", 1, NULL), TRK_E_NAME);
    assert_status(*state, trk_study_act_on(f.study, 2, 1, "tire", 1, NULL), TRK_E_MODEL);
    assert_message(*state, "already acted on by parameter 'tire'");
    study_close(&f);
}

static void too_many_cases(void **state)
{
    study_fixture f = study_open(*state, TRK_DESIGN_FACTORIAL, 0, 1);
    trk_study_parameter_options p;
    trk_study_parameter_options_init(&p, sizeof p);
    p.levels = 1000000;
    assert_ok(*state, trk_study_add_parameter(f.study, "x", &p, NULL));
    assert_status(*state, trk_study_add_parameter(f.study, "y", &p, NULL), TRK_E_RANGE);
    assert_int_equal(trk_study_cases(f.study), 12000000);
    study_close(&f);
}

static void outputs_out_of_range(void **state)
{
    study_fixture f = study_open(*state, TRK_DESIGN_LATIN_HYPERCUBE, 2, 1);
    const char *sensor = trk_model_part_name(f.model, TRK_PART_SENSOR, 1);
    static const double bad_frequency[] = {2, 2}, zero[] = {0, 1}, good[] = {1, 2};
    trk_study_output_options o;
#define REFUSE(field, bad, expected)                                                               \
    trk_study_output_options_init(&o, sizeof o);                                                   \
    o.kind = TRK_OUTPUT_WEIGHTED_RMS;                                                              \
    o.sensor = sensor;                                                                             \
    o.count = 2;                                                                                   \
    o.frequency = good;                                                                            \
    o.weight = good;                                                                               \
    o.field = bad;                                                                                 \
    assert_status(*state, trk_study_add_output(f.study, "new", &o, NULL), expected)
    REFUSE(kind, 0, TRK_E_ARGUMENT);
    REFUSE(kind, 11, TRK_E_ARGUMENT);
    REFUSE(reserved, 1, TRK_E_ARGUMENT);
    REFUSE(sensor, NULL, TRK_E_ARGUMENT);
    REFUSE(sensor, "nothing", TRK_E_NAME);
    REFUSE(low, -1, TRK_E_RANGE);
    REFUSE(high, NAN, TRK_E_RANGE);
    REFUSE(count, 0, TRK_E_ARGUMENT);
    REFUSE(weight, NULL, TRK_E_ARGUMENT);
    REFUSE(weight, zero, TRK_E_RANGE);
    REFUSE(frequency, bad_frequency, TRK_E_RANGE);
    REFUSE(frequency, zero, TRK_E_RANGE);
#undef REFUSE
    o.frequency = good;
    assert_status(*state, trk_study_add_output(f.study, "rms", &o, NULL), TRK_E_NAME);
    assert_status(*state, trk_study_add_excitation(f.study, "step", f.bump, NULL), TRK_E_NAME);
    study_close(&f);
}

static void runs_that_cannot_begin(void **state)
{
    study_fixture f = study_open(*state, TRK_DESIGN_LATIN_HYPERCUBE, 2, 1);
    trk_study_run_options r;
    double value[10] = {0};
#define REFUSE(field, bad, expected)                                                               \
    trk_study_run_options_init(&r, sizeof r);                                                      \
    r.field = bad;                                                                                 \
    assert_status(*state, trk_study_run(f.study, &r, NULL, NULL), expected)
    REFUSE(threads, 0, TRK_E_RANGE);
    REFUSE(chunk, -1, TRK_E_RANGE);
    REFUSE(shard, 0, TRK_E_RANGE);
    REFUSE(shard, 2, TRK_E_RANGE);
    REFUSE(shards, 0, TRK_E_RANGE);
    REFUSE(struct_size, 9000000, TRK_E_OPTIONS);
#undef REFUSE
    int64_t beyond = 4;
    assert_status(*state, trk_study_run_cases(f.study, 1, &beyond, NULL, NULL, NULL),
                  TRK_E_ARGUMENT);
    assert_status(*state, trk_study_run_cases(f.study, -1, &beyond, NULL, NULL, NULL),
                  TRK_E_ARGUMENT);
    assert_ok(*state, trk_study_run_cases(f.study, 0, NULL, NULL, NULL, NULL));
    assert_status(*state, trk_study_set_outputs(f.study, 4, TRK_OK, value), TRK_E_ARGUMENT);
    assert_status(*state, trk_study_set_outputs(f.study, 0, TRK_E_MEMORY, value), TRK_E_ARGUMENT);
    value[3] = INFINITY;
    assert_status(*state, trk_study_set_outputs(f.study, 0, TRK_OK, value), TRK_E_ARGUMENT);
    assert_int_equal(trk_study_get_outputs(f.study, 0, value, NULL), TRK_E_ARGUMENT);
    assert_ok(*state, trk_study_add_parameter(f.study, "idle", NULL, NULL));
    assert_status(*state, trk_study_run(f.study, NULL, NULL, NULL), TRK_E_ARGUMENT);
    assert_message(*state, "'idle' acts on nothing");
    trk_spectrum_options s;
    trk_spectrum_options_init(&s, sizeof s);
    s.scaling = TRK_SCALING_SPECTRUM;
    assert_status(*state, trk_study_set_spectrum(f.study, &s), TRK_E_ARGUMENT);
    study_close(&f);
    f = study_open(*state, TRK_DESIGN_LATIN_HYPERCUBE, 2, 0.2); /* 181 samples, segments of 256 */
    assert_status(*state, trk_study_run(f.study, NULL, NULL, NULL), TRK_E_RANGE);
    trk_newmark_options n;
    trk_newmark_options_init(&n, sizeof n);
    n.beta = 7;
    assert_ok(*state, trk_study_set_newmark(f.study, &n));
    assert_status(*state, trk_study_run(f.study, NULL, NULL, NULL), TRK_E_RANGE);
    study_close(&f);
    f = study_open(*state, TRK_DESIGN_LATIN_HYPERCUBE, 2, 2);
    assert_ok(*state, trk_study_set_newmark(f.study, &n)); /* no case fails by itself of this */
    assert_status(*state, trk_study_run(f.study, NULL, NULL, NULL), TRK_E_RANGE);
    assert_int_equal(trk_study_finished(f.study), 0);
    study_close(&f);
}

static void a_study_without_roads_or_outputs(void **state)
{
    study_fixture f = study_open(*state, TRK_DESIGN_LATIN_HYPERCUBE, 2, 1);
    trk_study *study;
    assert_ok(*state, trk_study_create(*state, f.spec, NULL, NULL, &study));
    assert_status(*state, trk_study_run(study, NULL, NULL, NULL), TRK_E_ARGUMENT);
    assert_message(*state, "no road");
    assert_ok(*state, trk_study_add_excitation(study, "a", f.bump, NULL));
    assert_status(*state, trk_study_run(study, NULL, NULL, NULL), TRK_E_ARGUMENT);
    assert_message(*state, "no output");
    trk_study_destroy(study);
    study_close(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(null_pointers),
        cmocka_unit_test(options_out_of_range),
        cmocka_unit_test(too_many_cases),
        cmocka_unit_test(outputs_out_of_range),
        cmocka_unit_test(runs_that_cannot_begin),
        cmocka_unit_test(a_study_without_roads_or_outputs),
    };
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
