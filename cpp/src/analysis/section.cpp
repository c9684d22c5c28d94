#include "girth/section.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "analysis/convex_hull.h"
#include "analysis/inscribed_circle.h"
#include "analysis/plane_frame.h"
#include "analysis/polygon.h"
#include "girth/girth_solver.h"
#include "girth/parallel.h"
#include "girth/shape_diameter.h"
#include "infinity.h"
#include "least_between.h"
#include "mesh/angles.h"
#include "mesh/check_point.h"
#include "mesh/level_walk.h"
#include "mesh/vector.h"
#include "no_value.h"

namespace girth {
namespace {

/// A vertex nearer to the plane than this share of the greatest coordinate lies in it.
constexpr double kInPlane = 1e-12;
/// An area of less than this share of the squared perimeter has no sign.
constexpr double kNoArea = 1e-14;
/// So many planes are cut by one thread at a time, with one list of the faces that it has visited.
constexpr std::size_t kPlanesAtOnce = 16;
/// So many are measured by one thread at a time.
constexpr std::size_t kMeasuredAtOnce = 256;

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

std::string inWords(double height) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.6g", height);
  return text.data();
}

Error cancelledSections() {
  return makeError(ErrorCode::Cancelled, -1, "the sections were cancelled");
}

/// A closed curve flat in the plane, and what it encloses.
struct Outline {
  std::vector<Point2> corners;
  double area{0};  ///< signed: positive where it runs counter-clockwise
  Point2 moment;   ///< the centroid times that area
};

/// The faces that planes cross, those of plane k from starts[k] to starts[k + 1].
struct CrossedFaces {
  std::span<const Face> of(std::size_t plane) const {
    return std::span(faces).subspan(starts[plane], starts[plane + 1] - starts[plane]);
  }

  std::vector<std::size_t> starts;
  std::vector<Face> faces;
};

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

  /// The height of each vertex along the normal.
  const std::vector<double>& heights() const { return heights_; }
  /// A vertex nearer to a plane than this lies in it.
  double slack() const { return slack_; }

  /// The vertices at whose heights the measures may jump: no neighbour lies above, or none below,
  /// or one as high.
  std::vector<bool> mayJump() const {
    constexpr unsigned kBelow = 1, kAbove = 2, kLevel = 4;
    std::vector<unsigned> seen(heights_.size(), 0);
    for (const Halfedge h : mesh_.halfedges()) {
      const double rise = heights_[mesh_.to(h)] - heights_[mesh_.from(h)];
      const bool isLevel = std::fabs(rise) <= 2 * slack_;
      seen[mesh_.from(h)] |= isLevel ? kLevel : rise > 0 ? kAbove : kBelow;
      seen[mesh_.to(h)] |= isLevel ? kLevel : rise > 0 ? kBelow : kAbove;
    }
    std::vector<bool> jumps;
    for (const unsigned one : seen) jumps.push_back(one != (kBelow | kAbove));
    return jumps;
  }

  /// The faces that each of some planes crosses, in the order of the faces. `offsets`: rising.
  CrossedFaces crossedBy(std::span<const double> offsets) const {
    std::vector<double> levels;
    for (const double offset : offsets) levels.push_back(offset - slack_);
    const auto between = [&](Face f) {
      const auto first = std::upper_bound(levels.begin(), levels.end(), ranges_[f].first);
      const auto last = std::upper_bound(first, levels.end(), ranges_[f].second);
      return std::pair(static_cast<std::size_t>(first - levels.begin()),
                       static_cast<std::size_t>(last - levels.begin()));
    };
    CrossedFaces crossed;
    crossed.starts.assign(levels.size() + 1, 0);
    for (const Face f : mesh_.faces()) {
      const auto [first, last] = between(f);
      for (std::size_t k = first; k < last; ++k) ++crossed.starts[k + 1];
    }
    std::partial_sum(crossed.starts.begin(), crossed.starts.end(), crossed.starts.begin());
    crossed.faces.resize(crossed.starts.back());
    std::vector<std::size_t> next(crossed.starts.begin(), crossed.starts.end() - 1);
    for (const Face f : mesh_.faces()) {
      const auto [first, last] = between(f);
      for (std::size_t k = first; k < last; ++k) crossed.faces[next[k]++] = f;
    }
    return crossed;
  }

  /// The section at an offset. `visited`: for each face a stamp that differs from this one.
  Section cut(double offset, std::span<const Face> crossed, std::size_t stamp,
              std::vector<std::size_t>& visited, bool inscribed) const {
    Section section;
    section.normal = normal_;
    section.offset = offset;
    for (const Face f : crossed) {
      if (visited[f] == stamp) continue;
      if (auto curve = follow(f, offset, stamp, visited)) {
        section.curves.push_back(std::move(*curve));
      }
    }
    measure(section, inscribed);
    return section;
  }

  /// A measure of a section, without its curves.
  double measured(SectionMeasure measure, double offset, std::span<const Face> crossed) const {
    if (crossed.empty()) return 0;
    const LevelWalk walk = walkAt(offset);
    double perimeter = 0;
    std::vector<Point2> corners;
    for (const Face f : crossed) {
      const Vec3 from = positionOf(mesh_, pointOn(walk.sideOf(f, false), offset));
      const Halfedge out = walk.sideOf(f, true);
      // Beyond an inner edge, the next face begins where this one ends.
      const bool isLast = mesh_.twin(out) == Halfedge::none;
      if (measure == SectionMeasure::Tape) {
        corners.push_back(frame_.flat(from));
        if (isLast) corners.push_back(frame_.flat(positionOf(mesh_, pointOn(out, offset))));
      } else {
        perimeter += norm(positionOf(mesh_, pointOn(out, offset)) - from);
      }
    }
    return measure == SectionMeasure::Tape ? perimeterOf(convexHull(std::move(corners)))
                                           : perimeter;
  }

 private:
  LevelWalk walkAt(double offset) const { return {mesh_, heights_, offset - slack_}; }

  /// Where the plane crosses an edge that rises or falls. Both halfedges give one place.
  SurfacePoint pointOn(Halfedge h, double offset) const {
    const bool isRising = walkAt(offset).rises(h);
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
    const LevelWalk walk = walkAt(offset);
    SectionCurve curve;
    curve.inscribedCentre = {kNoValue, kNoValue, kNoValue};
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
      const Halfedge twin = mesh_.twin(walk.sideOf(first, false));
      curve.closed = twin != Halfedge::none;
      if (!curve.closed || SurfaceMesh::faceOf(twin) == start) break;
      first = SurfaceMesh::faceOf(twin);
    }
    if (curve.closed) first = start;
    add(pointOn(walk.sideOf(first, false), offset));
    for (Face f = first;;) {
      visited[f] = stamp;
      const Halfedge out = walk.sideOf(f, true), twin = mesh_.twin(out);
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

  void measure(Section& section, bool inscribed) const {
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
    if (inscribed) {
      for (SectionCurve& curve : curves) {
        curve.inscribedDiameter = 0;
        curve.inscribedCentre = curve.centre;
      }
    }
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
      if (inscribed) inscribe(curve, i, holeIn, outlines, origin);
    }
  }

  /// Finds the largest circle inside a closed curve. `holeIn`: in which curve each is a hole.
  void inscribe(SectionCurve& curve, std::size_t place, const std::vector<std::size_t>& holeIn,
                const std::vector<Outline>& outlines, const Vec3& origin) const {
    curve.inscribedCentre = curve.centre;
    if (!(curve.area > kNoArea * curve.perimeter * curve.perimeter)) return;
    std::vector<std::vector<Point2>> rings{outlines[place].corners};
    for (std::size_t j = 0; j < outlines.size(); ++j) {
      if (holeIn[j] == place) rings.push_back(outlines[j].corners);
    }
    const InscribedCircle circle = inscribedCircle(rings);
    curve.inscribedDiameter = 2 * circle.radius;
    if (circle.radius > 0) curve.inscribedCentre = planar(origin, circle.centre);
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
  std::vector<std::pair<double, double>> ranges_;  ///< heights of each face, from and to
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

Result<Sections> findSections(const SurfaceMesh& mesh, const SectionsOptions& options,
                              const ExecutionContext& context) {
  const std::vector<double>& offsets = options.offsets;
  const auto unit = unitVector(options.normal);
  if (!unit) return noDirection();
  for (const double offset : offsets) {
    if (!std::isfinite(offset)) {
      return makeError(ErrorCode::InvalidOption, -1, "the plane's offset is a finite number");
    }
  }
  const SectionCutter cutter(mesh, *unit);
  std::vector<std::size_t> order(offsets.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
    return offsets[one] < offsets[other];
  });
  std::vector<double> rising;
  for (const std::size_t place : order) rising.push_back(offsets[place]);
  const CrossedFaces crossed = cutter.crossedBy(rising);
  Sections result;
  result.sections.resize(offsets.size());
  const bool isDone =
      parallelFor(offsets.size(), kPlanesAtOnce, context, [&](std::size_t begin, std::size_t end) {
        std::vector<std::size_t> visited(mesh.faceCount(), 0);
        for (std::size_t k = begin; k < end; ++k) {
          result.sections[order[k]] =
              cutter.cut(rising[k], crossed.of(k), k + 1, visited, options.inscribed);
        }
      });
  if (!isDone) return cancelledSections();
  return result;
}

namespace {

Result<Section> onlySection(const SurfaceMesh& mesh, const SectionsOptions& plane) {
  auto all = findSections(mesh, plane, {1, nullptr, {}});
  if (!all) return all.error();
  return std::move(all.value().sections.front());
}

}  // namespace

Result<Section> findSection(const SurfaceMesh& mesh, const Vec3& normal, double offset) {
  return onlySection(mesh, {normal, {offset}, false});
}

Result<Sections> sectionsThrough(const SurfaceMesh& mesh, const SectionsThroughOptions& options,
                                 const ExecutionContext& context) {
  for (const SurfacePoint& point : options.points) {
    if (auto error = checkPoint(mesh, point)) return *std::move(error);
  }
  if (!options.across) {
    SectionsOptions planes{options.normal, {}, options.inscribed};
    for (const SurfacePoint& point : options.points) {
      const auto offset = heightOf(mesh, options.normal, point);
      if (!offset) return offset.error();
      planes.offsets.push_back(offset.value());
    }
    return findSections(mesh, planes, context);
  }
  Sections found;
  for (const SurfacePoint& point : options.points) {
    if (context.cancelled()) return cancelledSections();
    const auto normal = directionAlong(mesh, point);
    if (!normal) return normal.error();
    const double offset = dot(normal.value(), positionOf(mesh, point));
    auto section = onlySection(mesh, {normal.value(), {offset}, options.inscribed});
    if (!section) return section.error();
    found.sections.push_back(std::move(section).value());
    if (context.onProgress) {
      context.onProgress(static_cast<double>(found.sections.size()) /
                         static_cast<double>(options.points.size()));
    }
  }
  return found;
}

const SectionCurve* curveThrough(const SurfaceMesh& mesh, const Section& section,
                                 const SurfacePoint& point) {
  const Vec3 place = positionOf(mesh, point);
  const SectionCurve* nearest = nullptr;
  double least = kInfinity;
  for (const SectionCurve& curve : section.curves) {
    for (std::size_t i = 1; i < curve.points.size(); ++i) {
      const double square = squareFromSegment(place, positionOf(mesh, curve.points[i - 1]),
                                              positionOf(mesh, curve.points[i]));
      if (!(square < least)) continue;
      least = square;
      nearest = &curve;
    }
  }
  return nearest;
}

void placeOnLimbs(const SurfaceMesh& mesh, std::span<const Limb> limbs, Sections& sections) {
  std::vector<Index> limbOf(mesh.vertexCount(), kNoIndex);
  for (std::size_t i = 0; i < limbs.size(); ++i) {
    for (const Vertex v : limbs[i].vertices) {
      if (v < mesh.vertexCount()) limbOf[v] = static_cast<Index>(i);
    }
  }
  const auto limbAt = [&](const SurfacePoint& point) {
    const Halfedge h = point.halfedge();
    if (h == Halfedge::none) return limbOf[point.vertex()];
    return limbOf[point.weights[1] > 0.5 ? mesh.to(h) : mesh.from(h)];
  };
  std::vector<double> lengths(limbs.size());
  for (Section& section : sections.sections) {
    for (SectionCurve& curve : section.curves) {
      std::fill(lengths.begin(), lengths.end(), 0.0);
      for (std::size_t i = 1; i < curve.points.size(); ++i) {
        const SurfacePoint &from = curve.points[i - 1], &to = curve.points[i];
        const double half = norm(positionOf(mesh, to) - positionOf(mesh, from)) / 2;
        for (const Index limb : {limbAt(from), limbAt(to)}) {
          if (limb != kNoIndex) lengths[limb] += half;
        }
      }
      const auto most = std::max_element(lengths.begin(), lengths.end());
      const bool isOnLimb = most != lengths.end() && *most > curve.perimeter / 2;
      curve.limb = isOnLimb ? static_cast<Index>(most - lengths.begin()) : kNoIndex;
    }
  }
}

std::string_view toString(SectionExtreme extreme) {
  switch (extreme) {
    case SectionExtreme::Widest:
      return "widest";
    case SectionExtreme::Narrowest:
      return "narrowest";
  }
  return "";
}

std::string_view toString(SectionMeasure measure) {
  switch (measure) {
    case SectionMeasure::Perimeter:
      return "perimeter";
    case SectionMeasure::Tape:
      return "tape";
  }
  return "";
}

namespace {

/// Planes of one normal at some offsets, which rise, and the faces that each crosses.
class MeasuredPlanes {
 public:
  MeasuredPlanes(const SectionCutter& cutter, SectionMeasure measure, std::vector<double> offsets)
      : cutter_(cutter),
        measure_(measure),
        offsets_(std::move(offsets)),
        crossed_(cutter.crossedBy(offsets_)) {}

  /// Measures all of them. Nothing where cancelled.
  std::optional<std::vector<double>> values(const ExecutionContext& context) const {
    std::vector<double> found(offsets_.size());
    const ExecutionContext quiet{context.threads, context.cancel, {}};
    const bool isDone =
        parallelFor(found.size(), kMeasuredAtOnce, quiet, [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k) {
            found[k] = measured(k, offsets_[k]);
          }
        });
    if (!isDone) return std::nullopt;
    return found;
  }
  double offset(std::size_t plane) const { return offsets_[plane]; }
  std::size_t count() const { return offsets_.size(); }
  /// The measure at an offset where the same faces are crossed as by one of the planes.
  double measured(std::size_t plane, double offset) const {
    return cutter_.measured(measure_, offset, crossed_.of(plane));
  }

 private:
  const SectionCutter& cutter_;
  SectionMeasure measure_;
  std::vector<double> offsets_;
  CrossedFaces crossed_;
};

/// The offsets where pieces of the measure begin and end: at each height of a vertex and, where the
/// measure may jump there, just above it, where it is the limit from above.
std::vector<double> pieceEnds(const SectionCutter& cutter, const HeightRange& range) {
  const double above = 2 * cutter.slack();
  const std::vector<bool> jumps = cutter.mayJump();
  std::vector<std::pair<double, bool>> heights{{range.low, true}, {range.high, true}};
  for (std::size_t v = 0; v < jumps.size(); ++v) {
    const double height = cutter.heights()[v];
    if (height > range.low && height < range.high) heights.emplace_back(height, jumps[v]);
  }
  std::sort(heights.begin(), heights.end());
  std::vector<double> ends;
  const auto add = [&](double offset) {
    if (offset <= range.high && (ends.empty() || offset > ends.back())) ends.push_back(offset);
  };
  for (const auto& [height, jump] : heights) {
    add(height);
    if (jump) add(height + above);
  }
  return ends;
}

/// The offset of the least value: at an end of a piece, or within one where pieces are convex, not
/// linear, by the planes in their middles. `values`: at the ends. Nothing where cancelled.
std::optional<double> narrowestOffset(const SectionCutter& cutter, SectionMeasure measure,
                                      const std::vector<double>& ends,
                                      const std::vector<double>& values,
                                      const ExecutionContext& context) {
  double best = kInfinity, offset = ends.front();
  const auto take = [&](double place, double value) {
    if (!(value > 0) || !(value < best)) return;
    best = value;
    offset = place;
  };
  for (std::size_t k = 0; k < ends.size(); ++k) take(ends[k], values[k]);
  if (measure == SectionMeasure::Perimeter) return offset;
  // Just above the height of a vertex there is no piece: only the slack of its plane.
  std::vector<std::size_t> pieces;
  std::vector<double> places;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    if (ends[k] - ends[k - 1] <= 4 * cutter.slack()) continue;
    pieces.push_back(k);
    places.push_back((ends[k - 1] + ends[k]) / 2);
  }
  const MeasuredPlanes middles(cutter, measure, std::move(places));
  const auto inside = middles.values(context);
  if (!inside) return std::nullopt;
  for (std::size_t k = 0; k < middles.count(); ++k) take(middles.offset(k), (*inside)[k]);
  for (std::size_t k = 0; k < middles.count(); ++k) {
    if (context.cancelled()) return std::nullopt;
    const double middle = (*inside)[k];
    if (!(middle > 0)) continue;
    // Convex: on each half it lies above the line through the other half.
    const std::size_t end = pieces[k];
    const double bound = 2 * middle - std::max(values[end - 1], values[end]);
    if (bound >= best) continue;
    // Nearer to the height of its lowest vertex, other faces are crossed.
    const double low = ends[end - 1] + 2 * cutter.slack(), high = ends[end];
    const double exact = kInPlane * std::max(std::fabs(low), std::fabs(high));
    const LeastValue least =
        leastBetween([&](double height) { return middles.measured(k, height); }, low, high,
                     middles.offset(k), std::min(exact, (high - low) / 8));
    take(least.at, least.value);
  }
  return offset;
}

}  // namespace

Result<Section> extremeSection(const SurfaceMesh& mesh, const ExtremeSectionOptions& options,
                               const ExecutionContext& context) {
  const auto whole = heightRange(mesh, options.normal);
  if (!whole) return whole.error();
  const HeightRange range{std::max(options.low, whole.value().low),
                          std::min(options.high, whole.value().high)};
  if (!(options.low <= options.high)) {
    return makeError(ErrorCode::InvalidOption, -1, "the range of heights is no range of numbers");
  }
  const auto missed = [&] {
    Error error =
        makeError(ErrorCode::InvalidOption, -1, "no plane of the range meets the surface");
    error.hint = "along this direction the surface reaches from " + inWords(whole.value().low) +
                 " to " + inWords(whole.value().high);
    return error;
  };
  if (!(range.low <= range.high)) return missed();
  const Vec3 unit = *unitVector(options.normal);
  const SectionCutter cutter(mesh, unit);
  const std::vector<double> ends = pieceEnds(cutter, range);
  const auto values = MeasuredPlanes(cutter, options.measure, ends).values(context);
  if (!values) return makeError(ErrorCode::Cancelled, -1, "the search was cancelled");
  const auto greatest = std::max_element(values->begin(), values->end());
  if (!(*greatest > 0)) return missed();
  std::optional<double> offset = ends[static_cast<std::size_t>(greatest - values->begin())];
  if (options.extreme == SectionExtreme::Narrowest) {
    offset = narrowestOffset(cutter, options.measure, ends, *values, context);
  }
  if (!offset) return makeError(ErrorCode::Cancelled, -1, "the search was cancelled");
  return onlySection(mesh, {options.normal, {*offset}, options.inscribed});
}

Result<double> heightOf(const SurfaceMesh& mesh, const Vec3& normal, const SurfacePoint& point) {
  const auto unit = unitVector(normal);
  if (!unit) return noDirection();
  return dot(*unit, positionOf(mesh, point));
}

Result<Vec3> directionAlong(const SurfaceMesh& mesh, const SurfacePoint& point) {
  const auto loop = GirthSolver(mesh).loop(point);
  if (!loop) return loop.error();
  const std::vector<Vec3> places = polyline(mesh, loop.value());
  Vec3 twice{0, 0, 0};
  for (std::size_t i = 1; i < places.size(); ++i) {
    twice = twice + cross(places[i - 1] - places[0], places[i] - places[0]);
  }
  if (!(norm(twice) > kNoArea * loop.value().length * loop.value().length)) {
    return makeError(ErrorCode::InvalidPoint, -1,
                     "no loop that encloses an area goes round the surface at the point");
  }
  return (1 / norm(twice)) * twice;
}

}  // namespace girth
