# SPDX-License-Identifier: MIT
"""smoke.py BENCH SUBJECT: run a subject with tiny sizes. The JSON parses, every row compares
something or says why not, and every error is within its bound. Times are not looked at."""
import json
import pathlib
import subprocess
import sys
import tempfile

bench, subject = sys.argv[1:]
with tempfile.TemporaryDirectory() as folder:
    path = pathlib.Path(folder) / "bench.json"
    run = subprocess.run([bench, "--tiny", "--json", path, subject], capture_output=True, text=True)
    print(run.stdout, run.stderr, sep="\n")
    assert run.returncode == 0, f"the benchmark ended with {run.returncode}"
    rows = json.loads(path.read_text())["rows"]

assert {row["subject"] for row in rows} == {"machine", subject}, "a subject is missing"
assert len(run.stdout.splitlines()) == len(rows) + 1, "table and JSON differ"
for row in rows:
    what = f"{row['subject']}: {row['name']}"
    assert "ratio" in row or "bound" in row or "note" in row, f"{what}: compares nothing"
    for key in "value", "ratio", "each":
        assert key not in row or row[key] >= 0, f"{what}: {key} is {row[key]}"
    if "bound" in row:
        assert row["error"] <= row["bound"], f"{what}: error {row['error']} > {row['bound']}"
