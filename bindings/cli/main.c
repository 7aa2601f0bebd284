/* SPDX-License-Identifier: MIT */
/* truckride: the subcommands. */
#define _GNU_SOURCE /* RTLD_DEFAULT */
#include "common/text.h"
#include "help.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

extern const command check_command, modes_command, simulate_command, psd_command, frf_command,
    calibrate_command, export_command, study_command;

const command *const commands[] = {&check_command, &modes_command,  &simulate_command,
                                   &psd_command,   &frf_command,    &calibrate_command,
                                   &study_command, &export_command, NULL};

static const command *find(const char *name)
{
    for (const command *const *c = commands; *c; c++)
        if (strcmp((*c)->name, name) == 0)
            return *c;
    return NULL;
}

static int unknown(const char *name)
{
    const char *names[sizeof commands / sizeof *commands];
    int count = 0;
    for (const command *const *c = commands; *c; c++)
        names[count++] = (*c)->name;
    names[count] = NULL;
    const char *nearest = text_nearest(names, name);
    fprintf(stderr, "truckride: there is no %s '%s'", *name == '-' ? "option" : "subcommand", name);
    if (nearest && *name != '-')
        fprintf(stderr, "; did you mean '%s'?", nearest);
    fputs(" (see truckride --help)\n", stderr);
    return EXIT_USAGE;
}

static int print_version(void)
{
    static const char *const names[] = {"CHOLMOD", "LAPACK", "NLopt", "JSON", "ARPACK"};
    bool none = true;
    printf("truckride %s, with", trk_version_text());
    for (int32_t k = 0; k < 5; k++) {
        if (!trk_has_feature(TRK_FEATURE_CHOLMOD + k))
            continue;
        printf(" %s", names[k]);
        none = false;
    }
    puts(none ? " none of its optional libraries" : "");
    return EXIT_DONE;
}

static int explain(int argc, char **argv)
{
    if (argc > 1)
        return fputs("truckride: help explains one subcommand at a time\n", stderr), EXIT_USAGE;
    if (argc == 1 && strcmp(argv[0], "--manual") == 0)
        return help_manual(stdout), EXIT_DONE;
    const command *c = argc > 0 ? find(argv[0]) : NULL;
    if (argc > 0 && !c)
        return unknown(argv[0]);
    c ? help_command(stdout, c) : help_all(stdout);
    return EXIT_DONE;
}

static int run(int argc, char **argv)
{
    if (argc == 0)
        return help_all(stderr), EXIT_USAGE;
    if (strcmp(argv[0], "help") == 0 || strcmp(argv[0], "--help") == 0 ||
        strcmp(argv[0], "-h") == 0)
        return explain(argc - 1, argv + 1);
    if (strcmp(argv[0], "--version") == 0 || strcmp(argv[0], "version") == 0)
        return print_version();
    const command *c = find(argv[0]);
    if (!c)
        return unknown(argv[0]);
    session s = {.command = c};
    snprintf(s.program, sizeof s.program, "truckride %s", c->name);
    return c->run(&s, argc - 1, argv + 1);
}

/* OpenBLAS lets a thread on each core spin for matrices that one core is done with sooner. */
static void use_one_blas_thread(void)
{
    void (*set_threads)(int);
    *(void **)&set_threads = dlsym(RTLD_DEFAULT, "openblas_set_num_threads");
    if (set_threads && !getenv("OPENBLAS_NUM_THREADS") && !getenv("OMP_NUM_THREADS"))
        set_threads(1);
}

int main(int argc, char **argv)
{
    use_one_blas_thread();
    const int code = run(argc - 1, argv + 1);
    if (fflush(stdout) == 0 && !ferror(stdout))
        return code;
    if (code == EXIT_DONE) /* help, which nobody could read */
        fputs("truckride: standard output cannot be written\n", stderr);
    return code == EXIT_DONE ? EXIT_FAILED : code;
}
