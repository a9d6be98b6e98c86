"""Drydock from Python: captures and recordings as NumPy arrays, rigs in virtual time with functions of your own as estimators
and controllers, the truth of missions, studies, scorecards, calibrations. docs/build/python.md"""

from . import main_interpreter  # before NumPy and the compiled part

import os
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Tuple, Union

import numpy.typing as npt

from . import _core, arguments
from ._core import Measurement, Moment, Step, __version__
from .arguments import Path
from .files import read_calibration, read_scorecard, with_arrays

__all__ = ["Estimator", "Measurement", "Moment", "Run", "Step", "Study", "Table", "__version__", "calibrate", "decode_capture",
           "decode_recording", "read_calibration", "read_recording", "read_scorecard", "run", "study", "truth"]

Table = Dict[str, npt.NDArray[Any]]
Outputs = Union[Sequence[float], npt.NDArray[Any]]


@dataclass(frozen=True)
class Estimator:
    """A function that is an estimator. It is called at the end of each step of virtual time and gives None, an estimate, or
    several; what each must have is `gives`: "attitude", "navigation" or "velocity"."""

    call: Callable[[Step], Any]
    gives: str = "attitude"
    step_s: float = 0.05


@dataclass(frozen=True)
class Run:
    """What a run gave. The tables of measurements are by device and type, those of estimates by estimator."""

    summary: Dict[str, Any]
    measurements: Dict[str, Dict[str, Table]]
    estimates: Dict[str, Table]
    truth: Table


@dataclass(frozen=True)
class Study:
    """`values` is what `drydock study --json` writes; a figure has curves with the arrays x and y."""

    title: str
    values: Dict[str, Any]
    tables: List[Dict[str, Any]]
    figures: List[Dict[str, Any]]


def _fault_text(faults: Path) -> str:
    """The text itself, or that of a file."""
    if not isinstance(faults, (str, os.PathLike)):
        raise TypeError(f"faults is a {type(faults).__name__}, allowed: a TOML text or the path of a .toml file")
    if isinstance(faults, str) and ("\n" in faults or not faults.endswith(".toml")):
        return faults
    with open(faults, encoding="utf-8") as file:
        return file.read()


def _seat(name: str, one: Any) -> Tuple[Callable[[Step], Any], str, float]:
    """An estimator as the compiled part takes it."""
    seat = one if isinstance(one, Estimator) else Estimator(one)
    if not callable(seat.call):
        raise TypeError(f"estimator {name} is {seat.call!r}, allowed: a function or a drydock.Estimator")
    return seat.call, seat.gives, arguments.seconds(seat.step_s, "step_s")


def decode_capture(path: Path, protocol: str, *, kind: str = "", baud: int = 0, format: str = "", clock: str = "",
                   interface: str = "", address: int = 0) -> Dict[str, Table]:
    """The measurements of a capture of one sensor, a table by type: `drydock replay --protocol`."""
    return _core.decode_capture(arguments.file(path), arguments.text(protocol, "protocol"), kind=arguments.text(kind, "kind"),
                                baud=arguments.whole(baud, "baud", 0, 2**32 - 1), format=arguments.text(format, "format"),
                                clock=arguments.text(clock, "clock"), interface=arguments.text(interface, "interface"),
                                address=arguments.whole(address, "address", 0, 255))


def decode_recording(path: Path, *, only: Sequence[str] = (), from_s: Optional[float] = None,
                     to_s: Optional[float] = None) -> Dict[str, Dict[str, Table]]:
    """The recorded bytes through their drivers: measurements by device and type."""
    return _core.decode_recording(arguments.file(path), only=arguments.texts(only, "only"),
                                  from_s=arguments.maybe_seconds(from_s, "from_s"), to_s=arguments.maybe_seconds(to_s, "to_s"))


def read_recording(path: Path, *, only: Sequence[str] = (), from_s: Optional[float] = None,
                   to_s: Optional[float] = None) -> Dict[str, Table]:
    """The recorded messages by topic: what was measured, estimated and true at the time."""
    return _core.read_recording(arguments.file(path), only=arguments.texts(only, "only"),
                                from_s=arguments.maybe_seconds(from_s, "from_s"), to_s=arguments.maybe_seconds(to_s, "to_s"))


def truth(mission: Path, times_s: Optional[npt.ArrayLike] = None, *, every_s: float = 1.0, start_ns: int = 0) -> Table:
    """The true motion of a mission at these times since its start; without times, of one lap."""
    return _core.truth(os.fspath(mission), arguments.times(times_s, "times_s"), every_s=arguments.seconds(every_s, "every_s"),
                       start_ns=arguments.whole(start_ns, "start_ns", -8 * 10**18, 8 * 10**18))


def run(rig: Path, duration_s: Optional[float] = None, *,
        estimators: Optional[Mapping[str, Union[Estimator, Callable[[Step], Any]]]] = None,
        controller: Optional[Callable[[Moment], Outputs]] = None, controller_period_s: float = 0.1,
        truth_period_s: float = 0.1, seed: Optional[int] = None, faults: Path = "", record: Optional[Path] = None,
        overwrite: bool = False) -> Run:
    """Runs a rig in virtual time: `drydock run --speed max`; without duration_s, one lap of its mission. `controller` gives
    the vehicle's outputs, -1 to 1 each, which hold until its next call. `faults`: blocks [[fault]], as a TOML text or the path
    of a .toml file."""
    if estimators is not None and not isinstance(estimators, Mapping):
        raise TypeError(f"estimators is a {type(estimators).__name__}, allowed: a dict of functions by name")
    if controller is not None and not callable(controller):
        raise TypeError(f"controller is {controller!r}, allowed: a function")
    seats = {arguments.text(name, "a name of estimators"): _seat(name, one) for name, one in (estimators or {}).items()}
    return Run(**_core.run(os.fspath(rig), arguments.maybe_seconds(duration_s, "duration_s"), estimators=seats,
                           controller=controller, controller_period_s=arguments.seconds(controller_period_s, "controller_period_s"),
                           truth_period_s=arguments.seconds(truth_period_s, "truth_period_s"),
                           seed=None if seed is None else arguments.whole(seed, "seed", 0, 2**64 - 1),
                           faults=_fault_text(faults), record=os.fspath(record or ""), overwrite=bool(overwrite)))


def study(name: str, *, runs: int = 100, seed: int = 1, jobs: int = 0, cases: Sequence[str] = ()) -> Study:
    """The experiment of a paper again: `drydock study`. `jobs` 0: one a processor."""
    return Study(**_core.study(arguments.text(name, "name"), runs=arguments.whole(runs, "runs", 1, 1000000),
                               seed=arguments.whole(seed, "seed", 0, 2**64 - 1), jobs=arguments.whole(jobs, "jobs", 0, 1024),
                               cases=arguments.texts(cases, "cases")))


def calibrate(recording: Path, *, rig: Path = "") -> Dict[str, Any]:
    """What a dive tells about its sensors: `drydock calibrate --json`, with arrays as of read_calibration."""
    return with_arrays(_core.calibrate(arguments.file(recording), rig=os.fspath(rig)))
