#include "girth/barcode.h"

#include <algorithm>
#include <cmath>

namespace girth {

GirthValue Barcode::girth(double persistence) const {
  for (const SaddleBar& bar : bars) {
    if (bar.persistence() > persistence) {
      // Beyond what was computed, a bar without an end may or may not last.
      const bool isKnown = persistence <= maxPersistence || std::isfinite(bar.death);
      return {2 * bar.birth, isKnown ? LoopKind::Loop : LoopKind::Unresolved};
    }
  }
  return rest;
}

std::optional<Error> checkPersistence(double persistence) {
  if (persistence >= 0 && std::isfinite(persistence)) return std::nullopt;
  return makeError(ErrorCode::InvalidOption, -1,
                   "a persistence is a length of at least 0, in model units");
}

}  // namespace girth
