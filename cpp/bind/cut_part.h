// A part of a surface that was cut, on its way to JavaScript.
#pragma once

#include <emscripten/val.h>

#include <vector>

#include "boundary.h"
#include "girth/describe/cut_surface.h"
#include "girth/io/write_cut.h"
#include "result_object.h"

namespace girth::bind {

/// `CutPart` of types.ts.
inline ResultObject cutPartOf(const io::CutModel& whole, const SurfaceComponent& part) {
  const SurfaceMesh& mesh = part.mesh;
  std::vector<double> positions;
  std::vector<Index> vertices;
  positions.reserve(3 * std::size_t{mesh.vertexCount()});
  for (const Vertex v : mesh.vertices()) {
    const Vec3& at = mesh.position(v);
    positions.insert(positions.end(), {at.x, at.y, at.z});
    const Index inWhole = part.vertices[v];
    vertices.push_back(inWhole < whole.points.size() ? Index{whole.points[inWhole].vertex()}
                                                     : kNoIndex);
  }
  std::vector<Index> corners, faces;
  corners.reserve(3 * std::size_t{mesh.faceCount()});
  for (const Face f : mesh.faces()) {
    for (const Vertex v : mesh.faceVertices(f)) corners.push_back(v);
    faces.push_back(whole.faces[part.faces[f]]);
  }
  ResultObject result;
  result.addMembers(partMeasures(mesh));
  result("positions", copyOut<double>("Float64Array", positions));
  result("indices", copyOut<Index>("Uint32Array", corners));
  result("vertices", copyOut<Index>("Uint32Array", vertices));
  result("faces", copyOut<Index>("Uint32Array", faces));
  result("boundaryCount", mesh.boundaryCount(0));
  return result;
}

}  // namespace girth::bind
