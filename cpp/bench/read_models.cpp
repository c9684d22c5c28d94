// The cost of reading. Every file of the corpus that could be a model (GIRTH_DATA; or the files and
// folders given as arguments): outcome, size, time, and the most memory held meanwhile as a
// multiple of the decoded geometry. Then one generated surface of a million faces in every format
// that is written here. `--faces N` makes that one larger or smaller, 0 leaves it out. Times are
// the processor's, so that what else the machine does counts less.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "girth/io/read_mesh.h"
#include "girth/io/write_mesh.h"
#include "support/heap_meter.h"
#include "support/measure.h"
#include "support/models.h"
#include "support/program.h"

namespace {

namespace fs = std::filesystem;
using namespace girth;

std::optional<std::vector<std::byte>> contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || fs::is_directory(path)) return std::nullopt;
  const std::string content((std::istreambuf_iterator<char>(file)), {});
  const auto* first = reinterpret_cast<const std::byte*>(content.data());
  return std::vector<std::byte>(first, first + content.size());
}

/// One reading, in two steps.
struct Measured {
  std::string outcome;
  std::size_t vertices{0}, faces{0}, components{0};
  double reading{0}, preparing{0};
  /// The most memory at once above the file itself.
  std::size_t peak{0};
  /// Bytes of the geometry that the file describes: its positions and triangles as numbers of 8 and
  /// 4 bytes.
  std::size_t geometry{0};

  double memoryRatio() const {
    return geometry == 0 ? 0 : static_cast<double>(peak) / static_cast<double>(geometry);
  }
};

Measured measure(std::span<const std::byte> bytes, const std::string& name,
                 const io::ResourceReader& resources) {
  Measured measured;
  bench::resetHeapPeak();
  const std::size_t before = bench::heapBytes();
  std::optional<Result<io::ReadModel>> model;
  measured.reading =
      bench::processorSecondsOf([&] { model.emplace(io::readModel(bytes, name, resources)); });
  const auto refused = [&](const Error& error) {
    measured.outcome = toString(error.code);
    measured.peak = bench::heapPeakBytes() - before;
    return measured;
  };
  if (!*model) return refused(model->error());
  TriangleSoup& soup = model->value().soup;
  measured.geometry = 8 * soup.positions.size() + 4 * soup.triangles.size();
  std::optional<Result<PreparedSurface>> prepared;
  measured.preparing =
      bench::processorSecondsOf([&] { prepared.emplace(prepareSurface(std::move(soup))); });
  if (!*prepared) return refused(prepared->error());
  measured.peak = bench::heapPeakBytes() - before;
  measured.outcome = "surface";
  measured.vertices = prepared->value().mesh.vertexCount();
  measured.faces = prepared->value().mesh.faceCount();
  measured.components = prepared->value().mesh.componentCount();
  return measured;
}

/// A name of at most so many characters, its end.
std::string shortened(const std::string& name, std::size_t length) {
  return name.size() <= length ? name : "…" + name.substr(name.size() - length + 1);
}

void measureCorpus(const std::vector<fs::path>& roots) {
  std::printf("| file | bytes | outcome | vertices | faces | parts | ms | memory |\n");
  std::printf("| --- | --: | --- | --: | --: | --: | --: | --: |\n");
  std::map<std::string, std::size_t> outcomes;
  double seconds = 0, worst = 0;
  for (const fs::path& root : roots) {
    std::vector<fs::path> files;
    if (fs::is_directory(root)) {
      for (const auto& entry : fs::recursive_directory_iterator(root)) {
        const std::string ending = entry.path().extension().string();
        // Files that models refer to, and that are none themselves.
        const bool part = ending == ".bin" || ending == ".mtl" || ending == ".csv" ||
                          ending == ".txt" || ending == ".md";
        if (entry.is_regular_file() && !part) files.push_back(entry.path());
      }
      std::sort(files.begin(), files.end());
    } else {
      files.push_back(root);
    }
    for (const fs::path& path : files) {
      const auto bytes = contentOf(path);
      if (!bytes) continue;
      const Measured measured = measure(*bytes, path.string(), [&](std::string_view name) {
        return contentOf(path.parent_path() / std::string(name));
      });
      const double took = measured.reading + measured.preparing;
      ++outcomes[measured.outcome];
      seconds += took;
      worst = std::max(worst, took);
      const std::string name = path == root ? path.filename().string()
                                            : path.lexically_relative(root.parent_path()).string();
      std::printf("| %s | %zu | %s | %zu | %zu | %zu | %.1f | %.1f |\n",
                  shortened(name, 64).c_str(), bytes->size(), measured.outcome.c_str(),
                  measured.vertices, measured.faces, measured.components, 1000 * took,
                  measured.memoryRatio());
    }
  }
  std::size_t files = 0;
  for (const auto& [outcome, count] : outcomes) files += count;
  std::printf("\n%zu files in %.2f s, the slowest %.2f s:", files, seconds, worst);
  for (const auto& [outcome, count] : outcomes) std::printf(" %s %zu", outcome.c_str(), count);
  std::printf("\n\n");
}

void measureGenerated(Index faces) {
  const bench::Model model = bench::bumpyTorus(faces);
  std::printf("%u faces, generated\n\n", model.mesh.faceCount());
  std::printf(
      "| format | MB | read, s | prepare, s | both, s | memory held at most | multiple of the "
      "geometry |\n");
  std::printf("| --- | --: | --: | --: | --: | --: | --: |\n");
  for (const io::Format format :
       {io::Format::Obj, io::Format::Ply, io::Format::Stl, io::Format::Off, io::Format::Glb}) {
    const auto file = io::meshFile(model.mesh, format);
    if (!file) continue;
    const std::string& content = file.value();
    const Measured measured =
        measure(std::as_bytes(std::span(content.data(), content.size())), "model", {});
    std::printf("| %s | %.1f | %.2f | %.2f | %.2f | %.0f MB | %.1f%s |\n",
                std::string(io::toString(format)).c_str(),
                static_cast<double>(content.size()) / 1e6, measured.reading, measured.preparing,
                measured.reading + measured.preparing, static_cast<double>(measured.peak) / 1e6,
                measured.memoryRatio(),
                measured.faces == model.mesh.faceCount() ? "" : ", but not the same surface");
  }
}

int run(int argc, char** argv) {
  Index faces = 1'000'000;
  std::vector<fs::path> roots;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--faces" && i + 1 < argc) {
      faces = static_cast<Index>(std::strtoul(argv[++i], nullptr, 10));
    } else if (argument.rfind("--", 0) != 0) {
      roots.emplace_back(argument);
    }
  }
  if (roots.empty() && !bench::corpusFile("").empty()) {
    for (const char* folder : {"gltf", "bad", "models"})
      roots.emplace_back(bench::corpusFile(folder));
  }
  if (!roots.empty()) measureCorpus(roots);
  if (faces > 0) measureGenerated(faces);
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return girth::bench::runProgram(run, argc, argv); }
