# SPDX-License-Identifier: MIT
"""Model files: exported, piped, calibrated, and wrong in many ways."""
import json
import os
import pathlib
import re

import pytest

from conftest import HALF, QUARTER, TRUCK, call, parsed, rows


def exported(model=HALF):
    return json.loads(call("export", model).stdout)


def write(name, description):
    pathlib.Path(name).write_text(json.dumps(description, indent=1))
    return name


@pytest.mark.parametrize("model", [TRUCK, HALF, QUARTER, TRUCK + ":nonlinear"])
def test_an_exported_vehicle_is_the_same_vehicle(model):
    call("export", model, "-o", "truck.json")
    text = pathlib.Path("truck.json").read_text()
    assert call("export", model).stdout == text == call("export", "truck.json").stdout
    wanted = call("modes", model, "-f", "json").stdout
    assert call("modes", "truck.json", "-f", "json").stdout == wanted
    assert call("modes", "-", "-f", "json", input=text).stdout == wanted
    run = ["--road", "sine", "--duration", "0.2"]
    assert call("simulate", "truck.json", *run).stdout == call("simulate", model, *run).stdout


def test_a_study_of_a_model_file():
    call("export", TRUCK, "-o", "truck.json")
    options = ["--vary", "t=stiffness:*_tire:0.8..1.2", "--output", "cab=rms:cab_front_left_z", "--cases", "3",
               "--duration", "0.5", "--quiet"]
    wanted = call("study", TRUCK, *options).stdout
    assert call("study", "truck.json", *options).stdout == wanted
    assert call("study", "--vehicle", "truck.json", *options).stdout == wanted
    assert call("study", "-", *options, input=pathlib.Path("truck.json").read_text()).stdout == wanted
    assert "cab_front_left_z" in call("study", "truck.json", "--list").stdout


def test_the_calibrated_model_has_its_frequencies():
    words = ["calibrate", "builtin:reference_truck:linear", "-t", "front_axle.z=13.8", "-t", "rear_axle.z=10",
             "-p", "front_*_tire:stiffness:0.5..8", "-p", "rear_*_tire:stiffness:0.5..8"]
    call(*words, "-o", "calibrated.json")
    modes = {row["dominant"]: row["frequency"] for row in parsed("modes", "calibrated.json", "--undamped")["modes"]}
    assert modes["front_axle.z"] == pytest.approx(13.8, rel=1e-6) and modes["rear_axle.z"] == pytest.approx(10, rel=1e-6)
    done = call(*words, "-o", "-")
    assert done.stdout == pathlib.Path("calibrated.json").read_text() and "fitted" in done.stderr


def test_a_model_that_misses_its_targets_is_written_only_if_asked():
    words = ["calibrate", HALF, "-t", "front_axle.z=100", "-p", "front_tire:stiffness:0.5..2", "-o", "out.json"]
    call(*words, expected=1)
    assert not pathlib.Path("out.json").exists()
    call(*words, "--anyway", expected=1)
    assert json.loads(pathlib.Path("out.json").read_text())["links"]["front_tire"]["stiffness"] == 2 * 817500


@pytest.mark.parametrize("change, message", [
    (lambda text: text.replace('"mass"', '"mas"', 1), 'mas'),
    (lambda text: text.replace('"links"', '"link"', 1), 'link'),
    (lambda text: text[:-20], ''),
    (lambda text: text.replace("817500", "-", 1), ''),
    (lambda text: text.replace("817500", '"stiff"', 1), 'stiffness'),
    (lambda text: "", ''),
])
@pytest.mark.parametrize("words", [["check"], ["modes"], ["simulate", "--road", "sine"], ["frf"], ["export"]])
def test_a_wrong_model_says_where(change, message, words):
    pathlib.Path("bad.json").write_text(change(call("export", HALF).stdout))
    done = call(*words, "bad.json", expected=1)
    assert re.match(r"bad\.json:\d+:\d+: .", done.stderr) and message in done.stderr and done.stdout == ""
    piped = call(*words, "-", input=pathlib.Path("bad.json").read_text(), expected=1)
    assert re.match(r"<stdin>:\d+:\d+: .", piped.stderr)


def test_check_warns_of_what_does_nothing():
    truck = exported()
    truck["links"]["idle"] = {"from": "cab", "to": "frame"}
    truck["roads"]["spare"] = {"x": -6, "y": 0}
    for link in truck["links"].values():
        link.pop("damping", None)
    report = parsed("check", write("truck.json", truck))
    warnings = [row["warning"] for row in report["warnings"]]
    assert any("link idle has no force" in warning for warning in warnings)
    assert any("no link stands on the road input spare" in warning for warning in warnings)
    assert any("road input spare carries nothing" in warning for warning in warnings)
    assert sum("has no damping" in warning for warning in warnings) == 7
    call("check", "truck.json", "--strict", expected=1)
    call("check", HALF, "--strict")
    table = call("check", "truck.json", "--format", "csv").stdout
    assert [row["table"] for row in rows(table.split("\n\n")[-1])] == ["warnings"] * len(warnings)


def test_check_finds_weight_that_hangs_elsewhere():
    truck = exported()
    truck["links"]["crane"] = {"from": "ground", "to": "frame", "stiffness": 1e5}
    warnings = [row["warning"] for row in parsed("check", write("truck.json", truck))["warnings"]]
    assert any("links to the ground carry" in warning for warning in warnings)


def test_check_fails_where_nothing_carries_the_weight():
    truck = exported()
    for name, link in truck["links"].items():
        if name.endswith("_tire"):
            del link["stiffness"]
    done = call("check", write("truck.json", truck), expected=1)
    assert done.stdout == "" and done.stderr


def test_masses_count():
    truck = exported()
    truck["masses"] = {"engine": {"body": "frame", "mass": 1000, "point": [-0.5, 0, 0.5]}}
    before = parsed("check", HALF)["vehicles"][0]
    after = parsed("check", write("truck.json", truck))["vehicles"][0]
    assert after["mass"] - before["mass"] == pytest.approx(1000)
    assert after["on roads"] == pytest.approx(after["weight"], rel=1e-9)
    assert after["masses"] == 1


def ladder(longest):
    """A flexible frame on four tires."""
    frame = {"freedoms": ["z", "roll", "pitch"], "stations": [0, -2, -4, -6], "cross_members": [0, -2, -4, -6],
             "half_width": 0.4, "longest": longest, "rail": {"section": "rail"}, "member": {"section": "rail"}}
    last = 1 + 3 * round(2 / longest)
    wheels = [(x, y, f"ladder.{'left' if y > 0 else 'right'}.{1 if x == 0 else last}") for x in (0, -6) for y in (0.4, -0.4)]
    return {
        "truckride_model": 1, "name": "ladder",
        "materials": {"steel": {"young": 210e9, "shear": 80e9, "density": 7850}},
        "sections": {"rail": {"channel": {"height": 0.27, "width": 0.08, "web": 0.007, "flange": 0.007},
                              "material": "steel"}},
        "frames": {"ladder": frame},
        "roads": {f"r{k}": {"x": x, "y": y} for k, (x, y, _) in enumerate(wheels)},
        "links": {f"tire{k}": {"from": {"road": f"r{k}"}, "to": node, "point": [x, y, 0], "stiffness": 1e5, "damping": 1e3}
                  for k, (x, y, node) in enumerate(wheels)}}


def test_a_flexible_frame_weighs_what_its_beams_do():
    report = parsed("check", write("ladder.json", ladder(0.5)))
    vehicle = report["vehicles"][0]
    area = 0.27 * 0.08 - (0.27 - 2 * 0.007) * (0.08 - 0.007)
    assert vehicle["mass"] == pytest.approx(7850 * area * (2 * 6 + 4 * 0.8), rel=1e-9)
    assert vehicle["on roads"] == pytest.approx(vehicle["weight"], rel=1e-9)
    assert {row["kinetic energy"] for row in report["modes"]} == {"ladder 100 %"}
    assert "no sensor" in report["warnings"][0]["warning"]


def test_a_large_frame_has_its_lowest_modes_at_once():
    write("large.json", ladder(0.02))
    coarse = [row["frequency"] for row in parsed("modes", write("small.json", ladder(0.1)), "--undamped", "-n", "6")["modes"]]
    fine = [row["frequency"] for row in parsed("modes", "large.json", "--undamped", "-n", "6", timeout=20)["modes"]]
    assert fine == pytest.approx(coarse, rel=1e-3)


def test_a_file_does_not_command_the_terminal():
    model = exported()
    model["bodies"]["\x1b[31mseat\n"] = {"mass": 1}
    model["links"]["k"] = {"from": "ground", "to": "\x1b[31mseat\n", "stiffness": 1}
    text = call("check", write("escape.json", model), "--modes", "3").stdout
    assert "?[31mseat?" in text and "\x1b" not in text
    model["links"]["k"]["\x1b[2J"] = 1
    text = call("check", write("escape.json", model), expected=1).stderr
    assert "unknown key '?[2J'" in text and "\x1b" not in text


def test_a_pipe_is_no_model_file():
    os.mkfifo("pipe.json")
    assert "no regular file" in call("check", "pipe.json", expected=1).stderr
