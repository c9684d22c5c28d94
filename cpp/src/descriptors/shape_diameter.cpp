#include "girth/shape_diameter.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "descriptors/triangle_tree.h"
#include "girth/parallel.h"
#include "mesh/angles.h"
#include "mesh/check_vertex.h"
#include "mesh/vector.h"
#include "mesh/vertex_normals.h"
#include "no_value.h"

namespace girth {

namespace {

constexpr std::size_t kVerticesAtOnce = 64;

/// A ray, given by the axis of the cone (z) and two directions across.
struct ConeRay {
  Vec3 direction;
  double weight;
};

std::vector<ConeRay> coneRays(const ShapeDiameterOptions& options) {
  // The golden angle, π (3 − √5).
  const CosSin golden = cosSin(kPi * (3 - std::sqrt(5.0)));
  std::vector<ConeRay> rays;
  double x = 1, y = 0;
  for (unsigned i = 0; i < options.rays; ++i) {
    const double angle = (i + 0.5) / options.rays * options.coneRadians / 2;
    const CosSin off = cosSin(angle);
    rays.push_back({{x * off.sin, y * off.sin, off.cos}, 1 / angle});
    const Vec3 turned{x * golden.cos - y * golden.sin, x * golden.sin + y * golden.cos, 0};
    const double length = norm(turned);
    x = turned.x / length;
    y = turned.y / length;
  }
  return rays;
}

/// Unit vectors into the surface, against the vertices' normals; zero where those cancel out.
std::vector<Vec3> inwardAxes(const SurfaceMesh& mesh) {
  std::vector<Vec3> axes = normalsOfVertices(mesh);
  for (Vec3& axis : axes) {
    const double length = norm(axis);
    axis = length > 1e-12 ? (-1 / length) * axis : Vec3{};
  }
  return axes;
}

/// Sum of the signed volumes between the faces and a point of the surface.
double enclosedVolume(const SurfaceMesh& mesh) {
  const Vec3 apex = mesh.position(mesh.from(Halfedge(0)));
  double volume = 0;
  for (const Face f : mesh.faces()) {
    const auto [a, b, c] = mesh.faceVertices(f);
    volume +=
        dot(mesh.position(a) - apex, cross(mesh.position(b) - apex, mesh.position(c) - apex)) / 6;
  }
  return volume;
}

bool isOpen(const SurfaceMesh& mesh) {
  for (Index c = 0; c < mesh.componentCount(); ++c) {
    if (mesh.boundaryCount(c) > 0) return true;
  }
  return false;
}

struct Length {
  double length, weight;
};

/// The mean of the lengths near their median. NaN where there are none.
double robustMean(std::vector<Length>& lengths) {
  if (lengths.empty()) return kNoValue;
  std::sort(lengths.begin(), lengths.end(),
            [](const Length& a, const Length& b) { return a.length < b.length; });
  const std::size_t n = lengths.size();
  const double median = (lengths[(n - 1) / 2].length + lengths[n / 2].length) / 2;
  double mean = 0, variance = 0;
  for (const Length& l : lengths) mean += l.length / static_cast<double>(n);
  for (const Length& l : lengths) {
    variance += (l.length - mean) * (l.length - mean) / static_cast<double>(n);
  }
  // Equal lengths must all stay, though rounding may give them a variance.
  const double allowed = std::sqrt(variance) + 1e-12 * median;
  double sum = 0, weight = 0;
  for (const Length& l : lengths) {
    if (std::fabs(l.length - median) > allowed) continue;
    sum += l.weight * l.length;
    weight += l.weight;
  }
  return weight > 0 ? sum / weight : median;
}

/// Data that the vertices of a surface have in common.
struct Cones {
  const SurfaceMesh& mesh;
  TriangleTree tree;
  std::vector<ConeRay> rays;
  std::vector<Vec3> axes;

  Cones(const SurfaceMesh& surface, const ShapeDiameterOptions& options)
      : mesh(surface), tree(surface), rays(coneRays(options)), axes(inwardAxes(surface)) {}

  /// The value at a vertex; `lengths` is scratch memory.
  double at(Vertex vertex, std::vector<Length>& lengths) const {
    const Vec3 axis = axes[vertex];
    if (dot(axis, axis) == 0) return kNoValue;
    // Two directions across the axis (Duff et al. 2017).
    const double sign = axis.z < 0 ? -1 : 1;
    const double a = -1 / (sign + axis.z), b = axis.x * axis.y * a;
    const Vec3 across{1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
    const Vec3 along{b, sign + axis.y * axis.y * a, -axis.y};
    lengths.clear();
    for (const ConeRay& ray : rays) {
      const Vec3 direction =
          ray.direction.x * across + ray.direction.y * along + ray.direction.z * axis;
      const auto hit = tree.firstHit(mesh.position(vertex), direction, vertex);
      if (hit && hit->fromBehind) lengths.push_back({hit->distance, ray.weight});
    }
    return robustMean(lengths);
  }
};

std::optional<Error> check(const ShapeDiameterOptions& options) {
  if (!(options.coneRadians > 0 && options.coneRadians < kPi)) {
    return makeError(ErrorCode::Usage, -1,
                     "the cone's angle " + std::to_string(options.coneRadians) +
                         " is not a number of radians between 0 and π");
  }
  if (options.rays < 1 || options.rays > 10'000) {
    return makeError(
        ErrorCode::Usage, -1,
        "the number of rays " + std::to_string(options.rays) + " is not between 1 and 10000");
  }
  return std::nullopt;
}

}  // namespace

Result<ShapeDiameterField> shapeDiameter(const SurfaceMesh& mesh,
                                         const ShapeDiameterOptions& options,
                                         const ExecutionContext& context) {
  if (auto error = check(options)) return *std::move(error);
  const Cones cones(mesh, options);
  ShapeDiameterField field;
  field.values.assign(mesh.vertexCount(), kNoValue);
  field.insideOut = isInsideOut(mesh);
  field.complete = parallelFor(mesh.vertexCount(), kVerticesAtOnce, context,
                               [&](std::size_t begin, std::size_t end) {
                                 std::vector<Length> lengths;
                                 for (Vertex v(static_cast<Index>(begin)); v < end; ++v) {
                                   field.values[v] = cones.at(v, lengths);
                                 }
                               });
  field.withoutValue = static_cast<Index>(std::count_if(
      field.values.begin(), field.values.end(), [](double value) { return std::isnan(value); }));
  return field;
}

Result<VertexFunction<double>> shapeDiameterFunction(const SurfaceMesh& mesh,
                                                     const ShapeDiameterOptions& options) {
  if (auto error = check(options)) return *std::move(error);
  const auto cones = std::make_shared<const Cones>(mesh, options);
  return VertexFunction<double>{[cones](const ExecutionContext&) -> VertexEvaluator<double> {
    return [cones, lengths = std::vector<Length>()](Vertex v) mutable -> Result<double> {
      if (auto error = checkVertex(cones->mesh, Vertex(v))) return *std::move(error);
      return cones->at(v, lengths);
    };
  }};
}

bool isInsideOut(const SurfaceMesh& mesh) { return !isOpen(mesh) && enclosedVolume(mesh) < 0; }

std::string shapeDiameterNote(bool insideOut, Index withoutValue, Index vertices) {
  std::string note;
  if (insideOut) {
    note =
        "the surface is inside out: its faces look inwards, and rays go outside; "
        "turn "
        "the faces over";
  }
  if (withoutValue > 0) {
    note += (note.empty() ? "" : ". ") + std::to_string(withoutValue) + " of " +
            std::to_string(vertices) +
            " vertices have no shape diameter: no ray from them meets a wall from inside";
  }
  return note;
}

}  // namespace girth
