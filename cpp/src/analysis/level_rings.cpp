#include "analysis/level_rings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "girth/transfer.h"
#include "mesh/vector.h"
#include "no_value.h"

namespace girth {

namespace {

/// The point at a share of the side between two corners of a face.
SurfacePoint between(Face face, Index from, Index to, double share) {
  return to == (from + 1) % 3 ? SurfacePoint::onHalfedge(SurfaceMesh::side(face, from), share)
                              : SurfacePoint::onHalfedge(SurfaceMesh::side(face, to), 1 - share);
}

/// Calls `visit(level, face, a, b)` for each face that the ring at levels[level] crosses, from a to
/// b.
template <class Visit>
void forEachSegment(const SurfaceMesh& mesh, std::span<const double> heights,
                    std::span<const double> leaves, std::span<const double> levels, Visit visit) {
  for (const Face face : mesh.faces()) {
    const std::array<Vertex, 3> corners = mesh.faceVertices(face);
    std::array<Index, 3> low{0, 1, 2};
    std::sort(low.begin(), low.end(), [&](Index a, Index b) {
      return std::pair(heights[corners[a]], corners[a]) <
             std::pair(heights[corners[b]], corners[b]);
    });
    std::array<double, 3> height{};
    for (std::size_t i = 0; i < 3; ++i) height[i] = heights[corners[low[i]]];
    if (!std::isfinite(height[2])) continue;
    const double last = std::min(height[2], leaves[corners[low[2]]]);
    const auto begin = std::upper_bound(levels.begin(), levels.end(), height[0]);
    const auto end = std::upper_bound(begin, levels.end(), last);
    for (auto at = begin; at < end; ++at) {
      const double t = *at;
      const bool below = t <= height[1];
      const std::size_t from = below ? 0 : 1, to = below ? 1 : 2;
      visit(static_cast<std::size_t>(at - levels.begin()), face,
            between(face, low[0], low[2], (t - height[0]) / (height[2] - height[0])),
            between(face, low[from], low[to], (t - height[from]) / (height[to] - height[from])));
    }
  }
}

/// Values that differ by less than this share are equal.
constexpr double kEqual = 1e-9;

/// A length that distinguishes points of edges by the shape of what is around them, and not by
/// numbers: points that are alike in a symmetric surface have the same one, but for rounding.
double signatureOf(const SurfaceMesh& mesh, std::span<const double> heights,
                   const SurfacePoint& point) {
  const Halfedge h = point.halfedge();
  const double fromLower =
      heights[mesh.from(h)] < heights[mesh.to(h)] ? point.weights[1] : point.weights[0];
  double around = 0;
  for (const Halfedge side : {h, mesh.twin(h)}) {
    if (side == Halfedge::none) continue;
    around += mesh.length(SurfaceMesh::next(side)) + mesh.length(SurfaceMesh::previous(side));
  }
  constexpr double kShare = 0.618, kAround = 0.317;  // no two shapes agree by chance
  return (1 + kShare * fromLower) * mesh.length(h) + kAround * around;
}

bool isEqual(double a, double b) { return std::fabs(a - b) <= kEqual * std::fabs(b); }

double lengthBetween(const SurfaceMesh& mesh, const SurfacePoint& a, const SurfacePoint& b) {
  return norm(positionOf(mesh, b) - positionOf(mesh, a));
}

}  // namespace

std::vector<double> ringLengths(const SurfaceMesh& mesh, std::span<const double> heights,
                                std::span<const double> leaves, std::span<const double> levels) {
  std::vector<double> lengths(levels.size(), 0);
  forEachSegment(mesh, heights, leaves, levels,
                 [&](std::size_t level, Face, const SurfacePoint& a, const SurfacePoint& b) {
                   lengths[level] += lengthBetween(mesh, a, b);
                 });
  return lengths;
}

std::vector<RingSegment> ringSegments(const SurfaceMesh& mesh, std::span<const double> heights,
                                      std::span<const double> leaves, double level) {
  std::vector<RingSegment> segments;
  forEachSegment(mesh, heights, leaves, {&level, 1},
                 [&](std::size_t, Face face, const SurfacePoint& a, const SurfacePoint& b) {
                   segments.push_back({face, a, b});
                 });
  return segments;
}

std::vector<RingGirth> ringGirths(const SurfaceMesh& mesh, std::span<const double> heights,
                                  std::span<const double> leaves, std::span<const double> levels,
                                  std::span<const double> girth, std::size_t shares) {
  std::vector<SurfacePoint> ends;  // two of each segment
  std::vector<std::vector<std::size_t>> segmentsAt(levels.size());
  forEachSegment(mesh, heights, leaves, levels,
                 [&](std::size_t level, Face, const SurfacePoint& a, const SurfacePoint& b) {
                   segmentsAt[level].push_back(ends.size());
                   ends.insert(ends.end(), {a, b});
                 });
  const std::vector<double> values = interpolated(mesh, girth, ends, kSteepestGirth);

  std::vector<RingGirth> rings;
  for (const std::vector<std::size_t>& segments : segmentsAt) {
    RingGirth& ring = rings.emplace_back();
    struct Segment {
      double girth, length;
      std::size_t end;
      double signature;
    };
    std::vector<Segment> known;
    double knownLength = 0;
    for (const std::size_t a : segments) {
      const double length = lengthBetween(mesh, ends[a], ends[a + 1]);
      ring.length += length;
      const double mean = (values[a] + values[a + 1]) / 2;
      if (std::isnan(mean) || !(length > 0)) continue;
      knownLength += length;
      const double ofA = signatureOf(mesh, heights, ends[a]);
      const double ofB = signatureOf(mesh, heights, ends[a + 1]);
      const bool isA = isEqual(values[a], values[a + 1]) ? ofA <= ofB : values[a] < values[a + 1];
      known.push_back({mean, length, isA ? a : a + 1, isA ? ofA : ofB});
    }
    std::sort(known.begin(), known.end(), [](const Segment& a, const Segment& b) {
      return std::pair(a.girth, a.end) < std::pair(b.girth, b.end);
    });
    ring.median = kNoValue;
    if (known.empty()) continue;
    double sum = 0;
    for (const Segment& segment : known) {
      sum += segment.length;
      if (2 * sum < knownLength * (1 - kEqual)) continue;
      ring.median = segment.girth;
      break;
    }
    // The shape decides between equal ones, so that rounding decides nothing.
    for (auto begin = known.begin(); begin != known.end();) {
      const auto end = std::find_if(begin, known.end(), [&](const Segment& segment) {
        return !isEqual(segment.girth, begin->girth);
      });
      std::sort(begin, end, [](const Segment& a, const Segment& b) {
        return std::pair(a.signature, a.end) < std::pair(b.signature, b.end);
      });
      begin = end;
    }
    auto least = known.begin();
    for (auto at = known.begin(); at != known.end(); ++at) {
      const double here = values[at->end], best = values[least->end];
      if (isEqual(here, best) ? at->signature < least->signature : here < best) least = at;
    }
    ring.points.push_back({values[least->end], ends[least->end]});
    sum = 0;
    std::size_t share = 0;
    for (auto at = known.begin(); at != known.end(); ++at) {
      const Segment& segment = *at;
      sum += segment.length;
      while (share < shares &&
             sum * static_cast<double>(2 * shares) >=
                 knownLength * static_cast<double>(2 * share + 1) * (1 - kEqual)) {
        ring.points.push_back({values[segment.end], ends[segment.end]});
        if (share++ != shares / 2) continue;
        const auto isAlike = [&](const Segment& other) {
          return isEqual(other.girth, segment.girth);
        };
        const std::size_t first = std::find_if(known.begin(), known.end(), isAlike)->end;
        const std::size_t last = std::find_if(known.rbegin(), known.rend(), isAlike)->end;
        ring.middles.push_back({values[first], ends[first]});
        if (last != first) ring.middles.push_back({values[last], ends[last]});
      }
    }
  }
  return rings;
}

}  // namespace girth
