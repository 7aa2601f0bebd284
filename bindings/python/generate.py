#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Write truckride/_abi.py and truckride/_options.py from the public headers.

usage: generate.py [--check] LIBRARY [INCLUDE_DIR]

LIBRARY is the libtruckride.so built from these headers: it knows the defaults. With --check
nothing is written; the exit status is 1 if a file is not what would be written.
"""
import argparse
import ctypes
import difflib
import pathlib
import sys

from generator import abi, headers, options

HERE = pathlib.Path(__file__).resolve().parent


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true")
    parser.add_argument("library")
    parser.add_argument("include", nargs="?", default=HERE.parents[1] / "include",
                        type=pathlib.Path)
    arguments = parser.parse_args()
    declared = headers.read(arguments.include)
    texts = {"_abi.py": abi.write(declared),
             "_options.py": options.write(declared, ctypes.CDLL(arguments.library))}
    different = 0
    for name, text in texts.items():
        path = HERE / "truckride" / name
        before = path.read_text() if path.exists() else ""
        if before == text:
            continue
        different = 1
        if arguments.check:
            sys.stdout.writelines(difflib.unified_diff(
                before.splitlines(True), text.splitlines(True), f"committed {name}",
                f"generated {name}", n=1))
        else:
            path.write_text(text)
    return different if arguments.check else 0


if __name__ == "__main__":
    sys.exit(main())
