"""Meshes of other libraries: recognised by what they have, without importing them; and made where asked for."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from pygirth._arguments import faces_of, vertices_of
from pygirth.errors import MissingPackageError, input_error


def arrays_of(model: Any) -> Optional[tuple[np.ndarray, np.ndarray]]:
    """(V, F) of a model; None where it is nothing that is known.

    Taken are ``(V, F)``, ``trimesh.Trimesh`` (``vertices`` and ``faces``), ``meshio.Mesh``
    (``points`` and ``cells``) and PyVista's ``PolyData`` (``points`` and a flat ``faces``).
    Polygons are cut into triangles from their first corner.
    """
    if isinstance(model, (tuple, list)) and len(model) == 2:
        return vertices_of(model[0]), faces_of(model[1])
    if hasattr(model, "vertices") and hasattr(model, "faces"):
        return vertices_of(model.vertices), faces_of(model.faces)
    if hasattr(model, "points") and hasattr(model, "cells") and not hasattr(model, "n_cells"):
        return vertices_of(model.points), _faces_of_cells(model.cells)
    if hasattr(model, "points") and hasattr(model, "faces"):
        return vertices_of(model.points), _faces_of_row(np.asarray(model.faces))
    return None


def _faces_of_cells(cells: Any) -> np.ndarray:
    """The surface among meshio's blocks of cells."""
    found = [
        _fans(np.asarray(block.data))
        for block in cells
        if block.type in ("triangle", "quad", "polygon") and len(block.data) > 0
    ]
    if not found:
        kinds = ", ".join(sorted({str(block.type) for block in cells})) or "none"
        raise input_error(
            "EMPTY_MESH",
            f"the mesh has no triangles (its cells: {kinds})",
            "pass a surface: triangles or quads",
        )
    return faces_of(np.concatenate(found))


def _fans(polygons: np.ndarray) -> np.ndarray:
    if polygons.ndim != 2 or polygons.shape[1] < 3:
        raise input_error("USAGE", "cells of a surface have three corners or more")
    sides = range(1, polygons.shape[1] - 1)
    fans = [polygons[:, [0, side, side + 1]] for side in sides]
    return np.stack(fans, axis=1).reshape(-1, 3)


def _faces_of_row(row: np.ndarray) -> np.ndarray:
    """Faces as VTK has them: the number of corners, then the corners, face after face."""
    if row.ndim == 2:
        return faces_of(row)
    if row.size % 4 == 0 and row.dtype.kind in "iu" and (row[::4] == 3).all():
        return faces_of(row.reshape(-1, 4)[:, 1:])
    found = []
    at = 0
    while at < row.size:
        corners = int(row[at])
        if corners < 3 or at + corners >= row.size:
            raise input_error(
                "USAGE", f"face {len(found)} of the faces has {corners} corners", element=len(found)
            )
        found.append(_fans(row[at + 1 : at + 1 + corners].reshape(1, -1)))
        at += corners + 1
    return faces_of(np.concatenate(found) if found else np.zeros((0, 3), np.int64))


def polydata_of(vertices: np.ndarray, faces: np.ndarray) -> Any:
    """PyVista's ``PolyData`` of a mesh; a MissingPackageError where there is no PyVista."""
    try:
        import pyvista
    except ModuleNotFoundError as error:
        # A package that PyVista itself does not find is its own matter.
        if error.name != "pyvista":
            raise
        raise MissingPackageError.of("PyVista", "to_pyvista") from None
    corners = np.full((len(faces), 1), 3, np.int64)
    return pyvista.PolyData(np.array(vertices), np.hstack([corners, faces]).ravel())
