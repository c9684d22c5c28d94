// A field on a surface, as files call it: what all writers of fields take.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "girth/girth_field.h"

namespace girth::io {

/// Values at the vertices of a surface. Does not own them.
struct VertexField {
  /// What files call it: a small letter, then small letters, digits and underscores: "igf", "sdf".
  std::string name;
  /// One for each vertex of the surface; NaN where there is none.
  std::span<const double> values;
  /// "metre"; empty where the values have no unit, or nobody knows it.
  std::string unit;
  /// How it was computed, in a word: "exact"; may be empty.
  std::string method;
  /// Of the girth function: how each value came about, one for each vertex. Otherwise empty. At
  /// most one of the fields of a file has kinds.
  std::span<const LoopKind> kinds;

  bool has(Index vertex) const { return values[vertex] == values[vertex]; }
  /// Whether all vertices have a value.
  bool complete() const;
};

/// "exact", "naive" or "ms".
std::string_view toString(GirthMethod method);

/// The girth function as a field with the name "igf". Valid as long as `field`.
VertexField girthVertexField(const GirthField& field, GirthMethod method, std::string_view unit);

}  // namespace girth::io
