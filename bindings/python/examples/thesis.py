#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The thesis in 40 lines: three front-axle dampers on the road simulator.

usage: thesis.py [RESULTS_FOLDER]

T. Lundberg, Analysis of simplified dynamic truck models for parameter evaluation (KTH, 2013):
a sweep from 0.8 to 20 Hz in 480 s, here on the reference tractor's 13-DOF model.
"""
import pathlib
import sys

import matplotlib
import truckride as tr
from truckride import plot

matplotlib.use("Agg")
SENSORS = {"front_axle_left_z": "front axle", "frame_front_left_z": "frame at front cab mount",
           "cab_front_left_z": "cab at front mount"}


@plot.styled
def main(folder="."):
    models = []
    for scale in (1, 2, 0):
        spec = tr.vehicle("reference_truck", "thesis_dampers")
        for side in ("left", "right"):
            spec.update_link(f"front_{side}_damper", damper_scale=scale)
        models.append(spec.compile())
    runs = [tr.simulate(model, tr.sweep(), 480, progress=True) for model in models]
    figure = plot.new_figure(11, 4)
    for panel, (sensor, title) in zip(figure.subplots(1, 3), SENSORS.items()):
        for run, name in zip(runs, ("standard", "harder", "undamped")):
            spectrum = run[sensor].psd(segment_length=8192, overlap=0.9)
            marked = int(name == "standard" and title == "front axle")
            plot.psd(spectrum, panel, peaks=marked, label=name, title=title)
            peak = spectrum.peaks(1)[0]
            print(f"{title:26s} {name:9s} peak {peak.frequency:5.2f} Hz, "
                  f"RMS {run[sensor].rms:6.3f} m/s^2")
        panel.legend(title="front damper")
    figure.savefig(pathlib.Path(folder, "thesis.png"))


if __name__ == "__main__":
    main(*sys.argv[1:])
