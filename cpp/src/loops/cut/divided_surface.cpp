#include "loops/cut/divided_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "loops/cut/faces_of_points.h"
#include "mesh/face_shape.h"
#include "mesh/sides.h"
#include "mesh/vector.h"

namespace girth::loops {
namespace {

using Chain = std::vector<Index>;

std::uint64_t pairKey(Index a, Index b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

/// Points are on one line if the triangle between them has no more than this share of the face:
/// what rounding makes of a point inside a face on a straight curve.
constexpr double kOnLine = 1e-13;

/// Twice the area of a triangle by barycentric coordinates, as a share of twice the face's: exactly
/// 0 for three points of one side.
double turn(const Weights& a, const Weights& b, const Weights& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Error atPoint(std::size_t place, const std::string& what) {
  return makeError(ErrorCode::InvalidPoint, static_cast<std::int64_t>(place),
                   "point " + std::to_string(place) + " of the curve " + what);
}

/// Faces that are divided before cancelling is looked for again.
constexpr Index kFacesBetweenLooks = 4096;

class Divider {
 public:
  Divider(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
          const ExecutionContext& context)
      : mesh_(mesh), curves_(curves), context_(context) {
    for (const Vertex v : mesh.vertices()) points_.push_back(SurfacePoint::atVertex(v));
  }

  Result<DividedSurface> run() {
    for (const SurfaceCurve& curve : curves_) {
      if (auto error = gatherEdgePoints(curve)) return *std::move(error);
    }
    numberEdgePoints();
    for (const SurfaceCurve& curve : curves_) {
      if (auto error = addCurve(curve)) return *std::move(error);
    }
    DividedSurface result;
    for (const Face f : mesh_.faces()) {
      if (f % kFacesBetweenLooks == 0 && context_.cancelled()) return cutCancelled();
      if (auto error = divideFace(f, result)) return *std::move(error);
    }
    if (result.triangles.size() / 3 >= kNoIndex / 3) {
      return makeError(ErrorCode::LimitExceeded, -1, "cutting makes too many faces");
    }
    result.points = std::move(points_);
    findTwins(result);
    return result;
  }

 private:
  Halfedge edgeOf(Halfedge h) const { return loops::edgeOf(mesh_, h); }
  /// Share along edgeOf(h).
  double shareOf(const SurfacePoint& point) const {
    const Halfedge h = point.halfedge();
    return edgeOf(h) == h ? point.weights[1] : point.weights[0];
  }

  /// A point as it is cut at: the vertex that it is moved to, if it is near one, or else itself.
  SurfacePoint settled(SurfacePoint point) const {
    if (point.kind == SurfacePoint::Kind::InFace) {
      for (Index k = 0; k < 3; ++k) {
        if (point.weights[k] > kLeastCutShare) continue;
        const Index from = (k + 1) % 3, to = (k + 2) % 3;
        const double sum = point.weights[from] + point.weights[to];
        point = SurfacePoint::onHalfedge(SurfaceMesh::side(point.face(), from),
                                         point.weights[to] / sum);
        break;
      }
    }
    if (point.kind != SurfacePoint::Kind::OnEdge) return point;
    if (point.weights[1] <= kLeastCutShare) {
      return SurfacePoint::atVertex(mesh_.from(point.halfedge()));
    }
    if (point.weights[0] <= kLeastCutShare) {
      return SurfacePoint::atVertex(mesh_.to(point.halfedge()));
    }
    return point;
  }

  std::optional<Error> gatherEdgePoints(const SurfaceCurve& curve) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
      if (!isPointOf(mesh_, curve[i])) return atPoint(i, "is none of the surface");
      const SurfacePoint point = settled(curve[i]);
      if (point.kind == SurfacePoint::Kind::OnEdge) {
        onEdge_[edgeOf(point.halfedge())].emplace_back(shareOf(point), kNoIndex);
      }
    }
    return std::nullopt;
  }

  /// Gives the points of each edge numbers; those too near to each other get one.
  void numberEdgePoints() {
    for (const Halfedge h : mesh_.halfedges()) {
      const auto found = onEdge_.find(h);
      if (found == onEdge_.end()) continue;
      auto& all = found->second;
      std::sort(all.begin(), all.end());
      double last = -1;
      for (auto& [share, number] : all) {
        if (share - last > kLeastCutShare) {
          points_.push_back(SurfacePoint::onHalfedge(h, share));
          last = share;
        }
        number = static_cast<Index>(points_.size() - 1);
      }
    }
  }

  Index numberOf(const SurfacePoint& point) {
    switch (point.kind) {
      case SurfacePoint::Kind::AtVertex:
        return point.element;
      case SurfacePoint::Kind::OnEdge: {
        const auto& all = onEdge_.at(edgeOf(point.halfedge()));
        return std::lower_bound(all.begin(), all.end(), std::pair{shareOf(point), Index{0}})
            ->second;
      }
      case SurfacePoint::Kind::InFace:
        break;
    }
    // A point that is known already, as where a curve is given twice.
    auto& known = inFace_[point.element];
    for (const Index number : known) {
      if (points_[number].weights == point.weights) return number;
    }
    points_.push_back(point);
    known.push_back(static_cast<Index>(points_.size() - 1));
    return known.back();
  }

  /// The parts of an edge between two of its points become cuts.
  void cutAlongSide(Face face, Index a, Index b) {
    const auto nodes = rimOf(face);
    const std::size_t size = nodes.size();
    const auto at =
        static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), a) - nodes.begin());
    const auto to =
        static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), b) - nodes.begin());
    // Whichever way round has no corner between.
    for (const bool forwards : {true, false}) {
      std::vector<std::pair<Index, Index>> parts;
      for (std::size_t i = forwards ? at : to; i != (forwards ? to : at); i = (i + 1) % size) {
        const Index next = nodes[(i + 1) % size];
        parts.emplace_back(nodes[i], next);
        if (next < mesh_.vertexCount() && next != (forwards ? b : a)) parts.clear();
        if (parts.empty()) break;
      }
      for (const auto& [from, next] : parts) cuts_.insert(pairKey(from, next));
      if (!parts.empty()) return;
    }
  }

  std::optional<Error> addCurve(const SurfaceCurve& curve) {
    std::vector<SurfacePoint> points;
    std::vector<Index> numbers;
    std::vector<std::size_t> places;
    const bool isClosed = curve.size() > 2 && isSame(curve.front(), curve.back());
    for (std::size_t i = 0; i + (isClosed ? 1 : 0) < curve.size(); ++i) {
      const SurfacePoint point = settled(curve[i]);
      const Index number = numberOf(point);
      if (!numbers.empty() && numbers.back() == number) continue;
      points.push_back(point.kind == SurfacePoint::Kind::OnEdge ? points_[number] : point);
      numbers.push_back(number);
      places.push_back(i);
    }
    while (isClosed && numbers.size() > 1 && numbers.front() == numbers.back()) {
      points.pop_back();
      numbers.pop_back();
      places.pop_back();
    }
    const std::size_t size = numbers.size();
    if (size < 2) return std::nullopt;
    // Begun on an edge or at a vertex.
    std::size_t first = 0;
    while (first < size && points[first].kind == SurfacePoint::Kind::InFace) ++first;
    if (first == size ||
        (!isClosed && (first > 0 || points.back().kind == SurfacePoint::Kind::InFace))) {
      const Index face = first == size ? points[0].element : kNoIndex;
      return makeError(ErrorCode::InvalidOption, face == kNoIndex ? -1 : std::int64_t{face},
                       first == size ? "the curve lies inside face " + std::to_string(face)
                                     : "the curve ends inside a face");
    }
    Chain chain{numbers[first]};
    Face within = Face::none;
    for (std::size_t k = 1; k < size + (isClosed ? 1 : 0); ++k) {
      const std::size_t i = (first + k) % size, before = (first + k - 1) % size;
      const auto common = commonFace(mesh_, points[before], points[i]);
      if (!common || (within != Face::none && common->face != within)) {
        return atPoint(places[i], "lies in no face of the point before");
      }
      chain.push_back(numbers[i]);
      if (points[i].kind == SurfacePoint::Kind::InFace) {
        within = common->face;
        continue;
      }
      if (chain.size() == 2 && common->isAlongSide) {
        cutAlongSide(common->face, chain[0], chain[1]);
      } else {
        bool isNew = false;
        for (std::size_t c = 0; c + 1 < chain.size(); ++c) {
          isNew = cuts_.insert(pairKey(chain[c], chain[c + 1])).second || isNew;
        }
        if (isNew) chains_[common->face].push_back(chain);
      }
      chain.assign(1, numbers[i]);
      within = Face::none;
    }
    return std::nullopt;
  }

  static bool isSame(const SurfacePoint& a, const SurfacePoint& b) {
    return a.kind == b.kind && a.element == b.element && a.weights == b.weights;
  }

  /// The corners of a face and the points on its sides, counter-clockwise.
  Chain rimOf(Face face) const {
    Chain nodes;
    for (Index k = 0; k < 3; ++k) {
      const Halfedge side = SurfaceMesh::side(face, k);
      nodes.push_back(mesh_.from(side));
      const Halfedge edge = edgeOf(side);
      const auto found = onEdge_.find(edge);
      if (found == onEdge_.end()) continue;
      Chain along;
      for (const auto& [share, number] : found->second) {
        if (along.empty() || along.back() != number) along.push_back(number);
      }
      if (edge != side) std::reverse(along.begin(), along.end());
      nodes.insert(nodes.end(), along.begin(), along.end());
    }
    return nodes;
  }

  std::optional<Error> divideFace(Face face, DividedSurface& result) {
    const Chain rim = rimOf(face);
    const auto chains = chains_.find(face);
    if (rim.size() == 3 && chains == chains_.end()) {
      result.triangles.insert(result.triangles.end(), rim.begin(), rim.end());
      result.faces.push_back(face);
      return std::nullopt;
    }
    std::vector<Chain> polygons{rim};
    if (chains != chains_.end()) {
      for (const Chain& chain : chains->second) {
        if (!divide(face, chain, polygons)) {
          return makeError(ErrorCode::InvalidOption, face,
                           "curves cross each other in face " + std::to_string(face));
        }
      }
    }
    for (const Chain& polygon : polygons) {
      if (!triangulate(face, polygon, result)) {
        return makeError(ErrorCode::InvalidOption, face,
                         "curves cross each other in face " + std::to_string(face));
      }
    }
    return std::nullopt;
  }

  Weights weightsOf(Face face, Index number) const {
    return weightsIn(mesh_, face, points_[number]).value_or(Weights{});
  }

  /// Divides the polygon that a chain leads through. False where there is none.
  bool divide(Face face, const Chain& chain, std::vector<Chain>& polygons) const {
    for (std::size_t p = 0; p < polygons.size(); ++p) {
      const Chain& polygon = polygons[p];
      const auto from = std::find(polygon.begin(), polygon.end(), chain.front());
      const auto to = std::find(polygon.begin(), polygon.end(), chain.back());
      if (from == polygon.end() || to == polygon.end() || from == to) continue;
      const auto size = polygon.size();
      const auto i = static_cast<std::size_t>(from - polygon.begin());
      const auto j = static_cast<std::size_t>(to - polygon.begin());
      // The way is a side of the polygon already.
      if (chain.size() == 2 && ((i + 1) % size == j || (j + 1) % size == i)) return true;
      if (chain.size() > 2 && polygons.size() > 1 && !contains(face, polygon, chain[1])) continue;
      Chain one, other;
      for (std::size_t k = i;; k = (k + 1) % size) {
        one.push_back(polygon[k]);
        if (k == j) break;
      }
      one.insert(one.end(), chain.rbegin() + 1, chain.rend() - 1);
      for (std::size_t k = j;; k = (k + 1) % size) {
        other.push_back(polygon[k]);
        if (k == i) break;
      }
      other.insert(other.end(), chain.begin() + 1, chain.end() - 1);
      polygons[p] = std::move(one);
      polygons.push_back(std::move(other));
      return true;
    }
    return false;
  }

  /// Whether a point of a face lies in a polygon, by the crossings of a ray.
  bool contains(Face face, const Chain& polygon, Index point) const {
    const Weights p = weightsOf(face, point);
    bool inside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Weights a = weightsOf(face, polygon[i]);
      const Weights b = weightsOf(face, polygon[(i + 1) % polygon.size()]);
      if ((a[1] > p[1]) == (b[1] > p[1])) continue;
      const double at = a[2] + (p[1] - a[1]) / (b[1] - a[1]) * (b[2] - a[2]);
      if (p[2] < at) inside = !inside;
    }
    return inside;
  }

  /// Cuts ears off a polygon, the best shaped first. False where there is none.
  bool triangulate(Face face, Chain polygon, DividedSurface& result) const {
    while (polygon.size() >= 3) {
      const std::size_t size = polygon.size();
      std::vector<Weights> weights;
      for (const Index number : polygon) weights.push_back(weightsOf(face, number));
      std::size_t best = size;
      double bestShape = 0;
      for (std::size_t i = 0; i < size; ++i) {
        const std::size_t before = (i + size - 1) % size, after = (i + 1) % size;
        if (turn(weights[before], weights[i], weights[after]) <= kOnLine) continue;
        bool isEar = true;
        for (std::size_t k = 0; k < size && isEar; ++k) {
          if (k == i || k == before || k == after) continue;
          isEar = turn(weights[before], weights[i], weights[k]) < -kOnLine ||
                  turn(weights[i], weights[after], weights[k]) < -kOnLine ||
                  turn(weights[after], weights[before], weights[k]) < -kOnLine;
        }
        if (!isEar) continue;
        const FaceShape shape({positionOf(mesh_, points_[polygon[before]]),
                               positionOf(mesh_, points_[polygon[i]]),
                               positionOf(mesh_, points_[polygon[after]])});
        const double quality = shape.doubleArea / (shape.longest() * shape.longest());
        if (quality > bestShape) {
          bestShape = quality;
          best = i;
        }
      }
      if (best == size) return false;
      result.triangles.insert(result.triangles.end(), {polygon[(best + size - 1) % size],
                                                       polygon[best], polygon[(best + 1) % size]});
      result.faces.push_back(face);
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(best));
      if (polygon.size() < 3) break;
    }
    return true;
  }

  void findTwins(DividedSurface& result) const {
    result.twins.assign(result.triangles.size(), kNoIndex);
    result.isCut.assign(result.triangles.size(), false);
    const EdgeGroups groups(result.triangles, result.points.size());
    groups.forEach([&](const EdgeGroup& group) {
      const Index h = group[0];
      const bool isCut =
          cuts_.contains(pairKey(result.triangles[h], result.triangles[nextSide(h)]));
      for (std::size_t i = 0; i < group.size(); ++i) {
        if (group.size() == 2) result.twins[group[i]] = group[1 - i];
        result.isCut[group[i]] = isCut && group.size() == 2;
      }
    });
  }

  const SurfaceMesh& mesh_;
  std::span<const SurfaceCurve> curves_;
  const ExecutionContext& context_;
  std::vector<SurfacePoint> points_;
  /// Shares and numbers of the points on each edge (edgeOf), in rising order.
  std::unordered_map<Index, std::vector<std::pair<double, Index>>> onEdge_;
  /// Ways through each face from one point of its rim to another.
  std::unordered_map<Index, std::vector<Chain>> chains_;
  /// The points inside each face.
  std::unordered_map<Index, std::vector<Index>> inFace_;
  std::unordered_set<std::uint64_t> cuts_;
};

}  // namespace

Error cutCancelled() { return makeError(ErrorCode::Cancelled, -1, "cutting was cancelled"); }

Result<DividedSurface> divided(const SurfaceMesh& mesh, std::span<const SurfaceCurve> curves,
                               const ExecutionContext& context) {
  return Divider(mesh, curves, context).run();
}

std::vector<Index> partsOf(const DividedSurface& surface) {
  std::vector<Index> parts(surface.faces.size(), kNoIndex);
  Index count = 0;
  std::vector<Index> pending;
  for (Index seed = 0; seed < parts.size(); ++seed) {
    if (parts[seed] != kNoIndex) continue;
    parts[seed] = count;
    pending.assign(1, seed);
    while (!pending.empty()) {
      const Index triangle = pending.back();
      pending.pop_back();
      for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
        if (surface.isCut[h] || surface.twins[h] == kNoIndex) continue;
        const Index next = faceOfSide(surface.twins[h]);
        if (parts[next] != kNoIndex) continue;
        parts[next] = count;
        pending.push_back(next);
      }
    }
    ++count;
  }
  return parts;
}

}  // namespace girth::loops
