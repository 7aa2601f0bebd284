#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""schema.py ROOT LIBRARY: the schema of model files is one, every shipped file and every example of the
guide follows it, and its keys are those that the library knows. Exit 77 without jsonschema."""
import ctypes
import json
import pathlib
import re
import sys

try:
    from jsonschema import Draft202012Validator
except ImportError:
    print("python3-jsonschema is not installed")
    sys.exit(77)

UNKNOWN = {"zzzzzzzz": 0}
WALLED = {"height": 1, "width": 1, "web": 0.1, "flange": 0.1}


def probes():
    """(path in the schema, model file in which that group has a key nobody knows)"""
    sections = {"curves": "curve", "materials": "material", "sections": "section", "bodies": "body", "roads": "road",
                "frames": "frame", "axles": "axle", "beams": "beam", "masses": "mass", "mounts": "mount",
                "links": "link", "anti_roll_bars": "anti_roll_bar", "ports": "port", "sensors": "sensor"}
    for section, what in sections.items():
        yield [what], {section: {"n": UNKNOWN}}
    for law in "tire stops leaf friction air_spring seal".split():
        yield ["law", law], {"laws": {"n": {law: UNKNOWN}}}
    for form in "channel box rectangle tube".split():
        yield ["section", form], {"sections": {"n": {form: UNKNOWN, "material": "m"}}}
    axle = {"x": 0, "mass": 1, "frame": "b"}
    for group in "tires springs dampers bump_stops".split():
        yield ["axle", group], {"bodies": {"b": {}}, "axles": {"n": {**axle, group: UNKNOWN}}}
    yield ["axle", "anti_roll_bar"], {"axles": {"n": {**axle, "anti_roll_bar": UNKNOWN}}}
    yield ["arm"], {"bodies": {"b": {}}, "mounts": {"n": {"from": "b", "to": "b", "vertical": UNKNOWN}}}
    yield ["end"], {"bodies": {"b": {}}, "links": {"n": {"from": UNKNOWN, "to": "b"}}}
    yield ["stock"], {"frames": {"n": {"stations": [0, 1], "cross_members": [0], "half_width": 1,
                                       "rail": UNKNOWN, "member": {}}}}


class Library:
    def __init__(self, path):
        self.library = ctypes.CDLL(path)
        self.library.trk_context_message.restype = ctypes.c_char_p
        self.context = ctypes.c_void_p()
        self.library.trk_context_create(None, None, ctypes.byref(self.context))

    def complaint(self, sections):
        text = json.dumps({"truckride_model": 1, "name": "probe", **sections}).encode()
        spec = ctypes.c_void_p()
        status = self.library.trk_model_file_parse(self.context, text, ctypes.c_size_t(len(text)), b"probe", None,
                                                   ctypes.byref(spec))
        return self.library.trk_context_message(self.context).decode() if status else "nothing"


def group_of(schema, path):
    """The group at a path, through references and the alternatives that are no group."""
    at = schema["$defs"][path[0]]
    for key in [*path[1:], None]:
        while "properties" not in at:
            at = (schema["$defs"][at["$ref"].rsplit("/", 1)[1]] if "$ref" in at
                  else next(one for one in at["anyOf"] if "properties" in one))
        at = at["properties"][key] if key else at
    return at["properties"]


def complaints(root, library):
    schema = json.loads((root / "docs" / "truckride-model.schema.json").read_text())
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    files = {path.name: path.read_text() for path in sorted((root / "examples" / "models").glob("*.json"))}
    guide = (root / "docs" / "model-files.md").read_text()
    for number, block in enumerate(re.findall(r"^```json[^\n]*\n(.*?)^```$", guide, re.S | re.M), 1):
        files[f"model-files.md, example {number}"] = block
    for name, text in files.items():
        for error in validator.iter_errors(json.loads(text)):
            yield f"{name}: {'/'.join(map(str, error.absolute_path))}: {error.message[:200]}"
    for path, sections in probes():
        found = library.complaint(sections)
        known = re.search(r"which may have: (.*)$", found)
        if not known or set(known[1].split(", ")) != set(group_of(schema, path)):
            yield f"{'/'.join(path)}: the schema has {sorted(group_of(schema, path))}, the library says: {found}"
    found = library.complaint({"laws": {"n": UNKNOWN}})
    for law in set(group_of(schema, ["law"])) - {"name"}:
        if law not in found:
            yield f"the library knows no law {law}: {found}"
    wrong = [{"truckride_model": 1}, {"truckride_model": 2, "name": "x"}, {"truckride_model": 1, "name": "x", "wings": {}},
             {"truckride_model": 1, "name": "x", "bodies": {"a": {"mass": -1}}},
             {"truckride_model": 1, "name": "x", "sections": {"s": {"box": WALLED, "tube": {}, "material": "m"}}}]
    for text in wrong:
        if validator.is_valid(text):
            yield f"the schema accepts {text}"
    print(f"{len(files)} files, {len(list(probes()))} groups")


def main(root, library):
    found = list(complaints(pathlib.Path(root), Library(library)))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
