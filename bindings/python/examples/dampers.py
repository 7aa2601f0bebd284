#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A damper study: ride in the cab over front and rear axle damping, 200 cases over all cores.

usage: dampers.py [RESULTS_FOLDER]
"""
import pathlib
import sys

import matplotlib
import truckride as tr
from truckride import plot

matplotlib.use("Agg")


@plot.styled
def main(folder="."):
    spec = tr.vehicle("reference_half", "thesis_dampers")
    model = spec.compile()
    with tr.Study(spec, design="latin_hypercube", points=200, duration=20.0, settle=2.0,
                  seed=7) as study:
        study.add_parameter("front damper factor", "front_damper", "damping", lower=0.25, upper=4,
                            distribution="log_uniform")
        study.add_parameter("rear damper factor", "rear_damper", "damping", lower=0.25, upper=4,
                            distribution="log_uniform")
        study.add_output("cab RMS", "cab_front_z", "band_rms", low=0.5, high=20)
        study.add_output("axle RMS", "front_axle_z", "band_rms", low=4, high=20)
        study.add_excitation("sweep", tr.Excitation(model, tr.sweep(duration=20, amplitude=0.005)))
        study.run(progress=True)
        table = study.table()
        best = table.outputs["cab RMS"].argmin()
        print(f"{study}: least cab RMS {table.outputs['cab RMS'][best]:.3f} m/s^2 with "
              + ", ".join(f"{name} {values[best]:.2f}"
                          for name, values in table.parameters.items()))
        study.write_csv(pathlib.Path(folder, "dampers.csv"))
        figure = plot.new_figure(10.5, 6.4)
        panels = figure.subplots(2, 2)
        for row, output in zip(panels, table.outputs):
            for panel, (name, values) in zip(row, table.parameters.items()):
                panel.plot(values, table.outputs[output], "o", markersize=3.5, alpha=0.7)
                panel.set_xscale("log")
                panel.set_xticks([0.25, 0.5, 1, 2, 4], ["0.25", "0.5", "1", "2", "4"])
                panel.minorticks_off()
                panel.grid(True, color="#e4e4e4")
                panel.set_xlabel(f"{name} [-]")
                panel.set_ylabel(f"{output} [m/s²]")
        figure.savefig(pathlib.Path(folder, "dampers.png"))


if __name__ == "__main__":
    main(*sys.argv[1:])
