/* SPDX-License-Identifier: MIT */
/*
 * Some 400 damaged files, made from good ones: cut off, grown, with keys missing, huge counts,
 * decimal commas, converted line ends. Each must be refused with a status of its own kind, a
 * message that begins with the file's name, nothing returned, and memory in proportion to its
 * bytes. Also in a locale with a decimal comma, if there is one.
 */
#include <stdbool.h>

#include "support.h"

#include <locale.h>
#include <truckride/crg.h>
#include <truckride/files.h>

typedef enum format { CSV, ERD, RPC, CRG_TEXT, CRG_BINARY, FORMATS } format;

typedef struct file {
    char bytes[8000];
    size_t size;
} file;

static file good[FORMATS];
static int refused;

/* Most bytes that were asked for at once, of an allocator that is malloc otherwise. */
typedef struct watched {
    int64_t now, most;
} watched;

static void *watch(void *user, void *block, size_t old_size, size_t new_size)
{
    watched *w = user;
    w->now += (int64_t)new_size - (int64_t)(block ? old_size : 0);
    w->most = w->now > w->most ? w->now : w->most;
    if (new_size == 0) {
        free(block);
        return NULL;
    }
    return w->now > 1 << 24 ? NULL : realloc(block, new_size);
}

static trk_status parse(trk_context *c, format kind, const file *f, void **out)
{
    const void *bytes = f->bytes;
    switch (kind) {
    case CSV: return trk_series_parse_csv(c, "x", bytes, f->size, NULL, (trk_series **)out);
    case ERD: return trk_series_parse_erd(c, "x", bytes, f->size, (trk_series **)out);
    case RPC: return trk_series_parse_rpc(c, "x", bytes, f->size, (trk_series **)out);
    default: return trk_crg_parse(c, "x", bytes, f->size, NULL, (trk_crg **)out);
    }
}

static void destroy(format kind, void *object)
{
    if (kind < CRG_TEXT)
        trk_series_destroy(object);
    else
        trk_crg_destroy(object);
}

static void expect(format kind, const file *f, bool good_file)
{
    watched memory = {0, 0};
    trk_context *c;
    void *out = NULL;
    assert_int_equal(trk_context_create(watch, &memory, &c), TRK_OK);
    const trk_status status = parse(c, kind, f, &out);
    const char *message = trk_context_message(c);
    if ((status == TRK_OK) != good_file)
        fail_msg("format %d, %d bytes: %d %s", kind, (int)f->size, (int)status, message);
    if (!good_file) {
        assert_null(out);
        assert_true(status == TRK_E_SYNTAX || status == TRK_E_RANGE || status == TRK_E_UNSUPPORTED);
        assert_true(strncmp(message, "x:", 2) == 0);
        refused++;
    }
    if (memory.most > 20000 + 64 * (int64_t)f->size)
        fail_msg("format %d: %d bytes took %lld", kind, (int)f->size, (long long)memory.most);
    destroy(kind, out);
    assert_int_equal(trk_context_blocks(c), 0);
    trk_context_destroy(c);
}

static void put(file *f, const char *text)
{
    const size_t length = strlen(text);
    memcpy(f->bytes + f->size, text, length);
    f->size += length;
}

static void make_text(void)
{
    put(&good[CSV], "time [s],a [m],b [N]\n");
    put(&good[ERD], "ERDFILEV2.00\n2,20,-1,1,5,0.25,-1\nUNITSNAMmm      mm\nXUNITS  m\nEND\n");
    for (int k = 0; k < 20; k++) {
        char line[80];
        snprintf(line, sizeof line, "%.2f,%.3f,%.1f\n", 0.25 * k, 1.5 * k, 0.5 - k);
        put(&good[CSV], line);
        snprintf(line, sizeof line, "%.2f %.3f\n", 0.25 * k, 1.5 * k);
        put(&good[ERD], line);
    }
}

static void make_crg(file *f, const char *kind)
{
    put(f, "$CT\ntitle\n$\n$ROAD_CRG\nREFERENCE_LINE_END_U = 9.5\nREFERENCE_LINE_INCREMENT = 0.5\n"
           "LONG_SECTION_V_RIGHT = -0.5\nLONG_SECTION_V_LEFT = 0.5\n$\n$KD_DEFINITION\n#:");
    put(f, kind);
    put(f, "\nD:long section 1,m\nD:long section 2,m\nD:long section 3,m\n$\n$$$$\n");
    for (int k = 0; k < 20; k++) {
        if (f == &good[CRG_TEXT]) {
            put(f, " 0.0100000-0.0200000 0.0300000\n");
            continue;
        }
        memcpy(f->bytes + f->size, "?\n\n\n?\n\n\n?\n\n\n", 12);
        f->size += 12;
    }
}

static void make_rpc(file *f)
{
    static const char *const record[][2] = {{"FORMAT", "BINARY"},    {"NUM_HEADER_BLOCKS", "3"},
                                            {"NUM_PARAMS", "10"},    {"DELTA_T", "0.01"},
                                            {"CHANNELS", "2"},       {"PTS_PER_FRAME", "4"},
                                            {"PTS_PER_GROUP", "8"},  {"FRAMES", "3"},
                                            {"SCALE.CHAN_1", "0.5"}, {"SCALE.CHAN_2", "2.5"}};
    for (int k = 0; k < 10; k++) {
        strcpy(f->bytes + 128 * k, record[k][0]);
        strcpy(f->bytes + 128 * k + 32, record[k][1]);
    }
    f->size = 3 * 512 + 64;
}

static int make(void **state)
{
    (void)state;
    memset(good, 0, sizeof good);
    make_text();
    make_rpc(&good[RPC]);
    make_crg(&good[CRG_TEXT], "LRFI");
    make_crg(&good[CRG_BINARY], "KRBI");
    return 0;
}

/* Replace the first `old` behind `from` by `new_text`; false if there is none. */
static bool replace(file *f, size_t from, const char *old, const char *new_text)
{
    const size_t length = strlen(old), new_length = strlen(new_text);
    for (size_t at = from; at + length <= f->size; at++)
        if (memcmp(f->bytes + at, old, length) == 0) {
            memmove(f->bytes + at + new_length, f->bytes + at + length, f->size - at - length);
            memcpy(f->bytes + at, new_text, new_length);
            f->size = f->size - length + new_length;
            return true;
        }
    return false;
}

static void good_ones(void **state)
{
    (void)state;
    for (format k = 0; k < FORMATS; k++)
        expect(k, &good[k], true);
}

static void cut_off(void **state)
{
    (void)state;
    for (format k = ERD; k < FORMATS; k++)
        for (size_t size = 0; size + 8 < good[k].size; size += k == RPC ? 16 : 7) {
            file f = good[k];
            f.size = size;
            expect(k, &f, false);
        }
    for (size_t size = 0; size < 60; size++) { /* within a row; a table may end behind one */
        file f = good[CSV];
        f.size = size;
        const char last = size ? f.bytes[size - 1] : '\n';
        if (size < 25 || last == ',' || last == '-')
            expect(CSV, &f, false);
    }
}

static void keys_missing(void **state)
{
    (void)state;
    static const struct {
        format kind;
        const char *text;
    } row[] = {{ERD, "ERDFILEV2.00\n"},
               {ERD, "END\n"},
               {ERD, "2,20,-1,1,5,0.25,-1\n"},
               {RPC, "FORMAT"},
               {RPC, "NUM_HEADER_BLOCKS"},
               {RPC, "DELTA_T"},
               {RPC, "CHANNELS"},
               {RPC, "PTS_PER_FRAME"},
               {RPC, "PTS_PER_GROUP"},
               {RPC, "FRAMES"},
               {RPC, "SCALE.CHAN_1"},
               {CRG_TEXT, "$ROAD_CRG\n"},
               {CRG_TEXT, "REFERENCE_LINE_INCREMENT = 0.5\n"},
               {CRG_TEXT, "LONG_SECTION_V_RIGHT = -0.5\n"},
               {CRG_TEXT, "$KD_DEFINITION\n"},
               {CRG_TEXT, "#:LRFI\n"},
               {CRG_TEXT, "D:long section 2,m\n"},
               {CRG_TEXT, "D:long section 3,m\n"},
               {CRG_BINARY, "D:long section 3,m\n"},
               {CRG_TEXT, "$$$$\n"},
               {CRG_BINARY, "$$$$\n"}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        file f = good[row[k].kind];
        /* A record of RPC keeps its place, a line goes. */
        char gone[40];
        snprintf(gone, sizeof gone, "%.*s", (int)strlen(row[k].text), "########################");
        assert_true(replace(&f, 0, row[k].text, row[k].kind == RPC ? gone : ""));
        expect(row[k].kind, &f, false);
    }
}

static void huge_counts(void **state)
{
    (void)state;
    static const struct {
        format kind;
        const char *before, *after;
    } row[] = {{ERD, "2,20,", "4000,20,"},
               {ERD, "2,20,", "2,2000000000,"},
               {ERD, "2,20,", "1e300,20,"},
               {ERD, "2,20,", "2,99999999999999999999,"},
               {ERD, "5,0.25", "5,0"},
               {ERD, "5,0.25", "5,1e999"},
               {CRG_TEXT, "U = 9.5", "U = 1e9"},
               {CRG_BINARY, "U = 9.5", "U = 1e9"},
               {CRG_BINARY, "U = 9.5", "U = 1e300"},
               {CRG_BINARY, "U = 9.5", "U = -1e9"},
               {CRG_BINARY, "U = 9.5", "U = 4.5"},
               {CRG_BINARY, "INCREMENT = 0.5", "INCREMENT = 1e-6"},
               {CRG_BINARY, "INCREMENT = 0.5", "INCREMENT = 0"},
               {CRG_BINARY, "INCREMENT = 0.5", "INCREMENT = nan"},
               {CRG_BINARY, "section 3", "section 999999999"},
               {CRG_BINARY, "section 3", "section 2"},
               {CRG_BINARY, "KRBI", "KDBI"},
               {CRG_BINARY, "KRBI", "LRBI"},
               {CRG_TEXT, "LRFI", "LDFI"},
               {CRG_TEXT, "LEFT = 0.5", "LEFT = 1e308"}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        file f = good[row[k].kind];
        assert_true(replace(&f, 0, row[k].before, row[k].after));
        expect(row[k].kind, &f, false);
    }
    static const char *const value[] = {"99999999999", "2147483647", "-1", "0",
                                        "1e18",        "x",          "",   "3.5"};
    for (int record = 4; record < 8; record++)
        for (size_t k = 0; k < sizeof value / sizeof *value; k++) {
            file f = good[RPC];
            memset(f.bytes + 128 * record + 32, 0, 16);
            strcpy(f.bytes + 128 * record + 32, value[k]);
            expect(RPC, &f, false);
        }
}

static void decimal_commas(void **state)
{
    (void)state;
    for (format k = 0; k < FORMATS; k++)
        for (int nth = 0; nth < 12; nth++) {
            file f = good[k];
            /* not the title, the version, the format or a record's name */
            size_t at = k == CSV ? 20 : k == ERD ? 14 : k == RPC ? 3 * 128 : 40;
            const size_t end = k == RPC ? 8 * 128 : k == CRG_BINARY ? 160 : f.size;
            bool found = false;
            for (int count = 0; at < end && !found; at++)
                found = f.bytes[at] == '.' && count++ == nth;
            if (!found)
                continue;
            f.bytes[at - 1] = ',';
            expect(k, &f, false);
        }
}

static void other_sizes(void **state)
{
    (void)state;
    for (size_t more = 1; more < 600; more += 37) {
        file f = good[CRG_BINARY];
        f.size += more; /* zeros behind the data */
        expect(CRG_BINARY, &f, false);
        f = good[RPC];
        f.size += 512 + more;
        expect(RPC, &f, false);
    }
}

static void converted_line_ends(void **state)
{
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        file f = {.size = 0};
        const file *from = &good[CRG_BINARY];
        for (size_t k = 0; k < from->size; k++) {
            const bool feed = from->bytes[k] == '\n', data = k > 280;
            if (feed && kind == 0)
                f.bytes[f.size++] = '\r';
            if (!(feed && kind == 1 && data))
                f.bytes[f.size++] = feed && kind == 2 && !data ? '\r' : from->bytes[k];
        }
        expect(CRG_BINARY, &f, false);
    }
}

static void in_german(void **state)
{
    if (!setlocale(LC_ALL, "de_DE.UTF-8")) {
        print_message("skipped: there is no locale de_DE.UTF-8\n");
        skip();
    }
    good_ones(state);
    decimal_commas(state);
    setlocale(LC_ALL, "C");
}

static void many_were_refused(void **state)
{
    (void)state;
    print_message("%d damaged files were refused\n", refused);
    assert_true(refused >= 150);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(good_ones),           cmocka_unit_test(cut_off),
        cmocka_unit_test(keys_missing),        cmocka_unit_test(huge_counts),
        cmocka_unit_test(decimal_commas),      cmocka_unit_test(other_sizes),
        cmocka_unit_test(converted_line_ends), cmocka_unit_test(in_german),
        cmocka_unit_test(many_were_refused),
    };
    return cmocka_run_group_tests(tests, make, NULL);
}
