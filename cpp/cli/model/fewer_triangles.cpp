#include "model/fewer_triangles.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "girth/transfer.h"
#include "model/computing.h"
#include "process/report.h"

namespace girth::cli {

Result<io::LoadedMesh> inFewerTriangles(const std::string& model, io::LoadedMesh loaded,
                                        std::uint32_t faces) {
  auto remeshed = remeshModel(model, loaded.mesh, {faces});
  if (!remeshed) return remeshed.error();
  if (!remeshed.value()) return loaded;
  auto& [few, onOriginal] = *remeshed.value();
  const std::vector<Vertex> standIn = nearestVertices(few, nearestPoints(few, loaded.mesh));
  for (Vertex& vertex : loaded.vertexOfInput) {
    if (vertex != Vertex::none) vertex = standIn[vertex];
  }
  const std::vector<Vertex> nearest = nearestVertices(loaded.mesh, onOriginal);
  std::vector<Index> inputOfVertex(few.vertexCount());
  std::transform(nearest.begin(), nearest.end(), inputOfVertex.begin(),
                 [&](Vertex vertex) { return loaded.inputOfVertex[vertex]; });
  loaded.inputOfVertex = std::move(inputOfVertex);
  loaded.inputOfFace.assign(few.faceCount(), kNoIndex);
  printNote(model, "measured on " + std::to_string(few.faceCount()) + " triangles in place of " +
                       std::to_string(loaded.mesh.faceCount()) +
                       "; vertices have the numbers of the nearest in the file");
  loaded.fewerFaces = few.faceCount();
  loaded.mesh = std::move(few);
  return loaded;
}

Error otherFaces(const std::string& hint) {
  return usageError("with --faces the surface has other faces than the file", hint);
}

}  // namespace girth::cli
