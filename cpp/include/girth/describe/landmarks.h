// The members of what girth/landmarks.h measures.
#pragma once

#include "girth/describe/description.h"
#include "girth/landmarks.h"

namespace girth {

/// The members of a landmark.
constexpr auto describe(Members<Landmark>) {
  return described<Landmark>(needed("name", &Landmark::name), needed("point", &Landmark::point),
                             needed("how", &Landmark::how), member("to", &Landmark::to),
                             member("across", &Landmark::across), member("all", &Landmark::all));
}

/// The members of the options of `measureLandmarks`.
constexpr auto describe(Members<LandmarksOptions>) {
  return described<LandmarksOptions>(needed("landmarks", &LandmarksOptions::landmarks),
                                     member("normal", &LandmarksOptions::normal));
}

/// The members of a measure.
constexpr auto describe(Members<NamedMeasure>) {
  return described<NamedMeasure>(
      member("name", &NamedMeasure::name), member("how", &NamedMeasure::how),
      member("point", &NamedMeasure::point), member("length", &NamedMeasure::length),
      curve("points", &NamedMeasure::points));
}

/// The members of several measures.
constexpr auto describe(Members<NamedMeasures>) {
  return described<NamedMeasures>(member("measures", &NamedMeasures::measures));
}

}  // namespace girth
