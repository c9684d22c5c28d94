#include "girth/print_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "analysis/regions.h"
#include "descriptors/facing_surface.h"
#include "girth/parallel.h"
#include "girth/shape_diameter.h"
#include "girth/vertex_areas.h"
#include "girth/vertex_function.h"
#include "mesh/angles.h"
#include "mesh/nearest_point.h"
#include "mesh/vector.h"
#include "part_of_work.h"

namespace girth {

namespace {

constexpr double kNoMeasure = std::numeric_limits<double>::infinity();
/// By what share of a limit a measure may be below it: coordinates of single precision.
constexpr double kSinglePrecision = 1e-6;
constexpr std::size_t kFacesAtOnce = 16;
/// Samples that tell how much of the faces fails: of all faces together, and of one.
constexpr std::size_t kMostSamplesInAll = 1u << 18;
constexpr int kFinestSamples = 5;

std::optional<Error> usage(const std::string& message) {
  return makeError(ErrorCode::Usage, -1, message);
}

std::optional<Error> checkLimit(double value, const char* name) {
  if (value >= 0) return std::nullopt;
  return usage(std::string(name) + " " + std::to_string(value) + " is not a number of at least 0");
}

std::optional<Error> checkCount(const SurfaceMesh& mesh, std::span<const double> values,
                                bool needed, const char* name) {
  if (!needed || values.size() == mesh.vertexCount()) return std::nullopt;
  return usage(std::to_string(values.size()) + " values of the " + name + " for " +
               std::to_string(mesh.vertexCount()) + " vertices");
}

double orNever(double value) { return std::isnan(value) ? kNoMeasure : value; }

/// Elements, some of which belong together.
class Groups {
 public:
  explicit Groups(std::size_t count) : parents_(count) {
    for (std::size_t i = 0; i < count; ++i) parents_[i] = i;
  }
  std::size_t of(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  /// The lower number stands for a group.
  void join(std::size_t a, std::size_t b) {
    a = of(a);
    b = of(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parents_;
};

/// The scale from which a measure reaches the limit.
double scaleThatPasses(double limit, double measure) { return limit / measure; }

SurfacePoint pointIn(const SurfaceMesh& mesh, Face face, const Vec3& p) {
  const auto [a, b, c] = mesh.faceVertices(face);
  const TrianglePoint found =
      nearestInTriangle(p, {mesh.position(a), mesh.position(b), mesh.position(c)});
  return SurfacePoint::inFace(face, found.weights);
}

/// Walls, or gaps: what is too thin on one side of the surface.
struct SideCheck {
  const SurfaceMesh& mesh;
  FacingSurface surface;
  WeakKind kind;
  double limit;
  /// At the vertices; infinite where there is none.
  std::vector<double> values;
  /// The least of each face below `limit`; infinite elsewhere.
  std::vector<TouchingBall> balls;
  /// The least measure of all, above the limit too.
  double least{kNoMeasure};

  SideCheck(const SurfaceMesh& checked, const ThicknessOptions& options, WeakKind what,
            double wanted)
      : mesh(checked),
        surface(checked, options),
        kind(what),
        limit(wanted * (1 - kSinglePrecision)) {}

  bool measureVertices(const ExecutionContext& context) {
    values.assign(mesh.vertexCount(), kNoMeasure);
    return parallelFor(mesh.vertexCount(), kFacesAtOnce, context,
                       [&](std::size_t begin, std::size_t end) {
                         for (Vertex v(static_cast<Index>(begin)); v < end; ++v) {
                           values[v] = surface.atVertex(v).diameter;
                         }
                       });
  }

  /// Every face starts from the same bound, so that threads do not matter.
  bool measureFaces(const ExecutionContext& context) {
    least = kNoMeasure;
    for (const double value : values) least = std::min(least, value);
    const double bound = std::max(least, limit);
    balls.assign(mesh.faceCount(), {});
    const bool whole = parallelFor(mesh.faceCount(), kFacesAtOnce, context,
                                   [&](std::size_t begin, std::size_t end) {
                                     for (Face f(static_cast<Index>(begin)); f < end; ++f) {
                                       balls[f] = surface.inFace(f, bound);
                                     }
                                   });
    for (TouchingBall& ball : balls) {
      least = std::min(least, ball.diameter);
      if (!(ball.diameter < limit)) ball = {};
    }
    return whole;
  }

  bool fails(Vertex v) const { return values[v] < limit; }
  bool fails(Face f) const { return balls[f].diameter < limit; }

  /// How much of a face that fails somewhere fails, up to 1, by `4^level` samples, one at least.
  double shareOf(Face face, int level) const {
    const auto [a, b, c] = mesh.faceVertices(face);
    if (fails(a) && fails(b) && fails(c)) return 1;
    const Vec3 corner = mesh.position(a);
    const int parts = 1 << level;
    const Vec3 u = (1.0 / parts) * (mesh.position(b) - corner),
               v = (1.0 / parts) * (mesh.position(c) - corner);
    int failing = 0;
    for (int i = 0; i < parts; ++i) {
      for (int k = 0; i + k < parts; ++k) {
        const Vec3 at = corner + static_cast<double>(i) * u + static_cast<double>(k) * v;
        failing += surface.isBelow(face, at + (1.0 / 3) * (u + v), limit) ? 1 : 0;
        if (i + k + 2 > parts) continue;
        failing += surface.isBelow(face, at + (2.0 / 3) * (u + v), limit) ? 1 : 0;
      }
    }
    return std::max(1.0, static_cast<double>(failing)) / (static_cast<double>(parts) * parts);
  }

  /// So fine that samples of the faces are about half a limit apart, and not too many in all.
  int levelFor(Face face, std::size_t faces) const {
    int level = 0;
    double longest = 0;
    for (Index k = 0; k < 3; ++k) {
      longest = std::max(longest, mesh.length(SurfaceMesh::side(face, k)));
    }
    while (level < kFinestSamples && longest > limit / 2 * (1 << level) &&
           faces << (2 * level + 2) <= kMostSamplesInAll) {
      ++level;
    }
    return level;
  }

  std::vector<Vertex> cornersOf(const std::vector<Face>& faces) const {
    std::vector<Vertex> corners;
    for (const Face f : faces) {
      for (const Vertex v : mesh.faceVertices(f)) corners.push_back(v);
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
  }

  /// Connected places, in the order of their first vertex or face. `isTaken`: vertices that belong
  /// to a tube, which are not told again.
  bool places(const std::vector<bool>& isTaken, const std::vector<double>& vertexAreas,
              const ExecutionContext& context, std::vector<WeakPlace>& found) const {
    std::vector<bool> thin(mesh.vertexCount()), thinFace(mesh.faceCount());
    for (const Vertex v : mesh.vertices()) thin[v] = fails(v) && !isTaken[v];
    std::vector<Face> faces;
    for (const Face f : mesh.faces()) {
      const auto [a, b, c] = mesh.faceVertices(f);
      thinFace[f] = fails(f) && !(isTaken[a] && isTaken[b] && isTaken[c]);
      if (thinFace[f]) faces.push_back(f);
    }
    std::vector<double> shares(faces.size());
    const bool whole =
        parallelFor(faces.size(), 1, context, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            shares[i] = shareOf(faces[i], levelFor(faces[i], faces.size()));
          }
        });
    if (!whole) return false;

    const std::size_t vertices = mesh.vertexCount();
    Groups groups(vertices + mesh.faceCount());
    std::vector<bool> isCounted(vertices, false);  // with its faces
    for (const Halfedge h : mesh.halfedges()) {
      const Vertex v = mesh.from(h);
      const Face f = SurfaceMesh::faceOf(h);
      if (thin[v] && thin[mesh.to(h)]) groups.join(v, mesh.to(h));
      if (!thinFace[f]) continue;
      if (thin[v]) {
        groups.join(v, vertices + f);
        isCounted[v] = true;
      }
      const Halfedge twin = mesh.twin(h);
      if (twin != Halfedge::none && thinFace[SurfaceMesh::faceOf(twin)]) {
        groups.join(vertices + f, vertices + SurfaceMesh::faceOf(twin));
      }
    }
    std::vector<std::size_t> numbers(vertices + mesh.faceCount(), found.max_size());
    const auto placeOf = [&](std::size_t element) -> WeakPlace& {
      const std::size_t group = groups.of(element);
      if (numbers[group] == found.max_size()) {
        numbers[group] = found.size();
        found.emplace_back();
        found.back().kind = kind;
        found.back().least = kNoMeasure;
      }
      return found[numbers[group]];
    };
    for (const Vertex v : mesh.vertices()) {
      if (!thin[v]) continue;
      WeakPlace& place = placeOf(v);
      place.vertices.push_back(v);
      if (!isCounted[v]) place.area += vertexAreas[v];
      if (values[v] < place.least) {
        place.least = values[v];
        place.thinnest = SurfacePoint::atVertex(v);
      }
    }
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Face f = faces[i];
      WeakPlace& place = placeOf(vertices + f);
      place.faces.push_back(f);
      place.area += shares[i] * mesh.area(f);
      if (balls[f].diameter < place.least) {
        place.least = balls[f].diameter;
        place.thinnest = pointIn(mesh, f, balls[f].from);
        place.opposite = balls[f].to;
      }
    }
    for (WeakPlace& place : found) {
      if (place.vertices.empty()) place.vertices = cornersOf(place.faces);
      if (place.kind == kind && place.thinnest.vertex() != Vertex::none) {
        place.opposite = surface.atVertex(place.thinnest.vertex()).to;
      }
    }
    return true;
  }
};

/// Tubes: where the girth is below 2π times the limit.
struct TubeCheck {
  const SurfaceMesh& mesh;
  std::span<const double> girth;
  double limit;
  /// At the vertices; infinite where there is no tube.
  std::vector<double> diameters;

  bool measure(const ExecutionContext& context) {
    diameters.assign(mesh.vertexCount(), kNoMeasure);
    const auto startThread = [&]() -> std::function<bool(Vertex)> {
      return [&, solver = std::make_shared<GirthSolver>(mesh),
              own = context.ofOneThread()](Vertex v) -> bool {
        if (!(girth[v] < 2 * kPi * limit)) return true;
        const auto loop = solver->loop(v, own);
        if (!loop) return false;  // cancelled
        diameters[v] = girth[v] / kPi;
        if (loop.value().kind == LoopKind::Loop) {
          diameters[v] = std::min(diameters[v], sectionWidth(mesh, loop.value()));
        }
        return true;
      };
    };
    return forEachVertex(mesh, context, startThread, {}) == mesh.vertexCount();
  }

  bool fails(Vertex v) const { return diameters[v] < limit * (1 - kSinglePrecision); }

  /// The scale from which on no vertex fails: it is thick enough, or so long round that it is none
  /// of a tube.
  double passingScale() const {
    double scale = 0;
    for (std::size_t v = 0; v < girth.size(); ++v) {
      if (std::isnan(girth[v])) continue;
      const double leaves = scaleThatPasses(2 * kPi * limit, girth[v]);
      scale = std::max(scale, diameters[v] < kNoMeasure
                                  ? std::min(leaves, scaleThatPasses(limit, diameters[v]))
                                  : leaves);
    }
    return scale;
  }

  void places(const std::vector<double>& vertexAreas, std::vector<WeakPlace>& found) const {
    for (std::vector<Vertex>& region :
         connectedRegions(mesh, [&](Vertex v) { return fails(v) ? 0 : kNoIndex; })) {
      WeakPlace place;
      place.kind = WeakKind::Tube;
      place.least = kNoMeasure;
      for (const Vertex v : region) {
        place.area += vertexAreas[v];
        if (!(diameters[v] < place.least)) continue;
        place.least = diameters[v];
        place.thinnest = SurfacePoint::atVertex(v);
      }
      place.vertices = std::move(region);
      found.push_back(std::move(place));
    }
  }
};

double limitFor(WeakKind kind, const PrintLimits& limits) {
  switch (kind) {
    case WeakKind::Tube:
      return limits.tubeDiameter;
    case WeakKind::Wall:
      return limits.wallThickness;
    case WeakKind::Gap:
      break;
  }
  return limits.gap;
}

}  // namespace

std::string_view toString(WeakKind kind) {
  switch (kind) {
    case WeakKind::Tube:
      return "tube";
    case WeakKind::Wall:
      return "wall";
    case WeakKind::Gap:
      break;
  }
  return "gap";
}

std::string_view WeakPlace::measure() const {
  switch (kind) {
    case WeakKind::Tube:
      return "diameter";
    case WeakKind::Wall:
      return "thickness";
    case WeakKind::Gap:
      break;
  }
  return "clearance";
}

std::optional<Error> whyNotChecked(const SurfaceMesh& mesh, const PrintFields& fields,
                                   const PrintLimits& limits) {
  const bool walls = limits.wallThickness > 0;
  if (!walls && !(limits.gap > 0)) return std::nullopt;
  const auto isNone = [](double value) { return std::isnan(value); };
  if (walls && std::all_of(fields.thickness.begin(), fields.thickness.end(), isNone)) {
    return makeError(ErrorCode::NoThickness, -1,
                     "no vertex has a thickness, so no wall is checked");
  }
  if (!isInsideOut(mesh)) return std::nullopt;
  return makeError(ErrorCode::NoThickness, -1,
                   walls ? "the surface is inside out, so no wall is checked"
                         : "the surface is inside out, so no gap is checked");
}

Result<PrintCheck> checkPrint(const SurfaceMesh& mesh, const PrintFields& fields,
                              const PrintLimits& limits, const ThicknessOptions& options,
                              const ExecutionContext& context) {
  if (auto error = checkLimit(limits.tubeDiameter, "the least tube diameter")) return *error;
  if (auto error = checkLimit(limits.wallThickness, "the least wall thickness")) return *error;
  if (auto error = checkLimit(limits.gap, "the least gap")) return *error;
  const bool tubes = limits.tubeDiameter > 0, walls = limits.wallThickness > 0,
             gaps = limits.gap > 0;
  if (auto error = checkCount(mesh, fields.girth, tubes, "girth")) return *error;
  if (auto error = checkCount(mesh, fields.thickness, walls, "thickness")) return *error;
  if (auto error = checkThicknessOptions(options)) return *error;
  if (auto error = whyNotChecked(mesh, fields, limits)) return *error;

  PrintCheck check;
  const std::vector<double> areas = vertexAreas(mesh);
  std::vector<bool> isTube(mesh.vertexCount(), false);
  if (tubes) {
    TubeCheck tube{mesh, fields.girth, limits.tubeDiameter, {}};
    if (!tube.measure(partOf(context, 0, 0.4))) return check;
    tube.places(areas, check.places);
    for (const Vertex v : mesh.vertices()) isTube[v] = tube.fails(v);
    check.passingScale = tube.passingScale();
  }
  const auto sides =
      std::array{std::pair{ThicknessSide::Inside, walls}, std::pair{ThicknessSide::Outside, gaps}};
  double progress = 0.4;
  for (const auto& [side, wanted] : sides) {
    const double from = std::exchange(progress, progress + 0.3);
    if (!wanted) continue;
    const bool inside = side == ThicknessSide::Inside;
    SideCheck part(mesh, {options.sharpRadians, side}, inside ? WeakKind::Wall : WeakKind::Gap,
                   inside ? limits.wallThickness : limits.gap);
    if (inside) {
      for (const double value : fields.thickness) part.values.push_back(orNever(value));
    } else if (!part.measureVertices(partOf(context, from, from + 0.15))) {
      return check;
    }
    if (!part.measureFaces(partOf(context, from + 0.15, from + 0.25))) return check;
    if (!part.places(inside ? isTube : std::vector<bool>(mesh.vertexCount(), false), areas,
                     partOf(context, from + 0.25, from + 0.3), check.places)) {
      return check;
    }
    if (part.least < kNoMeasure) {
      check.passingScale =
          std::max(check.passingScale,
                   scaleThatPasses(inside ? limits.wallThickness : limits.gap, part.least));
    }
  }
  double area = 0;
  for (const WeakPlace& place : check.places) area += place.area;
  check.failingShare = std::min(1.0, area / mesh.area());
  // Measures below a limit by rounding alone pass as they are.
  if (check.places.empty()) check.passingScale = std::min(1.0, check.passingScale);
  const auto share = [&](const WeakPlace& place) {
    return place.least / limitFor(place.kind, limits);
  };
  std::stable_sort(check.places.begin(), check.places.end(),
                   [&](const WeakPlace& a, const WeakPlace& b) { return share(a) < share(b); });
  if (context.onProgress) context.onProgress(1);
  check.complete = true;
  return check;
}

}  // namespace girth
