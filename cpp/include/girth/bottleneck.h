// The bottleneck between two points: the narrowest place that no way from one to the other avoids.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "girth/cut_surface.h"
#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// The kind of the narrowest place of the widest way (web/docs/definitions.md, section 5).
enum class BottleneckKind : std::uint8_t {
  /// A neck between the points: its loop is a closed geodesic, shorter than every other closed
  /// curve near it.
  Neck = 0,
  /// A place between them whose loop can be made shorter by moving it to one side.
  Pass = 1,
  /// One of the two points: there is no neck between them.
  End = 2,
};

/// "neck", "pass" or "end".
GIRTH_EXPORT std::string_view toString(BottleneckKind kind);

/// The bottleneck between two points.
struct Bottleneck {
  /// The least girth on the widest way, in model units: the length of its loop.
  double girth{0};
  BottleneckKind kind{BottleneckKind::End};  ///< a neck, a pass, or an end
  /// Where on the way the girth is least.
  SurfacePoint place;
  /// The loop: of a neck the closed geodesic itself (of a band of parallel ones that in the
  /// middle), otherwise the loop of the girth at `place`, empty where that is unresolved. As
  /// GirthLoop::points; the last point equals the first.
  std::vector<SurfacePoint> points;
  /// Mean of the loop's points, each part counted by its length, in model units; zero where there
  /// is no loop.
  Vec3 centre;
  /// The area that the loop encloses in its mean plane, in squared model units.
  double area{0};
  /// The sides of a neck, as Neck::sides; empty for other kinds.
  std::vector<CurveSide> sides;
  /// The way that was found, from the first point to the second, along the pieces of the mesh's
  /// edges: it is a witness of the girth, and not short.
  std::vector<SurfacePoint> way;
};

/// The way over the surface from one point to another whose least girth is greatest,
/// and the narrowest place on it.
///
/// The girth is measured over the surface, in between vertices too, as the prominence of findNecks:
/// ways lead over the mesh's edges, which are cut in halves round the narrowest place of the way,
/// and wherever the girth may fall below that between the ends of an edge (it changes by at most
/// twice the distance), until the pieces are shorter than a hundredth of the narrowest girth. So
/// the way's least girth is known to a hundredth (but where the girth jumps). A neck's length is
/// exact to rounding: its loop is drawn tight from there. A place that is wider by less than a
/// hundredth, and a wider way between vertices that are all narrower, may be missed.
///
/// `girth`: I(v) for each vertex; where it is NaN no way leads. Time: some hundred values of the
/// girth, on all threads. Any number of threads gives the same result. Errors: USAGE where the
/// values are not as many as the vertices; INVALID_POINT or VERTEX_OUT_OF_RANGE where one of the
/// points is none of the surface; INVALID_POINT where they lie in different components, or no way
/// leads from one to the other; CANCELLED.
///
/// \code
/// const girth::GirthField field = girth::girthField(mesh);
/// const auto one = girth::SurfacePoint::atVertex(girth::Vertex{0});
/// const auto two = girth::SurfacePoint::atVertex(girth::Vertex{1});
/// std::cout << girth::findBottleneck(mesh, field.values, one, two).value().girth << '\n';
/// \endcode
GIRTH_EXPORT Result<Bottleneck> findBottleneck(const SurfaceMesh& mesh,
                                               std::span<const double> girth,
                                               const SurfacePoint& from, const SurfacePoint& to,
                                               const ExecutionContext& context = {});

}  // namespace girth
