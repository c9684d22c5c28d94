// A field on a surface, as files call it: what all writers of fields take.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "girth/export.h"
#include "girth/fields.h"
#include "girth/geodesic_extent.h"
#include "girth/girth_field.h"
#include "girth/io/read_mesh.h"
#include "girth/refined_girth.h"
#include "girth/shape_diameter.h"
#include "girth/thickness.h"

namespace girth::io {

/// Values at the vertices of a surface. Does not own them.
struct GIRTH_EXPORT VertexField {
  /// Its name in files: a small letter, then letters, digits and underscores: "igf", "sdf".
  std::string name;
  /// One for each vertex of the surface; NaN where there is none.
  std::span<const double> values;
  /// "metre"; empty where the values have no unit, or it is not known.
  std::string unit;
  /// How it was computed, in a word: "exact"; may be empty.
  std::string method;
  /// Kinds of the girth's values, one for each vertex; empty for other fields. At
  /// most one of the fields of a file has kinds.
  std::span<const LoopKind> kinds;
  /// The name of the kinds in files.
  std::string kindName{"kind"};
  /// Where values are codes, what they mean: i is words[i]. Text has the words, binary files the
  /// codes.
  std::span<const std::string_view> words{};

  /// Whether a vertex has a value.
  bool has(Vertex vertex) const { return values[vertex] == values[vertex]; }
  /// Whether all vertices have a value.
  bool complete() const;
};

/// "exact" or "ms".
GIRTH_EXPORT std::string_view toString(GirthMethod method);

/// How the girth was computed, in words: "exact", "ms", or "exact, persistence 0.5", in the model's
/// unit.
GIRTH_EXPORT std::string methodText(const GirthOptions& options);
/// How distances were computed, in words: "exact" or "fast marching".
GIRTH_EXPORT std::string_view toString(DistanceMethod method);
/// How the shape diameter was computed, in words: "30 rays".
GIRTH_EXPORT std::string methodText(const ShapeDiameterOptions& options);
/// How the medial thickness was computed, in words: "sharp below 75 degrees".
GIRTH_EXPORT std::string methodText(const ThicknessOptions& options);

/// How a field of `fieldFunction` was computed, in words, as above; empty where there is none of
/// that name.
GIRTH_EXPORT std::string methodText(std::string_view field, const FieldOptions& options);

/// Whether files can hold the fields: USAGE where there is none, where one does not have a value
/// for each vertex (and a kind, if it has kinds at all), where names are not as above or come
/// twice, or where several have kinds.
GIRTH_EXPORT std::optional<Error> checkFields(const LoadedMesh& loaded,
                                              std::span<const VertexField> fields);

/// The girth function as a field with the name "igf". Valid as long as `field`, which must be kept
/// in a variable.
GIRTH_EXPORT VertexField girthVertexField(const GirthField& field, GirthMethod method,
                                          std::string_view unit);
/// The values must outlive the view of them.
VertexField girthVertexField(const GirthField&&, GirthMethod method,
                             std::string_view unit) = delete;

/// How sure the values of a refined girth are as a field with the name "state", with words. Valid
/// as long as `codes`, the numbers of a `GirthState` for each vertex.
GIRTH_EXPORT VertexField girthStateField(std::span<const double> codes, std::string_view method);

}  // namespace girth::io
