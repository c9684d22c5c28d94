// The medial thickness: the largest ball inside a body that touches its surface at a point.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"
#include "girth/vertex_function.h"

namespace girth {

/// On which side of the surface balls are laid.
enum class ThicknessSide : std::uint8_t {
  Inside,   ///< in the body: how thick it is
  Outside,  ///< in the space around: how far it is to the next surface, the clearance
};

/// Options of the thickness: which faces count as facing a point.
struct ThicknessOptions {
  /// In radians, in (0, π/2). Where two faces meet at a sharper angle, measured within the body,
  /// they face each other, and the thickness falls to 0 at their edge. Faces that lie at a blunter
  /// angle to each other do not: a cube is as thick at its edges as in the middle. Every convex
  /// body has faces that meet at 70.6° or less, if they meet.
  double sharpRadians{1.3089969389957472};  // 75°
  /// Which balls.
  ThicknessSide side{ThicknessSide::Inside};
};

/// How thick the body is under each vertex.
struct ThicknessField {
  /// In model units, one for each vertex; NaN where nothing faces the vertex, or before the work
  /// was cancelled.
  std::vector<double> values;
  /// Vertices that nothing faces.
  Index withoutValue{0};
  /// isInsideOut of the surface.
  bool insideOut{false};
  /// False after cancelling.
  bool complete{false};
};

/// The medial thickness of every vertex (web/docs/definitions.md, section 4, Definition 4.1): the
/// diameter of the largest ball inside that touches the surface there, of the contacts that count
/// for `options.sharpRadians`. It is exact to rounding on flat walls and in wedges; on curved ones,
/// whose normals at the vertices are means of those of the faces, to the square of the length of
/// the edges. At an edge with a crease of more than 30° each side has its own ball; the smallest
/// counts.
///
/// The surface may be open. Any number of threads gives the same bits, natively and in WebAssembly.
/// O(n log n) for usual surfaces. Errors: USAGE for an angle out of range.
///
/// \code
/// const auto thickness = girth::medialThickness(mesh).value();
/// std::cout << thickness.values[0] << '\n';
/// \endcode
GIRTH_EXPORT Result<ThicknessField> medialThickness(const SurfaceMesh& mesh,
                                                    const ThicknessOptions& options = {},
                                                    const ExecutionContext& context = {});

/// The medial thickness, in model units, vertex by vertex. Errors are the same.
GIRTH_EXPORT Result<VertexFunction<double>> medialThicknessFunction(
    const SurfaceMesh& mesh, const ThicknessOptions& options = {});
/// The mesh must outlive the function: keep it in a variable.
Result<VertexFunction<double>> medialThicknessFunction(
    const SurfaceMesh&&, const ThicknessOptions& options = {}) = delete;

/// Remarks on the values for people, in sentences: that the surface is inside out, that
/// nothing faces so many of its vertices. Empty where there is nothing to say.
GIRTH_EXPORT std::string thicknessNote(bool insideOut, Index withoutValue, Index vertices);

}  // namespace girth
