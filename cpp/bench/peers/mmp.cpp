// MMP: Mitchell, Mount, Papadimitriou 1987, Kirsanov's implementation as geometry-central has it.

#include <memory>
#include <tuple>

#include "geometrycentral/surface/exact_geodesics.h"
#include "geometrycentral/surface/surface_mesh_factories.h"
#include "geometrycentral/surface/vertex_position_geometry.h"
#include "peer.h"

namespace surface = geometrycentral::surface;

namespace {

/// The objects that serve for any number of propagations.
struct Prepared {
  std::unique_ptr<surface::ManifoldSurfaceMesh> mesh;
  std::unique_ptr<surface::VertexPositionGeometry> geometry;
  std::unique_ptr<surface::GeodesicAlgorithmExact> algorithm;

  explicit Prepared(const girth::bench::PeerMesh& from) {
    std::vector<geometrycentral::Vector3> positions;
    for (const auto& [x, y, z] : from.positions) positions.push_back({x, y, z});
    std::vector<std::vector<std::size_t>> faces;
    for (const auto& face : from.faces) faces.emplace_back(face.begin(), face.end());
    std::tie(mesh, geometry) = surface::makeManifoldSurfaceMeshAndGeometry(faces, positions);
    algorithm = std::make_unique<surface::GeodesicAlgorithmExact>(*mesh, *geometry);
  }

  std::vector<double> distancesFrom(std::size_t source) const {
    algorithm->propagate(mesh->vertex(source));
    const surface::VertexData<double> field = algorithm->getDistanceFunction();
    std::vector<double> distances;
    for (const surface::Vertex vertex : mesh->vertices()) distances.push_back(field[vertex]);
    return distances;
  }
};

}  // namespace

int main(int argc, char** argv) {
  std::unique_ptr<Prepared> prepared;
  return girth::bench::runPeer(argc, argv, [&prepared](const girth::bench::PeerMesh& mesh) {
    if (!prepared) prepared = std::make_unique<Prepared>(mesh);
    return [&prepared](std::size_t source) { return prepared->distancesFrom(source); };
  });
}
