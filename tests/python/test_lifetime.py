# SPDX-License-Identifier: MIT
"""Objects, views and running calls keep alive what they need; closed objects raise."""
import gc
import pickle
import threading
import weakref

import numpy as np
import pytest

import truckride as tr
from test_hostile import SURFACE
from truckride import _native


def everything(model, excitation):
    spec = tr.quarter_car()
    return [spec, model, excitation, tr.Curve([0, 1], [0, 1]), tr.sweep(duration=1),
            tr.Series({"a": [1, 2]}, 10), tr.Newmark(model), tr.RungeKutta(model), model.modes(),
            tr.Calibration(spec), tr.Study(spec), tr.comfort.WeightingFilter("wk", 500),
            tr.comfort.VibrationMeter(500), tr.Surface(SURFACE),
            tr.Law("seal", sliding=100), model.modes(count=2)]


def test_closed_objects_raise(model, excitation):
    for item in everything(model, excitation):
        with item:
            assert not item.closed
        item.close()
        assert item.closed and repr(item)
        with pytest.raises(tr.ClosedError, match="closed"):
            item._live()
    with pytest.raises(tr.ClosedError):
        len(model.modes())


def test_closing_in_any_order_pulls_nothing_away(model):
    sine = tr.Signal.sine(0.01, 2)
    excitation = tr.Excitation(model, sine)
    stepper, modes = tr.Newmark(model), model.modes()
    sine.close(), model.close()
    gc.collect()
    assert np.isfinite(excitation.evaluate(10, 0.1).height).all()
    stepper.step()
    assert modes.frequencies[0] > 0


def test_views_keep_their_owner():
    series = tr.Series({"a": np.arange(5.0)}, 10)
    view, handle = series["a"].values, weakref.ref(series._handle)
    series.close()
    del series
    gc.collect()
    assert handle() is not None and view.tolist() == [0, 1, 2, 3, 4]
    del view
    gc.collect()
    assert handle() is None


def test_views_are_not_copies():
    series = tr.Series({"a": np.zeros(3)}, 10)
    series["a"].values[1] = 7
    assert series["a"][1] == 7
    curve = tr.Curve([0, 1], [0, 2])
    with pytest.raises(ValueError):
        curve.y[0] = 1
    samples = np.arange(4.0)
    assert _native.vector(samples, "x") is samples


def test_contexts_are_freed(monkeypatch):
    freed, destroy = [], _native.quick.trk_context_destroy

    def spy(context):
        freed.append(_native.quick.trk_context_blocks(context))
        destroy(context)
    monkeypatch.setattr(_native.quick, "trk_context_destroy", spy)
    curve = tr.Curve([0, 1], [0, 1])
    assert curve.memory_blocks > 0
    with pytest.raises(tr.RangeError):
        tr.Curve([1, 0], [0, 1])
    del curve
    gc.collect()
    assert freed == [0, 0]  # the one that failed, the one that lived; nothing left in either


def test_stepper_refuses_a_callback_that_uses_it(model):
    calibration = tr.Calibration(tr.vehicle("reference_half"))
    calibration.add_parameter("tire", "front_tire")
    calibration.target_frequency("axle", 9, "front_axle.z")
    seen = []

    def inside(fraction):
        with pytest.raises(tr.BusyError):
            calibration.solve()
        with pytest.raises(tr.BusyError):
            calibration.close()
        seen.append(fraction)
    calibration.solve(progress=inside)
    assert seen


def test_threads_share_a_model(truck):
    results = {}

    def work(number):
        sine = tr.Signal.sine(0.001 * number, 1.3)
        results[number] = tr.simulate(truck, sine, 1.0)["cab_front_left_z"].values.copy()
    threads = [threading.Thread(target=work, args=(k,)) for k in range(1, 5)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    for number, values in results.items():
        again = tr.simulate(truck, tr.Signal.sine(0.001 * number, 1.3), 1.0)
        assert np.array_equal(values, again["cab_front_left_z"].values)


def test_errors_of_threads_do_not_mix():
    wrong = []

    def work(number):
        for _ in range(50):
            try:
                tr.psd(np.ones(10), 1.0, segment_length=100 + number)
            except tr.RangeError as error:
                if str(100 + number) not in error.message:
                    wrong.append(error.message)
    threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    assert not wrong


def test_gil_is_released_during_a_run(truck):
    """Python goes on while another thread is inside the library."""
    started, ticks = threading.Event(), []

    def run():
        started.set()
        tr.simulate(truck, tr.sweep(), 200.0, record_every=100)
    thread = threading.Thread(target=run)
    thread.start()
    started.wait()
    while thread.is_alive():
        ticks.append(len(ticks))
    assert len(ticks) > 1000


def test_specs_models_and_inputs_are_picklable(truck):
    for spec in (tr.quarter_car(sprung_mass=4321.0), tr.vehicle("reference_truck", "nonlinear")):
        again = pickle.loads(pickle.dumps(spec))
        assert again.describe() == spec.describe()
    again = pickle.loads(pickle.dumps(truck))
    assert np.array_equal(again.mass, truck.mass)
    excitation = tr.Excitation(truck).add_motion(tr.sweep(duration=3), "left", 0.5)
    copy = pickle.loads(pickle.dumps(excitation))
    assert np.array_equal(copy.evaluate(50, 0.05).height, excitation.evaluate(50, 0.05).height)
    run = tr.simulate(truck, excitation, 0.5)
    copy = pickle.loads(pickle.dumps(run))
    assert list(copy) == list(run) and copy.units == run.units
    assert np.array_equal(copy["cab_front_left_z"], run["cab_front_left_z"])
    for item in (tr.TruckParameters(), tr.RangeError("x"), tr.Curve.builtin("reference_bump_stop")):
        copy = pickle.loads(pickle.dumps(item))
        assert type(copy) is type(item) and str(copy) == str(item)
