# SPDX-License-Identifier: MIT
"""A calibration before and after."""
from __future__ import annotations

import math

import numpy as np
from matplotlib.figure import Figure

from ..calibrate import Solution
from .style import COLORS, DARK, GREY, LIGHT, new_figure, readable, styled


@styled
def solution(shown: Solution, title: str = "") -> Figure:
    """Targets before and after beside the measurement; parameters with their intervals."""
    figure = new_figure(9, 1.6 + 0.55 * max(len(shown.targets), len(shown.parameters)))
    left, right = figure.subplots(1, 2)
    rows = np.arange(len(shown.targets))
    for row, target in zip(rows, shown.targets.values()):
        left.plot([target.before, target.after], [row, row], color=LIGHT, linewidth=5,
                  solid_capstyle="round", zorder=2)
        left.plot(target.before, row, "o", color=GREY, markersize=8, zorder=3,
                  label="before" if row == 0 else None)
        left.plot(target.after, row, "o", color=COLORS[0], markersize=8, zorder=4,
                  label="after" if row == 0 else None)
        left.plot(target.measured, row, "|", color=COLORS[1], markersize=22, markeredgewidth=2,
                  zorder=5, label="measured" if row == 0 else None)
        for value in (target.before, target.after):
            left.annotate(f"{value:.3g}", (value, row), xytext=(0, 11), ha="center",
                          textcoords="offset points", fontsize=8.5, color=DARK)
    left.set_yticks(rows, [readable(name) for name in shown.targets])
    left.set_ylim(len(rows) - 0.4, -0.75)
    left.margins(x=0.12)
    left.set_xlabel("target [Hz or -]")
    left.legend(loc="upper center", bbox_to_anchor=(0.5, 1.0), ncols=3)
    left.set_title("targets")
    rows = np.arange(len(shown.parameters))
    for row, parameter in zip(rows, shown.parameters.values()):
        if parameter.determined and math.isfinite(parameter.high95):
            right.plot([parameter.low95, parameter.high95], [row, row], color=COLORS[0],
                       linewidth=5, alpha=0.35, solid_capstyle="butt", zorder=2,
                       label="95 % interval" if row == 0 else None)
        right.plot(parameter.start, row, "o", color=GREY, markersize=8, zorder=3,
                   label="start" if row == 0 else None)
        right.plot(parameter.fitted, row, "o", color=COLORS[0], markersize=8, zorder=4,
                   label="fitted" if row == 0 else None)
        right.annotate(f"{parameter.fitted:.3g}", (parameter.fitted, row), xytext=(0, 11),
                       textcoords="offset points", ha="center", fontsize=8.5, color=DARK)
    right.set_yticks(rows, [readable(name) for name in shown.parameters])
    right.set_ylim(len(rows) - 0.4, -0.75)
    right.margins(x=0.12)
    right.set_xlabel("parameter [- or unit of the value]")
    right.legend(loc="upper center", bbox_to_anchor=(0.5, 1.0), ncols=3)
    right.set_title("parameters")
    if title:
        figure.suptitle(title, fontsize=11.5, fontweight="bold", x=0.01, ha="left")
    return figure
