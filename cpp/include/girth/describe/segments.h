// The members of what girth/segments.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/segments.h"

namespace girth {

/// The members of shares.
constexpr auto describe(Members<KindShares>) {
  return described<KindShares>(member("body", &KindShares::body), member("tube", &KindShares::tube),
                               member("plate", &KindShares::plate),
                               member("unknown", &KindShares::unknown));
}

/// The members of a segment. Its tips are left to each output, and its area, which is that of its
/// part (`PartMeasures`).
constexpr auto describe(Members<Segment>) {
  return described<Segment>(member("kind", &Segment::kind), member("shares", &Segment::shares),
                            unwritten(&Segment::area), unwritten(&Segment::kindAreas),
                            unwritten(&Segment::tips));
}

}  // namespace girth
