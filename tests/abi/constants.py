#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""constants.py INCLUDE_DIRECTORY [CC]: what callers compile into their programs, one fact a line:

    constant TRK_E_RANGE 4
    size trk_curve_options 16
    field trk_curve_options.interpolation 8 4        (offset, size)

abidiff does not see anonymous enums and macros, and is told to ignore appended fields; these
lines catch a renumbered constant and a field that moved or filled a gap. The compiler is
asked for the values; only the names are read from the headers. Names that end in _ are no
constants for users, and versions must change.
"""
import pathlib
import re
import subprocess
import sys
import tempfile


def preprocessed(include, cc, *options):
    source = "".join(f"#include <truckride/{path.name}>\n"
                     for path in sorted((include / "truckride").glob("*.h")))
    command = [cc, "-std=c11", "-E", f"-I{include}", *options, "-x", "c", "-"]
    return source, subprocess.run(command, input=source, check=True, capture_output=True,
                                  text=True).stdout


def names(include, cc):
    """Enumerators, numeric macros, and structs with their fields, in order of declaration."""
    source, text = preprocessed(include, cc, "-P")
    constants = []
    for body in re.findall(r"\benum\b[^{};]*\{([^}]*)\}", text):
        constants += re.findall(r"\b(TRK_\w*[A-Z0-9])\s*(?==|,|\Z|\s*$)", body)
    _, macros = preprocessed(include, cc, "-dM")
    for name, value in re.findall(r"^#define (TRK_\w+) (.*)$", macros, re.M):
        if re.fullmatch(r"\(?-?[0-9][0-9a-zA-Z.+-]*\)?", value) and "_VERSION_" not in name:
            constants.append(name)
    structs = {}
    for name, body in re.findall(r"\bstruct (trk_\w+)\s*\{([^}]*)\}", text):
        declarators = (re.search(r"(\w+)\s*(?:\[[^\]]*\]\s*)*$", part.strip())
                       for line in body.split(";") if line.strip() for part in line.split(","))
        structs[name] = [match[1] for match in declarators if match]
    return source, sorted(set(constants)), structs


def facts(include, cc="cc"):
    source, constants, structs = names(pathlib.Path(include), cc)
    # A macro may be a double: %.17g prints integers and doubles alike.
    lines = [f'printf("constant {name} %.17g\\n", (double)({name}));' for name in constants]
    for struct, fields in sorted(structs.items()):
        lines.append(f'printf("size {struct} %zu\\n", sizeof(struct {struct}));')
        lines += [f'printf("field {struct}.{field} %zu %zu\\n", offsetof(struct {struct}, {field}), '
                  f'sizeof(((struct {struct} *)0)->{field}));' for field in fields]
    program = "#include <stdio.h>\n" + source + "int main(void)\n{\n" + "\n".join(lines) + "\n}\n"
    with tempfile.TemporaryDirectory() as folder:
        binary = f"{folder}/facts"
        subprocess.run([cc, "-std=c11", f"-I{include}", "-o", binary, "-x", "c", "-"],
                       input=program, check=True, text=True)
        return subprocess.run([binary], check=True, capture_output=True, text=True).stdout


if __name__ == "__main__":
    sys.stdout.write(facts(*sys.argv[1:]))
