# SPDX-License-Identifier: MIT
"""Laws: traces against closed forms, parameters there and back, in a vehicle, in a pickle."""
import pickle

import numpy as np
import pytest

import truckride as tr

PATH = 0.01 * np.sin(np.linspace(0, 9, 4001))
STEP = 0.001


def laws():
    """One of each kind."""
    rubber = tr.Curve([0, 0.01, 0.02], [0, 2000, 9000], "rubber")
    return [tr.Law("tire", stiffness=1e6, stiffening=2e6, damping=500, preload=30e3),
            tr.Law("stops", "bump stop", bump_clearance=0.005, bump_curve=rubber,
                   rebound_clearance=0.008, rebound_stiffness=1e6),
            tr.Law("leaf", friction=2500, friction_slope=5000, approach_bump=0.002,
                   approach_rebound=0.003),
            tr.Law(tr.LawKind.FRICTION, friction=800, stiffness=4e6),
            tr.Law("air_spring", pressure=6e5, volume=0.012, area=0.045, area_slope=-0.05,
                   auxiliary_volume=0.01, conductance=2e-8),
            tr.Law("seal", settings=tr.SealOptions(sliding=150, breakaway=250))]


def test_tire_lifts_off():
    law = tr.Law("tire", stiffness=1e6, preload=5000)
    assert law.trace(PATH).force == pytest.approx(-np.maximum(5000 - 1e6 * PATH, 0), abs=1e-6)
    damped = tr.Law("tire", stiffness=1e6, damping=2e4, preload=5000)
    rate = np.diff(PATH) / STEP
    spring = np.maximum(5000 - 1e6 * PATH, 0)[1:]
    expected = -(spring - np.clip(2e4 * rate, -spring, spring))
    assert damped.trace(PATH, STEP).force[1:] == pytest.approx(expected, abs=1e-6)


def test_stops_are_their_curves():
    law = laws()[1]
    rubber = law.parameters.bump_curve
    bump = np.maximum(-PATH - 0.005, 0)
    rebound = np.maximum(PATH - 0.008, 0)
    trace = law.trace(PATH)
    assert trace.force == pytest.approx(1e6 * rebound - rubber(bump), abs=1e-8)
    assert np.abs(trace.lost).max() < 1e-6  # elastic


def test_leaf_goes_round_its_loop():
    """A settled cycle of amplitude A runs between -+R tanh(A / beta) and loses
    4 R (A - beta tanh(A / beta)), LAW.12."""
    friction, beta, amplitude = 2500.0, 0.002, 0.003
    law = tr.Law("leaf", friction=friction, approach_bump=beta)
    assert law.parameters.approach_rebound == beta
    path = amplitude * np.sin(2 * np.pi * np.arange(20 * 400 + 1) / 400)
    trace = law.trace(path)
    reach = np.tanh(amplitude / beta)
    assert trace.force[-400:].max() == pytest.approx(friction * reach, rel=1e-6)
    assert trace.force[-400:].min() == pytest.approx(-friction * reach, rel=1e-6)
    assert trace.lost[-1] - trace.lost[-401] == pytest.approx(
        4 * friction * (amplitude - beta * reach), rel=1e-5)
    first = law.trace(np.linspace(0, 0.01, 50))
    assert first.force == pytest.approx(
        friction * (1 - np.exp(-np.linspace(0, 0.01, 50) / beta)), rel=1e-9)


def test_friction_sticks_and_slides():
    trace = tr.Law("friction", friction=800, stiffness=4e6).trace(PATH)
    expected, force = np.zeros(len(PATH)), 0.0
    for k, change in enumerate(np.diff(PATH), 1):
        expected[k] = force = np.clip(force + 4e6 * change, -800, 800)
    assert trace.force == pytest.approx(expected, abs=1e-6)
    lost = np.abs(800 * np.diff(PATH - expected / 4e6)).cumsum()
    assert trace.lost[-1] == pytest.approx(lost[-1], rel=1e-6)


def test_air_spring_and_seal():
    air = tr.Law("air_spring", pressure=6e5, volume=0.012, area=0.045, area_slope=-0.05)
    volume = 0.012 + 0.045 * PATH - 0.025 * PATH ** 2
    expected = -(6e5 * (0.012 / volume) ** 1.38 - 101325) * (0.045 - 0.05 * PATH)
    assert air.trace(PATH).force == pytest.approx(expected, rel=1e-12)
    open_throttle = tr.Law("air_spring", pressure=6e5, volume=0.012, area=0.045,
                           auxiliary_volume=0.02, conductance=1e-3)
    slow = open_throttle.trace(PATH, 10.0).force  # s: all air has one pressure
    both = -(6e5 * (0.032 / (0.032 + 0.045 * PATH)) ** 1.38 - 101325) * 0.045
    assert slow == pytest.approx(both, rel=1e-4)
    with pytest.raises(tr.RangeError, match="point 2"):
        air.trace([0, -0.5])
    seal = tr.Law("seal", sliding=150, breakaway=250, stribeck=0.1, creep=0.001)
    rate = np.diff(PATH) / STEP
    trace = seal.trace(PATH, STEP)
    assert trace.force[1:] == pytest.approx(
        (150 + 100 * np.exp(-(rate / 0.1) ** 2)) * np.tanh(rate / 0.001), rel=1e-6, abs=1e-6)
    assert trace.lost[-1] == pytest.approx((trace.force[1:] * np.diff(PATH)).sum(), rel=1e-6)


@pytest.mark.parametrize("law", laws(), ids=lambda law: law.name)
def test_parameters_there_and_back(law):
    again = tr.Law(law.kind, law.name, law.parameters)
    twin = pickle.loads(pickle.dumps(law))
    assert again == law == twin and hash(again) == hash(law) and law.name in repr(law)
    assert np.array_equal(twin.trace(PATH).force, law.trace(PATH).force)
    assert law != laws()[(law.kind.value + 1) % 6] and law != 3
    assert law.trace(PATH).lost[-1] >= -1e-9


@pytest.mark.parametrize("law", laws(), ids=lambda law: law.name)
def test_a_link_keeps_its_law(law):
    spec = tr.vehicle("reference_half")
    spec.update_link("front_spring", law=law)
    assert spec.link("front_spring").law == law and spec.link("rear_spring").law is None
    for twin in (spec.copy(), pickle.loads(pickle.dumps(spec))):
        assert twin.describe() == spec.describe()
        assert twin.link("front_spring").law.parameters == law.parameters
    spec.update_link("front_spring", law=None)
    assert spec.link("front_spring").law is None


def test_leaf_sticks_in_small_motion():
    """At rest a leaf spring adds R / beta to the stiffness; a run loses energy."""
    spec = tr.quarter_car()
    plain = spec.compile()
    name = next(name for name in plain.links if "tire" not in name and "damper" not in name)
    spec.update_link(name, law=tr.Law("leaf", friction=2500, approach_bump=0.002))
    model = spec.compile()
    b = model.link_row(name)[0]
    assert model.tangent().stiffness - plain.tangent().stiffness == pytest.approx(
        2500 / 0.002 * np.outer(b, b))
    spec.vary(name, "friction", 2.0)
    spec.vary(name, "approach", 0.001, meaning="value")
    assert spec.link(name).law.parameters.friction == 5000
    assert spec.link(name).law.parameters.approach_bump == 0.001
    run = tr.simulate(model, tr.Signal.sine(0.01, 2.0), 2.0)
    assert all(np.isfinite(run[sensor].values).all() for sensor in run)


def test_laws_in_batches_studies_and_calibrations():
    spec = tr.vehicle("reference_half")
    for link in ("front_spring", "rear_spring"):
        spec.update_link(link, law=tr.Law("leaf", friction=2500, approach_bump=0.002))
    models = []
    for factor in (0.5, 1.0):
        varied = spec.copy()
        assert varied.vary("*_spring", "friction", factor) == 2
        models.append(varied.compile())
    sine = tr.Signal.sine(0.005, 1.5)
    batch = tr.run_batch(models, sine, 1.0, sensors=["cab_front_z"])
    for model, values in zip(models, batch["cab_front_z"]):
        single = tr.simulate(model, sine, 1.0)["cab_front_z"].values
        assert values == pytest.approx(single, abs=1e-9 * np.abs(single).max())
    study = tr.Study(spec, points=3, duration=0.5)
    study.add_parameter("leaves", "*_spring", tr.Field.FRICTION, lower=0.5, upper=2.0)
    study.add_parameter("approach", "*_spring", "approach", lower=0.5, upper=2.0)
    study.add_output("cab", "cab_front_z")
    study.add_excitation("sine", tr.Excitation(models[0], sine))
    study.run()
    assert set(study.table().status) == {tr.Status.OK}
    calibration = tr.Calibration(spec)
    calibration.add_parameter("friction", "*_spring", "friction")
    calibration.target_frequency("axle", 11, "front_axle.z", damped=False)
    stiff, soft = (calibration.evaluate([factor]).values[0] for factor in (1.0, 0.5))
    assert stiff != soft  # leaves that stick are a spring


def test_equivalent_of_a_leaf():
    """Stuck in small motion; in large motion damping is what the loop loses, LINEAR.23."""
    law = tr.Law("leaf", friction=2500, approach_bump=0.002)
    assert law.equivalent(1e-7, 1.0).stiffness == pytest.approx(2500 / 0.002, rel=1e-3)
    amplitude, omega = 0.02, 2 * np.pi * 3
    lost = 4 * 2500 * (amplitude - 0.002 * np.tanh(amplitude / 0.002))
    assert law.equivalent(amplitude, 3.0).damping == pytest.approx(
        lost / (np.pi * omega * amplitude ** 2), rel=1e-4)
    linear = tr.Law("tire", stiffness=2e5, damping=300, preload=1e5).equivalent(0.01, 2.0)
    assert linear == pytest.approx((2e5, 300))


@pytest.mark.parametrize("kind, words, call", [
    (tr.ArgumentError, "none of tire", lambda: tr.Law("rubber")),
    (tr.ArgumentError, "LawKind", lambda: tr.Law(99)),
    (TypeError, "LeafOptions has friction", lambda: tr.Law("leaf", stiffness=3)),
    (tr.RangeError, "friction", lambda: tr.Law("friction", friction=-1, stiffness=1)),
    (tr.RangeError, "step", lambda: laws()[0].trace([0, 1], 0.0)),
    (tr.RangeError, "point 2", lambda: laws()[0].trace([0, np.nan])),
    (tr.RangeError, "amplitude", lambda: laws()[2].equivalent(-1.0, 1.0)),
])
def test_sentences(kind, words, call):
    with pytest.raises(kind, match=words):
        call()
