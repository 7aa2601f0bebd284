#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Curves against SciPy on random tables: curve_scipy.py path/to/libtruckride.so

Exit status 0 if all agree to 1e-12 relative, 1 if not, 77 (skip) without SciPy.
"""
import ctypes
import sys

try:
    import numpy as np
    from scipy.interpolate import Akima1DInterpolator, CubicSpline, PchipInterpolator
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

TOLERANCE = 1e-12
KINDS = {  # trk_interpolation
    "pchip": (0, PchipInterpolator),
    "not-a-knot": (1, lambda x, y: CubicSpline(x, y, bc_type="not-a-knot")),
    "natural": (2, lambda x, y: CubicSpline(x, y, bc_type="natural")),
    "akima": (3, Akima1DInterpolator),
}


class Options(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_size_t), ("interpolation", ctypes.c_int32),
                ("extrapolation", ctypes.c_int32)]


def load(path):
    lib = ctypes.CDLL(path)
    p, d = ctypes.c_void_p, np.ctypeslib.ndpointer(np.float64, flags="C")
    lib.trk_context_create.argtypes = [p, p, p]
    lib.trk_context_destroy.argtypes = [p]
    lib.trk_curve_create.argtypes = [p, ctypes.c_char_p, ctypes.c_int64, d, d, p, p]
    lib.trk_curve_evaluate.argtypes = [p, ctypes.c_int64, d, d, d]
    lib.trk_curve_destroy.argtypes = [p]
    return lib


def evaluate(lib, context, kind, x, y, places):
    options = Options(ctypes.sizeof(Options), kind, 0)
    curve = ctypes.c_void_p()
    status = lib.trk_curve_create(context, b"random", len(x), x, y, ctypes.byref(options),
                                  ctypes.byref(curve))
    assert status == 0, status
    value, slope = np.empty_like(places), np.empty_like(places)
    lib.trk_curve_evaluate(curve, len(places), places, value, slope)
    lib.trk_curve_destroy(curve)
    return value, slope


def tables(random):
    """Smooth, rough, partly level and unevenly spaced tables, two to forty points."""
    for n in list(range(2, 9)) * 20 + [15, 40] * 20:
        x = np.cumsum(10.0 ** random.uniform(-1, 0.5, n)) - 3.0
        y = random.normal(size=n) * 10.0 ** random.integers(-3, 5)
        if random.random() < 0.5:
            y = np.cumsum(np.abs(y))
        if random.random() < 0.3:
            y[random.integers(0, n):] = y[0]
        yield x, y


def main():
    lib = load(sys.argv[1])
    context = ctypes.c_void_p()
    assert lib.trk_context_create(None, None, ctypes.byref(context)) == 0
    random = np.random.default_rng(20240229)
    worst = dict.fromkeys(KINDS, 0.0)
    for x, y in tables(random):
        places = np.concatenate([x[:-1], random.uniform(x[0], x[-1], 50)])
        for name, (kind, reference) in KINDS.items():
            if len(x) == 2 and name == "akima":
                continue  # SciPy's cannot; the straight line is tested in C
            spline = reference(x, y)
            value, slope = evaluate(lib, context, kind, x, y, places)
            for got, wanted in ((value, spline(places)), (slope, spline(places, 1))):
                scale = np.abs(wanted).max() or 1.0
                worst[name] = max(worst[name], np.abs(got - wanted).max() / scale)
    lib.trk_context_destroy(context)
    for name, error in worst.items():
        print(f"{name:10s} {error:.1e}")
    return 0 if max(worst.values()) <= TOLERANCE else 1


sys.exit(main())
