#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compile and run the C program of the README, and run its Python program.

usage: readme.py README LIBRARY INCLUDE_DIR CC
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

readme, library, include, compiler = sys.argv[1:5]
library = pathlib.Path(library).resolve()
text = pathlib.Path(readme).read_text()
blocks = dict(re.findall(r"^```(c|python)\n(.*?)^```", text, re.S | re.M))
environment = dict(os.environ, LD_LIBRARY_PATH=str(library.parent))


def run(*command):
    return subprocess.run(command, env=environment, check=True, text=True,
                          stdout=subprocess.PIPE).stdout.splitlines()


with tempfile.TemporaryDirectory() as folder:
    source = pathlib.Path(folder, "main.c")
    program = pathlib.Path(folder, "main")
    source.write_text(blocks["c"])
    run(compiler, "-std=c11", "-Wall", "-Werror", f"-I{include}", str(source), "-o", str(program),
        str(library))
    outputs = {"c": run(str(program)), "python": run(sys.executable, "-c", blocks["python"])}

for language, lines in outputs.items():
    print(language, *lines, sep="\n  ")
    if len(lines) < 13 or not any("front_axle" in line for line in lines):
        sys.exit(f"the {language} program of the README does not print the modes of the truck")
