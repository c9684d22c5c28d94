// Named measures at landmarks of a surface: how long, how far round.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// How a landmark is measured.
enum class MeasureKind : std::uint8_t {
  Girth,     ///< the length of the girth loop
  Section,   ///< the perimeter of the curve of a plane through the point
  Tape,      ///< the tape of that curve
  Distance,  ///< the distance to another point, along the surface
};

/// "girth", "section", "tape" or "distance".
GIRTH_EXPORT std::string_view toString(MeasureKind kind);

/// A point, and what is measured there.
struct Landmark {
  /// The name of the measure.
  std::string name;
  /// Where it is measured, or begins.
  SurfacePoint point;
  /// How it is measured.
  MeasureKind how{};
  /// The other end of a distance.
  SurfacePoint to{SurfacePoint::atVertex(Vertex::none)};
  /// Whether the plane of a section or tape is perpendicular to the limb or tube at the point.
  bool across{false};
  /// Whether a section or tape takes all curves of its plane, not the one through the point.
  bool all{false};
};

/// Which measures are wanted.
struct LandmarksOptions {
  /// The landmarks: one for each measure.
  std::vector<Landmark> landmarks;
  /// The normal of planes that are not across limbs, of any length but 0.
  Vec3 normal{0, 0, 1};
};

/// A measure at a landmark.
struct NamedMeasure {
  /// The name of the landmark.
  std::string name;
  /// How it was measured.
  MeasureKind how{MeasureKind::Girth};
  /// The point of the landmark.
  SurfacePoint point;
  /// The measure, in model units; infinite for a distance that has no path.
  double length{0};
  /// The curve that was measured; of all curves of a plane none.
  std::vector<SurfacePoint> points;
};

/// Measures at landmarks.
struct NamedMeasures {
  /// In the order of the landmarks.
  std::vector<NamedMeasure> measures;
};

/// Measures at landmarks of a surface. Errors: those of the measures, with the name of the landmark
/// before the message; INVALID_OPTION (a normal without length), CANCELLED.
GIRTH_EXPORT Result<NamedMeasures> measureLandmarks(const SurfaceMesh& mesh,
                                                    const LandmarksOptions& options,
                                                    const ExecutionContext& context = {});

}  // namespace girth
