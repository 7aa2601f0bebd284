/* SPDX-License-Identifier: MIT */
/* A law around closed cycles, and the average over cycles of all sizes (LINEAR.33, LINEAR.34). */
#include "linear/cycle.h"

#include "linear/kronrod.h"

#include <math.h>
#include <string.h>

static const double half_pi = 1.57079632679489661923;

/*
 * An arc is halved until its two rules agree: to 1e-10 of the largest force for laws without
 * memory. A law with memory goes from point to point, no farther than 1/256 of a cycle if time
 * drives its memory; the motion behind it is a model (LINEAR.33), so 1e-7 will do.
 */
enum { MEMORYLESS_ARCS = 4, MEMORY_ARCS = 16, MOST_HALVINGS = 18, MOST_ROUNDS = 12 };
static const double memoryless_tolerance = 1e-10, memory_tolerance = 1e-7, period_tolerance = 1e-8;

/* Beyond this many standard deviations lies 1e-13 of the fourth moment. */
static const double farthest = 8.5, least_reach = 4;
enum { PANELS = 4, MOST_PANEL_HALVINGS = 10 };
static const double memoryless_panel_tolerance = 1e-9, memory_panel_tolerance = 1e-6;

typedef struct cycle {
    const trk_law *law;
    trk_swing swing;
    double rest, largest, tolerance; /* largest: of |f - rest| so far */
    double z[TRK_LAW_STATES], force; /* memory and f - rest, where the last arc ended */
    trk_integrals sum;
} cycle;

/* f - rest at an angle, from the memory at another; the memory moves along. */
static double move(cycle *c, double *z, double from, double to)
{
    const trk_swing *s = &c->swing;
    double next[TRK_LAW_STATES];
    trk_law_point point;
    c->law->ops->evaluate(c->law, z, s->mean + s->e_size * cos(to), -s->v_size * sin(to),
                          (to - from) * s->e_size / s->v_size, &point, next);
    memcpy(z, next, sizeof(double) * (size_t)c->law->ops->states);
    return point.force - c->rest;
}

/* Add the integrals over an arc; leaves the memory at its end. */
static void add_arc(cycle *c, double from, double to, int halvings)
{
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double z[TRK_LAW_STATES], gauss[3] = {0}, kronrod[3] = {0}, place = from;
    memcpy(z, c->z, sizeof z);
    for (int k = 0; k < TRK_KRONROD; k++) {
        const trk_kronrod_point *p = &trk_kronrod[k];
        const double angle = middle + half * p->place, f = move(c, z, place, angle);
        const double part[3] = {f, f * cos(angle), -f * sin(angle)};
        for (int i = 0; i < 3; i++) {
            kronrod[i] += half * p->weight * part[i];
            gauss[i] += half * p->gauss * part[i];
        }
        c->largest = fmax(c->largest, fabs(f));
        place = angle;
    }
    double error = 0;
    for (int i = 0; i < 3; i++)
        error = fmax(error, fabs(kronrod[i] - gauss[i]));
    if (error > c->tolerance * c->largest && halvings > 0) {
        add_arc(c, from, middle, halvings - 1);
        add_arc(c, middle, to, halvings - 1);
        return;
    }
    c->force = move(c, z, place, to);
    memcpy(c->z, z, sizeof z);
    for (int i = 0; i < 3; i++)
        c->sum.of[i] += kronrod[i];
}

/* Once around from the top, where the motion turns. */
static void go_around(cycle *c)
{
    const int arcs = c->law->ops->states > 0 ? MEMORY_ARCS : MEMORYLESS_ARCS;
    c->sum = (trk_integrals){{0}, 0};
    for (int k = 0; k < arcs; k++)
        add_arc(c, 4 * half_pi * k / arcs, 4 * half_pi * (k + 1) / arcs, MOST_HALVINGS);
}

/* A fixed point of the cycle: go around, and jump to where a geometric approach would end. */
static void settle(cycle *c)
{
    double z[3][TRK_LAW_STATES], before = c->force;
    for (int round = 0; round < MOST_ROUNDS; round++) {
        for (int k = 0; k < 2; k++) {
            memcpy(z[k], c->z, sizeof c->z);
            go_around(c);
            if (fabs(c->force - before) <= period_tolerance * c->largest || isnan(c->force))
                return;
            before = c->force;
        }
        memcpy(z[2], c->z, sizeof c->z);
        for (int32_t i = 0; i < c->law->ops->states; i++) {
            const double last = z[2][i] - z[1][i], bend = last - (z[1][i] - z[0][i]);
            c->z[i] -= bend != 0 && fabs(last) <= 1e3 * fabs(bend) ? last * last / bend : 0;
        }
    }
}

bool trk_cycle_average(const trk_law *law, const trk_swing *swing, trk_parts *out)
{
    const bool remembers = law->ops->states > 0;
    cycle c = {.law = law,
               .swing = *swing,
               .tolerance = remembers ? memory_tolerance : memoryless_tolerance};
    trk_law_point rest;
    law->ops->rest(law, swing->mean, &rest);
    c.rest = rest.force;
    law->ops->relax(law, swing->mean, c.z);
    add_arc(&c, -half_pi, 0, 0); /* from rest to the top */
    if (remembers)
        settle(&c);
    else
        go_around(&c);
    const double share = 0.25 / half_pi;
    *out = (trk_parts){c.rest, share * c.sum.of[0], share * c.sum.of[1], share * c.sum.of[2]};
    return isfinite(out->force) && isfinite(out->in_phase) && isfinite(out->quadrature);
}

typedef struct crowd {
    const trk_law *law;
    const trk_swing *swing; /* of one standard deviation */
    double largest, tolerance, reach, rest;
    trk_integrals sum;
} crowd;

/* Cycles of amplitudes from .. to, each by its share of the Rayleigh distribution. */
static void add_panel(crowd *c, double from, double to, int halvings)
{
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    double gauss[3] = {0}, kronrod[3] = {0}, error = 0;
    for (int k = 0; k < TRK_KRONROD; k++) {
        const trk_kronrod_point *p = &trk_kronrod[k];
        const double size = middle + half * p->place, share = size * exp(-0.5 * size * size);
        const trk_swing swing = {c->swing->mean, size * c->swing->e_size, size * c->swing->v_size};
        trk_parts parts;
        if (!trk_cycle_average(c->law, &swing, &parts)) {
            c->reach = fmin(c->reach, size);
            continue;
        }
        c->rest = parts.rest;
        const double part[3] = {share * parts.force, share * size * parts.in_phase,
                                share * size * parts.quadrature};
        for (int i = 0; i < 3; i++) {
            kronrod[i] += half * p->weight * part[i];
            gauss[i] += half * p->gauss * part[i];
            c->largest = fmax(c->largest, fabs(part[i]));
        }
    }
    for (int i = 0; i < 3; i++)
        error = fmax(error, fabs(kronrod[i] - gauss[i]));
    if (error > c->tolerance * c->largest && halvings > 0) {
        add_panel(c, from, middle, halvings - 1);
        add_panel(c, middle, to, halvings - 1);
        return;
    }
    for (int i = 0; i < 3; i++)
        c->sum.of[i] += kronrod[i];
}

bool trk_cycle_expect(const trk_law *law, const trk_swing *swing, trk_parts *out)
{
    crowd c = {.law = law,
               .swing = swing,
               .reach = INFINITY,
               .tolerance =
                   law->ops->states > 0 ? memory_panel_tolerance : memoryless_panel_tolerance};
    for (int k = 0; k < PANELS; k++)
        add_panel(&c, farthest * k / PANELS, farthest * (k + 1) / PANELS, MOST_PANEL_HALVINGS);
    *out = (trk_parts){c.rest, c.sum.of[0], c.sum.of[1], c.sum.of[2]};
    return c.reach > least_reach;
}
