// Any bytes as OFF.
#include "checks.h"
#include "formats/read_off.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return girth::fuzz::check(girth::io::readOff(girth::fuzz::bytesOf(data, size)));
}
