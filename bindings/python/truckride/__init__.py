# SPDX-License-Identifier: MIT
"""Ride dynamics of heavy trucks.

    import truckride as tr

    model = tr.vehicle("reference_truck", "thesis_dampers").compile()
    run = tr.simulate(model, tr.sweep(), duration=480)
    run["cab_front_left_z"].psd(segment_length=8192).plot()

SI units; angles in rad; x forward, y left, z up (ISO 8855); elongation and damper velocity are
positive in extension. Long calls release the GIL. Models, curves, signals and excitations may
be shared by threads; steppers, specs and calibrations serve one thread at a time and say so.
"""
from . import comfort, roughness, section
from ._abi import (TRK_STANDARD_GRAVITY as STANDARD_GRAVITY, Averaging, Axis, Backend, CrgBorder,
                   CrgMissing, Design, Detrend, Distribution, Exposure, Extrapolation, Feature,
                   Field, Free, HalfCarLayout, Interpolation, LawKind, Meaning, Method, Motion,
                   Output, Part, PeakOrder, Purpose, Quantity, Reaction, RoadClass, RoadTracks,
                   RpcType, Scaling, Status, StudyPart, Table, TargetKind, Unfriendly, Variant,
                   Vehicle, Weighting, Window)
from ._check import check_defaults as _check_defaults
from ._library import lib as _lib, path as library_path
from ._options import (AirSpringOptions, AxleDropOptions, AxleTransient, Beam, Body, CrgOptions,
                       CsvOptions, CurveOptions, FrictionOptions, HalfCarParameters, IriOptions,
                       LeafOptions, LineariseOptions, Link, LoadNumbers, ModelOptions,
                       NewmarkOptions, NewmarkStatistics, ParameterOptions, ParameterResult,
                       PeakOptions, Port, QuarterCarParameters, ReduceOptions, RoadOptions,
                       RpcOptions, RunOptions, RungekuttaOptions, SealOptions, Sensor,
                       SolveOptions, SpectrumOptions, StopsOptions, StudyOptions,
                       StudyParameterOptions, StudyRunOptions, SweepOptions, TargetResult,
                       TireOptions, TravelNumbers, TruckParameters, Vibration)
from ._stepper import LinkState, State, Stepper
from .batch import Batch, run_batch
from .calibrate import Calibration, Evaluation, Solution
from .crg import Extent, Surface
from .curve import Curve
from .envelope import (Envelope, envelope_average, envelope_rigid_band, envelope_weight,
                       enveloped)
from .errors import (ArgumentError, BusyError, CancelledError, ClosedError, ConvergenceError,
                     FileError, IdentifyError, InputError, InternalError, LibraryError, LimitError,
                     ModelError, OptionsError, OutOfMemoryError, RangeError, SingularError,
                     TargetError, TruckrideError, UnknownNameError, UnsupportedError)
from .excitation import Excitation, Inputs
from .files import read_csv, read_csv_signal, read_erd, read_rpc
from .law import Equivalent, Law, Trace
from .linear import (Mode, Modes, RandomResponse, Response, frequency_response, response_psd,
                     response_psd_excited, road_cross_spectra, road_input_spectra)
from .linearise import Linearised, linearise
from .model import Model, Static, Tangent
from .newmark import Newmark, adams, generalized_alpha, hht
from .road import Tracks, road, road_coherence, road_density
from .rungekutta import RungeKutta, StepLimit, step_limit
from .section import Material
from .series import Channel, Series
from .signal import Signal, sweep
from .simulate import simulate
from .spec import Description, PointMass, Road, Spec
from .spectrum import (Peak, Psd, band_rms, coherence, csd, frf, psd, psd_frequencies,
                       psd_normalise, psd_peaks, psd_segments)
from .study import Case, Study
from .vehicle import axle_quarter, half_car, half_truck, quarter_car, truck, vehicle

_check_defaults()

__version__: str = (_lib.trk_version_text() or b"").decode()


def has_feature(feature: Feature) -> bool:
    """Whether this build of the library has CHOLMOD, LAPACK, NLopt, JSON or ARPACK."""
    return bool(_lib.trk_has_feature(feature))


__all__ = [
    "AirSpringOptions", "ArgumentError", "Averaging", "Axis", "AxleDropOptions",
    "AxleTransient", "Backend", "Batch", "Beam", "Body", "BusyError", "Calibration",
    "CancelledError", "Case", "Channel", "ClosedError", "ConvergenceError", "CrgBorder",
    "CrgMissing", "CrgOptions", "CsvOptions", "Curve", "CurveOptions", "Description", "Design",
    "Detrend", "Distribution", "Envelope", "Equivalent", "Evaluation", "Excitation", "Exposure",
    "Extent", "Extrapolation", "Feature", "Field", "FileError", "Free", "FrictionOptions",
    "HalfCarLayout", "HalfCarParameters", "IdentifyError", "InputError", "Inputs",
    "InternalError", "Interpolation", "IriOptions", "Law", "LawKind", "LeafOptions",
    "LibraryError", "LimitError", "LineariseOptions", "Linearised", "Link", "LinkState",
    "LoadNumbers", "Material", "Meaning", "Method", "Mode", "Model", "ModelError",
    "ModelOptions", "Modes", "Motion", "Newmark", "NewmarkOptions", "NewmarkStatistics",
    "OptionsError", "OutOfMemoryError", "Output", "ParameterOptions", "ParameterResult", "Part",
    "Peak", "PeakOptions", "PeakOrder", "PointMass", "Port", "Psd", "Purpose", "Quantity",
    "QuarterCarParameters", "RandomResponse", "RangeError", "Reaction", "ReduceOptions",
    "Response", "Road", "RoadClass", "RoadOptions", "RoadTracks", "RpcOptions", "RpcType",
    "RunOptions", "RungeKutta", "RungekuttaOptions", "STANDARD_GRAVITY", "Scaling",
    "SealOptions", "Sensor", "Series", "Signal", "SingularError", "Solution", "SolveOptions",
    "Spec", "SpectrumOptions", "State", "Static", "Status", "StepLimit", "Stepper",
    "StopsOptions", "Study", "StudyOptions", "StudyParameterOptions", "StudyPart",
    "StudyRunOptions", "Surface", "SweepOptions", "Table", "Tangent", "TargetError",
    "TargetKind", "TargetResult", "TireOptions", "Trace", "Tracks", "TravelNumbers",
    "TruckParameters", "TruckrideError", "Unfriendly", "UnknownNameError", "UnsupportedError",
    "Variant", "Vehicle", "Vibration", "Weighting", "Window", "__version__", "adams",
    "axle_quarter", "band_rms", "coherence", "comfort", "csd", "envelope_average",
    "envelope_rigid_band", "envelope_weight", "enveloped", "frequency_response", "frf",
    "generalized_alpha", "half_car", "half_truck", "has_feature", "hht", "library_path",
    "linearise", "psd", "psd_frequencies", "psd_normalise", "psd_peaks", "psd_segments",
    "quarter_car", "read_csv", "read_csv_signal", "read_erd", "read_rpc", "response_psd",
    "response_psd_excited", "road", "road_coherence", "road_cross_spectra", "road_density",
    "road_input_spectra", "roughness", "run_batch", "section", "simulate", "step_limit",
    "sweep", "truck", "vehicle",
]
