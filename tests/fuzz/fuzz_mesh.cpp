// Any bytes, recognised, read and prepared as a surface. The first byte chooses the name's ending
// and what is asked of the preparation.
#include <array>

#include "checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace girth;
  if (size == 0) return 0;
  constexpr std::array<const char*, 8> kNames{"a",     "a.obj", "a.ply",  "a.stl",
                                              "a.off", "a.glb", "a.gltf", "a.zip"};
  PrepareOptions options;
  options.closeHoles = (data[0] & 8) != 0;
  options.weldDistance = (data[0] & 16) != 0 ? 0.125 : 0;
  if ((data[0] & 32) != 0) options.components = {0};
  return fuzz::check(io::readMesh(fuzz::bytesOf(data + 1, size - 1), kNames[data[0] & 7],
                                  fuzz::resource, options));
}
