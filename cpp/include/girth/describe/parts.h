// The members of what girth/parts.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/parts.h"

namespace girth {

/// The members of thresholds.
constexpr auto describe(Members<PartThresholds>) {
  return described<PartThresholds>(member("girth", &PartThresholds::girth),
                                   member("shapeDiameter", &PartThresholds::shapeDiameter));
}

/// The members of a part.
constexpr auto describe(Members<Part>) {
  return described<Part>(member("kind", &Part::kind), member("area", &Part::area),
                         member("medianGirth", &Part::medianGirth),
                         member("medianShapeDiameter", &Part::medianShapeDiameter),
                         member("equivalentRadius", &Part::equivalentRadius),
                         member("thinnest", &Part::thinnest), member("vertices", &Part::vertices));
}

}  // namespace girth
