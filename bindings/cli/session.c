/* SPDX-License-Identifier: MIT */
/* Options, context and messages of a subcommand. */
#define _POSIX_C_SOURCE 200809L
#include "session.h"
#include "common/text.h"
#include "common/vehicle.h"
#include "help.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define AT(field) offsetof(shared, field)

const argument shared_general[] = {
    {.help = "General"},
    {"quiet", 'q', ARGUMENT_SWITCH, AT(quiet), NULL, "no progress and no notes", 0},
    {"help", 'h', ARGUMENT_SWITCH, AT(help), NULL, "this text", 0},
    {0}};
const argument shared_tables[] = {
    {.help = "Output"},
    {"format", 'f', ARGUMENT_CHOICE, AT(format), "table|csv|json",
     "default: as the suffix of FILE tells, else table", FORMAT_TABLE},
    {"out", 'o', ARGUMENT_TEXT, AT(out), "FILE", "write there; default - is standard output", 0},
    {0}};
const argument shared_model[] = {
    {.help = "Model"},
    {"gravity", 'g', ARGUMENT_SWITCH, AT(gravity), NULL,
     "compile with weight: work about the static equilibrium of the drawn vehicle;\n"
     "without, the drawing is taken for the equilibrium",
     0},
    {0}};
const argument shared_plot[] = {{"plot", 0, ARGUMENT_TEXT, AT(plot), "FILE",
                                 "draw into FILE.png, FILE.svg or FILE.pdf, with gnuplot", 0},
                                {0}};

bool may_colour(FILE *stream)
{
    const char *no = getenv("NO_COLOR"), *terminal = getenv("TERM");
    return !(no && *no) && terminal && strcmp(terminal, "dumb") != 0 && isatty(fileno(stream));
}

static void hear(void *user, const char *message)
{
    const session *s = user;
    if (!s->shared->quiet) {
        fprintf(stderr, "%s: note: ", s->program);
        text_print(stderr, message);
        fputc('\n', stderr);
    }
}

bool session_begin(session *s, void *settings, int argc, char **argv, int *out_code)
{
    s->shared = settings;
    s->colour = may_colour(stderr);
    *out_code = arguments_read(s->program, s->command->tables, settings, &s->operands, argc,
                               (const char *const *)argv, true);
    if (*out_code != EXIT_DONE)
        return false;
    if (s->shared->help) {
        help_command(stdout, s->command);
        return false;
    }
    const trk_status status = trk_context_create(NULL, NULL, &s->context);
    if (status != TRK_OK) {
        *out_code = session_fail(s, status);
        return false;
    }
    trk_context_set_log(s->context, hear, s);
    return true;
}

void session_end(session *s)
{
    words_free(&s->operands);
    trk_context_destroy(s->context);
    s->context = NULL;
}

bool session_operands(session *s, int least, int most, const char *what, int *out_code)
{
    if (s->operands.count < least)
        *out_code = session_usage(s, "%s is missing", what);
    else if (s->operands.count > most)
        *out_code = session_usage(s, "unexpected word '%s'", s->operands.word[most]);
    return s->operands.count >= least && s->operands.count <= most;
}

static void print_message(const session *s, const char *end, const char *format, va_list values)
{
    const char *red = s->colour ? "\033[31m" : "", *plain = s->colour ? "\033[0m" : "";
    char message[2048];
    vsnprintf(message, sizeof message, format, values);
    fprintf(stderr, "%s%s:%s ", red, s->program, plain);
    text_print(stderr, message);
    fputs(end, stderr);
}

int session_error(session *s, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    print_message(s, "\n", format, values);
    va_end(values);
    return EXIT_FAILED;
}

int session_usage(session *s, const char *format, ...)
{
    char end[96];
    va_list values;
    va_start(values, format);
    snprintf(end, sizeof end, " (see %s --help)\n", s->program);
    print_message(s, end, format, values);
    va_end(values);
    return EXIT_USAGE;
}

/* "truck.json:12:7: ...": an editor finds the place if nothing stands before it. */
static bool has_place(const char *message)
{
    for (const char *c = strchr(message, ':'); c; c = strchr(c + 1, ':')) {
        const char *end = c + 1;
        while (isdigit((unsigned char)*end))
            end++;
        if (end > c + 1 && *end == ':' && isdigit((unsigned char)end[1]))
            return true;
        if (c[1] == ' ')
            return false;
    }
    return false;
}

int session_fail(session *s, trk_status status)
{
    if (status == TRK_E_CANCELLED) {
        session_error(s, "interrupted");
        return EXIT_INTERRUPTED;
    }
    const char *message = s->context ? trk_context_message(s->context) : "";
    if (has_place(message)) {
        text_print(stderr, message);
        fputc('\n', stderr);
    } else {
        session_error(s, "%s", *message ? message : trk_status_text(status));
    }
    return EXIT_FAILED;
}

int session_model(session *s, const char *text, trk_spec **out_spec, trk_model **out_model)
{
    complaint wrong;
    trk_spec *spec = NULL;
    trk_model_options options;
    trk_model_options_init(&options, sizeof options);
    options.gravity = s->shared->gravity ? TRK_STANDARD_GRAVITY : 0;
    *out_model = NULL;
    if (out_spec)
        *out_spec = NULL;
    trk_status status = vehicle_read(s->context, text, &wrong, &spec);
    if (status != TRK_OK && wrong.text[0])
        return session_usage(s, "%s", wrong.text);
    if (status == TRK_OK)
        status = trk_model_compile(s->context, spec, &options, out_model);
    if (status == TRK_OK && out_spec)
        *out_spec = spec;
    else
        trk_spec_destroy(spec);
    return status == TRK_OK ? EXIT_DONE : session_fail(s, status);
}
