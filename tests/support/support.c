/* SPDX-License-Identifier: MIT */
#include "support.h"

void *support_allocate(void *user, void *block, size_t old_size, size_t new_size)
{
    support_memory *memory = user;
    (void)old_size;
    if (new_size == 0) {
        if (block)
            memory->live--;
        free(block);
        return NULL;
    }
    memory->calls++;
    if (memory->refuse_at && memory->calls >= memory->refuse_at)
        return NULL;
    void *moved = realloc(block, new_size);
    if (moved && !block)
        memory->live++;
    return moved;
}

int support_setup(void **state)
{
    trk_context *context = NULL;
    if (trk_context_create(NULL, NULL, &context) != TRK_OK)
        return -1;
    *state = context;
    return 0;
}

int support_teardown(void **state)
{
    trk_context *context = *state;
    int64_t left = trk_context_blocks(context);
    trk_context_destroy(context);
    if (left)
        fprintf(stderr, "%lld blocks leaked\n", (long long)left);
    return left == 0 ? 0 : -1;
}

void support_exhaust_memory(trk_status (*work)(trk_context *context))
{
    for (int64_t refuse_at = 2;; refuse_at++) { /* request 1 is the context itself */
        support_memory memory = {0, 0, refuse_at};
        trk_context *context = NULL;
        assert_int_equal(trk_context_create(support_allocate, &memory, &context), TRK_OK);
        trk_status status = work(context);
        assert_int_equal(trk_context_blocks(context), 0);
        trk_context_destroy(context);
        assert_int_equal(memory.live, 0);
        if (status == TRK_OK) {
            assert_true(memory.calls < refuse_at); /* nothing was refused */
            return;
        }
        assert_int_equal(status, TRK_E_MEMORY);
        assert_true(refuse_at < 100000);
    }
}

void support_near(double a, double b, double tolerance, const char *what, const char *file,
                  int line)
{
    if (fabs(a - b) <= tolerance)
        return;
    print_error("%s = %.17g, expected %.17g, difference %.3g > %.3g\n", what, a, b, fabs(a - b),
                tolerance);
    _fail(file, line);
}

void support_status(const trk_context *context, trk_status got, trk_status wanted, const char *what,
                    const char *file, int line)
{
    if (got == wanted)
        return;
    print_error("%s\n  returned %d (%s), expected %d (%s)\n  message: %s\n", what, got,
                trk_status_text(got), wanted, trk_status_text(wanted),
                trk_context_message(context));
    _fail(file, line);
}

void support_message(const trk_context *context, const char *text, const char *file, int line)
{
    if (strstr(trk_context_message(context), text))
        return;
    print_error("message \"%s\"\n  does not contain \"%s\"\n", trk_context_message(context), text);
    _fail(file, line);
}
