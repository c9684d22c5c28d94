// The branches of a tubular surface, by a harmonic function from one end to the others.
#pragma once

#include <span>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"
#include "girth/tubes.h"

namespace girth::tubes {

/// Where a tube ends.
struct TreeEnd {
  Index component{0};
  std::vector<Vertex> vertices;  ///< vertices of a boundary curve in order, or one vertex
  double length{0};  ///< length of the boundary curve, in model units; 0 where it is closed
  Vec3 centre;       ///< the mean of the curve's points, or the vertex

  bool isOpen() const { return vertices.size() > 1; }
};

/// A level curve of the function round a branch.
struct TreeLevel {
  double value{0};   ///< the value of the function
  double length{0};  ///< in model units
  Vec3 centre;       ///< the mean of its points
};

/// A part of the surface between two values of the function.
struct TreeBranch {
  Index component{0};
  Index parent{kNoIndex};  ///< the branch with the values below; none at the first end
  Index top{kNoIndex};     ///< the end at its highest values; none at a branching
  Index bottom{kNoIndex};  ///< the end at its lowest ones; none at a branching
  double low{0}, high{0};
  std::vector<TreeLevel> levels;  ///< in rising order
};

/// Where a branch ends closed.
struct ClosedEnds {
  bool below{false}, above{false};
};

/// All branches of a surface.
struct TubeTree {
  ClosedEnds closedEndsOf(const TreeBranch& branch) const {
    const auto isClosed = [&](Index end) { return end != kNoIndex && !ends[end].isOpen(); };
    return {isClosed(branch.bottom), isClosed(branch.top)};
  }

  std::vector<TreeEnd> ends;
  std::vector<TreeBranch> branches;   ///< by component, each behind its parent
  std::vector<Index> branchOfVertex;  ///< none for components that are no tubes
  std::vector<NoTubeComponent> others;
};

/// Divides a surface into branches. `ends`: as TubesOptions::ends. Errors: VERTEX_OUT_OF_RANGE;
/// LIMIT_EXCEEDED; CANCELLED.
Result<TubeTree> growTree(const SurfaceMesh& mesh, std::span<const SurfacePoint> ends,
                          const ExecutionContext& context);

}  // namespace girth::tubes
