// Tubes, plates and body: the parts of a shape by its girth and its shape diameter.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"

namespace girth {

/// The kind of a place of a shape (paper, section 6.3).
enum class PartKind : std::uint8_t {
  Body,     ///< thick
  Tube,     ///< thin, and a short loop goes round it
  Plate,    ///< thin, but no short loop goes round it
  Unknown,  ///< its girth or its shape diameter has no value
};

/// "body", "tube", "plate" or "unknown".
GIRTH_EXPORT std::string_view toString(PartKind kind);

/// The paper's τ1 and τ2, in model units: plate = {I > girth, SDF < shapeDiameter},
/// tube = {I < girth, SDF < shapeDiameter}, body the rest.
struct PartThresholds {
  /// τ1: tubes have a smaller girth, in model units.
  double girth{0};
  /// τ2: tubes and plates have a smaller shape diameter, in model units.
  double shapeDiameter{0};
};

/// A place to start from, by the joint distribution of the two fields over the surface's area.
///
/// τ2 divides the logarithm of SDF where the two sides differ most (Otsu 1979): thin from thick.
/// Where they hardly differ (the variance between them is less than 4/5 of the whole; it is 3/4
/// where values are spread evenly), there is no division to be found, all counts as thin, and τ2
/// lies above every value. τ1 divides the logarithm of I over what is thin in the same way; where
/// there is no division, it is 2π times the median shape diameter of what is thin: the girth is π
/// times the diameter of a round tube, 4 times the width of a square one, and 2π times that of a
/// bar 2.1 times as wide as thick. Both are 0 where no vertex has both values.
GIRTH_EXPORT PartThresholds suggestedThresholds(const SurfaceMesh& mesh,
                                                std::span<const double> girth,
                                                std::span<const double> diameter);

/// How vertices are divided among parts.
struct PartOptions {
  /// The lengths below which a place is thin, and a loop short.
  PartThresholds thresholds;
  /// 0: plain thresholds, as in the paper. Above: a vertex becomes what most of its neighbourhood
  /// is, where the kind by thresholds counts 1 and all neighbours together count this much;
  /// repeated until nothing changes (at most 50 times).
  double smoothing{0};
};

/// A connected region of one kind.
struct GIRTH_EXPORT Part {
  PartKind kind{PartKind::Body};  ///< the kind of all its vertices
  std::vector<Vertex> vertices;   ///< its vertices, in rising order
  double area{0};                 ///< sum of the vertices' areas, in squared model units
  /// Median of the girth over the region, in model units; NaN where it is unknown.
  double medianGirth{0};
  /// Median of the shape diameter over the region, in model units; NaN where it is unknown.
  double medianShapeDiameter{0};
  /// Its thinnest place: the vertex with the least girth (tube), otherwise the least SDF; none
  /// where it is unknown. GirthSolver::loop gives the loop there.
  Vertex thinnest;

  /// Radius of the round tube with the same girth, I / 2π, in model units.
  double equivalentRadius() const;
};

/// A surface divided into parts.
struct Parts {
  std::vector<PartKind> kinds;  ///< the kind of each vertex
  std::vector<Index> partOf;    ///< the part of each vertex, a number in `parts`
  std::vector<Part> parts;      ///< largest area first
};

/// The parts of a surface. `girth` and `diameter`: one value for each vertex, NaN where there is
/// none. O(n log n). Errors: USAGE where values are not as many as vertices, or a threshold or the
/// smoothing is negative or not a number (infinite thresholds are allowed).
///
/// \code
/// const girth::GirthField field = girth::girthField(mesh);
/// const auto diameter = girth::shapeDiameter(mesh).value();
/// girth::PartOptions options;
/// options.thresholds = girth::suggestedThresholds(mesh, field.values, diameter.values);
/// const auto found = girth::findParts(mesh, field.values, diameter.values, options).value();
/// for (const girth::Part& part : found.parts) {
///   std::cout << girth::toString(part.kind) << ' ' << part.area << '\n';
/// }
/// \endcode
GIRTH_EXPORT Result<Parts> findParts(const SurfaceMesh& mesh, std::span<const double> girth,
                                     std::span<const double> diameter, const PartOptions& options);

}  // namespace girth
