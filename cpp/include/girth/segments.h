// Segments: the parts that a body falls into at its necks, and what each of them is.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "girth/cut_surface.h"
#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/necks.h"
#include "girth/parts.h"
#include "girth/surface_mesh.h"
#include "girth/tips.h"

namespace girth {

/// A surface that was cut at its necks.
struct CutAtNecks {
  CutSurface cut;  ///< as cutSurface gives it
  /// Numbers of the necks that were passed over, in rising order: they cross one before them.
  std::vector<Index> crossing;
};

/// Cuts along all necks. Where some cross, each is cut along that crosses none before it, in the
/// order of `necks`: the more prominent ones. Time: as cutSurface, and for each neck that crosses
/// about log2 of their number times as long. Errors: those of cutSurface, but for curves that
/// cross.
GIRTH_EXPORT Result<CutAtNecks> cutAtNecks(const SurfaceMesh& mesh, std::span<const Neck> necks,
                                           const ExecutionContext& context = {});

/// Shares of a segment's area, from 0 to 1, by kind; they add up to 1.
struct KindShares {
  double body{0};     ///< the share of the body
  double tube{0};     ///< the share of tubes
  double plate{0};    ///< the share of plates
  double unknown{0};  ///< the share without a kind
};

/// One segment of a body.
struct GIRTH_EXPORT Segment {
  double area{0};  ///< in squared model units, without caps
  /// The area of each kind, in the order of PartKind: each point of a face belongs to its
  /// three vertices by its barycentric coordinates, and so to their kinds. They add up to `area`.
  std::array<double, 4> kindAreas{};
  /// Numbers of the tips whose apexes lie on it, in rising order.
  std::vector<Index> tips;

  /// The kind that has the largest area in it; of equal ones the first.
  PartKind kind() const;
  /// Shares of its area by kind.
  KindShares shares() const;
};

/// The segments of a surface that was cut, one for each part. `parts`: those of `cut`, in
/// any order (partsOf or componentsOf). `kinds`: of the vertices of `mesh` (findParts). A tip whose
/// apex lies on a cut belongs to the first part that has it. O(n).
GIRTH_EXPORT std::vector<Segment> segmentsOf(const SurfaceMesh& mesh, const CutSurface& cut,
                                             std::span<const SurfaceComponent> parts,
                                             std::span<const PartKind> kinds,
                                             std::span<const Tip> tips);

}  // namespace girth
