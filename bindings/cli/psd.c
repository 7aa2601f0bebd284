/* SPDX-License-Identifier: MIT */
/* truckride psd: spectra and RMS of recordings and of vehicles on roads. */
#include "psd.h"
#include "common/text.h"
#include "output.h"
#include "plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define AT(field) offsetof(psd_settings, field)

static const argument own[] = {
    {.help = "Spectrum"},
    {"linear", 0, ARGUMENT_SWITCH, AT(linear), NULL,
     "without a run, from the model linearised at rest: the spectrum that a run of\n"
     "this duration would give",
     0},
    {"linearise", 0, ARGUMENT_SWITCH, AT(linearise), NULL,
     "as --linear, but dampers, friction and other laws linearised for the\n"
     "motion on this road, not at rest",
     0},
    {"segment", 0, ARGUMENT_WHOLE, AT(segment), "N",
     "samples of a segment; default 4096, or all if there are fewer", 0},
    {"overlap", 0, ARGUMENT_NUMBER, AT(overlap), "X", "part that segments share; default 0.5", 0},
    {"window", 0, ARGUMENT_CHOICE, AT(window),
     "hann|rectangular|hamming|blackman|blackman_harris|flat_top", "default hann", TRK_WINDOW_HANN},
    {"from", 0, ARGUMENT_NUMBER, AT(from), "HZ", "leave out what is below; default 0", 0},
    {"to", 0, ARGUMENT_NUMBER, AT(to), "HZ", "leave out what is above; default: no end", 0},
    {"weighting", 'w', ARGUMENT_CHOICE, AT(weighting), "Wk|Wd|Wc|We|Wj|Wf|Wb",
     "weight accelerations as ISO 2631-1 does; other channels are left out", TRK_WEIGHTING_WK},
    {"rms", 0, ARGUMENT_SWITCH, AT(rms), NULL,
     "in place of the spectrum: RMS and highest peak of each channel in the band", 0},
    {0}};
static const argument *const tables[] = {own,         run_arguments,  shared_model, shared_tables,
                                         shared_plot, shared_general, NULL};

static trk_status weight(session *s, const psd_settings *o, psd_spectra *p)
{
    trk_status status = TRK_OK;
    for (int c = 0; c < p->channels && o->weighting && status == TRK_OK; c++) {
        double *density = p->density + (size_t)c * (size_t)p->length;
        status = trk_psd_weight(s->context, o->weighting, p->length, density, p->step, density);
    }
    return status;
}

/* First bin and number of bins from `from` to `to`. */
static int64_t band_of(const psd_settings *o, const psd_spectra *p, int64_t *out_first)
{
    *out_first = (int64_t)ceil(o->from / p->step - 1e-9);
    const double last = o->to > 0 ? floor(o->to / p->step + 1e-9) : (double)p->length;
    return (last < (double)p->length - 1 ? (int64_t)last : p->length - 1) - *out_first + 1;
}

/* "(m/s^2)^2/Hz", "N^2/Hz" */
static void density_unit(const char *unit, char *out, size_t room)
{
    if (!*unit)
        snprintf(out, room, "1/Hz");
    else
        snprintf(out, room, strpbrk(unit, "/^ ") ? "(%s)^2/Hz" : "%s^2/Hz", unit);
}

static table *spectrum_table(const psd_spectra *p, int64_t first, int64_t count)
{
    table *t = table_create("psd");
    char unit[160];
    table_column_add(t, "frequency", "Hz", 3);
    for (int c = 0; c < p->channels; c++) {
        density_unit(p->channel[c].unit, unit, sizeof unit);
        table_column_add(t, p->channel[c].name, unit, TABLE_GENERAL);
    }
    for (int64_t k = first; k < first + count; k++) {
        table_number(t, (double)k * p->step);
        for (int c = 0; c < p->channels; c++)
            table_number(t, p->density[(size_t)c * (size_t)p->length + (size_t)k]);
    }
    return t;
}

static trk_status rms_row(session *s, table *t, const psd_settings *o, const psd_spectra *p, int c,
                          int64_t first, int64_t count)
{
    const double *density = p->density + (size_t)c * (size_t)p->length;
    double rms, frequency = NAN, height = NAN;
    int64_t peaks = 0;
    trk_status status = trk_band_rms(s->context, p->length, density, p->step, o->from,
                                     o->to > 0 ? o->to : (double)p->length * p->step, &rms);
    if (status == TRK_OK)
        status = trk_psd_peaks(s->context, count, density + first, p->step, NULL, 1, &frequency,
                               &height, NULL, &peaks);
    if (status != TRK_OK)
        return status;
    table_text(t, p->channel[c].name);
    table_text(t, p->channel[c].unit);
    table_number(t, rms);
    table_number(t, peaks > 0 ? frequency + (double)first * p->step : NAN);
    table_number(t, peaks > 0 ? height : NAN);
    return TRK_OK;
}

static trk_status rms_table(session *s, const psd_settings *o, const psd_spectra *p, int64_t first,
                            int64_t count, table *t)
{
    trk_status status = TRK_OK;
    table_column_add(t, "channel", "", TABLE_TEXT);
    table_column_add(t, "unit", "", TABLE_TEXT);
    table_column_add(t, o->weighting ? "weighted rms" : "rms", "", TABLE_GENERAL);
    table_column_add(t, "peak frequency", "Hz", 3);
    table_column_add(t, "peak density", "", TABLE_GENERAL);
    for (int c = 0; c < p->channels && status == TRK_OK; c++)
        status = rms_row(s, t, o, p, c, first, count);
    return status;
}

static int draw(session *s, const psd_spectra *p, int64_t first, int64_t count)
{
    const int64_t skip = first == 0 ? 1 : 0; /* no logarithm of 0 Hz */
    char(*label)[160] = need((size_t)p->channels, sizeof *label);
    plot_page page = {.title = "power spectral density",
                      .label = "frequency [Hz]",
                      .logarithmic = true,
                      .points = count - skip,
                      .start = (double)(first + skip) * p->step,
                      .step = p->step};
    for (int c = 0; c < p->channels; c++) {
        density_unit(p->channel[c].unit, label[c], sizeof label[c]);
        plot_add(&page, label[c], true, p->channel[c].name,
                 p->density + (size_t)c * (size_t)p->length + (size_t)(first + skip), 1);
    }
    const int code = plot_draw(s, s->shared->plot, &page);
    plot_free(&page);
    free(label);
    return code;
}

static int print(session *s, const psd_settings *o, psd_spectra *p)
{
    int64_t first;
    const int64_t count = band_of(o, p, &first);
    if (p->channels == 0)
        return session_error(s, "no channel is left to show");
    if (count < 2)
        return session_usage(s, "--from and --to leave no frequencies: they are %.4g Hz apart",
                             p->step);
    trk_status status = weight(s, o, p);
    table *t = o->rms ? table_create("rms") : NULL;
    if (status == TRK_OK && o->rms)
        status = rms_table(s, o, p, first, count, t);
    else if (status == TRK_OK)
        t = spectrum_table(p, first, count);
    int code = status == TRK_OK ? output_tables(s, 1, &t) : session_fail(s, status);
    table_destroy(t);
    if (code == EXIT_DONE && s->shared->plot)
        code = draw(s, p, first, count);
    return code;
}

static int run(session *s, int argc, char **argv)
{
    psd_settings o = {.run = run_defaults(), .overlap = 0.5};
    psd_spectra p = {0};
    int code;
    if (session_begin(s, &o, argc, argv, &code) &&
        session_operands(s, 1, 1, "a recording, or MODEL with --road,", &code)) {
        code = plot_check(s, s->shared->plot);
        if (code == EXIT_DONE && !(o.from >= 0 && (o.to == 0 || o.to > o.from)))
            code = session_usage(s, "--from and --to are no band");
        if (code == EXIT_DONE)
            code = output_check(s, s->shared->out);
        if (code == EXIT_DONE)
            code = o.run.road ? psd_of_run(s, &o, &p) : psd_of_recording(s, &o, &p);
        if (code == EXIT_DONE)
            code = print(s, &o, &p);
    }
    psd_close(&p);
    session_end(s);
    return code;
}

extern const command psd_command;
const command psd_command = {
    "psd",
    "spectra and RMS, of recordings and of vehicles on roads",
    "[OPTION...] RECORDING | --road ROAD [OPTION...] MODEL",
    "Estimate power spectral densities by Welch's method: of the channels of a RECORDING (.csv,\n"
    ".erd, .rpc, .rsp; - is CSV on standard input), or with --road of what the sensors of a\n"
    "vehicle measure on that road.\n",
    "  truckride psd run.csv --plot psd.svg -o psd.csv\n"
    "  truckride psd run.csv --rms --weighting Wk --sensors 'cab_*_z'\n"
    "  truckride psd builtin:reference_truck:linear --road iso:class=C --duration 120 \\\n"
    "      --linear --rms --from 0.5 --to 80\n",
    tables,
    run,
    false,
};
