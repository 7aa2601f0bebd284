# SPDX-License-Identifier: MIT
"""Damper and spring curves with their tables, loops of laws, signals over time."""
from __future__ import annotations

from typing import Optional, Sequence

import numpy as np
from matplotlib.axes import Axes

from ..curve import Curve
from ..law import Law
from ..signal import Signal
from .style import label, new_axes, readable, styled


@styled
def curve(shown: Curve, ax: Optional[Axes] = None, *, x: str = "velocity [m/s]",
          y: str = "force [kN]", scale: float = 1e-3, margin: float = 0.15,
          title: str = "") -> Axes:
    """A curve with the points of its table, continued a little beyond them.

    x, y label the axes; scale multiplies the ordinates (default: N to kN).
    """
    axes = new_axes(ax, 6.5, 4.2)
    table = shown.x
    reach = margin * (table[-1] - table[0])
    inside = np.linspace(table[0], table[-1], 600)
    line, = axes.plot(inside, scale * shown(inside), label=readable(shown.name))
    for end, outer in ((table[0], table[0] - reach), (table[-1], table[-1] + reach)):
        beyond = np.linspace(end, outer, 20)
        axes.plot(beyond, scale * shown(beyond), ":", color=line.get_color(), linewidth=1.2)
    axes.plot(table, scale * shown.y, "o", color=line.get_color(), markersize=4.5,
              markerfacecolor="white", markeredgewidth=1.2)
    axes.axhline(0, color="#999999", linewidth=0.8, zorder=1)
    axes.axvline(0, color="#999999", linewidth=0.8, zorder=1)
    axes.set_xlabel(f"{x}, extension positive")
    axes.set_ylabel(y)
    axes.margins(x=0)
    axes.set_title(title or readable(shown.name))
    return axes


@styled
def curves(shown: Sequence[Curve], ax: Optional[Axes] = None, title: str = "",
           x: str = "velocity [m/s]") -> Axes:
    """Several curves on one axis."""
    axes = new_axes(ax, 6.5, 4.2)
    for item in shown:
        curve(item, axes, x=x, title=" ")
    axes.legend(loc="best")
    axes.set_title(title)
    return axes


@styled
def loop(shown: Law, amplitude: float, frequency: float = 1.0, ax: Optional[Axes] = None, *,
         stiffness: float = 0.0, cycles: int = 2, x: str = "elongation [mm]",
         y: str = "force [kN]", scale: tuple[float, float] = (1e3, 1e-3),
         title: str = "") -> Axes:
    """Last cycle of a law under a sine of an amplitude [m or rad] and a frequency [Hz].

    stiffness [N/m] is that of the link beside the law; scale multiplies abscissa and ordinate.
    """
    axes = new_axes(ax, 6.5, 4.2)
    count = 1000
    time = np.arange(cycles * count + 1) / (count * frequency)
    path = amplitude * np.sin(2 * np.pi * frequency * time)
    force = shown.trace(path, 1 / (count * frequency)).force + stiffness * path
    last = slice(-count - 1, None)
    axes.plot(scale[0] * path[last], scale[1] * force[last], label=readable(shown.name))
    axes.set_xlabel(f"{x}, extension positive")
    axes.set_ylabel(y)
    axes.set_title(title or readable(shown.name))
    return axes


@styled
def signal(shown: Signal, until: float, ax: Optional[Axes] = None, *, unit: str = "m",
           x: str = "time [s]", title: str = "") -> Axes:
    """A signal from 0 until a time [s] or distance [m]."""
    axes = new_axes(ax, 8, 3.2)
    count = 4000
    axes.plot(np.linspace(0, until, count), shown.evaluate(count, until / (count - 1))[0],
              linewidth=1.0)
    axes.set_xlabel(x)
    axes.set_ylabel(label("value", unit))
    axes.margins(x=0)
    axes.set_title(title)
    return axes
