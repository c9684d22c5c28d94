// The paper's Figure 7: the girth of one model remeshed to 2,000, 5,000, 10,000 and 20,000 faces
// against that of the model itself, as the difference of the distributions (equation 1).
//
//   remesh_figure [--threads N] [--values FILE.csv] MODEL [FACES...]
//
// --values: the girth of MODEL as `girth igf MODEL -o FILE.csv` writes it, so that it need not be
// computed again (minutes for 50,000 faces).

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "girth/girth.h"
#include "support/measure.h"
#include "support/models.h"
#include "support/program.h"

namespace {

using girth::Index;

/// The second column, a row a vertex.
std::vector<double> valuesOf(const std::string& path) {
  std::ifstream file(path);
  std::vector<double> values;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    const char* value = line.c_str() + line.find(',') + 1;
    values.push_back(*value == ',' ? std::numeric_limits<double>::quiet_NaN()
                                   : std::strtod(value, nullptr));
  }
  return values;
}

/// The share of faces with a corner below 20 degrees.
double thinShare(const girth::SurfaceMesh& mesh) {
  constexpr double kThin = 0.3490658503988659;
  std::size_t thin = 0;
  for (const girth::Face f : mesh.faces()) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      if (mesh.cornerAngle(girth::Halfedge(h)) >= kThin) continue;
      ++thin;
      break;
    }
  }
  return static_cast<double>(thin) / mesh.faceCount();
}

int run(int argc, char** argv) {
  girth::ExecutionContext context;
  std::string model, table;
  std::vector<Index> wanted;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--threads" && i + 1 < argc) {
      context.threads = static_cast<unsigned>(std::strtoul(argv[++i], nullptr, 10));
    } else if (argument == "--values" && i + 1 < argc) {
      table = argv[++i];
    } else if (model.empty()) {
      model = argument;
    } else {
      wanted.push_back(static_cast<Index>(std::strtoul(argument.c_str(), nullptr, 10)));
    }
  }
  if (model.empty()) {
    std::fprintf(stderr, "remesh_figure [--threads N] [--values FILE.csv] MODEL [FACES...]\n");
    return 1;
  }
  if (wanted.empty()) wanted = {2000, 5000, 10000, 20000};

  const girth::SurfaceMesh mesh = girth::bench::loadModel(model).mesh;
  std::vector<double> values;
  if (!table.empty()) {
    // Rows are the file's vertices; the models of this figure have none that are welded or left
    // out.
    values = valuesOf(table);
    if (values.size() != mesh.vertexCount()) {
      std::fprintf(stderr, "%s has not one row for each vertex\n", table.c_str());
      return 1;
    }
  } else {
    values = girth::girthField(mesh, girth::GirthMethod::Exact, context).values;
  }
  std::printf(
      "faces wanted, had, remeshing, below 20 degrees, girth, difference (eq. 1), carried\n");
  for (const Index faces : wanted) {
    girth::Result<girth::RemeshedSurface> result =
        girth::makeError(girth::ErrorCode::Internal, -1, "");
    const double remeshing =
        girth::bench::secondsOf([&] { result = girth::remesh(mesh, {faces}, context); });
    if (!result) {
      std::fprintf(stderr, "%s\n", result.error().message.c_str());
      return 1;
    }
    const girth::SurfaceMesh& other = result.value().mesh;
    girth::GirthField field;
    const double computing = girth::bench::secondsOf(
        [&] { field = girth::girthField(other, girth::GirthMethod::Exact, context); });
    const std::vector<double> carried = girth::interpolated(
        other, field.values, girth::nearestPoints(other, mesh), girth::kSteepestGirth);
    std::printf("%u, %u, %.2f s, %.2f %%, %.1f s, %.2e, %.2e\n", faces, other.faceCount(),
                remeshing, 100 * thinShare(other), computing,
                girth::fieldDifference(mesh, values, other, field.values),
                girth::fieldDifference(mesh, values, mesh, carried));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return girth::bench::runProgram(run, argc, argv); }
