// How far the surface reaches from each point: mean and greatest geodesic distance.
#pragma once

#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/vertex_function.h"

namespace girth {

/// How geodesic distances are computed.
enum class DistanceMethod : std::uint8_t {
  Exact,         ///< windows: GeodesicSolver
  FastMarching,  ///< Kimmel and Sethian 1998: off by a share that falls with the triangles' size
};

/// For each vertex p two numbers, in model units, over the vertices of its own component. NaN where
/// the work was cancelled before, and where exact distances would take more than 67 million
/// windows.
struct GeodesicExtent {
  /// The mean of the distances from p, weighted by the vertices' areas (GeoAverage, centricity).
  std::vector<double> average;
  /// The greatest distance from p (GeoFarthest, eccentricity).
  std::vector<double> farthest;
  /// False after cancelling.
  bool complete{false};
};

/// GeoAverage and GeoFarthest at all vertices (web/docs/definitions.md, section 4), by one distance
/// field for each. Any number of threads gives the same bits. Time as of so many fields: O(n² log
/// n) by fast marching, about O(n^2.5) exactly.
///
/// \code
/// const auto extent = girth::geodesicExtent(mesh, girth::DistanceMethod::Exact);
/// std::cout << extent.average[0] << ' ' << extent.farthest[0] << '\n';
/// \endcode
GIRTH_EXPORT GeodesicExtent geodesicExtent(const SurfaceMesh& mesh, DistanceMethod method,
                                           const ExecutionContext& context = {});

/// Which of the two.
enum class ExtentMeasure : std::uint8_t { Average, Farthest };

/// GeoAverage or GeoFarthest, in model units, vertex by vertex.
GIRTH_EXPORT VertexFunction<double> geodesicExtentFunction(const SurfaceMesh& mesh,
                                                           ExtentMeasure measure,
                                                           DistanceMethod method);
/// The mesh must outlive the function: keep it in a variable.
VertexFunction<double> geodesicExtentFunction(const SurfaceMesh&&, ExtentMeasure measure,
                                              DistanceMethod method) = delete;

}  // namespace girth
