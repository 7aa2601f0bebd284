/* SPDX-License-Identifier: MIT */
/* A law along a path: to look at a hysteresis loop. */
#include "law/law.h"

#include <math.h>

/* A way from point to point is cut into so many pieces, for memory driven by time and for corners. */
enum { PIECES = 32 };

/* Where the law is: memory, elongation, work done on it. */
typedef struct tracer {
    const trk_law *law;
    double z[TRK_LAW_STATES], e, work;
} tracer;

static double force_at(const tracer *t, double e, double v, double h, double *z_next)
{
    trk_law_point point;
    t->law->ops->evaluate(t->law, t->z, e, v, h, &point, z_next);
    return point.force;
}

/* On to e in the time h; the work by Simpson's rule. Returns the force there. */
static double advance(tracer *t, double e, double h)
{
    double next[TRK_LAW_STATES] = {0}, v = (e - t->e) / h, middle = t->e + (e - t->e) / 2;
    double first = force_at(t, t->e, v, 0, next);
    double second = force_at(t, middle, v, h / 2, next);
    double third = force_at(t, e, v, h, next);
    t->work += (e - t->e) * (first + 4 * second + third) / 6;
    for (int k = 0; k < TRK_LAW_STATES; k++)
        t->z[k] = next[k];
    t->e = e;
    return third;
}

static trk_status check(trk_context *context, const trk_law *law, int64_t count, double step,
                        const double *e)
{
    if (count < 1)
        return trk_fail(context, TRK_E_ARGUMENT,
                        "trk_law_trace: count is %lld; at least 1 is needed", (long long)count);
    if (!(isfinite(step) && step > 0))
        return trk_fail(context, TRK_E_RANGE,
                        "trk_law_trace of '%s': step is %g; a finite number > 0 is needed",
                        law->name, step);
    for (int64_t k = 0; k < count; k++)
        if (!isfinite(e[k]))
            return trk_fail(
                context, TRK_E_RANGE,
                "trk_law_trace of '%s': e of point %lld is %g; a finite number is needed",
                law->name, (long long)k + 1, e[k]);
    return TRK_OK;
}

trk_status trk_law_trace(trk_context *context, const trk_law *law, int64_t count, double step,
                         const double *e, double *out_force, double *out_lost)
{
    TRK_REQUIRE(context, context, "trk_law_trace");
    TRK_REQUIRE(context, law, "trk_law_trace");
    TRK_REQUIRE(context, e, "trk_law_trace");
    TRK_REQUIRE(context, out_force, "trk_law_trace");
    trk_status status = check(context, law, count, step, e);
    if (status)
        return status;
    tracer t = {.law = law, .e = e[0]};
    double next[TRK_LAW_STATES];
    law->ops->relax(law, e[0], t.z);
    double start = law->ops->stored(law, t.z, e[0]);
    for (int64_t k = 0; k < count; k++) {
        out_force[k] = k ? 0 : force_at(&t, e[0], 0, 0, next);
        for (int piece = 1; k && piece <= PIECES; piece++)
            out_force[k] =
                advance(&t, e[k - 1] + (e[k] - e[k - 1]) * piece / PIECES, step / PIECES);
        if (!isfinite(out_force[k]))
            return trk_fail(context, TRK_E_RANGE,
                            "trk_law_trace: the %s '%s' has no force at point %lld, e = %g",
                            law->ops->word, law->name, (long long)k + 1, e[k]);
        if (out_lost)
            out_lost[k] = t.work - (law->ops->stored(law, t.z, e[k]) - start);
        if (out_lost && !isfinite(out_lost[k]))
            return trk_fail(context, TRK_E_RANGE,
                            "trk_law_trace: the energy of the %s '%s' overflows at point %lld, "
                            "e = %g",
                            law->ops->word, law->name, (long long)k + 1, e[k]);
    }
    return TRK_OK;
}
