# SPDX-License-Identifier: MIT
"""Help, version, exit codes, and what is said of wrong words."""
import re

import pytest

from conftest import HALF, QUARTER, TRUCK, call

SUBCOMMANDS = ["check", "modes", "simulate", "psd", "frf", "calibrate", "study", "export"]


def test_help_names_every_subcommand():
    for words in (["--help"], ["-h"], ["help"]):
        text = call(*words).stdout
        assert all(re.search(rf"(?m)^  {name} ", text) for name in SUBCOMMANDS)
        assert "Exit codes" in text and "130" in text


@pytest.mark.parametrize("name", SUBCOMMANDS)
def test_help_of_a_subcommand_is_one_text(name):
    text = call(name, "--help").stdout
    assert text == call("help", name).stdout == call(name, "-h").stdout
    assert text.startswith(f"Usage: truckride {name} ") and "Examples:" in text
    assert text.count(f"  truckride {name} ") >= 2
    assert max(map(len, text.splitlines())) <= 100


def test_examples_with_ready_made_vehicles_are_valid():
    """Options of the examples exist: the parser takes them, and help shows."""
    for name in SUBCOMMANDS:
        text = call("help", name).stdout.split("Examples:")[1].replace("\\\n", " ")
        for line in re.findall(rf"truckride {name} ([^|\n]*)", text):
            words = [word.strip("'") for word in line.split() if not word.startswith("@")]
            assert call(name, *words, "--help").stdout.startswith("Usage:"), line


def test_manual_has_every_option():
    page = call("help", "--manual").stdout
    assert page.startswith(".TH TRUCKRIDE 1")
    for name in SUBCOMMANDS:
        for option in re.findall(r"(?m)^  (?:-., )?--([a-z]+)", call("help", name).stdout):
            assert f"\\-\\-{option}\\fR" in page


def test_version():
    assert re.match(r"truckride \d+\.\d+\.\d+, with", call("--version").stdout)


@pytest.mark.parametrize("words, message", [
    ([], "Usage: truckride SUBCOMMAND"),
    (["simulat"], "did you mean 'simulate'?"),
    (["--nonsense"], "there is no option '--nonsense'"),
    (["help", "mode"], "did you mean 'modes'?"),
    (["help", "modes", "psd"], "one subcommand at a time"),
    (["modes"], "MODEL is missing"),
    (["modes", QUARTER, "more"], "unexpected word 'more'"),
    (["modes", "--cout", "3", QUARTER], "did you mean '--count'?"),
    (["modes", "--zzz", QUARTER], "unknown option '--zzz'"),
    (["modes", "--count"], "--count expects a value behind it"),
    (["modes", "--count", "few", QUARTER], "--count expects a whole number"),
    (["modes", "--count=-1", QUARTER], "--count expects a whole number from 0"),
    (["modes", "--shapes=yes", QUARTER], "--shapes expects no value"),
    (["modes", "--format", "xml", QUARTER], "--format expects table|csv|json"),
    (["modes", "builtin:refrence_truck"], "did you mean 'reference_truck'?"),
    (["modes", "builtin:reference_truck:lienar"], "did you mean 'linear'?"),
    (["modes", "builtin:"], "there is no ready-made vehicle ''"),
    (["simulate", TRUCK], "--road is missing"),
    (["simulate", TRUCK, "--road", "sea"], "there is no kind of road 'sea'"),
    (["simulate", TRUCK, "--road", "swep"], "did you mean 'sweep'?"),
    (["simulate", TRUCK, "--road", "iso:class=K"], "'class' of a road expects a number, not 'K'"),
    (["simulate", TRUCK, "--road", "iso:class=9"], "a letter from A to H"),
    (["simulate", TRUCK, "--road", "iso:speed=0"], "above 0 km/h"),
    (["simulate", TRUCK, "--road", "iso:seed=1.5"], "a whole number"),
    (["simulate", TRUCK, "--road", "sine:frequenzy=2"], "did you mean 'frequency'?"),
    (["simulate", TRUCK, "--road", "csv"], "needs a file: csv:FILE"),
    (["simulate", TRUCK, "--road", "crg:"], "needs a file: crg:FILE"),
    (["simulate", TRUCK, "--road", "sine", "--duration", "nan"], "--duration expects a number"),
    (["simulate", TRUCK, "--road", "sine", "--duration", "0.1", "--sensors", "cab_front_left_zz"],
     "did you mean 'cab_front_left_z'?"),
    (["simulate", TRUCK, "--road", "sine", "--plot", "x.gif"], "ends in .png, .svg or .pdf"),
    (["psd", TRUCK, "--road", "sine", "--from", "5", "--to", "2"], "no band"),
    (["psd", TRUCK, "--road", "sine", "--weighting", "Wx"], "--weighting expects Wk|Wd"),
    (["frf", HALF, "--road", "frnt"], "did you mean 'front'?"),
    (["frf", HALF, "--sensor", "nowhere"], "no sensor is called 'nowhere'"),
    (["frf", HALF, "--points", "1"], "--points expects 2"),
    (["frf", HALF, "--from", "3", "--to", "1"], "no band of frequencies"),
    (["calibrate", HALF], "--target is missing"),
    (["calibrate", HALF, "--target", "cab.z=1"], "--parameter is missing"),
    (["calibrate", HALF, "--target", "cab.z", "-p", "*_tire:stiffness:1..2"], "a target is COORDINATE=HZ"),
    (["calibrate", HALF, "--target", "cab.z=1:wait=2", "-p", "*_tire:stiffness:1..2"], "a target is"),
    (["calibrate", HALF, "--target", "cab.z=1", "-p", "*_tire:stiffnes:1..2"], "did you mean 'stiffness'?"),
    (["calibrate", HALF, "--target", "cab.z=1", "-p", "*_tire:stiffness"], "a parameter is PATTERN"),
    (["study", "--output", "a=rms:x", "--vry", "b"], "did you mean '--vary'?"),
])
def test_wrong_usage_is_code_2(words, message):
    done = call(*words, expected=2)
    assert message in done.stderr and done.stdout == ""
    assert "--help" in done.stderr or "help explains" in done.stderr


@pytest.mark.parametrize("words, message", [
    (["modes", "missing.json"], "missing.json"),
    (["simulate", HALF, "--road", "csv:missing.csv"], "missing.csv"),
    (["simulate", HALF, "--road", "sine", "--step", "-1"], "step"),
    (["simulate", HALF, "--road", "sine", "-o", "no/folder.csv"], "no/folder.csv: cannot be written"),
    (["simulate", HALF, "--road", "sine", "--plot", "no/folder.png"], "no/folder.png: cannot be written"),
    (["simulate", HALF, "--road", "sine", "-o", "."], "cannot be written"),
    (["psd", "missing.csv"], "missing.csv"),
    (["calibrate", HALF, "--target", "cabin.z=1", "-p", "*_tire:stiffness:1..2"], "cabin.z"),
    (["calibrate", HALF, "--target", "cab.z=1", "-p", "*_tyre:stiffness:1..2"], "_tyre"),
    (["study", "missing.json", "--output", "a=rms:x"], "missing.json"),
])
def test_failure_is_code_1_and_leaves_nothing(folder, words, message):
    done = call(*words, expected=1)
    assert message in done.stderr and done.stdout == ""
    assert list(folder.iterdir()) == []


def test_options_may_stand_anywhere():
    wanted = call("modes", QUARTER, "--count", "1", "--format", "csv").stdout
    for words in (["--count=1", "-fcsv", QUARTER], ["-n", "1", "-f", "csv", "--", QUARTER],
                  ["-n1", QUARTER, "--format=csv"]):
        assert call("modes", *words).stdout == wanted
