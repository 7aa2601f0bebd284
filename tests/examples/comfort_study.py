#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Run the comfort_study example and check what it must show.

usage: comfort_study.py PROGRAM
"""
import csv
import itertools
import math
import pathlib
import subprocess
import sys
import tempfile

DURATION = 240  # s
DAMPERS = "standard", "harder", "undamped"
QUANTITIES = {  # and its error
    "cab_x_wd": "cab_x_wd_error", "cab_y_wd": "cab_y_wd_error", "cab_z_wk": "cab_z_wk_error",
    "total": "total_error", "front_dlc": "front_dlc_error", "rear_dlc": "rear_dlc_error",
    "front_travel_m": "front_travel_error_m", "rear_travel_m": "rear_travel_error_m"}
WORDS = ((0, 0.315, "not uncomfortable"), (0.315, 0.63, "a little uncomfortable"),
         (0.5, 1, "fairly uncomfortable"), (0.8, 1.6, "uncomfortable"),
         (1.25, 2.5, "very uncomfortable"), (2, math.inf, "extremely uncomfortable"))


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def wk_squared(f):
    """Squared magnitude of Wk, ISO 8041-1."""
    def quadratic(corner, q):
        return 1 + 1j * f / (q * corner) - (f / corner) ** 2
    band = f ** 4 / (f ** 4 + 0.4 ** 4) / (1 + (f / 100) ** 4)
    weight = (1 + 1j * f / 12.5) / quadratic(12.5, 0.63) * quadratic(2.37, 0.91) / quadratic(3.35, 0.91)
    return band * abs(weight * (2.37 / 3.35) ** 2) ** 2


def demand(condition, sentence):
    if not condition:
        sys.exit(f"comfort_study: {sentence}")


with tempfile.TemporaryDirectory() as folder:
    subprocess.run([sys.argv[1], folder], check=True, stdout=subprocess.DEVNULL)
    folder = pathlib.Path(folder)
    table = {(r["truck"], r["method"], r["class"], r["speed_km_h"], r["damper"]): r
             for r in rows(folder / "comfort_table.csv")}
    run_psd, exact_psd = rows(folder / "psd_time.csv"), rows(folder / "psd_frequency.csv")
    deviations = rows(folder / "agreement.csv")
    findings = (folder / "findings.txt").read_text()
    text = (folder / "comfort_table.txt").read_text()

studied = ("thesis_dampers", "time"), ("linear", "time"), ("linear", "frequency")
cases = list(itertools.product(("B", "C"), ("50", "70", "90"), DAMPERS))
demand(set(table) == {s + c for s in studied for c in cases}, f"the table lacks rows: {len(table)}")
demand("has no seat" in text, "the table does not say that there is no seat")

for key, row in table.items():
    for name, error in QUANTITIES.items():
        value, chance = float(row[name]), float(row[error])
        demand(0 < chance < 0.1 * value, f"{key}: {name} {value} +- {chance}")
    for axle in "front", "rear":
        demand(0 < float(row[f"{axle}_dlc"]) < 1, f"{key}: DLC {row[f'{axle}_dlc']}")
    z, total = float(row["cab_z_wk"]), float(row["total"])
    demand(abs(math.hypot(z, float(row["cab_y_wd"]), float(row["cab_x_wd"])) / total - 1) < 1e-4,
           f"{key}: the sum is not that of its axes")
    demand(row["words"] == " / ".join(w for low, high, w in WORDS if low <= total <= high),
           f"{key}: {total} m/s^2 is not {row['words']}")
    # An RMS of n degrees of freedom has the relative error 1 / sqrt(2 n).
    demand(abs(float(row["cab_z_wk_error"]) / z * math.sqrt(2 * float(row["cab_z_freedoms"])) - 1) < 1e-4,
           f"{key}: the error does not follow from the degrees of freedom")
    if row["method"] == "time":
        # (VDV / RMS)^4 / T is the kurtosis: 3 if Gaussian, hardly more with these dampers.
        kurtosis = (float(row["cab_z_vdv"]) / z) ** 4 / DURATION
        demand(2.7 < kurtosis < (3.3 if row["truck"] == "linear" else 5), f"{key}: kurtosis {kurtosis}")
        for axle in "front", "rear":
            crest = float(row[f"{axle}_travel_peak_m"]) / float(row[f"{axle}_travel_m"])
            demand(2.5 < crest < 8, f"{key}: {axle} peak travel is {crest} times the RMS")

# The linear truck: time steps and spectra agree, and the plot shows the same differences.
largest = 0
for case, (name, error) in itertools.product(cases, QUANTITIES.items()):
    run, exact = table["linear", "time", *case], table["linear", "frequency", *case]
    difference = (float(run[name]) - float(exact[name])) / float(run[error])
    largest = max(largest, abs(difference))
    demand(abs(difference) < 3, f"{case}: {name} {run[name]} in time, {exact[name]} by spectra: "
                                f"{difference:.1f} standard errors")
    # The run's own estimate of its error against that of the exact spectrum.
    demand(0.85 < float(run[error]) / float(exact[error]) < 1.15,
           f"{case}: error of {name} {run[error]}, by the exact spectrum {exact[error]}")
demand(abs(max(abs(float(r["deviation_in_errors"])) for r in deviations) - largest) < 0.01,
       "agreement.csv shows other differences than the table")
demand(f"at most {largest:.2f} standard errors" in findings, f"the findings do not say {largest:.2f}")

# Class C has four times the density of B: twice everything where the truck is linear.
for speed, damper, name in itertools.product(("50", "70", "90"), DAMPERS, QUANTITIES):
    ratio = {s: float(table[s + ("C", speed, damper)][name]) / float(table[s + ("B", speed, damper)][name])
             for s in studied}
    demand(abs(ratio["linear", "frequency"] - 2) < 2e-5, f"spectra: {name} rises by {ratio}")
    # The mean load of a run, by which its deviation is divided, is the static one by 1e-3 only.
    demand(abs(ratio["linear", "time"] - 2) < 1e-3, f"time steps: {name} rises by {ratio}")
    demand(1.5 < ratio["thesis_dampers", "time"] < 2.6, f"dampers of the thesis: {name} rises by {ratio}")

# Without its damper the front axle loads the road much more, the rear one as before.
for truck, method in studied:
    for road, speed in itertools.product("BC", ("50", "70", "90")):
        with_, without = (table[truck, method, road, speed, d] for d in ("standard", "undamped"))
        demand(float(without["front_dlc"]) > 1.8 * float(with_["front_dlc"]) and
               abs(float(without["rear_dlc"]) / float(with_["rear_dlc"]) - 1) < 0.15,
               f"{truck}, {method}, {road}, {speed} km/h: front damper removed")

# The spectra of the picture: the same power between 1 and 15 Hz.
power = []
for psd, column in (run_psd, "linear"), (exact_psd, "linear"), (run_psd, "thesis_dampers"):
    step = float(psd[0]["frequency_hz"])
    power.append(sum(float(r[column]) * step for r in psd if 1 <= float(r["frequency_hz"]) <= 15))
demand(abs(power[0] / power[1] - 1) < 0.06, f"PSD of the cab: mean squares {power[0]} and {power[1]}")
demand(power[2] != power[0] and power[2] > 0, "PSD with the dampers of the thesis")
# RMS and degrees of freedom 2 T (int G df)^2 / int G^2 df of the plotted exact spectrum, from scratch.
shown = table["linear", "frequency", "B", "70", "standard"]
step = float(exact_psd[0]["frequency_hz"])
weighted = [float(r["linear"]) * wk_squared(float(r["frequency_hz"])) for r in exact_psd]
rms = math.sqrt(sum(weighted) * step)
freedoms = 2 * DURATION * sum(weighted) ** 2 * step / sum(g * g for g in weighted)
demand(abs(rms / float(shown["cab_z_wk"]) - 1) < 1e-3, f"weighted RMS {shown['cab_z_wk']}, here {rms}")
demand(abs(freedoms / float(shown["cab_z_freedoms"]) - 1) < 1e-3,
       f"{shown['cab_z_freedoms']} degrees of freedom, here {freedoms}")
print(next(line for line in findings.splitlines() if line.startswith("They differ")))
