# SPDX-License-Identifier: MIT
"""At import: the library's defaults lie where this package thinks they do."""
from __future__ import annotations

import ctypes
import dataclasses

from . import _library
from ._struct import Fields
from .errors import LibraryError


def check_defaults() -> None:
    for kind in Fields.__subclasses__():
        init = getattr(_library.quick, f"{kind._struct_.__name__}_init", None)
        if init is None:
            continue  # a result
        struct = kind._sized()
        init(ctypes.byref(struct), ctypes.sizeof(struct))
        found, expected = kind._from_struct(struct), kind()
        for field in dataclasses.fields(kind):
            ours, theirs = getattr(expected, field.name), getattr(found, field.name)
            if ours != theirs:
                raise LibraryError(
                    f"{_library.path}: {kind._struct_.__name__}.{field.name} is {theirs} by "
                    f"default, this package expects {ours}: they are not of one release")
