// Any bytes as OBJ.
#include "checks.h"
#include "formats/read_obj.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return girth::fuzz::check(girth::io::readObj(girth::fuzz::bytesOf(data, size), {true}));
}
