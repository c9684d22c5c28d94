// The members of what girth/bottleneck.h finds.
#pragma once

#include "girth/bottleneck.h"
#include "girth/describe/cut_surface.h"

namespace girth {

/// The members of a bottleneck.
constexpr auto describe(Members<Bottleneck>) {
  return described<Bottleneck>(
      member("kind", &Bottleneck::kind), member("girth", &Bottleneck::girth),
      member("place", &Bottleneck::place), member("centre", &Bottleneck::centre),
      member("area", &Bottleneck::area), member("sides", &Bottleneck::sides),
      curve("points", &Bottleneck::points), member("way", &Bottleneck::way));
}

}  // namespace girth
