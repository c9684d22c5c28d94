"""Where the fields of models are kept: by what the models are and how the fields were computed.

A store is a folder::

    store.json                    the format, and which program made it
    igf-0f3a…/parameters.txt      a folder for each set of parameters, and what they are
    igf-0f3a…/5b1c….npz           fields of some thousand models

Each NPZ has ``keys`` (hashes of the models' surfaces), ``offsets``, and behind each other the
``weights`` of all models and the values of each field. Files are written whole and never changed,
so that several programs may add to a store at once.
"""

from __future__ import annotations

import hashlib
import io
import json
import os
import uuid
import warnings
import zipfile
from pathlib import Path
from typing import Iterable, Iterator, Mapping, NamedTuple, Optional, Sequence

import numpy as np

from pygirth import _girth
from pygirth.errors import InputError, error_codes, input_error

#: The fields that a collection can have: those with one number for each vertex.
NAMES = ("igf", "igf-ms", "sdf", "geoaverage", "geofarthest")

FORMAT = 1


class Group(NamedTuple):
    """Fields that are computed together, and their parameters."""

    names: tuple[str, ...]
    parameters: str
    folder: str


def groups_of(names: Sequence[str], faces: int, smooth: int) -> list[Group]:
    """The groups of fields, each once."""
    groups: dict[str, Group] = {}
    for name in names:
        if name not in NAMES:
            raise input_error(
                "INVALID_OPTION", f"a collection has no {name!r}", f"choose some of {', '.join(NAMES)}"
            )
        parameters = _girth.parameters_text([name], faces, smooth)
        together = tuple(
            other
            for other in NAMES
            if _girth.parameters_text([other], faces, smooth) == parameters
        )
        digest = hashlib.sha256(parameters.encode()).hexdigest()[:12]
        groups[parameters] = Group(together, parameters, f"{together[0]}-{digest}")
    return list(groups.values())


class Fields(NamedTuple):
    """How much each vertex of one model counts, and its values by their names."""

    weights: np.ndarray
    values: Mapping[str, np.ndarray]

    @property
    def size(self) -> int:
        """In bytes."""
        return self.weights.nbytes * (1 + len(self.values))


class Store:
    """Fields by the keys of models; in memory alone where there is no folder."""

    def __init__(self, folder: Optional["os.PathLike[str] | str"], groups: Sequence[Group]) -> None:
        self.groups = tuple(groups)
        self.folder = None if folder is None else Path(os.fsdecode(os.fspath(folder)))
        #: Why results could not be written, where they could not.
        self.fault: Optional[InputError] = None
        self._pending: dict[Group, dict[str, Fields]] = {group: {} for group in groups}
        self._pending_size = 0
        self._where: dict[Group, dict[str, tuple[Path, int]]] = {group: {} for group in groups}
        self._check()
        for group in groups:
            self._look(group)

    def _check(self) -> None:
        """Checks that the folder is a store of this program's format, if it is there."""
        if self.folder is None or not self.folder.exists():
            return
        header = self.folder / "store.json"
        if not self.folder.is_dir():
            raise _error("FILE_UNREADABLE", "the store is no folder", "name a folder", self.folder)
        if not header.exists():
            # Files that begin with a dot are no one's results: such as those that are being written.
            if any(not path.name.startswith(".") for path in self.folder.iterdir()):
                raise _error(
                    "UNSUPPORTED_FEATURE",
                    "the folder has files and is no store",
                    "name an empty folder, or one that is not there yet",
                    self.folder,
                )
            return
        try:
            found = json.loads(header.read_text(encoding="utf8"))
            number = found["format"]
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise _error("MALFORMED_FILE", f"not a store: {error}", "", header) from None
        if number != FORMAT:
            raise _error(
                "UNSUPPORTED_FEATURE",
                f"the store has the format {number}, this program (girth {_girth.version}) knows {FORMAT}",
                f"use the girth that made it ({found.get('program', 'not known')}), or another folder",
                header,
            )

    def _look(self, group: Group) -> None:
        """Which models are there."""
        if self.folder is None:
            return
        for path in sorted((self.folder / group.folder).glob("*.npz")):
            try:
                with np.load(path, allow_pickle=False) as shard:
                    keys = shard["keys"].astype("U").tolist()
            except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile) as error:
                warnings.warn(f"{path} cannot be read and is passed over: {error}", stacklevel=2)
                continue
            for row, key in enumerate(keys):
                self._where[group].setdefault(key, (path, row))

    def has(self, group: Group, key: str) -> bool:
        """Whether a model's fields are there."""
        return key in self._where[group] or key in self._pending[group]

    def add(self, group: Group, key: str, fields: Fields) -> None:
        """Takes a model's fields; `save` writes them."""
        if not self.has(group, key):
            self._pending[group][key] = fields
            self._pending_size += fields.size

    @property
    def unsaved(self) -> tuple[int, int]:
        """Models and bytes that are not written yet."""
        return sum(map(len, self._pending.values())), self._pending_size

    def save(self) -> None:
        """Writes what is not written yet; what cannot be written stays, and `fault` states why."""
        if self.folder is None:
            return
        self.fault = None
        for group, pending in self._pending.items():
            if not pending:
                continue
            try:
                path = self._write(group, pending)
            except OSError as error:
                reason = error.strerror or str(error)
                self.fault = _error(
                    "FILE_UNWRITABLE",
                    f"the fields of {len(pending)} models could not be written: {reason}",
                    "make room, or the folder writable, and run it again; what was written is kept",
                    Path(error.filename or self.folder),
                )
                continue
            self._pending_size -= sum(fields.size for fields in pending.values())
            for row, key in enumerate(pending):
                self._where[group][key] = (path, row)
            pending.clear()

    def _write(self, group: Group, pending: Mapping[str, Fields]) -> Path:
        assert self.folder is not None
        folder = self.folder / group.folder
        header = json.dumps({"format": FORMAT, "program": _girth.version})
        # The header comes before all else: a folder with anything in it and without a header is no store.
        for path, text in (
            (self.folder / "store.json", header + "\n"),
            (folder / "parameters.txt", group.parameters),
        ):
            path.parent.mkdir(parents=True, exist_ok=True)
            if not path.exists():
                _write_whole(path, text.encode())
        all_fields = list(pending.values())
        sizes = [len(fields.weights) for fields in all_fields]
        shard = {
            "keys": np.array(list(pending), "S"),
            "offsets": np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64),
            "weights": np.concatenate([fields.weights for fields in all_fields]),
        }
        for name in group.names:
            shard[name] = np.concatenate([fields.values[name] for fields in all_fields])
        path = folder / f"{uuid.uuid4().hex}.npz"
        content = io.BytesIO()
        np.savez(content, **shard)
        _write_whole(path, content.getbuffer())
        return path

    def read(self, group: Group, keys: Iterable[str]) -> Iterator[tuple[str, Fields]]:
        """The fields of the models of these keys that are there, in any order."""
        by_shard: dict[Path, list[tuple[int, str]]] = {}
        for key in keys:
            pending = self._pending[group].get(key)
            if pending is not None:
                yield key, pending
            elif key in self._where[group]:
                path, row = self._where[group][key]
                by_shard.setdefault(path, []).append((row, key))
        for path, rows in by_shard.items():
            try:
                with np.load(path, allow_pickle=False) as file:
                    shard = {name: file[name] for name in ("offsets", "weights", *group.names)}
            except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile) as error:
                raise _error("MALFORMED_FILE", f"cannot be read: {error}", "delete it", path) from None
            for row, key in rows:
                part = slice(shard["offsets"][row], shard["offsets"][row + 1])
                values = {name: shard[name][part] for name in group.names}
                yield key, Fields(shard["weights"][part], values)


def _error(code: str, message: str, hint: str, path: Path) -> InputError:
    return InputError(code, message, hint or error_codes[code][1], -1, str(path))


def _write_whole(path: Path, content: "bytes | memoryview") -> None:
    """Writes a file that is there as a whole or not at all, also where the power fails."""
    beside = path.with_name(f".{uuid.uuid4().hex}.part")
    try:
        with open(beside, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        os.replace(beside, path)
    finally:
        beside.unlink(missing_ok=True)
