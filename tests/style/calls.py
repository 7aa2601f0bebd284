# SPDX-License-Identifier: MIT
"""The library never prints, exits, reads the environment or sets the locale, and takes
memory only from its context."""
import re

from tree import blank, line_of

FORBIDDEN = {
    "prints": "printf vprintf puts putchar perror",
    "ends or interrupts the process": "exit _exit _Exit quick_exit abort raise signal assert system",
    "reads the environment": "getenv secure_getenv",
    "sets or follows the locale of the process": "setlocale atof",
    "keeps hidden state": "rand srand strtok localtime gmtime strerror",
    "may write beyond its buffer": "sprintf vsprintf strcpy strcat gets",
    "bypasses the context's memory": "malloc calloc realloc free aligned_alloc posix_memalign strdup alloca",
}
# The one place where a context without an allocation function of the caller gets its own.
ALLOWED = {"lib/base/context.c": {"realloc", "free"}}


def check(root):
    reason = {name: why for why, names in FORBIDDEN.items() for name in names.split()}
    call = re.compile(r"(?<![\w.>])(" + "|".join(reason) + r")\s*\(")
    for path in sorted((root / "lib").rglob("*.[ch]")):
        name = str(path.relative_to(root))
        text = blank(path.read_text(), strings=True)
        for match in call.finditer(text):
            if match[1] not in ALLOWED.get(name, ()):
                yield f"{name}:{line_of(text, match.start())}: {match[1]} {reason[match[1]]}"
        for match in re.finditer(r"\b(stdout|stderr)\b", text):
            yield f"{name}:{line_of(text, match.start())}: {match[1]} prints"
