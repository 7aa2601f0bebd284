# SPDX-License-Identifier: MIT
"""Time signals and spectra."""
from __future__ import annotations

from typing import Any, Optional, Sequence

import numpy as np
from matplotlib.axes import Axes

from ..errors import ArgumentError
from ..series import Channel, Series
from ..spectrum import Psd
from .style import COLORS, DARK, label, new_axes, pretty, readable, styled

MOST_LINES = 6
MOST_POINTS = 4000
QUANTITY = {"m/s^2": "acceleration", "m/s": "velocity", "m": "displacement", "N": "force"}


def choose(series: Series, names: Sequence[str]) -> list[Channel]:
    """The named channels; without names the first vertical accelerations."""
    if names:
        return [series[name] for name in names]
    every = [series[name] for name in series]
    vertical = [c for c in every if c.unit == "m/s^2" and c.name.endswith("_z")]
    return (vertical or every)[:MOST_LINES]


def thin(channel: Channel) -> tuple[Any, Any]:
    """Time and values with no more points than a plot can show: extremes of blocks stay."""
    block = len(channel) // (MOST_POINTS // 2)
    if block < 2:
        return channel.time, channel.values
    count = len(channel) // block
    rows = channel.values[:count * block].reshape(count, block)
    values = np.column_stack([rows.min(axis=1), rows.max(axis=1)]).ravel()
    return channel.start + np.arange(2 * count) * block / (2 * channel.rate), values


@styled
def channels(shown: Sequence[Channel], ax: Optional[Axes] = None, title: str = "") -> Axes:
    """Time signals, one axis per unit: channels of another unit are refused."""
    units = {channel.unit for channel in shown}
    if len(units) != 1:
        raise ArgumentError(f"channels of one unit are expected, not of {sorted(units)}")
    axes = new_axes(ax, 9, 3.6)
    for channel in sorted(shown, key=lambda c: -c.rms):  # the small ones in front
        axes.plot(*thin(channel), linewidth=1.0, label=readable(channel.name))
    axes.set_xlabel("time [s]")
    axes.margins(x=0)
    single = len(shown) == 1
    unit = units.pop()
    axes.set_ylabel(label(QUANTITY.get(unit, "value"), unit))
    if not single:
        axes.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=3)
    axes.set_title(title or (readable(shown[0].name) if single else ""))
    return axes


def _mark(axes: Axes, spectrum: Psd, count: int, limit: float, color: str) -> None:
    """Frequencies of the highest peaks, written beside them."""
    inside = spectrum.density[spectrum.frequency <= limit]
    if not len(inside) or not inside.max():
        return
    marked = [peak for peak in spectrum.peaks(minimum_distance=0.25)
              if peak.frequency <= limit and peak.prominence > 0.3 * peak.height
              and peak.height > 1e-5 * inside.max()][:count]
    for peak in marked:
        axes.plot(peak.frequency, peak.height, "o", color=color, markersize=4.5,
                  markeredgecolor="white", markeredgewidth=0.8, zorder=5)
        axes.annotate(f"{peak.frequency:.2f} Hz", (peak.frequency, peak.height),
                      xytext=(0, 7), textcoords="offset points", ha="center", fontsize=8.5,
                      color=DARK)


@styled
def psd(spectrum: Psd, ax: Optional[Axes] = None, *, peaks: int = 4, limit: float = 25.0,
        log: bool = True, title: str = "", **line: Any) -> Axes:
    """A spectrum up to a limit [Hz] with the frequencies of its highest peaks."""
    axes = new_axes(ax)
    end = min(limit, float(spectrum.frequency[-1]))
    shown = (spectrum.frequency <= end) & (spectrum.frequency > 0)
    line.setdefault("label", readable(spectrum.name))
    drawn, = axes.plot(spectrum.frequency[shown], spectrum.density[shown], **line)
    if log:
        axes.set_yscale("log")
        top = spectrum.density[shown].max(initial=0.0)
        if top > 0:
            low, high = axes.get_ylim()
            axes.set_ylim(max(min(low, top), 1e-7 * top), max(high, 4 * top))
    axes.set_xlim(0, end)
    _mark(axes, spectrum, peaks, end, drawn.get_color())
    axes.set_xlabel("frequency [Hz]")
    axes.set_ylabel(f"PSD [{pretty(spectrum.density_unit)}]")
    axes.set_title(title or readable(spectrum.name))
    return axes


@styled
def psds(shown: Sequence[Channel], ax: Optional[Axes] = None, *, peaks: int = 1,
         limit: float = 25.0, title: str = "", **options: Any) -> Axes:
    """Spectra of several channels on one axis; options as truckride.psd()."""
    axes = new_axes(ax)
    for number, channel in enumerate(shown):
        psd(channel.psd(**options), axes, peaks=peaks, limit=limit, title=" ",
            color=COLORS[number % len(COLORS)])
    axes.set_title(title)
    axes.legend(loc="upper right")
    return axes
