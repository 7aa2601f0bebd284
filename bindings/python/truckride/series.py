# SPDX-License-Identifier: MIT
"""Sampled channels: names, units, sample rate. What a run records."""
from __future__ import annotations

import ctypes
import os
from typing import TYPE_CHECKING, Any, Iterator, Mapping, Optional, Union

import numpy as np
import numpy.typing as npt

from ._library import lib, quick
from ._native import (Array, Exclusive, Handle, Native, borrow, check, create, encode, encode_path,
                      scratch, text, vector)
from ._options import RpcOptions
from ._struct import options
from .errors import ArgumentError, UnknownNameError
from .spectrum import Psd, psd

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class Channel:
    """One channel of a series: an array with a name, a unit and a time axis.

    NumPy functions take it as it is; values is the same memory, not a copy.
    """

    def __init__(self, name: str, unit: str, values: Array, rate: float, start: float) -> None:
        self.name, self.unit, self.values = name, unit, values
        self.rate, self.start = rate, start

    @property
    def time(self) -> Array:
        """Time or place of each sample [s or m]."""
        return self.start + np.arange(len(self.values)) / self.rate

    @property
    def rms(self) -> float:
        """Root mean square [unit]."""
        return float(np.sqrt(np.mean(np.square(self.values))))

    def psd(self, **options: Any) -> Psd:
        """Power spectral density; options as truckride.psd()."""
        return psd(self.values, self.rate, unit=self.unit, name=self.name, **options)

    def plot(self, **options: Any) -> Axes:
        """Time signal; options as truckride.plot.channels()."""
        from . import plot
        return plot.channels([self], **options)

    def __array__(self, dtype: Any = None) -> Any:
        return np.asarray(self.values, dtype=dtype)

    def __len__(self) -> int:
        return len(self.values)

    def __getitem__(self, key: Any) -> Any:
        return self.values[key]

    def __repr__(self) -> str:
        return f"<Channel '{self.name}' [{self.unit}], {len(self)} samples, rate {self.rate:g}>"


class Series(Native, Mapping[str, Channel]):
    """Equally spaced samples of several channels over one axis, time or, as a profile, distance.

    A mapping from channel names to channels, whose arrays are views of the library's memory.

    Args:
        data: channels by name [any], all of one length; copied
        rate: sample rate [Hz or 1/m]
        start: time or place of the first sample [s or m]
        units: unit of each channel by name, "" where not given
    """

    def __init__(self, data: Mapping[str, npt.ArrayLike], rate: float, start: float = 0.0,
                 units: Optional[Mapping[str, str]] = None) -> None:
        arrays = {name: vector(values, name) for name, values in data.items()}
        lengths = {len(values) for values in arrays.values()}
        if len(lengths) != 1:
            raise ArgumentError(f"channels of one length are expected, not {sorted(lengths)}")
        self._handle = create(quick.trk_series_destroy, lib.trk_series_create, len(arrays),
                              lengths.pop(), rate, start)
        for number, (name, values) in enumerate(arrays.items(), 1):
            self.label(number, name, (units or {}).get(name, ""))
            self._data(number)[:] = values

    @classmethod
    def _of(cls, handle: Handle) -> Series:
        series = cls.__new__(cls)
        series._handle = handle
        return series

    def label(self, channel: Union[int, str], name: str, unit: str = "") -> None:
        """Name a channel (by number from 1, or by its old name) and its unit."""
        number = channel if isinstance(channel, int) else self._number(channel)
        with Exclusive(self) as handle:
            check(lib.trk_series_label(handle, number, encode(name), encode(unit)),
                  handle.context)

    def _number(self, name: str) -> int:
        number = quick.trk_series_find(self._live(), encode(name))
        if not number:
            raise UnknownNameError(f"there is no channel '{name}'; there are {', '.join(self)}")
        return number

    def _data(self, number: int) -> Array:
        handle = self._live()
        pointer = quick.trk_series_data_mutable(handle, number)
        return borrow(pointer, self.samples, handle, writable=True)

    def __getitem__(self, name: str) -> Channel:
        handle, number = self._live(), self._number(name)
        values = borrow(quick.trk_series_data(handle, number), self.samples, handle)
        values.flags.writeable = True
        return Channel(name, text(quick.trk_series_unit(handle, number)), values, self.rate,
                       self.start)

    def __contains__(self, name: object) -> bool:
        return isinstance(name, str) and bool(quick.trk_series_find(self._live(), encode(name)))

    def __iter__(self) -> Iterator[str]:
        handle = self._live()
        for number in range(1, len(self) + 1):
            yield text(quick.trk_series_name(handle, number))

    def __len__(self) -> int:
        return quick.trk_series_channels(self._live())

    @property
    def samples(self) -> int:
        """Number of samples of each channel."""
        return quick.trk_series_samples(self._live())

    @property
    def rate(self) -> float:
        """Sample rate [Hz or 1/m]."""
        return quick.trk_series_rate(self._live())

    @property
    def start(self) -> float:
        """Time or place of the first sample [s or m]."""
        return quick.trk_series_start(self._live())

    @property
    def time(self) -> Array:
        """Time or place of each sample [s or m]."""
        return self.start + np.arange(self.samples) / self.rate

    @property
    def units(self) -> dict[str, str]:
        return {name: self[name].unit for name in self}

    def resample(self, rate: float) -> Series:
        """All channels at another rate [Hz or 1/m] over the same time, low-passed."""
        return Series._of(create(quick.trk_series_destroy, lib.trk_series_resample, self._live(),
                                 rate))

    def write_csv(self, path: Union[str, os.PathLike[str]], every: int = 1) -> None:
        """Write each every-th sample with a header line of names and units."""
        context = scratch()
        check(lib.trk_series_write_csv(context, self._live(), encode_path(path), every), context)

    def write_rpc(self, path: Union[str, os.PathLike[str]], settings: Optional[RpcOptions] = None,
                  **changes: Any) -> None:
        """Write as MTS RPC III, for a rig; keywords are the fields of RpcOptions: type
        ("floating_point" or "short_integer"), big_endian, drive."""
        chosen, context = options(RpcOptions, settings, changes), scratch()
        check(lib.trk_series_write_rpc(context, self._live(), encode_path(path),
                                       ctypes.byref(chosen._to_struct())), context)

    def write_mat(self, path: Union[str, os.PathLike[str]]) -> None:
        """Write as MATLAB level 5, which MATLAB, Octave and scipy.io.loadmat() read: each channel
        a variable, with `time` [s or m], `channel_names` and `channel_units`."""
        context = scratch()
        check(lib.trk_series_write_mat(context, self._live(), encode_path(path)), context)

    def to_si(self) -> Series:
        """Convert the channels whose unit is known (mm, ft, km/h, g, kN, deg, ...) to SI, in place;
        others stay as they are. Returns the series itself."""
        with Exclusive(self) as handle:
            check(lib.trk_series_to_si(handle), handle.context)
        return self

    def plot(self, *names: str, **options: Any) -> Axes:
        """Time signals of some channels (default: the accelerations)."""
        from . import plot
        return plot.channels(plot.choose(self, names), **options)

    def plot_psd(self, *names: str, **options: Any) -> Axes:
        """Spectra of some channels with marked peaks (default: the accelerations)."""
        from . import plot
        return plot.psds(plot.choose(self, names), **options)

    def __eq__(self, other: object) -> bool:
        return self is other

    __hash__ = Native.__hash__

    def __reduce__(self) -> tuple[Any, ...]:
        data = {name: np.array(self[name].values) for name in self}
        return Series, (data, self.rate, self.start, self.units)

    def __repr__(self) -> str:
        if self.closed:
            return "<Series, closed>"
        return f"<Series of {len(self)} channels, {self.samples} samples, rate {self.rate:g}>"
