#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Files against independent readers: files_scipy.py path/to/libtruckride.so

MAT files through scipy.io.loadmat, and GNU Octave where it is installed; RPC III files decoded with
NumPy alone; 1e5 random numbers in a CSV against Python's float(); heights of an OpenCRG file that is
packed here. Exit 1 at the first difference, 77 (skip) without SciPy.
"""
import ctypes
import math
import pathlib
import random
import shutil
import struct
import subprocess
import sys
import tempfile

try:
    import numpy as np
    import scipy.io
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

lib = ctypes.CDLL(sys.argv[1])
lib.trk_context_message.restype = ctypes.c_char_p
lib.trk_series_data_mutable.restype = ctypes.POINTER(ctypes.c_double)
lib.trk_series_samples.restype = ctypes.c_int64
lib.trk_crg_height.restype = ctypes.c_double
lib.trk_crg_height.argtypes = [ctypes.c_void_p, ctypes.c_double, ctypes.c_double]
context = ctypes.c_void_p()
NAMES = ["cab, front°", "end", "3", "ok", "ok!", "x" * 80, "über"]


class RpcOptions(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_size_t), ("type", ctypes.c_int32),
                ("big_endian", ctypes.c_int32), ("drive", ctypes.c_int32),
                ("reserved", ctypes.c_int32)]


def check(status):
    if status:
        sys.exit(lib.trk_context_message(context).decode())


def make_series(values):
    series = ctypes.c_void_p()
    check(lib.trk_series_create(context, len(values), ctypes.c_int64(len(values[0])),
                                ctypes.c_double(200), ctypes.c_double(1.5), ctypes.byref(series)))
    for k, (name, x) in enumerate(zip(NAMES, values), 1):
        check(lib.trk_series_label(series, k, name.encode(), b"m/s^2" if k % 2 else b""))
        ctypes.memmove(lib.trk_series_data_mutable(series, k), x.ctypes.data, x.nbytes)
    return series


def mat(folder, series, values):
    path = folder / "run.mat"
    check(lib.trk_series_write_mat(context, series, str(path).encode()))
    loaded = scipy.io.loadmat(path)
    assert [str(n[0]) for n in loaded["channel_names"][:, 0]] == NAMES
    assert [str(n[0]) if n.size else "" for n in loaded["channel_units"][:, 0]] == \
        ["" if k % 2 else "m/s^2" for k in range(len(NAMES))]
    assert np.array_equal(loaded["time"][:, 0], 1.5 + np.arange(len(values[0])) / 200)
    variables = [n for n in loaded if not n.startswith("__")][1:len(NAMES) + 1]
    for name, x in zip(variables, values):
        assert loaded[name].shape == (len(x), 1) and np.array_equal(loaded[name][:, 0], x), name
    print("scipy:", variables[:5])
    octave = shutil.which("octave-cli") or shutil.which("octave")
    if not octave:
        print("skipped: octave was not found")
        return
    script = (f"s = load('{path}'); printf('%.17g ', sum(s.ok), s.time(end), columns(s.channel_names{{4}}));"
              "printf('%s %s %d', s.channel_names{4}, s.channel_units{1}, isvarname('cab__front_'))")
    out = subprocess.run([octave, "--norc", "--quiet", "--no-gui", "--eval", script], check=True,
                         capture_output=True, text=True).stdout.split()
    assert math.isclose(float(out[0]), values[3].sum(), rel_tol=1e-12), out
    assert out[1:] == ["%.17g" % (1.5 + (len(values[0]) - 1) / 200), "2", "ok", "m/s^2", "1"], out
    print("octave:", out)


def rpc(folder, series, values):
    path = folder / "run.rsp"
    for number in range(4):
        options = RpcOptions(ctypes.sizeof(RpcOptions), number % 2, number // 2, 0, 0)
        check(lib.trk_series_write_rpc(context, series, str(path).encode(), ctypes.byref(options)))
        data = path.read_bytes()
        key = {}
        for at in range(0, int(data[160:256].split(b"\0")[0]) * 512, 128):
            record = data[at:at + 128]
            key[record[:32].split(b"\0")[0].decode()] = record[32:].split(b"\0")[0].decode("cp1252")
        assert key["DATA_TYPE"] == ["FLOATING_POINT", "SHORT_INTEGER"][number % 2]
        order = ">" if "BIG" in key["FORMAT"] else "<"
        raw = np.frombuffer(data[512 * int(key["NUM_HEADER_BLOCKS"]):],
                            order + ["f4", "i2"][number % 2])
        groups = raw.reshape(-1, int(key["CHANNELS"]), int(key["PTS_PER_GROUP"]))
        assert len(groups) == math.ceil(int(key["FRAMES"]) * int(key["PTS_PER_FRAME"])
                                        / int(key["PTS_PER_GROUP"]))
        assert int(key["NUM_PARAMS"]) == sum(1 for k in key if k)
        for k, x in enumerate(values):
            scale = float(key[f"SCALE.CHAN_{k + 1}"])
            got = groups[:, k, :].ravel()[:len(x)].astype(float) * scale
            bound = 0.5001 * scale if number % 2 else np.abs(x) * 2.0 ** -24 + 1e-45
            assert np.all(np.abs(got - x) <= bound), (number, k)
    print("rpc: 4 files decoded")


def numbers(folder):
    random.seed(7)
    texts = []
    while len(texts) < 100000:
        x = struct.unpack("<d", struct.pack("<Q", random.getrandbits(64)))[0]
        digits = "".join(random.choice("0123456789") for _ in range(random.randint(1, 30)))
        point = random.randint(0, len(digits))
        text = random.choice([f"{x!r}", f"{x:.20e}", digits[:point] + "." + digits[point:],
                              f"{digits}e{random.randint(-320, 270)}"])
        if math.isfinite(float(text)):
            texts.append(text)
    path = folder / "numbers.csv"
    path.write_text("t,a\n" + "".join(f"{k},{text}\n" for k, text in enumerate(texts)))
    series = ctypes.c_void_p()
    check(lib.trk_series_read_csv(context, str(path).encode(), None, ctypes.byref(series)))
    got = np.ctypeslib.as_array(lib.trk_series_data_mutable(series, 1), (len(texts),))
    want = np.array([float(text) for text in texts])
    wrong = np.flatnonzero(got.view(np.uint64) != want.view(np.uint64))
    assert len(wrong) == 0, texts[wrong[0]]
    lib.trk_series_destroy(series)
    print(f"csv: {len(texts)} numbers equal")


def crg(folder):
    rng = np.random.default_rng(3)
    grid, u0, du, v0, dv = rng.normal(size=(40, 7)).astype(">f4"), 5, 0.25, -1.5, 0.5
    head = (f"$CT\n$\n$ROAD_CRG\nreference_line_start_u={u0}\nreference_line_end_u={u0 + 39 * du}\n"
            f"reference_line_increment={du}\nlong_section_v_right={v0}\nlong_section_v_increment={dv}\n"
            "$\n$KD_DEFINITION\n#:KRBI\n" + "".join(f"D:long section {k},m\n" for k in range(1, 8))
            + "$\n$$$$\n")
    data = grid.tobytes()
    path = folder / "road.crg"
    path.write_bytes(head.encode() + data + struct.pack(">f", math.nan) * (-len(data) % 80 // 4))
    surface = ctypes.c_void_p()
    check(lib.trk_crg_read(context, str(path).encode(), None, ctypes.byref(surface)))
    z = grid.astype(float)
    for u, v in rng.uniform([0, 0], [39, 6], size=(2000, 2)):
        i, j = int(u), int(v)
        f, g = u - i, v - j
        want = (z[i, j] * (1 - f) * (1 - g) + z[i + 1, j] * f * (1 - g) + z[i, j + 1] * (1 - f) * g
                + z[i + 1, j + 1] * f * g)
        assert abs(lib.trk_crg_height(surface, u0 + u * du, v0 + v * dv) - want) < 1e-12
    lib.trk_crg_destroy(surface)
    print("crg: 2000 heights equal")


def main():
    check(lib.trk_context_create(None, None, ctypes.byref(context)))
    rng = np.random.default_rng(1)
    values = [np.ascontiguousarray(rng.normal(size=5000) * 10.0 ** k) for k in range(len(NAMES))]
    series = make_series(values)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        mat(folder, series, values)
        rpc(folder, series, values)
        numbers(folder)
        crg(folder)
    lib.trk_series_destroy(series)
    lib.trk_context_destroy(context)


main()
