#include "girth/necks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "girth/girth_solver.h"
#include "girth/parallel.h"
#include "girth/vertex_function.h"
#include "loops/necks/girth_at.h"
#include "loops/necks/pass_search.h"
#include "loops/necks/upper_bounds.h"
#include "loops/tight/loop_shape.h"
#include "loops/tight/taut_loop.h"
#include "mesh/vector.h"
#include "part_of_work.h"
#include "solver/solver_factory.h"

namespace girth {
namespace {

using geodesic::Unfolding;
using loops::TautLoop;
using loops::Tightened;

/// Lengths that differ by less than this share are equal.
constexpr double kEqualLength = 1e-9;
/// Loops that lie closer together than this share of their length are one.
constexpr double kSamePlace = 1e-7;
/// Pieces of edges on which prominence is measured, as a share of the neck's length.
constexpr double kFinest = 1e-2;
/// Prominence of less than this share of the neck's length is none.
constexpr double kLeastProminence = 1e-3;
/// The share of the work that is loops.
constexpr double kLoopShare = 0.8;

Error cancelled() {
  return makeError(ErrorCode::Cancelled, -1, "the search for necks was cancelled");
}

/// Orders loops by what they pass and cross.
struct ByElements {
  bool operator()(const TautLoop& a, const TautLoop& b) const {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.runs < b.runs;
  }
};
using LoopSet = std::set<TautLoop, ByElements>;

/// Necks that the threads find.
struct Gathered {
  std::mutex mutex;
  LoopSet loops;
  std::size_t unresolved{0};
};

/// The closed geodesics that the loops at all vertices with a value are drawn tight to.
std::optional<Error> gatherLoops(const SurfaceMesh& mesh, std::span<const double> girth,
                                 const std::shared_ptr<const Unfolding>& unfolding,
                                 const ExecutionContext& context, Gathered& gathered) {
  // Most loops come to where others have been before.
  loops::TightenedBefore before;
  const auto startThread = [&]() -> std::function<bool(Vertex)> {
    auto solver = std::make_shared<GirthSolver>(SolverFactory::onUnfolding(unfolding));
    return [&, solver](Vertex vertex) {
      if (std::isnan(girth[vertex])) return true;
      const auto loop = solver->loop(vertex, context.ofOneThread());
      if (!loop) return false;  // cancelled: the vertex is in range
      if (loop.value().kind == LoopKind::Antipodal) return true;
      std::optional<TautLoop> tight;
      Tightened outcome = Tightened::GaveUp;
      if (loop.value().kind == LoopKind::Loop) {
        tight = loops::looseLoop(*unfolding, loop.value().points);
        if (tight) outcome = loops::tighten(*unfolding, *tight, before);
      }
      if (outcome == Tightened::Contracted) return true;
      const std::lock_guard lock(gathered.mutex);
      if (outcome == Tightened::Geodesic) {
        gathered.loops.insert(std::move(*tight));
      } else {
        ++gathered.unresolved;
      }
      return true;
    };
  };
  if (forEachVertex(mesh, context, startThread, {}) < mesh.vertexCount()) {
    return cancelled();
  }
  return std::nullopt;
}

/// Whether each of some points lies on a curve.
bool liesOn(const std::vector<Vec3>& points, const std::vector<Vec3>& curve, double tolerance) {
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
      if (std::sqrt(squareFromSegment(p, curve[i], curve[i + 1])) <= tolerance) return true;
    }
    return false;
  });
}

/// The necks among closed geodesics, in rising order of their lengths: each band once, and what
/// leaking bands lead to.
std::vector<Neck> necksOf(const SurfaceMesh& mesh, const Unfolding& unfolding,
                          std::span<const double> girth, const LoopSet& loops) {
  std::vector<double> areas(mesh.componentCount(), 0);
  for (const Face f : mesh.faces()) {
    areas[mesh.componentOf(mesh.faceVertices(f)[0])] += mesh.area(f);
  }
  std::vector<TautLoop> pending(loops.begin(), loops.end());
  LoopSet known = loops;
  std::vector<Neck> necks;
  std::vector<std::vector<Vec3>> curves;
  while (!pending.empty()) {
    const TautLoop loop = std::move(pending.back());
    pending.pop_back();
    const Vertex vertex(unfolding.vertexInMesh(loop.vertices[0]));
    loops::Band band = loops::bandOf(unfolding, loop, areas[mesh.componentOf(vertex)]);
    if (band.shorter) {
      if (loops::tighten(unfolding, *band.shorter) != Tightened::Geodesic) continue;
      TautLoop next = loops::canonical(unfolding, *band.shorter);
      if (known.insert(next).second) pending.push_back(std::move(next));
      continue;
    }
    Neck neck;
    neck.length = loops::lengthOf(unfolding, loop);
    neck.points = std::move(band.middle);
    neck.width = band.width;
    neck.vertices = std::move(band.vertices);
    std::vector<Vec3> places = loops::placesOf(mesh, neck.points);
    const bool isKnown = [&] {
      for (std::size_t i = 0; i < necks.size(); ++i) {
        const double tolerance = kSamePlace * neck.length;
        if (std::fabs(necks[i].length - neck.length) <= kEqualLength * neck.length &&
            liesOn(places, curves[i], tolerance) && liesOn(curves[i], places, tolerance)) {
          return true;
        }
      }
      return false;
    }();
    if (isKnown) continue;
    const loops::LoopShape shape = loops::shapeOf(places);
    neck.centre = shape.centre;
    neck.normal = shape.normal;
    neck.radius = shape.radius;
    neck.area = shape.area;
    for (const Vertex v : neck.vertices) {
      neck.touchesBoundary = neck.touchesBoundary || mesh.isBoundary(v);
      neck.measuresGirth =
          neck.measuresGirth && std::fabs(girth[v] - neck.length) <= kEqualLength * neck.length;
    }
    necks.push_back(std::move(neck));
    curves.push_back(std::move(places));
  }
  std::stable_sort(necks.begin(), necks.end(), [](const Neck& a, const Neck& b) {
    return a.length != b.length ? a.length < b.length : a.vertices < b.vertices;
  });
  return necks;
}

/// Prominences, of necks in rising order of their lengths.
std::optional<Error> findProminences(const SurfaceMesh& mesh, std::span<const double> girth,
                                     const std::shared_ptr<const Unfolding>& unfolding,
                                     const ExecutionContext& context, std::vector<Neck>& necks) {
  loops::GirthAt girthAt(unfolding, context);
  loops::UpperBounds upperBounds(*unfolding, girthAt);
  loops::PassSearch search(
      mesh, girth, [&](std::span<const SurfacePoint> points) { return girthAt.lengths(points); },
      [&](std::span<const loops::PassSearch::Segment> segments) {
        return upperBounds.at(segments);
      });
  std::vector<bool> isNarrower(mesh.vertexCount(), false);
  std::vector<bool> hasNeck(mesh.componentCount(), false);
  for (std::size_t i = 0; i < necks.size(); ++i) {
    Neck& neck = necks[i];
    const Index component = mesh.componentOf(neck.vertices[0]);
    if (hasNeck[component]) {
      const double level = (1 + kLeastProminence) * neck.length;
      const auto height = search.height(neck.vertices, isNarrower, level, kFinest * neck.length);
      if (!height) return height.error();
      neck.prominence = height.value() > level ? height.value() - neck.length : 0;
    }
    hasNeck[component] = true;
    for (const Vertex v : neck.vertices) isNarrower[v] = true;
    if (context.onProgress) {
      context.onProgress(static_cast<double>(i + 1) / static_cast<double>(necks.size()));
    }
  }
  return std::nullopt;
}

/// A twentieth of the narrowest neck's length; 0 without necks.
double prominenceOfClearOnes(std::span<const Neck> necks) {
  constexpr double kShare = 0.05;
  const auto narrowest = std::min_element(
      necks.begin(), necks.end(), [](const Neck& a, const Neck& b) { return a.length < b.length; });
  return narrowest == necks.end() ? 0 : kShare * narrowest->length;
}

}  // namespace

Result<Necks> findNecks(const SurfaceMesh& mesh, std::span<const double> girth,
                        const NeckOptions& options, const ExecutionContext& context) {
  if (girth.size() != mesh.vertexCount()) {
    return makeError(ErrorCode::Usage, -1,
                     std::to_string(girth.size()) + " values for " +
                         std::to_string(mesh.vertexCount()) + " vertices");
  }
  if (!(options.minProminence >= 0)) {
    return makeError(ErrorCode::InvalidOption, -1,
                     "the least prominence is a number of at least 0");
  }
  const auto unfolding = std::make_shared<const Unfolding>(mesh);
  Gathered gathered;
  if (auto error = gatherLoops(mesh, girth, unfolding, partOf(context, 0, kLoopShare), gathered)) {
    return *error;
  }
  Necks found;
  found.unresolved = static_cast<Index>(gathered.unresolved);
  found.necks = necksOf(mesh, *unfolding, girth, gathered.loops);
  if (auto error =
          findProminences(mesh, girth, unfolding, partOf(context, kLoopShare, 1), found.necks)) {
    return *error;
  }
  found.suggestedProminence = prominenceOfClearOnes(found.necks);
  std::erase_if(found.necks,
                [&](const Neck& neck) { return neck.prominence < options.minProminence; });
  std::stable_sort(found.necks.begin(), found.necks.end(),
                   [](const Neck& a, const Neck& b) { return a.prominence > b.prominence; });
  const bool isDone = parallelFor(found.necks.size(), 1, {context.threads, context.cancel, {}},
                                  [&](std::size_t begin, std::size_t) {
                                    Neck& neck = found.necks[begin];
                                    if (auto sides = sidesOf(mesh, neck.points))
                                      neck.sides = std::move(sides).value();
                                  });
  if (!isDone) return cancelled();
  if (context.onProgress) context.onProgress(1);
  return found;
}

double suggestedProminence(std::span<const Neck> necks) { return prominenceOfClearOnes(necks); }

}  // namespace girth
