// The members of what girth/tighten.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/tighten.h"

namespace girth {

/// The members of options.
constexpr auto describe(Members<TightenOptions>) {
  return described<TightenOptions>(needed("points", &TightenOptions::points),
                                   member("closed", &TightenOptions::closed),
                                   member("fixed", &TightenOptions::fixed));
}

/// The members of a piece.
constexpr auto describe(Members<TightPiece>) {
  return described<TightPiece>(
      member("lengthBefore", &TightPiece::lengthBefore), member("length", &TightPiece::length),
      member("promise", &TightPiece::promise), member("start", &TightPiece::start),
      member("end", &TightPiece::end));
}

/// The members of a tight curve.
constexpr auto describe(Members<TightCurve>) {
  return described<TightCurve>(
      member("kind", &TightCurve::kind), member("promise", &TightCurve::promise),
      member("component", &TightCurve::component),
      member("lengthBefore", &TightCurve::lengthBefore), member("length", &TightCurve::length),
      member("pieces", &TightCurve::pieces), curve("points", &TightCurve::points));
}

}  // namespace girth
