// The faces on their way from a soup to a surface.
#pragma once

#include <span>
#include <vector>

#include "girth/prepare_surface.h"
#include "mesh/face_shape.h"

namespace girth::prepare {

/// Triangles over the vertices of the input, and where each comes from.
struct WorkingFaces {
  std::span<const double> positions;
  std::vector<Index> triangles;
  std::vector<Index> inputOfFace;
  /// For each vertex the first one at its position, and whether the file's own numbers close the
  /// surface round it (closedByTheFile); both empty where vertices at one place are one.
  std::vector<Index> place;
  std::vector<bool> closedByFile;
  /// Brings coordinates to a scale near 1.
  double scale{1};

  Index faceCount() const { return static_cast<Index>(inputOfFace.size()); }
  std::size_t vertexCount() const { return positions.size() / 3; }
  /// The places of the corners: edges at one place may have different vertices.
  std::vector<Index> cornerPlaces() const {
    std::vector<Index> places = triangles;
    if (!place.empty()) {
      for (Index& v : places) v = place[v];
    }
    return places;
  }
  Vec3 scaledPosition(Index vertex) const {
    const double* p = &positions[3 * std::size_t{vertex}];
    return {scale * p[0], scale * p[1], scale * p[2]};
  }
  FaceShape shape(Index face) const {
    const Index* corner = &triangles[3 * std::size_t{face}];
    return FaceShape(
        {scaledPosition(corner[0]), scaledPosition(corner[1]), scaledPosition(corner[2])});
  }

  /// Keeps the faces for which `keep` is true, in their order.
  template <class Keep>
  void filter(Keep&& keep) {
    Index kept = 0;
    for (Index f = 0; f < faceCount(); ++f) {
      if (!keep(f)) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        triangles[3 * std::size_t{kept} + k] = triangles[3 * std::size_t{f} + k];
      }
      inputOfFace[kept++] = inputOfFace[f];
    }
    triangles.resize(3 * std::size_t{kept});
    inputOfFace.resize(kept);
  }
};

}  // namespace girth::prepare
