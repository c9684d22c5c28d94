#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "descriptors/facing_surface.h"
#include "girth/parallel.h"
#include "girth/shape_diameter.h"
#include "girth/thickness.h"
#include "mesh/angles.h"
#include "mesh/check_vertex.h"
#include "no_value.h"

namespace girth {

namespace {

constexpr std::size_t kThicknessGrain = 8;

double valueOf(const TouchingBall& ball) {
  return std::isfinite(ball.diameter) ? ball.diameter : kNoValue;
}

}  // namespace

std::optional<Error> checkThicknessOptions(const ThicknessOptions& options) {
  if (options.sharpRadians > 0 && options.sharpRadians < kPi / 2) return std::nullopt;
  return makeError(ErrorCode::Usage, -1,
                   "the angle of sharp edges " + std::to_string(options.sharpRadians) +
                       " is not a number of radians between 0 and π/2");
}

Result<ThicknessField> medialThickness(const SurfaceMesh& mesh, const ThicknessOptions& options,
                                       const ExecutionContext& context) {
  if (auto error = checkThicknessOptions(options)) return *std::move(error);
  const FacingSurface surface(mesh, options);
  ThicknessField field;
  field.values.assign(mesh.vertexCount(), kNoValue);
  field.insideOut = isInsideOut(mesh);
  field.complete = parallelFor(mesh.vertexCount(), kThicknessGrain, context,
                               [&](std::size_t begin, std::size_t end) {
                                 for (Vertex v(static_cast<Index>(begin)); v < end; ++v) {
                                   field.values[v] = valueOf(surface.atVertex(v));
                                 }
                               });
  field.withoutValue = static_cast<Index>(std::count_if(
      field.values.begin(), field.values.end(), [](double value) { return std::isnan(value); }));
  return field;
}

Result<VertexFunction<double>> medialThicknessFunction(const SurfaceMesh& mesh,
                                                       const ThicknessOptions& options) {
  if (auto error = checkThicknessOptions(options)) return *std::move(error);
  const auto surface = std::make_shared<const FacingSurface>(mesh, options);
  return VertexFunction<double>{
      [surface, &mesh](const ExecutionContext&) -> VertexEvaluator<double> {
        return [surface, &mesh](Vertex v) -> Result<double> {
          if (auto error = checkVertex(mesh, v)) return *std::move(error);
          return valueOf(surface->atVertex(v));
        };
      }};
}

std::string thicknessNote(bool insideOut, Index withoutValue, Index vertices) {
  std::string note;
  if (insideOut) {
    note =
        "the surface is inside out: its faces look inwards, and thickness is measured outside; "
        "turn the faces over";
  }
  if (withoutValue > 0) {
    note += (note.empty() ? "" : ". ") + std::to_string(withoutValue) + " of " +
            std::to_string(vertices) +
            " vertices have no thickness: nothing faces them from behind";
  }
  return note;
}

}  // namespace girth
