// A field of values as a file's content: CSV, JSON or PLY.
#pragma once

#include <string>
#include <string_view>

#include "girth/girth_field.h"
#include "girth/io/read_mesh.h"

namespace girth::io {

/// What JSON says about the values beside the values.
struct FieldOrigin {
  /// The model's name.
  std::string_view file;
  GirthMethod method{GirthMethod::Exact};
};

/// "exact" or "naive".
std::string_view toString(GirthMethod method);

/// `vertex,igf,kind` and one row for every vertex of the file, in its order, counted from 0.
/// Vertices that were welded share a value; where no face uses a vertex, or it was not computed,
/// igf and kind are empty. Numbers read back as the same doubles (formatNumber); lines end with
/// "\n".
std::string fieldCsv(const LoadedMesh& loaded, const GirthField& field);

/// The same as one JSON object: `file`, `method`, `unit` ("" where the file does not say),
/// `complete`, `vertices`, and the arrays `igf` and `kind`, with null where the CSV is empty.
std::string fieldJson(const LoadedMesh& loaded, const GirthField& field, const FieldOrigin& origin);

/// The surface as binary little-endian PLY: for every vertex of the surface (not of the file) x, y,
/// z and `igf` as doubles and `kind` as a byte (0 loop, 1 antipodal, 255 not computed, where igf is
/// NaN); then the faces.
std::string fieldPly(const LoadedMesh& loaded, const GirthField& field);

}  // namespace girth::io
