#include "analysis/contour.h"

#include <algorithm>

#include "mesh/vector.h"

namespace girth {

namespace {

/// Goes on from an edge through the face of `halfedge`, one of its two: the halfedge of the next
/// crossed edge that lies in this face; none where the line ends.
Halfedge acrossFace(const std::vector<bool>& crossed, Halfedge halfedge) {
  const Halfedge next = SurfaceMesh::next(halfedge), previous = SurfaceMesh::previous(halfedge);
  if (crossed[next] == crossed[previous]) return Halfedge::none;
  return crossed[next] ? next : previous;
}

}  // namespace

std::vector<ContourLine> contourLines(const SurfaceMesh& mesh, const std::vector<Halfedge>& edges,
                                      const std::vector<bool>& crossed) {
  std::vector<bool> drawn(mesh.halfedgeCount(), false);
  const auto markDrawn = [&](Halfedge halfedge) {
    drawn[halfedge] = true;
    const Halfedge twin = mesh.twin(halfedge);
    if (twin != Halfedge::none) drawn[twin] = true;
  };
  // From `halfedge` on through its face; true when it comes back to where `points` began.
  const auto follow = [&](Halfedge halfedge, std::vector<SurfacePoint>& points) {
    while (halfedge != Halfedge::none) {
      const Halfedge reached = acrossFace(crossed, halfedge);
      if (reached == Halfedge::none) return false;
      if (drawn[reached]) return true;
      markDrawn(reached);
      points.push_back(SurfacePoint::onHalfedge(reached, 0.5));
      halfedge = mesh.twin(reached);
    }
    return false;
  };

  std::vector<ContourLine> lines;
  for (const Halfedge edge : edges) {
    if (drawn[edge]) continue;
    markDrawn(edge);
    ContourLine line;
    line.points.push_back(SurfacePoint::onHalfedge(edge, 0.5));
    line.closed = follow(edge, line.points);
    if (!line.closed) {
      std::reverse(line.points.begin(), line.points.end());
      follow(mesh.twin(edge), line.points);
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

double lengthOf(const SurfaceMesh& mesh, const ContourLine& line) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    length += norm(positionOf(mesh, line.points[i + 1]) - positionOf(mesh, line.points[i]));
  }
  if (line.closed) {
    length += norm(positionOf(mesh, line.points.back()) - positionOf(mesh, line.points.front()));
  }
  return length;
}

}  // namespace girth
