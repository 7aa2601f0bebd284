/* SPDX-License-Identifier: MIT */
/* The table, as CSV and to read, and the spectra. */
#include "comfort_study.h"

#include <math.h>

void describe(double total, char *out, size_t size)
{
    int32_t reactions = trk_comfort_reactions(total);
    size_t length = 0;
    out[0] = '\0';
    for (int32_t one = 1; trk_comfort_text(one) && length < size; one *= 2)
        if (reactions & one)
            length += (size_t)snprintf(out + length, size - length, "%s%s", length ? " / " : "",
                                       trk_comfort_text(one));
}

static void put(FILE *file, double value)
{
    if (isfinite(value))
        fprintf(file, ",%.6g", value);
    else
        fputc(',', file);
}

static void put_estimate(FILE *file, const estimate *e)
{
    put(file, e->value);
    put(file, e->error);
}

static void write_row(FILE *file, int truck, const char *method, int class, int speed, int damper,
                      const judgement *j)
{
    char words[128];
    describe(j->total.value, words, sizeof words);
    fprintf(file, "%s,%s,%s,%g,%s", truck_names[truck], method, class_names[class], speeds[speed],
            damper_names[damper]);
    for (int k = 2; k >= 0; k--)
        put_estimate(file, &j->weighted[k]);
    put(file, j->freedoms);
    put_estimate(file, &j->total);
    fprintf(file, ",%s", words);
    put(file, j->vdv);
    for (int axle = 0; axle < AXLES; axle++)
        put_estimate(file, &j->load[axle]);
    for (int axle = 0; axle < AXLES; axle++) {
        put_estimate(file, &j->travel[axle]);
        put(file, j->peak[axle]);
    }
    fputc('\n', file);
}

static const char *const columns =
    "truck,method,class,speed_km_h,damper,cab_z_wk,cab_z_wk_error,cab_y_wd,cab_y_wd_error,"
    "cab_x_wd,cab_x_wd_error,cab_z_freedoms,total,total_error,words,cab_z_vdv,front_dlc,"
    "front_dlc_error,rear_dlc,rear_dlc_error,front_travel_m,front_travel_error_m,"
    "front_travel_peak_m,rear_travel_m,rear_travel_error_m,rear_travel_peak_m\n";

/* Value and error in one cell; scale makes mm of m. */
static void cell(FILE *text, const estimate *e, double scale, int digits)
{
    print_both(text, "  %.*f +-%.*f", digits, scale * e->value, digits, scale * e->error);
}

static void write_line(FILE *text, int class, int speed, int damper, const judgement *j)
{
    char words[128];
    describe(j->total.value, words, sizeof words);
    print_both(text, "%-5s %3g  %-8s", class_names[class], speeds[speed], damper_names[damper]);
    for (int k = 2; k >= 0; k--)
        cell(text, &j->weighted[k], 1, 3);
    cell(text, &j->total, 1, 3);
    if (isfinite(j->vdv))
        print_both(text, " %5.2f", j->vdv);
    else
        print_both(text, "     -");
    for (int axle = 0; axle < AXLES; axle++)
        cell(text, &j->load[axle], 1, 4);
    for (int axle = 0; axle < AXLES; axle++) {
        cell(text, &j->travel[axle], 1000, 2);
        if (isfinite(j->peak[axle]))
            print_both(text, " %5.1f", 1000 * j->peak[axle]);
        else
            print_both(text, "     -");
    }
    print_both(text, "  %s\n", words);
}

static void write_method(FILE *csv, FILE *text, int truck, const char *method, const char *title,
                         const judgement *all)
{
    print_both(text, "\n%s\n%-19s  %-14s  %-14s  %-14s  %-14s %5s  %-15s  %-15s  %-20s  %-20s\n",
               title, "class km/h damper", "z Wk [m/s^2]", "y Wd", "x Wd", "sum [m/s^2]", "VDV",
               "DLC front [-]", "DLC rear [-]", "front travel, peak", "rear [mm]");
    for (int class = 0; class < CLASSES; class ++)
        for (int speed = 0; speed < SPEEDS; speed++)
            for (int damper = 0; damper < DAMPERS; damper++) {
                const judgement *j = &all[case_of(class, speed, damper)];
                write_row(csv, truck, method, class, speed, damper, j);
                write_line(text, class, speed, damper, j);
            }
}

void write_table(const study *s, const char *directory)
{
    FILE *csv = open_result(directory, "comfort_table.csv");
    FILE *text = open_result(directory, "comfort_table.txt");
    fputs(columns, csv);
    print_both(text,
               "Accelerations on the cab's floor where a seat would stand (the truck has no seat), "
               "weighted after ISO 2631-1;\ntravel and dynamic load coefficient (DLC) of the left "
               "wheels; +-: standard error by chance in %g s.\n",
               duration);
    write_method(csv, text, THESIS_DAMPERS, "time", "Dampers of the thesis, in time steps",
                 s->driven[THESIS_DAMPERS]);
    write_method(csv, text, LINEAR, "time", "Linear dampers, in time steps", s->driven[LINEAR]);
    write_method(csv, text, LINEAR, "frequency",
                 "Linear dampers, by spectra: exact, the error is what a run would have",
                 s->computed);
    fclose(csv);
    fclose(text);
}

void write_agreement(const study *s, const char *directory)
{
    static const char *const names[ESTIMATES] = {
        "cab x", "cab y", "cab z", "sum", "front DLC", "rear DLC", "front travel", "rear travel"};
    FILE *file = open_result(directory, "agreement.csv");
    fputs("number,quantity,class,speed_km_h,damper,deviation_in_errors\n", file);
    for (int which = 0; which < ESTIMATES; which++)
        for (int k = 0; k < CASES; k++) {
            const estimate *run = pick(&s->driven[LINEAR][k], which);
            fprintf(file, "%d,%s,%s,%g,%s,%.4f\n", which + 1, names[which],
                    class_names[k / (SPEEDS * DAMPERS)], speeds[k / DAMPERS % SPEEDS],
                    damper_names[k % DAMPERS],
                    (run->value - pick(&s->computed[k], which)->value) / run->error);
        }
    fclose(file);
}

void write_run_psd(int64_t length, double step, double *const *density, const char *directory)
{
    FILE *file = open_result(directory, "psd_time.csv");
    fputs("frequency_hz,thesis_dampers,linear\n", file);
    for (int64_t k = 1; k < length; k++)
        fprintf(file, "%.6g,%.6g,%.6g\n", (double)k * step, density[THESIS_DAMPERS][k],
                density[LINEAR][k]);
    fclose(file);
}

void write_computed_psd(int64_t length, double step, const double *density, const char *directory)
{
    FILE *file = open_result(directory, "psd_frequency.csv");
    fputs("frequency_hz,linear\n", file);
    for (int64_t k = 1; k < length; k++)
        fprintf(file, "%.6g,%.6g\n", (double)k * step, density[k]);
    fclose(file);
}
