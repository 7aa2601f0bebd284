# SPDX-License-Identifier: MIT
"""What acts on a vehicle over time: road heights and loads."""
from __future__ import annotations

from typing import Any, NamedTuple, Optional, Union

import numpy as np

from ._abi import TRK_ROAD_ALL, TRK_ROAD_LEFT, TRK_ROAD_RIGHT, Part
from ._library import lib, quick
from ._native import Array, Handle, Native, check, create
from .model import Model
from .spec import Reference
from .signal import Signal

SIDES = {"all": TRK_ROAD_ALL, "left": TRK_ROAD_LEFT, "right": TRK_ROAD_RIGHT}


class Inputs(NamedTuple):
    """Road heights [m] and rates [m/s], loads [N, N m]; a row a time."""

    height: Array
    velocity: Array
    load: Array


class Excitation(Native):
    """Road heights and loads for a model, and for every model with as many roads and ports.

    Runs take the excitation as it is when they start: it may be changed while they go on.

    Args:
        model: whose roads and ports are meant
        motion: a signal for all roads, or None to begin with a level road
    """

    def __init__(self, model: Model, motion: Optional[Signal] = None) -> None:
        self._model = Model._expect(model)
        self._added: list[tuple[Any, int, Signal, tuple[float, ...]]] = []
        self._handle = self._native()
        if motion is not None:
            self.add_motion(motion)

    def _native(self, *further: tuple[Any, int, Signal, tuple[float, ...]]) -> Handle:
        """A native excitation, never changed again, so that threads can share it."""
        added = [*self._added, *further]
        signals = tuple(Signal._expect(signal)._live() for _, _, signal, _ in added)
        handle = create(quick.trk_excitation_destroy, lib.trk_excitation_create,
                        self._model._live(), keep=signals)
        for (function, place, _, numbers), signal in zip(added, signals):
            check(function(handle, place, signal, *numbers), handle.context)
        return handle

    def _add(self, function: Any, place: int, signal: Signal, *numbers: float) -> Excitation:
        self._live()
        item = (function, place, signal, numbers)
        self._handle = self._native(item)
        self._added.append(item)
        return self

    def _road(self, road: Reference) -> int:
        if isinstance(road, str) and road in SIDES:
            return SIDES[road]
        return self._model.find(Part.ROAD, road)

    def add_motion(self, signal: Signal, road: Reference = "all", gain: float = 1.0,
                   delay: float = 0.0) -> Excitation:
        """Move a road ("front_left", or "all", "left", "right") by gain [-] times a signal
        [m over s], delay [s] later. Returns itself, so that calls can be chained."""
        return self._add(quick.trk_excitation_add_motion, self._road(road), signal, gain, delay)

    def add_profile(self, profile: Signal, speed: float, road: Reference = "all",
                    gain: float = 1.0, start: float = 0.0) -> Excitation:
        """Drive roads over a profile [m over m] at a speed [m/s]; start [m] is the place of the
        vehicle's origin on it at t = 0. Each axle meets it when it comes along."""
        return self._add(quick.trk_excitation_add_profile, self._road(road), profile, gain, speed,
                         start)

    def add_load(self, port: Reference, signal: Signal, gain: float = 1.0,
                 delay: float = 0.0) -> Excitation:
        """Load a force port by gain [-] times a signal [N or N m over s]."""
        return self._add(quick.trk_excitation_add_load, self._model.find(Part.PORT, port), signal,
                         gain, delay)

    @property
    def roads(self) -> int:
        return quick.trk_excitation_roads(self._live())

    @property
    def ports(self) -> int:
        return quick.trk_excitation_ports(self._live())

    def evaluate(self, count: int, step: float, start: float = 0.0) -> Inputs:
        """Values at start + k step [s], k = 0 .. count - 1."""
        height, velocity = np.empty((count, self.roads)), np.empty((count, self.roads))
        load = np.empty((count, self.ports))
        lib.trk_excitation_evaluate(self._live(), count, start, step, height.ctypes,
                                    velocity.ctypes, load.ctypes)
        return Inputs(height, velocity, load)

    def __reduce__(self) -> tuple[Any, ...]:
        self._live()
        return _rebuild, (self._model, [(function.__name__, *rest)
                                        for function, *rest in self._added])

    def __repr__(self) -> str:
        if self.closed:
            return "<Excitation, closed>"
        return f"<Excitation of '{self._model.name}' with {len(self._added)} signals>"


def _rebuild(model: Model, added: list[tuple[str, int, Signal, tuple[float, ...]]]) -> Excitation:
    excitation = Excitation(model)
    for name, place, signal, numbers in added:
        excitation._add(getattr(quick, name), place, signal, *numbers)
    return excitation


def as_excitation(model: Model, given: Union[Excitation, Signal]) -> Excitation:
    """A signal means: all wheels in phase."""
    return Excitation(model, given) if isinstance(given, Signal) else Excitation._expect(given)
