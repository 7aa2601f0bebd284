/* SPDX-License-Identifier: MIT */
/* Needs JSON. More than 200 malformed files: status, line and column of each, and words of the message. */
#define _POSIX_C_SOURCE 200809L
#include "malformed.h"
#include "support.h"

#include <sys/stat.h>
#include <truckride/modelfile.h>
#include <unistd.h>

enum { ROOM = 4096 };

static int cases, failures;

/* Take the @ out; its line and column. */
static size_t unmark(const char *text, char *out, int *line, int *column)
{
    size_t length = 0;
    int row = 1, place = 1;
    *line = *column = 0;
    for (; *text; text++) {
        if (*text == '@') {
            *line = row;
            *column = place;
            continue;
        }
        out[length++] = *text;
        place = *text == '\n' ? 1 : place + 1;
        row += *text == '\n';
    }
    out[length] = '\0';
    return length;
}

static void refuse(trk_context *c, const char *text, const malformed *m)
{
    char plain[ROOM], place[64];
    int line, column;
    trk_spec *spec = (trk_spec *)c;
    const size_t length = unmark(text, plain, &line, &column);
    if (line == 0)
        fail_msg("no @ in %s", text);
    const trk_status status = trk_model_file_parse(c, plain, length, "truck.json", NULL, &spec);
    snprintf(place, sizeof place, "truck.json:%d:%d: ", line, column);
    const char *message = trk_context_message(c);
    if (status != m->status || strncmp(message, place, strlen(place)) != 0 ||
        !strstr(message, m->message))
        failures++, print_error("%s\nstatus %d, wanted %d at %swith '%s', got: %s\n", plain,
                                (int)status, (int)m->status, place, m->message, message);
    if (status == TRK_OK)
        trk_spec_destroy(spec);
    else
        assert_null(spec);
}

static void whole_files(void **state)
{
    for (size_t k = 0; k < sizeof whole / sizeof *whole; k++, cases++)
        refuse(*state, whole[k].text, &whole[k]);
    for (size_t k = 0; k < sizeof alone / sizeof *alone; k++, cases++)
        refuse(*state, alone[k].text, &alone[k]);
}

static void sections(void **state)
{
    char text[ROOM];
    for (size_t k = 0; k < sizeof part / sizeof *part; k++, cases++) {
        snprintf(text, sizeof text, "%s %s}", HEAD, part[k].text);
        refuse(*state, text, &part[k]);
    }
}

/* Bytes that no C string holds. */
static void zero_bytes(void **state)
{
    static const struct {
        const char *bytes;
        size_t size;
        int line, column;
    } with_zero[] = {
        {"\0", 1, 1, 1},
        {"{\"a\": 1}\0", 9, 1, 9},
        {"{\"a\":\n \"x\0y\"}", 13, 2, 4},
        {"{\n\"a\0\": 1}", 10, 2, 3},
    };
    for (size_t k = 0; k < sizeof with_zero / sizeof *with_zero; k++, cases++) {
        char place[64];
        trk_spec *spec;
        assert_status(
            *state,
            trk_model_file_parse(*state, with_zero[k].bytes, with_zero[k].size, "x", NULL, &spec),
            TRK_E_SYNTAX);
        snprintf(place, sizeof place, "x:%d:%d: there is a zero byte", with_zero[k].line,
                 with_zero[k].column);
        assert_message(*state, place);
    }
}

/* Megabytes of brackets, of one number, of one key: refused, and quickly. */
static void bombs(void **state)
{
    const size_t size = 4 << 20;
    static const char *const begin[] = {"[[", "{\"a\":[", "{\"truckride_model\": 1, \"name\": \"",
                                        "{\"truckride_model\": 1", "{\""};
    static const char fill[] = "[[a1a";
    for (size_t k = 0; k < sizeof begin / sizeof *begin; k++, cases++) {
        trk_spec *spec;
        char *text = malloc(size);
        assert_non_null(text);
        memset(text, fill[k], size);
        memcpy(text, begin[k], strlen(begin[k]));
        assert_status(*state, trk_model_file_parse(*state, text, size, "x", NULL, &spec),
                      TRK_E_SYNTAX);
        assert_message(*state, "x:1:");
        free(text);
    }
}

/* What is no file must not be waited for, and what is too large not read. */
static void no_files(void **state)
{
    const char *const pipe_path = "malformed_pipe", *const large_path = "malformed_large";
    static const char *const texts[] = {
        "{\"truckride_model\": 1, \"name\": \"x\", \"curves\": {\"c\": {\"csv\": "
        "\"malformed_pipe\"}}}",
        "{\"truckride_model\": 1, \"name\": \"x\", \"curves\": {\"c\": {\"csv\": "
        "\"malformed_large\"}}}",
        "{\"truckride_model\": 1, \"name\": \"x\", \"curves\": {\"c\": {\"csv\": \".\"}}}",
    };
    trk_spec *spec;
    remove(pipe_path);
    assert_int_equal(mkfifo(pipe_path, 0600), 0);
    FILE *large = fopen(large_path, "wb");
    assert_non_null(large);
    assert_int_equal(ftruncate(fileno(large), (1 << 26) + 1), 0); /* no bytes on the disk */
    fclose(large);
    assert_status(*state, trk_model_file_read(*state, pipe_path, &spec), TRK_E_FILE);
    assert_message(*state, "no regular file");
    assert_status(*state, trk_model_file_read(*state, large_path, &spec), TRK_E_FILE);
    assert_message(*state, "expected at most 67108864");
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++, cases++)
        assert_status(*state,
                      trk_model_file_parse(*state, texts[k], strlen(texts[k]), "x", ".", &spec),
                      TRK_E_FILE);
    remove(pipe_path);
    remove(large_path);
}

static void enough(void **state)
{
    (void)state;
    assert_int_equal(failures, 0);
    assert_true(cases >= 200);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(whole_files, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(sections, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(zero_bytes, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(bombs, support_setup, support_teardown),
        cmocka_unit_test_setup_teardown(no_files, support_setup, support_teardown),
        cmocka_unit_test(enough),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
