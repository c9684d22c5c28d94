#include "mesh/shifted_paths.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace girth {

namespace {

/// A vertex that is off by less than such a share of its edge is not off.
constexpr double kOff = 1e-12;

}  // namespace

ShiftedPaths::ShiftedPaths(const SurfaceMesh& surface, const LeanSurface& lean)
    : surface_(surface), lean_(lean.mesh) {
  for (const Vertex v : surface.vertices()) {
    const SurfacePoint& place = lean.places[v];
    if (place.kind != SurfacePoint::Kind::OnEdge) continue;
    const Halfedge side = place.halfedge();
    const Vec3 by = surface.position(v) - positionOf(lean_, place);
    if (norm(by) <= kOff * lean_.length(side)) continue;
    const auto [edge, t] = onEdge(place);
    shifts_.push_back({edge, t, by});
  }
  std::stable_sort(shifts_.begin(), shifts_.end(), [](const Shift& a, const Shift& b) {
    return std::tie(a.edge, a.t) < std::tie(b.edge, b.t);
  });
}

std::pair<Index, double> ShiftedPaths::onEdge(const SurfacePoint& point) const {
  const Halfedge own = point.halfedge(), twin = lean_.twin(own);
  const bool isOther = twin != Halfedge::none && twin < own;
  return {isOther ? Index(twin) : Index(own), point.weights[isOther ? 0 : 1]};
}

Vec3 ShiftedPaths::shiftAt(const SurfacePoint& point) const {
  if (point.kind != SurfacePoint::Kind::OnEdge) return {0, 0, 0};
  const auto [edge, t] = onEdge(point);
  // Between the vertices next to it on both sides; the ends of the edge are not shifted.
  const auto after = std::lower_bound(
      shifts_.begin(), shifts_.end(), std::make_tuple(edge, t),
      [](const Shift& shift, const auto& place) { return std::tie(shift.edge, shift.t) < place; });
  const bool hasAfter = after != shifts_.end() && after->edge == edge;
  const bool hasBefore = after != shifts_.begin() && std::prev(after)->edge == edge;
  const Shift end{edge, 1, {0, 0, 0}}, start{edge, 0, {0, 0, 0}};
  const Shift &one = hasBefore ? *std::prev(after) : start, &other = hasAfter ? *after : end;
  const double between = other.t - one.t, share = between > 0 ? (t - one.t) / between : 0;
  return one.by + share * (other.by - one.by);
}

double ShiftedPaths::excess(Vertex base, std::span<const SurfacePoint> points) const {
  double excess = 0;
  std::optional<Vec3> before, shiftedBefore;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 place = positionOf(lean_, points[i]);
    const bool isBase = i == 0 || i + 1 == points.size();
    const Vec3 shifted = isBase ? surface_.position(base) : place + shiftAt(points[i]);
    if (before) excess += norm(shifted - *shiftedBefore) - norm(place - *before);
    before = place;
    shiftedBefore = shifted;
  }
  return excess;
}

}  // namespace girth
