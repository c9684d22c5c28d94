"""Fields of many models, and the distances between these."""

from __future__ import annotations

import os
import time
from typing import Any, Iterable, NamedTuple, Optional, Sequence, Union

import numpy as np

from pygirth import _girth
from pygirth._arguments import (
    Progress,
    face_count,
    real_number,
    reporter,
    smoothing_steps,
    whole_number,
)
from pygirth.collection._clients import Work
from pygirth.collection._search import Distributions, Index, block_of, nearest_of
from pygirth.collection._store import NAMES, Group, Store, groups_of
from pygirth.collection._tasks import computed, keys_of
from pygirth.errors import GirthError, LimitError, input_error

#: Results are also written when there are so many bytes of them.
BYTES_BETWEEN = 2**26

#: Errors that may go away by themselves: a file server that does not answer, a full memory.
PASSING = ("FILE_NOT_FOUND", "FILE_UNREADABLE", "OUT_OF_MEMORY")


class Neighbours(NamedTuple):
    """The nearest neighbours of some models.

    Attributes
    ----------
    numbers : ndarray of int64, shape (queries, k)
        The models nearest to each, nearest first, of equals the lower number; -1 where there are
        fewer.
    distances : ndarray of float64, shape (queries, k)
        How far they are; NaN where there are fewer.
    compared : int
        How many exact distances that took.
    """

    numbers: np.ndarray
    distances: np.ndarray
    compared: int


class Collection:
    """Models with their fields.

    Attributes
    ----------
    models : list of str
        Paths, or ``"model 3"`` of what came from no path. All results are numbered by this list.
    names : tuple of str
        The fields.
    failed : dict of int to GirthError
        The models that have no fields, by number, and why.
    computed, reused : int
        Models whose fields were computed now, and that the store had already.
    unsaved : GirthError or None
        Why results could not be written to the store, where they could not. They are here
        nevertheless.
    """

    def __init__(
        self,
        models: list[str],
        names: Sequence[str],
        keys: list[Optional[str]],
        failed: dict[int, GirthError],
        store: Store,
        counts: tuple[int, int],
    ) -> None:
        self.models = models
        self.names = tuple(names)
        self.failed = failed
        self.computed, self.reused = counts
        self.unsaved: Optional[GirthError] = store.fault
        self._keys = keys
        self._store = store
        self._distributions: dict[str, Distributions] = {}
        self._indices: dict[str, Index] = {}

    def __repr__(self) -> str:
        failed = f", {len(self.failed)} failed" if self.failed else ""
        return (
            f"<pygirth.collection.Collection: {len(self)} models with {', '.join(self.names)}{failed}>"
        )

    def __len__(self) -> int:
        return len(self.models)

    def values(self, number: int, name: str) -> tuple[np.ndarray, np.ndarray]:
        """The values of a model's field and how much each counts.

        Parameters
        ----------
        number : int
            The number of the model.
        name : str
            One of `names`.

        Returns
        -------
        values, weights : ndarray of float64, shape (vertices,)
            On the surface that was compared: scaled to the area 1, and remeshed where it had more
            faces than was asked for. The weights are shares of the area.
        """
        group = self._group(name)
        at = whole_number(number, "number")
        if not 0 <= at < len(self):
            raise input_error("INVALID_OPTION", f"there is no model {at}")
        if at in self.failed:
            raise self.failed[at]
        key = self._keys[at]
        for _, found in self._store.read(group, [key] if key else []):
            return found.values[name], found.weights
        raise input_error("INVALID_OPTION", f"the store no longer has model {at}")

    def distances(
        self,
        name: str = "igf",
        *,
        client: Any = None,
        block: int = 256,
        out: Optional[np.ndarray] = None,
        progress: Progress = None,
    ) -> np.ndarray:
        """The distances between all models: the earth mover's, exact.

        Parameters
        ----------
        name : str, optional
            One of `names`.
        client
            As of `fields`.
        block : int, optional
            The matrix is computed in squares of so many models.
        out : ndarray of float64, shape (models, models), optional
            Where it goes, such as a ``numpy.memmap``. Default: a new array.
        progress
            As of `pygirth.igf`.

        Returns
        -------
        ndarray of float64, shape (models, models)
            Symmetric, zeros on the diagonal; NaN of models that failed. Those of `pygirth.compare`.
        """
        all = self._packed(name)
        count, size = len(self), whole_number(block, "block")
        if size < 1:
            raise input_error("INVALID_OPTION", f"block is {size}", "choose 1 or more")
        matrix = np.empty((count, count)) if out is None else out
        if matrix.shape != (count, count) or matrix.dtype != np.float64:
            raise input_error("USAGE", f"out is no ({count}, {count}) array of float64")
        starts = range(0, count, size)
        blocks = {start: all.some(start, min(start + size, count)) for start in starts}
        work = Work(client, _placed_block)
        pairs = [(row, column) for row in starts for column in starts if column >= row]
        for row, column in pairs:
            work.add(row, column, blocks[row], blocks[column])
        report = reporter(progress)
        for done, (task, result, error) in enumerate(work):
            if error:
                raise _lost(error)
            row, column, values = result
            height, width = values.shape
            matrix[row : row + height, column : column + width] = values
            matrix[column : column + width, row : row + height] = values.T
            if report:
                report((done + 1) / len(pairs))
        # Each is at the distance 0 from itself; summing up may have left a rounding.
        own = np.arange(count)
        matrix[own, own] = np.where(np.isnan(matrix[own, own]), np.nan, 0)
        return matrix

    def nearest(
        self,
        name: str = "igf",
        k: int = 10,
        *,
        queries: Optional[Iterable[int]] = None,
        client: Any = None,
        progress: Progress = None,
    ) -> Neighbours:
        """The models nearest to each, exact, without the whole matrix.

        A lower bound of each distance, from 32 means of the quantile function, chooses the few
        models whose distance is computed.

        Parameters
        ----------
        name : str, optional
            One of `names`.
        k : int, optional
            How many.
        queries : iterable of int, optional
            The models whose neighbours are looked for. Default: all.
        client, progress
            As of `distances`.

        Returns
        -------
        Neighbours
            Numbers and distances, to the bit as a sorted row of `distances` without the model
            itself.
        """
        count = whole_number(k, "k")
        if count < 1:
            raise input_error("INVALID_OPTION", f"k is {count}", "choose 1 or more")
        chosen = range(len(self)) if queries is None else [whole_number(q, "a query") for q in queries]
        if not all(0 <= query < len(self) for query in chosen):
            raise input_error("INVALID_OPTION", "a query is no model", f"choose 0 to {len(self) - 1}")
        asked = np.array(chosen, np.int64)
        if name not in self._indices:
            self._indices[name] = Index(self._packed(name))
        index: Any = self._indices[name]
        work = Work(client, _placed_nearest)
        if client is not None and hasattr(client, "scatter"):
            index = client.scatter(index, broadcast=True)
        size = max(1, min(64, len(asked) // 8))
        for begin in range(0, len(asked), size):
            some = asked[begin : begin + size]
            work.add(begin, index, some, count)
        numbers = np.full((len(asked), count), -1, np.int64)
        distances = np.full((len(asked), count), np.nan)
        compared = done = 0
        report = reporter(progress)
        for task, result, error in work:
            if error:
                raise _lost(error)
            begin, (found, far, exact) = result
            numbers[begin : begin + len(found)] = found
            distances[begin : begin + len(found)] = far
            compared += exact
            done += len(found)
            if report:
                report(done / len(asked))
        return Neighbours(numbers, distances, compared)

    def _group(self, name: str) -> Group:
        for group in self._store.groups:
            if name in group.names:
                return group
        raise input_error(
            "INVALID_OPTION",
            f"the collection has no {name!r}",
            f"choose one of {', '.join(self.names)}, or compute it too",
        )

    def _packed(self, name: str) -> Distributions:
        """The distributions of all models; empty ones of those that failed."""
        if name not in self._distributions:
            group = self._group(name)
            keys = [key for key in self._keys if key]
            by_key = {
                key: _girth.distribution(np.ascontiguousarray(found.values[name]), found.weights)
                for key, found in self._store.read(group, dict.fromkeys(keys))
            }
            none = (np.zeros(0), np.zeros(0))
            parts = [by_key.get(key, none) if key else none for key in self._keys]
            self._distributions[name] = _joined(parts)
        return self._distributions[name]


def _joined(parts: Sequence[tuple[np.ndarray, np.ndarray]]) -> Distributions:
    none = [np.zeros(0)]
    return Distributions(
        np.concatenate(none + [values for values, _ in parts]),
        np.concatenate(none + [shares for _, shares in parts]),
        np.cumsum([0] + [len(values) for values, _ in parts]).astype(np.int64),
    )


def _placed_block(row: int, column: int, rows: Distributions, columns: Distributions) -> Any:
    return row, column, block_of(rows, columns, row == column)


def _placed_nearest(begin: int, index: Index, queries: np.ndarray, k: int) -> Any:
    return begin, nearest_of(index, queries, k)


def _lost(error: BaseException) -> BaseException:
    """An error of a task as people can read it."""
    if isinstance(error, GirthError) or not isinstance(error, Exception):
        return error
    return LimitError(
        "INTERNAL",
        f"the work was lost with its worker ({type(error).__name__}: {error})",
        "look at the workers' memory and logs, and try again",
    )


def fields(
    files: Iterable[Any],
    *,
    client: Any = None,
    store: Optional[Union[str, "os.PathLike[str]"]] = None,
    names: Sequence[str] = ("igf",),
    faces: int = 10_000,
    smooth: int = 0,
    retries: int = 2,
    batch: int = 4,
    save_every: float = 5.0,
    progress: Progress = None,
) -> Collection:
    """The fields of many models, as shapes are compared by them.

    Models that cannot be read are left out and named in `Collection.failed`; what the store has is not
    computed again, also where the same surface comes in several files.

    Parameters
    ----------
    files : iterable
        Paths, or whatever else `pygirth.as_mesh` takes.
    client : dask.distributed.Client or concurrent.futures.Executor, optional
        Where it is computed: each worker reads the files itself. Workers may come, go and be lost
        meanwhile. Default: on all cores of this machine.
    store : path, optional
        A folder that keeps the results; made where it is not there. Several programs may use one at
        a time. Default: none, results are kept in memory.
    names : sequence of {'igf', 'igf-ms', 'sdf', 'geoaverage', 'geofarthest'}, optional
        The fields.
    faces : int, optional
        Larger models are remeshed to so many faces; 0: all are taken as they are.
    smooth : int, optional
        Steps of smoothing after that, as of `pygirth.Mesh.smooth`: three for rough scans.
    retries : int, optional
        How often a model is tried again whose file could not be read or whose worker was lost.
    batch : int, optional
        Models of a task: more have less overhead, and more is done again where a worker is lost.
    save_every : float, optional
        Results are written at least so often, in seconds: no more is lost where the program is
        killed. 0: each at once.
    progress
        As of `pygirth.igf`.

    Returns
    -------
    Collection

    Raises
    ------
    InputError
        UNSUPPORTED_FEATURE where the store has another format; USAGE or INVALID_OPTION.
    LimitError
        PROGRAM_NOT_LOADED where a worker has another version of Girth.

    Notes
    -----
    What is computed is also written when the work is stopped by Ctrl-C. A store that cannot be
    written to stops nothing: `Collection.unsaved` states why, and the results are there.
    """
    names = [names] if isinstance(names, str) else list(names)
    if not names:
        raise input_error("USAGE", "there is no field", f"name some of {', '.join(NAMES)}")
    prepared = (face_count(faces), smoothing_steps(smooth))
    again, size = whole_number(retries, "retries"), whole_number(batch, "batch")
    if again < 0 or size < 1:
        raise input_error("INVALID_OPTION", "retries is below 0, or batch below 1")
    interval = real_number(save_every, "save_every")
    if not interval >= 0:
        raise input_error("INVALID_OPTION", f"save_every is {interval}", "choose 0 seconds or more")
    if isinstance(files, (str, bytes, os.PathLike)):
        raise input_error("USAGE", "files is one path", "pass a list of paths")
    models = list(files)
    run = _Run(models, client, Store(store, groups_of(names, *prepared)), prepared, again, size)
    run.report = reporter(progress)
    run.save_every = interval
    try:
        run.find_keys()
        run.compute()
    finally:
        run.store.save()
    if run.report:
        run.report(1.0)
    labels = [
        os.fsdecode(os.fspath(model)) if isinstance(model, (str, bytes, os.PathLike)) else f"model {i}"
        for i, model in enumerate(models)
    ]
    counts = (len(run.computed), len(models) - len(run.failed) - len(run.computed))
    return Collection(labels, names, run.keys, run.failed, run.store, counts)


class _Run:
    """One call of `fields`."""

    def __init__(
        self,
        models: list,
        client: Any,
        store: Store,
        prepared: tuple[int, int],
        retries: int,
        batch: int,
    ) -> None:
        self.models = models
        self.client = client
        self.store = store
        #: Faces at most, and steps of smoothing.
        self.prepared = prepared
        self.retries = retries
        self.batch = batch
        self.keys: list[Optional[str]] = [None] * len(models)
        self.failed: dict[int, GirthError] = {}
        self.computed: set[int] = set()
        self.report: Any = None
        self.save_every = 0.0
        self._tries: dict[int, int] = {}

    def _batches(self, numbers: Sequence[int], size: int) -> Iterable[list[int]]:
        return (list(numbers[i : i + size]) for i in range(0, len(numbers), size))

    def _fails(self, number: int, error: BaseException) -> bool:
        """Whether a model is given up; otherwise it is to be tried again."""
        tries = self._tries[number] = self._tries.get(number, 0) + 1
        passes = not isinstance(error, GirthError) or error.code in PASSING
        if passes and tries <= self.retries:
            return False
        found = _lost(error)
        assert isinstance(found, GirthError)
        self.failed[number] = found
        return True

    def _each(self, work: Work, add: Any) -> Iterable[tuple[int, Any]]:
        """The results of models one by one; what can be tried again goes back to the work."""
        for task, results, error in work:
            numbers = task[0]
            if isinstance(error, LimitError) and error.code == "PROGRAM_NOT_LOADED":
                raise error
            if error and not isinstance(error, Exception):
                raise error
            for place, number in enumerate(numbers):
                result = error or results[place]
                if not isinstance(result, BaseException):
                    yield number, result
                elif self._fails(number, result):
                    yield number, None
                else:
                    # Alone: it may be the one that the others were lost with.
                    add([number])

    def find_keys(self) -> None:
        """Reads all models; those that the store has are done."""
        work = Work(self.client, _keys_task)

        def add(numbers: list[int]) -> None:
            work.add(numbers, _girth.version, [self.models[number] for number in numbers])

        for numbers in self._batches(range(len(self.models)), 4 * self.batch):
            add(numbers)
        for number, key in self._each(work, add):
            self.keys[number] = key

    def compute(self) -> None:
        """Computes what the store has not, each surface once."""
        groups = self.store.groups
        wanted: dict[str, int] = {}
        for number, key in enumerate(self.keys):
            if key and not all(self.store.has(group, key) for group in groups):
                wanted.setdefault(key, number)
        work = Work(self.client, _fields_task)

        missing = {
            number: [group for group in groups if not self.store.has(group, key)]
            for key, number in wanted.items()
        }

        def add(numbers: list[int]) -> None:
            models = [self.models[number] for number in numbers]
            names = [[group.names for group in missing[number]] for number in numbers]
            work.add(numbers, _girth.version, models, names, *self.prepared)

        for numbers in self._batches(list(wanted.values()), self.batch):
            add(numbers)
        saved = time.monotonic()
        done = 0
        for number, result in self._each(work, add):
            done += 1
            if result is not None:
                # The file may have been changed since it was first read.
                self.keys[number], found = result
                for group, one in zip(missing[number], found):
                    self.store.add(group, self.keys[number], one)
                self.computed.add(number)
            late = time.monotonic() - saved >= self.save_every
            if late or self.store.unsaved[1] > BYTES_BETWEEN:
                self.store.save()
                saved = time.monotonic()
            if self.report:
                self.report(done / len(wanted))
        # Other files of a surface that could not be computed.
        for number, key in enumerate(self.keys):
            if key and number not in self.failed:
                first = wanted.get(key)
                if first is not None and first in self.failed:
                    self.failed[number] = self.failed[first]


def _keys_task(_: list[int], version: str, models: list) -> list:
    return keys_of(version, models)


def _fields_task(
    _: list[int], version: str, models: list, names: list, faces: int, smooth: int
) -> list:
    return computed(version, models, names, faces, smooth)
