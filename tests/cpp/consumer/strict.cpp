// A program of somebody else that uses the headers, templates instantiated, for compilers that
// take every warning for an error. strict.sh puts all public headers before it.
#include <girth/girth.h>
#include <girth/io/load_mesh.h>
#include <girth/io/save_field.h>

#include <cstddef>
#include <string>
#include <vector>

namespace {

girth::VertexValues<double> heights(const girth::SurfaceMesh& mesh) {
  const girth::VertexFunction<double> function{[&mesh](const girth::ExecutionContext&) {
    return
        [&mesh](girth::Vertex vertex) -> girth::Result<double> { return mesh.position(vertex).z; };
  }};
  return girth::evaluateAll(mesh, function, {}, [](const girth::VertexPartial<double>&) {});
}

double sumOf(const girth::SurfaceMesh& mesh) {
  double sum = 0;
  const std::vector<double> values = heights(mesh).values;
  for (const girth::Vertex vertex : mesh.vertices()) sum += values[vertex];
  for (const girth::Face face : mesh.faces()) {
    const girth::Halfedge side = girth::SurfaceMesh::next(girth::SurfaceMesh::side(face, 0));
    if (mesh.twin(side) != girth::Halfedge::none) sum += mesh.length(side);
  }
  const std::vector<girth::Vertex> some{girth::Vertex{0}};
  return sum + girth::numbersOf(some)[0];
}

}  // namespace

int main() {
  girth::Result<girth::io::LoadedMesh> loaded = girth::io::loadMesh("model.obj");
  if (!loaded) return static_cast<int>(loaded.error().element);
  girth::SearchStatistics cost;
  cost += girth::girthField(loaded.value().mesh).statistics;
  const girth::io::LoadedMesh model = std::move(loaded).value();
  return sumOf(model.mesh) > 0 && cost.sources > 0 ? 0 : 1;
}
