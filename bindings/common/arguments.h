/* SPDX-License-Identifier: MIT */
/* Options of a command: tables of them, reading, help. */
#ifndef TRUCKRIDE_COMMON_ARGUMENTS_H
#define TRUCKRIDE_COMMON_ARGUMENTS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Exit codes of all commands. */
enum { EXIT_DONE = 0, EXIT_FAILED = 1, EXIT_USAGE = 2, EXIT_INTERRUPTED = 130 };

/* Words, borrowed. */
typedef struct words {
    const char **word;
    int count, room;
} words;

void words_add(words *list, const char *word);
void words_free(words *list);

/* What an option takes, and the type of its place. */
typedef enum argument_kind {
    ARGUMENT_SWITCH, /* nothing; bool                              */
    ARGUMENT_TEXT,   /* const char *                               */
    ARGUMENT_WORDS,  /* may come several times; words              */
    ARGUMENT_NUMBER, /* finite; double                             */
    ARGUMENT_WHOLE,  /* int64_t                                    */
    ARGUMENT_COUNT,  /* 0 to 2147483647; int32_t                   */
    ARGUMENT_CHOICE  /* one of "a|b|c", counted from `first`; int32_t */
} argument_kind;

/* An option; one without a name is a heading in the help. A table ends with {0}. */
typedef struct argument {
    const char *name; /* without dashes */
    char letter;      /* short name, or 0 */
    argument_kind kind;
    size_t place;      /* of its value in the settings of the command */
    const char *value; /* name of the value in help, or the choices */
    const char *help;  /* may have several lines */
    int32_t first;     /* value of the first choice */
} argument;

/*
 * Read argv into settings; what is no option goes to operands. tables ends with NULL. An option is
 * --name VALUE, --name=VALUE, -n VALUE or -nVALUE; "--" ends options. EXIT_DONE or, with a message
 * if loud, EXIT_USAGE.
 */
int arguments_read(const char *program, const argument *const *tables, void *settings,
                   words *operands, int argc, const char *const *argv, bool loud);

/* Print "program: --name expects EXPECTED, not 'VALUE'"; EXIT_USAGE. */
int arguments_expected(const char *program, const char *name, const char *expected,
                       const char *value);

/* Explain the options. */
void arguments_help(FILE *file, const argument *const *tables);

#endif
