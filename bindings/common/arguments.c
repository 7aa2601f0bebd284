/* SPDX-License-Identifier: MIT */
/* Reading the options of a command. */
#include "common/arguments.h"
#include "common/text.h"

#include <stdlib.h>
#include <string.h>

void words_add(words *list, const char *word)
{
    if (list->count == list->room) {
        list->room = list->room ? 2 * list->room : 16;
        const char **larger = need((size_t)list->room, sizeof *larger);
        if (list->count > 0)
            memcpy(larger, list->word, (size_t)list->count * sizeof *larger);
        free(list->word);
        list->word = larger;
    }
    list->word[list->count++] = word;
}

void words_free(words *list)
{
    free(list->word);
    *list = (words){0};
}

int arguments_expected(const char *program, const char *name, const char *expected,
                       const char *value)
{
    fprintf(stderr, "%s: %s expects %s, not '%s' (see %s --help)\n", program, name, expected, value,
            program);
    return EXIT_USAGE;
}

static bool choose(const argument *a, const char *value, int32_t *out)
{
    char *copy = text_copy(a->value), *rest = copy;
    const char *choice;
    int32_t k = a->first;
    while ((choice = text_field(&rest, '|')) && strcmp(choice, value) != 0)
        k++;
    *out = choice ? k : *out;
    free(copy);
    return choice != NULL;
}

/* What was expected instead of the value; NULL if it was stored. */
static const char *store(const argument *a, void *settings, const char *value)
{
    void *place = (char *)settings + a->place;
    int64_t whole;
    double number;
    switch (a->kind) {
    case ARGUMENT_SWITCH: *(bool *)place = true; return NULL;
    case ARGUMENT_TEXT: *(const char **)place = value; return NULL;
    case ARGUMENT_WORDS: words_add(place, value); return NULL;
    case ARGUMENT_NUMBER:
        if (!text_number(value, &number))
            return "a number";
        *(double *)place = number;
        return NULL;
    case ARGUMENT_WHOLE:
        if (!text_whole(value, &whole))
            return "a whole number";
        *(int64_t *)place = whole;
        return NULL;
    case ARGUMENT_COUNT:
        if (!text_whole(value, &whole) || whole < 0 || whole > INT32_MAX)
            return "a whole number from 0 to 2147483647";
        *(int32_t *)place = (int32_t)whole;
        return NULL;
    case ARGUMENT_CHOICE: return choose(a, value, place) ? NULL : a->value;
    }
    return "nothing";
}

/* The option of a word, "--name", "--name=..." or "-n..."; NULL if there is none. */
static const argument *find(const argument *const *tables, const char *word)
{
    const bool is_long = word[1] == '-';
    const size_t length = strcspn(word, "=") - 2;
    for (; *tables; tables++)
        for (const argument *a = *tables; a->name || a->help; a++)
            if (a->name && (is_long ? strncmp(a->name, word + 2, length) == 0 && !a->name[length]
                                    : a->letter && a->letter == word[1]))
                return a;
    return NULL;
}

static int unknown(const char *program, const argument *const *tables, const char *word, bool loud)
{
    words names = {0};
    char *name = text_copy(word + strspn(word, "-"));
    name[strcspn(name, "=")] = 0;
    for (; *tables; tables++)
        for (const argument *a = *tables; a->name || a->help; a++)
            if (a->name)
                words_add(&names, a->name);
    words_add(&names, NULL);
    const char *nearest = text_nearest(names.word, name);
    if (loud && nearest)
        fprintf(stderr, "%s: unknown option '%s'; did you mean '--%s'? (see %s --help)\n", program,
                word, nearest, program);
    else if (loud)
        fprintf(stderr, "%s: unknown option '%s' (see %s --help)\n", program, word, program);
    words_free(&names);
    free(name);
    return EXIT_USAGE;
}

/* One option and its value; `next` is the word behind, *out_used says if it was the value. */
static int read_one(const char *program, const argument *const *tables, void *settings,
                    const char *word, const char *next, bool loud, bool *out_used)
{
    const argument *a = find(tables, word);
    const char *value = word[1] == '-' ? strchr(word, '=') : word[1] && word[2] ? word + 1 : NULL;
    value = value ? value + 1 : NULL;
    *out_used = false;
    if (!a || (a->kind == ARGUMENT_SWITCH && value && word[1] != '-'))
        return unknown(program, tables, word, loud);
    const char *wrong = NULL, *expected = NULL;
    if (a->kind == ARGUMENT_SWITCH) {
        expected = value ? "no value" : NULL;
        wrong = value;
    } else if (!value) {
        *out_used = true;
        value = next;
        wrong = !next || strncmp(next, "--", 2) == 0 ? "" : NULL;
        expected = wrong ? "a value behind it" : NULL;
    }
    if (!expected) {
        expected = store(a, settings, value);
        wrong = value;
    }
    if (!expected)
        return EXIT_DONE;
    char name[64];
    snprintf(name, sizeof name, "--%s", a->name);
    if (loud && *wrong)
        arguments_expected(program, name, expected, wrong);
    else if (loud)
        fprintf(stderr, "%s: %s expects %s (see %s --help)\n", program, name, expected, program);
    return EXIT_USAGE;
}

int arguments_read(const char *program, const argument *const *tables, void *settings,
                   words *operands, int argc, const char *const *argv, bool loud)
{
    int code = EXIT_DONE;
    for (int k = 0; k < argc && code == EXIT_DONE; k++) {
        bool used = false;
        if (strcmp(argv[k], "--") == 0) {
            while (++k < argc)
                words_add(operands, argv[k]);
        } else if (argv[k][0] != '-' || !argv[k][1]) {
            words_add(operands, argv[k]);
        } else {
            code = read_one(program, tables, settings, argv[k], k + 1 < argc ? argv[k + 1] : NULL,
                            loud, &used);
        }
        k += used;
    }
    return code;
}

void arguments_help(FILE *file, const argument *const *tables)
{
    enum { INDENT = 24 };
    for (; *tables; tables++)
        for (const argument *a = *tables; a->name || a->help; a++) {
            if (!a->name) {
                fprintf(file, "\n%s:\n", a->help);
                continue;
            }
            char left[160], letter[] = "-x, ";
            letter[1] = a->letter;
            const int length = snprintf(left, sizeof left, "  %s--%s%s%s", a->letter ? letter : "",
                                        a->name, a->kind == ARGUMENT_SWITCH ? "" : " ",
                                        a->kind == ARGUMENT_SWITCH ? "" : a->value);
            fprintf(file, "%s%*s", left, length < INDENT - 1 ? INDENT - length : 0, "");
            if (length >= INDENT - 1)
                fprintf(file, "\n%*s", INDENT, "");
            for (const char *c = a->help; *c; c++)
                *c == '\n' ? fprintf(file, "\n%*s", INDENT, "") : fputc(*c, file);
            fputc('\n', file);
        }
}
