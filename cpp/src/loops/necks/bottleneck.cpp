#include "girth/bottleneck.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "girth/girth_solver.h"
#include "loops/cut/faces_of_points.h"
#include "loops/necks/girth_at.h"
#include "loops/necks/pass_search.h"
#include "loops/tight/loop_shape.h"
#include "loops/tight/taut_loop.h"
#include "solver/solver_factory.h"

namespace girth {
namespace {

using geodesic::Unfolding;

/// Pieces of edges on which the girth is measured, as a share of the narrowest.
constexpr double kFinestShare = 1e-2;

Index componentAt(const SurfaceMesh& mesh, const SurfacePoint& point) {
  return mesh.componentOf(mesh.faceVertices(loops::faceAt(mesh, point))[0]);
}

Error noWay(const std::string& why) {
  Error error = makeError(ErrorCode::InvalidPoint, -1, why);
  error.hint = "choose two points that a way over the surface joins";
  return error;
}

/// The neck that a loop is drawn tight to, if it gets no shorter than `least`: its length and its
/// points.
struct FoundNeck {
  double length{0};
  std::vector<SurfacePoint> points;
};
std::optional<FoundNeck> neckAt(const SurfaceMesh& mesh, const Unfolding& unfolding,
                                const GirthLoop& loop, double least) {
  if (loop.kind != LoopKind::Loop) return std::nullopt;
  std::optional<loops::TautLoop> tight = loops::looseLoop(unfolding, loop.points);
  if (!tight || loops::tighten(unfolding, *tight) != loops::Tightened::Geodesic) {
    return std::nullopt;
  }
  const loops::TautLoop neck = loops::canonical(unfolding, *tight);
  const double length = loops::lengthOf(unfolding, neck);
  if (length < least) return std::nullopt;
  loops::Band band = loops::bandOf(unfolding, neck, mesh.area());
  if (band.shorter) return std::nullopt;
  return FoundNeck{length, std::move(band.middle)};
}

}  // namespace

std::string_view toString(BottleneckKind kind) {
  switch (kind) {
    case BottleneckKind::Neck:
      return "neck";
    case BottleneckKind::Pass:
      return "pass";
    case BottleneckKind::End:
      break;
  }
  return "end";
}

Result<Bottleneck> findBottleneck(const SurfaceMesh& mesh, std::span<const double> girth,
                                  const SurfacePoint& from, const SurfacePoint& to,
                                  const ExecutionContext& context) {
  if (girth.size() != mesh.vertexCount()) {
    return makeError(ErrorCode::Usage, -1,
                     std::to_string(girth.size()) + " values for " +
                         std::to_string(mesh.vertexCount()) + " vertices");
  }
  const auto unfolding = std::make_shared<const Unfolding>(mesh);
  GirthSolver solver = SolverFactory::onUnfolding(unfolding);
  // The girths of the ends by themselves, whatever the values of their neighbours are.
  const auto start = solver.value(from, context.ofOneThread());
  if (!start) return start.error();
  const auto end = solver.value(to, context.ofOneThread());
  if (!end) return end.error();
  if (componentAt(mesh, from) != componentAt(mesh, to)) {
    return noWay("the two points lie in different components");
  }
  // The widest way is the lowest one over the girth turned upside down.
  std::vector<double> depths;
  depths.reserve(girth.size());
  for (const double value : girth) depths.push_back(-value);
  if (from.kind == SurfacePoint::Kind::AtVertex) depths[from.element] = -start.value().length;
  if (to.kind == SurfacePoint::Kind::AtVertex) depths[to.element] = -end.value().length;
  loops::GirthAt girthAt(unfolding, context);
  loops::PassSearch search(mesh, depths, [&](std::span<const SurfacePoint> points) {
    auto values = girthAt.lengths(points);
    if (values) {
      for (double& value : values.value()) value = -value;
    }
    return values;
  });
  const Index first = search.insert(from, -start.value().length);
  const Index last = search.insert(to, -end.value().length);
  const double narrowerEnd = std::min(start.value().length, end.value().length);
  loops::PassSearch::Path way;
  double least = narrowerEnd, finest = 0;
  // As fine as the narrowest girth asks for, which is known only behind it.
  do {
    finest = kFinestShare * least;
    auto found = search.between(first, last, finest);
    if (!found) return found.error();
    way = std::move(found).value();
    if (way.points.empty()) return noWay("no way of known girth leads from one to the other");
    least = -way.height;
  } while (finest > kFinestShare * least * (1 + kFinestShare));

  Bottleneck result;
  const auto place = static_cast<std::size_t>(
      std::max_element(way.values.begin(), way.values.end()) - way.values.begin());
  result.place = way.points[place];
  result.way = std::move(way.points);
  auto loop = solver.loop(result.place, context.ofOneThread());
  if (!loop) return loop.error();
  result.girth = loop.value().length;
  if (least < narrowerEnd) {
    // Between two points of the way the girth may be less by a piece's length.
    auto neck = neckAt(mesh, *unfolding, loop.value(), least - finest);
    result.kind = neck ? BottleneckKind::Neck : BottleneckKind::Pass;
    if (neck) {
      result.girth = neck->length;
      result.points = std::move(neck->points);
      if (auto sides = sidesOf(mesh, result.points)) result.sides = std::move(sides).value();
    }
  }
  if (result.points.empty()) result.points = std::move(loop).value().points;
  const std::vector<Vec3> places = loops::placesOf(mesh, result.points);
  if (!places.empty()) {
    const loops::LoopShape shape = loops::shapeOf(places);
    result.centre = shape.centre;
    result.area = shape.area;
  }
  if (context.onProgress) context.onProgress(1);
  return result;
}

}  // namespace girth
