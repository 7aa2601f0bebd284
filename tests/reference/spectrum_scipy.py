#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compare spectra with scipy.signal: spectrum_scipy.py path/to/libtruckride.so

Every window, overlap, detrend and scaling at several segment lengths. Prints the largest
relative difference of each kind; exit 1 above 1e-10, 77 (skip) without SciPy.
"""
import ctypes
import sys
import warnings

try:
    import numpy as np
    import scipy.signal as signal
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

TOLERANCE = 1e-10
FLOOR = 1e-8  # values below this part of the maximum are compared with the maximum only
QUOTIENT_FLOOR = 1e-2
CROSS_FLOOR = 1e-6  # of cross spectra: below, SciPy's own rounding, which depends on the BLAS
                    # behind its detrend, comes near the tolerance
RATE = 250.0
KAISER_BETA = 8.6
WINDOWS = ["hann", "boxcar", "hamming", "blackman", "blackmanharris", "flattop",
           ("kaiser", KAISER_BETA)]  # in the order of trk_window
DETRENDS = ["constant", False, "linear"]  # of trk_detrend
SCALINGS = ["density", "spectrum"]  # of trk_scaling
OVERLAPS = [0.0, 0.25, 0.5, 0.75]
SEGMENTS = [1, 2, 3, 15, 64, 97, 100, 101, 211, 256, 331, 674, 1000, 1024,
            3001]  # primes, 2 * 337, one segment of everything


class SpectrumOptions(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_size_t), ("segment_length", ctypes.c_int64),
                ("overlap", ctypes.c_double), ("window", ctypes.c_int32),
                ("detrend", ctypes.c_int32), ("scaling", ctypes.c_int32),
                ("reserved", ctypes.c_int32), ("kaiser_beta", ctypes.c_double)]


class PeakOptions(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_size_t), ("minimum_height", ctypes.c_double),
                ("minimum_prominence", ctypes.c_double), ("minimum_distance", ctypes.c_double),
                ("order", ctypes.c_int32), ("reserved", ctypes.c_int32)]


class Library:
    def __init__(self, path):
        self.lib = ctypes.CDLL(path)
        self.lib.trk_context_message.restype = ctypes.c_char_p
        self.lib.trk_psd_length.restype = ctypes.c_int64
        self.context = ctypes.c_void_p()
        self.check(self.lib.trk_context_create(None, None, ctypes.byref(self.context)))

    def check(self, status):
        if status:
            sys.exit(self.lib.trk_context_message(self.context).decode())

    def call(self, name, x, y, rate, options, parts):
        """A spectrum of x (and y); real for one part, complex for two."""
        length = self.lib.trk_psd_length(ctypes.byref(options), ctypes.c_int64(len(x)))
        out = np.empty(length * parts)
        arrays = [pointer(x)] + ([pointer(y)] if y is not None else [])
        rates = [ctypes.c_double(rate)] if rate else []
        self.check(getattr(self.lib, name)(self.context, ctypes.c_int64(len(x)), *arrays, *rates,
                                           ctypes.byref(options), pointer(out)))
        return out.view(complex) if parts == 2 else out

    def peaks(self, density, step, **fields):
        options = PeakOptions()
        self.lib.trk_peak_options_init(ctypes.byref(options),
                                       ctypes.c_size_t(ctypes.sizeof(options)))
        for field, value in fields.items():
            setattr(options, field, value)
        height, prominence = np.empty(len(density)), np.empty(len(density))
        count = ctypes.c_int64()
        self.check(self.lib.trk_psd_peaks(
            self.context, ctypes.c_int64(len(density)), pointer(density), ctypes.c_double(step),
            ctypes.byref(options), ctypes.c_int64(len(density)), None, pointer(height),
            pointer(prominence), ctypes.byref(count)))
        return height[:count.value], prominence[:count.value]


def pointer(array):
    return array.ctypes.data_as(ctypes.POINTER(ctypes.c_double))


def difference(ours, theirs, floor):
    """Largest difference over the maximum, and over each value above the floor."""
    defined = np.isfinite(theirs)
    if not np.array_equal(defined, np.isfinite(ours)):
        return np.inf
    ours, theirs = ours[defined], theirs[defined]
    if not len(theirs) or not np.abs(theirs).max():
        return float(np.abs(ours).max(initial=0))
    size, maximum = np.abs(theirs), np.abs(theirs).max()
    large = size > floor * maximum
    error = np.abs(ours - theirs)
    return max(error.max() / maximum, (error[large] / size[large]).max())


def compare_spectra(library, x, y, worst):
    def note(kind, ours, theirs, floor=FLOOR):
        # Segments of one or two samples less their trend leave nothing but rounding.
        nothing = np.abs(theirs).max(initial=0) < 1e-24
        both = nothing and np.abs(ours).max(initial=0) < 1e-24
        worst[kind] = max(worst.get(kind, 0.0), 0.0 if both else difference(ours, theirs, floor))

    for segment in SEGMENTS:
        for window, name in enumerate(WINDOWS):
            for overlap in OVERLAPS:
                for detrend, trend in enumerate(DETRENDS):
                    o = SpectrumOptions(ctypes.sizeof(SpectrumOptions), segment, overlap, window,
                                        detrend, 0, 0, KAISER_BETA)
                    same = dict(window=name, nperseg=segment, noverlap=int(overlap * segment),
                                detrend=trend)
                    xx = signal.welch(x, RATE, **same)[1]
                    yy = signal.welch(y, RATE, **same)[1]
                    xy = signal.csd(x, y, RATE, **same)[1]
                    note("psd", library.call("trk_psd", x, None, RATE, o, 1), xx)
                    note("csd", library.call("trk_csd", x, y, RATE, o, 2), xy, CROSS_FLOOR)
                    # Quotients of little power show nothing but rounding.
                    some = (xx > CROSS_FLOOR * xx.max()) & (yy > CROSS_FLOOR * yy.max())
                    if xx.max() > 1e-20 and yy.max() > 1e-20:
                        theirs = signal.coherence(x, y, RATE, **same)[1]
                        note("coherence", library.call("trk_coherence", x, y, None, o, 1)[some],
                             theirs[some], QUOTIENT_FLOOR)
                        note("frf_h1", library.call("trk_frf_h1", x, y, None, o, 2)[some],
                             xy[some] / xx[some], QUOTIENT_FLOOR)
                    o.scaling = 1
                    note("psd spectrum", library.call("trk_psd", x, None, RATE, o, 1),
                         signal.welch(x, RATE, scaling="spectrum", **same)[1])
                    note("csd spectrum", library.call("trk_csd", x, y, RATE, o, 2),
                         signal.csd(x, y, RATE, scaling="spectrum", **same)[1], CROSS_FLOOR)


def compare_peaks(library, random, worst):
    for length in [1, 2, 3, 50, 1000]:
        for repeat in range(20):
            density = random.random(length) ** 2
            if repeat % 2:
                density = np.ceil(density * 8) / 8  # plateaus and ties
            for height, prominence, bins in [(0, 0, 0), (0.3, 0, 0), (0, 0.2, 0), (0.1, 0.1, 2.5),
                                             (0, 0, 7)]:
                if repeat % 2 and bins:
                    continue  # which of equally high neighbours stays differs by intent
                found, properties = signal.find_peaks(density, height=height,
                                                      prominence=prominence, distance=bins or None)
                ours = library.peaks(density, 0.1, minimum_height=height, order=1,
                                     minimum_prominence=prominence, minimum_distance=bins * 0.1)
                theirs = density[found], properties["prominences"]
                for kind, a, b in zip(["peak height", "peak prominence"], ours, theirs):
                    error = np.abs(a - b).max(initial=0) if len(a) == len(b) else np.inf
                    worst[kind] = max(worst.get(kind, 0.0), error)


def main(path):
    warnings.simplefilter("ignore")
    np.seterr(all="ignore")
    library = Library(path)
    random = np.random.default_rng(1)
    t = np.arange(3001) / RATE
    x = 0.3 + 0.2 * t + np.sin(2 * np.pi * 13.8 * t) + 0.3 * random.standard_normal(len(t))
    y = signal.lfilter([0.2, 0.1], [1, -1.6, 0.8], x) + 0.1 * random.standard_normal(len(t))
    worst = {}
    compare_spectra(library, x, y, worst)
    compare_peaks(library, random, worst)
    for kind, value in worst.items():
        print(f"{kind:16s} max relative difference {value:.2e}")
    return int(max(worst.values()) > TOLERANCE)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
