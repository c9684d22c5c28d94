// VTP: Qin, Han, Yu, Yu, Zhang, 'Fast and exact discrete geodesic computation based on
// triangle-oriented wavefront propagation', ACM TOG 35(4), 2016, in the authors' own program.

#include "stdafx.h"
// The peer's headers need the one above, and this one.
#include <cstring>
#include <memory>

#include "geodesic_algorithm_exact.h"
#include "geodesic_mesh.h"
#include "peer.h"

int main(int argc, char** argv) {
  // A mesh serves for one propagation: what it has found stays in its vertices.
  return girth::bench::runPeer(argc, argv, [](const girth::bench::PeerMesh& from) {
    std::vector<double> points;
    for (const auto& position : from.positions) {
      points.insert(points.end(), position.begin(), position.end());
    }
    std::vector<unsigned> faces;
    for (const auto& face : from.faces) faces.insert(faces.end(), face.begin(), face.end());
    auto mesh = std::make_shared<geodesic::Mesh>();
    mesh->initialize_mesh_data(points, faces);
    auto algorithm = std::make_shared<geodesic::GeodesicAlgorithmExact>(mesh.get());
    return [mesh, algorithm](std::size_t source) {
      algorithm->propagate(static_cast<unsigned>(source));
      std::vector<double> distances;
      for (auto& vertex : mesh->vertices()) distances.push_back(vertex.geodesic_distance());
      return distances;
    };
  });
}
