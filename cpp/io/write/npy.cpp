#include "write/npy.h"

#include <cstddef>

namespace girth::io {

std::string npyHeader(std::string_view shape) {
  std::string header =
      "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::string(shape) + "), }";
  // The values begin at a multiple of 64 bytes.
  constexpr std::size_t kPreamble = 10;
  while ((kPreamble + header.size() + 1) % 64 != 0) header += ' ';
  header += '\n';
  std::string content("\x93NUMPY\x01\x00", 8);
  content += static_cast<char>(header.size() & 0xFF);
  content += static_cast<char>(header.size() >> 8);
  return content + header;
}

}  // namespace girth::io
