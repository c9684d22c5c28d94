// Reads a small model and asks for one girth, with nothing but the installed package.

#include <girth/girth.h>
#include <girth/io/read_mesh.h>
#include <girth/study/naive_girth.h>
#include <girth/version.h>

#include <cmath>
#include <cstdio>
#include <span>
#include <string_view>

namespace {

// A regular octahedron with edges of length √2.
constexpr std::string_view kOctahedron =
    "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"
    "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";

}  // namespace

int main() {
  if (girth::version() != GIRTH_VERSION) return 1;
  const auto loaded = girth::io::readMesh(std::as_bytes(std::span(kOctahedron)), "octahedron.obj");
  if (!loaded) {
    std::fprintf(stderr, "%s\n", loaded.error().message.c_str());
    return 1;
  }
  const auto loop = girth::girthLoop(loaded.value().mesh, girth::Vertex(0));
  if (!loop) {
    std::fprintf(stderr, "%s\n", loop.error().message.c_str());
    return 1;
  }
  const auto naive = girth::study::naiveGirth(loaded.value().mesh, girth::Vertex(0));
  if (!naive) return 1;
  std::printf("girth at vertex 0: %.17g\n", loop.value().length);
  const bool agrees = std::fabs(naive.value().length - loop.value().length) < 1e-9;
  return std::isfinite(loop.value().length) && loop.value().length > 0 && agrees ? 0 : 1;
}
