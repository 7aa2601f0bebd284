# SPDX-License-Identifier: MIT
"""Every plot is drawn, with units on its axes, and leaves the user's style alone."""
import numpy as np
import pytest

import truckride as tr

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")

from truckride import plot  # noqa: E402


@pytest.fixture(autouse=True)
def close_figures():
    before = dict(matplotlib.rcParams)
    yield
    import matplotlib.pyplot as plt
    plt.close("all")
    assert dict(matplotlib.rcParams) == before


@pytest.fixture(scope="module")
def run(truck):
    return tr.simulate(truck, tr.sweep(duration=30), 30.0)


def labels(axes):
    return axes.get_xlabel(), axes.get_ylabel()


def test_signals_and_spectra(run):
    assert labels(run["cab_front_left_z"].plot()) == ("time [s]", "acceleration [m/s²]")
    assert "force [N]" in labels(run.plot("front_left_tire_force"))
    axes = run["cab_front_left_z"].psd().plot()
    assert labels(axes) == ("frequency [Hz]", "PSD [(m/s²)²/Hz]")
    assert any("Hz" in text.get_text() for text in axes.texts)  # marked peaks
    assert len(run.plot_psd("cab_front_left_z", "frame_front_left_z").get_lines()) >= 2
    with pytest.raises(tr.ArgumentError, match="one unit"):
        run.plot("cab_front_left_z", "front_left_tire_force")


def test_decimated_lines_keep_their_extremes():
    from truckride.plot.signals import thin
    values = np.zeros(100000)
    values[54321] = 7
    time, shown = thin(tr.Series({"a": values}, 1000.0)["a"])
    assert len(shown) <= 5000 and shown.max() == 7
    assert time[shown.argmax()] == pytest.approx(54.321, abs=0.05)


def test_bode_and_curves(truck):
    figure = truck.response(np.geomspace(0.5, 20, 50)).plot("cab_front_left_z")
    assert figure.axes[1].get_xlabel() == "frequency [Hz]"
    axes = tr.Curve.builtin("thesis_front_axle_damper").plot()
    assert "velocity [m/s]" in axes.get_xlabel() and axes.get_ylabel() == "force [kN]"
    plot.curves([tr.Curve.builtin(table) for table in (2, 3)])
    tr.sweep(duration=5).plot(5)


@pytest.mark.parametrize("name", [vehicle.name.lower() for vehicle in tr.Vehicle])
def test_views_and_modes(name):
    model = tr.vehicle(name).compile()
    model.plot(), model.plot(view="front")
    assert len(model.modes().plot().axes) >= len(model.modes())


def test_a_rising_body_is_drawn_higher(model):
    """A mode that lifts the cab lifts its corners; pitch nose down lowers the front ones."""
    from truckride.plot import geometry
    description, names = model.describe(), model.coordinates
    scene = geometry.scene(description)
    box = scene.boxes[1]
    for coordinate, left, right in (("cab.z", 1, 1), ("cab.pitch", 1, -1)):
        values = [1e-3 if name == coordinate else 0 for name in names]
        motion = geometry.motions(names, scene, values)[1]
        up = (geometry.moved(box.outline, box.cg, motion) - box.outline)[:, 1]
        assert np.sign(up[0]) == left and np.sign(up[1]) == right


def test_calibration_and_study(spec, excitation):
    calibration = tr.Calibration(spec)
    calibration.add_parameter("tire", "front_tire")
    calibration.target_frequency("axle", 12, "front_axle.z", damped=False)
    assert len(calibration.solve().plot().axes) == 2
    study = tr.Study(spec, points=4, duration=0.5)
    study.add_parameter("tires", "*_tire")
    study.add_output("cab", "cab_front_z")
    study.add_excitation("sine", excitation)
    study.run()
    assert study.plot().axes[0].get_ylabel() == "cab [m/s²]"


def test_animation(model, excitation, tmp_path):
    image = pytest.importorskip("PIL.Image")
    path = plot.animate(model, excitation, tmp_path / "run.gif", 0.4, rate=10)
    assert image.open(path).n_frames == 5
    with pytest.raises(tr.ArgumentError, match="gif or .mp4"):
        plot.animate(model, excitation, tmp_path / "run.avi")
