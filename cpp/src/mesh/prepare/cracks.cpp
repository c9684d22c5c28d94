#include "mesh/prepare/cracks.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "infinity.h"
#include "mesh/edge_groups.h"
#include "mesh/nearest_point.h"
#include "mesh/prepare/drop_faces.h"
#include "mesh/prepare/roots.h"
#include "mesh/prepare/weld_vertices.h"
#include "mesh/sides.h"

namespace girth::prepare {

namespace {

/// Rounding displaces vertices by less than this share of the extent: the sixth digit of a text.
constexpr double kCrack = 1e-5;
/// Vertices farther away than this share of an edge make no crack along it.
constexpr double kCrackOfEdge = 0.1;

class CrackSearch {
 public:
  CrackSearch(std::span<const double> positions, std::span<const Index> triangles, double scale)
      : positions_(positions), triangles_(triangles), scale_(scale) {
    EdgeGroups(triangles, positions.size() / 3).forEach([&](const EdgeGroup& edge) {
      if (edge.size() == 1) openEdges_.push_back(edge[0]);
    });
    std::sort(openEdges_.begin(), openEdges_.end());
  }

  Cracks run(double distance) {
    Cracks cracks;
    if (openEdges_.empty()) return cracks;
    std::vector<Index> ends;
    for (const Index h : openEdges_) ends.insert(ends.end(), {from(h), to(h)});
    std::vector<Index> first = firstAtSamePlace(positions_, ends);
    findReach(distance);
    joinWithin(distance > 0 ? distance : greatest_ / scale_, positions_, first);
    for (Index v = 0; v < first.size(); ++v) {
      if (first[v] == kNoIndex || first[v] == v) continue;
      const double away = norm(at(v) - at(first[v]));
      if (away > 0 && away <= std::min(reach_[v], reach_[first[v]])) {
        cracks.nearVertices.push_back({v, first[v], away / scale_});
      }
    }
    findOnEdges(first, cracks);
    return cracks;
  }

 private:
  Index from(Index h) const { return triangles_[h]; }
  Index to(Index h) const { return triangles_[nextSide(h)]; }
  Vec3 at(Index v) const {
    const double* p = &positions_[3 * std::size_t{v}];
    return {scale_ * p[0], scale_ * p[1], scale_ * p[2]};
  }

  /// How wide a crack can be at each vertex.
  void findReach(double distance) {
    reach_.assign(positions_.size() / 3, scale_ * distance);
    if (distance > 0) return;
    Vec3 low = at(triangles_[0]), high = low;
    for (const Index v : triangles_) {
      const Vec3 p = at(v);
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    greatest_ = kCrack * norm(high - low);
    std::fill(reach_.begin(), reach_.end(), greatest_);
    for (const Index h : openEdges_) {
      const double most = kCrackOfEdge * norm(at(to(h)) - at(from(h)));
      for (const Index v : {from(h), to(h)}) reach_[v] = std::min(reach_[v], most);
    }
  }

  void findOnEdges(const std::vector<Index>& first, Cracks& cracks) const {
    std::vector<std::array<Vec3, 3>> segments;
    segments.reserve(openEdges_.size());
    for (const Index h : openEdges_) segments.push_back({at(from(h)), at(to(h)), at(to(h))});
    const NearestSearch search(std::move(segments));
    for (Index v = 0; v < first.size(); ++v) {
      if (first[v] == kNoIndex) continue;
      const Vec3 p = at(v);
      double nearest = reach_[v];
      Index edge = kNoIndex;
      double along = 0;
      search.search(
          [&](Index, const NearestSearch::Box& box) {
            const double away = box.squaredDistance(p);
            return away <= nearest * nearest ? away : kInfinity;
          },
          [&](Index i) {
            const Index h = openEdges_[i];
            const auto& ends = search.triangle(i);
            if (norm(ends[0] - p) <= reach_[v] || norm(ends[1] - p) <= reach_[v] ||
                triangles_[previousSide(h)] == v) {
              return;
            }
            const TrianglePoint found = nearestInTriangle(p, ends);
            const double away = norm(found.position - p);
            if (!(away <= nearest) || (away == nearest && edge != kNoIndex && edge < h)) return;
            if (!(found.weights[0] > 0 && found.weights[0] < 1)) return;
            nearest = away;
            edge = h;
            along = 1 - found.weights[0];
          });
      if (edge != kNoIndex) cracks.onEdges.push_back({v, edge, along, nearest / scale_});
    }
  }

  std::span<const double> positions_;
  std::span<const Index> triangles_;
  double scale_;
  std::vector<Index> openEdges_;
  std::vector<double> reach_;  ///< for each vertex, scaled
  double greatest_{0};
};

/// Divides one edge of each face, at all vertices that lie within it. Returns whether there were
/// any.
bool divideFaces(WorkingFaces& faces, double distance, PreparationReport& report) {
  Cracks cracks = findCracks(faces.positions, faces.triangles, faces.scale, distance);
  std::vector<Cracks::OnEdge>& points = cracks.onEdges;
  if (points.empty()) return false;
  std::sort(points.begin(), points.end(), [](const Cracks::OnEdge& a, const Cracks::OnEdge& b) {
    if (a.halfedge != b.halfedge) return a.halfedge < b.halfedge;
    return a.along != b.along ? a.along < b.along : a.vertex < b.vertex;
  });
  WorkingFaces divided;
  auto point = points.begin();
  for (Index f = 0; f < faces.faceCount(); ++f) {
    const bool isDivided = point != points.end() && point->halfedge / 3 == f;
    const Index h = isDivided ? point->halfedge : 3 * f;
    Index begin = faces.triangles[h];
    const Index end = faces.triangles[nextSide(h)], apex = faces.triangles[previousSide(h)];
    const auto add = [&](Index v) {
      divided.triangles.insert(divided.triangles.end(), {begin, v, apex});
      divided.inputOfFace.push_back(faces.inputOfFace[f]);
      begin = v;
    };
    for (; point != points.end() && point->halfedge / 3 == f; ++point) {
      if (point->halfedge != h) continue;
      add(point->vertex);
      ++report.addedFaces;
    }
    if (isDivided) {
      add(end);
    } else {
      divided.triangles.insert(divided.triangles.end(), {begin, end, apex});
      divided.inputOfFace.push_back(faces.inputOfFace[f]);
    }
  }
  faces.triangles = std::move(divided.triangles);
  faces.inputOfFace = std::move(divided.inputOfFace);
  return true;
}

}  // namespace

double Cracks::width(double scale) const {
  if (nearVertices.empty() && onEdges.empty()) return 0;
  // A vertex may lie exactly on an edge: then any distance will do that is above rounding.
  double width = onEdges.empty() ? 0 : 1e-12 / scale;
  for (const NearVertex& near : nearVertices) width = std::max(width, near.distance);
  for (const OnEdge& on : onEdges) width = std::max(width, on.distance);
  // Multiplied and divided by whole numbers only, so that it is the nearest double to its digits.
  double factor = 1;
  while (width * factor < 10) factor *= 10;
  double unit = 1;
  while (width / unit >= 100) unit *= 10;
  return std::ceil(width * factor / unit) / factor * unit;
}

Cracks findCracks(std::span<const double> positions, std::span<const Index> triangles, double scale,
                  double distance) {
  return CrackSearch(positions, triangles, scale).run(distance);
}

void sewCracks(WorkingFaces& faces, std::vector<Index>& first, const PrepareOptions& options,
               PreparationReport& report) {
  if (faces.faceCount() == 0) return;
  if (options.closeHoles) {
    const Cracks cracks = findCracks(faces.positions, faces.triangles, faces.scale, 0);
    for (const Cracks::NearVertex& near : cracks.nearVertices) {
      unite(first, near.vertex, near.earlier);
      ++report.weldedVertices;
    }
    for (Index& v : faces.triangles) v = rootOf(first, v);
    dropCollapsedFaces(faces, first, report);
  }
  // A face may have points within three edges, and a point may lie within several.
  constexpr int kMostRounds = 16;
  const auto divide = [&](double distance) {
    for (int round = 0; round < kMostRounds && divideFaces(faces, distance, report);) ++round;
  };
  if (options.weldDistance > 0) divide(options.weldDistance);
  if (options.closeHoles) divide(0);
}

}  // namespace girth::prepare
