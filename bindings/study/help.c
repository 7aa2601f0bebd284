/* SPDX-License-Identifier: MIT */
/* What the command says about itself and about a vehicle. */
#include "words.h"

#include <stdio.h>

const char job_about[] =
    "Vary parameters of a vehicle, drive it over roads, and write a table of what its\n"
    "sensors felt. With the same options the table is the same, whether it comes from one\n"
    "run, from shards, from MPI ranks or from an interrupted run. @FILE holds options, one a\n"
    "line, with their values.\n";

static const char examples[] =
    "Examples:\n"
    "  %s --vary 'tires=stiffness:*_tire:0.8..1.2' \\\n"
    "      --vary 'dampers=damping:*_damper:0.5..2:log' \\\n"
    "      --output 'cab=rms:cab_front_left_z' --cases 50 --settle 1 --csv study.csv\n"
    "  %s @study.txt --journal study.journal --threads 4 --csv study.csv\n";

void job_help(const job *j)
{
    const char *p = j->program, *model = j->subcommand ? "[MODEL] " : "";
    printf("Usage: %s [@FILE] %sOPTION...\n       %s merge [@FILE] OPTION... JOURNAL...\n\n", p,
           model, p);
    fputs(job_about, stdout);
    arguments_help(stdout, job_tables);
    printf("\n%s\n", road_help);
    puts("Exit codes: 0 done (cases that failed stand in the table with their status), 1 failed,\n"
         "2 wrong usage, 130 interrupted; finished cases are in the journal.\n");
    printf(examples, p, p);
}

static void list(const trk_spec *spec, trk_part part, const char *heading)
{
    printf("%s\n", heading);
    for (int32_t k = 1; k <= trk_spec_count(spec, part); k++)
        printf("  %s\n", trk_spec_part_name(spec, part, k));
}

void job_list(const job *j)
{
    list(j->spec, TRK_PART_LINK, "Links (stiffness, damping):");
    list(j->spec, TRK_PART_BODY, "Bodies (mass, inertia, mass_inertia):");
    list(j->spec, TRK_PART_SENSOR, "Sensors:");
}
