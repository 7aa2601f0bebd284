/* SPDX-License-Identifier: MIT */
/* IRI, MRI and HRI of profiles, Sayers' algorithm (ROUGHNESS.3, ROUGHNESS.4). */
#include "roughness/golden.h"

#include <math.h>
#include <truckride/roughness.h>

static const trk_iri_options defaults = {
    .struct_size = sizeof(trk_iri_options),
    .start_length = 11,
    .smoothed = 0,
    .reserved = 0,
};

void trk_iri_options_init(trk_iri_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

/* What is known of a profile once its arguments are checked. */
typedef struct plan {
    int64_t base;   /* samples of the moving average        */
    int64_t lead;   /* heights under the start length       */
    int64_t slopes; /* count - base                         */
} plan;

static trk_status make_plan(trk_context *context, const char *what, int64_t count, double spacing,
                            const trk_iri_options *options, plan *out)
{
    trk_iri_options o = defaults;
    trk_status status = trk_read_options(context, what, options, &o, sizeof o);
    if (status != TRK_OK)
        return status;
    if (!(spacing > 0 && spacing <= TRK_IRI_SPACING_MAXIMUM))
        return trk_fail(context, TRK_E_RANGE, "%s: spacing is %g m, expected > 0, at most %g m",
                        what, spacing, TRK_IRI_SPACING_MAXIMUM);
    if (!(o.start_length > 0 && isfinite(o.start_length)))
        return trk_fail(context, TRK_E_RANGE, "%s: start_length is %g m, expected > 0 and finite",
                        what, o.start_length);
    if ((o.smoothed != 0 && o.smoothed != 1) || o.reserved != 0)
        return trk_fail(context, TRK_E_RANGE,
                        "%s: smoothed is %d, reserved is %d, expected 0 or 1, and 0", what,
                        (int)o.smoothed, (int)o.reserved);
    double base = o.smoothed ? 1 : fmax(floor(0.25 / spacing + 0.5), 1);
    double lead = floor(o.start_length / spacing + 0.5) + 1;
    if (count < 2 || (double)count <= base)
        return trk_fail(context, TRK_E_RANGE, "%s: count is %lld heights, expected more than %.0f",
                        what, (long long)count, base);
    out->base = (int64_t)base;
    out->lead = lead < (double)count ? (int64_t)lead : count;
    out->slopes = count - out->base;
    return TRK_OK;
}

static trk_status check_heights(trk_context *context, const char *what, const char *name,
                                int64_t count, const double *height)
{
    for (int64_t i = 0; i < count; i++)
        if (!(fabs(height[i]) <= 1e75))
            return trk_fail(context, TRK_E_RANGE, "%s: %s[%lld] is %g m, expected at most 1e75",
                            what, name, (long long)i, height[i]);
    return TRK_OK;
}

/* The car on a profile: its state, and where it is. */
typedef struct car {
    trk_golden_step step;
    double x[4];
    int64_t place;
} car;

static void start(const plan *p, const double *height, double spacing, car *out)
{
    trk_golden_create(spacing, &out->step);
    double slope = (height[p->lead - 1] - height[0]) / (spacing * (double)p->lead);
    out->x[0] = out->x[2] = slope;
    out->x[1] = out->x[3] = 0;
    out->place = 0;
}

/* Mean magnitude of the slope between the masses over the next samples. */
static double drive(car *c, const plan *p, const double *height, double spacing, int64_t samples)
{
    double sum = 0, base = spacing * (double)p->base;
    for (int64_t k = 0; k < samples; k++, c->place++) {
        double slope = (height[c->place + p->base] - height[c->place]) / base, next[4];
        for (int i = 0; i < 4; i++) {
            const double *row = c->step.transition[i];
            next[i] = row[0] * c->x[0] + row[1] * c->x[1] + row[2] * c->x[2] + row[3] * c->x[3] +
                      c->step.input[i] * slope;
        }
        for (int i = 0; i < 4; i++)
            c->x[i] = next[i];
        sum += fabs(next[2] - next[0]);
    }
    return sum / (double)samples;
}

trk_status trk_iri(trk_context *context, int64_t count, const double *height, double spacing,
                   const trk_iri_options *options, double *out_iri)
{
    static const char what[] = "trk_iri";
    TRK_REQUIRE(context, context, "trk_iri");
    TRK_REQUIRE(context, height, "trk_iri");
    TRK_REQUIRE(context, out_iri, "trk_iri");
    plan p;
    trk_status status = make_plan(context, what, count, spacing, options, &p);
    if (status == TRK_OK)
        status = check_heights(context, what, "height", count, height);
    if (status != TRK_OK)
        return status;
    car c;
    start(&p, height, spacing, &c);
    *out_iri = drive(&c, &p, height, spacing, p.slopes);
    return TRK_OK;
}

static int64_t samples_of(double segment_length, double spacing)
{
    double samples = rint(segment_length / spacing);
    return samples >= 1 && samples <= 1e15 ? (int64_t)samples : 0;
}

int64_t trk_iri_segment_count(int64_t count, double spacing, const trk_iri_options *options,
                              double segment_length)
{
    plan p = {0};
    if (make_plan(NULL, "", count, spacing, options, &p) != TRK_OK)
        return 0;
    int64_t samples = samples_of(segment_length, spacing);
    return samples ? p.slopes / samples : 0;
}

trk_status trk_iri_segments(trk_context *context, int64_t count, const double *height,
                            double spacing, const trk_iri_options *options, double segment_length,
                            int64_t segments, double *out_iri)
{
    static const char what[] = "trk_iri_segments";
    TRK_REQUIRE(context, context, "trk_iri_segments");
    TRK_REQUIRE(context, height, "trk_iri_segments");
    TRK_REQUIRE(context, out_iri, "trk_iri_segments");
    plan p;
    trk_status status = make_plan(context, what, count, spacing, options, &p);
    if (status == TRK_OK)
        status = check_heights(context, what, "height", count, height);
    if (status != TRK_OK)
        return status;
    int64_t samples = samples_of(segment_length, spacing);
    if (samples == 0)
        return trk_fail(context, TRK_E_RANGE,
                        "%s: segment_length is %g m, expected at least the spacing of %g m", what,
                        segment_length, spacing);
    if (segments < 0)
        return trk_fail(context, TRK_E_RANGE, "%s: segments is %lld, expected >= 0", what,
                        (long long)segments);
    int64_t whole = p.slopes / samples;
    car c;
    start(&p, height, spacing, &c);
    for (int64_t k = 0; k < segments && k < whole; k++)
        out_iri[k] = drive(&c, &p, height, spacing, samples);
    return TRK_OK;
}

trk_status trk_mri(trk_context *context, int64_t count, const double *left, const double *right,
                   double spacing, const trk_iri_options *options, double *out_mri)
{
    TRK_REQUIRE(context, context, "trk_mri");
    TRK_REQUIRE(context, left, "trk_mri");
    TRK_REQUIRE(context, right, "trk_mri");
    TRK_REQUIRE(context, out_mri, "trk_mri");
    double iri[2];
    trk_status status = trk_iri(context, count, left, spacing, options, &iri[0]);
    if (status != TRK_OK)
        return trk_fail_within(context, status, "trk_mri: left track");
    status = trk_iri(context, count, right, spacing, options, &iri[1]);
    if (status != TRK_OK)
        return trk_fail_within(context, status, "trk_mri: right track");
    *out_mri = (iri[0] + iri[1]) / 2;
    return TRK_OK;
}

trk_status trk_hri(trk_context *context, int64_t count, const double *left, const double *right,
                   double spacing, const trk_iri_options *options, double *out_hri)
{
    static const char what[] = "trk_hri";
    TRK_REQUIRE(context, context, "trk_hri");
    TRK_REQUIRE(context, left, "trk_hri");
    TRK_REQUIRE(context, right, "trk_hri");
    TRK_REQUIRE(context, out_hri, "trk_hri");
    plan p;
    trk_status status = make_plan(context, what, count, spacing, options, &p);
    if (status == TRK_OK)
        status = check_heights(context, what, "left", count, left);
    if (status == TRK_OK)
        status = check_heights(context, what, "right", count, right);
    if (status != TRK_OK)
        return status;
    double *mean = trk_new(context, count, sizeof *mean);
    if (!mean)
        return TRK_E_MEMORY;
    for (int64_t i = 0; i < count; i++)
        mean[i] = (left[i] + right[i]) / 2;
    status = trk_iri(context, count, mean, spacing, options, out_hri);
    trk_free(context, mean);
    return status;
}
