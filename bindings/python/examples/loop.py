#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A loop with hardware: each millisecond a controller reads sensors and sets a load.

usage: loop.py [RESULTS_FOLDER]

The "hardware" is a skyhook damper on the sprung mass of the quarter car, computed here; on a
test bench the line that sets the load would read an actuator instead.
"""
import pathlib
import sys
import time

import matplotlib
import numpy as np
import truckride as tr
from truckride import plot

matplotlib.use("Agg")
STEP, SKYHOOK = 0.001, 15e3  # [s], [N s/m]


def build():
    spec = tr.vehicle("thesis_quarter")
    spec.add_port("actuator", "sprung")
    spec.add_sensor("sprung_velocity", "velocity", body="sprung")
    return spec.compile()


def drive(model, road, rate, gain):
    """Recorded sensors of a run, and the time a turn of the loop takes [s]."""
    stepper = tr.Newmark(model, step=STEP)
    velocity = model.sensors.index("sprung_velocity")
    record = np.empty((len(road), len(stepper.sensors)))
    height, speed, load, step, read = (stepper.height, stepper.velocity, stepper.load,
                                       stepper.step, stepper.read)
    started = time.perf_counter()
    for k in range(len(road)):
        height[0], speed[0] = road[k], rate[k]
        step()
        record[k] = read()
        load[0] = -gain * record[k, velocity]
    return record, (time.perf_counter() - started) / len(road)


@plot.styled
def main(folder="."):
    model = build()
    road, rate = tr.sweep(duration=30, amplitude=0.005).evaluate(30000, STEP)
    figure = plot.new_figure(9, 3.8)
    axes = figure.add_subplot()
    for gain, name in ((0.0, "passive"), (SKYHOOK, "skyhook")):
        record, turn = drive(model, road, rate, gain)
        series = tr.Series({name: record[:, model.sensors.index("sprung_z")]}, 1 / STEP,
                           units={name: "m/s^2"})
        plot.channels([series[name]], axes, title=" ")
        print(f"{name:8s} RMS {series[name].rms:.3f} m/s^2, {turn * 1e6:.1f} us a turn of the loop")
    axes.lines[0].set_label("passive")
    axes.lines[1].set_label("skyhook damper in the loop")
    axes.legend(loc="upper right")
    axes.set_title("Sprung mass of the quarter car over a sweep")
    figure.savefig(pathlib.Path(folder, "loop.png"))


if __name__ == "__main__":
    main(*sys.argv[1:])
