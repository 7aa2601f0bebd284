# SPDX-License-Identifier: MIT
"""Every source file names its licence on the first line (the second after #!)."""
from tree import lines_of

FOLDERS = "include lib examples tests bindings pkgconfig .ci"
SUFFIXES = {".c", ".h", ".cpp", ".py", ".sh", ".cmake", ".m", ".map", ".gp"}


def check(root):
    for folder in FOLDERS.split():
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in SUFFIXES and path.name != "CMakeLists.txt":
                continue
            head = lines_of(path)[:2]
            wanted = head[1:] if head and head[0].startswith("#!") else head[:1]
            if not wanted or "SPDX-License-Identifier: MIT" not in wanted[0]:
                yield f"{path.relative_to(root)}:1: SPDX-License-Identifier is missing"
