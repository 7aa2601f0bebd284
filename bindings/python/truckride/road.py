# SPDX-License-Identifier: MIT
"""Random roads of ISO 8608: two tracks as signals over distance."""
from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from ._abi import RoadClass
from ._library import lib, quick
from ._native import Array, Handle, check, create, scratch, vector
from ._options import RoadOptions
from ._struct import member, options
from .signal import Signal


class Tracks(NamedTuple):
    """Left and right track [m over m]."""

    left: Signal
    right: Signal


def unevenness(road_class: Union[RoadClass, str]) -> float:
    """Unevenness [m^3] at 0.1 cycles/m of a class "a" to "h"."""
    return quick.trk_road_class_unevenness(member(RoadClass, road_class))


def choose(settings: Optional[RoadOptions], road_class: Union[RoadClass, str, None],
           changes: dict[str, Any]) -> RoadOptions:
    """Options of a road, whose unevenness may be given by a class."""
    if road_class is not None:
        changes["unevenness"] = unevenness(road_class)
    return options(RoadOptions, settings, changes)


def road(settings: Optional[RoadOptions] = None, *,
         road_class: Union[RoadClass, str, None] = None, **changes: Any) -> Tracks:
    """A random road, the same for the same options; keywords are the fields of RoadOptions:
    unevenness [m^3] (or road_class), waviness, low, high [1/m], seed, tracks, track_width [m]."""
    chosen, left = choose(settings, road_class, changes), ctypes.c_void_p()

    def make(context: int, out_right: Any) -> int:
        return lib.trk_road_create(context, ctypes.byref(chosen._to_struct()), ctypes.byref(left),
                                   out_right)
    # Both live in one context: the left one keeps the right one, which frees the context last.
    second = create(quick.trk_signal_destroy, make)
    assert left.value is not None
    first = Handle(quick.trk_signal_destroy, left.value, None, (second,))
    return Tracks(Signal._of(first, ("_track", (chosen, 0))),
                  Signal._of(second, ("_track", (chosen, 1))))


def _over(function: Any, wavenumber: npt.ArrayLike, chosen: RoadOptions) -> Array:
    places, context = vector(wavenumber, "wavenumber"), scratch()
    out = np.empty_like(places)
    check(function(context, ctypes.byref(chosen._to_struct()), len(places), places.ctypes,
                   out.ctypes), context)
    return out


def road_density(wavenumber: npt.ArrayLike, settings: Optional[RoadOptions] = None,
                 **changes: Any) -> Array:
    """One-sided PSD of the height [m^3] over wavenumber [1/m]."""
    return _over(lib.trk_road_density, wavenumber, options(RoadOptions, settings, changes))


def road_coherence(wavenumber: npt.ArrayLike, settings: Optional[RoadOptions] = None,
                   **changes: Any) -> Array:
    """Coherence of the tracks [-] over wavenumber [1/m], for road_cross_spectra()."""
    return _over(lib.trk_road_coherence, wavenumber, options(RoadOptions, settings, changes))
