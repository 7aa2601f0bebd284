# SPDX-License-Identifier: MIT
"""Code blocks of Markdown pages, and the programs they make.

    c         a block with main() is a program; the others of a page make one program together:
              those that begin with "static", "typedef" or "#" stand before main, the rest inside, as
              docs/howto.md says
    python    the blocks of a page make one program
    sh        the blocks of a page make one script, run in a copy of the tree; of lines that call
              .ci the script must exist, lines that need root must stand in a script of .ci
    cmake     a project that builds the page's first C program as "app"
    output    what the programs of the blocks before it print, in each of their languages
    json NAME, csv NAME
              a file of that name in the folder in which programs run
    text      anything else
"""
import re

LANGUAGES = {"c", "c preamble", "python", "sh", "cmake", "output", "text"}
FILE = re.compile(r"(?:json|csv) ([\w.]+)")
OUTSIDE = re.compile(r"static|typedef|#")
ELSEWHERE = re.compile(r"\b(apt-get|apt|ldconfig|dpkg|dpkg-buildpackage)\b|^bash \.ci/")


class Page:
    def __init__(self, name, text):
        self.name, self.text = name, text
        self.blocks = re.findall(r"^```([^\n]*)\n(.*?)^```$", text, re.S | re.M)

    def of(self, language):
        return [body for info, body in self.blocks if info.split("#")[0].strip() == language]

    def files(self):
        """(name, text) of the files that its programs read."""
        return [(FILE.fullmatch(info)[1], body) for info, body in self.blocks if FILE.fullmatch(info)]

    def complaints(self):
        """What is written so that no test could run it."""
        for info, body in self.blocks:
            if info not in LANGUAGES and not FILE.fullmatch(info):
                yield f"{self.name}: block marked {info!r}, not one of {', '.join(sorted(LANGUAGES))}: {body[:40]!r}"
        prose = re.sub(r"^```.*?^```$", "", self.text, flags=re.S | re.M)
        if "```" in prose:
            yield f"{self.name}: a block does not end, or is indented"
        # Equations of the theory are set by indentation; code must not hide that way.
        if not self.name.startswith("docs/theory/"):
            for match in re.finditer(r"(?m)^(?![-*\d ]).*\n\n    .*", prose):
                yield f"{self.name}: indented block: {match[0].splitlines()[-1]!r}"

    def c_programs(self, preamble):
        whole = [block for block in self.of("c") if re.search(r"^int main\(", block, re.M)]
        parts = [block for block in self.of("c") if block not in whole]
        if parts:
            outside = "\n".join(part for part in parts if OUTSIDE.match(part))
            inside = "\n".join(part for part in parts if not OUTSIDE.match(part))
            whole.append(f"{preamble}{outside}\nint main(void)\n{{\n    trk_context *context = NULL;\n"
                         f"    TRY(trk_context_create(NULL, NULL, &context));\n{inside}\n"
                         '    if (trk_context_blocks(context) != 0)\n        return puts("something is not freed"), 1;\n'
                         f"    trk_context_destroy(context);\n    return 0;\n}}\n")
        return whole

    def expected(self):
        """(languages, text): output, and the languages of the blocks since the one before."""
        languages = set()
        for info, body in self.blocks:
            if info == "output":
                yield sorted(languages), body
                languages = set()
            elif info in ("c", "python", "sh"):
                languages.add(info)

    def shell(self):
        """Script to run, and the commands that a script of .ci must hold."""
        lines = [line for block in self.of("sh") for line in block.splitlines()]
        lines = [re.sub(r"\s+# .*", "", line) for line in lines if line and not line.startswith("#")]
        return ([line for line in lines if not ELSEWHERE.search(line)],
                [line for line in lines if ELSEWHERE.search(line)])


def pages_of(root):
    paths = [root / "README.md", *sorted((root / "docs").rglob("*.md"))]
    return [Page(str(path.relative_to(root)), path.read_text(encoding="utf-8")) for path in paths]
