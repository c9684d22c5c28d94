// Exact distances from one vertex to all vertices, on one core: milliseconds (processor
// time; the median of several sources, each the fastest of three runs) of the library, of the ICH
// yardstick, and of any other program that was run on the same models; ratios, and the largest
// relative difference.
//
//   single_source [--sources N] [--export FOLDER] [--peers FOLDER] [MODEL...]
//
// Without models: five of 6,000 to 97,000 faces (support/models.h). --export writes each model to
// FOLDER/NAME.obj, with all digits, for other programs to read; --peers takes their results from
// FOLDER/NAME.PEER.txt, in the form that README.md gives.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "girth/girth.h"
#include "support/ich_girth.h"
#include "support/measure.h"
#include "support/models.h"

namespace {

using girth::Index;

/// What one program found for one model, by source.
struct Result {
  std::string name;
  struct Field {
    double seconds{0};
    std::vector<double> distances;
  };
  std::map<Index, Field> fields;

  double medianMilliseconds() const {
    std::vector<double> times;
    for (const auto& [source, field] : fields) times.push_back(1e3 * field.seconds);
    return girth::bench::quantile(times, 0.5);
  }
};

template <class Distances>
Result measure(const std::string& name, const std::vector<Index>& sources, Distances&& distances) {
  constexpr int kRuns = 3;
  Result result{name, {}};
  for (const Index source : sources) {
    Result::Field& field = result.fields[source];
    field.seconds = std::numeric_limits<double>::infinity();
    for (int run = 0; run < kRuns; ++run) {
      field.seconds =
          std::min(field.seconds,
                   girth::bench::processorSecondsOf([&] { distances(source, field.distances); }));
    }
  }
  return result;
}

/// Blocks of `source V seconds S` and one distance a line.
Result readPeer(const std::filesystem::path& path, const std::string& name) {
  Result result{name, {}};
  std::ifstream in(path);
  std::string word;
  Result::Field* field = nullptr;
  while (in >> word) {
    if (word == "source") {
      Index source = 0;
      double seconds = 0;
      in >> source >> word >> seconds;
      field = &result.fields[source];
      field->seconds = seconds;
    } else if (field != nullptr) {
      field->distances.push_back(std::strtod(word.c_str(), nullptr));
    }
  }
  return result;
}

void writeObj(const girth::SurfaceMesh& mesh, const std::filesystem::path& path) {
  std::FILE* file = std::fopen(path.string().c_str(), "w");
  if (file == nullptr) {
    std::fprintf(stderr, "%s: cannot be written\n", path.string().c_str());
    std::exit(1);
  }
  for (Index v = 0; v < mesh.vertexCount(); ++v) {
    const girth::Vec3& p = mesh.position(v);
    std::fprintf(file, "v %.17g %.17g %.17g\n", p.x, p.y, p.z);
  }
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    const auto corners = mesh.faceVertices(f);
    std::fprintf(file, "f %u %u %u\n", corners[0] + 1, corners[1] + 1, corners[2] + 1);
  }
  std::fclose(file);
}

/// Largest difference as a share of the distance, over all sources that both have.
double difference(const Result& a, const Result& b) {
  double largest = 0;
  for (const auto& [source, field] : a.fields) {
    const auto other = b.fields.find(source);
    if (other == b.fields.end()) continue;
    if (field.distances.size() != other->second.distances.size()) {
      return std::numeric_limits<double>::infinity();
    }
    for (std::size_t v = 0; v < field.distances.size(); ++v) {
      const double x = field.distances[v], y = other->second.distances[v];
      if (x != y) largest = std::max(largest, std::abs(x - y) / std::max(x, y));
    }
  }
  return largest;
}

void compare(const girth::bench::Model& model, std::size_t sourceCount, const std::string& peers) {
  const girth::SurfaceMesh& mesh = model.mesh;
  const std::vector<Index> sources = girth::bench::spreadVertices(mesh, sourceCount);
  girth::GeodesicSolver solver(mesh);
  girth::bench::IchGirth ich(mesh);
  const Result ours = measure("girth", sources, [&](Index source, std::vector<double>& out) {
    out = solver.distances(girth::SurfacePoint::atVertex(source)).value();
  });
  std::vector<Result> others = {
      measure("ICH", sources, [&](Index source, std::vector<double>& out) {
        const auto distances = ich.distances(source);
        out.assign(distances.begin(), distances.end());
      })};
  if (!peers.empty()) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(peers)) {
      files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
      const std::string name = file.filename().string(), prefix = model.name + ".";
      if (name.rfind(prefix, 0) != 0 || file.extension() != ".txt") continue;
      others.push_back(readPeer(file, name.substr(prefix.size(), name.size() - prefix.size() - 4)));
    }
  }
  const double milliseconds = ours.medianMilliseconds();
  std::printf("%-24s %6u  %-18s %9.2f ms\n", model.name.c_str(), mesh.faceCount(), "girth",
              milliseconds);
  for (const Result& other : others) {
    std::printf("%-24s %6s  %-18s %9.2f ms %7.2f times ours, difference %.1e\n", "", "",
                other.name.c_str(), other.medianMilliseconds(),
                other.medianMilliseconds() / milliseconds, difference(ours, other));
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<girth::bench::Model> models;
  std::size_t sources = 5;
  std::string exportFolder, peers;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--sources" && i + 1 < argc) {
      sources = static_cast<std::size_t>(std::atol(argv[++i]));
    } else if (argument == "--export" && i + 1 < argc) {
      exportFolder = argv[++i];
    } else if (argument == "--peers" && i + 1 < argc) {
      peers = argv[++i];
    } else {
      models.push_back(girth::bench::loadModel(argument));
    }
  }
  if (models.empty()) models = girth::bench::modelsOfFiveSizes();
  for (const auto& model : models) {
    if (exportFolder.empty()) {
      compare(model, sources, peers);
    } else {
      writeObj(model.mesh, std::filesystem::path(exportFolder) / (model.name + ".obj"));
    }
  }
}
