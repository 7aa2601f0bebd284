# SPDX-License-Identifier: MIT
"""Files in, files out, OpenCRG surfaces: numbers against NumPy and SciPy, errors with places."""
import math
import pickle

import numpy as np
import pytest

import truckride as tr
from conftest import ROOT

TABLE = b"distance [m],left [mm],right [mm]\n0,0,0\n0.25,4,2\n0.5,-3,1\n0.75,1,-2\n1,0,0\n"
ERD = (b"ERDFILEV2.00\n2,3,-1,1,5,0.5,-1,\nXUNITS  m\nSHORTNAMLeft    Right\n"
       b"UNITSNAMmm      mm\nEND\n1 2\n3 4\n5 6\n")
BUMP = (b"$CT\nA bump across\n$\n$ROAD_CRG\nREFERENCE_LINE_INCREMENT = 1\n"
        b"LONG_SECTION_V_RIGHT = -1\nLONG_SECTION_V_LEFT = 1\n$\n$KD_DEFINITION\n#:LRFI\n"
        b"D:long section 1,m\nD:long section 2,m\n$\n$$$$\n"
        b"0.0000000 0.0000000 \n0.0400000 0.0600000 \n0.0000000 0.0000000 \n")


def shared(name):
    """A measured file beside the project."""
    path = ROOT.parent / "shared" / "data" / name
    if not path.exists():
        pytest.skip(f"{name} is not there")
    return path


@pytest.fixture(params=["path", "bytes", "memoryview"])
def source(request, tmp_path):
    """The same bytes in each form that readers take."""
    def give(data):
        if request.param == "path":
            (tmp_path / "given").write_bytes(data)
            return tmp_path / "given"
        return data if request.param == "bytes" else memoryview(data)
    return give


def test_csv(source):
    profile = tr.read_csv(source(TABLE))
    assert list(profile) == ["left", "right"] and profile.units == {"left": "mm", "right": "mm"}
    assert (profile.rate, profile.start, profile.samples) == (4.0, 0.0, 5)
    assert profile["left"].values.tolist() == [0, 4, -3, 1, 0]
    assert profile.to_si() is profile and profile["left"].unit == "m"
    assert profile["left"].values == pytest.approx([0, 0.004, -0.003, 0.001, 0], abs=1e-18)


def test_csv_of_other_countries():
    german = b"t [s];a\n0,0;1,5\n0,1;2,5\n"
    assert tr.read_csv(german, decimal_comma=1)["a"].values.tolist() == [1.5, 2.5]
    assert tr.read_csv(german, tr.CsvOptions(decimal_comma=1), separator=";").rate == 10
    with pytest.raises(tr.ArgumentError, match="one character"):
        tr.read_csv(german, separator=";;")


def test_csv_signal_is_that_of_points(source):
    signal = tr.read_csv_signal(source(b"x [m],z [mm],w\n0,0,5\n1,2,6\n4,3,8\n"))
    points, places = tr.Signal.points([0, 1, 4], [0, 0.002, 0.003]), np.linspace(0, 4, 33)
    for twin in (signal, pickle.loads(pickle.dumps(signal))):
        assert twin(places) == pytest.approx(points(places), rel=1e-14)
    assert repr(signal) == "<Signal _csv>"
    assert tr.read_csv_signal(source(TABLE), 2).rate(0) != 0


def test_erd(source):
    profile = tr.read_erd(source(ERD)).to_si()
    assert list(profile) == ["Left", "Right"] and profile.rate == 2
    assert np.array(profile["Right"]) == pytest.approx([0.002, 0.004, 0.006])


def test_rpc_measured():
    path = shared("sample_mts_rpc3_int16.rsp")
    run = tr.read_rpc(path)
    assert len(run) == 5 and run.samples == 2048 and run.rate == 250
    assert run.units["ACC_76zGlob"] == "m/s^2"
    assert np.std(run["FDO_54xLoc_sh"], ddof=1) == pytest.approx(68.956131, rel=1e-4)  # its header
    assert np.array_equal(tr.read_rpc(path.read_bytes())["ACC_76zGlob"], run["ACC_76zGlob"])


@pytest.mark.parametrize("settings, error", [
    ({}, 2e-7), ({"big_endian": 1, "drive": 1}, 2e-7), ({"type": "short_integer"}, 1 / 65000)])
def test_rpc_round_trip(tmp_path, settings, error):
    sent = tr.Series({"a": np.sin(np.arange(3000) / 7), "b": np.arange(3000.0)}, 200,
                     units={"a": "m"})
    sent.write_rpc(tmp_path / "run.rsp", **settings)
    back = tr.read_rpc(tmp_path / "run.rsp")
    assert (back.rate, back.samples, back.units) == (200, 3000, sent.units)
    for name in sent:
        peak = np.abs(sent[name]).max()
        assert np.abs(back[name].values - sent[name].values).max() < error * peak


def test_mat_is_read_by_scipy(tmp_path):
    scipy_io = pytest.importorskip("scipy.io")
    sent = tr.Series({"front z": [1.0, 2.0, 4.0]}, 10, 0.5, {"front z": "m/s^2"})
    sent.write_mat(tmp_path / "run.mat")
    back = scipy_io.loadmat(tmp_path / "run.mat", squeeze_me=True)
    assert back["front_z"].tolist() == [1, 2, 4] and back["time"] == pytest.approx([0.5, 0.6, 0.7])
    assert str(back["channel_names"]) == "front z" and str(back["channel_units"]) == "m/s^2"


def test_csv_round_trip(tmp_path):
    sent = tr.Series({"a": np.random.default_rng(1).normal(size=100)}, 100, units={"a": "N"})
    sent.write_csv(tmp_path / "run.csv")
    back = tr.read_csv(tmp_path / "run.csv")
    assert np.array(back["a"]) == pytest.approx(np.array(sent["a"]), rel=1e-8)  # 9 digits
    assert back.rate == 100 and back.units == {"a": "N"}


def test_surface(source):
    road = tr.Surface(source(BUMP))
    assert road.extent == (0, 2, 1, -1, 1) and (road.rows, road.columns) == (3, 2)
    assert road.height(1, -0.5) == pytest.approx(0.045)
    u, v = np.linspace(0, 2, 9)[:, None], np.array([-1, 0.25, 1])
    expected = (0.05 + 0.01 * v) * (1 - np.abs(u - 1))
    for twin in (road, pickle.loads(pickle.dumps(road))):
        assert twin.height(u, v) == pytest.approx(expected)
    assert math.isnan(road.height(math.nan, 0)) and road.height([], 0).shape == (0,)
    assert repr(road) == "<Surface of 3 rows, 2 columns>"


def test_borders_of_a_surface():
    heights = {border: tr.Surface(BUMP, border_u=border).height(2.5, 0)
               for border in ("keep", "repeat", "reflect")}
    assert heights["keep"] == 0 and heights["reflect"] == pytest.approx(0.025)
    assert math.isnan(tr.Surface(BUMP, tr.CrgOptions(border_u="none")).height(2.5, 0))
    with pytest.raises(tr.ArgumentError, match="neighbour"):
        tr.Surface(BUMP, missing="maybe")


def test_profile_of_a_surface():
    road = tr.Surface(BUMP)
    right = road.profile(-0.5)
    road.close()
    assert right(1.0) == pytest.approx(0.045) and right.rate(0.5) == pytest.approx(0.045)
    assert pickle.loads(pickle.dumps(right))(0.25) == pytest.approx(0.045 / 4)
    with pytest.raises(tr.RangeError, match="4"):
        tr.Surface(BUMP).profile(0, smooth=True)
    with pytest.raises(tr.ClosedError):
        road.height(0, 0)


def test_series_of_a_surface():
    road = tr.Surface(BUMP)
    both = road.series([0.9, -0.9], 0.1)
    assert list(both) == ["v=0.9", "v=-0.9"] and both.samples == 21
    assert both.rate == pytest.approx(10) and both["v=0.9"].unit == "m"
    assert np.array(both["v=0.9"]) == pytest.approx(road.height(both.time, 0.9))
    assert road.series(0).samples == 3 and road.series(0, 0.5, start=1).samples == 3
    assert road.series(0, 0.5, start=1, samples=2).start == 1
    for spacing in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(tr.RangeError, match="trk_crg_sample"):
            road.series(0, spacing)
    with pytest.raises(tr.RangeError):
        road.series([0, 0], 0.5)


def test_belgian_block():
    """Heights as the C tests have them, from NumPy."""
    path = shared("belgian_block.crg")
    road = tr.Surface(path)
    assert (road.rows, road.columns) == (1001, 341)
    assert road.extent == pytest.approx((730, 740, 0.01, -1.7, 1.7))
    assert road.height(735.123, 0.8045) == pytest.approx(2.1441491580009355, abs=1e-9)
    tracks = road.series([0.9, -0.9])
    assert tracks.samples == 1001 and tracks["v=-0.9"][500] == pytest.approx(2.0860025882720947)
    assert road.profile(0.9, smooth=True)(735) == pytest.approx(2.1507272720336914, abs=1e-9)


def test_truck_over_a_course(truck):
    road = tr.Surface(shared("detrended_rms_course_1in.crg"))
    excitation = (tr.Excitation(truck).add_profile(road.profile(1), 10.0, "left", start=110)
                  .add_profile(road.profile(-1), 10.0, "right", start=110))
    run = tr.simulate(truck, excitation, 2.0)
    assert 0.1 < run["cab_front_left_z"].rms < 50
    height = road.series(1, 0.05, 100, 6096)["v=1"]
    assert height.rms / 0.0254 == pytest.approx(0.9573952975506561, abs=1e-9)  # NumPy


def test_roughness_of_a_measured_profile():
    path = shared("iri_profile_1.txt")
    profile = tr.read_csv(path)
    x, z = np.loadtxt(path, unpack=True)
    channel = next(iter(profile.values()))
    assert np.array_equal(channel, z) and profile.rate == pytest.approx(1 / (x[1] - x[0]))
    assert tr.roughness.iri(channel, 1 / profile.rate) == tr.roughness.iri(z, 1 / profile.rate)


@pytest.mark.parametrize("kind, words, call", [
    (tr.FileError, "nowhere.csv", lambda: tr.read_csv("nowhere.csv")),
    (tr.FileError, "nowhere.crg", lambda: tr.Surface("nowhere.crg")),
    (tr.InputError, "run.csv:3:5", lambda: tr.read_csv(b"t,a\n0,1\n1,2,5\n", name="run.csv")),
    (tr.InputError, "bytes", lambda: tr.read_rpc(b"")),
    (tr.InputError, "bytes:1", lambda: tr.read_erd(b"no such file")),
    (tr.RangeError, "column", lambda: tr.read_csv_signal(TABLE, 3)),
    (tr.ArgumentError, "no integer of", lambda: tr.read_csv_signal(TABLE, 2**32 + 1)),
    (tr.RangeError, "even", lambda: tr.read_csv(b"t,a\n0,1\n1,2\n3,5\n")),
    (tr.ArgumentError, "NUL", lambda: tr.read_erd("a\0b")),
    (tr.ArgumentError, "NUL", lambda: tr.read_erd(b"", name="a\0b")),
    (tr.FileError, "nowhere", lambda: tr.Series({"a": [1]}, 1).write_mat("nowhere/run.mat")),
    (tr.RangeError, "finite", lambda: tr.Series({"a": [math.inf]}, 1).write_rpc("never.rsp")),
    (TypeError, "RpcOptions has", lambda: tr.Series({"a": [1]}, 1).write_rpc("never.rsp", x=1)),
    (TypeError, "int", lambda: tr.read_csv(3)),
    (tr.RangeError, "v", lambda: tr.Surface(BUMP).profile(math.nan)),
])
def test_what_is_wrong_is_said(kind, words, call):
    with pytest.raises(kind, match=words):
        call()
