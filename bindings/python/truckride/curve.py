# SPDX-License-Identifier: MIT
"""Smooth curves through tables: damper force over velocity, spring force over elongation."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Union, overload

import numpy as np
import numpy.typing as npt

from ._abi import Extrapolation, Interpolation, Table
from ._library import lib, quick
from ._native import Array, Native, borrow, check, create, encode, scratch, text, vector
from ._options import CurveOptions
from ._struct import member
from .errors import ArgumentError

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Curve(Native):
    """Piecewise cubic y(x) through the points of a table. Immutable; threads may share it.

    Args:
        x: strictly increasing, e.g. velocity [m/s] or elongation [m], positive in extension
        y: e.g. force [N], as long as x
        name: what messages and plots call it
        interpolation: "pchip" (never overshoots), "not_a_knot" (MATLAB's spline), "natural",
            "akima" or "linear"
        extrapolation: "slope" goes straight on with the slope at the end, "clamp" stays
    """

    def __init__(self, x: npt.ArrayLike, y: npt.ArrayLike, name: str = "curve",
                 interpolation: Union[Interpolation, str] = Interpolation.PCHIP,
                 extrapolation: Union[Extrapolation, str] = Extrapolation.SLOPE) -> None:
        places, values = vector(x, "x"), vector(y, "y")
        if len(places) != len(values):
            raise ArgumentError(f"curve '{name}': {len(places)} x but {len(values)} y")
        options = CurveOptions(member(Interpolation, interpolation),
                               member(Extrapolation, extrapolation))
        self._handle = create(quick.trk_curve_destroy, lib.trk_curve_create, encode(name),
                              len(places), places.ctypes, values.ctypes,
                              ctypes.byref(options._to_struct()))

    @classmethod
    def builtin(cls, table: Union[Table, str], **options: Any) -> Curve:
        """Curve through a built-in table; options as CurveOptions, default what suits the table."""
        curve = cls.__new__(cls)
        given = ctypes.byref(CurveOptions(**options)._to_struct()) if options else None
        curve._handle = create(quick.trk_curve_destroy, lib.trk_vehicle_create_curve,
                               member(Table, table), given)
        return curve

    @classmethod
    def _copy_of(cls, pointer: int) -> Curve:
        curve = cls.__new__(cls)
        curve._handle = create(quick.trk_curve_destroy, lib.trk_curve_copy, pointer)
        return curve

    @overload
    def __call__(self, x: float) -> float: ...

    @overload
    def __call__(self, x: npt.ArrayLike) -> Any: ...

    def __call__(self, x: Any) -> Any:
        """Value y(x) at one place or at many."""
        if isinstance(x, (int, float)):
            return quick.trk_curve_value(self._live(), x)
        return self._evaluate(x, 0)

    def slope(self, x: Any) -> Any:
        """Slope y'(x), exact, at one place or at many."""
        if isinstance(x, (int, float)):
            return quick.trk_curve_slope(self._live(), x)
        return self._evaluate(x, 1)

    def _evaluate(self, x: npt.ArrayLike, which: int) -> Array:
        places = np.ascontiguousarray(x, dtype=np.float64)
        out = np.empty_like(places)
        arguments: list[Any] = [None, None]
        arguments[which] = out.ctypes
        lib.trk_curve_evaluate(self._live(), places.size, places.ctypes, *arguments)
        return out

    def solve(self, y: float) -> float:
        """The smallest x at which a monotone curve takes the value y."""
        out, context = ctypes.c_double(), scratch()
        check(lib.trk_curve_solve(context, self._live(), y, ctypes.byref(out)), context)
        return out.value

    @property
    def monotone(self) -> int:
        """1 nowhere falling, -1 nowhere rising, 0 neither."""
        return quick.trk_curve_monotone(self._live())

    @property
    def slope_range(self) -> tuple[float, float]:
        """Smallest and largest slope over the whole curve."""
        low, high = ctypes.c_double(), ctypes.c_double()
        quick.trk_curve_slope_range(self._live(), ctypes.byref(low), ctypes.byref(high))
        return low.value, high.value

    def __len__(self) -> int:
        return quick.trk_curve_count(self._live())

    @property
    def x(self) -> Array:
        """Abscissas of the table, a read-only view."""
        handle = self._live()
        return borrow(quick.trk_curve_x(handle), len(self), handle)

    @property
    def y(self) -> Array:
        """Ordinates of the table, a read-only view."""
        handle = self._live()
        return borrow(quick.trk_curve_y(handle), len(self), handle)

    @property
    def name(self) -> str:
        handle = self._live()
        return text(quick.trk_curve_name(handle))

    @property
    def interpolation(self) -> Interpolation:
        return Interpolation(quick.trk_curve_interpolation(self._live()))

    @property
    def extrapolation(self) -> Extrapolation:
        return Extrapolation(quick.trk_curve_extrapolation(self._live()))

    def plot(self, **options: Any) -> Axes:
        """Curve with its table points; options as truckride.plot.curve()."""
        from . import plot
        return plot.curve(self, **options)

    def _content(self) -> tuple[Any, ...]:
        return (self.x.tolist(), self.y.tolist(), self.name, self.interpolation,
                self.extrapolation)

    def __reduce__(self) -> tuple[Any, ...]:
        return Curve, (self.x.copy(), self.y.copy(), *self._content()[2:])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Curve) and self._content() == other._content()

    def __hash__(self) -> int:
        return hash((self.name, len(self)))

    def __repr__(self) -> str:
        if self.closed:
            return "<Curve, closed>"
        return f"<Curve '{self.name}', {len(self)} points, {self.interpolation.name.lower()}>"
