// girth tube: centrelines, diameters, narrowings and widenings of tubes.
#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands/common_options.h"
#include "commands/measure.h"
#include "commands/table.h"
#include "girth/describe/tubes.h"
#include "girth/io/result_csv.h"
#include "girth/io/result_json.h"
#include "girth/io/write_tubes.h"
#include "girth/tubes.h"
#include "model/computing.h"
#include "model/typed_point.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace tube_command {
namespace {

/// Rows of a table that are printed.
constexpr std::size_t kMostRows = 50;

struct Options : MeasuringOptions {
  std::vector<TypedPoint> ends;
  std::string spacing;
  double leastDegree{100 * TubesOptions{}.leastDegree};
  std::string reference{"taper"};
  bool places{false};
  bool noGirth{false};
};

TubeReference referenceOf(const std::string& word) {
  for (const TubeReference one :
       {TubeReference::Mean, TubeReference::Beyond, TubeReference::Before}) {
    if (word == toString(one)) return one;
  }
  return TubeReference::Taper;
}

Result<Tubes> compute(const Options& options, const io::LoadedMesh& loaded) {
  if (options.places && options.output.ending() != ".csv") {
    return usageError("--places needs a table",
                      "write one: -o places.csv; JSON has the narrowings anyway");
  }
  TubesOptions wanted;
  auto ends = surfacePoints(loaded, options.ends, options.model, options.preparing);
  if (!ends) return ends.error();
  wanted.ends = std::move(ends).value();
  if (!options.spacing.empty()) {
    if (auto error = readLength(options.spacing, loaded.unit, wanted.spacing)) {
      return *std::move(error);
    }
    if (!(wanted.spacing > 0)) {
      return usageError("--every needs a length above 0", "type one as in 0.5mm");
    }
  }
  wanted.leastDegree = options.leastDegree / 100;
  wanted.reference = referenceOf(options.reference);
  wanted.girth = !options.noGirth;
  ProgressLine progress(options.model);
  return findTubes(loaded.mesh, wanted, watched(options.threads, progress));
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f%%", 100 * share);
  return text;
}

void printOthers(const Tubes& found) {
  for (std::size_t i = 0; i < found.others.size() && i < kMostRows; ++i) {
    const NoTubeComponent& other = found.others[i];
    const std::string reason(io::noTubeWords(other.reason));
    const char* remedy = other.reason == NoTube::Handle ? ": cut it first" : "";
    std::printf("  component %u is no tube: it %s%s\n", other.component, reason.c_str(), remedy);
  }
  if (found.others.size() > kMostRows) {
    std::printf("  ... and %zu more are none\n", found.others.size() - kMostRows);
  }
}

void printText(const std::string& model, const io::LoadedMesh& loaded, const Tubes& found) {
  const std::size_t branches = found.branches.size(), places = found.places.size();
  std::printf("%s: %zu branch%s, %zu narrowing%s or widening%s\n", model.c_str(), branches,
              branches == 1 ? "" : "es", places, places == 1 ? "" : "s", places == 1 ? "" : "s");
  if (branches > 0) {
    std::printf("  %6s %6s %12s %12s %12s  %s\n", "branch", "leaves", "from", "to", "diameter",
                "leads to");
  }
  for (std::size_t i = 0; i < branches && i < kMostRows; ++i) {
    const TubeBranch& branch = found.branches[i];
    const std::string parent = branch.parent == kNoIndex ? "-" : std::to_string(branch.parent);
    std::printf("  %6zu %6s %12s %12s %12s  %s\n", i, parent.c_str(),
                readable(branch.firstDistance).c_str(), readable(branch.lastDistance).c_str(),
                readable(branch.median).c_str(), std::string(io::branchEndWords(branch)).c_str());
  }
  if (places > 0) {
    std::printf("  %6s %-9s %6s %12s %12s %12s %8s %8s %12s\n", "place", "kind", "branch", "at",
                "diameter", "reference", "diameter", "area", "girth");
  }
  for (std::size_t i = 0; i < places && i < kMostRows; ++i) {
    const TubePlace& place = found.places[i];
    std::printf("  %6zu %-9s %6u %12s %12s %12s %8s %8s %12s\n", i,
                std::string(toString(place.change)).c_str(), place.branch,
                readable(place.distance).c_str(), readable(place.equivalentDiameter).c_str(),
                readable(place.reference).c_str(), percent(place.degreeByDiameter).c_str(),
                percent(place.degreeByArea).c_str(), readableOrDash(place.girth).c_str());
  }
  if (branches > kMostRows || places > kMostRows) std::printf("  ... and more, which -o writes\n");
  printOthers(found);
  printUnits(loaded.unit);
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  const Writers<Tubes> writers{{{".csv",
                                 [options](const io::LoadedMesh& loaded, const Tubes& found) {
                                   return options->places ? io::tubePlacesCsv(loaded, found)
                                                          : io::resultCsv(loaded, found);
                                 }},
                                {".html",
                                 [options](const io::LoadedMesh& loaded, const Tubes& found) {
                                   return io::tubesHtml(loaded, found, options->model);
                                 }},
                                {".obj", io::tubesObj},
                                {".glb", io::tubesGlb}},
                               [options](const io::LoadedMesh& loaded, const Tubes& found) {
                                 return io::resultJson(loaded, found, options->model);
                               },
                               [options](const io::LoadedMesh& loaded, const Tubes& found) {
                                 printText(options->model, loaded, found);
                               }};
  table.add("MODEL", options->model, "The model to read").required();
  addOutputOptions(table, options->output, writers.endings(),
                   "Write the tubes: .html (a report), .json, .csv (a row for each station), .obj "
                   "or .glb (lines)");
  table.add("--places", options->places,
            "Write the narrowings and widenings as .csv: a row for each");
  table.onValue(
      "--ends P1,P2,...",
      [options](const std::string& text) { return readPoints(text, options->ends); },
      "Points at the ends of the tube, the first one where it begins, as in 12,88; or only that "
      "one. "
      "Default: the boundary curves, the longest first, and the farthest places of closed "
      "branches");
  table.add("--every LENGTH", options->spacing,
            "The distance of stations, as in 0.5mm. Default: an eighth of the median diameter");
  table
      .add("--min-degree PERCENT", options->leastDegree,
           "The least degree of narrowings and widenings, by diameter. Default: 10")
      .range(0.1, 100);
  table
      .add("--reference SIDE", options->reference,
           "What the degree is measured against: taper, between the diameters of both sides; mean, "
           "of both; beyond or before, of one. Default: taper")
      .oneOf({"taper", "mean", "beyond", "before"});
  table.add("--no-girth", options->noGirth, "Leave out the exact girth at each station");
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth tube vessel.stl --unit mm -o report.html",
                "Centreline, diameters, narrowings and bulges as a page.");
  table.example("girth tube vessel.stl --unit mm --reference beyond --places -o stenoses.csv",
                "The degree of each stenosis against the vessel beyond it.");
  table.note("Degree",
             "50% by diameter: half as wide as the reference. Of round tubes that is 75% by area.");
  return [options, writers] {
    return measure(
        *options, [&](const io::LoadedMesh& loaded) { return compute(*options, loaded); }, writers);
  };
}

}  // namespace
}  // namespace tube_command

const Command kTube{"tube", "Measure tubes: centrelines, diameters, narrowings", tube_command::add};

}  // namespace girth::cli
