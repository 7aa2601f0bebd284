# SPDX-License-Identifier: MIT
"""Types, wheel, examples and the code of the documentation."""
import os
import re
import subprocess
import sys

import pytest

import truckride as tr
from conftest import PACKAGE, ROOT

ENVIRONMENT = dict(os.environ, PYTHONPATH=str(PACKAGE), TRUCKRIDE_LIBRARY=tr.library_path,
                   PYTHONDONTWRITEBYTECODE="1", MPLBACKEND="Agg")


def run(*command, **options):
    options.setdefault("env", ENVIRONMENT)
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                          **options)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_types_are_strict(tmp_path):
    pytest.importorskip("mypy")
    run(sys.executable, "-m", "mypy", "--config-file", PACKAGE / "pyproject.toml", "--cache-dir",
        tmp_path, env=dict(ENVIRONMENT, MYPYPATH=str(PACKAGE)), cwd=tmp_path)


def test_every_public_name_is_documented():
    for name in tr.__all__:
        item = getattr(tr, name)
        if callable(item) and not isinstance(item, type(tr.Status)):
            assert (item.__doc__ or "").strip(), name


def test_wheel_in_a_venv_without_network(tmp_path):
    """Built twice, the same; installed by pip, it finds the library inside."""
    pytest.importorskip("venv")
    real = os.path.realpath(tr.library_path)
    wheels = []
    for folder in ("one", "two"):
        path = run(sys.executable, PACKAGE / "build_wheel.py", "--library", real,
                   tmp_path / folder).strip()
        wheels.append(open(path, "rb").read())
    assert wheels[0] == wheels[1]
    if subprocess.run([sys.executable, "-c", "import ensurepip, numpy"]).returncode:
        pytest.skip("python3-venv is not installed")
    run(sys.executable, "-m", "venv", "--system-site-packages", tmp_path / "venv")
    python = tmp_path / "venv" / "bin" / "python"
    run(python, "-m", "pip", "install", "--no-index", "--disable-pip-version-check", path)
    bare = {key: value for key, value in os.environ.items()
            if key not in ("PYTHONPATH", "TRUCKRIDE_LIBRARY")}
    code = "import truckride as t; print(t.library_path, len(t.vehicle().names(t.Part.BODY)))"
    told = run(python, "-c", code, env=bare, cwd=tmp_path)
    assert "site-packages" in told and told.split()[-1] == "4"


@pytest.mark.parametrize("example", sorted(path.stem for path in
                                           (PACKAGE / "examples").glob("*.py")))
def test_examples(example, tmp_path):
    pytest.importorskip("matplotlib")
    run(sys.executable, PACKAGE / "examples" / f"{example}.py", tmp_path, cwd=tmp_path)
    assert (tmp_path / f"{example}.png").stat().st_size > 10000


@pytest.mark.parametrize("document", ["docs/python.md", "bindings/python/README.md"])
def test_code_of_the_documentation_runs(document, tmp_path):
    pytest.importorskip("matplotlib")
    if not tr.has_feature(tr.Feature.JSON):
        pytest.skip("built without JSON: no model files")
    blocks = re.findall(r"^```python\n(.*?)^```", (ROOT / document).read_text(), re.S | re.M)
    assert blocks
    run(sys.executable, "-c", "\n".join(blocks), cwd=tmp_path)
