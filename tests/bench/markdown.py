# SPDX-License-Identifier: MIT
"""markdown.py BENCH.JSON: the rows of a run as the table of docs/benchmarks.md."""
import json
import sys

with open(sys.argv[1]) as file:
    rows = json.load(file)["rows"]

print("| subject | row | value | ratio | error | |\n|---|---|--:|---|--:|---|")
for row in rows:
    value = f"{row['value']:.4g} {row['unit']}" if "value" in row else ""
    ratio = f"{row['ratio']:.3g} x {row['of']}" if "ratio" in row else ""
    error = f"{row['error']:.1e}" if "error" in row else ""
    each = f"{row['each']:.3g} ns/{row['element']}" if "each" in row else ""
    note = "; ".join(text for text in (each, row.get("note")) if text)
    print(f"| {row['subject']} | {row['name']} | {value} | {ratio} | {error} | {note} |")
