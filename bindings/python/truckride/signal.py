# SPDX-License-Identifier: MIT
"""Scalar functions with their derivative: what moves a wheel or loads the frame."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Callable, Optional

import numpy.typing as npt

from ._library import lib, quick
from ._native import Array, Handle, Native, create, optional, vector
from ._options import SweepOptions
from ._struct import options
from .errors import ArgumentError

import numpy as np

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Signal(Native):
    """A function s(x) of time [s] or, as a road profile, of distance [m].

    Made by Signal.step(), sine(), sweep(), samples() or points(), by road(), enveloped(),
    read_csv_signal() or Surface.profile(). Immutable; threads and excitations may share it.
    """

    _recipe: tuple[str, tuple[Any, ...]]

    def __init__(self) -> None:
        raise TypeError("use Signal.step(), sine(), sweep(), samples() or points()")

    @classmethod
    def _make(cls, recipe: str, given: tuple[Any, ...], function: Callable[..., int],
              *arguments: Any) -> Signal:
        signal = cls.__new__(cls)
        signal._handle = create(quick.trk_signal_destroy, function, *arguments)
        signal._recipe = (recipe, given)
        return signal

    @classmethod
    def _of(cls, handle: Handle, recipe: tuple[str, tuple[Any, ...]]) -> Signal:
        signal = cls.__new__(cls)
        signal._handle, signal._recipe = handle, recipe
        return signal

    @classmethod
    def _track(cls, road: Any, number: int) -> Signal:
        from .road import road as make_road
        tracks: tuple[Signal, Signal] = make_road(road)
        return tracks[number]

    @classmethod
    def _csv(cls, source: Any, column: int, settings: Any, name: str) -> Signal:
        from .files import read_csv_signal
        return read_csv_signal(source, column, settings, name=name)

    @classmethod
    def _profile(cls, surface: tuple[Any, ...], v: float, smooth: bool) -> Signal:
        from .crg import Surface
        source, settings, name = surface
        return Surface(source, settings, name=name).profile(v, smooth)

    @classmethod
    def _enveloped(cls, profile: Signal, samples: int, spacing: float, radius: float,
                   length: float, start: float) -> Signal:
        from .envelope import enveloped
        return enveloped(profile, samples, spacing, radius=radius, length=length, start=start)

    @classmethod
    def step(cls, height: float, length: float, start: float = 0.0) -> Signal:
        """Smooth step to height [any] within length [s or m] from start [s or m] on."""
        return cls._make("step", (height, length, start), lib.trk_signal_create_step, start,
                         length, height)

    @classmethod
    def sine(cls, amplitude: float, frequency: float, phase: float = 0.0,
             start: float = 0.0) -> Signal:
        """Sine of amplitude [any], frequency [Hz or 1/m] and phase [rad]; 0 before start."""
        return cls._make("sine", (amplitude, frequency, phase, start),
                         lib.trk_signal_create_sine, amplitude, frequency, phase, start)

    @classmethod
    def sweep(cls, sweep: Optional[SweepOptions] = None, **changes: Any) -> Signal:
        """Logarithmic sine sweep; by default the thesis's road-simulator run, 0.8 to 20 Hz in
        480 s with 1 mm at 1 Hz. Keywords are the fields of SweepOptions: start_frequency,
        end_frequency [Hz], duration [s], amplitude [m at 1 Hz], amplitude_exponent [-],
        phase [rad], start [s]."""
        given = options(SweepOptions, sweep, changes)
        return cls._make("sweep", (given,), lib.trk_signal_create_sweep,
                         ctypes.byref(given._to_struct()))

    @classmethod
    def samples(cls, values: npt.ArrayLike, spacing: float, start: float = 0.0,
                rates: Optional[npt.ArrayLike] = None) -> Signal:
        """Spline through equally spaced samples [any], spacing [s or m] apart; with rates
        [any per s or m] cubic Hermite pieces."""
        y = vector(values, "values")
        return cls._make("samples", (y, spacing, start, rates), lib.trk_signal_create_samples,
                         len(y), start, spacing, y.ctypes, optional(rates, "rates", len(y)))

    @classmethod
    def points(cls, x: npt.ArrayLike, values: npt.ArrayLike) -> Signal:
        """Through points (x [s or m], values [any]) without overshoot: a road profile."""
        places, y = vector(x, "x"), vector(values, "values")
        if len(places) != len(y):
            raise ArgumentError(f"points: {len(places)} x but {len(y)} values")
        return cls._make("points", (places, y), lib.trk_signal_create_points, len(y),
                         places.ctypes, y.ctypes)

    def __call__(self, x: Any) -> Any:
        """Value s(x) [any], at one place or at many."""
        return self._map(quick.trk_signal_value, x)

    def rate(self, x: Any) -> Any:
        """Derivative s'(x) [any per s or m], exact, at one place or at many."""
        return self._map(quick.trk_signal_rate, x)

    def _map(self, function: Callable[..., float], x: Any) -> Any:
        handle = self._live()
        if isinstance(x, (int, float)):
            return function(handle, x)
        places = np.asarray(x, dtype=np.float64)
        return np.array([function(handle, place) for place in places.ravel().tolist()]
                        ).reshape(places.shape)

    def evaluate(self, count: int, spacing: float, start: float = 0.0) -> tuple[Array, Array]:
        """Values and derivatives at start + k spacing, k = 0 .. count - 1."""
        value, rate = np.empty(max(count, 0)), np.empty(max(count, 0))
        lib.trk_signal_evaluate(self._live(), count, start, spacing, value.ctypes, rate.ctypes)
        return value, rate

    def plot(self, until: float, **options: Any) -> Axes:
        """Value over time [s] or distance [m]; options as truckride.plot.signal()."""
        from . import plot
        return plot.signal(self, until, **options)

    def __reduce__(self) -> tuple[Any, ...]:
        self._live()
        return _rebuild, self._recipe

    def __repr__(self) -> str:
        return "<Signal, closed>" if self.closed else f"<Signal {self._recipe[0]}>"


def _rebuild(recipe: str, given: tuple[Any, ...]) -> Signal:
    signal: Signal = getattr(Signal, recipe)(*given)
    return signal


def sweep(options: Optional[SweepOptions] = None, **changes: Any) -> Signal:
    """Signal.sweep(): the road simulator's logarithmic sine sweep."""
    return Signal.sweep(options, **changes)
