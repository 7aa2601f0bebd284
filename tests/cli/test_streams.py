# SPDX-License-Identifier: MIT
"""Standard streams, terminals, signals, full disks, plots."""
import json
import os
import pathlib
import pty
import select
import shutil
import signal
import stat
import struct
import subprocess
import time

import pytest

from conftest import COMMAND, HALF, QUARTER, TRUCK, call, environment, rows

RUN = ["simulate", QUARTER, "--road", "sine", "--duration", "0.5"]
LONG = ["simulate", TRUCK, "--road", "iso:class=C", "--duration", "3000", "--every", "100000"]
needs_gnuplot = pytest.mark.skipif(not shutil.which("gnuplot"), reason="gnuplot is not installed")


def on_terminal(*words, seconds=60, interrupt=None, stdout=None, **variables):
    """Exit code and what a terminal shows; Ctrl-C after some seconds."""
    master, slave = pty.openpty()
    process = subprocess.Popen([COMMAND, *words], stdin=slave, stdout=stdout or slave, stderr=slave,
                               env=environment(TERM="xterm", **variables), close_fds=True)
    os.close(slave)
    shown, begin = b"", time.monotonic()
    while time.monotonic() < begin + seconds:
        if interrupt and time.monotonic() > begin + interrupt:
            process.send_signal(signal.SIGINT)
            interrupt = None
        if select.select([master], [], [], 0.1)[0]:
            try:
                piece = os.read(master, 65536)
            except OSError:  # the other end is closed
                break
            if not piece:
                break
            shown += piece
    os.close(master)
    return process.wait(timeout=30), shown.decode()


@pytest.mark.parametrize("words", [RUN, ["modes", TRUCK], ["modes", "--help"], ["frf", HALF],
                                   [*RUN, "--format", "json"], ["study", QUARTER, "--output", "a=rms:sprung_z",
                                    "--vary", "t=stiffness:tire:0.8..1.2", "--cases", "2", "--duration", "1", "-q"]])
def test_a_full_disk_is_said(words):
    with open("/dev/full", "w") as full:
        done = subprocess.run([COMMAND, *words], stdout=full, stderr=subprocess.PIPE, text=True, env=environment())
    assert done.returncode == 1 and "standard output" in done.stderr and "cannot be written" in done.stderr


@pytest.mark.parametrize("words", [RUN, ["modes", TRUCK], [*RUN, "--format", "json"]])
def test_a_device_stays_where_it_is(words):
    done = call(*words, "-o", "/dev/full", expected=1)
    assert "/dev/full" in done.stderr and stat.S_ISCHR(os.stat("/dev/full").st_mode)


def test_a_reader_that_leaves_ends_the_command_quietly():
    script = f"'{COMMAND}' simulate {TRUCK} --road sine --duration 5 | head -n 1; echo ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", script], capture_output=True, text=True, env=environment())
    assert done.stdout.startswith("time [s],") and done.stdout.split()[-1] in ("141", "1")
    assert done.stderr == "" or "Broken pipe" in done.stderr


def test_standard_output_is_appended_to_not_replaced(folder):
    pathlib.Path("log").write_text("before\n")
    for words in (RUN, ["modes", QUARTER]):
        with open("log", "a") as log:
            call(*words, stdout=log)
    text = pathlib.Path("log").read_text()
    assert text.startswith("before\ntime [s],") and "unsprung.z" in text


def test_simulate_feeds_psd():
    script = f"'{COMMAND}' simulate {HALF} --road sweep --duration 5 -o - | '{COMMAND}' psd - --rms -f csv"
    done = subprocess.run(["bash", "-euo", "pipefail", "-c", script], capture_output=True, text=True, check=True)
    assert len(rows(done.stdout)) > 3


def test_no_temporary_file_stays(folder):
    room = folder / "room"
    room.mkdir()
    call(*RUN, environment={"TMPDIR": str(room)})
    assert list(room.iterdir()) == []
    call(*RUN, environment={"TMPDIR": "/no/such/folder"}, expected=1)


def test_colour_only_on_a_terminal():
    assert "\033" not in call("modes", QUARTER).stdout
    assert "\033[1m" in on_terminal("modes", QUARTER)[1]
    assert "\033" not in on_terminal("modes", QUARTER, NO_COLOR="1")[1]
    code, shown = on_terminal("modes", "missing.json")
    assert code == 1 and "\033[31m" in shown
    assert "\033" not in call("modes", "missing.json", expected=1).stderr


def test_progress_on_a_terminal_only():
    words = ["simulate", TRUCK, "--road", "iso:class=C", "--duration", "400", "--every", "1000"]
    with open("run.csv", "w") as table:
        code, shown = on_terminal(*words, stdout=table)
    quick = "[" not in shown  # a machine that needs less than a second
    assert code == 0 and (quick or ("%" in shown and shown.endswith("\r\033[K")))
    with open("run.csv", "w") as table:
        assert on_terminal(*words, "--quiet", stdout=table) == (0, "")
    assert call(*words).stderr == ""


@pytest.mark.parametrize("words", [
    LONG,
    ["psd", *LONG[1:]],
    ["study", TRUCK, "--road", "sweep", "--duration", "200", "--cases", "2000", "--chunk", "1", "--vary",
     "t=stiffness:*_tire:0.8..1.2", "--output", "a=rms:cab_front_left_z", "-o", "study.csv"],
    ["calibrate", TRUCK, "--target", "peak:front_axle_left_z:5..15=13", "--parameter", "front_*_tire:stiffness:1..8"],
])
def test_interrupted_is_code_130(words):
    process = subprocess.Popen([COMMAND, *words], env=environment(), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    time.sleep(0.7)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 130, err
    assert out == b""


def test_numbers_do_not_follow_the_locale():
    locales = subprocess.run(["locale", "-a"], capture_output=True, text=True).stdout.split()
    comma = next((name for name in locales if name.startswith(("de_DE", "sv_SE", "fr_FR"))), "de_DE.UTF-8")
    for words in ([*RUN, "--step", "0.002"], ["modes", TRUCK, "-f", "json"], ["frf", HALF, "--from", "0.5"]):
        assert call(*words, environment={"LC_ALL": comma}).stdout == call(*words, environment={"LC_ALL": "C"}).stdout


PLOTS = {"simulate": RUN, "psd": ["psd", HALF, "--road", "sweep", "--duration", "5", "--to", "30"], "frf": ["frf", HALF]}


@needs_gnuplot
@pytest.mark.parametrize("name", PLOTS)
@pytest.mark.parametrize("suffix, begin", [("png", b"\x89PNG\r\n\x1a\n"), ("svg", b"<?xml"), ("pdf", b"%PDF-")])
def test_plots(name, suffix, begin):
    call(*PLOTS[name], "--plot", f"out.{suffix}", "-o", "out.csv")
    image = pathlib.Path(f"out.{suffix}").read_bytes()
    assert image.startswith(begin) and len(image) > 4000
    if suffix == "png":
        width, height = struct.unpack(">II", image[16:24])
        assert width == 1000 and height >= 500
    if suffix == "svg":
        assert image.count(b"<path") > 4 and b"frequency [Hz]" in image or b"time [s]" in image


@needs_gnuplot
@pytest.mark.parametrize("name", ["|touch injected #.png", "`touch injected`.png", "$(touch injected).png",
                                  "it's; \"quoted\".png", "-d.png"])
def test_names_of_plots_are_only_names(folder, name):
    call(*RUN, f"--plot={name}", "-o", "out.csv")
    assert pathlib.Path(name).read_bytes().startswith(b"\x89PNG")
    assert sorted(path.name for path in folder.iterdir()) == sorted([name, "out.csv"])


@needs_gnuplot
def test_labels_of_plots_are_only_text(folder):
    label = "a'; system('touch injected'); `touch injected` $(touch injected) _{x} ^2"
    pathlib.Path("run.csv").write_text(f'time [s],"{label}"\n' + "".join(f"{k / 10},{k % 3}\n" for k in range(50)))
    call("psd", "run.csv", "--plot", "run.svg", "-o", "out.csv")
    assert not os.path.exists("injected")
    assert b"touch injected" in pathlib.Path("run.svg").read_bytes()


def test_without_gnuplot_it_says_so(folder):
    done = call(*RUN, "--plot", "x.png", "-o", "out.csv", environment={"PATH": "/nowhere"}, expected=1)
    assert "gnuplot" in done.stderr and "not installed" in done.stderr
    assert not os.path.exists("x.png")


def test_a_gnuplot_that_fails_leaves_no_plot(folder):
    fake = folder / "bin" / "gnuplot"
    fake.parent.mkdir()
    fake.write_text("#!/bin/sh\nexit 3\n")
    fake.chmod(0o755)
    done = call(*RUN, "--plot", "x.png", "-o", "out.csv", environment={"PATH": f"{fake.parent}:{os.environ['PATH']}"},
                expected=1)
    assert "failed to draw" in done.stderr and not os.path.exists("x.png")


def test_json_of_strange_names():
    pathlib.Path("run.csv").write_text('time [s],"say ""a\\b"" [N]"\n' + "".join(f"{k},{k % 3}\n" for k in range(9)))
    done = call("psd", "run.csv", "--rms", "--format", "json")
    assert json.loads(done.stdout)["rms"][0]["channel"].startswith('say "a\\b"')
    assert rows(call("psd", "run.csv", "--rms", "--format", "csv").stdout)[0]["channel"].startswith('say "a\\b"')


@pytest.mark.parametrize("words", [["--sensors", "cab_front_left_zz"], ["--plot", "run.gif"], ["-o", "no/run.csv"],
                                   ["--plot", "no/run.png"]])
def test_what_would_fail_behind_a_long_run_fails_before_it(words):
    begin = time.monotonic()
    assert subprocess.run([COMMAND, *LONG, *words], capture_output=True, env=environment()).returncode in (1, 2)
    assert time.monotonic() < begin + 2
