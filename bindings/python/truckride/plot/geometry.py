# SPDX-License-Identifier: MIT
"""Where the parts of a vehicle are drawn: boxes for bodies, lines for beams, wheels, struts.

Lengths along the vehicle are true. A link of the description has both ends at one point, so
heights leave room for it: wheels on the ground, above them what they carry, above that the next.
The nodes of a frame keep their heights among themselves.
"""
from __future__ import annotations

import dataclasses
import math
from typing import Any, Collection, Optional, Sequence

import numpy as np

from .._abi import Motion
from ..spec import Description
from .layout import Layout

WHEEL = 0.5  # [m] radius
CLEARANCE = 0.44  # [m] from a wheel's centre to the body above
GAP = 0.24  # [m] between bodies
BEAM = 0.2  # [m] height of a body whose cg is not above its lower edge
NODE = 0.05  # [m] half the height of a node
STROKE = 0.08  # [m] half the length of a beam seen end on
STROKES = 60  # at most about so many of them
SIDE, FRONT = 0, 1
STILL = (0.0, 0.0, 0.0)

Motions = dict[int, tuple[float, float, float]]


@dataclasses.dataclass
class Box:
    """A body: corners (left, right, bottom, top) in the plane of the view and its cg [m]. A node
    is the end of beams, and drawn by them."""

    name: str
    number: int
    rank: int
    left: float
    right: float
    bottom: float
    top: float
    cg: tuple[float, float]
    node: bool = False

    @property
    def outline(self) -> Any:
        corners = [(self.left, self.bottom), (self.right, self.bottom), (self.right, self.top),
                   (self.left, self.top)]
        return np.array(corners)


@dataclasses.dataclass
class Strut:
    """A spring or damper between two bodies at a place along the view."""

    lower: int
    upper: int
    place: float
    spring: bool
    damper: bool


@dataclasses.dataclass
class Beams:
    """Beams in the plane of the view: bodies (0: ground) and points [m] of both ends, a row each;
    far ones lie behind the middle of all."""

    bodies: Any
    ends: Any
    far: Any


@dataclasses.dataclass
class Scene:
    view: int
    boxes: dict[int, Box]
    struts: list[Strut]
    wheels: list[tuple[int, float, float, int]]  # body, place, height of the centre, road
    beams: Beams

    @property
    def ground(self) -> float:
        lowest = min((box.bottom for box in self.boxes.values()), default=0.0)
        return min((height for _, _, height, _ in self.wheels), default=lowest) - WHEEL

    @property
    def frames(self) -> dict[str, list[Box]]:
        """Nodes by the beginning of their names, "frame" of "frame.left.1"."""
        found: dict[str, list[Box]] = {}
        for box in self.boxes.values():
            if box.node:
                found.setdefault(box.name.split(".")[0], []).append(box)
        return found


def _places(description: Description, layout: Layout, number: int, view: int) -> list[float]:
    """Places along the view where something is fixed to a body."""
    places = [mass.point[view] for mass in description.masses.values() if mass.body == number]
    for link in layout.links.get(number, ()):
        if link.motion != Motion.TRANSLATION:
            continue  # turns whole bodies, has no place
        places.append((link.from_point if link.from_body == number else link.to_point)[view])
    return places or [layout.bodies[number - 1][1].cg[view]]


def _floor(layout: Layout, group: int, boxes: dict[int, Box]) -> float:
    """Lower edge of a group, above what carries it."""
    carriers = [boxes[number] for number in layout.around(group)
                if number in boxes and boxes[number].rank <= layout.rank[group]]
    return max(box.top + GAP if box.rank > 1 else box.top - 0.05 + CLEARANCE
               for box in carriers or boxes.values())


def _frame(layout: Layout, group: int, view: int, boxes: dict[int, Box]) -> dict[int, Box]:
    """Nodes at their own heights, or lifted above what carries them."""
    rank, lift, found = layout.rank[group], 0.0, {}
    if rank > 1:
        lowest = min(layout.bodies[number - 1][1].cg[2] for number in layout.groups[group])
        lift = _floor(layout, group, boxes) + NODE - lowest
    for number in layout.groups[group]:
        name, body = layout.bodies[number - 1]
        place, height = body.cg[view], body.cg[2] + lift
        found[number] = Box(name, number, rank, place - NODE, place + NODE, height - NODE,
                            height + NODE, (place, height), True)
    return found


def _box(description: Description, layout: Layout, number: int, view: int,
         boxes: dict[int, Box]) -> Box:
    (name, body), rank = layout.bodies[number - 1], layout.rank[number]
    places = _places(description, layout, number, view) + [body.cg[view]]
    pad = 0.3 if max(places) - min(places) > 0.5 else 0.45
    if rank == 1:
        pad, bottom, height = 0.06, body.cg[2] - 0.05, 0.1
    else:
        bottom = _floor(layout, number, boxes)
        above = body.cg[2] - bottom
        height = 2 * above if above > 0.3 else max(BEAM, 2 * above)
    cg = (body.cg[view], bottom + height / 2 if height <= BEAM else body.cg[2])
    return Box(name, number, rank, min(places) - pad, max(places) + pad, bottom, bottom + height,
               cg)


def _boxes(description: Description, view: int) -> dict[int, Box]:
    layout = Layout(description)
    boxes: dict[int, Box] = {}
    # Of groups as far from the road the higher one is carried: a trailer by its tractor's frame.
    for group in sorted(layout.groups, key=lambda key: (layout.rank[key], layout.height(key))):
        if layout.is_frame(group):
            boxes.update(_frame(layout, group, view, boxes))
        else:
            boxes[group] = _box(description, layout, group, view, boxes)
    return boxes


def _beams(description: Description, boxes: dict[int, Box], view: int) -> Beams:
    """Beams between bodies that are drawn; the plane of the view is x or y, and z."""
    bodies, bottom = list(description.bodies.values()), []
    shown = [beam for beam in description.beams.values()
             if all(end in boxes for end in (beam.from_body, beam.to_body) if end)]
    for beam in shown:
        known = beam.from_body or beam.to_body
        bottom.append(boxes[known].cg[1] - bodies[known - 1].cg[2])
    ends = np.array([(beam.from_point, beam.to_point) for beam in shown]).reshape(-1, 2, 3)
    depth = ends[:, :, 1 - view].mean(axis=1)  # y is away from the eye at the side, x from behind
    plane = ends[:, :, [view, 2]] + np.array([(0, lift) for lift in bottom]).reshape(-1, 1, 2)
    return Beams(np.array([(beam.from_body, beam.to_body) for beam in shown]).reshape(-1, 2),
                 plane, depth > (depth.mean() if len(depth) else 0) + 1e-6)


def scene(description: Description, view: int = SIDE,
          bodies: Optional[Collection[str]] = None) -> Scene:
    """What is drawn of a vehicle; with names of bodies only these of the nodes of frames."""
    boxes = {number: box for number, box in _boxes(description, view).items()
             if bodies is None or not box.node or box.name in bodies}
    struts: dict[tuple[int, int, float], Strut] = {}
    wheels: dict[tuple[int, float], tuple[int, float, float, int]] = {}
    for link in description.links.values():
        upright = abs(link.direction[2]) > 0.5 * math.hypot(*link.direction)
        if link.motion != Motion.TRANSLATION or not upright or link.to_body not in boxes:
            continue
        place = link.to_point[view]
        nodes = any(end in boxes and boxes[end].node for end in (link.from_body, link.to_body))
        # From behind, what both axles and the cab have on one side falls together.
        place = 0.3 * round(place / 0.3) if view == FRONT and not nodes else round(place, 2)
        if link.from_road:
            height = boxes[link.to_body].cg[1]
            wheels.setdefault((link.to_body, place), (link.to_body, place, height, link.from_road))
            continue
        if link.from_body not in boxes:
            continue
        lower, upper = sorted((link.from_body, link.to_body), key=lambda k: boxes[k].bottom)
        strut = struts.setdefault((lower, upper, place), Strut(lower, upper, place, False, False))
        strut.spring |= bool(link.stiffness or link.spring_curve or link.law)
        strut.damper |= bool(link.damping or link.damper_curve)
    return Scene(view, boxes, list(struts.values()), list(wheels.values()),
                 _beams(description, boxes, view))


def motions(names: Sequence[str], shown: Scene, values: Any) -> Motions:
    """Of every body the displacement in the plane of the view and the rotation, counter-clockwise
    positive."""
    value = dict(zip(names, np.asarray(values, dtype=np.float64).tolist()))
    # Pitch is nose down positive, clockwise with x to the right; roll lifts the left side, +y.
    along, turn, sign = ("x", "pitch", -1.0) if shown.view == SIDE else ("y", "roll", 1.0)
    return {number: (value.get(f"{box.name}.{along}", 0.0), value.get(f"{box.name}.z", 0.0),
                     sign * value.get(f"{box.name}.{turn}", 0.0))
            for number, box in shown.boxes.items()}


def moved(points: Any, cg: tuple[float, float], motion: tuple[float, float, float]) -> Any:
    """Points of a body after a small motion (SPEC.1)."""
    along, up, turn = motion
    arm = points - np.array(cg)
    return points + np.array([along, up]) + turn * np.column_stack([-arm[:, 1], arm[:, 0]])


def strokes(shown: Scene, motion: Motions) -> Any:
    """Short upright lines through the ends of the beams that the view sees end on, moved; of
    very many some."""
    width = np.abs(np.diff(shown.beams.ends[:, :, 0], axis=1)).ravel()
    seen = np.flatnonzero(width < 1e-6)
    found = []
    for k in seen[::len(seen) // STROKES | 1].tolist():  # odd: left and right take turns
        for number, point in zip(shown.beams.bodies[k].tolist(), shown.beams.ends[k]):
            if number:
                line = point + np.array([(0, -STROKE), (0, STROKE)])
                found.append(moved(line, shown.boxes[number].cg, motion.get(number, STILL)))
    return np.array(found).reshape(-1, 2, 2)


def reach(shown: Scene, motion: Motions) -> float:
    """Largest displacement of what is drawn."""
    shifts = [moved(box.outline, box.cg, motion[number]) - box.outline
              for number, box in shown.boxes.items()]
    shifts += [strokes(shown, motion) - strokes(shown, {}), bent(shown, motion, 8)
               - bent(shown, {}, 8)]
    for strut in shown.struts:
        for number in (strut.lower, strut.upper):
            box = shown.boxes[number]
            point = np.array([(strut.place, box.cg[1])])
            shifts.append(moved(point, box.cg, motion[number]) - point)
    return max(float(np.abs(shift).max(initial=0.0)) for shift in shifts)


def bent(shown: Scene, motion: Motions, pieces: int) -> Any:
    """Beams after a small motion of their bodies, beams x (pieces + 1) x 2: between their ends
    the cubics that follow displacement and rotation there."""
    bodies, ends = shown.beams.bodies, shown.beams.ends
    state = np.array([[(*motion.get(number, STILL), *(shown.boxes[number].cg if number else (0, 0)))
                       for number in pair] for pair in bodies.tolist()]).reshape(-1, 2, 5)
    turn = state[:, :, 2]
    arm = ends - state[:, :, 3:]
    shift = state[:, :, :2] + turn[:, :, None] * np.stack([-arm[:, :, 1], arm[:, :, 0]], axis=-1)
    axis = ends[:, 1] - ends[:, 0]
    across = np.stack([-axis[:, 1], axis[:, 0]], axis=-1)
    s = np.linspace(0, 1, pieces + 1)
    weights = np.stack([1 - s, s])  # of the ends
    # The ends turn more or less than the straight line between them: what is left bends the beam.
    square = np.maximum((axis ** 2).sum(axis=-1), 1e-12)
    chord = ((shift[:, 1] - shift[:, 0]) * across).sum(axis=-1) / square
    bend = (turn - chord[:, None]) @ np.stack([s * (1 - s) ** 2, -(1 - s) * s ** 2])
    return np.einsum("ks,bkx->bsx", weights, ends + shift) + bend[:, :, None] * across[:, None, :]
