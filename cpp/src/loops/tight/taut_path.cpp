#include "loops/tight/taut_path.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "geodesic/tolerances.h"
#include "loops/tight/pulling.h"
#include "loops/tight/rounding_guard.h"

namespace girth::loops {
namespace {

using Kind = SurfacePoint::Kind;

/// Calls `visit` with a halfedge of each face that a point lies in, until it returns true.
template <class Visit>
void visitFacesOf(const Unfolding& unfolding, const SurfacePoint& point, Visit visit) {
  if (point.kind == Kind::AtVertex) {
    for (const Index halfedge : unfolding.fan(point.element)) {
      if (visit(halfedge)) return;
    }
    return;
  }
  const Index home = unfolding.home(point);
  if (visit(home) || point.kind == Kind::InFace) return;
  const Index twin = unfolding.twin(home);
  if (twin != kNoIndex) visit(twin);
}

/// A face that two points have in common: `before`, if it is one.
Index faceOfBoth(const Unfolding& unfolding, const SurfacePoint& a, const SurfacePoint& b,
                 Index before) {
  if (before != kNoIndex && unfolding.placeIn(3 * before, a) && unfolding.placeIn(3 * before, b)) {
    return before;
  }
  const bool isFromB = a.kind == Kind::AtVertex;
  Index face = kNoIndex;
  visitFacesOf(unfolding, isFromB ? b : a, [&](Index halfedge) {
    if (!unfolding.placeIn(halfedge, isFromB ? a : b)) return false;
    face = faceOfSide(halfedge);
    return true;
  });
  return face;
}

/// The halfedge of a face on an edge.
Index sideIn(const Unfolding& unfolding, Index face, Index halfedge) {
  return faceOfSide(halfedge) == face ? halfedge : unfolding.twin(halfedge);
}

/// The faces that neighbours of a curve have in common; nothing where some have none.
std::optional<std::vector<Index>> facesBetween(const Unfolding& unfolding,
                                               std::span<const SurfacePoint> points,
                                               bool isClosed) {
  std::vector<Index> faces;
  Index face = kNoIndex;
  for (std::size_t i = 0; i + (isClosed ? 0 : 1) < points.size(); ++i) {
    face = faceOfBoth(unfolding, points[i], points[(i + 1) % points.size()], face);
    if (face == kNoIndex) return std::nullopt;
    faces.push_back(face);
  }
  return faces;
}

/// Takes out vertices that follow on themselves.
void dropStops(TautPath& path) {
  for (std::size_t i = path.runs.size(); i-- > 0 && path.runs.size() > 1;) {
    const SurfacePoint &a = path.nodes[i], &b = path.nodes[i + 1];
    if (!path.runs[i].empty() || a.kind != Kind::AtVertex || b.kind != Kind::AtVertex ||
        a.element != b.element) {
      continue;
    }
    // The one that is no end goes.
    path.nodes.erase(path.nodes.begin() + static_cast<std::ptrdiff_t>(i == 0 ? 1 : i));
    path.runs.erase(path.runs.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

/// A path that is drawn tight step by step, with the passages of its vertices.
class PathTightening {
 public:
  PathTightening(const Unfolding& unfolding, TautPath& path) : unfolding_(unfolding), path_(path) {
    TautPath tight;
    tight.nodes.push_back(path.nodes.front());
    for (std::size_t i = 0; i < path.runs.size(); ++i) {
      cancelReturns(unfolding, path.runs[i], false);
      std::vector<Index> vertices;
      pull(unfolding, path.nodes[i], std::move(path.runs[i]), path.nodes[i + 1], vertices,
           tight.runs);
      for (const Index vertex : vertices) tight.nodes.push_back(vertexNode(vertex));
      tight.nodes.push_back(path.nodes[i + 1]);
    }
    path = std::move(tight);
    measureAll();
  }

  Tightened run(const ExecutionContext& context) {
    std::size_t steps =
        1000 + 100 * path_.nodes.size() + 10 * std::size_t{unfolding_.vertexCount()};
    for (const Run& run : path_.runs) steps += 100 * run.size();
    for (; steps > 0 && !context.cancelled(); --steps) {
      const std::size_t sharpest = sharpestTurn();
      if (sharpest == 0) return Tightened::Geodesic;
      const Index vertex = path_.nodes[sharpest].element;
      pass(sharpest);
      guard_.passed(vertex, path_.nodes.size(), [&] { return lengthOf(unfolding_, path_); });
    }
    return Tightened::GaveUp;
  }

 private:
  void measureAll() {
    dropStops(path_);
    passages_.assign(path_.nodes.size(), {});
    for (std::size_t i = 1; i + 1 < path_.nodes.size(); ++i) measure(i);
  }

  void measure(std::size_t i) {
    passages_[i] = passageOf(unfolding_, path_.nodes[i - 1], path_.runs[i - 1],
                             path_.nodes[i].element, path_.runs[i], path_.nodes[i + 1]);
  }

  /// The vertex with the sharpest turn; 0: there is none.
  std::size_t sharpestTurn() const {
    std::size_t sharpest = 0;
    double least = kPi - geodesic::kTaut;
    for (std::size_t i = 1; i + 1 < passages_.size(); ++i) {
      const double angle = std::min(passages_[i].left, passages_[i].right);
      if (angle >= least || guard_.isSettled(path_.nodes[i].element)) continue;
      least = angle;
      sharpest = i;
    }
    return sharpest;
  }

  /// Passes a vertex on the side where the angle is less: only what lies between its neighbours
  /// changes.
  void pass(std::size_t i) {
    const Passage& passage = passages_[i];
    const Run way = around(unfolding_, path_.nodes[i].element, passage,
                           passage.left < passage.right ? Side::Left : Side::Right);
    Run run = std::move(path_.runs[i - 1]);
    run.insert(run.end(), way.begin(), way.end());
    run.insert(run.end(), path_.runs[i].begin(), path_.runs[i].end());
    cancelReturns(unfolding_, run, false);
    std::vector<Index> vertices;
    std::vector<Run> runs;
    pull(unfolding_, path_.nodes[i - 1], std::move(run), path_.nodes[i + 1], vertices, runs);
    const auto at = static_cast<std::ptrdiff_t>(i);
    path_.runs.erase(path_.runs.begin() + at - 1, path_.runs.begin() + at + 1);
    path_.runs.insert(path_.runs.begin() + at - 1, runs.begin(), runs.end());
    path_.nodes.erase(path_.nodes.begin() + at);
    std::vector<SurfacePoint> nodes;
    for (const Index vertex : vertices) nodes.push_back(vertexNode(vertex));
    path_.nodes.insert(path_.nodes.begin() + at, nodes.begin(), nodes.end());
    const std::size_t size = path_.nodes.size();
    dropStops(path_);
    if (path_.nodes.size() != size) {
      measureAll();
      return;
    }
    passages_.erase(passages_.begin() + at);
    passages_.insert(passages_.begin() + at, vertices.size(), Passage{});
    const std::size_t last = std::min(i + vertices.size(), size - 2);
    for (std::size_t k = std::max<std::size_t>(i - 1, 1); k <= last; ++k) measure(k);
  }

  const Unfolding& unfolding_;
  TautPath& path_;
  std::vector<Passage> passages_;
  RoundingGuard guard_;
};

}  // namespace

std::optional<TautPath> loosePath(const Unfolding& unfolding,
                                  std::span<const SurfacePoint> points) {
  if (points.empty()) return std::nullopt;
  if (points.size() == 1) return TautPath{{points[0], points[0]}, {{}}};
  const auto faces = facesBetween(unfolding, points, false);
  if (!faces) return std::nullopt;
  TautPath path{{points[0]}, {{}}};
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    if (points[i].kind == Kind::AtVertex) {
      path.nodes.push_back(points[i]);
      path.runs.emplace_back();
    } else if ((*faces)[i - 1] != (*faces)[i]) {
      path.runs.back().push_back(sideIn(unfolding, (*faces)[i - 1], points[i].element));
    }
  }
  path.nodes.push_back(points.back());
  return path;
}

std::optional<TautLoop> looseClosed(const Unfolding& unfolding,
                                    std::span<const SurfacePoint> points) {
  if (points.empty()) return std::nullopt;
  // Begun at a vertex, so that no run goes over the end.
  std::vector<SurfacePoint> turned(points.begin(), points.end());
  std::rotate(turned.begin(),
              std::find_if(turned.begin(), turned.end(),
                           [](const SurfacePoint& one) { return one.kind == Kind::AtVertex; }),
              turned.end());
  const auto faces = facesBetween(unfolding, turned, true);
  if (!faces) return std::nullopt;
  TautLoop loop;
  if (turned[0].kind != Kind::AtVertex) loop.runs.emplace_back();
  for (std::size_t i = 0; i < turned.size(); ++i) {
    const Index before = (*faces)[(i + turned.size() - 1) % turned.size()];
    if (turned[i].kind == Kind::AtVertex) {
      loop.vertices.push_back(turned[i].element);
      loop.runs.emplace_back();
    } else if (before != (*faces)[i]) {
      loop.runs.back().push_back(sideIn(unfolding, before, turned[i].element));
    }
  }
  return loop;
}

Tightened tightenBetween(const Unfolding& unfolding, TautPath& path,
                         const ExecutionContext& context) {
  return PathTightening(unfolding, path).run(context);
}

double lengthOf(const Unfolding& unfolding, const TautPath& path) {
  double length = 0;
  for (std::size_t i = 0; i < path.runs.size(); ++i) {
    length += lengthOfRun(unfolding, path.nodes[i], path.runs[i], path.nodes[i + 1]);
  }
  return length * unfolding.unit();
}

std::vector<SurfacePoint> pointsOf(const Unfolding& unfolding, const TautPath& path) {
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < path.runs.size(); ++i) {
    points.push_back(unfolding.toMesh(path.nodes[i]));
    appendCrossings(unfolding, path.nodes[i], path.runs[i], path.nodes[i + 1], points);
  }
  points.push_back(unfolding.toMesh(path.nodes.back()));
  return points;
}

}  // namespace girth::loops
