/* SPDX-License-Identifier: MIT */
/* Aligned counted memory and lists of names. */
#include "support.h"

#include "base/names.h"

static void blocks_are_zeroed_and_aligned(void **state)
{
    for (int64_t count = 0; count < 200; count += 7) {
        unsigned char *block = trk_new(*state, count, 1);
        assert_non_null(block);
        assert_int_equal((uintptr_t)block % 64, 0);
        for (int64_t k = 0; k < count; k++)
            assert_int_equal(block[k], 0);
        memset(block, 0xff, (size_t)count);
        trk_free(*state, block);
    }
    trk_free(*state, NULL);
}

static void impossible_sizes_are_refused(void **state)
{
    assert_null(trk_new(*state, -1, 8));
    assert_message(*state, "-1 elements of 8 bytes");
    assert_null(trk_new(*state, INT64_MAX, 8));
    assert_message(*state, "exceed the address space");
    assert_null(trk_new(*state, INT64_MAX, 1));
    assert_message(*state, "out of memory");
}

static void growing_keeps_the_contents(void **state)
{
    int32_t *list = NULL;
    int64_t capacity = 0;
    for (int32_t k = 0; k < 1000; k++) {
        assert_ok(*state, trk_grow(*state, (void **)&list, &capacity, k + 1, sizeof *list));
        list[k] = k;
    }
    for (int32_t k = 0; k < 1000; k++)
        assert_int_equal(list[k], k);
    int32_t *before = list;
    assert_status(*state, trk_grow(*state, (void **)&list, &capacity, INT64_MAX, 4), TRK_E_MEMORY);
    assert_ptr_equal(list, before);
    assert_int_equal(list[999], 999);
    trk_free(*state, list);
}

static void names_are_found_by_text_and_by_id(void **state)
{
    trk_names names = {0};
    char text[20];
    assert_int_equal(trk_names_find(&names, "n1"), 0);
    for (int32_t k = 1; k <= 500; k++) {
        snprintf(text, sizeof text, "n%d", k);
        assert_ok(*state, trk_names_add(*state, &names, "link", text));
    }
    for (int32_t k = 1; k <= 500; k++) {
        snprintf(text, sizeof text, "n%d", k);
        assert_int_equal(trk_names_find(&names, text), k);
        assert_string_equal(trk_names_text(&names, k), text);
    }
    assert_int_equal(trk_names_find(&names, "n501"), 0);
    assert_int_equal(trk_names_find(&names, ""), 0);
    assert_int_equal(trk_names_find(&names, NULL), 0);
    assert_null(trk_names_text(&names, 0));
    assert_null(trk_names_text(&names, -1));
    assert_null(trk_names_text(&names, 501));
    trk_names_clear(*state, &names);
    assert_int_equal(names.count, 0);
}

static void bad_names_change_nothing(void **state)
{
    trk_names names = {0};
    assert_ok(*state, trk_names_add(*state, &names, "link", "tire"));
    assert_status(*state, trk_names_add(*state, &names, "link", "tire"), TRK_E_NAME);
    assert_message(*state, "link name 'tire' is already used");
    assert_status(*state, trk_names_add(*state, &names, "link", ""), TRK_E_NAME);
    assert_message(*state, "a link needs a name");
    assert_status(*state, trk_names_add(*state, &names, "link", NULL), TRK_E_NAME);
    assert_int_equal(names.count, 1);
    trk_names_clear(*state, &names);
}

/* Enough names to grow the list and to hash again. */
static trk_status make_and_copy(trk_context *context)
{
    trk_names names = {0}, copy = {0};
    trk_status status = TRK_OK;
    for (int k = 0; status == TRK_OK && k < 20; k++) {
        char text[20];
        snprintf(text, sizeof text, "n%d", k);
        status = trk_names_add(context, &names, "part", text);
    }
    if (status == TRK_OK)
        status = trk_names_copy(context, &names, &copy);
    if (status == TRK_OK)
        assert_int_equal(trk_names_find(&copy, "n19"), 20);
    trk_names_clear(context, &names);
    trk_names_clear(context, &copy);
    return status;
}

static void names_survive_lack_of_memory(void **state)
{
    (void)state;
    support_exhaust_memory(make_and_copy);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(blocks_are_zeroed_and_aligned), TEST(impossible_sizes_are_refused),
        TEST(growing_keeps_the_contents),    TEST(names_are_found_by_text_and_by_id),
        TEST(bad_names_change_nothing),      TEST(names_survive_lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
