#include "solver/refined/refined_bases.h"

#include <algorithm>

namespace girth {

std::vector<Index> RefinedBases::ofVertices() const {
  std::vector<Index> result(vertices.size());
  for (Index base = 0; base < vertices.size(); ++base) result[vertices[base]] = base;
  return result;
}

RefinedBases basesOn(const geodesic::Unfolding& ground, const LeanSurface* lean) {
  RefinedBases bases;
  bases.onGround = ground.vertexCount();
  const Index count = lean != nullptr ? static_cast<Index>(lean->places.size()) : bases.onGround;
  bases.vertices.resize(count);
  bases.places.resize(count);
  std::vector<Index> flat;
  for (Index v = 0; v < count; ++v) {
    const SurfacePoint place =
        lean != nullptr ? lean->places[v] : SurfacePoint::atVertex(Vertex(v));
    if (place.kind != SurfacePoint::Kind::AtVertex) {
      flat.push_back(v);
      continue;
    }
    const Index base = ground.fromMesh(place).element;
    bases.vertices[base] = v;
    bases.places[base] = place;
  }
  // Bases that are near on the surface are near in memory.
  const auto faceOf = [&](Index v) {
    return faceOfSide(ground.home(ground.fromMesh(lean->places[v])));
  };
  std::stable_sort(flat.begin(), flat.end(),
                   [&](Index a, Index b) { return faceOf(a) < faceOf(b); });
  for (Index i = 0; i < flat.size(); ++i) {
    bases.vertices[bases.onGround + i] = flat[i];
    bases.places[bases.onGround + i] = lean->places[flat[i]];
  }
  return bases;
}

}  // namespace girth
