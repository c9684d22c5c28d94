#include "solver/refined/face_set.h"

#include <algorithm>

namespace girth {

using geodesic::Unfolding;

std::vector<Index> facesOf(const Unfolding& unfolding, const GirthLoop& loop) {
  std::vector<Index> faces;
  for (const SurfacePoint& numbered : loop.points) {
    const SurfacePoint point = unfolding.fromMesh(numbered);
    switch (point.kind) {
      case SurfacePoint::Kind::OnEdge: {
        const Index twin = unfolding.twin(point.element);
        faces.push_back(faceOfSide(point.element));
        if (twin != kNoIndex) faces.push_back(faceOfSide(twin));
        break;
      }
      case SurfacePoint::Kind::AtVertex:
        for (const Index h : unfolding.fan(point.element)) faces.push_back(faceOfSide(h));
        break;
      case SurfacePoint::Kind::InFace:
        faces.push_back(point.element);
        break;
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  faces.shrink_to_fit();
  return faces;
}

FaceSet::FaceSet(const Unfolding& unfolding)
    : unfolding_(&unfolding),
      isIn_(unfolding.halfedgeCount() / 3, 0),
      isSurrounded_(unfolding.vertexCount(), 0) {}

void FaceSet::clear() {
  for (const Index face : faces_) isIn_[face] = 0;
  faces_.clear();
  for (const Index vertex : surrounded_) isSurrounded_[vertex] = 0;
  surrounded_.clear();
  grown_ = 0;
}

void FaceSet::add(Index face) {
  if (isIn_[face] != 0) return;
  isIn_[face] = 1;
  faces_.push_back(face);
}

void FaceSet::add(std::span<const Index> faces) {
  for (const Index face : faces) add(face);
}

void FaceSet::addAround(Index vertex) {
  if (isSurrounded_[vertex] != 0) return;
  isSurrounded_[vertex] = 1;
  surrounded_.push_back(vertex);
  for (const Index h : unfolding_->fan(vertex)) add(faceOfSide(h));
}

void FaceSet::grow(int rings) {
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t end = faces_.size();
    for (; grown_ < end; ++grown_) {
      const Index first = 3 * faces_[grown_];
      for (Index h = first; h < first + 3; ++h) addAround(unfolding_->crossing(h).from());
    }
  }
}

bool FaceSet::hasAll(std::span<const Index> faces) const {
  return std::all_of(faces.begin(), faces.end(), [&](Index face) { return has(face); });
}

bool FaceSet::reachesRim(std::span<const Index> faces) const {
  return std::any_of(faces.begin(), faces.end(), [&](Index face) {
    for (Index h = 3 * face; h < 3 * face + 3; ++h) {
      const Index twin = unfolding_->twin(h);
      if (twin != kNoIndex && !has(faceOfSide(twin))) return true;
    }
    return false;
  });
}

}  // namespace girth
