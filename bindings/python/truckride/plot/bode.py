# SPDX-License-Identifier: MIT
"""Frequency responses."""
from __future__ import annotations

from typing import Sequence

import numpy as np
from matplotlib.figure import Figure

from ..errors import ArgumentError
from ..linear import Response
from .style import new_figure, pretty, readable, styled

MOST_LINES = 6


@styled
def bode(response: Response, sensors: Sequence[str] = (), *, title: str = "",
         log: bool = True) -> Figure:
    """Magnitude over phase of some sensors; without names the first vertical accelerations."""
    names = list(sensors) or [name for name, unit in zip(response.sensors, response.units)
                              if unit == "m/s^2" and name.endswith("_z")][:MOST_LINES]
    units = {response.units[response.sensors.index(name)] for name in names}
    if len(units) != 1:
        raise ArgumentError(f"sensors of one unit are expected, not of {sorted(units)}")
    figure = new_figure(8, 5.6)
    upper, lower = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": [2, 1]})
    for name in names:
        values = response[name]
        upper.plot(response.frequency, np.abs(values), label=readable(name))
        phase = np.degrees(np.angle(values))
        jumps = np.abs(np.diff(phase)) > 180
        phase[1:][jumps] = np.nan  # no line across the page where the phase wraps
        lower.plot(response.frequency, phase)
    upper.set_yscale("log")
    if log:
        upper.set_xscale("log")
        upper.xaxis.set_major_formatter("{x:g}")
    upper.set_xlim(response.frequency[0], response.frequency[-1])
    upper.set_ylabel(f"magnitude [{pretty(units.pop())} per m]")
    upper.legend(loc="best")
    upper.set_title(title)
    lower.set_ylabel("phase [°]")
    lower.set_yticks([-180, -90, 0, 90, 180])
    lower.set_ylim(-185, 185)
    lower.set_xlabel("frequency [Hz]")
    return figure
