/* SPDX-License-Identifier: MIT */
/* What came out, in words: every sentence follows from the numbers. */
#include "thesis_revisited.h"

#include <math.h>
#include <string.h>

/* Peaks nearer than this to the measured ones count as met: the thesis prints them to 0.2 Hz, and
 * the Hann window is 0.25 Hz wide. */
static const double met = 0.5; /* [Hz] */

static const double reference_tire = 817500; /* [N/m] of the reference tractor */

static void tires(const outcome *o, FILE *out)
{
    const trk_parameter_result *tire = &o->fitted.parameter[TIRE];
    for (int32_t k = 0; k < o->model->axles; k++) {
        const truck_axle *axle = &o->model->axle[k];
        print_both(out, "   %s axle, measured %.1f Hz:\n", axle->name, axle->measured);
        print_both(out, "      original tires              %5.2f Hz\n", o->peak[ORIGINAL][0][k]);
        print_both(
            out, "      tires of %4.2f MN/m          %5.2f Hz   (x %.2f; published 0.8 to 1.25)\n",
            o->factor[k] * reference_tire / 1e6, o->peak[TRIMMED_TIRES][0][k], o->factor[k]);
        print_both(out, "      friction, tires of %4.2f MN/m %4.2f Hz   (%s)\n", tire->fitted / 1e6,
                   o->peak[LEAF_FRICTION][0][k],
                   fabs(o->peak[LEAF_FRICTION][0][k] - axle->measured) <= met ? "met" : "not met");
    }
}

static void friction(const outcome *o, FILE *out)
{
    const trk_parameter_result *p = o->fitted.parameter;
    static const char *const ends[] = {", its lower bound", "", ", its upper bound"};
    print_both(out, "   fitted:");
    for (int k = 0; k < PARAMETERS; k++)
        if (p[k].fitted > 0)
            print_both(out, " %s %.4g %s%s%s;", published[k].name, p[k].fitted, published[k].unit,
                       ends[p[k].at_bound + 1], p[k].determined ? "" : " (not determined)");
    print_both(out, " %lld runs.\n", (long long)o->fitted.evaluations);
    if (o->fitted.status != TRK_OK)
        print_both(out, "   The calibration says: %s.\n", o->fitted.message);
}

static void damper(const outcome *o, FILE *out)
{
    if (o->model == &truck_models[QUARTER_REAR])
        return;
    print_both(out, "   Without the front damper (the truck: from 13.8 down to 11.8 Hz):\n");
    for (int e = 0; e < EXPLANATIONS; e++) {
        double with = o->peak[e][STANDARD][0], without = o->peak[e][UNDAMPED][0];
        print_both(out, "      %-14s %5.2f -> %5.2f Hz: %s\n", explanation_names[e], with, without,
                   without < with ? "falls, as on the truck" : "does not fall");
    }
}

void write_findings(const outcome *all, FILE *findings)
{
    print_both(findings,
               "\nDoes friction in the leaf springs explain what the rigid truck could not?\n"
               "Sweep 0.8 to 20 Hz, cylinders within 15 mm, dampers of the thesis.\n");
    for (int m = 0; m < TRUCK_MODELS; m++) {
        print_both(findings, "\n%s\n", truck_models[m].title);
        tires(&all[m], findings);
        friction(&all[m], findings);
        damper(&all[m], findings);
    }
    const outcome *half = &all[HALF_TRUCK];
    print_both(findings, "\nThe same half truck under other amplitudes of the sweep:\n");
    for (int a = 0; a < AMPLITUDES; a++)
        print_both(findings, "   %2.0f mm at 1 Hz: %5.2f Hz, without front damper %5.2f Hz\n",
                   1e3 * amplitudes[a], half->by_amplitude[a][STANDARD],
                   half->by_amplitude[a][UNDAMPED]);
    int axles = 0, hits = 0, models = 0, falls = 0;
    for (int m = 0; m < TRUCK_MODELS; m++) {
        for (int32_t k = 0; k < truck_models[m].axles; k++, axles++)
            hits += fabs(all[m].peak[LEAF_FRICTION][STANDARD][k] -
                         truck_models[m].axle[k].measured) <= met;
        if (m != QUARTER_REAR) {
            models++;
            falls +=
                all[m].peak[LEAF_FRICTION][UNDAMPED][0] < all[m].peak[LEAF_FRICTION][STANDARD][0];
        }
    }
    print_both(
        findings,
        "\nWith friction and tires of published stiffness %d of %d axle peaks come within %.1f Hz "
        "of "
        "the\nmeasured ones, and removing the front damper lowers the peak in %d of %d models, "
        "which no model\nof the thesis could show.\n",
        hits, axles, met, falls, models);
}
