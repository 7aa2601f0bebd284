# SPDX-License-Identifier: MIT
"""Sections of beams, by their dimensions and material: stiffness and mass per length.

    rail = tr.section.channel(0.27, 0.08, web=0.008, flange=0.008)
    spec.add_frame("frame", stations, crosses, rail=rail, member=rail, half_width=0.4)
"""
from __future__ import annotations

import ctypes
import dataclasses
from typing import Any

from ._library import lib
from ._native import check, scratch
from ._options import Beam


@dataclasses.dataclass(frozen=True)
class Material:
    """Moduli of elasticity and shear [Pa], density [kg/m^3]."""

    young: float = 2.1e11
    shear: float = 8.1e10
    density: float = 7850.0


STEEL = Material()


def _fill(function: Any, material: Material, dimensions: tuple[float, ...],
          changes: dict[str, Any]) -> Beam:
    struct, context = Beam(**changes)._to_struct(), scratch()
    check(function(context, material.young, material.shear, material.density, *dimensions,
                   ctypes.byref(struct)), context)
    return Beam._from_struct(struct)


def channel(height: float, width: float, web: float, flange: float,
            material: Material = STEEL, **changes: Any) -> Beam:
    """Channel section [m]: height along z, width along y, thickness of web and flanges.

    changes: other fields of Beam, e.g. stiffness_damping=1e-4. Warping is not modelled.
    """
    return _fill(lib.trk_beam_options_channel, material, (height, width, web, flange), changes)


def box(height: float, width: float, web: float, flange: float,
        material: Material = STEEL, **changes: Any) -> Beam:
    """Closed rectangular section [m]; web and flange: thickness of the walls along z and y."""
    return _fill(lib.trk_beam_options_box, material, (height, width, web, flange), changes)


def rectangle(height: float, width: float, material: Material = STEEL, **changes: Any) -> Beam:
    """Full rectangle [m], height along z."""
    return _fill(lib.trk_beam_options_rectangle, material, (height, width), changes)


def tube(outer: float, wall: float, material: Material = STEEL, **changes: Any) -> Beam:
    """Round tube [m] by outer diameter and wall thickness; a wall of half of it is a rod."""
    return _fill(lib.trk_beam_options_tube, material, (outer, wall), changes)
