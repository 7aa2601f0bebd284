/* SPDX-License-Identifier: MIT */
/* Peaks of a PSD (SPECTRUM.9, SPECTRUM.10). */
#include "spectrum/settings.h"

#include <math.h>
#include <stdlib.h>

static const trk_peak_options defaults = {
    .struct_size = sizeof(trk_peak_options),
    .minimum_height = 0,
    .minimum_prominence = 0,
    .minimum_distance = 0,
    .order = TRK_PEAK_ORDER_HEIGHT,
};

typedef struct peak {
    int64_t bin;      /* middle of the plateau, rounded down */
    double frequency; /* [bins] interpolated                 */
    double height;
    double prominence;
    bool dropped;
} peak;

void trk_peak_options_init(trk_peak_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

static trk_status check_options(trk_context *context, const trk_peak_options *o)
{
    const struct {
        const char *name;
        double value;
    } field[] = {
        {"minimum_height", o->minimum_height},
        {"minimum_prominence", o->minimum_prominence},
        {"minimum_distance", o->minimum_distance},
    };
    for (size_t i = 0; i < sizeof field / sizeof *field; i++)
        if (!(field[i].value >= 0 && isfinite(field[i].value)))
            return trk_fail(context, TRK_E_RANGE,
                            "trk_psd_peaks: %s is %g, expected >= 0 and finite", field[i].name,
                            field[i].value);
    if (o->order != TRK_PEAK_ORDER_HEIGHT && o->order != TRK_PEAK_ORDER_FREQUENCY)
        return trk_fail(context, TRK_E_ARGUMENT, "trk_psd_peaks: order is %d, expected 0 or 1",
                        (int)o->order);
    if (o->reserved)
        return trk_fail(context, TRK_E_ARGUMENT, "trk_psd_peaks: reserved is %d, expected 0",
                        (int)o->reserved);
    return TRK_OK;
}

/* Vertex of the parabola through the logarithms at k - 1, k, k + 1 [bins] (SPECTRUM.10). */
static double vertex(const double *density, int64_t k)
{
    const double left = density[k - 1] / density[k], right = density[k + 1] / density[k];
    if (left == 0 || right == 0)
        return (double)k;
    const double before = log(left), after = log(right);
    return (double)k + 0.5 * (before - after) / (before + after);
}

/* The next plateau at or after *from with lower neighbours on both sides; false at the end. */
static bool next_maximum(int64_t length, const double *density, int64_t *from, peak *out)
{
    for (int64_t k = *from; k + 1 < length; k++) {
        if (density[k] <= density[k - 1])
            continue;
        int64_t last = k;
        while (last + 1 < length && density[last + 1] == density[k])
            last++;
        if (last + 1 < length && density[last + 1] < density[k]) {
            *out = (peak){.bin = (k + last) / 2, .height = density[k]};
            out->frequency = last > k ? 0.5 * (double)(k + last) : vertex(density, k);
            *from = last + 1;
            return true;
        }
        k = last;
    }
    return false;
}

/* Lowest density from bin towards one side, up to the first higher one or the end. */
static double base(int64_t length, const double *density, int64_t bin, int64_t direction)
{
    double lowest = density[bin];
    for (int64_t k = bin; k >= 0 && k < length && density[k] <= density[bin]; k += direction)
        lowest = fmin(lowest, density[k]);
    return lowest;
}

static int by_height(const void *left, const void *right)
{
    const peak *a = left, *b = right;
    if (a->height != b->height)
        return a->height > b->height ? -1 : 1;
    return (a->bin > b->bin) - (a->bin < b->bin);
}

static int by_height_indirect(const void *left, const void *right)
{
    return by_height(*(const peak *const *)left, *(const peak *const *)right);
}

static int by_frequency(const void *left, const void *right)
{
    const peak *a = left, *b = right;
    return (a->bin > b->bin) - (a->bin < b->bin);
}

/* Starting from the highest peak, drop all lower ones less than `distance` bins away. */
static trk_status drop_close(trk_context *context, int64_t count, peak *found, double distance)
{
    peak **ranked = trk_new(context, count, sizeof *ranked);
    if (!ranked)
        return TRK_E_MEMORY;
    for (int64_t i = 0; i < count; i++)
        ranked[i] = &found[i];
    qsort(ranked, (size_t)count, sizeof *ranked, by_height_indirect);
    for (int64_t i = 0; i < count; i++) {
        const peak *high = ranked[i];
        if (high->dropped)
            continue;
        for (peak *p = ranked[i]; p-- > found && (double)(high->bin - p->bin) < distance;)
            p->dropped = true;
        for (peak *p = ranked[i]; ++p < found + count && (double)(p->bin - high->bin) < distance;)
            p->dropped = true;
    }
    trk_free(context, ranked);
    return TRK_OK;
}

/* All peaks of at least the minimum height; *out_found has room for every maximum. */
static int64_t find_maxima(int64_t length, const double *density, double minimum_height,
                           peak *out_found)
{
    int64_t count = 0, from = 1;
    while (next_maximum(length, density, &from, &out_found[count]))
        count += out_found[count].height >= minimum_height;
    return count;
}

/* The peaks that are not dropped and prominent enough, moved to the front. */
static int64_t keep_prominent(int64_t length, const double *density, double minimum_prominence,
                              int64_t count, peak *found)
{
    int64_t kept = 0;
    for (int64_t i = 0; i < count; i++) {
        peak p = found[i];
        p.prominence =
            p.height - fmax(base(length, density, p.bin, -1), base(length, density, p.bin, 1));
        if (!p.dropped && p.prominence >= minimum_prominence)
            found[kept++] = p;
    }
    return kept;
}

trk_status trk_psd_peaks(trk_context *context, int64_t length, const double *density,
                         double frequency_step, const trk_peak_options *options, int64_t capacity,
                         double *out_frequency, double *out_height, double *out_prominence,
                         int64_t *out_count)
{
    static const char what[] = "trk_psd_peaks";
    TRK_REQUIRE(context, context, "trk_psd_peaks");
    TRK_REQUIRE(context, density, "trk_psd_peaks");
    TRK_REQUIRE(context, out_count, "trk_psd_peaks");
    *out_count = 0;
    trk_peak_options o = defaults;
    trk_status status = trk_read_options(context, what, options, &o, sizeof o);
    if (status == TRK_OK)
        status = check_options(context, &o);
    if (status == TRK_OK)
        status = trk_check_density(context, what, length, density);
    if (status == TRK_OK)
        status = trk_check_rate(context, what, "frequency_step", frequency_step);
    if (status == TRK_OK && capacity < 0)
        status = trk_fail(context, TRK_E_RANGE, "%s: capacity is %lld, expected >= 0", what,
                          (long long)capacity);
    if (status != TRK_OK)
        return status;

    peak *found = trk_new(context, length / 2 + 1, sizeof *found);
    if (!found)
        return TRK_E_MEMORY;
    int64_t count = find_maxima(length, density, o.minimum_height, found);
    /* A distance of a whole number of bins must not grow by the rounding of the quotient. */
    const double distance = ceil(o.minimum_distance / frequency_step * (1 - 1e-12));
    if (distance > 1)
        status = drop_close(context, count, found, distance);
    if (status == TRK_OK) {
        count = keep_prominent(length, density, o.minimum_prominence, count, found);
        qsort(found, (size_t)count, sizeof *found,
              o.order == TRK_PEAK_ORDER_HEIGHT ? by_height : by_frequency);
        for (int64_t i = 0; i < count && i < capacity; i++) {
            if (out_frequency)
                out_frequency[i] = found[i].frequency * frequency_step;
            if (out_height)
                out_height[i] = found[i].height;
            if (out_prominence)
                out_prominence[i] = found[i].prominence;
        }
        *out_count = count;
    }
    trk_free(context, found);
    return status;
}
