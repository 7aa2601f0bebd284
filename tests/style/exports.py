# SPDX-License-Identifier: MIT
"""The shared library exports exactly what the public headers declare TRK_API."""
import subprocess

from tree import declared_names


def exported_names(library, nm="nm"):
    """Defined dynamic symbols, without the name of the version node itself."""
    output = subprocess.run([nm, "-D", "--defined-only", library], check=True,
                            capture_output=True, text=True).stdout
    fields = (line.split() for line in output.splitlines())
    return {name.split("@")[0] for _, kind, name in fields if kind != "A"}


def check(root, library, nm="nm"):
    declared = declared_names(root)
    exported = exported_names(library, nm)
    for name in sorted(set(declared) - exported):
        yield f"{declared[name]}: {name} is declared, but the library does not export it"
    for name in sorted(exported - set(declared)):
        yield f"{name} is exported, but no public header declares it"
