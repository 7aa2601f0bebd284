# SPDX-License-Identifier: MIT
"""Many variants of one model advanced together, over threads."""
from __future__ import annotations

import ctypes
import dataclasses
import os
from typing import Any, Callable, Optional, Sequence, Union

import numpy as np

from . import _abi
from ._abi import Part, Status
from ._library import lib, quick
from ._native import Array, check, new_context, position, whole
from ._options import NewmarkOptions
from ._progress import Progress, Watch
from ._struct import options
from .errors import ArgumentError
from .excitation import Excitation, as_excitation
from .model import Model
from .signal import Signal
from .spec import Reference

# variant, number of the first sample, samples of the block (sensors x count); true ends the variant
Sink = Callable[[int, int, Array], Any]


@dataclasses.dataclass(frozen=True, eq=False)
class Batch:
    """What run_batch() recorded.

    values: variants x sensors x samples [unit of the sensor]; NaN where a variant failed; empty
        with a sink
    sensors, units: of the second dimension, those recorded
    rate: sample rate [Hz]
    status: of each variant
    """

    values: Array
    sensors: list[str]
    units: list[str]
    rate: float
    start: float
    status: list[Status]

    def __getitem__(self, sensor: str) -> Array:
        """variants x samples of one sensor, a view."""
        values: Array = self.values[:, position(self.sensors, sensor, "sensor"), :]
        return values

    @property
    def time(self) -> Array:
        """[s]"""
        return self.start + np.arange(self.values.shape[2]) / self.rate


def _pointers(objects: Sequence[Any]) -> tuple[Any, list[Any]]:
    handles = [item._live() for item in objects]
    array = (ctypes.c_void_p * len(handles))(*(h._as_parameter_.value for h in handles))
    return array, handles


class _Sink:
    """Hands blocks to Python or copies them into an array; keeps the first exception."""

    def __init__(self, sensors: int, values: Array, sink: Optional[Sink]) -> None:
        self.sensors, self.values, self.sink = sensors, values, sink
        self.error: Optional[BaseException] = None
        self.callback = _abi.trk_batch_sink(self._called)

    def _called(self, user: Optional[int], variant: int, first: int, count: int,
                pointer: int) -> int:
        try:
            memory = (ctypes.c_double * (self.sensors * count)).from_address(pointer)
            block = np.frombuffer(memoryview(memory), dtype=np.float64).reshape(self.sensors, count)
            if self.sink:
                return int(bool(self.sink(variant, first, block.copy())))
            self.values[variant, :, first:first + count] = block
            return 0
        except BaseException as error:
            self.error = self.error or error
            return 1


def run_batch(models: Sequence[Model],
              excitations: Union[Excitation, Signal, Sequence[Union[Excitation, Signal]]],
              duration: float = 10.0, *, start: float = 0.0, record_every: int = 1,
              sensors: Optional[Sequence[Reference]] = None, threads: Optional[int] = None,
              newmark: Optional[NewmarkOptions] = None, sink: Optional[Sink] = None,
              must_succeed: bool = True, progress: Progress = None, **changes: Any) -> Batch:
    """Run variants of one model, several side by side in each of a few threads.

    Args:
        models: of the same structure, e.g. one spec compiled with other numbers
        excitations: one for all, or one each
        duration, start: [s]
        record_every: record each such step
        sensors: those to record, by name or id, in this order; default all
        threads: default one a processor
        newmark: options of the stepper; its fields can be keywords too: step [s], ...
        sink: receives blocks of samples instead of an array of all; called from several threads
        must_succeed: raise the error of the first variant that fails; else see Batch.status
        progress: as in simulate()
    """
    models = [Model._expect(model) for model in models]
    count = len(models)
    if not count:
        raise ArgumentError("models: at least one is expected")
    if isinstance(excitations, (Excitation, Signal)):
        excitations = [as_excitation(models[0], excitations)] * count
    if len(excitations) != count:
        raise ArgumentError(f"excitations: {count} are expected, not {len(excitations)}")
    roads = [as_excitation(model, given) for model, given in zip(models, excitations)]
    given = _abi.trk_batch_options()
    quick.trk_batch_options_init(ctypes.byref(given), ctypes.sizeof(given))
    given.duration, given.start = duration, start
    given.record_every = whole(record_every, "record_every")
    given.threads = os.cpu_count() or 1 if threads is None else whole(threads, "threads", 32)
    settings = options(NewmarkOptions, newmark, changes)
    step = settings._to_struct()
    samples = quick.trk_batch_samples(ctypes.byref(step), ctypes.byref(given))
    if sensors is None:
        sensors = range(1, models[0].count(Part.SENSOR) + 1)
    elif not sensors:
        raise ArgumentError("sensors: at least one is expected")
    chosen = np.array([models[0].find(Part.SENSOR, sensor) for sensor in sensors], dtype=np.int32)
    given.sensor_count, given.sensors = len(chosen), chosen.ctypes.data
    kept = np.full((count, len(chosen), 0 if sink else samples), np.nan)
    receiver = _Sink(len(chosen), kept, sink)
    model_array, model_handles = _pointers(models)
    road_array, road_handles = _pointers(roads)
    status = (ctypes.c_int32 * count)()
    context = new_context()  # not the thread's: a sink may use that
    try:
        with Watch(progress, "batch") as watch:
            result = lib.trk_batch_run(
                context, count, model_array, road_array, ctypes.byref(step), ctypes.byref(given),
                receiver.callback, None, watch.callback, None, ctypes.byref(status))
        if receiver.error is not None:
            raise receiver.error
        if must_succeed or result and not any(status):
            check(result, context)
    finally:
        quick.trk_context_destroy(context)
    del model_handles, road_handles
    known = models[0].sensors
    names = [known[number - 1] for number in chosen.tolist()]
    units = [models[0].unit(Part.SENSOR, number) for number in chosen.tolist()]
    for variant, code in enumerate(status):
        if code and not sink:
            kept[variant] = np.nan
    return Batch(kept, names, units, 1 / (settings.step * record_every), start,
                 [Status(code) for code in status])
