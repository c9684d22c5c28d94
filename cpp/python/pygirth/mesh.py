"""Meshes, and everything that is computed of one."""

from __future__ import annotations

import os
from typing import Any, Iterable, Optional, Sequence, Union

import numpy as np

from pygirth import _girth
from pygirth._analyses import Analyses
from pygirth._arguments import (
    Progress,
    face_count,
    faces_of,
    one_of,
    path_of,
    real_number,
    running,
    smoothing_steps,
    vertices_of,
    whole_number,
)
from pygirth._fields import Fields
from pygirth._models import arrays_of, polydata_of
from pygirth._result import warn_of_older
from pygirth.errors import input_error
from pygirth.results import (
    AxisLoop,
    Barcode,
    Bottleneck,
    Comparison,
    Cut,
    Field,
    Girth,
    HandleRemoval,
    Handles,
    Limb,
    Loop,
    Maximum,
    Necks,
    Parts,
    Path,
    PrintCheck,
    Profile,
    RefinedGirth,
    Segments,
    Tips,
)

__all__ = ["FIELDS", "Mesh", "Point", "as_mesh", "compare", "igf", "load"]

#: The fields of `Mesh.field`, and which unit they have: a power of the model's, or radians.
FIELDS = _girth.fields()

#: A vertex, or a face with the shares of its three vertices.
Point = Union[int, tuple[int, Sequence[float]]]

_NONE = 255
_DEFAULTS = _girth.defaults()

#: How parameters of fields are read, by their kind in the table of fields.
_READERS = {
    "Count": lambda value, name: min(max(whole_number(value, name), 0), 2**31),
    "Degrees": real_number,
    "Method": lambda value, name: bool(value),
    "Length": real_number,
}


class Mesh(Analyses, Fields):
    """A triangle mesh as a surface on which lengths are measured.

    The surface is prepared as the reading of files does it: equal vertices become one, faces
    without area and duplicates are dropped, faces are oriented alike, edges of more than two faces
    are cut apart; other open edges are boundaries. `report` states what was done. Whatever is
    computed is numbered by the rows of ``V`` and ``F`` nevertheless.

    Parameters
    ----------
    V : array_like of float, shape (n, 3)
        Positions, in model units. C-contiguous float64 is kept without copying: do not change it
        afterwards.
    F : array_like of int, shape (m, 3)
        Three vertices for each face, counter-clockwise seen from outside.
    weld : float, optional
        Vertices no farther apart than this, in model units, also become one, and open
        edges are divided where a neighbour has a vertex within them. ``report`` names
        a distance as ``crack_width`` where the surface has cracks.
    close_holes : bool, optional
        Closes cracks, and fills every boundary curve with faces, but over faces.
    components : sequence of int, optional
        Keeps these connected components only, numbered by their first faces.
    min_component : float, optional
        Leaves out components whose area is less than this share of the largest one's, from 0 to 1.
    scale : float, optional
        Multiplies all positions first.
    unit : str, optional
        The unit of lengths, such as ``"mm"`` or ``"millimetre"``; empty where it is not known.

    Raises
    ------
    InputError
        With the codes USAGE (dtype or shape), EMPTY_MESH, NON_FINITE_POSITION (vertex of a face),
        INDEX_OUT_OF_RANGE (face), INVALID_OPTION or COMPONENT_OUT_OF_RANGE.

    Examples
    --------
    >>> m = pygirth.Mesh(V, F)
    >>> m.igf().values
    """

    def __init__(
        self,
        V: Any,
        F: Any,
        *,
        weld: float = 0.0,
        close_holes: bool = False,
        components: Sequence[int] = (),
        min_component: float = 0.0,
        scale: float = 1.0,
        unit: str = "",
    ) -> None:
        vertices, faces = vertices_of(V), faces_of(F)
        options = _preparing(weld, close_holes, components, min_component, scale)
        surface = _girth.Surface(vertices, faces, *options, _unit_name(unit), running(None, None))
        self._set(surface, vertices, faces, options)

    @classmethod
    def _of(
        cls,
        surface: "_girth.Surface",
        vertices: np.ndarray,
        faces: np.ndarray,
        options: tuple,
    ) -> "Mesh":
        mesh = cls.__new__(cls)
        mesh._set(surface, vertices, faces, options)
        return mesh

    def _set(
        self,
        surface: "_girth.Surface",
        vertices: np.ndarray,
        faces: np.ndarray,
        options: tuple,
    ) -> None:
        self._surface = surface
        self._vertices = _read_only(vertices)
        self._faces = _read_only(faces)
        self._options = options
        self._unit = surface.unit
        self._vertex_of_row = surface.vertex_of_input()
        self._row_of_vertex = surface.input_of_vertex()
        own = np.arange(len(self._vertex_of_row))
        self._is_plain = np.array_equal(self._vertex_of_row, own) and np.array_equal(
            self._row_of_vertex, own
        )
        self._face_of_row: Optional[dict[int, int]] = None

    def __reduce__(self) -> tuple:
        weld, close_holes, components, min_component, scale = self._options
        return _remade, (
            np.asarray(self._vertices),
            np.asarray(self._faces),
            {
                "weld": weld,
                "close_holes": close_holes,
                "components": components,
                "min_component": min_component,
                "scale": scale,
                "unit": self._unit,
            },
        )

    def __repr__(self) -> str:
        unit = f", in {self._unit}s" if self._unit else ""
        return (
            f"<pygirth.Mesh: {len(self._vertices)} vertices, {len(self._faces)} faces, "
            f"area {self.area:.6g}{unit}>"
        )

    @property
    def vertices(self) -> np.ndarray:
        """Positions as they were given, float64 of shape (n, 3); not to be written to."""
        return self._vertices

    @property
    def faces(self) -> np.ndarray:
        """Faces as they were given, int64 of shape (m, 3); not to be written to."""
        return self._faces

    @property
    def unit(self) -> str:
        """The unit of lengths, by its name; empty where it is not known. Files in glTF have metres."""
        return self._unit

    @property
    def area(self) -> float:
        """Area of the surface, in squared model units."""
        return self._surface.area

    @property
    def report(self) -> dict[str, Any]:
        """Counts of the changes that the preparation made; ``holes`` lists the filled holes."""
        return self._surface.report()

    @property
    def notes(self) -> list[str]:
        """Remarks of the reader of the file, in sentences."""
        return self._surface.notes

    def surface(self) -> "Mesh":
        """The prepared surface as a mesh of its own: oriented, manifold, each vertex used.

        Returns
        -------
        Mesh
            With other numbers where the preparation changed something.
        """
        return Mesh(self._surface.positions(), self._surface.triangles(), unit=self._unit)

    def igf(
        self,
        *,
        method: str = "exact",
        persistence: float = 0.0,
        audit: int = _DEFAULTS["audit"],
        seed: int = _DEFAULTS["seed"],
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Girth:
        """The girth at every vertex: the length of the shortest geodesic loop based there.

        Parameters
        ----------
        method : {'exact', 'refined', 'ms'}
            ``'refined'`` is for large meshes: it searches bands of faces round loops, and says how
            sure each value is. ``'ms'`` is the paper's approximation by fast marching.
        persistence : float, optional
            tau, in model units: loops whose saddles last no longer are passed over, as noise makes
            them. ``0.02 * mesh.area ** 0.5`` is the command's ``--persistence 2%``. Only with
            ``'exact'``.
        audit, seed : int, optional
            With ``'refined'``: how many vertices are compared with the exact method, and which.
        threads : int, optional
            Default: one for each core. The result does not depend on it.
        progress : callable or bar, optional
            Called with the finished share in [0, 1], some times a second; or a bar such as
            ``tqdm(total=1)``. What it raises stops the work.

        Returns
        -------
        Girth
            The values of the command ``girth igf``, to the bit; with ``'refined'`` a
            `RefinedGirth`.

        Notes
        -----
        The exact girth is computed once and kept, and the latest one with a persistence. Ctrl-C
        stops the work within 200 ms.
        """
        one_of(method, "method", ("exact", "refined", "ms"))
        tau = _persistence(persistence)
        if tau != 0 and method != "exact":
            raise input_error(
                "INVALID_OPTION", "only the exact method knows how long saddles last"
            )
        if method == "refined":
            found = self._surface.refined_girth(
                _count(audit, "audit"), _count(seed, "seed"), running(threads, progress)
            )
            values, kinds, states = (
                self._by_row(array, none) for array, none in zip(found, (np.nan, _NONE, _NONE))
            )
            return RefinedGirth(self, values, kinds, states, found[3], self._unit)
        values, kinds = self._surface.girth(method, tau, running(threads, progress))
        kinds = self._by_row(kinds, _NONE)
        return Girth(self, self._by_row(values, np.nan), kinds, method, self._unit, tau)

    def loop(
        self,
        vertex: Optional[int] = None,
        *,
        face: Optional[int] = None,
        weights: Optional[Sequence[float]] = None,
        persistence: float = 0.0,
    ) -> Loop:
        """The shortest geodesic loop based at a point.

        Parameters
        ----------
        vertex : int, optional
            A row of `vertices`.
        face : int, optional
            A row of `faces` instead.
        weights : sequence of three floats, optional
            Where in the face: the shares of its three vertices, which add up to 1. Default: its
            middle.
        persistence : float, optional
            As of `igf`.

        Returns
        -------
        Loop

        Raises
        ------
        InputError
            VERTEX_OUT_OF_RANGE, INVALID_POINT or INVALID_OPTION.
        """
        point = self._base("a loop", vertex, face, weights)
        tau = _persistence(persistence)
        return Loop(self._surface.loop(point, tau, running(1, None)))

    def barcode(
        self,
        vertex: Optional[int] = None,
        *,
        face: Optional[int] = None,
        weights: Optional[Sequence[float]] = None,
        max_persistence: float = np.inf,
        max_saddles: Optional[int] = None,
        loops: bool = False,
    ) -> Barcode:
        """The saddles of the distance from a point: where they are born, and where they die.

        Parameters
        ----------
        vertex, face, weights
            As of `loop`.
        max_persistence : float, optional
            Up to which persistence it is wanted, in model units. The less, the sooner it is there.
        max_saddles : int, optional
            No more than these, the first ones. Default: all.
        loops : bool, optional
            With the loop of each.

        Returns
        -------
        Barcode

        Raises
        ------
        InputError
            VERTEX_OUT_OF_RANGE, INVALID_POINT or INVALID_OPTION.
        """
        point = self._base("a barcode", vertex, face, weights)
        most = 2**63 - 1 if max_saddles is None else whole_number(max_saddles, "max_saddles")
        if most < 0:
            raise input_error("INVALID_OPTION", f"max_saddles is {most}", "choose 0 or more")
        longest = _not_negative(max_persistence, "max_persistence")
        found = self._surface.barcode(point, longest, most, bool(loops), running(1, None))
        return Barcode(found)

    def _base(
        self,
        what: str,
        vertex: Optional[int],
        face: Optional[int],
        weights: Optional[Sequence[float]],
    ) -> Any:
        if (vertex is None) == (face is None):
            raise input_error("USAGE", f"{what} is based at one point", "name a vertex or a face")
        if vertex is not None and weights is not None:
            raise input_error("USAGE", "a vertex has no weights", "name a face with the weights")
        if face is None:
            return self._point(vertex)
        return self._point((face, (1 / 3, 1 / 3, 1 / 3) if weights is None else weights))

    def tips(
        self,
        *,
        persistence: float = 0.0,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Tips:
        """Where the shape ends: regions cut off by the lines along which the girth jumps.

        Parameters
        ----------
        persistence, threads, progress
            As of `igf`.

        Returns
        -------
        Tips
            Largest jump first.
        """
        return Tips(self, _girth.tips(self._surface, _persistence(persistence), running(threads, progress)))

    def limbs(
        self,
        *,
        stations: int = _DEFAULTS["stations"],
        persistence: float = 0.0,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> list[Limb]:
        """The limbs that the tips end, longest first: how long they are, and how thick all along.

        Parameters
        ----------
        stations : int, optional
            Stations of a profile, 1 to 10,000.
        persistence, threads, progress
            As of `igf`.

        Returns
        -------
        list of Limb
        """
        count = whole_number(stations, "stations")
        if not 1 <= count <= 10_000:
            raise input_error("INVALID_OPTION", f"stations is {count}", "choose 1 to 10,000")
        tau = _persistence(persistence)
        found = _girth.limbs(self._surface, count, tau, running(threads, progress))
        return [Limb(limb) for limb in found]

    def parts(
        self,
        *,
        girth: Optional[float] = None,
        shape_diameter: Optional[float] = None,
        smoothing: float = 0.0,
        persistence: float = 0.0,
        threads: Optional[int] = None,
        progress: Progress = None,
        thickness: Optional[float] = None,
    ) -> Parts:
        """Tubes, plates and body, by girth and shape diameter.

        Parameters
        ----------
        girth, shape_diameter : float, optional
            Tubes and plates have a smaller shape diameter; tubes have a smaller girth, too. In
            model units. Default: found from the two fields' distributions.
        smoothing : float, optional
            0: plain thresholds. Above: how much a vertex's neighbours count.
        persistence, threads, progress
            As of `igf`.
        thickness : float, optional
            The older name of `shape_diameter`, until 2.0.

        Returns
        -------
        Parts
            Largest area first.
        """
        limits = _thresholds(girth, shape_diameter, thickness)
        weight, tau = _not_negative(smoothing, "smoothing"), _persistence(persistence)
        found = _girth.parts(
            self._surface, *limits, weight, tau, running(threads, progress)
        )
        return Parts(self, found[0], found[1], self._by_row(found[2], -1), found[3])

    def necks(
        self,
        *,
        min_prominence: float = 0.0,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Necks:
        """Where the surface is locally narrowest, the clearest first.

        Parameters
        ----------
        min_prominence : float, optional
            Only necks from which the girth must rise by this, in model units, to reach a narrower
            one.
        threads, progress
            As of `igf`.

        Returns
        -------
        Necks
            As the command ``girth necks --min-prominence 0`` finds them, to the bit.
            ``suggested_prominence`` is a ``min_prominence`` for the clear ones.
        """
        least = _not_negative(min_prominence, "min_prominence")
        return Necks(_girth.necks(self._surface, least, running(threads, progress)))

    def segments(
        self,
        *,
        min_prominence: float = 0.0,
        girth: Optional[float] = None,
        shape_diameter: Optional[float] = None,
        smoothing: float = 0.0,
        threads: Optional[int] = None,
        progress: Progress = None,
        thickness: Optional[float] = None,
    ) -> Segments:
        """The parts that the surface falls into at its necks, what they are, and their tips.

        Parameters
        ----------
        min_prominence : float, optional
            As of `necks`: divides at necks of at least this prominence. Of necks that cross, the
            most prominent count.
        girth, shape_diameter, smoothing, thickness : float, optional
            As of `parts`: what is a tube, a plate or body.
        threads, progress
            As of `igf`.

        Returns
        -------
        Segments
            The segments of the command ``girth segments --min-prominence 0``, to the bit.
        """
        least = _not_negative(min_prominence, "min_prominence")
        limits = _thresholds(girth, shape_diameter, thickness)
        weight = _not_negative(smoothing, "smoothing")
        found = _girth.segments(
            self._surface, least, *limits, weight, running(threads, progress)
        )
        return Segments(self, *found)

    def handles(
        self,
        *,
        base_points: int = _DEFAULTS["base_points"],
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Handles:
        """The loops round handles and through tunnels, the shortest first.

        Parameters
        ----------
        base_points : int, optional
            Points of each component whose loops are compared at first, at least 1. Then loops are
            proven shortest, for about five seconds (`Handle.may_be_shorter_by`). As many as there
            are vertices: all of them, which proves all loops.
        threads, progress
            As of `igf`.

        Returns
        -------
        Handles
            The handles of the command ``girth handles``, to the bit.
        """
        found = _girth.handles(
            self._surface, _base_points(base_points), running(threads, progress)
        )
        return Handles(found)

    def remove_handles(
        self,
        length: float,
        *,
        base_points: int = _DEFAULTS["base_points"],
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> HandleRemoval:
        """The surface without the handles and tunnels whose loops are shorter than a length.

        Each is cut along its loop, and both rims are closed. Away from the cuts no vertex moves.

        Parameters
        ----------
        length : float
            In model units; infinite: all handles.
        base_points
            As of `handles`.
        threads, progress
            As of `igf`.

        Returns
        -------
        HandleRemoval
            With the mesh that is left: that of the command ``girth remesh --remove-handles``.

        Raises
        ------
        InputError
            INVALID_OPTION.
        """
        shortest = _not_negative(length, "length")
        count = _base_points(base_points)
        vertices, faces, found = _girth.remove_handles(
            self._surface, shortest, count, running(threads, progress)
        )
        return HandleRemoval(Mesh(vertices, faces, unit=self._unit), found)

    def maxima(self, field: Any, *, minima: bool = False) -> list[Maximum]:
        """The maxima of a field along the edges, the most persistent first.

        Parameters
        ----------
        field : Field, str or array_like, shape (n,)
            A field, the name of one, or one value for each row of `vertices`. Vertices without a
            value (NaN) do not count.
        minima : bool, optional
            The minima instead.

        Returns
        -------
        list of Maximum

        Raises
        ------
        InputError
            USAGE where there is not one value for each vertex.
        """
        values = self.field(field) if isinstance(field, str) else field
        found = _girth.maxima(self._surface, self._of_vertices(values), bool(minima))
        return [Maximum(one) for one in found]

    def print_check(
        self,
        *,
        tube_diameter: float = 0.0,
        wall_thickness: float = 0.0,
        gap: float = 0.0,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> PrintCheck:
        """Whether a body can be printed: places that are too thin, or too close together.

        Parameters
        ----------
        tube_diameter, wall_thickness, gap : float, optional
            The least diameter of tubes, thickness of walls, and distance between surfaces that face
            each other across empty space, in model units; 0: any.
        threads, progress
            As of `igf`.

        Returns
        -------
        PrintCheck
            The check of the command ``girth parts --min-tube --min-wall --min-gap``, to the bit.

        Raises
        ------
        InputError
            INVALID_OPTION for a negative limit; NO_THICKNESS where the surface is inside out, or no
            vertex has a thickness.
        """
        limits = [
            _not_negative(limit, name)
            for name, limit in (
                ("tube_diameter", tube_diameter),
                ("wall_thickness", wall_thickness),
                ("gap", gap),
            )
        ]
        run = running(threads, progress)
        return PrintCheck(_girth.print_check(self._surface, *limits, run))

    def bottleneck(
        self,
        a: Point,
        b: Point,
        *,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Bottleneck:
        """The narrowest place on the widest way from one point to another.

        Parameters
        ----------
        a, b : point
            Vertices, or ``(face, weights)``.
        threads, progress
            As of `igf`.

        Returns
        -------
        Bottleneck

        Raises
        ------
        InputError
            VERTEX_OUT_OF_RANGE; INVALID_POINT, also where they lie in different components.
        """
        return Bottleneck(
            _girth.bottleneck(
                self._surface, self._point(a), self._point(b), running(threads, progress)
            )
        )

    def profile(
        self,
        *points: Point,
        samples: int = _DEFAULTS["samples"],
        crossings: bool = True,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Profile:
        """The girth along a path.

        Parameters
        ----------
        *points : point
            Two or more: vertices, or ``(face, weights)``. Each is joined to the next by a shortest
            path.
        samples : int, optional
            Places at equal distances, both ends among them; 0 for none.
        crossings : bool, optional
            Also where the path crosses edges and passes vertices.
        threads, progress
            As of `igf`.

        Returns
        -------
        Profile
            Exact at each place; nothing is interpolated.

        Raises
        ------
        InputError
            VERTEX_OUT_OF_RANGE; INVALID_POINT, also where they lie in different components;
            INVALID_OPTION.
        """
        if len(points) < 2:
            raise input_error("USAGE", "a path needs two points", "name two points or more")
        count = whole_number(samples, "samples")
        if not 0 <= count < 2**63:
            raise input_error("INVALID_OPTION", f"samples is {count}", "choose 0, or 2 or more")
        through = [self._point(point) for point in points]
        run = running(threads, progress)
        return Profile(*_girth.profile(self._surface, through, count, bool(crossings), run))

    def axis(
        self,
        limb: Limb,
        *,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> list[AxisLoop]:
        """The loops swept along a limb; their middles are its axis.

        Parameters
        ----------
        limb : Limb
            A limb of this mesh, by `limbs`; as many loops as loops go round at its stations.
        threads, progress
            As of `igf`.

        Returns
        -------
        list of AxisLoop
            In the order of their distances; none where no loop goes round.
        """
        run = running(threads, progress)
        found = _girth.axis(self._surface, limb.profile, limb._places, run)
        return [AxisLoop(loop) for loop in found]

    def cut(
        self,
        loops: Any,
        *,
        cap: bool = False,
        progress: Progress = None,
    ) -> Cut:
        """The surface taken apart along loops.

        Parameters
        ----------
        loops : Loop, Neck, Handle, Bottleneck, AxisLoop, or sequence of them
            Loops of this mesh; they may touch, but not cross each other.
        cap : bool, optional
            Closes the rims that cutting makes.
        progress
            As of `igf`.

        Returns
        -------
        Cut
            The parts of the command ``girth cut``, to the bit.

        Raises
        ------
        InputError
            USAGE where something is no loop; INVALID_POINT where a loop is none of this mesh;
            INVALID_OPTION where they cross.
        """
        given = [loops] if hasattr(loops, "_curve") else list(loops)
        for loop in given:
            if not hasattr(loop, "_curve"):
                raise input_error(
                    "USAGE",
                    f"a {type(loop).__name__} is no loop",
                    "pass a loop, neck, handle or bottleneck of this mesh",
                )
        curves = [loop._curve for loop in given]
        return Cut(*_girth.cut(self._surface, curves, bool(cap), running(None, progress)))

    def _field(
        self,
        name: str,
        given: dict[str, Any],
        pairs: Optional[int],
        times: Optional[Sequence[float]],
        threads: Optional[int],
        progress: Progress,
    ) -> Field:
        one_of(name, "the field", tuple(FIELDS))
        run = running(threads, progress)
        if name == "igf":
            return self.igf(threads=threads, progress=progress)
        if _girth.is_spectral(name):
            values, made = self._spectral_values(name, pairs, times, run)
        else:
            parameters = {
                keyword: self._points(given[keyword])
                if kind == "Points"
                else _READERS[kind](given[keyword], keyword)
                for keyword, kind in _girth.field_parameters(name).items()
                if given.get(keyword) is not None
            }
            values, made = self._surface.field(name, parameters, run)
        unit = _girth.unit_of_field(name, self._unit)
        return Field(self, name, self._by_row(values, np.nan), unit, made)

    def _spectral_values(
        self,
        name: str,
        pairs: Optional[int],
        times: Optional[Sequence[float]],
        run: _girth.Running,
    ) -> tuple[np.ndarray, str]:
        """One number for each vertex where the signature has one only, otherwise all; the method."""
        count = None if pairs is None else whole_number(pairs, "pairs")
        if count is not None and not 2 <= count <= 100_000:
            raise input_error("INVALID_OPTION", f"pairs is {count}", "choose 2 to 100,000")
        shares = None if times is None else [real_number(time, "a time") for time in times]
        values, made = self._surface.spectral_field(name, count, shares, run)
        if values.shape[1] > 1:
            return values, made
        if name == "hks":
            (time,) = shares or (_DEFAULTS["time"],)
            made = f"{made}, time {time:.15g}"
        return values[:, 0], made

    def geodesics(
        self, source: Union[Point, Iterable[Point]], *, radius: float = np.inf
    ) -> Field:
        """Exact geodesic distances of all vertices.

        Parameters
        ----------
        source : point or sequence of points
            A vertex, or ``(face, weights)``; of several, each distance is that of the nearest one.
        radius : float, optional
            Distances beyond it are infinite.

        Returns
        -------
        Field
            In model units; infinite in other components.
        """
        values = self._surface.distances(self._points(source), real_number(radius, "radius"), running(1, None))
        return Field(self, "distance", self._by_row(values, np.nan), self._unit, "exact")

    def path(self, a: Point, b: Point) -> Path:
        """A shortest path from one point to another, exact.

        Parameters
        ----------
        a, b : point
            Vertices, or ``(face, weights)``.

        Returns
        -------
        Path
        """
        return Path(self._surface.path(self._point(a), self._point(b), running(1, None)))

    def remesh(
        self, n: int, *, method: str = "fitting", progress: Progress = None
    ) -> "Mesh":
        """Another mesh of the surface, of about `n` faces.

        Parameters
        ----------
        n : int
            Faces wanted, from 4 to 100 million; met to within 2% where the shape allows it.
        method : {'fitting', 'even'}
            Good at keeping the shape, or triangles of even size.
        progress
            As of `igf`.

        Returns
        -------
        Mesh
        """
        one_of(method, "method", ("fitting", "even"))
        arrays = self._surface.remesh(
            whole_number(n, "n"), method == "even", running(None, progress)
        )
        return Mesh(*arrays, unit=self._unit)

    def subdivide(self, n: int, *, progress: Progress = None) -> "Mesh":
        """Divides the surface into more triangles: the longest edges are cut in two.

        The surface stays where it is, and so does its girth; vertices keep their order, and new
        ones follow.

        Parameters
        ----------
        n : int
            Faces wanted, up to 100 million; one more may come out. A mesh that has as many stays as
            it is.
        progress
            As of `igf`.

        Returns
        -------
        Mesh
        """
        count = whole_number(n, "n")
        if not 1 <= count <= 100_000_000:
            raise input_error("INVALID_OPTION", f"n is {count}", "choose 1 to 100,000,000")
        arrays = self._surface.subdivide(count, running(None, progress))
        return Mesh(*arrays, unit=self._unit)

    def smooth(self, steps: int, *, progress: Progress = None) -> "Mesh":
        """The mesh without the wrinkles of a rough scan: the same triangles, vertices moved.

        Wrinkles about as long as an edge go, and limbs stay as thick as they are (Taubin 1995).
        Rough scans are smoothed before they are compared.

        Parameters
        ----------
        steps : int
            From 0 to 100; three do for noise of half an edge.
        progress
            As of `igf`.

        Returns
        -------
        Mesh
            Vertices and faces keep their order; what preparing has left out is not there.
        """
        arrays = self._surface.smooth(
            whole_number(steps, "steps"), running(None, progress)
        )
        return Mesh(*arrays, unit=self._unit)

    def save(self, path: Union[str, "os.PathLike[str]"], *fields: Field) -> None:
        """Writes the surface to a file, or fields of it, in the format of the name's ending.

        Parameters
        ----------
        path : str or path
            Without fields it ends with .obj, .ply, .stl, .off or .glb; with fields, which are
            written as the command ``girth field`` does, with .csv, .json, .npy, .ply or .glb.
            A file that is there is replaced by the whole new one, or not at all.
        *fields : Field
            Fields of this mesh. NPY holds one.

        Raises
        ------
        InputError
            USAGE for another ending, for a field of several numbers a vertex, and for two fields of
            one name; FILE_UNWRITABLE.
        """
        target = path_of(path)
        if not fields:
            _girth.save_mesh(self._surface, target)
            return
        none = np.zeros(0, np.uint8)
        given = []
        for field in fields:
            values = self._of_vertices(field)
            made = field.method
            if getattr(field, "persistence", 0) > 0:
                made = _girth.persistent_method(field.persistence)
            codes = [getattr(field, name, none) for name in ("kinds", "states")]
            kinds, states = (self._at_vertices(one, _NONE) if len(one) else one for one in codes)
            given.append((field.name, values, field.unit, made, kinds, states))
        _girth.save_fields(self._surface, target, given)

    def to_pyvista(self) -> Any:
        """The mesh as PyVista's ``PolyData``.

        Returns
        -------
        pyvista.PolyData

        Raises
        ------
        MissingPackageError
            PROGRAM_NOT_LOADED where PyVista is not installed; it is an ImportError.
        """
        return polydata_of(self._vertices, self._faces)

    def _by_row(self, values: np.ndarray, none: Any) -> np.ndarray:
        """Values of the surface's vertices for the rows of `vertices`."""
        if self._is_plain:
            return values
        rows = np.full((len(self._vertex_of_row),) + values.shape[1:], none, values.dtype)
        known = self._vertex_of_row >= 0
        rows[known] = values[self._vertex_of_row[known]]
        return rows

    def _of_vertices(self, values: Any) -> np.ndarray:
        """Values of the surface's vertices, of anything with one for each row of `vertices`."""
        rows = np.asarray(values, np.float64)
        if rows.shape != (len(self._vertices),):
            raise input_error(
                "USAGE",
                f"values have the shape {rows.shape}, not ({len(self._vertices)},)",
                "pass one value for each vertex of the mesh",
            )
        return self._at_vertices(rows, np.nan)

    def _at_vertices(self, values: np.ndarray, none: Any) -> np.ndarray:
        """Values of the rows of `vertices` for the surface's vertices."""
        known = self._row_of_vertex >= 0
        result = np.full(len(known), none, values.dtype)
        result[known] = values[self._row_of_vertex[known]]
        return result

    def _point(self, point: Any) -> tuple[int, list[float]]:
        """A point as the core takes it: (vertex, []) or (face, weights)."""
        if isinstance(point, tuple):
            if len(point) != 2:
                raise input_error("INVALID_POINT", f"{point!r} is no point")
            return self._face_point(*point)
        return self._vertex(point), []

    def _points(self, given: Any) -> list[tuple[int, list[float]]]:
        """One point or several, as the core takes them."""
        return [self._point(one) for one in ([given] if _is_point(given) else given)]

    def _vertex(self, vertex: Any) -> int:
        number = whole_number(vertex, "the vertex", "VERTEX_OUT_OF_RANGE")
        count = len(self._vertex_of_row)
        if not 0 <= number < count:
            raise input_error(
                "VERTEX_OUT_OF_RANGE",
                f"there is no vertex {number}",
                f"vertices are numbered from 0 to {count - 1}",
                number,
            )
        found = int(self._vertex_of_row[number])
        if found < 0:
            raise input_error(
                "VERTEX_OUT_OF_RANGE",
                f"no face uses vertex {number}",
                "name a vertex of a face",
                number,
            )
        return found

    def _face_point(self, face: Any, weights: Any) -> tuple[int, list[float]]:
        number = whole_number(face, "the face", "INVALID_POINT")
        count = len(self._faces)
        if not 0 <= number < count:
            raise input_error(
                "INVALID_POINT",
                f"there is no face {number}",
                f"faces are numbered from 0 to {count - 1}",
                number,
            )
        shares = [real_number(weight, "a weight") for weight in weights]
        if len(shares) != 3:
            raise input_error("INVALID_POINT", f"{len(shares)} weights are not three", "", number)
        if self._face_of_row is None:
            rows = self._surface.input_of_face().tolist()
            # The first of several faces on one triangle.
            self._face_of_row = {row: i for i, row in reversed(list(enumerate(rows)))}
        found = self._face_of_row.get(number)
        if found is None:
            raise input_error(
                "INVALID_POINT",
                f"face {number} was left out",
                "the mesh's report states what was left out",
                number,
            )
        report = self.report
        if report["reoriented_faces"] + report["flipped_faces"] + report["added_faces"] == 0:
            return found, shares
        # The face may have been turned over: its corners are found by where they come from.
        given = self._row_of_vertex[self._vertex_of_row[self._faces[number]]].tolist()
        corners = self._row_of_vertex[self._surface.triangles()[found]].tolist()
        if sorted(given) != sorted(corners):
            raise input_error(
                "INVALID_POINT",
                f"face {number} was divided where a neighbour has a vertex within its edge"
                if report["added_faces"] > 0
                else f"face {number} had no area and shares that of its neighbour now",
                "name another face, or a vertex",
                number,
            )
        return found, [shares[given.index(corner)] for corner in corners]


def _remade(vertices: np.ndarray, faces: np.ndarray, options: dict) -> Mesh:
    return Mesh(vertices, faces, **options)


def _read_only(array: np.ndarray) -> np.ndarray:
    view = array.view()
    view.flags.writeable = False
    return view


def _is_point(value: Any) -> bool:
    if isinstance(value, tuple):
        return len(value) == 2 and np.ndim(value[0]) == 0 and np.ndim(value[1]) == 1
    return not isinstance(value, list) and np.ndim(value) == 0


def _thresholds(
    girth: Optional[float], shape_diameter: Optional[float], thickness: Optional[float]
) -> list[float]:
    """Both thresholds of parts; -1 for one that is to be found."""
    if thickness is not None:
        if shape_diameter is not None:
            raise input_error("USAGE", "thickness is the older name of shape_diameter: state one")
        warn_of_older("thickness")
        shape_diameter = thickness
    return [
        -1.0 if value is None else _not_negative(value, name)
        for name, value in (("girth", girth), ("shape_diameter", shape_diameter))
    ]


def _not_negative(value: Any, name: str) -> float:
    number = real_number(value, name)
    if not number >= 0:
        raise input_error("INVALID_OPTION", f"{name} is {number}", "choose a number of at least 0")
    return number


def _unit_name(unit: Any) -> str:
    """The name of a unit that is given by its name or symbol; empty where none is."""
    symbols = _girth.length_unit_symbols()
    names = {"": "", **{name: name for name in symbols}, **{s: name for name, s in symbols.items()}}
    if unit not in names:
        words = ", ".join(symbols.values())
        raise input_error("INVALID_OPTION", f"unit is {unit!r}", f"choose one of {words}, or its name")
    return names[unit]


def _base_points(value: Any) -> int:
    count = whole_number(value, "base_points")
    if not 1 <= count < 2**63:
        raise input_error("INVALID_OPTION", f"base_points is {count}", "choose 1 or more")
    return count


def _count(value: Any, name: str) -> int:
    """A number from 0 on that 32 bits hold."""
    number = whole_number(value, name)
    if not 0 <= number < 2**32 - 1:
        raise input_error("INVALID_OPTION", f"{name} is {number}", "choose 0 to 4294967294")
    return number


def _persistence(value: Any) -> float:
    number = _not_negative(value, "persistence")
    if np.isinf(number):
        raise input_error("INVALID_OPTION", "persistence is inf", "choose a length")
    return number


def _preparing(
    weld: Any, close_holes: Any, components: Any, min_component: Any, scale: Any
) -> tuple[float, bool, list[int], float, float]:
    factor = real_number(scale, "scale")
    if not 0 < factor < np.inf:
        raise input_error("INVALID_OPTION", f"scale is {factor}", "choose a number above 0")
    kept = [whole_number(number, "a component") for number in components]
    for number in kept:
        if not 0 <= number < 2**32 - 1:
            raise input_error("COMPONENT_OUT_OF_RANGE", f"there is no component {number}")
    share = real_number(min_component, "min_component")
    return real_number(weld, "weld"), bool(close_holes), kept, share, factor


def load(
    path: Union[str, "os.PathLike[str]"],
    *,
    weld: float = 0.0,
    close_holes: bool = False,
    components: Sequence[int] = (),
    min_component: float = 0.0,
    scale: float = 1.0,
    unit: str = "",
) -> Mesh:
    """Reads a model: GLB, glTF, OBJ, PLY, STL or OFF, recognised by content.

    Parameters
    ----------
    path : str or path
    weld, close_holes, components, min_component, scale
        As of `Mesh`.
    unit : str, optional
        The unit of the file's numbers, such as ``"mm"`` or ``"millimetre"``, where the file does not state it; it replaces
        the one that the file states.

    Returns
    -------
    Mesh
        Its vertices and faces are those of the file; polygons are cut into triangles.

    Raises
    ------
    MissingFileError
        FILE_NOT_FOUND; it is a FileNotFoundError.
    InputError
        Such as UNKNOWN_FORMAT or MALFORMED_FILE, with the file's name.
    """
    options = _preparing(weld, close_holes, components, min_component, scale)
    read = _girth.load(path_of(path), *options, _unit_name(unit), running(None, None))
    return Mesh._of(*read, options)


def as_mesh(model: Any, F: Any = None) -> Mesh:
    """A mesh of whatever stands for one.

    Parameters
    ----------
    model : Mesh, path, (V, F), trimesh.Trimesh, meshio.Mesh, pyvista.PolyData or array_like
        An array is ``V``, and needs `F`.
    F : array_like of int, shape (m, 3), optional

    Returns
    -------
    Mesh
    """
    if F is not None:
        return Mesh(model, F)
    if isinstance(model, Mesh):
        return model
    if isinstance(model, (str, bytes, os.PathLike)):
        return load(path_of(model))
    arrays = arrays_of(model)
    if arrays is None:
        raise input_error(
            "USAGE",
            f"a {type(model).__name__} is no mesh",
            "pass a path, (V, F), or a mesh of trimesh, meshio or PyVista",
        )
    return Mesh(*arrays)


def igf(
    V: Any,
    F: Any = None,
    *,
    method: str = "exact",
    persistence: float = 0.0,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Girth:
    """The girth at every vertex of a mesh.

    Parameters
    ----------
    V : array_like of float, shape (n, 3), or anything that `as_mesh` takes
    F : array_like of int, shape (m, 3), optional
    method, persistence, threads, progress
        As of `Mesh.igf`.

    Returns
    -------
    Girth
        One value for each row of `V`, in model units.
    """
    return as_mesh(V, F).igf(
        method=method, persistence=persistence, threads=threads, progress=progress
    )


def compare(
    models: Iterable[Any],
    descriptors: Sequence[str] = ("igf", "sdf", "geoaverage", "geofarthest"),
    *,
    faces: int = 10_000,
    smooth: int = 0,
    threads: Optional[int] = None,
    progress: Progress = None,
) -> Comparison:
    """How far shapes are apart, whatever their sizes, places and triangles.

    Parameters
    ----------
    models : iterable
        Two or more of whatever `as_mesh` takes.
    descriptors : sequence of str, optional
        Names as of the command: ``'igf'``, ``'sdf'``, ``'hks'``, ``'log-igf'``, ``'igf-sdf'`` …, or
        sums such as ``'2*igf+sdf'``.
    faces : int, optional
        Larger models are remeshed to so many; 0: all are taken as they are.
    smooth : int, optional
        Steps of smoothing after that, as of `Mesh.smooth`: three for rough scans.
    threads, progress
        As of `Mesh.igf`; the progress is that of all models.

    Returns
    -------
    Comparison
        Its matrices are symmetric; without unit, since models are scaled to the area 1.
    """
    names = [descriptors] if isinstance(descriptors, str) else [str(name) for name in descriptors]
    count, steps = face_count(faces), smoothing_steps(smooth)
    if not names:
        raise input_error("USAGE", "there is no descriptor", "name one, such as igf")
    given = list(models)
    if len(given) < 2:
        raise input_error(
            "USAGE", "there is nothing to compare it with", "name two models or more"
        )
    run = running(threads, progress)
    report = run.progress
    fields = []
    for number, model in enumerate(given):

        def share(fraction: float, number: int = number) -> None:
            report((number + fraction) / len(given))

        each = running(threads, None if report is None else share)
        fields.append(_girth.compared_fields(as_mesh(model)._surface, names, count, steps, each))
    matrices = _girth.compare(fields, names, running(threads, None))
    return Comparison(dict(zip(names, matrices)))
