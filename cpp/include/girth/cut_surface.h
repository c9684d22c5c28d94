// A surface cut along curves: necks, handles, contours, loops.
#pragma once

#include <span>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// A curve on a surface: points in order, each two neighbours in one face, where it runs straight.
/// Closed if the last point equals the first.
using SurfaceCurve = std::vector<SurfacePoint>;

/// How surfaces are cut.
struct CutOptions {
  /// Closes the rims that cutting made: each with the triangulation of least area, one of more than
  /// 100 edges with a fan round its middle.
  bool cap{false};
  /// With `cap`: a hollow body is cut with its cavities, by caps with holes. See cutSurface.
  bool cutsCavities{true};
};

/// The parts of a surface that was cut.
struct CutSurface {
  /// All parts in one; they are its components, where the cuts divide the surface.
  SurfaceMesh mesh;
  /// For each vertex the point of the uncut surface that it stands at; vertices of caps, which come
  /// last, have none.
  std::vector<SurfacePoint> points;
  /// For each face the face of the uncut surface that it is a piece of; none for those of caps.
  std::vector<Face> faces;
};

/// Points nearer to a vertex than this share of their edge are moved to it.
inline constexpr double kLeastCutShare = 1e-6;

/// Cuts along curves: each face is divided along what runs through it, with new vertices on its
/// edges where a curve crosses them and inside it where a curve turns; nothing else is moved. Along
/// the curves every vertex has a copy on each side, and so the surface has a boundary there. Curves
/// may touch each other and themselves, run along edges and along the boundary, where nothing is
/// cut, and cross each other at a vertex or at a point of an edge that both pass, where all that
/// meets is taken apart; they must not cross anywhere else. A curve that is not closed is a slit.
///
/// A cavity is a closed component that lies in another one, round no third one in between, and
/// faces the other way. Where a closed curve runs round a body with cavities, or in one, and `cap`
/// is set, its mean plane cuts the others as well, inside the body's curve; a given curve round the
/// same place is taken instead. Their rims are closed by one cap with holes, of least area: the
/// parts enclose together what the body did. A cavity in no plane's way is left whole:
/// partsOf counts it with the part that encloses it.
///
/// No edge is made that is shorter than a millionth (kLeastCutShare) of the one that it is a part
/// of: a point nearer to a vertex is moved there, and two points of an edge nearer to each other
/// become one. Divided faces are triangulated with the best shaped ears first.
///
/// O(n log n + k²) for k pieces of curves in one face. Errors: INVALID_POINT (element: the point's
/// place in its curve) where a point is none of the surface or two neighbours lie in no common
/// face; INVALID_OPTION where curves cross inside a face, and where one lies inside a single face
/// (element: the face), and where no cap with holes of up to 1000 edges closes a hollow body;
/// LIMIT_EXCEEDED (too many faces to number); CANCELLED. The context serves
/// to cancel only.
///
/// \code
/// const girth::GirthField field = girth::girthField(mesh);
/// std::vector<girth::SurfaceCurve> curves;
/// for (const girth::Neck& neck : girth::findNecks(mesh, field.values).value().necks) {
///   curves.push_back(neck.points);
/// }
/// std::cout << girth::cutSurface(mesh, curves, {.cap = true}).value().mesh.faceCount() << '\n';
/// \endcode
GIRTH_EXPORT Result<CutSurface> cutSurface(const SurfaceMesh& mesh,
                                           std::span<const SurfaceCurve> curves,
                                           const CutOptions& options = {},
                                           const ExecutionContext& context = {});

/// One of the pieces into which a closed curve separates a component.
struct CurveSide {
  double area{0};  ///< in squared model units
  /// Enclosed by this side and the cone over the curve from the mean of its points, in cubed model
  /// units: negative where the surface faces inwards. NaN where the side has a boundary.
  double volume{0};
};

/// The sides of a curve, the larger area first; one where it does not separate its component.
/// Errors are the same.
GIRTH_EXPORT Result<std::vector<CurveSide>> sidesOf(const SurfaceMesh& mesh,
                                                    const SurfaceCurve& curve);

/// One of the components of a surface, or a part of several, as a surface of its own.
struct SurfaceComponent {
  SurfaceMesh mesh;              ///< the component or part
  std::vector<Vertex> vertices;  ///< for each vertex its number in the whole, in rising order
  std::vector<Face> faces;       ///< for each face the same
};

/// The components of a surface, in its numbering of them. O(n log n).
GIRTH_EXPORT std::vector<SurfaceComponent> componentsOf(const SurfaceMesh& mesh);

/// The parts of a surface: as componentsOf, but a body and its cavities, as of cutSurface, are one
/// part. Its volume is the volume that they enclose together.
GIRTH_EXPORT std::vector<SurfaceComponent> partsOf(const SurfaceMesh& mesh);

/// Measures of a part of a surface.
struct PartMeasures {
  double area{0};       ///< in squared model units
  double volume{0};     ///< enclosed, in cubed model units; NaN where the part has a boundary
  Index genus{0};       ///< handles, those of its cavities among them
  Index boundaries{0};  ///< boundary curves
};

/// The measures of a part. Its volume is negative where it faces inwards. O(n).
GIRTH_EXPORT PartMeasures partMeasures(const SurfaceMesh& part);

}  // namespace girth
