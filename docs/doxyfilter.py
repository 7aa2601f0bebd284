#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""doxyfilter.py HEADER: the header as Doxygen should read it.

A comment stands for all declarations that follow it without an empty line, which Doxygen gives
to the first alone: it is repeated for the others. The list of statuses becomes an enum with comments.
"""
import re
import sys

COMMENT = r"/\*\*(?!<)(?:[^*]|\*(?!/))*\*/\n"
DECLARATION = r"(?:TRK_API[^;]*;|#define \w+ [^\n\\]*)\n"


def repeated(match):
    return "".join(match[1] + declaration for declaration in re.findall(DECLARATION, match[2]))


def filtered(text):
    text = re.sub(rf"({COMMENT})((?:{DECLARATION}){{2,}})", repeated, text)
    statuses = re.findall(r'X\((TRK_\w+), +(\d+), +("[^"]*")\)', text)
    if statuses:
        values = "".join(f"{name} = {value}, /**< {words[1:-1]} */\n" for name, value, words in statuses)
        text = re.sub(r"enum \{ TRK_STATUS_LIST[^}]*\}", lambda _: f"enum {{\n{values}}}", text)
    return text


with open(sys.argv[1], encoding="utf-8") as header:
    sys.stdout.write(filtered(header.read()))
