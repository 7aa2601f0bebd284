# SPDX-License-Identifier: MIT
"""Measured data in: CSV, ERD and MTS RPC III, from a path or from bytes.

Results go out by Series.write_csv(), write_rpc() and write_mat(); OpenCRG is in crg.py.
"""
from __future__ import annotations

import ctypes
import os
from typing import Any, Optional, Union

from ._library import lib, quick
from ._native import create, encode, encode_path, whole
from ._options import CsvOptions
from ._struct import options
from .errors import ArgumentError
from .series import Series
from .signal import Signal

Source = Union[str, os.PathLike[str], bytes, bytearray, memoryview]


def kept(source: Source) -> Union[str, bytes]:
    """The source as long as it is needed again: bytes, or a path whatever folder is current."""
    if isinstance(source, (bytes, bytearray, memoryview)):
        return bytes(source)
    return os.path.abspath(os.fsdecode(source))


def load(destroy: Any, read: Any, parse: Any, source: Source, name: str, *arguments: Any) -> Any:
    """Handle of what a reader makes of a path, or its twin of bytes with a name for messages."""
    if isinstance(source, (bytes, bytearray, memoryview)):
        data = bytes(source)
        return create(destroy, parse, encode(name), data, len(data), *arguments)
    return create(destroy, read, encode_path(source), *arguments)


def _csv_options(settings: Optional[CsvOptions], changes: dict[str, Any]) -> CsvOptions:
    separator = changes.get("separator")
    if isinstance(separator, str):
        if len(separator) != 1:
            raise ArgumentError(f"separator: one character is expected, not {separator!r}")
        changes["separator"] = ord(separator)
    return options(CsvOptions, settings, changes)


def read_csv(source: Source, settings: Optional[CsvOptions] = None, *, name: str = "bytes",
             **changes: Any) -> Series:
    """A table as a series: the first column is the axis, time [s] or distance [m], evenly spaced;
    the others are channels in their units, see Series.to_si().

    Args:
        source: path of a file, or its bytes
        name: stands in messages for the path of bytes
        changes: fields of CsvOptions: separator (one character: semicolon, comma, tab or blank;
            found by default), decimal_comma, spacing_tolerance [-]
    """
    chosen = _csv_options(settings, changes)
    return Series._of(load(quick.trk_series_destroy, lib.trk_series_read_csv,
                           lib.trk_series_parse_csv, source, name,
                           ctypes.byref(chosen._to_struct())))


def read_csv_signal(source: Source, column: int = 1, settings: Optional[CsvOptions] = None, *,
                    name: str = "bytes", **changes: Any) -> Signal:
    """A column of a table, from 1 behind the axis, as a signal in SI units over time [s] or
    distance [m], which need not be evenly spaced: Signal.points(). Other arguments as read_csv().

    A pickled signal holds the bytes; of a path it holds the path, which is read again.
    """
    chosen, number = _csv_options(settings, changes), whole(column, "column", 32)
    handle = load(quick.trk_signal_destroy, lib.trk_signal_read_csv, lib.trk_signal_parse_csv,
                  source, name, ctypes.byref(chosen._to_struct()), number)
    return Signal._of(handle, ("_csv", (kept(source), number, chosen, name)))


def read_erd(source: Source, *, name: str = "bytes") -> Series:
    """Road profiles [m] over distance [m] of an ERD file (UMTRI, ProVAL), given by its path or
    its bytes, with a name for messages."""
    return Series._of(load(quick.trk_series_destroy, lib.trk_series_read_erd,
                           lib.trk_series_parse_erd, source, name))


def read_rpc(source: Source, *, name: str = "bytes") -> Series:
    """Channels of an MTS RPC III time history over time [s], given by its path or its bytes, with
    a name for messages. They keep their units, see Series.to_si()."""
    return Series._of(load(quick.trk_series_destroy, lib.trk_series_read_rpc,
                           lib.trk_series_parse_rpc, source, name))
