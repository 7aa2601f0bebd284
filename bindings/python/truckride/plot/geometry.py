# SPDX-License-Identifier: MIT
"""Where the parts of a vehicle are drawn: boxes for bodies, wheels, springs, dampers.

Lengths along the vehicle are true. A link of the description has both ends at one point, so
heights leave room for it: wheels on the ground, above them what they carry, above that the next.
"""
from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

from .._abi import Motion
from ..spec import Description

WHEEL = 0.5  # [m] radius
CLEARANCE = 0.44  # [m] from a wheel's centre to the body above
GAP = 0.24  # [m] between bodies
BEAM = 0.2  # [m] height of a body whose cg is not above its lower edge
SIDE, FRONT = 0, 1


@dataclasses.dataclass
class Box:
    """A body: corners (left, right, bottom, top) in the plane of the view and its cg [m]."""

    name: str
    number: int
    rank: int
    left: float
    right: float
    bottom: float
    top: float
    cg: tuple[float, float]

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
class Scene:
    view: int
    boxes: dict[int, Box]
    struts: list[Strut]
    wheels: list[tuple[int, float, float, int]]  # body, place, height of the centre, road

    @property
    def ground(self) -> float:
        return min((height for _, _, height, _ in self.wheels), default=0.0) - WHEEL


def ranks(description: Description) -> dict[int, int]:
    """Number of links between a body and the road; unconnected bodies float above."""
    rank = {link.to_body: 1 for link in description.links.values() if link.from_road}
    rank = rank or {1: 1}
    for _ in description.bodies:
        for link in description.links.values():
            for a, b in ((link.from_body, link.to_body), (link.to_body, link.from_body)):
                if a in rank and b:
                    rank[b] = min(rank.get(b, 99), rank[a] + 1)
    top = max(rank.values())
    return {number: rank.get(number, top + 1)
            for number in range(1, len(description.bodies) + 1)}


def _places(description: Description, number: int, view: int) -> list[float]:
    """Places along the view where something is fixed to a body."""
    places = [mass.point[view] for mass in description.masses.values() if mass.body == number]
    for link in description.links.values():
        if link.from_body == number:
            places.append(link.from_point[view])
        if link.to_body == number:
            places.append(link.to_point[view])
    return places or [list(description.bodies.values())[number - 1].cg[view]]


def _boxes(description: Description, view: int) -> dict[int, Box]:
    rank = ranks(description)
    boxes: dict[int, Box] = {}
    for number in sorted(rank, key=lambda key: rank[key]):
        name, body = list(description.bodies.items())[number - 1]
        places = _places(description, number, view) + [body.cg[view]]
        pad = 0.3 if max(places) - min(places) > 0.5 else 0.45
        if rank[number] == 1:
            pad, bottom, height = 0.06, body.cg[2] - 0.05, 0.1
        else:
            carriers = [boxes[k] for k in boxes if rank[k] < rank[number] and _linked(
                description, k, number)] or list(boxes.values())
            bottom = max(box.top + GAP if box.rank > 1 else box.top - 0.05 + CLEARANCE
                         for box in carriers) if carriers else body.cg[2]
            above = body.cg[2] - bottom
            height = 2 * above if above > 0.3 else max(BEAM, 2 * above)
        cg = (body.cg[view], bottom + height / 2 if height <= BEAM else body.cg[2])
        boxes[number] = Box(name, number, rank[number], min(places) - pad, max(places) + pad,
                            bottom, bottom + height, cg)
    return boxes


def _linked(description: Description, a: int, b: int) -> bool:
    return any({link.from_body, link.to_body} == {a, b} for link in description.links.values())


def scene(description: Description, view: int = SIDE) -> Scene:
    boxes = _boxes(description, view)
    struts: dict[tuple[int, int, float], Strut] = {}
    wheels: dict[tuple[int, float], tuple[int, float, float, int]] = {}
    for link in description.links.values():
        upright = abs(link.direction[2]) > 0.5 * math.hypot(*link.direction)
        if link.motion != Motion.TRANSLATION or not upright:
            continue
        # From behind, what both axles and the cab have on one side falls together.
        place = link.to_point[view]
        place = 0.3 * round(place / 0.3) if view == FRONT else round(place, 2)
        if link.from_road:
            height = boxes[link.to_body].cg[1]
            wheels.setdefault((link.to_body, place), (link.to_body, place, height, link.from_road))
            continue
        if not link.from_body or not link.to_body:
            continue
        lower, upper = sorted((link.from_body, link.to_body), key=lambda k: boxes[k].bottom)
        strut = struts.setdefault((lower, upper, place), Strut(lower, upper, place, False, False))
        strut.spring |= bool(link.stiffness or link.spring_curve)
        strut.damper |= bool(link.damping or link.damper_curve)
    return Scene(view, boxes, list(struts.values()), list(wheels.values()))


def motion_of(names: list[str], description: Description, values: Any, number: int,
              view: int) -> tuple[float, float, float]:
    """Displacement in the plane of the view and rotation, counter-clockwise positive."""
    body = list(description.bodies)[number - 1]
    value = {name: float(values[k]) for k, name in enumerate(names)}
    along = value.get(f"{body}.{'x' if view == SIDE else 'y'}", 0.0)
    # Pitch is nose down positive, clockwise with x to the right; roll lifts the left side, +y.
    turn = -value.get(f"{body}.pitch", 0.0) if view == SIDE else value.get(f"{body}.roll", 0.0)
    return along, value.get(f"{body}.z", 0.0), turn


def moved(points: Any, cg: tuple[float, float], motion: tuple[float, float, float]) -> Any:
    """Points of a body after a small motion (SPEC.1)."""
    along, up, turn = motion
    arm = points - np.array(cg)
    return points + np.array([along, up]) + turn * np.column_stack([-arm[:, 1], arm[:, 0]])
