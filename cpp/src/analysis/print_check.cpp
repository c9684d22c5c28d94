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
#include "analysis/thin_kinds.h"
#include "descriptors/facing_surface.h"
#include "girth/parallel.h"
#include "girth/shape_diameter.h"
#include "girth/vertex_areas.h"
#include "girth/vertex_function.h"
#include "mesh/angles.h"
#include "mesh/face_shape.h"
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
/// Scales that are tried until a shape passes.
constexpr int kMostRounds = 6;

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

/// Measures below a limit; infinite elsewhere.
struct ThinMeasures {
  std::vector<double> values;       ///< at the vertices
  std::vector<TouchingBall> balls;  ///< the least of each face

  double least() const {
    double least = kNoMeasure;
    for (const double value : values) least = std::min(least, value);
    for (const TouchingBall& ball : balls) least = std::min(least, ball.diameter);
    return least;
  }
};

/// Walls, or gaps: what is too thin on one side of the surface.
struct SideCheck {
  const SurfaceMesh& mesh;
  FacingSurface surface;
  /// By faces that oppose each other alone.
  FacingSurface opposing;
  WeakKind kind;
  double wanted;
  double rounding;
  double limit;
  /// At the vertices; infinite where there is none.
  std::vector<double> values;
  /// The least of each face below `limit`; infinite elsewhere.
  std::vector<TouchingBall> balls;
  /// The least measure of all, above the limit too.
  double least{kNoMeasure};
  /// The parts of both that are walls (or gaps), and that are creases.
  ThinMeasures walls, creases;

  SideCheck(const SurfaceMesh& checked, const ThicknessOptions& options, WeakKind what,
            double wantedLeast)
      : mesh(checked),
        surface(checked, options),
        opposing(checked, {std::min(options.sharpRadians, kOpposingAngle), options.side}),
        kind(what),
        wanted(wantedLeast),
        rounding(kSingleRounding * extentOf(checked)),
        limit(wanted - std::clamp(rounding, kSinglePrecision * wanted, 0.5 * wanted)) {}

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

  /// The walls below a limit of at most `limit`; nothing after cancelling.
  std::optional<ThinMeasures> wallsBelow(double bound, const ExecutionContext& context) const {
    const ThinKinds kinds(mesh, surface, opposing, values, bound, rounding, kind == WeakKind::Gap);
    ThinMeasures found{std::vector<double>(mesh.vertexCount(), kNoMeasure),
                       std::vector<TouchingBall>(mesh.faceCount())};
    const bool whole = parallelFor(mesh.faceCount(), kFacesAtOnce, partOf(context, 0, 0.8),
                                   [&](std::size_t begin, std::size_t end) {
                                     for (Face f(static_cast<Index>(begin)); f < end; ++f) {
                                       if (balls[f].diameter < bound)
                                         found.balls[f] = kinds.wallIn(f, balls[f]);
                                     }
                                   }) &&
                       parallelFor(mesh.vertexCount(), kFacesAtOnce, partOf(context, 0.8, 1),
                                   [&](std::size_t begin, std::size_t end) {
                                     for (Vertex v(static_cast<Index>(begin)); v < end; ++v) {
                                       if (values[v] < bound) found.values[v] = kinds.wallAt(v);
                                     }
                                   });
    if (!whole) return std::nullopt;
    return found;
  }

  /// Tells walls from creases.
  bool divide(const ExecutionContext& context) {
    auto found = wallsBelow(limit, context);
    if (!found) return false;
    walls = *std::move(found);
    creases = {values, balls};
    for (std::size_t v = 0; v < values.size(); ++v) {
      if (!(values[v] < limit) || walls.values[v] < kNoMeasure) creases.values[v] = kNoMeasure;
    }
    for (std::size_t f = 0; f < balls.size(); ++f) {
      if (walls.balls[f].diameter < kNoMeasure) creases.balls[f] = {};
    }
    return true;
  }

  /// A scale from which on there are no walls; infinite where none is found. Creases that remain
  /// let nothing be said of smaller shapes. Nothing after cancelling.
  std::optional<double> passingScale(const ExecutionContext& context) const {
    double thinnest = walls.least();
    if (!(thinnest < kNoMeasure)) {
      if (creases.least() < kNoMeasure) return 1;
      return least < kNoMeasure ? scaleThatPasses(wanted, least) : 0;
    }
    ExecutionContext quiet = context;
    quiet.onProgress = {};
    // A smaller limit may make walls of creases and lips, but not often. Where faces touch, halves
    // of it are tried.
    double bound = limit;
    for (int round = 0; round < kMostRounds; ++round) {
      const double passes = thinnest > rounding ? thinnest : bound / 2;
      bound = passes * (1 - kSinglePrecision);
      const auto rest = wallsBelow(bound, quiet);
      if (!rest) return std::nullopt;
      thinnest = rest->least();
      if (!(thinnest < kNoMeasure)) return scaleThatPasses(wanted, passes);
    }
    return kNoMeasure;
  }

  /// How much of a face that fails somewhere fails, up to 1, by `4^level` samples, one at least.
  double shareOf(Face face, const ThinMeasures& thin, const FacingSurface& by, int level) const {
    const auto [a, b, c] = mesh.faceVertices(face);
    const bool allThin = thin.values[a] < limit && thin.values[b] < limit && thin.values[c] < limit;
    if (&thin == &walls && allThin) return 1;
    const Vec3 corner = mesh.position(a);
    const int parts = 1 << level;
    const Vec3 u = (1.0 / parts) * (mesh.position(b) - corner),
               v = (1.0 / parts) * (mesh.position(c) - corner);
    int failing = 0;
    const auto fails = [&](const Vec3& p) { return by.atPoint(face, p, limit).diameter < limit; };
    for (int i = 0; i < parts; ++i) {
      for (int k = 0; i + k < parts; ++k) {
        const Vec3 at = corner + static_cast<double>(i) * u + static_cast<double>(k) * v;
        failing += fails(at + (1.0 / 3) * (u + v)) ? 1 : 0;
        if (i + k + 2 > parts) continue;
        failing += fails(at + (2.0 / 3) * (u + v)) ? 1 : 0;
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

  /// Connected places of some measures, in the order of their first vertex or face. `by`: measures
  /// points within faces. `isTaken`: vertices that belong to a tube, which are not told again.
  bool places(const ThinMeasures& measures, const FacingSurface& by,
              const std::vector<bool>& isTaken, const std::vector<double>& vertexAreas,
              const ExecutionContext& context, std::vector<WeakPlace>& found) const {
    const std::size_t before = found.size();
    std::vector<bool> thin(mesh.vertexCount()), thinFace(mesh.faceCount());
    for (const Vertex v : mesh.vertices()) thin[v] = measures.values[v] < limit && !isTaken[v];
    std::vector<Face> faces;
    for (const Face f : mesh.faces()) {
      const auto [a, b, c] = mesh.faceVertices(f);
      thinFace[f] = measures.balls[f].diameter < limit && !(isTaken[a] && isTaken[b] && isTaken[c]);
      if (thinFace[f]) faces.push_back(f);
    }
    std::vector<double> shares(faces.size());
    const bool whole =
        parallelFor(faces.size(), 1, context, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            shares[i] = shareOf(faces[i], measures, by, levelFor(faces[i], faces.size()));
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
      if (measures.values[v] < place.least) {
        place.least = measures.values[v];
        place.thinnest = SurfacePoint::atVertex(v);
      }
    }
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Face f = faces[i];
      WeakPlace& place = placeOf(vertices + f);
      place.faces.push_back(f);
      place.area += shares[i] * mesh.area(f);
      const TouchingBall& ball = measures.balls[f];
      if (ball.diameter < place.least) {
        place.least = ball.diameter;
        place.thinnest = pointIn(mesh, f, ball.from);
        place.opposite = ball.to;
      }
    }
    for (std::size_t i = before; i < found.size(); ++i) {
      WeakPlace& place = found[i];
      if (place.vertices.empty()) place.vertices = cornersOf(place.faces);
      const Vertex at = place.thinnest.vertex();
      if (at != Vertex::none) place.opposite = by.atVertex(at).to;
    }
    return true;
  }

  /// A connected place of creases, with its kind and length.
  Crease creaseOf(WeakPlace&& place) const {
    const ThinKinds kinds(mesh, surface, opposing, values, limit, rounding, kind == WeakKind::Gap);
    Crease crease;
    crease.area = place.area;
    crease.least = place.least;
    crease.thinnest = place.thinnest;
    crease.opposite = place.opposite;
    for (const Face f : place.faces) {
      if (creases.balls[f].diameter <= place.least) crease.kind = kinds.kindOf(f, creases.balls[f]);
      for (Index k = 0; k < 3; ++k) {
        const Halfedge h = SurfaceMesh::side(f, k), twin = mesh.twin(h);
        if (twin == Halfedge::none || h > twin) continue;
        const bool inside =
            std::binary_search(place.faces.begin(), place.faces.end(), SurfaceMesh::faceOf(twin));
        if (inside && surface.bendAt(h) == FacingSurface::Bend::Outward) {
          crease.length += mesh.length(h);
        }
      }
    }
    crease.vertices = std::move(place.vertices);
    crease.faces = std::move(place.faces);
    return crease;
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

std::string_view toString(CreaseKind kind) {
  switch (kind) {
    case CreaseKind::Crease:
      return "crease";
    case CreaseKind::Rounding:
      return "rounding";
    case CreaseKind::Sliver:
      break;
  }
  return "sliver";
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
    if (!part.measureFaces(partOf(context, from + 0.15, from + 0.2)) ||
        !part.divide(partOf(context, from + 0.2, from + 0.24))) {
      return check;
    }
    const std::vector<bool> isTaken =
        inside ? isTube : std::vector<bool>(mesh.vertexCount(), false);
    std::vector<WeakPlace> thin;
    if (!part.places(part.walls, part.opposing, isTaken, areas,
                     partOf(context, from + 0.24, from + 0.26), check.places) ||
        !part.places(part.creases, part.surface, isTaken, areas,
                     partOf(context, from + 0.26, from + 0.28), thin)) {
      return check;
    }
    for (WeakPlace& place : thin) check.creases.push_back(part.creaseOf(std::move(place)));
    const auto scale = part.passingScale(partOf(context, from + 0.28, from + 0.3));
    if (!scale) return check;
    check.passingScale = std::max(check.passingScale, *scale);
  }
  std::stable_sort(check.creases.begin(), check.creases.end(),
                   [](const Crease& a, const Crease& b) { return a.length > b.length; });
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
