// Necks: the closed geodesics that a surface cannot be slipped out of without stretching them.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "girth/cut_surface.h"
#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"
#include "girth/version.h"

namespace girth {

/// A closed geodesic that is shorter than every other closed curve near it
/// (web/docs/definitions.md, section 5).
struct Neck {
  /// In model units.
  double length{0};
  /// How far the girth must rise, at least, on the way over the surface from here to a narrower
  /// neck, in model units; infinite where no narrower one can be reached. See findNecks for what it
  /// is measured on.
  double prominence{std::numeric_limits<double>::infinity()};
  /// The loop: the edges it crosses and the vertices it passes in order; the last point equals the
  /// first. Between neighbours it is straight inside one face or along one edge. Among
  /// parallel loops in a band, it is the one in the middle.
  std::vector<SurfacePoint> points;
  /// Width of the band of parallel loops of the same length, in model units: 0 for a single one.
  double width{0};
  /// The vertices that the loop passes; of a band, that its two outermost loops pass. In rising
  /// order, at least one.
  std::vector<Vertex> vertices;
  /// Mean of the loop's points, each part counted by its length, in model units.
  Vec3 centre;
  /// Unit normal of the loop's mean plane: of all planes the one onto which it casts the largest
  /// area. Seen from its tip the loop runs counter-clockwise. Zero where there is none.
  Vec3 normal;
  /// Mean distance of the loop from its centre, within the mean plane, in model units.
  double radius{0};
  /// The area that the loop encloses in its mean plane, in squared model units.
  double area{0};
  /// The sides that it separates its component into, the larger area first; one where it separates
  /// nothing, as round a handle. Empty where the surface cannot be cut along it.
  std::vector<CurveSide> sides;
  /// Whether the girth is this neck's length at all of its vertices. Otherwise a shorter loop goes
  /// through one of them, as beside a thinner part.
  bool measuresGirth{true};
  /// Whether it touches the surface's boundary.
  bool touchesBoundary{false};
};

/// Which necks are wanted.
struct NeckOptions {
  /// The least prominence of the necks that are wanted, in model units, 0 or more.
  double minProminence{0};
};

/// The necks of a surface.
struct Necks {
  /// Most prominent first, of equal ones the shortest.
  std::vector<Neck> necks;
  /// Vertices whose loops could not be followed: their girth is unresolved, or drawing them tight
  /// took more steps than their size explains.
  Index unresolved{0};
  /// A least prominence for the clear ones, in model units: a twentieth of the narrowest neck's
  /// length, whatever `minProminence` leaves out. Necks of noise and most of bands of parallel
  /// loops are below it. 0 without necks.
  double suggestedProminence{0};
};

/// The necks that the loops of the vertices lead to: the loop at each vertex is drawn tight, and
/// pushed on where it can get shorter, until nothing near it is. Each neck is listed once, however
/// many vertices lead to it. There may be none.
///
/// *Found for certain* is every neck that measures the girth at a vertex which it passes, if no
/// other loop is as short there: every neck passes a vertex, and there the loop of the girth is the
/// neck itself. Others, longer than the girth all along, are found where a loop can be drawn tight
/// into them. Lengths are exact to rounding (1e-9); of a band whose loops differ by rounding of the
/// coordinates, the length is that of one of them. The angles are at least π less 1e-8 on each side
/// at every vertex.
///
/// *Prominence* is measured on the girth over the surface, in between vertices too: the way from
/// the neck to a narrower one is searched over the mesh's edges, which are cut in halves round the
/// highest point of the way, and wherever the girth may rise beyond that between the ends of an
/// edge, until the pieces are shorter than a hundredth of the neck's length, or of the prominence
/// where that is more. The girth changes by at most twice the distance, and is nowhere more than at
/// both ends of a piece along which one loop of theirs can be moved. So a way of this height
/// exists, to a hundredth of the greater of the two (but where the girth jumps); a lower one that
/// lies between vertices that are all higher, far from this one, is not seen. Less than a
/// thousandth of the length is given as 0. Among necks of equal length (to 1e-9), the first
/// one in the list counts as narrower.
///
/// `girth`: I(v) for each vertex; where it is NaN (not computed), the surface has no loop and no
/// way. Time: one loop for each vertex, about O(n^1.5) for all of n where they are short, and
/// mostly less than a hundred values of the girth for each neck, on all threads; memory for the
/// loops of some of the vertices. Any number of threads gives the same result. Errors: USAGE where
/// the values are not as many as the vertices; INVALID_OPTION where `minProminence` is negative or
/// NaN; CANCELLED.
///
/// \code
/// const girth::GirthField field = girth::girthField(mesh);
/// for (const girth::Neck& neck : girth::findNecks(mesh, field.values).value().necks) {
///   std::cout << neck.length << ' ' << neck.prominence << '\n';
/// }
/// \endcode
GIRTH_EXPORT Result<Necks> findNecks(const SurfaceMesh& mesh, std::span<const double> girth,
                                     const NeckOptions& options = {},
                                     const ExecutionContext& context = {});

/// The older form of `Necks::suggestedProminence`, of all necks of a surface, until 2.0.
GIRTH_DEPRECATED("use Necks::suggestedProminence")
GIRTH_EXPORT double suggestedProminence(std::span<const Neck> necks);

}  // namespace girth
