// The members of what girth/print_check.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/print_check.h"

namespace girth {

/// The members of limits.
constexpr auto describe(Members<PrintLimits>) {
  return described<PrintLimits>(member("tubeDiameter", &PrintLimits::tubeDiameter),
                                member("wallThickness", &PrintLimits::wallThickness),
                                member("gap", &PrintLimits::gap));
}

/// Whether a weak place has a point across from it.
inline bool hasOpposite(const WeakPlace& place) { return place.kind != WeakKind::Tube; }

/// The members of a weak place.
constexpr auto describe(Members<WeakPlace>) {
  return described<WeakPlace>(
      member("kind", &WeakPlace::kind), member("measure", &WeakPlace::measure),
      member("least", &WeakPlace::least), member("area", &WeakPlace::area),
      member("thinnest", &WeakPlace::thinnest),
      memberWhere("opposite", &WeakPlace::opposite, hasOpposite),
      member("vertices", &WeakPlace::vertices), member("faces", &WeakPlace::faces));
}

/// The members of a crease.
constexpr auto describe(Members<Crease>) {
  return described<Crease>(member("kind", &Crease::kind), member("length", &Crease::length),
                           member("area", &Crease::area), member("least", &Crease::least),
                           member("thinnest", &Crease::thinnest),
                           member("opposite", &Crease::opposite),
                           member("vertices", &Crease::vertices), member("faces", &Crease::faces));
}

/// The members of a check.
constexpr auto describe(Members<PrintCheck>) {
  return described<PrintCheck>(
      member("passes", &PrintCheck::passes), member("failingShare", &PrintCheck::failingShare),
      member("passingScale", &PrintCheck::passingScale), member("places", &PrintCheck::places),
      member("creases", &PrintCheck::creases), unwritten(&PrintCheck::complete));
}

}  // namespace girth
