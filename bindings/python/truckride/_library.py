# SPDX-License-Identifier: MIT
"""Find libtruckride, check that it fits this package, declare its functions."""
from __future__ import annotations

import ctypes
import ctypes.util
import importlib.resources
import operator
import os
from typing import Any, Callable, cast

from . import _abi
from .errors import ArgumentError, LibraryError

SONAME = "libtruckride.so.0"
VARIABLE = "TRUCKRIDE_LIBRARY"


def candidates() -> list[tuple[str, str]]:
    """(where it comes from, what to load), best first. A variable that is set is the only one."""
    chosen = os.environ.get(VARIABLE)
    if chosen:
        return [(f"environment variable {VARIABLE}", chosen)]
    bundled = str(importlib.resources.files(__package__) / SONAME)
    # Asking for a path that is not there would end in the search path of the system.
    found = [("inside the package", bundled)] if os.path.exists(bundled) else []
    found.append(("the system's search path", SONAME))
    located = ctypes.util.find_library("truckride")
    if located and located != SONAME:
        found.append(("ctypes.util.find_library", located))
    return found


def load() -> tuple[str, ctypes.CDLL]:
    tried = []
    for origin, path in candidates():
        try:
            return path, ctypes.CDLL(path)
        except OSError as error:
            tried.append(f"  {origin}: {path}: {error}")
    if not os.environ.get(VARIABLE):
        tried.insert(0, f"  environment variable {VARIABLE}: not set")
        if not any("inside the package" in line for line in tried):
            tried.insert(1, f"  inside the package: no {SONAME} beside {__file__}")
    raise LibraryError(f"libtruckride was not found. Tried:\n" + "\n".join(tried) + "\n"
                       f"Install it, or set {VARIABLE} to the path of {SONAME}.")


class Int32:
    """Argument type: ctypes.c_int32 would take a number modulo 2^32."""

    kind: Any = ctypes.c_int32
    bits = 32

    @classmethod
    def from_param(cls, value: Any) -> Any:
        number = operator.index(value)
        if not -(1 << (cls.bits - 1)) <= number < 1 << (cls.bits - 1):
            raise ValueError(f"{number} is no integer of {cls.bits} bits")
        return cls.kind(number)


class Int64(Int32):
    kind = ctypes.c_int64
    bits = 64


CHECKED: dict[Any, Any] = {ctypes.c_int32: Int32, ctypes.c_int64: Int64}


def explained(name: str, function: Any) -> Callable[..., Any]:
    """The function with an exception of this package for a number that is none."""
    def call(*arguments: Any) -> Any:
        try:
            return function(*arguments)
        except ctypes.ArgumentError as error:
            raise ArgumentError(f"{name}, {error}") from None
    call.__name__ = name
    return call


def declare(library: Any) -> None:
    """Set argument and result types; every function must be there. Those without numbers, the
    step among them, are called directly."""
    missing = []
    for name, (result, arguments) in _abi.SIGNATURES.items():
        try:
            function = getattr(library, name)
        except AttributeError:
            missing.append(name)
            continue
        function.restype = result
        function.argtypes = [CHECKED.get(kind, kind) for kind in arguments]
        if any(kind in CHECKED or kind is ctypes.c_double for kind in arguments):
            setattr(library, name, explained(name, function))
    if missing:
        raise LibraryError(f"{library._name} lacks {', '.join(missing)}: it is older than this "
                           f"package ({version_text(_abi.VERSION)})")


def version_text(version: tuple[int, ...]) -> str:
    return ".".join(str(number) for number in version)


def check_version(library: Any) -> None:
    """Before anything else: same major and minor version, not an older patch."""
    try:
        library.trk_version.restype = ctypes.c_int32
        number = library.trk_version()
    except AttributeError:
        raise LibraryError(f"{library._name} is not libtruckride: it has no trk_version") from None
    version = (number // 10000, number // 100 % 100, number % 100)
    if version[:2] != _abi.VERSION[:2] or version < _abi.VERSION:
        raise LibraryError(f"{library._name} has version {version_text(version)}, this package "
                           f"needs {version_text(_abi.VERSION[:2])}, from "
                           f"{version_text(_abi.VERSION)} on")


def check_struct(library: Any, kind: type[ctypes.Structure]) -> None:
    """The library fills as many bytes as we think and none behind them."""
    init = getattr(library, f"{kind.__name__}_init")
    size = ctypes.sizeof(kind)
    guard = 64
    memory = (ctypes.c_ubyte * (size + guard))(*([0xA5] * (size + guard)))
    init(ctypes.cast(memory, ctypes.POINTER(kind)), size)
    told = kind.from_buffer(memory).struct_size
    if told != size or any(byte != 0xA5 for byte in memory[size:]):
        raise LibraryError(f"{library._name}: {kind.__name__}_init does not take the {size} bytes "
                           "that this package gives it")


def check_structs(library: Any) -> None:
    for kind in vars(_abi).values():
        if isinstance(kind, type) and issubclass(kind, ctypes.Structure) \
                and f"{kind.__name__}_init" in _abi.SIGNATURES:
            check_struct(library, kind)


class Holding(_abi.Functions):
    """The same functions called without releasing the GIL, for calls of a microsecond."""

    def __init__(self, path: str) -> None:
        library = ctypes.PyDLL(path)
        declare(library)
        for name in _abi.SIGNATURES:
            setattr(self, name, getattr(library, name))


def open_library() -> tuple[str, _abi.Functions]:
    path, library = load()
    check_version(library)
    declare(library)
    check_structs(library)
    return path, cast(_abi.Functions, library)


path, lib = open_library()  # releases the GIL during each call
quick = Holding(path)
