// Sets of faces round loops. Searches for loops may be confined to such a set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geodesic/unfolding.h"
#include "girth/girth_solver.h"

namespace girth {

/// The faces of the unfolding that a loop runs through, and all faces round vertices that it
/// passes, in rising order.
std::vector<Index> facesOf(const geodesic::Unfolding& unfolding, const GirthLoop& loop);

/// A set of faces of an unfolding. Emptied in proportion to what is in it.
class FaceSet {
 public:
  explicit FaceSet(const geodesic::Unfolding& unfolding);

  void clear();
  void add(Index face);
  void add(std::span<const Index> faces);
  /// The faces round a vertex.
  void addAround(Index vertex);
  /// So many times all faces that share a vertex with one of the set.
  void grow(int rings);
  std::size_t size() const { return faces_.size(); }
  bool has(Index face) const { return isIn_[face] != 0; }
  bool hasAll(std::span<const Index> faces) const;
  /// Whether one of some faces has a neighbour outside.
  bool reachesRim(std::span<const Index> faces) const;
  /// One byte for each face of the unfolding: 1 where the face is in the set.
  const std::uint8_t* data() const { return isIn_.data(); }

 private:
  const geodesic::Unfolding* unfolding_;
  std::vector<std::uint8_t> isIn_;
  std::vector<Index> faces_;
  std::size_t grown_{0};  // faces whose neighbours are in the set
  std::vector<std::uint8_t> isSurrounded_;
  std::vector<Index> surrounded_;  // vertices of which all faces are in the set
};

}  // namespace girth
