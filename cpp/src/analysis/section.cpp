#include "girth/section.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "analysis/convex_hull.h"
#include "analysis/plane_frame.h"
#include "girth/parallel.h"
#include "girth/shape_diameter.h"
#include "infinity.h"
#include "mesh/angles.h"
#include "mesh/vector.h"

namespace girth {
namespace {

/// A vertex nearer to the plane than this share of the greatest coordinate lies in it.
constexpr double kInPlane = 1e-12;
/// An area of less than this share of the squared perimeter has no sign.
constexpr double kNoArea = 1e-14;
/// So many planes are cut by one thread at a time: it looks for their faces in one pass.
constexpr std::size_t kPlanesAtOnce = 16;

/// The vector with length 1; nothing where its length is 0 or not finite.
std::optional<Vec3> unitVector(const Vec3& normal) {
  const double greatest = std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)});
  if (!(greatest > 0) || !std::isfinite(greatest)) return std::nullopt;
  // Along an axis nothing is rounded.
  const Vec3 scaled = (1 / greatest) * normal;
  return (1 / norm(scaled)) * scaled;
}

Error noDirection() {
  return makeError(ErrorCode::InvalidOption, -1, "the plane's normal has no finite length above 0");
}

/// A closed curve flat in the plane, and what it encloses.
struct Outline {
  std::vector<Point2> corners;
  double area{0};  ///< signed: positive where it runs counter-clockwise
  Point2 moment;   ///< the centroid times that area
};

/// Whether a point lies inside a closed polygon: how many sides cross the ray to the right.
bool isInside(const Point2& p, const std::vector<Point2>& polygon) {
  bool isIn = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point2 &a = polygon[j], &b = polygon[i];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) isIn = !isIn;
  }
  return isIn;
}

/// The sections with planes of one normal.
class SectionCutter {
 public:
  SectionCutter(const SurfaceMesh& mesh, const Vec3& normal)
      : mesh_(mesh), normal_(normal), frame_(normal), outwards_(isInsideOut(mesh) ? -1 : 1) {
    double greatest = 0;
    for (const Vertex v : mesh.vertices()) {
      const Vec3& p = mesh.position(v);
      heights_.push_back(dot(normal, p));
      greatest = std::max({greatest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    }
    slack_ = kInPlane * greatest;
    for (const Face f : mesh.faces()) {
      const auto [a, b, c] = mesh.faceVertices(f);
      ranges_.push_back({std::min({heights_[a], heights_[b], heights_[c]}),
                         std::max({heights_[a], heights_[b], heights_[c]})});
    }
  }

  /// The sections at some offsets, in the order of these.
  void cut(std::span<const double> offsets, std::span<Section> result) const {
    std::vector<std::vector<Face>> crossed(offsets.size());
    for (const Face f : mesh_.faces()) {
      for (std::size_t k = 0; k < offsets.size(); ++k) {
        const double level = offsets[k] - slack_;
        if (ranges_[f].first < level && ranges_[f].second >= level) crossed[k].push_back(f);
      }
    }
    std::vector<std::size_t> visited(mesh_.faceCount(), 0);
    for (std::size_t k = 0; k < offsets.size(); ++k) {
      result[k].normal = normal_;
      result[k].offset = offsets[k];
      for (const Face f : crossed[k]) {
        if (visited[f] == k + 1) continue;
        if (auto curve = follow(f, offsets[k], k + 1, visited)) {
          result[k].curves.push_back(std::move(*curve));
        }
      }
      measure(result[k]);
    }
  }

 private:
  bool isBelow(Vertex v, double offset) const { return heights_[v] < offset - slack_; }
  bool rises(Halfedge h, double offset) const {
    return isBelow(mesh_.from(h), offset) && !isBelow(mesh_.to(h), offset);
  }
  /// The side of a crossed face that rises, or falls.
  Halfedge sideOf(Face face, double offset, bool isRising) const {
    for (Index k = 0; k < 3; ++k) {
      const Halfedge h = SurfaceMesh::side(face, k);
      const bool isAbove = !isBelow(mesh_.from(h), offset);
      if (isAbove != isRising && isBelow(mesh_.to(h), offset) != isRising) return h;
    }
    return Halfedge::none;
  }

  /// Where the plane crosses an edge that rises or falls. Both halfedges give one place.
  SurfacePoint pointOn(Halfedge h, double offset) const {
    const bool isRising = rises(h, offset);
    const Vertex low = isRising ? mesh_.from(h) : mesh_.to(h),
                 high = isRising ? mesh_.to(h) : mesh_.from(h);
    const double above = heights_[high] - offset, below = offset - heights_[low];
    if (above <= slack_) return SurfacePoint::atVertex(high);
    const double share = below / (above + below);
    return SurfacePoint::onHalfedge(h, isRising ? share : 1 - share);
  }

  /// The curve through a face; nothing where it is a single point.
  std::optional<SectionCurve> follow(Face start, double offset, std::size_t stamp,
                                     std::vector<std::size_t>& visited) const {
    SectionCurve curve;
    curve.component = mesh_.componentOf(mesh_.faceVertices(start)[0]);
    std::vector<SurfacePoint>& points = curve.points;
    const auto add = [&points](const SurfacePoint& point) {
      const bool isKnown = !points.empty() && points.back().kind == SurfacePoint::Kind::AtVertex &&
                           point.vertex() == points.back().vertex();
      if (!isKnown) points.push_back(point);
    };
    // Back to where it comes from: to the boundary, or round to the face again.
    Face first = start;
    for (;;) {
      const Halfedge twin = mesh_.twin(sideOf(first, offset, false));
      curve.closed = twin != Halfedge::none;
      if (!curve.closed || SurfaceMesh::faceOf(twin) == start) break;
      first = SurfaceMesh::faceOf(twin);
    }
    if (curve.closed) first = start;
    add(pointOn(sideOf(first, offset, false), offset));
    for (Face f = first;;) {
      visited[f] = stamp;
      const Halfedge out = sideOf(f, offset, true), twin = mesh_.twin(out);
      if (twin != Halfedge::none && SurfaceMesh::faceOf(twin) == first) break;
      add(pointOn(out, offset));
      if (twin == Halfedge::none) break;
      f = SurfaceMesh::faceOf(twin);
    }
    if (curve.closed) add(points.front());
    if (points.size() < 2) return std::nullopt;
    if (outwards_ < 0) std::reverse(points.begin(), points.end());
    return curve;
  }

  void measure(Section& section) const {
    std::vector<SectionCurve>& curves = section.curves;
    if (curves.empty()) return;
    // Flat, round a point of the section: far from the origin nothing is lost.
    const Vec3 origin = positionOf(mesh_, curves.front().points.front());
    std::vector<Outline> outlines;
    std::vector<Point2> all;
    for (SectionCurve& curve : curves) {
      outlines.push_back(outlineOf(curve, origin));
      const std::vector<Point2> hull = convexHull(outlines.back().corners);
      curve.tape = perimeterOf(hull);
      const Widths widths = widthsOf(hull);
      curve.leastWidth = widths.least;
      curve.greatestWidth = widths.greatest;
      section.perimeter += curve.perimeter;
      all.insert(all.end(), hull.begin(), hull.end());
    }
    section.tape = perimeterOf(convexHull(std::move(all)));
    const std::vector<std::size_t> holeIn = findHoles(curves, outlines);
    for (std::size_t i = 0; i < curves.size(); ++i) {
      SectionCurve& curve = curves[i];
      if (!curve.closed) continue;
      double area = std::fabs(outlines[i].area);
      const double sign = outlines[i].area < 0 ? -1 : 1;
      Point2 moment{sign * outlines[i].moment.x, sign * outlines[i].moment.y};
      for (std::size_t j = 0; j < curves.size(); ++j) {
        if (holeIn[j] != i) continue;
        area += outlines[j].area;  // negative
        moment = {moment.x + outlines[j].moment.x, moment.y + outlines[j].moment.y};
      }
      curve.area = std::max(area, 0.0);
      curve.equivalentDiameter = 2 * std::sqrt(curve.area / kPi);
      if (curve.area > kNoArea * curve.perimeter * curve.perimeter) {
        curve.centre = planar(origin, {moment.x / curve.area, moment.y / curve.area});
      }
      if (!curve.hole) section.area += curve.area;
    }
  }

  /// Measures the curve's length, and its middle by length.
  Outline outlineOf(SectionCurve& curve, const Vec3& origin) const {
    Outline outline;
    Vec3 before = positionOf(mesh_, curve.points.front());
    outline.corners.push_back(frame_.flat(before - origin));
    Point2 middle;
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      const Vec3 here = positionOf(mesh_, curve.points[i]);
      outline.corners.push_back(frame_.flat(here - origin));
      const double length = norm(here - before);
      const Point2 &a = outline.corners[i - 1], &b = outline.corners[i];
      middle = {middle.x + length * (a.x + b.x) / 2, middle.y + length * (a.y + b.y) / 2};
      curve.perimeter += length;
      before = here;
    }
    if (curve.perimeter > 0) {
      middle = {middle.x / curve.perimeter, middle.y / curve.perimeter};
    }
    curve.centre = planar(origin, middle);
    if (!curve.closed) return outline;
    outline.corners.pop_back();
    const Point2 base = outline.corners.front();
    for (std::size_t i = 1; i + 1 < outline.corners.size(); ++i) {
      const Point2 &a = outline.corners[i], &b = outline.corners[i + 1];
      const double part = cross(base, a, b) / 2;
      outline.area += part;
      outline.moment.x += part * (base.x + a.x + b.x) / 3;
      outline.moment.y += part * (base.y + a.y + b.y) / 3;
    }
    return outline;
  }

  Vec3 planar(const Vec3& origin, const Point2& p) const { return origin + frame_.inSpace(p); }

  /// Each clockwise curve is a hole in the smallest counter-clockwise one that lies round it: in
  /// which curve each is one, or none (the number of curves).
  static std::vector<std::size_t> findHoles(std::vector<SectionCurve>& curves,
                                            const std::vector<Outline>& outlines) {
    std::vector<std::size_t> holeIn(curves.size(), curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const double least = kNoArea * curves[i].perimeter * curves[i].perimeter;
      if (!curves[i].closed || !(outlines[i].area < -least)) continue;
      const Point2 &a = outlines[i].corners[0], &b = outlines[i].corners[1];
      const Point2 middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
      double smallest = kInfinity;
      for (std::size_t j = 0; j < curves.size(); ++j) {
        const double area = outlines[j].area;
        if (!curves[j].closed || !(area > -outlines[i].area) || !(area < smallest)) continue;
        if (!isInside(middle, outlines[j].corners)) continue;
        smallest = area;
        holeIn[i] = j;
      }
      curves[i].hole = holeIn[i] < curves.size();
    }
    return holeIn;
  }

  const SurfaceMesh& mesh_;
  Vec3 normal_;
  PlaneFrame frame_;
  int outwards_;
  double slack_{0};
  std::vector<double> heights_;
  std::vector<std::pair<double, double>> ranges_;  ///< of the faces
};

}  // namespace

Result<HeightRange> heightRange(const SurfaceMesh& mesh, const Vec3& normal) {
  const auto unit = unitVector(normal);
  if (!unit) return noDirection();
  HeightRange range{kInfinity, -kInfinity};
  for (const Vertex v : mesh.vertices()) {
    const double height = dot(*unit, mesh.position(v));
    range = {std::min(range.low, height), std::max(range.high, height)};
  }
  return range;
}

Result<Sections> findSections(const SurfaceMesh& mesh, const Vec3& normal,
                              std::span<const double> offsets, const ExecutionContext& context) {
  const auto unit = unitVector(normal);
  if (!unit) return noDirection();
  for (const double offset : offsets) {
    if (!std::isfinite(offset)) {
      return makeError(ErrorCode::InvalidOption, -1, "the plane's offset is a finite number");
    }
  }
  const SectionCutter cutter(mesh, *unit);
  Sections result;
  result.sections.resize(offsets.size());
  const bool isDone =
      parallelFor(offsets.size(), kPlanesAtOnce, context, [&](std::size_t begin, std::size_t end) {
        cutter.cut(offsets.subspan(begin, end - begin),
                   std::span(result.sections).subspan(begin, end - begin));
      });
  if (!isDone) return makeError(ErrorCode::Cancelled, -1, "the sections were cancelled");
  return result;
}

Result<Section> findSection(const SurfaceMesh& mesh, const Vec3& normal, double offset) {
  auto all = findSections(mesh, normal, {&offset, 1}, {1, nullptr, {}});
  if (!all) return all.error();
  return std::move(all.value().sections.front());
}

}  // namespace girth
