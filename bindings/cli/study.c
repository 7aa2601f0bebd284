/* SPDX-License-Identifier: MIT */
/* truckride study: truckride-study (bindings/study), with MODEL as its first word. */
#include "session.h"
#include "words.h"

static int run(session *s, int argc, char **argv)
{
    (void)s;
    return job_main("truckride study", true, argc, argv);
}

extern const command study_command;
const command study_command = {
    "study",
    "vary parameters, drive over roads, tabulate the results",
    "[@FILE] [MODEL] OPTION...",
    job_about,
    "  truckride study truck.json --vary 'tires=stiffness:*_tire:0.8..1.2' \\\n"
    "      --output 'cab=rms:cab_front_left_z' --cases 50 --settle 1 -o study.csv\n"
    "  truckride study @study.txt --journal study.journal --threads 4 -o study.csv\n",
    job_tables,
    run,
    true,
};
