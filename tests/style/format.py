# SPDX-License-Identifier: MIT
"""C files are formatted as .clang-format says. Public headers are set by hand, as tables."""
import collections
import subprocess


def check(root, clang_format="clang-format"):
    files = [path for folder in ("lib", "examples", "tests", "bindings")
             for path in sorted((root / folder).rglob("*.[ch]"))]
    command = [clang_format, "--dry-run", "-Werror", *files]
    run = subprocess.run(command, capture_output=True, text=True)
    places = collections.Counter(line.split(":")[0].replace(f"{root}/", "")
                                 for line in run.stderr.splitlines() if ": error:" in line)
    for name, count in places.items():
        yield f"{name}: {count} places are not formatted (cmake --build build/dev --target format)"
    if run.returncode and not places:
        yield run.stderr.strip()
