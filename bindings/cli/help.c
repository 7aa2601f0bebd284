/* SPDX-License-Identifier: MIT */
/* Help of the command and of its subcommands; the manual page made of the same texts. */
#include "common/road.h"
#include "help.h"

#include <string.h>

static const char introduction[] =
    "Ride dynamics of heavy trucks: modes, runs over roads, spectra and calibration of\n"
    "vehicles that are described in model files.\n";

const char help_model[] =
    "MODEL is the path of a model file (JSON), - for one on standard input, or a ready-made\n"
    "vehicle builtin:NAME[:VARIANT]. NAME: thesis_quarter, reference_front, reference_rear,\n"
    "reference_half, reference_truck. VARIANT: linear, thesis (default), nonlinear.\n";

static const char start[] =
    "  truckride check builtin:reference_truck\n"
    "  truckride modes builtin:reference_truck\n"
    "  truckride simulate truck.json --road iso:class=C:speed=70 --plot run.png -o run.csv\n";

static const char exits[] = "  0    done\n"
                            "  1    failed: the message says why; check: a model is not valid\n"
                            "  2    wrong usage\n"
                            "  130  interrupted by Ctrl-C\n";

void help_all(FILE *file)
{
    fprintf(file, "Usage: truckride SUBCOMMAND [OPTION...] MODEL...\n\n%s\nSubcommands:\n",
            introduction);
    for (const command *const *c = commands; *c; c++)
        fprintf(file, "  %-10s %s\n", (*c)->name, (*c)->summary);
    fprintf(file, "  %-10s %s\n\n%s\n", "help", "explain a subcommand: truckride help modes",
            help_model);
    fprintf(file,
            "Start with:\n%s\n"
            "truckride SUBCOMMAND --help explains a subcommand, truckride --version tells the\n"
            "version. All numbers are in SI units, speeds of roads in km/h.\n\n"
            "Exit codes:\n%s",
            start, exits);
}

void help_command(FILE *file, const command *c)
{
    if (c->independent) {
        char *ask[] = {"--help"};
        session s = {.command = c};
        c->run(&s, 1, ask);
        return;
    }
    fprintf(file, "Usage: truckride %s %s\n\n%s", c->name, c->usage, c->about);
    arguments_help(file, c->tables);
    if (strstr(c->usage, "ROAD"))
        fprintf(file, "\n%s", road_help);
    fprintf(file, "\n%s", help_model);
    fprintf(file, "\nExamples:\n%s", c->examples);
}

/* Text for roff: no line is a request, no dash is a hyphen. */
static void put_text(FILE *file, const char *text)
{
    for (bool begins = true; *text; text++) {
        if (begins && (*text == '.' || *text == '\''))
            fputs("\\&", file);
        if (*text == '\\')
            fputs("\\e", file);
        else if (*text == '-')
            fputs("\\-", file);
        else
            fputc(*text, file);
        begins = *text == '\n';
    }
}

/* Lines as they are. */
static void put_lines(FILE *file, const char *text)
{
    fputs(".nf\n", file);
    put_text(file, text);
    fputs(".fi\n", file);
}

static void put_options(FILE *file, const argument *a)
{
    for (; a->name || a->help; a++) {
        if (!a->name)
            continue;
        fputs(".TP\n", file);
        if (a->letter)
            fprintf(file, "\\fB\\-%c\\fR, ", a->letter);
        fprintf(file, "\\fB\\-\\-%s\\fR", a->name);
        if (a->kind != ARGUMENT_SWITCH)
            fprintf(file, " \\fI%s\\fR", a->value);
        fputc('\n', file);
        put_text(file, a->help);
        fputc('\n', file);
    }
}

void help_manual(FILE *file)
{
    fprintf(
        file,
        ".TH TRUCKRIDE 1 \"\" \"truckride %s\" \"User Commands\"\n.SH NAME\n"
        "truckride, truckride\\-study \\- ride dynamics of heavy trucks\n.SH SYNOPSIS\n"
        ".B truckride\n.I SUBCOMMAND\n[\\fIOPTION\\fR...] \\fIMODEL\\fR...\n.SH DESCRIPTION\n%s",
        trk_version_text(), introduction);
    fputs(".PP\ntruckride\\-study is truckride study without MODEL: see \\-\\-vehicle.\n", file);
    fputs(".SH MODELS\n", file);
    put_lines(file, help_model);
    fputs(".SH ROADS\n", file);
    put_lines(file, road_help);
    for (const command *const *c = commands; *c; c++) {
        fprintf(file, ".SH truckride %s\n.B truckride %s\n%s\n.PP\n", (*c)->name, (*c)->name,
                (*c)->usage);
        put_text(file, (*c)->about);
        for (const argument *const *t = (*c)->tables; *t; t++)
            put_options(file, *t);
        fputs(".PP\nExamples:\n", file);
        put_lines(file, (*c)->examples);
    }
    fputs(".SH EXIT STATUS\n", file);
    put_lines(file, exits);
    fputs(".SH ENVIRONMENT\n.TP\n.B NO_COLOR\nno colours, whatever the terminal can do\n"
          ".TP\n.B TMPDIR\nwhere temporary files go\n.SH SEE ALSO\n.BR gnuplot (1)\n",
          file);
}
