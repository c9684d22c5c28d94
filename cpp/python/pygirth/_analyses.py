"""The analyses of a mesh. Made of cpp/include/girth/analyses.def by `npm run build:tables`: not to be edited."""

from __future__ import annotations

import math
from typing import Any, Iterable, Mapping, Optional, Sequence

from pygirth import _girth
from pygirth._arguments import Progress, entry_of, one_of, real_number, running, three_numbers
from pygirth.results import Distances, Sections, Section, NamedMeasures, TightCurve, Tubes


class Analyses:
    _surface: "_girth.Surface"

    def _point(self, point: Any) -> tuple[int, list[float]]:
        raise NotImplementedError

    def distances(
        self,
        pairs: Iterable[tuple[Any, Any]],
        *,
        paths: bool = False,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Distances:
        """Measures the distances between pairs of points along the surface, exact to rounding
        (`GeodesicSolver.path`).

        Parameters
        ----------
        pairs : sequence of two points
            The points: two for each distance.
        paths : bool, optional
            Whether each distance has its shortest path too.
        threads, progress
            As of `igf`.

        Returns
        -------
        Distances

        Notes
        -----
        On all threads, the same bits for any number of them. Errors: VERTEX_OUT_OF_RANGE,
        INVALID_POINT; LIMIT_EXCEEDED where a path takes too many windows; CANCELLED.
        """
        options = (
            [[self._point(part) for part in one] for one in pairs],
            bool(paths),
        )
        return Distances(_girth.analyse("distances", self._surface, options, running(threads, progress)))

    def sections(
        self,
        normal: Sequence[float],
        offsets: Iterable[float],
        *,
        inscribed: bool = False,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Sections:
        """Cuts a surface with planes of one normal, at several offsets, and measures the
        curves.

        Parameters
        ----------
        normal : three floats
            The planes' normal, of any length but 0.
        offsets : sequence of float
            Where each plane lies: normal · x in model units, where the normal has length 1.
        inscribed : bool, optional
            Whether each curve has its largest inscribed circle, which takes longer.
        threads, progress
            As of `igf`.

        Returns
        -------
        Sections

        Notes
        -----
        *Planes through vertices.* A vertex that lies in the plane (nearer to it than 1e-12 of
        the greatest coordinate) counts as lying above it, on the side of the normal. So every
        curve runs through edges that lead from below to above, curves never end inside the
        surface, and where the plane touches it from above there is none. A face in the plane is
        part of the section by its outline, where the surface goes on below it. *Holes* are
        found by the surface's orientation: a closed curve is a hole where the enclosed side
        lies round it and another curve of the section lies round that. Curves of bodies that
        overlap are measured one by one. On polyhedra the measures are exact to rounding.
        Inscribed circles are the largest to 1e-12 of their diameter, proven by branch and
        bound; where that takes more than 100,000 squares, as of curves 10,000 times as long as
        wide, the largest found. Time: O(n log m + c log c) for n faces, m planes and c crossed
        edges, without the circles, on all threads; the same result for any number of them.
        Errors: INVALID_OPTION (a normal without length, an offset that is not finite),
        CANCELLED.
        """
        options = (
            three_numbers(normal, "normal"),
            [real_number(one, "offsets") for one in offsets],
            bool(inscribed),
        )
        return Sections(_girth.analyse("sections", self._surface, options, running(threads, progress)))

    def sections_through(
        self,
        points: Iterable[Any],
        *,
        normal: Sequence[float] = (0, 0, 1),
        across: bool = False,
        inscribed: bool = False,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Sections:
        """Cuts a surface with a plane through each of some points.

        Parameters
        ----------
        points : sequence of point
            The points: one for each plane.
        normal : three floats, optional
            The planes' normal, of any length but 0.
        across : bool, optional
            Whether each plane is perpendicular to the limb or tube at its point, instead of the
            normal.
        inscribed : bool, optional
            Whether each curve has its largest inscribed circle, which takes longer.
        threads, progress
            As of `igf`.

        Returns
        -------
        Sections

        Notes
        -----
        Errors: those of ``find_sections`` and, across limbs, of ``direction_along``;
        VERTEX_OUT_OF_RANGE, INVALID_POINT.
        """
        options = (
            [self._point(one) for one in points],
            three_numbers(normal, "normal"),
            bool(across),
            bool(inscribed),
        )
        return Sections(_girth.analyse("sectionsThrough", self._surface, options, running(threads, progress)))

    def extreme_section(
        self,
        normal: Sequence[float],
        extreme: str,
        *,
        low: float = -math.inf,
        high: float = math.inf,
        measure: str = "perimeter",
        inscribed: bool = False,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Section:
        """Finds the section in which a measure is greatest or least, of all planes of one
        normal in a range of offsets.

        Parameters
        ----------
        normal : three floats
            The planes' normal, of any length but 0.
        extreme : "widest" or "narrowest"
            Which of the two is looked for.
        low : float, optional
            The least offset of a plane, in model units.
        high : float, optional
            The greatest one, in model units.
        measure : "perimeter" or "tape", optional
            The measure that is compared.
        inscribed : bool, optional
            Whether each curve has its largest inscribed circle, which takes longer.
        threads, progress
            As of `igf`.

        Returns
        -------
        Section

        Notes
        -----
        Between the heights of two vertices the perimeter is linear in the offset, and the tape
        convex: the greatest, and the least perimeter, are at such a height, just above one (by
        2e-12 of the greatest coordinate), or at an end of the range; the least tape is found
        between them, by parabolas and golden sections (Brent 1973). Among equal ones, it is the
        lowest. Time: O(c log c) for the edges that planes at all heights of vertices cross, on
        all threads; the same result for any number of them. Errors: INVALID_OPTION (a normal
        without length, no range, or no plane of it that meets the surface), CANCELLED.
        """
        options = (
            three_numbers(normal, "normal"),
            one_of(extreme, "extreme", ["widest", "narrowest"]),
            real_number(low, "low"),
            real_number(high, "high"),
            one_of(measure, "measure", ["perimeter", "tape"]),
            bool(inscribed),
        )
        return Section(_girth.analyse("extremeSection", self._surface, options, running(threads, progress)))

    def measure_landmarks(
        self,
        landmarks: Iterable[Mapping[str, Any]],
        *,
        normal: Sequence[float] = (0, 0, 1),
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> NamedMeasures:
        """Measures at landmarks of a surface.

        Parameters
        ----------
        landmarks : sequence of dict
            The landmarks: one for each measure. ``"name"``: The name of the measure.
            ``"point"``: Where it is measured, or begins. ``"how"``: How it is measured.
            ``"to"``: The other end of a distance. ``"across"``: Whether the plane of a section
            or tape is perpendicular to the limb or tube at the point. ``"all"``: Whether a
            section or tape takes all curves of its plane, not the one through the point.
        normal : three floats, optional
            The normal of planes that are not across limbs, of any length but 0.
        threads, progress
            As of `igf`.

        Returns
        -------
        NamedMeasures

        Notes
        -----
        Errors: those of the measures, with the name of the landmark before the message;
        INVALID_OPTION (a normal without length), CANCELLED.
        """
        options = (
            [(str(entry_of(one, "name")), self._point(entry_of(one, "point")), one_of(entry_of(one, "how"), "how", ["girth", "section", "tape", "distance"]), self._point(one["to"]) if "to" in one else None, bool(one.get("across", False)), bool(one.get("all", False))) for one in landmarks],
            three_numbers(normal, "normal"),
        )
        return NamedMeasures(_girth.analyse("measureLandmarks", self._surface, options, running(threads, progress)))

    def tighten(
        self,
        points: Iterable[Any],
        *,
        closed: bool = False,
        fixed: bool = False,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> TightCurve:
        """Draws a curve tight: it is moved over the surface and only gets shorter, until it is
        straight in all faces and across all edges, and has at least π on both sides of each
        vertex that it passes, on the inner side alone at a boundary (Xin, He and Fu 2012).

        Parameters
        ----------
        points : sequence of point
            The curve, point by point. Neighbours that lie in one face are joined straight,
            others by a shortest path.
        closed : bool, optional
            Whether it goes on from the last point to the first, and no point stays. Otherwise
            both ends stay, also where they are one point.
        fixed : bool, optional
            Whether all its points stay: each piece between two is drawn tight by itself.
        threads, progress
            As of `igf`.

        Returns
        -------
        TightCurve

        Notes
        -----
        It stays in its homotopy class. No curve of the class is shorter where the component has
        no convex vertex but at its boundary, where an open curve is as long as the distance of
        its ends, or where it contracts; elsewhere none is that it can be moved to without
        passing over a convex vertex. A closed curve with equally long ones beside it stays
        among them. Lengths are exact to rounding; an angle that lacks 1e-8 of π counts as
        straight, and a point with a share below 1e-10 lies on the edge or at the vertex beside
        it. Time: linear in the curve for each vertex that it is moved over, and a shortest path
        between ends. Errors: INVALID_OPTION (no points); VERTEX_OUT_OF_RANGE; INVALID_POINT
        (also of a curve over several components); LIMIT_EXCEEDED where a shortest path takes
        too many windows; CANCELLED.
        """
        options = (
            [self._point(one) for one in points],
            bool(closed),
            bool(fixed),
        )
        return TightCurve(_girth.analyse("tighten", self._surface, options, running(threads, progress)))

    def tubes(
        self,
        *,
        ends: Iterable[Any] = (),
        spacing: float = 0,
        least_degree: float = 0.1,
        reference: str = "taper",
        girth: bool = True,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Tubes:
        """Finds the centrelines of tubes, and measures what lies along them.

        Parameters
        ----------
        ends : sequence of point, optional
            Points at the ends: the vertex nearest to each lies on a boundary curve, or where a
            tube ends closed; the first one of a component is where its centrelines begin. Where
            a component has fewer than two, the others are found: boundary curves, but for holes
            shorter than a tenth of the longest, and the places that are farthest away, where a
            closed branch is longer than a tenth of the whole.
        spacing : float, optional
            The distance of stations, in model units. 0: an eighth of the median diameter, but
            at most 1,000 stations a branch.
        least_degree : float, optional
            The least degree, by diameter, of narrowings and widenings that are listed, above 0.
        reference : "taper" or "mean" or "beyond" or "before", optional
            The diameter that each is compared with.
        girth : bool, optional
            Whether the exact girth is measured too, which takes longer.
        threads, progress
            As of `igf`.

        Returns
        -------
        Tubes

        Notes
        -----
        The surface is divided into branches by a harmonic function from one end to the others.
        The line through the middles of its level curves is then moved until each of its points
        is the centroid of the section perpendicular to it. Stations whose section is open, or
        runs over another branch, are left out. Sections are exact on the surface; the line is
        exact where it is straight or a circle, to the square of the spacing. Where a tube ends
        closed, the line goes on as it bends before. Time: O(n) for each station and step, on
        all threads, and one loop for each station; the same result for any number of threads.
        Errors: VERTEX_OUT_OF_RANGE; INVALID_POINT; INVALID_OPTION (a spacing or degree that is
        negative or not finite, one that makes more than 100,000 stations); LIMIT_EXCEEDED;
        CANCELLED.
        """
        options = (
            [self._point(one) for one in ends],
            real_number(spacing, "spacing"),
            real_number(least_degree, "least_degree"),
            one_of(reference, "reference", ["taper", "mean", "beyond", "before"]),
            bool(girth),
        )
        return Tubes(_girth.analyse("tubes", self._surface, options, running(threads, progress)))
