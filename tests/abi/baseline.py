#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""baseline.py INCLUDE_DIRECTORY LIBRARY BASELINE_DIRECTORY [CC]: replace the baseline of check.py
and client.py:

    truckride-0.abi   types and symbols, for abidiff
    constants.txt     values, sizes and offsets, for check.py
    headers.txt       the public headers without their comments, for client.py
"""
import pathlib
import re
import sys

from check import dump
from constants import facts


def pack(include):
    """All headers in one text: a line "=== NAME" before each."""
    parts = []
    for path in sorted((include / "truckride").glob("*.h")):
        code = re.sub(r"/\*.*?\*/|//[^\n]*", "", path.read_text(), flags=re.S)
        lines = (line.rstrip() for line in code.splitlines())
        parts += [f"=== {path.name}", *(line for line in lines if line)]
    return "\n".join(parts) + "\n"


def unpack(text, include):
    """Write what pack() packed into include/truckride."""
    (include / "truckride").mkdir(parents=True)
    for part in text.split("=== ")[1:]:
        name, code = part.split("\n", 1)
        (include / "truckride" / name).write_text(code)


def baseline(include, library, folder, cc="cc"):
    folder = pathlib.Path(folder)
    folder.mkdir(exist_ok=True)
    dump(include, library, folder / "truckride-0.abi")
    (folder / "constants.txt").write_text(facts(include, cc))
    (folder / "headers.txt").write_text(pack(pathlib.Path(include)))


if __name__ == "__main__":
    baseline(*sys.argv[1:])
