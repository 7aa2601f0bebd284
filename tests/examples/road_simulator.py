#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Run the road-simulator example and check what it must show.

usage: road_simulator.py PROGRAM
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
        sys.exit(f"road_simulator: {sentence}")


with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.argv[1], folder], check=True, stdout=subprocess.DEVNULL)
    folder = pathlib.Path(folder)
    peaks = {(r["model"], r["channel"], r["configuration"]): r for r in rows(folder / "peaks.csv")}
    verification = rows(folder / "verification.csv")
    signals = (folder / "time_truck_3d_standard.csv").read_text().splitlines()

# Equal input left and right: half truck and 3D truck are one model, and nothing rolls.
for (model, channel, configuration), row in peaks.items():
    if model == "half_truck":
        for side in ("left", "right"):
            head, axis = channel.rsplit("_", 1)
            twin = peaks.get(("truck_3d", f"{head}_{side}_{axis}", configuration))
            if twin:
                demand(twin["peak_hz"] == row["peak_hz"], f"{channel} peaks elsewhere in 3D: {twin}")
    if model == "truck_3d" and channel.endswith("_y"):
        demand(row["peak_hz"] == "" and float(row["rms"]) == 0, f"lateral motion: {row}")

# Without its damper the front axle rings at its eigenfrequency, louder than with it.
loud, quiet = (peaks["half_truck", "front_axle_z", c] for c in ("undamped", "standard"))
demand(abs(float(loud["peak_hz"]) - 7.05) < 0.06, f"undamped front axle: {loud}")
demand(float(loud["rms"]) > 3 * float(quiet["rms"]), f"{loud} not louder than {quiet}")

# The thesis's printed axes: sprung mass to 0.016 m, unsprung to 0.012 m.
for coordinate, peak in (("sprung.z", 0.016), ("unsprung.z", 0.012)):
    row = next(r for r in verification
               if (r["model"], r["input"], r["coordinate"]) == ("thesis_quarter", "step", coordinate))
    demand(abs(float(row["peak"]) - peak) < 0.0005, f"step response of the thesis: {row}")
worst = max(verification, key=lambda r: float(r["relative"]))
demand(float(worst["relative"]) < 1e-4, f"differs from the independent integrator: {worst}")
demand(len(signals) == 24002, f"{len(signals)} lines of time signals, expected 24002")
print(f"{len(peaks)} peaks; largest difference from the reference {worst['relative']} ({worst['model']})")
