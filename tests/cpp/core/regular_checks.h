// Properties that must hold on regular shapes whose coordinates were rounded.
#pragma once

#include <cstdint>

#include "girth/girth_field.h"
#include "girth/surface_mesh.h"

namespace girth::test {

/// How far a run of these checks went.
struct RegularChecks {
  Index vertices{0};    ///< compared with the naive method
  Index enumerated{0};  ///< compared with an enumeration of all loops too
  Index ties{0};        ///< where rounding decides: three paths arrive together
};

/// Fails the test unless the girth of the shape of this seed is right:
///  - it equals that of the naive method at every vertex, to 1e-9;
///  - at some `enumerations` vertices, and wherever the two methods differ, no loop is shorter, and
///    a loop of this length exists, among all loops that `BruteForce` enumerates.
/// Two methods may differ where enumeration says that a third path arrives at the midpoint within
/// 1e-9 of the two: whether that is a loop is decided by rounding. Such vertices are counted.
RegularChecks expectExactOnRegularShape(std::uint64_t seed, Index enumerations);

/// Fails the test unless what stands on the search for loops holds on the shape of this seed, at
/// some `vertices` of it, spread over it:
///  - the loop is as long as the field says, straight, and through its midpoint;
///  - of a whole barcode as many bars never end as the surface has independent cycles that bound
///    nothing (its first Betti number), and each persistent girth is what the barcode says;
///  - refined values equal the exact ones;
///  - every loop is drawn tight: no neck and no handle is unresolved.
void expectTheRestOnRegularShape(std::uint64_t seed, Index vertices);

}  // namespace girth::test
