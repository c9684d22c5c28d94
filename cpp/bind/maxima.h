// Maxima of fields as JavaScript receives them.
#pragma once

#include <emscripten/val.h>

#include <vector>

#include "girth/describe/persistent_maxima.h"
#include "result_object.h"

namespace girth::bind {

/// {maxima}, each a `Maximum` of types.ts.
inline emscripten::val maximaOf(const std::vector<PersistentMaximum>& maxima) {
  ResultObject result;
  result("maxima", maxima);
  return result.object();
}

}  // namespace girth::bind
