// Solvers that share the prepared faces of a surface, or search a part of it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "geodesic/propagation.h"
#include "geodesic/unfolding.h"
#include "girth/girth_solver.h"

namespace girth {

/// What parts of the library may ask of solvers.
struct SolverFactory {
  /// One of the solvers of several threads: each has scratch memory of its own.
  static GirthSolver onUnfolding(std::shared_ptr<const geodesic::Unfolding> unfolding);
  /// What a solver searches with: between two calls another search may use it.
  static geodesic::Propagation& propagationOf(GirthSolver& solver);
  /// The girth of a point and its loop, of the loops and paths that stay within some faces of the
  /// unfolding: those for which `band` is not 0. Nothing where there is no loop, or the context was
  /// cancelled. The loop is a geodesic of the whole surface; its halves are the shortest of those
  /// within.
  static std::optional<GirthLoop> loopWithin(GirthSolver& solver, const SurfacePoint& point,
                                             const std::uint8_t* band,
                                             const ExecutionContext& context);
};

}  // namespace girth
