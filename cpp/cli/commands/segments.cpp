// girth segments: the parts that a body falls into at its necks, and what they are.
#include "girth/segments.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "commands/common_options.h"
#include "commands/measure.h"
#include "commands/table.h"
#include "girth/io/write_segments.h"
#include "model/clear_necks.h"
#include "model/computing.h"
#include "model/fewer_triangles.h"
#include "process/progress_line.h"
#include "process/report.h"

namespace girth::cli {
namespace segments_command {
namespace {

struct Options : MeasuringOptions {
  /// Lengths as typed, with or without a unit. Empty: suggested by the model.
  std::string minProminence, girth, shapeDiameter;
  double smoothing{0};
};

Result<io::SegmentedModel> compute(const Options& options, const io::LoadedMesh& loaded) {
  if (options.preparing.faces > 0 && options.output.ending() == ".csv") {
    return otherFaces("write .json or .glb");
  }
  const SurfaceMesh& mesh = loaded.mesh;
  // The typed lengths are checked before long work.
  const auto least = readProminence(options.minProminence, loaded.unit);
  if (!least) return least.error();
  PartOptions kinds;
  kinds.smoothing = options.smoothing;
  PartThresholds typed;
  for (const auto& [text, length] :
       {std::pair{&options.girth, &typed.girth}, {&options.shapeDiameter, &typed.shapeDiameter}}) {
    if (auto error = readLength(*text, loaded.unit, *length)) return *std::move(error);
  }
  auto found = computeTips(options.model, mesh, 0, options.threads);
  if (!found) return found.error();
  const std::vector<double>& girth = found.value().girth.values;
  const auto diameter = computeField(options.model, mesh, "sdf", {}, options.threads);
  if (!diameter) return diameter.error();
  PartThresholds& thresholds = kinds.thresholds;
  thresholds = suggestedThresholds(mesh, girth, diameter.value().values);
  if (!options.girth.empty()) thresholds.girth = typed.girth;
  if (!options.shapeDiameter.empty()) thresholds.shapeDiameter = typed.shapeDiameter;
  const auto parts = findParts(mesh, girth, diameter.value().values, kinds);
  if (!parts) return parts.error();

  const auto necks = computeNecks(options.model, loaded, girth, least.value(), options.threads);
  if (!necks) return necks.error();
  ProgressLine progress(options.model);
  auto segmented = io::segmentedModel(mesh, necks.value().necks, parts.value().kinds, kinds,
                                      std::move(found.value().tips.tips), watched(1, progress));
  if (const std::size_t crossing = segmented ? segmented.value().crossing.size() : 0;
      crossing > 0) {
    printNote(options.model,
              std::to_string(crossing) + (crossing == 1 ? " neck crosses" : " necks cross") +
                  " a more prominent one and " + (crossing == 1 ? "was" : "were") + " passed over");
  }
  return segmented;
}

void printText(const std::string& model, const io::LoadedMesh& loaded,
               const io::SegmentedModel& segmented) {
  const std::size_t count = segmented.segments.size();
  std::printf("%s: %zu segment%s\n", model.c_str(), count, count == 1 ? "" : "s");
  std::printf("  %7s %12s %12s %-8s %6s  %s\n", "segment", "area", "faces", "kind", "share",
              "tips at vertex");
  for (std::size_t i = 0; i < count; ++i) {
    const Segment& segment = segmented.segments[i];
    std::string tips;
    for (const Index tip : segment.tips) {
      tips += (tips.empty() ? "" : ", ") + numberInFile(loaded, segmented.tips[tip].apex);
    }
    const double share = segment.kindAreas[static_cast<std::size_t>(segment.kind())] / segment.area;
    std::printf("  %7zu %12s %12u %-8s %5.0f%%  %s\n", i, readable(segment.area).c_str(),
                segmented.model.parts[i].mesh.faceCount(),
                std::string(toString(segment.kind())).c_str(), 100 * share,
                tips.empty() ? "-" : tips.c_str());
  }
  printUnits(loaded.unit);
}

Run add(OptionTable& table) {
  const auto options = std::make_shared<Options>();
  const Writers<io::SegmentedModel> writers{
      {{".csv", io::segmentsCsv}, {".glb", io::segmentsGlb}},
      [options](const io::LoadedMesh& loaded, const io::SegmentedModel& segmented) {
        return io::segmentsJson(loaded, segmented, options->model);
      },
      [options](const io::LoadedMesh& loaded, const io::SegmentedModel& segmented) {
        printText(options->model, loaded, segmented);
      }};
  table.add("MODEL", options->model, "The model to read").required();
  addProminenceOption(table, options->minProminence, "Divide at necks of at least this prominence");
  addLengthOption(table, "--girth LENGTH", options->girth,
                  "Tubes have a girth below this length (tau 1)");
  addLengthOption(table, "--shape-diameter LENGTH", options->shapeDiameter,
                  "Tubes and plates have a shape diameter below this length (tau 2)")
      .formerly("--thickness");
  table
      .add("--smooth-labels WEIGHT", options->smoothing,
           "Weight of all neighbours of a vertex against its own kind, 0 by default")
      .range(0, 1e6)
      .formerly("--smooth");
  addOutputOptions(table, options->output, writers.endings(),
                   "Write the segments: .json, .csv (the segment of each face, its kind and its "
                   "tips), .glb (a node for each, coloured)");
  addFacesOption(table, options->preparing);
  addMeasuringOptions(table, options->preparing, options->threads, options->json);
  table.example("girth segments figure.stl --unit mm --min-prominence 5mm -o segments.csv",
                "A row for each face: its segment, and the segment's kind and tips.");
  table.example("girth segments model.glb --min-prominence 5mm -o segments.glb",
                "The segments in colours.");
  table.note("What a segment is",
             "A segment lies between necks, as girth necks finds them; of necks that cross, only "
             "the most prominent cuts. Most of its area has its kind, as in girth parts; its tips "
             "are those of girth tips. A nose without a neck is no segment.");
  return [options, writers] {
    return measure(
        *options, [&](const io::LoadedMesh& loaded) { return compute(*options, loaded); }, writers);
  };
}

}  // namespace
}  // namespace segments_command

const Command kSegments{"segments", "Divide a body at its necks, and classify the parts",
                        segments_command::add};

}  // namespace girth::cli
