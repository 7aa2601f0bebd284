/* SPDX-License-Identifier: MIT */
/* One table whatever happens: shards, threads, chunks, kills; and damaged journals. */
#define _POSIX_C_SOURCE 200809L
#include "cases.h"

#include <locale.h>
#include <signal.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { POINTS = 24 };
static const char reference[] = "study_reference.csv", table[] = "study_table.csv",
                  journal[] = "study.journal";

static study_fixture small(trk_context *context, double duration)
{
    study_fixture f = study_open(context, TRK_DESIGN_LATIN_HYPERCUBE, POINTS, duration);
    assert_ok(context, f.status);
    return f;
}

static void write_reference(trk_context *context, double duration)
{
    study_fixture f = small(context, duration);
    assert_ok(context, trk_study_run(f.study, NULL, NULL, NULL));
    assert_ok(context, trk_study_write_csv(f.study, reference));
    study_close(&f);
}

static void threads_and_chunks_make_no_difference(void **state)
{
    write_reference(*state, 1);
    for (int32_t threads = 1; threads <= 3; threads++)
        for (int32_t chunk = 0; chunk < 12; chunk += 5) {
            study_fixture f = small(*state, 1);
            trk_study_run_options o;
            trk_study_run_options_init(&o, sizeof o);
            o.threads = threads;
            o.chunk = chunk;
            assert_ok(*state, trk_study_run(f.study, &o, NULL, NULL));
            assert_ok(*state, trk_study_write_csv(f.study, table));
            study_same_files(table, reference);
            study_close(&f);
        }
}

static void shards_in_any_order_make_no_difference(void **state)
{
    enum { SHARDS = 5 };
    static const int order[SHARDS] = {3, 1, 5, 2, 4};
    char path[SHARDS][32];
    write_reference(*state, 1);
    for (int k = 0; k < SHARDS; k++) {
        study_fixture f = small(*state, 1);
        trk_study_run_options o;
        trk_study_run_options_init(&o, sizeof o);
        o.shard = k + 1;
        o.shards = SHARDS;
        snprintf(path[k], sizeof path[k], "study_shard_%d.journal", k + 1);
        remove(path[k]);
        assert_ok(*state, trk_study_open_journal(f.study, path[k]));
        assert_ok(*state, trk_study_run(f.study, &o, NULL, NULL));
        for (int64_t c = 0; c < trk_study_cases(f.study); c++)
            assert_int_equal(trk_study_is_finished(f.study, c), c % SHARDS == k);
        assert_ok(*state, trk_study_close_journal(f.study));
        study_close(&f);
    }
    study_fixture f = small(*state, 1);
    remove(journal);
    assert_ok(*state, trk_study_open_journal(f.study, journal));
    for (int k = 0; k < SHARDS; k++)
        assert_ok(*state, trk_study_load(f.study, path[order[k] - 1]));
    assert_ok(*state, trk_study_load(f.study, path[0])); /* twice does no harm */
    assert_ok(*state, trk_study_write_csv(f.study, table));
    study_same_files(table, reference);
    study_close(&f);
    /* What was loaded went into the open journal. */
    f = small(*state, 1);
    assert_ok(*state, trk_study_load(f.study, journal));
    assert_ok(*state, trk_study_write_csv(f.study, table));
    study_same_files(table, reference);
    study_close(&f);
}

static int32_t die_early(void *user, double fraction)
{
    (void)user;
    return fraction > 0.3 ? raise(SIGKILL) : 0;
}

/* A child that runs the study with its journal to the end, unless it is killed. */
static int run_child(trk_progress progress)
{
    trk_context *context;
    if (trk_context_create(NULL, NULL, &context) != TRK_OK)
        return 1;
    study_fixture f = study_open(context, TRK_DESIGN_LATIN_HYPERCUBE, POINTS, 8);
    trk_study_run_options o;
    trk_study_run_options_init(&o, sizeof o);
    o.chunk = 3;
    STUDY_TRY(&f, trk_study_open_journal(f.study, journal));
    STUDY_TRY(&f, trk_study_run(f.study, &o, progress, NULL));
    return f.status;
}

static void a_killed_run_resumes_to_the_same_table(void **state)
{
    write_reference(*state, 8);
    remove(journal);
    uint32_t noise = (uint32_t)time(NULL);
    int killed = 0;
    for (int attempt = 0; attempt < 40; attempt++) {
        pid_t child = fork();
        assert_true(child >= 0);
        if (child == 0)
            _exit(run_child(attempt == 0 ? die_early : NULL)); /* so that one is killed for sure */
        noise = noise * 1664525u + 1013904223u;
        struct timespec pause = {0, (long)(3000000 + (noise >> 8) % 30000000)};
        if (attempt > 0) {
            nanosleep(&pause, NULL);
            kill(child, SIGKILL);
        }
        int outcome;
        assert_int_equal(waitpid(child, &outcome, 0), child);
        if (WIFEXITED(outcome)) {
            assert_int_equal(WEXITSTATUS(outcome), 0);
            break;
        }
        killed++;
        if (attempt % 3 == 0) { /* a page that the system wrote by half */
            FILE *file = fopen(journal, "ab");
            fputs("17 0 0.5", file);
            fclose(file);
        }
    }
    assert_true(killed > 0);
    study_fixture f = small(*state, 8);
    assert_ok(*state, trk_study_open_journal(f.study, journal));
    assert_ok(*state, trk_study_run(f.study, NULL, NULL, NULL));
    assert_ok(*state, trk_study_write_csv(f.study, table));
    study_same_files(table, reference);
    study_close(&f);
}

static int32_t stop_at_half(void *user, double fraction)
{
    (void)user;
    return fraction > 0.5;
}

static void a_cancelled_run_keeps_its_cases_and_goes_on(void **state)
{
    write_reference(*state, 1);
    study_fixture f = small(*state, 1);
    trk_study_run_options o;
    trk_study_run_options_init(&o, sizeof o);
    o.chunk = 4;
    assert_status(*state, trk_study_run(f.study, &o, stop_at_half, NULL), TRK_E_CANCELLED);
    assert_in_range(trk_study_finished(f.study), POINTS - 4, 2 * POINTS - 1);
    assert_ok(*state, trk_study_run(f.study, &o, NULL, NULL));
    assert_ok(*state, trk_study_write_csv(f.study, table));
    study_same_files(table, reference);
    study_close(&f);
}

/* What a scheduler of the caller does: cases run in one study, handed to another. */
static void results_can_be_handed_over(void **state)
{
    write_reference(*state, 1);
    study_fixture worker = small(*state, 1), collector = small(*state, 1);
    remove(journal);
    assert_ok(*state, trk_study_open_journal(collector.study, journal));
    for (int64_t k = 2 * POINTS - 1; k >= 0; k--) {
        int64_t twice[2] = {k, k};
        double values[10];
        trk_status outcome;
        assert_ok(*state, trk_study_run_cases(worker.study, 2, twice, NULL, NULL, NULL));
        assert_int_equal(trk_study_get_outputs(worker.study, k, values, &outcome), TRK_OK);
        assert_ok(*state, trk_study_set_outputs(collector.study, k, outcome, values));
        assert_ok(*state, trk_study_set_outputs(collector.study, k, outcome, values));
        values[0] += 1;
        assert_status(*state, trk_study_set_outputs(collector.study, k, outcome, values),
                      TRK_E_ARGUMENT);
    }
    assert_ok(*state, trk_study_write_csv(collector.study, table));
    study_same_files(table, reference);
    study_close(&worker);
    study_close(&collector);
}

static void cases_that_fail_do_not_stop_the_others(void **state)
{
    for (int attempt = 0; attempt < 2; attempt++) {
        study_fixture f = study_open(*state, TRK_DESIGN_FACTORIAL, 0, 1);
        trk_study_parameter_options p;
        trk_study_parameter_options_init(&p, sizeof p);
        p.lower = 0; /* unsprung mass 0: the model cannot be compiled */
        p.upper = 1;
        p.levels = 2;
        assert_ok(*state, trk_study_add_parameter(f.study, "unsprung", &p, NULL));
        assert_ok(*state, trk_study_act_on(f.study, 3, TRK_FIELD_MASS, "unsprung", 1, NULL));
        trk_study_run_options o;
        trk_study_run_options_init(&o, sizeof o);
        o.chunk = attempt ? 1 : 0;
        assert_ok(*state, trk_study_run(f.study, &o, NULL, NULL));
        assert_int_equal(trk_study_finished(f.study), 24);
        for (int64_t k = 0; k < 24; k++) {
            double values[10];
            trk_status outcome;
            assert_int_equal(trk_study_get_outputs(f.study, k, values, &outcome), TRK_OK);
            assert_int_equal(outcome, k / 2 % 2 ? TRK_OK : TRK_E_MODEL);
            assert_int_equal(isnan(values[0]), outcome != TRK_OK);
        }
        assert_ok(*state, trk_study_write_csv(f.study, attempt ? table : reference));
        study_close(&f);
    }
    study_same_files(table, reference);
}

static void damage_is_cut_off_or_refused(void **state)
{
    write_reference(*state, 1);
    study_fixture f = small(*state, 1);
    remove(journal);
    assert_ok(*state, trk_study_open_journal(f.study, journal));
    assert_ok(*state, trk_study_run(f.study, NULL, NULL, NULL));
    study_close(&f);
    size_t size;
    char *good = study_read_file(journal, &size), *bad = malloc(size + 1);
    assert_non_null(good);
    const size_t header = (size_t)(strchr(good, '\n') - good) + 1;
    char *last = good + size - 1;
    while (last[-1] != '\n')
        last--;
    const size_t tail = (size_t)(last - good);
    uint32_t noise = 5;
    int repaired = 0, refused = 0;
    for (int k = 0; k < 240; k++) {
        noise = noise * 1664525u + 1013904223u;
        size_t place = (noise >> 4) % size, length = size;
        memcpy(bad, good, size);
        trk_status expected = place < header ? TRK_E_SYNTAX : TRK_OK;
        if (k % 3 == 0) {
            length = place; /* cut off: within the first line like a new file */
            expected = TRK_OK;
        } else if (k % 3 == 1) {
            bad[place] = (char)(bad[place] ^ (1 << (noise % 8)));
            expected = place >= tail ? TRK_OK : TRK_E_SYNTAX;
            if (place >= header - 1 && place == tail - 1)
                expected = TRK_OK; /* the last two lines became one */
        } else {                   /* zeros to the end, as after a power failure */
            memset(bad + place, 0, size - place);
        }
        study_write_file(journal, bad, length);
        f = small(*state, 1);
        assert_status(*state, trk_study_open_journal(f.study, journal), expected);
        if (expected == TRK_OK) {
            repaired++;
            assert_ok(*state, trk_study_run(f.study, NULL, NULL, NULL));
            assert_ok(*state, trk_study_write_csv(f.study, table));
            study_same_files(table, reference);
        } else {
            refused++;
            size_t now;
            char *left = study_read_file(journal, &now);
            assert_int_equal(now, length); /* nobody touched it */
            assert_memory_equal(left, bad, now);
            free(left);
        }
        study_close(&f);
    }
    assert_true(repaired > 60 && refused > 40);
    free(good);
    free(bad);
}

static void foreign_files_are_refused(void **state)
{
    study_fixture a = small(*state, 1), b = small(*state, 1.5);
    remove(journal);
    assert_ok(*state, trk_study_open_journal(a.study, journal));
    assert_status(*state, trk_study_open_journal(a.study, journal), TRK_E_ARGUMENT);
    assert_status(*state, trk_study_set_newmark(a.study, NULL), TRK_E_ARGUMENT);
    pid_t child = fork();
    if (child == 0) { /* locks do not pass on to a child */
        trk_context *context;
        if (trk_context_create(NULL, NULL, &context) != TRK_OK)
            _exit(1);
        study_fixture c = study_open(context, TRK_DESIGN_LATIN_HYPERCUBE, POINTS, 1);
        _exit(trk_study_open_journal(c.study, journal));
    }
    int outcome;
    assert_int_equal(waitpid(child, &outcome, 0), child);
    assert_true(WIFEXITED(outcome) && WEXITSTATUS(outcome) == TRK_E_FILE);
    assert_ok(*state, trk_study_close_journal(a.study));
    assert_status(*state, trk_study_open_journal(b.study, journal), TRK_E_ARGUMENT);
    assert_message(*state, "another study");
    assert_status(*state, trk_study_load(b.study, journal), TRK_E_ARGUMENT);
    study_write_file(journal, "precious data\nof somebody else\n", 31);
    assert_status(*state, trk_study_open_journal(a.study, journal), TRK_E_SYNTAX);
    study_write_file(journal, "precious data", 13);
    assert_status(*state, trk_study_open_journal(a.study, journal), TRK_E_SYNTAX);
    assert_status(*state, trk_study_load(a.study, "does/not/exist"), TRK_E_FILE);
    assert_status(*state, trk_study_open_journal(a.study, "does/not/exist"), TRK_E_FILE);
    assert_status(*state, trk_study_write_csv(a.study, "does/not/exist"), TRK_E_FILE);
    study_close(&a);
    study_close(&b);
}

/* A full disk: the run tells it, the results are there all the same. */
/* /dev/zero is one line without an end, a pipe may never send one. */
static void devices_are_no_journals(void **state)
{
    study_fixture f = small(*state, 1);
    assert_int_equal(trk_study_open_journal(f.study, "/dev/zero"), TRK_E_FILE);
    assert_non_null(strstr(trk_context_message(*state), "regular file"));
    assert_int_equal(trk_study_load(f.study, "/dev/zero"), TRK_E_SYNTAX);
    assert_non_null(strstr(trk_context_message(*state), "/dev/zero:1:"));
    study_close(&f);
}

static void a_journal_that_cannot_be_written_is_told(void **state)
{
    if (access("/dev/full", W_OK) != 0)
        skip();
    study_fixture f = small(*state, 1);
    assert_status(*state, trk_study_write_csv(f.study, "/dev/full"), TRK_E_FILE);
    study_close(&f);
}

static void a_longer_monte_carlo_study_goes_on_with_the_journal(void **state)
{
    study_fixture a = study_open(*state, TRK_DESIGN_MONTE_CARLO, 4, 1),
                  b = study_open(*state, TRK_DESIGN_MONTE_CARLO, 7, 1);
    remove(journal);
    assert_ok(*state, trk_study_open_journal(a.study, journal));
    assert_ok(*state, trk_study_run(a.study, NULL, NULL, NULL));
    assert_ok(*state, trk_study_close_journal(a.study));
    assert_ok(*state, trk_study_open_journal(b.study, journal));
    assert_int_equal(trk_study_finished(b.study), 8);
    assert_ok(*state, trk_study_run(b.study, NULL, NULL, NULL));
    assert_ok(*state, trk_study_close_journal(b.study));
    study_close(&a);
    a = study_open(*state, TRK_DESIGN_MONTE_CARLO, 4, 1);
    assert_status(*state, trk_study_load(a.study, journal), TRK_E_ARGUMENT);
    assert_message(*state, "ends with case 7");
    study_close(&a);
    study_close(&b);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(threads_and_chunks_make_no_difference),
        cmocka_unit_test(shards_in_any_order_make_no_difference),
        cmocka_unit_test(a_killed_run_resumes_to_the_same_table),
        cmocka_unit_test(a_cancelled_run_keeps_its_cases_and_goes_on),
        cmocka_unit_test(results_can_be_handed_over),
        cmocka_unit_test(cases_that_fail_do_not_stop_the_others),
        cmocka_unit_test(damage_is_cut_off_or_refused),
        cmocka_unit_test(foreign_files_are_refused),
        cmocka_unit_test(devices_are_no_journals),
        cmocka_unit_test(a_journal_that_cannot_be_written_is_told),
        cmocka_unit_test(a_longer_monte_carlo_study_goes_on_with_the_journal),
    };
    /* A comma for the decimal point, where the system has such a locale. */
    (void)!setlocale(LC_ALL, "de_DE.UTF-8");
    return cmocka_run_group_tests(tests, support_setup, support_teardown);
}
