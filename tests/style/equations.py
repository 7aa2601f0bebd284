# SPDX-License-Identifier: MIT
"""Every equation id SECTION.n cited in the headers or in lib/ stands in docs/theory/section.md."""
import re

from tree import comments_of


def check(root):
    known = {}
    for path in sorted((root / "docs" / "theory").glob("*.md")):
        # An equation is numbered at its right, or by the heading of its paragraph.
        known[path.stem.upper()] = set(
            re.findall(r"(?:\(|^#+ )([A-Z][A-Z0-9]+\.\d+)\b", path.read_text(), re.M))
    files = [*(root / "include").rglob("*.h"), *(root / "lib").rglob("*.[ch]")]
    for path in sorted(files):
        for line, comment in comments_of(path.read_text()):
            for match in re.finditer(r"\b([A-Z][A-Z0-9]+)\.\d+\b", comment):
                if match[0] in known.get(match[1], ()):
                    continue
                at = line + comment.count("\n", 0, match.start())
                yield (f"{path.relative_to(root)}:{at}: equation ({match[0]}) does not stand in "
                       f"docs/theory/{match[1].lower()}.md")
