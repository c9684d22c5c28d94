// Maxima of fields as JavaScript receives them.
#pragma once

#include <emscripten/val.h>

#include <span>

#include "boundary.h"
#include "girth/persistent_maxima.h"

namespace girth::bind {

/// {maxima}, each a `Maximum` of types.ts.
inline emscripten::val describe(std::span<const PersistentMaximum> maxima) {
  emscripten::val list = emscripten::val::array();
  for (const PersistentMaximum& maximum : maxima) {
    emscripten::val entry = emscripten::val::object();
    entry.set("vertex", Index{maximum.vertex});
    entry.set("value", maximum.value);
    entry.set("persistence", maximum.persistence);
    entry.set("saddle", maximum.saddle == kNoIndex ? -1 : static_cast<double>(maximum.saddle));
    list.call<void>("push", entry);
  }
  emscripten::val result = emscripten::val::object();
  result.set("maxima", list);
  return result;
}

}  // namespace girth::bind
