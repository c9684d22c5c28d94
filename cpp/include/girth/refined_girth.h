// The girth at every vertex of a large surface: most values from a band of faces round a loop that
// is nearly known, which is far less work than the whole disk.
//
// GIRTH_EXPERIMENTAL (girth/version.h).
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "girth/error.h"
#include "girth/execution.h"
#include "girth/export.h"
#include "girth/girth_field.h"
#include "girth/surface_mesh.h"

namespace girth {

/// How sure a value is.
enum class GirthState : std::uint8_t {
  /// Computed exactly, on the whole surface.
  Proved = 0,
  /// The shortest loop in its band, and in agreement with all neighbours: none differs by more than
  /// twice the length of the edge to it. Or one is longer by more, where the girth jumps, and this
  /// loop's halves have been found to be shortest paths of the whole surface.
  Consistent = 1,
  /// A neighbour contradicts it, or no loop was found.
  Suspect = 2,
};

/// "proved", "consistent" or "suspect".
GIRTH_EXPORT std::string_view toString(GirthState state);

/// How the girth of a large surface is computed.
struct RefinedOptions {
  /// Triangles of the coarse surface on which the girth is computed exactly first, from 4 on. Never
  /// more than a quarter of the surface's.
  Index coarseFaces{10'000};
  /// Vertices, drawn at random, that are computed exactly at the end and compared.
  Index audit{200};
  /// Which ones: the same number draws the same.
  std::uint64_t seed{1};
};

/// How values that were found in bands compare with exact ones, at vertices drawn at random.
struct GirthAudit {
  /// Vertices that were compared.
  Index vertices{0};
  /// Vertices at which the two are equal to one part in a million.
  Index equal{0};
  /// The share of equal ones among all vertices lies between this and `atMost` with a probability
  /// of 95 % (Wilson 1927).
  double atLeast{0};
  /// The upper end of that share.
  double atMost{1};
  /// The median of the differences, as shares of the exact value. Where no value was found, it is
  /// off by 1.
  double median{0};
  /// The difference that one in twenty exceeds, as a share.
  double percentile95{0};
  /// The largest difference, as a share.
  double greatest{0};
};

/// The girth of a large surface.
struct GIRTH_EXPORT RefinedGirth {
  /// In the order of the vertices. Each value is the length of a geodesic loop of the surface; NaN
  /// and `LoopKind::Unresolved` where none was found.
  GirthField field;
  /// How sure each value is.
  std::vector<GirthState> states;
  /// How they compare with exact ones. The audited vertices are proved thereby.
  GirthAudit audit;
  /// Triangles of the coarse surface.
  Index coarseFaces{0};
  /// Triangles of the surface without its flat vertices, on which loops were looked for; 0: on all
  /// triangles.
  Index leanFaces{0};

  /// How many vertices are in a state.
  Index count(GirthState state) const;
};

/// I(v) for all vertices, the way that web/docs/definitions.md describes in section 3: exact loops
/// of a coarse surface are carried to the fine one; there each vertex takes the shortest loop in a
/// band of faces round the loops of its neighbours, until nothing changes. Where neighbours
/// contradict each other, the whole surface is asked whether the halves of the shorter loop are
/// shortest paths; there and at vertices evenly spread it is searched, within bounds. Where many
/// vertices are flat, loops are looked for on the surface without them. Any number of threads gives
/// the same bits.
///
/// Time grows with the faces of bands, O(n^1.5) for the usual mesh of n faces: at 50,000 a third to
/// a sixth of the exact method's. Flat vertices cost as much as on the surface without them.
/// Memory: 4 bytes for each edge that the loop of a vertex crosses there, some 700 MB for 400,000
/// vertices.
///
/// Errors: INVALID_OPTION (`coarseFaces`), CANCELLED, OUT_OF_MEMORY.
GIRTH_EXPORT Result<RefinedGirth> refinedGirth(const SurfaceMesh& mesh,
                                               const RefinedOptions& options = {},
                                               const ExecutionContext& context = {});

}  // namespace girth
