"""The work for each model, here or on a worker of a cluster."""

from __future__ import annotations

import hashlib
from typing import Any, Callable, Sequence, Union

import numpy as np

from pygirth import _girth
from pygirth._arguments import running
from pygirth.collection._clients import until_stopped
from pygirth.collection._store import Fields
from pygirth.errors import GirthError, LimitError
from pygirth.mesh import Mesh, as_mesh

#: A model's key, or why it has none.
Key = Union[str, GirthError]


def _key_of(mesh: Mesh) -> str:
    """A hash of the surface, all that its fields depend on beside parameters."""
    digest = hashlib.sha256()
    for array in (mesh._surface.positions(), mesh._surface.triangles()):
        digest.update(np.int64(array.size).tobytes())
        digest.update(array.tobytes())
    return digest.hexdigest()[:40]


def _guarded(work: Callable[[], Any]) -> Any:
    """The result of some work, or the error that it ends in."""
    until_stopped(0)
    try:
        return work()
    except GirthError as error:
        return error
    except MemoryError:
        return LimitError("OUT_OF_MEMORY", "there is not enough memory", "use a smaller model")
    except Exception as error:  # noqa: BLE001: one model must not stop the others
        return LimitError("INTERNAL", f"{type(error).__name__}: {error}", "report this with the model")


def check_version(version: str) -> None:
    """Checks that a worker computes what the program expects that sent it the task."""
    if version != _girth.version:
        raise LimitError(
            "PROGRAM_NOT_LOADED",
            f"a worker has girth {_girth.version}, the program that it works for has {version}",
            "install the same version everywhere",
        )


def keys_of(version: str, models: Sequence[Any]) -> list[Key]:
    """The keys of some models."""
    check_version(version)
    return [_guarded(lambda: _key_of(as_mesh(model))) for model in models]


def computed(
    version: str,
    models: Sequence[Any],
    wanted: Sequence[Sequence[tuple[str, ...]]],
    faces: int,
    smooth: int,
) -> list[Union[tuple[str, list[Fields]], GirthError]]:
    """The key of each model, and its fields of some groups of names."""
    check_version(version)

    def compute(model: Any, groups: Sequence[tuple[str, ...]]) -> tuple[str, list[Fields]]:
        mesh = as_mesh(model)
        found = []
        for names in groups:
            weights, values = _girth.compared_fields(
                mesh._surface, list(names), faces, smooth, running(1, until_stopped)
            )
            found.append(Fields(weights, {name: values[name][:, 0] for name in names}))
        return _key_of(mesh), found

    return [
        _guarded(lambda: compute(model, groups)) for model, groups in zip(models, wanted)
    ]
