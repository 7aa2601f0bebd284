# SPDX-License-Identifier: MIT
"""Modes and frequency response of a model about a working point."""
from __future__ import annotations

import ctypes
import dataclasses
import math
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Sequence, Union, overload

import numpy as np
import numpy.typing as npt

from ._abi import Part, RoadClass, Scaling
from ._library import lib, quick
from ._native import (Array, ComplexArray, Native, check, check_plain, create, optional, position,
                      scratch, text, vector)
from ._options import RoadOptions, SpectrumOptions
from ._struct import options
from .errors import ArgumentError, RangeError
from .excitation import Excitation, as_excitation
from .model import Model
from .road import choose
from .signal import Signal
from .spectrum import Psd, psd_frequencies

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


@dataclasses.dataclass(frozen=True, eq=False)
class Mode:
    """One mode of a model.

    number: counted from 1
    frequency: natural frequency |lambda| / 2 pi [Hz]; negative if the working point is unstable
    damped_frequency: Im lambda / 2 pi [Hz]; 0 if overdamped
    damping_ratio: [-]
    label: coordinate that takes most of its energy, e.g. "front_axle.z"
    shape: complex, over the coordinates [m, rad], phi^H M phi = 1
    energy: share of its kinetic energy in each coordinate [-]
    """

    number: int
    frequency: float
    damped_frequency: float
    damping_ratio: float
    label: str
    shape: ComplexArray
    energy: Array
    model: Model

    def plot(self, **options: Any) -> Axes:
        """Shape drawn on a side view of the truck; options as truckride.plot.mode()."""
        from . import plot
        return plot.mode(self, **options)

    def __repr__(self) -> str:
        return (f"<Mode {self.number}: {self.frequency:.3f} Hz, damping {self.damping_ratio:.3f}, "
                f"{self.label}>")


class Modes(Native, Sequence[Mode]):
    """Modes about a working point, by rising natural frequency; a sequence of Mode.

    Args:
        model: may be shared
        damped: with damping (complex shapes) or without; default with, but for a count
        q: working point [m, rad]; default static equilibrium
        v: velocity at which curves are linearised [m/s, rad/s]; default rest; damped only
        count: only so many of the lowest ones, undamped, of a model of any size
    """

    def __init__(self, model: Model, damped: Optional[bool] = None,
                 q: Optional[npt.ArrayLike] = None, v: Optional[npt.ArrayLike] = None,
                 count: Optional[int] = None) -> None:
        native, n = Model._expect(model)._live(), model.count(Part.COORDINATE)
        self.model = model
        self.damped = count is None if damped is None else bool(damped)
        if count is not None and self.damped:
            raise ArgumentError("count: the lowest modes of a model are undamped ones")
        places = optional(q, "q", n)
        if self.damped:
            self._handle = create(quick.trk_modes_destroy, lib.trk_modes_create_damped, native,
                                  places, optional(v, "v", n))
        elif count is None:
            self._handle = create(quick.trk_modes_destroy, lib.trk_modes_create_undamped, native,
                                  places)
        else:
            self._handle = create(quick.trk_modes_destroy, lib.trk_modes_create_lowest, native,
                                  places, count)

    def __len__(self) -> int:
        return quick.trk_modes_count(self._live())

    @overload
    def __getitem__(self, index: int) -> Mode: ...

    @overload
    def __getitem__(self, index: slice) -> list[Mode]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[Mode, list[Mode]]:
        if isinstance(index, slice):
            return [self[k] for k in range(*index.indices(len(self)))]
        return self._mode(range(1, len(self) + 1)[index])

    def _mode(self, number: int) -> Mode:
        handle, n = self._live(), self.model.count(Part.COORDINATE)
        re, im, share = np.empty(n), np.empty(n), np.empty(n)
        check_plain(lib.trk_modes_get_shape(handle, number, re.ctypes, im.ctypes), "mode")
        check_plain(lib.trk_modes_get_energy(handle, number, share.ctypes), "mode")
        return Mode(number, quick.trk_modes_frequency(handle, number),
                    quick.trk_modes_damped_frequency(handle, number),
                    quick.trk_modes_damping_ratio(handle, number) + 0.0,  # no -0
                    text(quick.trk_modes_label(handle, number)), re + 1j * im, share, self.model)

    def dominated_by(self, coordinate: Union[int, str]) -> list[Mode]:
        """Modes whose energy is mostly in a coordinate, e.g. "front_axle.z"."""
        handle, wanted = self._live(), self.model.find(Part.COORDINATE, coordinate)
        return [self[k] for k in range(len(self))
                if quick.trk_modes_dominant(handle, k + 1) == wanted]

    @property
    def frequencies(self) -> Array:
        """Natural frequencies [Hz]."""
        handle = self._live()
        return np.array([quick.trk_modes_frequency(handle, k + 1) for k in range(len(self))])

    @property
    def damping_ratios(self) -> Array:
        """[-]"""
        handle = self._live()
        return np.array([quick.trk_modes_damping_ratio(handle, k + 1) for k in range(len(self))])

    def plot(self, **options: Any) -> Figure:
        """All shapes on one page; options as truckride.plot.modes()."""
        from . import plot
        return plot.modes(self, **options)

    def __str__(self) -> str:
        lines = [f"{mode.number:3d} {mode.frequency:8.3f} Hz  "
                 f"damping {mode.damping_ratio + 0.0:5.3f}  {mode.label}" for mode in self]
        return "\n".join(lines)

    def __repr__(self) -> str:
        if self.closed:
            return "<Modes, closed>"
        return f"<{len(self)} {'' if self.damped else 'un'}damped modes of '{self.model.name}'>"


@dataclasses.dataclass(frozen=True, eq=False)
class Response:
    """Frequency response of all sensors.

    frequency: [Hz]
    values: complex, frequencies x sensors [unit of the sensor, for the given gains]
    sensors, units: of the columns
    """

    frequency: Array
    values: ComplexArray
    sensors: list[str]
    units: list[str]

    def __getitem__(self, sensor: str) -> ComplexArray:
        column: ComplexArray = self.values[:, position(self.sensors, sensor, "sensor")]
        return column

    def plot(self, *sensors: str, **options: Any) -> Figure:
        """Bode plot; options as truckride.plot.bode()."""
        from . import plot
        return plot.bode(self, sensors, **options)


class RandomResponse(NamedTuple):
    """Spectra of all sensors by name, and their RMS [unit of the sensor]."""

    psd: dict[str, Psd]
    rms: dict[str, float]


def road_cross_spectra(model: Model, frequency: npt.ArrayLike, density: npt.ArrayLike,
                       speed: float, coherence: Optional[npt.ArrayLike] = None) -> ComplexArray:
    """Cross spectra of the inputs of a vehicle on a homogeneous road.

    Args:
        frequency: [Hz] > 0
        density: one-sided PSD of the height of one track [m^2/Hz]
        speed: [m/s]
        coherence: of left and right [-], default 1

    Returns:
        frequencies x inputs x inputs [m^2/Hz], for response_psd()
    """
    places, context = vector(frequency, "frequency"), scratch()
    heights, out = vector(density, "density", len(places)), _inputs(model, len(places))
    check(lib.trk_road_cross_spectra(context, Model._expect(model)._live(), len(places),
                                     places.ctypes, heights.ctypes, speed,
                                     optional(coherence, "coherence", len(places)), out.ctypes),
          context)
    return out


def road_input_spectra(model: Model, frequency: npt.ArrayLike, speed: float,
                       settings: Optional[RoadOptions] = None, *,
                       road_class: Union[RoadClass, str, None] = None,
                       **changes: Any) -> ComplexArray:
    """Cross spectra of the inputs of a vehicle on a random road of ISO 8608, as road() makes it.

    Args:
        frequency: [Hz]
        speed: [m/s]
        settings: RoadOptions; its fields, or road_class "a" to "h", can be keywords too

    Returns:
        frequencies x inputs x inputs [m^2/Hz], for response_psd() and linearise()
    """
    places, context = vector(frequency, "frequency"), scratch()
    chosen = choose(settings, road_class, changes)
    out = _inputs(model, len(places))
    check(lib.trk_road_input_spectra(context, Model._expect(model)._live(),
                                     ctypes.byref(chosen._to_struct()), speed, len(places),
                                     places.ctypes, out.ctypes), context)
    return out


def _inputs(model: Model, frequencies: int) -> ComplexArray:
    """Room for the cross spectra of roads and ports."""
    inputs = model.count(Part.ROAD) + model.count(Part.PORT)
    return np.empty((frequencies, inputs, inputs), dtype=np.complex128)


def check_inputs(model: Model, frequencies: int, given: npt.ArrayLike) -> ComplexArray:
    """Cross spectra as the library reads them, of the shape that fits a model."""
    size = model.count(Part.ROAD) + model.count(Part.PORT)
    inputs, shape = np.ascontiguousarray(given, dtype=np.complex128), (frequencies, size, size)
    if inputs.shape != shape:
        raise ArgumentError(f"inputs: the shape {shape} is expected, not {inputs.shape}")
    return inputs


def _random(model: Model, frequency: Array, density: Array, rms: Array,
            scaling: Scaling = Scaling.DENSITY) -> RandomResponse:
    names = model.sensors
    units = [model.unit(Part.SENSOR, k) for k in range(1, len(names) + 1)]
    return RandomResponse(
        {name: Psd(frequency, row, unit, name, scaling)
         for name, unit, row in zip(names, units, density)},
        dict(zip(names, rms.tolist())))


def response_psd(model: Model, frequency: npt.ArrayLike, inputs: npt.ArrayLike, *,
                 q: Optional[npt.ArrayLike] = None,
                 v: Optional[npt.ArrayLike] = None) -> RandomResponse:
    """Spectra of all sensors from cross spectra of roads and ports, without time stepping.

    Args:
        frequency: [Hz], rising
        inputs: frequencies x inputs x inputs, roads before ports, of road_input_spectra() or
            road_cross_spectra()
        q, v: working point [m, rad], [m/s, rad/s]; default rest at static equilibrium
    """
    places, context = vector(frequency, "frequency"), scratch()
    n, given = model.count(Part.COORDINATE), check_inputs(model, len(places), inputs)
    density = np.empty((model.count(Part.SENSOR), len(places)))
    rms = np.empty(len(density))
    check(lib.trk_response_psd(context, Model._expect(model)._live(), optional(q, "q", n),
                               optional(v, "v", n), len(places), places.ctypes, given.ctypes,
                               density.ctypes, rms.ctypes), context)
    return _random(model, places, density, rms)


def response_psd_excited(model: Model, excitation: Union[Excitation, Signal], duration: float, *,
                         start: float = 0.0, step: float = 0.001,
                         q: Optional[npt.ArrayLike] = None, v: Optional[npt.ArrayLike] = None,
                         settings: Optional[SpectrumOptions] = None,
                         **changes: Any) -> RandomResponse:
    """Spectra that simulate() and psd() would estimate over duration [s], by linear response.

    step [s]; settings: SpectrumOptions, its fields can be keywords too.
    """
    chosen, context = options(SpectrumOptions, settings, changes), scratch()
    struct, n = chosen._to_struct(), model.count(Part.COORDINATE)
    if not (step > 0 and math.isfinite(duration / step)):
        raise RangeError(f"a step of {step} s and a duration of {duration} s are not possible")
    samples = round(duration / step) + 1
    frequency = psd_frequencies(samples, 1 / step, chosen)
    density = np.empty((model.count(Part.SENSOR), len(frequency)))
    rms = np.full(len(density), np.nan)
    wanted = None if chosen.scaling == Scaling.SPECTRUM else rms.ctypes
    check(lib.trk_response_psd_excited(
        context, Model._expect(model)._live(), optional(q, "q", n), optional(v, "v", n),
        as_excitation(model, excitation)._live(), start, step, samples, ctypes.byref(struct),
        density.ctypes, wanted), context)
    return _random(model, frequency, density, rms, chosen.scaling)


def frequency_response(model: Model, frequency: npt.ArrayLike, *,
                       road: Union[float, npt.ArrayLike, None] = None,
                       delay: Optional[npt.ArrayLike] = None,
                       load: Optional[npt.ArrayLike] = None, q: Optional[npt.ArrayLike] = None,
                       v: Optional[npt.ArrayLike] = None) -> Response:
    """Frequency response of all sensors to road heights and loads.

    Args:
        frequency: [Hz]
        road: amplitude of each road [m], one number for all; default 1 on all without a load
        delay: of each road [s]
        load: amplitude on each force port [N, N m]
        q, v: working point [m, rad], [m/s, rad/s]; default rest at static equilibrium
    """
    places, context = vector(np.atleast_1d(np.asarray(frequency)), "frequency"), scratch()
    roads, n = model.count(Part.ROAD), model.count(Part.COORDINATE)
    if road is None and load is None:
        road = 1.0
    if road is not None and np.ndim(road) == 0:
        road = np.full(roads, road)
    out = np.empty((len(places), model.count(Part.SENSOR)), dtype=np.complex128)
    check(lib.trk_frequency_response(
        context, Model._expect(model)._live(), optional(q, "q", n), optional(v, "v", n),
        len(places),
        places.ctypes, optional(road, "road", roads), optional(delay, "delay", roads),
        optional(load, "load", model.count(Part.PORT)), out.ctypes), context)
    return Response(places, out, model.sensors,
                    [model.unit(Part.SENSOR, k) for k in range(1, out.shape[1] + 1)])
