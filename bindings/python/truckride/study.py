# SPDX-License-Identifier: MIT
"""Parameter studies: many cases of one vehicle, reduced to a few numbers each."""
from __future__ import annotations

import ctypes
import os
from typing import TYPE_CHECKING, Any, Callable, Iterable, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _abi
from ._abi import Field, Output, Status, StudyPart
from ._library import lib, quick
from ._native import (Array, Exclusive, Native, check, check_plain, create, encode, encode_path,
                      position, text, vector, whole)
from ._options import (ModelOptions, NewmarkOptions, SpectrumOptions, StudyOptions,
                       StudyParameterOptions, StudyRunOptions)
from ._progress import Progress, Watch
from ._struct import member, options
from .errors import UnknownNameError
from .excitation import Excitation
from .spec import Spec

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PathLike = Union[str, os.PathLike[str]]


class Case(NamedTuple):
    """Parameters of a case [- or unit of the value] and the name of its road."""

    parameters: dict[str, float]
    excitation: str


class Table(NamedTuple):
    """Finished cases: numbers, parameters and outputs by name, road, status."""

    case: npt.NDArray[np.int64]
    parameters: dict[str, Array]
    outputs: dict[str, Array]
    excitation: list[str]
    status: list[Status]


class Study(Native):
    """A copy of a spec, parameters that act on it, roads, and outputs of every case.

    Args:
        spec: copied; factors refer to its values
        settings: StudyOptions; its fields can be keywords too: design ("latin_hypercube",
            "factorial", "monte_carlo"), points, seed, duration, start, settle [s], record_every
        gravity, allow_free: as Spec.compile()
    """

    def __init__(self, spec: Spec, settings: Optional[StudyOptions] = None, *,
                 gravity: float = 0.0, allow_free: bool = False, **changes: Any) -> None:
        struct = options(StudyOptions, settings, changes)._to_struct()
        model = ModelOptions(gravity, int(allow_free))._to_struct()
        with Exclusive(Spec._expect(spec)) as handle:
            self._handle = create(quick.trk_study_destroy, lib.trk_study_create, handle,
                                  ctypes.byref(model), ctypes.byref(struct))

    def _call(self, function: Callable[..., int], *arguments: Any) -> None:
        with Exclusive(self) as handle:
            check(function(handle, *arguments), handle.context)

    def names(self, part: Union[StudyPart, str]) -> list[str]:
        """Names of its parameters, outputs or excitations."""
        handle, kind = self._live(), member(StudyPart, part)
        return [text(quick.trk_study_part_name(handle, kind, number))
                for number in range(1, quick.trk_study_count(handle, kind) + 1)]

    def set_newmark(self, settings: Optional[NewmarkOptions] = None, **changes: Any) -> None:
        """How runs are integrated; fields of NewmarkOptions as keywords."""
        struct = options(NewmarkOptions, settings, changes)._to_struct()
        self._call(lib.trk_study_set_newmark, ctypes.byref(struct))

    def set_spectrum(self, settings: Optional[SpectrumOptions] = None, **changes: Any) -> None:
        """How PSDs are estimated; fields of SpectrumOptions as keywords."""
        struct = options(SpectrumOptions, settings, changes)._to_struct()
        self._call(lib.trk_study_set_spectrum, ctypes.byref(struct))

    def add_parameter(self, name: str, pattern: str, field: Union[Field, str] = Field.STIFFNESS,
                      *, power: float = 1.0, settings: Optional[StudyParameterOptions] = None,
                      **changes: Any) -> int:
        """Add a parameter that acts on all links or bodies matching a pattern ('*' is any text).

        Args:
            field: "stiffness", "damping", "mass", "inertia" or "mass_inertia"
            power: value = parameter^power * value of the spec
            settings: StudyParameterOptions; its fields can be keywords too: distribution,
                meaning, lower, upper, mean, deviation, levels
        """
        struct = options(StudyParameterOptions, settings, changes)._to_struct()
        out, kind = ctypes.c_int32(), member(Field, field)
        self._call(lib.trk_study_add_parameter, encode(name), ctypes.byref(struct),
                   ctypes.byref(out))
        self.act_on(name, pattern, kind, power)
        return out.value

    def act_on(self, parameter: str, pattern: str, field: Union[Field, str] = Field.STIFFNESS,
               power: float = 1.0) -> int:
        """Let a parameter act on further links or bodies. Returns how many matched."""
        names, out = self.names(StudyPart.PARAMETER), ctypes.c_int32()
        if parameter not in names:
            raise UnknownNameError(f"there is no parameter '{parameter}'; there are "
                                   f"{', '.join(names) or 'none'}")
        self._call(lib.trk_study_act_on, names.index(parameter) + 1, member(Field, field),
                   encode(pattern), power, ctypes.byref(out))
        return out.value

    def add_output(self, name: str, sensor: str, kind: Union[Output, str] = Output.RMS, *,
                   low: float = 0.0, high: float = 0.0,
                   frequency: Optional[npt.ArrayLike] = None,
                   weight: Optional[npt.ArrayLike] = None) -> int:
        """Add a number taken from a sensor's samples: "rms", "peak", "band_rms" between low and
        high [Hz], "psd_peak_frequency", ..., "weighted_rms" with weights [-] over frequency
        [Hz]."""
        struct = _abi.trk_study_output_options()
        quick.trk_study_output_options_init(ctypes.byref(struct), ctypes.sizeof(struct))
        struct.kind, struct.sensor = member(Output, kind), encode(sensor)
        struct.low, struct.high = low, high
        if frequency is not None:
            places = vector(frequency, "frequency")
            weights = vector(() if weight is None else weight, "weight", len(places))
            struct.count = len(places)
            struct.frequency, struct.weight = places.ctypes.data, weights.ctypes.data
        out = ctypes.c_int32()
        self._call(lib.trk_study_add_output, encode(name), ctypes.byref(struct), ctypes.byref(out))
        return out.value

    def add_excitation(self, name: str, excitation: Excitation) -> int:
        """Add a road that every point of the design is driven over."""
        out, native = ctypes.c_int32(), Excitation._expect(excitation)._live()
        self._call(lib.trk_study_add_excitation, encode(name), native, ctypes.byref(out))
        self._live().keep += (native,)
        return out.value

    def output_unit(self, output: str) -> str:
        number = position(self.names(StudyPart.OUTPUT), output, "output") + 1
        return text(quick.trk_study_output_unit(self._live(), number))

    def __len__(self) -> int:
        """Number of cases."""
        return quick.trk_study_cases(self._live())

    @property
    def finished(self) -> int:
        """Number of finished cases."""
        return quick.trk_study_finished(self._live())

    def is_finished(self, case: int) -> bool:
        return bool(quick.trk_study_is_finished(self._live(), case))

    @property
    def fingerprint(self) -> int:
        """Number that tells this study from others."""
        out = ctypes.c_int64()
        self._call(lib.trk_study_get_fingerprint, ctypes.byref(out))
        return out.value

    def case(self, number: int) -> Case:
        """Parameters and road of a case, counted from 0."""
        names, road = self.names(StudyPart.PARAMETER), ctypes.c_int32()
        values = np.empty(len(names))
        check_plain(quick.trk_study_get_case(self._live(), number, values.ctypes,
                                           ctypes.byref(road)), f"case {number}")
        roads = self.names(StudyPart.EXCITATION)
        return Case(dict(zip(names, values.tolist())), roads[road.value - 1] if road.value else "")

    def run(self, settings: Optional[StudyRunOptions] = None, *,
            cases: Optional[Iterable[int]] = None, progress: Progress = None,
            **changes: Any) -> None:
        """Run all cases that are not finished, or the given ones.

        Args:
            settings: StudyRunOptions; its fields can be keywords too: threads (default here: one
                a processor), chunk, shard, shards
            progress: True for a bar in a terminal, or a function of the fraction done
        """
        if settings is None:
            changes.setdefault("threads", os.cpu_count() or 1)
        struct = options(StudyRunOptions, settings, changes)._to_struct()
        with Watch(progress, "study") as watch:
            if cases is None:
                self._call(lib.trk_study_run, ctypes.byref(struct), watch.callback, None)
            else:
                numbers = np.array([whole(case, "cases") for case in cases], dtype=np.int64)
                self._call(lib.trk_study_run_cases, len(numbers), numbers.ctypes,
                           ctypes.byref(struct), watch.callback, None)

    def outputs(self, case: int) -> tuple[dict[str, float], Status]:
        """Outputs of a finished case [unit of the output], NaN if it failed, and its status."""
        names, status = self.names(StudyPart.OUTPUT), ctypes.c_int32()
        values = np.empty(len(names))
        check_plain(quick.trk_study_get_outputs(self._live(), case, values.ctypes,
                                              ctypes.byref(status)), f"case {case}")
        return dict(zip(names, values.tolist())), Status(status.value)

    def set_outputs(self, case: int, values: npt.ArrayLike, status: Status = Status.OK) -> None:
        """Hand in the result of a case computed elsewhere by the same study."""
        given = vector(values, "values", len(self.names(StudyPart.OUTPUT)))
        self._call(lib.trk_study_set_outputs, case, status, given.ctypes)

    def table(self) -> Table:
        """All finished cases as arrays."""
        done = [k for k in range(len(self)) if self.is_finished(k)]
        cases, results = [self.case(k) for k in done], [self.outputs(k) for k in done]
        return Table(
            np.array(done, dtype=np.int64),
            {name: np.array([case.parameters[name] for case in cases])
             for name in self.names(StudyPart.PARAMETER)},
            {name: np.array([values[name] for values, _ in results])
             for name in self.names(StudyPart.OUTPUT)},
            [case.excitation for case in cases], [status for _, status in results])

    def open_journal(self, path: PathLike) -> None:
        """Keep finished cases in a file from now on; those it holds are taken from it."""
        self._call(lib.trk_study_open_journal, encode_path(path))

    def close_journal(self) -> None:
        self._call(lib.trk_study_close_journal)

    def load(self, path: PathLike) -> None:
        """Take cases from a journal, e.g. of a shard."""
        self._call(lib.trk_study_load, encode_path(path))

    def write_csv(self, path: PathLike) -> None:
        """Write a table of the finished cases."""
        self._call(lib.trk_study_write_csv, encode_path(path))

    def plot(self, output: str = "", **options: Any) -> Figure:
        """An output over every parameter; options as truckride.plot.study()."""
        from . import plot
        return plot.study(self, output, **options)

    def __repr__(self) -> str:
        if self.closed:
            return "<Study, closed>"
        return f"<Study of {len(self)} cases, {self.finished} finished>"
