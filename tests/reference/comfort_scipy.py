#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compare comfort and roughness with NumPy and SciPy: comfort_scipy.py path/to/libtruckride.so

Weighting filters against the analogue response applied to the spectrum (padded against wrap),
running RMS, dose values, percentiles, IRI of random profiles by scipy.linalg.expm. Exit 1 above the
tolerances, 77 (skip) without SciPy.
"""
import ctypes
import sys

try:
    import numpy as np
    import scipy.linalg
    import scipy.signal as signal
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

double, int64, int32 = ctypes.c_double, ctypes.c_int64, ctypes.c_int32
# f1, f2, f3, f4, Q4, f5, Q5, f6, Q6, K; None for infinity. In the order of trk_weighting.
WEIGHTINGS = [(0.4, 100, 12.5, 12.5, 0.63, 2.37, 0.91, 3.35, 0.91, 1),
              (0.4, 100, 2, 2, 0.63, None, None, None, None, 1),
              (0.4, 100, 8, 8, 0.63, None, None, None, None, 1),
              (0.4, 100, 1, 1, 0.63, None, None, None, None, 1),
              (0.4, 100, None, None, None, 3.75, 0.91, 5.32, 0.91, 1),
              (0.08, 0.63, None, 0.25, 0.86, 0.0625, 0.8, 0.1, 0.8, 1),
              (0.4, 100, 16, 16, 0.55, 2.5, 0.9, 4, 0.95, 1.024)]


class Vibration(ctypes.Structure):
    NAMES = ("duration rms peak crest_factor mtvv mtvv_exponential vdv evdv msdv mtvv_ratio "
             "vdv_ratio").split()
    _fields_ = ([("struct_size", ctypes.c_size_t)] + [(name, double) for name in NAMES]
                + [("additional", int32), ("reserved", int32)])


def pointer(array):
    return array.ctypes.data_as(ctypes.POINTER(double))


def check(name, difference, tolerance):
    print(f"{name}: {difference:.2e} (tolerance {tolerance:.0e})")
    return difference <= tolerance


def polynomials(w):
    """Numerator and denominator in s, highest power first."""
    f1, f2, f3, f4, q4, f5, q5, f6, q6, gain = w

    def quadratic(f, q):
        return np.array([1 / (2 * np.pi * f) ** 2, 1 / (2 * np.pi * f * q), 1])
    half = np.sqrt(0.5)
    numerator = np.array([gain / (2 * np.pi * f1) ** 2, 0, 0])
    denominator = np.polymul(quadratic(f1, half), quadratic(f2, half))
    if f3:
        numerator = np.polymul(numerator, [1 / (2 * np.pi * f3), 1])
    if f4:
        denominator = np.polymul(denominator, quadratic(f4, q4))
    if f5:
        numerator = np.polymul(numerator, quadratic(f5, q5)) * (f5 / f6) ** 2
        denominator = np.polymul(denominator, quadratic(f6, q6))
    return numerator, denominator


def sayers(z, dx):
    k1, k2, c, mu, speed = 653, 63.3, 6, 0.15, 80 / 3.6
    a = np.array([[0, 1, 0, 0], [-k2, -c, k2, c], [0, 0, 0, 1],
                  [k2 / mu, c / mu, -(k1 + k2) / mu, -c / mu]])
    transition = scipy.linalg.expm(a * dx / speed)
    drive = np.linalg.solve(a, (transition - np.eye(4)) @ [0, 0, 0, k1 / mu])
    base = max(int(0.25 / dx + 0.5), 1)
    lead = min(int(11 / dx + 0.5) + 1, len(z))
    start = (z[lead - 1] - z[0]) / (lead * dx)
    x, total = np.array([start, 0, start, 0]), 0
    for slope in (z[base:] - z[:-base]) / (base * dx):
        x = transition @ x + drive * slope
        total += abs(x[2] - x[0])
    return total / (len(z) - base)


def main():
    lib = ctypes.CDLL(sys.argv[1])
    context = ctypes.c_void_p()
    assert lib.trk_context_create(None, None, ctypes.byref(context)) == 0
    random, good = np.random.default_rng(2631), True

    worst = rms = 0
    for rate in (200.0, 256.0, 500.0, 2048.0):
        n = int(30 * rate)
        # Noise up to 80 Hz: what lies between 80 Hz and the Nyquist frequency is not promised.
        low_pass = signal.butter(8, 60, fs=rate, output="sos")
        x = np.ascontiguousarray(signal.sosfiltfilt(low_pass, random.normal(size=n)))
        size = 8 * n
        f = np.fft.rfftfreq(size, 1 / rate)
        for number, w in enumerate(WEIGHTINGS, 1):
            if w[1] < 1:
                continue  # decays longer than the padding
            y, early = np.empty(n), 0.0
            assert lib.trk_weighting_apply(context, int32(number), int64(n), pointer(x),
                                           double(rate), pointer(y)) == 0
            numerator, denominator = polynomials(w)
            h = np.polyval(numerator, 2j * np.pi * f) / np.polyval(denominator, 2j * np.pi * f)
            spectrum = np.fft.rfft(x, size) * h
            wanted = np.fft.irfft(spectrum, size)[:n]
            rms = max(rms, abs(np.std(y) / np.std(wanted) - 1))
            # The filter is early by a time: take it out with the slope of the cross spectrum.
            got = np.fft.rfft(y, size)
            low = (f > 1) & (f < 0.2 * rate)
            weight = np.abs(spectrum[low]) ** 2
            angle = np.angle(got[low] * np.conj(spectrum[low]))
            early = np.sum(weight * angle * f[low]) / np.sum(weight * f[low] ** 2)
            shifted = np.fft.irfft(spectrum * np.exp(1j * early * f), size)[:n]
            worst = max(worst, np.std((y - shifted)[n // 10:]) / np.std(wanted))
    good &= check("RMS of filters, all rates", rms, 1e-3)
    good &= check("waveform of filters, their advance taken out", worst, 2e-2)

    x = random.normal(size=3000)
    y = np.empty_like(x)
    squares = np.convolve(x**2, np.ones(250))[:3000] / 250
    settings = int64(3000), pointer(x), double(250)
    assert lib.trk_running_rms(context, int32(0), *settings, double(1), pointer(y)) == 0
    good &= check("linear running RMS", np.max(np.abs(y - np.sqrt(squares))), 1e-13)
    alpha = np.exp(-1 / 250)
    squares = signal.lfilter([1 - alpha], [1, -alpha], x**2)
    assert lib.trk_running_rms(context, int32(1), *settings, double(1), pointer(y)) == 0
    good &= check("exponential running RMS", np.max(np.abs(y - np.sqrt(squares))), 1e-13)
    v = Vibration(ctypes.sizeof(Vibration))
    assert lib.trk_vibration_measure(context, *settings, ctypes.byref(v)) == 0
    good &= check("VDV", abs(v.vdv - np.sum(x**4 / 250) ** 0.25), 1e-13)
    good &= check("MTVV", abs(v.mtvv_exponential - np.sqrt(np.max(squares))), 1e-13)
    percent, out = np.array([0.0, 1, 17, 50, 99.9, 100]), np.empty(6)
    assert lib.trk_travel_measure(context, int64(3000), pointer(x), None, int32(6),
                                  pointer(percent), pointer(out)) == 0
    good &= check("percentiles", np.max(np.abs(out - np.percentile(x, percent))), 1e-14)

    worst = 0
    for dx in (0.025, 0.05, 0.1, 0.15, 0.25, 0.3):
        z = np.cumsum(random.normal(size=4000)) * 1e-3
        iri = double()
        assert lib.trk_iri(context, int64(4000), pointer(z), double(dx), None,
                           ctypes.byref(iri)) == 0
        worst = max(worst, abs(iri.value / sayers(z, dx) - 1))
    good &= check("IRI", worst, 1e-10)
    lib.trk_context_destroy(context)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
