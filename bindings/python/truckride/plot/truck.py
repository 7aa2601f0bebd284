# SPDX-License-Identifier: MIT
"""Side views of a vehicle, at rest and in the shape of a mode."""
from __future__ import annotations

from typing import Any, Optional

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon, Rectangle

from ..linear import Mode, Modes
from ..spec import Description
from . import geometry
from .geometry import FRONT, SIDE, STILL, WHEEL, Motions, Scene
from .style import COLORS, DARK, GREY, LIGHT, new_axes, new_figure, readable, styled

FILL = ["#f2f2f2", "#c9d9e8", "#dbe8d5", "#f4e3d3"]


def zigzag(start: Any, end: Any, width: float = 0.07, turns: int = 4) -> Any:
    """Points of a spring between two points."""
    t = np.concatenate([[0, 0.12], np.linspace(0.12, 0.88, 2 * turns + 1)[1:-1], [0.88, 1]])
    side = np.zeros(len(t))
    side[2:-2] = width * np.where(np.arange(len(t) - 4) % 2, -1, 1)
    along = np.asarray(end) - np.asarray(start)
    normal = np.array([-along[1], along[0]]) / (np.hypot(*along) or 1)
    return np.asarray(start) + t[:, None] * along + side[:, None] * normal


class Drawing:
    """Artists of a vehicle that can be moved: once for a mode, often for an animation."""

    def __init__(self, axes: Axes, scene: Scene, color: Optional[str] = None,
                 names: bool = False) -> None:
        self.axes, self.scene, self.color = axes, scene, color
        self.ghost = color == LIGHT
        line = color or DARK
        self.bodies: dict[int, Any] = {}
        self.springs: list[tuple[Any, Any]] = []
        self.dampers: list[tuple[Any, Any]] = []
        self.wheels: list[tuple[Any, Any]] = []
        for number, box in scene.boxes.items():
            if box.node and number in scene.beams.bodies:
                continue
            fill = "none" if self.ghost else FILL[min(box.rank, len(FILL)) - 1]
            patch = Polygon(box.outline, closed=True, facecolor=fill, edgecolor=line,
                            linewidth=1.3, joinstyle="round", zorder=3 + 0.1 * box.rank)
            self.bodies[number] = axes.add_patch(patch)
            if not self.ghost and box.top - box.bottom > 0.4:
                axes.plot(*box.cg, marker="+", color=line, markersize=7, zorder=6)
        for strut in scene.struts:
            for there, target in ((strut.spring, self.springs), (strut.damper, self.dampers)):
                style = {"color": line, "linewidth": 1.1, "zorder": 2.5}
                if target is self.dampers:
                    style.update(linewidth=2.6, solid_capstyle="butt")
                target.append((strut, axes.plot([], [], **style)[0] if there else None))
        for wheel in scene.wheels:
            self.wheels.append((wheel, axes.add_patch(self._wheel(wheel, line))))
        self.beams = Beams(axes, scene, line) if len(scene.beams.bodies) else None
        if names:
            name_parts(axes, scene)
        self.move({})

    def _wheel(self, wheel: Any, line: str) -> Any:
        _, place, height, _ = wheel
        look = {"facecolor": "none" if self.ghost else "#fafafa", "edgecolor": line,
                "linewidth": 1.6, "zorder": 2}
        if self.scene.view == SIDE:
            return Circle((place, height), WHEEL, **look)
        return Rectangle((place - 0.15, height - WHEEL), 0.3, 2 * WHEEL, **look)

    def move(self, motion: Motions) -> None:
        boxes = self.scene.boxes
        if self.beams:
            self.beams.move(motion)

        def at(number: int, point: tuple[float, float]) -> Any:
            return geometry.moved(np.array([point]), boxes[number].cg,
                                  motion.get(number, STILL))[0]

        for number, patch in self.bodies.items():
            patch.set_xy(geometry.moved(boxes[number].outline, boxes[number].cg,
                                        motion.get(number, STILL)))
        for struts, offset, shape in ((self.springs, -0.09, zigzag), (self.dampers, 0.09, None)):
            for strut, artist in struts:
                if artist is None:
                    continue
                place = strut.place + (offset if strut.spring and strut.damper else 0)
                low = at(strut.lower, (place, boxes[strut.lower].top))
                high = at(strut.upper, (place, boxes[strut.upper].bottom))
                points = shape(low, high) if shape else np.array([low, high])
                artist.set_data(points[:, 0], points[:, 1])
        for (number, place, height, _), patch in self.wheels:
            x, z = at(number, (place, height))
            if self.scene.view == SIDE:
                patch.set_center((x, z))
            else:
                patch.set_xy((x - 0.15, z - WHEEL))


class Beams:
    """Beams of frames as curves; those end on to the view as strokes that turn with their nodes."""

    def __init__(self, axes: Axes, scene: Scene, color: str) -> None:
        self.scene, far = scene, scene.beams.far
        self.lines = []
        for part, width in ((far, 1.0), (~far, 2.4)):
            lines = LineCollection([], colors=color, linewidths=width, capstyle="round",
                                   zorder=3.2 if width < 2 else 3.6)
            self.lines.append((part, axes.add_collection(lines, autolim=False)))
        self.pieces = 8 if len(far) <= 400 else 2
        self.strokes = axes.add_collection(LineCollection(
            [], colors=color, linewidths=1.4, capstyle="butt", zorder=3.4), autolim=False)

    def move(self, motion: Motions) -> None:
        shape = geometry.bent(self.scene, motion, self.pieces)
        for part, lines in self.lines:
            lines.set_segments(shape[part])
        self.strokes.set_segments(geometry.strokes(self.scene, motion))


def name_parts(axes: Axes, scene: Scene) -> None:
    """Names at bodies and frames; of two at one place what they have in common: "tank"."""
    look = {"textcoords": "offset points", "fontsize": 8.5, "color": DARK, "zorder": 7}
    found: dict[tuple[float, float], list[Any]] = {}
    for box in scene.boxes.values():
        if box.rank > 1 and not box.node:
            place = (round((box.left + box.right) / 2, 1), round(box.top, 1))
            found.setdefault(place, []).append(box)
    for boxes in found.values():
        words = zip(*(readable(box.name).split() for box in boxes))
        shared = " ".join(same[0] for same in words if len(set(same)) == 1)
        box = boxes[-1]
        axes.annotate(shared or readable(box.name), ((box.left + box.right) / 2, box.top),
                      xytext=(0, -11 if box.top - box.bottom > 0.4 else 3), ha="center", **look)
    # Where the view begins: +x is right at the side, +y left from behind.
    first = min if scene.view == SIDE else max
    for name, nodes in scene.frames.items():
        corner = first(box.left for box in nodes), max(box.top for box in nodes)
        axes.annotate(readable(name), corner, xytext=(0, 3), **look)


def frame_axes(axes: Axes, scene: Scene, margin: float = 0.35) -> None:
    """Limits around the vehicle, wide enough that a single wheel does not fill the page."""
    left = min([box.left for box in scene.boxes.values()]
               + [place - WHEEL for _, place, _, _ in scene.wheels]) - margin
    right = max([box.right for box in scene.boxes.values()]
                + [place + WHEEL for _, place, _, _ in scene.wheels]) + margin
    top = max([box.top for box in scene.boxes.values()]
              + [height + WHEEL for _, _, height, _ in scene.wheels]) + margin
    short = max(0.0, 2.6 - (right - left)) / 2
    left, right = left - short, right + short
    axes.set_aspect("equal")
    axes.set_xlim((left, right) if scene.view == SIDE else (right, left))  # +y is left
    axes.set_ylim(scene.ground - 0.2, top)
    axes.grid(False)


def ground_line(axes: Axes, scene: Scene) -> None:
    axes.axhline(scene.ground, color=GREY, linewidth=1.2, zorder=1)


@styled
def side_view(description: Description, ax: Optional[Axes] = None, *, view: str = "side",
              title: str = "") -> Axes:
    """The vehicle at rest; view "side" (x to the right) or "front" (seen from behind)."""
    scene = geometry.scene(description, FRONT if view == "front" else SIDE)
    axes = new_axes(ax, 8, 4.2)
    ground_line(axes, scene)
    Drawing(axes, scene, names=True)
    frame_axes(axes, scene)
    axes.set_xlabel("x [m], forward" if scene.view == SIDE else "y [m], left")
    axes.set_ylabel("z [m], heights schematic")
    axes.set_title(title or readable(description.name))
    return axes


def _view_of(mode: Mode, names: list[str]) -> int:
    """The side in which most of the energy is seen."""
    share = dict(zip((name.rsplit(".", 1)[1] for name in names), np.zeros(len(names))))
    for name, energy in zip(names, mode.energy):
        share[name.rsplit(".", 1)[1]] += float(energy)
    seen_from_behind = share.get("y", 0) + share.get("roll", 0)
    return FRONT if seen_from_behind > share.get("x", 0) + share.get("z", 0) + share.get(
        "pitch", 0) else SIDE


def _leading(mode: Mode, scene: Scene) -> str:
    """What moves most: a coordinate, or a frame as a whole."""
    part, share = mode.label, float(mode.energy.max())
    frame = part.split(".")[0]
    if frame in scene.frames:
        inside = [name.startswith(f"{frame}.") for name in mode.model.coordinates]
        part, share = frame, float(mode.energy[inside].sum())
    return f"{readable(part).replace('.', ' ')} {100 * share:.0f} % of energy"


@styled
def mode(shown: Mode, ax: Optional[Axes] = None, *, view: str = "", size: float = 0.2,
         title: str = "", bare: bool = False) -> Axes:
    """Shape of a mode over the vehicle at rest, the largest motion drawn `size` [m].

    view "side" or "front"; by default the one that shows most of its energy. The motion is
    that at the instant when the leading coordinate is at its largest.
    """
    description, names = shown.model.describe(), shown.model.coordinates
    chosen = {"side": SIDE, "front": FRONT}.get(view, _view_of(shown, names))
    # A reduced model has no coordinates of the inner nodes of its frame.
    scene = geometry.scene(description, chosen, {name.rsplit(".", 1)[0] for name in names})
    axes = new_axes(ax, 7, 3.8)
    ground_line(axes, scene)
    Drawing(axes, scene, LIGHT)
    motion = geometry.motions(names, scene, shown.shape.real)
    reach = geometry.reach(scene, motion)
    factor = size / reach if reach > 1e-12 else 0.0
    Drawing(axes, scene, COLORS[0]).move(
        {number: (a * factor, b * factor, c * factor) for number, (a, b, c) in motion.items()})
    frame_axes(axes, scene)
    damping = f", damping {100 * shown.damping_ratio:.1f} %" if shown.damping_ratio else ""
    axes.set_title(title or f"{shown.frequency:.2f} Hz{damping}")
    note = f"{_leading(shown, scene)}, seen from {'the side' if chosen == SIDE else 'behind'}"
    if bare:
        axes.set_xlabel(note, fontsize=8.5, color=GREY, loc="left")
        axes.title.set_fontsize(9.5)
        axes.set_xticks([])
        axes.set_yticks([])
        for spine in axes.spines.values():
            spine.set_visible(False)
    else:
        axes.annotate(note, (0, 1), xycoords="axes fraction", xytext=(2, -2), va="top",
                      textcoords="offset points", fontsize=8.5, color=GREY)
        axes.set_xlabel("x [m]" if chosen == SIDE else "y [m]")
        axes.set_ylabel("z [m], heights schematic")
    return axes


@styled
def modes(shown: Modes, *, count: int = 16, columns: int = 4, title: str = "") -> Figure:
    """The first modes on one page."""
    count = min(count, len(shown))
    columns = min(columns, count)
    rows = -(-count // columns)
    figure = new_figure(3.4 * columns, 2.25 * rows + 0.4)
    panels = np.atleast_1d(figure.subplots(rows, columns)).ravel()
    for panel, item in zip(panels, shown[:count]):
        mode(item, panel, bare=True)
    for panel in panels[count:]:
        panel.set_visible(False)
    figure.suptitle(title or f"{readable(shown.model.name)}: "
                    f"{'' if shown.damped else 'un'}damped modes", fontsize=12,
                    fontweight="bold", x=0.01, ha="left")
    return figure
