// Named measures at landmarks of a model: `girth section --landmarks`.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "girth/describe/description.h"
#include "girth/io/read_mesh.h"
#include "model/model_options.h"

namespace girth::cli {

/// How a landmark is measured.
enum class MeasureKind : std::uint8_t {
  Girth,     ///< the length of the girth loop
  Section,   ///< the perimeter of the curve of a plane through the point
  Tape,      ///< the tape of that curve
  Distance,  ///< the distance to another point, along the surface
};

/// "girth", "section", "tape" or "distance".
std::string_view toString(MeasureKind kind);

/// A measure at a landmark.
struct NamedMeasure {
  std::string name;
  MeasureKind how{MeasureKind::Girth};
  SurfacePoint point;
  double length{0};                  ///< in model units; infinite for a distance that has no path
  std::vector<SurfacePoint> points;  ///< the curve that was measured
};

/// The members of a measure.
constexpr auto describe(Members<NamedMeasure>) {
  return described<NamedMeasure>(
      member("name", &NamedMeasure::name), member("how", &NamedMeasure::how),
      member("point", &NamedMeasure::point), member("length", &NamedMeasure::length),
      curve("points", &NamedMeasure::points));
}

/// In the order of the file.
struct NamedMeasures {
  std::vector<NamedMeasure> measures;
};

/// The members of several measures.
constexpr auto describe(Members<NamedMeasures>) {
  return described<NamedMeasures>(member("measures", &NamedMeasures::measures));
}

/// Measures at the landmarks of a file: a JSON array of objects with `name`, `point` (a vertex, or
/// a point of a face as it is typed), `how`, of distances `to`, and `across` where the plane of a
/// section or tape is perpendicular to the limb there, not to `normal`. Errors: those of reading;
/// MALFORMED_FILE with the landmark; those of the measures, which name the landmark.
Result<NamedMeasures> measureLandmarks(const std::string& file, const io::LoadedMesh& loaded,
                                       const Vec3& normal, const std::string& model,
                                       const ModelOptions& preparing);

}  // namespace girth::cli
