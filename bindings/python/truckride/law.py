# SPDX-License-Identifier: MIT
"""Force laws beyond springs, dampers and curves: contact, stops, friction, air."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from ._abi import LawKind
from ._library import lib, quick
from ._native import Array, Native, check, check_plain, create, encode, scratch, text, vector
from ._options import (AirSpringOptions, FrictionOptions, LeafOptions, SealOptions, StopsOptions,
                       TireOptions)
from ._struct import Fields, member, options

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_KINDS: dict[LawKind, tuple[type[Fields], Any, Any]] = {
    LawKind.TIRE: (TireOptions, lib.trk_law_create_tire, quick.trk_law_get_tire),
    LawKind.STOPS: (StopsOptions, lib.trk_law_create_stops, quick.trk_law_get_stops),
    LawKind.LEAF: (LeafOptions, lib.trk_law_create_leaf, quick.trk_law_get_leaf),
    LawKind.FRICTION: (FrictionOptions, lib.trk_law_create_friction, quick.trk_law_get_friction),
    LawKind.AIR_SPRING: (AirSpringOptions, lib.trk_law_create_air_spring,
                         quick.trk_law_get_air_spring),
    LawKind.SEAL: (SealOptions, lib.trk_law_create_seal, quick.trk_law_get_seal)}


class Trace(NamedTuple):
    """Force of a law along a path [N or N m], and the energy lost up to each point [J]."""

    force: Array
    lost: Array


class Equivalent(NamedTuple):
    """Stiffness [N/m or N m/rad] and damping [N s/m or N m s/rad] of a link like a law."""

    stiffness: float
    damping: float


class Law(Native):
    """A force law for a link, beside its stiffness, damping and curves. Immutable.

        leaf = tr.Law("leaf", friction=2500, approach_bump=0.002)
        spec.add_link("front_spring", ..., stiffness=2.2e5, law=leaf)

    Args:
        kind: "tire" (lifts off), "stops" (bump and rebound), "leaf" (inter-leaf friction),
            "friction" (dry), "air_spring" or "seal" (Stribeck)
        name: what messages call it; default the kind
        settings: TireOptions, StopsOptions, LeafOptions, FrictionOptions, AirSpringOptions or
            SealOptions, by the kind; their fields can be keywords too
    """

    def __init__(self, kind: Union[LawKind, str], name: str = "",
                 settings: Optional[Fields] = None, **changes: Any) -> None:
        chosen = member(LawKind, kind)
        fields, make, _ = _KINDS[chosen]
        struct = options(fields, settings, changes)._to_struct()
        self._handle = create(quick.trk_law_destroy, make, encode(name or chosen.name.lower()),
                              ctypes.byref(struct))

    @classmethod
    def _copy_of(cls, pointer: int) -> Law:
        law = cls.__new__(cls)
        law._handle = create(quick.trk_law_destroy, lib.trk_law_copy, pointer)
        return law

    @property
    def kind(self) -> LawKind:
        return LawKind(quick.trk_law_get_kind(self._live()))

    @property
    def name(self) -> str:
        return text(quick.trk_law_name(self._live()))

    @property
    def parameters(self) -> Any:
        """Its parameters: TireOptions, LeafOptions, ... by its kind."""
        fields, _, get = _KINDS[self.kind]
        struct = fields._sized()
        check_plain(get(self._live(), ctypes.byref(struct)), f"law '{self.name}'")
        return fields._from_struct(struct)

    def trace(self, elongation: npt.ArrayLike, step: float = 0.001) -> Trace:
        """Force along a path of elongations [m or rad], step [s] apart, from rest at the first."""
        path, context = vector(elongation, "elongation"), scratch()
        force, lost = np.empty_like(path), np.empty_like(path)
        check(lib.trk_law_trace(context, self._live(), len(path), step, path.ctypes, force.ctypes,
                                lost.ctypes), context)
        return Trace(force, lost)

    def equivalent(self, amplitude: float, frequency: float, mean: float = 0.0) -> Equivalent:
        """Linear link with the same harmonic of the force in a settled cycle of an amplitude
        [m or rad] and a frequency [Hz] about a mean [m or rad]: its describing function."""
        stiffness, damping, context = ctypes.c_double(), ctypes.c_double(), scratch()
        check(lib.trk_law_describe(context, self._live(), mean, amplitude, frequency,
                                   ctypes.byref(stiffness), ctypes.byref(damping)), context)
        return Equivalent(stiffness.value, damping.value)

    def plot(self, amplitude: float, frequency: float = 1.0, **options: Any) -> Axes:
        """Loop under a sine of an amplitude [m or rad] and a frequency [Hz], after one cycle to
        settle; options as truckride.plot.loop()."""
        from . import plot
        return plot.loop(self, amplitude, frequency, **options)

    def _content(self) -> tuple[Any, ...]:
        return self.kind, self.name, self.parameters

    def __reduce__(self) -> tuple[Any, ...]:
        return Law, self._content()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Law) and self._content() == other._content()

    def __hash__(self) -> int:
        return hash((self.kind, self.name))

    def __repr__(self) -> str:
        if self.closed:
            return "<Law, closed>"
        return f"<Law '{self.name}', {self.kind.name.lower()}>"
