# SPDX-License-Identifier: MIT
"""A room of lib/ includes only rooms on lower floors, with paths "room/file.h"."""
import re

from tree import floors, lines_of


def check(root):
    floor = floors(root)
    for path in sorted((root / "lib").rglob("*.[ch]")):
        room = path.relative_to(root / "lib").parts[0]
        for number, line in enumerate(lines_of(path), 1):
            match = re.match(r'\s*#\s*include\s+"([^"]*)"', line)
            if not match:
                continue
            where = f"{path.relative_to(root)}:{number}"
            other = match[1].split("/")[0]
            if "/" not in match[1] or other not in floor:
                yield f'{where}: include "{match[1]}" does not name a room: write "room/file.h"'
            elif other != room and floor[other] >= floor.get(room, -1):
                yield f"{where}: {room} must not include {other}, which is not on a lower floor"
