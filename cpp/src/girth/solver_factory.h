// Solvers that share the prepared faces of a surface.
#pragma once

#include <memory>

#include "geodesic/unfolding.h"
#include "girth/girth_solver.h"

namespace girth {

/// Makes the solvers of several threads: each has scratch memory of its own.
struct SolverFactory {
  static GirthSolver onUnfolding(std::shared_ptr<const geodesic::Unfolding> unfolding);
};

}  // namespace girth
