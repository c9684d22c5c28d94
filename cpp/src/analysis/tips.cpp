#include "girth/tips.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <string>
#include <utility>

#include "analysis/contour.h"
#include "girth/geodesic_solver.h"
#include "mesh/neighbours.h"

namespace girth {

namespace {

/// Steps from piece to piece in all, and vertices in all regions, beyond which the values cannot be
/// those of a girth: they jump at nearly every edge.
constexpr std::size_t kMostWork = 100'000'000;

double medianOf(std::vector<double> values) {
  const std::size_t n = values.size();
  std::sort(values.begin(), values.end());
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

/// What is left of the surface without the edges that the contour crosses.
class Pieces {
 public:
  Pieces(const SurfaceMesh& mesh, std::span<const double> girth)
      : mesh_(mesh),
        girth_(girth),
        crossed_(mesh.halfedgeCount(), false),
        pieceOf_(mesh.vertexCount(), kNoIndex) {
    for (Index h = 0; h < mesh.halfedgeCount(); ++h) {
      const double jump = std::fabs(girth[mesh.from(h)] - girth[mesh.to(h)]);
      crossed_[h] = jump > 2 * mesh.length(h);  // not where a value is NaN
      const Index twin = mesh.twin(h);
      if (crossed_[h] && (twin == kNoIndex || h < twin)) edges_.push_back(h);
    }
    flood();
    for (const Index h : edges_) {
      Index a = pieceOf_[mesh.from(h)], b = pieceOf_[mesh.to(h)];
      if (a == b) {
        within_.push_back(h);
        continue;
      }
      const double rise = girth[mesh.from(h)] - girth[mesh.to(h)];
      between_[std::minmax(a, b)].push_back(a < b ? rise : -rise);
    }
    neighbours_.resize(vertices_.size());
    for (const auto& [pair, rises] : between_) {
      neighbours_[pair.first].push_back(pair.second);
      neighbours_[pair.second].push_back(pair.first);
    }
  }

  const std::vector<bool>& crossed() const { return crossed_; }
  const std::vector<Index>& edges() const { return edges_; }
  /// Crossed edges that begin and end in the same piece.
  const std::vector<Index>& within() const { return within_; }
  Index pieceOf(Index vertex) const { return pieceOf_[vertex]; }
  const std::vector<Index>& vertices(Index piece) const { return vertices_[piece]; }

  /// Regions that some contour cuts off, as sets of pieces. Nothing where the work is too much.
  std::optional<std::set<std::vector<Index>>> regions() const {
    std::set<std::vector<Index>> found;
    std::vector<Index> stamp(vertices_.size(), kNoIndex);
    Index run = 0;
    std::size_t work = 0;
    for (const auto& [pair, rises] : between_) {
      const bool firstIsInside = medianOf(rises) > 0;
      const Index inside = firstIsInside ? pair.first : pair.second;
      const Index outside = firstIsInside ? pair.second : pair.first;
      std::vector<Index> region{inside};
      stamp[inside] = run;
      for (std::size_t i = 0; i < region.size(); ++i) {
        for (const Index next : neighbours_[region[i]]) {
          if (++work > kMostWork) return std::nullopt;
          if (next == outside || stamp[next] == run) continue;
          const double toInside = std::fabs(level_[next] - level_[inside]);
          const double toOutside = std::fabs(level_[next] - level_[outside]);
          if (!(toInside <= toOutside)) continue;
          stamp[next] = run;
          region.push_back(next);
        }
      }
      ++run;
      std::sort(region.begin(), region.end());
      if (found.insert(region).second) {
        for (const Index piece : region) work += vertices_[piece].size();
      }
    }
    return found;
  }

 private:
  void flood() {
    for (Index seed = 0; seed < mesh_.vertexCount(); ++seed) {
      if (pieceOf_[seed] != kNoIndex) continue;
      const auto piece = static_cast<Index>(vertices_.size());
      std::vector<Index> members{seed};
      pieceOf_[seed] = piece;
      const auto reach = [&](Index vertex) {
        if (pieceOf_[vertex] != kNoIndex) return;
        pieceOf_[vertex] = piece;
        members.push_back(vertex);
      };
      for (std::size_t i = 0; i < members.size(); ++i) {
        forEachEdge(mesh_, members[i], [&](Index h, Index neighbour) {
          if (!crossed_[h]) reach(neighbour);
        });
      }
      std::vector<double> values;
      for (const Index v : members) {
        if (!std::isnan(girth_[v])) values.push_back(girth_[v]);
      }
      level_.push_back(values.empty() ? 0 : medianOf(std::move(values)));
      vertices_.push_back(std::move(members));
    }
  }

  const SurfaceMesh& mesh_;
  std::span<const double> girth_;
  std::vector<bool> crossed_;
  std::vector<Index> edges_, within_, pieceOf_;
  std::vector<std::vector<Index>> vertices_;
  std::vector<double> level_;  // the median girth of a piece
  /// For two pieces that meet, by how much the girth of the first is larger, edge by edge.
  std::map<std::pair<Index, Index>, std::vector<double>> between_;
  std::vector<std::vector<Index>> neighbours_;
};

/// Measures regions; keeps its memory.
class TipMaker {
 public:
  TipMaker(const SurfaceMesh& mesh, std::span<const double> girth)
      : mesh_(mesh),
        girth_(girth),
        solver_(mesh),
        inside_(mesh.vertexCount(), false),
        crossed_(mesh.halfedgeCount(), false) {}

  Result<Tip> make(const Pieces& pieces, const std::vector<Index>& region,
                   const ExecutionContext& context) {
    Tip tip;
    for (const Index piece : region) {
      const auto& members = pieces.vertices(piece);
      tip.vertices.insert(tip.vertices.end(), members.begin(), members.end());
    }
    std::sort(tip.vertices.begin(), tip.vertices.end());
    for (const Index v : tip.vertices) inside_[v] = true;

    std::vector<Index> rim;  // halfedges with one end inside
    std::vector<double> rises;
    for (const Index v : tip.vertices) {
      forEachEdge(mesh_, v, [&](Index h, Index neighbour) {
        if (!inside_[neighbour]) cross(h, neighbour, v, rim, rises);
        if (mesh_.from(h) == v) tip.area += share(h) * mesh_.area(SurfaceMesh::faceOf(h));
      });
    }
    tip.contour = contourLines(mesh_, rim, crossed_);
    for (const ContourLine& line : tip.contour) tip.boundaryLength += lengthOf(mesh_, line);
    tip.jump = medianOf(std::move(rises));
    auto error = findApex(rim, context, tip);

    for (const Index v : tip.vertices) inside_[v] = false;
    for (const Index h : rim) {
      crossed_[h] = false;
      if (mesh_.twin(h) != kNoIndex) crossed_[mesh_.twin(h)] = false;
    }
    if (error) return *std::move(error);
    return tip;
  }

 private:
  /// The share of a face inside the contour through the middles of its sides, divided among its
  /// corners inside.
  double share(Index halfedge) const {
    int count = 0;
    for (const Index v : mesh_.faceVertices(SurfaceMesh::faceOf(halfedge))) count += inside_[v];
    return count == 1 ? 1.0 / 4 : count == 2 ? 3.0 / 8 : 1.0 / 3;
  }

  void cross(Index halfedge, Index outside, Index inside, std::vector<Index>& rim,
             std::vector<double>& rises) {
    rim.push_back(halfedge);
    crossed_[halfedge] = true;
    if (mesh_.twin(halfedge) != kNoIndex) crossed_[mesh_.twin(halfedge)] = true;
    rises.push_back(girth_[inside] - girth_[outside]);
  }

  /// The vertex farthest from the contour. Ways along edges inside tell how far that can be, and so
  /// how far the exact distances are needed.
  std::optional<Error> findApex(const std::vector<Index>& rim, const ExecutionContext& context,
                                Tip& tip) {
    std::map<Index, double> reached;
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::vector<SurfacePoint> sources;
    for (const Index h : rim) {
      sources.push_back(SurfacePoint::onHalfedge(h, 0.5));
      queue.push({mesh_.length(h) / 2, inside_[mesh_.from(h)] ? mesh_.from(h) : mesh_.to(h)});
    }
    double radius = 0;
    while (!queue.empty()) {
      const auto [distance, v] = queue.top();
      queue.pop();
      if (!reached.emplace(v, distance).second) continue;
      radius = std::max(radius, distance);
      forEachEdge(mesh_, v, [&, from = distance](Index h, Index neighbour) {
        if (inside_[neighbour] && !reached.contains(neighbour)) {
          queue.push({from + mesh_.length(h), neighbour});
        }
      });
    }
    const auto distances = solver_.distances(sources, radius * (1 + 1e-9), context);
    if (!distances) return distances.error();
    for (const Index v : tip.vertices) {
      const double distance = distances.value()[v];
      if (std::isinf(distance) || (tip.apex != kNoIndex && !(distance > tip.apexDistance)))
        continue;
      tip.apex = v;
      tip.apexDistance = distance;
    }
    return std::nullopt;
  }

  const SurfaceMesh& mesh_;
  std::span<const double> girth_;
  GeodesicSolver solver_;
  std::vector<bool> inside_;   // of the vertices
  std::vector<bool> crossed_;  // of the halfedges
};

}  // namespace

Result<Tips> findTips(const SurfaceMesh& mesh, std::span<const double> girth,
                      const ExecutionContext& context) {
  if (girth.size() != mesh.vertexCount()) {
    return makeError(ErrorCode::Usage, -1,
                     std::to_string(girth.size()) + " values for " +
                         std::to_string(mesh.vertexCount()) + " vertices");
  }
  const Pieces pieces(mesh, girth);
  Tips result;
  result.crossedEdges = static_cast<Index>(pieces.edges().size());

  const auto regions = pieces.regions();
  if (!regions) {
    return makeError(ErrorCode::LimitExceeded, -1,
                     "the values jump at so many edges that their pieces cannot be told apart");
  }
  TipMaker maker(mesh, girth);
  for (const std::vector<Index>& region : *regions) {
    if (context.cancelled()) return makeError(ErrorCode::Cancelled, -1, "cancelled");
    auto tip = maker.make(pieces, region, context);
    if (!tip) return tip.error();
    result.tips.push_back(std::move(tip).value());
  }
  std::stable_sort(result.tips.begin(), result.tips.end(),
                   [](const Tip& a, const Tip& b) { return a.jump > b.jump; });

  std::vector<bool> crossed(mesh.halfedgeCount(), false);
  for (const Index h : pieces.within()) {
    crossed[h] = true;
    if (mesh.twin(h) != kNoIndex) crossed[mesh.twin(h)] = true;
  }
  for (ContourLine& line : contourLines(mesh, pieces.within(), crossed)) {
    OpenArc arc;
    arc.length = lengthOf(mesh, line);
    std::vector<double> jumps;
    for (const SurfacePoint& point : line.points) {
      jumps.push_back(std::fabs(girth[mesh.from(point.element)] - girth[mesh.to(point.element)]));
    }
    arc.jump = medianOf(std::move(jumps));
    arc.line = std::move(line);
    result.arcs.push_back(std::move(arc));
  }
  std::stable_sort(result.arcs.begin(), result.arcs.end(),
                   [](const OpenArc& a, const OpenArc& b) { return a.length > b.length; });
  return result;
}

}  // namespace girth
