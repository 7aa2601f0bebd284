#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""selftest.py CHECK: plant violations in a small tree that passes, and see the check find each.

The small tree has two rooms, low and high, and the files of TREE. A case is (file, new text,
words the complaint must contain); new text None removes the file.
"""
import importlib
import pathlib
import subprocess
import sys
import tempfile

SPDX = "/* SPDX-License-Identifier: MIT */\n"
LOW_H = SPDX + """/** @file truckride/low.h  Low. */
#ifndef TRUCKRIDE_LOW_H
#define TRUCKRIDE_LOW_H
#include <stddef.h>
#define TRK_API extern __attribute__((visibility("default")))
typedef struct trk_low_options {
    size_t struct_size; /**< [byte] size */
    double step;        /**< [s] time step (LOW.1) */
    double cg[3];       /**< [m] centre of gravity */
} trk_low_options;
/** Progress. @param fraction [-] 0 to 1 */
typedef int (*trk_low_progress)(void *user, double fraction);
/**
 * Speed [m/s].
 * @param length [m] of the way
 */
TRK_API double trk_low_speed(double length, const double *out_time);

#endif
"""
HIGH_H = SPDX + """#ifndef TRUCKRIDE_HIGH_H
#define TRUCKRIDE_HIGH_H
#include <truckride/low.h>
/** Number of things. */
TRK_API int trk_high_count(void);
#endif
"""
UMBRELLA = SPDX + """#ifndef TRUCKRIDE_TRUCKRIDE_H
#define TRUCKRIDE_TRUCKRIDE_H

#include <truckride/low.h>
#include <truckride/high.h>

#endif
"""
LOW_C = SPDX + """#include <truckride/low.h>

/* printf(3) is only mentioned: (LOW.1). */
double trk_low_speed(double length, const double *out_time)
{
    return length / *out_time;
}
"""
HIGH_C = SPDX + """#include <truckride/high.h>

static const char *const names[] = {"abort()", "b"};

int trk_high_count(void)
{
    return names[0][0] ? 2 : 1;
}
"""
TREE = {
    ".clang-format": "BasedOnStyle: LLVM\nIndentWidth: 4\nBreakBeforeBraces: Linux\n"
                     "AllowShortFunctionsOnASingleLine: None\n",
    "include/truckride/low.h": LOW_H,
    "include/truckride/high.h": HIGH_H,
    "include/truckride/truckride.h": UMBRELLA,
    "lib/layers.txt": "low\nhigh\n",
    "lib/CMakeLists.txt": "# SPDX-License-Identifier: MIT\nset(sources\n    low/low.c\n    high/high.c\n)\n",
    "lib/low/low.c": LOW_C,
    "lib/high/high.c": HIGH_C,
    "tests/unit/low/test_low.c": SPDX,
    "tests/unit/high/test_high.c": SPDX,
    "docs/theory/low.md": "v = s / t    (LOW.1)\n",
}


def edited(name, old, new):
    assert TREE[name].count(old) == 1, (name, old)
    return name, TREE[name].replace(old, new)


CASES = {
    "layers": [
        (*edited("lib/low/low.c", "<truckride/low.h>", '"high/high.h"'), "low must not include high"),
        (*edited("lib/high/high.c", "<truckride/high.h>", '"high.h"'), "does not name a room"),
    ],
    "rooms": [
        ("include/truckride/other.h", SPDX, "no room lib/other"),
        ("lib/other/other.c", SPDX, "not in lib/layers.txt"),
        ("lib/low/low.c", None, "has no source"),
        ("tests/unit/low/test_low.c", None, "has no unit test"),
        ("tests/unit/other/test_other.c", SPDX, "no room lib/other"),
    ],
    "sources": [
        ("lib/low/forgotten.c", SPDX, "lib/low/forgotten.c is not in"),
        ("lib/low/low.c", None, "does not exist"),
        (*edited("lib/CMakeLists.txt", "low/low.c\n", "low/low.c\n    low/low.c\n"), "more than once"),
        (*edited("lib/CMakeLists.txt", "    low/low.c\n    high/high.c", "    high/high.c\n    low/low.c"),
         "higher floor"),
    ],
    "umbrella": [
        (*edited("include/truckride/truckride.h", "#include <truckride/low.h>\n", ""), "does not include <truckride/low.h>"),
        (*edited("include/truckride/truckride.h", "high.h>\n", "high.h>\nint x;\n"), "holds more than includes"),
        ("include/truckride/high.h", None, "which does not exist"),
    ],
    "calls": [
        (*edited("lib/low/low.c", "return", 'printf("x");\n    return'), "printf prints"),
        (*edited("lib/low/low.c", "return", "assert(length > 0);\n    return"), "assert ends"),
        (*edited("lib/low/low.c", "return", 'getenv("HOME");\n    return'), "getenv reads the environment"),
        (*edited("lib/low/low.c", "return", 'setlocale(0, "");\n    return'), "setlocale sets"),
        (*edited("lib/low/low.c", "return", "exit (1);\n    return"), "exit ends"),
        (*edited("lib/low/low.c", "return", "malloc(1);\n    return"), "malloc bypasses"),
        (*edited("lib/low/low.c", "return", 'fputs("x", stderr);\n    return'), "stderr prints"),
    ],
    "equations": [
        (*edited("lib/low/low.c", "LOW.1", "LOW.2"), "(LOW.2) does not stand in docs/theory/low.md"),
        (*edited("include/truckride/low.h", "LOW.1", "HIGH.1"), "(HIGH.1) does not stand"),
        ("docs/theory/low.md", None, "(LOW.1) does not stand"),
    ],
    "licence": [
        (*edited("lib/low/low.c", SPDX, ""), "lib/low/low.c:1: SPDX"),
        ("tests/style/check.py", "#!/usr/bin/env python3\nprint()\n", "check.py:1: SPDX"),
    ],
    "units": [
        (*edited("include/truckride/low.h", "[s] time", "time"), "field without [unit]: double step"),
        (*edited("include/truckride/low.h", "[m] centre", "centre"), "field without [unit]: double cg[3]"),
        (*edited("include/truckride/low.h", "[m/s]", ""), "returns a number without [unit]"),
        (*edited("include/truckride/low.h", "[m] of the way", "of the way"), "parameter without [unit]: length"),
        (*edited("include/truckride/low.h", "Speed [m/s]", "Speed v[i]"), "parameter without [unit]: out_time"),
        (*edited("include/truckride/low.h", "[-] 0 to 1", "0 to 1"), "parameter without [unit]: fraction"),
        (*edited("include/truckride/high.h", "/** Number of things. */\n", ""), "trk_high_count has no comment"),
        (*edited("include/truckride/high.h", "/** Number", "#define TRK_G 9.81\n/** Number"), "TRK_G is a number"),
    ],
    "headers": [
        (*edited("include/truckride/low.h", "#include <stddef.h>\n", ""), "low.h as c99"),
        (*edited("include/truckride/low.h", "void *user", "void *new"), "low.h as c++11"),
        (*edited("include/truckride/low.h", "int (*trk", "_Bool x:1; int (*trk"), "low.h as c99"),
        (*edited("include/truckride/low.h", "#ifndef TRUCKRIDE_LOW_H\n", "#if 1\n"), "low.h as c99"),
    ],
    "format": [
        (*edited("lib/low/low.c", "    return", "  return"), "lib/low/low.c"),
        (*edited("lib/high/high.c", "void)\n{", "void) {"), "lib/high/high.c"),
    ],
    "exports": [
        (*edited("lib/low/low.c", "double trk_low", 'TRK_API int trk_extra;\nint trk_extra = 1;\ndouble trk_low'),
         "trk_extra is exported, but no public header declares it"),
        (*edited("include/truckride/high.h", "int trk_high", "int trk_lost(void);\nTRK_API int trk_high"),
         "trk_lost is declared, but the library does not export it"),
    ],
    "globals": [
        (*edited("lib/low/low.c", "return", "static int calls;\n    calls++;\n    return"), "calls"),
        (*edited("lib/low/low.c", "double trk_low", "int trk_state;\ndouble trk_low"), "trk_state is a writable global"),
        (*edited("lib/high/high.c", "static const char *const names", "static const char *names"),
         "names is a writable global"),
    ],
}


def plant(root, changes):
    for name, text in {**TREE, **changes}.items():
        if text is not None:
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)


def arguments(check, root):
    """What the check takes besides the tree: the library built from it."""
    if check not in ("exports", "globals"):
        return []
    sources = sorted((root / "lib").rglob("*.c"))
    library, objects = root / "library.so", root / "objects.o"
    build = ["cc", "-fPIC", "-fvisibility=hidden", f"-I{root}/include"]
    subprocess.run([*build, "-shared", "-o", library, *sources], check=True)
    subprocess.run([*build, "-r", "-nostdlib", "-o", objects, *sources], check=True)
    return [library if check == "exports" else objects]


def complaints(check, changes):
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        plant(root, changes)
        module = importlib.import_module(check)
        return [str(complaint) for complaint in module.check(root, *arguments(check, root))]


def main():
    check, failures = sys.argv[1], 0
    found = complaints(check, {})
    if found:
        print(f"complains about a tree without violations: {found}")
        failures += 1
    for name, text, words in CASES[check]:
        found = complaints(check, {name: text})
        if not any(words in complaint for complaint in found):
            print(f"not found: {words!r} after changing {name}; found: {found}")
            failures += 1
    print(f"{len(CASES[check])} violations planted, {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
