#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Run the calibrate_tires example and check what it must show.

usage: calibrate_tires.py PROGRAM
"""
import csv
import math
import pathlib
import re
import subprocess
import sys
import tempfile


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def demand(condition, sentence):
    if not condition:
        sys.exit(f"calibrate_tires: {sentence}")


with tempfile.TemporaryDirectory() as folder:
    run = subprocess.run([sys.argv[1], folder], check=True, capture_output=True, text=True)
    folder = pathlib.Path(folder)
    factors = {(r["model"], r["variant"], r["method"], r["axle"]): r for r in rows(folder / "factors.csv")}
    peaks = {(r["model"], r["variant"], r["channel"], r["tires"]): r for r in rows(folder / "peaks.csv")}
    spectra = list(folder.glob("psd_*.csv"))

# Two quarter cars with one axle, two trucks with two, each in three variants by three methods.
demand(len(factors) == 6 * 3 * 3, f"{len(factors)} calibrations, expected 54")
demand(len(spectra) == 4 * 3, f"{len(spectra)} files of spectra, expected 12")
for key, row in factors.items():
    demand(row["status"].startswith("success"), f"{key}: {row['status']}")
    demand(abs(float(row["after_hz"]) - float(row["target_hz"])) < 0.02, f"misses its target: {row}")
    low, factor, high = (float(row[k]) for k in ("low95", "factor", "high95"))
    demand(low < factor < high < 1.2 * low, f"no sensible interval: {row}")
    twin = ("half_truck", *key[1:])
    if key[0] == "truck_3d":
        difference = abs(factor / float(factors[twin]["factor"]) - 1)
        demand(difference < 1e-3, f"half truck and 3D truck need other tires: {row}")


def undamped_factor(frequency, sprung, unsprung, spring, tire):
    """Factor that gives the quarter car an eigenfrequency: det(K - omega^2 M) = 0 for the tire."""
    square = (2 * math.pi * frequency) ** 2
    wanted = square * unsprung - spring + spring**2 / (spring - square * sprung)
    return wanted / tire


# The front quarter car of the reference tractor: half of cab and frame's share, half of the axle.
cab, frame, wheelbase = 1242.63, 5842.370, 4.5
front = (cab * (4.5 + 0.4969) + frame * (4.5 - 2.22547)) / wheelbase / 2
expected = undamped_factor(13.8, front, 1084.781 / 2, 222276, 817500)
found = float(factors["quarter_front", "linear", "undamped", "front"]["factor"])
demand(abs(found / expected - 1) < 1e-3, f"front factor {found}, closed form {expected:.4f}")

# Damping lowers the frequency, so the damped mode needs a stiffer tire; the more the more damping.
for variant in ("linear", "thesis_dampers", "nonlinear"):
    by = {m: float(factors["quarter_front", variant, m, "front"]["factor"]) for m in ("undamped", "damped")}
    demand(by["damped"] > by["undamped"], f"{variant}: {by}")

# With its published shock absorbers the axle has no peak of its own, and the program says so.
row = factors["quarter_front", "nonlinear", "psd_peak", "front"]
demand(row["before_hz"] == "" and "no peak" in row["status"], f"a peak of an overdamped axle: {row}")

# The full sweep agrees with the short one of the calibration.
difference = float(re.search(r"by at most ([0-9.]+) %", run.stdout)[1])
demand(difference < 0.5, f"short and full run differ by {difference} %")
for model, channel, target in (("quarter_front", "unsprung_z", 13.8), ("half_truck", "rear_axle_z", 10)):
    peak = float(peaks[model, "thesis_dampers", channel, "psd_peak"]["peaks_hz"].split()[0])
    demand(abs(peak / target - 1) < 0.005, f"{model}, {channel}: {peak} Hz in the full run")
print(f"{len(factors)} calibrations; front factor {found} (closed form {expected:.3f}); "
      f"short and full run within {difference} %")
