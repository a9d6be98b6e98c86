"""Drydock from Python: captures and recordings as NumPy arrays, rigs in virtual time with functions of your own as estimators
and controllers, the truth of missions, studies, scorecards, calibrations. docs/build/python.md"""

import os
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Mapping, Optional, Sequence, Union

import numpy.typing as npt

from . import _core
from ._core import Measurement, Moment, Step, __version__
from .files import read_calibration, read_scorecard, with_arrays

__all__ = ["Estimator", "Measurement", "Moment", "Run", "Step", "Study", "Table", "__version__", "calibrate", "decode_capture",
           "decode_recording", "read_calibration", "read_recording", "read_scorecard", "run", "study", "truth"]

Path = Union[str, "os.PathLike[str]"]
Table = Dict[str, npt.NDArray[Any]]


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


def _names(names: Sequence[str], what: str) -> List[str]:
    """A text is a sequence of its letters, which nobody means."""
    if isinstance(names, str):
        raise TypeError(f'{what} is a text, allowed: a sequence of names, as ["{names}"]')
    return list(names)


def _fault_text(faults: Union[str, "os.PathLike[str]"]) -> str:
    """The text itself, or that of a file."""
    if isinstance(faults, str) and ("\n" in faults or not faults.endswith(".toml")):
        return faults
    with open(faults, encoding="utf-8") as file:
        return file.read()


def decode_capture(path: Path, protocol: str, *, kind: str = "", baud: int = 0, format: str = "", clock: str = "",
                   interface: str = "", address: int = 0) -> Dict[str, Table]:
    """The measurements of a capture of one sensor, a table by type: `drydock replay --protocol`."""
    return _core.decode_capture(os.fspath(path), protocol, kind=kind, baud=baud, format=format, clock=clock,
                                interface=interface, address=address)


def decode_recording(path: Path, *, only: Sequence[str] = (), from_s: Optional[float] = None,
                     to_s: Optional[float] = None) -> Dict[str, Dict[str, Table]]:
    """The recorded bytes through their drivers: measurements by device and type."""
    return _core.decode_recording(os.fspath(path), only=_names(only, "only"), from_s=from_s, to_s=to_s)


def read_recording(path: Path, *, only: Sequence[str] = (), from_s: Optional[float] = None,
                   to_s: Optional[float] = None) -> Dict[str, Table]:
    """The recorded messages by topic: what was measured, estimated and true at the time."""
    return _core.read_recording(os.fspath(path), only=_names(only, "only"), from_s=from_s, to_s=to_s)


def truth(mission: Path, times_s: Optional[npt.ArrayLike] = None, *, every_s: float = 1.0, start_ns: int = 0) -> Table:
    """The true motion of a mission at these times since its start; without times, of one lap."""
    return _core.truth(os.fspath(mission), times_s, every_s=every_s, start_ns=start_ns)


def run(rig: Path, duration_s: Optional[float] = None, *,
        estimators: Optional[Mapping[str, Union[Estimator, Callable[[Step], Any]]]] = None,
        controller: Optional[Callable[[Moment], Sequence[float]]] = None, controller_period_s: float = 0.1,
        truth_period_s: float = 0.1, seed: Optional[int] = None, faults: Path = "", record: Optional[Path] = None,
        overwrite: bool = False) -> Run:
    """Runs a rig in virtual time: `drydock run --speed max`; without duration_s, one lap of its mission. `controller` gives
    the vehicle's outputs, -1 to 1 each, which hold until its next call. `faults`: blocks [[fault]], as a TOML text or the path
    of a .toml file."""
    seats = {name: one if isinstance(one, Estimator) else Estimator(one) for name, one in (estimators or {}).items()}
    return Run(**_core.run(os.fspath(rig), duration_s, estimators={name: (e.call, e.gives, e.step_s) for name, e in seats.items()},
                           controller=controller, controller_period_s=controller_period_s, truth_period_s=truth_period_s,
                           seed=seed, faults=_fault_text(faults), record=os.fspath(record or ""), overwrite=overwrite))


def study(name: str, *, runs: int = 100, seed: int = 1, jobs: int = 0, cases: Sequence[str] = ()) -> Study:
    """The experiment of a paper again: `drydock study`. `jobs` 0: one a processor."""
    return Study(**_core.study(name, runs=runs, seed=seed, jobs=jobs, cases=_names(cases, "cases")))


def calibrate(recording: Path, *, rig: Path = "") -> Dict[str, Any]:
    """What a dive tells about its sensors: `drydock calibrate --json`, with arrays as of read_calibration."""
    return with_arrays(_core.calibrate(os.fspath(recording), rig=os.fspath(rig)))
