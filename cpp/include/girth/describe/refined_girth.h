// The members of what girth/refined_girth.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/refined_girth.h"

namespace girth {

/// The members of a comparison with exact values.
constexpr auto describe(Members<GirthAudit>) {
  return described<GirthAudit>(
      member("vertices", &GirthAudit::vertices), member("equal", &GirthAudit::equal),
      member("atLeast", &GirthAudit::atLeast), member("atMost", &GirthAudit::atMost),
      member("median", &GirthAudit::median), member("percentile95", &GirthAudit::percentile95),
      member("greatest", &GirthAudit::greatest));
}

}  // namespace girth
