"""Arguments as people pass them, made into what the core takes."""

from __future__ import annotations

import operator
import os
from typing import Any, Callable, Mapping, Optional, Sequence, Union

import numpy as np

from pygirth import _girth
from pygirth.errors import input_error

#: A callable that takes the finished share in [0, 1], or a bar with ``update`` and ``total``.
Progress = Union[None, Callable[[float], object], Any]

MOST_THREADS = 1024


def vertices_of(values: Any) -> np.ndarray:
    """Positions as C-contiguous float64 of shape (n, 3); not copied where they are that already."""
    array = _array_of(values, "V")
    if array.dtype.kind not in "fiu":
        raise input_error(
            "USAGE",
            f"V is an array of {array.dtype}, not of real numbers",
            "pass vertices as floats: V.astype(float)",
        )
    return np.ascontiguousarray(_in_threes(array, "V", "x, y, z of each vertex"), np.float64)


def faces_of(values: Any) -> np.ndarray:
    """Faces as C-contiguous int64 of shape (m, 3); not copied where they are that already."""
    array = _array_of(values, "F")
    if array.size == 0:
        array = array.astype(np.int64)
    if array.dtype.kind not in "iu":
        raise input_error(
            "USAGE",
            f"F is an array of {array.dtype}, not of integers",
            "pass the vertices' numbers as integers: F.astype(int)",
        )
    return np.ascontiguousarray(_in_threes(array, "F", "three vertices of each face"), np.int64)


def _array_of(values: Any, name: str) -> np.ndarray:
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise input_error("USAGE", f"{name} is no array: {error}", "give all rows the same length")
    if array.dtype.kind == "O":
        raise input_error("USAGE", f"{name} is no array of numbers", "pass a NumPy array")
    return array


def _in_threes(array: np.ndarray, name: str, meaning: str) -> np.ndarray:
    if array.size == 0 and array.ndim <= 2:
        return array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        raise input_error(
            "USAGE",
            f"{name} has the shape {array.shape}, not (n, 3)",
            f"pass {meaning} in a row",
        )
    return array


def whole_number(value: Any, name: str, code: str = "INVALID_OPTION") -> int:
    """An integer of Python or NumPy."""
    try:
        if isinstance(value, (bool, np.bool_)):
            raise TypeError
        number = operator.index(value)
    except TypeError:
        raise input_error(code, f"{name} is {value!r}, not a whole number") from None
    if not -(2**63) <= number < 2**63:
        raise input_error(code, f"{name} is {number}, which is beyond 64 bits")
    return number


def real_number(value: Any, name: str) -> float:
    """A number of Python or NumPy."""
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise input_error("INVALID_OPTION", f"{name} is {value!r}, not a number") from None


def three_numbers(values: Any, name: str) -> list[float]:
    """A place or a direction."""
    array = np.asarray(values)
    if array.shape != (3,):
        raise input_error("USAGE", f"{name} has three numbers")
    return [real_number(value, name) for value in array]


def entry_of(values: Mapping[str, Any], name: str) -> Any:
    """An entry that must be there."""
    if not isinstance(values, Mapping) or name not in values:
        raise input_error("USAGE", f"there is no {name!r}", "pass a dictionary that has it")
    return values[name]


def face_count(value: Any) -> int:
    """The number of faces that larger models are remeshed to; 0: none is."""
    count = whole_number(value, "faces")
    if count != 0 and not 4 <= count <= 100_000_000:
        raise input_error("INVALID_OPTION", f"faces is {count}", "choose 0, or 4 to 100 million")
    return count


def smoothing_steps(value: Any) -> int:
    """Steps of smoothing."""
    count = whole_number(value, "smooth")
    if not 0 <= count <= 100:
        raise input_error("INVALID_OPTION", f"smooth is {count}", "choose 0 to 100 steps")
    return count


def one_of(value: Any, name: str, choices: Sequence[str]) -> str:
    """A word of a list."""
    if isinstance(value, str) and value in choices:
        return value
    raise input_error(
        "INVALID_OPTION", f"{name} is {value!r}", f"choose one of {', '.join(choices)}"
    )


def running(threads: Optional[int], progress: Progress) -> "_girth.Running":
    """How a long call runs."""
    count = 0 if threads is None else whole_number(threads, "threads")
    if not 0 <= count <= MOST_THREADS:
        raise input_error(
            "INVALID_OPTION",
            f"threads is {count}",
            f"choose 1 to {MOST_THREADS}, or None for one on each core",
        )
    return _girth.Running(count, reporter(progress))


def reporter(progress: Progress) -> Optional[Callable[[float], object]]:
    """The function that is called with the finished share; None where nobody asks for it."""
    if progress is None or callable(progress):
        return progress
    if not hasattr(progress, "update"):
        raise input_error(
            "INVALID_OPTION",
            f"progress is {progress!r}",
            "pass a callable, or a bar such as tqdm(total=1)",
        )
    total = getattr(progress, "total", None) or 1
    reported = 0.0

    def report(fraction: float) -> None:
        nonlocal reported
        progress.update((fraction - reported) * total)
        reported = fraction

    return report


def path_of(value: Any) -> str:
    """A path as the core takes it: UTF-8, or the bytes that the file system has."""
    path = os.fspath(value)
    if isinstance(path, bytes):
        path = os.fsdecode(path)
    if "\0" in path:
        raise input_error("FILE_NOT_FOUND", "a path has no zero bytes")
    return path
