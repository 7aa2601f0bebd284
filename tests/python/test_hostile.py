# SPDX-License-Identifier: MIT
"""Every function of the headers with NULL for each pointer in turn, with options of every size;
every class of the package with objects of other classes and numbers that do not fit.

Functions and types are read from the headers, so that a new function is asked too."""
import copy
import ctypes
import math
import os
import pickle
import re
import subprocess
import sys

import numpy as np
import pytest

from conftest import ROOT  # says where the package is

import truckride as tr
from truckride import _abi

OPTIONS = tr.Status.OPTIONS
CALLBACKS = "trk_allocate", "trk_log", "trk_progress", "trk_batch_sink"
SURFACE = (b"$CT\n$\n$ROAD_CRG\nREFERENCE_LINE_INCREMENT = 1\nLONG_SECTION_V_RIGHT = -1\n"
           b"LONG_SECTION_V_LEFT = 1\n$\n$KD_DEFINITION\n#:LRFI\nD:long section 1,m\n"
           b"D:long section 2,m\n$\n$$$$\n" + b"0.0100000 0.0200000 \n" * 5)
ROOM = 4096
SENTINEL = 0x5A5A


def functions():
    """name: (type of the result, types of the parameters)"""
    found, folder = {}, ROOT / "include" / "truckride"
    for header in re.findall(r"#include <truckride/(\w+\.h)>", (folder / "truckride.h").read_text()):
        text = re.sub(r"/\*.*?\*/", "", (folder / header).read_text(), flags=re.S)
        for result, name, parameters in re.findall(
                r"^TRK_API\b([^;(]*?)\b(trk_\w+)\s*\(([^;]*?)\)[^;()]*;", text, re.M | re.S):
            kinds = [re.sub(r"\s*\b\w+(\[\d*\])?\s*$", lambda m: "*" if m[1] else "", one.strip())
                     for one in parameters.split(",") if one.strip() != "void"]
            found[name] = result.strip(), [re.sub(r"\s*\*\s*", "*", kind) for kind in kinds]
    return found


def objects():
    """An address of each class of object, and what keeps it."""
    spec = tr.vehicle("reference_half", "thesis_dampers")
    model = spec.compile()
    excitation = tr.Excitation(model, tr.Signal.sine(0.001, 2))
    study = tr.Study(spec, points=2, duration=0.05)
    study.add_parameter("tire", "front_tire")
    study.add_output("rms", model.sensors[0])
    study.add_excitation("road", excitation)
    calibration = tr.Calibration(spec)
    calibration.add_parameter("tire", "front_tire")
    calibration.target_frequency("axle", 11, "front_axle.z")
    made = {"law": tr.Law("leaf", friction=2500, approach_bump=0.002),
            "spec": spec, "model": model, "excitation": excitation, "study": study,
            "calibration": calibration, "signal": tr.Signal.sine(0.001, 2),
            "curve": tr.Curve([0, 1, 2, 3], [0, 1, 2, 4]), "modes": model.modes(),
            "crg": tr.Surface(SURFACE),
            "series": tr.Series({"a": np.arange(50.0)}, 100), "newmark": tr.Newmark(model),
            "rungekutta": tr.RungeKutta(model, step=1e-4),
            "weighting_filter": tr.comfort.WeightingFilter("wk", 500),
            "vibration_meter": tr.comfort.VibrationMeter(500)}
    places = {f"trk_{name}": item._live()._as_parameter_.value for name, item in made.items()}
    places["trk_context"] = made["curve"]._live().context
    return places, made


class Caller:
    """Calls functions with arguments that are right as far as their types tell."""

    def __init__(self):
        self.library = ctypes.CDLL(tr.library_path)
        self.places, self.made = objects()
        self.doubles = (ctypes.c_double * 200000)(*np.linspace(0.1, 1, 1000))
        self.integers = {4: (ctypes.c_int32 * 1000)(*[1] * 1000), 8: (ctypes.c_int64 * 1000)()}
        self.keep = []

    def block(self, struct, size=None, tail=0):
        """Options with their defaults in a large block."""
        memory = (ctypes.c_ubyte * ROOM)()
        init = getattr(self.library, f"{struct}_init", None)
        fields = getattr(_abi, struct, None)
        length = ctypes.sizeof(fields) if fields else ROOM
        if init:
            init(memory, ctypes.c_size_t(length))
        memory[ROOM - 1] = tail
        ctypes.c_size_t.from_buffer(memory).value = length if size is None else size
        return memory

    def argument(self, kind, name):
        stars, base = kind.count("*"), re.sub(r"\bconst\b|\*", " ", kind).split()[0]
        if stars == 2 and "const" in kind or stars == 2 and base == "double":
            one = self.doubles if base == "double" else self.places.get(base)
            address = ctypes.addressof(one) if base == "double" else one
            return (ctypes.c_void_p * 16)(*[address] * 16)
        if stars == 2:
            return (ctypes.c_void_p * 1)(SENTINEL)
        if stars == 0:
            by_value = {"double": ctypes.c_double(0.01), "int64_t": ctypes.c_int64(4),
                        "size_t": ctypes.c_size_t(ROOM if name.endswith("_init") else 1)}
            return None if base in CALLBACKS else by_value.get(base, ctypes.c_int32(1))
        if base == "char":
            return ctypes.create_string_buffer(b"x" * 8) if "const" not in kind else b"x"
        if base == "void":  # bytes of a file, or what a callback gets
            return SURFACE if "const" in kind else None
        if base in self.places:
            return ctypes.c_void_p(self.places[base])
        if base == "double":
            return self.doubles
        if base in ("int32_t", "int64_t") or not hasattr(_abi, base):
            return self.integers[8 if base == "int64_t" else 4]
        return self.block(base)

    def call(self, name, result, arguments):
        """The status, or None for another result. Objects are not made on failure."""
        function = getattr(self.library, name)
        function.restype = {"trk_status": ctypes.c_int32, "double": ctypes.c_double,
                            "void": None}.get(result, ctypes.c_void_p)
        self.keep.append(arguments)
        print(name, [type(one).__name__ for one in arguments], flush=True)
        status = function(*arguments)
        if result != "trk_status":
            return None
        for one in arguments:
            if isinstance(one, ctypes.Array) and len(one) == 1 and one._type_ is ctypes.c_void_p:
                assert not status or one[0] is None, f"{name} failed and left an object behind"
        return status


def null_everywhere():
    caller = Caller()
    for name, (result, kinds) in functions().items():
        caller.call(name, result, [None if "*" in kind else caller.argument(kind, name)
                                   for kind in kinds])
        if name.endswith("_destroy"):
            continue
        for place, kind in enumerate(kinds):
            if "*" in kind:
                arguments = [caller.argument(one, name) for one in kinds]
                arguments[place] = None
                caller.call(name, result, arguments)


def options_of_every_size():
    caller, asked = Caller(), set()
    for name, (result, kinds) in functions().items():
        for place, kind in enumerate(kinds):
            struct = re.sub(r"\bconst\b|\*", " ", kind).split()[0]
            if "*" not in kind or result != "trk_status" or struct in caller.places \
                    or not issubclass(getattr(_abi, struct, int), ctypes.Structure):
                continue
            asked.add(struct)
            for size, tail, refused in ((0, 0, True), (7, 0, True), (ROOM, 1, True), (ROOM, 0, False)):
                if size == ROOM and "const" not in kind:
                    continue  # a result may be larger than the library knows
                arguments = [caller.argument(one, name) for one in kinds]
                arguments[place] = caller.block(struct, size, tail)
                status = caller.call(name, result, arguments)
                # Some look at another argument first, which may be wrong by chance.
                assert status or not refused, f"{name}: {struct} of {size} bytes, tail {tail}"
                assert status != OPTIONS or refused, f"{name}: zeros behind {struct} are refused"
    assert len(asked) > 25, asked


def bad_numbers():
    """Counts beyond the arrays cannot be told from good ones; negative ones can."""
    caller = Caller()
    bad = {"double": (ctypes.c_double, [math.nan, math.inf, -math.inf, -1.0, 0.0, 1e308, -1e308, 5e-324]),
           "int64_t": (ctypes.c_int64, [-1, 0, -2**63]), "size_t": (ctypes.c_size_t, [0])}
    for name, (result, kinds) in functions().items():
        for place, kind in enumerate(kinds):
            if "*" in kind or name.endswith("_init") or kind in CALLBACKS:
                continue
            make, numbers = bad.get(kind, (ctypes.c_int32, [-1, 0, -2**31]))
            for number in numbers:
                arguments = [caller.argument(one, name) for one in kinds]
                arguments[place] = make(number)
                caller.call(name, result, arguments)


@pytest.mark.parametrize("part", ["null_everywhere", "options_of_every_size", "bad_numbers"])
def test_the_library_survives(part, tmp_path):
    run = subprocess.run([sys.executable, "-B", __file__, part], capture_output=True, text=True,
                         cwd=tmp_path, timeout=500,
                         env=dict(os.environ, PYTHONPATH=os.pathsep.join(sys.path)))
    assert run.returncode == 0, run.stdout[-300:] + run.stderr[-2000:]


def test_all_functions_are_asked():
    assert set(_abi.SIGNATURES) <= set(functions())


SPEC = tr.vehicle("reference_half")
MODEL = SPEC.compile()
SINE = tr.Signal.sine(0.01, 1)
CURVE = tr.Curve([0, 1], [0, 1])
RAIL = tr.section.channel(0.27, 0.08, 0.008, 0.008)
LAW = tr.Law("friction", friction=100, stiffness=1e6)


@pytest.mark.parametrize("call", [
    lambda: tr.Newmark(SPEC), lambda: tr.RungeKutta(SPEC), lambda: tr.step_limit(SPEC),
    lambda: tr.simulate(SPEC, SINE, 1), lambda: tr.simulate(MODEL, CURVE, 1),
    lambda: tr.simulate(MODEL, None, 1), lambda: tr.run_batch([MODEL, SPEC], SINE, 0.1),
    lambda: tr.run_batch([MODEL], [CURVE], 0.1), lambda: tr.Excitation(SPEC),
    lambda: tr.Excitation(MODEL).add_motion(CURVE), lambda: tr.Study(MODEL),
    lambda: tr.Study(SPEC).add_excitation("a", SINE), lambda: tr.Calibration(MODEL),
    lambda: tr.Calibration(SPEC).set_run(SINE), lambda: tr.Modes(SPEC), lambda: tr.Model(CURVE),
    lambda: tr.frequency_response(SPEC, [1.0]), lambda: tr.response_psd_excited(SPEC, SINE, 1),
    lambda: tr.comfort.axle_drop(SPEC, ["front"], 1),
    lambda: SPEC.copy().update_link("front_tire", spring_curve=SPEC),
    lambda: SPEC.copy().update_link("front_tire", spring_curve=12345),
    lambda: SPEC.copy().update_link("front_tire", law=CURVE),
    lambda: SPEC.copy().update_link("front_tire", spring_curve=LAW),
    lambda: tr.Law("stops", bump_curve=LAW), lambda: tr.Law("leaf", settings=tr.SealOptions()),
    lambda: tr.psd(np.ones(64), 1.0, tr.PeakOptions()),
    lambda: SPEC.copy().add_beam("b", CURVE, 1, 2),
    lambda: tr.Spec("s").add_frame("f", [0, 1], [0], rail=LAW, member=LAW, half_width=0.4),
    lambda: tr.enveloped(CURVE, 10, 0.1, length=1), lambda: tr.road_input_spectra(SPEC, [1.0], 20),
    lambda: tr.linearise(SPEC, [1.0], [[[0.0]]]),
])
def test_an_object_of_another_class_is_refused(call):
    with pytest.raises((TypeError, tr.ArgumentError), match="expected"):
        call()


@pytest.mark.parametrize("call", [
    lambda: tr.simulate(MODEL, SINE, 1.0, record_every=2**64 + 1),
    lambda: tr.run_batch([MODEL], SINE, 1.0, threads=2**32 + 1),
    lambda: tr.Newmark(MODEL, max_iterations=2**32 + 5), lambda: tr.Study(SPEC, seed=2**64 + 1),
    lambda: tr.Study(SPEC).case(2**64), lambda: SPEC.body(2**32 + 1),
    lambda: tr.Series({"a": [1]}, 1).write_csv("never.csv", 2**64 + 1),
    lambda: tr.psd(np.ones(64), 1.0, segment_length=2**64 + 8),
    lambda: tr.response_psd_excited(MODEL, SINE, 1e300), lambda: MODEL.modes(count=2**32 + 1),
    lambda: MODEL.reduce(modes=2**32 + 1), lambda: tr.enveloped(SINE, 2**64 + 5, 0.1, length=1),
    lambda: tr.Spec("s").add_frame("f", [0, 1], [0], rail=RAIL, member=RAIL, half_width=0.4,
                                   member_elements=2**32 + 1),
])
def test_an_integer_is_not_taken_modulo_a_power_of_two(call):
    with pytest.raises(tr.ArgumentError, match="no integer of"):
        call()


@pytest.mark.parametrize("kind, words, call", [
    (tr.ArgumentError, "trk_spec_vary", lambda: SPEC.copy().vary("*", "stiffness", "x")),
    (tr.ArgumentError, "NUL", lambda: tr.Series({"a": [1]}, 1).write_csv("a\0b")),
    (tr.ArgumentError, "complex", lambda: tr.psd(np.ones(10) * 1j, 1.0)),
    (tr.RangeError, "step", lambda: tr.response_psd_excited(MODEL, SINE, 1.0, step=0.0)),
    (tr.RangeError, "duration", lambda: tr.response_psd_excited(MODEL, SINE, math.nan)),
    (tr.UnknownNameError, "nope", lambda: tr.Study(SPEC).output_unit("nope")),
    (TypeError, "integer", lambda: SPEC.body(1.5)),
    (TypeError, "integer", lambda: tr.Study(SPEC).run(cases=[0.5])),
])
def test_sentences(kind, words, call):
    with pytest.raises(kind, match=words):
        call()


def test_what_has_a_state_is_not_copied():
    for item in (tr.Newmark(MODEL), tr.Study(SPEC), MODEL.modes()):
        for twin in (copy.copy, copy.deepcopy, pickle.dumps):
            with pytest.raises(TypeError, match="neither copied nor pickled"):
                twin(item)


if __name__ == "__main__":
    globals()[sys.argv[1]]()
