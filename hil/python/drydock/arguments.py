"""What callers give, checked before the compiled part sees it: a line names the argument and what is allowed."""

import operator
import os
from typing import Any, List, Optional, Sequence, Union

import numpy as np

Path = Union[str, "os.PathLike[str]"]


def text(value: Any, name: str) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{name} is {value!r}, allowed: a text")
    return value


def texts(values: Any, name: str) -> List[str]:
    """A text is a sequence of its letters, which nobody means."""
    if isinstance(values, str):
        raise TypeError(f'{name} is a text, allowed: a sequence of names, as ["{values}"]')
    if not isinstance(values, Sequence) and not hasattr(values, "__iter__"):
        raise TypeError(f"{name} is {values!r}, allowed: a sequence of names")
    return [text(value, f"a name of {name}") for value in values]


def whole(value: Any, name: str, least: int, most: int) -> int:
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is {value!r}, allowed: a whole number") from None
    if not least <= number <= most:
        raise ValueError(f"{name} = {number}, allowed: {least} to {most}")
    return number


def seconds(value: Any, name: str) -> float:
    """A number; what it may be is said by those who use it."""
    if isinstance(value, (str, bytes)) or not (hasattr(value, "__float__") or hasattr(value, "__index__")):
        raise TypeError(f"{name} is {value!r}, allowed: a number of seconds")
    return float(value)


def maybe_seconds(value: Any, name: str) -> Optional[float]:
    return None if value is None else seconds(value, name)


def times(values: Any, name: str) -> Any:
    """None or an array of numbers."""
    if values is None:
        return None
    array = np.asarray(values)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{name} has the type {array.dtype}, allowed: numbers")
    return array.astype(float, copy=False)


def file(path: Path) -> str:
    """Of a file that must be there: its name, or FileNotFoundError and its like."""
    os.stat(path)
    return os.fspath(path)
