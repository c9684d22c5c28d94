// Values from one triangulation of a surface to another.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"

namespace girth {

/// The girth differs by at most so many times the distance along the surface, except where it jumps
/// (web/docs/definitions.md, section 2).
inline constexpr double kSteepestGirth = 2;

/// For each vertex of `points` the nearest point of `surface`, in space. Where faces lie back to
/// back, those count that face the same way as the vertex does, so that values do not jump through
/// thin walls. O((n + m) log n).
GIRTH_EXPORT std::vector<SurfacePoint> nearestPoints(const SurfaceMesh& surface,
                                                     const SurfaceMesh& points);

/// For each place the nearest point of `surface`, in space. A share of a corner below 1e-9 counts
/// as 0: the point lies on a side. O((n + m) log n).
GIRTH_EXPORT std::vector<SurfacePoint> nearestPoints(const SurfaceMesh& surface,
                                                     std::span<const Vec3> places);

/// Values at points of a surface, linear within each face. Where two corners of a face differ by
/// more than `steepest` times their distance (kSteepestGirth for the girth), the value of
/// the nearest corner is taken instead, and also where a corner has no value (NaN).
GIRTH_EXPORT std::vector<double> interpolated(
    const SurfaceMesh& surface, std::span<const double> values,
    std::span<const SurfacePoint> points,
    double steepest = std::numeric_limits<double>::infinity());

/// A girth of `surface` at the vertices of another mesh that lies there, whose nearest points are
/// given. As `interpolated` with kSteepestGirth; but between edges of at most that slope a face may
/// be a little steeper, which the other mesh's edges would show as jumps: where one rises by up to
/// half more than twice its length, its upper end is lowered. O(n log n).
GIRTH_EXPORT std::vector<double> carriedBack(const SurfaceMesh& surface,
                                             std::span<const double> girth,
                                             const SurfaceMesh& other,
                                             std::span<const SurfacePoint> nearest);

/// For each point the nearest corner of its face: the vertex to take kinds from.
GIRTH_EXPORT std::vector<Vertex> nearestVertices(const SurfaceMesh& surface,
                                                 std::span<const SurfacePoint> points);

}  // namespace girth
