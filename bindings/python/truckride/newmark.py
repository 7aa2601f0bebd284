# SPDX-License-Identifier: MIT
"""Drive a compiled model: implicit time integration, one step a call."""
from __future__ import annotations

import ctypes
from typing import Any, Optional

from ._library import lib, quick
from ._native import check_plain, create
from ._options import NewmarkOptions, NewmarkStatistics
from ._stepper import Stepper
from ._struct import options
from .model import Model


class Newmark(Stepper):
    """Newmark's method and its relatives; by default average acceleration at 1 ms.

        stepper = truckride.Newmark(model, step=0.001)
        stepper.height[:] = 0.01
        stepper.step()
        print(stepper.read())

    Args:
        model: may be shared
        settings: NewmarkOptions; its fields can be keywords too: step [s], beta, gamma,
            alpha_f, alpha_m, tolerance, max_iterations, backend
    """

    _prefix = "trk_newmark"

    def __init__(self, model: Model, settings: Optional[NewmarkOptions] = None,
                 **changes: Any) -> None:
        struct = options(NewmarkOptions, settings, changes)._to_struct()
        native = Model._expect(model)._live()
        self._start(model, create(quick.trk_newmark_destroy, lib.trk_newmark_create, native,
                                  ctypes.byref(struct), keep=(native,)))
        self._advance = self._bind("step", self.height, self.velocity, self.load)

    @property
    def statistics(self) -> NewmarkStatistics:
        """Steps, iterations and the solver in use."""
        struct = NewmarkStatistics._sized()
        check_plain(quick.trk_newmark_get_statistics(self._live(), ctypes.byref(struct)),
                    "statistics")
        return NewmarkStatistics._from_struct(struct)


def _preset(function: Any, *arguments: float, step: float) -> NewmarkOptions:
    struct = NewmarkOptions(step=step)._to_struct()
    function(ctypes.byref(struct), *arguments)
    return NewmarkOptions._from_struct(struct)


def adams(step: float = 0.001) -> NewmarkOptions:
    """beta 0.36 and gamma 0.7, the constants of Adams and of the thesis; step [s]."""
    return _preset(quick.trk_newmark_options_adams, step=step)


def hht(alpha: float, step: float = 0.001) -> NewmarkOptions:
    """Hilber, Hughes and Taylor's method, alpha -1/3 to 0; step [s]."""
    return _preset(quick.trk_newmark_options_hht, alpha, step=step)


def generalized_alpha(rho_infinity: float, step: float = 0.001) -> NewmarkOptions:
    """Chung and Hulbert's method by its spectral radius at infinite frequency; step [s]."""
    return _preset(quick.trk_newmark_options_generalized_alpha, rho_infinity, step=step)
