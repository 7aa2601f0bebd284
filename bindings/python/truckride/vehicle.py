# SPDX-License-Identifier: MIT
"""Ready-made vehicles: quarter car, half car, half truck, 3D truck, and built-in data."""
from __future__ import annotations

import ctypes
from typing import Any, Optional, Union

from ._abi import TRK_FRONT, TRK_REAR, Variant, Vehicle
from ._library import lib
from ._options import HalfCarParameters, QuarterCarParameters, TruckParameters
from ._struct import Fields, member, options
from .errors import ArgumentError
from .spec import Spec

AXLES = {"front": TRK_FRONT, "rear": TRK_REAR}


def vehicle(name: Union[Vehicle, str] = Vehicle.REFERENCE_TRUCK,
            variant: Union[Variant, str] = Variant.LINEAR) -> Spec:
    """A built-in vehicle.

    Args:
        name: "thesis_quarter", "reference_front", "reference_rear" (quarter cars),
            "reference_half" (7 coordinates) or "reference_truck" (13 coordinates)
        variant: "linear", "thesis_dampers" or "nonlinear"
    """
    return Spec._make(lib.trk_vehicle_create_builtin, member(Vehicle, name),
                      member(Variant, variant))


def _from(function: Any, given: Fields, *arguments: Any) -> Spec:
    return Spec._make(function, ctypes.byref(given._to_struct()), *arguments)


def quarter_car(parameters: Optional[QuarterCarParameters] = None, **changes: Any) -> Spec:
    """Quarter car, 2 coordinates; keywords are the fields of QuarterCarParameters."""
    return _from(lib.trk_vehicle_create_quarter_car,
                 options(QuarterCarParameters, parameters, changes))


def half_car(parameters: Optional[HalfCarParameters] = None, **changes: Any) -> Spec:
    """Half car, 4 coordinates; keywords are the fields of HalfCarParameters."""
    return _from(lib.trk_vehicle_create_half_car, options(HalfCarParameters, parameters, changes))


def half_truck(parameters: Optional[TruckParameters] = None, **changes: Any) -> Spec:
    """Left half of a truck, 7 coordinates; keywords are the fields of TruckParameters."""
    return _from(lib.trk_vehicle_create_half_truck, options(TruckParameters, parameters, changes))


def truck(parameters: Optional[TruckParameters] = None, **changes: Any) -> Spec:
    """3D truck, 13 coordinates; keywords are the fields of TruckParameters."""
    return _from(lib.trk_vehicle_create_truck, options(TruckParameters, parameters, changes))


def axle_quarter(axle: Union[int, str], parameters: Optional[TruckParameters] = None,
                 **changes: Any) -> Spec:
    """Quarter car of one wheel of a truck's axle, "front" or "rear"."""
    if isinstance(axle, str) and axle not in AXLES:
        raise ArgumentError(f"axle: {axle!r} is none of front, rear")
    number = AXLES[axle] if isinstance(axle, str) else axle
    return _from(lib.trk_vehicle_create_axle_quarter,
                 options(TruckParameters, parameters, changes), number)
