// The faces of a file while it is read: polygons first, triangles once all vertices are known.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "girth/surface_mesh.h"

namespace girth::io {

/// Collects polygons corner by corner. Costs 4 bytes a corner, and 4 a polygon from the first one
/// on that is no triangle.
class PolygonSoup {
 public:
  /// A corner of the polygon that is being collected. `vertex` is below kNoIndex; it may come later
  /// in the file than the `known` vertices so far. `place`: whatever the reader wants to get back
  /// again by firstOutside, such as the line.
  void addCorner(Index vertex, std::size_t known, std::int64_t place) {
    if (vertex >= known && (ahead_.empty() || vertex > ahead_.back().vertex)) {
      ahead_.push_back({vertex, place});
    }
    corners_.push_back(vertex);
  }
  /// Sets the attribute's number of the corner that was added last; kNoIndex until then.
  void setValue(Index value) {
    values_.resize(corners_.size(), kNoIndex);
    values_.back() = value;
  }
  /// Ends the polygon. One of fewer than three corners is left out; then it returns false.
  bool endPolygon();
  /// Adds a polygon of three corners as a whole.
  void addTriangle(Index a, Index b, Index c, std::size_t known, std::int64_t place) {
    for (const Index vertex : {a, b, c}) addCorner(vertex, known, place);
    endPolygon();
  }

  /// A corner that names a vertex, and the place where it does.
  struct Corner {
    Index vertex;
    std::int64_t place;
  };
  /// The first corner that names a vertex beyond the `vertices` there are.
  std::optional<Corner> firstOutside(std::size_t vertices) const;

  std::size_t polygonCount() const { return polygons_; }

  /// A polygon, by its number in the file, and a vertex that it has.
  struct Use {
    Index vertex;
    std::size_t polygon;
  };
  /// The first polygon with a vertex that has a coordinate which is not a finite number.
  /// `positions` holds all vertices that are named.
  std::optional<Use> firstNowhere(std::span<const double> positions) const;

  /// Adds a note on the polygons that were left out, if any were.
  void noteLeftOut(std::vector<std::string>& notes) const;

  /// The triangles, in the polygons' order (PolygonCutter); leaves nothing here. `positions` holds
  /// all vertices that are named. Nothing where cutting would take unreasonably long.
  std::optional<std::vector<Index>> takeTriangles(std::span<const double> positions);

  /// After takeTriangles, for each corner of the triangles the number that was set, or kNoIndex.
  /// Empty where none was.
  std::vector<Index> takeValues() { return std::exchange(values_, {}); }

 private:
  std::vector<Index> corners_;
  std::vector<Index> values_;  ///< values by corner; empty, or short, as long as none was set
  std::vector<Index> sizes_;   ///< corners of each polygon; empty as long as all are triangles
  std::size_t polygons_{0};
  std::size_t begin_{0};              ///< first corner of the polygon that is being collected
  std::vector<std::size_t> leftOut_;  ///< for each that is, the polygons before it
  /// Corners ahead of their vertices, each naming a later one than all before it: the first that
  /// lies outside is among them however many vertices there are in the end.
  std::vector<Corner> ahead_;
};

}  // namespace girth::io
