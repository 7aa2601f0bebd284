# SPDX-License-Identifier: MIT
"""Between dataclasses and the structs of the C interface."""
from __future__ import annotations

import ctypes
import dataclasses
import enum
import re
from typing import Any, ClassVar, TypeVar, Union

from ._native import encode, text, whole
from .errors import ArgumentError

F = TypeVar("F", bound="Fields")
E = TypeVar("E", bound=enum.IntEnum)


def member(kind: type[E], value: Union[E, str, int]) -> E:
    """Member of an enum by itself, by number, or by name in any case: "not_a_knot"."""
    if isinstance(value, str):
        try:
            return kind[value.upper().replace("-", "_").replace(" ", "_")]
        except KeyError:
            names = ", ".join(item.name.lower() for item in kind)
            raise ArgumentError(f"{kind.__name__}: {value!r} is none of {names}") from None
    try:
        return kind(value)
    except ValueError:
        raise ArgumentError(f"{kind.__name__}: there is no {value!r}") from None


BITS = {ctypes.c_int32: 32, ctypes.c_int64: 64}


def _fill(struct: Any, name: str, value: Any, annotation: str, keep: list[Any]) -> None:
    """Set one field; what it points to is appended to keep."""
    kind = dict(struct._fields_)[name]
    if issubclass(kind, ctypes.Array):
        items = list(value)
        if len(items) != kind._length_:
            raise ArgumentError(f"{name}: {kind._length_} values are expected, not {len(items)}")
        getattr(struct, name)[:] = [_plain(item, name, kind._type_, annotation, keep)
                                    for item in items]
    else:
        setattr(struct, name, _plain(value, name, kind, annotation, keep))


def _plain(value: Any, name: str, kind: Any, annotation: str, keep: list[Any]) -> Any:
    if kind is ctypes.c_void_p:
        if value is None:
            return None
        keep.append(_class_of(annotation)._expect(value)._live())
        return keep[-1]._as_parameter_.value
    if kind in BITS:
        return whole(value, name, BITS[kind])
    return encode(value) if isinstance(value, str) else value


def _class_of(annotation: str) -> Any:
    """Class of the objects that a field points to, None if it holds no objects."""
    from .curve import Curve
    from .law import Law
    found = re.search(r"Optional\[(Curve|Law)\]", annotation)
    return {"Curve": Curve, "Law": Law}[found[1]] if found else None


def _read(value: Any, annotation: str) -> Any:
    if isinstance(value, ctypes.Array):
        return tuple(_read(item, annotation) for item in value)
    kind = _class_of(annotation)
    if kind:
        return kind._copy_of(value) if value else None
    return text(value) if isinstance(value, bytes) else value


@dataclasses.dataclass(frozen=True)
class Fields:
    """Base of the generated dataclasses."""

    _struct_: ClassVar[Any]

    def __post_init__(self) -> None:
        from . import _abi
        for field in dataclasses.fields(self):
            kind = str(field.type)
            if kind.startswith("_abi.") and kind != "_abi.Free":
                value = member(getattr(_abi, kind[5:]), getattr(self, field.name))
                object.__setattr__(self, field.name, value)

    def replace(self: F, **changes: Any) -> F:
        """A copy with some fields changed."""
        return dataclasses.replace(self, **changes)

    def _to_struct(self) -> Any:
        struct = self._struct_()
        struct.struct_size = ctypes.sizeof(struct)
        keep: list[Any] = []
        for field in dataclasses.fields(self):
            try:
                _fill(struct, field.name, getattr(self, field.name), str(field.type), keep)
            except (TypeError, ctypes.ArgumentError) as error:
                raise ArgumentError(f"{type(self).__name__}.{field.name}: {error}") from None
        struct.keep = keep  # as long as the struct
        return struct

    @classmethod
    def _from_struct(cls: type[F], struct: Any) -> F:
        return cls(**{field.name: _read(getattr(struct, field.name), str(field.type))
                      for field in dataclasses.fields(cls)})

    @classmethod
    def _sized(cls) -> Any:
        """An empty struct that knows its size, for the library to fill."""
        struct = cls._struct_()
        struct.struct_size = ctypes.sizeof(struct)
        return struct


def options(kind: type[F], given: Union[F, None], changes: dict[str, Any]) -> F:
    """Options object and keyword arguments in one: the keywords win."""
    if given is not None and not isinstance(given, kind):
        raise TypeError(f"an object of the class {kind.__name__} is expected, not {given!r}")
    try:
        return kind(**changes) if given is None else given.replace(**changes)
    except TypeError as error:
        names = ", ".join(field.name for field in dataclasses.fields(kind))
        raise TypeError(f"{error}; {kind.__name__} has {names}") from None
