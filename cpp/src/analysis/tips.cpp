#include "girth/tips.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <queue>
#include <set>
#include <string>
#include <utility>

#include "analysis/contour.h"
#include "analysis/median.h"
#include "girth/geodesic_solver.h"
#include "mesh/neighbours.h"

namespace girth {

namespace {

/// Steps from piece to piece in all, and vertices in all regions, beyond which the values cannot be
/// those of a girth: they jump at nearly every edge.
constexpr std::size_t kMostWork = 100'000'000;

/// The pieces of the surface without the edges that the contour crosses.
class Pieces {
 public:
  Pieces(const SurfaceMesh& mesh, std::span<const double> girth)
      : mesh_(mesh),
        girth_(girth),
        crossed_(mesh.halfedgeCount(), false),
        pieceOf_(mesh.vertexCount(), kNoIndex) {
    for (const Halfedge h : mesh.halfedges()) {
      const double jump = std::fabs(girth[mesh.from(h)] - girth[mesh.to(h)]);
      crossed_[h] = jump > 2 * mesh.length(h);  // not where a value is NaN
      const Halfedge twin = mesh.twin(h);
      if (crossed_[h] && (twin == kNoIndex || h < twin)) edges_.push_back(h);
    }
    flood();
    for (const Halfedge h : edges_) {
      const Index a = pieceOf_[mesh.from(h)], b = pieceOf_[mesh.to(h)];
      if (a == b) continue;
      const double rise = girth[mesh.from(h)] - girth[mesh.to(h)];
      between_[std::minmax(a, b)].push_back(a < b ? rise : -rise);
    }
    neighbours_.resize(vertices_.size());
    for (const auto& [pair, rises] : between_) {
      neighbours_[pair.first].push_back(pair.second);
      neighbours_[pair.second].push_back(pair.first);
    }
  }

  const std::vector<Halfedge>& edges() const { return edges_; }
  Index pieceOf(Vertex vertex) const { return pieceOf_[vertex]; }
  const std::vector<Vertex>& vertices(Index piece) const { return vertices_[piece]; }

  /// Regions that some contour may cut off, as sets of pieces. Nothing where the work is too much.
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
    for (const Vertex seed : mesh_.vertices()) {
      if (pieceOf_[seed] != kNoIndex) continue;
      const auto piece = static_cast<Index>(vertices_.size());
      std::vector<Vertex> members{seed};
      pieceOf_[seed] = piece;
      const auto reach = [&](Vertex vertex) {
        if (pieceOf_[vertex] != kNoIndex) return;
        pieceOf_[vertex] = piece;
        members.push_back(vertex);
      };
      for (std::size_t i = 0; i < members.size(); ++i) {
        forEachEdge(mesh_, members[i], [&](Halfedge h, Vertex neighbour) {
          if (!crossed_[h]) reach(neighbour);
        });
      }
      std::vector<double> values;
      for (const Vertex v : members) {
        if (!std::isnan(girth_[v])) values.push_back(girth_[v]);
      }
      level_.push_back(values.empty() ? 0 : medianOf(std::move(values)));
      vertices_.push_back(std::move(members));
    }
  }

  const SurfaceMesh& mesh_;
  std::span<const double> girth_;
  std::vector<bool> crossed_;
  std::vector<Halfedge> edges_;
  std::vector<Index> pieceOf_;  // by vertex
  std::vector<std::vector<Vertex>> vertices_;
  std::vector<double> level_;  // the median girth of a piece
  /// For two pieces that meet, by how much the girth of the first is larger, edge by edge.
  std::map<std::pair<Index, Index>, std::vector<double>> between_;
  std::vector<std::vector<Index>> neighbours_;
};

/// The edges with one end in a region, one halfedge of each, and how far the girth rises there.
struct Rim {
  std::vector<Halfedge> edges;
  double jump{0};  ///< the median
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

  Rim rimOf(const Pieces& pieces, const std::vector<Index>& region) {
    const std::vector<Vertex> vertices = enter(pieces, region);
    Rim rim;
    std::vector<double> rises;
    for (const Vertex v : vertices) {
      forEachEdge(mesh_, v, [&](Halfedge h, Vertex neighbour) {
        if (inside_[neighbour]) return;
        rim.edges.push_back(edgeOf(h));
        rises.push_back(girth_[v] - girth_[neighbour]);
      });
    }
    rim.jump = medianOf(std::move(rises));
    leave(vertices);
    return rim;
  }

  Result<Tip> make(const Pieces& pieces, const std::vector<Index>& region, const Rim& rim,
                   const ExecutionContext& context) {
    Tip tip;
    tip.vertices = enter(pieces, region);
    for (const Vertex v : tip.vertices) {
      forEachEdge(mesh_, v, [&](Halfedge h, Vertex) {
        if (mesh_.from(h) == v) tip.area += share(h) * mesh_.area(SurfaceMesh::faceOf(h));
      });
    }
    tip.contour = lines(rim.edges);
    for (const ContourLine& line : tip.contour) tip.boundaryLength += lengthOf(mesh_, line);
    tip.jump = rim.jump;
    auto error = findApex(rim.edges, context, tip);
    leave(tip.vertices);
    if (error) return *std::move(error);
    return tip;
  }

  /// Joins edges to lines.
  std::vector<ContourLine> lines(const std::vector<Halfedge>& edges) {
    const auto mark = [&](bool crossed) {
      for (const Halfedge h : edges) {
        crossed_[h] = crossed;
        const Halfedge twin = mesh_.twin(h);
        if (twin != Halfedge::none) crossed_[twin] = crossed;
      }
    };
    mark(true);
    std::vector<ContourLine> found = contourLines(mesh_, edges, crossed_);
    mark(false);
    return found;
  }

 private:
  /// The share of a face inside the contour through the middles of its sides, divided among its
  /// corners inside.
  double share(Halfedge halfedge) const {
    int count = 0;
    for (const Vertex v : mesh_.faceVertices(SurfaceMesh::faceOf(halfedge))) {
      count += inside_[v];
    }
    return count == 1 ? 1.0 / 4 : count == 2 ? 3.0 / 8 : 1.0 / 3;
  }

  /// Marks the vertices of a region as inside; gives them, in rising order.
  std::vector<Vertex> enter(const Pieces& pieces, const std::vector<Index>& region) {
    std::vector<Vertex> vertices;
    for (const Index piece : region) {
      const auto& members = pieces.vertices(piece);
      vertices.insert(vertices.end(), members.begin(), members.end());
    }
    std::sort(vertices.begin(), vertices.end());
    for (const Vertex v : vertices) inside_[v] = true;
    return vertices;
  }
  void leave(const std::vector<Vertex>& vertices) {
    for (const Vertex v : vertices) inside_[v] = false;
  }

  /// One halfedge for both of an edge: as in Pieces::edges.
  Halfedge edgeOf(Halfedge halfedge) const { return std::min(halfedge, mesh_.twin(halfedge)); }

  /// The vertex farthest from the contour. Ways along edges inside bound how far that can be, and
  /// so how far the exact distances are needed.
  std::optional<Error> findApex(const std::vector<Halfedge>& rim, const ExecutionContext& context,
                                Tip& tip) {
    std::map<Vertex, double> reached;
    using Entry = std::pair<double, Vertex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::vector<SurfacePoint> sources;
    for (const Halfedge h : rim) {
      sources.push_back(SurfacePoint::onHalfedge(h, 0.5));
      queue.push({mesh_.length(h) / 2, inside_[mesh_.from(h)] ? mesh_.from(h) : mesh_.to(h)});
    }
    double radius = 0;
    while (!queue.empty()) {
      const auto [distance, v] = queue.top();
      queue.pop();
      if (!reached.emplace(v, distance).second) continue;
      radius = std::max(radius, distance);
      forEachEdge(mesh_, v, [&, from = distance](Halfedge h, Vertex neighbour) {
        if (inside_[neighbour] && !reached.contains(neighbour)) {
          queue.push({from + mesh_.length(h), neighbour});
        }
      });
    }
    const auto distances = solver_.distances(sources, radius * (1 + 1e-9), context);
    if (!distances) return distances.error();
    for (const Vertex v : tip.vertices) {
      const double distance = distances.value()[v];
      if (std::isinf(distance) || (tip.apex != Vertex::none && !(distance > tip.apexDistance)))
        continue;
      tip.apex = v;
      tip.apexDistance = distance;
    }
    return std::nullopt;
  }

  const SurfaceMesh& mesh_;
  std::span<const double> girth_;
  GeodesicSolver solver_;
  std::vector<bool> inside_;   // by vertex
  std::vector<bool> crossed_;  // by halfedge
};

/// Whether `rim` and one that is kept have more than half of their edges, of either, in common.
/// `keptAt`: numbers of the kept rims at an edge.
bool isMostlyKept(const Rim& rim, const std::vector<Rim>& kept,
                  const std::map<Halfedge, std::vector<std::size_t>>& keptAt) {
  std::map<std::size_t, std::size_t> shared;
  for (const Halfedge edge : rim.edges) {
    const auto found = keptAt.find(edge);
    if (found == keptAt.end()) continue;
    for (const std::size_t other : found->second) ++shared[other];
  }
  return std::any_of(shared.begin(), shared.end(), [&](const auto& entry) {
    return 2 * entry.second > std::max(rim.edges.size(), kept[entry.first].edges.size());
  });
}

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
                     "the values jump at so many edges that their pieces cannot be distinguished");
  }
  TipMaker maker(mesh, girth);
  struct Candidate {
    const std::vector<Index>* region;
    Rim rim;
  };
  std::vector<Candidate> candidates;
  for (const std::vector<Index>& region : *regions) {
    if (context.cancelled()) return makeError(ErrorCode::Cancelled, -1, "cancelled");
    Rim rim = maker.rimOf(pieces, region);
    if (rim.jump > 0) candidates.push_back({&region, std::move(rim)});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.rim.jump > b.rim.jump; });
  std::vector<Rim> kept;
  std::map<Halfedge, std::vector<std::size_t>> keptAt;
  for (Candidate& candidate : candidates) {
    if (context.cancelled()) return makeError(ErrorCode::Cancelled, -1, "cancelled");
    if (isMostlyKept(candidate.rim, kept, keptAt)) continue;
    auto tip = maker.make(pieces, *candidate.region, candidate.rim, context);
    if (!tip) return tip.error();
    result.tips.push_back(std::move(tip).value());
    for (const Halfedge edge : candidate.rim.edges) keptAt[edge].push_back(kept.size());
    kept.push_back(std::move(candidate.rim));
  }

  std::vector<Halfedge> loose;
  std::copy_if(pieces.edges().begin(), pieces.edges().end(), std::back_inserter(loose),
               [&](Halfedge edge) { return !keptAt.contains(edge); });
  for (ContourLine& line : maker.lines(loose)) {
    OpenArc arc;
    arc.length = lengthOf(mesh, line);
    std::vector<double> jumps;
    for (const SurfacePoint& point : line.points) {
      const Halfedge edge = point.halfedge();
      jumps.push_back(std::fabs(girth[mesh.from(edge)] - girth[mesh.to(edge)]));
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
