#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""run.py ROOT BUILD CMAKE CC [PAGE...]: compile and run every code block of README.md and docs/,
as a user of an installed library would (pages.py says how blocks make programs)."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from pages import pages_of

FLAGS = ["-std=c11", "-D_POSIX_C_SOURCE=200809L", "-Wall", "-Wextra", "-Werror"]
PROJECT = "cmake_minimum_required(VERSION 3.20)\nproject(app C)\nadd_executable(app main.c)\n"


class Failed(Exception):
    pass


class Place:
    """An installed library, and a folder to work in."""

    def __init__(self, root, build, cmake, cc, top):
        self.root, self.cmake, self.cc, self.top = root, cmake, cc, top
        prefix = top / "prefix"
        self.environment = dict(os.environ)
        self.run([cmake, "--install", build, "--prefix", prefix])
        pkgconfig = next(prefix.rglob("pkgconfig"))
        self.environment.update(
            CC=cc, HOME=str(top), CMAKE_PREFIX_PATH=str(prefix), PKG_CONFIG_PATH=str(pkgconfig),
            PATH=os.pathsep.join([str(prefix / "bin"), os.environ["PATH"]]),
            LD_LIBRARY_PATH=str(pkgconfig.parent), PYTHONPATH=str(root / "bindings" / "python"),
            PYTHONDONTWRITEBYTECODE="1", TRUCKRIDE_REUSE=str(build),
            CMAKE_C_COMPILER_LAUNCHER=str(root / "tests" / "consumer" / "reuse.sh"))
        self.link = self.run(["pkg-config", "--cflags", "--libs", "truckride"]).split()
        self.preamble = "".join(block for page in pages_of(root) for block in page.of("c preamble"))

    def run(self, command, folder=None):
        done = subprocess.run(command, cwd=folder or self.top, env=self.environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300)
        if done.returncode:
            raise Failed(f"{' '.join(map(str, command))[:200]} ended with {done.returncode}:\n{done.stdout}")
        return done.stdout

    def tree(self):
        """A copy of the tree, for shell commands that stand in the README."""
        tree = self.top / "tree"
        if not tree.exists():
            tree.mkdir()
            for path in self.root.iterdir():
                if path.name not in (".git", "build", "results"):
                    self.run(["cp", "-r", path, tree])
        return tree


def run_c(place, page):
    for source in page.c_programs(place.preamble):
        (place.top / "main.c").write_text(source)
        place.run([place.cc, *FLAGS, "main.c", "-o", "main", *place.link, "-lm", "-pthread"])
        yield place.run(["./main"])


def run_python(place, page):
    if page.of("python"):
        yield place.run([sys.executable, "-c", "\n".join(page.of("python"))])


def run_cmake(place, page):
    for number, block in enumerate(page.of("cmake")):
        folder = place.top / f"{page.name.replace('/', '_')}.{number}"
        folder.mkdir()
        (folder / "main.c").write_text(page.c_programs(place.preamble)[0])
        (folder / "CMakeLists.txt").write_text(block if "project(" in block else PROJECT + block)
        place.run([place.cmake, "-S", folder, "-B", folder / "build"])
        place.run([place.cmake, "--build", folder / "build"])
        yield place.run([folder / "build" / "app"])


def run_sh(place, page):
    script, elsewhere = page.shell()
    ci = "".join(path.read_text() for path in (place.root / ".ci").iterdir())
    for line in elsewhere:
        script_of_ci = re.match(r"bash (\.ci/\w+)", line)
        if not ((place.root / script_of_ci[1]).exists() if script_of_ci else line in ci):
            raise Failed(f"no script of .ci runs {line!r}")
    if script:
        for source in page.c_programs(place.preamble)[:1]:
            (place.tree() / "main.c").write_text(source)
        yield place.run(["bash", "-euo", "pipefail", "-c", "\n".join(script)], place.tree())


RUNNERS = {"c": run_c, "python": run_python, "cmake": run_cmake, "sh": run_sh}


def complaints(place, page):
    yield from page.complaints()
    output = {}
    for name, text in page.files():
        (place.top / name).write_text(text)
    for language, runner in RUNNERS.items():
        try:
            output[language] = "".join(runner(place, page))
        except (Failed, subprocess.TimeoutExpired) as failure:
            yield f"{page.name}: {failure}"
    for languages, wanted in page.expected():
        for language in languages or ["nothing"]:
            if wanted not in output.get(language, ""):
                yield (f"{page.name}: {language} does not print these lines:\n{wanted}"
                       f"--- but:\n{output.get(language)}")


def main(root, build, cmake, cc, *names):
    failures = 0
    with tempfile.TemporaryDirectory() as top:
        place = Place(pathlib.Path(root), build, cmake, cc, pathlib.Path(top))
        pages = [page for page in pages_of(place.root) if not names or page.name in names]
        for page in pages:
            for complaint in complaints(place, page):
                failures += 1
                print(complaint)
        print(f"{len(pages)} pages, {sum(len(page.blocks) for page in pages)} blocks, {failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
