"""The members of results. Made of the headers in cpp/include/girth by `npm run build:tables`: not to be edited."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from pygirth._result import Result

__all__ = ["Distance", "Distances", "NamedMeasure", "NamedMeasures", "NoTubeComponent", "Sections", "TightCurve", "TightPiece", "TubeBranch", "TubePlace", "TubeStation", "Tubes"]


class _Members(Result):
    #: The names of the classes of results within a result, alone or in lists, by member.
    _entries: dict[str, str] = {}
    #: The classes by their names: of two with one name the later one, which extends the other.
    _classes: dict[str, Any] = {}

    def __init_subclass__(cls) -> None:
        if cls.__module__.startswith("pygirth."):
            _Members._classes[cls.__name__] = cls

    def __init__(self, found: dict[str, Any]) -> None:
        self.__dict__.update(found)
        for member, name in self._entries.items():
            entry, given = self._classes[name], found[member]
            made = [entry(one) for one in given] if isinstance(given, list) else entry(given)
            setattr(self, member, made)

    def _line(self) -> str:
        found = self.__dict__.items()
        lists = [name for name in self._entries if isinstance(self.__dict__[name], list)]
        counts = [f"{len(self.__dict__[name])} {name}" for name in lists]
        numbers = [f"{name} {value:.6g}" for name, value in found if isinstance(value, float)]
        return ", ".join(counts + numbers)


class Bottleneck(_Members):
    """The bottleneck between two points.

    Attributes
    ----------
    kind : str
        A neck, a pass, or an end. ``"neck"``: A neck between the points: its loop is a closed
        geodesic, shorter than every other closed curve near it. ``"pass"``: A place between
        them whose loop can be made shorter by moving it to one side. ``"end"``: One of the two
        points: there is no neck between them.
    girth : float
        The least girth on the widest way, in model units: the length of its loop.
    place : ndarray of float64, shape (3,)
        Where on the way the girth is least.
    centre : ndarray of float64, shape (3,)
        Mean of the loop's points, each part counted by its length, in model units; zero where
        there is no loop.
    area : float
        The area that the loop encloses in its mean plane, in squared model units.
    sides : ndarray of float64, shape (sides, 2)
        The sides of a neck, as `Neck.sides`; empty for other kinds. Columns: area: In squared
        model units. volume: Enclosed by this side and the cone over the curve from the mean of
        its points, in cubed model units: negative where the surface faces inwards. NaN where
        the side has a boundary.
    points : ndarray of float64, shape (k, 3)
        The loop: of a neck the closed geodesic itself (of a band of parallel ones that in the
        middle), otherwise the loop of the girth at ``place``, empty where that is unresolved.
        As `Loop.points`; the last point equals the first.
    way : ndarray of float64, shape (k, 3)
        The way that was found, from the first point to the second, along the pieces of the
        mesh's edges: it is a witness of the girth, and not short.
    """

    kind: str
    girth: float
    place: np.ndarray
    centre: np.ndarray
    area: float
    sides: np.ndarray
    points: np.ndarray
    way: np.ndarray
    _curve: tuple[np.ndarray, np.ndarray]


class PartMeasures(_Members):
    """Measures of a part of a surface.

    Attributes
    ----------
    area : float
        In squared model units.
    volume : float
        Enclosed, in cubed model units; NaN where the part has a boundary.
    genus : int
        Handles, those of its cavities among them.
    boundaries : int
        Boundary curves.
    """

    area: float
    volume: float
    genus: int
    boundaries: int


class Distance(_Members):
    """The distance between two points.

    Attributes
    ----------
    start : ndarray of float64, shape (3,)
        The first point.
    end : ndarray of float64, shape (3,)
        The second point.
    length : float
        Length of a shortest path along the surface, in model units; infinite where the points
        lie in different components.
    straight : float
        Length of the straight line between them, in model units.
    points : ndarray of float64, shape (k, 3)
        The path: the edges crossed and vertices passed in order. Between neighbours it is
        straight inside one face or along one edge. Empty where paths were not asked for, or
        there is none.
    """

    start: np.ndarray
    end: np.ndarray
    length: float
    straight: float
    points: np.ndarray
    _curve: tuple[np.ndarray, np.ndarray]


class Distances(_Members):
    """Distances between pairs of points.

    Attributes
    ----------
    distances : list of Distance
        In the order of the pairs.
    """

    _entries = {"distances": "Distance"}
    distances: list["Distance"]


class Path(_Members):
    """A shortest path between two points of a surface.

    Attributes
    ----------
    length : float
        In model units; infinite where the points lie in different components.
    points : ndarray of float64, shape (k, 3)
        From the first point to the second: the edges crossed and vertices passed in order.
        Between neighbours the path is straight inside one face or along one edge. Empty where
        there is none.
    """

    length: float
    points: np.ndarray


class Loop(_Members):
    """The shortest geodesic loop based at a point.

    Attributes
    ----------
    base : ndarray of float64, shape (3,)
        The point p where the loop starts and ends.
    length : float
        I(p), in model units; where unresolved, no more than I(p).
    kind : str
        How it came about. ``"loop"``: The frontier of the growing geodesic disk touched itself
        head-on: a loop around the surface. ``"antipodal"``: The frontier vanished at one
        farthest point without a loop before: the "loop" is out and back again.
        ``"unresolved"``: The budget was met first. The length is a lower bound, and ``at_most``
        one from above.
    angle : float
        Angle at p between the loop's two ends, inside the surface, on the smaller side, in
        radians. At least π: the loop is a closed geodesic. 0: antipodal.
    midpoint : ndarray of float64, shape (3,)
        The loop's point farthest from p: length / 2 from p both ways, and both are shortest.
    points : ndarray of float64, shape (k, 3)
        The loop from p round to p: p, the edges it crosses and vertices it passes in order, p.
        Between neighbours it is straight inside one face or along one edge. An antipodal loop
        runs to ``midpoint`` and back the same way, and there the midpoint is one of the points.
        Empty where unresolved. Surfaces are cut along those of the kind Loop.
    """

    base: np.ndarray
    length: float
    kind: str
    angle: float
    midpoint: np.ndarray
    points: np.ndarray
    _curve: tuple[np.ndarray, np.ndarray]


class Handle(_Members):
    """A closed geodesic round a handle or a tunnel.

    Attributes
    ----------
    length : float
        In model units.
    kind : str
        Round the material, or round a hole. ``"handle"``: Inside: it goes round the material.
        ``"tunnel"``: Outside: it goes round a hole. ``"unknown"``: The component has no inside:
        it, or what closes its holes, crosses it.
    may_be_shorter_by : float
        How much shorter a loop in its place may be, at most, in model units: one of its kind
        and component that is no sum of the shorter ones listed. 0: none is, which is proven to
        a share of 1e-9.
    component : int
        The number of its component of the surface, from 0.
    area : float
        The area that the loop encloses in its mean plane, in squared model units.
    centre : ndarray of float64, shape (3,)
        Mean of the loop's points, each part counted by its length, in model units.
    points : ndarray of float64, shape (k, 3)
        The edges it crosses and the vertices it passes in order; the last point equals the
        first. Between neighbours it is straight inside one face or along one edge. Among
        parallel loops in a band, it is the one in the middle.
    """

    length: float
    kind: str
    may_be_shorter_by: float
    component: int
    area: float
    centre: np.ndarray
    points: np.ndarray
    _curve: tuple[np.ndarray, np.ndarray]


class Handles(_Members):
    """The handles of a surface.

    Attributes
    ----------
    unresolved : int
        Handles and tunnels that the genus promises and that were not found.
    handles : list of Handle
        The shortest first.
    """

    _entries = {"handles": "Handle"}
    unresolved: int
    handles: list["Handle"]


class NamedMeasure(_Members):
    """A measure at a landmark.

    Attributes
    ----------
    name : str
        The name of the landmark.
    how : str
        How it was measured. ``"girth"``: The length of the girth loop. ``"section"``: The
        perimeter of the curve of a plane through the point. ``"tape"``: The tape of that curve.
        ``"distance"``: The distance to another point, along the surface.
    point : ndarray of float64, shape (3,)
        The point of the landmark.
    length : float
        The measure, in model units; infinite for a distance that has no path.
    points : ndarray of float64, shape (k, 3)
        The curve that was measured; of all curves of a plane none.
    """

    name: str
    how: str
    point: np.ndarray
    length: float
    points: np.ndarray
    _curve: tuple[np.ndarray, np.ndarray]


class NamedMeasures(_Members):
    """Measures at landmarks.

    Attributes
    ----------
    measures : list of NamedMeasure
        In the order of the landmarks.
    """

    _entries = {"measures": "NamedMeasure"}
    measures: list["NamedMeasure"]


class AxisLoop(_Members):
    """One of the loops that are swept along a tube.

    Attributes
    ----------
    distance : float
        Along the axis from its first point, in model units.
    along : float
        Over the surface: how far along the first station is, and on along the path, in model
        units.
    girth : float
        The loop's length, in model units.
    area : float
        The area that the loop encloses in its mean plane, in squared model units.
    centre : ndarray of float64, shape (3,)
        A point of the axis: the mean of the loop's points, each part counted by its length.
    points : ndarray of float64, shape (k, 3)
        The loop, as `Loop.points`; the last point equals the first.
    """

    distance: float
    along: float
    girth: float
    area: float
    centre: np.ndarray
    points: np.ndarray
    _curve: tuple[np.ndarray, np.ndarray]


class Limb(_Members):
    """A finger, an arm, a leg: what lies between a tip's apex and the ring of points at
    ``length`` from it.

    Attributes
    ----------
    length : float
        Distance from the apex to the ring at its base, along the surface, in model units.
    narrowest : float
        The least girth of loops round the limb, from the end of its cap to the base, in model
        units: of the shortest neck, otherwise on the ring at one of these ends, or where loops
        slip off between them. The cap ends at ``middle`` / π from the apex, as far as the limb
        is thick, or where the tip's contour is, if that is farther. Exact, but not proven to be
        least between two stations. NaN where there is none.
    narrowest_distance : float
        How far from the apex it is, in model units: its ring, of equal ones the nearest, or the
        mean distance of the neck; NaN where there is none.
    median : float
        The middle one of the stations' medians, of those where a loop goes round the limb, in
        model units: along half of the limb the girth is less.
    middle : float
        The least girth on the ring at half of ``length``, in model units; NaN where no loop
        goes round the limb there.
    base : float
        The least girth at the base, in model units; NaN for a limb that is its whole component.
    end : str
        Why it ends there. ``"spreads"``: It spreads into a thicker part: beyond, the ring grows
        by more than π times the distance. ``"slips"``: Beyond, the loops at half of the ring's
        points have slipped off: they go round other parts. ``"splits"``: The ring falls apart
        into two, each round a part that is deeper than the limb is thick; or the loops slip
        over the place, less than half a loop beyond, where it does. ``"handle"``: The ring
        meets itself round a handle, or the loops slip over the place where it does.
        ``"boundary"``: The ring reaches the boundary of the surface. ``"whole"``: Never: the
        limb is its whole component, as of a spindle.
    tips : list of int
        The tips that it ends in, by their numbers in the list that was handed over; the first
        is the one with this apex. Several where the distances from each of their apexes give
        the same limb.
    apex : int
        Where it begins: the apex of a tip. -1 where there is none, or the preparation made it.
    vertices : ndarray of int64
        The vertices that the ring at the base cuts off, in rising order.
    distances : ndarray of float64
        Their distances from the apex, in model units.
    profile : ndarray of float64, shape (stations, 4)
        From near the apex to the base, at equal distances; the last station is the base.
        Columns: distance: How far along, in model units. ring: Length of the ring itself, in
        model units. median: The median of the girth over the ring, each part of it counted by
        its length, in model units; NaN where no part has a value. least: The least girth on the
        ring among loops that go round here, in model units; NaN where none does.
    """

    length: float
    narrowest: float
    narrowest_distance: float
    median: float
    middle: float
    base: float
    end: str
    tips: list[int]
    apex: int
    vertices: np.ndarray
    distances: np.ndarray
    profile: np.ndarray
    _places: tuple[np.ndarray, np.ndarray]


class Neck(_Members):
    """A closed geodesic that is shorter than every other closed curve near it
    (web/docs/definitions.md, section 5).

    Attributes
    ----------
    length : float
        In model units.
    prominence : float
        How far the girth must rise, at least, on the way over the surface from here to a
        narrower neck, in model units; infinite where no narrower one can be reached. See
        findNecks for what it is measured on.
    width : float
        Width of the band of parallel loops of the same length, in model units: 0 for a single
        one.
    area : float
        The area that the loop encloses in its mean plane, in squared model units.
    radius : float
        Mean distance of the loop from its centre, within the mean plane, in model units.
    centre : ndarray of float64, shape (3,)
        Mean of the loop's points, each part counted by its length, in model units.
    normal : ndarray of float64, shape (3,)
        Unit normal of the loop's mean plane: of all planes the one onto which it casts the
        largest area. Seen from its tip the loop runs counter-clockwise. Zero where there is
        none.
    sides : ndarray of float64, shape (sides, 2)
        The sides that it separates its component into, the larger area first; one where it
        separates nothing, as round a handle. Empty where the surface cannot be cut along it.
        Columns: area: In squared model units. volume: Enclosed by this side and the cone over
        the curve from the mean of its points, in cubed model units: negative where the surface
        faces inwards. NaN where the side has a boundary.
    measures_girth : bool
        Whether the girth is this neck's length at all of its vertices. Otherwise a shorter loop
        goes through one of them, as beside a thinner part.
    touches_boundary : bool
        Whether it touches the surface's boundary.
    vertices : ndarray of int64
        The vertices that the loop passes; of a band, that its two outermost loops pass. In
        rising order, at least one.
    points : ndarray of float64, shape (k, 3)
        The loop: the edges it crosses and the vertices it passes in order; the last point
        equals the first. Between neighbours it is straight inside one face or along one edge.
        Among parallel loops in a band, it is the one in the middle.
    """

    length: float
    prominence: float
    width: float
    area: float
    radius: float
    centre: np.ndarray
    normal: np.ndarray
    sides: np.ndarray
    measures_girth: bool
    touches_boundary: bool
    vertices: np.ndarray
    points: np.ndarray
    _curve: tuple[np.ndarray, np.ndarray]


class Necks(_Members):
    """The necks of a surface.

    Attributes
    ----------
    unresolved : int
        Vertices whose loops could not be followed: their girth is unresolved, or drawing them
        tight took more steps than their size explains.
    suggested_prominence : float
        A least prominence for the clear ones, in model units: a twentieth of the narrowest
        neck's length, whatever ``min_prominence`` leaves out. Necks of noise and most of bands
        of parallel loops are below it. 0 without necks.
    necks : list of Neck
        Most prominent first, of equal ones the shortest.
    """

    _entries = {"necks": "Neck"}
    unresolved: int
    suggested_prominence: float
    necks: list["Neck"]


class Part(_Members):
    """A connected region of one kind.

    Attributes
    ----------
    kind : str
        The kind of all its vertices. ``"body"``: Thick. ``"tube"``: Thin, and a short loop goes
        round it. ``"plate"``: Thin, but no short loop goes round it. ``"unknown"``: Its girth
        or its shape diameter has no value.
    area : float
        Sum of the vertices' areas, in squared model units.
    median_girth : float
        Median of the girth over the region, in model units; NaN where it is unknown.
    median_shape_diameter : float
        Median of the shape diameter over the region, in model units; NaN where it is unknown.
    equivalent_radius : float
        Radius of the round tube with the same girth, I / 2π, in model units.
    thinnest : int
        Its thinnest place: the vertex with the least girth (tube), otherwise the least SDF;
        none where it is unknown. `Mesh.loop` gives the loop there. -1 where there is none, or
        the preparation made it.
    vertices : ndarray of int64
        Its vertices, in rising order.
    """

    kind: str
    area: float
    median_girth: float
    median_shape_diameter: float
    equivalent_radius: float
    thinnest: int
    vertices: np.ndarray


class Maximum(_Members):
    """A maximum of a field.

    Attributes
    ----------
    vertex : int
        Where it is. -1 where there is none, or the preparation made it.
    value : float
        The field there, in its unit.
    persistence : float
        How far one must go down from it, at least, to reach a higher maximum: 0 or more, in the
        field's unit. For the highest of a component: how far down to its least value.
    saddle : int
        The vertex where its surroundings meet those of a higher maximum; none for the highest.
        -1 where there is none, or the preparation made it.
    """

    vertex: int
    value: float
    persistence: float
    saddle: int


class WeakPlace(_Members):
    """A connected place that does not meet a limit.

    Attributes
    ----------
    kind : str
        Which limit it does not meet. ``"tube"``: A tube's diameter. ``"wall"``: A wall's
        thickness. ``"gap"``: The clearance.
    measure : str
        The measure that is too small: "diameter", "thickness" or "clearance".
    least : float
        The least diameter, thickness or clearance there, in model units.
    area : float
        In squared model units; of faces that meet the limit in part, by samples.
    thinnest : ndarray of float64, shape (3,)
        The point that has it.
    opposite : ndarray of float64, shape (3,), or None
        The point of the surface across from it, in model units; of walls and gaps only.
    vertices : ndarray of int64
        Vertices that do not meet the limit, in rising order; where only the inside of faces
        does not, the corners of these.
    faces : ndarray of int64
        Faces that somewhere do not meet the limit, of walls and gaps, in rising order.
    """

    kind: str
    measure: str
    least: float
    area: float
    thinnest: np.ndarray
    opposite: Optional[np.ndarray]
    vertices: np.ndarray
    faces: np.ndarray


class Crease(_Members):
    """A connected place where measures are below a limit, but where no wall and no gap is. It
    does not fail.

    Attributes
    ----------
    kind : str
        The kind of its thinnest point. ``"crease"``: Faces run into each other, or end in a lip
        of an eighth of the limit. ``"rounding"``: Faces touch, to the rounding of coordinates
        in single precision. ``"sliver"``: A triangle is so low that rounding alone decides
        where it faces.
    length : float
        The sharp edges in it together, in model units; 0 where faces only touch.
    area : float
        In squared model units.
    least : float
        The least measure there, in model units: no thickness of anything.
    thinnest : ndarray of float64, shape (3,)
        The point that has it.
    opposite : ndarray of float64, shape (3,)
        The point of the surface across from it, in model units.
    vertices : ndarray of int64
        Its vertices, in rising order, as of a weak place.
    faces : ndarray of int64
        Its faces, in rising order.
    """

    kind: str
    length: float
    area: float
    least: float
    thinnest: np.ndarray
    opposite: np.ndarray
    vertices: np.ndarray
    faces: np.ndarray


class PrintCheck(_Members):
    """The answer to a check.

    Attributes
    ----------
    passes : bool
        Whether nothing fails; creases do not.
    failing_share : float
        The share of the surface's area, in [0, 1], that is in places.
    passing_scale : float
        At this scale of the shape nothing fails, and all measures grow with it. 1.12: it passes
        at 112% of its size; at most 1 where it passes as it is, and so far at least it may
        shrink (1 where there are creases). 0 where nothing is limited; infinite where no scale
        was found, as of a blade.
    places : list of WeakPlace
        The worst first, in shares of their limits.
    creases : list of Crease
        The places that are thin, but fail by no wall and no gap: the longest first.
    """

    _entries = {"places": "WeakPlace", "creases": "Crease"}
    passes: bool
    failing_share: float
    passing_scale: float
    places: list["WeakPlace"]
    creases: list["Crease"]


class RemovedHandle(_Members):
    """A handle or tunnel that was taken away.

    Attributes
    ----------
    kind : str
        Which of the two it was. ``"handle"``: Inside: it goes round the material. ``"tunnel"``:
        Outside: it goes round a hole. ``"unknown"``: The component has no inside: it, or what
        closes its holes, crosses it.
    length : float
        The length of its loop, in model units.
    centre : ndarray of float64, shape (3,)
        Mean of the loop's points, in model units.
    dropped_area : float
        Area of its tube, which was dropped, in squared model units; 0 where the surface was cut
        along the loop and closed.
    """

    kind: str
    length: float
    centre: np.ndarray
    dropped_area: float


class HandleRemoval(_Members):
    """A surface with fewer handles, and the account of what was done.

    Attributes
    ----------
    genus_before : int
        Genus of all components together.
    genus_after : int
        Genus of the surface that is left.
    crossing_faces : int
        Faces that were made or moved and cross others, since there was no room for them; those
        of the surface that crossed each other before do not count.
    proven_length : float
        No loop is left that is shorter than this, in model units, but those that touch the
        boundary: the length that was asked for, or less where the budget did not suffice to
        prove it.
    removed : list of RemovedHandle
        The removed handles without their loops, in the order of the cuts.
    """

    _entries = {"removed": "RemovedHandle"}
    genus_before: int
    genus_after: int
    crossing_faces: int
    proven_length: float
    removed: list["RemovedHandle"]


class SectionCurve(_Members):
    """A curve in which a plane cuts a surface (web/docs/definitions.md, section 5).

    Attributes
    ----------
    perimeter : float
        Its length, in model units; of an open curve without the gap.
    tape : float
        The perimeter of its convex hull in the plane, in model units: what a tape shows, which
        spans hollows.
    area : float
        The area that it encloses, those of the holes in it taken away, in squared model units;
        0 where it is open.
    equivalent_diameter : float
        The diameter of a circle of that area, in model units.
    least_width : float
        The least distance of two parallel lines in the plane that hold it between them, in
        model units.
    greatest_width : float
        The greatest one, in model units: that of its two points that are farthest apart.
    centre : ndarray of float64, shape (3,)
        The centroid of its area; of an open curve, of its length.
    inscribed_diameter : float
        The diameter of the largest circle in the plane that it encloses and none of its holes
        meets, in model units; 0 where it is open. NaN where circles were not asked for.
    inscribed_centre : ndarray of float64, shape (3,)
        The centre of that circle, of several equal ones of any; ``centre`` where there is none.
        NaN where circles were not asked for.
    closed : bool
        False where it ends at the surface's boundary.
    hole : bool
        Whether it bounds a hole in another curve: what the surface encloses lies round it.
    component : int
        The component of the surface that it lies on.
    limb : int, or None
        The number of the limb that it lies on, where limbs were asked for: more than half of
        its length does.
    points : ndarray of float64, shape (k, 3)
        The edges that it crosses and the vertices that it passes, in order; straight between
        neighbours. Seen from the tip of the plane's normal, what the surface encloses lies on
        the left. The last point of a closed curve equals the first.
    """

    perimeter: float
    tape: float
    area: float
    equivalent_diameter: float
    least_width: float
    greatest_width: float
    centre: np.ndarray
    inscribed_diameter: float
    inscribed_centre: np.ndarray
    closed: bool
    hole: bool
    component: int
    limb: Optional[int]
    points: np.ndarray
    _curve: tuple[np.ndarray, np.ndarray]


class Section(_Members):
    """The curves that one plane cuts.

    Attributes
    ----------
    normal : ndarray of float64, shape (3,)
        The plane's normal, of length 1.
    offset : float
        Normal · x of all points of the plane, in model units.
    perimeter : float
        The sum of the curves' lengths, in model units.
    tape : float
        The perimeter of the convex hull of all curves, in model units: one tape round them.
    area : float
        The sum of the areas of the curves that are no holes, in squared model units.
    curves : list of SectionCurve
        In the order of the first face that each runs through. Empty where the plane misses the
        surface.
    """

    _entries = {"curves": "SectionCurve"}
    normal: np.ndarray
    offset: float
    perimeter: float
    tape: float
    area: float
    curves: list["SectionCurve"]


class Sections(_Members):
    """The curves that several planes cut.

    Attributes
    ----------
    sections : list of Section
        In the order in which the planes were given.
    """

    _entries = {"sections": "Section"}
    sections: list["Section"]


class Segment(_Members):
    """One segment of a body.

    Attributes
    ----------
    kind : str
        The kind that has the largest area in it; of equal ones the first. ``"body"``: Thick.
        ``"tube"``: Thin, and a short loop goes round it. ``"plate"``: Thin, but no short loop
        goes round it. ``"unknown"``: Its girth or its shape diameter has no value.
    shares : dict of str to float
        Shares of its area by kind.
    """

    kind: str
    shares: dict[str, float]


class TightPiece(_Members):
    """A piece of a curve between two points that stay; of a closed curve without any, all of
    it.

    Attributes
    ----------
    length_before : float
        The length before, in model units.
    length : float
        The length when it is tight, in model units.
    promise : str
        The curves that it is shorter than. ``"shortest"``: All curves of the homotopy class,
        with the same ends. ``"local"``: All curves that it can be moved to without passing over
        a convex vertex. ``"shorter"``: Unknown: it was given up after too many steps, and is
        only no longer.
    start : ndarray of float64, shape (3,)
        Where it begins.
    end : ndarray of float64, shape (3,)
        Where it ends.
    """

    length_before: float
    length: float
    promise: str
    start: np.ndarray
    end: np.ndarray


class TightCurve(_Members):
    """A curve drawn tight.

    Attributes
    ----------
    kind : str
        Whether it is open or closed, or only a point. ``"path"``: It joins two ends, which
        stay. ``"loop"``: It is closed. ``"point"``: It contracts to a point: it bounds a disk
        that it slips off.
    promise : str
        The weakest promise of its pieces. ``"shortest"``: All curves of the homotopy class,
        with the same ends. ``"local"``: All curves that it can be moved to without passing over
        a convex vertex. ``"shorter"``: Unknown: it was given up after too many steps, and is
        only no longer.
    component : int
        The component that it lies on.
    length_before : float
        The length of the curve through the points that were given, in model units.
    length : float
        The length of the tight one, in model units.
    pieces : list of TightPiece
        Its pieces, in order: one, but where all points stay.
    points : ndarray of float64, shape (k, 3)
        The edges that it crosses and the vertices that it passes, in order; straight between
        neighbours. The last point of a closed curve equals the first. Empty where it is a
        point.
    """

    _entries = {"pieces": "TightPiece"}
    kind: str
    promise: str
    component: int
    length_before: float
    length: float
    pieces: list["TightPiece"]
    points: np.ndarray
    _curve: tuple[np.ndarray, np.ndarray]


class Contour(_Members):
    """A line across edges of the surface: a point in the middle of each, in order.

    Attributes
    ----------
    closed : bool
        Whether it comes back to its first point, which is not repeated. Otherwise it ends at
        the boundary, or, an arc, inside faces.
    points : ndarray of float64, shape (k, 3)
        The middles of the edges that it crosses.
    """

    closed: bool
    points: np.ndarray


class Tip(_Members):
    """A region that the discontinuity contour cuts off.

    Attributes
    ----------
    area : float
        Area inside the contour, in squared model units.
    boundary_length : float
        Length of the contour, in model units.
    jump : float
        How far the girth rises from outside to inside, in model units: the median over the
        edges that the contour crosses. Tips that noise makes rise little.
    apex : int
        The vertex of the region that is farthest from the contour, along the surface. -1 where
        there is none, or the preparation made it.
    apex_distance : float
        How far, in model units.
    vertices : ndarray of int64
        Its vertices, in rising order.
    contour : list of Contour
        The line that cuts it off: usually one closed line.
    """

    _entries = {"contour": "Contour"}
    area: float
    boundary_length: float
    jump: float
    apex: int
    apex_distance: float
    vertices: np.ndarray
    contour: list["Contour"]


class OpenArc(_Members):
    """A part of the discontinuity contour that is no tip's: it ends somewhere, or where it
    meets the contour of a tip, which it follows closely.

    Attributes
    ----------
    length : float
        Its length, in model units.
    jump : float
        How far the girth rises across it, in model units: as of a tip.
    line : Contour
        Where it runs; never closed.
    """

    _entries = {"line": "Contour"}
    length: float
    jump: float
    line: "Contour"


class Tips(_Members):
    """The tips of a surface, and what else the girth jumps along.

    Attributes
    ----------
    crossed_edges : int
        Edges that the contour crosses.
    tips : list of Tip
        Largest jump first.
    arcs : list of OpenArc
        Longest first.
    """

    _entries = {"tips": "Tip", "arcs": "OpenArc"}
    crossed_edges: int
    tips: list["Tip"]
    arcs: list["OpenArc"]


class TubeStation(_Members):
    """The measures of a tube at one place of its centreline (web/docs/definitions.md, section
    5).

    Attributes
    ----------
    branch : int
        The number of the branch.
    distance : float
        How far along the centrelines it is from where the first branch begins, in model units.
    equivalent_diameter : float
        The diameter of a circle with the section's area, in model units.
    area : float
        The area of the section perpendicular to the centreline, in squared model units.
    perimeter : float
        The length of its outline, in model units.
    inscribed_diameter : float
        The diameter of the largest circle within it, in model units.
    least_width : float
        The least distance of two parallel lines that hold it between them, in model units.
    greatest_width : float
        The greatest such distance, in model units.
    girth : float
        The exact girth at ``place``, in model units; NaN where no loop goes round, as in caps
        (where it is longer than the outline), or where it was not asked for.
    curvature : float
        The curvature of the centreline, in 1 / model units: one over the radius of its circle.
    torsion : float
        How fast the centreline leaves the plane of that circle, in radians per model unit;
        positive where it is screwed to the right. NaN where it is straight: a curvature below
        0.001 divided by the equivalent diameter.
    centre : ndarray of float64, shape (3,)
        A point of the centreline: the centroid of the section.
    direction : ndarray of float64, shape (3,)
        Along the centreline, of length 1, away from the first end.
    place : ndarray of float64, shape (3,)
        The point of the outline that is nearest to the centre.
    points : ndarray of float64, shape (k, 3)
        The outline: the edges that it crosses in order; the last point equals the first.
    """

    branch: int
    distance: float
    equivalent_diameter: float
    area: float
    perimeter: float
    inscribed_diameter: float
    least_width: float
    greatest_width: float
    girth: float
    curvature: float
    torsion: float
    centre: np.ndarray
    direction: np.ndarray
    place: np.ndarray
    points: np.ndarray
    _curve: tuple[np.ndarray, np.ndarray]


class TubePlace(_Members):
    """A place where a tube is narrower or wider than on both sides.

    Attributes
    ----------
    change : str
        Which of the two it is. ``"narrowing"``: Narrower than on both sides: a stenosis.
        ``"widening"``: Wider than on both sides: a bulge, an aneurysm.
    branch : int
        The number of the branch.
    distance : float
        Where its section is least, or greatest, in model units, as `TubeStation.distance`.
    before_distance : float
        The side before: the nearest place from which the tube is no wider (no narrower) towards
        its beginning, in model units, as `TubeStation.distance`.
    beyond_distance : float
        The side beyond, in model units: the same towards its end.
    length : float
        How long it is: the part along which the diameter differs from the taper between both
        sides by more than half as much as at the place itself, in model units.
    equivalent_diameter : float
        The equivalent diameter at the place, in model units.
    reference : float
        The equivalent diameter that it is compared with, in model units.
    degree_by_diameter : float
        How much less (more) the equivalent diameter is, as a share of the reference.
    degree_by_area : float
        How much less (more) the area is, as a share of the area of the reference's circle.
    before_diameter : float
        The equivalent diameter at ``before_distance``, in model units.
    beyond_diameter : float
        The equivalent diameter at ``beyond_distance``, in model units.
    area : float
        The area of the section there, in squared model units.
    perimeter : float
        The length of its outline, in model units.
    inscribed_diameter : float
        The diameter of the largest circle within it, in model units.
    least_width : float
        The least distance of two parallel lines that hold it between them, in model units.
    girth : float
        The length of the neck that a narrowing's outline is drawn tight to (girth/necks.h); of
        a widening the exact girth at the point of the outline nearest to the centre. In model
        units; NaN where there is none, or where it was not asked for.
    centre : ndarray of float64, shape (3,)
        The centroid of the section.
    points : ndarray of float64, shape (k, 3)
        The outline, as `TubeStation.points`.
    """

    change: str
    branch: int
    distance: float
    before_distance: float
    beyond_distance: float
    length: float
    equivalent_diameter: float
    reference: float
    degree_by_diameter: float
    degree_by_area: float
    before_diameter: float
    beyond_diameter: float
    area: float
    perimeter: float
    inscribed_diameter: float
    least_width: float
    girth: float
    centre: np.ndarray
    points: np.ndarray
    _curve: tuple[np.ndarray, np.ndarray]


class TubeBranch(_Members):
    """A tube between two ends or branchings.

    Attributes
    ----------
    component : int
        The component of the surface that it lies on.
    parent : int, or None
        The number of the branch that it leaves; none where it begins at an end.
    ends : bool
        Whether it leads to an end, and not to a branching.
    open : bool
        Whether that end is open: a boundary curve of the surface.
    end : int, or None
        A vertex of that end; none where it leads to a branching. -1 where there is none, or the
        preparation made it.
    first_distance : float
        The distance of its first station, in model units, as `TubeStation.distance`.
    last_distance : float
        The distance of its last station, in model units.
    median : float
        The median of the equivalent diameters of its stations, in model units.
    first_station : int
        The numbers of its stations in the result, the first and the one behind the last.
    end_station : int
        See firstStation.
    """

    component: int
    parent: Optional[int]
    ends: bool
    open: bool
    end: Optional[int]
    first_distance: float
    last_distance: float
    median: float
    first_station: int
    end_station: int


class NoTubeComponent(_Members):
    """A component that is no tube.

    Attributes
    ----------
    component : int
        Its number.
    reason : str
        The reason for it. ``"handle"``: It has a handle: centrelines would run in a circle.
        ``"blunt"``: It is less than 2.5 times as long as wide, as a ball is. ``"flat"``: It is
        more than four times as wide as thick, as a plate is. ``"coarse"``: No section
        perpendicular to its line is closed.
    """

    component: int
    reason: str


class Tubes(_Members):
    """The tubes of a surface.

    Attributes
    ----------
    branches : list of TubeBranch
        Each behind the one that it leaves.
    others : list of NoTubeComponent
        Components that are no tubes, in rising order.
    places : list of TubePlace
        Narrowings and widenings, by branch and by distance.
    stations : list of TubeStation
        The stations of all branches, by branch and by distance.
    """

    _entries = {"branches": "TubeBranch", "others": "NoTubeComponent", "places": "TubePlace", "stations": "TubeStation"}
    branches: list["TubeBranch"]
    others: list["NoTubeComponent"]
    places: list["TubePlace"]
    stations: list["TubeStation"]
