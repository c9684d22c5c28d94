#include "girth/level_curves.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "mesh/level_walk.h"

namespace girth {
namespace {

class LevelCurves {
 public:
  LevelCurves(const SurfaceMesh& mesh, std::span<const double> values, double level)
      : mesh_(mesh),
        values_(values),
        level_(level),
        walk_(mesh, values, level),
        isDone_(mesh.halfedgeCount(), false) {}

  std::vector<SurfaceCurve> all() {
    // Curves that begin at the boundary or beside a vertex without a value come first, from their
    // ends.
    for (const bool fromEnds : {true, false}) {
      for (const Halfedge h : mesh_.halfedges()) {
        if (isDone_[h] || !walk_.rises(h) || !isWhole(h) || (fromEnds && !isEnd(mesh_.twin(h))))
          continue;
        follow(h);
      }
    }
    return std::move(curves_);
  }

 private:
  /// Whether all corners of a halfedge's face have values.
  bool isWhole(Halfedge h) const {
    const auto corners = mesh_.faceVertices(SurfaceMesh::faceOf(h));
    return std::none_of(corners.begin(), corners.end(),
                        [&](Vertex v) { return std::isnan(values_[v]); });
  }
  bool isEnd(Halfedge h) const { return h == Halfedge::none || !isWhole(h); }
  SurfacePoint pointOn(Halfedge h) const {
    const double from = values_[mesh_.from(h)], to = values_[mesh_.to(h)];
    // Halves, so that no difference of two numbers is infinite.
    const double share = (level_ / 2 - from / 2) / (to / 2 - from / 2);
    return SurfacePoint::onHalfedge(h, std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.5);
  }

  void follow(Halfedge start) {
    SurfaceCurve curve{pointOn(start)};
    for (Halfedge h = start;;) {
      isDone_[h] = true;
      // Out through the side that falls.
      const Halfedge out = walk_.sideOf(SurfaceMesh::faceOf(h), false);
      const Halfedge twin = mesh_.twin(out);
      if (isEnd(twin)) {
        curve.push_back(pointOn(out));
        break;
      }
      curve.push_back(twin == start ? curve.front() : pointOn(twin));
      if (twin == start) break;
      h = twin;
    }
    curves_.push_back(std::move(curve));
  }

  const SurfaceMesh& mesh_;
  std::span<const double> values_;
  double level_;
  LevelWalk walk_;
  std::vector<bool> isDone_;
  std::vector<SurfaceCurve> curves_;
};

}  // namespace

Result<std::vector<SurfaceCurve>> levelCurves(const SurfaceMesh& mesh,
                                              std::span<const double> values, double level) {
  if (values.size() != mesh.vertexCount()) {
    return makeError(ErrorCode::Usage, -1,
                     std::to_string(values.size()) + " values for " +
                         std::to_string(mesh.vertexCount()) + " vertices");
  }
  if (!std::isfinite(level)) {
    return makeError(ErrorCode::InvalidOption, -1, "the level of a contour is a finite number");
  }
  return LevelCurves(mesh, values, level).all();
}

}  // namespace girth
