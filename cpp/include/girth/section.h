// Plane sections: where planes cut a surface, and the measures of the curves.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/limbs.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// A curve in which a plane cuts a surface (web/docs/definitions.md, section 5).
struct SectionCurve {
  /// The edges that it crosses and the vertices that it passes, in order; straight between
  /// neighbours. Seen from the tip of the plane's normal, what the surface encloses lies on the
  /// left. The last point of a closed curve equals the first.
  std::vector<SurfacePoint> points;
  /// False where it ends at the surface's boundary.
  bool closed{true};
  /// The component of the surface that it lies on.
  Index component{kNoIndex};
  /// The number of the limb that it lies on, where limbs were asked for: more than half of its
  /// length does.
  Index limb{kNoIndex};
  /// Its length, in model units; of an open curve without the gap.
  double perimeter{0};
  /// The perimeter of its convex hull in the plane, in model units: what a tape shows, which spans
  /// hollows.
  double tape{0};
  /// The area that it encloses, those of the holes in it taken away, in squared model units; 0
  /// where it is open.
  double area{0};
  /// The diameter of a circle of that area, in model units.
  double equivalentDiameter{0};
  /// The least distance of two parallel lines in the plane that hold it between them, in model
  /// units.
  double leastWidth{0};
  /// The greatest one, in model units: that of its two points that are farthest apart.
  double greatestWidth{0};
  /// The centroid of its area; of an open curve, of its length.
  Vec3 centre;
  /// The diameter of the largest circle in the plane that it encloses and none of its holes meets,
  /// in model units; 0 where it is open. NaN where circles were not asked for.
  double inscribedDiameter{std::numeric_limits<double>::quiet_NaN()};
  /// The centre of that circle, of several equal ones of any; `centre` where there is none. NaN
  /// where circles were not asked for.
  Vec3 inscribedCentre;
  /// Whether it bounds a hole in another curve: what the surface encloses lies round it.
  bool hole{false};
};

/// The curves that one plane cuts.
struct Section {
  /// The plane's normal, of length 1.
  Vec3 normal{0, 0, 1};
  /// normal · x of all points of the plane, in model units.
  double offset{0};
  /// In the order of the first face that each runs through. Empty where the plane misses the
  /// surface.
  std::vector<SectionCurve> curves;
  /// The sum of the curves' lengths, in model units.
  double perimeter{0};
  /// The perimeter of the convex hull of all curves, in model units: one tape round them.
  double tape{0};
  /// The sum of the areas of the curves that are no holes, in squared model units.
  double area{0};
};

/// The curves that several planes cut.
struct Sections {
  /// In the order in which the planes were given.
  std::vector<Section> sections;
};

/// The least and the greatest normal · x of a surface, in model units.
struct HeightRange {
  /// At the lowest vertex.
  double low{0};
  /// At the highest one.
  double high{0};
};

/// How far a surface reaches along a direction. O(n). Error: INVALID_OPTION where the direction has
/// no length, or one that is not finite.
GIRTH_EXPORT Result<HeightRange> heightRange(const SurfaceMesh& mesh, const Vec3& normal);

/// Which planes cut a surface.
struct SectionsOptions {
  /// The planes' normal, of any length but 0.
  Vec3 normal;
  /// Where each plane lies: normal · x in model units, where the normal has length 1.
  std::vector<double> offsets;
  /// Whether each curve has its largest inscribed circle, which takes longer.
  bool inscribed{false};
};

/// Cuts a surface with planes of one normal, at several offsets, and measures the curves.
///
/// *Planes through vertices.* A vertex that lies in the plane (nearer to it than 1e-12 of the
/// greatest coordinate) counts as lying above it, on the side of the normal. So every curve runs
/// through edges that lead from below to above, curves never end inside the surface, and where the
/// plane touches it from above there is none. A face in the plane is part of the section by its
/// outline, where the surface goes on below it.
///
/// *Holes* are found by the surface's orientation: a closed curve is a hole where the enclosed side
/// lies round it and another curve of the section lies round that. Curves of bodies that overlap
/// are measured one by one.
///
/// On polyhedra the measures are exact to rounding. Inscribed circles are the largest to 1e-12 of
/// their diameter, proven by branch and bound; where that takes more than 100,000 squares, as of
/// curves 10,000 times as long as wide, the largest found. Time: O(n log m + c log c) for n faces,
/// m planes and c crossed edges, without the circles, on all threads; the same result for any
/// number of them. Errors: INVALID_OPTION (a normal without length, an offset that is not finite),
/// CANCELLED.
GIRTH_EXPORT Result<Sections> findSections(const SurfaceMesh& mesh, const SectionsOptions& options,
                                           const ExecutionContext& context = {});

/// The section with one plane. Errors are the same.
GIRTH_EXPORT Result<Section> findSection(const SurfaceMesh& mesh, const Vec3& normal,
                                         double offset);

/// Which planes pass points of a surface.
struct SectionsThroughOptions {
  /// The points: one for each plane.
  std::vector<SurfacePoint> points;
  /// The planes' normal, of any length but 0.
  Vec3 normal{0, 0, 1};
  /// Whether each plane is perpendicular to the limb or tube at its point, instead of the normal.
  bool across{false};
  /// Whether each curve has its largest inscribed circle, which takes longer.
  bool inscribed{false};
};

/// Cuts a surface with a plane through each of some points. Errors: those of `findSections` and,
/// across limbs, of `directionAlong`; VERTEX_OUT_OF_RANGE, INVALID_POINT.
GIRTH_EXPORT Result<Sections> sectionsThrough(const SurfaceMesh& mesh,
                                              const SectionsThroughOptions& options,
                                              const ExecutionContext& context = {});

/// The curve of a section that runs through a point, or past it nearest; null: it has none.
GIRTH_EXPORT const SectionCurve* curveThrough(const SurfaceMesh& mesh, const Section& section,
                                              const SurfacePoint& point);

/// Finds the limb of each curve. `limbs`: of the same surface (girth/limbs.h).
GIRTH_EXPORT void placeOnLimbs(const SurfaceMesh& mesh, std::span<const Limb> limbs,
                               Sections& sections);

/// Where a surface has the most or the least of a measure.
enum class SectionExtreme : std::uint8_t {
  Widest,     ///< most
  Narrowest,  ///< least, of planes that meet the surface
};

/// "widest" or "narrowest".
GIRTH_EXPORT std::string_view toString(SectionExtreme extreme);

/// A measure of a section.
enum class SectionMeasure : std::uint8_t {
  Perimeter,  ///< the sum of the curves' lengths
  Tape,       ///< one tape round all curves
};

/// "perimeter" or "tape".
GIRTH_EXPORT std::string_view toString(SectionMeasure measure);

/// Which section is the widest or the narrowest.
struct ExtremeSectionOptions {
  /// The planes' normal, of any length but 0.
  Vec3 normal;
  /// Which of the two is looked for.
  SectionExtreme extreme{};
  /// The least offset of a plane, in model units.
  double low{-std::numeric_limits<double>::infinity()};
  /// The greatest one, in model units.
  double high{std::numeric_limits<double>::infinity()};
  /// The measure that is compared.
  SectionMeasure measure{SectionMeasure::Perimeter};
  /// Whether each curve has its largest inscribed circle, which takes longer.
  bool inscribed{false};
};

/// Finds the section in which a measure is greatest or least, of all planes of one normal in a
/// range of offsets. Between the heights of two vertices the perimeter is linear in the offset, and
/// the tape convex: the greatest, and the least perimeter, are at such a height, just above one (by
/// 2e-12 of the greatest coordinate), or at an end of the range; the least tape is found between
/// them, by parabolas
/// and golden sections (Brent 1973). Among equal ones, it is the lowest. Time: O(c log c) for the
/// edges that planes at all heights of vertices cross, on all threads; the same result for any
/// number of them. Errors: INVALID_OPTION (a normal without length, no range, or no plane of it
/// that meets the surface), CANCELLED.
GIRTH_EXPORT Result<Section> extremeSection(const SurfaceMesh& mesh,
                                            const ExtremeSectionOptions& options,
                                            const ExecutionContext& context = {});

/// The offset of the plane through a point: normal · x in model units, where the normal has length
/// 1 (it may be given with any length but 0). Error: INVALID_OPTION.
GIRTH_EXPORT Result<double> heightOf(const SurfaceMesh& mesh, const Vec3& normal,
                                     const SurfacePoint& point);

/// Along the limb or tube at a point, of length 1: the normal of the mean plane of the girth loop
/// there (web/docs/definitions.md, section 5). Errors: VERTEX_OUT_OF_RANGE, INVALID_POINT, also
/// where no loop encloses an area.
GIRTH_EXPORT Result<Vec3> directionAlong(const SurfaceMesh& mesh, const SurfacePoint& point);

}  // namespace girth
