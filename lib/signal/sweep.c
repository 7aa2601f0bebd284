/* SPDX-License-Identifier: MIT */
/* Logarithmic sine sweep (SIGNAL.3). */
#include "signal/signal.h"
#include "signal/turn.h"

static const double pi = 3.14159265358979323846;

enum { PANELS_PER_E_FOLD = 16, LARGEST_EXPONENT = 10 };

/* (e^u - 1) / u for |u| <= 1 / (2 PANELS_PER_E_FOLD); the next term is below 3e-18. */
static inline double exponential_ratio(double u)
{
    return 1.0 +
           u * (1.0 / 2 +
                u * (1.0 / 6 + u * (1.0 / 24 +
                                    u * (1.0 / 120 +
                                         u * (1.0 / 720 + u * (1.0 / 5040 + u * (1.0 / 40320)))))));
}

/*
 * Phase, amplitude and frequency come from the panel's centre by short series
 * (SIGNAL.3b), so that the phase is as exact after thousands of turns as in the first.
 */
static void evaluate(const trk_signal *signal, int64_t count, const double *x, double *value,
                     double *rate)
{
    const trk_sweep *p = &signal->sweep;
    const double start = p->start, last = p->duration, decay = p->amplitude_exponent * p->growth;
    double turns[TRK_SIGNAL_BLOCK], amplitude[TRK_SIGNAL_BLOCK], frequency[TRK_SIGNAL_BLOCK];
    for (int64_t k = 0; k < count; k++) {
        double t = x[k] - start;
        t = t < 0.0 ? 0.0 : t > last ? last : t; /* keeps NaN */
        int32_t i = t < last ? (int32_t)(t * p->panels_per_unit) : p->panel_count;
        const trk_sweep_panel *panel = &p->panels[i < p->panel_count ? i : p->panel_count - 1];
        double from_centre = t - panel->centre, u = p->growth * from_centre;
        double v = -p->amplitude_exponent * u, ratio = exponential_ratio(u);
        turns[k] = panel->turns + panel->frequency * from_centre * ratio;
        frequency[k] = panel->frequency * (1.0 + u * ratio);
        amplitude[k] = panel->amplitude * (1.0 + v * exponential_ratio(v));
    }
    for (int64_t k = 0; k < count; k++) {
        double t = x[k] - start, sine, cosine;
        trk_turn_sincos(trk_turn_fraction(turns[k]), &sine, &cosine);
        double v = amplitude[k] * sine;
        double r = amplitude[k] * (2.0 * pi * frequency[k]) * cosine - decay * v;
        value[k] = t < 0.0 ? 0.0 : v;
        r = t < 0.0 ? 0.0 : r;
        rate[k] = t >= last ? 0.0 : r;
    }
}

static void destroy(trk_signal *signal)
{
    trk_free(signal->context, signal->sweep.panels);
}

/* The phase of each centre from the one before, over the edge between the two panels. */
static void set_panels(trk_sweep *p, const trk_sweep_options *o)
{
    double half = 0.5 * p->duration / p->panel_count, u = p->growth * half;
    double forward = half * exponential_ratio(u), backward = half * exponential_ratio(-u);
    double turns = trk_turn_fraction(o->phase / (2.0 * pi)); /* at the edge */
    for (int32_t i = 0; i < p->panel_count; i++) {
        double centre = (2.0 * i + 1.0) * half;
        double frequency = o->start_frequency * exp(p->growth * centre);
        turns = trk_turn_fraction(turns + frequency * backward);
        p->panels[i] = (trk_sweep_panel){
            centre, frequency, o->amplitude * pow(frequency, -o->amplitude_exponent), turns};
        turns = trk_turn_fraction(turns + frequency * forward);
    }
}

static trk_status check(trk_context *context, const trk_sweep_options *o)
{
    const struct {
        const char *name;
        double value;
        bool positive;
    } fields[] = {
        {"start_frequency", o->start_frequency, true},
        {"end_frequency", o->end_frequency, true},
        {"duration", o->duration, true},
        {"amplitude", o->amplitude, false},
        {"phase", o->phase, false},
        {"start", o->start, false},
        {"amplitude_exponent", o->amplitude_exponent, false},
    };
    for (size_t k = 0; k < sizeof fields / sizeof *fields; k++) {
        trk_status status =
            fields[k].positive
                ? trk_signal_check_positive(context, "sweep", fields[k].name, fields[k].value)
                : trk_signal_check_finite(context, "sweep", fields[k].name, fields[k].value);
        if (status)
            return status;
    }
    if (o->start_frequency == o->end_frequency)
        return trk_fail(context, TRK_E_RANGE,
                        "sweep: start_frequency and end_frequency are both %g", o->start_frequency);
    if (fabs(o->amplitude_exponent) > LARGEST_EXPONENT)
        return trk_fail(context, TRK_E_RANGE, "sweep: amplitude_exponent is %g, expected -%d to %d",
                        o->amplitude_exponent, LARGEST_EXPONENT, LARGEST_EXPONENT);
    double growth = log(o->end_frequency / o->start_frequency) / o->duration;
    for (int end = 0; end < 2; end++) {
        double frequency = end ? o->end_frequency : o->start_frequency;
        double peak = o->amplitude * pow(frequency, -o->amplitude_exponent);
        double fastest = fabs(peak) * (2.0 * pi * frequency + fabs(o->amplitude_exponent * growth));
        if (!isfinite(growth) || !isfinite(2.0 * fastest) || !isfinite(frequency * o->duration))
            return trk_fail(context, TRK_E_RANGE,
                            "sweep: amplitude %g m/s or phase overflows at %g Hz", fastest,
                            frequency);
    }
    return TRK_OK;
}

static const trk_sweep_options defaults = {sizeof defaults, 0.8, 20.0, 480.0, 0.001, 1.0, 0.0, 0.0};

void trk_sweep_options_init(trk_sweep_options *options, size_t struct_size)
{
    trk_write_defaults(options, struct_size, &defaults, sizeof defaults);
}

trk_status trk_signal_create_sweep(trk_context *context, const trk_sweep_options *options,
                                   trk_signal **out_signal)
{
    static const trk_signal_kind kind = {evaluate, destroy};
    TRK_REQUIRE(context, out_signal, "trk_signal_create_sweep");
    *out_signal = NULL;
    if (!context)
        return TRK_E_ARGUMENT;
    trk_sweep_options o = defaults;
    trk_status status = trk_read_options(context, "trk_sweep_options", options, &o, sizeof o);
    if (status == TRK_OK)
        status = check(context, &o);
    if (status)
        return status;
    trk_signal *signal = trk_signal_new(context, &kind);
    if (!signal)
        return TRK_E_MEMORY;
    trk_sweep *p = &signal->sweep;
    double folds = log(o.end_frequency / o.start_frequency);
    int32_t panels =
        (int32_t)ceil(PANELS_PER_E_FOLD * fabs(folds) * fmax(1.0, fabs(o.amplitude_exponent)));
    *p = (trk_sweep){.start = o.start,
                     .duration = o.duration,
                     .growth = folds / o.duration,
                     .amplitude_exponent = o.amplitude_exponent,
                     .panel_count = panels > 0 ? panels : 1};
    p->panels_per_unit = p->panel_count / p->duration;
    p->panels = trk_new(context, p->panel_count, sizeof *p->panels);
    if (!p->panels) {
        trk_signal_destroy(signal);
        return TRK_E_MEMORY;
    }
    set_panels(p, &o);
    *out_signal = signal;
    return TRK_OK;
}
