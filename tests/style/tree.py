# SPDX-License-Identifier: MIT
"""What every style check needs: files of the tree, text without comments, declarations."""
import re


def lines_of(path):
    return path.read_text(encoding="utf-8").splitlines()


def public_headers(root):
    """Public headers but the umbrella, sorted."""
    folder = root / "include" / "truckride"
    return [path for path in sorted(folder.glob("*.h")) if path.name != "truckride.h"]


def floors(root):
    """Floor number of each room, lowest first (lib/layers.txt: one floor a line)."""
    text = (root / "lib" / "layers.txt").read_text()
    return {room: floor for floor, line in enumerate(text.splitlines()) for room in line.split()}


def blank(text, comments=True, strings=False):
    """Text with comments (and string literals) replaced by spaces, newlines kept."""
    pattern = r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\''

    def replace(match):
        found = match[0]
        wanted = comments if found.startswith("/") else strings
        return re.sub(r"[^\n]", " ", found) if wanted else found

    return re.sub(pattern, replace, text, flags=re.S)


def comments_of(text):
    """(line, comment) of each comment of C text."""
    pattern = r'"(?:\\.|[^"\\\n])*"|(//[^\n]*|/\*.*?\*/)'
    for match in re.finditer(pattern, text, re.S):
        if match[1]:
            yield text.count("\n", 0, match.start()) + 1, match[1]


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def declared_names(root):
    """Functions and objects declared TRK_API in the public headers: name -> file:line."""
    names = {}
    for path in public_headers(root):
        text = blank(path.read_text())
        text = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda m: re.sub(r"[^\n]", " ", m[0]), text,
                      flags=re.M)
        for match in re.finditer(r"\bTRK_API\b([^;(]*?)(\w+)\s*(?:\(|\[|;)", text):
            names[match[2]] = f"{path.relative_to(root)}:{line_of(text, match.start())}"
    return names
