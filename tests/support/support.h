/* SPDX-License-Identifier: MIT */
/* What every test file needs: cmocka, a counting and failing allocator, tolerant comparisons. */
#ifndef TRK_TESTS_SUPPORT_H
#define TRK_TESTS_SUPPORT_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <truckride/base.h>

/* Allocator state: counts calls, can refuse. Hand it to trk_context_create(support_allocate, &s, ...). */
typedef struct support_memory {
    int64_t calls;     /* requests for memory so far            */
    int64_t live;      /* blocks not freed yet                  */
    int64_t refuse_at; /* refuse this request and all later ones; 0: never */
} support_memory;

void *support_allocate(void *user, void *block, size_t old_size, size_t new_size);

/* cmocka setup and teardown: *state becomes a trk_context *; teardown fails if blocks are left. */
int support_setup(void **state);
int support_teardown(void **state);

/* Run `work` with the first, second, ... allocation refused until it succeeds. It must
 * return TRK_E_MEMORY each time before and leave nothing allocated. */
void support_exhaust_memory(trk_status (*work)(trk_context *context));

/* Fails with both values unless |a - b| <= tolerance. */
#define assert_near(a, b, tolerance) support_near((a), (b), (tolerance), #a, __FILE__, __LINE__)
void support_near(double a, double b, double tolerance, const char *what, const char *file,
                  int line);

/* Fails with the context's message unless call returned status. */
#define assert_status(context, call, status)                                                       \
    support_status((context), (call), (status), #call, __FILE__, __LINE__)
#define assert_ok(context, call) assert_status(context, call, TRK_OK)
void support_status(const trk_context *context, trk_status got, trk_status wanted, const char *what,
                    const char *file, int line);

/* Fails unless the context's last message contains the text. */
#define assert_message(context, text) support_message((context), (text), __FILE__, __LINE__)
void support_message(const trk_context *context, const char *text, const char *file, int line);

#endif
