// Any bytes as STL.
#include "checks.h"
#include "formats/read_stl.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return girth::fuzz::check(girth::io::readStl(girth::fuzz::bytesOf(data, size)));
}
