/* SPDX-License-Identifier: MIT */
/* One call of a subcommand: its options, context and messages. */
#ifndef TRUCKRIDE_CLI_SESSION_H
#define TRUCKRIDE_CLI_SESSION_H

#include "common/arguments.h"

#include <truckride/truckride.h>

/* How tables are written. */
enum { FORMAT_AUTO = 0, FORMAT_TABLE = 1, FORMAT_CSV = 2, FORMAT_JSON = 3 };

/* Options of all subcommands; the first member of the settings of each. */
typedef struct shared {
    bool help, quiet, gravity;
    int32_t format;
    const char *out, *plot;
} shared;

/* Tables of these options. */
extern const argument shared_general[]; /* help, quiet            */
extern const argument shared_tables[];  /* format, out            */
extern const argument shared_model[];   /* gravity                */
extern const argument shared_plot[];    /* plot                   */

typedef struct session session;

/* A subcommand. */
typedef struct command {
    const char *name, *summary, *usage, *about, *examples;
    const argument *const *tables;
    int (*run)(session *s, int argc, char **argv);
    bool independent; /* it reads and explains its options by itself */
} command;

struct session {
    const command *command;
    char program[64]; /* "truckride modes" */
    trk_context *context;
    const shared *shared;
    words operands;
    bool colour; /* of messages */
};

/* Read the options into settings, which begin with a `shared`, and open a context. True to go on;
 * else *out_code is how the program ends. Needs session_end() in any case. */
bool session_begin(session *s, void *settings, int argc, char **argv, int *out_code);
void session_end(session *s);

/* There must be so many operands: "MODEL". */
bool session_operands(session *s, int least, int most, const char *what, int *out_code);

/* Print why, and return the exit code. */
int session_fail(session *s, trk_status status);
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
int session_usage(session *s, const char *format, ...);
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
int session_error(session *s, const char *format, ...);

/* Read and compile MODEL; EXIT_DONE or the exit code. out_spec may be NULL. */
int session_model(session *s, const char *text, trk_spec **out_spec, trk_model **out_model);

/* True if a stream is a terminal that may be coloured (NO_COLOR is not set). */
bool may_colour(FILE *stream);

#endif
