"""The analyses of a mesh. Made of cpp/include/girth/analyses.def by `npm run build:tables`: not to be edited."""

from __future__ import annotations

from typing import Any, Iterable, Optional

from pygirth import _girth
from pygirth._arguments import Progress, running
from pygirth._members import Distances


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
