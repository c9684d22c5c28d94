// The members of what girth/handles.h finds.
#pragma once

#include "girth/describe/description.h"
#include "girth/handles.h"

namespace girth {

/// The members of a handle.
constexpr auto describe(Members<Handle>) {
  return described<Handle>(member("length", &Handle::length), member("kind", &Handle::kind),
                           member("mayBeShorterBy", &Handle::mayBeShorterBy),
                           member("component", &Handle::component), member("area", &Handle::area),
                           member("centre", &Handle::centre), curve("points", &Handle::points));
}

/// The members of all handles.
constexpr auto describe(Members<Handles>) {
  return described<Handles>(member("unresolved", &Handles::unresolved),
                            member("handles", &Handles::handles));
}

}  // namespace girth
