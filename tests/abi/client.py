#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""client.py LIBRARY BASELINE_DIRECTORY [CC]: run client.c, compiled with other headers than those of
the library, against the library.

The headers are those of the baseline, and two made from them: an older one, in which every struct
that carries its size lacks its last field, and a newer one, in which it has one more. A field or function this library does not know is refused, politely.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from baseline import unpack

HERE = pathlib.Path(__file__).resolve().parent
STRUCT = re.compile(r"(\btypedef struct trk_\w+ \{\s*size_t\s+struct_size;)(.*?)(\} trk_\w+;)", re.S)


def older(text):
    return STRUCT.sub(lambda m: m[1] + re.sub(r"[^;]*;\s*\Z", "\n", m[2]) + m[3], text)


def newer(text):
    text = STRUCT.sub(r"\1\2    double newer_field;\n\3", text)
    return re.sub(r"(?m)^TRK_API", "TRK_API int32_t trk_newer_function(void);\nTRK_API", text, count=1)


def shared(path, code, cc):
    subprocess.run([cc, "-shared", "-fPIC", "-o", path, "-x", "c", "-"], input=code, text=True, check=True)


def run(headers, library, cc, *options):
    """Exit code and output of the client built with these headers."""
    with tempfile.TemporaryDirectory() as top:
        include, program, more = (pathlib.Path(top, name) for name in ("include", "client", "more.so"))
        unpack(headers, include)
        # What a newer library has besides is there for the linker and gone when the client runs.
        shared(more, "int trk_newer_function(void) { return 0; }", cc)
        subprocess.run([cc, "-std=c99", f"-I{include}", *options, HERE / "client.c", "-o", program,
                        library, more, "-lm"], check=True)
        shared(more, "", cc)
        done = subprocess.run([program], capture_output=True, text=True, timeout=60,
                              env={**os.environ, "LD_LIBRARY_PATH": str(pathlib.Path(library).parent)})
        return done.returncode, done.stdout + done.stderr


def check(library, folder, cc="cc"):
    headers = pathlib.Path(folder, "headers.txt").read_text()
    assert len(STRUCT.findall(headers)) > 10
    cases = [
        ("baseline headers", headers, [], 0, r"\Aok\n\Z"),
        ("older headers", older(headers), [], 0, r"\Aok\n\Z"),
        ("newer headers, new fields zero", newer(headers), [], 0, r"\Aok\n\Z"),
        ("newer headers, a new field set", newer(headers), ["-DSET_NEWER_FIELD"], 3,
         r"options struct has a size or field this library does not know: .*byte \d+ is set"),
        ("newer headers, a new function called", newer(headers), ["-DCALL_NEWER_FUNCTION"], 127,
         r"undefined symbol: trk_newer_function"),
    ]
    for what, text, options, code, words in cases:
        found, said = run(text, library, cc, *options)
        if found != code or not re.search(words, said):
            yield f"{what}: exit code {found}, not {code}: {said}"


if __name__ == "__main__":
    complaints = list(check(*sys.argv[1:]))
    print(*complaints, sep="\n")
    sys.exit(1 if complaints else 0)
