// The members of what girth/section.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/section.h"

namespace girth {

/// Whether the limb of a curve is known.
inline bool isOnLimb(const SectionCurve& curve) { return curve.limb != kNoIndex; }

/// The members of a curve.
constexpr auto describe(Members<SectionCurve>) {
  return described<SectionCurve>(
      member("perimeter", &SectionCurve::perimeter), member("tape", &SectionCurve::tape),
      member("area", &SectionCurve::area),
      member("equivalentDiameter", &SectionCurve::equivalentDiameter),
      member("leastWidth", &SectionCurve::leastWidth),
      member("greatestWidth", &SectionCurve::greatestWidth),
      member("centre", &SectionCurve::centre),
      member("inscribedDiameter", &SectionCurve::inscribedDiameter),
      member("inscribedCentre", &SectionCurve::inscribedCentre),
      member("closed", &SectionCurve::closed), member("hole", &SectionCurve::hole),
      member("component", &SectionCurve::component),
      memberWhere("limb", &SectionCurve::limb, isOnLimb), curve("points", &SectionCurve::points));
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

/// The members of the options of `findSections`.
constexpr auto describe(Members<SectionsOptions>) {
  return described<SectionsOptions>(needed("normal", &SectionsOptions::normal),
                                    needed("offsets", &SectionsOptions::offsets),
                                    member("inscribed", &SectionsOptions::inscribed));
}

/// The members of the options of `sectionsThrough`.
constexpr auto describe(Members<SectionsThroughOptions>) {
  return described<SectionsThroughOptions>(needed("points", &SectionsThroughOptions::points),
                                           member("normal", &SectionsThroughOptions::normal),
                                           member("across", &SectionsThroughOptions::across),
                                           member("inscribed", &SectionsThroughOptions::inscribed));
}

/// The members of the options of `extremeSection`.
constexpr auto describe(Members<ExtremeSectionOptions>) {
  return described<ExtremeSectionOptions>(needed("normal", &ExtremeSectionOptions::normal),
                                          needed("extreme", &ExtremeSectionOptions::extreme),
                                          member("low", &ExtremeSectionOptions::low),
                                          member("high", &ExtremeSectionOptions::high),
                                          member("measure", &ExtremeSectionOptions::measure),
                                          member("inscribed", &ExtremeSectionOptions::inscribed));
}

}  // namespace girth
