# SPDX-License-Identifier: MIT
"""include/truckride/X.h <-> lib/X/ <-> tests/unit/X/: one name, one room."""
from tree import floors, public_headers


def check(root):
    floor = floors(root)
    for path in sorted((root / "lib").iterdir()):
        if path.is_dir() and path.name not in floor:
            yield f"lib/{path.name}: room is not in lib/layers.txt"
    for room in floor:
        if not list((root / "lib" / room).glob("*.c")):
            yield f"lib/{room}: room of lib/layers.txt has no source"
        if not list((root / "tests" / "unit" / room).glob("test_*.c")):
            yield f"tests/unit/{room}: room lib/{room} has no unit test"
    for path in public_headers(root):
        if path.stem not in floor:
            yield f"{path.relative_to(root)}: there is no room lib/{path.stem}"
    for path in sorted((root / "tests" / "unit").iterdir()):
        if path.name not in floor:
            yield f"tests/unit/{path.name}: there is no room lib/{path.name}"
