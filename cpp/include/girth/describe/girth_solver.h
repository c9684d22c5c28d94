// The members of what girth/girth_solver.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/girth_solver.h"

namespace girth {

/// The members of the girth at a point. Outputs say by its kind that a length is a lower bound.
constexpr auto describe(Members<GirthValue>) {
  return described<GirthValue>(member("length", &GirthValue::length),
                               member("kind", &GirthValue::kind), unwritten(&GirthValue::atMost));
}

/// The members of a loop.
constexpr auto describe(Members<GirthLoop>) {
  return described<GirthLoop>(
      member("base", &GirthLoop::base), member("length", &GirthLoop::length),
      member("kind", &GirthLoop::kind), member("angle", &GirthLoop::angle),
      unwritten(&GirthLoop::atMost), drawnPoint("midpoint", &GirthLoop::midpoint),
      curve("points", &GirthLoop::points));
}

}  // namespace girth
