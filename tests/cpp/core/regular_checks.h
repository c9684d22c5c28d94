// What must hold on regular shapes whose coordinates were rounded.
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
/// 1e-9 of the two: whether that is a loop is decided by rounding. Those are counted.
RegularChecks expectExactOnRegularShape(std::uint64_t seed, Index enumerations);

}  // namespace girth::test
