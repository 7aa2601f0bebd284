# SPDX-License-Identifier: MIT
"""Failures are exceptions with a status and a sentence; nothing crashes."""
import numpy as np
import pytest

import truckride as tr


@pytest.mark.parametrize("kind, words, call", [
    (tr.RangeError, "increas", lambda: tr.Curve([1, 0], [0, 1], "front damper")),
    (tr.ArgumentError, "2 x but 3 y", lambda: tr.Curve([0, 1], [0, 1, 2])),
    (tr.ArgumentError, "one dimension", lambda: tr.Curve([[0, 1]], [[0, 1]])),
    (tr.ArgumentError, "none of pchip", lambda: tr.Curve([0, 1], [0, 1], interpolation="cubic")),
    (tr.ArgumentError, "none of front, rear", lambda: tr.axle_quarter("middle")),
    (tr.ArgumentError, "Vehicle", lambda: tr.vehicle("bus")),
    (tr.ArgumentError, "there is no 77", lambda: tr.vehicle(77)),
    (tr.ModelError, "", lambda: tr.Spec("empty").compile()),
    (tr.UnknownNameError, "no body 'cab'", lambda: tr.Spec("empty").body("cab")),
    (tr.ArgumentError, "body 5", lambda: tr.Spec("empty").body(5)),
    (tr.RangeError, "", lambda: tr.quarter_car(sprung_mass=-1.0)),
    (tr.RangeError, "", lambda: tr.Signal.step(1, -1)),
    (tr.ArgumentError, "3 values", lambda: tr.Spec("s").add_body("b", mass=1, cg=(0, 0))),
    (tr.ArgumentError, "4 values", lambda: tr.truck(cab_vertical_damping=(1.0, 2.0))),
    (tr.ArgumentError, "TruckParameters.cab_mass", lambda: tr.truck(cab_mass="heavy")),
    (tr.ArgumentError, "NUL", lambda: tr.Spec("a\0b")),
    (tr.RangeError, "100", lambda: tr.psd(np.ones(10), 1.0, segment_length=100)),
    (tr.ArgumentError, "x has 10", lambda: tr.csd(np.ones(10), np.ones(9), 1.0)),
    (tr.RangeError, "finite", lambda: tr.psd([1.0, np.nan], 1.0)),
    (tr.FileError, "nowhere", lambda: tr.Series({"a": [1]}, 1).write_csv("/nowhere/a.csv")),
    (tr.ArgumentError, "one length", lambda: tr.Series({"a": [1], "b": [1, 2]}, 1)),
    (tr.UnknownNameError, "there are a", lambda: tr.Series({"a": [1]}, 1)["b"]),
    (tr.ArgumentError, "at least one", lambda: tr.run_batch([], tr.sweep())),
    (tr.RangeError, "", lambda: tr.roughness.iri([0.0, 0.0], 5.0)),
])
def test_sentences(kind, words, call):
    with pytest.raises(kind) as caught:
        call()
    error = caught.value
    assert isinstance(error, tr.TruckrideError) and error.status == kind.status
    assert words in error.message and str(error) == error.message and error.message


def test_wrong_keywords_name_the_fields():
    with pytest.raises(TypeError, match="sprung_mass"):
        tr.quarter_car(spring_mass=3)
    with pytest.raises(TypeError, match="Signal.step"):
        tr.Signal()
    with pytest.raises(TypeError, match="a name is expected"):
        tr.Spec(3)


def test_errors_are_also_pythons_own(model):
    with pytest.raises(ValueError):
        tr.Newmark(model, step=-1.0)
    with pytest.raises(LookupError):
        model.find(tr.Part.SENSOR, "nothing")
    with pytest.raises(OSError):
        tr.Series({"a": [1]}, 1).write_csv("/nowhere/a.csv")
    with pytest.raises(IndexError):
        model.modes()[99]


def test_stepper_reports_and_stays_usable(model):
    stepper = tr.Newmark(model)
    stepper.height[:] = np.nan
    with pytest.raises(tr.RangeError):
        stepper.step()
    stepper.height = 0.0
    stepper.step()
    assert stepper.time == pytest.approx(0.001)


def test_buffers_cannot_be_replaced(model):
    stepper = tr.Newmark(model)
    buffer = stepper.height
    stepper.height = [0.01, 0.02]
    assert stepper.height is buffer and buffer.tolist() == [0.01, 0.02]
    with pytest.raises(ValueError):
        stepper.height = [1, 2, 3]


def test_progress_cancels_and_raises(model, excitation):
    seen = []
    tr.simulate(model, excitation, 1.0, progress=seen.append)
    assert seen == sorted(seen) and 0 <= seen[0] and seen[-1] == 1 and len(seen) > 3
    with pytest.raises(tr.CancelledError):
        tr.simulate(model, excitation, 1.0, progress=lambda fraction: fraction > 0.3)
    for kind in (KeyboardInterrupt, ZeroDivisionError):
        def raise_it(fraction):
            raise kind
        with pytest.raises(kind):
            tr.simulate(model, excitation, 1.0, progress=raise_it)


def test_ctrl_c_ends_a_run(model, excitation):
    import signal
    import threading
    timer = threading.Timer(0.1, signal.raise_signal, [signal.SIGINT])
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        tr.simulate(model, excitation, 4000.0, record_every=1000)
    timer.join()


def test_bar_in_a_terminal(model, excitation, monkeypatch, capsys):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    tr.simulate(model, excitation, 1.0, progress=True)
    shown = capsys.readouterr().err
    assert "simulate" in shown and "100%" in shown and shown.endswith("\n")
    monkeypatch.setattr("sys.stderr.isatty", lambda: False, raising=False)
    tr.simulate(model, excitation, 1.0, progress=True)
    assert capsys.readouterr().err == ""


def test_calibration_out_of_reach_carries_its_answer():
    calibration = tr.Calibration(tr.vehicle("reference_half"))
    calibration.add_parameter("tire", "front_tire", upper=1.1)
    calibration.target_frequency("axle", 13.8, "front_axle.z")
    with pytest.raises(tr.TargetError, match="axle") as caught:
        calibration.solve()
    solution = caught.value.solution
    assert solution.parameters["tire"].at_bound == 1 and not solution.targets["axle"].met
    assert calibration.solve(must_succeed=False).status == tr.Status.TARGET
    with pytest.raises(tr.UnknownNameError):
        calibration.act_on("nothing", "rear_tire")


def test_batch_tells_which_variant_failed(excitation):
    models = [tr.half_truck().compile(), tr.vehicle("reference_truck").compile()]
    with pytest.raises(tr.ArgumentError, match="variant"):
        tr.run_batch(models, excitation, 0.1)


def test_notes_go_to_logging(caplog):
    tr.Curve([0, 1, 2, 3], [0, 1, 1.01, 5], "kinked", interpolation="not_a_knot")
    assert "kinked" in caplog.text and caplog.records[0].name == "truckride"
