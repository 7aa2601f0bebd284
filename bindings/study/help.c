/* SPDX-License-Identifier: MIT */
/* What the command says about itself and about a vehicle. */
#include "job.h"

#include <stdio.h>

void job_help(const char *program)
{
    printf("Usage: %s [@FILE] OPTION...\n"
           "       %s merge [@FILE] OPTION... JOURNAL...\n"
           "Vary parameters of a built-in vehicle, drive it over roads, and write a table of\n"
           "what its sensors felt. With the same options the table is the same, whether it\n"
           "comes from one run, from shards, from MPI ranks or from an interrupted run.\n\n",
           program, program);
    puts(
        "What the study is (the same in every shard and in merge; @FILE holds one option a line):\n"
        "  --vehicle NAME     thesis_quarter, reference_front, reference_rear, reference_half,\n"
        "                     reference_truck (default)\n"
        "  --variant NAME     linear, thesis (default: dampers of the thesis), nonlinear\n"
        "  --vary NAME=FIELD:PATTERN[,PATTERN...]:LOW..HIGH[:log][:normal=MEAN,DEVIATION]\n"
        "                     [:value][:levels=N][:power=P]\n"
        "                     a parameter: a factor on stiffness, damping, mass, inertia or\n"
        "                     mass_inertia of all links or bodies whose name matches ('*' is\n"
        "                     any text); even, or log: even in the logarithm, or normal\n"
        "  --road [NAME=]KIND[:SETTING=NUMBER...]\n"
        "                     sweep (from, to [Hz], duration [s], amplitude [m], exponent),\n"
        "                     sine (frequency [Hz], amplitude [m]) or step (start, length [s],\n"
        "                     height [m]) under all wheels, or iso (class=A to H, speed [km/h],\n"
        "                     seed, waviness): a random road of ISO 8608 under both tracks;\n"
        "                     several are all driven by every point; default: sweep\n"
        "  --output NAME=KIND:SENSOR[:LOW..HIGH]\n"
        "                     max, min, peak, mean, rms, std; of the PSD between LOW and HIGH Hz:\n"
        "                     band (RMS), psd_peak (its frequency), psd_height;\n"
        "                     weighted:SENSOR:HZ/WEIGHT,HZ/WEIGHT,... (RMS)\n"
        "  --design NAME      lhs (default: Latin hypercube), monte_carlo, factorial\n"
        "  --cases N          points of the design; a factorial counts its levels; default 100\n"
        "  --seed N           of the random designs; default 1\n"
        "  --duration S       of a run; default 10\n"
        "  --settle S         at its beginning that no output looks at; default 0\n"
        "  --step S           of the integration; default 0.001\n"
        "  --segment N, --overlap X   samples of a PSD segment, and the part they share;\n"
        "                     default 4096 and 0.5\n");
    puts("How it is run:\n"
         "  --threads N        default 1\n"
         "  --chunk N          cases computed together; default 16 a thread\n"
         "  --shard I/N        only each Nth case, from the Ith on\n"
         "  --journal FILE     keep finished cases here; a second run goes on where it ended\n"
         "  --csv FILE         write the table here; - is the standard output\n"
         "  --quiet            no progress and no summary\n"
         "  --list             links, bodies and sensors of the vehicle, and nothing else\n"
         "  --help\n\n"
         "Exit codes: 0 done (cases that failed stand in the table with their status), 1 failed,\n"
         "2 wrong usage, 130 interrupted; finished cases are in the journal.\n\n"
         "Example:\n"
         "  truckride-study --vary 'tires=stiffness:*_tire:0.8..1.2' \\\n"
         "      --vary 'dampers=damping:*_damper:0.5..2:log' \\\n"
         "      --output 'cab=rms:cab_front_left_z' --cases 50 --settle 1 --csv study.csv");
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
