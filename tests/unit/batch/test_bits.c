/* SPDX-License-Identifier: MIT */
/*
 * The bits of a variant do not depend on its lane, on what rides beside it, on the order, or on
 * the number of threads; and only the calling thread asks for memory or reports progress. The
 * batch starts its threads with pthread_create: the label of this test.
 */
#include "fleet.h"

#include <pthread.h>

enum { VARIANTS = 21 };

static void same(const fleet *a, int32_t variant_a, const fleet *b, int32_t variant_b)
{
    assert_int_equal(a->received[variant_a], a->samples);
    assert_int_equal(b->received[variant_b], b->samples);
    assert_memory_equal(a->recorded[variant_a], b->recorded[variant_b], fleet_bytes(a));
}

/* Part of a fleet in another order: variant k of it is variant order[k] of the whole. */
static fleet pick(const fleet *whole, int32_t count, const int32_t *order)
{
    fleet f = *whole;
    f.count = count;
    for (int32_t k = 0; k < count; k++) {
        f.model[k] = whole->model[order[k]];
        f.road[k] = whole->road[order[k]];
    }
    memset(f.recorded, 0, sizeof f.recorded);
    return f;
}

static void check_pick(const fleet *whole, int32_t count, const int32_t *order)
{
    fleet f = pick(whole, count, order);
    assert_ok(f.context, fleet_run(&f, NULL, NULL));
    for (int32_t k = 0; k < count; k++)
        same(&f, k, whole, order[k]);
    fleet_forget(&f);
}

static void check_fleet(trk_context *context, trk_variant variant, int32_t kernel, int32_t roads)
{
    static const int32_t shuffled[VARIANTS] = {13, 4, 20, 0, 17, 8, 11, 2,  6,  15, 19,
                                               1,  9, 3,  7, 18, 5, 10, 16, 12, 14};
    static const int32_t few[] = {19, 2, 2, 7, 12};
    fleet f;
    fleet_create(&f, context, TRK_VEHICLE_REFERENCE_TRUCK, variant, 0, VARIANTS, roads);
    if (!fleet_has_kernel(&f, kernel)) {
        fleet_destroy(&f);
        return;
    }
    f.kernel = kernel;
    assert_ok(context, fleet_run(&f, NULL, NULL));
    check_pick(&f, VARIANTS, shuffled);
    check_pick(&f, 5, few);
    for (int32_t k = 0; k < VARIANTS; k += 6)
        check_pick(&f, 1, &k);
    for (int32_t threads = 2; threads <= 3; threads++) {
        fleet g = pick(&f, VARIANTS, shuffled);
        g.options.threads = threads;
        assert_ok(context, fleet_run(&g, NULL, NULL));
        for (int32_t k = 0; k < VARIANTS; k++)
            same(&g, k, &f, shuffled[k]);
        fleet_forget(&g);
    }
    fleet_destroy(&f);
}

static void test_composition(void **state)
{
    for (int32_t kernel = 0; kernel < TRK_BATCH_KERNEL_BEST; kernel++)
        for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++)
            check_fleet(*state, variant, kernel, variant + 1);
}

/* At rest on a level road all numbers are zeros, and even their signs are the same. */
static void test_rest(void **state)
{
    fleet f;
    fleet_create(&f, *state, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_NONLINEAR, 0, 4, 4);
    trk_excitation *level;
    assert_ok(*state, trk_excitation_create(*state, f.model[0], &level));
    trk_excitation_destroy(f.road[1]);
    f.road[1] = level;
    assert_ok(*state, fleet_run(&f, NULL, NULL));
    check_pick(&f, 1, &(int32_t){1});
    fleet_destroy(&f);
}

/* An allocator that remembers whether another thread came. */
typedef struct watch {
    support_memory memory;
    pthread_t caller;
    int strangers, progress_strangers, reports;
} watch;

static void *watching_allocate(void *user, void *block, size_t old_size, size_t new_size)
{
    watch *w = user;
    w->strangers += !pthread_equal(w->caller, pthread_self());
    return support_allocate(&w->memory, block, old_size, new_size);
}

static int32_t watching_progress(void *user, double fraction)
{
    watch *w = user;
    w->progress_strangers += !pthread_equal(w->caller, pthread_self());
    w->reports++;
    return fraction < 0 || fraction > 1;
}

static void test_calling_thread(void **state)
{
    (void)state;
    for (int32_t kernel = 0; kernel <= TRK_BATCH_KERNEL_BEST; kernel += TRK_BATCH_KERNEL_BEST) {
        watch w = {.caller = pthread_self()};
        trk_context *context;
        assert_int_equal(trk_context_create(watching_allocate, &w, &context), TRK_OK);
        fleet f;
        fleet_create(&f, context, TRK_VEHICLE_REFERENCE_HALF, TRK_VARIANT_NONLINEAR, 0, VARIANTS,
                     2);
        f.options.threads = 3;
        f.kernel = kernel;
        assert_ok(context, fleet_run(&f, watching_progress, &w));
        assert_true(w.reports >= 2);
        assert_int_equal(w.strangers, 0);
        assert_int_equal(w.progress_strangers, 0);
        fleet_destroy(&f);
        trk_context_destroy(context);
        assert_int_equal(w.memory.live, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_composition, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(test_rest, support_setup, support_teardown),
        cmocka_unit_test(test_calling_thread),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
