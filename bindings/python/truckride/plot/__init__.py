# SPDX-License-Identifier: MIT
"""Plots with matplotlib. Each takes ax=... or makes a figure, and returns what it drew on."""

try:
    import matplotlib  # noqa: F401
except ImportError as missing:
    raise ImportError("plots need matplotlib: install it, e.g. Debian's python3-matplotlib"
                      ) from missing

from .bode import bode
from .curves import curve, curves, loop, signal
from .fit import solution
from .motion import animate
from .signals import channels, choose, psd, psds
from .study import study
from .style import COLORS, new_axes, new_figure, style, styled
from .truck import mode, modes, side_view

__all__ = ["COLORS", "animate", "bode", "channels", "choose", "curve", "curves", "loop", "mode",
           "modes", "new_axes", "new_figure", "psd", "psds", "side_view", "signal", "solution",
           "study", "style", "styled"]
