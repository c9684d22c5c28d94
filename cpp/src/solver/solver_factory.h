// Solvers that share the prepared faces of a surface, or search a part of it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "geodesic/propagation.h"
#include "geodesic/unfolding.h"
#include "girth/girth_solver.h"

namespace girth {

/// The short loops at a vertex.
struct LoopsUpTo {
  /// In the order of their lengths. All loops there that are shorter than `length` are made of
  /// these.
  std::vector<GirthLoop> loops;
  double length{0};  ///< in model units
};

/// Services of solvers for other parts of the library.
struct SolverFactory {
  /// One of the solvers of several threads: each has scratch memory of its own.
  static GirthSolver onUnfolding(std::shared_ptr<const geodesic::Unfolding> unfolding);
  /// The propagation that a solver searches with: between two calls another search may use it.
  static geodesic::Propagation& propagationOf(GirthSolver& solver);
  /// The girth of a point and its loop, of the loops and paths that stay within some faces of the
  /// unfolding: those for which `band` is not 0. Nothing where there is no loop, or the context was
  /// cancelled. The loop is a geodesic of the whole surface; its halves are the shortest of those
  /// within.
  static std::optional<GirthLoop> loopWithin(GirthSolver& solver, const SurfacePoint& point,
                                             const std::uint8_t* band,
                                             const ExecutionContext& context);
  /// The loops of the saddles of the distance from a vertex, up to a length in model units, or up
  /// to what the budget sufficed for. Nothing where the context was cancelled.
  static std::optional<LoopsUpTo> loopsUpTo(GirthSolver& solver, Vertex vertex, double length,
                                            const ExecutionContext& context);
};

}  // namespace girth
