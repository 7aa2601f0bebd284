#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Run the damper_study example and check what it must show.

usage: damper_study.py PROGRAM
"""
import csv
import pathlib
import subprocess
import sys
import tempfile


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def demand(condition, sentence):
    if not condition:
        sys.exit(f"damper_study: {sentence}")


with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.argv[1], folder], check=True, stdout=subprocess.DEVNULL)
    folder = pathlib.Path(folder)
    table = {(r["model"], r["channel"], r["configuration"]): r for r in rows(folder / "damper_table.csv")}
    curves = rows(folder / "damper_curves.csv")
    findings = (folder / "findings.txt").read_text()

demand(len(table) == (2 + 5 + 5) * 3, f"{len(table)} rows, expected 36")
axles = {"quarter_front": ("front quarter car", "unsprung_z"), "half_truck": ("half truck", "front_axle_z"),
         "truck_3d": ("3D truck", "front_axle_left_z")}
for model, (title, channel) in axles.items():
    row = {c: table[model, channel, c] for c in ("standard", "harder", "undamped")}
    peak = {c: float(r["peak_hz"]) for c, r in row.items()}
    # The tires are trimmed to the undamped frequency, where the axle without damper rings.
    demand(abs(peak["undamped"] - 13.8) < 0.06, f"{model} rings at {peak['undamped']} Hz")
    demand(peak["harder"] < peak["standard"] < peak["undamped"], f"{model}: {peak}")
    height = {c: float(r["peak_psd"]) for c, r in row.items()}
    demand(height["harder"] < height["standard"] < height["undamped"], f"{model}: {height}")
    # The words say what the numbers say.
    change = peak["undamped"] - peak["standard"]
    demand(f"{title}: removing the damper raises the front axle's peak, from {peak['standard']:.2f} to "
           f"{peak['undamped']:.2f} Hz" in findings, f"{model}: the findings do not say {change:+.2f} Hz")
    demand(f"{title}: the harder damper lowers the front axle's peak PSD "
           f"(x {height['harder'] / height['standard']:.2f})" in findings, f"{model}: {height}")

# Equal wheels: the left half of the 3D truck is the half truck.
for (model, channel, configuration), row in table.items():
    if model == "half_truck":
        twin = table["truck_3d", channel.replace("_z", "_left_z"), configuration]
        demand(all(twin[k] == row[k] for k in ("peak_hz", "rms")), f"{row} and {twin}")

for row in curves:
    demand(abs(float(row["harder"]) - 2 * float(row["standard"])) < 0.02 and float(row["undamped"]) == 0,
           f"damper curves: {row}")
demand(findings.count("The thesis's truck differs: it fell from 13.8 to 11.8 Hz.") == 3,
       "the measured fall to 11.8 Hz is not set against the models")
print(next(line for line in findings.splitlines() if line.startswith("half truck: removing")))
