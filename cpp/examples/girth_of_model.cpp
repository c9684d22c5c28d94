// Reads a model, computes the girth at every vertex, prints the range of the values and the loop
// where the girth is least, and writes the values as CSV:
//
//   girth_of_model MODEL VALUES.csv
#include <girth/girth.h>
#include <girth/io/read_mesh.h>
#include <girth/io/write_field.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <vector>

namespace {

/// Every failure of the library is a value: a code, a message, and what to do about it.
int fail(const girth::Error& error) {
  std::fprintf(stderr, "%s: %s; %s\n", std::string(girth::toString(error.code)).c_str(),
               error.message.c_str(), error.hint.c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: girth_of_model MODEL VALUES.csv\n");
    return 1;
  }
  const std::string modelPath = argv[1], valuesPath = argv[2];

  // 1. The library reads bytes and touches no files itself: the program brings them. (A .gltf whose
  //    buffers are files beside it needs a third argument of readMesh, which brings those.)
  std::ifstream file(modelPath, std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "%s cannot be opened\n", modelPath.c_str());
    return 1;
  }
  const std::vector<char> content{std::istreambuf_iterator<char>(file), {}};
  const auto loaded = girth::io::readMesh(std::as_bytes(std::span(content)), modelPath);
  if (!loaded) return fail(loaded.error());
  const girth::SurfaceMesh& mesh = loaded.value().mesh;
  std::printf("%u vertices, %u faces\n", mesh.vertexCount(), mesh.faceCount());

  // 2. The girth at every vertex, on all threads. Lengths are in the model's unit. A value is NaN
  // only
  //    where the computation was stopped, which cannot happen here.
  const girth::GirthField field = girth::girthField(mesh);
  const auto [least, greatest] = std::minmax_element(field.values.begin(), field.values.end());
  std::printf("girth from %g to %g\n", *least, *greatest);

  // 3. The loop at the vertex of the least girth. A solver keeps its memory between calls: for many
  //    loops, keep the solver.
  const girth::Vertex narrowest(static_cast<girth::Index>(least - field.values.begin()));
  girth::GirthSolver solver(mesh);
  const auto loop = solver.loop(narrowest);
  if (!loop) return fail(loop.error());
  std::printf("the narrowest loop: length %g, %zu points\n", loop.value().length,
              girth::polyline(mesh, loop.value()).size());

  // 4. The values at the vertices of the file, in its order.
  const girth::io::VertexField values =
      girth::io::girthVertexField(field, girth::GirthMethod::Exact, loaded.value().unit);
  std::ofstream(valuesPath, std::ios::binary)
      << girth::io::fieldCsv(loaded.value(), std::span(&values, 1));
  return 0;
}
