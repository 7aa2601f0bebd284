#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""baseline.py INCLUDE_DIRECTORY LIBRARY BASELINE_DIRECTORY [CC]: replace the baseline of check.py."""
import pathlib
import sys

from check import dump
from constants import facts


def baseline(include, library, folder, cc="cc"):
    folder = pathlib.Path(folder)
    dump(include, library, folder / "truckride-0.abi")
    (folder / "constants.txt").write_text(facts(include, cc))


if __name__ == "__main__":
    baseline(*sys.argv[1:])
