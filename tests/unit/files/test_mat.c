/* SPDX-License-Identifier: MIT */
/* MATLAB level 5: bytes of the file; what other programs load is in tests/reference/files_scipy.py. */
#include "support.h"

#include <stdbool.h>
#include <truckride/files.h>

static const char path[] = "test_mat.mat";

static size_t read_back(unsigned char *out, size_t room)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    const size_t size = fread(out, 1, room, file);
    fclose(file);
    return size;
}

static uint32_t word(const unsigned char *at)
{
    return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

/* Elements follow each other without a gap to the end of the file, all whole multiples of 8. */
static void structure(void **state)
{
    static const char *const name[] = {"time",   "cab__front_",   "x3",           "xend",
                                       "xend_4", "channel_names", "channel_units"};
    trk_context *c = *state;
    trk_series *s;
    assert_ok(c, trk_series_create(c, 4, 3, 4, 1, &s));
    assert_ok(c, trk_series_label(s, 1, "cab, front\xc2\xb0", "m/s^2"));
    assert_ok(c, trk_series_label(s, 3, "end", ""));
    assert_ok(c, trk_series_label(s, 2, "3", ""));
    assert_ok(c, trk_series_label(s, 4, "xend", "m"));
    trk_series_data_mutable(s, 1)[2] = 0.1;
    assert_ok(c, trk_series_write_mat(c, s, path));
    trk_series_destroy(s);
    static unsigned char file[4096];
    const size_t size = read_back(file, sizeof file);
    remove(path);
    assert_memory_equal(file, "MATLAB 5.0 MAT-file", 19);
    assert_memory_equal(file + 124, "\0\1IM", 4);
    size_t at = 128;
    for (int k = 0; k < 7; k++) {
        assert_int_equal(word(file + at), 14);
        const uint32_t bytes = word(file + at + 4);
        assert_int_equal(bytes % 8, 0);
        assert_int_equal(word(file + at + 16), k < 5 ? 6 : 1); /* double, cell */
        const unsigned char *label = file + at + 40;
        const bool small = word(label) >> 16 != 0;
        const uint32_t length = small ? word(label) >> 16 : word(label + 4);
        assert_int_equal(length, strlen(name[k]));
        assert_memory_equal(label + (small ? 4 : 8), name[k], length);
        if (k == 1) { /* behind the name: tag and three doubles */
            double value;
            memcpy(&value, file + at + 8 + bytes - 8, 8);
            assert_near(value, 0.1, 0);
        }
        at += 8 + bytes;
    }
    assert_int_equal(at, size);
}

static void wrong_arguments(void **state)
{
    trk_context *c = *state;
    trk_series *s;
    assert_ok(c, trk_series_create(c, 1, 3, 4, 1, &s));
    assert_status(c, trk_series_write_mat(NULL, s, path), TRK_E_ARGUMENT);
    assert_status(c, trk_series_write_mat(c, NULL, path), TRK_E_ARGUMENT);
    assert_status(c, trk_series_write_mat(c, s, NULL), TRK_E_ARGUMENT);
    assert_status(c, trk_series_write_mat(c, s, "/does/not/exist"), TRK_E_FILE);
    assert_status(c, trk_series_write_mat(c, s, "/dev/full"), TRK_E_FILE);
    assert_message(c, "/dev/full: cannot be written (No space left on device)");
    trk_series_destroy(s);
}

#define TEST(f) cmocka_unit_test_setup_teardown(f, support_setup, support_teardown)

int main(void)
{
    const struct CMUnitTest tests[] = {TEST(structure), TEST(wrong_arguments)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
