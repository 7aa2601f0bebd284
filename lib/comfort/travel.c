/* SPDX-License-Identifier: MIT */
/* Travel of a suspension and its percentiles (COMFORT.13). */
#include "comfort/check.h"
#include "comfort/sum.h"

#include <math.h>
#include <string.h>
#include <truckride/comfort.h>

static void sift_down(double *x, int64_t root, int64_t count)
{
    double value = x[root];
    for (int64_t child = 2 * root + 1; child < count; child = 2 * root + 1) {
        if (child + 1 < count && x[child + 1] > x[child])
            child++;
        if (!(x[child] > value))
            break;
        x[root] = x[child];
        root = child;
    }
    x[root] = value;
}

/* Heapsort: qsort of the C library may take memory that is not the context's. */
static void sort(double *x, int64_t count)
{
    for (int64_t root = count / 2; root-- > 0;)
        sift_down(x, root, count);
    for (int64_t last = count - 1; last > 0; last--) {
        double largest = x[0];
        x[0] = x[last];
        x[last] = largest;
        sift_down(x, 0, last);
    }
}

static double interpolate(const double *sorted, int64_t count, double percent)
{
    double place = percent / 100 * (double)(count - 1);
    int64_t below = (int64_t)floor(place);
    if (below >= count - 1)
        return sorted[count - 1];
    return sorted[below] + (place - (double)below) * (sorted[below + 1] - sorted[below]);
}

static trk_travel_numbers measure(int64_t count, const double *x)
{
    trk_travel_numbers n = {.struct_size = sizeof n, .minimum = x[0], .maximum = x[0]};
    trk_sum sum = {0, 0}, square = {0, 0};
    for (int64_t i = 0; i < count; i++) {
        trk_sum_add(&sum, x[i]);
        n.minimum = fmin(n.minimum, x[i]);
        n.maximum = fmax(n.maximum, x[i]);
    }
    n.mean = trk_sum_value(&sum) / (double)count;
    for (int64_t i = 0; i < count; i++)
        trk_sum_add(&square, (x[i] - n.mean) * (x[i] - n.mean));
    n.rms = sqrt(trk_sum_value(&square) / (double)count);
    n.peak_to_peak = n.maximum - n.minimum;
    return n;
}

static trk_status check_percent(trk_context *context, const char *what, int32_t percentiles,
                                const double *percent, const double *out_travel)
{
    if (percentiles < 0)
        return trk_fail(context, TRK_E_RANGE, "%s: percentiles is %d, expected >= 0", what,
                        (int)percentiles);
    if (percentiles == 0)
        return TRK_OK;
    TRK_REQUIRE(context, percent, "trk_travel_measure");
    TRK_REQUIRE(context, out_travel, "trk_travel_measure");
    for (int32_t k = 0; k < percentiles; k++)
        if (!(percent[k] >= 0 && percent[k] <= 100))
            return trk_fail(context, TRK_E_RANGE, "%s: percent[%d] is %g, expected 0 to 100", what,
                            (int)k, percent[k]);
    return TRK_OK;
}

trk_status trk_travel_measure(trk_context *context, int64_t count, const double *travel,
                              trk_travel_numbers *out_numbers, int32_t percentiles,
                              const double *percent, double *out_travel)
{
    static const char what[] = "trk_travel_measure";
    TRK_REQUIRE(context, context, "trk_travel_measure");
    TRK_REQUIRE(context, travel, "trk_travel_measure");
    trk_status status = TRK_OK;
    if (out_numbers)
        status = trk_comfort_check_result(context, what, out_numbers);
    if (status == TRK_OK)
        status = check_percent(context, what, percentiles, percent, out_travel);
    if (status == TRK_OK)
        status = trk_comfort_check_samples(context, what, "travel", 1, count, travel);
    if (status != TRK_OK)
        return status;
    if (percentiles > 0) {
        double *sorted = trk_new(context, count, sizeof *sorted);
        if (!sorted)
            return TRK_E_MEMORY;
        memcpy(sorted, travel, (size_t)count * sizeof *sorted);
        sort(sorted, count);
        for (int32_t k = 0; k < percentiles; k++)
            out_travel[k] = interpolate(sorted, count, percent[k]);
        trk_free(context, sorted);
    }
    if (!out_numbers)
        return TRK_OK;
    trk_travel_numbers n = measure(count, travel);
    return trk_write_options(out_numbers, &n, sizeof n);
}
