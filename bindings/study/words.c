/* SPDX-License-Identifier: MIT */
/* Command line of a study, and files that hold more of it. */
#define _POSIX_C_SOURCE 200809L
#include "words.h"
#include "common/text.h"
#include "common/vehicle.h"

#include <errno.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define AT(field) offsetof(job, field)

static const argument what[] = {
    {.help = "What the study is (the same in every shard and in merge)"},
    {"vehicle", 0, ARGUMENT_TEXT, AT(vehicle), "NAME",
     "thesis_quarter, reference_front, reference_rear, reference_half,\n"
     "reference_truck (default), or the path of a model file",
     0},
    {"variant", 0, ARGUMENT_CHOICE, AT(variant), "linear|thesis|nonlinear",
     "of a ready-made vehicle; thesis (default): dampers of the thesis", TRK_VARIANT_LINEAR},
    {"gravity", 0, ARGUMENT_SWITCH, AT(gravity), NULL,
     "compile with weight, start from static equilibrium: for tires that lift off", 0},
    {"vary", 0, ARGUMENT_WORDS, AT(vary), "NAME=FIELD:PATTERN[,PATTERN...]:LOW..HIGH[:SETTING...]",
     "a parameter: a factor on stiffness, damping, mass, inertia, mass_inertia,\n"
     "friction, approach or bending of all links, bodies or beams whose name\n"
     "matches ('*' is any text); even, or with log even in the logarithm, or\n"
     "normal=MEAN,DEVIATION; also value (no factor), levels=N, power=P",
     0},
    {"road", 0, ARGUMENT_WORDS, AT(roads_asked), "[NAME=]KIND[:SETTING=VALUE...]",
     "a road, see below; several are all driven by every point; default: sweep", 0},
    {"output", 0, ARGUMENT_WORDS, AT(outputs_asked), "NAME=KIND:SENSOR[:LOW..HIGH]",
     "max, min, peak, mean, rms, std; of the PSD between LOW and HIGH Hz: band\n"
     "(RMS), psd_peak (its frequency), psd_height; RMS of the weighted PSD:\n"
     "weighted:SENSOR:HZ/WEIGHT,HZ/WEIGHT,...",
     0},
    {"design", 0, ARGUMENT_CHOICE, AT(study_options.design), "factorial|lhs|monte_carlo",
     "lhs is the default: Latin hypercube", TRK_DESIGN_FACTORIAL},
    {"cases", 0, ARGUMENT_WHOLE, AT(study_options.points), "N",
     "points of the design; a factorial counts its levels; default 100", 0},
    {"seed", 0, ARGUMENT_WHOLE, AT(study_options.seed), "N", "of the random designs; default 1", 0},
    {"duration", 0, ARGUMENT_NUMBER, AT(study_options.duration), "S", "of a run; default 10", 0},
    {"settle", 0, ARGUMENT_NUMBER, AT(study_options.settle), "S",
     "at its beginning that no output looks at; default 0", 0},
    {"step", 0, ARGUMENT_NUMBER, AT(newmark.step), "S", "of the integration; default 0.001", 0},
    {"segment", 0, ARGUMENT_WHOLE, AT(spectrum.segment_length), "N",
     "samples of a PSD segment; default 4096", 0},
    {"overlap", 0, ARGUMENT_NUMBER, AT(spectrum.overlap), "X",
     "part that segments share; default 0.5", 0},
    {0}};

static const argument how[] = {
    {.help = "How it is run"},
    {"threads", 0, ARGUMENT_COUNT, AT(run.threads), "N", "default 1", 0},
    {"chunk", 0, ARGUMENT_COUNT, AT(run.chunk), "N", "cases computed together; default 16 a thread",
     0},
    {"shard", 0, ARGUMENT_TEXT, AT(shard), "I/N", "only each Nth case, from the Ith on", 0},
    {"journal", 0, ARGUMENT_TEXT, AT(journal), "FILE",
     "keep finished cases here; a second run goes on where it ended", 0},
    {"csv", 'o', ARGUMENT_TEXT, AT(csv), "FILE", "write the table here; - is the standard output",
     0},
    {"quiet", 'q', ARGUMENT_SWITCH, AT(quiet), NULL, "no progress and no summary", 0},
    {"list", 0, ARGUMENT_SWITCH, AT(list), NULL,
     "links, bodies and sensors of the vehicle, and nothing else", 0},
    {"help", 'h', ARGUMENT_SWITCH, AT(help), NULL, "this text", 0},
    {0}};

const argument *const job_tables[] = {what, how, NULL};

/* A whole text file of less than 64 kB, without a 0; NULL with errno set. */
static char *read_text(const char *path)
{
    enum { ROOM = 1 << 16 };
    FILE *file = fopen(path, "rb");
    char *text = file ? malloc(ROOM) : NULL;
    if (text) {
        errno = 0;
        const size_t size = fread(text, 1, ROOM, file);
        if (ferror(file) || size == ROOM || memchr(text, 0, size)) {
            errno = errno ? errno : size == ROOM ? EFBIG : EILSEQ;
            free(text);
            text = NULL;
        } else {
            text[size] = 0;
        }
    }
    if (file)
        fclose(file);
    return text;
}

/* Lines of a file: an option and, behind a blank, its value; # begins a comment. */
static int add_file(job *j, words *all, const char *path)
{
    if (j->files == (int)(sizeof j->file_text / sizeof *j->file_text))
        return job_usage(j, "too many files, from", path);
    char *text = read_text(path);
    if (!text) {
        fprintf(stderr, "%s: %s: %s\n", j->program, path, strerror(errno));
        return JOB_FAILED;
    }
    j->file_text[j->files++] = text;
    char *place, *line = strtok_r(text, "\r\n", &place);
    for (; line; line = strtok_r(NULL, "\r\n", &place)) {
        line += strspn(line, " \t");
        size_t length = strlen(line);
        while (length > 0 && strchr(" \t", line[length - 1]))
            line[--length] = 0;
        if (!*line || *line == '#')
            continue;
        char *value = line + strcspn(line, " \t");
        if (*value) {
            *value++ = 0;
            value += strspn(value, " \t");
        }
        words_add(all, line);
        if (*value)
            words_add(all, value);
    }
    return JOB_DONE;
}

static int collect(job *j, words *all, int argc, char **argv)
{
    int code = JOB_DONE;
    for (int k = 0; k < argc && code == JOB_DONE; k++)
        if (argv[k][0] == '@')
            code = add_file(j, all, argv[k] + 1);
        else
            words_add(all, argv[k]);
    return code;
}

static bool read_shard(const char *text, trk_study_run_options *run)
{
    char *copy = text_copy(text), *last = copy;
    int64_t shard = 0, shards = 0;
    const bool valid = text_whole(text_field(&last, '/'), &shard) && text_whole(last, &shards) &&
                       shard >= 1 && shard <= shards && shards <= INT32_MAX;
    run->shard = (int32_t)shard;
    run->shards = (int32_t)shards;
    free(copy);
    return valid;
}

/* "merge" and its journals, or the vehicle of a subcommand. */
static int read_operands(job *j)
{
    const words *o = &j->operands;
    j->merge = o->count > 0 && strcmp(o->word[0], "merge") == 0;
    int used = j->merge;
    if (j->subcommand && !j->merge && o->count > 0)
        j->vehicle = o->word[used++];
    if (!j->merge && o->count > used)
        return job_usage(j, "unexpected word", o->word[used]);
    for (; used < o->count; used++)
        words_add(&j->inputs, o->word[used]);
    return JOB_DONE;
}

/* A ready-made vehicle, or clearly no name of one. */
static bool names_vehicle(const char *text)
{
    return text_index(vehicle_names, text) >= 0 || strcspn(text, "./:") < strlen(text) ||
           strcmp(text, "-") == 0;
}

int job_read_words(job *j, int argc, char **argv, bool loud)
{
    words all = {0};
    int code = collect(j, &all, argc, argv);
    if (code == JOB_DONE)
        code = arguments_read(j->program, job_tables, j, &j->operands, all.count, all.word, loud);
    if (code == JOB_DONE)
        code = read_operands(j);
    if (code == JOB_DONE && j->shard && !read_shard(j->shard, &j->run))
        code = arguments_expected(j->program, "--shard", "I/N with 1 <= I <= N", j->shard);
    if (code == JOB_DONE && !j->subcommand && !names_vehicle(j->vehicle))
        code = arguments_expected(j->program, "--vehicle",
                                  "thesis_quarter, reference_front, reference_rear, "
                                  "reference_half, reference_truck or the path of a model file",
                                  j->vehicle);
    words_free(&all);
    return code;
}
