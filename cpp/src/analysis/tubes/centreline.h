// Centrelines of branches: each point is the centroid of the section perpendicular to the line.
#pragma once

#include <optional>
#include <vector>

#include "analysis/tubes/tube_tree.h"
#include "girth/error.h"
#include "girth/execution.h"
#include "girth/section.h"

namespace girth::tubes {

/// A place of a centreline, and the section there.
struct LinePoint {
  Vec3 centre, direction;
  SectionCurve curve;
};

/// The section of a branch with a plane: the closed curve that runs over this branch alone, round
/// the point or nearest to it. Nothing where there is none.
std::optional<SectionCurve> sectionOf(const SurfaceMesh& mesh, const TubeTree& tree, Index branch,
                                      const Vec3& point, const Vec3& direction, bool inscribed);

/// The centreline of a branch, from its lower end: points at equal distances that have a section.
/// `spacing`: as TubesOptions::spacing. Empty where no level curve lies away from the ends, or no
/// section is closed. Errors: INVALID_OPTION (more than 100,000 points); CANCELLED.
Result<std::vector<LinePoint>> centrelineOf(const SurfaceMesh& mesh, const TubeTree& tree,
                                            Index branch, double spacing,
                                            const ExecutionContext& context);

}  // namespace girth::tubes
