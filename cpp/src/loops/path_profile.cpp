#include "girth/path_profile.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "girth/geodesic_solver.h"
#include "girth/girth_solver.h"
#include "infinity.h"
#include "least_between.h"
#include "loops/cut/faces_of_points.h"
#include "loops/necks/girth_at.h"
#include "mesh/vector.h"

namespace girth {
namespace {

/// Places nearer to each other than this share of the path are one.
constexpr double kSameStation = 1e-9;
/// Values that differ by less than this share are equal; places are found to this share of the way
/// between two stations.
constexpr double kEqualGirth = 1e-12;
constexpr double kExactStation = 1e-10;
/// Stations near which less is looked for.
constexpr std::size_t kMostNarrow = 16;
constexpr std::size_t kMostSamples = 10'000'000;

Error atPoint(std::size_t place, const std::string& what) {
  return makeError(ErrorCode::InvalidPoint, static_cast<std::int64_t>(place),
                   "point " + std::to_string(place) + " of the path " + what);
}

/// A path by how far along its points are.
struct Measured {
  std::vector<double> distances;
  /// A face in which each two neighbours lie.
  std::vector<Face> faces;
};

Result<Measured> measured(const SurfaceMesh& mesh, std::span<const SurfacePoint> path) {
  if (path.empty()) return makeError(ErrorCode::InvalidPoint, -1, "the path has no points");
  Measured result;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!loops::isPointOf(mesh, path[i])) return atPoint(i, "is none of the surface");
    if (i == 0) {
      result.distances.push_back(0);
      continue;
    }
    const auto common = loops::commonFace(mesh, path[i - 1], path[i]);
    if (!common) return atPoint(i, "lies in no face of the point before");
    result.faces.push_back(common->face);
    result.distances.push_back(result.distances.back() +
                               norm(positionOf(mesh, path[i]) - positionOf(mesh, path[i - 1])));
  }
  return result;
}

/// The point at a distance along a path, behind its point `i`.
SurfacePoint pointAt(const SurfaceMesh& mesh, std::span<const SurfacePoint> path,
                     const Measured& measures, std::size_t i, double distance) {
  const double before = measures.distances[i], length = measures.distances[i + 1] - before;
  const double share = length > 0 ? std::clamp((distance - before) / length, 0.0, 1.0) : 0;
  return loops::pointBetween(mesh, measures.faces[i], path[i], path[i + 1], share);
}

}  // namespace

Result<std::vector<SurfacePoint>> shortestPathThrough(const SurfaceMesh& mesh,
                                                      std::span<const SurfacePoint> points,
                                                      const ExecutionContext& context) {
  if (points.size() < 2) {
    Error error = makeError(ErrorCode::Usage, -1, "a path needs two points");
    error.hint = "name two points or more";
    return error;
  }
  GeodesicSolver solver(mesh);
  std::vector<SurfacePoint> path;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto piece = solver.path(points[i - 1], points[i], context);
    if (!piece) return piece.error();
    if (!std::isfinite(piece.value().length)) {
      Error error = makeError(ErrorCode::InvalidPoint, static_cast<std::int64_t>(i),
                              "points " + std::to_string(i - 1) + " and " + std::to_string(i) +
                                  " of the path lie in different components");
      error.hint = "choose points that a way over the surface joins";
      return error;
    }
    path.insert(path.end(), piece.value().points.begin(), piece.value().points.end());
  }
  return path;
}

Result<std::vector<PathStation>> girthAlong(const SurfaceMesh& mesh,
                                            std::span<const SurfacePoint> path,
                                            const PathProfileOptions& options,
                                            const ExecutionContext& context) {
  if (options.samples == 1 || options.samples > kMostSamples ||
      (options.samples == 0 && !options.crossings)) {
    Error error = makeError(ErrorCode::InvalidOption, -1,
                            options.samples == 0
                                ? "neither samples nor crossings are wanted"
                                : std::to_string(options.samples) + " samples are not a profile");
    error.hint = "choose 2 to 10 million samples";
    return error;
  }
  const auto measures = measured(mesh, path);
  if (!measures) return measures.error();
  const std::vector<double>& distances = measures.value().distances;
  const double length = distances.back();
  std::vector<PathStation> stations;
  if (options.crossings) {
    for (std::size_t i = 0; i < path.size(); ++i) {
      stations.push_back({distances[i], 0, LoopKind::Loop, path[i]});
    }
  }
  for (std::size_t k = 0; k < options.samples; ++k) {
    const double at = length * (static_cast<double>(k) / static_cast<double>(options.samples - 1));
    const auto behind = static_cast<std::size_t>(
        std::upper_bound(distances.begin(), distances.end(), at) - distances.begin());
    // The ends are the path's own, to the last bit.
    stations.push_back({at, 0, LoopKind::Loop,
                        behind == path.size()
                            ? path.back()
                            : pointAt(mesh, path, measures.value(), behind - 1, at)});
  }
  std::stable_sort(
      stations.begin(), stations.end(),
      [](const PathStation& a, const PathStation& b) { return a.distance < b.distance; });
  // The first of several stations at one place stays.
  std::vector<PathStation> apart;
  for (const PathStation& station : stations) {
    if (!apart.empty() && station.distance - apart.back().distance <= kSameStation * length)
      continue;
    apart.push_back(station);
  }
  std::vector<SurfacePoint> points;
  for (const PathStation& station : apart) points.push_back(station.point);
  loops::GirthAt girthAt(std::make_shared<const geodesic::Unfolding>(mesh), context);
  const auto values = girthAt.values(points, context.onProgress);
  if (!values) return values.error();
  for (std::size_t i = 0; i < apart.size(); ++i) {
    apart[i].girth = values.value()[i].length;
    apart[i].kind = values.value()[i].kind;
  }
  return apart;
}

Result<PathStation> leastAlong(const SurfaceMesh& mesh, std::span<const SurfacePoint> path,
                               std::span<const PathStation> stations,
                               const ExecutionContext& context) {
  if (stations.empty()) return makeError(ErrorCode::Usage, -1, "the path has no station");
  const auto measures = measured(mesh, path);
  if (!measures) return measures.error();
  std::vector<std::size_t> narrow;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (i > 0 && stations[i - 1].girth < stations[i].girth) continue;
    if (i + 1 < stations.size() && stations[i + 1].girth < stations[i].girth) continue;
    narrow.push_back(i);
  }
  std::stable_sort(narrow.begin(), narrow.end(), [&](std::size_t a, std::size_t b) {
    return stations[a].girth < stations[b].girth;
  });
  narrow.resize(std::min(narrow.size(), kMostNarrow));
  GirthSolver solver(mesh);
  PathStation best = stations[narrow.front()];
  std::optional<Error> failed;
  const std::vector<double>& distances = measures.value().distances;
  const auto girthAt = [&](double distance) {
    if (failed) return kInfinity;
    const auto behind = static_cast<std::size_t>(
        std::upper_bound(distances.begin(), distances.end(), distance) - distances.begin());
    const SurfacePoint point =
        behind == path.size()
            ? path.back()
            : pointAt(mesh, path, measures.value(), std::max<std::size_t>(behind, 1) - 1, distance);
    const auto value = solver.value(point, context.ofOneThread());
    if (!value) {
      failed = value.error();
      return kInfinity;
    }
    if (value.value().length < best.girth * (1 - kEqualGirth)) {
      best = {distance, value.value().length, value.value().kind, point};
    }
    return value.value().length;
  };
  for (const std::size_t i : narrow) {
    const double from = stations[i > 0 ? i - 1 : 0].distance;
    const double to = stations[std::min(i + 1, stations.size() - 1)].distance;
    if (to > from) {
      leastBetween(girthAt, from, to, stations[i].distance, kExactStation * (to - from));
    }
  }
  if (failed) return *std::move(failed);
  return best;
}

}  // namespace girth
