#include "girth/segments.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace girth {
namespace {

/// Adds the barycentric coordinates of a point of a face, times a weight.
void addShares(const SurfaceMesh& mesh, Face face, const SurfacePoint& point, double weight,
               std::array<double, 3>& shares) {
  if (point.kind == SurfacePoint::Kind::InFace) {
    for (std::size_t k = 0; k < 3; ++k) shares[k] += weight * point.weights[k];
    return;
  }
  const Halfedge h = point.halfedge();
  const auto corners = mesh.faceVertices(face);
  for (std::size_t k = 0; k < 3; ++k) {
    if (h == Halfedge::none) {
      shares[k] += corners[k] == point.vertex() ? weight : 0;
    } else if (corners[k] == mesh.from(h)) {
      shares[k] += weight * point.weights[0];
    } else if (corners[k] == mesh.to(h)) {
      shares[k] += weight * point.weights[1];
    }
  }
}

}  // namespace

PartKind Segment::kind() const {
  const auto most = std::max_element(kindAreas.begin(), kindAreas.end());
  return static_cast<PartKind>(most - kindAreas.begin());
}

KindShares Segment::shares() const {
  const auto& [body, tube, plate, unknown] = kindAreas;
  return {body / area, tube / area, plate / area, unknown / area};
}

Result<CutAtNecks> cutAtNecks(const SurfaceMesh& mesh, std::span<const Neck> necks,
                              const ExecutionContext& context) {
  std::vector<SurfaceCurve> curves;
  auto whole = cutSurface(mesh, curves, {}, context);
  if (!whole) return whole.error();
  CutAtNecks result{std::move(whole).value(), {}};
  // All at once; where some cross, one half and then the other.
  std::vector<std::pair<std::size_t, std::size_t>> pending{{0, necks.size()}};
  while (!pending.empty()) {
    const auto [begin, end] = pending.back();
    pending.pop_back();
    if (begin == end) continue;
    const std::size_t before = curves.size();
    for (std::size_t i = begin; i < end; ++i) curves.push_back(necks[i].points);
    auto cut = cutSurface(mesh, curves, {}, context);
    if (cut) {
      result.cut = std::move(cut).value();
      continue;
    }
    if (cut.error().code != ErrorCode::InvalidOption) return cut.error();
    curves.resize(before);
    if (end - begin == 1) {
      result.crossing.push_back(static_cast<Index>(begin));
      continue;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    pending.emplace_back(middle, end);
    pending.emplace_back(begin, middle);
  }
  return result;
}

std::vector<Segment> segmentsOf(const SurfaceMesh& mesh, const CutSurface& cut,
                                std::span<const SurfaceComponent> parts,
                                std::span<const PartKind> kinds, std::span<const Tip> tips) {
  std::vector<Segment> segments(parts.size());
  std::vector<Index> partOf(mesh.vertexCount(), kNoIndex);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const SurfaceComponent& part = parts[i];
    Segment& segment = segments[i];
    for (const Vertex v : part.vertices) {
      if (v >= cut.points.size()) continue;
      const SurfacePoint& point = cut.points[v];
      if (point.kind == SurfacePoint::Kind::InFace || point.halfedge() != Halfedge::none) continue;
      Index& of = partOf[point.vertex()];
      if (of == kNoIndex) of = static_cast<Index>(i);
    }
    for (const Face f : part.mesh.faces()) {
      const Face whole = cut.faces[part.faces[f]];
      if (whole == Face::none) continue;
      // Barycentric coordinates are linear: their means over a piece are those of its centroid.
      std::array<double, 3> shares{};
      const double area = part.mesh.area(f);
      for (const Vertex corner : part.mesh.faceVertices(f)) {
        addShares(mesh, whole, cut.points[part.vertices[corner]], area / 3, shares);
      }
      segment.area += area;
      const auto corners = mesh.faceVertices(whole);
      for (std::size_t k = 0; k < 3; ++k) {
        segment.kindAreas[static_cast<std::size_t>(kinds[corners[k]])] += shares[k];
      }
    }
  }
  for (std::size_t t = 0; t < tips.size(); ++t) {
    const Index part = partOf[tips[t].apex];
    if (part != kNoIndex) segments[part].tips.push_back(static_cast<Index>(t));
  }
  return segments;
}

}  // namespace girth
