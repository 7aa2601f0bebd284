# SPDX-License-Identifier: MIT
"""One look for all plots."""
from __future__ import annotations

import contextlib
from typing import Any, Callable, Iterator, Optional, TypeVar, cast

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure

COLORS = ["#1f5a92", "#d1661c", "#4b8b3b", "#8a5aa8", "#b0303c", "#6b6b6b", "#2a9d9a", "#c9a227"]
GREY = "#8c8c8c"
LIGHT = "#d9d9d9"
DARK = "#333333"

STYLE = {
    "font.size": 9.5, "axes.titlesize": 10.5, "axes.titleweight": "bold",
    "axes.titlelocation": "left", "axes.labelsize": 9.5, "axes.spines.top": False,
    "axes.spines.right": False, "axes.edgecolor": "#666666", "axes.linewidth": 0.8,
    "axes.grid": True, "axes.axisbelow": True, "grid.color": "#e4e4e4", "grid.linewidth": 0.7,
    "axes.prop_cycle": matplotlib.cycler(color=COLORS), "lines.linewidth": 1.4,
    "xtick.color": "#444444", "ytick.color": "#444444", "legend.frameon": False,
    "legend.fontsize": 9, "figure.dpi": 110, "savefig.dpi": 150, "figure.figsize": (8, 4.5),
}

F = TypeVar("F", bound=Callable[..., Any])


@contextlib.contextmanager
def style() -> Iterator[None]:
    with matplotlib.rc_context(STYLE):
        yield


def styled(function: F) -> F:
    """Draw with the style of this package, leave the user's own as it was."""
    import functools

    @functools.wraps(function)
    def inner(*arguments: Any, **options: Any) -> Any:
        with style():
            return function(*arguments, **options)
    return cast(F, inner)


def new_figure(width: float, height: float) -> Figure:
    import matplotlib.pyplot as plt
    return plt.figure(figsize=(width, height), constrained_layout=True)


def new_axes(ax: Optional[Axes], width: float = 8, height: float = 4.5) -> Axes:
    return ax if ax is not None else new_figure(width, height).add_subplot()


def label(name: str, unit: str) -> str:
    """Axis label: name [unit] with superscripts."""
    return f"{name} [{pretty(unit)}]" if unit and unit != "-" else name


def pretty(unit: str) -> str:
    return unit.replace("^2", "²").replace("N m", "N·m").replace("N s", "N·s")


def readable(name: str) -> str:
    return name.replace("_", " ")
