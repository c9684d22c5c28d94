// The knowledge of the girth at the vertices of a large surface, while loops run from neighbour to
// neighbour.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "girth/girth_solver.h"
#include "girth/surface_mesh.h"
#include "girth/surface_point.h"
#include "no_value.h"
#include "solver/refined/base_graph.h"

namespace girth {

/// The best loop that is known at a base.
struct KnownLoop {
  /// In model units; NaN: none is known. On the ground, where flat vertices are left out.
  double length{kNoValue};
  /// How much longer it is with the flat vertices.
  double excess{0};
  LoopKind kind{LoopKind::Unresolved};
  /// Computed exactly.
  bool isProved{false};
  /// Its halves are shortest paths of the whole surface (loop_check.h).
  bool stands{false};
  /// To be asked, although no neighbour contradicts it.
  bool isDoubted{false};
  /// Shorter than its floor, as that of a neighbour that is proved.
  bool isLow{false};
  /// The faces that it runs through, in rising order; empty where there is no loop to spread.
  std::vector<Index> faces;
  /// Its midpoint.
  SurfacePoint middle;
  /// See `pullOf`.
  Vec3 pull{};

  bool isThere() const { return !std::isnan(length); }
  double value() const { return length + excess; }
};

/// Lengths that differ by less, as shares, are equal.
inline constexpr double kSameLength = 1e-9;

inline bool isSameLength(double a, double b) { return std::fabs(a - b) <= kSameLength * b; }

/// Whether `low` is shorter than it can be beside `high` at a base so far away, if both are the
/// girth and it does not jump between: it changes by at most twice the way.
inline bool isContradicted(double low, double high, double distance) {
  return high - low > 2 * distance * (1 + kSameLength);
}

/// The question to be answered at a base, so that its neighbours do not contradict it.
enum class Question : std::uint8_t {
  None,
  DoesItStand,  ///< a longer loop beside, or a question: are its halves shortest?
  WhatIsIt,     ///< no loop, or a shorter one beside that stands: what is the girth?
};

Question questionAt(Index base, std::span<const KnownLoop> known, const BaseGraph& graph);

/// The sum of the unit vectors in which a loop leaves its base, one for each end: by the first
/// variation of length, a loop gets shorter by the product with a small step of its base. NaN where
/// the loop has no points between.
Vec3 pullOf(const SurfaceMesh& mesh, const GirthLoop& loop);

/// Whether the loop of a neighbour is not worth looking for at a base that has a loop of its own:
/// moved there it would be longer, or the two are one loop that moves along. `step`: from the
/// neighbour to the base, in space.
bool isNoGain(const KnownLoop& own, const KnownLoop& neighbours, const Vec3& step);

}  // namespace girth
