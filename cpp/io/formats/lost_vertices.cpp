#include "formats/lost_vertices.h"

#include <algorithm>

namespace girth::io {

std::optional<Error> LostVertices::inFaceOf(const PolygonSoup& faces,
                                            std::span<const double> positions,
                                            const std::string& unit, Element element) const {
  if (places_.empty()) return std::nullopt;
  const auto found = faces.firstNowhere(positions);
  if (!found) return std::nullopt;
  const std::size_t vertex = found->vertex;
  const auto place =
      std::lower_bound(places_.begin(), places_.end(), vertex,
                       [](const auto& known, std::size_t wanted) { return known.first < wanted; });
  return makeError(ErrorCode::NonFinitePosition,
                   element == Element::Place ? place->second : static_cast<std::int64_t>(vertex),
                   unit + " " + std::to_string(place->second) + ": vertex " +
                       std::to_string(vertex) + " of face " + std::to_string(found->polygon) +
                       " has a coordinate that is not a finite number");
}

}  // namespace girth::io
