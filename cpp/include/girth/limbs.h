// Limbs: what the tips of a shape end, how long they are, and how thick all along.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/girth_profile.h"
#include "girth/surface_mesh.h"
#include "girth/tips.h"

namespace girth {

/// Why a limb ends where it does (web/docs/definitions.md, section 5).
enum class LimbEnd : std::uint8_t {
  /// It spreads into a thicker part: beyond, the ring grows by more than π times the distance.
  Spreads,
  /// Beyond, the loops at half of the ring's points have slipped off: they go round other parts.
  Slips,
  /// The ring falls apart into two, each round a part that is deeper than the limb is thick; or the
  /// loops slip over the place, less than half a loop beyond, where it does.
  Splits,
  /// The ring meets itself round a handle, or the loops slip over the place where it does.
  Handle,
  /// The ring reaches the boundary of the surface.
  Boundary,
  /// Never: the limb is its whole component, as of a spindle.
  Whole,
};

/// "spreads", "slips", "splits", "handle", "boundary" or "whole".
GIRTH_EXPORT std::string_view toString(LimbEnd end);

/// A finger, an arm, a leg: what lies between a tip's apex and the ring of points at `length` from
/// it.
struct Limb {
  /// Where it begins: the apex of a tip.
  Vertex apex;
  /// The tips that it ends in, by their numbers in the list that was handed over; the first is the
  /// one with this apex. Several where the distances from each of their apexes give the same limb.
  std::vector<Index> tips;
  /// Distance from the apex to the ring at its base, along the surface, in model units.
  double length{0};
  /// Why it ends there.
  LimbEnd end{LimbEnd::Spreads};
  /// The least girth of loops round the limb, from the end of its cap to the base, in model units:
  /// of the shortest neck, otherwise on the ring at one of these ends, or where loops slip off
  /// between them. The cap ends at `middle` / π from the apex, as far as the limb is thick, or
  /// where the tip's contour is, if that is farther. Exact, but not proven to be least between two
  /// stations. NaN where there is none.
  double narrowest{0};
  /// How far from the apex it is, in model units: its ring, of equal ones the nearest, or the mean
  /// distance of the neck; NaN where there is none.
  double narrowestDistance{0};
  /// The middle one of the stations' medians, of those where a loop goes round the limb, in model
  /// units: along half of the limb the girth is less.
  double median{0};
  /// The least girth on the ring at half of `length`, in model units; NaN where no loop goes round
  /// the limb there.
  double middle{0};
  /// The least girth at the base, in model units; NaN for a limb that is its whole component.
  double base{0};
  /// The vertices that the ring at the base cuts off, in rising order.
  std::vector<Vertex> vertices;
  /// Their distances from the apex, in model units.
  std::vector<double> distances;
  /// From near the apex to the base, at equal distances; the last station is the base.
  GirthProfile profile;
};

/// The limbs of a surface.
struct Limbs {
  /// Longest first.
  std::vector<Limb> limbs;
  /// Numbers of the tips that end no limb, in rising order: what they end is nowhere longer than it
  /// is thick, no loop goes round it, or it is a whole component beside a limb that has a base.
  std::vector<Index> tipsWithoutLimb;
};

/// How limbs are measured.
struct LimbOptions {
  /// Stations of a profile, 1 to 10,000.
  Index stations{64};
};

/// The limb that each tip ends (web/docs/definitions.md, section 5).
///
/// The ring at distance t from the apex is the level curve of the distance, that part of it which
/// lies before the main part of what is farther away. The limb ends at the ring where its length
/// exceeds its diameter (the ring's length by π) by most, or before, where the ring is no ring any
/// more or loops do not go round the limb.
///
/// Distances are exact at vertices (GeodesicSolver) and linear within faces, so rings are off by
/// O(h²) for edges of length h, and by O(h) where several shortest paths meet. On a ring `median`
/// and the choice of the least take values of the girth that are linear along edges, but where it
/// jumps (by more than twice the edge's length) the value of the nearer end; the least itself is
/// exact, of a loop that was traced. Where the loop at the least does not go round the limb, eight
/// others are tried, at equal shares of the ring by rising girth. Where the least exceeds the
/// median, as on triangles as large as the limb is thick, these eight are asked for the exact
/// girth, and the median is theirs. Among points with equal values the shape around them decides,
/// not their numbers: a limb has the same measures, to rounding, wherever it lies and however it is
/// numbered.
///
/// `girth`: I(v) for each vertex, NaN where there is none. `tips`: of findTips, all or some. Time:
/// for each tip one distance field, about O(n^1.5), and some loops for each station, on all
/// threads; the same result for any number of them. Errors: USAGE where the values are not as many
/// as the vertices; VERTEX_OUT_OF_RANGE; INVALID_OPTION; LIMIT_EXCEEDED; CANCELLED.
///
/// \code
/// const girth::GirthField field = girth::girthField(mesh);
/// const girth::Tips tips = girth::findTips(mesh, field.values).value();
/// for (const girth::Limb& limb : girth::findLimbs(mesh, field.values, tips.tips).value().limbs) {
///   std::cout << limb.length << ' ' << limb.narrowest << '\n';
/// }
/// \endcode
GIRTH_EXPORT Result<Limbs> findLimbs(const SurfaceMesh& mesh, std::span<const double> girth,
                                     std::span<const Tip> tips, const LimbOptions& options = {},
                                     const ExecutionContext& context = {});

}  // namespace girth
