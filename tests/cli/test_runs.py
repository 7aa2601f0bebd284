# SPDX-License-Identifier: MIT
"""simulate, psd, calibrate, study: numbers of runs against the library's."""
import json
import os
import pathlib
import subprocess

import pytest

from conftest import COMMAND, HALF, QUARTER, TRUCK, call, columns, environment, parsed, rows


def series_of(text):
    table = columns(text)
    return table.pop("time"), table


@pytest.fixture
def half(tr):
    return tr.vehicle("reference_half", "linear").compile()


def drive(tr, model, profiles, speed):
    excitation = tr.Excitation(model)
    for side, profile in profiles.items():
        excitation.add_profile(profile, speed, side)
    return excitation


def test_simulate_is_what_the_library_computes(tr, half):
    text = call("simulate", HALF, "--road", "step:start=0.1:length=0.2:height=0.03", "--duration", "0.5",
                "--step", "0.002", "--every", "5").stdout
    time, channels = series_of(text)
    run = tr.simulate(half, tr.Signal.step(0.03, 0.2, start=0.1), 0.5, step=0.002, record_every=5)
    assert list(channels) == half.sensors and time == pytest.approx(list(run.time))
    for name, values in channels.items():
        assert values == pytest.approx(list(run[name]), rel=6e-9, abs=1e-12)
    assert text.splitlines()[0].split(",")[1] == f"{half.sensors[0]} [{run.units[half.sensors[0]]}]"


def test_the_method_is_a_choice(tr, half):
    words = ["simulate", HALF, "--road", "sine:frequency=2:amplitude=0.01", "--duration", "0.3"]
    newmark = series_of(call(*words).stdout)[1]
    rk4 = series_of(call(*words, "--method", "rk4").stdout)[1]
    run = tr.simulate(half, tr.Signal.sine(0.01, 2.0), 0.3, method="runge_kutta")
    for name in half.sensors:
        assert rk4[name] == pytest.approx(list(run[name]), rel=6e-9, abs=1e-12)
        assert rk4[name] != newmark[name]


def test_simulate_on_an_iso_road(tr):
    text = call("simulate", TRUCK, "--road", "iso:class=C:speed=72:seed=5", "--duration", "1",
                "--sensors", "cab_front_*_z,rear_left_tire_force").stdout
    _, channels = series_of(text)
    left, right = tr.road(road_class="c", seed=5, ramp_length=20.0)
    truck = tr.vehicle("reference_truck", "thesis_dampers").compile()
    run = tr.simulate(truck, drive(tr, truck, {"left": left, "right": right}, 20.0), 1.0)
    assert list(channels) == ["cab_front_left_z", "cab_front_right_z", "rear_left_tire_force"]
    for name, values in channels.items():
        assert values == pytest.approx(list(run[name]), rel=1e-8, abs=1e-9)


def test_every_format_holds_the_same(tr):
    words = ["simulate", QUARTER, "--road", "sine", "--duration", "0.2"]
    text = call(*words).stdout
    time, channels = series_of(text)
    for name in ("run.csv", "run.json", "run.mat", "run.rpc"):
        call(*words, "-o", name)
    assert pathlib.Path("run.csv").read_text() == text
    data = json.loads(pathlib.Path("run.json").read_text())
    assert (data["start"], data["rate"]) == (0, 1000)
    for channel in data["channels"]:
        assert channels[channel["name"]] == pytest.approx(channel["data"], rel=1e-8, abs=1e-12)
    rpc = tr.read_rpc("run.rpc")
    assert list(rpc) == list(channels) and rpc.samples == len(time)
    for name in rpc:
        assert channels[name] == pytest.approx(list(rpc[name]), rel=1e-6, abs=1e-6)
    assert pathlib.Path("run.mat").read_bytes().startswith(b"MATLAB 5.0")
    mat = subprocess.run([COMMAND, *words, "--format", "mat"], capture_output=True, check=True).stdout
    assert mat[128:] == pathlib.Path("run.mat").read_bytes()[128:]  # the header has the date


def test_recorded_heights_over_time(tr, half):
    signal = tr.Signal.sine(0.01, 1.0)
    steps = [k * 0.01 for k in range(201)]
    lines = [f"{t:.2f},{1000 * signal(t) + 5:.17g}" for t in steps]
    pathlib.Path("road.csv").write_text("time [s],height [mm]\n" + "\n".join(lines))
    _, channels = series_of(call("simulate", HALF, "--road", "csv:road.csv").stdout)
    run = tr.simulate(half, tr.Signal.samples([signal(t) for t in steps], 0.01), 2.0)
    assert len(channels[half.sensors[0]]) == 2001  # as long as the recording
    for name in half.sensors:
        assert channels[name] == pytest.approx(list(run[name]), rel=1e-6, abs=1e-9)


def test_recorded_heights_over_distance_per_side(tr):
    places = [0.25 * k for k in range(81)]
    left = [0.001 * k % 0.02 for k in range(81)]
    right = [-0.5 * height for height in left]
    table = [f"{x},{a},{b}" for x, a, b in zip(places, left, right)]
    pathlib.Path("track.csv").write_text("distance [m],a,b\n" + "\n".join(table))
    truck = tr.vehicle("reference_truck", "thesis_dampers").compile()
    tracks = {"left": tr.Signal.samples(left, 0.25), "right": tr.Signal.samples(right, 0.25)}
    run = tr.simulate(truck, drive(tr, truck, tracks, 10.0), 2.0)
    for words in ("", ":left=a:right=b", ":right=2:left=1:gain=1"):
        text = call("simulate", TRUCK, "--road", f"csv:track.csv:speed=36{words}", "--sensors", "*_tire_force").stdout
        _, channels = series_of(text)
        for name, values in channels.items():
            assert values == pytest.approx(list(run[name]), rel=1e-6, abs=1e-4)
    call("simulate", TRUCK, "--road", "csv:track.csv:left=c", expected=2)
    call("simulate", TRUCK, "--road", "csv:track.csv:middle=a", expected=2)


def test_a_run_is_a_road_again():
    """A recording by RPC III, whose channels are called as the road inputs."""
    header = "time [s],front [m],rear [m],other\n"
    pathlib.Path("rig.csv").write_text(header + "".join(f"{k / 100},{k % 7 / 1000},0,{k}\n" for k in range(200)))
    text = call("simulate", HALF, "--road", "csv:rig.csv", "--duration", "1", "--sensors", "*_tire_force").stdout
    _, channels = series_of(text)
    assert max(map(abs, channels["front_tire_force"])) > 10 * max(map(abs, channels["rear_tire_force"]))


def test_a_surface(tr):
    text = ["$ROAD_CRG", "REFERENCE_LINE_START_U=0", "REFERENCE_LINE_END_U=40", "REFERENCE_LINE_INCREMENT=0.5",
            "LONG_SECTION_V_RIGHT=-2", "LONG_SECTION_V_LEFT=2", "LONG_SECTION_V_INCREMENT=4", "$",
            "$KD_DEFINITION", "#:LRFI", "D:LONG SECTION 1,M", "D:LONG SECTION 2,M", "$", "$" * 72]
    heights = [(0.5 + 0.01 * (k % 3), 0.5 + 0.02 * (k % 5)) for k in range(81)]
    text += [f"{a:10.7f}{b:10.7f}" for a, b in heights]
    pathlib.Path("road.crg").write_text("\n".join(text) + "\n")
    _, channels = series_of(call("simulate", TRUCK, "--road", "crg:road.crg:speed=36", "--sensors",
                                 "*_tire_force").stdout)
    truck = tr.vehicle("reference_truck", "thesis_dampers").compile()
    crg = tr.Surface("road.crg")
    excitation = tr.Excitation(truck)
    for road in truck.roads:
        profile = crg.profile(truck.road_place(road).y)
        excitation.add_profile(profile, 10.0, road)
        excitation.add_motion(tr.Signal.points([0, 1], [-profile(0)] * 2), road)
    run = tr.simulate(truck, excitation, 4.0)
    for name, values in channels.items():
        assert values == pytest.approx(list(run[name]), rel=1e-6, abs=1e-3)


def test_psd_of_a_recording(tr):
    call("simulate", HALF, "--road", "sweep:from=1:to=10", "--duration", "4", "-o", "run.csv")
    recorded = tr.read_csv("run.csv")
    table = columns(call("psd", "run.csv", "--segment", "1000", "--window", "hamming", "--format", "csv").stdout)
    for name in recorded:
        wanted = recorded[name].psd(segment_length=1000, window="hamming")
        assert table["frequency"] == pytest.approx(list(wanted.frequency))
        assert table[name] == pytest.approx(list(wanted.density), rel=1e-14)
    with open("run.csv") as stream:
        piped = columns(call("psd", "-", "--segment", "1000", "--window", "hamming", "--format", "csv",
                             stdin=stream).stdout)
    assert piped == table
    part = columns(call("psd", "run.csv", "--segment", "1000", "--from", "2", "--to", "5", "--format", "csv").stdout)
    assert part["frequency"] == [2, 3, 4, 5]


def test_rms_and_weighting(tr):
    call("simulate", HALF, "--road", "sweep:from=1:to=10", "--duration", "4", "-o", "run.csv")
    recorded = tr.read_csv("run.csv")
    plain = {row["channel"]: row for row in parsed("psd", "run.csv", "--rms", "--from", "1", "--to", "8")["rms"]}
    weighted = {row["channel"]: row for row in parsed("psd", "run.csv", "--rms", "--weighting", "Wk")["rms"]}
    for name in recorded:
        psd = recorded[name].psd()
        assert plain[name]["rms"] == pytest.approx(psd.band_rms(1, 8), rel=1e-12)
        if recorded[name].unit == "m/s^2":
            density = tr.comfort.psd_weight("Wk", psd.density, psd.step)
            assert weighted[name]["weighted rms"] == pytest.approx(tr.band_rms(density, psd.step, 0, 1e6), rel=1e-12)
        else:
            assert name not in weighted


def test_psd_linearised_on_the_road():
    """Curves of the thesis's dampers: linearised on the road they come nearer to the run than at rest."""
    words = ["psd", "builtin:reference_truck", "--road", "iso:class=C:speed=70", "--duration", "120",
             "--sensors", "cab_*_left_z,*_axle_left_z", "--rms"]

    def rms(*more):
        return {row["channel"]: row["rms"] for row in parsed(*words, *more)["rms"]}
    run, rest, road = rms(), rms("--linear"), rms("--linearise")
    assert run.keys() == rest.keys() == road.keys()
    assert all(road[name] == pytest.approx(run[name], rel=0.15) for name in run)
    assert max(rest[name] / run[name] for name in run) > 1.25


def test_psd_with_and_without_a_run(tr, half):
    words = ["psd", HALF, "--road", "sweep:from=0.8:to=15", "--duration", "60"]
    run = {row["channel"]: row["rms"] for row in parsed(*words, "--rms")["rms"]}
    linear = {row["channel"]: row["rms"] for row in parsed(*words, "--rms", "--linear")["rms"]}
    assert run.keys() == linear.keys()
    assert all(linear[name] == pytest.approx(run[name], rel=0.02) for name in run)
    table = columns(call(*words, "--linear", "--sensors", "cab_front_z,*_tire_force", "--format", "csv").stdout)
    sweep = tr.Signal.sweep(start_frequency=0.8, end_frequency=15.0, duration=60.0)
    wanted = tr.response_psd_excited(half, sweep, 60.0).psd
    assert set(table) == {"frequency", "cab_front_z", "front_tire_force", "rear_tire_force"}
    for name in table.keys() - {"frequency"}:
        assert table[name] == pytest.approx(list(wanted[name].density), rel=1e-12)


def test_calibrate_reaches_its_targets(tr):
    words = ["calibrate", "builtin:reference_truck:linear", "--target", "front_axle.z=13.8",
             "--target", "rear_axle.z=10", "--parameter", "front_*_tire:stiffness:0.5..8",
             "--parameter", "rear_*_tire:stiffness:0.5..8:name=rear"]
    report = parsed(*words)
    spec = tr.vehicle("reference_truck", "linear")
    for row, pattern in zip(report["parameters"], ("front_*_tire", "rear_*_tire")):
        assert row["low 95 %"] < row["fitted"] < row["high 95 %"]
        spec.vary(pattern, "stiffness", row["fitted"])
    modes = spec.compile().modes(damped=False)
    for row, (coordinate, wanted) in zip(report["targets"], (("front_axle.z", 13.8), ("rear_axle.z", 10))):
        assert row["met"] == "yes" and row["after"] == pytest.approx(wanted, rel=1e-6)
        assert row["after"] == pytest.approx(modes.dominated_by(coordinate)[0].frequency, rel=1e-9)


def test_a_target_out_of_reach_is_code_1_and_writes_no_model():
    words = ["calibrate", HALF, "--target", "front_axle.z=100", "-p", "front_tire:stiffness:0.5..2", "-o", "out.json"]
    done = call(*words, expected=1)
    assert "at upper bound" in done.stdout and "no" in done.stdout and done.stderr
    assert not os.path.exists("out.json")


def test_peak_and_damping_targets():
    """Targets that are the model's own values leave its parameters as they are."""
    words = ["--target", "ratio:cab.z=0.0385", "--parameter", "cab_*:damping:0.5..2"]
    ratio = next(row for row in parsed("modes", HALF)["modes"] if row["dominant"] == "cab.z")["damping ratio"]
    words[1] = f"ratio:cab.z={ratio:.9g}"
    assert parsed("calibrate", HALF, *words)["parameters"][0]["fitted"] == pytest.approx(1, rel=1e-3)
    report = parsed("calibrate", QUARTER, "--target", "peak:unsprung_z:5..15=8.8", "--parameter",
                    "tire:stiffness:0.8..1.3", "--road", "sweep:from=2:to=15", "--duration", "30")
    assert report["targets"][0]["met"] == "yes"


def test_study_is_truckride_study(folder):
    options = ["--vary", "t=stiffness:*_tire:0.8..1.2", "--output", "cab=rms:cab_front_left_z", "--cases", "5",
               "--duration", "1", "--quiet"]
    own = call("study", TRUCK, *options).stdout
    table = rows(own)
    assert len(table) == 5 and all(row["status"] == 0 for row in table)
    call("study", *options, "-o", "study.csv")
    assert pathlib.Path("study.csv").read_text() == own
    for part in ("1/2", "2/2"):
        call("study", TRUCK, *options, "--shard", part, "--journal", f"{part[0]}.journal")
    merged = call("study", "merge", "--vehicle", TRUCK, *options, "1.journal", "2.journal").stdout
    assert merged == own
    program = pathlib.Path(os.environ.get("TRUCKRIDE_STUDY", ""))
    if program.is_file():
        done = subprocess.run([program, *options, "--csv", "-"], env=environment(), capture_output=True, text=True)
        assert done.stdout == own
