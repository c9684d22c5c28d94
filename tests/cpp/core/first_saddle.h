// The first saddle of a distance field, by topology alone: no loop is looked for, no angle
// measured.
//
// I(p) is twice the least critical value of the distance from p at a saddle point, where the
// growing disk first meets itself (web/docs/definitions.md, section 2). There its topology changes:
// a cycle is born in the sublevel set. So the field is sampled exactly at the points of a
// subdivided surface, and the persistent homology of its sublevel sets says when cycles are born
// and when they are filled.
#pragma once

#include <optional>
#include <vector>

#include "girth/surface_mesh.h"
#include "textbook_mmp.h"

namespace girth::test {

/// A cycle of the sublevel sets: when it is born, and when it is filled; infinite: never.
struct Cycle {
  double born, filled;
};

/// All cycles that are born below `limit` in a field that has been propagated at least to `limit +
/// spacing`, as far as samples at the corners of triangles with sides up to `spacing` show them:
/// the same as those of the field, give or take `error` at both ends, but for cycles that last no
/// longer than twice that. See FirstSaddle.
struct SampledCycles {
  std::vector<Cycle> cycles;
  double error{0}, farthest{0};
  std::size_t triangles{0};
};
SampledCycles sampledCycles(const SurfaceMesh& mesh, const TextbookMmp& field, double limit,
                            double spacing);

struct FirstSaddle {
  /// The distance at which the first lasting cycle is born, off by no more than `error`; nothing
  /// if none is born below the limit.
  std::optional<double> value;
  /// How far the interpolated field may be from the true one: a distance changes by no more than
  /// the way walked, so its interpolation in a triangle with sides up to s is off by s/√3 at most.
  /// Only cycles that last for more than twice this are distinguished from those that interpolation
  /// makes (stability of persistence, Cohen-Steiner et al. 2007); those are what `value` leaves
  /// out.
  double error{0};
  /// The greatest distance met at any sample below the limit.
  double farthest{0};
  /// Triangles of the subdivided surface.
  std::size_t triangles{0};
};

/// The first saddle below `limit` of a field that has been propagated at least to `limit +
/// spacing`. Sides longer than `spacing` are subdivided wherever the field may be below the limit.
/// A cycle that is still there at the limit counts as lasting until then.
FirstSaddle firstSaddle(const SurfaceMesh& mesh, const TextbookMmp& field, double limit,
                        double spacing);

}  // namespace girth::test
