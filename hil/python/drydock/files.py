"""Files that the program writes: scorecards and calibrations."""

import json
import os
from typing import Any, Dict, List

import numpy as np

from .arguments import Path


def _column(values: List[Any]) -> Any:
    """None among numbers is NaN; lists stay lists."""
    if all(value is None or type(value) in (int, float) for value in values):
        return np.array([np.nan if value is None else value for value in values], dtype=float)
    if not any(isinstance(value, list) for value in values):
        return np.array(values)
    column = np.empty(len(values), dtype=object)
    for row, value in enumerate(values):
        column[row] = value
    return column


def _flat(row: Dict[str, Any]) -> Dict[str, Any]:
    """The values of a dict in a row are `key.inner`."""
    flat: Dict[str, Any] = {}
    for key, value in row.items():
        flat.update({f"{key}.{inner}": item for inner, item in value.items()} if isinstance(value, dict) else {key: value})
    return flat


def _table(rows: List[Dict[str, Any]]) -> Dict[str, Any]:
    flat = [_flat(row) for row in rows]
    return {name: _column([row.get(name) for row in flat]) for name in dict.fromkeys(name for row in flat for name in row)}


def _read(path: Path, key: str, what: str, command: str) -> Dict[str, Any]:
    with open(path, encoding="utf-8") as file:
        try:
            content = json.load(file)
        except ValueError as error:  # no JSON, or no UTF-8
            raise ValueError(f"{os.fspath(path)} is no {what}: {error}") from error
    if not isinstance(content, dict) or key not in content:
        raise ValueError(f"{os.fspath(path)} is no {what}; drydock {command} --json writes one")
    return content


def read_scorecard(path: Path) -> Dict[str, Any]:
    """The file of `drydock scorecard --json`; `pairs` is a table with a row for each fault of each device."""
    card = _read(path, "drydock_scorecard", "scorecard", "scorecard")
    return {**card, "pairs": _table(card["pairs"])}


def with_arrays(calibration: Dict[str, Any]) -> Dict[str, Any]:
    return {**calibration, "findings": _table(calibration["findings"]),
            "correlation": np.array(calibration["correlation"], dtype=float)}


def read_calibration(path: Path) -> Dict[str, Any]:
    """What `drydock calibrate --json` writes; `findings` is a table, `correlation` a matrix."""
    return with_arrays(_read(path, "correlation", "calibration", "calibrate"))
