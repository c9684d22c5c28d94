"""The intrinsic girth function of triangle meshes: exact values and shortest geodesic loops.

>>> import pygirth
>>> field = pygirth.igf(V, F)          # one value for each row of V
>>> m = pygirth.load("model.glb")      # or pygirth.Mesh(V, F), or pygirth.as_mesh(a trimesh)
>>> m.tips().apexes
"""

from pygirth import _girth, _members, collection, errors, results
from pygirth._members import *
from pygirth._show import Shown, show
from pygirth.errors import (
    GirthError,
    InputError,
    LimitError,
    MissingFileError,
    MissingPackageError,
)
from pygirth.mesh import FIELDS, Mesh, as_mesh, compare, igf, load
from pygirth.results import (
    AxisLoop,
    Barcode,
    Bottleneck,
    Comparison,
    Contour,
    Crease,
    Cut,
    CutPart,
    Field,
    Girth,
    Handle,
    HandleRemoval,
    Handles,
    Limb,
    Loop,
    Maximum,
    Neck,
    Necks,
    OpenArc,
    Part,
    Parts,
    Path,
    PrintCheck,
    Profile,
    RefinedGirth,
    RemovedHandle,
    Segment,
    Section,
    SectionCurve,
    Segments,
    Tip,
    Tips,
    WeakPlace,
)

__version__: str = _girth.version

__all__ = [
    "AxisLoop",
    "Barcode",
    "Bottleneck",
    "Comparison",
    "Contour",
    "Crease",
    "Cut",
    "CutPart",
    "FIELDS",
    "Field",
    "Girth",
    "GirthError",
    "Handle",
    "HandleRemoval",
    "Handles",
    "InputError",
    "Limb",
    "LimitError",
    "Loop",
    "Maximum",
    "Mesh",
    "MissingFileError",
    "MissingPackageError",
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
    "Segment",
    "Section",
    "SectionCurve",
    "Segments",
    "Shown",
    "Tip",
    "Tips",
    "WeakPlace",
    "as_mesh",
    "collection",
    "compare",
    "errors",
    "igf",
    "load",
    "results",
    "show",
]
__all__ += _members.__all__
