/* SPDX-License-Identifier: MIT */
/* truckride modes: eigenfrequencies, damping ratios and shapes. */
#include "common/text.h"
#include "modes.h"
#include "energy.h"
#include "output.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct settings {
    shared shared;
    bool undamped, shapes;
    int32_t count;
} settings;

/* Coordinates of a model whose damped modes take minutes. */
enum { MANY = 1000 };

#define AT(field) offsetof(settings, field)

static const argument own[] = {
    {.help = "Modes"},
    {"undamped", 0, ARGUMENT_SWITCH, AT(undamped), NULL,
     "leave dampers out; default: damped modes, with |lambda| / 2 pi as frequency", 0},
    {"count", 'n', ARGUMENT_COUNT, AT(count), "N", "only the N lowest", 0},
    {"shapes", 's', ARGUMENT_SWITCH, AT(shapes), NULL,
     "also the shape of each mode: real and imaginary part and share of the\n"
     "kinetic energy of every coordinate that takes part",
     0},
    {0}};
static const argument *const tables[] = {own, shared_model, shared_tables, shared_general, NULL};

table *modes_table(bool labelled)
{
    table *t = table_create("modes");
    if (labelled)
        table_column_add(t, "model", "", TABLE_TEXT);
    table_column_add(t, "mode", "", 0);
    table_column_add(t, "frequency", "Hz", 3);
    table_column_add(t, "damped frequency", "Hz", 3);
    table_column_add(t, "damping ratio", "", 4);
    table_column_add(t, "dominant", "", TABLE_TEXT);
    table_column_add(t, "kinetic energy", "", TABLE_TEXT);
    return t;
}

void modes_rows(table *t, const char *label, const trk_model *model, const trk_modes *modes,
                int32_t count)
{
    double *share = need((size_t)trk_model_count(model, TRK_PART_COORDINATE), sizeof *share);
    char energy[640];
    for (int32_t k = 1; k <= count && k <= trk_modes_count(modes); k++) {
        energy[0] = 0;
        if (trk_modes_get_energy(modes, k, share) == TRK_OK)
            energy_text(model, share, energy, sizeof energy);
        if (label)
            table_text(t, label);
        table_number(t, k);
        table_number(t, trk_modes_frequency(modes, k));
        table_number(t, trk_modes_damped_frequency(modes, k));
        table_number(t, trk_modes_damping_ratio(modes, k));
        table_text(t, trk_modes_label(modes, k));
        table_text(t, energy);
    }
    free(share);
}

/* Coordinates without motion are left out. */
static table *shapes_table(const trk_model *model, const trk_modes *modes, int32_t count)
{
    const int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
    table *t = table_create("shapes");
    double *shape = need(3 * (size_t)n, sizeof *shape), *im = shape + n, *share = im + n;
    table_column_add(t, "mode", "", 0);
    table_column_add(t, "coordinate", "", TABLE_TEXT);
    table_column_add(t, "real", "", TABLE_GENERAL);
    table_column_add(t, "imaginary", "", TABLE_GENERAL);
    table_column_add(t, "energy", "", 4);
    for (int32_t k = 1; k <= count && k <= trk_modes_count(modes); k++) {
        if (trk_modes_get_shape(modes, k, shape, im) != TRK_OK ||
            trk_modes_get_energy(modes, k, share) != TRK_OK)
            continue;
        double most = 0;
        for (int32_t i = 0; i < n; i++)
            most = fmax(most, hypot(shape[i], im[i]));
        for (int32_t i = 0; i < n; i++) {
            if (hypot(shape[i], im[i]) <= 1e-12 * most)
                continue;
            table_number(t, k);
            table_text(t, trk_model_part_name(model, TRK_PART_COORDINATE, i + 1));
            table_number(t, shape[i]);
            table_number(t, im[i]);
            table_number(t, share[i]);
        }
    }
    free(shape);
    return t;
}

static int print(session *s, const settings *o, const trk_model *model)
{
    trk_modes *modes = NULL;
    const int32_t count = o->count > 0 ? o->count : INT32_MAX;
    const int32_t n = trk_model_count(model, TRK_PART_COORDINATE);
    if (!o->undamped && n > MANY && !s->shared->quiet)
        fprintf(stderr,
                "%s: note: all damped modes of %d coordinates take long; "
                "--undamped --count N is quick\n",
                s->program, (int)n);
    const trk_status status =
        !o->undamped ? trk_modes_create_damped(s->context, model, NULL, NULL, &modes)
        : count < n  ? trk_modes_create_lowest(s->context, model, NULL, count, &modes)
                     : trk_modes_create_undamped(s->context, model, NULL, &modes);
    if (status != TRK_OK)
        return session_fail(s, status);
    table *t[2] = {modes_table(false), NULL};
    modes_rows(t[0], NULL, model, modes, count);
    if (o->shapes)
        t[1] = shapes_table(model, modes, count);
    const int code = output_tables(s, 1 + o->shapes, t);
    table_destroy(t[0]);
    table_destroy(t[1]);
    trk_modes_destroy(modes);
    return code;
}

static int run(session *s, int argc, char **argv)
{
    settings o = {0};
    trk_model *model = NULL;
    int code;
    if (session_begin(s, &o, argc, argv, &code) && session_operands(s, 1, 1, "MODEL", &code)) {
        code = session_model(s, s->operands.word[0], NULL, &model);
        if (code == EXIT_DONE)
            code = print(s, &o, model);
        trk_model_destroy(model);
    }
    session_end(s);
    return code;
}

extern const command modes_command;
const command modes_command = {
    "modes",
    "eigenfrequencies, damping ratios and mode shapes",
    "[OPTION...] MODEL",
    "List the modes of a vehicle about its equilibrium, by rising frequency: natural frequency,\n"
    "frequency of the free oscillation, damping ratio, the coordinate with most of the kinetic\n"
    "energy, and how the energy is shared.\n",
    "  truckride modes builtin:reference_truck\n"
    "  truckride modes truck.json --gravity --undamped --count 5 --shapes\n"
    "  truckride modes truck.json --format json | jq '.modes[].frequency'\n",
    tables,
    run,
    false,
};
