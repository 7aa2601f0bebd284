#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Build a wheel with the shared library inside; needs neither network nor pip.

usage: build_wheel.py [--library LIBRARY] [--min] [OUTPUT_DIR]

Without --library the library is built with CMake in build/wheel; --min leaves CHOLMOD, LAPACK,
NLopt, jansson and ARPACK out, so that the wheel runs without any package of the system, but has
no modes, frequency responses and calibration and reads no model files. The wheel is the same, byte
by byte, from the same files.
"""
import argparse
import base64
import hashlib
import pathlib
import platform
import re
import subprocess
import sys
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
SONAME = "libtruckride.so.0"
FEATURES = ("CHOLMOD", "LAPACK", "NLOPT", "JSON", "ARPACK")


def build_library(minimal: bool) -> pathlib.Path:
    folder = ROOT / "build" / ("wheel-min" if minimal else "wheel")
    options = [f"-DTRUCKRIDE_WITH_{name}=OFF" for name in FEATURES] if minimal else []
    subprocess.run(["cmake", "-S", str(ROOT), "-B", str(folder), "-DCMAKE_BUILD_TYPE=Release",
                    "-DTRUCKRIDE_BUILD_TESTS=OFF", "-DTRUCKRIDE_BUILD_EXAMPLES=OFF",
                    "-DTRUCKRIDE_BUILD_STATIC=OFF", *options], check=True)
    subprocess.run(["cmake", "--build", str(folder), "--parallel"], check=True)
    return folder / "lib" / SONAME


def version() -> str:
    text = (HERE / "truckride" / "_abi.py").read_text()
    found = re.search(r'^PACKAGE_VERSION = "(.*)"', text, re.M)
    return found[1] if found else sys.exit("truckride/_abi.py has no PACKAGE_VERSION")


def metadata(number: str) -> str:
    readme = (HERE / "README.md").read_text()
    return ("Metadata-Version: 2.1\nName: truckride\n"
            f"Version: {number}\nSummary: Ride dynamics of heavy trucks\nLicense: MIT\n"
            "Requires-Python: >=3.9\nRequires-Dist: numpy\nProvides-Extra: plot\n"
            "Requires-Dist: matplotlib (>=3.5) ; extra == 'plot'\n"
            "Requires-Dist: pillow ; extra == 'plot'\n"
            f"Description-Content-Type: text/markdown\n\n{readme}")


def contents(library: pathlib.Path, number: str, tag: str) -> dict:
    """Name in the wheel -> bytes, without RECORD."""
    package = HERE / "truckride"
    files = {f"truckride/{path.relative_to(package)}": path.read_bytes()
             for path in sorted(package.rglob("*"))
             if path.suffix in (".py", ".typed") and "__pycache__" not in path.parts}
    files[f"truckride/{SONAME}"] = library.read_bytes()
    info = f"truckride-{number}.dist-info"
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    files[f"{info}/METADATA"] = metadata(number).encode()
    files[f"{info}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: build_wheel.py\n"
                              f"Root-Is-Purelib: false\nTag: {tag}\n").encode()
    return files


def record(files: dict, name: str) -> bytes:
    lines = []
    for path, data in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        lines.append(f"{path},sha256={digest},{len(data)}\n")
    return "".join(lines + [f"{name},,\n"]).encode()


def write(library: pathlib.Path, folder: pathlib.Path) -> pathlib.Path:
    number = version()
    tag = f"py3-none-linux_{platform.machine()}"
    files = contents(library, number, tag)
    name = f"truckride-{number}.dist-info/RECORD"
    files[name] = record(files, name)
    folder.mkdir(parents=True, exist_ok=True)
    wheel = folder / f"truckride-{number}-{tag}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, data in files.items():
            entry = zipfile.ZipInfo(path, (2020, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if path.endswith(SONAME) else 0o644) << 16
            archive.writestr(entry, data)
    return wheel


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--library", type=pathlib.Path)
    parser.add_argument("--min", action="store_true")
    parser.add_argument("output", nargs="?", type=pathlib.Path, default=ROOT / "build" / "dist")
    arguments = parser.parse_args()
    print(write(arguments.library or build_library(arguments.min), arguments.output))


if __name__ == "__main__":
    main()
