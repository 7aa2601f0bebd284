# SPDX-License-Identifier: MIT
"""International Roughness Index of road profiles."""
from __future__ import annotations

import ctypes
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from ._library import lib, quick
from ._native import Array, check, scratch, vector
from ._options import IriOptions
from ._struct import options
from .errors import ArgumentError


def iri(height: npt.ArrayLike, spacing: float, settings: Optional[IriOptions] = None,
        **changes: Any) -> float:
    """IRI [m/m], times 1000 m/km, of heights [m] at a spacing [m] of at most 0.3 m; fields of
    IriOptions as keywords: start_length [m], smoothed."""
    given, out, context = vector(height, "height"), ctypes.c_double(), scratch()
    struct = options(IriOptions, settings, changes)._to_struct()
    check(lib.trk_iri(context, len(given), given.ctypes, spacing, ctypes.byref(struct),
                      ctypes.byref(out)), context)
    return out.value


def iri_segments(height: npt.ArrayLike, spacing: float, segment_length: float,
                 settings: Optional[IriOptions] = None, **changes: Any) -> Array:
    """IRI [m/m] of consecutive segments of a length [m]."""
    given, context = vector(height, "height"), scratch()
    struct = options(IriOptions, settings, changes)._to_struct()
    out = np.empty(quick.trk_iri_segment_count(len(given), spacing, ctypes.byref(struct),
                                               segment_length))
    check(lib.trk_iri_segments(context, len(given), given.ctypes, spacing, ctypes.byref(struct),
                               segment_length, len(out), out.ctypes), context)
    return out


def _tracks(function: Any, left: npt.ArrayLike, right: npt.ArrayLike, spacing: float,
            given: IriOptions) -> float:
    first, second = vector(left, "left"), vector(right, "right")
    if len(first) != len(second):
        raise ArgumentError(f"left has {len(first)} heights, right {len(second)}")
    struct, out, context = given._to_struct(), ctypes.c_double(), scratch()
    check(function(context, len(first), first.ctypes, second.ctypes, spacing,
                   ctypes.byref(struct), ctypes.byref(out)), context)
    return out.value


def mri(left: npt.ArrayLike, right: npt.ArrayLike, spacing: float,
        settings: Optional[IriOptions] = None, **changes: Any) -> float:
    """Mean roughness index [m/m] of two tracks [m]."""
    return _tracks(lib.trk_mri, left, right, spacing, options(IriOptions, settings, changes))


def hri(left: npt.ArrayLike, right: npt.ArrayLike, spacing: float,
        settings: Optional[IriOptions] = None, **changes: Any) -> float:
    """Half-car roughness index [m/m] of two tracks [m]."""
    return _tracks(lib.trk_hri, left, right, spacing, options(IriOptions, settings, changes))


def iri_gain(wavenumber: float) -> float:
    """Gain of the standard car [-] at a wavenumber [1/m]."""
    return quick.trk_iri_gain(wavenumber)


def iri_of_road(unevenness: float, waviness: float = 2.0, low: float = 0.0,
                high: float = float("inf")) -> float:
    """Expected IRI [m/m] of a road of ISO 8608: unevenness [m^3] at 0.1 cycles/m, waviness [-],
    between two wavenumbers [1/m]."""
    out, context = ctypes.c_double(), scratch()
    check(lib.trk_iri_of_road(context, unevenness, waviness, low, high, ctypes.byref(out)), context)
    return out.value
