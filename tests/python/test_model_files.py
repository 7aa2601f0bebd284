# SPDX-License-Identifier: MIT
"""Model files: what is written reads back to the bit; errors name file, line and column."""
import json

import numpy as np
import pytest

import truckride as tr
from conftest import ROOT
from test_frames import ladder
from test_laws import laws

pytestmark = pytest.mark.skipif(not tr.has_feature(tr.Feature.JSON), reason="built without JSON")

QUARTER = """{
  "truckride_model": 1, "name": "quarter car",
  "curves": {"damper": {"csv": "damper.csv", "x": "velocity", "y": "force"}},
  "bodies": {"sprung": {"mass": 4500}, "unsprung": {"mass": 550}},
  "roads": {"wheel": {"x": 0, "y": 0}},
  "links": {
    "tire": {"from": {"road": "wheel"}, "to": "unsprung", "stiffness": 1e6},
    "spring": {"from": "unsprung", "to": "sprung", "stiffness": 2.5e5},
    "damper": {"from": "unsprung", "to": "sprung", "damper_curve": "damper"}
  },
  "sensors": {"z": {"body": "sprung"}}
}
"""
TABLE = "velocity [mm/s],force [kN]\n-500,-3.5\n0,0\n500,0.5\n"


def everything():
    """All built-in vehicles, a frame, each law."""
    for name in tr.Vehicle:
        for variant in tr.Variant:
            yield tr.vehicle(name, variant)
    yield ladder()
    spec = tr.vehicle("reference_truck")
    for link, law in zip(spec.names(tr.Part.LINK), laws()):
        spec.update_link(link, law=law)
    spec.add_body("Größe", mass=1 / 3, cg=(1e-300, -0.1, 5))
    yield spec


def test_round_trip_is_exact(tmp_path):
    for spec in everything():
        path = tmp_path / "model.json"
        spec.write(path)
        assert path.read_text(encoding="utf-8") == spec.to_json()
        for twin in (tr.Spec.read(path), tr.Spec.from_json(spec.to_json())):
            assert twin.describe() == spec.describe() and twin.name == spec.name
            assert twin.to_json() == spec.to_json()
        json.loads(spec.to_json())
    assert [item.name for item in tmp_path.iterdir()] == ["model.json"]
    model = tr.Spec.read(path).compile(allow_free=True)
    assert np.array_equal(model.mass, spec.compile(allow_free=True).mass)


def test_tables_beside_the_file(tmp_path):
    (tmp_path / "damper.csv").write_text(TABLE)
    (tmp_path / "quarter.json").write_text(QUARTER)
    spec = tr.Spec.read(tmp_path / "quarter.json")
    assert spec.link("damper").damper_curve.x.tolist() == [-0.5, 0, 0.5]
    assert spec.link("damper").damper_curve.y.tolist() == [-3500, 0, 500]
    assert tr.Spec.from_json(QUARTER, folder=tmp_path).describe() == spec.describe()
    with pytest.raises(tr.FileError, match="text:3:32: .*no folder"):
        tr.Spec.from_json(QUARTER)
    with pytest.raises(tr.FileError, match="damper.csv"):
        tr.Spec.from_json(QUARTER, folder=tmp_path / "elsewhere")


@pytest.mark.parametrize("kind, place, words, old, new", [
    (tr.InputError, "4:53", "did you mean 'mass'", '"unsprung": {"mass"', '"unsprung": {"mas"'),
    (tr.InputError, "5:30", "'}' expected", '"wheel": {"x": 0,', '"wheel": {"x": 0'),
    (tr.InputError, "4:33", "expected a number", '"mass": 4500', '"mass": "heavy"'),
    (tr.RangeError, "4:33", "is -4500", '"mass": 4500', '"mass": -4500'),
    (tr.UnsupportedError, "2:22", "version 99", '"truckride_model": 1', '"truckride_model": 99'),
    (tr.UnknownNameError, "7:47", "did you mean 'unsprung'", '"to": "unsprung"',
     '"to": "unsprun"'),
])
def test_errors_have_places(tmp_path, kind, place, words, old, new):
    (tmp_path / "damper.csv").write_text(TABLE)
    with pytest.raises(kind, match=f"mine.json:{place}: .*{words}"):
        tr.Spec.from_json(QUARTER.replace(old, new, 1), "mine.json", tmp_path)
    (tmp_path / "mine.json").write_text(QUARTER.replace(old, new, 1))
    with pytest.raises(kind, match=f"{tmp_path}/mine.json:{place}: .*{words}"):
        tr.Spec.read(tmp_path / "mine.json")


def test_files_that_are_not_there(tmp_path):
    with pytest.raises(tr.FileError, match="nowhere.json"):
        tr.Spec.read(tmp_path / "nowhere.json")
    with pytest.raises(tr.FileError, match="nowhere"):
        tr.vehicle().write(tmp_path / "nowhere" / "x.json")
    with pytest.raises(tr.ArgumentError, match="NUL"):
        tr.Spec.read("a\0b")
    with pytest.raises(tr.InputError):
        tr.Spec.from_json("")


@pytest.mark.parametrize("path", sorted((ROOT / "examples" / "models").glob("*.json")),
                         ids=lambda path: path.stem)
def test_shipped_files(path):
    """Each compiles under gravity and carries its weight on its tires."""
    spec = tr.Spec.read(path)
    assert tr.Spec.from_json(spec.to_json()).describe() == spec.describe()
    model, gravity = spec.compile(tr.STANDARD_GRAVITY), tr.STANDARD_GRAVITY
    up = np.array([float(name.endswith(".z")) for name in model.coordinates])
    links = spec.describe().links
    tires = [k for k, name in enumerate(model.links) if links[name].from_road]
    weight = gravity * (up @ model.mass @ up)
    assert -model.static.force[tires].sum() == pytest.approx(weight, rel=1e-9)
