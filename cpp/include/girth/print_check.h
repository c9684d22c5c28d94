// The check of a body for places too thin, or too close together, for a printer.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/girth_solver.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"
#include "girth/thickness.h"

namespace girth {

/// The least lengths that a printer can make, in model units; 0: any.
struct PrintLimits {
  /// The least diameter of a tube.
  double tubeDiameter{0};
  /// The least thickness of a wall.
  double wallThickness{0};
  /// The least distance between surfaces that face each other across empty space.
  double gap{0};
};

/// The fault of a place.
enum class WeakKind : std::uint8_t {
  Tube,  ///< a tube's diameter
  Wall,  ///< a wall's thickness
  Gap,   ///< the clearance
};

/// "tube", "wall" or "gap".
GIRTH_EXPORT std::string_view toString(WeakKind kind);

/// A connected place that does not meet a limit.
struct GIRTH_EXPORT WeakPlace {
  WeakKind kind{WeakKind::Tube};  ///< which limit it does not meet
  /// Vertices that do not meet the limit, in rising order; where only the inside of faces does not,
  /// the corners of these.
  std::vector<Vertex> vertices;
  /// Faces that somewhere do not meet the limit, of walls and gaps, in rising order.
  std::vector<Face> faces;
  /// In squared model units; of faces that meet the limit in part, by samples.
  double area{0};
  /// The least diameter, thickness or clearance there, in model units.
  double least{0};
  /// The point that has it.
  SurfacePoint thinnest;
  /// The point of the surface across from it, in model units; of walls and gaps only.
  Vec3 opposite;

  /// The measure that is too small: "diameter", "thickness" or "clearance".
  std::string_view measure() const;
};

/// Why a measure below a limit belongs to no wall and no gap.
enum class CreaseKind : std::uint8_t {
  Crease,    ///< faces run into each other, or end in a lip of an eighth of the limit
  Rounding,  ///< faces touch, to the rounding of coordinates in single precision
  Sliver,    ///< a triangle is so low that rounding alone decides where it faces
};

/// "crease", "rounding" or "sliver".
GIRTH_EXPORT std::string_view toString(CreaseKind kind);

/// A connected place where measures are below a limit, but where no wall and no gap is. It does not
/// fail.
struct Crease {
  CreaseKind kind{CreaseKind::Crease};  ///< the kind of its thinnest point
  /// The sharp edges in it together, in model units; 0 where faces only touch.
  double length{0};
  /// In squared model units.
  double area{0};
  /// The least measure there, in model units: no thickness of anything.
  double least{0};
  /// The point that has it.
  SurfacePoint thinnest;
  /// The point of the surface across from it, in model units.
  Vec3 opposite;
  /// Its vertices, in rising order, as of a weak place.
  std::vector<Vertex> vertices;
  /// Its faces, in rising order.
  std::vector<Face> faces;
};

/// The answer to a check.
struct PrintCheck {
  /// The worst first, in shares of their limits.
  std::vector<WeakPlace> places;
  /// The places that are thin, but fail by no wall and no gap: the longest first.
  std::vector<Crease> creases;
  /// The share of the surface's area, in [0, 1], that is in places.
  double failingShare{0};
  /// At this scale of the shape nothing fails, and all measures grow with it. 1.12: it passes at
  /// 112% of its size; at most 1 where it passes as it is, and so far at least it may shrink (1
  /// where there are creases). 0 where nothing is limited; infinite where no scale was found, as of
  /// a blade.
  double passingScale{0};
  /// False after cancelling; then the rest means nothing.
  bool complete{false};

  /// Whether nothing fails; creases do not.
  bool passes() const { return places.empty(); }
};

/// Values at the vertices, NaN where there is none. A field that no limit needs may be empty.
struct PrintFields {
  /// The girth; needed where tubes are limited.
  std::span<const double> girth;
  /// The medial thickness with the same options as the check's; needed where walls are limited.
  std::span<const double> thickness;
};

/// Why a surface must not pass a check, though nothing may be found in it: walls are limited, but
/// no vertex has a thickness; or walls or gaps are, and the surface is inside out, so that each
/// would be taken for the other (NO_THICKNESS). Nothing where it can be checked. O(n).
GIRTH_EXPORT std::optional<Error> whyNotChecked(const SurfaceMesh& mesh, const PrintFields& fields,
                                                const PrintLimits& limits);

/// Looks for all that does not meet the limits (web/docs/definitions.md, section 5, Definition
/// 5.7):
///
/// - Walls: the medial thickness at the vertices, and its least value within each face.
/// - Gaps: the same on the other side of the surface.
/// - Creases are told from both: material that is thin only where faces run into each other at an
///   angle, up to thick material within two limits; lips; and what rounding alone makes.
/// - Tubes, where the girth is below 2π times the limit: the least width of the cross-section
///   inside the loop, or the girth by π where that is less. A place longer round is a wall.
///
/// A length below a limit by a millionth of it passes, of walls and gaps by the rounding of the
/// coordinates in single precision.
/// `options.side` does not matter. Any number of threads gives the same result. O(n log n) for
/// usual surfaces, and a loop for every vertex of a tube. Errors: those of whyNotChecked; USAGE
/// where there are not as many values as vertices, a limit is negative or not a number, or the
/// angle is out of range.
GIRTH_EXPORT Result<PrintCheck> checkPrint(const SurfaceMesh& mesh, const PrintFields& fields,
                                           const PrintLimits& limits,
                                           const ThicknessOptions& options = {},
                                           const ExecutionContext& context = {});

/// The least width, in model units, of the cross-section inside a loop: the least distance of two
/// parallel lines, in the loop's mean plane, with the loop between them. 0 for a loop that goes out
/// and back. O(points²).
GIRTH_EXPORT double sectionWidth(const SurfaceMesh& mesh, const GirthLoop& loop);

}  // namespace girth
