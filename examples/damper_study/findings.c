/* SPDX-License-Identifier: MIT */
/* The table in words: every sentence follows from the numbers. */
#include "damper_study.h"

#include <math.h>
#include <string.h>

/* Below this a change of RMS is called none. */
static const double relative_change = 0.1;

/* Direction of a change that the thesis says nothing of. */
enum { NOT_SAID = 2 };

void write_table(const study *s, int studied, FILE *table)
{
    for (int place = 0; place < PLACES; place++)
        for (int c = 0; sensor_at(studied, place) && c < CONFIGURATIONS; c++) {
            const response *r = &s->seen[c][place];
            char frequency[32] = "", peak[64] = ",";
            if (place == FRONT_AXLE)
                snprintf(frequency, sizeof frequency, "%.2f", s->eigenfrequency[c]);
            if (isfinite(r->peak))
                snprintf(peak, sizeof peak, "%.2f,%.4g", r->peak, r->height);
            print_both(table, "%s,%s,%s,%s,%s,%.4g,%.4g\n", s->model->name,
                       sensor_at(studied, place), configuration_names[c], frequency, peak, r->rms,
                       r->axle_rms);
        }
}

/* Direction of a change: -1, 0 or 1. */
static int direction(double change, double none)
{
    return change > none ? 1 : change < -none ? -1 : 0;
}

static const char *verb(int way)
{
    return way > 0 ? "raises" : way < 0 ? "lowers" : "hardly changes";
}

static const char *past(int way)
{
    return way > 0 ? "rose" : way < 0 ? "fell" : "hardly changed";
}

/* One of the thesis's two findings beside ours. */
static void compare(FILE *out, int ours, int thesis, const char *who, const char *numbers)
{
    if (thesis != NOT_SAID)
        print_both(out, "   The thesis's %s %s: it %s%s.\n", who,
                   ours == thesis ? "agrees" : "differs", past(thesis), numbers);
}

static void peak_frequency(const study *s, FILE *out)
{
    const response *with = &s->seen[STANDARD][FRONT_AXLE],
                   *without = &s->seen[UNDAMPED][FRONT_AXLE];
    double change = without->peak - with->peak;
    int way = direction(change, peak_uncertainty);
    print_both(out,
               "%s: removing the damper %s the front axle's peak, from %.2f to %.2f Hz "
               "(%+.2f Hz, %+.1f %%); its eigenfrequency goes from %.2f to %.2f Hz.\n",
               s->model->title, verb(way), with->peak, without->peak, change,
               100 * change / with->peak, s->eigenfrequency[STANDARD], s->eigenfrequency[UNDAMPED]);
    compare(out, way, 1, "model",
            s->model == &truck_models[QUARTER_FRONT] ? " from 13.8 to 18.8 Hz" : "");
    compare(out, way, -1, "truck", " from 13.8 to 11.8 Hz");
}

static void peak_height(const study *s, FILE *out)
{
    const response *standard = &s->seen[STANDARD][FRONT_AXLE];
    const response *harder = &s->seen[HARDER][FRONT_AXLE], *none = &s->seen[UNDAMPED][FRONT_AXLE];
    double ratio = harder->height / standard->height;
    int way = direction(ratio - 1, relative_change / 2);
    print_both(out,
               "%s: the harder damper %s the front axle's peak PSD (x %.2f) and its RMS goes "
               "from %.3f to %.3f m/s^2; without damper the PSD peaks x %.1f, the RMS is %.3f "
               "m/s^2.\n",
               s->model->title, verb(way), ratio, standard->rms, harder->rms,
               none->height / standard->height, none->rms);
    compare(out, way, s->model == &truck_models[QUARTER_FRONT] ? 1 : -1, "model", "");
    compare(out, way, 1, "truck", "");
}

/* What the thesis says of a place when the damper goes, or gets harder: its model, its truck. */
typedef struct passage {
    int place;
    const char *name;
    int removed_model, removed_truck, harder_model, harder_truck;
} passage;

/* How much of the axle's resonance arrives; the rear axle gets its own from the road. */
static void share_of_axle(const study *s, int place, FILE *out)
{
    double share[CONFIGURATIONS];
    for (int c = 0; c < CONFIGURATIONS; c++)
        share[c] = 100 * s->seen[c][place].axle_rms / s->seen[c][FRONT_AXLE].axle_rms;
    print_both(out,
               "   Between %g and %g Hz its RMS is %.2g %% of the front axle's with the standard "
               "damper, %.2g %% with the harder one, %.2g %% without.\n",
               resonance[0], resonance[1], share[STANDARD], share[HARDER], share[UNDAMPED]);
}

static void reaches(const study *s, const passage *p, FILE *out)
{
    double standard = s->seen[STANDARD][p->place].rms, removed = s->seen[UNDAMPED][p->place].rms;
    double harder = s->seen[HARDER][p->place].rms;
    int way = direction(removed / standard - 1, relative_change);
    print_both(out, "%s, %s: removing the damper %s the RMS, from %.3f to %.3f m/s^2 (x %.2f).\n",
               s->model->title, p->name, verb(way), standard, removed, removed / standard);
    compare(out, way, p->removed_model, "model", "");
    compare(out, way, p->removed_truck, "truck", "");
    way = direction(harder / standard - 1, relative_change);
    print_both(out, "   The harder damper %s it (x %.2f).\n", verb(way), harder / standard);
    compare(out, way, p->harder_model, "model", "");
    compare(out, way, p->harder_truck, "truck", "");
    if (p->place != REAR_AXLE)
        share_of_axle(s, p->place, out);
}

/* Damping that lowers an undamped frequency to the damped one. */
static void explain(const study *quarter, FILE *out)
{
    double thesis = sqrt(1 - pow(13.8 / 18.8, 2)), ours = quarter->damping_ratio[STANDARD];
    print_both(out,
               "From 18.8 down to 13.8 Hz takes a damping ratio of %.2f; the front axle here has "
               "%.2f at rest: %s.\n",
               thesis, ours,
               ours < thesis / 2 ? "its damper moves the amplitude, not the frequency"
                                 : "enough to move its frequency as far");
}

static void twins(const study *half, const study *full, FILE *out)
{
    double worst = 0;
    for (int c = 0; c < CONFIGURATIONS; c++)
        for (int place = 0; place < PLACES; place++)
            worst = fmax(worst, fabs(full->seen[c][place].rms / half->seen[c][place].rms - 1));
    print_both(out,
               "Half truck and 3D truck differ by at most %.1e in RMS: equal wheels make them "
               "%s model.\n",
               worst, worst < 1e-3 ? "one" : "more than one");
}

void write_findings(const study *all, FILE *findings)
{
    const passage passages[] = {{FRAME, "frame at the front cab mount", 0, NOT_SAID, NOT_SAID, 1},
                                {CAB_FRONT, "cab at its front mount", 0, 1, 0, NOT_SAID},
                                {CAB_REAR, "cab at its rear mount", 1, 1, NOT_SAID, NOT_SAID},
                                {REAR_AXLE, "rear axle", NOT_SAID, 0, 1, 0}};
    const passage sprung = {FRAME, "sprung mass", 1, 1, NOT_SAID, NOT_SAID};
    print_both(findings, "\n1. Does removing the front damper raise or lower the axle's peak?\n");
    for (int k = 0; k < STUDIED; k++)
        peak_frequency(&all[k], findings);
    explain(&all[QUARTER], findings);
    print_both(findings, "\n2. Does the harder damper raise or lower the axle's response?\n");
    for (int k = 0; k < STUDIED; k++)
        peak_height(&all[k], findings);
    print_both(findings, "\n3. What reaches frame, cab and rear axle?\n");
    reaches(&all[QUARTER], &sprung, findings);
    for (size_t p = 0; p < sizeof passages / sizeof *passages; p++)
        reaches(&all[HALF], &passages[p], findings);
    twins(&all[HALF], &all[FULL], findings);
}
