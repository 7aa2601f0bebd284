# SPDX-License-Identifier: MIT
"""Ride comfort, exposure, tire loads and suspension numbers."""
from __future__ import annotations

import ctypes
from typing import Any, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from ._abi import (Averaging, Axis, Exposure, Part, Purpose, Reaction, Unfriendly, Weighting)
from ._library import lib, quick
from ._native import (Array, ComplexArray, Exclusive, Native, check, check_plain, create, scratch,
                      text, vector)
from ._options import (AxleDropOptions, AxleTransient, LoadNumbers, TravelNumbers, Vibration)
from ._struct import member, options
from .errors import ArgumentError
from .model import Model
from .spec import Reference

WeightingLike = Union[Weighting, str]


class SeatFactor(NamedTuple):
    """Vibration on the seat over that on the floor, by RMS and by VDV [-]."""

    rms: float
    vdv: float


def _call(function: Any, *arguments: Any) -> None:
    context = scratch()
    check(function(context, *arguments), context)


def _weighting(given: WeightingLike) -> Weighting:
    return member(Weighting, given)


def weighting_name(weighting: WeightingLike) -> str:
    """Name as the standards write it, "Wk"."""
    return text(quick.trk_weighting_name(_weighting(weighting)))


def weighting_factor(weighting: WeightingLike, frequency: float) -> float:
    """Magnitude [-] of the analogue weighting at a frequency [Hz]."""
    return quick.trk_weighting_factor(_weighting(weighting), frequency)


def weighting_response(weighting: WeightingLike, frequency: npt.ArrayLike) -> ComplexArray:
    """Complex analogue weighting [-] over frequency [Hz]."""
    places = vector(frequency, "frequency")
    out = np.empty(len(places), dtype=np.complex128)
    _call(lib.trk_weighting_response, _weighting(weighting), len(places), places.ctypes, out.ctypes)
    return out


def psd_weight(weighting: WeightingLike, density: npt.ArrayLike, frequency_step: float) -> Array:
    """A PSD [(m/s^2)^2/Hz] weighted; frequency_step [Hz]."""
    given = vector(density, "density")
    out = np.empty_like(given)
    _call(lib.trk_psd_weight, _weighting(weighting), len(given), given.ctypes, frequency_step,
          out.ctypes)
    return out


def third_octave_centre(band: int) -> float:
    """Exact centre [Hz] of a third-octave band; band 0 is 1 Hz."""
    return quick.trk_third_octave_centre(band)


def third_octave_rms(density: npt.ArrayLike, frequency_step: float, first_band: int,
                     bands: int) -> Array:
    """RMS [any] in third-octave bands from a PSD [any^2/Hz]."""
    given, out = vector(density, "density"), np.empty(max(bands, 0))
    _call(lib.trk_third_octave_rms, len(given), given.ctypes, frequency_step, first_band, bands,
          out.ctypes)
    return out


def third_octave_weight(weighting: WeightingLike, rms: npt.ArrayLike, first_band: int) -> float:
    """Weighted RMS [m/s^2] from third-octave values."""
    given, out = vector(rms, "rms"), ctypes.c_double()
    _call(lib.trk_third_octave_weight, _weighting(weighting), first_band, len(given), given.ctypes,
          ctypes.byref(out))
    return out.value


def weight(weighting: WeightingLike, x: npt.ArrayLike, rate: float) -> Array:
    """A whole acceleration signal [m/s^2] at a rate [Hz] weighted from rest, e.g. by "wk"."""
    given = vector(x, "x")
    out = np.empty_like(given)
    _call(lib.trk_weighting_apply, _weighting(weighting), len(given), given.ctypes, rate,
          out.ctypes)
    return out


class WeightingFilter(Native):
    """A weighting as a filter that takes a signal block by block; rate [Hz]."""

    def __init__(self, weighting: WeightingLike, rate: float) -> None:
        self._handle = create(quick.trk_weighting_filter_destroy, lib.trk_weighting_filter_create,
                              _weighting(weighting), rate)

    def reset(self, level: float = 0.0) -> None:
        """Start again as if the input had always been level [m/s^2]."""
        with Exclusive(self) as handle:
            quick.trk_weighting_filter_reset(handle, level)

    def __call__(self, x: npt.ArrayLike) -> Array:
        """Filter the next block [m/s^2]."""
        given = vector(x, "x")
        out = np.empty_like(given)
        with Exclusive(self) as handle:
            check(lib.trk_weighting_filter_process(handle, len(given), given.ctypes, out.ctypes),
                  handle.context)
        return out


class VibrationMeter(Native):
    """Measures a weighted acceleration block by block; rate [Hz], integration_time [s]."""

    def __init__(self, rate: float, integration_time: float = 1.0) -> None:
        self._handle = create(quick.trk_vibration_meter_destroy, lib.trk_vibration_meter_create,
                              rate, integration_time)

    def reset(self) -> None:
        with Exclusive(self) as handle:
            quick.trk_vibration_meter_reset(handle)

    def process(self, x: npt.ArrayLike) -> None:
        """Measure the next block [m/s^2]."""
        given = vector(x, "x")
        with Exclusive(self) as handle:
            check(lib.trk_vibration_meter_process(handle, len(given), given.ctypes), handle.context)

    def read(self) -> Vibration:
        """Numbers so far."""
        struct = Vibration._sized()
        check_plain(quick.trk_vibration_meter_read(self._live(), ctypes.byref(struct)),
                    "vibration meter without samples")
        return Vibration._from_struct(struct)


def vibration(x: npt.ArrayLike, rate: float) -> Vibration:
    """RMS, crest factor, MTVV, VDV, ... of a weighted acceleration [m/s^2] at a rate [Hz]."""
    given, struct = vector(x, "x"), Vibration._sized()
    _call(lib.trk_vibration_measure, len(given), given.ctypes, rate, ctypes.byref(struct))
    return Vibration._from_struct(struct)


def running_rms(x: npt.ArrayLike, rate: float, integration_time: float = 1.0,
                averaging: Union[Averaging, str] = Averaging.LINEAR) -> Array:
    """Running RMS [any] at every sample; rate [Hz], integration_time [s]."""
    given = vector(x, "x")
    out = np.empty_like(given)
    _call(lib.trk_running_rms, member(Averaging, averaging), len(given), given.ctypes, rate,
          integration_time, out.ctypes)
    return out


def axis_weighting(axis: Union[Axis, str],
                   purpose: Union[Purpose, str] = Purpose.COMFORT) -> tuple[Weighting, float]:
    """Weighting and multiplying factor k of an axis."""
    weighting, factor = ctypes.c_int32(), ctypes.c_double()
    check_plain(quick.trk_axis_get(member(Axis, axis), member(Purpose, purpose),
                                   ctypes.byref(weighting), ctypes.byref(factor)), f"axis {axis}")
    return Weighting(weighting.value), factor.value


def vibration_total(rms: Mapping[Union[Axis, str], float],
                    purpose: Union[Purpose, str] = Purpose.COMFORT) -> float:
    """Vibration total value [m/s^2] of weighted RMS values by axis."""
    axes = np.array([member(Axis, axis) for axis in rms], dtype=np.int32)
    given, out = vector(list(rms.values()), "rms"), ctypes.c_double()
    _call(lib.trk_vibration_total, member(Purpose, purpose), len(axes), axes.ctypes, given.ctypes,
          ctypes.byref(out))
    return out.value


def comfort_reactions(total: float) -> Reaction:
    """All reactions of ISO 2631-1 whose overlapping bands hold a total value [m/s^2]."""
    return Reaction(quick.trk_comfort_reactions(total))


def comfort_texts(reactions: Reaction) -> list[str]:
    """Reactions in words."""
    return [text(quick.trk_comfort_text(one)) for one in Reaction if one in reactions]


def daily_a8(axis: Union[Axis, str], rms: npt.ArrayLike, duration: npt.ArrayLike) -> float:
    """Daily exposure A(8) [m/s^2] of tasks: weighted RMS [m/s^2] and duration [s]."""
    values = vector(rms, "rms")
    times, out = vector(duration, "duration", len(values)), ctypes.c_double()
    _call(lib.trk_daily_a8, member(Axis, axis), len(values), values.ctypes, times.ctypes,
          ctypes.byref(out))
    return out.value


def daily_vdv(axis: Union[Axis, str], vdv: npt.ArrayLike, measured: npt.ArrayLike,
              duration: npt.ArrayLike) -> float:
    """Daily VDV [m/s^1.75] of tasks that last duration [s] and were measured for measured [s]."""
    values = vector(vdv, "vdv")
    spans, times = (vector(measured, "measured", len(values)),
                    vector(duration, "duration", len(values)))
    out = ctypes.c_double()
    _call(lib.trk_daily_vdv, member(Axis, axis), len(values), values.ctypes, spans.ctypes,
          times.ctypes, ctypes.byref(out))
    return out.value


def exposure_of_a8(a8: float) -> Exposure:
    """Where an A(8) [m/s^2] lies."""
    return Exposure(quick.trk_exposure_of_a8(a8))


def exposure_of_vdv(vdv: float) -> Exposure:
    """Where a daily VDV [m/s^1.75] lies."""
    return Exposure(quick.trk_exposure_of_vdv(vdv))


def seat_factor(seat: npt.ArrayLike, floor: npt.ArrayLike, rate: float,
                weighting: WeightingLike = Weighting.WK) -> SeatFactor:
    """SEAT factors of accelerations [m/s^2] on the seat and below it; rate [Hz]."""
    above = vector(seat, "seat")
    below = vector(floor, "floor", len(above))
    rms, vdv = ctypes.c_double(), ctypes.c_double()
    _call(lib.trk_seat_factor, _weighting(weighting), len(above), above.ctypes, below.ctypes, rate,
          ctypes.byref(rms), ctypes.byref(vdv))
    return SeatFactor(rms.value, vdv.value)


def axle_load(forces: Sequence[npt.ArrayLike], static_load: float = 0.0) -> Array:
    """Load [N] of an axle from the recorded forces [N] of its tires and its static load [N]."""
    if not len(forces):
        raise ArgumentError("forces: at least one tire is expected")
    first = vector(forces[0], "force")
    tires = [vector(force, "force", len(first)) for force in forces]
    pointers, out = (ctypes.c_void_p * len(tires))(*(t.ctypes.data for t in tires)), np.empty(
        len(first))
    _call(lib.trk_axle_load, len(tires), len(first), pointers, static_load, out.ctypes)
    return out


def load_numbers(load: npt.ArrayLike) -> LoadNumbers:
    """Mean, deviation, dynamic load coefficient, ... of a tire or axle load [N]."""
    given, struct = vector(load, "load"), LoadNumbers._sized()
    _call(lib.trk_load_measure, len(given), given.ctypes, ctypes.byref(struct))
    return LoadNumbers._from_struct(struct)


def travel_numbers(travel: npt.ArrayLike,
                   percent: npt.ArrayLike = ()) -> tuple[TravelNumbers, Array]:
    """How far a suspension moves [m], and the travels [m] not exceeded by so many percent."""
    given, struct, wanted = vector(travel, "travel"), TravelNumbers._sized(), vector(percent, "%")
    out = np.empty_like(wanted)
    _call(lib.trk_travel_measure, len(given), given.ctypes, ctypes.byref(struct), len(wanted),
          wanted.ctypes, out.ctypes)
    return TravelNumbers._from_struct(struct), out


def axle_transient(travel: npt.ArrayLike, rate: float, rest: float = 0.0) -> AxleTransient:
    """Frequency and damping ratio of a free oscillation of a suspension [m]; rate [Hz]."""
    given, struct = vector(travel, "travel"), AxleTransient._sized()
    _call(lib.trk_axle_transient_measure, len(given), given.ctypes, rate, rest,
          ctypes.byref(struct))
    return AxleTransient._from_struct(struct)


def axle_drop(model: Model, roads: Sequence[Reference], link: Reference,
              settings: Optional[AxleDropOptions] = None, **changes: Any) -> AxleTransient:
    """Let an axle drop off a step and measure a suspension link; fields of AxleDropOptions as
    keywords: height [m], duration, step [s]."""
    numbers = np.array([model.find(Part.ROAD, road) for road in roads], dtype=np.int32)
    given, struct = options(AxleDropOptions, settings, changes)._to_struct(), AxleTransient._sized()
    _call(lib.trk_axle_drop, Model._expect(model)._live(), len(numbers), numbers.ctypes,
          model.find(Part.LINK, link), ctypes.byref(given), ctypes.byref(struct))
    return AxleTransient._from_struct(struct)


def road_friendliness(frequency: float, damping_ratio: float,
                      without_dampers: float) -> Unfriendly:
    """Conditions of 96/53/EC that an axle does not meet: frequency [Hz], damping ratios [-]."""
    return Unfriendly(quick.trk_road_friendliness(frequency, damping_ratio, without_dampers))
