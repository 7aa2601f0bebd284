# SPDX-License-Identifier: MIT
"""Round trips: what goes in comes out, and the numbers are those of NumPy and SciPy."""
import numpy as np
import pytest

import truckride as tr


def test_spec_by_hand_is_a_quarter_car():
    spec = tr.Spec("mine")
    road = spec.add_road("road")
    spec.add_body("axle", mass=500)
    spec.add_body("body", mass=5000)
    spec.add_link("tire", from_road=road, to_body="axle", stiffness=1e6, damping=500)
    spec.add_link("spring", from_body="axle", to_body="body", stiffness=5e5)
    spec.add_mass("driver", "body", 100, (0, 0, 0))
    spec.add_sensor("z", body="body")
    spec.add_port("push", "body")
    model = spec.compile()
    assert model.coordinates == ["axle.z", "body.z"] and model.ports == ["push"]
    assert np.allclose(model.mass, np.diag([500, 5100]))
    assert np.allclose(model.tangent().stiffness, [[1.5e6, -5e5], [-5e5, 5e5]])
    assert model.link_row("tire")[1].tolist() == [1] and model.row(tr.Part.PORT, "push")[1] == 1
    lam = np.linalg.eigvals(np.linalg.solve(model.mass, model.tangent().stiffness))
    assert np.allclose(model.modes(damped=False).frequencies, np.sort(np.sqrt(lam)) / 2 / np.pi)
    response = model.response([0.0, 1.0])["z"]
    assert response[0] == 0 and abs(response[1]) > 0
    spec.update_body("body", mass=4000)
    spec.update_link("spring", stiffness=6e5)
    assert spec.vary("t*", "stiffness", 1.5) == 1
    assert spec.body("body").mass == 4000 and spec.link("tire").stiffness == 1.5e6
    assert spec.port("push").body == 2 and spec.mass("driver").mass == 100
    assert model.tangent().stiffness[0, 0] == 1.5e6  # compiled before


def test_parts_of_a_builtin_survive_a_round_trip():
    for name in tr.Vehicle:
        for variant in tr.Variant:
            spec = tr.vehicle(name, variant)
            again = tr.Spec.from_description(spec.describe())
            assert again.describe() == spec.describe() == spec.copy().describe()
            assert np.array_equal(again.compile().mass, spec.compile().mass)


def test_parameters_reach_the_library():
    curve = tr.Curve([-1, 0, 1], [-1000, 0, 500])
    spec = tr.truck(cab_mass=999.0, damper_curve=(curve, None), damping=(0.0, 20000.0))
    assert spec.body("cab").mass == 999.0
    assert spec.link("front_left_damper").damper_curve == curve
    assert spec.link("rear_left_damper").damper_curve is None
    assert tr.half_car(layout="roll").compile().coordinates[1].endswith("roll")
    assert tr.axle_quarter("rear").body("unsprung").mass == pytest.approx(1097.581 / 2)
    static = tr.half_truck().compile(gravity=tr.STANDARD_GRAVITY).static
    weight = 9.80665 * (1242.63 + 5842.37 + 1084.781 + 1097.581) / 2
    tires = [k for k, name in enumerate(tr.half_truck().names(tr.Part.LINK)) if "tire" in name]
    assert -static.force[tires].sum() == pytest.approx(weight)


def test_curves():
    scipy_interpolate = pytest.importorskip("scipy.interpolate")
    x, y = [-2.0, -0.5, 0.0, 1.0, 3.0], [-4.0, -3.0, 0.0, 1.0, 1.5]
    curve, places = tr.Curve(x, y, "damper"), np.linspace(-2, 3, 41)
    assert np.allclose(curve(places), scipy_interpolate.PchipInterpolator(x, y)(places))
    assert curve(places[3]) == curve(places)[3] and curve(np.ones((2, 2))).shape == (2, 2)
    assert curve.monotone == 1 and curve.solve(1.0) == pytest.approx(1.0)
    assert curve.slope(0.7) == pytest.approx((curve(0.7001) - curve(0.6999)) / 2e-4, rel=1e-5)
    assert curve.slope_range[0] >= 0 and len(curve) == 5 and curve.name == "damper"
    assert tr.Curve(x, y, extrapolation="clamp")(99) == 1.5


def test_signals():
    step = tr.Signal.step(0.05, 0.2, start=1.0)
    assert [step(t) for t in (0.5, 1.1, 2.0)] == pytest.approx([0, 0.025, 0.05])
    sine = tr.Signal.sine(2.0, 3.0)
    value, rate = sine.evaluate(100, 0.01)
    assert np.allclose(value, 2 * np.sin(6 * np.pi * np.arange(100) * 0.01))
    assert np.allclose(rate, sine.rate(np.arange(100) * 0.01))
    samples = tr.Signal.samples(np.sin(np.arange(50) * 0.1), 0.1)
    assert samples(1.23) == pytest.approx(np.sin(1.23), abs=1e-5)
    assert tr.Signal.points([0, 1, 3], [0, 1, 1])(2.0) == 1


def test_excitation_of_a_profile(truck):
    profile = tr.Signal.step(0.1, 1.0, start=10.0)
    excitation = tr.Excitation(truck).add_profile(profile, speed=10.0)
    height = excitation.evaluate(200, 0.01).height
    front = height[:, truck.find(tr.Part.ROAD, "front_left") - 1]
    rear = height[:, truck.find(tr.Part.ROAD, "rear_left") - 1]
    assert np.allclose(front[:-45], rear[45:])  # 4.5 m at 10 m/s


def test_spectra_are_scipys():
    signal = pytest.importorskip("scipy.signal")
    random = np.random.default_rng(3)
    x, y = random.standard_normal((2, 5000))
    same = {"fs": 250.0, "nperseg": 512, "noverlap": 256}
    spectrum = tr.psd(x, 250.0, segment_length=512)
    frequency, density = signal.welch(x, **same)
    assert np.allclose(spectrum.density, density, rtol=1e-10)
    assert np.allclose(spectrum.frequency, frequency)
    assert np.allclose(tr.csd(x, y, 250.0, segment_length=512)[1], signal.csd(x, y, **same)[1])
    assert np.allclose(tr.coherence(x, y, 250.0, segment_length=512)[1],
                       signal.coherence(x, y, **same)[1])
    assert np.allclose(tr.frf(x, y, 250.0, segment_length=512)[1],
                       signal.csd(x, y, **same)[1] / density)
    assert tr.psd_segments(5000, segment_length=512) == 18
    assert spectrum.band_rms() == pytest.approx(np.sqrt(density.sum() * frequency[1]))
    assert spectrum.normalised().density.max() == 1
    found = signal.find_peaks(density, height=0.008)[0]
    assert sorted(p.height for p in spectrum.peaks(minimum_height=0.008)) == pytest.approx(
        sorted(density[found]))


def test_peaks_of_a_spectrum_that_does_not_begin_at_zero():
    frequency = np.linspace(3, 9, 601)
    spectrum = tr.Psd(frequency, 1 / (1 + (frequency - 5.5) ** 2))
    assert spectrum.peaks(1)[0].frequency == pytest.approx(5.5, abs=1e-6)
    with pytest.raises(tr.ArgumentError, match="equally"):
        tr.Psd(np.array([0.0, 1.0, 3.0]), np.ones(3)).peaks()


def test_stepper_is_the_run(model, excitation):
    run = tr.simulate(model, excitation, 0.3)
    stepper, inputs = tr.Newmark(model), excitation.evaluate(301, 0.001)
    stepper.set_state(0.0, height=inputs.height[0], velocity=inputs.velocity[0])
    record = [stepper.read().copy()]
    for k in range(1, 301):
        stepper.height = inputs.height[k]
        stepper.velocity[:] = inputs.velocity[k]
        stepper.step()
        record.append(stepper.read().copy())
    expected = np.array([run[name].values for name in run]).T
    assert np.allclose(record, expected, rtol=1e-7, atol=1e-7 * np.abs(expected).max())
    assert stepper.statistics.steps == 300 and stepper.time == pytest.approx(0.3)
    assert np.allclose(stepper.links.force,
                       model.link_force(stepper.links.elongation, stepper.links.rate))


def test_methods_agree(model, excitation):
    implicit = tr.simulate(model, excitation, 2.0)["cab_front_z"].values
    explicit = tr.simulate(model, excitation, 2.0, method="runge_kutta")["cab_front_z"].values
    assert np.allclose(implicit, explicit, atol=2e-3 * np.abs(explicit).max())
    stepper = model.stepper("rungekutta", step=0.002)
    stepper.middle_height = 0.005
    stepper.height = 0.01
    stepper.step()
    assert stepper.time == 0.002 and tr.step_limit(model).step > 0.002
    assert tr.adams().beta == 0.36 and tr.hht(-0.1).alpha_f == pytest.approx(0.1)
    assert tr.generalized_alpha(1.0).gamma == pytest.approx(0.5)


def test_initial_state(model):
    q = 0.001 * np.arange(1.0, 8.0)
    run = tr.simulate(model, tr.Excitation(model), 0.01, initial_q=q)
    assert run["cab_front_z"][0] != 0
    with pytest.raises(tr.ArgumentError, match="7 values are expected, not 3"):
        tr.simulate(model, tr.Excitation(model), 0.01, initial_q=[1, 2, 3])


def test_batch_is_single_runs(excitation):
    models = [tr.half_truck(cab_mass=mass).compile() for mass in (1000.0, 1200.0, 1400.0)]
    batch = tr.run_batch(models, excitation, 1.0, threads=2)
    for k, model in enumerate(models):
        single = tr.simulate(model, excitation, 1.0)["cab_front_z"].values
        assert np.allclose(batch["cab_front_z"][k], single, atol=1e-9 * np.abs(single).max())
    blocks = []
    tr.run_batch(models, excitation, 0.1, sink=lambda *block: blocks.append(block) and None)
    assert sum(block[2].shape[1] for block in blocks) == 3 * 101
    with pytest.raises(ZeroDivisionError):
        tr.run_batch(models, excitation, 0.1, sink=lambda *block: 1 / 0)


def test_batch_records_what_is_asked_for(model, excitation):
    whole = tr.run_batch([model], excitation, 0.1)
    part = tr.run_batch([model], excitation, 0.1, sensors=["cab_rear_z", 1])
    assert part.sensors == ["cab_rear_z", whole.sensors[0]] and part.values.shape == (1, 2, 101)
    assert part.units == ["m/s^2", whole.units[0]]
    assert np.array_equal(part["cab_rear_z"], whole["cab_rear_z"])
    assert np.array_equal(part.values[:, 1], whole.values[:, 0])
    with pytest.raises(tr.UnknownNameError, match="no sensor 'seat'"):
        tr.run_batch([model], excitation, 0.1, sensors=["seat"])
    for wrong in [], [0], [99]:
        with pytest.raises(tr.ArgumentError):
            tr.run_batch([model], excitation, 0.1, sensors=wrong)


def test_study(spec, model, excitation, tmp_path):
    def build():
        study = tr.Study(spec, points=6, duration=1.0)
        study.add_parameter("tires", "*_tire", lower=0.5, upper=2.0)
        study.add_output("cab", "cab_front_z")
        study.add_excitation("sine", excitation)
        return study
    study = build()
    study.run(threads=2)
    table = study.table()
    assert len(study) == study.finished == 6 and set(table.status) == {tr.Status.OK}
    for k in range(6):
        varied = spec.copy()
        varied.vary("*_tire", "stiffness", table.parameters["tires"][k])
        run = tr.simulate(varied.compile(), excitation, 1.0)
        assert table.outputs["cab"][k] == pytest.approx(run["cab_front_z"].rms, rel=1e-8)
    assert study.case(0).excitation == "sine" and study.output_unit("cab") == "m/s^2"
    other = build()
    other.open_journal(tmp_path / "journal")
    other.run(cases=[1, 3])
    other.close_journal()
    third = build()
    third.load(tmp_path / "journal")
    assert third.finished == 2 and third.is_finished(3) and not third.is_finished(0)
    third.set_outputs(0, [study.outputs(0)[0]["cab"]])
    assert third.fingerprint == study.fingerprint
    third.set_spectrum(segment_length=256)
    third.set_newmark(step=0.002)
    third.write_csv(tmp_path / "table.csv")
    assert (tmp_path / "table.csv").read_text().startswith("case")


def test_random_response_is_the_integral(model):
    f = np.linspace(0.5, 20, 300)
    density = 1e-6 / f ** 2
    road = tr.road_cross_spectra(model, f, density, 1e9)  # all wheels at once
    found = tr.response_psd(model, f, road)
    expected = np.abs(model.response(f)["cab_front_z"]) ** 2 * density
    assert np.allclose(found.psd["cab_front_z"].density, expected, rtol=1e-5)
    welch = tr.response_psd_excited(model, tr.sweep(duration=20), 20.0, segment_length=4096)
    assert welch.rms["cab_front_z"] > 0


def test_calibration_finds_what_was_hidden():
    hidden = tr.half_truck(tire_stiffness=(1.5e6, 1.1e6))
    modes = hidden.compile().modes(damped=False)
    spec = tr.half_truck()
    calibration = tr.Calibration(spec)
    for axle in ("front", "rear"):
        calibration.add_parameter(axle, f"{axle}_tire", meaning="value", start=8e5, lower=1e5,
                                  upper=1e7)
        calibration.target_frequency(axle, modes.dominated_by(f"{axle}_axle.z")[0].frequency,
                                     f"{axle}_axle.z", damped=False)
    solution = calibration.solve()
    assert solution.ok and solution.fitted == pytest.approx({"front": 1.5e6, "rear": 1.1e6})
    assert calibration.apply(spec).link("rear_tire").stiffness == pytest.approx(1.1e6)
    assert solution.jacobian.shape == (2, 2) and "targets are met" in str(solution)
    values, jacobian = calibration.evaluate([1.5e6, 1.1e6], jacobian=True)
    assert values.shape == (2,) and jacobian.shape == (2, 2)


def test_calibration_to_peaks_and_curves(spec, model):
    calibration = tr.Calibration(spec)
    calibration.add_parameter("cab", "cab_front_vertical")
    f = np.linspace(0.5, 10, 30)
    calibration.target_response("response", "cab_front_z", f,
                                np.abs(model.response(f)["cab_front_z"]))
    calibration.target_damping("damping", 0.1, "frame.z")
    sweep = tr.Excitation(model, tr.sweep(duration=20))
    calibration.set_run(sweep, duration=20.0, segment_length=2048)
    calibration.target_peak("peak", 1.2, "cab_front_z", (0.5, 4))
    run = tr.simulate(model, sweep, 20.0)["cab_front_z"].psd(segment_length=2048)
    calibration.target_psd("psd", "cab_front_z", run.frequency[2:20], run.density[2:20])
    values = calibration.evaluate([1.0]).values
    assert len(values) == 30 + 1 + 1 + 18 and np.allclose(values[:30], 0, atol=1e-9)


def test_series(tmp_path):
    t = np.arange(2000) / 1000
    series = tr.Series({"a": np.sin(12 * t), "b": t}, 1000.0, start=1.0, units={"a": "m/s^2"})
    assert list(series) == ["a", "b"] and series["a"].unit == "m/s^2" and "c" not in series
    assert series.time[0] == 1.0 and series["a"].time[-1] == pytest.approx(2.999)
    slow = series.resample(100.0)
    assert slow.rate == 100 and np.allclose(slow["a"].values[50:150], np.sin(12 * t)[500:1500:10],
                                            atol=1e-3)
    series.label("b", "ramp", "m")
    series.write_csv(tmp_path / "out.csv")
    assert (tmp_path / "out.csv").read_text().splitlines()[0] == "time [s],a [m/s^2],ramp [m]"
    assert np.mean(series["ramp"]) == pytest.approx(t.mean())


def test_comfort_and_roughness():
    rate, t = 500.0, np.arange(10000) / 500
    x = np.sin(2 * np.pi * 5 * t)
    weighted = tr.comfort.weight("wk", x, rate)
    measured = tr.comfort.vibration(weighted, rate)
    factor = tr.comfort.weighting_factor("wk", 5)
    assert measured.rms == pytest.approx(factor / np.sqrt(2), rel=0.01)
    wave, meter = tr.comfort.WeightingFilter("wk", rate), tr.comfort.VibrationMeter(rate)
    for block in np.array_split(x, 7):
        meter.process(wave(block))
    assert meter.read() == measured
    meter.reset(), wave.reset()
    with pytest.raises(tr.RangeError):
        meter.read()
    assert tr.comfort.weighting_name("wd") == "Wd"
    assert abs(tr.comfort.weighting_response("wk", [5.0])[0]) == pytest.approx(
        tr.comfort.weighting_factor("wk", 5))
    spectrum = tr.psd(x, rate)
    bands = tr.comfort.third_octave_rms(spectrum.density, spectrum.step, -3, 20)
    assert np.sqrt((bands ** 2).sum()) == pytest.approx(np.sqrt(0.5), rel=1e-3)
    assert tr.comfort.third_octave_weight("wk", bands, -3) == pytest.approx(measured.rms, rel=0.05)
    assert tr.comfort.psd_weight("wk", spectrum.density, spectrum.step)[0] == 0
    assert tr.comfort.third_octave_centre(10) == pytest.approx(10)
    assert tr.comfort.running_rms(x, rate)[-1] == pytest.approx(np.sqrt(0.5), rel=1e-2)
    assert tr.comfort.axis_weighting("seat_x", "health") == (tr.Weighting.WD, 1.4)
    assert tr.comfort.vibration_total({"seat_z": 0.3}) == pytest.approx(0.3)
    words = tr.comfort.comfort_texts(tr.comfort.comfort_reactions(0.55))
    assert words == ["a little uncomfortable", "fairly uncomfortable"]
    assert tr.comfort.daily_a8("seat_z", [0.5], [8 * 3600]) == pytest.approx(0.5)
    assert tr.comfort.daily_vdv("seat_z", [5.0], [60], [60]) == pytest.approx(5)
    assert tr.comfort.exposure_of_a8(0.7) == tr.comfort.exposure_of_vdv(10.0) == 1
    assert tr.comfort.seat_factor(0.5 * x, x, rate).rms == pytest.approx(0.5)
    load = tr.comfort.axle_load([-x, -x], 100.0)
    assert np.allclose(load, 100 + 2 * x) and tr.comfort.load_numbers(load).mean > 99
    numbers, percentiles = tr.comfort.travel_numbers(x, [50])
    assert numbers.peak_to_peak == pytest.approx(2, abs=1e-3) and abs(percentiles[0]) < 0.05
    decay = -np.exp(-t) * np.cos(2 * np.pi * 1.5 * t)
    assert tr.comfort.axle_transient(decay, rate).damped_frequency == pytest.approx(1.5, rel=0.02)
    drop = tr.comfort.axle_drop(tr.truck().compile(), ["rear_left", "rear_right"],
                                "rear_left_spring")
    assert 1 < drop.damped_frequency < 3
    assert tr.Unfriendly.FREQUENCY in tr.comfort.road_friendliness(2.5, 0.3, 0.1)
    road = 0.002 * np.sin(2 * np.pi * np.arange(2000) * 0.1 / 5)
    assert 0 < tr.roughness.iri(road, 0.1) < 0.02
    assert len(tr.roughness.iri_segments(road, 0.1, 20.0)) == 9
    assert tr.roughness.hri(road, -road, 0.1) < 1e-12 < tr.roughness.mri(road, -road, 0.1)
    assert tr.roughness.iri_gain(0.0634) == pytest.approx(1.5376, abs=1e-3)
    assert tr.roughness.iri_of_road(16e-6) * 1000 == pytest.approx(2.221, rel=2e-3)


def test_random_road():
    import gc
    import pickle
    left, right = tr.road(road_class="c", seed=3)
    x = np.linspace(0, 50, 200)
    heights = left(x)
    assert np.array_equal(tr.road(unevenness=256e-6, seed=3).left(x), heights)
    assert np.array_equal(pickle.loads(pickle.dumps(left))(x), heights)
    del right
    gc.collect()
    assert np.array_equal(left(x), heights) and heights.std() > 1e-3
    assert tr.road_density([0.1], unevenness=16e-6)[0] == pytest.approx(16e-6)
    assert 0 <= tr.road_coherence([0.5])[0] <= 1
