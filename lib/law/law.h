/* SPDX-License-Identifier: MIT */
/*
 * Inside of a law with parameters: what its kind can do. All pure functions of the law, its
 * committed memory z and the motion; nothing is written but the outputs.
 */
#ifndef TRK_LAW_LAW_H
#define TRK_LAW_LAW_H

#include "base/base.h"
#include <truckride/law.h>

/* Force and its tangents df/de, df/dv. */
typedef struct trk_law_point {
    double force, stiffness, damping;
} trk_law_point;

/* Memory of the law that remembers most, so that trial memory can live on the stack. */
enum { TRK_LAW_STATES = 2 };

typedef struct trk_law_ops {
    trk_law_kind kind;
    const char *word; /* in messages: "leaf spring" */
    int32_t states;   /* doubles of memory, at most TRK_LAW_STATES */
    /* Memory of a law that has been at rest at e for long: friction relaxed, pressures equal. */
    void (*relax)(const trk_law *law, double e, double *z);
    /*
     * Force at (e, v), reached in the time h from the committed memory z, its tangents, and the
     * memory then, z_next (states long, never NULL if states > 0). h = 0: memory driven by time
     * stands still, memory driven by motion moves along the path from z to e. No motion since
     * z: the tangent is that of sticking friction.
     */
    void (*evaluate)(const trk_law *law, const double *z, double e, double v, double h,
                     trk_law_point *out, double *z_next);
    /* Force of a law that has been at rest at e for long and its slope over e: for statics. With
     * z relaxed at e it is the force of evaluate, whose tangent is steeper where friction sticks. */
    void (*rest)(const trk_law *law, double e, trk_law_point *out);
    /* Energy [J] that the law can give back up to a constant, and power [W] that it turns to
     * heat: f v = d(stored)/dt + lost. z is the memory at e. */
    double (*stored)(const trk_law *law, const double *z, double e);
    double (*lost)(const trk_law *law, const double *z, double e, double v);
    /* Bound |df/de|, |df/dv| where they end: for statics that start where a law is slack. */
    void (*steepest)(const trk_law *law, double *out_stiffness, double *out_damping);
    trk_status (*copy)(trk_context *context, const trk_law *law, trk_law **out_law);
    void (*release)(trk_law *law); /* what a kind owns beside its struct; NULL: nothing */
} trk_law_ops;

/* Every kind has a struct of its own that begins with this one. */
struct trk_law {
    trk_context *context;
    const trk_law_ops *ops;
    char *name;
};

/*
 * What every create function begins with: *out_law = NULL, no pointer NULL, the caller's
 * options read into `known`, which holds the defaults.
 */
trk_status trk_law_begin(trk_context *context, const trk_law_ops *ops, const char *name,
                         const void *options, void *known, size_t known_size, trk_law **out_law);

/* And ends with: memory for the struct of the kind, its base filled in. */
trk_status trk_law_allocate(trk_context *context, const trk_law_ops *ops, const char *name,
                            size_t size, trk_law **out_law);

/* Range checks of a field. */
trk_status trk_law_check_positive(trk_context *context, const trk_law_ops *ops, const char *name,
                                  const char *field, double value);
trk_status trk_law_check_not_negative(trk_context *context, const trk_law_ops *ops,
                                      const char *name, const char *field, double value);

/* What every get function does. */
trk_status trk_law_read(const trk_law *law, trk_law_kind kind, const void *known, size_t known_size,
                        void *out_options);

#endif
