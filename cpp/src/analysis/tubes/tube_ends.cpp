#include "analysis/tubes/tube_ends.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include "girth/geodesic_solver.h"
#include "girth/persistent_maxima.h"
#include "infinity.h"
#include "mesh/check_point.h"
#include "mesh/vector.h"

namespace girth::tubes {
namespace {

/// Boundary curves shorter than this share of the component's longest are holes.
constexpr double kLeastOpening = 0.1;
/// Closed branches shorter than this share of the distance to the farthest point are bumps.
constexpr double kLeastBranch = 0.1;
/// Lengths that differ by less than this share are equal: then the lower number counts.
constexpr double kEqual = 1e-9;

/// Finds the ends, component by component.
class EndSearch {
 public:
  EndSearch(const SurfaceMesh& mesh, const ExecutionContext& context)
      : mesh_(mesh), context_(context.ofOneThread()), ends_(mesh.componentCount()) {
    findOpenings();
  }

  /// The ends that a caller gave.
  void take(std::span<const Vertex> given) {
    std::vector<bool> isGiven(mesh_.componentCount(), false);
    const std::vector<std::vector<TreeEnd>> openings = ends_;
    for (const Vertex v : given) {
      const Index component = mesh_.componentOf(v);
      if (!isGiven[component]) ends_[component].clear();
      isGiven[component] = true;
      TreeEnd end = atVertex(v);
      for (const TreeEnd& opening : openings[component]) {
        if (std::find(opening.vertices.begin(), opening.vertices.end(), v) !=
            opening.vertices.end()) {
          end = opening;
        }
      }
      std::vector<TreeEnd>& all = ends_[component];
      const bool isNew = std::none_of(
          all.begin(), all.end(), [&](const TreeEnd& one) { return one.vertices == end.vertices; });
      if (isNew) all.push_back(std::move(end));
    }
    for (const Index c : components()) {
      isStarted_[c] = isGiven[c];
      // Components with handles are no tubes, whatever their ends.
      isSettled_[c] = mesh_.genus(c) > 0 || (isGiven[c] && ends_[c].size() > 1);
      if (!isStarted_[c] || isSettled_[c]) continue;
      // One end is where the centrelines begin: the others are found.
      for (const TreeEnd& opening : openings[c]) {
        if (opening.vertices != ends_[c].front().vertices) ends_[c].push_back(opening);
      }
    }
  }

  /// Finds those of the other components: openings, and the farthest places.
  std::optional<Error> findOthers() {
    if (std::find(isSettled_.begin(), isSettled_.end(), false) == isSettled_.end()) {
      return std::nullopt;
    }
    for (const Index c : components()) {
      if (isSettled_[c]) continue;
      std::vector<TreeEnd>& all = ends_[c];
      double longest = 0;
      for (const TreeEnd& end : all) longest = std::max(longest, end.length);
      const auto begin = all.begin() + (isStarted_[c] ? 1 : 0);
      all.erase(
          std::remove_if(begin, all.end(),
                         [&](const TreeEnd& end) { return end.length < kLeastOpening * longest; }),
          all.end());
      if (isStarted_[c]) continue;
      const auto first = std::find_if(all.begin(), all.end(), [&](const TreeEnd& end) {
        return end.length >= (1 - kEqual) * longest;
      });
      if (first != all.end()) std::rotate(all.begin(), first, first + 1);
    }
    if (auto error = findClosedStarts()) return error;
    return findFarEnds();
  }

  std::vector<TreeEnd> result() {
    std::vector<TreeEnd> all;
    for (const Index c : components()) {
      if (mesh_.genus(c) > 0) continue;
      for (TreeEnd& end : ends_[c]) all.push_back(std::move(end));
    }
    return all;
  }

 private:
  /// The numbers of the components.
  std::vector<Index> components() const {
    std::vector<Index> all(mesh_.componentCount());
    for (Index c = 0; c < all.size(); ++c) all[c] = c;
    return all;
  }

  TreeEnd atVertex(Vertex v) const { return {mesh_.componentOf(v), {v}, 0, mesh_.position(v)}; }

  void findOpenings() {
    isStarted_.assign(mesh_.componentCount(), false);
    isSettled_.assign(mesh_.componentCount(), false);
    std::vector<bool> isSeen(mesh_.vertexCount(), false);
    for (const Vertex first : mesh_.vertices()) {
      if (!mesh_.isBoundary(first) || isSeen[first]) continue;
      TreeEnd end{mesh_.componentOf(first), {}, 0, {}};
      for (Vertex v = first; !isSeen[v];) {
        isSeen[v] = true;
        end.vertices.push_back(v);
        const Halfedge along = mesh_.outgoing(v);
        const double length = mesh_.length(along);
        end.length += length;
        end.centre =
            end.centre + (length / 2) * (mesh_.position(v) + mesh_.position(mesh_.to(along)));
        v = mesh_.to(along);
      }
      end.centre = (1 / end.length) * end.centre;
      ends_[end.component].push_back(std::move(end));
    }
  }

  /// Distances within each component from the vertices of its first end, or from its first vertex.
  Result<std::vector<double>> distancesFromStarts() {
    std::vector<SurfacePoint> sources;
    std::vector<bool> isStarted(mesh_.componentCount(), false);
    for (const auto& ends : ends_) {
      if (ends.empty()) continue;
      for (const Vertex v : ends.front().vertices) sources.push_back(SurfacePoint::atVertex(v));
      isStarted[ends.front().component] = true;
    }
    for (const Vertex v : mesh_.vertices()) {
      if (isStarted[mesh_.componentOf(v)]) continue;
      isStarted[mesh_.componentOf(v)] = true;
      sources.push_back(SurfacePoint::atVertex(v));
    }
    return GeodesicSolver(mesh_).distances(sources, kInfinity, context_);
  }

  /// Closed components begin at one of two vertices that are far apart.
  std::optional<Error> findClosedStarts() {
    std::vector<bool> isClosed;
    for (const Index c : components()) isClosed.push_back(!isSettled_[c] && ends_[c].empty());
    if (std::none_of(isClosed.begin(), isClosed.end(), [](bool is) { return is; })) {
      return std::nullopt;
    }
    // Twice the farthest vertex: from the first one, then from that.
    for (int sweep = 0; sweep < 2; ++sweep) {
      const auto distances = distancesFromStarts();
      if (!distances) return distances.error();
      std::vector<Vertex> farthest(mesh_.componentCount());
      for (const Vertex v : mesh_.vertices()) {
        Vertex& best = farthest[mesh_.componentOf(v)];
        const double distance = distances.value()[v];
        if (best == Vertex::none || distance * (1 - kEqual) > distances.value()[best]) best = v;
      }
      for (const Index c : components()) {
        if (isClosed[c]) ends_[c] = {atVertex(farthest[c])};
      }
    }
    return std::nullopt;
  }

  /// The places that are farther from the first end than those around them.
  std::optional<Error> findFarEnds() {
    const auto distances = distancesFromStarts();
    if (!distances) return distances.error();
    std::vector<double> values = distances.value(), greatest(mesh_.componentCount(), 0);
    for (const Vertex v : mesh_.vertices()) {
      const Index c = mesh_.componentOf(v);
      greatest[c] = std::max(greatest[c], values[v]);
    }
    const auto maxima = persistentMaxima(mesh_, values);
    if (!maxima) return maxima.error();
    for (const PersistentMaximum& one : maxima.value()) {
      const Index c = mesh_.componentOf(one.vertex);
      if (isSettled_[c] || mesh_.isBoundary(one.vertex)) continue;
      if (one.persistence < kLeastBranch * greatest[c]) continue;
      const bool isStart = ends_[c].front().vertices.front() == one.vertex;
      if (!isStart) ends_[c].push_back(atVertex(one.vertex));
    }
    return std::nullopt;
  }

  const SurfaceMesh& mesh_;
  const ExecutionContext context_;
  std::vector<std::vector<TreeEnd>> ends_;  // by component
  std::vector<bool> isStarted_;             // by component: its first end was given
  std::vector<bool> isSettled_;             // by component: no end is looked for
};

/// The corner that has the greatest share of a point.
Vertex nearestVertex(const SurfaceMesh& mesh, const SurfacePoint& point) {
  if (point.kind == SurfacePoint::Kind::AtVertex) return point.vertex();
  const auto& weights = point.weights;
  if (point.kind == SurfacePoint::Kind::OnEdge) {
    const Halfedge h = point.halfedge();
    return weights[0] >= weights[1] ? mesh.from(h) : mesh.to(h);
  }
  const auto greatest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  return mesh.faceVertices(point.face())[static_cast<std::size_t>(greatest)];
}

}  // namespace

Result<std::vector<TreeEnd>> findEnds(const SurfaceMesh& mesh, std::span<const SurfacePoint> given,
                                      const ExecutionContext& context) {
  std::vector<Vertex> vertices;
  for (const SurfacePoint& point : given) {
    if (auto error = checkPoint(mesh, point)) return *error;
    vertices.push_back(nearestVertex(mesh, point));
  }
  EndSearch search(mesh, context);
  search.take(vertices);
  if (auto error = search.findOthers()) return *error;
  return search.result();
}

}  // namespace girth::tubes
