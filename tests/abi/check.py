#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check.py INCLUDE_DIRECTORY LIBRARY BASELINE_DIRECTORY [CC]: may old programs use this library?

Compares with the committed baseline (truckride-0.abi, constants.txt). Additions are allowed,
changes are not. Exit code 77 while there is no baseline. A new baseline is made by
    cmake --build build/dev --target abi-baseline
"""
import pathlib
import subprocess
import sys

from constants import facts

HERE = pathlib.Path(__file__).resolve().parent


def dump(include, library, out):
    """Write what abidiff compares. Private types are left out: callers never see them."""
    subprocess.run(["abidw", "--headers-dir", include, "--drop-private-types", "--no-show-locs",
                    "--no-corpus-path", "--no-comp-dir-path", "--out-file", out, library], check=True)
    out.write_text(out.read_text().replace(f"{pathlib.Path(include).resolve().parent}/", ""))


def symbol_complaints(include, library, baseline):
    command = ["abidiff", "--headers-dir2", include, "--drop-private-types", "--no-added-syms",
               "--suppressions", HERE / "suppressions.ini", baseline, library]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode:
        yield f"abidiff says {run.returncode}:\n{run.stdout}{run.stderr}"


def table(text):
    """(kind, name) -> numbers"""
    lines = (line.split() for line in text.splitlines())
    return {(kind, name): [float(number) for number in numbers] for kind, name, *numbers in lines}


def constant_complaints(old, new):
    old, new = table(old), table(new)
    for (kind, name), values in old.items():
        grows = kind == "size" and ("field", f"{name}.struct_size") in old
        now = new.get((kind, name))
        if now is None:
            yield f"{kind} {name} is gone"
        elif now != values and not (grows and now > values):
            yield f"{kind} {name} was {values}, is {now}"
    for (kind, name), values in new.items():
        size = old.get(("size", name.split(".")[0]))
        if kind == "field" and size and (kind, name) not in old and values[0] < size[0]:
            yield f"new field {name} lies at byte {values[0]:g}, inside the old struct of {size[0]:g}"


def check(include, library, baseline, cc="cc"):
    baseline = pathlib.Path(baseline)
    yield from symbol_complaints(include, library, baseline / "truckride-0.abi")
    yield from constant_complaints((baseline / "constants.txt").read_text(), facts(include, cc))


def main():
    if not (pathlib.Path(sys.argv[3]) / "truckride-0.abi").exists():
        print("skipped: no baseline is committed yet (target abi-baseline makes one)")
        return 77
    complaints = list(check(*sys.argv[1:]))
    for complaint in complaints:
        print(complaint)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
