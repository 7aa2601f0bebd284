# SPDX-License-Identifier: MIT
"""Life of native objects: contexts, handles, status codes, arrays.

Every native object has a context of its own, so that objects know nothing of each other's
threads. A Handle owns both; it is destroyed when the last Python object, view or running call
that needs it lets go. close() therefore never pulls memory away from anybody.
"""
from __future__ import annotations

import ctypes
import logging
import operator
import os
import threading
import weakref
from typing import Any, Callable, Optional, Sequence, TypeVar, Union

import numpy as np
import numpy.typing as npt

from . import _abi
from ._library import lib, quick
from .errors import ArgumentError, BusyError, ClosedError, UnknownNameError, error_of

Array = npt.NDArray[np.float64]
ComplexArray = npt.NDArray[np.complex128]
Self = TypeVar("Self", bound="Native")

logger = logging.getLogger("truckride")
NO_PROGRESS = _abi.trk_progress()


def _log(user: Optional[int], message: bytes) -> None:
    logger.warning("%s", text(message))


_forward_log = _abi.trk_log(_log)  # for all contexts, as long as the process


def text(value: Optional[bytes]) -> str:
    return value.decode("utf-8", "replace") if value else ""


def new_context() -> int:
    out = ctypes.c_void_p()
    status = quick.trk_context_create(_abi.trk_allocate(), None, ctypes.byref(out))
    if status:
        raise error_of(status, text(quick.trk_status_text(status)))
    quick.trk_context_set_log(out, _forward_log, None)
    assert out.value is not None
    return out.value


class _Scratch(threading.local):
    """A context for each thread, for functions that leave no object behind."""

    def __init__(self) -> None:
        self.context = new_context()
        finalizer = weakref.finalize(self._owner(), quick.trk_context_destroy, self.context)
        finalizer.atexit = False

    def _owner(self) -> Any:
        self.owner = _Owner()  # dies with the thread
        return self.owner


class _Owner:
    pass


_scratch = _Scratch()


def scratch() -> int:
    return _scratch.context


def check(status: int, context: Optional[int]) -> None:
    """Raise the exception of a status with the message kept in a context."""
    if status:
        raise error_of(status, text(quick.trk_context_message(context))
                       or text(quick.trk_status_text(status)))


def check_plain(status: int, what: str) -> None:
    """For functions on const objects, which keep no message."""
    if status:
        raise error_of(status, f"{what}: {text(quick.trk_status_text(status))}")


def _destroy(destroy: Callable[[int], None], pointer: int, context: Optional[int]) -> None:
    destroy(pointer)
    if context is not None:
        quick.trk_context_destroy(context)


class Handle:
    """A native object and its context. ctypes takes it as an argument and keeps it alive."""

    __slots__ = ("_as_parameter_", "context", "keep", "__weakref__")

    def __init__(self, destroy: Callable[[int], None], pointer: int, context: Optional[int],
                 keep: tuple[Any, ...]) -> None:
        self._as_parameter_ = ctypes.c_void_p(pointer)
        self.context = context
        self.keep = keep  # what the native object borrows
        # At exit memory goes with the process; threads may still be inside the library.
        weakref.finalize(self, _destroy, destroy, pointer, context).atexit = False


def create(destroy: Callable[[int], None], function: Callable[..., int], *arguments: Any,
           keep: tuple[Any, ...] = ()) -> Handle:
    """Call function(context, *arguments, out) in a new context."""
    context = new_context()
    out = ctypes.c_void_p()
    try:
        check(function(context, *arguments, ctypes.byref(out)), context)
        assert out.value is not None
        return Handle(destroy, out.value, context, keep)
    except BaseException:
        quick.trk_context_destroy(context)
        raise


class Native:
    """Base of all classes with a native object: a context manager that can be closed."""

    _handle: Optional[Handle] = None
    _busy = False

    @classmethod
    def _expect(cls: type[Self], value: Any) -> Self:
        """The value if it is of this class: to the library one address is like another."""
        if not isinstance(value, cls):
            raise TypeError(f"an object of the class {cls.__name__} is expected, not {value!r}")
        return value

    def close(self) -> None:
        """Let go of the native object; it is freed when nothing else needs it any more.

        Further calls raise ClosedError. Arrays and objects obtained from it stay valid.
        """
        if self._busy:
            raise BusyError(f"{type(self).__name__} cannot be closed while it is in use")
        self._handle = None

    @property
    def closed(self) -> bool:
        return self._handle is None

    @property
    def memory_blocks(self) -> int:
        """Blocks of native memory that it holds."""
        return quick.trk_context_blocks(self._live().context)

    def __reduce__(self) -> Union[str, tuple[Any, ...]]:
        raise TypeError(f"a {type(self).__name__} can be neither copied nor pickled")

    def __enter__(self: Self) -> Self:
        self._live()
        return self

    def __exit__(self, *exception: object) -> None:
        self.close()

    def _live(self) -> Handle:
        handle = self._handle
        if handle is None:
            raise ClosedError(f"this {type(self).__name__} is closed")
        if self._busy:
            raise BusyError(f"this {type(self).__name__} is in use by another thread or by the "
                            "call whose callback this is; give each thread its own")
        return handle

    def _check(self, status: int) -> None:
        if status:
            check(status, self._live().context)


_claim = threading.RLock()  # a signal handler may come in while it is held


class Exclusive:
    """with Exclusive(object) as handle: nobody else may use the object meanwhile."""

    def __init__(self, owner: Native) -> None:
        self.owner = owner

    def __enter__(self) -> Handle:
        with _claim:
            handle = self.owner._live()
            self.owner._busy = True
        return handle

    def __exit__(self, *exception: object) -> None:
        self.owner._busy = False


def vector(values: Any, name: str, length: Optional[int] = None) -> Array:
    """One-dimensional contiguous doubles; a view where values are that already."""
    if np.iscomplexobj(values):
        raise ArgumentError(f"{name}: real values are expected, not complex ones")
    array = np.ascontiguousarray(values, dtype=np.float64)
    if array.ndim != 1:
        raise ArgumentError(f"{name}: one dimension is expected, not the shape {array.shape}")
    if length is not None and len(array) != length:
        raise ArgumentError(f"{name}: {length} values are expected, not {len(array)}")
    return array


def optional(values: Any, name: str, length: int) -> Any:
    """Argument for an array that may be absent: keeps the array alive during the call."""
    return None if values is None else vector(values, name, length).ctypes


def borrow(pointer: Optional[int], length: int, owner: Handle, writable: bool = False) -> Array:
    """NumPy view of library memory; the view keeps the owner alive."""
    if not pointer:
        raise ArgumentError("there is no such array")
    memory = (ctypes.c_double * length).from_address(pointer)
    memory._owner = owner  # type: ignore[attr-defined]
    array: Array = np.frombuffer(memoryview(memory), dtype=np.float64)
    array.flags.writeable = writable
    return array


def whole(value: Any, name: str, bits: int = 64) -> int:
    """An integer that fits; ctypes would take it modulo 2^bits."""
    number = operator.index(value)
    if not -(1 << (bits - 1)) <= number < 1 << (bits - 1):
        raise ArgumentError(f"{name}: {number} is no integer of {bits} bits")
    return number


def position(names: Sequence[str], name: str, what: str) -> int:
    """Place of a name among others, from 0."""
    if name not in names:
        raise UnknownNameError(f"there is no {what} {name!r}; there are "
                               f"{', '.join(names) or 'none'}")
    return names.index(name)


def encode_path(path: Union[str, os.PathLike[str]]) -> bytes:
    encoded = os.fsencode(path)
    if b"\0" in encoded:
        raise ArgumentError(f"{path!r}: a path cannot contain a NUL character")
    return encoded


def encode(name: str) -> bytes:
    if not isinstance(name, str):
        raise TypeError(f"a name is expected, not {name!r}")
    if "\0" in name:
        raise ArgumentError(f"{name!r}: a name cannot contain a NUL character")
    return name.encode("utf-8")
