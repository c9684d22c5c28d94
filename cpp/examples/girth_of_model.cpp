// Reads a model, computes the girth at every vertex, prints the range of the values and the loop
// where the girth is least, and writes the values as CSV:
//
//   girth_of_model MODEL VALUES.csv
#include <girth/girth.h>
#include <girth/io/load_mesh.h>
#include <girth/io/save_field.h>

#include <algorithm>
#include <cstdio>

namespace {

/// Every failure of the library is a value: the file, a code, a message, and what to do about it.
int fail(const girth::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: girth_of_model MODEL VALUES.csv\n");
    return 1;
  }
  // 1. The model, with the buffers beside it if it is a .gltf. (Arrays go through
  //    girth::SurfaceMesh::fromArrays, bytes that are no file through girth::io::readMesh.)
  const auto loaded = girth::io::loadMesh(argv[1]);
  if (!loaded) return fail(loaded.error());
  const girth::SurfaceMesh& mesh = loaded.value().mesh;
  std::printf("%u vertices, %u faces\n", mesh.vertexCount(), mesh.faceCount());

  // 2. The girth at every vertex, on all threads. Lengths are in the model's unit. A value is NaN
  //    only where the computation was stopped, which cannot happen here.
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

  // 4. The values at the vertices of the file, in its order; the file's ending chooses the format.
  const auto problem = girth::io::saveField(argv[2], loaded.value(), field);
  return problem ? fail(*problem) : 0;
}
