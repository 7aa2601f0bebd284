# SPDX-License-Identifier: MIT
"""How the tests call the command, and the library that they compare it with (TRUCKRIDE_LIBRARY,
through the Python package; without it, tests of numbers are skipped)."""
import csv
import io
import json
import os
import pathlib
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMMAND = os.environ["TRUCKRIDE_COMMAND"]
TRUCK = "builtin:reference_truck"
HALF = "builtin:reference_half:linear"
QUARTER = "builtin:thesis_quarter"
sys.dont_write_bytecode = True
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the command does: the same bits


def environment(**more):
    plain = {name: value for name, value in os.environ.items() if name not in ("NO_COLOR", "TMPDIR")}
    return dict(plain, **more)


def call(*words, expected=0, text=True, **more):
    """Run truckride; its exit code must be the expected one."""
    extra = more.pop("environment", {})
    done = subprocess.run([COMMAND, *map(str, words)], env=environment(**extra), timeout=more.pop("timeout", 120), text=text,
                          capture_output="stdout" not in more, **more)
    assert done.returncode == expected, f"{words}: {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done


def rows(text):
    """CSV as dictionaries, numbers as floats; the unit is cut off the name."""
    def value(field):
        try:
            return float(field)
        except ValueError:
            return field
    table = list(csv.reader(io.StringIO(text)))
    names = [name.split(" [")[0] for name in table[0]]
    assert all(len(row) == len(names) for row in table)
    return [dict(zip(names, map(value, row))) for row in table[1:]]


def columns(text):
    table = rows(text)
    return {name: [row[name] for row in table] for name in table[0]}


def parsed(*words, **more):
    return json.loads(call(*words, "--format", "json", **more).stdout)


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture(scope="session")
def tr():
    if "TRUCKRIDE_LIBRARY" not in os.environ:
        pytest.skip("there is no shared library to compare with")
    sys.path.insert(0, str(ROOT / "bindings" / "python"))
    return pytest.importorskip("truckride")
