// Asking for memory before it is needed.
#pragma once

#include <cstddef>

namespace girth::geodesic {

/// Asks for the cache lines in which `count` objects lie, but for an end that may reach into one
/// more. Does nothing where the target has no such instruction (WebAssembly).
template <class T>
inline void prefetch([[maybe_unused]] const T* objects, [[maybe_unused]] std::size_t count = 1) {
#ifndef __EMSCRIPTEN__
  constexpr std::size_t kLine = 64;
  const char* from = reinterpret_cast<const char*>(objects);
  for (std::size_t byte = 0; byte < count * sizeof(T); byte += kLine) {
    __builtin_prefetch(from + byte);
  }
#endif
}

}  // namespace girth::geodesic
