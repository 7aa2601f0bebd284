/* SPDX-License-Identifier: MIT */
/* Memory: every allocation refused once; the peak does not grow with the duration. */
#include "cases.h"

static const char journal[] = "study_memory.journal", table[] = "study_memory.csv";

static trk_status work(trk_context *context)
{
    study_fixture f = study_open(context, TRK_DESIGN_LATIN_HYPERCUBE, 2, 0.5);
    trk_study_run_options o;
    trk_study_run_options_init(&o, sizeof o);
    o.chunk = 3;
    remove(journal);
    STUDY_TRY(&f, trk_study_open_journal(f.study, journal));
    STUDY_TRY(&f, trk_study_run(f.study, &o, NULL, NULL));
    STUDY_TRY(&f, trk_study_close_journal(f.study));
    STUDY_TRY(&f, trk_study_load(f.study, journal));
    STUDY_TRY(&f, trk_study_write_csv(f.study, table));
    study_close(&f);
    return f.status;
}

static void every_allocation_may_fail(void **state)
{
    (void)state;
    support_exhaust_memory(work);
}

/* Bytes in use, and the most of them so far. */
typedef struct counter {
    size_t now, peak;
} counter;

static void *count(void *user, void *block, size_t old_size, size_t new_size)
{
    counter *c = user;
    c->now += new_size - (block ? old_size : 0);
    c->peak = c->now > c->peak ? c->now : c->peak;
    if (new_size)
        return realloc(block, new_size);
    free(block);
    return NULL;
}

static size_t peak_of(double duration, int64_t points)
{
    counter c = {0, 0};
    trk_context *context;
    assert_int_equal(trk_context_create(count, &c, &context), TRK_OK);
    study_fixture f = study_open(context, TRK_DESIGN_LATIN_HYPERCUBE, points, duration);
    assert_ok(context, f.status);
    trk_study_run_options o;
    trk_study_run_options_init(&o, sizeof o);
    o.chunk = 2;
    assert_ok(context, trk_study_run(f.study, &o, NULL, NULL));
    study_close(&f);
    trk_context_destroy(context);
    assert_int_equal(c.now, 0);
    return c.peak;
}

static void the_peak_does_not_depend_on_the_duration(void **state)
{
    (void)state;
    assert_int_equal(peak_of(10, 2), peak_of(100, 2));
}

static void a_case_costs_its_outputs_and_a_status(void **state)
{
    (void)state;
    size_t few = peak_of(1, 2), many = peak_of(1, 52);
    /* 50 points on 2 roads, 10 outputs, and a trk_status each */
    assert_int_equal(many - few, 100 * (10 * sizeof(double) + sizeof(trk_status)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_allocation_may_fail),
        cmocka_unit_test(the_peak_does_not_depend_on_the_duration),
        cmocka_unit_test(a_case_costs_its_outputs_and_a_status),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
