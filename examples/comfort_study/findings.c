/* SPDX-License-Identifier: MIT */
/* The table in words: every sentence follows from the numbers. */
#include "comfort_study.h"

#include <math.h>

/* Below this a change is called none: about what chance leaves. */
static const double relative_change = 0.05;

typedef struct range {
    double low, high;
} range;

static void widen(range *r, double value)
{
    r->low = fmin(r->low, value);
    r->high = fmax(r->high, value);
}

/* Ratio of an estimate with a damper to that with the standard one, over roads and speeds. */
static range damper_ratio(const judgement *all, int damper, int which)
{
    range r = {INFINITY, -INFINITY};
    for (int k = 0; k < CASES; k += DAMPERS)
        widen(&r, pick(&all[k + damper], which)->value / pick(&all[k + STANDARD], which)->value);
    return r;
}

/* Ratio of an estimate on the road of class C to that on class B. */
static range class_ratio(const judgement *all, int which)
{
    range r = {INFINITY, -INFINITY};
    for (int k = 0; k < SPEEDS * DAMPERS; k++)
        widen(&r,
              pick(&all[case_of(CLASS_C, 0, 0) + k], which)->value / pick(&all[k], which)->value);
    return r;
}

static const char *verb(range r)
{
    return r.low > 1 + relative_change                                   ? "raises"
           : r.high < 1 - relative_change                                ? "lowers"
           : r.low > 1 - relative_change && r.high < 1 + relative_change ? "hardly changes"
           : r.low > 1 - relative_change                                 ? "raises, if anything,"
           : r.high < 1 + relative_change                                ? "lowers, if anything,"
                                                                         : "raises or lowers";
}

static void comfort(const judgement *all, FILE *out)
{
    int calm = 0, rough = 0;
    char words[128];
    for (int k = 1; k < CASES; k++) {
        calm = all[k].total.value < all[calm].total.value ? k : calm;
        rough = all[k].total.value > all[rough].total.value ? k : rough;
    }
    const int ends[] = {calm, rough};
    print_both(out, "\n1. How comfortable? (dampers of the thesis; the floor under the seat: a "
                    "seat would change it)\n");
    for (int i = 0; i < 2; i++) {
        const int k = ends[i];
        describe(all[k].total.value, words, sizeof words);
        print_both(out, "%s: class %s, %g km/h, %s front damper: sum %.2f +- %.2f m/s^2, %s.\n",
                   i ? "Worst" : "Best", class_names[k / (SPEEDS * DAMPERS)],
                   speeds[k / DAMPERS % SPEEDS], damper_names[k % DAMPERS], all[k].total.value,
                   all[k].total.error, words);
    }
    for (int class = 0; class < CLASSES; class ++) {
        const judgement *slow = &all[case_of(class, 0, STANDARD)];
        const judgement *fast = &all[case_of(class, SPEEDS - 1, STANDARD)];
        print_both(out,
                   "Class %s, standard damper: from %g to %g km/h the cab's weighted z goes from "
                   "%.2f to %.2f m/s^2 (x %.2f), the front tire's load coefficient from %.3f to "
                   "%.3f.\n",
                   class_names[class], speeds[0], speeds[SPEEDS - 1], slow->weighted[2].value,
                   fast->weighted[2].value, fast->weighted[2].value / slow->weighted[2].value,
                   slow->load[0].value, fast->load[0].value);
    }
}

static void dampers(const study *s, FILE *out)
{
    static const int asked[] = {WEIGHTED_Z, FRONT_DLC, REAR_DLC, FRONT_RMS};
    static const char *const names[] = {"the cab's weighted z", "the front tire's load coefficient",
                                        "the rear tire's load coefficient", "the front travel"};
    static const char *const does[] = {
        [HARDER] = "the harder front damper", [UNDAMPED] = "removing the front damper"};
    static const char *const trucks[TRUCKS] = {"Dampers of the thesis", "Linear dampers"};
    print_both(out, "\n2. What do the front dampers do?\n");
    for (int truck = 0; truck < TRUCKS; truck++)
        for (int damper = HARDER; damper <= UNDAMPED; damper++)
            for (int q = 0; q < 4; q++) {
                range r = damper_ratio(s->driven[truck], damper, asked[q]);
                print_both(out, "%s: %s %s %s (x %.2f to %.2f).\n", trucks[truck], does[damper],
                           verb(r), names[q], r.low, r.high);
            }
}

static void classes(const study *s, FILE *out)
{
    range computed = class_ratio(s->computed, WEIGHTED_Z);
    range linear = class_ratio(s->driven[LINEAR], WEIGHTED_Z);
    range thesis = class_ratio(s->driven[THESIS_DAMPERS], WEIGHTED_Z);
    print_both(out,
               "\n3. What does a class make? One road, twice as high: 4 times the density.\n"
               "Weighted z of the linear truck: x %.6f to %.6f by spectra, x %.6f to %.6f in time "
               "steps; with the dampers of the thesis x %.2f to %.2f: %s.\n",
               computed.low, computed.high, linear.low, linear.high, thesis.low, thesis.high,
               thesis.low > 2    ? "they damp less, the faster they move"
               : thesis.high < 2 ? "they damp more, the faster they move"
                                 : "more or less than 2");
}

static void agreement(const study *s, FILE *out)
{
    double largest = 0, sum = 0;
    range errors = {INFINITY, -INFINITY}, twins = {INFINITY, -INFINITY};
    for (int k = 0; k < CASES; k++) {
        for (int which = 0; which < ESTIMATES; which++) {
            const estimate *run = pick(&s->driven[LINEAR][k], which);
            const estimate *exact = pick(&s->computed[k], which);
            double deviation = (run->value - exact->value) / run->error;
            largest = fmax(largest, fabs(deviation));
            sum += deviation * deviation / (CASES * ESTIMATES);
            widen(&errors, run->error / exact->error);
        }
        widen(&twins, s->driven[THESIS_DAMPERS][k].weighted[2].value /
                          s->driven[LINEAR][k].weighted[2].value);
    }
    print_both(out,
               "\n4. Do time steps and spectra agree? (linear truck, %d values, those of class C "
               "twice those of B)\n"
               "They differ by at most %.2f standard errors, %.2f in the mean%s.\n"
               "Standard errors from the spectrum of the run are x %.2f to %.2f those from the "
               "exact one.\n"
               "The weighted z with the dampers of the thesis is x %.2f to %.2f that of the linear "
               "truck.\n",
               CASES * ESTIMATES, largest, sqrt(sum),
               sum < 1 ? ": the power of the road varies less from stretch to stretch than that "
                         "of noise (ROAD.8), for which the errors are stated"
                       : "",
               errors.low, errors.high, twins.low, twins.high);
}

static void limits(const judgement *all, FILE *out)
{
    print_both(out, "\n5. Where do the models end? (dampers of the thesis)\n");
    for (int damper = 0; damper < DAMPERS; damper++) {
        double lift = 0, travel = 0;
        for (int k = damper; k < CASES; k += DAMPERS) {
            lift = fmax(lift, all[k].lift_off[0]);
            travel = fmax(travel, all[k].peak[0]);
        }
        print_both(out,
                   "%s front damper: the front tire pulls on the road for up to %.2g %% of the "
                   "time, where a real one lifts off; the spring moves by up to %.0f mm, without "
                   "a bump stop.\n",
                   damper_names[damper], 100 * lift, 1000 * travel);
    }
}

void write_findings(const study *s, const char *directory)
{
    FILE *out = open_result(directory, "findings.txt");
    comfort(s->driven[THESIS_DAMPERS], out);
    dampers(s, out);
    classes(s, out);
    agreement(s, out);
    limits(s->driven[THESIS_DAMPERS], out);
    fclose(out);
}
