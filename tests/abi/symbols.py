#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""symbols.py LIBRARY VERSION FILE: bring the symbols file of the Debian package up to date.

Each function keeps the version in which it first appeared; new ones get VERSION. A function that
is gone is an error: programs need it. (The package's build fails while the file is not up to date.)
"""
import pathlib
import re
import subprocess
import sys

HEAD = "libtruckride.so.0 libtruckride0 #MINVER#\n* Build-Depends-Package: libtruckride-dev\n"


def main(library, version, path):
    path = pathlib.Path(path)
    since = dict(re.findall(r"^ (\S+) (\S+)$", path.read_text(), re.M)) if path.exists() else {}
    nm = subprocess.run(["nm", "-D", "--defined-only", library], check=True, capture_output=True, text=True)
    present = {line.split()[-1].replace("@@", "@") for line in nm.stdout.splitlines()}
    present = {name if "@" in name else f"{name}@{name}" for name in present} # the node itself
    gone = sorted(set(since) - present)
    if gone:
        sys.exit(f"no longer exported: {', '.join(gone)}")
    lines = (f" {name} {since.get(name, version)}\n" for name in sorted(present))
    path.write_text(HEAD + "".join(lines))


if __name__ == "__main__":
    main(*sys.argv[1:])
