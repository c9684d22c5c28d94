// The members of what girth/tubes.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/tubes.h"

namespace girth {

/// Whether a branch leaves another one.
inline bool leavesBranch(const TubeBranch& branch) { return branch.parent != kNoIndex; }

/// Whether a branch leads to an end.
inline bool leadsToEnd(const TubeBranch& branch) { return branch.ends; }

/// The members of a station.
constexpr auto describe(Members<TubeStation>) {
  return described<TubeStation>(
      member("branch", &TubeStation::branch), member("distance", &TubeStation::distance),
      member("equivalentDiameter", &TubeStation::equivalentDiameter),
      member("area", &TubeStation::area), member("perimeter", &TubeStation::perimeter),
      member("inscribedDiameter", &TubeStation::inscribedDiameter),
      member("leastWidth", &TubeStation::leastWidth),
      member("greatestWidth", &TubeStation::greatestWidth), member("girth", &TubeStation::girth),
      member("curvature", &TubeStation::curvature), member("torsion", &TubeStation::torsion),
      member("centre", &TubeStation::centre), member("direction", &TubeStation::direction),
      member("place", &TubeStation::place), curve("points", &TubeStation::points));
}

/// The members of a narrowing or widening.
constexpr auto describe(Members<TubePlace>) {
  return described<TubePlace>(
      member("change", &TubePlace::change), member("branch", &TubePlace::branch),
      member("distance", &TubePlace::distance),
      member("beforeDistance", &TubePlace::beforeDistance),
      member("beyondDistance", &TubePlace::beyondDistance), member("length", &TubePlace::length),
      member("equivalentDiameter", &TubePlace::equivalentDiameter),
      member("reference", &TubePlace::reference),
      member("degreeByDiameter", &TubePlace::degreeByDiameter),
      member("degreeByArea", &TubePlace::degreeByArea),
      member("beforeDiameter", &TubePlace::beforeDiameter),
      member("beyondDiameter", &TubePlace::beyondDiameter), member("area", &TubePlace::area),
      member("perimeter", &TubePlace::perimeter),
      member("inscribedDiameter", &TubePlace::inscribedDiameter),
      member("leastWidth", &TubePlace::leastWidth), member("girth", &TubePlace::girth),
      member("centre", &TubePlace::centre), curve("points", &TubePlace::points));
}

/// The members of a branch.
constexpr auto describe(Members<TubeBranch>) {
  return described<TubeBranch>(
      member("component", &TubeBranch::component),
      memberWhere("parent", &TubeBranch::parent, leavesBranch), member("ends", &TubeBranch::ends),
      member("open", &TubeBranch::open), memberWhere("end", &TubeBranch::end, leadsToEnd),
      member("firstDistance", &TubeBranch::firstDistance),
      member("lastDistance", &TubeBranch::lastDistance), member("median", &TubeBranch::median),
      member("firstStation", &TubeBranch::firstStation),
      member("endStation", &TubeBranch::endStation));
}

/// The members of a component that is no tube.
constexpr auto describe(Members<NoTubeComponent>) {
  return described<NoTubeComponent>(member("component", &NoTubeComponent::component),
                                    member("reason", &NoTubeComponent::reason));
}

/// The members of tubes.
constexpr auto describe(Members<Tubes>) {
  return described<Tubes>(member("branches", &Tubes::branches), member("others", &Tubes::others),
                          member("places", &Tubes::places), member("stations", &Tubes::stations));
}

/// The members of the options of `findTubes`.
constexpr auto describe(Members<TubesOptions>) {
  return described<TubesOptions>(
      member("ends", &TubesOptions::ends), member("spacing", &TubesOptions::spacing),
      member("leastDegree", &TubesOptions::leastDegree),
      member("reference", &TubesOptions::reference), member("girth", &TubesOptions::girth));
}

}  // namespace girth
