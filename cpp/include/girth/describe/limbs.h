// The members of what girth/limbs.h finds.
#pragma once

#include "girth/describe/girth_profile.h"
#include "girth/limbs.h"

namespace girth {

/// The members of a limb.
constexpr auto describe(Members<Limb>) {
  return described<Limb>(
      member("length", &Limb::length), member("narrowest", &Limb::narrowest),
      member("narrowestDistance", &Limb::narrowestDistance), member("median", &Limb::median),
      member("middle", &Limb::middle), member("base", &Limb::base), member("end", &Limb::end),
      numbers("tips", &Limb::tips), member("apex", &Limb::apex),
      member("vertices", &Limb::vertices),
      numbersAt("distances", &Limb::distances, &Limb::vertices), member("profile", &Limb::profile));
}

/// The members of all limbs.
constexpr auto describe(Members<Limbs>) {
  return described<Limbs>(member("limbs", &Limbs::limbs),
                          numbers("tipsWithoutLimb", &Limbs::tipsWithoutLimb));
}

}  // namespace girth
