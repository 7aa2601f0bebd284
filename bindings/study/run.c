/* SPDX-License-Identifier: MIT */
/* A whole study in one process. */
#include "job.h"

#include <stdlib.h>

static int run(job *j)
{
    trk_status status = j->journal ? trk_study_open_journal(j->study, j->journal) : TRK_OK;
    for (int k = 0; k < j->inputs.count && status == TRK_OK; k++)
        status = trk_study_load(j->study, j->inputs.word[k]);
    if (status != TRK_OK) /* an earlier table stays as it is */
        return job_complain(j, status);
    if (!j->merge)
        status = trk_study_run(j->study, &j->run, job_progress, j);
    return job_finish(j, status);
}

int job_main(const char *program, bool subcommand, int argc, char **argv)
{
    job j = {.program = program, .subcommand = subcommand};
    int code = job_open(&j, argc, argv, true);
    if (code == JOB_DONE && j.help)
        job_help(&j);
    else if (code == JOB_DONE && j.list)
        job_list(&j);
    else if (code == JOB_DONE)
        code = run(&j);
    job_close(&j);
    return code;
}
