#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Trim the tires to measured axle frequencies, and show before and after.

usage: tires.py [RESULTS_FOLDER]
"""
import pathlib
import sys

import matplotlib
import truckride as tr

matplotlib.use("Agg")


def main(folder="."):
    spec = tr.vehicle("reference_truck", "thesis_dampers")
    with tr.Calibration(spec) as calibration:
        for axle, measured in (("front", 13.8), ("rear", 10.0)):
            calibration.add_parameter(f"{axle} tire stiffness", f"{axle}_*_tire")
            calibration.target_frequency(f"{axle} axle", measured, f"{axle}_axle.z", damped=False,
                                         uncertainty=0.1)
        solution = calibration.solve(progress=True)
        calibration.apply(spec)
    print(solution)
    print(spec.compile().modes(damped=False))
    figure = solution.plot(title="Tires trimmed to the measured axle frequencies")
    figure.savefig(pathlib.Path(folder, "tires.png"))


if __name__ == "__main__":
    main(*sys.argv[1:])
