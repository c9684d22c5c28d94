#include "loops/handles/handle_tubes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "girth/geodesic_solver.h"
#include "girth/girth_solver.h"
#include "girth/level_curves.h"
#include "infinity.h"
#include "mesh/neighbours.h"
#include "mesh/vector.h"
#include "no_value.h"

namespace girth::loops {
namespace {

/// Curves at equal distance are measured so often along one length of the loop.
constexpr int kCurvesPerLength = 32;

/// Within so many of them a curve doubles its length at an end of a tube.
constexpr int kCurvesOfAnEnd = 16;

/// At an end the girth has grown to so many times that of the tube near it: the second one where
/// ends of the first kind would meet.
constexpr std::array kGirthsOfAnEnd{1.25, 1.1};

/// The girth near an end is that which so large a share of the vertices there do not exceed.
constexpr double kQuantile = 0.25;

/// Below this share of the distance to its end a vertex is on the tube.
constexpr double kSurelyInside = 0.5;

/// The share of a triangle's area in which a linear function, given at the corners, is below 1.
double shareBelowOne(std::array<double, 3> values) {
  std::sort(values.begin(), values.end());
  const auto [least, middle, most] = values;
  if (most < 1) return 1;
  if (!(least < 1)) return 0;
  if (middle < 1) return 1 - (most - 1) * (most - 1) / ((most - least) * (most - middle));
  return (1 - least) * (1 - least) / ((middle - least) * (most - least));
}

using Rim = std::vector<Vertex>;

/// A surface cut along loops, and the two rims of each.
class CutLoops {
 public:
  CutLoops(const SurfaceMesh& mesh, std::span<const Handle> handles, CutSurface cut)
      : mesh_(mesh), cut_(std::move(cut)), rims_(handles.size()), solver_(cut_.mesh) {
    std::vector<std::size_t> owner(mesh.faceCount(), handles.size());
    for (std::size_t i = 0; i < handles.size(); ++i) {
      for (const Index f : facesAlong(mesh, handles[i].points)) owner[f] = i;
    }
    const SurfaceMesh& pieces = cut_.mesh;
    std::vector<bool> isSeen(pieces.vertexCount(), false);
    for (const Vertex start : pieces.vertices()) {
      if (!pieces.isBoundary(start) || isSeen[start]) continue;
      Rim rim;
      std::size_t of = handles.size();
      for (Vertex v = start; !isSeen[v]; v = pieces.to(pieces.outgoing(v))) {
        isSeen[v] = true;
        rim.push_back(v);
        of = std::min(of, owner[cut_.faces[SurfaceMesh::faceOf(pieces.outgoing(v))]]);
      }
      if (of < handles.size()) rims_[of].push_back(std::move(rim));
    }
  }

  /// The tube of a handle; nothing where it has none of at most an area. Error: CANCELLED.
  Result<std::optional<HandleTube>> tube(std::size_t handle, double length, double largestArea,
                                         const ExecutionContext& context) {
    const std::vector<Rim>& rims = rims_[handle];
    std::array<Side, 2> sides;
    if (rims.size() != sides.size()) return std::optional<HandleTube>();
    for (std::size_t i = 0; i < sides.size(); ++i) {
      auto side = sideAt(rims[i], length, largestArea, context);
      if (!side) return side.error();
      if (side.value().end == 0) return std::optional<HandleTube>();
      sides[i] = std::move(side).value();
    }
    return tubeBetween(sides, largestArea);
  }

 private:
  /// One side of a loop: distances from it, and the distance at which its tube ends.
  struct Side {
    std::vector<double> distances;
    double end{0};    // 0: there is none
    double girth{0};  // the length of curves round the tube near its end
  };

  /// The side of a rim. Error: CANCELLED.
  Result<Side> sideAt(const Rim& rim, double length, double largestArea,
                      const ExecutionContext& context) {
    std::vector<SurfacePoint> sources;
    for (const Vertex v : rim) sources.push_back(SurfacePoint::atVertex(v));
    for (double radius = 2 * length;; radius *= 2) {
      auto distances = solver_.distances(sources, radius, context);
      if (!distances && distances.error().code == ErrorCode::Cancelled) return distances.error();
      if (!distances) return Side{};  // beyond the budget
      const Reach reach = reachOf(distances.value());
      Side side = sideWithin(std::move(distances).value(), length, reach.complete);
      if (side.end > 0) return side;
      if (reach.area > largestArea || std::isinf(reach.complete)) return Side{};
    }
  }

  struct Reach {
    double area;      // the sum over faces with all corners reached
    double complete;  // curves at this distance and less run through no other face
  };

  Reach reachOf(const std::vector<double>& distances) const {
    Reach reach{0, kInfinity};
    for (const Face f : cut_.mesh.faces()) {
      double least = kInfinity, most = 0;
      for (const Vertex v : cut_.mesh.faceVertices(f)) {
        least = std::min(least, distances[v]);
        most = std::max(most, distances[v]);
      }
      if (!std::isinf(most)) {
        reach.area += cut_.mesh.area(f);
      } else if (!std::isinf(least)) {
        reach.complete = std::min(reach.complete, least);
      }
    }
    return reach;
  }

  /// The tube ends at the last curve before one that is twice as long as another one a little
  /// nearer to the loop; no curve beyond `farthest` is looked at.
  Side sideWithin(std::vector<double> distances, double length, double farthest) const {
    const double step = length / kCurvesPerLength;
    double reached = 0;
    for (const double d : distances) reached = std::isinf(d) ? reached : std::max(reached, d);
    const auto count = static_cast<std::size_t>(std::min(farthest, reached) / step);
    std::vector<double> lengths(count + 1, 0);
    for (const Face f : cut_.mesh.faces()) addCurvesIn(f, distances, step, lengths);
    lengths[0] = length;
    for (std::size_t k = 1; k <= count; ++k) {
      const double before = std::max(lengths[k > kCurvesOfAnEnd ? k - kCurvesOfAnEnd : 0], length);
      if (lengths[k] > 2 * before) {
        return {std::move(distances), static_cast<double>(k - 1) * step, before};
      }
    }
    return {};
  }

  /// Adds the pieces in a face of the curves at multiples of a distance.
  void addCurvesIn(Face f, const std::vector<double>& distances, double step,
                   std::vector<double>& lengths) const {
    std::array<Vertex, 3> corners = cut_.mesh.faceVertices(f);
    std::sort(corners.begin(), corners.end(),
              [&](Vertex a, Vertex b) { return distances[a] < distances[b]; });
    const auto [a, b, c] = corners;
    if (std::isinf(distances[c])) return;
    const auto at = [&](Vertex from, Vertex to, double distance) {
      const double share = (distance - distances[from]) / (distances[to] - distances[from]);
      const Vec3& start = cut_.mesh.position(from);
      return start + share * (cut_.mesh.position(to) - start);
    };
    for (auto k = static_cast<std::size_t>(distances[a] / step) + 1; k < lengths.size(); ++k) {
      const double distance = static_cast<double>(k) * step;
      if (distance >= distances[c]) break;
      const Vec3 side = distance < distances[b] ? at(a, b, distance) : at(b, c, distance);
      lengths[k] += norm(side - at(a, c, distance));
    }
  }

  /// The tube on both sides of a loop; nothing where it is none, or has more than an area.
  std::optional<HandleTube> tubeBetween(const std::array<Side, 2>& sides,
                                        double largestArea) const {
    // By vertex of the uncut surface: below 1 on the tube; and the side that it is near, if any.
    std::vector<double> shares(mesh_.vertexCount(), kInfinity);
    std::vector<const Side*> near(mesh_.vertexCount(), nullptr);
    bool sidesMeet = false;
    for (const Vertex v : cut_.mesh.vertices()) {
      int inside = 0;
      for (const Side& side : sides) {
        const double share = side.distances[v] / side.end;
        inside += share < 1 ? 1 : 0;
        const Vertex uncut = cut_.points[v].vertex();
        if (uncut == Vertex::none || share >= shares[uncut]) continue;
        shares[uncut] = share;
        near[uncut] = side.distances[v] < side.end + side.girth ? &side : nullptr;
      }
      sidesMeet = sidesMeet || inside > 1;
    }
    for (std::vector<double>& byGirth : sharesByGirth(shares, near)) {
      if (auto tube = cutOff(std::move(byGirth), largestArea)) return tube;
    }
    if (sidesMeet) return std::nullopt;
    return cutOff(std::move(shares), largestArea);
  }

  /// As a bent tube is shorter on one side than on the other, curves at equal distance meet its end
  /// at an angle. Its girth does not: beyond the end it grows by twice the way. `shares`: of the
  /// distance to the end. `near`: for vertices on the tube or near it the side. One result for each
  /// of kGirthsOfAnEnd; none where the vertices near the tube make no surface.
  std::vector<std::vector<double>> sharesByGirth(const std::vector<double>& shares,
                                                 const std::vector<const Side*>& near) const {
    std::vector<Index> numbers(mesh_.vertexCount(), kNoIndex);
    std::vector<Vertex> vertices;
    std::vector<double> positions;
    std::vector<Index> triangles;
    for (const Face f : mesh_.faces()) {
      const auto corners = mesh_.faceVertices(f);
      if (std::none_of(corners.begin(), corners.end(),
                       [&](Vertex v) { return near[v] != nullptr; })) {
        continue;
      }
      for (const Vertex v : corners) {
        if (numbers[v] == kNoIndex) {
          numbers[v] = static_cast<Index>(vertices.size());
          vertices.push_back(v);
          const Vec3& p = mesh_.position(v);
          positions.insert(positions.end(), {p.x, p.y, p.z});
        }
        triangles.push_back(numbers[v]);
      }
    }
    const auto patch = SurfaceMesh::fromArrays(positions, triangles, OpenEdges::Boundary);
    if (!patch) return {};
    std::vector<double> girths(vertices.size(), kNoValue);
    GirthSolver solver(patch.value());
    const auto girthAt = [&](Vertex v) {
      if (std::isnan(girths[v])) {
        const auto girth = solver.value(v);
        girths[v] = girth ? girth.value().length : kInfinity;
      }
      return girths[v];
    };
    std::map<const Side*, std::vector<double>> beforeEnd;
    for (const Vertex v : patch.value().vertices()) {
      const Side* side = near[vertices[v]];
      if (side == nullptr || shares[vertices[v]] >= 1) continue;
      if ((1 - shares[vertices[v]]) * side->end < side->girth / 2) {
        beforeEnd[side].push_back(girthAt(v));
      }
    }
    for (auto& [side, values] : beforeEnd) {
      std::sort(values.begin(), values.end());
      values = {values[static_cast<std::size_t>(kQuantile * static_cast<double>(values.size()))]};
    }
    std::vector<std::vector<double>> results;
    for (const double atEnd : kGirthsOfAnEnd) {
      std::vector<double>& result = results.emplace_back(mesh_.vertexCount(), kInfinity);
      std::vector<Vertex> pending;
      for (const Vertex v : patch.value().vertices()) {
        if (shares[vertices[v]] >= kSurelyInside) continue;
        result[vertices[v]] = 0;
        pending.push_back(v);
      }
      for (std::size_t i = 0; i < pending.size(); ++i) {
        forEachNeighbour(patch.value(), pending[i], [&](Vertex v) {
          double& share = result[vertices[v]];
          const auto before = beforeEnd.find(near[vertices[v]]);
          if (!std::isinf(share) || before == beforeEnd.end()) return;
          share = std::min(girthAt(v) / (atEnd * before->second.front()), 2.0);
          if (share < 1) pending.push_back(v);
        });
      }
    }
    return results;
  }

  /// The tube of the vertices whose share is below 1, and what it encloses.
  std::optional<HandleTube> cutOff(std::vector<double> shares, double largestArea) const {
    const auto inside = std::find_if(shares.begin(), shares.end(), [](double s) { return s < 1; });
    if (inside == shares.end()) return std::nullopt;
    HandleTube tube;
    tube.inside = Vertex(static_cast<Index>(inside - shares.begin()));
    takeEnclosed(shares, mesh_.componentOf(tube.inside));
    for (double& share : shares) share = std::min(share, 2.0);
    double area = 0;
    for (const Face f : mesh_.faces()) {
      const auto corners = mesh_.faceVertices(f);
      const auto isInside = [&](Vertex v) { return shares[v] < 1; };
      if (std::none_of(corners.begin(), corners.end(), isInside)) continue;
      if (std::any_of(corners.begin(), corners.end(),
                      [&](Vertex v) { return isInside(v) && mesh_.isBoundary(v); })) {
        return std::nullopt;
      }
      tube.faces.insert(f);
      area += mesh_.area(f) *
              shareBelowOne({shares[corners[0]], shares[corners[1]], shares[corners[2]]});
    }
    if (area > largestArea) return std::nullopt;
    auto curves = levelCurves(mesh_, shares, 1);
    if (!curves || curves.value().size() != tube.ends.size()) return std::nullopt;
    std::move(curves.value().begin(), curves.value().end(), tube.ends.begin());
    return tube;
  }

  /// Connected pieces outside become inside, but for the largest.
  void takeEnclosed(std::vector<double>& shares, Index component) const {
    std::vector<std::vector<Vertex>> outside;
    std::vector<bool> isSeen(mesh_.vertexCount(), false);
    for (const Vertex seed : mesh_.vertices()) {
      if (isSeen[seed] || shares[seed] < 1 || mesh_.componentOf(seed) != component) continue;
      isSeen[seed] = true;
      std::vector<Vertex> piece{seed};
      for (std::size_t i = 0; i < piece.size(); ++i) {
        forEachNeighbour(mesh_, piece[i], [&](Vertex v) {
          if (isSeen[v] || shares[v] < 1) return;
          isSeen[v] = true;
          piece.push_back(v);
        });
      }
      outside.push_back(std::move(piece));
    }
    const auto largest =
        std::max_element(outside.begin(), outside.end(),
                         [](const auto& a, const auto& b) { return a.size() < b.size(); });
    for (auto piece = outside.begin(); piece != outside.end(); ++piece) {
      if (piece == largest) continue;
      for (const Vertex v : *piece) shares[v] = 0;
    }
  }

  const SurfaceMesh& mesh_;
  CutSurface cut_;
  std::vector<std::vector<Rim>> rims_;  // by handle
  GeodesicSolver solver_;
};

bool areApart(const std::set<Index>& a, const std::set<Index>& b) {
  return std::none_of(a.begin(), a.end(), [&](Index f) { return b.count(f) > 0; });
}

}  // namespace

std::set<Index> facesAlong(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points) {
  std::set<Index> faces;
  const auto addAround = [&](Vertex vertex) {
    forEachEdge(mesh, vertex, [&](Halfedge h, Vertex) { faces.insert(SurfaceMesh::faceOf(h)); });
  };
  for (const SurfacePoint& point : points) {
    if (point.kind == SurfacePoint::Kind::InFace) {
      faces.insert(point.element);
    } else if (point.kind == SurfacePoint::Kind::AtVertex) {
      addAround(point.vertex());
    } else {
      addAround(mesh.from(point.halfedge()));
      addAround(mesh.to(point.halfedge()));
    }
  }
  return faces;
}

Result<std::vector<std::optional<HandleTube>>> findHandleTubes(const SurfaceMesh& mesh,
                                                               std::span<const Handle> handles,
                                                               const ExecutionContext& context) {
  std::vector<std::optional<HandleTube>> tubes(handles.size());
  if (handles.empty()) return tubes;
  std::vector<SurfaceCurve> loops;
  std::set<Index> alongLoops;
  for (const Handle& handle : handles) {
    loops.push_back(handle.points);
    alongLoops.merge(facesAlong(mesh, handle.points));
  }
  std::vector<double> areas(mesh.componentCount(), 0);
  for (const Face f : mesh.faces())
    areas[mesh.componentOf(mesh.faceVertices(f)[0])] += mesh.area(f);
  const ExecutionContext alone{1, context.cancel, {}};
  auto cut = cutSurface(mesh, loops, {}, alone);
  if (!cut) return cut.error();
  CutLoops cutLoops(mesh, handles, std::move(cut).value());
  std::set<Index> taken;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const Handle& handle = handles[i];
    auto found = cutLoops.tube(i, handle.length, kLargestTube * areas[handle.component], alone);
    if (!found) return found.error();
    std::optional<HandleTube>& tube = found.value();
    if (!tube) continue;
    std::set<Index> others = alongLoops;
    for (const Index f : facesAlong(mesh, handle.points)) others.erase(f);
    if (!areApart(tube->faces, others) || !areApart(tube->faces, taken)) continue;
    taken.insert(tube->faces.begin(), tube->faces.end());
    tubes[i] = std::move(tube);
  }
  return tubes;
}

}  // namespace girth::loops
