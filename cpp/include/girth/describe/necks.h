// The members of what girth/necks.h finds.
#pragma once

#include "girth/describe/cut_surface.h"
#include "girth/necks.h"

namespace girth {

/// The members of a neck.
constexpr auto describe(Members<Neck>) {
  return described<Neck>(member("length", &Neck::length), member("prominence", &Neck::prominence),
                         member("width", &Neck::width), member("area", &Neck::area),
                         member("radius", &Neck::radius), member("centre", &Neck::centre),
                         member("normal", &Neck::normal), member("sides", &Neck::sides),
                         member("measuresGirth", &Neck::measuresGirth),
                         member("touchesBoundary", &Neck::touchesBoundary),
                         member("vertices", &Neck::vertices), curve("points", &Neck::points));
}

/// The members of all necks.
constexpr auto describe(Members<Necks>) {
  return described<Necks>(member("unresolved", &Necks::unresolved),
                          member("suggestedProminence", &Necks::suggestedProminence),
                          member("necks", &Necks::necks));
}

}  // namespace girth
