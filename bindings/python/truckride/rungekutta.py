# SPDX-License-Identifier: MIT
"""Drive a compiled model: explicit time integration of fourth order, one step a call."""
from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, Optional

import numpy as np

from ._abi import Part
from ._library import lib, quick
from ._native import check, create, scratch
from ._options import RungekuttaOptions
from ._stepper import Stepper
from ._struct import options
from .model import Model


class StepLimit(NamedTuple):
    """Longest stable step [s] and the link that is stiffest on its masses, "" for none."""

    step: float
    link: str


def step_limit(model: Model) -> StepLimit:
    """Longest stable step of the explicit method on a model."""
    step, link, context = ctypes.c_double(), ctypes.c_int32(), scratch()
    check(lib.trk_rungekutta_find_limit(context, Model._expect(model)._live(), ctypes.byref(step),
                                        ctypes.byref(link)), context)
    return StepLimit(step.value, model.names(Part.LINK)[link.value - 1] if link.value else "")


class RungeKutta(Stepper):
    """The classical Runge-Kutta method; needs the inputs in the middle of a step too.

    Attributes:
        middle_height, middle_velocity, middle_load: as height, velocity, load, half a step
            earlier

    Args:
        model: may be shared
        settings: RungekuttaOptions; its fields can be keywords too: step [s]
    """

    _prefix = "trk_rungekutta"

    def __init__(self, model: Model, settings: Optional[RungekuttaOptions] = None,
                 **changes: Any) -> None:
        struct = options(RungekuttaOptions, settings, changes)._to_struct()
        native = Model._expect(model)._live()
        self._start(model, create(quick.trk_rungekutta_destroy, lib.trk_rungekutta_create, native,
                                  ctypes.byref(struct), keep=(native,)))
        self.middle_height = np.zeros_like(self.height)
        self.middle_velocity = np.zeros_like(self.velocity)
        self.middle_load = np.zeros_like(self.load)
        self._advance = self._bind("step", self.middle_height, self.middle_velocity,
                                   self.middle_load, self.height, self.velocity, self.load)
