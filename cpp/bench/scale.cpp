// The girth at all vertices against the number of triangles: computed exactly, refined, and carried
// back from 10,000 triangles. One JSON object a line; `npm run bench:paper` makes a table and a
// plot of them.
//
//   scale [--threads N] [--faces N] [--divided N] [--exact-seconds S] [--refined-faces N] MODEL...
//
// --faces: the model is remeshed to about so many triangles first.
// --divided: after that each triangle is cut into four equal ones, so many times.
// --threads: default: all. --exact-seconds: where the exact method takes longer, it computes a
// sample spread over the numbers of the vertices in about that time, and "vertices" says how many:
// "seconds" are then extrapolated. Default: 60. --refined-faces: models of more triangles are not
// refined. Default: no limit.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "girth/girth.h"
#include "support/measure.h"
#include "support/models.h"

namespace {

using girth::Index;
using girth::SurfaceMesh;
using girth::Vertex;

/// Triangles that values are carried back from; smaller models are not refined either.
constexpr Index kCoarseFaces = 10'000;

SurfaceMesh remeshed(const SurfaceMesh& mesh, Index faces, const girth::ExecutionContext& context) {
  girth::RemeshOptions options;
  options.faces = faces;
  auto result = girth::remesh(mesh, options, context);
  if (!result) std::exit(1);
  return std::move(result).value().mesh;
}

/// A surface with each triangle cut into four by the middles of its sides.
SurfaceMesh divided(const SurfaceMesh& mesh) {
  girth::TriangleSoup soup;
  const auto add = [&](const girth::Vec3& p) {
    soup.positions.insert(soup.positions.end(), {p.x, p.y, p.z});
    return static_cast<Index>(soup.positions.size() / 3 - 1);
  };
  for (const Vertex v : mesh.vertices()) add(mesh.position(v));
  std::vector<Index> middle(mesh.halfedgeCount(), girth::kNoIndex);
  for (const girth::Halfedge h : mesh.halfedges()) {
    if (middle[h] != girth::kNoIndex) continue;
    middle[h] = add(positionOf(mesh, girth::SurfacePoint::onHalfedge(h, 0.5)));
    if (mesh.twin(h) != girth::Halfedge::none) middle[mesh.twin(h)] = middle[h];
  }
  for (const girth::Face face : mesh.faces()) {
    std::array<Index, 3> corner{}, side{};
    for (Index k = 0; k < 3; ++k) {
      const girth::Halfedge h(3 * face + k);
      corner[k] = mesh.from(h);
      side[k] = middle[h];
    }
    for (Index k = 0; k < 3; ++k) {
      soup.triangles.insert(soup.triangles.end(), {corner[k], side[k], side[(k + 2) % 3]});
    }
    soup.triangles.insert(soup.triangles.end(), side.begin(), side.end());
  }
  auto prepared = girth::prepareSurface(std::move(soup));
  if (!prepared) std::exit(1);
  return std::move(prepared).value().mesh;
}

/// Seconds for some vertices, divided between threads.
double exactSeconds(std::vector<girth::GirthSolver>& solvers, const std::vector<Index>& vertices) {
  return girth::bench::secondsOf([&] {
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < solvers.size(); ++t) {
      threads.emplace_back([&, t] {
        for (std::size_t i = t; i < vertices.size(); i += solvers.size()) {
          if (!solvers[t].value(Vertex(vertices[i]))) std::exit(1);
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
  });
}

void printExact(const SurfaceMesh& mesh, const girth::ExecutionContext& context, double most) {
  constexpr std::size_t kTrial = 32;
  std::vector<girth::GirthSolver> solvers;
  for (unsigned t = 0; t < context.threads; ++t) solvers.emplace_back(mesh);
  const std::size_t all = mesh.vertexCount();
  std::size_t count = std::min(all, kTrial);
  double seconds = exactSeconds(solvers, girth::bench::spreadVertices(mesh, count));
  const double whole = seconds / static_cast<double>(count) * static_cast<double>(all);
  if (whole <= most) {
    count = all;
    seconds = girth::bench::secondsOf([&] {
      if (girth::girthField(mesh, girth::GirthMethod::Exact, context).computed != all) std::exit(1);
    });
  } else {
    const auto affordable = static_cast<std::size_t>(most / whole * static_cast<double>(all));
    if (affordable > count) {
      count = affordable;
      seconds = exactSeconds(solvers, girth::bench::spreadVertices(mesh, count));
    }
    seconds *= static_cast<double>(all) / static_cast<double>(count);
  }
  std::printf(R"(,"exact":{"seconds":%.6g,"vertices":%zu})", seconds, count);
}

void printRefined(const SurfaceMesh& mesh, const girth::ExecutionContext& context) {
  girth::RefinedOptions options;
  options.audit = 0;
  const double seconds = girth::bench::secondsOf([&] {
    if (!girth::refinedGirth(mesh, options, context)) std::exit(1);
  });
  std::printf(R"(,"refined":{"seconds":%.6g})", seconds);
}

void printCarried(const SurfaceMesh& mesh, const girth::ExecutionContext& context) {
  const double seconds = girth::bench::secondsOf([&] {
    const SurfaceMesh few = remeshed(mesh, kCoarseFaces, context);
    const auto field = girth::girthField(few, girth::GirthMethod::Exact, context);
    const auto places = girth::nearestPoints(few, mesh);
    if (girth::interpolated(few, field.values, places).size() != mesh.vertexCount()) std::exit(1);
  });
  std::printf(R"(,"carried":{"seconds":%.6g})", seconds);
}

}  // namespace

int main(int argc, char** argv) {
  girth::ExecutionContext context;
  context.threads = std::max(1u, std::thread::hardware_concurrency());
  double exactSeconds = 60;
  Index faces = 0, divisions = 0, refinedFaces = std::numeric_limits<Index>::max();
  std::vector<std::string> paths;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--threads" && i + 1 < argc) {
      context.threads = std::max(1u, static_cast<unsigned>(std::atoi(argv[++i])));
    } else if (argument == "--faces" && i + 1 < argc) {
      faces = static_cast<Index>(std::atoi(argv[++i]));
    } else if (argument == "--divided" && i + 1 < argc) {
      divisions = static_cast<Index>(std::atoi(argv[++i]));
    } else if (argument == "--exact-seconds" && i + 1 < argc) {
      exactSeconds = std::atof(argv[++i]);
    } else if (argument == "--refined-faces" && i + 1 < argc) {
      refinedFaces = static_cast<Index>(std::atoi(argv[++i]));
    } else {
      paths.push_back(argument);
    }
  }
  for (const std::string& path : paths) {
    const girth::bench::Model model = girth::bench::loadModel(path);
    SurfaceMesh mesh = faces > 0 ? remeshed(model.mesh, faces, context) : model.mesh;
    for (Index i = 0; i < divisions; ++i) mesh = divided(mesh);
    std::printf(R"({"model":"%s","faces":%u,"vertices":%u,"threads":%u)", model.name.c_str(),
                mesh.faceCount(), mesh.vertexCount(), context.threads);
    printExact(mesh, context, exactSeconds);
    if (mesh.faceCount() > kCoarseFaces + kCoarseFaces / 10) {
      printCarried(mesh, context);
      if (mesh.faceCount() <= refinedFaces) printRefined(mesh, context);
    }
    std::printf("}\n");
    std::fflush(stdout);
  }
}
