# SPDX-License-Identifier: MIT
"""Measured road surfaces from OpenCRG files, and profiles under the wheels."""
from __future__ import annotations

import ctypes
import math
from typing import Any, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from ._library import lib, quick
from ._native import Native, check_plain, create, encode, vector
from ._options import CrgOptions
from ._struct import options
from .files import Source, kept, load
from .series import Series
from .signal import Signal


class Extent(NamedTuple):
    """Grid of a surface [m]: u of the first and last row, the distance between rows, v of the
    rightmost and leftmost column."""

    start: float
    end: float
    increment: float
    right: float
    left: float


class Surface(Native):
    """Heights [m] over u [m], the distance along a reference line, and v [m], the distance to the
    left of it, from an ASAM OpenCRG file. Immutable; threads may share it.

    A pickled surface holds the bytes; of a path it holds the path, which is read again.

    Args:
        source: path of a file, or its bytes
        name: stands in messages for the path of bytes
        changes: fields of CrgOptions: border_u, border_v ("file", "none", "zero", "keep",
            "repeat", "reflect") and missing ("file", "keep", "zero", "neighbour")
    """

    def __init__(self, source: Source, settings: Optional[CrgOptions] = None, *,
                 name: str = "bytes", **changes: Any) -> None:
        chosen = options(CrgOptions, settings, changes)
        self._handle = load(quick.trk_crg_destroy, lib.trk_crg_read, lib.trk_crg_parse, source,
                            name, ctypes.byref(chosen._to_struct()))
        self._recipe = kept(source), chosen, name

    @property
    def rows(self) -> int:
        """Rows of the grid along u."""
        return quick.trk_crg_rows(self._live())

    @property
    def columns(self) -> int:
        """Columns of the grid across, along v."""
        return quick.trk_crg_columns(self._live())

    @property
    def extent(self) -> Extent:
        """Where the grid lies [m]."""
        out = [ctypes.c_double() for _ in range(4)]
        check_plain(quick.trk_crg_extent(self._live(), *map(ctypes.byref, out)), "extent")
        start, increment, right, left = (number.value for number in out)
        return Extent(start, start + (self.rows - 1) * increment, increment, right, left)

    def height(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Any:
        """Height [m] at u [m] along and v [m] to the left, at one place or at many, which are
        broadcast; NaN where there is none."""
        handle, function = self._live(), quick.trk_crg_height
        if isinstance(u, (int, float)) and isinstance(v, (int, float)):
            return function(handle, u, v)
        along, across = np.broadcast_arrays(np.asarray(u, dtype=np.float64),
                                            np.asarray(v, dtype=np.float64))
        places = zip(along.ravel().tolist(), across.ravel().tolist())
        return np.array([function(handle, *place) for place in places]).reshape(along.shape)

    def profile(self, v: float, smooth: bool = False) -> Signal:
        """Height [m] along a wheel path, v [m] to the left, as a signal over u [m]: linear between
        rows, or a smooth spline through them. Beyond its ends the end height is held."""
        handle = create(quick.trk_signal_destroy, lib.trk_crg_profile, self._live(), v,
                        int(smooth))
        return Signal._of(handle, ("_profile", (self._recipe, v, smooth)))

    def series(self, v: Union[float, npt.ArrayLike], spacing: Optional[float] = None,
               start: Optional[float] = None, samples: Optional[int] = None) -> Series:
        """Heights [m] along wheel paths, v [m] to the left, as channels "v=0.9" over u [m], for
        psd() and roughness.iri(). The rate of the series is 1/spacing [1/m].

        By default from the first row on, one row's distance apart, to the last row.
        """
        extent, paths = self.extent, vector(np.atleast_1d(np.asarray(v)), "v")
        step = extent.increment if spacing is None else spacing
        first = extent.start if start is None else start
        count = _count(extent.end - first, step) if samples is None else samples
        return Series._of(create(quick.trk_series_destroy, lib.trk_crg_sample, self._live(),
                                 len(paths), paths.ctypes, first, step, count))

    def __reduce__(self) -> tuple[Any, ...]:
        self._live()
        return _rebuild, self._recipe

    def __repr__(self) -> str:
        if self.closed:
            return "<Surface, closed>"
        return f"<Surface of {self.rows} rows, {self.columns} columns>"


def _rebuild(source: Source, settings: CrgOptions, name: str) -> Surface:
    return Surface(source, settings, name=name)


def _count(length: float, step: float) -> int:
    """Samples of a step that fit in a length, rounding aside; the library judges both."""
    steps = length / step if step else math.nan
    return max(math.floor(steps + 1e-6) + 1, 1) if math.isfinite(steps) else 1
