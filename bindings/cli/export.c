/* SPDX-License-Identifier: MIT */
/* truckride export: a vehicle as a model file, part by part. */
#include "export.h"
#include "common/text.h"
#include "output.h"

#include <stdlib.h>
#include <string.h>

static const argument own[] = {{.help = "Output"},
                               {"out", 'o', ARGUMENT_TEXT, offsetof(shared, out), "FILE",
                                "write there; default - is standard output", 0},
                               {0}};
static const argument *const tables[] = {own, shared_general, NULL};

static void print_model(FILE *file, const void *user)
{
    fputs(user, file);
}

int export_model(session *s, const trk_spec *spec, const char *path)
{
    size_t length = 0;
    trk_status status;
    if (path && strcmp(path, "-") != 0) {
        status = trk_model_file_write(s->context, spec, path);
        return status == TRK_OK ? EXIT_DONE : session_fail(s, status);
    }
    status = trk_model_file_format(spec, 0, NULL, &length);
    if (status != TRK_OK && status != TRK_E_RANGE)
        return session_fail(s, status);
    char *text = need(length + 1, 1);
    status = trk_model_file_format(spec, length + 1, text, NULL);
    const int code =
        status == TRK_OK ? output_write(s, NULL, print_model, text) : session_fail(s, status);
    free(text);
    return code;
}

static int run(session *s, int argc, char **argv)
{
    shared o = {0};
    trk_spec *spec = NULL;
    trk_model *model = NULL;
    int code;
    if (session_begin(s, &o, argc, argv, &code) && session_operands(s, 1, 1, "MODEL", &code)) {
        code = session_model(s, s->operands.word[0], &spec, &model);
        if (code == EXIT_DONE)
            code = export_model(s, spec, o.out);
        trk_model_destroy(model);
        trk_spec_destroy(spec);
    }
    session_end(s);
    return code;
}

extern const command export_command;
const command export_command = {
    "export",
    "write a vehicle as a model file, to begin with",
    "[OPTION...] MODEL",
    "Write a vehicle as a model file in which every part is spelled out: a ready-made one, to\n"
    "change it, or one of your own, with its axles, frames and tables resolved.\n",
    "  truckride export builtin:reference_truck -o truck.json\n"
    "  truckride export builtin:reference_half:linear | truckride modes -\n",
    tables,
    run,
    false,
};
