// Tubes: the centrelines of vessels, roots, horns and pipes, what is measured along them, and where
// they narrow and widen.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// The measures of a tube at one place of its centreline (web/docs/definitions.md, section 5).
struct TubeStation {
  /// The number of the branch.
  Index branch{0};
  /// How far along the centrelines it is from where the first branch begins, in model units.
  double distance{0};
  /// A point of the centreline: the centroid of the section.
  Vec3 centre;
  /// Along the centreline, of length 1, away from the first end.
  Vec3 direction;
  /// The diameter of a circle with the section's area, in model units.
  double equivalentDiameter{0};
  /// The area of the section perpendicular to the centreline, in squared model units.
  double area{0};
  /// The length of its outline, in model units.
  double perimeter{0};
  /// The diameter of the largest circle within it, in model units.
  double inscribedDiameter{0};
  /// The least distance of two parallel lines that hold it between them, in model units.
  double leastWidth{0};
  /// The greatest such distance, in model units.
  double greatestWidth{0};
  /// The exact girth at `place`, in model units; NaN where no loop goes round, as in caps (where it
  /// is longer than the outline), or where it was not asked for.
  double girth{0};
  /// The point of the outline that is nearest to the centre.
  SurfacePoint place;
  /// The curvature of the centreline, in 1 / model units: one over the radius of its circle.
  double curvature{0};
  /// How fast the centreline leaves the plane of that circle, in radians per model unit; positive
  /// where it is screwed to the right. NaN where it is straight: a curvature below 0.001 divided by
  /// the equivalent diameter.
  double torsion{0};
  /// The outline: the edges that it crosses in order; the last point equals the first.
  std::vector<SurfacePoint> points;
};

/// Whether a tube is narrow or wide at a place.
enum class TubeChange : std::uint8_t {
  Narrowing,  ///< narrower than on both sides: a stenosis
  Widening,   ///< wider than on both sides: a bulge, an aneurysm
};

/// "narrowing" or "widening".
GIRTH_EXPORT std::string_view toString(TubeChange change);

/// The diameter that a narrowing or widening is compared with.
enum class TubeReference : std::uint8_t {
  Taper,   ///< the diameter between both sides, in proportion to the distances
  Mean,    ///< the mean diameter of both sides
  Beyond,  ///< the diameter of the side that is farther along
  Before,  ///< the diameter of the side that is less far along
};

/// "taper", "mean", "beyond" or "before".
GIRTH_EXPORT std::string_view toString(TubeReference reference);

/// A place where a tube is narrower or wider than on both sides.
struct TubePlace {
  /// Which of the two it is.
  TubeChange change{TubeChange::Narrowing};
  /// The number of the branch.
  Index branch{0};
  /// Where its section is least, or greatest, in model units, as TubeStation::distance.
  double distance{0};
  /// The side before: the nearest place from which the tube is no wider (no narrower) towards its
  /// beginning, in model units, as TubeStation::distance.
  double beforeDistance{0};
  /// The side beyond, in model units: the same towards its end.
  double beyondDistance{0};
  /// How long it is: the part along which the diameter differs from the taper between both sides by
  /// more than half as much as at the place itself, in model units.
  double length{0};
  /// The equivalent diameter at the place, in model units.
  double equivalentDiameter{0};
  /// The equivalent diameter that it is compared with, in model units.
  double reference{0};
  /// How much less (more) the equivalent diameter is, as a share of the reference.
  double degreeByDiameter{0};
  /// How much less (more) the area is, as a share of the area of the reference's circle.
  double degreeByArea{0};
  /// The equivalent diameter at `beforeDistance`, in model units.
  double beforeDiameter{0};
  /// The equivalent diameter at `beyondDistance`, in model units.
  double beyondDiameter{0};
  /// The area of the section there, in squared model units.
  double area{0};
  /// The length of its outline, in model units.
  double perimeter{0};
  /// The diameter of the largest circle within it, in model units.
  double inscribedDiameter{0};
  /// The least distance of two parallel lines that hold it between them, in model units.
  double leastWidth{0};
  /// The length of the neck that a narrowing's outline is drawn tight to (girth/necks.h); of a
  /// widening the exact girth at the point of the outline nearest to the centre. In model units;
  /// NaN where there is none, or where it was not asked for.
  double girth{0};
  /// The centroid of the section.
  Vec3 centre;
  /// The outline, as TubeStation::points.
  std::vector<SurfacePoint> points;
};

/// A tube between two ends or branchings.
struct TubeBranch {
  /// The component of the surface that it lies on.
  Index component{0};
  /// The number of the branch that it leaves; none where it begins at an end.
  Index parent{kNoIndex};
  /// Whether it leads to an end, and not to a branching.
  bool ends{true};
  /// Whether that end is open: a boundary curve of the surface.
  bool open{false};
  /// A vertex of that end; none where it leads to a branching.
  Vertex end{Vertex::none};
  /// The distance of its first station, in model units, as TubeStation::distance.
  double firstDistance{0};
  /// The distance of its last station, in model units.
  double lastDistance{0};
  /// The median of the equivalent diameters of its stations, in model units.
  double median{0};
  /// The numbers of its stations in the result, the first and the one behind the last.
  Index firstStation{0};
  /// See firstStation.
  Index endStation{0};
};

/// Why a component is no tube.
enum class NoTube : std::uint8_t {
  Handle,  ///< it has a handle: centrelines would run in a circle
  Blunt,   ///< it is less than 2.5 times as long as wide, as a ball is
  Flat,    ///< it is more than four times as wide as thick, as a plate is
  Coarse,  ///< no section perpendicular to its line is closed
};

/// "handle", "blunt", "flat" or "coarse".
GIRTH_EXPORT std::string_view toString(NoTube reason);

/// A component that is no tube.
struct NoTubeComponent {
  /// Its number.
  Index component{0};
  /// The reason for it.
  NoTube reason{NoTube::Blunt};
};

/// The tubes of a surface.
struct Tubes {
  /// Each behind the one that it leaves.
  std::vector<TubeBranch> branches;
  /// Components that are no tubes, in rising order.
  std::vector<NoTubeComponent> others;
  /// Narrowings and widenings, by branch and by distance.
  std::vector<TubePlace> places;
  /// The stations of all branches, by branch and by distance.
  std::vector<TubeStation> stations;
};

/// How tubes are measured.
struct TubesOptions {
  /// Points at the ends: the vertex nearest to each lies on a boundary curve, or where a tube ends
  /// closed; the first one of a component is where its centrelines begin. Where a component has
  /// fewer than two, the others are found: boundary curves, but for holes shorter than a tenth of
  /// the longest, and the places that are farthest away, where a closed branch is longer than a
  /// tenth of the whole.
  std::vector<SurfacePoint> ends;
  /// The distance of stations, in model units. 0: an eighth of the median diameter, but at most
  /// 1,000 stations a branch.
  double spacing{0};
  /// The least degree, by diameter, of narrowings and widenings that are listed, above 0.
  double leastDegree{0.1};
  /// The diameter that each is compared with.
  TubeReference reference{TubeReference::Taper};
  /// Whether the exact girth is measured too, which takes longer.
  bool girth{true};
};

/// Finds the centrelines of tubes, and measures what lies along them.
///
/// The surface is divided into branches by a harmonic function from one end to the others. The line
/// through the middles of its level curves is then moved until each of its points is the centroid
/// of the section perpendicular to it. Stations whose section is open, or runs over another branch,
/// are left out. Sections are exact on the surface; the line is exact where it is straight or a
/// circle, to the square of the spacing. Where a tube ends closed, the line goes on as it bends
/// before.
///
/// Time: O(n) for each station and step, on all threads, and one loop for each station; the same
/// result for any number of threads. Errors: VERTEX_OUT_OF_RANGE; INVALID_POINT; INVALID_OPTION (a
/// spacing or degree that is negative or not finite, one that makes more than 100,000 stations);
/// LIMIT_EXCEEDED; CANCELLED.
///
/// \code
/// for (const girth::TubePlace& place : girth::findTubes(mesh, {}).value().places) {
///   std::cout << toString(place.change) << ' ' << 100 * place.degreeByDiameter << " %\n";
/// }
/// \endcode
GIRTH_EXPORT Result<Tubes> findTubes(const SurfaceMesh& mesh, const TubesOptions& options,
                                     const ExecutionContext& context = {});

}  // namespace girth
