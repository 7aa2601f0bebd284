# SPDX-License-Identifier: MIT
"""Statistical linearisation: the linear links that come nearest under random inputs."""
from __future__ import annotations

import ctypes
import dataclasses
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from ._library import lib, quick
from ._native import create, vector
from ._options import LineariseOptions
from ._struct import options
from .linear import check_inputs
from .model import Model


@dataclasses.dataclass(frozen=True)
class Linearised:
    """A model with linear links in place of its own.

    model: a model as any, without gravity; its coordinates are measured from the mean position
    stiffness: of every link by name [N/m or N m/rad]
    damping: of every link by name [N s/m or N m s/rad]
    mean: position about which the vehicle moves, by coordinate of the given model [m, rad]
    """

    model: Model
    stiffness: dict[str, float]
    damping: dict[str, float]
    mean: dict[str, float]


def linearise(model: Model, frequency: npt.ArrayLike, inputs: npt.ArrayLike,
              settings: Optional[LineariseOptions] = None, **changes: Any) -> Linearised:
    """Linear links that are nearest to curves and laws in the mean square of the force, while
    the vehicle moves under random inputs; found by iteration.

        road = tr.road_input_spectra(model, frequency, speed=20, road_class="c")
        linear = tr.linearise(model, frequency, road)
        print(linear.damping["front_left_damper"], linear.model.modes())

    Args:
        frequency: [Hz], rising; they must resolve the resonances
        inputs: frequencies x inputs x inputs, as of response_psd()
        settings: LineariseOptions; its fields can be keywords too: tolerance, relaxation,
            max_iterations
    """
    native, places = Model._expect(model)._live(), vector(frequency, "frequency")
    given = check_inputs(model, len(places), inputs)
    chosen = options(LineariseOptions, settings, changes)
    links, coordinates = model.links, model.coordinates
    stiffness, damping = np.empty((2, len(links)))
    mean = np.empty(len(coordinates))
    handle = create(quick.trk_model_destroy, lib.trk_model_linearise, native, len(places),
                    places.ctypes, given.ctypes, ctypes.byref(chosen._to_struct()),
                    stiffness.ctypes, damping.ctypes, mean.ctypes)
    return Linearised(model._derived("_linearised", (places, given, chosen), handle),
                      dict(zip(links, stiffness.tolist())), dict(zip(links, damping.tolist())),
                      dict(zip(coordinates, mean.tolist())))
