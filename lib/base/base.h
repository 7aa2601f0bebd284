/* SPDX-License-Identifier: MIT */
/* Private side of truckride/base.h: memory, messages and options for all rooms. */
#ifndef TRK_BASE_BASE_H
#define TRK_BASE_BASE_H

#include <stdarg.h>
#include <stdbool.h>
#include <truckride/base.h>

#if defined(__GNUC__)
#define TRK_PRINTF(text, first) __attribute__((format(printf, text, first)))
#else
#define TRK_PRINTF(text, first)
#endif

/*
 * Record a failure and return its status, so that a caller can write
 *     return trk_fail(context, TRK_E_RANGE, "damper '%s': ...", name);
 * context may be NULL (nothing is recorded). Numbers are written with a decimal
 * point whatever the locale.
 */
trk_status trk_fail(trk_context *context, trk_status status, const char *format, ...)
    TRK_PRINTF(3, 4);

/* Put "text: " in front of the last message: a caller adds where it was. Returns status. */
trk_status trk_fail_within(trk_context *context, trk_status status, const char *format, ...)
    TRK_PRINTF(3, 4);

/* Hand a note to the context's log function, if any. */
void trk_note(trk_context *context, const char *format, ...) TRK_PRINTF(2, 3);

/*
 * Zeroed memory for count elements, aligned to 64 bytes (a cache line, a
 * 512-bit vector). NULL when it does not fit, with the message recorded:
 *     p = trk_new(context, n, sizeof *p);  if (!p) return TRK_E_MEMORY;
 * count 0 gives a valid block. Free with trk_free(), NULL allowed.
 */
void *trk_new(trk_context *context, int64_t count, size_t element_size);
void trk_free(trk_context *context, void *block);

/* Grow *block, keeping the contents, so that it holds at least count elements
 * (doubling). *capacity is updated. On failure the block stays as it was. */
trk_status trk_grow(trk_context *context, void **block, int64_t *capacity, int64_t count,
                    size_t element_size);

/* Copy of a string in the context's memory; NULL when out of memory. */
char *trk_copy_text(trk_context *context, const char *text);

/*
 * Read an options struct of the caller into `known`, which holds the defaults on
 * entry and has known_size bytes (this library's struct). options NULL keeps the
 * defaults. `what` names the struct in messages.
 */
trk_status trk_read_options(trk_context *context, const char *what, const void *options,
                            void *known, size_t known_size);

/* Copy defaults into the caller's struct of struct_size bytes: the init functions. */
void trk_write_defaults(void *options, size_t struct_size, const void *defaults, size_t known_size);

/* Copy a struct of this library to the caller's, whose struct_size is set: the get functions.
 * TRK_E_OPTIONS when it is not. */
trk_status trk_write_options(void *options, const void *known, size_t known_size);

/*
 * The C locale for this thread, for many numbers in a row: between the two calls
 * snprintf writes and strtod reads a decimal point whatever the caller's locale.
 */
typedef struct trk_locale {
    void *c_locale, *before; /* locale_t */
} trk_locale;
void trk_locale_enter(trk_locale *out_locale);
void trk_locale_leave(trk_locale *locale);

/* snprintf and vsnprintf that write a decimal point in every locale. */
int trk_format(char *out, size_t size, const char *format, ...) TRK_PRINTF(3, 4);
int trk_format_list(char *out, size_t size, const char *format, va_list arguments);

/* NULL pointer arguments end here: TRK_REQUIRE(context, x, "trk_curve_create"). */
#define TRK_REQUIRE(context, argument, function)                                                   \
    do {                                                                                           \
        if (!(argument))                                                                           \
            return trk_fail((context), TRK_E_ARGUMENT, function ": " #argument " is NULL");        \
    } while (0)

#endif
