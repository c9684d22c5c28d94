// Whether a loop that is known stands: whether its halves are shortest paths of the whole surface.
#pragma once

#include <cstddef>
#include <optional>

#include "geodesic/propagation.h"
#include "girth/execution.h"
#include "girth/surface_point.h"

namespace girth {

/// Looks for a shorter way to the midpoint of a loop, among the paths that may reach it in time: a
/// sixth of the work of an exact search, or less. Points are those of the mesh, lengths in model
/// units.
class LoopCheck {
 public:
  /// A propagation of one thread.
  explicit LoopCheck(geodesic::Propagation& propagation) : propagation_(&propagation) {}

  /// Whether no way from the base to the midpoint is shorter than half the loop. Nothing where the
  /// budget was met, or the context was cancelled.
  std::optional<bool> stands(const SurfacePoint& base, double length, const SurfacePoint& middle,
                             const ExecutionContext& context);
  /// After a loop did not: whether another one does not either, by what is known from that. Its
  /// base is no farther from that of the other than `away`: a way to its midpoint leads over that
  /// base.
  bool refutes(double away, double length, const SurfacePoint& middle) const;

  /// Windows made by the last question.
  std::size_t windows() const { return propagation_->windowsCreated(); }

 private:
  double wayTo(const SurfacePoint& point) const;

  geodesic::Propagation* propagation_;
};

}  // namespace girth
