// The shape diameter function against CGAL's, at the same cone and the same number of rays, on one
// thread, one after the other on the same surface. Without CGAL (Debian: libcgal-dev) only ours.
//
//   shape_diameter [MODEL...]   default: a bumpy torus of 10,000 faces
//
// Prints for each surface the processor time of both (the fastest of three alternating runs), the
// ratio, and how far apart the values are: the median of |ours / theirs − 1|. The two differ by
// design: CGAL's rays fill the cone's disk evenly, ours are in equal steps of angle
// (shape_diameter.h). CGAL's own smoothing and normalisation are switched off.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "girth/shape_diameter.h"
#include "support/measure.h"
#include "support/models.h"
#include "support/program.h"

#ifdef GIRTH_WITH_CGAL
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>
#endif

namespace {

using girth::Index;
using girth::SurfaceMesh;

constexpr unsigned kRays = 30;
constexpr int kTurns = 3;

#ifdef GIRTH_WITH_CGAL

struct Theirs {
  double seconds;
  std::vector<double> ofFaces;
};

/// CGAL computes one value for each face, from its middle.
Theirs byCgal(const SurfaceMesh& mesh, double cone) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  Surface surface;
  std::vector<Surface::Vertex_index> vertices;
  for (const girth::Vertex v : mesh.vertices()) {
    const girth::Vec3& p = mesh.position(v);
    vertices.push_back(surface.add_vertex({p.x, p.y, p.z}));
  }
  for (const girth::Face f : mesh.faces()) {
    const auto [a, b, c] = mesh.faceVertices(f);
    surface.add_face(vertices[a], vertices[b], vertices[c]);
  }
  auto values = surface.add_property_map<Surface::Face_index, double>("f:sdf", 0).first;
  Theirs theirs{};
  theirs.seconds = girth::bench::processorSecondsOf(
      [&] { CGAL::sdf_values(surface, values, cone, kRays, false); });
  for (const auto face : surface.faces()) theirs.ofFaces.push_back(values[face]);
  return theirs;
}

/// The mean over a face's vertices, to compare with a value at its middle.
double ofFace(const SurfaceMesh& mesh, Index face, const std::vector<double>& values) {
  const auto [a, b, c] = mesh.faceVertices(girth::Face(face));
  return (values[a] + values[b] + values[c]) / 3;
}

#endif

void compare(const std::string& name, const SurfaceMesh& mesh) {
  const girth::ShapeDiameterOptions options{2 * std::numbers::pi / 3, kRays};
  girth::ExecutionContext context;
  context.threads = 1;
  girth::ShapeDiameterField field;
  double ours = std::numeric_limits<double>::infinity();
#ifdef GIRTH_WITH_CGAL
  Theirs theirs{ours, {}};
#endif
  for (int turn = 0; turn < kTurns; ++turn) {
    ours = std::min(ours, girth::bench::processorSecondsOf([&] {
                      field = girth::shapeDiameter(mesh, options, context).value();
                    }));
#ifdef GIRTH_WITH_CGAL
    Theirs now = byCgal(mesh, options.coneRadians);
    if (now.seconds < theirs.seconds) theirs = std::move(now);
#endif
  }
  const double rays = static_cast<double>(kRays) * mesh.vertexCount();
  std::printf("%s, %u faces: %.3f s, %.2f us a ray", name.c_str(), mesh.faceCount(), ours,
              1e6 * ours / rays);
#ifdef GIRTH_WITH_CGAL
  const double theirRays = static_cast<double>(kRays) * mesh.faceCount();
  std::vector<double> off;
  for (const girth::Face f : mesh.faces()) {
    off.push_back(std::fabs(ofFace(mesh, f, field.values) / theirs.ofFaces[f] - 1));
  }
  const double perRay = (theirs.seconds / theirRays) / (ours / rays);
  std::printf("; CGAL %.3f s, %.2f us a ray; ratio %.1f for the field, %.1f a ray; apart %.1f %%",
              theirs.seconds, 1e6 * theirs.seconds / theirRays, theirs.seconds / ours, perRay,
              100 * girth::bench::quantile(off, 0.5));
#endif
  std::printf("\n");
  std::fflush(stdout);
}

int run(int argc, char** argv) {
#ifndef GIRTH_WITH_CGAL
  std::printf("CGAL is not installed (Debian: libcgal-dev): only our own times\n");
#endif
  for (int i = 1; i < argc; ++i) compare(argv[i], girth::bench::loadModel(argv[i]).mesh);
  if (argc == 1) {
    const girth::bench::Model torus = girth::bench::bumpyTorus(10'000);
    compare(torus.name, torus.mesh);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return girth::bench::runProgram(run, argc, argv); }
