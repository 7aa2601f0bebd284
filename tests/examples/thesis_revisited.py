#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Run the thesis_revisited example and check what it must show.

usage: thesis_revisited.py PROGRAM
"""
import csv
import pathlib
import subprocess
import sys
import tempfile

MODEL = pathlib.Path(__file__).resolve().parents[2] / "examples/models/tractor_4x2.json"


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(line for line in file if line.strip()))


def demand(condition, sentence):
    if not condition:
        sys.exit(f"thesis_revisited: {sentence}")


with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.argv[1], folder, str(MODEL)], check=True, capture_output=True)
    folder = pathlib.Path(folder)
    fitted = rows(folder / "fit.csv")
    peaks = {(r["model"], r["axle"], r["explanation"], r["front_damper"]): float(r["peak_hz"])
             for r in rows(folder / "peaks.csv")}
    frames = {(r["channel"], r["frame"]): [float(f) for f in r["peaks_hz"].split()]
              for r in rows(folder / "frame_peaks.csv")}
    amplitude = rows(folder / "amplitude.csv")
    findings = (folder / "findings.txt").read_text()

for row in fitted:
    low, value, high = (float(row[k]) for k in ("low", "fitted", "high"))
    demand(low * 0.999 <= value <= high * 1.001, f"outside its published range: {row}")
for model in "quarter_front", "half_truck", "truck_3d":
    def peak(explanation, damper):
        return peaks[model, "front", explanation, damper]
    demand(peak("original", "standard") < 8, f"{model}: original tires {peak('original', 'standard')}")
    demand(abs(peak("trimmed_tires", "standard") - 13.8) < 0.2, f"{model}: tires not trimmed")
    demand(peak("trimmed_tires", "undamped") > peak("trimmed_tires", "standard") - 0.05,
           f"{model}: the rigid model's peak falls without its damper, which the thesis did not see")
    demand(12.5 < peak("leaf_friction", "standard") < 14.3, f"{model}: no friction peak near 13.8 Hz")
    demand(peak("leaf_friction", "undamped") < peak("leaf_friction", "standard") - 0.1,
           f"{model}: with friction the peak does not fall without the damper")
# Equal motion of both sides: the half truck is the 3D truck.
for key, value in peaks.items():
    if key[0] == "half_truck":
        demand(abs(value - peaks[("truck_3d", *key[1:])]) < 0.02, f"{key}: half truck and 3D truck differ")
demand(abs(peaks["quarter_rear", "rear", "leaf_friction", "standard"] - 10) < 0.5, "rear axle not at 10 Hz")
demand(len(amplitude) == 4, "four amplitudes are expected")
demand(frames["frame_front_left_z", "flexible"] != frames["frame_front_left_z", "rigid"],
       "the frame's flexibility changes nothing")
demand("falls, as on the truck" in findings and "axle peaks come within" in findings, "no findings")
