"""The fields of a collection from a shell, a share of it at a time.

    python -m pygirth.collection fields LIST --store fields --part 3/40
    python -m pygirth.collection matrix LIST --store fields -o igf.npy
    python -m pygirth.collection nearest LIST --store fields -k 10 -o igf.csv

LIST is a text file with a path a line, relative to its folder; ``-`` is standard input.
"""

from __future__ import annotations

import argparse
import csv
import os
import re
import signal
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, Optional, Sequence

import numpy as np

from pygirth.collection import NAMES, Collection, fields
from pygirth.collection._clients import cores
from pygirth.errors import GirthError, error_codes, input_error


def _listed(path: str) -> list[str]:
    try:
        if path == "-":
            return [line.rstrip("\n") for line in sys.stdin if line.strip()]
        lines = Path(path).read_text(encoding="utf8", errors="surrogateescape").split("\n")
    except OSError as error:
        raise input_error("FILE_NOT_FOUND", f"{path}: {error.strerror}") from None
    return [str(Path(path).parent / line.rstrip("\r")) for line in lines if line.strip()]


def _part(text: str) -> tuple[int, int]:
    """'3/40': the third of forty."""
    match = re.fullmatch(r"(\d+)/(\d+)", text)
    if not match or not 1 <= int(match[1]) <= int(match[2]):
        raise argparse.ArgumentTypeError("write a part as 3/40, from 1/40 to 40/40")
    return int(match[1]), int(match[2])


def _arguments(words: Optional[Sequence[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="python -m pygirth.collection",
        description="Fields, distances and nearest neighbours of a collection of models.",
    )
    commands = parser.add_subparsers(dest="command", required=True)
    for name, words_on_it in (
        ("fields", "computes what the store has not"),
        ("matrix", "the distances between all models, as NPY"),
        ("nearest", "the models nearest to each, as CSV: file, rank, neighbour, distance"),
    ):
        command = commands.add_parser(name, help=words_on_it, description=words_on_it)
        command.add_argument("list", help="a text file with a path a line; - is standard input")
        command.add_argument("--store", required=True, help="the folder that keeps the fields")
        command.add_argument(
            "--faces", type=int, default=10_000, help="larger models are remeshed; 0: as they are"
        )
        command.add_argument(
            "--smooth", type=int, default=0, metavar="STEPS", help="smoothing steps for rough models; default: 0"
        )
        command.add_argument("--jobs", type=int, default=0, help="models at a time; 0: one a core")
        if name == "fields":
            command.add_argument("--names", default="igf", help=f"of {','.join(NAMES)}")
            command.add_argument(
                "--save-every", type=float, default=5, metavar="S", help="seconds; default: 5"
            )
            command.add_argument("--part", type=_part, default=(1, 1), help="the part to compute: 3/40 is the third of forty")
        else:
            command.add_argument("--name", default="igf", choices=NAMES, help="the field that is compared")
            command.add_argument("-o", "--output", required=True, help="the file to write")
        if name == "nearest":
            command.add_argument("-k", type=int, default=10, help="number of neighbours; default: 10")
    return parser.parse_args(words)


def _write(path: str, write: Any) -> None:
    """Writes a file that is there whole or not at all."""
    beside = f"{path}.part"
    try:
        with open(beside, "wb") as file:
            write(file)
        os.replace(beside, path)
    except OSError as error:
        raise input_error("FILE_UNWRITABLE", f"{path}: {error.strerror}") from None
    finally:
        Path(beside).unlink(missing_ok=True)


def _write_nearest(file: Any, models: Collection, found: Any) -> None:
    lines = _Text(file)
    table = csv.writer(lines, lineterminator="\n")
    table.writerow(["file", "rank", "neighbour", "distance"])
    for model, numbers, distances in zip(models.models, found.numbers, found.distances):
        for rank, (number, distance) in enumerate(zip(numbers.tolist(), distances.tolist())):
            if number >= 0:
                table.writerow([model, rank + 1, models.models[number], repr(distance)])


class _Text:
    """A text of csv's, as bytes of any file name."""

    def __init__(self, file: Any) -> None:
        self._file = file

    def write(self, text: str) -> None:
        self._file.write(text.encode("utf8", "surrogateescape"))


def _stopped(*_: Any) -> None:
    """A scheduler sends this before it kills: all that is computed is written."""
    raise KeyboardInterrupt


def run(words: Optional[Sequence[str]] = None) -> int:
    """Runs a command; returns its exit code: that of `girth`, and 3 where it was stopped."""
    options = _arguments(words)
    signal.signal(signal.SIGTERM, _stopped)
    try:
        files = _listed(options.list)
        part, parts = getattr(options, "part", (1, 1))
        names = options.names.split(",") if options.command == "fields" else [options.name]
        if not 0 <= options.jobs <= 1024:
            raise input_error("INVALID_OPTION", f"jobs is {options.jobs}", "choose 0 to 1024")
        with ThreadPoolExecutor(options.jobs or cores()) as pool:
            models = fields(
                files[part - 1 :: parts],
                client=pool,
                store=options.store,
                names=names,
                faces=options.faces,
                smooth=options.smooth,
                save_every=getattr(options, "save_every", 5.0),
            )
        for error in models.failed.values():
            print(error, file=sys.stderr)
        if models.unsaved:
            print(models.unsaved, file=sys.stderr)
        if options.command == "matrix":
            matrix = models.distances(options.name)
            _write(options.output, lambda file: np.save(file, matrix))
        elif options.command == "nearest":
            found = models.nearest(options.name, options.k)
            _write(options.output, lambda file: _write_nearest(file, models, found))
        print(
            f"{len(models)} models: {models.computed} computed, {models.reused} found in the store, "
            f"{len(models.failed)} failed"
        )
    except GirthError as error:
        print(error, file=sys.stderr)
        return error_codes[error.code][0]
    except KeyboardInterrupt:
        print("stopped; what was computed is in the store", file=sys.stderr)
        return 3
    return 2 if models.failed or models.unsaved else 0


if __name__ == "__main__":
    sys.exit(run())
