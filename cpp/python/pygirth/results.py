"""Results of the functions of Girth: small classes with arrays.

Vertices are numbered as in the arrays or the file that the mesh was made of, from 0. Lengths are in
model units.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Iterator, Optional, Union

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin

from pygirth import _members
from pygirth._members import *
from pygirth._result import Result

if TYPE_CHECKING:
    from pygirth.mesh import Mesh

__all__ = [
    "AxisLoop",
    "Barcode",
    "Bottleneck",
    "Comparison",
    "Contour",
    "Crease",
    "Cut",
    "CutPart",
    "Field",
    "Girth",
    "Handle",
    "HandleRemoval",
    "Handles",
    "Limb",
    "Loop",
    "Maximum",
    "Neck",
    "Necks",
    "OpenArc",
    "Part",
    "Parts",
    "Path",
    "PrintCheck",
    "Profile",
    "RefinedGirth",
    "RemovedHandle",
    "Section",
    "SectionCurve",
    "Segment",
    "Segments",
    "Tip",
    "Tips",
    "WeakPlace",
]
__all__ += _members.__all__


def _unit(unit: str) -> str:
    return f" {unit}" if unit else ""


class _Sequence:
    """A result that is a sequence of the entries of one of its lists."""

    #: The name of that list.
    _list: str

    def __len__(self) -> int:
        return len(getattr(self, self._list))

    def __getitem__(self, number: int) -> Any:
        return getattr(self, self._list)[number]

    def __iter__(self) -> Iterator[Any]:
        return iter(getattr(self, self._list))


class Field(NDArrayOperatorsMixin, Result):
    """Values at the vertices of a mesh; an array wherever NumPy takes one.

    Arithmetic, comparison, indexing and iteration are those of `values`, and give plain arrays.

    Attributes
    ----------
    mesh : Mesh
        The mesh that they are of.
    name : str
        Such as ``"sdf"``.
    values : ndarray of float64, shape (n,), or (n, d) where a vertex has several numbers
        One for each row of ``mesh.vertices``; NaN where there is none.
    unit : str
        Such as ``"metre"``; empty where it is not known.
    method : str
        How it was computed, in words, such as ``"30 rays"``; may be empty.
    """

    def __init__(
        self, mesh: "Mesh", name: str, values: np.ndarray, unit: str, method: str = ""
    ) -> None:
        self.mesh = mesh
        self.name = name
        self.values = values
        self.unit = unit
        self.method = method

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> np.ndarray:
        array = self.values if dtype is None else self.values.astype(dtype, copy=False)
        return array.copy() if copy else array

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        plain = (one.values if isinstance(one, Field) else one for one in inputs)
        return getattr(ufunc, method)(*plain, **options)

    def __len__(self) -> int:
        return len(self.values)

    def __getitem__(self, key: Any) -> Any:
        return self.values[key]

    def __iter__(self) -> Iterator[Any]:
        return iter(self.values)

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of `values`."""
        return self.values.shape

    @property
    def dtype(self) -> np.dtype:
        """The type of `values`."""
        return self.values.dtype

    def min(self, axis: Optional[int] = None) -> Any:
        """The least of `values`; NaN where one of them is."""
        return self.values.min(axis)

    def max(self, axis: Optional[int] = None) -> Any:
        """The greatest of `values`; NaN where one of them is."""
        return self.values.max(axis)

    def mean(self, axis: Optional[int] = None) -> Any:
        """The mean of `values`; NaN where one of them is."""
        return self.values.mean(axis)

    def argmin(self, axis: Optional[int] = None) -> Any:
        """The row of the least value."""
        return self.values.argmin(axis)

    def argmax(self, axis: Optional[int] = None) -> Any:
        """The row of the greatest value."""
        return self.values.argmax(axis)

    @property
    def range(self) -> tuple[float, float]:
        """The least and the greatest value; NaN where there is none."""
        known = self.values[~np.isnan(self.values)]
        return (float(known.min()), float(known.max())) if known.size else (np.nan, np.nan)

    def _line(self) -> str:
        least, greatest = self.range
        shape = f", {self.values.shape[1]} numbers each" if self.values.ndim > 1 else ""
        unit = _unit(self.unit)
        return f"{self.name} of {len(self)} vertices{shape}, {least:.4g} to {greatest:.4g}{unit}"

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the field to a file: ``mesh.save(path, field)``.

        Parameters
        ----------
        path : str or path
            Ends with .csv, .json, .npy, .ply or .glb.
        """
        self.mesh.save(path, self)

    def to_pyvista(self) -> Any:
        """The mesh as PyVista's ``PolyData`` with the values as point data of the field's name.

        Returns
        -------
        pyvista.PolyData

        Raises
        ------
        MissingPackageError
            PROGRAM_NOT_LOADED where PyVista is not installed; it is an ImportError.
        """
        polygons = self.mesh.to_pyvista()
        polygons.point_data[self.name] = self.values
        return polygons


class Girth(Field):
    """The girth at the vertices of a mesh.

    Attributes
    ----------
    mesh, name, values, unit
        As of `Field`.
    method : str
        ``"exact"``, ``"refined"`` or ``"ms"``.
    persistence : float
        tau, where it is that of `Mesh.igf`; otherwise 0.
    kinds : ndarray of uint8, shape (n,)
        How each value came about: 0 loop, 1 antipodal, 2 unresolved (the value is a lower bound);
        255 where there is none.
    """

    KINDS = ("loop", "antipodal", "unresolved")

    def __init__(
        self,
        mesh: "Mesh",
        values: np.ndarray,
        kinds: np.ndarray,
        method: str,
        unit: str,
        persistence: float = 0.0,
    ) -> None:
        super().__init__(mesh, "igf", values, unit, method)
        self.kinds = kinds
        self.persistence = persistence

    def to_pyvista(self) -> Any:
        """As `Field.to_pyvista`, with the kinds as the point data ``igf_kind``."""
        polygons = super().to_pyvista()
        polygons.point_data["igf_kind"] = self.kinds
        return polygons


class RefinedGirth(Girth):
    """The girth at the vertices of a large mesh, most of it from bands of faces round loops.

    Attributes
    ----------
    mesh, name, values, unit, method, persistence, kinds
        As of `Girth`; every value is the length of a geodesic loop, NaN where none was found.
    states : ndarray of uint8, shape (n,)
        How sure each value is: 0 proved (exact), 1 consistent (in agreement with all neighbours),
        2 suspect; 255 where there is no vertex.
    audit : dict
        States of how many ``vertices``, drawn at random, the values were ``equal`` to the exact ones
        to 1e-6, so that with a probability of 95% the share of all is between ``at_least`` and
        ``at_most``; and the ``median``, ``percentile95`` and ``greatest`` difference, as shares.
    """

    STATES = ("proved", "consistent", "suspect")

    def __init__(
        self,
        mesh: "Mesh",
        values: np.ndarray,
        kinds: np.ndarray,
        states: np.ndarray,
        audit: dict,
        unit: str,
    ) -> None:
        super().__init__(mesh, values, kinds, "refined", unit)
        self.states = states
        self.audit = audit

    def to_pyvista(self) -> Any:
        """As `Girth.to_pyvista`, with the states as the point data ``igf_state``."""
        polygons = super().to_pyvista()
        polygons.point_data["igf_state"] = self.states
        return polygons


class Loop(_members.Loop):
    def _line(self) -> str:
        return f"{self.kind}, length {self.length:.6g}, {len(self.points)} points"


class Barcode(Result):
    """The saddles of the distance from a point, by their distance, and how long they last.

    Attributes
    ----------
    births, deaths : ndarray of float64, shape (k,)
        Where each saddle is, and where a side of its loop has been filled: distances from the
        point, in model units. A death is infinite where the loop cuts nothing off, or where nothing
        is filled up to `max_persistence` behind the birth. The last saddle is the first that lasts
        longer than that.
    loops : list of Loop
        The loop of each saddle, where they were asked for; otherwise empty.
    max_persistence : float
        Persistence is known up to this, in model units.
    rest : float
        Twice the greatest distance, where all saddles are listed; otherwise a lower bound of it.
    rest_kind : str
        ``"antipodal"`` or ``"unresolved"``: a lower bound.
    """

    def __init__(self, found: dict) -> None:
        bars = found["bars"]
        self.births: np.ndarray = np.array([bar["birth"] for bar in bars], np.float64)
        self.deaths: np.ndarray = np.array([bar["death"] for bar in bars], np.float64)
        self.loops = [Loop(loop) for loop in found["loops"]]
        self.max_persistence: float = found["max_persistence"]
        self.rest: float = found["rest"]["length"]
        self.rest_kind: str = found["rest"]["kind"]

    def __len__(self) -> int:
        return len(self.births)

    def girth(self, persistence: float) -> tuple[float, str]:
        """The persistent girth at the point, and its kind, read off the saddles.

        Parameters
        ----------
        persistence : float
            tau, above 0, in model units: saddles that last no longer do not count.

        Returns
        -------
        length : float
        kind : str
            As of `Loop`; ``"unresolved"``: the length is a lower bound.
        """
        lasting = np.flatnonzero(self.deaths - self.births > persistence)
        if not len(lasting):
            return self.rest, self.rest_kind
        first = lasting[0]
        is_known = persistence <= self.max_persistence or np.isfinite(self.deaths[first])
        return 2 * float(self.births[first]), "loop" if is_known else "unresolved"

    def _line(self) -> str:
        return f"{len(self)} saddles, up to the persistence {self.max_persistence:.4g}"


class Path(_members.Path):
    def _line(self) -> str:
        return f"length {self.length:.6g}, {len(self.points)} points"


class Neck(_members.Neck):
    def _line(self) -> str:
        return f"length {self.length:.6g}, prominence {self.prominence:.4g}"


class Handle(_members.Handle):
    def _line(self) -> str:
        return f"{self.kind}, length {self.length:.6g}"


class _Loops(_Sequence):
    """A sequence of loops."""

    @property
    def lengths(self) -> np.ndarray:
        """The length of each, float64."""
        return np.array([loop.length for loop in self], np.float64)

    def _line(self) -> str:
        return f"{len(self)} {self._list}, lengths {[float(f'{x:.4g}') for x in self.lengths]}"


class Necks(_Loops, _members.Necks):
    _list = "necks"

    @property
    def prominences(self) -> np.ndarray:
        """The prominence of each, float64."""
        return np.array([neck.prominence for neck in self], np.float64)


class Handles(_Loops, _members.Handles):
    _list = "handles"


class RemovedHandle(_members.RemovedHandle):
    def _line(self) -> str:
        return f"{self.kind}, length {self.length:.6g}"


class HandleRemoval(_members.HandleRemoval):
    __doc__ = f"""{_members.HandleRemoval.__doc__}mesh : Mesh
        The surface that is left, with vertices and faces of its own.
    """

    mesh: "Mesh"

    def __init__(self, mesh: "Mesh", found: dict) -> None:
        super().__init__(found)
        self.mesh = mesh

    def _line(self) -> str:
        return f"{len(self.removed)} removed, genus {self.genus_before} to {self.genus_after}"


class Maximum(_members.Maximum):
    def _line(self) -> str:
        return f"vertex {self.vertex}, value {self.value:.6g}, persistence {self.persistence:.4g}"


class WeakPlace(_members.WeakPlace):
    def _line(self) -> str:
        return f"{self.kind}, {self.measure} {self.least:.4g}"


class Crease(_members.Crease):
    def _line(self) -> str:
        return f"{self.kind}, length {self.length:.4g}"


class PrintCheck(_members.PrintCheck):
    def _line(self) -> str:
        return f"{len(self.places)} weak places, passes from {self.passing_scale:.4g}"


class Bottleneck(_members.Bottleneck):
    def _line(self) -> str:
        return f"{self.kind}, girth {self.girth:.6g}"


class Profile(Result):
    """The girth along a path.

    Attributes
    ----------
    distances, girths : ndarray of float64, shape (k,)
        How far along the path, and the girth there, in model units.
    kinds : ndarray of uint8, shape (k,)
        As of `Girth`.
    points : ndarray of float64, shape (k, 3)
        The places.
    """

    def __init__(
        self, distances: np.ndarray, girths: np.ndarray, kinds: np.ndarray, points: np.ndarray
    ) -> None:
        self.distances = distances
        self.girths = girths
        self.kinds = kinds
        self.points = points

    def __len__(self) -> int:
        return len(self.distances)

    def _line(self) -> str:
        return (
            f"{len(self)} places, length {self.distances[-1]:.6g}, "
            f"girth {self.girths.min():.4g} to {self.girths.max():.4g}"
        )


class AxisLoop(_members.AxisLoop):
    def _line(self) -> str:
        return f"distance {self.distance:.4g}, girth {self.girth:.6g}"


class CutPart(_members.PartMeasures):
    __doc__ = f"""{_members.PartMeasures.__doc__}vertices : ndarray of float64, shape (n, 3)
        Both sides of a cut have vertices of their own.
    faces : ndarray of int64, shape (m, 3)
        Three rows of ``vertices`` each.
    face_rows : ndarray of int64, shape (m,)
        For each face the row of ``mesh.faces`` that it is a piece of; -1: of a cap.
    """

    vertices: np.ndarray
    faces: np.ndarray
    face_rows: np.ndarray

    def _line(self) -> str:
        return f"{len(self.faces)} faces, area {self.area:.6g}"


class Cut(_Sequence, Result):
    """The parts of a mesh that was cut, the largest first; a sequence of `CutPart`.

    Attributes
    ----------
    parts : list of CutPart
    labels : ndarray of int64, shape (m,)
        For each row of ``mesh.faces`` the part that has most of its area; -1 where the face was
        dropped.
    """

    _list = "parts"

    def __init__(self, parts: list, labels: np.ndarray) -> None:
        self.parts = [CutPart(part) for part in parts]
        self.labels = labels

    def _line(self) -> str:
        return f"{len(self)} parts, areas {[float(f'{part.area:.4g}') for part in self.parts]}"


class Contour(_members.Contour):
    def _line(self) -> str:
        return f"{'closed' if self.closed else 'open'}, {len(self.points)} points"


class SectionCurve(_members.SectionCurve):
    def _line(self) -> str:
        return f"{'closed' if self.closed else 'open'}, perimeter {self.perimeter:.6g}"


class Section(_members.Section):
    def _line(self) -> str:
        return f"{len(self.curves)} curves, perimeter {self.perimeter:.6g}, area {self.area:.6g}"


class Tip(_members.Tip):
    def _line(self) -> str:
        return f"{len(self.vertices)} vertices, apex {self.apex}, jump {self.jump:.4g}"


class OpenArc(_members.OpenArc):
    @property
    def closed(self) -> bool:
        """``line.closed``: the older name, until 2.0."""
        return self.line.closed

    @property
    def points(self) -> np.ndarray:
        """``line.points``: the older name, until 2.0."""
        return self.line.points

    def _line(self) -> str:
        return f"length {self.length:.6g}, {len(self.line.points)} points"


class Tips(_Sequence, _members.Tips):
    __doc__ = f"""{_members.Tips.__doc__}mesh : Mesh
        The mesh that they are of.
    """

    _list = "tips"
    mesh: "Mesh"

    def __init__(self, mesh: "Mesh", found: dict) -> None:
        super().__init__(found)
        self.mesh = mesh

    @property
    def apexes(self) -> np.ndarray:
        """The apex of each tip, int64."""
        return np.array([tip.apex for tip in self], np.int64)

    def _line(self) -> str:
        return f"{len(self)} tips, apexes {self.apexes.tolist()}"


class Limb(_members.Limb):
    def _line(self) -> str:
        return f"apex {self.apex}, length {self.length:.4g}, narrowest {self.narrowest:.4g}"


class Part(_members.Part):
    def _line(self) -> str:
        return f"{self.kind}, {len(self.vertices)} vertices, area {self.area:.4g}"


class Parts(_Sequence, Result):
    """A mesh divided into tubes, plates and body, largest part first; a sequence of `Part`.

    Attributes
    ----------
    mesh : Mesh
        The mesh that they are of.
    parts : list of Part
    labels : ndarray of int64, shape (n,)
        For each row of ``mesh.vertices`` its part's number; -1 where the vertex was dropped.
    girth, shape_diameter : float
        The thresholds that were used, in model units.
    """

    _list = "parts"

    def __init__(
        self, mesh: "Mesh", girth: float, shape_diameter: float, labels: np.ndarray, parts: list
    ) -> None:
        self.mesh = mesh
        self.parts = [Part(part) for part in parts]
        self.labels = labels
        self.girth = girth
        self.shape_diameter = shape_diameter

    def _line(self) -> str:
        kinds = [part.kind for part in self.parts]
        counts = [f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds)]
        return f"{len(self)} parts ({', '.join(counts)})"


class Segment(_members.Segment):
    __doc__ = f"""{_members.Segment.__doc__}area : float
        In squared model units.
    tips : list of int
        Numbers in ``mesh.tips()`` of those that end on it.
    apexes : ndarray of int64
        The apex of each of these; -1 where it was made by the preparation.
    """

    area: float
    tips: list[int]
    apexes: np.ndarray

    def __init__(self, found: dict) -> None:
        super().__init__({**found, "apexes": np.array(found["apexes"], np.int64)})

    def _line(self) -> str:
        return f"{self.kind}, area {self.area:.4g}, tips {self.tips}"


class Segments(_Sequence, Result):
    """A mesh divided at its necks, largest part first; a sequence of `Segment`.

    Attributes
    ----------
    mesh : Mesh
        The mesh that they are of.
    segments : list of Segment
    labels : ndarray of int64, shape (m,)
        For each row of ``mesh.faces`` the segment that has most of its area; -1 where the face was
        dropped.
    girth, shape_diameter : float
        The thresholds by which kinds were told apart, in model units.
    crossing : list of int
        Numbers in ``mesh.necks()`` of those that were passed over, as they cross more prominent
        ones.
    """

    _list = "segments"

    def __init__(
        self,
        mesh: "Mesh",
        girth: float,
        shape_diameter: float,
        labels: np.ndarray,
        segments: list,
        crossing: list,
    ) -> None:
        self.mesh = mesh
        self.segments = [Segment(segment) for segment in segments]
        self.labels = labels
        self.girth = girth
        self.shape_diameter = shape_diameter
        self.crossing: list[int] = crossing

    def _line(self) -> str:
        return f"{len(self)} segments: {', '.join(segment.kind for segment in self)}"


class Comparison(Result):
    """How far models are apart.

    Attributes
    ----------
    descriptors : tuple of str
        By which they were compared.
    distances : dict of str to ndarray of float64, shape (models, models)
        The matrix by each descriptor: symmetric, zeros on the diagonal, NaN where a model has no
        value at all. Models have the area 1, so that size does not matter.
    """

    def __init__(self, distances: dict[str, np.ndarray]) -> None:
        self.distances = distances
        self.descriptors = tuple(distances)

    def __getitem__(self, descriptor: str) -> np.ndarray:
        return self.distances[descriptor]

    def _line(self) -> str:
        models = len(next(iter(self.distances.values())))
        return f"{models} models by {', '.join(self.descriptors)}"
