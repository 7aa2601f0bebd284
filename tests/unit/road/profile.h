/* SPDX-License-Identifier: MIT */
/* Long stretches of road and their power in third octaves. */
#ifndef TRK_TESTS_ROAD_PROFILE_H
#define TRK_TESTS_ROAD_PROFILE_H

#include "support.h"

#include <stdbool.h>
#include <truckride/road.h>
#include <truckride/spectrum.h>

static const double pi = 3.14159265358979323846;

static inline trk_road_options road_options(void)
{
    trk_road_options o;
    trk_road_options_init(&o, sizeof o);
    return o;
}

static inline double *new_profile(int64_t count)
{
    double *profile = malloc((size_t)count * sizeof *profile);
    assert_non_null(profile);
    return profile;
}

/* Real and imaginary part of the cross spectrum of x and y and both spectra, each over the
 * density of the options, averaged over third octaves from low up. */
typedef struct third {
    double centre, x, y, re, im;
} third;

static inline int measure_thirds(trk_context *context, const trk_road_options *o, int64_t count,
                                 double spacing, int64_t segment, const double *x, const double *y,
                                 third *out, int room)
{
    trk_spectrum_options s;
    trk_spectrum_options_init(&s, sizeof s);
    s.segment_length = segment;
    const int64_t lines = trk_psd_length(&s, count);
    double *xx = new_profile(lines), *yy = new_profile(lines), *xy = new_profile(2 * lines);
    assert_ok(context, trk_psd(context, count, x, 1 / spacing, &s, xx));
    assert_ok(context, trk_psd(context, count, y, 1 / spacing, &s, yy));
    assert_ok(context, trk_csd(context, count, x, y, 1 / spacing, &s, xy));
    const double dn = 1 / (spacing * (double)segment), ratio = cbrt(2);
    int thirds = 0;
    for (double low = o->low; low * ratio < 1.1 * o->high && thirds < room; low *= ratio) {
        /* the last one takes what is left */
        const double high = low * ratio * ratio < 1.1 * o->high ? low * ratio : o->high;
        third t = {sqrt(low * high), 0, 0, 0, 0};
        double all = 0;
        for (int64_t k = 1; k < lines; k++) {
            const double n = (double)k * dn;
            const double part = fmin(high, n + dn / 2) - fmax(low, n - dn / 2);
            if (!(part > 0))
                continue;
            const double inside = fmin(fmax(n, o->low), o->high); /* half a line may stick out */
            double density;
            assert_ok(context, trk_road_density(context, o, 1, &inside, &density));
            t.x += part * xx[k] / density;
            t.y += part * yy[k] / density;
            t.re += part * xy[2 * k] / density;
            t.im += part * xy[2 * k + 1] / density;
            all += part;
        }
        out[thirds++] = (third){t.centre, t.x / all, t.y / all, t.re / all, t.im / all};
    }
    free(xx);
    free(yy);
    free(xy);
    return thirds;
}

#endif
