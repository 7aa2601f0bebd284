# SPDX-License-Identifier: MIT
"""Beams and ladder frames: closed forms, SciPy's eigenvalues, reduction, pictures."""
import pickle

import numpy as np
import pytest

import truckride as tr

YOUNG = tr.section.STEEL.young
GRILLAGE = tr.Free.Z | tr.Free.ROLL | tr.Free.PITCH


def cantilever(elements, length=2.0):
    """Clamped at the ground at x = 0, free to bend up and down."""
    spec, section = tr.Spec("cantilever"), tr.section.rectangle(0.02, 0.03)
    section = section.replace(shear_y=0.0, shear_z=0.0, inertia_y=0.0, inertia_z=0.0)
    for k in range(1, elements + 1):
        spec.add_body(f"n.{k}", tr.Free.Z | tr.Free.PITCH, cg=(length * k / elements, 0, 0))
        spec.add_beam(f"b.{k}", section, k - 1, k)
    spec.add_port("tip", elements, (length, 0, 0))
    return spec, section


def ladder(longest=0.8, name="frame"):
    """A frame on four springs, with a sensor and a tank."""
    spec = tr.Spec("ladder")
    rail = tr.section.channel(0.27, 0.08, 0.008, 0.008, stiffness_damping=6e-4)
    member = tr.section.box(0.12, 0.10, 0.005, 0.005, stiffness_damping=6e-4)
    spec.add_frame(name, [1.3, 0, -1.5, -3, -4.5, -5.5], [1.3, -1.5, -3, -5.5], rail=rail,
                   member=member, half_width=0.4, z=0.9, longest=longest, freedoms=GRILLAGE)
    for x in (0, -4.5):
        for y in (0.4, -0.4):
            number = spec.add_road(f"{x} {y}", x, y)
            spec.add_link(f"spring {x} {y}", from_road=number, to_point=(x, y, 0.9), damping=6e3,
                          to_body=spec.nearest_body(f"{name}.*", (x, y, 0.9)), stiffness=2.5e5)
    spec.add_mass("tank", spec.nearest_body(f"{name}.left.*", (-3, 0.4, 0.9)), 400, (-3, 0.6, 0.7))
    spec.add_sensor("front", body=f"{name}.left.1", point=(1.3, 0.4, 0.9))
    return spec


def test_sections():
    section = tr.section.rectangle(0.3, 0.1, tr.Material(2e11, 8e10, 7800), mass_damping=0.5)
    assert section.bending_y == pytest.approx(2e11 * 0.1 * 0.3 ** 3 / 12)
    assert section.axial == pytest.approx(2e11 * 0.03) and section.mass_damping == 0.5
    assert section.mass_per_length == pytest.approx(7800 * 0.03)
    pipe = tr.section.tube(0.1, 0.01)
    assert pipe.torsion == pytest.approx(
        tr.section.STEEL.shear * np.pi * (0.1 ** 4 - 0.08 ** 4) / 32)
    assert tr.section.box(0.12, 0.1, 0.005, 0.006).bending_z == pytest.approx(
        YOUNG * (0.12 * 0.1 ** 3 - 0.108 * 0.09 ** 3) / 12)
    rail = tr.section.channel(0.27, 0.08, 0.008, 0.007)
    assert rail.bending_y == pytest.approx(
        YOUNG * (0.08 * 0.27 ** 3 - 0.072 * 0.256 ** 3) / 12)
    with pytest.raises(tr.RangeError, match="web"):
        tr.section.channel(0.27, 0.08, 0.2, 0.008)
    with pytest.raises(TypeError, match="stiffness"):
        tr.section.tube(0.1, 0.01, stiffness=3)


def test_cantilever():
    """cosh x cos x = -1, and P l^3 / 3 E I."""
    spec, section = cantilever(40)
    model = spec.compile()
    found = model.modes(count=3).frequencies
    roots = np.array([1.8751040687119611, 4.694091132974175, 7.854757438237613])
    exact = (roots / 2.0) ** 2 * np.sqrt(section.bending_y / section.mass_per_length) / (2 * np.pi)
    assert found == pytest.approx(exact, rel=2e-6)
    flexibility = np.linalg.inv(model.tangent().stiffness)
    row = model.row(tr.Part.PORT, "tip")
    assert row @ flexibility @ row == pytest.approx(2.0 ** 3 / 3 / section.bending_y, rel=1e-9)
    sag = spec.compile(gravity=tr.STANDARD_GRAVITY).static.q
    weight = section.mass_per_length * tr.STANDARD_GRAVITY
    assert sag[-2] == pytest.approx(-weight * 2.0 ** 4 / 8 / section.bending_y, rel=1e-9)


def test_parts_of_a_frame():
    spec = ladder()
    assert spec.count(tr.Part.BEAM) == 24 and spec.count(tr.Part.BODY) == 22
    assert "24 beams" in repr(spec)
    beam = spec.beam("frame.left.1")
    assert beam.from_point[2] == 0.9 and beam.stiffness_damping == 6e-4
    assert spec.body(spec.nearest_body("frame.right.*", (-9, 0, 0))).cg == (-5.5, -0.4, 0.9)
    spec.update_beam("frame.left.1", mass_per_length=99.0)
    assert spec.vary("frame.left.*", "bending", 2.0) == 10
    assert spec.beam("frame.left.1").bending_y == 2 * beam.bending_y
    for twin in (spec.copy(), pickle.loads(pickle.dumps(spec)),
                 tr.Spec.from_description(spec.describe())):
        assert twin.describe() == spec.describe()
        assert np.array_equal(twin.compile().mass, spec.compile().mass)
    assert spec.describe().beams["frame.left.1"].mass_per_length == 99
    body = spec.add_body("on the ground", GRILLAGE, cg=(1, 0, 0))
    spec.add_beam("post", beam, 0, body)
    assert spec.beam("post").from_point == (0, 0, 0) and spec.beam("post").to_point == (1, 0, 0)


@pytest.mark.parametrize("kind, words, call", [
    (tr.RangeError, "cross", lambda spec, rail: spec.add_frame(
        "f", [0, 1], [0.5], rail=rail, member=rail, half_width=0.4)),
    (tr.UnknownNameError, "frame", lambda spec, rail: spec.add_frame(
        "frame", [0, 1], [0], rail=rail, member=rail, half_width=0.4)),
    (tr.UnknownNameError, "nothing", lambda spec, rail: spec.nearest_body("nothing*", (0, 0, 0))),
    (tr.ArgumentError, "3 values", lambda spec, rail: spec.nearest_body("*", (0, 0))),
    (tr.ArgumentError, "one dimension", lambda spec, rail: spec.add_frame(
        "f", [[0, 1]], [0], rail=rail, member=rail, half_width=0.4)),
    (tr.UnknownNameError, "no beam 'x'", lambda spec, rail: spec.beam("x")),
    (tr.RangeError, "length", lambda spec, rail: spec.add_beam("b", rail, 1, 0, (0, 0, 0))),
    (tr.RangeError, "pieces|modes", lambda spec, rail: spec.compile().modes(count=0)),
    (tr.ArgumentError, "undamped", lambda spec, rail: spec.compile().modes(True, count=2)),
    (tr.UnknownNameError, "nothing", lambda spec, rail: spec.compile().reduce(pattern="nothing")),
    (tr.RangeError, "modes", lambda spec, rail: spec.compile().reduce(modes=-1)),
])
def test_sentences(kind, words, call):
    with pytest.raises(kind, match=words):
        call(ladder(), tr.section.tube(0.1, 0.01))


@pytest.mark.parametrize("longest", [0.8, 0.03])
def test_lowest_modes_are_scipys(longest):
    """Dense for few coordinates, Lanczos for many: the same as scipy.linalg.eigh."""
    linalg = pytest.importorskip("scipy.linalg")
    if longest < 0.1 and not tr.has_feature(tr.Feature.ARPACK):
        pytest.skip("built without ARPACK")
    model = ladder(longest).compile()
    square, shapes = linalg.eigh(model.tangent().stiffness, model.mass, subset_by_index=(0, 9))
    modes = model.modes(count=10)
    assert not modes.damped and len(modes) == 10
    assert modes.frequencies == pytest.approx(np.sqrt(square) / (2 * np.pi), rel=1e-7)
    for mode, shape in zip(modes, shapes.T):
        assert abs(mode.shape @ model.mass @ shape) == pytest.approx(1, abs=1e-6)
        assert mode.damping_ratio == 0 and mode.energy.sum() == pytest.approx(1)


def test_reduced_is_the_full_one():
    full = ladder(0.2).compile(gravity=tr.STANDARD_GRAVITY)
    small = full.reduce(pattern="frame.*", modes=30)
    assert len(small.coordinates) < 45 < 200 < len(full.coordinates)
    assert small.modes(count=6).frequencies == pytest.approx(full.modes(count=6).frequencies,
                                                             rel=2e-3)
    assert small.static.force == pytest.approx(full.static.force, rel=1e-9)
    frequency = np.linspace(1, 20, 20)
    response = full.response(frequency)["front"]
    assert np.abs(small.response(frequency)["front"] - response).max() < 5e-3 * np.abs(
        response).max()
    assert small.sensors == full.sensors and "modes.1" in small.coordinates
    copy = pickle.loads(pickle.dumps(small))
    assert np.array_equal(copy.mass, small.mass) and copy.gravity == full.gravity
    smaller = full.reduce(tr.ReduceOptions("frame.*", 10), modal_damping=0.02, interface_modes=6)
    assert len(smaller.coordinates) < len(small.coordinates)
    exact, run, coarse = (tr.simulate(model, tr.Signal.sine(0.002, 2.0), 1.0)["front"].rms
                          for model in (full, small, smaller))
    assert run == pytest.approx(exact, rel=0.02) and coarse == pytest.approx(exact, rel=0.25)


def test_pictures(tmp_path):
    """Beams follow their nodes: the ends to the bit, the middle by the cubic of the bent beam."""
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    from matplotlib import pyplot
    from truckride.plot import geometry
    spec = ladder()
    model = spec.compile()
    scene = geometry.scene(spec.describe())
    assert len(scene.beams.bodies) == 24 and scene.beams.far.sum() == 10  # the left rail
    assert list(scene.frames) == ["frame"] and not scene.struts and len(scene.wheels) == 4
    names = model.coordinates
    values = [0.01 if name.endswith(".pitch") else 0.0 for name in names]
    motion = geometry.motions(names, scene, values)
    assert np.allclose(geometry.bent(scene, {}, 4)[:, [0, -1]], scene.beams.ends)
    rails = np.abs(np.diff(scene.beams.ends[:, :, 0], axis=1))[:, 0] > 1e-6
    bent = geometry.bent(scene, motion, 4)[rails]
    # Both ends turn nose down by the same angle: an S, not moved in its middle.
    assert np.allclose(bent[:, 2, 1], scene.beams.ends[rails][:, :, 1].mean(axis=1))
    assert np.all((bent[:, 1, 1] - bent[:, 0, 1]) * np.diff(bent[:, :, 0], axis=1)[:, 0] < 0)
    assert geometry.reach(scene, motion) > 0
    for plot in (spec.plot, lambda: spec.plot(view="front"), model.modes(count=5)[3].plot,
                 lambda: model.modes(count=5)[3].plot(view="front"), model.modes().plot,
                 lambda: model.reduce(modes=3).modes(count=3).plot(),
                 lambda: cantilever(5)[0].plot(),
                 lambda: tr.Law("leaf", friction=100, approach_bump=0.001).plot(0.01)):
        drawn = plot()
        getattr(drawn, "figure", drawn).savefig(tmp_path / "picture.png")
        assert (tmp_path / "picture.png").stat().st_size > 3000
        pyplot.close("all")
    assert len(model.modes().plot(count=3).axes) == 3
