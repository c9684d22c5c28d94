// The members of what girth/barcode.h finds.
#pragma once

#include "girth/barcode.h"
#include "girth/describe/girth_solver.h"

namespace girth {

/// The members of a saddle.
constexpr auto describe(Members<SaddleBar>) {
  return described<SaddleBar>(member("birth", &SaddleBar::birth),
                              member("death", &SaddleBar::death));
}

/// The members of a barcode.
constexpr auto describe(Members<Barcode>) {
  return described<Barcode>(member("maxPersistence", &Barcode::maxPersistence),
                            member("rest", &Barcode::rest), member("bars", &Barcode::bars),
                            member("loops", &Barcode::loops));
}

}  // namespace girth
