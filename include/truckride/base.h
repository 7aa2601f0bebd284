/* SPDX-License-Identifier: MIT */
/**
 * @file  truckride/base.h
 * @brief Visibility, status codes, contexts, options structs, version.
 *
 * Every other header includes this one.
 *
 * Conventions of the whole library
 *  - SI units; angles in rad; axes of ISO 8855: x forward, y left, z up; roll,
 *    pitch (nose down positive) and yaw about +x, +y, +z; small rotations.
 *  - Elongation and damper velocity are positive in extension.
 *  - Ids are int32_t starting at 1; 0 means none. In an array over all parts of a
 *    kind (link forces, road heights, sensor values) the entry of id k is [k - 1].
 *  - Ownership words: "borrowed" (must outlive the borrower), "copied", "owned
 *    by caller" (destroy it), "owned by <object>" (lives as long as the object).
 *  - Functions on const objects never write a context and may be called from
 *    several threads at once. Everything else: one thread at a time per context.
 *  - The library never prints, exits, reads the environment, or uses the locale.
 */
#ifndef TRUCKRIDE_BASE_H
#define TRUCKRIDE_BASE_H

#include <stddef.h>
#include <stdint.h>

#if defined(TRUCKRIDE_STATIC)
#  define TRK_EXPORT
#elif defined(_WIN32)
#  if defined(TRUCKRIDE_BUILDING)
#    define TRK_EXPORT __declspec(dllexport)
#  else
#    define TRK_EXPORT __declspec(dllimport)
#  endif
#elif defined(__GNUC__)
#  define TRK_EXPORT __attribute__((visibility("default")))
#else
#  define TRK_EXPORT
#endif
#ifdef __cplusplus
#  define TRK_API extern "C" TRK_EXPORT
#else
#  define TRK_API extern TRK_EXPORT
#endif
#if defined(__GNUC__)
#  define TRK_MUST_CHECK __attribute__((warn_unused_result))
#else
#  define TRK_MUST_CHECK
#endif

/** Version of these headers; trk_version() is that of the running library. */
#define TRK_VERSION_MAJOR 0
#define TRK_VERSION_MINOR 1
#define TRK_VERSION_PATCH 0

/** Result of every call that can fail. Values never change and are never reused. */
typedef int32_t trk_status;

/** Every status, its number and its text, as X(name, number, text). */
#define TRK_STATUS_LIST(X)                                                                  \
    X(TRK_OK,             0, "success")                                                     \
    X(TRK_E_ARGUMENT,     1, "invalid argument")                                            \
    X(TRK_E_MEMORY,       2, "out of memory")                                               \
    X(TRK_E_OPTIONS,      3, "options struct has a size or field this library does not know") \
    X(TRK_E_RANGE,        4, "value out of range")                                          \
    X(TRK_E_NAME,         5, "name is empty, unknown or already used")                      \
    X(TRK_E_UNSUPPORTED,  6, "this build of the library does not support the request")      \
    X(TRK_E_CANCELLED,    7, "cancelled by the caller")                                     \
    X(TRK_E_FILE,         8, "file cannot be read or written")                              \
    X(TRK_E_SYNTAX,      10, "input text is malformed")                                     \
    X(TRK_E_MODEL,       11, "model is incomplete or inconsistent")                         \
    X(TRK_E_SINGULAR,    20, "matrix is not positive definite")                             \
    X(TRK_E_CONVERGENCE, 21, "iteration did not converge")                                  \
    X(TRK_E_LIMIT,       22, "a limit of evaluations or time came before the answer")       \
    X(TRK_E_TARGET,      23, "a target cannot be reached")                                  \
    X(TRK_E_IDENTIFY,    24, "a parameter cannot be found from the targets")                \
    X(TRK_E_INTERNAL,    30, "a numerical library failed unexpectedly")

#define TRK_STATUS_ENUM(name, value, text) name = value,
enum { TRK_STATUS_LIST(TRK_STATUS_ENUM) TRK_STATUS_END_ /**< not a status */ };
#undef TRK_STATUS_ENUM

/** Static text of a status; never NULL, also for values this library does not know. */
TRK_API const char *trk_status_text(trk_status status);

/** Version of the running library as MAJOR * 10000 + MINOR * 100 + PATCH. */
TRK_API int32_t trk_version(void);

/** Version of the running library as text, "0.1.0"; static storage. */
TRK_API const char *trk_version_text(void);

/** Parts of the library that a build may leave out. */
typedef int32_t trk_feature;
enum {
    TRK_FEATURE_CHOLMOD = 1, /**< sparse solver              */
    TRK_FEATURE_LAPACK  = 2, /**< modes, frequency response  */
    TRK_FEATURE_NLOPT   = 3, /**< calibration                */
    TRK_FEATURE_JSON    = 4, /**< model files are read       */
    TRK_FEATURE_ARPACK  = 5  /**< modes of large models      */
};

/** 1 if this build has the feature, else 0. */
TRK_API int32_t trk_has_feature(trk_feature feature);

/** Linear solver behind an assembled system. */
typedef int32_t trk_backend;
enum {
    TRK_BACKEND_AUTO   = 0, /**< dense for few coordinates, else sparse       */
    TRK_BACKEND_DENSE  = 1, /**< dense Cholesky                               */
    TRK_BACKEND_SPARSE = 2  /**< CHOLMOD, simplicial, needs TRK_FEATURE_CHOLMOD */
};

/**
 * Memory, log and last message of one thread.
 *
 * Every object is created in a context and must be destroyed before it.
 */
typedef struct trk_context trk_context;

/**
 * The one allocation function of a context, in the manner of Lua.
 *
 * block NULL asks for new memory; new_size 0 frees block and returns NULL;
 * otherwise block is resized. old_size is the size given when the block was
 * obtained. Must return memory aligned as malloc does, or NULL.
 */
typedef void *(*trk_allocate)(void *user, void *block, size_t old_size, size_t new_size);

/** Receives messages that are not errors, e.g. "curve is not monotone". */
typedef void (*trk_log)(void *user, const char *message);

/**
 * Progress of long work, called now and then from the calling thread.
 * @param fraction [-] 0 to 1
 * @return 0 to go on, anything else to cancel (the work returns TRK_E_CANCELLED)
 */
typedef int32_t (*trk_progress)(void *user, double fraction);

/**
 * Create a context.
 *
 * @param allocate    NULL for malloc, realloc and free
 * @param user        handed to allocate; borrowed
 * @param out_context receives the context, owned by caller; NULL on failure
 * @retval TRK_E_ARGUMENT out_context is NULL
 * @retval TRK_E_MEMORY   allocate returned NULL
 */
TRK_API trk_status trk_context_create(trk_allocate allocate, void *user,
                                      trk_context **out_context) TRK_MUST_CHECK;

/** Free a context. All objects created in it must be gone. NULL is allowed. */
TRK_API void trk_context_destroy(trk_context *context);

/** Receive notes; log NULL switches them off (the default). user is borrowed. */
TRK_API void trk_context_set_log(trk_context *context, trk_log log, void *user);

/**
 * Sentence about the last failure in this context: where, what, which value,
 * what was expected. "" if nothing failed yet. Owned by the context, valid
 * until the next call that fails in it. Functions on const objects, and all on NULL,
 * return a status and leave the message as it is: for those there is trk_status_text().
 */
TRK_API const char *trk_context_message(const trk_context *context);

/** Number of blocks currently allocated by objects of this context (0: nothing leaked). */
TRK_API int64_t trk_context_blocks(const trk_context *context);

/*
 * Options structs
 *
 * struct_size comes first and is set by the struct's init function, called as
 * trk_X_options_init(&o, sizeof o), or (p, sizeof *p) through a pointer. Fields are
 * appended, never moved. Where a parameter says "NULL for ...", NULL means the defaults;
 * parts of a spec and targets need their options. A struct from a newer header is
 * accepted if every field unknown to this library is zero.
 */

#endif
