// The bits of one value as another: std::bit_cast, which the oldest supported Emscripten lacks.
#pragma once

#include <cstring>

namespace girth::io {

template <class To, class From>
To bitCast(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof(To));
  return to;
}

}  // namespace girth::io
