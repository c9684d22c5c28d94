#include "girth/io/write_tubes.h"

#include <cstddef>
#include <string>

#include "girth/describe/tubes.h"
#include "girth/io/json_text.h"
#include "girth/io/result_csv.h"
#include "write/glb_writer.h"
#include "write/point_json.h"

namespace girth::io {
std::string_view noTubeWords(NoTube reason) {
  switch (reason) {
    case NoTube::Handle:
      return "has a handle, so that a centreline would run in a circle";
    case NoTube::Blunt:
      return "is less than 2.5 times as long as wide";
    case NoTube::Flat:
      return "is more than four times as wide as thick";
    case NoTube::Coarse:
      return "has no closed section across its line";
  }
  return "";
}

std::string_view branchEndWords(const TubeBranch& branch) {
  if (!branch.ends) return "branching";
  return branch.open ? "open end" : "closed end";
}

std::string tubePlacesCsv(const LoadedMesh& loaded, const Tubes& tubes) {
  ResultCsv<TubePlace> csv(loaded, "number");
  for (std::size_t i = 0; i < tubes.places.size(); ++i) {
    csv.add(tubes.places[i], std::to_string(i));
  }
  return csv.text();
}

std::string tubesObj(const LoadedMesh& loaded, const Tubes& tubes) {
  std::string text;
  std::size_t count = 0;
  for (std::size_t b = 0; b < tubes.branches.size(); ++b) {
    const TubeBranch& branch = tubes.branches[b];
    text += "o branch_" + std::to_string(b) + "\n";
    for (Index i = branch.firstStation; i < branch.endStation; ++i) {
      text += "v " + pointText(tubes.stations[i].centre, ' ') + "\n";
    }
    text += "l";
    for (Index i = branch.firstStation; i < branch.endStation; ++i) {
      text += " " + std::to_string(++count);
    }
    text += "\n";
  }
  for (std::size_t i = 0; i < tubes.places.size(); ++i) {
    text += "o place_" + std::to_string(i) + "\n";
    appendLine(loaded, tubes.places[i].points, true, count, text);
  }
  return text;
}

Result<std::string> tubesGlb(const LoadedMesh& loaded, const Tubes& tubes) {
  GlbWriter writer;
  const auto addAll = [&](const auto& rows, const std::string& name) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      addLine(loaded, rows[i].points,
              JsonObject()
                  .add("distance", rows[i].distance)
                  .add("equivalentDiameter", rows[i].equivalentDiameter)
                  .add("girth", rows[i].girth)
                  .add("unit", loaded.unit)
                  .text(),
              name + std::to_string(i), writer);
    }
  };
  addAll(tubes.stations, "station_");
  addAll(tubes.places, "place_");
  return writer.file(loaded.unit);
}

}  // namespace girth::io
