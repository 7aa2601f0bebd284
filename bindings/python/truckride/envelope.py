# SPDX-License-Identifier: MIT
"""What of a road profile a tire passes on: moving average and rigid tread band.

    felt = tr.enveloped(profile, samples=2000, spacing=0.01, radius=0.5, length=0.2)
    excitation.add_profile(felt, speed=20)
"""
from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from ._library import lib, quick
from ._native import Array, check, scratch, vector
from .signal import Signal


class Envelope(NamedTuple):
    """Heights [m] and their slopes [-], as Signal.samples() takes them."""

    height: Array
    slope: Array


def _filter(function: Any, height: npt.ArrayLike, spacing: float, size: float) -> Envelope:
    given, context = vector(height, "height"), scratch()
    out = Envelope(np.empty_like(given), np.empty_like(given))
    check(function(context, len(given), spacing, given.ctypes, size, out.height.ctypes,
                   out.slope.ctypes), context)
    return out


def envelope_average(height: npt.ArrayLike, spacing: float, length: float) -> Envelope:
    """Moving average of heights [m], spacing [m] apart, over the length [m] of the contact
    patch: the exact integral of the profile, which is linear between the samples."""
    return _filter(lib.trk_envelope_average, height, spacing, length)


def envelope_rigid_band(height: npt.ArrayLike, spacing: float, radius: float) -> Envelope:
    """Height [m] of the hub of a rigid wheel of a radius [m] that rolls over heights [m],
    spacing [m] apart, less its radius."""
    return _filter(lib.trk_envelope_rigid_band, height, spacing, radius)


def envelope_weight(wavenumber: npt.ArrayLike, length: float) -> Any:
    """Factor [-] of the moving average over a length [m] on a wave of 1/m, at one or at many."""
    if isinstance(wavenumber, (int, float)):
        return quick.trk_envelope_weight(wavenumber, length)
    waves = np.asarray(wavenumber, dtype=np.float64)
    return np.array([quick.trk_envelope_weight(wave, length) for wave in waves.ravel().tolist()]
                    ).reshape(waves.shape)


def enveloped(profile: Signal, samples: int, spacing: float, *, radius: float = 0.0,
              length: float = 0.0, start: float = 0.0) -> Signal:
    """A profile [m over m] as a tire passes it on: rigid tread band, then average of its hub.

    Args:
        profile: of a Surface, of a file, a random road, ...
        samples: their number from start [m] on
        spacing: [m] of them; a tenth of the patch, or less
        radius: [m] of the tread band; 0 for none
        length: [m] of the contact patch; 0 for none
    """
    return Signal._make("_enveloped", (profile, samples, spacing, radius, length, start),
                        lib.trk_envelope_signal, Signal._expect(profile)._live(), start, spacing,
                        samples, radius, length)
