# SPDX-License-Identifier: MIT
"""check, modes, frf: numbers of a vehicle against the library's."""
import json
import math

import pytest

from conftest import HALF, QUARTER, TRUCK, call, columns, parsed, rows

GRAVITY = 9.80665


def test_check_weighs_the_truck(tr):
    report = parsed("check", TRUCK, QUARTER)
    vehicle, quarter = report["vehicles"]
    spec = tr.vehicle("reference_truck", "thesis_dampers")
    mass = sum(spec.body(name).mass for name in spec.names(tr.Part.BODY))
    assert vehicle["mass"] == pytest.approx(mass, rel=1e-15)
    assert vehicle["weight"] == pytest.approx(GRAVITY * mass, rel=1e-12)
    assert vehicle["on roads"] == pytest.approx(vehicle["weight"], rel=1e-9)
    assert (vehicle["coordinates"], vehicle["bodies"], vehicle["roads"]) == (13, 4, 4)
    assert vehicle["links"] == spec.count(tr.Part.LINK) and vehicle["sensors"] == spec.count(tr.Part.SENSOR)
    assert quarter["weight"] == pytest.approx(5500 * GRAVITY, rel=1e-12)

    model = spec.compile(gravity=GRAVITY)
    force = dict(zip(model.links, model.static.force))
    tires = {tire["road"]: tire for tire in report["tires"] if tire["model"] == "truck"}
    for road, tire in tires.items():
        assert tire["load"] == pytest.approx(-force[f"{road}_tire"], rel=1e-12)
    assert sum(tire["share"] for tire in tires.values()) == pytest.approx(100, rel=1e-9)
    front, rear = [axle for axle in report["axles"] if axle["model"] == "truck"]
    assert front["load"] == pytest.approx(tires["front_left"]["load"] + tires["front_right"]["load"], rel=1e-14)
    assert front["load"] + rear["load"] == pytest.approx(vehicle["weight"], rel=1e-9)
    assert (front["wheels"], rear["x"]) == (2, -4.5)
    assert "warnings" not in report
    assert report["units"]["tires"]["load"] == "N"


def test_check_shows_the_lowest_modes(tr):
    modes = [mode for mode in parsed("check", TRUCK, "--modes", "3")["modes"]]
    model = tr.vehicle("reference_truck", "thesis_dampers").compile(gravity=GRAVITY)
    assert [mode["frequency"] for mode in modes] == [mode.frequency for mode in model.modes()[:3]]


def test_check_goes_on_behind_a_bad_model():
    done = call("check", "missing.json", QUARTER, "--format", "csv", expected=1)
    assert "quarter car" in done.stdout and "missing.json" in done.stderr
    assert call("check", "missing.json", expected=1).stdout == ""


@pytest.mark.parametrize("options, damped", [([], True), (["--undamped"], False)])
def test_modes(tr, options, damped):
    modes = tr.vehicle("reference_half", "linear").compile().modes(damped=damped)
    for table in (parsed("modes", HALF, *options)["modes"],
                  rows(call("modes", HALF, *options, "--format", "csv").stdout)):
        assert len(table) == len(modes)
        for row, mode in zip(table, modes):
            assert row["frequency"] == mode.frequency
            assert row["damping ratio"] == mode.damping_ratio
            assert row["dominant"] == mode.label


def test_modes_lowest_and_shapes(tr):
    report = parsed("modes", HALF, "--undamped", "--count", "2", "--shapes")
    modes = tr.vehicle("reference_half", "linear").compile().modes(damped=False)
    assert [row["frequency"] for row in report["modes"]] == pytest.approx([m.frequency for m in modes[:2]], rel=1e-9)
    for number in (1, 2):
        shape = [row for row in report["shapes"] if row["mode"] == number]
        assert sum(row["energy"] for row in shape) == pytest.approx(1, rel=1e-9)
    assert len(call("modes", HALF, "--count", "3").stdout.splitlines()) == 2 + 3


def test_modes_with_gravity_work_about_the_static_equilibrium(tr):
    truck = "builtin:reference_truck:nonlinear"
    spec = tr.vehicle("reference_truck", "nonlinear")
    wanted = [mode.frequency for mode in spec.compile(gravity=GRAVITY).modes()]
    assert [row["frequency"] for row in parsed("modes", truck, "--gravity")["modes"]] == wanted


def test_the_table_is_aligned_and_has_no_trailing_blanks():
    lines = call("modes", TRUCK).stdout.splitlines()
    assert lines[0].split() == ["mode", "frequency", "damped", "frequency", "damping", "ratio", "dominant",
                                "kinetic", "energy"]
    assert all(line == line.rstrip() for line in lines)
    assert len({line.index(".") for line in lines[2:]}) == 1


def test_frf(tr):
    model = tr.vehicle("reference_half", "linear").compile()
    table = columns(call("frf", HALF, "--from", "0.5", "--to", "20", "--points", "7", "--format", "csv").stdout)
    assert table["frequency"] == pytest.approx([0.5 * 40 ** (k / 6) for k in range(7)], rel=1e-14)
    response = model.response(table["frequency"])
    for sensor in model.sensors:
        for k, value in enumerate(response[sensor]):
            assert table[f"{sensor} magnitude"][k] == pytest.approx(abs(value), rel=1e-12)
            assert table[f"{sensor} phase"][k] == pytest.approx(math.degrees(math.atan2(value.imag, value.real)))


def test_frf_of_one_axle_and_at_speed(tr):
    model = tr.vehicle("reference_half", "linear").compile()
    sensor = "cab_front_z"
    options = ["--even", "--from", "1", "--to", "3", "--points", "3", "--sensor", sensor, "--format", "json"]
    report = json.loads(call("frf", HALF, "--road", "front", *options).stdout)
    wanted = model.response([1, 2, 3], road=[1, 0])[sensor]
    assert [row[f"{sensor} magnitude"] for row in report["frf"]] == pytest.approx(abs(wanted), rel=1e-12)
    assert set(report["frf"][0]) == {"frequency", f"{sensor} magnitude", f"{sensor} phase"}
    report = json.loads(call("frf", HALF, "--speed", "72", *options).stdout)
    wanted = model.response([1, 2, 3], road=[1, 1], delay=[0, 4.5 / 20])[sensor]
    assert [row[f"{sensor} magnitude"] for row in report["frf"]] == pytest.approx(abs(wanted), rel=1e-9)
