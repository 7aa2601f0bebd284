/* SPDX-License-Identifier: MIT */
/*
 * truckride-study-mpi: the same study on the ranks of MPI. Rank 0 hands out chunks of
 * cases and alone writes journal and table; the others ask for work, so that slow
 * machines and slow cases hold nobody up. A single rank works by itself.
 */
#include "job.h"

#include <mpi.h>

#include <stdio.h>
#include <stdlib.h>

enum { TAG_RESULT = 1, TAG_WORK = 2 };

/* A result travels as doubles: number of the case, status, outputs. */
static int width(const job *j)
{
    return 2 + trk_study_count(j->study, TRK_STUDY_OUTPUT);
}

static int chunk_of(const job *j)
{
    return j->run.chunk > 0 ? j->run.chunk : 16 * j->run.threads;
}

/* The next cases that are not finished, from *next on. */
static int take_cases(const job *j, int64_t *next, int64_t *numbers)
{
    const int64_t cases = trk_study_cases(j->study);
    int count = 0;
    for (; *next < cases && count < chunk_of(j); *next += j->run.shards)
        if (!trk_study_is_finished(j->study, *next))
            numbers[count++] = *next;
    return count;
}

static trk_status take_results(job *j, const double *results, int count)
{
    trk_status status = TRK_OK;
    for (int k = 0; k < count && status == TRK_OK; k++) {
        const double *r = results + (size_t)k * (size_t)width(j);
        status = trk_study_set_outputs(j->study, (int64_t)r[0], (trk_status)r[1], r + 2);
    }
    return status;
}

/* Rank 0: an empty message asks for work, an empty one ends a worker. */
static trk_status coordinate(job *j, int ranks)
{
    const size_t room = (size_t)chunk_of(j);
    double *results = malloc(room * (size_t)width(j) * sizeof *results);
    int64_t *numbers = malloc(room * sizeof *numbers);
    int64_t next = j->run.shard - 1;
    trk_status status = results && numbers ? TRK_OK : TRK_E_MEMORY;
    for (int working = ranks - 1; working > 0;) {
        MPI_Status from;
        int values = 0;
        MPI_Recv(results, results ? (int)room * width(j) : 0, MPI_DOUBLE, MPI_ANY_SOURCE,
                 TAG_RESULT, MPI_COMM_WORLD, &from);
        MPI_Get_count(&from, MPI_DOUBLE, &values);
        if (status == TRK_OK)
            status = take_results(j, results, values / width(j));
        if (status == TRK_OK && job_progress(j, (double)trk_study_finished(j->study) /
                                                    (double)trk_study_cases(j->study)))
            status = TRK_E_CANCELLED;
        const int count = status == TRK_OK ? take_cases(j, &next, numbers) : 0;
        MPI_Send(numbers, count, MPI_INT64_T, from.MPI_SOURCE, TAG_WORK, MPI_COMM_WORLD);
        working -= count == 0;
    }
    free(results);
    free(numbers);
    return status;
}

/* The other ranks. A failure that is none of a single case ends all of them. */
static trk_status serve(job *j)
{
    const size_t room = (size_t)chunk_of(j);
    double *results = malloc(room * (size_t)width(j) * sizeof *results);
    int64_t *numbers = malloc(room * sizeof *numbers);
    trk_status status = results && numbers ? TRK_OK : TRK_E_MEMORY;
    for (int count = 0; status == TRK_OK;) {
        MPI_Status from;
        MPI_Send(results, count * width(j), MPI_DOUBLE, 0, TAG_RESULT, MPI_COMM_WORLD);
        MPI_Recv(numbers, (int)room, MPI_INT64_T, 0, TAG_WORK, MPI_COMM_WORLD, &from);
        MPI_Get_count(&from, MPI_INT64_T, &count);
        if (count == 0)
            break;
        status = trk_study_run_cases(j->study, count, numbers, &j->run, NULL, NULL);
        for (int k = 0; k < count && status == TRK_OK; k++) {
            double *r = results + (size_t)k * (size_t)width(j);
            trk_status outcome;
            status = trk_study_get_outputs(j->study, numbers[k], r + 2, &outcome);
            r[0] = (double)numbers[k];
            r[1] = (double)outcome;
        }
    }
    free(results);
    free(numbers);
    return status;
}

/* All ranks must have read the same study: files may differ between machines. */
static trk_status compare_studies(job *j, bool *out_same)
{
    int64_t own, first;
    trk_status status = trk_study_get_fingerprint(j->study, &own);
    if (status != TRK_OK)
        return status;
    first = own;
    MPI_Bcast(&first, 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
    *out_same = first == own;
    return TRK_OK;
}

static int work(job *j, int rank, int ranks)
{
    bool same = false;
    trk_status status = compare_studies(j, &same);
    if (status == TRK_OK && !same) {
        fprintf(stderr, "%s: rank %d has another study than rank 0\n", j->program, rank);
        MPI_Abort(MPI_COMM_WORLD, JOB_FAILED);
    }
    if (status == TRK_OK && rank > 0)
        status = serve(j);
    else if (status == TRK_OK && j->journal)
        status = trk_study_open_journal(j->study, j->journal);
    if (status != TRK_OK) { /* the others wait for this rank */
        job_complain(j, status);
        MPI_Abort(MPI_COMM_WORLD, JOB_FAILED);
    }
    if (rank > 0)
        return JOB_DONE;
    status = ranks > 1 ? coordinate(j, ranks) : trk_study_run(j->study, &j->run, job_progress, j);
    return job_finish(j, status);
}

int main(int argc, char **argv)
{
    static job j = {.program = "truckride-study-mpi"};
    int rank, ranks;
    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks);
    int code = job_open(&j, argc - 1, argv + 1, rank == 0);
    if (code == JOB_DONE && j.merge)
        code = job_usage(&j, "merging needs no MPI: use truckride-study", "merge");
    else if (code == JOB_DONE && (j.help || j.list)) {
        if (rank == 0 && j.help)
            job_help(&j);
        else if (rank == 0)
            job_list(&j);
    } else if (code == JOB_DONE) {
        code = work(&j, rank, ranks);
    }
    job_close(&j);
    MPI_Finalize();
    return code;
}
