// The comparison of refined values with exact ones.
#pragma once

#include <span>

#include "girth/refined_girth.h"

namespace girth {

/// The comparison of values with exact ones, as many, drawn at random. NaN: no value was found.
GirthAudit auditOf(std::span<const double> found, std::span<const double> exact);

}  // namespace girth
