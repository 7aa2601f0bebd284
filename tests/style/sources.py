# SPDX-License-Identifier: MIT
"""lib/CMakeLists.txt lists every source of lib/, none twice, lowest floor first."""
import re

from tree import floors


def check(root):
    floor = floors(root)
    listing = re.sub(r"#[^\n]*", "", (root / "lib" / "CMakeLists.txt").read_text())
    listed = re.findall(r"^\s+([a-z0-9_]+/[a-z0-9_]+\.c)\b", listing, re.M)
    present = {str(path.relative_to(root / "lib")) for path in (root / "lib").rglob("*.c")}
    for name in sorted(present - set(listed)):
        yield f"lib/{name} is not in lib/CMakeLists.txt"
    for name in sorted(set(listed) - present):
        yield f"lib/{name} of lib/CMakeLists.txt does not exist"
    for name in sorted({name for name in listed if listed.count(name) > 1}):
        yield f"lib/{name} is in lib/CMakeLists.txt more than once"
    for before, after in zip(listed, listed[1:]):
        low, high = before.split("/")[0], after.split("/")[0]
        if floor.get(low, 0) > floor.get(high, 0):
            yield f"lib/CMakeLists.txt: {after} stands behind {before}, which is on a higher floor"
