# SPDX-License-Identifier: MIT
"""Every double of a public header carries its [unit]: fields, returns, parameters, macros.

A field states it in the comment behind it or above it, a parameter in its @param, or, when it
has none, in the text of its function. A comment stands for all declarations that follow it
without an empty line.
"""
import re

from tree import line_of, public_headers

UNIT = re.compile(r"(?<![\w\])])\[[^\][\n]+\]")
REAL = r"(?:double|float)"
COMMENT = r"/\*(?:[^*]|\*(?!/))*\*/"


def fields(text, body, start):
    """Fields of a struct that hold numbers without a unit."""
    field = re.compile(rf"(?P<above>(?:{COMMENT}\s*)*)(?P<code>[^;/]*;)(?P<behind>[ \t]*{COMMENT})?")
    for match in field.finditer(body):
        if not re.match(rf"\s*(?:const\s+)?{REAL}\b", match["code"]):
            continue
        comment = match["behind"] or match["above"] or ""
        if not UNIT.search(comment):
            position = start + match.start("code") + len(match["code"]) - len(match["code"].lstrip())
            yield line_of(text, position), f"field without [unit]: {' '.join(match['code'].split())}"


def prose(doc):
    """Text of a function without that of its parameters."""
    return re.sub(r"@param.*?(?=@|\Z)", "", doc, flags=re.S)


def parameters(doc, arguments):
    """Names of the parameters that hold numbers without a unit."""
    for name in re.findall(rf"\b{REAL}\s*(?:const\s*)?\**\s*(\w+)", arguments):
        own = re.search(rf"@param\s+{name}\b((?:(?!@param|@ret).)*)", doc, re.S)
        if not UNIT.search(own[1] if own else prose(doc)):
            yield name


def functions(text):
    """Declarations and callback types, each with the comment that stands for it."""
    doc, end = None, 0
    pattern = re.compile(rf"(?P<doc>/\*\*(?!<)(?:[^*]|\*(?!/))*\*/)"
                         r"|(?P<code>^(?:TRK_API|typedef)\b[^;{]*\([^;{]*;)", re.M)
    for match in pattern.finditer(text):
        if match["doc"]:
            doc, end = match["doc"], match.end()
            continue
        if text[end:match.start()].count("\n") > 1:
            doc = None
        end = match.end()
        yield match["code"], doc, line_of(text, match.start())


def check(root):
    for path in public_headers(root):
        name, text = path.relative_to(root), path.read_text()
        for match in re.finditer(r"\bstruct\s+\w*\s*\{(.*?)\n\}", text, re.S):
            for line, complaint in fields(text, match[1], match.start(1)):
                yield f"{name}:{line}: {complaint}"
        for code, doc, line in functions(text):
            function = re.search(r"(\w+)\s*\)?\s*\(", code)[1]
            if doc is None:
                yield f"{name}:{line}: {function} has no comment"
                continue
            if re.match(rf"(?:TRK_API|typedef)\s+(?:const\s+)?{REAL}\b", code) and not UNIT.search(prose(doc)):
                yield f"{name}:{line}: {function} returns a number without [unit]"
            for parameter in parameters(doc, code[code.index("("):]):
                yield f"{name}:{line}: {function}: parameter without [unit]: {parameter}"
        for match in re.finditer(rf"({COMMENT})?\s*^#\s*define (\w+)\s+[-(]*\d+\.\d*(.*)$", text, re.M):
            if not UNIT.search((match[1] or "") + match[3]):
                yield f"{name}:{line_of(text, match.start(2))}: {match[2]} is a number without [unit]"
