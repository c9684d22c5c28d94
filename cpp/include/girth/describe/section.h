// The members of what girth/section.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/section.h"

namespace girth {

/// The members of a curve.
constexpr auto describe(Members<SectionCurve>) {
  return described<SectionCurve>(
      member("perimeter", &SectionCurve::perimeter), member("tape", &SectionCurve::tape),
      member("area", &SectionCurve::area),
      member("equivalentDiameter", &SectionCurve::equivalentDiameter),
      member("leastWidth", &SectionCurve::leastWidth),
      member("greatestWidth", &SectionCurve::greatestWidth),
      member("centre", &SectionCurve::centre), member("closed", &SectionCurve::closed),
      member("hole", &SectionCurve::hole), member("component", &SectionCurve::component),
      curve("points", &SectionCurve::points));
}

/// The members of a section.
constexpr auto describe(Members<Section>) {
  return described<Section>(member("normal", &Section::normal), member("offset", &Section::offset),
                            member("perimeter", &Section::perimeter),
                            member("tape", &Section::tape), member("area", &Section::area),
                            member("curves", &Section::curves));
}

/// The members of several sections.
constexpr auto describe(Members<Sections>) {
  return described<Sections>(member("sections", &Sections::sections));
}

}  // namespace girth
