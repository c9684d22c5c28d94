// Any bytes as PLY.
#include "checks.h"
#include "formats/read_ply.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return girth::fuzz::check(girth::io::readPly(girth::fuzz::bytesOf(data, size), {true}));
}
