# SPDX-License-Identifier: MIT
"""Exceptions: one class a status of the library, all of them TruckrideError."""
from __future__ import annotations

from ._abi import Status


class TruckrideError(Exception):
    """A call of the library failed.

    Attributes:
        status: the library's status, truckride.Status
        message: sentence saying where, what, which value, what was expected
    """

    status: Status = Status.INTERNAL

    @property
    def message(self) -> str:
        return str(self.args[0]) if self.args else ""


class LibraryError(ImportError):
    """libtruckride was not found, or does not fit this package."""


class ClosedError(TruckrideError, ValueError):
    """The object was closed before."""

    status = Status.ARGUMENT


class BusyError(TruckrideError, RuntimeError):
    """Another thread, or a callback of the running call, uses the object just now."""

    status = Status.ARGUMENT


class ArgumentError(TruckrideError, ValueError):
    """An argument is invalid."""

    status = Status.ARGUMENT


class OutOfMemoryError(TruckrideError, MemoryError):
    """No memory."""

    status = Status.MEMORY


class OptionsError(TruckrideError):
    """An options struct has a size or field the library does not know."""

    status = Status.OPTIONS


class RangeError(TruckrideError, ValueError):
    """A value is out of range."""

    status = Status.RANGE


class UnknownNameError(TruckrideError, LookupError):
    """A name is empty, unknown or already used."""

    status = Status.NAME


class UnsupportedError(TruckrideError, NotImplementedError):
    """This build of the library lacks a feature."""

    status = Status.UNSUPPORTED


class CancelledError(TruckrideError):
    """The progress callback cancelled the work."""

    status = Status.CANCELLED


class FileError(TruckrideError, OSError):
    """A file cannot be read or written."""

    status = Status.FILE

    def __str__(self) -> str:
        return self.message


class InputError(TruckrideError, ValueError):
    """Input text is malformed."""

    status = Status.SYNTAX


class ModelError(TruckrideError, ValueError):
    """A vehicle is incomplete or inconsistent."""

    status = Status.MODEL


class SingularError(TruckrideError, ArithmeticError):
    """A matrix is not positive definite."""

    status = Status.SINGULAR


class ConvergenceError(TruckrideError, ArithmeticError):
    """An iteration did not converge."""

    status = Status.CONVERGENCE


class LimitError(TruckrideError):
    """A limit of evaluations or time came before the answer."""

    status = Status.LIMIT


class TargetError(TruckrideError):
    """A calibration target cannot be reached."""

    status = Status.TARGET


class IdentifyError(TruckrideError):
    """The targets leave a calibration parameter undetermined."""

    status = Status.IDENTIFY


class InternalError(TruckrideError):
    """A numerical library failed unexpectedly."""

    status = Status.INTERNAL


BY_STATUS: dict[int, type[TruckrideError]] = {
    kind.status: kind
    for kind in TruckrideError.__subclasses__() if kind not in (ClosedError, BusyError)
}


def error_of(status: int, message: str) -> TruckrideError:
    """The exception of a status; also of one that this package does not know yet."""
    return BY_STATUS.get(status, TruckrideError)(message)
