#include "model/loading.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "girth/io/length_unit.h"
#include "model/length_text.h"
#include "process/files.h"
#include "process/report.h"

namespace girth::cli {
namespace {

/// The component that a user named. Those of `parts` are numbered by their place.
Result<Index> componentOf(const std::string& text, const std::vector<SurfacePart>& parts) {
  if (text == "largest") {
    const auto largest = std::max_element(
        parts.begin(), parts.end(),
        [](const SurfacePart& a, const SurfacePart& b) { return a.area < b.area; });
    return static_cast<Index>(largest - parts.begin());
  }
  Index number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc() || end != text.data() + text.size()) {
    return usageError("\"" + text + "\" is no component",
                      "name one by its number in girth info, or write largest");
  }
  return number;
}

}  // namespace

Result<io::LoadedMesh> loadModel(const std::string& path, const ModelOptions& options) {
  auto bytes = readFile(path);
  if (!bytes) return bytes.error();
  auto model = io::readModel(bytes.value(), path, resourcesBeside(path));
  if (!model) return model.error();
  bytes.value() = {};
  io::ReadModel& read = model.value();
  if (const io::LengthUnit* unit = io::findLengthUnit(options.unit)) read.unit = unit->name;

  PrepareOptions prepare;
  prepare.closeHoles = options.closeHoles;
  if (!options.weldDistance.empty()) {
    const auto distance = lengthInModelUnit(options.weldDistance, read.unit);
    if (!distance) return distance.error();
    prepare.weldDistance = distance.value();
  }
  if (!options.components.empty()) {
    // The components are known only once the surface has been prepared.
    const auto all = prepareSurface(read.soup, prepare);
    if (!all) return all.error();
    for (const std::string& text : options.components) {
      const auto component = componentOf(text, all.value().parts);
      if (!component) return component.error();
      prepare.components.push_back(component.value());
    }
  }
  auto prepared = prepareSurface(std::move(read.soup), prepare);
  if (!prepared) return prepared.error();
  return io::LoadedMesh{std::move(prepared).value(), read.format, std::move(read.unit),
                        std::move(read.notes)};
}

Result<SurfaceMesh> readSurface(const std::string& path) {
  const auto bytes = readFile(path);
  if (!bytes) return bytes.error();
  auto loaded = io::readMesh(bytes.value(), path, resourcesBeside(path));
  if (!loaded) return loaded.error();
  return std::move(loaded.value().mesh);
}

}  // namespace girth::cli
