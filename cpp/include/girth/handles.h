// Handles and tunnels: the shortest closed geodesics round a surface's handles and through them.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// On which side of its component a loop bounds a surface (web/docs/definitions.md, section 5).
enum class HandleKind : std::uint8_t {
  Handle = 0,   ///< inside: it goes round the material
  Tunnel = 1,   ///< outside: it goes round a hole
  Unknown = 2,  ///< the component has no inside: it, or what closes its holes, crosses it
};

/// "handle", "tunnel" or "unknown".
GIRTH_EXPORT std::string_view toString(HandleKind kind);

/// A closed geodesic round a handle or a tunnel.
struct Handle {
  /// In model units.
  double length{0};
  /// How much shorter a loop in its place may be, at most, in model units: one of its kind and
  /// component that is no sum of the shorter ones listed. 0: none is, which is proven to a share of
  /// 1e-9.
  double mayBeShorterBy{0};
  HandleKind kind{HandleKind::Unknown};  ///< round the material, or round a hole
  /// The edges it crosses and the vertices it passes in order; the last point equals the first.
  /// Between neighbours it is straight inside one face or along one edge. Among parallel loops
  /// in a band, it is the one in the middle.
  std::vector<SurfacePoint> points;
  /// Mean of the loop's points, each part counted by its length, in model units.
  Vec3 centre;
  /// The area that the loop encloses in its mean plane, in squared model units.
  double area{0};
  Index component{0};  ///< the number of its component of the surface, from 0
};

/// How handles are searched for.
struct HandleOptions {
  /// Points of each component whose loops are compared at first, at least 1: half of them spread
  /// over it, the others on the loops found. As many as it has vertices, or more: all of them.
  std::size_t basePoints{32};
  /// Windows of each component that may be propagated from other vertices to prove that no loop is
  /// shorter. Default: 2^26, some five seconds.
  std::size_t windows{std::size_t{1} << 26};
};

/// The handles of a surface.
struct Handles {
  /// The shortest first.
  std::vector<Handle> handles;
  /// Handles and tunnels that the genus promises and that were not found.
  Index unresolved{0};
};

/// For a component of genus g, g handle loops and g tunnel loops: no sum of some of either is the
/// boundary of a part of the surface. A handle loop bounds a surface inside the component (often a
/// disk: the cut through a handle), a tunnel loop one outside. They are closed geodesics, necks in
/// the sense of findNecks, exact to rounding. Boundary curves are none: holes count as closed, each
/// with a cone over the mean of its corners. Every component counts by itself, whichever others lie
/// inside it, and whichever way its faces look.
///
/// *Guaranteed*: their number, but for `unresolved`; their kinds, by linking numbers, which are
/// computed exactly, if the surface does not cross itself. Where it does, the numbers may
/// contradict each other: then there are 2g loops of an unknown kind, of which no sum bounds a part
/// of the surface. Each loop is locally shortest, and no loop in its place is shorter by more than
/// `mayBeShorterBy`. With all vertices as base points, if the shortest system of 2g loops consists
/// of handle loops and tunnel loops, that is 0. With fewer, loops are proven afterwards, the
/// shortest first: the shortest loop of a kind at a vertex changes by at most twice the way to
/// another one, so only those vertices are looked at at which it can be shorter; what is found is
/// taken instead. Which of several loops of one length is found is not told.
///
/// Time: for each base point one propagation over the whole component, O(n^1.5) to O(n² log n), on
/// all threads; for the proof up to `windows` windows; for the kinds as given at the header
/// loops/homology.h, about O(g² n). Nothing for components of genus 0. Any number of threads gives
/// the same result. Errors: INVALID_OPTION (`basePoints` is 0); CANCELLED.
///
/// \code
/// for (const girth::Handle& handle : girth::findHandles(mesh).value().handles) {
///   std::cout << girth::toString(handle.kind) << ' ' << handle.length << '\n';
/// }
/// \endcode
GIRTH_EXPORT Result<Handles> findHandles(const SurfaceMesh& mesh, const HandleOptions& options = {},
                                         const ExecutionContext& context = {});

}  // namespace girth
