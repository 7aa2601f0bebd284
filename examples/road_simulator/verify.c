/* SPDX-License-Identifier: MIT */
/*
 * Step and sine on every model, 0 to 15 s at h = 1 ms, against an integrator that shares
 * nothing with the stepper: classical Runge-Kutta of fourth order at 0.05 ms on
 * M q" = -B^T f(B q - G u, B q' - G u'), written with the model's matrices only.
 */
#include "road_simulator.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_N = 16, MAX_LINKS = 40, MAX_ROADS = 4, SUBSTEPS = 20 };

/* A model written out. */
typedef struct equations {
    const trk_model *model;
    const trk_signal *road;
    int32_t n, links, roads;
    double inverse_mass[MAX_N][MAX_N];
    double b[MAX_LINKS][MAX_N], g[MAX_LINKS]; /* all wheels see the same road */
} equations;

/* Gauss-Jordan; mass matrices of vehicles are diagonal or nearly so. */
static void invert(int32_t n, double *a, double out[MAX_N][MAX_N])
{
    for (int32_t i = 0; i < n; i++)
        for (int32_t j = 0; j < n; j++)
            out[i][j] = i == j;
    for (int32_t k = 0; k < n; k++) {
        double pivot = a[k * n + k];
        for (int32_t j = 0; j < n; j++) {
            a[k * n + j] /= pivot;
            out[k][j] /= pivot;
        }
        for (int32_t i = 0; i < n; i++) {
            double factor = a[i * n + k];
            for (int32_t j = 0; i != k && j < n; j++) {
                a[i * n + j] -= factor * a[k * n + j];
                out[i][j] -= factor * out[k][j];
            }
        }
    }
}

static void write_out(trk_context *context, const trk_model *model, const trk_signal *road,
                      equations *e)
{
    double mass[MAX_N * MAX_N], g[MAX_ROADS] = {0};
    memset(e, 0, sizeof *e);
    e->model = model;
    e->road = road;
    e->n = trk_model_count(model, TRK_PART_COORDINATE);
    e->links = trk_model_count(model, TRK_PART_LINK);
    e->roads = trk_model_count(model, TRK_PART_ROAD);
    if (e->n > MAX_N || e->links > MAX_LINKS || e->roads > MAX_ROADS)
        exit(1);
    trk_model_get_mass(model, mass);
    invert(e->n, mass, e->inverse_mass);
    for (int32_t k = 0; k < e->links; k++) {
        check(context, trk_model_get_link_row(model, k + 1, e->b[k], g));
        for (int32_t r = 0; r < e->roads; r++)
            e->g[k] += g[r];
    }
}

/* y = (q, q') -> dy/dt */
static void derivative(const equations *e, double t, const double *y, double *out)
{
    double elongation[MAX_LINKS], rate[MAX_LINKS], force[MAX_LINKS], load[MAX_N] = {0};
    double u = trk_signal_value(e->road, t), du = trk_signal_rate(e->road, t);
    for (int32_t k = 0; k < e->links; k++) {
        elongation[k] = -e->g[k] * u;
        rate[k] = -e->g[k] * du;
        for (int32_t i = 0; i < e->n; i++) {
            elongation[k] += e->b[k][i] * y[i];
            rate[k] += e->b[k][i] * y[e->n + i];
        }
    }
    trk_model_get_link_force(e->model, elongation, rate, force);
    for (int32_t k = 0; k < e->links; k++)
        for (int32_t i = 0; i < e->n; i++)
            load[i] -= e->b[k][i] * force[k];
    for (int32_t i = 0; i < e->n; i++) {
        out[i] = y[e->n + i];
        out[e->n + i] = 0;
        for (int32_t j = 0; j < e->n; j++)
            out[e->n + i] += e->inverse_mass[i][j] * load[j];
    }
}

static void runge_kutta(const equations *e, double t, double h, double *y)
{
    double k[4][2 * MAX_N], trial[2 * MAX_N];
    const double at[4] = {0, 0.5, 0.5, 1};
    for (int stage = 0; stage < 4; stage++) {
        for (int32_t i = 0; i < 2 * e->n; i++)
            trial[i] = y[i] + (stage ? at[stage] * h * k[stage - 1][i] : 0);
        derivative(e, t + at[stage] * h, trial, k[stage]);
    }
    for (int32_t i = 0; i < 2 * e->n; i++)
        y[i] += h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
}

/* Both integrators side by side; one row per coordinate into the table, signals into a file. */
static void compare(trk_context *context, const char *name, const char *input,
                    const trk_model *model, const trk_signal *road, const char *directory,
                    FILE *table)
{
    equations *e = allocate(sizeof *e);
    trk_newmark *stepper;
    write_out(context, model, road, e);
    check(context, trk_newmark_create(context, model, NULL, &stepper));
    double h = trk_newmark_step_size(stepper), q[MAX_N], y[2 * MAX_N] = {0};
    double peak[MAX_N] = {0}, difference[MAX_N] = {0};
    double u0[MAX_ROADS] = {0}, v0[MAX_ROADS];
    for (int k = 0; k < MAX_ROADS; k++)
        v0[k] = trk_signal_rate(road, 0);
    check(context, trk_newmark_set_state(stepper, 0, NULL, NULL, u0, v0, NULL));

    char file_name[128];
    snprintf(file_name, sizeof file_name, "verify_%s_%s.csv", name, input);
    FILE *file = open_result(directory, file_name);
    fputs("time_s", file);
    for (int32_t i = 1; i <= e->n; i++) {
        const char *coordinate = trk_model_part_name(model, TRK_PART_COORDINATE, i);
        fprintf(file, ",%s newmark,%s reference", coordinate, coordinate);
    }
    fputc('\n', file);
    for (int step = 1; step <= 15000; step++) {
        double t = step * h, u[MAX_ROADS], v[MAX_ROADS];
        for (int k = 0; k < MAX_ROADS; k++) {
            u[k] = trk_signal_value(road, t);
            v[k] = trk_signal_rate(road, t);
        }
        check(context, trk_newmark_step(stepper, u, v, NULL));
        for (int k = 0; k < SUBSTEPS; k++)
            runge_kutta(e, (step - 1) * h + k * h / SUBSTEPS, h / SUBSTEPS, y);
        trk_newmark_get_state(stepper, q, NULL, NULL);
        for (int32_t i = 0; i < e->n; i++) {
            peak[i] = fmax(peak[i], fabs(y[i]));
            difference[i] = fmax(difference[i], fabs(q[i] - y[i]));
        }
        if (step % 10 == 0) {
            fprintf(file, "%.6g", t);
            for (int32_t i = 0; i < e->n; i++)
                fprintf(file, ",%.10g,%.10g", q[i], y[i]);
            fputc('\n', file);
        }
    }
    fclose(file);
    for (int32_t i = 0; i < e->n; i++) {
        if (peak[i] < 1e-12) /* left and right wheels move alike: nothing but rounding */
            continue;
        print_both(table, "%s,%s,%s,%.4g,%.2e,%.2e\n", name, input,
                   trk_model_part_name(model, TRK_PART_COORDINATE, i + 1), peak[i], difference[i],
                   difference[i] / peak[i]);
    }
    trk_newmark_destroy(stepper);
    free(e);
}

void run_verification(trk_context *context, const char *directory)
{
    const char *const name[] = {"thesis_quarter", "half_car", "half_truck", "truck_3d"};
    trk_spec *spec;
    trk_model *model[4];
    trk_signal *step, *sine;
    check(context, trk_vehicle_create_builtin(context, TRK_VEHICLE_THESIS_QUARTER,
                                              TRK_VARIANT_LINEAR, &spec));
    model[0] = compile(context, spec);
    check(context, trk_vehicle_create_half_car(context, NULL, &spec));
    model[1] = compile(context, spec);
    check(context, trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_HALF,
                                              TRK_VARIANT_THESIS_DAMPERS, &spec));
    model[2] = compile(context, spec);
    check(context, trk_vehicle_create_builtin(context, TRK_VEHICLE_REFERENCE_TRUCK,
                                              TRK_VARIANT_THESIS_DAMPERS, &spec));
    model[3] = compile(context, spec);
    /* The thesis's step; its sine has 0.01 m, the frequency is lost: 1 Hz here. */
    check(context, trk_signal_create_step(context, 1, 0.5, 0.01, &step));
    check(context, trk_signal_create_sine(context, 0.01, 1, 0, 0, &sine));

    FILE *table = open_result(directory, "verification.csv");
    fputs("\n", stdout);
    print_both(table, "model,input,coordinate,peak,largest_difference,relative\n");
    for (int k = 0; k < 4; k++) {
        compare(context, name[k], "step", model[k], step, directory, table);
        compare(context, name[k], "sine", model[k], sine, directory, table);
        trk_model_destroy(model[k]);
    }
    trk_signal_destroy(step);
    trk_signal_destroy(sine);
    fclose(table);
}
