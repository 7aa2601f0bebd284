# SPDX-License-Identifier: MIT
"""Fit parameters of a vehicle to measured eigenfrequencies, damping, peaks and curves."""
from __future__ import annotations

import ctypes
import dataclasses
from typing import TYPE_CHECKING, Any, Callable, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _abi
from ._abi import Field, Meaning, Status, TargetKind
from ._library import lib, quick
from ._native import (Array, Exclusive, Handle, Native, check, create, encode, text, vector)
from ._options import (ModelOptions, ParameterOptions, ParameterResult, RunOptions, SolveOptions,
                       TargetResult)
from ._progress import Progress, Watch
from ._struct import Fields, member, options
from .errors import TruckrideError, UnknownNameError, error_of
from .excitation import Excitation
from .spec import Spec

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Evaluation(NamedTuple):
    """Values of all targets [Hz or -] and, if asked for, their derivatives."""

    values: Array
    jacobian: Optional[Array]


@dataclasses.dataclass(frozen=True)
class Solution:
    """What Calibration.solve() found.

    status, message: Status.OK and "" if all targets are met and all parameters determined
    parameters: by name: start, fitted, low95, high95 [- or unit of the value], at_bound,
        determined
    targets: by name: measured, before, after [Hz or -], residual [-], met
    jacobian: w_i / s_i d y_i / d ln p_j at the answer [-], values x parameters
    singular_values: of it [-], falling
    evaluations, failures: of the model
    report: all of it in words
    """

    status: Status
    message: str
    parameters: dict[str, ParameterResult]
    targets: dict[str, TargetResult]
    jacobian: Array
    singular_values: Array
    evaluations: int
    failures: int
    report: str

    @property
    def ok(self) -> bool:
        return self.status == Status.OK

    @property
    def fitted(self) -> dict[str, float]:
        """Fitted parameters by name [- or unit of the value]."""
        return {name: result.fitted for name, result in self.parameters.items()}

    def plot(self, **options: Any) -> Figure:
        """Targets before and after, parameters with intervals; as truckride.plot.solution()."""
        from . import plot
        return plot.solution(self, **options)

    def __str__(self) -> str:
        return self.report


class Calibration(Native):
    """Parameters that act on a copy of a spec, and measured targets.

    Args:
        spec: copied; factors refer to its values
        gravity: [m/s^2], as Spec.compile()
        allow_free: as Spec.compile()
    """

    def __init__(self, spec: Spec, gravity: float = 0.0, allow_free: bool = False) -> None:
        struct = ModelOptions(gravity, int(allow_free))._to_struct()
        with Exclusive(Spec._expect(spec)) as handle:
            self._handle = create(quick.trk_calibration_destroy, lib.trk_calibration_create,
                                  handle, ctypes.byref(struct))
        self._parameters: list[str] = []
        self._targets: list[str] = []
        self._run: Optional[Handle] = None

    def _call(self, function: Callable[..., int], *arguments: Any) -> None:
        with Exclusive(self) as handle:
            check(function(handle, *arguments), handle.context)

    # What is sought

    def add_parameter(self, name: str, pattern: str, field: Union[Field, str] = Field.STIFFNESS,
                      *, power: float = 1.0, settings: Optional[ParameterOptions] = None,
                      **changes: Any) -> int:
        """Add a parameter, by default a factor on the stiffness of links.

        Args:
            pattern: name of the links or bodies it acts on; '*' stands for any text
            field: "stiffness", "damping" of links; "mass", "inertia", "mass_inertia" of bodies
            power: value = parameter^power * value of the spec
            settings: ParameterOptions; its fields can be keywords too: meaning ("factor" or
                "value"), start, lower, upper [- or unit of the value]
        """
        struct = options(ParameterOptions, settings, changes)._to_struct()
        out = ctypes.c_int32()
        kind = member(Field, field)
        self._call(lib.trk_calibration_add_parameter, encode(name), ctypes.byref(struct),
                   ctypes.byref(out))
        self._parameters.append(name)
        self.act_on(name, pattern, kind, power)
        return out.value

    def act_on(self, parameter: str, pattern: str, field: Union[Field, str] = Field.STIFFNESS,
               power: float = 1.0) -> int:
        """Let a parameter act on further links or bodies. Returns how many matched."""
        out = ctypes.c_int32()
        self._call(lib.trk_calibration_act_on, self._number(parameter), member(Field, field),
                   encode(pattern), power, ctypes.byref(out))
        return out.value

    def _number(self, parameter: str) -> int:
        if parameter not in self._parameters:
            raise UnknownNameError(f"there is no parameter '{parameter}'; there are "
                                   f"{', '.join(self._parameters) or 'none'}")
        return self._parameters.index(parameter) + 1

    # What was measured

    def _add_target(self, name: str, kind: TargetKind, value: float = 0.0,
                    uncertainty: float = 0.0, weight: float = 1.0, coordinate: str = "",
                    shape: Optional[npt.ArrayLike] = None, sensor: str = "",
                    band: tuple[float, float] = (0.0, 0.0),
                    frequency: Optional[npt.ArrayLike] = None,
                    magnitude: Optional[npt.ArrayLike] = None,
                    road_gain: Optional[npt.ArrayLike] = None) -> int:
        struct = _abi.trk_target_options()
        quick.trk_target_options_init(ctypes.byref(struct), ctypes.sizeof(struct))
        struct.kind, struct.value, struct.uncertainty = kind, value, uncertainty
        struct.weight, (struct.low, struct.high) = weight, band
        struct.coordinate = encode(coordinate) if coordinate else None
        struct.sensor = encode(sensor) if sensor else None
        given = {"shape": shape, "frequency": frequency, "magnitude": magnitude,
                 "road_gain": road_gain}
        arrays = {field: vector(values, field) for field, values in given.items()
                  if values is not None}
        for field, array in arrays.items():
            setattr(struct, field, array.ctypes.data)
        if "frequency" in arrays:
            struct.count = len(arrays["frequency"])
            vector(arrays.get("magnitude", ()), "magnitude", struct.count)
        out = ctypes.c_int32()
        self._call(lib.trk_calibration_add_target, encode(name), ctypes.byref(struct),
                   ctypes.byref(out))
        self._targets.append(name)
        return out.value

    def target_frequency(self, name: str, value: float, coordinate: str = "", *,
                         damped: bool = True, shape: Optional[npt.ArrayLike] = None,
                         uncertainty: float = 0.0, weight: float = 1.0) -> int:
        """Eigenfrequency [Hz] of the mode with most energy in a coordinate ("front_axle.z"), or
        the one most like a shape; uncertainty [Hz], 0: 1 %."""
        kind = TargetKind.DAMPED_FREQUENCY if damped else TargetKind.UNDAMPED_FREQUENCY
        return self._add_target(name, kind, value, uncertainty, weight, coordinate, shape)

    def target_damping(self, name: str, value: float, coordinate: str = "", *,
                       shape: Optional[npt.ArrayLike] = None, uncertainty: float = 0.0,
                       weight: float = 1.0) -> int:
        """Damping ratio [-] of a mode, chosen as in target_frequency()."""
        return self._add_target(name, TargetKind.DAMPING_RATIO, value, uncertainty, weight,
                                coordinate, shape)

    def target_peak(self, name: str, value: float, sensor: str,
                    band: tuple[float, float] = (0.0, 0.0), *, uncertainty: float = 0.0,
                    weight: float = 1.0) -> int:
        """Frequency [Hz] of the highest PSD peak of a sensor in a band [Hz]; needs set_run()."""
        return self._add_target(name, TargetKind.PSD_PEAK, value, uncertainty, weight,
                                sensor=sensor, band=band)

    def target_psd(self, name: str, sensor: str, frequency: npt.ArrayLike,
                   magnitude: npt.ArrayLike, *, uncertainty: float = 0.0,
                   weight: float = 1.0) -> int:
        """PSD of a sensor [unit^2/Hz] over frequency [Hz], compared by logarithm; needs
        set_run()."""
        return self._add_target(name, TargetKind.PSD_CURVE, 0.0, uncertainty, weight,
                                sensor=sensor, frequency=frequency, magnitude=magnitude)

    def target_response(self, name: str, sensor: str, frequency: npt.ArrayLike,
                        magnitude: npt.ArrayLike, *, road_gain: Optional[npt.ArrayLike] = None,
                        uncertainty: float = 0.0, weight: float = 1.0) -> int:
        """Magnitude of the response of a sensor to the road [unit/m] over frequency [Hz]."""
        return self._add_target(name, TargetKind.RESPONSE_CURVE, 0.0, uncertainty, weight,
                                sensor=sensor, frequency=frequency, magnitude=magnitude,
                                road_gain=road_gain)

    def set_run(self, excitation: Excitation, settings: Optional[RunOptions] = None,
                **changes: Any) -> None:
        """The run that peaks and PSD curves are taken from; fields of RunOptions: duration,
        step [s], segment_length, overlap."""
        struct, native = options(RunOptions, settings, changes)._to_struct(), Excitation._expect(excitation)._live()
        self._call(lib.trk_calibration_set_run, native, ctypes.byref(struct))
        self._run = native  # borrowed by the library
        self._live().keep += (native,)

    # The answer

    def evaluate(self, parameters: npt.ArrayLike, jacobian: bool = False) -> Evaluation:
        """Values of all targets at given parameters; a curve gives one a point."""
        given = vector(parameters, "parameters", len(self._parameters))
        count = quick.trk_calibration_values(self._live())
        values = np.empty(count)
        derivatives = np.empty((count, len(given))) if jacobian else None
        self._call(lib.trk_calibration_evaluate, given.ctypes, values.ctypes,
                   None if derivatives is None else derivatives.ctypes)
        return Evaluation(values, derivatives)

    def solve(self, settings: Optional[SolveOptions] = None, *, progress: Progress = None,
              must_succeed: bool = True, **changes: Any) -> Solution:
        """Fit the parameters.

        Args:
            settings: SolveOptions; its fields can be keywords too: max_evaluations, max_time
                [s], starts, seed, met
            progress: True for a bar in a terminal, or a function of the fraction done
            must_succeed: raise TargetError, IdentifyError, LimitError or ConvergenceError when
                targets are missed or parameters undetermined; the exception's attribute
                solution holds the answer so far. False returns it.
        """
        struct = options(SolveOptions, settings, changes)._to_struct()
        with Watch(progress, "calibrate") as watch, Exclusive(self) as handle:
            status = lib.trk_calibration_solve(handle, ctypes.byref(struct), watch.callback, None)
            message = text(quick.trk_context_message(handle.context)) if status else ""
        report = text(quick.trk_calibration_report(self._live()))
        fallen_short = status in (Status.TARGET, Status.IDENTIFY, Status.LIMIT, Status.CONVERGENCE)
        if status and not (fallen_short and report):
            raise error_of(status, message)
        solution = self._solution(Status(status), message, report)
        if status and must_succeed:
            error: TruckrideError = error_of(status, message)
            error.solution = solution  # type: ignore[attr-defined]
            raise error
        return solution

    def _results(self, kind: type[Fields], function: Any, names: list[str]) -> dict[str, Any]:
        out = {}
        for number, name in enumerate(names, 1):
            struct = kind._sized()
            self._call(function, number, ctypes.byref(struct))
            out[name] = kind._from_struct(struct)
        return out

    def _solution(self, status: Status, message: str, report: str) -> Solution:
        handle = self._live()
        values, n = quick.trk_calibration_values(handle), len(self._parameters)
        jacobian, singular = np.empty((values, n)), np.empty(min(values, n))
        self._call(lib.trk_calibration_get_jacobian, jacobian.ctypes, singular.ctypes)
        return Solution(
            status, message,
            self._results(ParameterResult, quick.trk_calibration_get_parameter, self._parameters),
            self._results(TargetResult, quick.trk_calibration_get_target, self._targets),
            jacobian, singular, quick.trk_calibration_evaluations(handle),
            quick.trk_calibration_failures(handle), report)

    def apply(self, spec: Spec) -> Spec:
        """Set the fitted values in a spec, usually the one calibrated. Returns it."""
        with Exclusive(self) as handle, Exclusive(spec) as target:
            check(lib.trk_calibration_apply(handle, target), handle.context)
        return spec

    def __repr__(self) -> str:
        if self.closed:
            return "<Calibration, closed>"
        return f"<Calibration of {len(self._parameters)} to {len(self._targets)} targets>"
