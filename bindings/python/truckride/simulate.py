# SPDX-License-Identifier: MIT
"""Run a model over an excitation into a series of all its sensors."""
from __future__ import annotations

import ctypes
from typing import Any, Optional, Union

import numpy.typing as npt

from . import _abi
from ._abi import Method, Part
from ._library import lib, quick
from ._native import create, vector, whole
from ._options import NewmarkOptions
from ._progress import Progress, Watch
from ._struct import member, options
from .excitation import Excitation, as_excitation
from .model import Model
from .series import Series
from .signal import Signal


def simulate(model: Model, excitation: Union[Excitation, Signal], duration: float = 10.0, *,
             start: float = 0.0, record_every: int = 1,
             initial_q: Optional[npt.ArrayLike] = None,
             initial_velocity: Optional[npt.ArrayLike] = None,
             method: Union[Method, str] = Method.NEWMARK,
             newmark: Optional[NewmarkOptions] = None, progress: Progress = None,
             **changes: Any) -> Series:
    """Run a model over an excitation.

    Args:
        model: may be shared by threads; the GIL is released during the run
        excitation: an Excitation, or a Signal [m over s] that moves all wheels in phase
        duration: [s]
        start: time at the beginning [s]
        record_every: record each such step
        initial_q, initial_velocity: [m, rad], [m/s, rad/s]; default static equilibrium at rest
        method: "newmark", implicit, for every model, or "runge_kutta", explicit, fourth order,
            within its limit of stability
        newmark: options of the stepper; its fields can be keywords too: step=0.001 [s], beta, ...
        progress: True for a bar in a terminal, or a function of the fraction done that may
            return True to cancel

    Returns:
        a Series with a channel a sensor, the initial state included
    """
    struct = _abi.trk_simulate_options()
    quick.trk_simulate_options_init(ctypes.byref(struct), ctypes.sizeof(struct))
    struct.duration, struct.start = duration, start
    struct.record_every = whole(record_every, "record_every")
    struct.method = member(Method, method)
    keep = []
    for field, values in (("initial_q", initial_q), ("initial_velocity", initial_velocity)):
        if values is not None:
            keep.append(vector(values, field, model.count(Part.COORDINATE)))
            setattr(struct, field, keep[-1].ctypes.data)
    settings = options(NewmarkOptions, newmark, changes)._to_struct()
    with Watch(progress, "simulate") as watch:
        handle = create(quick.trk_series_destroy, lib.trk_simulate, Model._expect(model)._live(),
                        as_excitation(model, excitation)._live(), ctypes.byref(settings),
                        ctypes.byref(struct), watch.callback, None)
    return Series._of(handle)
