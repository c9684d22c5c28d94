#include "girth/landmarks.h"

#include <cstddef>
#include <utility>

#include "girth/geodesic_solver.h"
#include "girth/girth_solver.h"
#include "girth/parallel.h"
#include "girth/section.h"

namespace girth {
namespace {

Result<NamedMeasure> measureOne(const SurfaceMesh& mesh, const Landmark& landmark,
                                const Vec3& normal, const ExecutionContext& context) {
  const auto& [name, point, how, to, across, all] = landmark;
  NamedMeasure measure{name, how, point, 0, {}};
  if (how == MeasureKind::Girth) {
    auto loop = GirthSolver(mesh).loop(point);
    if (!loop) return loop.error();
    measure.length = loop.value().length;
    measure.points = std::move(loop.value().points);
    return measure;
  }
  if (how == MeasureKind::Distance) {
    auto path = GeodesicSolver(mesh).path(point, to, context);
    if (!path) return path.error();
    measure.length = path.value().length;
    measure.points = std::move(path.value().points);
    return measure;
  }
  const auto found = sectionsThrough(mesh, {{point}, normal, across, false}, context);
  if (!found) return found.error();
  const Section& section = found.value().sections.front();
  const SectionCurve* curve = curveThrough(mesh, section, point);
  if (curve == nullptr) {
    return makeError(ErrorCode::InvalidPoint, -1,
                     "the plane through the point only touches the surface");
  }
  const bool isTape = how == MeasureKind::Tape;
  if (all) {
    measure.length = isTape ? section.tape : section.perimeter;
  } else {
    measure.length = isTape ? curve->tape : curve->perimeter;
    measure.points = curve->points;
  }
  return measure;
}

}  // namespace

std::string_view toString(MeasureKind kind) {
  switch (kind) {
    case MeasureKind::Girth:
      return "girth";
    case MeasureKind::Section:
      return "section";
    case MeasureKind::Tape:
      return "tape";
    case MeasureKind::Distance:
      return "distance";
  }
  return "";
}

Result<NamedMeasures> measureLandmarks(const SurfaceMesh& mesh, const LandmarksOptions& options,
                                       const ExecutionContext& context) {
  NamedMeasures all;
  const std::size_t count = options.landmarks.size();
  for (const Landmark& landmark : options.landmarks) {
    if (context.cancelled())
      return makeError(ErrorCode::Cancelled, -1, "the measures were cancelled");
    auto measure = measureOne(mesh, landmark, options.normal, context.ofOneThread());
    if (!measure) {
      Error error = measure.error();
      error.message = landmark.name + ": " + error.message;
      return error;
    }
    all.measures.push_back(std::move(measure).value());
    if (context.onProgress) {
      context.onProgress(static_cast<double>(all.measures.size()) / static_cast<double>(count));
    }
  }
  return all;
}

}  // namespace girth
