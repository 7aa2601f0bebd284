/* SPDX-License-Identifier: MIT */
/* Threads with a context each share one immutable object and get what a single thread gets. */
#include "support.h"

#include <pthread.h>
#include <truckride/curve.h>

enum { THREADS = 4, PLACES = 2000 };

typedef struct job {
    const trk_curve *shared;
    double value[PLACES], slope[PLACES];
    trk_status status;
} job;

static void evaluate(job *j)
{
    for (int k = 0; k < PLACES; k++) {
        double x = 3.0 * ((k * 7919) % PLACES) / PLACES - 1.5; /* all over the place */
        j->value[k] = trk_curve_value(j->shared, x);
        j->slope[k] = trk_curve_slope(j->shared, x);
    }
}

/* Works in its own context too, where it fails on purpose: messages must not meet. */
static void *work(void *argument)
{
    job *j = argument;
    trk_context *context = NULL;
    trk_curve *copy = NULL;
    j->status = trk_context_create(NULL, NULL, &context);
    if (j->status != TRK_OK)
        return NULL;
    for (int k = 0; k < 50 && j->status == TRK_OK; k++) {
        if (trk_curve_create(context, "wrong", 1, NULL, NULL, NULL, &copy) != TRK_E_ARGUMENT)
            j->status = TRK_E_INTERNAL;
        else
            j->status = trk_curve_copy(context, j->shared, &copy);
        trk_curve_destroy(copy);
    }
    evaluate(j);
    trk_context_destroy(context);
    return NULL;
}

static void shared_curve(void **state)
{
    static const double x[] = {-1.0, -0.3, 0.0, 0.2, 1.0}, y[] = {-9.0, -4.0, 0.0, 1.0, 2.0};
    static job jobs[THREADS], alone;
    pthread_t threads[THREADS];
    trk_curve *curve = NULL;
    assert_ok(*state, trk_curve_create(*state, "damper", 5, x, y, NULL, &curve));
    alone.shared = curve;
    evaluate(&alone);
    for (int k = 0; k < THREADS; k++) {
        jobs[k].shared = curve;
        assert_int_equal(pthread_create(&threads[k], NULL, work, &jobs[k]), 0);
    }
    for (int k = 0; k < THREADS; k++) {
        assert_int_equal(pthread_join(threads[k], NULL), 0);
        assert_int_equal(jobs[k].status, TRK_OK);
        assert_memory_equal(jobs[k].value, alone.value, sizeof alone.value);
        assert_memory_equal(jobs[k].slope, alone.slope, sizeof alone.slope);
    }
    trk_curve_destroy(curve);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(shared_curve, support_setup, support_teardown),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
