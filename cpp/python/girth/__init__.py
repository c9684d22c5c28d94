"""The intrinsic girth function of triangle meshes: exact values and shortest geodesic loops.

>>> import girth
>>> field = girth.igf(V, F)          # one value for each row of V
>>> m = girth.load("model.glb")      # or girth.Mesh(V, F), or girth.as_mesh(a trimesh)
>>> m.tips().apexes
"""

from girth import _girth, collection, errors, results
from girth._show import Shown, show
from girth.errors import GirthError, InputError, LimitError, MissingPackageError
from girth.mesh import FIELDS, Mesh, as_mesh, compare, igf, load
from girth.results import (
    AxisLoop,
    Barcode,
    Bottleneck,
    Comparison,
    Contour,
    Cut,
    CutPart,
    Field,
    Girth,
    Handle,
    Handles,
    Limb,
    Loop,
    Neck,
    Necks,
    Part,
    Parts,
    Path,
    Profile,
    RefinedGirth,
    Segment,
    Segments,
    Tip,
    Tips,
)

__version__: str = _girth.version

__all__ = [
    "AxisLoop",
    "Barcode",
    "Bottleneck",
    "Comparison",
    "Contour",
    "Cut",
    "CutPart",
    "FIELDS",
    "Field",
    "Girth",
    "GirthError",
    "Handle",
    "Handles",
    "InputError",
    "Limb",
    "LimitError",
    "Loop",
    "Mesh",
    "MissingPackageError",
    "Neck",
    "Necks",
    "Part",
    "Parts",
    "Path",
    "Profile",
    "RefinedGirth",
    "Segment",
    "Segments",
    "Shown",
    "Tip",
    "Tips",
    "as_mesh",
    "collection",
    "compare",
    "errors",
    "igf",
    "load",
    "results",
    "show",
]
