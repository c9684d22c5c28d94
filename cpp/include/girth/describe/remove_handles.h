// The members of what girth/remove_handles.h makes.
#pragma once

#include "girth/describe/description.h"
#include "girth/remove_handles.h"

namespace girth {

/// The members of the account of a removal. The surface and the loops, which lie on surfaces that
/// are gone, are left to each output.
constexpr auto describe(Members<HandleRemoval>) {
  return described<HandleRemoval>(unwritten(&HandleRemoval::mesh),
                                  unwritten(&HandleRemoval::removed),
                                  member("genusBefore", &HandleRemoval::genusBefore),
                                  member("genusAfter", &HandleRemoval::genusAfter),
                                  member("crossingFaces", &HandleRemoval::crossingFaces),
                                  member("provenLength", &HandleRemoval::provenLength));
}

}  // namespace girth
