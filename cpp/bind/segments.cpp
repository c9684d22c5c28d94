// The segments that a body falls into at its necks.
#include "girth/segments.h"

#include <emscripten/bind.h>

#include <string>
#include <utility>

#include "analysis.h"
#include "boundary.h"
#include "cut_part.h"
#include "file_content.h"
#include "girth/describe/parts.h"
#include "girth/io/write_segments.h"
#include "job_surface.h"

using emscripten::val;

namespace girth::bind {
namespace {

/// By {girth, diameter} and {minProminence, girth, thickness, smoothing}; a threshold that is
/// undefined is the suggested one.
Result<io::SegmentedModel> segmented(const SurfaceMesh& mesh, const val& fields, const val& options,
                                     const ExecutionContext& context) {
  const GirthAndDiameter values(fields);
  PartOptions kinds;
  kinds.smoothing = options["smoothing"].as<double>();
  PartThresholds& thresholds = kinds.thresholds;
  thresholds = suggestedThresholds(mesh, values.girth, values.diameter);
  for (const auto& [name, threshold] :
       {std::pair{"girth", &thresholds.girth}, {"thickness", &thresholds.thickness}}) {
    if (const val wanted = options[name]; !wanted.isUndefined()) *threshold = wanted.as<double>();
  }
  const auto parts = findParts(mesh, values.girth, values.diameter, kinds);
  if (!parts) return parts.error();
  auto tips = findTips(mesh, values.girth);
  if (!tips) return tips.error();
  const auto necks =
      findNecks(mesh, values.girth, {options["minProminence"].as<double>()}, context);
  if (!necks) return necks.error();
  return io::segmentedModel(mesh, necks.value().necks, parts.value().kinds, kinds,
                            std::move(tips.value().tips));
}

/// `Segments` of types.ts, or an error.
val segments(const JobSurface& surface, const val& fields, const val& options,
             const val& onProgress) {
  return guarded([&] {
    const auto found = segmented(surface.mesh(), fields, options, reportingTo(onProgress));
    if (!found) return toJs(found.error());
    const io::SegmentedModel& model = found.value();
    val list = val::array();
    for (std::size_t i = 0; i < model.segments.size(); ++i) {
      const Segment& segment = model.segments[i];
      val entry = cutPartOf(model.model, model.model.parts[i]);
      entry.set("kind", std::string(toString(segment.kind())));
      val shares = val::object();
      for (const PartKind kind :
           {PartKind::Body, PartKind::Tube, PartKind::Plate, PartKind::Unknown}) {
        shares.set(std::string(toString(kind)),
                   segment.kindAreas[static_cast<std::size_t>(kind)] / segment.area);
      }
      entry.set("shares", shares);
      entry.set("tips", val::array(segment.tips));
      list.call<void>("push", entry);
    }
    val result = val::object();
    result.set("segments", list);
    result.set("labels", copyOut<Index>("Uint32Array",
                                        io::partOfFaces(model.model, surface.mesh().faceCount())));
    result.set("thresholds", ResultObject().addMembers(model.kinds.thresholds).object());
    result.set("crossing", val::array(model.crossing));
    return result;
  });
}

Result<std::string> contentFor(const std::string& format, const io::LoadedMesh& loaded,
                               const io::SegmentedModel& segmented, const std::string& name) {
  if (format == "csv") return io::segmentsCsv(loaded, segmented);
  if (format == "glb") return io::segmentsGlb(loaded, segmented);
  if (format == "json") return io::segmentsJson(loaded, segmented, name);
  return makeError(ErrorCode::Usage, -1, "segments are not written as '" + format + "'");
}

/// {bytes} of a file with the segments, of `WrittenModel` and `FileContent` of protocol.ts; or an
/// error.
val writeSegments(JobSurface& surface, const val& model, const val& content, const val& fields,
                  const val& options, const std::string& format, const val& onProgress) {
  return guarded([&] {
    const io::LoadedMesh& loaded = surface.inUnit(model["unit"].as<std::string>());
    const WithFileContent with(surface.loaded(), content);
    const auto found = segmented(loaded.mesh, fields, options, reportingTo(onProgress));
    if (!found) return toJs(found.error());
    return fileOf(contentFor(format, loaded, found.value(), model["name"].as<std::string>()));
  });
}

EMSCRIPTEN_BINDINGS(girthSegments) {
  emscripten::function("segments", &segments);
  emscripten::function("writeSegments", &writeSegments);
}

}  // namespace
}  // namespace girth::bind
