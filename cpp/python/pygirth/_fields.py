"""The fields of a mesh. Made of cpp/include/girth/fields.def by `npm run build:tables`: not to be edited."""

from __future__ import annotations

from typing import Any, Optional, Sequence

from pygirth._arguments import Progress
from pygirth.results import Field


class Fields:
    def _field(
        self,
        name: str,
        given: dict[str, Any],
        pairs: Optional[int],
        times: Optional[Sequence[float]],
        threads: Optional[int],
        progress: Progress,
    ) -> Field:
        raise NotImplementedError

    def field(
        self,
        name: str,
        *,
        rays: Optional[int] = None,
        cone: Optional[float] = None,
        sharp: Optional[float] = None,
        exact: bool = False,
        from_: Any = None,
        radius: Optional[float] = None,
        pairs: Optional[int] = None,
        times: Optional[Sequence[float]] = None,
        threads: Optional[int] = None,
        progress: Progress = None,
    ) -> Field:
        """A function with one value for each vertex, or several.

        Parameters
        ----------
        name : str
            One of `FIELDS`; the documentation of the outputs states what each is.
        rays : int, optional
            For ``'sdf'``: Rays sent from each vertex, 1 to 10,000.
        cone : float, in degrees, optional
            For ``'sdf'``: opening of the cone.
        sharp : float, in degrees, optional
            For ``'thickness'``: edges sharper than this thin out to nothing.
        exact : bool, optional
            For ``'geoaverage'`` and ``'geofarthest'``: exact distances, not by fast marching.
        from_ : point or sequence of points, optional
            For ``'distance'``: Where distances are measured from: each is that from the nearest
            of these points.
        radius : float, optional
            For ``'distance'``: Vertices farther away than this, in model units, have an
            infinite distance.
        pairs : int, optional
            For ``'hks'``, ``'sihks'`` and ``'wks'``: eigenpairs, 2 to 100,000.
        times : sequence of float, optional
            For ``'hks'``: diffusion times as shares of the area.
        threads, progress
            As of `igf`; signatures and distances use one thread.

        Returns
        -------
        Field
            Its values have the shape (n,), of signatures (n, d).
        """
        given = {
            "rays": rays,
            "cone": cone,
            "sharp": sharp,
            "exact": exact or None,
            "from": from_,
            "radius": radius,
        }
        return self._field(name, given, pairs, times, threads, progress)
