# SPDX-License-Identifier: MIT
"""What the public headers declare: constants, enums, structs, callbacks, functions."""
from __future__ import annotations

import dataclasses
import pathlib
import re
import subprocess
import tempfile
from typing import Any

from pycparser import c_ast, c_parser

# Stand-ins for the two standard headers, so that the parser sees no compiler's own.
STANDARD = {
    "stddef.h": "typedef unsigned long size_t;\n",
    "stdint.h": "typedef int int32_t;\ntypedef long int64_t;\n",
}


@dataclasses.dataclass
class Type:
    """Base name, number of pointers to it, array length (0: no array)."""

    name: str
    pointers: int = 0
    length: int = 0


@dataclasses.dataclass
class Field:
    name: str
    type: Type
    comment: str = ""


@dataclasses.dataclass
class Struct:
    name: str
    fields: list[Field]
    comment: str = ""


@dataclasses.dataclass
class Enum:
    """An enum with the typedef that precedes it, "" if it has none."""

    name: str
    values: dict[str, int]


@dataclasses.dataclass
class Function:
    name: str
    result: Type
    arguments: list[Type]
    header: str = ""


@dataclasses.dataclass
class Headers:
    version: tuple[int, ...]
    aliases: dict[str, str] = dataclasses.field(default_factory=dict)  # trk_status -> int32_t
    doubles: dict[str, float] = dataclasses.field(default_factory=dict)
    enums: list[Enum] = dataclasses.field(default_factory=list)
    opaque: list[str] = dataclasses.field(default_factory=list)
    structs: dict[str, Struct] = dataclasses.field(default_factory=dict)
    callbacks: dict[str, Function] = dataclasses.field(default_factory=dict)
    functions: list[Function] = dataclasses.field(default_factory=list)


def preprocess(include: pathlib.Path, compiler: str) -> str:
    with tempfile.TemporaryDirectory() as folder:
        for name, text in STANDARD.items():
            pathlib.Path(folder, name).write_text(text)
        command = [compiler, "-E", "-nostdinc", "-I", folder, "-I", str(include),
                   "-D__attribute__(x)=", str(include / "truckride" / "truckride.h")]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def evaluate(node: Any, known: dict[str, int]) -> int:
    """Value of a constant expression of an enum or array length."""
    if isinstance(node, c_ast.Constant):
        return int(node.value.rstrip("uUlL"), 0)
    if isinstance(node, c_ast.ID):
        return known[node.name]
    if isinstance(node, c_ast.UnaryOp) and node.op == "-":
        return -evaluate(node.expr, known)
    left, right = evaluate(node.left, known), evaluate(node.right, known)
    return {"+": left + right, "-": left - right, "*": left * right, "<<": left << right,
            "|": left | right}[node.op]


def type_of(node: Any, known: dict[str, int]) -> Type:
    if isinstance(node, c_ast.ArrayDecl):
        inner = type_of(node.type, known)
        return Type(inner.name, inner.pointers, evaluate(node.dim, known) if node.dim else 0)
    if isinstance(node, c_ast.PtrDecl):
        inner = type_of(node.type, known)
        return Type(inner.name, inner.pointers + 1)
    if isinstance(node, (c_ast.TypeDecl, c_ast.Typename)):
        return type_of(node.type, known)
    if isinstance(node, c_ast.Struct):
        return Type(node.name)
    return Type(" ".join(node.names))


def function_of(name: str, node: Any, known: dict[str, int]) -> Function:
    arguments = [type_of(p.type, known) for p in (node.args.params if node.args else [])]
    if len(arguments) == 1 and arguments[0] == Type("void"):
        arguments = []
    return Function(name, type_of(node.type, known), arguments)


def enum_values(node: Any, known: dict[str, int]) -> dict[str, int]:
    values: dict[str, int] = {}
    following = 0
    for item in node.values.enumerators:
        following = evaluate(item.value, known) if item.value else following
        known[item.name] = following
        if not item.name.endswith(("_END", "_END_")):  # the end mark of the list is no status
            values[item.name] = following
        following += 1
    return values


def collect(tree: Any, out: Headers) -> None:
    known: dict[str, int] = {}
    before = ""
    for node in tree.ext:
        if isinstance(node, c_ast.Typedef):
            kind = node.type
            if isinstance(kind, c_ast.PtrDecl) and isinstance(kind.type, c_ast.FuncDecl):
                out.callbacks[node.name] = function_of(node.name, kind.type, known)
            elif isinstance(kind.type, c_ast.Struct) and kind.type.decls:
                fields = [Field(d.name, type_of(d.type, known)) for d in kind.type.decls]
                out.structs[node.name] = Struct(node.name, fields)
            elif isinstance(kind.type, c_ast.Struct):
                out.opaque.append(node.name)
            elif node.name.startswith("trk_"):
                out.aliases[node.name] = type_of(kind, known).name
                before = node.name
                continue
        elif isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.Enum):
            out.enums.append(Enum(before, enum_values(node.type, known)))
        elif isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.FuncDecl):
            function = function_of(node.name, node.type, known)
            function.header = pathlib.Path(str(node.coord.file)).name
            out.functions.append(function)
        before = ""


def add_comments(text: str, structs: dict[str, Struct]) -> None:
    """The parser drops comments: find those of the structs in the text itself."""
    pattern = (r"(?:/\*\*((?:(?!\*/).)*)\*/\n)?typedef struct (trk_\w+) \{\n(.*?)^\} \2;")
    for comment, name, body in re.findall(pattern, text, re.S | re.M):
        struct = structs.get(name)
        if not struct:
            continue  # of a header that is not in the umbrella
        struct.comment = re.sub(r"\s*\n\s*\* ?", " ", comment).strip()
        found = dict(re.findall(r"(\w+)(?:\[\w+\])?;\s*/\*\*<\s*(.*?)\s*\*/", body, re.S))
        for field in struct.fields:
            field.comment = re.sub(r"\s+", " ", found.get(field.name, ""))


def read(include: pathlib.Path, compiler: str = "cc") -> Headers:
    folder = include / "truckride"
    base = (folder / "base.h").read_text()
    version = re.findall(r"#define TRK_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", base)
    out = Headers(tuple(int(number) for number in version))
    collect(c_parser.CParser().parse(preprocess(include, compiler)), out)
    for path in sorted(folder.glob("*.h")):
        text = path.read_text()
        add_comments(text, out.structs)
        for name, value in re.findall(r"#define (TRK_\w+)\s+(\d+(?:\.\d+|e\d+))\b", text, re.M):
            out.doubles[name] = float(value)
    return out
