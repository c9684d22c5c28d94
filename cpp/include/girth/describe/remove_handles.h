// The members of what girth/remove_handles.h makes.
#pragma once

#include "girth/describe/description.h"
#include "girth/remove_handles.h"

namespace girth {

/// The members of a removed handle.
constexpr auto describe(Members<RemovedHandle>) {
  return described<RemovedHandle>(
      member("kind", &RemovedHandle::kind), member("length", &RemovedHandle::length),
      member("centre", &RemovedHandle::centre), member("droppedArea", &RemovedHandle::droppedArea));
}

/// The members of the account of a removal. The surface is left to each output. The loops have
/// none, as they lie on surfaces that are gone.
constexpr auto describe(Members<HandleRemoval>) {
  return described<HandleRemoval>(
      unwritten(&HandleRemoval::mesh), unwritten(&HandleRemoval::removed),
      unwritten(&HandleRemoval::droppedAreas), member("genusBefore", &HandleRemoval::genusBefore),
      member("genusAfter", &HandleRemoval::genusAfter),
      member("crossingFaces", &HandleRemoval::crossingFaces),
      member("provenLength", &HandleRemoval::provenLength),
      member("removed", &HandleRemoval::account));
}

}  // namespace girth
