// Fields of values as a file's content: CSV, JSON, NPY, PLY or GLB.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/girth_solver.h"
#include "girth/io/read_mesh.h"
#include "girth/io/vertex_field.h"
#include "girth/tips.h"

namespace girth::io {

/// Which columns text has besides the fields'.
enum class Columns : std::uint8_t {
  Fields,     ///< the fields', by their names alone
  Positions,  ///< also x, y and z of each vertex, and units in the header of a CSV
};

/// `vertex,igf,kind` (the fields' names, each followed by `kind` where it has kinds) and one row
/// for every vertex of the *file*, in its order, counted from 0. Vertices that were welded share
/// their values. Where a vertex is not on the surface, or has no value, its columns are empty.
/// Numbers read back as the same doubles (formatNumber); lines end with "\n". With positions:
/// `vertex,x (mm),y (mm),z (mm),igf (mm),kind`, without the units that are not known.
GIRTH_EXPORT std::string fieldCsv(const LoadedMesh& loaded, std::span<const VertexField> fields,
                                  Columns columns = Columns::Fields);

/// The fields as one JSON object: `file`, `unit` of the model ("" where it is not known),
/// `complete`, `vertices`, `fields` (of each its `name`, `method`, `unit` and whether it is
/// `complete`), and one array for every column of the CSV but the first, under its name (without
/// units), with null where that is empty.
GIRTH_EXPORT std::string fieldJson(const LoadedMesh& loaded, std::span<const VertexField> fields,
                                   std::string_view file, Columns columns = Columns::Fields);

/// The values as NumPy reads them with `numpy.load`: format version 1.0, dtype '<f8', shape (n,),
/// one for every vertex of the *file*, in its order; NaN where the CSV is empty.
GIRTH_EXPORT std::string fieldNpy(const LoadedMesh& loaded, const VertexField& field);

/// The surface as binary little-endian PLY: for every vertex of the *surface* (not of the file) x,
/// y, z and each field as doubles, after a field with kinds `kind` as a byte (0 loop, 1 antipodal,
/// 2 unresolved, 255 no value, where the field is NaN); then the faces. Comments state units,
/// methods and what codes mean.
GIRTH_EXPORT std::string fieldPly(const LoadedMesh& loaded, std::span<const VertexField> fields);

/// Values between which the colour map of a GLB runs.
struct ColourRange {
  double low{0};   ///< its first colour
  double high{1};  ///< its last colour
};

/// Lines that a GLB has beside the surface. Does not own them.
struct LinesOnSurface {
  std::span<const GirthLoop> loops;  ///< loops at vertices; those that are unresolved are left out
  const Tips* tips{nullptr};         ///< null: none
};

/// The surface as GLB with, for every vertex of the *surface*: each field as an attribute of its
/// name in capitals behind an underscore (`_IGF`), kinds as `_KIND`, and `COLOR_0`: the first field
/// in the colours of viridis between the ends of `range`, by default its least and greatest value,
/// so that any viewer shows it; grey where it has no value.
///
/// glTF holds numbers of 32 bits: positions and values are rounded to the nearest float, too large
/// ones to the largest; whoever needs the bits takes CSV, NPY or PLY. It has no NaN either: where a
/// field has no value, the attribute is -1. glTF is in metres: a model in another length that is
/// known ("millimetre", ...) is scaled by its node; positions and fields stay in the model's unit.
/// Units and methods stand in the mesh's `extras`.
///
/// Each line is a mesh of its own, a line strip in a node called `loop 12`, `tip 0` or `arc 0`, so
/// that any viewer shows it: readModel leaves them out. In their `extras`, a loop has `loop` with
/// `vertex` (of the surface), `length`, `kind`, `angle` and `midpoint`; the contour of a tip has
/// `contour` with the number of the `tip`, from 0, and whether it is `closed`; what cuts no tip off
/// has `arc` with `length` and `jump`. With tips, the surface's `extras` have `tips`, of each its
/// `vertices`, `area`, `boundaryLength`, `apex`, `apexDistance` and `jump`, and `crossedEdges`.
///
/// Error: LIMIT_EXCEEDED where the file would pass 4 GB.
GIRTH_EXPORT Result<std::string> fieldGlb(const LoadedMesh& loaded,
                                          std::span<const VertexField> fields,
                                          std::optional<ColourRange> range = std::nullopt,
                                          const LinesOnSurface& lines = {});

/// The fields as a file of the format "csv", "json", "npy", "ply" or "glb": what the functions
/// above return. `file`: what JSON calls the model. `columns`: of CSV and JSON.
///
/// Errors: USAGE for another one, as of checkFields, and for several fields in NPY, which holds
/// one; LIMIT_EXCEEDED.
GIRTH_EXPORT Result<std::string> fieldFile(const LoadedMesh& loaded,
                                           std::span<const VertexField> fields,
                                           std::string_view format, std::string_view file,
                                           Columns columns = Columns::Fields);

}  // namespace girth::io
