"""A mesh with its values as a page that can be turned and looked at, whole in itself."""

from __future__ import annotations

import base64
import html
import importlib.resources
import json
import os
import re
import zlib
from typing import Any, Iterable, Optional, Sequence, Union

import numpy as np

from pygirth._arguments import one_of, path_of, real_number, running, whole_number
from pygirth.errors import MissingPackageError, input_error
from pygirth.mesh import FIELDS, Mesh, as_mesh
from pygirth.results import Field

__all__ = ["Shown", "show"]

COLORMAPS = ("viridis", "cividis", "plasma", "magma", "turbo", "rdbu")


#: Surfaces that lie farther from the origin, in their own sizes, are drawn from a point of theirs.
FAR = 64

#: Bytes that are compressed at once: some 20 ms.
PIECE = 1 << 20

class Shown:
    """A page that shows a mesh: displayed by Jupyter as it is, and saved by `save`.

    Nothing is fetched for it and no server is needed: the program, the mesh and the values are in
    the page.

    Attributes
    ----------
    page : str
        The whole page, as HTML.
    height : int
        The height of the fragment in a notebook, in CSS pixels.
    """

    def __init__(self, page: str, title: str, height: int) -> None:
        self.page = page
        self.height = height
        self._title = title

    def __repr__(self) -> str:
        return f"<pygirth.Shown: {self._title}, {len(self.page) / 1e6:.1f} MB>"

    def _repr_html_(self) -> str:
        """The page as a fragment of another one: a frame of its own."""
        return (
            f'<iframe srcdoc="{html.escape(self.page)}" title="{html.escape(self._title)}" '
            f'style="width: 100%; height: {self.height}px; border: 0"></iframe>'
        )

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the page to a file that any browser opens.

        Parameters
        ----------
        path : str or path
            Such as ``"model.html"``; replaced where it is there.
        """
        with open(path_of(path), "w", encoding="utf8") as file:
            file.write(self.page)


def show(
    model: Any,
    field: Any = None,
    *,
    title: str = "",
    colormap: Optional[str] = None,
    range: Optional[Sequence[float]] = None,
    isolines: int = 0,
    log: bool = False,
    edges: bool = False,
    up: Optional[str] = None,
    loops: Iterable[int] = (),
    points: Iterable[int] = (),
    name: str = "",
    height: int = 480,
) -> Shown:
    """A mesh to turn and look at, in Jupyter or as a page, coloured by values.

    Parameters
    ----------
    model : anything that `as_mesh` takes, or Field
        A `Field` stands for its mesh, coloured by it.
    field : Field, str or array_like of float, shape (n,), optional
        The values that colour it: a result, the name of a field, which is computed, or one value for
        each row of ``vertices``; NaN is grey. Default: nothing.
    title : str, optional
        The legend's words for the values. Default: the field's usual name.
    colormap : {'viridis', 'cividis', 'plasma', 'magma', 'turbo', 'rdbu'}, optional
    range : (float, float), optional
        The values at the ends of the colour map. Default: the body of the values.
    isolines : int, optional
        So many lines of equal value, 0 to 100.
    log : bool, optional
        Whether the colour map is logarithmic.
    edges : bool, optional
        Whether the mesh's edges are drawn.
    up : {'x', 'y', 'z', '-x', '-y', '-z'}, optional
        Which direction is up. Default: a guess from the shape.
    loops : iterable of int, optional
        Vertices whose loops are drawn and measured.
    points : iterable of int, optional
        Vertices that are marked, such as ``m.tips().apexes``.
    name : str, optional
        The name of what is shown.
    height : int, optional
        In a notebook, in CSS pixels, 100 to 10,000.

    Returns
    -------
    Shown

    Raises
    ------
    InputError
        USAGE, INVALID_OPTION or VERTEX_OUT_OF_RANGE.
    MissingPackageError
        PROGRAM_NOT_LOADED where the package was installed without the viewer.

    Examples
    --------
    >>> pygirth.show(m, "igf")
    >>> pygirth.show(m.igf(), points=m.tips().apexes).save("octopus.html")
    """
    if field is None and isinstance(model, Field):
        field = model
    mesh = model.mesh if isinstance(model, Field) else as_mesh(model)
    pixels = whole_number(height, "height")
    if not 100 <= pixels <= 10_000:
        raise input_error("INVALID_OPTION", f"height is {pixels}", "choose 100 to 10,000")
    lines = whole_number(isolines, "isolines")
    if not 0 <= lines <= 100:
        raise input_error("INVALID_OPTION", f"isolines is {lines}", "choose 0 to 100")
    vertices = [mesh._vertex(row) for row in loops]
    slot, words, values, kinds, method = _values_of(mesh, field)
    attributes = {
        "field": slot,
        "field-title": str(title) or words,
        "loop": " ".join(map(str, vertices)) or "none",
        "isolines": str(lines),
        "controls": "true",
    }
    if colormap is not None:
        attributes["colormap"] = one_of(colormap, "colormap", COLORMAPS)
    if up is not None:
        attributes["up"] = one_of(up, "up", ("x", "y", "z", "-x", "-y", "-z"))
    if range is not None:
        attributes["range"] = " ".join(map(repr, _ends(range)))
    if log:
        attributes["log"] = "true"
    if edges:
        attributes["edges"] = "true"
    caption = str(name) or "Girth"
    content = _surface(mesh, str(name))
    content["points"] = [mesh._vertex(row) for row in points]
    content["loops"] = [_loop(mesh, vertex, content) for vertex in vertices]
    content["field"] = None
    if values is not None:
        content["field"] = {
            "name": slot,
            "unit": content["unit"],
            "method": method,
            "values": _packed(values, np.float64),
            "kinds": _packed(kinds, np.uint8),
        }
    parts = {
        "title": html.escape(caption),
        "attributes": " ".join(
            f'{key}="{html.escape(value)}"' for key, value in attributes.items() if value
        ),
        # The end of a script in HTML is written otherwise in JSON and in JavaScript.
        "content": json.dumps(content).replace("<", "\\u003c"),
        "program": _viewer("girth-shown.js").replace("</script", "<\\/script"),
    }
    page = re.sub(r"\{\{(\w+)\}\}", lambda found: parts[found[1]], _viewer("girth-shown.html"))
    return Shown(page, caption, pixels)


def _viewer(name: str) -> str:
    file = importlib.resources.files("pygirth") / name
    if not file.is_file():
        raise MissingPackageError(
            "PROGRAM_NOT_LOADED",
            "show needs the viewer, which was not built when the package was installed",
            "in a clone with Node.js: npm run build:shown && python -m pip install ./cpp/python",
        )
    return file.read_text(encoding="utf8")


def _values_of(
    mesh: Mesh, field: Any
) -> tuple[str, str, Optional[np.ndarray], np.ndarray, str]:
    """The page's name of the field, the legend's words where these are not its own, values and
    kinds at the surface's vertices, and the method."""
    kinds = np.zeros(0, np.uint8)
    if field is None:
        return "none", "", None, kinds, ""
    if isinstance(field, str):
        field = mesh.field(field)
    slot, words, method = "sihks", "Values", ""
    rows = field
    if isinstance(field, Field):
        rows, method = field.values, getattr(field, "method", "")
        if field.name in FIELDS:
            slot, words = field.name, ""
        else:
            # Lengths are written with their unit.
            slot = "geofarthest" if field.unit == mesh.unit else "sihks"
            words = field.name[:1].upper() + field.name[1:].replace("_", " ")
    rows = np.asarray(rows)
    if rows.dtype.kind not in "fiub":
        raise input_error("USAGE", f"values are {rows.dtype}, not real numbers")
    count = len(mesh.vertices)
    if rows.ndim == 2 and len(rows) == count:
        raise input_error(
            "USAGE",
            f"there are {rows.shape[1]} numbers at each vertex",
            "choose one of them: pygirth.show(m, field.values[:, 0])",
        )
    if rows.shape != (count,):
        raise input_error(
            "USAGE",
            f"values have the shape {rows.shape}, not ({count},)",
            "pass one value for each vertex of the mesh",
        )
    if hasattr(field, "kinds"):
        kinds = mesh._at_vertices(field.kinds, 255)
    values = mesh._at_vertices(rows.astype(np.float64), np.nan)
    return slot, words, np.where(np.isfinite(values), values, np.nan), kinds, method


def _ends(values: Sequence[float]) -> tuple[float, float]:
    ends = [real_number(value, "an end of the range") for value in values]
    if len(ends) != 2 or not ends[0] < ends[1] or not np.isfinite(ends).all():
        raise input_error("INVALID_OPTION", f"range is {values!r}", "pass two rising numbers")
    return ends[0], ends[1]


def _packed(array: np.ndarray, dtype: Any) -> str:
    """An array as pages carry it (web/src/element/model/packed.ts)."""
    data = np.ascontiguousarray(array, np.dtype(dtype).newbyteorder("<")).tobytes()
    # As gzip does; piece by piece, so that Ctrl-C is heard.
    packer = zlib.compressobj(6, zlib.DEFLATED, zlib.MAX_WBITS | 16)
    pieces = [packer.compress(data[i : i + PIECE]) for i in range(0, len(data), PIECE)]
    return base64.b64encode(b"".join([*pieces, packer.flush()])).decode()


def _surface(mesh: Mesh, name: str) -> dict[str, Any]:
    """The surface as the page draws it (web/src/element/saved-page.ts)."""
    core = mesh._surface
    positions, faces = core.positions(), core.triangles()
    low, high = positions.min(axis=0), positions.max(axis=0)
    is_far = np.abs(positions).max() > FAR * (high - low).max()
    origin = (low + high) / 2 if is_far else np.zeros(3)
    rows = mesh._row_of_vertex
    is_plain = np.array_equal(rows, np.arange(len(rows)))
    return {
        "name": name,
        "unit": mesh.unit,
        "origin": origin.tolist(),
        "size": (high - low).tolist(),
        "area": core.area,
        "positions": _packed(positions - origin, np.float32),
        "indices": _packed(faces, np.uint32),
        "boundary": _packed(core.boundary(), np.uint32),
        "areas": _packed(core.areas(), np.float64),
        "rows": None if is_plain else _packed(rows, np.int32),
    }


def _loop(mesh: Mesh, vertex: int, content: dict[str, Any]) -> dict[str, Any]:
    found = mesh._surface.loop((vertex, []), 0.0, running(1, None))
    origin = np.array(content["origin"])
    return {
        "length": found["length"],
        "kind": found["kind"],
        "base": vertex,
        "polyline": _packed(found["points"] - origin, np.float32),
        "midpoint": (found["midpoint"] - origin).tolist(),
        "angle": found["angle"] if np.isfinite(found["angle"]) else 0,
        "unit": content["unit"],
    }
