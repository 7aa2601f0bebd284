# SPDX-License-Identifier: MIT
"""A run as an animation: GIF, or MP4 where ffmpeg is installed."""
from __future__ import annotations

import os
import pathlib
from typing import Any, Union

import numpy as np
from matplotlib import animation

from ..errors import ArgumentError
from ..excitation import Excitation, as_excitation
from ..model import Model
from ..newmark import Newmark
from ..signal import Signal
from . import geometry
from .geometry import SIDE, WHEEL
from .style import DARK, GREY, new_axes, readable, styled
from .truck import Drawing, frame_axes


def _frames(model: Model, excitation: Excitation, duration: float, step: float,
            every: int) -> list[tuple[float, Any, Any]]:
    """(time, coordinates, road heights) of every frame."""
    with Newmark(model, step=step) as stepper:
        count = int(round(duration / step))
        inputs = excitation.evaluate(count + 1, step)
        stepper.set_state(0, None, None, inputs.height[0], inputs.velocity[0], inputs.load[0])
        frames = [(0.0, stepper.state.q, inputs.height[0])]
        for k in range(1, count + 1):
            stepper.height, stepper.velocity = inputs.height[k], inputs.velocity[k]
            stepper.load = inputs.load[k]
            stepper.step()
            if k % every == 0:
                frames.append((stepper.time, stepper.state.q, inputs.height[k]))
    return frames


def _writer(path: pathlib.Path, rate: float) -> Any:
    if path.suffix == ".gif":
        return animation.PillowWriter(fps=int(round(rate)))
    if path.suffix == ".mp4":
        if not animation.FFMpegWriter.isAvailable():
            raise ArgumentError("MP4 needs ffmpeg, which is missing; a .gif needs Pillow only")
        return animation.FFMpegWriter(fps=rate)
    raise ArgumentError(f"{path}: the name of an animation ends in .gif or .mp4")


@styled
def animate(model: Model, excitation: Union[Excitation, Signal], path: Union[str, os.PathLike[str]],
            duration: float = 3.0, *, step: float = 0.001, rate: float = 25.0,
            magnify: float = 10.0, title: str = "") -> pathlib.Path:
    """Write a side view of a run from rest, its motion magnified, in real time.

    Args:
        path: file to write, .gif or .mp4
        duration, step: [s]
        rate: frames a second
        magnify: factor on all displacements
    """
    target = pathlib.Path(path)
    writer = _writer(target, rate)
    names = model.coordinates
    scene = geometry.scene(model.describe(), SIDE, {name.rsplit(".", 1)[0] for name in names})
    frames = _frames(model, as_excitation(model, excitation), duration, step,
                     max(1, int(round(1 / (rate * step)))))
    axes = new_axes(None, 6.4, 3.6)
    drawing = Drawing(axes, scene)
    frame_axes(axes, scene)
    axes.set_ylim(scene.ground - 0.45, axes.get_ylim()[1] + 0.1)
    axes.set_axis_off()
    roads = [(road, axes.plot([], [], color=GREY, linewidth=3, solid_capstyle="round")[0], place)
             for _, place, _, road in scene.wheels]
    axes.set_title(title or f"{readable(model.name)}, motion x {magnify:g}")
    clock = axes.text(0.99, 0.97, "", transform=axes.transAxes, ha="right", va="top", color=DARK)
    figure = axes.figure
    with writer.saving(figure, str(target), dpi=100):
        for time, q, height in frames:
            drawing.move(geometry.motions(names, scene, magnify * q))
            for road, line, place in roads:
                level = scene.ground + magnify * height[road - 1]
                line.set_data([place - WHEEL, place + WHEEL], [level, level])
            clock.set_text(f"{time:.2f} s")
            writer.grab_frame()
    import matplotlib.pyplot as plt
    plt.close(figure)
    return target
