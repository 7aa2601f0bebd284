/* SPDX-License-Identifier: MIT */
/* truckride-study: a parameter study from the command line. */
#include "job.h"

int main(int argc, char **argv)
{
    static job j;
    int code = job_open(&j, argc, argv, true);
    if (code == JOB_DONE && j.help) {
        job_help(j.program);
    } else if (code == JOB_DONE && j.list) {
        job_list(&j);
    } else if (code == JOB_DONE) {
        trk_status status = j.journal ? trk_study_open_journal(j.study, j.journal) : TRK_OK;
        for (int k = 0; k < j.inputs && status == TRK_OK; k++)
            status = trk_study_load(j.study, j.input[k]);
        if (status != TRK_OK) { /* an earlier table stays as it is */
            code = job_complain(&j, status);
        } else {
            if (!j.merge)
                status = trk_study_run(j.study, &j.run, job_progress, &j);
            code = job_finish(&j, status);
        }
    }
    job_close(&j);
    return code;
}
