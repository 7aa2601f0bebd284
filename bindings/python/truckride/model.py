# SPDX-License-Identifier: MIT
"""A compiled vehicle: rows, matrices, static equilibrium, and what can be asked of it."""
from __future__ import annotations

import ctypes
import operator
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from ._abi import Part
from ._library import lib, quick
from ._native import (Array, Exclusive, Handle, Native, check_plain, create, encode, optional,
                      text, vector)
from ._options import LineariseOptions, ModelOptions, ReduceOptions
from ._struct import options
from .errors import UnknownNameError
from .spec import Description, Reference, Road, Spec

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._stepper import Stepper
    from .excitation import Excitation
    from .linear import Modes, Response
    from .linearise import Linearised
    from .series import Series
    from .signal import Signal


class Tangent(NamedTuple):
    """Damping C [N s/m, ...] and stiffness K [N/m, ...] about a working point."""

    damping: Array
    stiffness: Array


class Static(NamedTuple):
    """Static equilibrium: coordinates q [m, rad] and force of every link [N, N m]."""

    q: Array
    force: Array


class Model(Native):
    """Equations of motion of a spec. Immutable; any number of threads may share it.

    Args:
        spec: the vehicle; it may be changed afterwards
        gravity: [m/s^2] downwards; 0 measures displacements from static equilibrium
        allow_free: admit bodies that nothing ties to ground or road
    """

    _steps: tuple[tuple[str, tuple[Any, ...]], ...] = ()  # what was done to the compiled spec

    def __init__(self, spec: Spec, gravity: float = 0.0, allow_free: bool = False) -> None:
        self._options = ModelOptions(gravity, int(allow_free))
        self._spec = Spec._expect(spec).copy()
        with Exclusive(self._spec) as handle:
            self._handle = create(quick.trk_model_destroy, lib.trk_model_compile, handle,
                                  ctypes.byref(self._options._to_struct()))

    @property
    def name(self) -> str:
        handle = self._live()
        return text(quick.trk_model_name(handle))

    @property
    def gravity(self) -> float:
        """[m/s^2]"""
        return quick.trk_model_gravity(self._live())

    def describe(self) -> Description:
        """The parts it was compiled from, as plain data."""
        self._live()
        return self._spec.describe()

    # Parts

    def count(self, part: Part) -> int:
        return quick.trk_model_count(self._live(), part)

    def find(self, part: Part, name: Reference) -> int:
        """Id of a part by its name; an id is returned as it is."""
        if not isinstance(name, str):
            return operator.index(name)
        found = quick.trk_model_find(self._live(), part, encode(name))
        if not found:
            raise UnknownNameError(f"{self.name}: there is no {part.name.lower()} '{name}'; there "
                                   f"are {', '.join(self.names(part)) or 'none'}")
        return found

    def names(self, part: Part) -> list[str]:
        handle = self._live()
        return [text(quick.trk_model_part_name(handle, part, number))
                for number in range(1, self.count(part) + 1)]

    def unit(self, part: Part, name: Reference) -> str:
        """Unit of a coordinate, sensor, link force, port or road; "" if it has none."""
        return text(quick.trk_model_unit(self._live(), part, self.find(part, name)))

    @property
    def coordinates(self) -> list[str]:
        """Names of the coordinates, e.g. "cab.pitch", in the order of all matrices."""
        return self.names(Part.COORDINATE)

    @property
    def links(self) -> list[str]:
        return self.names(Part.LINK)

    @property
    def roads(self) -> list[str]:
        return self.names(Part.ROAD)

    @property
    def ports(self) -> list[str]:
        return self.names(Part.PORT)

    @property
    def sensors(self) -> list[str]:
        return self.names(Part.SENSOR)

    def road_place(self, road: Reference) -> Road:
        x, y = ctypes.c_double(), ctypes.c_double()
        number = self.find(Part.ROAD, road)
        check_plain(quick.trk_model_get_road_place(self._live(), number, ctypes.byref(x),
                                                   ctypes.byref(y)), f"road {road!r}")
        return Road(x.value, y.value)

    # Matrices

    @property
    def static(self) -> Static:
        """Static equilibrium; minus the force of a tire is its load."""
        q, force = np.empty(self.count(Part.COORDINATE)), np.empty(self.count(Part.LINK))
        lib.trk_model_get_static(self._live(), q.ctypes, force.ctypes)
        return Static(q, force)

    @property
    def mass(self) -> Array:
        """Mass matrix [kg, kg m, kg m^2]."""
        n = self.count(Part.COORDINATE)
        out = np.empty((n, n))
        lib.trk_model_get_mass(self._live(), out.ctypes)
        return out

    def tangent(self, q: Optional[npt.ArrayLike] = None,
                v: Optional[npt.ArrayLike] = None) -> Tangent:
        """Damping and stiffness matrices about q [m, rad] and v [m/s, rad/s]; default at rest."""
        n = self.count(Part.COORDINATE)
        damping, stiffness = np.empty((n, n)), np.empty((n, n))
        lib.trk_model_get_tangent(self._live(), optional(q, "q", n), optional(v, "v", n),
                                  damping.ctypes, stiffness.ctypes)
        return Tangent(damping, stiffness)

    def link_row(self, link: Reference) -> tuple[Array, Array]:
        """Rows of B over the coordinates and of G over the roads: e = B q - G u."""
        b, g = np.empty(self.count(Part.COORDINATE)), np.empty(self.count(Part.ROAD))
        check_plain(lib.trk_model_get_link_row(self._live(), self.find(Part.LINK, link), b.ctypes,
                                               g.ctypes), f"link {link!r}")
        return b, g

    def row(self, part: Part, name: Reference) -> Array:
        """Row over the coordinates of a port or of a sensor."""
        out = np.empty(self.count(Part.COORDINATE))
        check_plain(lib.trk_model_get_row(self._live(), part, self.find(part, name), out.ctypes),
                    f"{part.name.lower()} {name!r}")
        return out

    def link_force(self, elongation: npt.ArrayLike, rate: npt.ArrayLike) -> Array:
        """Force of every link [N, N m] at given elongations [m, rad] and rates [m/s, rad/s]."""
        n = self.count(Part.LINK)
        e, v, out = vector(elongation, "elongation", n), vector(rate, "rate", n), np.empty(n)
        lib.trk_model_get_link_force(self._live(), e.ctypes, v.ctypes, out.ctypes)
        return out

    # What follows from it

    def reduce(self, settings: Optional[ReduceOptions] = None, **changes: Any) -> Model:
        """A model of fewer coordinates: the inner nodes of a frame follow its interface to other
        bodies, and move in its lowest modes besides (Craig-Bampton).

        Keywords are the fields of ReduceOptions: pattern of the names of its nodes ("frame.*"),
        modes (20), interface_modes, modal_damping [-].
        """
        given = options(ReduceOptions, settings, changes)
        return self._derived("reduce", (given,), create(
            quick.trk_model_destroy, lib.trk_model_reduce, self._live(),
            ctypes.byref(given._to_struct())))

    def linearise(self, frequency: npt.ArrayLike, inputs: npt.ArrayLike,
                  **options: Any) -> Linearised:
        """Linear links nearest to its own under random inputs; as truckride.linearise()."""
        from .linearise import linearise
        return linearise(self, frequency, inputs, **options)

    def _linearised(self, frequency: Array, inputs: npt.ArrayLike,
                    given: LineariseOptions) -> Model:
        return self.linearise(frequency, inputs, settings=given).model

    def _derived(self, step: str, given: tuple[Any, ...], handle: Handle) -> Model:
        model = Model.__new__(Model)
        model._options, model._spec = self._options, self._spec
        model._steps, model._handle = (*self._steps, (step, given)), handle
        return model

    def modes(self, damped: Optional[bool] = None, **options: Any) -> Modes:
        """Damped or undamped modes, or the lowest of a large model, modes(count=20); options as
        truckride.Modes."""
        from .linear import Modes
        return Modes(self, damped, **options)

    def response(self, frequency: npt.ArrayLike, **options: Any) -> Response:
        """Frequency response of all sensors; options as truckride.frequency_response()."""
        from .linear import frequency_response
        return frequency_response(self, frequency, **options)

    def stepper(self, method: str = "newmark", **options: Any) -> Stepper:
        """A stepper, to drive the model a step a call: truckride.Newmark or RungeKutta."""
        from . import _stepper
        stepper: Stepper = _stepper.of_method(method)(self, **options)
        return stepper

    def simulate(self, excitation: Union[Excitation, Signal], **options: Any) -> Series:
        """Run over an excitation, or with all wheels on a signal; as truckride.simulate()."""
        from .simulate import simulate
        return simulate(self, excitation, **options)

    def plot(self, **options: Any) -> Axes:
        """Side view; options as truckride.plot.side_view()."""
        from . import plot
        return plot.side_view(self.describe(), **options)

    def __reduce__(self) -> tuple[Any, ...]:
        self._live()
        return _rebuild, (self._spec, self._options, self._steps)

    def __repr__(self) -> str:
        if self.closed:
            return "<Model, closed>"
        return f"<Model '{self.name}', {self.count(Part.COORDINATE)} coordinates>"


def _rebuild(spec: Spec, given: ModelOptions,
             steps: tuple[tuple[str, tuple[Any, ...]], ...]) -> Model:
    model = Model(spec, given.gravity, bool(given.allow_free))
    for name, arguments in steps:
        model = getattr(model, name)(*arguments)
    return model
