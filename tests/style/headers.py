# SPDX-License-Identifier: MIT
"""Every public header compiles alone, as C99 and as C++11, without a warning."""
import subprocess

FLAGS = "-fsyntax-only -pedantic-errors -Wall -Wextra -Werror".split()


def check(root, cc="cc", cxx="c++"):
    for path in sorted((root / "include" / "truckride").glob("*.h")):
        for language, compiler in ("c99", cc), ("c++11", cxx):
            # Twice: the include guard is part of the header.
            source = f"#include <truckride/{path.name}>\n" * 2
            command = [compiler, f"-std={language}", *FLAGS, f"-I{root}/include",
                       "-x", "c++" if "++" in language else "c", "-"]
            run = subprocess.run(command, input=source, capture_output=True, text=True)
            if run.returncode:
                yield f"{path.relative_to(root)} as {language}:\n{run.stderr.strip()}"
