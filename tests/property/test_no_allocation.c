/* SPDX-License-Identifier: MIT */
/*
 * Stepping allocates nothing, neither from the context nor past it: this program's own
 * malloc, calloc, realloc and aligned_alloc stand before the C library's and count.
 */
#include "support.h"
#include "vehicles.h"

enum { STEPS = 10000 };

static int64_t calls; /* of the functions below */

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define __SANITIZE_ADDRESS__ 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
#define COUNTS_MALLOC 0 /* the sanitizer's malloc must stay in front; the context still counts */
#else
#define COUNTS_MALLOC 1

extern void *__libc_malloc(size_t size);
extern void *__libc_calloc(size_t count, size_t size);
extern void *__libc_realloc(void *block, size_t size);
extern void *__libc_memalign(size_t alignment, size_t size);

void *malloc(size_t size)
{
    calls++;
    return __libc_malloc(size);
}

void *calloc(size_t count, size_t size)
{
    calls++;
    return __libc_calloc(count, size);
}

void *realloc(void *block, size_t size)
{
    calls++;
    return __libc_realloc(block, size);
}

void *aligned_alloc(size_t alignment, size_t size)
{
    calls++;
    return __libc_memalign(alignment, size);
}
#endif

/* The counter sees what the libraries allocate, or the test below would prove nothing. */
static void test_counter_counts(void **state)
{
    int64_t before = calls;
    trk_model *model = support_model(*state, TRK_VEHICLE_REFERENCE_TRUCK, TRK_VARIANT_LINEAR, 0);
    if (COUNTS_MALLOC)
        assert_true(calls > before + 10);
    trk_model_destroy(model);
}

static void check(trk_variant variant, int method, trk_backend backend)
{
    support_memory memory = {0, 0, 0};
    trk_context *context;
    assert_int_equal(trk_context_create(support_allocate, &memory, &context), TRK_OK);
    trk_model *model = support_model(context, TRK_VEHICLE_REFERENCE_TRUCK, variant, 0);
    trk_newmark_options options;
    support_method(method, 1e-3, &options);
    options.backend = backend;
    trk_newmark *stepper;
    assert_ok(context, trk_newmark_create(context, model, &options, &stepper));
    double height[4], velocity[4], load[2], values[256];
    trk_status status = TRK_OK;
    int64_t requests = memory.calls, before = calls;
    for (int64_t k = 1; k <= STEPS && status == TRK_OK; k++) {
        support_road((double)k * 1e-3, 4, height, velocity);
        support_load((double)k * 1e-3, 2, load);
        status = trk_newmark_step(stepper, height, velocity, load);
        trk_newmark_read_sensors(stepper, values);
    }
    int64_t after = calls;
    assert_int_equal(status, TRK_OK);
    assert_int_equal(memory.calls, requests);
    assert_int_equal(after, before);
    trk_newmark_destroy(stepper);
    trk_model_destroy(model);
    trk_context_destroy(context);
    assert_int_equal(memory.live, 0);
}

static void test_dense(void **state)
{
    (void)state;
    for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++)
        check(variant, variant, TRK_BACKEND_DENSE);
}

static void test_sparse(void **state)
{
    (void)state;
    if (!trk_has_feature(TRK_FEATURE_CHOLMOD))
        skip();
    for (trk_variant variant = 0; variant < SUPPORT_VARIANTS; variant++)
        check(variant, variant, TRK_BACKEND_SPARSE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_counter_counts, support_setup, support_teardown),
        cmocka_unit_test(test_dense),
        cmocka_unit_test(test_sparse),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
