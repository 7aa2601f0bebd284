/* SPDX-License-Identifier: MIT */
/* Contexts: allocation function, messages, log, status texts, version. */
#include "support.h"

#include "base/base.h"

static void allocation_function_is_used(void **state)
{
    (void)state;
    support_memory memory = {0, 0, 0};
    trk_context *context = NULL;
    assert_int_equal(trk_context_create(support_allocate, &memory, &context), TRK_OK);
    assert_int_equal(memory.live, 1);
    void *block = trk_new(context, 10, 4);
    assert_int_equal(memory.live, 2);
    assert_int_equal(trk_context_blocks(context), 1);
    trk_free(context, block);
    assert_int_equal(trk_context_blocks(context), 0);
    trk_context_destroy(context);
    assert_int_equal(memory.live, 0);
}

static void creation_can_fail(void **state)
{
    (void)state;
    support_memory refusing = {0, 0, 1};
    trk_context *context = (trk_context *)&refusing;
    assert_int_equal(trk_context_create(support_allocate, &refusing, &context), TRK_E_MEMORY);
    assert_null(context);
    assert_int_equal(trk_context_create(NULL, NULL, NULL), TRK_E_ARGUMENT);
}

static void null_contexts_are_harmless(void **state)
{
    (void)state;
    trk_context_destroy(NULL);
    trk_context_set_log(NULL, NULL, NULL);
    assert_string_equal(trk_context_message(NULL), "no context");
    assert_int_equal(trk_context_blocks(NULL), 0);
    assert_int_equal(trk_fail(NULL, TRK_E_RANGE, "nobody hears %d", 1), TRK_E_RANGE);
    assert_int_equal(trk_fail_within(NULL, TRK_E_RANGE, "nor this"), TRK_E_RANGE);
    trk_note(NULL, "nor that");
}

static void message_names_where_and_what(void **state)
{
    assert_string_equal(trk_context_message(*state), "");
    assert_int_equal(trk_fail(*state, TRK_E_RANGE, "mass is %g", -1.5), TRK_E_RANGE);
    assert_string_equal(trk_context_message(*state), "mass is -1.5");
    assert_int_equal(trk_fail_within(*state, TRK_E_MODEL, "body '%s'", "cab"), TRK_E_MODEL);
    assert_string_equal(trk_context_message(*state), "body 'cab': mass is -1.5");
}

static void message_may_quote_the_last_one(void **state)
{
    (void)trk_fail(*state, TRK_E_NAME, "inner");
    (void)trk_fail(*state, TRK_E_NAME, "again: %s, %s", trk_context_message(*state),
                   trk_context_message(*state));
    assert_string_equal(trk_context_message(*state), "again: inner, inner");
}

static void long_message_is_cut_behind_the_place(void **state)
{
    char text[3000];
    memset(text, 'x', sizeof text - 1);
    text[sizeof text - 1] = 0;
    (void)trk_fail(*state, TRK_E_NAME, "%s", text);
    assert_int_equal(strlen(trk_context_message(*state)), 1023);
    (void)trk_fail_within(*state, TRK_E_NAME, "here");
    assert_memory_equal(trk_context_message(*state), "here: xxx", 9);
    (void)trk_fail_within(*state, TRK_E_NAME, "%s", text);
    assert_true(strlen(trk_context_message(*state)) <= 1023);
}

static void take_note(void *user, const char *message)
{
    snprintf(user, 40, "%s", message);
}

static void notes_go_to_the_log(void **state)
{
    char heard[40] = "";
    trk_note(*state, "nobody listens");
    trk_context_set_log(*state, take_note, heard);
    trk_note(*state, "curve %d", 3);
    assert_string_equal(heard, "curve 3");
    trk_context_set_log(*state, NULL, NULL);
    trk_note(*state, "nobody listens");
    assert_string_equal(heard, "curve 3");
    assert_string_equal(trk_context_message(*state), "");
}

static void every_status_has_a_text(void **state)
{
    (void)state;
#define CHECK(name, value, text)                                                                   \
    assert_int_equal((name), (value));                                                             \
    assert_string_equal(trk_status_text(name), (text));
    TRK_STATUS_LIST(CHECK)
#undef CHECK
    for (trk_status status = -1000; status < 1000; status++)
        assert_true(strlen(trk_status_text(status)) > 0);
    assert_string_equal(trk_status_text(INT32_MAX), "unknown status");
    assert_string_equal(trk_status_text(INT32_MIN), "unknown status");
}

static void version_and_features(void **state)
{
    (void)state;
    int major, minor, patch;
    assert_int_equal(sscanf(trk_version_text(), "%d.%d.%d", &major, &minor, &patch), 3);
    assert_int_equal(trk_version(), major * 10000 + minor * 100 + patch);
    assert_int_equal(trk_version(),
                     TRK_VERSION_MAJOR * 10000 + TRK_VERSION_MINOR * 100 + TRK_VERSION_PATCH);
    for (trk_feature feature = -2; feature < 20; feature++)
        assert_in_range(trk_has_feature(feature), 0, 1);
    assert_int_equal(trk_has_feature(0), 0);
    assert_int_equal(trk_has_feature(INT32_MAX), 0);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(allocation_function_is_used),
        TEST(creation_can_fail),
        TEST(null_contexts_are_harmless),
        TEST(message_names_where_and_what),
        TEST(message_may_quote_the_last_one),
        TEST(long_message_is_cut_behind_the_place),
        TEST(notes_go_to_the_log),
        TEST(every_status_has_a_text),
        TEST(version_and_features),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
