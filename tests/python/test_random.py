# SPDX-License-Identifier: MIT
"""Random roads without time stepping: input spectra, statistical linearisation, enveloping."""
import pickle

import numpy as np
import pytest

import truckride as tr

FREQUENCY = np.geomspace(0.2, 60, 800)


def quarter(law=None, **changes):
    """A quarter car whose damper may be a law, with sensors of that damper."""
    spec = tr.quarter_car()
    name = next(name for name in spec.names(tr.Part.LINK) if "damper" in name or "spring" in name)
    spec.update_link(name, law=law, **changes)
    spec.add_sensor("rate", "rate", link=name)
    spec.add_sensor("force", "force", link=name)
    return spec.compile(), name


def test_input_spectra_are_those_of_the_road(truck):
    settings = tr.RoadOptions(unevenness=64e-6, contact_length=0.2, seed=9)
    speed = 15.0
    density = tr.road_density(FREQUENCY / speed, settings) / speed
    coherence = tr.road_coherence(FREQUENCY / speed, settings)
    expected = tr.road_cross_spectra(truck, FREQUENCY, density, speed, coherence)
    found = tr.road_input_spectra(truck, FREQUENCY, speed, settings)
    assert np.allclose(found, expected, rtol=1e-12, atol=0)
    assert np.array_equal(tr.road_input_spectra(truck, FREQUENCY, speed, road_class="b",
                                                contact_length=0.2), found)
    with pytest.raises(tr.RangeError, match="speed"):
        tr.road_input_spectra(truck, FREQUENCY, 0.0)
    with pytest.raises(TypeError, match="RoadOptions has unevenness"):
        tr.road_input_spectra(truck, FREQUENCY, 10, roughness=3)


def test_a_linear_model_stays_as_it_is():
    model, name = quarter()
    found = model.linearise(FREQUENCY, tr.road_input_spectra(model, FREQUENCY, 20))
    spec = tr.quarter_car()
    for link in model.links:
        assert found.stiffness[link] == pytest.approx(spec.link(link).stiffness)
        assert found.damping[link] == pytest.approx(spec.link(link).damping)
    assert max(map(abs, found.mean.values())) < 1e-12
    assert np.allclose(found.model.tangent().stiffness, model.tangent().stiffness)
    assert found.model.coordinates == model.coordinates == list(found.mean)


def test_coulomb_friction_is_that_of_booton():
    """f = F sign v under Gaussian motion: c = sqrt(2 / pi) F / sigma_v."""
    friction = 400.0
    model, name = quarter(tr.Law("seal", sliding=friction, creep=1e-5))
    road = tr.road_input_spectra(model, FREQUENCY, 20, road_class="c")
    found = tr.linearise(model, FREQUENCY, road)
    sigma = tr.response_psd(found.model, FREQUENCY, road).rms["rate"]
    own = tr.quarter_car().link(name).damping
    assert found.damping[name] - own == pytest.approx(np.sqrt(2 / np.pi) * friction / sigma,
                                                      rel=1e-3)
    rough = tr.linearise(model, FREQUENCY, 16 * road, tr.LineariseOptions(tolerance=1e-8))
    assert own < rough.damping[name] < found.damping[name]
    copy = pickle.loads(pickle.dumps(rough.model))
    assert np.array_equal(copy.tangent().damping, rough.model.tangent().damping)
    assert copy.modes().frequencies[0] == rough.model.modes().frequencies[0]


def test_what_cannot_be_linearised_is_said():
    model, name = quarter()
    road = tr.road_input_spectra(model, FREQUENCY, 20)
    with pytest.raises(tr.ArgumentError, match="the shape"):
        model.linearise(FREQUENCY[1:], road)
    with pytest.raises(tr.RangeError, match="tolerance"):
        model.linearise(FREQUENCY, road, tolerance=-1.0)
    with pytest.raises(TypeError, match="LineariseOptions has tolerance"):
        model.linearise(FREQUENCY, road, accuracy=1)
    model, name = quarter(tr.Law("friction", friction=2000, stiffness=5e6))
    with pytest.raises(tr.ConvergenceError, match=name):
        model.linearise(FREQUENCY, road, max_iterations=1)


def test_envelope_average_is_the_integral():
    height = np.random.default_rng(2).standard_normal(400).cumsum() * 1e-3
    x, spacing, length = np.arange(400) * 0.02, 0.02, 0.13
    found = tr.envelope_average(height, spacing, length)
    for k in (50, 123, 350):
        fine = np.linspace(x[k] - length / 2, x[k] + length / 2, 20001)
        heights = np.interp(fine, x, height)
        assert found.height[k] == pytest.approx(((heights[1:] + heights[:-1]) / 2).mean(), abs=1e-9)
        assert found.slope[k] == pytest.approx((heights[-1] - heights[0]) / length, abs=1e-9)
    assert tr.envelope_weight(2.0, 0.25) == pytest.approx(2 / np.pi)
    assert tr.envelope_weight([[0.0, 4.0]], 0.25) == pytest.approx(np.array([[1.0, 0.0]]))
    wave = np.sin(2 * np.pi * 2.0 * np.arange(4000) * 0.001)
    smooth = tr.envelope_average(wave, 0.001, 0.25).height[500:-500]
    assert smooth == pytest.approx(2 / np.pi * wave[500:-500], abs=1e-5)


def test_a_wheel_rolls_over_a_step():
    """Ahead of a step of height h the hub of a wheel is at sqrt(r^2 - x^2) - r + h."""
    radius, spacing, h = 0.5, 0.01, 0.02
    x = np.arange(-200, 201) * spacing
    found = tr.envelope_rigid_band(np.where(x >= 0, h, 0.0), spacing, radius)
    before = (x < 0) & (x > -np.sqrt(radius ** 2 - (radius - h) ** 2))
    assert found.height[before] == pytest.approx(
        np.sqrt(radius ** 2 - x[before] ** 2) - radius + h, abs=1e-12)
    assert found.height[x < -0.2] == pytest.approx(0) and found.height[-1] == pytest.approx(h)


def test_enveloped_signal():
    profile = tr.Signal.points([0, 10, 10.001, 10.1, 10.101, 20], [0, 0, 0.02, 0.02, 0, 0])
    felt = tr.enveloped(profile, 2001, 0.01, radius=0.5, length=0.2)
    hub = tr.envelope_rigid_band(profile(np.arange(2001) * 0.01), 0.01, 0.5).height
    height, slope = tr.envelope_average(hub, 0.01, 0.2)
    assert felt(np.arange(2001) * 0.01) == pytest.approx(height, abs=1e-12)
    assert felt.rate(10.0) == pytest.approx(slope[1000], abs=1e-9)
    twin = pickle.loads(pickle.dumps(felt))
    assert twin(9.95) == felt(9.95) and 0 < felt(9.95) < 0.02
    with pytest.raises(tr.RangeError):
        tr.enveloped(profile, 2001, 0.01)
    with pytest.raises(tr.RangeError, match="spacing"):
        tr.envelope_average([0, 1], -1.0, 0.2)
