#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Change a small library in every way that breaks its callers, and see check.py find each one;
change it in the ways that do not, and see it pass."""
import pathlib
import subprocess
import sys
import tempfile

from baseline import baseline
from check import check

HEADER = """
#ifndef TRUCKRIDE_MINI_H
#define TRUCKRIDE_MINI_H
#include <stddef.h>
#include <stdint.h>
#define TRK_API extern __attribute__((visibility("default")))
#define TRK_GRAVITY 9.80665
#define TRK_LIST(X) X(TRK_E_A, 1) X(TRK_E_B, 2)
#define TRK_ENUM(name, value) name = value,
enum { TRK_LIST(TRK_ENUM) TRK_END_ };
typedef int32_t trk_kind;
enum {
    TRK_KIND_A = 0,
    TRK_KIND_B = 1
};
typedef struct trk_mini trk_mini;
typedef struct trk_mini_options {
    size_t struct_size;
    double step;
    trk_kind kind;
    int32_t count;
} trk_mini_options;
typedef struct trk_gap_options {
    size_t struct_size;
    int32_t count;
} trk_gap_options;
typedef struct trk_point {
    double x, y;
} trk_point;
typedef struct trk_mini_result {
    size_t struct_size;
    double more;
} trk_mini_result;
TRK_API int32_t trk_mini_result_of(const trk_mini *mini, trk_mini_result *result);
TRK_API int32_t trk_mini_run(trk_mini *mini, const trk_mini_options *options);
TRK_API int32_t trk_mini_stop(trk_mini *mini, const trk_gap_options *options, trk_point *point);
#endif
"""
SOURCE = """
#include <truckride/mini.h>
struct trk_mini {
    int state;
};
int32_t trk_mini_run(trk_mini *mini, const trk_mini_options *options)
{
    return mini->state + options->count;
}
int32_t trk_mini_result_of(const trk_mini *mini, trk_mini_result *result)
{
    return mini->state + (int32_t)result->more;
}
int32_t trk_mini_stop(trk_mini *mini, const trk_gap_options *options, trk_point *point)
{
    return mini->state + options->count + (int32_t)point->y;
}
"""
STOP = SOURCE[SOURCE.index("int32_t trk_mini_stop"):]
STOP_DECLARED = HEADER[HEADER.index("TRK_API int32_t trk_mini_stop"):HEADER.index("#endif\n", 300)]

# (what, old text in the header, new text, old text in the source, new text)
ALLOWED = [
    ("nothing changed", "", "", "", ""),
    ("function added", "TRK_API int32_t trk_mini_run", "TRK_API int32_t trk_more(void);\nTRK_API int32_t trk_mini_run",
     "int32_t trk_mini_run", "int32_t trk_more(void)\n{\n    return 1;\n}\nint32_t trk_mini_run"),
    ("result appended", "double more;\n} trk_mini_result", "double more, most;\n} trk_mini_result", "", ""),
    ("option appended", "int32_t count;\n} trk_mini_options", "int32_t count;\n    double more;\n} trk_mini_options", "", ""),
    ("constant added", "TRK_KIND_B = 1", "TRK_KIND_B = 1,\n    TRK_KIND_C = 2", "", ""),
    ("status added", "X(TRK_E_B, 2)", "X(TRK_E_B, 2) X(TRK_E_C, 3)", "", ""),
    ("private struct changed", "", "", "int state;", "double more;\n    int state;"),
]
FORBIDDEN = [
    ("function removed", STOP_DECLARED, "", STOP, ""),
    ("export that no header declares", "", "", "int32_t trk_mini_run",
     "extern __attribute__((visibility(\"default\"))) int32_t trk_secret(void);\n"
     "int32_t trk_secret(void)\n{\n    return 1;\n}\nint32_t trk_mini_run"),
    ("declared function that is not exported", "TRK_API int32_t trk_mini_run",
     "TRK_API int32_t trk_lost(void);\nTRK_API int32_t trk_mini_run", "", ""),
    ("option inserted in the middle", "double step;", "double middle;\n    double step;", "", ""),
    ("same-size options swapped", "trk_kind kind;\n    int32_t count;", "int32_t count;\n    trk_kind kind;", "", ""),
    ("option removed", "    double step;\n", "", "", ""),
    ("option put into the padding", "int32_t count;\n} trk_gap", "int32_t count;\n    int32_t more;\n} trk_gap", "", ""),
    ("option widened", "int32_t count;\n} trk_mini", "int64_t count;\n} trk_mini", "", "",),
    ("field appended to a struct without size", "double x, y;", "double x, y, z;", "", ""),
    ("constant renumbered", "TRK_KIND_B = 1", "TRK_KIND_B = 2", "", ""),
    ("constant removed", ",\n    TRK_KIND_B = 1", "", "", ""),
    ("status renumbered", "X(TRK_E_B, 2)", "X(TRK_E_B, 3)", "", ""),
    ("macro changed", "9.80665", "9.81", "", ""),
    ("parameter changed", "trk_mini *mini, const trk_mini_options *options);", "trk_mini *mini, trk_point *options);",
     "run(trk_mini *mini, const trk_mini_options *options)\n{\n    return mini->state + options->count",
     "run(trk_mini *mini, trk_point *options)\n{\n    return mini->state + (int)options->x"),
]


def build(folder, header, source):
    include = folder / "include" / "truckride"
    include.mkdir(parents=True, exist_ok=True)
    (include / "mini.h").write_text(header)
    (folder / "mini.c").write_text(source)
    library = folder / "libtruckride.so"
    subprocess.run(["cc", "-g", "-fPIC", "-shared", "-fvisibility=hidden", f"-I{folder}/include",
                    "-Wl,-soname,libtruckride.so.0", "-o", library, folder / "mini.c"], check=True)
    return str(folder / "include"), str(library)


def edited(text, old, new):
    assert not old or text.count(old) == 1, old
    return text.replace(old, new) if old else text


def main():
    failures = 0
    with tempfile.TemporaryDirectory() as top:
        top = pathlib.Path(top)
        baseline(*build(top / "old", HEADER, SOURCE), top)
        for cases, wanted in (ALLOWED, False), (FORBIDDEN, True):
            for what, header_old, header_new, source_old, source_new in cases:
                include, library = build(top / "new", edited(HEADER, header_old, header_new),
                                         edited(SOURCE, source_old, source_new))
                complaints = list(check(include, library, top))
                if bool(complaints) != wanted:
                    failures += 1
                    print(f"{what}: {complaints or 'was not found'}")
    print(f"{len(ALLOWED)} allowed and {len(FORBIDDEN)} forbidden changes made, {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
