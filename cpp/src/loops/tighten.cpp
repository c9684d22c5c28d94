#include "girth/tighten.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "geodesic/locate.h"
#include "geodesic/tolerances.h"
#include "geodesic/unfolding.h"
#include "girth/geodesic_solver.h"
#include "loops/cut/faces_of_points.h"
#include "loops/tight/taut_path.h"
#include "mesh/vector.h"

namespace girth {
namespace {

using geodesic::Unfolding;
using loops::Tightened;

Error tighteningCancelled() {
  return makeError(ErrorCode::Cancelled, -1, "drawing the curve tight was cancelled");
}

/// The curve from one given point to the next: points of the mesh, each two neighbours in one face.
using Joint = std::vector<SurfacePoint>;

class Drawing {
 public:
  Drawing(const SurfaceMesh& mesh, const TightenOptions& options, const ExecutionContext& context)
      : mesh_(mesh), options_(options), context_(context), unfolding_(mesh) {}

  Result<TightCurve> run() {
    if (auto error = readPoints()) return *std::move(error);
    if (auto error = join()) return *std::move(error);
    TightCurve curve;
    curve.component = componentAtPoint(given_[0]);
    const bool isClosed = options_.closed && given_.size() > 1;
    curve.kind = options_.closed ? TightKind::Loop : TightKind::Path;
    if (isClosed && !options_.fixed) {
      if (auto error = addPieceClosed(curve)) return *std::move(error);
    } else if (options_.fixed && given_.size() > 1) {
      for (std::size_t i = 0; i < joints_.size(); ++i) {
        const SurfacePoint &start = given_[i], &end = given_[(i + 1) % given_.size()];
        if (auto error = addPiece(curve, start, end, joints_[i], true)) {
          return *std::move(error);
        }
      }
    } else {
      std::vector<SurfacePoint> points = allPoints();
      if (auto error = addPiece(curve, given_.front(), given_.back(), points, false)) {
        return *std::move(error);
      }
    }
    finish(curve);
    if (context_.onProgress) context_.onProgress(1);
    return curve;
  }

 private:
  /// The given points where they belong: at vertices and on edges, if they lie there but for
  /// kTouch.
  std::optional<Error> readPoints() {
    if (options_.points.empty()) {
      Error error = makeError(ErrorCode::InvalidOption, -1, "the curve has no points");
      error.hint = "name one point or more";
      return error;
    }
    for (const SurfacePoint& point : options_.points) {
      const auto named = geodesic::locate(unfolding_, point);
      if (!named) return named.error();
      SurfacePoint near = unfolding_.toMesh(named.value());
      for (double& share : near.weights) share = share < geodesic::kTouch ? 0 : share;
      const auto located = geodesic::locate(unfolding_, near);
      if (!located) return located.error();
      given_.push_back(unfolding_.toMesh(located.value()));
    }
    if (options_.closed && given_.size() > 1 && isSame(given_.front(), given_.back())) {
      given_.pop_back();
    }
    const Index component = componentAtPoint(given_[0]);
    for (std::size_t i = 1; i < given_.size(); ++i) {
      if (componentAtPoint(given_[i]) == component) continue;
      Error error = makeError(ErrorCode::InvalidPoint, static_cast<std::int64_t>(i),
                              "points " + std::to_string(i - 1) + " and " + std::to_string(i) +
                                  " of the curve lie in different components");
      error.hint = "choose points that a way over the surface joins";
      return error;
    }
    return std::nullopt;
  }

  std::optional<Error> join() {
    const std::size_t count = given_.size();
    const std::size_t joints = count == 1 ? 0 : options_.closed ? count : count - 1;
    for (std::size_t i = 0; i < joints; ++i) {
      if (context_.cancelled()) return tighteningCancelled();
      const SurfacePoint &start = given_[i], &end = given_[(i + 1) % count];
      Joint joint;
      if (loops::commonFace(mesh_, start, end)) {
        joint = {start, end};
      } else {
        auto path = solver().path(start, end, context_.ofOneThread());
        if (!path) return path.error();
        joint = std::move(path.value().points);
        setEnds(joint, start, end);
      }
      joints_.push_back(std::move(joint));
    }
    return std::nullopt;
  }

  /// Ends a path at the given points to the last bit: in place of its own ends or, where these lie
  /// at a vertex beside, behind them.
  void setEnds(std::vector<SurfacePoint>& path, const SurfacePoint& start,
               const SurfacePoint& end) const {
    if (path.size() > 1 && loops::commonFace(mesh_, start, path[1])) {
      path.front() = start;
    } else {
      path.insert(path.begin(), start);
    }
    if (loops::commonFace(mesh_, path[path.size() - 2], end)) {
      path.back() = end;
    } else {
      path.push_back(end);
    }
  }

  double lengthThrough(const std::vector<SurfacePoint>& points) const {
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      length += norm(positionOf(mesh_, points[i]) - positionOf(mesh_, points[i - 1]));
    }
    return length;
  }

  std::vector<SurfacePoint> allPoints() const {
    std::vector<SurfacePoint> points{given_[0]};
    for (const Joint& joint : joints_) {
      points.insert(points.end(), joint.begin() + 1, joint.end());
    }
    return points;
  }

  std::vector<SurfacePoint> fromMesh(const std::vector<SurfacePoint>& points) const {
    std::vector<SurfacePoint> own;
    own.reserve(points.size());
    for (const SurfacePoint& point : points) own.push_back(unfolding_.fromMesh(point));
    return own;
  }

  /// Adds the closed curve as one piece.
  std::optional<Error> addPieceClosed(TightCurve& curve) {
    std::vector<SurfacePoint> points = allPoints();
    TightPiece piece;
    piece.lengthBefore = lengthThrough(points);
    points.pop_back();
    auto loop = loops::looseClosed(unfolding_, fromMesh(points));
    if (!loop) return apart();
    const Tightened outcome = loops::tightenInPlace(unfolding_, *loop, context_);
    if (context_.cancelled()) return tighteningCancelled();
    piece.start = piece.end = given_[0];
    if (outcome == Tightened::Contracted) {
      piece.promise = TightPromise::Shortest;
    } else {
      piece.length = loops::lengthOf(unfolding_, *loop);
      piece.promise = outcome == Tightened::GaveUp       ? TightPromise::Shorter
                      : hasConvexVertex(curve.component) ? TightPromise::Local
                                                         : TightPromise::Shortest;
      curve.points = loops::pointsOf(unfolding_, *loop);
      piece.start = piece.end = curve.points.front();
    }
    curve.pieces.push_back(piece);
    return std::nullopt;
  }

  /// Adds a piece between two points. `isShortest`: a shortest path joins them.
  std::optional<Error> addPiece(TightCurve& curve, const SurfacePoint& start,
                                const SurfacePoint& end, const std::vector<SurfacePoint>& points,
                                bool isShortest) {
    TightPiece piece;
    piece.start = start;
    piece.end = end;
    piece.lengthBefore = lengthThrough(points);
    auto path = loops::loosePath(unfolding_, fromMesh(points));
    if (!path) return apart();
    const Tightened outcome = loops::tightenBetween(unfolding_, *path, context_);
    if (context_.cancelled()) return tighteningCancelled();
    piece.length = loops::lengthOf(unfolding_, *path);
    if (isShortest || piece.length == 0) {
      piece.promise = TightPromise::Shortest;
    } else if (outcome != Tightened::GaveUp) {
      const auto promise = promiseOf(curve.component, start, end, piece.length);
      if (!promise) return promise.error();
      piece.promise = promise.value();
    }
    const std::vector<SurfacePoint> tight = loops::pointsOf(unfolding_, *path);
    curve.points.insert(curve.points.end(), tight.begin() + (curve.points.empty() ? 0 : 1),
                        tight.end());
    curve.pieces.push_back(piece);
    return std::nullopt;
  }

  /// The promise for a locally shortest curve: by the surface, or by the distance of its ends.
  Result<TightPromise> promiseOf(Index component, const SurfacePoint& start,
                                 const SurfacePoint& end, double length) {
    if (!hasConvexVertex(component)) return TightPromise::Shortest;
    const auto path = solver().path(start, end, context_.ofOneThread());
    if (path) {
      return length <= path.value().length * (1 + geodesic::kShortest) ? TightPromise::Shortest
                                                                       : TightPromise::Local;
    }
    // Where the distance takes too long, the curve is good without it.
    if (path.error().code == ErrorCode::LimitExceeded) return TightPromise::Local;
    return path.error();
  }

  void finish(TightCurve& curve) const {
    curve.promise = TightPromise::Shortest;
    for (const TightPiece& piece : curve.pieces) {
      curve.lengthBefore += piece.lengthBefore;
      curve.length += piece.length;
      curve.promise = std::max(curve.promise, piece.promise);
    }
    if (curve.length > 0) return;
    curve.kind = TightKind::Point;
    curve.points.clear();
  }

  bool hasConvexVertex(Index component) {
    if (!hasConvex_) {
      hasConvex_ = false;
      for (const Vertex v : mesh_.vertices()) {
        if (mesh_.componentOf(v) == component && !mesh_.isBoundary(v) &&
            mesh_.totalAngle(v) < 2 * kPi - geodesic::kFlatAngle) {
          hasConvex_ = true;
          break;
        }
      }
    }
    return *hasConvex_;
  }

  GeodesicSolver& solver() {
    if (!solver_) solver_ = std::make_unique<GeodesicSolver>(mesh_);
    return *solver_;
  }

  Index componentAtPoint(const SurfacePoint& point) const {
    return mesh_.componentOf(mesh_.faceVertices(loops::faceAt(mesh_, point))[0]);
  }

  bool isSame(const SurfacePoint& a, const SurfacePoint& b) const {
    return a.kind == b.kind && a.element == b.element && a.weights == b.weights;
  }

  static Error apart() {
    return makeError(ErrorCode::Internal, -1, "neighbours of the curve lie in no common face");
  }

  const SurfaceMesh& mesh_;
  const TightenOptions& options_;
  const ExecutionContext& context_;
  const Unfolding unfolding_;
  std::unique_ptr<GeodesicSolver> solver_;
  /// Points of the mesh.
  std::vector<SurfacePoint> given_;
  std::vector<Joint> joints_;
  std::optional<bool> hasConvex_;
};

}  // namespace

std::string_view toString(TightKind kind) {
  switch (kind) {
    case TightKind::Path:
      return "path";
    case TightKind::Loop:
      return "loop";
    case TightKind::Point:
      break;
  }
  return "point";
}

std::string_view toString(TightPromise promise) {
  switch (promise) {
    case TightPromise::Shortest:
      return "shortest";
    case TightPromise::Local:
      return "local";
    case TightPromise::Shorter:
      break;
  }
  return "shorter";
}

Result<TightCurve> tighten(const SurfaceMesh& mesh, const TightenOptions& options,
                           const ExecutionContext& context) {
  return Drawing(mesh, options, context).run();
}

}  // namespace girth
