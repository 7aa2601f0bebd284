/* SPDX-License-Identifier: MIT */
/* truckride check: is a model valid, and does it look right? */
#include "check.h"
#include "common/text.h"
#include "modes.h"
#include "output.h"

#include <math.h>
#include <stdlib.h>

typedef struct settings {
    shared shared;
    bool strict;
    int32_t count;
} settings;

/* Coordinates of a model whose damped modes take no time; else the lowest undamped ones are shown. */
enum { FEW = 300 };

#define AT(field) offsetof(settings, field)

static const argument own[] = {
    {.help = "Check"},
    {"modes", 'n', ARGUMENT_COUNT, AT(count), "N", "show the N lowest modes; default 6", 0},
    {"strict", 0, ARGUMENT_SWITCH, AT(strict), NULL, "exit code 1 for warnings, too", 0},
    {0}};
static const argument *const tables[] = {own, shared_tables, shared_general, NULL};

static table *labelled(const char *name)
{
    table *t = table_create(name);
    table_column_add(t, "model", "", TABLE_TEXT);
    return t;
}

static void open_report(check_report *r)
{
    static const char *const counts[] = {"coordinates", "bodies", "masses", "links",
                                         "beams",       "roads",  "ports",  "sensors"};
    r->vehicles = labelled("vehicles");
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++)
        table_column_add(r->vehicles, counts[k], "", 0);
    table_column_add(r->vehicles, "mass", "kg", 1);
    table_column_add(r->vehicles, "weight", "N", 1);
    table_column_add(r->vehicles, "on roads", "N", 1);
    r->tires = labelled("tires");
    table_column_add(r->tires, "road", "", TABLE_TEXT);
    table_column_add(r->tires, "x", "m", 3);
    table_column_add(r->tires, "y", "m", 3);
    table_column_add(r->tires, "load", "N", 1);
    table_column_add(r->tires, "share", "%", 2);
    r->axles = labelled("axles");
    table_column_add(r->axles, "x", "m", 3);
    table_column_add(r->axles, "wheels", "", 0);
    table_column_add(r->axles, "load", "N", 1);
    table_column_add(r->axles, "share", "%", 2);
    r->modes = modes_table(true);
    r->warnings = labelled("warnings");
    table_column_add(r->warnings, "warning", "", TABLE_TEXT);
}

static void check_damping(check_report *r, const check_subject *c, const trk_modes *modes)
{
    for (int32_t k = 1; k <= trk_modes_count(modes); k++) {
        const double f = trk_modes_frequency(modes, k), zeta = trk_modes_damping_ratio(modes, k);
        const char *name = trk_modes_label(modes, k);
        if (zeta < -1e-9)
            check_warn(r, c, "mode %d (%s, %.4g Hz) grows: its damping ratio is %.3g", (int)k, name,
                       f, zeta);
        else if (f < 1e-6)
            check_warn(r, c, "mode %d (%s) moves freely", (int)k, name);
        else if (zeta < 1e-6)
            check_warn(r, c, "mode %d (%s, %.4g Hz) has no damping", (int)k, name, f);
    }
}

static void check_modes(session *s, check_report *r, const check_subject *c, int32_t count)
{
    const int32_t n = trk_model_count(c->model, TRK_PART_COORDINATE);
    trk_modes *modes = NULL;
    trk_status status = TRK_OK;
    if (n <= FEW)
        status = trk_modes_create_damped(s->context, c->model, NULL, NULL, &modes);
    else if (count > 0)
        status = trk_modes_create_lowest(s->context, c->model, NULL, count < n ? count : n, &modes);
    if (status != TRK_OK) {
        check_warn(r, c, "no modes: %s", trk_context_message(s->context));
        return;
    }
    modes_rows(r->modes, c->label, c->model, modes, count);
    if (n <= FEW)
        check_damping(r, c, modes);
    trk_modes_destroy(modes);
}

static int check_one(session *s, const settings *o, check_report *r, const char *path)
{
    trk_spec *spec = NULL;
    trk_model *model = NULL;
    const int code = session_model(s, path, &spec, &model);
    if (code == EXIT_DONE) {
        check_subject c = {.label = trk_model_name(model), .spec = spec, .model = model};
        c.force = need((size_t)trk_model_count(model, TRK_PART_LINK), sizeof *c.force);
        trk_model_get_static(model, NULL, c.force);
        check_loads(r, &c);
        check_parts(r, &c);
        check_modes(s, r, &c, o->count);
        free(c.force);
    }
    trk_model_destroy(model);
    trk_spec_destroy(spec);
    return code;
}

static int check_all(session *s, const settings *o)
{
    check_report r;
    int worst = EXIT_DONE;
    open_report(&r);
    for (int k = 0; k < s->operands.count; k++) {
        const int code = check_one(s, o, &r, s->operands.word[k]);
        worst = code > worst ? code : worst;
    }
    table *all[] = {r.vehicles, r.tires, r.axles, r.modes, r.warnings};
    const bool warned = table_rows(r.warnings) > 0;
    if (table_rows(r.vehicles) > 0) {
        const int code = output_tables(s, 4 + warned, all);
        worst = code > worst ? code : worst;
    }
    for (size_t k = 0; k < sizeof all / sizeof *all; k++)
        table_destroy(all[k]);
    return worst == EXIT_DONE && warned && o->strict ? EXIT_FAILED : worst;
}

static int run(session *s, int argc, char **argv)
{
    settings o = {.shared.gravity = true, .count = 6};
    int code;
    if (session_begin(s, &o, argc, argv, &code) &&
        session_operands(s, 1, INT32_MAX, "MODEL", &code))
        code = check_all(s, &o);
    session_end(s);
    return code;
}

extern const command check_command;
const command check_command = {
    "check",
    "is a model valid, what does it weigh, does it look right?",
    "[OPTION...] MODEL...",
    "Read models, compile them with weight, and show the number of parts, mass, static loads of\n"
    "tires and axles, and the lowest modes. Warn of links without force, road inputs that no\n"
    "link stands on, wheels that carry nothing, and motions without damping.\n"
    "The exit code is 1 if a model is not valid; messages begin with file:line:column.\n",
    "  truckride check truck.json\n"
    "  truckride check --strict vehicles/*.json\n"
    "  truckride check builtin:reference_truck --format json | jq '.axles[].load'\n",
    tables,
    run,
    false,
};
