# SPDX-License-Identifier: MIT
"""Describe a vehicle: bodies, links, beams, road inputs, force ports, sensors."""
from __future__ import annotations

import ctypes
import dataclasses
import operator
import os
from typing import TYPE_CHECKING, Any, Callable, Optional, Sequence, TypeVar, Union

import numpy as np
import numpy.typing as npt

from . import _abi
from ._abi import Field, Free, Meaning, Motion, Part, Quantity
from ._library import lib, quick
from ._native import (Exclusive, Native, check, check_plain, create, encode, encode_path, scratch,
                      text, vector, whole)
from ._options import Beam, Body, Link, Port, Sensor
from ._struct import Fields, member
from .curve import Curve
from .errors import UnknownNameError
from .law import Law

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .model import Model

Reference = Union[int, str]
Point = Union[Sequence[float], npt.NDArray[np.float64]]
F = TypeVar("F", bound=Fields)
T = TypeVar("T")
UP = (0.0, 0.0, 1.0)
ORIGIN = (0.0, 0.0, 0.0)
ALL_FREE = Free.X | Free.Y | Free.Z | Free.ROLL | Free.PITCH | Free.YAW


@dataclasses.dataclass(frozen=True)
class Road:
    """Road input at x [m] along and y [m] across the vehicle, left positive."""

    x: float
    y: float


@dataclasses.dataclass(frozen=True)
class PointMass:
    """Mass [kg] fixed to a body (id) at a point [m]."""

    body: int
    mass: float
    point: tuple[float, float, float]


@dataclasses.dataclass
class Description:
    """Everything in a spec as plain data, by name: to compare, to print, to pickle."""

    name: str
    bodies: dict[str, Body]
    masses: dict[str, PointMass]
    roads: dict[str, Road]
    links: dict[str, Link]
    ports: dict[str, Port]
    sensors: dict[str, Sensor]
    beams: dict[str, Beam] = dataclasses.field(default_factory=dict)


def _triple(values: Point, what: str) -> tuple[float, float, float]:
    x, y, z = vector(values, what, 3).tolist()
    return x, y, z


def _section(given: Any) -> Beam:
    if not isinstance(given, Beam):
        raise TypeError(f"a section, an object of the class Beam, is expected, not {given!r}")
    return given


class Spec(Native):
    """A mutable description of a vehicle in the user's words; compile() makes equations of it.

    Parts have names, unique among parts of a kind, and ids counted from 1; wherever a part is
    meant either can be given. Points are in m, in the vehicle's axes: x forward, y left, z up.
    """

    def __init__(self, name: str) -> None:
        self._handle = create(quick.trk_spec_destroy, lib.trk_spec_create, encode(name))

    @classmethod
    def _make(cls, function: Any, *arguments: Any) -> Spec:
        spec = cls.__new__(cls)
        spec._handle = create(quick.trk_spec_destroy, function, *arguments)
        return spec

    def copy(self) -> Spec:
        with Exclusive(self) as handle:
            return Spec._make(lib.trk_spec_copy, handle)

    @property
    def name(self) -> str:
        return text(quick.trk_spec_name(self._live()))

    # Parts are added

    def _add(self, function: Any, name: str, *arguments: Any) -> int:
        out = ctypes.c_int32()
        with Exclusive(self) as handle:
            check(function(handle, encode(name), *arguments, ctypes.byref(out)), handle.context)
        return out.value

    def _add_options(self, function: Any, name: str, given: Fields) -> int:
        return self._add(function, name, ctypes.byref(given._to_struct()))

    def add_body(self, name: str, freedoms: Free = Free.Z, mass: float = 0.0,
                 inertia: Point = ORIGIN, cg: Point = ORIGIN) -> int:
        """Add a rigid body: freedoms Free.Z | Free.PITCH, mass [kg], inertia about x, y, z
        through cg [kg m^2], centre of gravity [m]. Returns its id."""
        return self._add_options(quick.trk_spec_add_body, name, Body(
            freedoms, mass, _triple(inertia, "inertia"), _triple(cg, "cg")))

    def add_mass(self, name: str, body: Reference, mass: float, point: Point) -> int:
        """Fix a point mass [kg] at a point [m] of a body."""
        place = vector(point, "point", 3)
        return self._add(quick.trk_spec_add_mass, name, self.find(Part.BODY, body), mass,
                         place.ctypes)

    def add_road(self, name: str, x: float = 0.0, y: float = 0.0) -> int:
        """Add a road input, a height [m] imposed at x, y [m]."""
        return self._add(quick.trk_spec_add_road, name, x, y)

    def add_link(self, name: str, *, to_body: Reference = 0, from_body: Reference = 0,
                 from_road: Reference = 0, to_point: Point = ORIGIN, from_point: Point = ORIGIN,
                 direction: Point = UP, motion: Motion = Motion.TRANSLATION,
                 stiffness: float = 0.0, damping: float = 0.0,
                 spring_curve: Optional[Curve] = None, damper_curve: Optional[Curve] = None,
                 spring_scale: float = 1.0, damper_scale: float = 1.0,
                 spring_offset: float = 0.0, law: Optional[Law] = None) -> int:
        """Add a spring and damper between two points, or with Motion.ROTATION an anti-roll bar.

        stiffness [N/m or N m/rad], damping [N s/m or N m s/rad], curves force over elongation
        or rate, positive in extension; a law acts beside them. Without from_body and from_road
        it starts at the ground.
        """
        return self._add_options(quick.trk_spec_add_link, name, Link(
            motion, self.find(Part.BODY, from_body), self.find(Part.ROAD, from_road),
            self.find(Part.BODY, to_body), _triple(from_point, "from_point"),
            _triple(to_point, "to_point"), _triple(direction, "direction"), stiffness, damping,
            spring_curve, damper_curve, spring_scale, damper_scale, spring_offset, law))

    def add_beam(self, name: str, section: Beam, from_body: Reference, to_body: Reference,
                 from_point: Optional[Point] = None, to_point: Optional[Point] = None,
                 up: Point = UP) -> int:
        """Add a beam between points [m] of two bodies, by default their centres of gravity; the
        body 0 is the ground, to which it is clamped. Stiffness, mass and damping are those of a
        section: truckride.section.channel()."""
        ends = [self.find(Part.BODY, body) for body in (from_body, to_body)]
        points = [_triple(point, "point") if point is not None
                  else self.body(body).cg if body else ORIGIN
                  for body, point in zip(ends, (from_point, to_point))]
        return self._add_options(quick.trk_spec_add_beam, name, _section(section).replace(
            from_body=ends[0], to_body=ends[1], from_point=points[0], to_point=points[1],
            up=_triple(up, "up")))

    def add_frame(self, name: str, stations: npt.ArrayLike, crosses: npt.ArrayLike, *,
                  rail: Beam, member: Beam, half_width: float, z: float = 0.0,
                  longest: float = 0.0, member_elements: int = 1,
                  freedoms: Free = ALL_FREE) -> None:
        """Add a ladder frame: two rails of a section with nodes at stations x [m], joined by
        members of a section at crosses x [m], each one of the stations.

        half_width: |y| of the rails [m]; z: their height [m]; longest: no element is longer [m], 0
        for stations only. Nodes are bodies called NAME.left.1, NAME.right.1, ... Free.Z |
        Free.ROLL | Free.PITCH make a frame that needs no ties in the horizontal plane.
        """
        x, members = vector(stations, "stations"), vector(crosses, "crosses")
        inner = _section(rail)._to_struct(), _section(member)._to_struct()
        struct = _abi.trk_frame_options(
            struct_size=ctypes.sizeof(_abi.trk_frame_options),
            freedoms=whole(freedoms, "freedoms", 32), half_width=half_width, z=z, longest=longest,
            stations=len(x), station=x.ctypes.data, crosses=len(members), cross=members.ctypes.data,
            rail=ctypes.pointer(inner[0]), member=ctypes.pointer(inner[1]),
            member_elements=whole(member_elements, "member_elements", 32))
        with Exclusive(self) as handle:
            check(quick.trk_spec_add_frame(handle, encode(name), ctypes.byref(struct)),
                  handle.context)

    def nearest_body(self, pattern: str, point: Point) -> int:
        """Id of the body nearest to a point [m] of those whose name matches, "frame.*"."""
        out, place = ctypes.c_int32(), vector(point, "point", 3)
        check_plain(quick.trk_spec_nearest_body(self._live(), encode(pattern), place.ctypes,
                                                ctypes.byref(out)), f"{self.name}: {pattern!r}")
        return out.value

    def add_port(self, name: str, body: Reference, point: Point = ORIGIN, direction: Point = UP,
                 motion: Motion = Motion.TRANSLATION) -> int:
        """Add a place where a load [N or N m] acts on a body."""
        return self._add_options(quick.trk_spec_add_port, name, Port(
            self.find(Part.BODY, body), motion, _triple(point, "point"),
            _triple(direction, "direction")))

    def add_sensor(self, name: str, quantity: Union[Quantity, str] = Quantity.ACCELERATION, *,
                   body: Reference = 0, link: Reference = 0, point: Point = ORIGIN,
                   direction: Point = UP, motion: Motion = Motion.TRANSLATION) -> int:
        """Record a quantity: "displacement", "velocity" or "acceleration" of a body's point,
        "elongation", "rate" or "force" of a link."""
        return self._add_options(quick.trk_spec_add_sensor, name, Sensor(
            quantity, self.find(Part.BODY, body),  # type: ignore[arg-type]
            self.find(Part.LINK, link), motion, _triple(point, "point"),
            _triple(direction, "direction")))

    # Parts are found, read and changed

    def count(self, part: Part) -> int:
        """Number of parts of a kind."""
        return quick.trk_spec_count(self._live(), part)

    def find(self, part: Part, name: Reference) -> int:
        """Id of a part by its name; an id is returned as it is."""
        if not isinstance(name, str):
            return operator.index(name)
        found = quick.trk_spec_find(self._live(), part, encode(name))
        if not found:
            raise UnknownNameError(f"{self.name}: there is no {part.name.lower()} '{name}'; there "
                                   f"are {', '.join(self.names(part)) or 'none'}")
        return found

    def names(self, part: Part) -> list[str]:
        """Names of all parts of a kind, in order of their ids."""
        handle = self._live()
        return [text(quick.trk_spec_part_name(handle, part, number))
                for number in range(1, self.count(part) + 1)]

    def _get(self, kind: type[F], function: Any, part: Part, reference: Reference) -> F:
        number, struct = self.find(part, reference), kind._sized()
        status = function(self._live(), number, ctypes.byref(struct))
        check_plain(status, f"{self.name}: {part.name.lower()} {reference!r}")
        return kind._from_struct(struct)

    def body(self, body: Reference) -> Body:
        return self._get(Body, quick.trk_spec_get_body, Part.BODY, body)

    def link(self, link: Reference) -> Link:
        return self._get(Link, quick.trk_spec_get_link, Part.LINK, link)

    def beam(self, beam: Reference) -> Beam:
        return self._get(Beam, quick.trk_spec_get_beam, Part.BEAM, beam)

    def sensor(self, sensor: Reference) -> Sensor:
        return self._get(Sensor, quick.trk_spec_get_sensor, Part.SENSOR, sensor)

    def port(self, port: Reference) -> Port:
        return self._get(Port, quick.trk_spec_get_port, Part.PORT, port)

    def road(self, road: Reference) -> Road:
        x, y = ctypes.c_double(), ctypes.c_double()
        number = self.find(Part.ROAD, road)
        check_plain(quick.trk_spec_get_road(self._live(), number, ctypes.byref(x),
                                            ctypes.byref(y)), f"{self.name}: road {road!r}")
        return Road(x.value, y.value)

    def mass(self, mass: Reference) -> PointMass:
        body, value, point = ctypes.c_int32(), ctypes.c_double(), np.empty(3)
        number = self.find(Part.MASS, mass)
        check_plain(quick.trk_spec_get_mass(self._live(), number, ctypes.byref(body),
                                            ctypes.byref(value), point.ctypes),
                    f"{self.name}: mass {mass!r}")
        return PointMass(body.value, value.value, _triple(point, "point"))

    def update_body(self, body: Reference, **changes: Any) -> None:
        """Change fields of a body: update_body("cab", mass=1300)."""
        self._set(quick.trk_spec_set_body, Part.BODY, body, self.body(body).replace(**changes))

    def update_link(self, link: Reference, **changes: Any) -> None:
        """Change fields of a link: update_link("front_tire", stiffness=9e5)."""
        self._set(quick.trk_spec_set_link, Part.LINK, link, self.link(link).replace(**changes))

    def update_beam(self, beam: Reference, **changes: Any) -> None:
        """Change fields of a beam: update_beam("frame.left.1", bending_y=1e6)."""
        self._set(quick.trk_spec_set_beam, Part.BEAM, beam, self.beam(beam).replace(**changes))

    def _set(self, function: Any, part: Part, reference: Reference, given: Fields) -> None:
        number, struct = self.find(part, reference), given._to_struct()
        with Exclusive(self) as handle:
            check(function(handle, number, ctypes.byref(struct)), handle.context)

    def vary(self, pattern: str, field: Union[Field, str], value: float,
             meaning: Union[Meaning, str] = Meaning.FACTOR) -> int:
        """Multiply a field of all parts whose name matches, or with meaning "value" replace it:
        vary("front_*_tire", "stiffness", 1.1). Returns how many matched.

        field: "stiffness", "damping" or, of their laws, "friction" or "approach" of links;
            "mass", "inertia" or "mass_inertia" of bodies; "bending" of beams
        """
        out, kind, means = ctypes.c_int32(), member(Field, field), member(Meaning, meaning)
        with Exclusive(self) as handle:
            check(quick.trk_spec_vary(handle, kind, encode(pattern), means, value,
                                      ctypes.byref(out)), handle.context)
        return out.value

    def compile(self, gravity: float = 0.0, allow_free: bool = False) -> Model:
        """Equations of motion; gravity [m/s^2] > 0 measures from the drawn position."""
        from .model import Model
        return Model(self, gravity, allow_free)

    def plot(self, **options: Any) -> Axes:
        """Side view; options as truckride.plot.side_view()."""
        from . import plot
        return plot.side_view(self.describe(), **options)

    # As a file

    @classmethod
    def read(cls, path: Union[str, os.PathLike[str]]) -> Spec:
        """Read a model file: Spec.read("truck.json").compile()."""
        return cls._make(lib.trk_model_file_read, encode_path(path))

    @classmethod
    def from_json(cls, json: str, source: str = "text",
                  folder: Union[str, os.PathLike[str], None] = None) -> Spec:
        """Read the text of a model file.

        source: what messages call it
        folder: where tables that it names are looked for; without one they are refused
        """
        given = json.encode("utf-8")
        return cls._make(lib.trk_model_file_parse, given, len(given), encode(source),
                         None if folder is None else encode_path(folder))

    def to_json(self) -> str:
        """Text of a model file that reads back as this spec, to the bit."""
        length = ctypes.c_size_t()
        with Exclusive(self) as handle:
            lib.trk_model_file_format(handle, 0, None, ctypes.byref(length))
            room = ctypes.create_string_buffer(length.value + 1)
            check_plain(lib.trk_model_file_format(handle, len(room), room, None), "a model file")
        return room.value.decode("utf-8")

    def write(self, path: Union[str, os.PathLike[str]]) -> None:
        """Write a model file, replacing what is there only when all is written."""
        with Exclusive(self) as handle:
            context = scratch()
            check(lib.trk_model_file_write(context, handle, encode_path(path)), context)

    # As plain data

    def describe(self) -> Description:
        """All parts as plain data."""
        def all_of(part: Part, get: Callable[[int], T]) -> dict[str, T]:
            return {name: get(number) for number, name in enumerate(self.names(part), 1)}
        return Description(
            self.name, all_of(Part.BODY, self.body), all_of(Part.MASS, self.mass),
            all_of(Part.ROAD, self.road), all_of(Part.LINK, self.link),
            all_of(Part.PORT, self.port), all_of(Part.SENSOR, self.sensor),
            all_of(Part.BEAM, self.beam))

    @classmethod
    def from_description(cls, description: Description) -> Spec:
        """The inverse of describe()."""
        spec = cls(description.name)
        for name, body in description.bodies.items():
            spec._add_options(quick.trk_spec_add_body, name, body)
        for name, mass in description.masses.items():
            spec.add_mass(name, mass.body, mass.mass, mass.point)
        for name, road in description.roads.items():
            spec.add_road(name, road.x, road.y)
        for name, link in description.links.items():
            spec._add_options(quick.trk_spec_add_link, name, link)
        for name, port in description.ports.items():
            spec._add_options(quick.trk_spec_add_port, name, port)
        for name, sensor in description.sensors.items():
            spec._add_options(quick.trk_spec_add_sensor, name, sensor)
        for name, beam in description.beams.items():
            spec._add_options(quick.trk_spec_add_beam, name, beam)
        return spec

    def __reduce__(self) -> tuple[Any, ...]:
        return Spec.from_description, (self.describe(),)

    def __repr__(self) -> str:
        if self.closed:
            return "<Spec, closed>"
        counts = ", ".join(f"{self.count(part)} {word}" for part, word in (
            (Part.BODY, "bodies"), (Part.LINK, "links"), (Part.BEAM, "beams"),
            (Part.SENSOR, "sensors")) if part != Part.BEAM or self.count(part))
        return f"<Spec '{self.name}': {counts}>"
