# SPDX-License-Identifier: MIT
"""What the steppers share: buffers, state, sensors."""
from __future__ import annotations

import functools
from typing import Any, Callable, ClassVar, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from ._abi import Part
from ._library import quick
from ._native import Array, Exclusive, Handle, Native, check, optional
from .model import Model

BUFFERS = {"height", "velocity", "load", "sensors", "middle_height", "middle_velocity",
           "middle_load"}


class State(NamedTuple):
    """Coordinates [m, rad], velocities [m/s, rad/s], accelerations [m/s^2, rad/s^2]."""

    q: Array
    v: Array
    a: Array


class LinkState(NamedTuple):
    """Elongation [m, rad], rate [m/s, rad/s] and force [N, N m] of every link."""

    elongation: Array
    rate: Array
    force: Array


class Stepper(Native):
    """A model on its way through time, for one thread at a time.

    Attributes:
        height, velocity: road heights [m] and rates [m/s] at the end of the next step
        load: loads on the force ports [N, N m] at the end of the next step
        sensors: what read() filled last, each in its unit

    These arrays are made once; write into them, height[:] = 0.01, and no call allocates.
    """

    _prefix: ClassVar[str]
    _advance: Callable[[], int]

    def _start(self, model: Model, handle: Handle) -> None:
        """Bind the buffers and the functions of every step once."""
        self.model = model
        self.height = np.zeros(model.count(Part.ROAD))
        self.velocity = np.zeros(model.count(Part.ROAD))
        self.load = np.zeros(model.count(Part.PORT))
        self.sensors = np.zeros(model.count(Part.SENSOR))
        self._handle = handle
        self._read = self._bind("read_sensors", self.sensors)

    def __setattr__(self, name: str, value: Any) -> None:
        # The library holds the address of these arrays: assigning means filling.
        if name in BUFFERS and name in self.__dict__:
            self.__dict__[name][...] = value
        else:
            super().__setattr__(name, value)

    def _bind(self, name: str, *buffers: Array) -> Any:
        """A call of every step with all arguments in place. It keeps the GIL, which a call of a
        microsecond would lose more by giving up, so that nobody can close the stepper meanwhile."""
        return functools.partial(self._call(name), self._live()._as_parameter_,
                                 *(buffer.ctypes._as_parameter_ for buffer in buffers))

    def step(self) -> None:
        """Advance by one step to the road heights, rates and loads in the buffers."""
        if self._handle is None or self._busy:
            self._live()  # says which
        status = self._advance()
        if status:
            self._check(status)

    def _call(self, name: str) -> Any:
        return getattr(quick, f"{self._prefix}_{name}")

    @property
    def time(self) -> float:
        """[s]"""
        time: float = self._call("time")(self._live())
        return time

    @property
    def step_size(self) -> float:
        """[s]"""
        size: float = self._call("step_size")(self._live())
        return size

    def read(self) -> Array:
        """Values of all sensors now; the array is `sensors`, filled anew by each call."""
        if self._handle is None or self._busy:
            self._live()  # says which
        self._read()
        return self.sensors

    @property
    def state(self) -> State:
        """Copies of coordinates, velocities and accelerations."""
        out = State(*np.empty((3, self.model.count(Part.COORDINATE))))
        self._call("get_state")(self._live(), *(array.ctypes for array in out))
        return out

    @property
    def links(self) -> LinkState:
        """Copies of elongation, rate and force of every link."""
        out = LinkState(*np.empty((3, self.model.count(Part.LINK))))
        self._call("get_links")(self._live(), *(array.ctypes for array in out))
        return out

    def set_state(self, time: float = 0.0, q: Optional[npt.ArrayLike] = None,
                  v: Optional[npt.ArrayLike] = None, height: Optional[npt.ArrayLike] = None,
                  velocity: Optional[npt.ArrayLike] = None,
                  load: Optional[npt.ArrayLike] = None) -> None:
        """Set time [s], coordinates and velocities, default static equilibrium at rest, under
        road heights [m], rates [m/s] and loads [N, N m], default none."""
        n, roads = self.model.count(Part.COORDINATE), len(self.height)
        arguments = (optional(q, "q", n), optional(v, "v", n), optional(height, "height", roads),
                     optional(velocity, "velocity", roads), optional(load, "load", len(self.load)))
        with Exclusive(self) as handle:
            check(self._call("set_state")(handle, time, *arguments), handle.context)

    def __repr__(self) -> str:
        if self.closed:
            return f"<{type(self).__name__}, closed>"
        return f"<{type(self).__name__} of '{self.model.name}' at {self.time:g} s>"


def of_method(method: str) -> type[Any]:
    """Class of a stepper by its name, "newmark" or "rungekutta"."""
    from .newmark import Newmark
    from .rungekutta import RungeKutta
    kinds = {"newmark": Newmark, "rungekutta": RungeKutta}
    try:
        return kinds[method.lower()]
    except KeyError:
        raise ValueError(f"method: {method!r} is none of {', '.join(kinds)}") from None
