// The members of what girth/persistent_maxima.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/persistent_maxima.h"

namespace girth {

/// The members of a maximum.
constexpr auto describe(Members<PersistentMaximum>) {
  return described<PersistentMaximum>(member("vertex", &PersistentMaximum::vertex),
                                      member("value", &PersistentMaximum::value),
                                      member("persistence", &PersistentMaximum::persistence),
                                      member("saddle", &PersistentMaximum::saddle));
}

}  // namespace girth
