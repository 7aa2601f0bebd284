# SPDX-License-Identifier: MIT
"""The package fits the headers and the library, and says so clearly where it does not."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

import truckride as tr
from conftest import PACKAGE, ROOT
from truckride import _abi, _library

COMPILER = os.environ.get("CC") or shutil.which("cc")


def import_with(library):
    """Output of an interpreter that imports the package with a library."""
    environment = dict(os.environ, TRUCKRIDE_LIBRARY=str(library), PYTHONPATH=str(PACKAGE))
    return subprocess.run([sys.executable, "-B", "-c", "import truckride"], env=environment,
                          capture_output=True, text=True)


def shim(folder, source):
    """A library with some functions of its own that has all others from the real one."""
    path = pathlib.Path(folder, "libshim.so")
    code = pathlib.Path(folder, "shim.c")
    code.write_text("#include <stddef.h>\n#include <string.h>\n" + source)
    subprocess.run([COMPILER, "-shared", "-fPIC", "-o", str(path), str(code), "-Wl,--no-as-needed",
                    os.path.realpath(tr.library_path),
                    f"-Wl,-rpath,{os.path.dirname(os.path.realpath(tr.library_path))}"], check=True)
    return path


@pytest.mark.skipif(not COMPILER, reason="no C compiler preprocesses the headers")
def test_generated_files_are_those_of_the_headers():
    pytest.importorskip("pycparser")
    run = subprocess.run([sys.executable, "-B", str(PACKAGE / "generate.py"), "--check",
                          tr.library_path], capture_output=True, text=True)
    assert run.returncode == 0, run.stdout + run.stderr


def test_every_declared_function_has_a_signature():
    declared, folder = set(), ROOT / "include" / "truckride"
    for name in re.findall(r"#include <truckride/(\w+\.h)>", (folder / "truckride.h").read_text()):
        text = re.sub(r"/\*.*?\*/", "", (folder / name).read_text(), flags=re.S)
        declared |= set(re.findall(r"^TRK_API\b[^;(]*?\b(trk_\w+)\s*\(", text, re.M))
    assert declared == set(_abi.SIGNATURES)


def test_every_function_is_used():
    """Nothing of the C interface is out of reach from Python."""
    text = "\n".join(path.read_text() for path in (PACKAGE / "truckride").rglob("*.py")
                     if path.name != "_abi.py")
    named = set(re.findall(r"\btrk_\w+", text))
    for prefix in ("trk_newmark", "trk_rungekutta"):  # the base of the steppers puts these together
        named |= {f"{prefix}_{verb}" for verb in ("step", "time", "step_size", "get_state", "get_links",
                                                  "set_state", "read_sensors")}
    named |= {f"{struct}_init" for struct in re.findall(r"_abi\.(trk_\w+)", text)}
    assert set(_abi.SIGNATURES) - named == set()


def test_missing_library_names_what_was_tried():
    run = import_with("/nowhere/libtruckride.so.0")
    assert run.returncode == 1
    assert "LibraryError" in run.stderr and "/nowhere/libtruckride.so.0" in run.stderr


def test_without_variable_all_places_are_named(tmp_path):
    environment = {"PYTHONPATH": str(PACKAGE), "PATH": "", "LD_LIBRARY_PATH": str(tmp_path)}
    code = ("import ctypes\nreal = ctypes.CDLL\n"
            "def none(*a, **k): raise OSError('not here')\nctypes.CDLL = none\nimport truckride\n")
    run = subprocess.run([sys.executable, "-B", "-c", code], env=environment, capture_output=True,
                         text=True)
    for place in ("TRUCKRIDE_LIBRARY: not set", "inside the package", "search path"):
        assert place in run.stderr


@pytest.mark.skipif(not COMPILER, reason="no C compiler")
@pytest.mark.parametrize("source, message", [
    ("int trk_version(void) { return 90909; }", "has version 9.9.9"),
    ("int trk_version(void) { return 0; }", "has version 0.0.0"),
    ("void trk_newmark_options_init(void *o, size_t n) { memset(o, 0, n + 8);"
     " *(size_t *)o = n; }", "trk_newmark_options_init does not take"),
    ("void trk_newmark_options_init(void *o, size_t n) { memset(o, 0, n); *(size_t *)o = n;"
     " ((double *)o)[2] = 0.001; }", "trk_newmark_options.step is 0.0"),
])
def test_library_of_another_release_is_refused(tmp_path, source, message):
    run = import_with(shim(tmp_path, source))
    assert run.returncode == 1, run.stderr
    assert "LibraryError" in run.stderr and message in run.stderr


def test_stranger_is_refused():
    run = import_with("libc.so.6")
    assert run.returncode == 1 and "is not libtruckride" in run.stderr


def test_older_library_names_what_it_lacks():
    class Old:
        _name = "old.so"
    with pytest.raises(tr.LibraryError, match="lacks trk_.*older"):
        _library.declare(Old())


def test_statuses_have_exceptions():
    from truckride.errors import BY_STATUS, error_of
    assert set(BY_STATUS) == set(tr.Status) - {tr.Status.OK}
    assert type(error_of(999, "new")) is tr.TruckrideError
