// Files of what was found: results that JavaScript hands back are written, and nothing is computed
// again.

#include <emscripten/bind.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis.h"
#include "boundary.h"
#include "file_content.h"
#include "girth/analyses.def"
#include "girth/describe/bottleneck.h"
#include "girth/describe/handles.h"
#include "girth/describe/limb_axis.h"
#include "girth/describe/limbs.h"
#include "girth/describe/necks.h"
#include "girth/describe/parts.h"
#include "girth/describe/path_profile.h"
#include "girth/describe/print_check.h"
#include "girth/describe/section.h"
#include "girth/describe/tips.h"
#include "girth/io/result_csv.h"
#include "girth/io/result_json.h"
#include "girth/io/write_bottleneck.h"
#include "girth/io/write_handles.h"
#include "girth/io/write_limb_axis.h"
#include "girth/io/write_limbs.h"
#include "girth/io/write_necks.h"
#include "girth/io/write_parts.h"
#include "girth/io/write_path_profile.h"
#include "girth/io/write_section.h"
#include "girth/io/write_segments.h"
#include "girth/io/write_tips.h"
#include "job_surface.h"
#include "result_again.h"
#include "surface_point.h"

using emscripten::val;

namespace girth::bind {
namespace {

Error notOfSurface() {
  return makeError(ErrorCode::InvalidPoint, -1, "the result is not one of this surface");
}

/// A result to be written: `WrittenFound` and `WrittenModel` of protocol.ts.
struct Asked {
  JobSurface& surface;
  const io::LoadedMesh& loaded;
  const val& found;
  const std::string& format;
  std::string name;
  double persistence;

  /// A result; an error where it is not one of the surface. `linePoints`: of its lines, in order.
  template <class Found>
  Result<Found> read(const val& result, std::vector<SurfacePoint> linePoints = {}) const {
    ResultAgain again(loaded.mesh, std::move(linePoints));
    Found value{};
    again.read(result, value);
    if (again.isOfMesh()) return value;
    return notOfSurface();
  }
  template <class Found>
  Result<Found> result() const {
    return read<Found>(found["result"]);
  }
  Error unknownFormat(const char* what) const {
    return makeError(ErrorCode::Usage, -1, std::string(what) + " not written as '" + format + "'");
  }
};

using Content = Result<std::string>;

Content tipsFile(const Asked& asked) {
  if (asked.format != "json" && asked.format != "obj") return asked.unknownFormat("tips are");
  const auto tips =
      asked.read<Tips>(asked.found["result"], unpackedPoints(asked.found["linePoints"]));
  if (!tips) return tips.error();
  if (asked.format == "obj") return io::tipsObj(asked.loaded, tips.value());
  return io::tipsJson(asked.loaded, tips.value(), asked.name, {}, asked.persistence);
}

Content limbsFile(const Asked& asked) {
  if (asked.format != "json" && asked.format != "csv") return asked.unknownFormat("limbs are");
  const auto limbs = asked.result<Limbs>();
  if (!limbs) return limbs.error();
  if (asked.format == "json") {
    return io::limbsJson(asked.loaded, limbs.value(), asked.name, asked.persistence);
  }
  return asked.found["profiles"].as<bool>() ? io::limbProfilesCsv(asked.loaded, limbs.value())
                                            : io::limbsCsv(asked.loaded, limbs.value());
}

Content necksFile(const Asked& asked) {
  const auto necks = asked.result<Necks>();
  if (!necks) return necks.error();
  if (asked.format == "csv") return io::necksCsv(asked.loaded, necks.value());
  if (asked.format == "obj") return io::necksObj(asked.loaded, necks.value());
  if (asked.format == "glb") return io::necksGlb(asked.loaded, necks.value());
  if (asked.format == "json") return io::necksJson(asked.loaded, necks.value(), asked.name);
  return asked.unknownFormat("necks are");
}

/// Sections of several planes have a row, or a line, for each curve.
Content sectionsFile(const Asked& asked) {
  const auto sections = asked.result<Sections>();
  if (!sections) return sections.error();
  if (asked.format == "csv") return io::sectionsCsv(asked.loaded, sections.value());
  if (asked.format == "obj") return io::sectionsObj(asked.loaded, sections.value());
  if (asked.format == "glb") return io::sectionsGlb(asked.loaded, sections.value());
  if (asked.format == "json") {
    return io::sectionsJson(asked.loaded, sections.value(), asked.name);
  }
  return asked.unknownFormat("sections are");
}

Content handlesFile(const Asked& asked) {
  const auto handles = asked.result<Handles>();
  if (!handles) return handles.error();
  if (asked.format == "csv") return io::handlesCsv(asked.loaded, handles.value());
  if (asked.format == "obj") return io::handlesObj(asked.loaded, handles.value());
  if (asked.format == "glb") return io::handlesGlb(asked.loaded, handles.value());
  if (asked.format == "json") return io::handlesJson(asked.loaded, handles.value(), asked.name);
  return asked.unknownFormat("handles are");
}

Content bottleneckFile(const Asked& asked) {
  const auto found = asked.result<Bottleneck>();
  if (!found) return found.error();
  if (asked.format == "obj") return io::bottleneckObj(asked.loaded, found.value());
  if (asked.format == "glb") return io::bottleneckGlb(asked.loaded, found.value());
  if (asked.format == "json") return io::bottleneckJson(asked.loaded, found.value(), asked.name);
  return asked.unknownFormat("a bottleneck is");
}

Content profileFile(const Asked& asked) {
  if (asked.format != "csv" && asked.format != "json") {
    return asked.unknownFormat("a path's profile is");
  }
  const auto stations = asked.read<std::vector<PathStation>>(asked.found["result"]["stations"]);
  if (!stations) return stations.error();
  return asked.format == "csv" ? io::pathProfileCsv(asked.loaded, stations.value())
                               : io::pathProfileJson(asked.loaded, stations.value(), asked.name);
}

Content axisFile(const Asked& asked) {
  const auto axis = asked.read<std::vector<AxisStation>>(asked.found["result"]["loops"]);
  if (!axis) return axis.error();
  if (asked.format == "csv") return io::limbAxisCsv(asked.loaded, axis.value());
  if (asked.format == "obj") return io::limbAxisObj(asked.loaded, axis.value());
  if (asked.format == "glb") return io::limbAxisGlb(asked.loaded, axis.value());
  if (asked.format == "json") return io::limbAxisJson(asked.loaded, axis.value(), asked.name);
  return asked.unknownFormat("an axis is");
}

Content partsFile(const Asked& asked) {
  if (asked.format != "json") return asked.unknownFormat("parts are");
  const val result = asked.found["result"];
  const auto parts = asked.read<std::vector<Part>>(result["parts"]);
  if (!parts) return parts.error();
  const Parts found{kindsAgain(result["kinds"]), copyIn<Index>(result["partOf"]), parts.value()};
  const std::size_t vertices = asked.loaded.mesh.vertexCount();
  if (found.kinds.size() != vertices || found.partOf.size() != vertices) return notOfSurface();
  return io::partsJson(asked.loaded, found, partOptionsOf(asked.found["options"]), asked.name,
                       asked.persistence);
}

Content weakPlacesFile(const Asked& asked) {
  if (asked.format != "json") return asked.unknownFormat("weak places are");
  auto check = asked.result<PrintCheck>();
  if (!check) return check.error();
  // The thinnest points lie at vertices or in faces, never on edges, whatever their weights.
  const val places = asked.found["result"]["places"];
  std::vector<WeakPlace>& found = check.value().places;
  for (std::size_t i = 0; i < found.size(); ++i) found[i].thinnest = pointOf(places[i]["thinnest"]);
  const val creases = asked.found["result"]["creases"];
  std::vector<Crease>& thin = check.value().creases;
  for (std::size_t i = 0; i < thin.size(); ++i) thin[i].thinnest = pointOf(creases[i]["thinnest"]);
  const WithFileContent with(asked.surface.loaded(), asked.found["content"]);
  return io::printCheckJson(asked.loaded, check.value(), limitsOf(asked.found["limits"]),
                            asked.name, asked.persistence);
}

/// By what `segments` gave beside them; the surface is cut again, but nothing is searched for.
Content segmentsFile(const Asked& asked) {
  const val by = asked.found["by"];
  const auto necks = asked.read<Necks>(by["necks"]);
  if (!necks) return necks.error();
  auto tips = asked.read<Tips>(by["tips"], unpackedPoints(by["tips"]["linePoints"]));
  if (!tips) return tips.error();
  const val thresholds = asked.found["result"]["thresholds"];
  const PartOptions options{
      {thresholds["girth"].as<double>(), thresholds["shapeDiameter"].as<double>()},
      by["smoothing"].as<double>()};
  const auto segmented =
      io::segmentedModel(asked.loaded.mesh, necks.value().necks, kindsAgain(by["kinds"]), options,
                         std::move(tips.value().tips));
  if (!segmented) return segmented.error();
  const WithFileContent with(asked.surface.loaded(), asked.found["content"]);
  if (asked.format == "csv") return io::segmentsCsv(asked.loaded, segmented.value());
  if (asked.format == "glb") return io::segmentsGlb(asked.loaded, segmented.value());
  if (asked.format == "json") return io::segmentsJson(asked.loaded, segmented.value(), asked.name);
  return asked.unknownFormat("segments are");
}

/// The file of an analysis of the table.
template <Described Found>
Content analysisFile(const Asked& asked) {
  if (asked.format != "csv" && asked.format != "json")
    return asked.unknownFormat("such results are");
  const auto found = asked.result<Found>();
  if (!found) return found.error();
  return asked.format == "csv" ? io::resultCsv(asked.loaded, found.value())
                               : io::resultJson(asked.loaded, found.value(), asked.name);
}

/// {bytes} of a file with a result of this surface, or an error.
val writeFound(JobSurface& surface, const val& model, const val& found, const std::string& format) {
  static const std::map<std::string, Content (*)(const Asked&)> writers{
      {"sections", sectionsFile},     {"tips", tipsFile},         {"limbs", limbsFile},
      {"necks", necksFile},           {"handles", handlesFile},   {"bottleneck", bottleneckFile},
      {"profile", profileFile},       {"axis", axisFile},         {"parts", partsFile},
      {"printCheck", weakPlacesFile}, {"segments", segmentsFile},
#define GIRTH_ANALYSIS(name, Options, Found, function) {#name, analysisFile<Found>},
#include "girth/analyses.def"
  };
  return guarded([&] {
    const io::LoadedMesh& loaded = surface.inUnit(model["unit"].as<std::string>());
    const Asked asked{surface,
                      loaded,
                      found,
                      format,
                      model["name"].as<std::string>(),
                      model["persistence"].as<double>()};
    return fileOf(writers.at(found["kind"].as<std::string>())(asked));
  });
}

EMSCRIPTEN_BINDINGS(girthFound) { emscripten::function("writeFound", &writeFound); }

}  // namespace
}  // namespace girth::bind
