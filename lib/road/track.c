/* SPDX-License-Identifier: MIT */
/* A track: splines through the grids of all octaves, averaged over the contact, with its ramp. */
#include "road/road.h"
#include "signal/turn.h"

static const double pi = 3.14159265358979323846;

/* Polynomial of the spline from a grid point to the next; between 0 and 1 (ROAD.5). */
typedef struct cell {
    int64_t point;
    double c[6];
} cell;

/* Row k: polynomial by which the coefficient at point - 2 + k counts, times 120. */
static const double quintic[6][6] = {{1, -5, 10, -10, 5, -1},  {26, -50, 20, 20, -20, 5},
                                     {66, 0, -60, 0, 30, -10}, {26, 50, 20, -20, -20, 10},
                                     {1, 5, 10, 10, 5, -5},    {0, 0, 0, 0, 0, 1}};

static void move(trk_octave_reader *reader, int64_t point, cell *out)
{
    if (out->point == point)
        return;
    double c[6] = {0};
    for (int k = 0; k < 6; k++) {
        const double height = trk_octave_read(reader, point - 2 + k);
        for (int power = 0; power < 6; power++)
            c[power] += quintic[k][power] * height;
    }
    for (int power = 0; power < 6; power++)
        out->c[power] = c[power] * (1.0 / 120);
    out->point = point;
}

static double value_of(const cell *p, double t)
{
    return p->c[0] + t * (p->c[1] + t * (p->c[2] + t * (p->c[3] + t * (p->c[4] + t * p->c[5]))));
}

static double rate_of(const cell *p, double t)
{
    return p->c[1] + t * (2 * p->c[2] + t * (3 * p->c[3] + t * (4 * p->c[4] + t * (5 * p->c[5]))));
}

/* Integral from 0 to t. */
static double area_of(const cell *p, double t)
{
    static const double third = 1.0 / 3, fifth = 1.0 / 5, sixth = 1.0 / 6;
    return t * (p->c[0] +
                t * (0.5 * p->c[1] +
                     t * (third * p->c[2] +
                          t * (0.25 * p->c[3] + t * (fifth * p->c[4] + t * (sixth * p->c[5]))))));
}

/* floor() without a call, for numbers of grid points that a double resolves. */
static inline int64_t whole_of(double s)
{
    const int64_t k = (int64_t)s;
    return k - ((double)k > s);
}

static void add_points(const trk_track *track, int32_t octave, int64_t count, const double *x,
                       double *value, double *rate)
{
    const double per_metre = track->octaves[octave].per_metre;
    const double origin = track->octaves[octave].origin;
    trk_octave_reader reader;
    trk_octave_reader_start(&reader, track, octave);
    cell here = {INT64_MIN, {0}};
    for (int64_t k = 0; k < count; k++) {
        const double s = x[k] * per_metre + origin;
        if (!(fabs(x[k]) < track->farthest)) {
            value[k] += x[k] * 0.0; /* NaN if x is not finite */
            rate[k] += x[k] * 0.0;
            continue;
        }
        const int64_t point = whole_of(s);
        const double t = s - (double)point;
        move(&reader, point, &here);
        value[k] += value_of(&here, t);
        rate[k] += per_metre * rate_of(&here, t);
    }
}

/* The same for the mean over the contact length: integral and difference of the spline (ROAD.6). */
static void add_contacts(const trk_track *track, int32_t octave, int64_t count, const double *x,
                         double *value, double *rate)
{
    const double per_metre = track->octaves[octave].per_metre;
    const double origin = track->octaves[octave].origin;
    const double length = track->contact_length * per_metre;
    trk_octave_reader reader;
    trk_octave_reader_start(&reader, track, octave);
    cell tail = {INT64_MIN, {0}}, head = tail, between = tail;
    for (int64_t k = 0; k < count; k++) {
        const double s = x[k] * per_metre + origin;
        if (!(fabs(x[k]) < track->farthest)) {
            value[k] += x[k] * 0.0;
            rate[k] += x[k] * 0.0;
            continue;
        }
        /* Ends from the near grid point, so that short contacts far away keep their length. */
        const int64_t point = whole_of(s);
        const double from = s - (double)point - 0.5 * length, to = s - (double)point + 0.5 * length;
        const int64_t first = point + whole_of(from), last = point + whole_of(to);
        const double t = from - (double)(first - point), u = to - (double)(last - point);
        if (first == head.point)
            tail = head;
        move(&reader, first, &tail);
        move(&reader, last, &head);
        double area = area_of(&head, u) - area_of(&tail, t);
        if (first < last)
            area += area_of(&tail, 1);
        for (int64_t inner = first + 1; inner < last; inner++) {
            move(&reader, inner, &between);
            area += area_of(&between, 1);
        }
        value[k] += area / length;
        rate[k] += (value_of(&head, u) - value_of(&tail, t)) / track->contact_length;
    }
}

/* (ROAD.7) */
static void apply_ramp(const trk_track *track, int64_t count, const double *x, double *value,
                       double *rate)
{
    for (int64_t k = 0; k < count; k++) {
        double u = (x[k] - track->ramp_start) / track->ramp_length, sine, cosine;
        u = u < 0 ? 0 : u > 1 ? 1 : u; /* keeps NaN */
        trk_turn_sincos(0.25 * u, &sine, &cosine);
        const double share = u == 1 ? 1 : sine * sine;
        const double growth = pi / track->ramp_length * sine * cosine;
        rate[k] = share * rate[k] + growth * value[k];
        value[k] = share * value[k];
    }
}

static void evaluate(const trk_signal *signal, int64_t count, const double *x, double *value,
                     double *rate)
{
    const trk_track *track = (const trk_track *)signal;
    for (int64_t k = 0; k < count; k++)
        value[k] = rate[k] = 0;
    for (int32_t octave = 0; octave < track->octave_count; octave++)
        (track->contact_length > 0 ? add_contacts : add_points)(track, octave, count, x, value,
                                                                rate);
    if (track->ramp_length > 0)
        apply_ramp(track, count, x, value, rate);
}

static void destroy(trk_signal *signal)
{
    trk_free(signal->context, ((trk_track *)signal)->octaves);
}

const trk_signal_kind trk_track_kind = {evaluate, destroy};
