// Any bytes as GLB.
#include "checks.h"
#include "gltf/read_gltf.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace girth;
  return fuzz::check(io::readGlb(fuzz::bytesOf(data, size), fuzz::resource, {true}));
}
