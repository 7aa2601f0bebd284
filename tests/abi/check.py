#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""check.py INCLUDE_DIRECTORY LIBRARY BASELINE_DIRECTORY [CC]: may old programs use this library?

Compares with the committed baseline (truckride-0.abi, constants.txt). Additions that the headers
declare are allowed, changes are not. A new baseline, for a new ABI number, is made by
    cmake --build build/dev --target abi-baseline
"""
import pathlib
import subprocess
import sys
import tempfile

from constants import facts

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "style"))
import exports  # noqa: E402

# Fields may be appended to structs that carry their own size, and nothing else may change.
# Without type_kind a field inserted in the middle would be let through too.
APPENDED = """[suppress_type]
  type_kind = struct
  name_regexp = ^({})$
  has_data_member_inserted_at = end
"""


def dump(include, library, out):
    """Write what abidiff compares. Private types are left out: callers never see them."""
    subprocess.run(["abidw", "--headers-dir", include, "--drop-private-types", "--no-show-locs",
                    "--no-corpus-path", "--no-comp-dir-path", "--out-file", out, library], check=True)
    out.write_text(out.read_text().replace(f"{pathlib.Path(include).resolve().parent}/", ""))


def table(text):
    """(kind, name) -> numbers"""
    lines = (line.split() for line in text.splitlines())
    return {(kind, name): [float(number) for number in numbers] for kind, name, *numbers in lines}


def sized(facts_of_structs):
    """Structs whose first field is their size: these may grow."""
    return {name.split(".")[0] for (kind, name), values in facts_of_structs.items()
            if kind == "field" and name.endswith(".struct_size") and values[0] == 0}


def symbol_complaints(include, library, baseline, growing):
    with tempfile.NamedTemporaryFile("w", suffix=".ini") as suppressions:
        suppressions.write(APPENDED.format("|".join(sorted(growing))))
        suppressions.flush()
        command = ["abidiff", "--headers-dir2", include, "--drop-private-types", "--no-added-syms",
                   "--suppressions", suppressions.name, baseline, library]
        run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode:
        yield f"abidiff says {run.returncode}:\n{run.stdout}{run.stderr}"


def constant_complaints(old, new):
    growing = sized(old)
    for (kind, name), values in old.items():
        now = new.get((kind, name))
        if now is None:
            yield f"{kind} {name} is gone"
        elif now != values and not (kind == "size" and name in growing and now > values):
            yield f"{kind} {name} was {values}, is {now}"
    for (kind, name), values in new.items():
        size = old.get(("size", name.split(".")[0]))
        if kind == "field" and size and (kind, name) not in old and values[0] < size[0]:
            yield f"new field {name} lies at byte {values[0]:g}, inside the old struct of {size[0]:g}"


def check(include, library, baseline, cc="cc"):
    baseline = pathlib.Path(baseline)
    old = table((baseline / "constants.txt").read_text())
    yield from symbol_complaints(include, library, baseline / "truckride-0.abi", sized(old))
    yield from constant_complaints(old, table(facts(include, cc)))
    yield from exports.check(pathlib.Path(include).parent, library)


def main():
    if not (pathlib.Path(sys.argv[3]) / "truckride-0.abi").exists():
        print("there is no baseline (target abi-baseline makes one)")
        return 1
    complaints = list(check(*sys.argv[1:]))
    for complaint in complaints:
        print(complaint)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
