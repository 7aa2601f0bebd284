#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""SciPy drives the model: cab mounts for the least weighted vibration on the same travel.

usage: optimise.py [RESULTS_FOLDER]

The objective is the Wk-weighted RMS of the cab on a road of ISO 8608, class B at 80 km/h; the
front mount may not move further than as built. Linear random response: no time stepping, a few
milliseconds an evaluation.
"""
import pathlib
import sys

import matplotlib
import numpy as np
import scipy.optimize
import truckride as tr
from truckride import plot

matplotlib.use("Agg")
SPEED, CLASS_B = 80 / 3.6, 64e-6  # [m/s], [m^3] at 0.1 cycles/m
FREQUENCY = np.linspace(0.3, 30, 400)
ROAD = CLASS_B * (FREQUENCY / SPEED / 0.1) ** -2 / SPEED  # [m^2/Hz]
WEIGHT = np.abs(tr.comfort.weighting_response("wk", FREQUENCY))


def respond(factors):
    """Spectra of the half truck with stiffness and damping of the cab mounts multiplied."""
    spec = tr.vehicle("reference_half")
    spec.vary("cab_*_vertical", "stiffness", factors[0])
    spec.vary("cab_*_vertical", "damping", factors[1])
    spec.add_sensor("travel", "elongation", link="cab_front_vertical")
    model = spec.compile()
    inputs = tr.road_cross_spectra(model, FREQUENCY, ROAD, SPEED)
    return tr.response_psd(model, FREQUENCY, inputs)


def weighted_rms(response):
    density = response.psd["cab_front_z"].density
    return float(np.sqrt(np.trapz(WEIGHT ** 2 * density, FREQUENCY)))


@plot.styled
def main(folder="."):
    built = respond([1, 1])

    def objective(logarithms):
        response = respond(np.exp(logarithms))
        excess = max(0.0, response.rms["travel"] / built.rms["travel"] - 1)
        return weighted_rms(response) + 10 * excess

    found = scipy.optimize.minimize(objective, [0.0, 0.0], method="Nelder-Mead",
                                    bounds=[np.log([0.3, 3])] * 2,
                                    options={"xatol": 1e-3, "fatol": 1e-5})
    factors = np.exp(found.x)
    best = respond(factors)
    print(f"weighted RMS {weighted_rms(built):.3f} -> {weighted_rms(best):.3f} m/s^2, travel "
          f"{1e3 * built.rms['travel']:.2f} -> {1e3 * best.rms['travel']:.2f} mm with stiffness "
          f"x {factors[0]:.2f}, damping x {factors[1]:.2f} after {found.nfev} evaluations")
    axes = plot.psd(built.psd["cab_front_z"], peaks=1, label="as built")
    plot.psd(best.psd["cab_front_z"], axes, peaks=1, label="optimised mounts", limit=20,
             title="Cab at its front mount on a class B road at 80 km/h")
    axes.legend()
    axes.figure.savefig(pathlib.Path(folder, "optimise.png"))


if __name__ == "__main__":
    main(*sys.argv[1:])
