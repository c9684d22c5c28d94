// Exact distances from one vertex to all vertices, on one core: milliseconds (processor
// time; the median of several sources, each the fastest of three runs) of the library, of the ICH
// reference implementation, and of other programs; ratios, and the largest relative difference. All
// take turns, source by source.
//
//   single_source [--sources N] [--peer NAME=PROGRAM]... [MODEL...]
//
// Without models: five of 6,000 to 97,000 faces (support/models.h). --peer measures another program
// beside ours: what it has to do is in peers/peer.h, and how to build two of them in README.md.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "girth/girth.h"
#include "support/ich_girth.h"
#include "support/measure.h"
#include "support/models.h"

namespace {

using girth::Index;

/// Distances from one source, and the time that they took.
struct Field {
  double seconds{0};
  std::vector<double> distances;
};

/// A way to find distances, and what it found so far.
struct Method {
  std::string name;
  std::function<Field(Index)> measure;
  std::vector<Field> fields;

  double medianMilliseconds() const {
    std::vector<double> times;
    for (const Field& field : fields) times.push_back(1e3 * field.seconds);
    return girth::bench::quantile(times, 0.5);
  }
};

template <class Distances>
Method own(const std::string& name, Distances distances) {
  return {name,
          [distances](Index source) {
            constexpr int kRuns = 3;
            Field field{std::numeric_limits<double>::infinity(), {}};
            for (int run = 0; run < kRuns; ++run) {
              const double seconds =
                  girth::bench::processorSecondsOf([&] { field.distances = distances(source); });
              field.seconds = std::min(field.seconds, seconds);
            }
            return field;
          },
          {}};
}

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "%s\n", what.c_str());
  std::exit(1);
}

/// Another program, by the contract of peers/peer.h.
Method peer(const std::string& name, const std::string& program, const std::string& file) {
  return {name,
          [program, file](Index source) {
            const std::string command =
                '"' + program + "\" \"" + file + "\" " + std::to_string(source);
            std::FILE* output = popen(command.c_str(), "r");
            Field field;
            double distance = 0;
            const bool isRight =
                output != nullptr && std::fscanf(output, "seconds %lf", &field.seconds) == 1;
            while (isRight && std::fscanf(output, "%lf", &distance) == 1) {
              field.distances.push_back(distance);
            }
            if (!isRight || pclose(output) != 0) fail(command + ": failed");
            return field;
          },
          {}};
}

void writeObj(const girth::SurfaceMesh& mesh, const std::filesystem::path& path) {
  std::FILE* file = std::fopen(path.string().c_str(), "w");
  if (file == nullptr) fail(path.string() + ": cannot be written");
  for (const girth::Vertex v : mesh.vertices()) {
    const girth::Vec3& p = mesh.position(v);
    std::fprintf(file, "v %.17g %.17g %.17g\n", p.x, p.y, p.z);
  }
  for (const girth::Face f : mesh.faces()) {
    const auto corners = mesh.faceVertices(f);
    std::fprintf(file, "f %u %u %u\n", corners[0] + 1, corners[1] + 1, corners[2] + 1);
  }
  std::fclose(file);
}

/// Largest difference as a share of the distance, over all sources.
double difference(const Method& a, const Method& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.fields.size(); ++i) {
    const std::vector<double>&xs = a.fields[i].distances, &ys = b.fields[i].distances;
    if (xs.size() != ys.size()) return std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < xs.size(); ++v) {
      const double x = xs[v], y = ys[v];
      if (x != y) largest = std::max(largest, std::abs(x - y) / std::max(x, y));
    }
  }
  return largest;
}

/// Programs by the names that they have in the table.
using Peers = std::vector<std::pair<std::string, std::string>>;

void compare(const girth::bench::Model& model, std::size_t sourceCount, const Peers& peers) {
  const girth::SurfaceMesh& mesh = model.mesh;
  girth::GeodesicSolver solver(mesh);
  girth::bench::IchGirth ich(mesh);
  std::vector<Method> methods = {
      own("girth",
          [&](Index source) {
            return solver.distances(girth::SurfacePoint::atVertex(girth::Vertex(source))).value();
          }),
      own("ICH", [&](Index source) {
        const auto distances = ich.distances(source);
        return std::vector<double>(distances.begin(), distances.end());
      })};
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("girth_single_source_" + model.name + ".obj");
  if (!peers.empty()) writeObj(mesh, file);
  for (const auto& [name, program] : peers) methods.push_back(peer(name, program, file.string()));
  for (const Index source : girth::bench::spreadVertices(mesh, sourceCount)) {
    for (Method& method : methods) method.fields.push_back(method.measure(source));
  }
  std::filesystem::remove(file);

  const Method& ours = methods.front();
  const double milliseconds = ours.medianMilliseconds();
  std::printf("%-24s %6u  %-8s %9.2f ms\n", model.name.c_str(), mesh.faceCount(), ours.name.c_str(),
              milliseconds);
  for (std::size_t i = 1; i < methods.size(); ++i) {
    const Method& other = methods[i];
    std::printf("%-24s %6s  %-8s %9.2f ms %7.2f times ours, difference %.1e\n", "", "",
                other.name.c_str(), other.medianMilliseconds(),
                other.medianMilliseconds() / milliseconds, difference(ours, other));
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<girth::bench::Model> models;
  std::size_t sources = 5;
  Peers peers;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--sources" && i + 1 < argc) {
      sources = static_cast<std::size_t>(std::atol(argv[++i]));
    } else if (argument == "--peer" && i + 1 < argc) {
      const std::string words = argv[++i];
      const std::size_t equals = words.find('=');
      if (equals == std::string::npos) fail(words + ": not NAME=PROGRAM");
      peers.emplace_back(words.substr(0, equals), words.substr(equals + 1));
    } else {
      models.push_back(girth::bench::loadModel(argument));
    }
  }
  if (models.empty()) models = girth::bench::modelsOfFiveSizes();
  for (const auto& model : models) compare(model, sources, peers);
}
