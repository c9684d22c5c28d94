// The segments that a body falls into at its necks.
#include "girth/segments.h"

#include <emscripten/bind.h>

#include <string>
#include <utility>

#include "analysis.h"
#include "boundary.h"
#include "cut_part.h"
#include "girth/describe/necks.h"
#include "girth/describe/parts.h"
#include "girth/describe/segments.h"
#include "girth/io/write_segments.h"
#include "job_surface.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// The tips, necks and kinds that a body is divided by.
struct Division {
  std::vector<PartKind> vertexKinds;
  PartOptions kinds;
  Tips tips;
  Necks necks;
};

/// By {girth, diameter} and {minProminence, girth, shapeDiameter, smoothing}; a threshold that is
/// undefined is the suggested one.
Result<Division> divisionOf(const SurfaceMesh& mesh, const val& fields, const val& options,
                            const ExecutionContext& context) {
  const GirthAndDiameter values(fields);
  PartOptions kinds;
  kinds.smoothing = options["smoothing"].as<double>();
  PartThresholds& thresholds = kinds.thresholds;
  thresholds = suggestedThresholds(mesh, values.girth, values.diameter);
  for (const auto& [name, threshold] :
       {std::pair{"girth", &thresholds.girth}, {"shapeDiameter", &thresholds.shapeDiameter}}) {
    if (const val wanted = options[name]; !wanted.isUndefined()) *threshold = wanted.as<double>();
  }
  auto parts = findParts(mesh, values.girth, values.diameter, kinds);
  if (!parts) return parts.error();
  auto tips = findTips(mesh, values.girth);
  if (!tips) return tips.error();
  auto necks = findNecks(mesh, values.girth, {options["minProminence"].as<double>()}, context);
  if (!necks) return necks.error();
  return Division{std::move(parts.value().kinds), kinds, std::move(tips).value(),
                  std::move(necks).value()};
}

/// `FoundSegments` of protocol.ts, or an error.
val segments(const JobSurface& surface, const val& fields, const val& options,
             const val& onProgress) {
  return guarded([&] {
    const auto division = divisionOf(surface.mesh(), fields, options, reportingTo(onProgress));
    if (!division) return toJs(division.error());
    const Division& by = division.value();
    const auto found =
        io::segmentedModel(surface.mesh(), by.necks.necks, by.vertexKinds, by.kinds, by.tips.tips);
    if (!found) return toJs(found.error());
    const io::SegmentedModel& model = found.value();
    val list = val::array();
    for (std::size_t i = 0; i < model.segments.size(); ++i) {
      const Segment& segment = model.segments[i];
      ResultObject entry = cutPartOf(model.model, model.model.parts[i]);
      entry.addMembers(segment);
      entry("tips", Numbers{segment.tips});
      list.call<void>("push", entry.object());
    }
    val result = val::object();
    result.set("segments", list);
    result.set("labels", copyOut<Index>("Uint32Array",
                                        io::partOfFaces(model.model, surface.mesh().faceCount())));
    result.set("thresholds", ResultObject().addMembers(model.kinds.thresholds).object());
    result.set("crossing", val::array(model.crossing));
    val files = val::object();
    files.set("kinds", kindCodes(by.vertexKinds));
    files.set("smoothing", by.kinds.smoothing);
    files.set("tips", tipsWithPoints(surface.drawn(), by.tips));
    files.set("necks", ResultObject(surface.drawn()).addMembers(by.necks).object());
    result.set("by", files);
    return result;
  });
}

EMSCRIPTEN_BINDINGS(girthSegments) { emscripten::function("segments", &segments); }

}  // namespace
}  // namespace girth::bind
