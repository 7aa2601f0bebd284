# SPDX-License-Identifier: MIT
"""Spectra of measured or simulated channels: PSD, cross spectrum, coherence, FRF, peaks."""
from __future__ import annotations

import ctypes
import dataclasses
from typing import TYPE_CHECKING, Any, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from ._abi import PeakOrder, Scaling
from ._library import lib, quick
from ._native import Array, ComplexArray, check, scratch, vector
from ._options import PeakOptions, SpectrumOptions
from ._struct import options
from .errors import ArgumentError

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Peak(NamedTuple):
    """A peak of a PSD: frequency [Hz], height and prominence [unit of the density]."""

    frequency: float
    height: float
    prominence: float


@dataclasses.dataclass(frozen=True)
class Psd:
    """A one-sided spectrum.

    frequency: [Hz]
    density: [unit^2/Hz, or unit^2 with Scaling.SPECTRUM]
    unit: of the samples, "" if unknown
    name: of the channel
    """

    frequency: Array
    density: Array
    unit: str = ""
    name: str = ""
    scaling: Scaling = Scaling.DENSITY

    @property
    def step(self) -> float:
        """[Hz] between two frequencies."""
        return float(self.frequency[1] - self.frequency[0]) if len(self.frequency) > 1 else 0.0

    @property
    def density_unit(self) -> str:
        if not self.unit:
            return "-"
        square = f"({self.unit})^2" if "/" in self.unit else f"{self.unit}^2"
        return square + "/Hz" if self.scaling == Scaling.DENSITY else square

    def peaks(self, count: Optional[int] = None, **changes: Any) -> list[Peak]:
        """Local maxima, highest first. Keywords are the fields of PeakOptions:
        minimum_height, minimum_prominence [unit of the density], minimum_distance [Hz],
        order (PeakOrder)."""
        first = self._first()
        return [peak._replace(frequency=peak.frequency + first)
                for peak in psd_peaks(self.density, self.step, **changes)[:count]]

    def _first(self) -> float:
        """First frequency [Hz]; they must be equally far apart, if not from 0 on."""
        steps = np.diff(self.frequency)
        if len(steps) and np.ptp(steps) > 1e-6 * self.step:
            raise ArgumentError("the frequencies of this spectrum are not equally far apart")
        return float(self.frequency[0])

    def band_rms(self, low: float = 0.0, high: Optional[float] = None) -> float:
        """RMS [unit] of the part between two frequencies [Hz]."""
        first = self._first()
        end = 2 * float(self.frequency[-1]) + self.step if high is None else high
        return band_rms(self.density, self.step, max(low - first, 0.0), max(end - first, 0.0))

    def normalised(self, reference: float = 0.0) -> Psd:
        """Divided by a reference [unit of the density]; 0 for its own maximum."""
        return dataclasses.replace(self, density=psd_normalise(self.density, reference)[0],
                                   unit="")

    def plot(self, **options: Any) -> Axes:
        """Spectrum with marked peaks; options as truckride.plot.psd()."""
        from . import plot
        return plot.psd(self, **options)


def _length(struct: Any, count: int) -> int:
    return quick.trk_psd_length(ctypes.byref(struct), count)


def _frequencies(struct: Any, count: int, rate: float) -> Array:
    out, context = np.empty(_length(struct, count)), scratch()
    check(lib.trk_psd_frequencies(context, count, rate, ctypes.byref(struct), out.ctypes), context)
    return out


def psd_frequencies(count: int, rate: float, settings: Optional[SpectrumOptions] = None,
                    **changes: Any) -> Array:
    """Frequencies [Hz] of a spectrum of count samples at rate [Hz]."""
    return _frequencies(options(SpectrumOptions, settings, changes)._to_struct(), count, rate)


def psd_segments(count: int, settings: Optional[SpectrumOptions] = None, **changes: Any) -> int:
    """Number of segments that are averaged; 0 if the settings do not fit count samples."""
    struct = options(SpectrumOptions, settings, changes)._to_struct()
    return quick.trk_psd_segments(ctypes.byref(struct), count)


def psd(x: npt.ArrayLike, rate: float, settings: Optional[SpectrumOptions] = None, *,
        unit: str = "", name: str = "", **changes: Any) -> Psd:
    """One-sided power spectral density by Welch's method, as scipy.signal.welch.

    Args:
        x: samples [any]; a contiguous array of doubles is not copied
        rate: sample rate [Hz]
        settings: SpectrumOptions; its fields can also be given as keywords: segment_length
            (default 4096), overlap (0.5), window ("hann"), detrend ("constant"), scaling
            ("density"), kaiser_beta
        unit, name: of the samples, for plots
    """
    given = options(SpectrumOptions, settings, changes)
    samples, struct, context = vector(x, "x"), given._to_struct(), scratch()
    density = np.empty(_length(struct, len(samples)))
    check(lib.trk_psd(context, len(samples), samples.ctypes, rate, ctypes.byref(struct),
                      density.ctypes), context)
    return Psd(_frequencies(struct, len(samples), rate), density, unit, name, given.scaling)


def _pair(function: Any, x: npt.ArrayLike, y: npt.ArrayLike, rate: float, with_rate: bool,
          parts: int, given: SpectrumOptions) -> tuple[Array, Array]:
    """Frequencies and a spectrum of two channels with one or two doubles a frequency."""
    first, second = vector(x, "x"), vector(y, "y")
    if len(first) != len(second):
        raise ArgumentError(f"x has {len(first)} samples, y has {len(second)}")
    struct, context = given._to_struct(), scratch()
    out = np.empty(parts * _length(struct, len(first)))
    rates = (rate,) if with_rate else ()
    check(function(context, len(first), first.ctypes, second.ctypes, *rates,
                   ctypes.byref(struct), out.ctypes), context)
    return _frequencies(struct, len(first), rate), out


def csd(x: npt.ArrayLike, y: npt.ArrayLike, rate: float,
        settings: Optional[SpectrumOptions] = None, **changes: Any) -> tuple[Array, ComplexArray]:
    """Frequencies [Hz] and one-sided cross spectral density of x and y, as scipy.signal.csd."""
    frequency, out = _pair(lib.trk_csd, x, y, rate, True, 2,
                           options(SpectrumOptions, settings, changes))
    return frequency, out.view(np.complex128)


def coherence(x: npt.ArrayLike, y: npt.ArrayLike, rate: float,
              settings: Optional[SpectrumOptions] = None, **changes: Any) -> tuple[Array, Array]:
    """Frequencies [Hz] and magnitude-squared coherence [-]."""
    return _pair(lib.trk_coherence, x, y, rate, False, 1,
                 options(SpectrumOptions, settings, changes))


def frf(x: npt.ArrayLike, y: npt.ArrayLike, rate: float,
        settings: Optional[SpectrumOptions] = None, **changes: Any) -> tuple[Array, ComplexArray]:
    """Frequencies [Hz] and response from x to y [unit of y / unit of x], H1 estimator."""
    frequency, out = _pair(lib.trk_frf_h1, x, y, rate, False, 2,
                           options(SpectrumOptions, settings, changes))
    return frequency, out.view(np.complex128)


def psd_normalise(density: npt.ArrayLike, reference: float = 0.0) -> tuple[Array, float]:
    """PSD over a reference, 0 for its own maximum; returns it and the divisor."""
    values, context, divisor = vector(density, "density"), scratch(), ctypes.c_double()
    out = np.empty_like(values)
    check(lib.trk_psd_normalise(context, len(values), values.ctypes, reference, out.ctypes,
                                ctypes.byref(divisor)), context)
    return out, divisor.value


def band_rms(density: npt.ArrayLike, frequency_step: float, low: float, high: float) -> float:
    """RMS [any] between two frequencies [Hz] from a PSD [any^2/Hz]."""
    values, context, out = vector(density, "density"), scratch(), ctypes.c_double()
    check(lib.trk_band_rms(context, len(values), values.ctypes, frequency_step, low, high,
                           ctypes.byref(out)), context)
    return out.value


def psd_peaks(density: npt.ArrayLike, frequency_step: float,
              settings: Optional[PeakOptions] = None, **changes: Any) -> list[Peak]:
    """Peaks of a PSD, highest first, as scipy.signal.find_peaks with interpolated frequency."""
    values, context, found = vector(density, "density"), scratch(), ctypes.c_int64()
    struct = options(PeakOptions, settings, changes)._to_struct()
    room = len(values)
    out = np.empty((3, room))
    check(lib.trk_psd_peaks(context, room, values.ctypes, frequency_step, ctypes.byref(struct),
                            room, out[0].ctypes, out[1].ctypes, out[2].ctypes,
                            ctypes.byref(found)), context)
    return [Peak(*map(float, column)) for column in out[:, :found.value].T]


__all__ = ["Peak", "PeakOrder", "Psd", "band_rms", "coherence", "csd", "frf", "psd",
           "psd_frequencies", "psd_normalise", "psd_peaks", "psd_segments"]
