// Vertices without a place, as scanners write them where they have measured nothing.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "formats/polygon_soup.h"
#include "girth/error.h"

namespace girth::io {

/// Remembers vertices with a coordinate that is not a finite number: they do no harm unless a face
/// has them.
class LostVertices {
 public:
  /// Takes note of a vertex, if it is one. `place`: its line or byte.
  void look(std::span<const double, 3> position, std::size_t vertex, std::int64_t place) {
    for (const double coordinate : position) {
      if (std::isfinite(coordinate)) continue;
      places_.emplace_back(vertex, place);
      return;
    }
  }

  enum class Element : bool { Vertex, Place };
  /// The error of the first face that has one of them. `unit`: of places, "line" or "byte";
  /// `element`: which number the error has.
  std::optional<Error> inFaceOf(const PolygonSoup& faces, std::span<const double> positions,
                                const std::string& unit, Element element) const;

 private:
  std::vector<std::pair<std::size_t, std::int64_t>> places_;  ///< by vertex
};

}  // namespace girth::io
