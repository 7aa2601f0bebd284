/* SPDX-License-Identifier: MIT */
/* truckride frf: frequency response from roads to sensors. */
#include "common/text.h"
#include "names.h"
#include "output.h"
#include "plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct settings {
    shared shared;
    const char *roads, *sensors;
    double from, to, speed;
    int64_t points;
    bool even;
} settings;

#define AT(field) offsetof(settings, field)

static const argument own[] = {
    {.help = "Response"},
    {"road", 'r', ARGUMENT_TEXT, AT(roads), "INPUT[,INPUT...]",
     "road inputs that move, all with 1 m; '*' stands for any text; default: all", 0},
    {"sensor", 's', ARGUMENT_TEXT, AT(sensors), "NAME[,NAME...]", "default: all", 0},
    {"from", 0, ARGUMENT_NUMBER, AT(from), "HZ", "first frequency; default 0.1", 0},
    {"to", 0, ARGUMENT_NUMBER, AT(to), "HZ", "last frequency; default 30", 0},
    {"points", 'n', ARGUMENT_WHOLE, AT(points), "N", "number of frequencies; default 300", 0},
    {"even", 0, ARGUMENT_SWITCH, AT(even), NULL, "even steps in Hz; default: even in the logarithm",
     0},
    {"speed", 0, ARGUMENT_NUMBER, AT(speed), "KM/H",
     "drive: rear wheels follow the front ones; default: all move at once", 0},
    {0}};
static const argument *const tables[] = {own,         shared_model,   shared_tables,
                                         shared_plot, shared_general, NULL};

/* What is shown of a model: frequencies, and complex responses of all sensors. */
typedef struct response {
    const trk_model *model;
    int64_t points;
    int32_t sensors;
    double *frequency, *value; /* points; points x sensors x 2     */
    double *magnitude, *phase; /* [deg] points x sensors           */
    bool *shown;               /* by sensor                        */
} response;

static void fill_frequencies(const settings *o, response *r)
{
    for (int64_t k = 0; k < o->points; k++) {
        const double part = (double)k / (double)(o->points - 1);
        r->frequency[k] =
            o->even ? o->from + part * (o->to - o->from) : o->from * pow(o->to / o->from, part);
    }
}

static int compute(session *s, const settings *o, response *r)
{
    const int32_t roads = trk_model_count(r->model, TRK_PART_ROAD);
    bool *moves = need((size_t)roads, sizeof *moves);
    double *gain = need(2 * (size_t)roads, sizeof *gain), *delay = gain + roads, front = -INFINITY;
    int code = names_of_model(s, r->model, TRK_PART_ROAD, o->roads, moves);
    for (int32_t k = 0; k < roads && code == EXIT_DONE; k++) {
        gain[k] = moves[k];
        if (trk_model_get_road_place(r->model, k + 1, &delay[k], NULL) != TRK_OK)
            delay[k] = 0;
        front = fmax(front, delay[k]);
    }
    for (int32_t k = 0; k < roads; k++)
        delay[k] = o->speed > 0 ? (front - delay[k]) / (o->speed / 3.6) : 0;
    if (code == EXIT_DONE) {
        fill_frequencies(o, r);
        const trk_status status = trk_frequency_response(
            s->context, r->model, NULL, NULL, r->points, r->frequency, gain, delay, NULL, r->value);
        code = status == TRK_OK ? EXIT_DONE : session_fail(s, status);
    }
    free(moves);
    free(gain);
    if (code == EXIT_DONE)
        for (size_t k = 0; k < (size_t)r->points * (size_t)r->sensors; k++) {
            const double *v = r->value + 2 * k;
            r->magnitude[k] = hypot(v[0], v[1]);
            r->phase[k] = atan2(v[1], v[0]) * 180 / acos(-1.0);
        }
    return code;
}

static table *response_table(const response *r)
{
    table *t = table_create("frf");
    char name[200], unit[80];
    table_column_add(t, "frequency", "Hz", 4);
    for (int32_t c = 0; c < r->sensors; c++) {
        if (!r->shown[c])
            continue;
        const char *sensor = trk_model_part_name(r->model, TRK_PART_SENSOR, c + 1);
        snprintf(name, sizeof name, "%s magnitude", sensor);
        snprintf(unit, sizeof unit, "%s/m", trk_model_unit(r->model, TRK_PART_SENSOR, c + 1));
        table_column_add(t, name, unit, TABLE_GENERAL);
        snprintf(name, sizeof name, "%s phase", sensor);
        table_column_add(t, name, "deg", 2);
    }
    for (int64_t k = 0; k < r->points; k++) {
        table_number(t, r->frequency[k]);
        for (int32_t c = 0; c < r->sensors; c++) {
            const size_t at = (size_t)k * (size_t)r->sensors + (size_t)c;
            if (!r->shown[c])
                continue;
            table_number(t, r->magnitude[at]);
            table_number(t, r->phase[at]);
        }
    }
    return t;
}

/* Is the largest magnitude more than rounding beside that of other sensors of its unit? */
static bool responds(const response *r, int32_t sensor)
{
    const char *unit = trk_model_unit(r->model, TRK_PART_SENSOR, sensor + 1);
    double mine = 0, all = 0;
    for (size_t k = 0; k < (size_t)r->points * (size_t)r->sensors; k++) {
        const int32_t c = (int32_t)(k % (size_t)r->sensors);
        if (c == sensor)
            mine = fmax(mine, r->magnitude[k]);
        if (strcmp(trk_model_unit(r->model, TRK_PART_SENSOR, c + 1), unit) == 0)
            all = fmax(all, r->magnitude[k]);
    }
    return mine > 1e-9 * all;
}

static int draw(session *s, const settings *o, const response *r)
{
    char(*label)[80] = need((size_t)r->sensors, sizeof *label);
    plot_page page = {.title = trk_model_name(r->model),
                      .label = "frequency [Hz]",
                      .logarithmic = !o->even,
                      .points = r->points,
                      .x = r->frequency};
    for (int pass = 0; pass < 2; pass++)
        for (int32_t c = 0; c < r->sensors; c++) {
            snprintf(label[c], sizeof label[c], "%s/m",
                     trk_model_unit(r->model, TRK_PART_SENSOR, c + 1));
            if (r->shown[c] && responds(r, c))
                plot_add(&page, pass ? "phase [deg]" : label[c], pass == 0,
                         trk_model_part_name(r->model, TRK_PART_SENSOR, c + 1),
                         (pass ? r->phase : r->magnitude) + c, (size_t)r->sensors);
        }
    const int code = page.panels == 0 ? session_error(s, "nothing responds: there is no plot")
                                      : plot_draw(s, s->shared->plot, &page);
    plot_free(&page);
    free(label);
    return code;
}

static int respond(session *s, const settings *o, const trk_model *model)
{
    response r = {.model = model, .points = o->points};
    r.sensors = trk_model_count(model, TRK_PART_SENSOR);
    if (r.sensors == 0)
        return session_error(s, "%s: the vehicle has no sensor", trk_model_name(model));
    const size_t all = (size_t)r.points * (size_t)r.sensors;
    r.frequency = need((size_t)r.points, sizeof(double));
    r.value = need(4 * all, sizeof(double));
    r.magnitude = r.value + 2 * all;
    r.phase = r.magnitude + all;
    r.shown = need((size_t)r.sensors, sizeof *r.shown);
    int code = names_of_model(s, model, TRK_PART_SENSOR, o->sensors, r.shown);
    if (code == EXIT_DONE)
        code = compute(s, o, &r);
    if (code == EXIT_DONE) {
        table *t = response_table(&r);
        code = output_tables(s, 1, &t);
        table_destroy(t);
    }
    if (code == EXIT_DONE && s->shared->plot)
        code = draw(s, o, &r);
    free(r.frequency);
    free(r.value);
    free(r.shown);
    return code;
}

static int run(session *s, int argc, char **argv)
{
    settings o = {.from = 0.1, .to = 30, .points = 300};
    trk_model *model = NULL;
    int code;
    if (session_begin(s, &o, argc, argv, &code) && session_operands(s, 1, 1, "MODEL", &code)) {
        code = plot_check(s, s->shared->plot);
        if (code == EXIT_DONE && !(o.to > o.from && o.from >= (o.even ? 0 : 1e-9)))
            code = session_usage(s, "--from and --to are no band of frequencies");
        if (code == EXIT_DONE && !(o.points >= 2 && o.points <= 10000000))
            code = session_usage(s, "--points expects 2 to 10000000");
        if (code == EXIT_DONE)
            code = session_model(s, s->operands.word[0], NULL, &model);
        if (code == EXIT_DONE)
            code = respond(s, &o, model);
        trk_model_destroy(model);
    }
    session_end(s);
    return code;
}

extern const command frf_command;
const command frf_command = {
    "frf",
    "frequency response from roads to sensors",
    "[OPTION...] MODEL",
    "Magnitude and phase of what sensors measure when road inputs move by a sine of 1 m, of the\n"
    "model linearised at rest.\n",
    "  truckride frf builtin:reference_half --sensor cab_front_z --plot frf.png -o frf.csv\n"
    "  truckride frf truck.json --road 'front_*' --from 0.5 --to 20 --points 40\n"
    "  truckride frf truck.json --speed 80 --sensor 'cab_*' --even --format csv\n",
    tables,
    run,
    false,
};
