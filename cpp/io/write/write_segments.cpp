#include "girth/io/write_segments.h"

#include <array>
#include <cstdint>
#include <utility>

#include "girth/describe/parts.h"
#include "girth/describe/segments.h"
#include "girth/io/result_json.h"
#include "write/glb_writer.h"
#include "write/part_json.h"

namespace girth::io {
namespace {

/// Colours that most eyes tell apart (Okabe and Ito 2008), linear.
using Colour = std::array<std::uint16_t, 3>;
constexpr std::array<Colour, 8> kColours{{{51858, 22721, 0},
                                          {6099, 29911, 53401},
                                          {0, 22407, 11235},
                                          {57105, 50844, 3570},
                                          {0, 11028, 29176},
                                          {43606, 7335, 0},
                                          {39572, 12530, 25325},
                                          {14146, 14146, 14146}}};

std::string_view kindText(const Segment& segment) { return toString(segment.kind()); }

std::string segmentJson(const LoadedMesh& loaded, const SegmentedModel& segmented,
                        std::size_t number) {
  const Segment& segment = segmented.segments[number];
  JsonList tips;
  for (const Index tip : segment.tips) {
    tips.add(
        ResultJson(&loaded).addValue("tip", tip).addValue("apex", segmented.tips[tip].apex).text());
  }
  ResultJson json = partJson(segmented.model.parts[number].mesh);
  json.addMembers(segment).addJson("tips", tips.text());
  return json.text();
}

/// The numbers of a segment's tips.
std::string tipsText(const Segment& segment, const char* between) {
  std::string text;
  for (const Index tip : segment.tips) {
    text += (text.empty() ? "" : between) + std::to_string(tip);
  }
  return text;
}

}  // namespace

Result<SegmentedModel> segmentedModel(const SurfaceMesh& mesh, std::span<const Neck> necks,
                                      std::span<const PartKind> kinds, const PartOptions& options,
                                      std::vector<Tip> tips, const ExecutionContext& context) {
  auto cut = cutAtNecks(mesh, necks, context);
  if (!cut) return cut.error();
  SegmentedModel result{
      cutModel(cut.value().cut), {}, std::move(tips), options, std::move(cut.value().crossing)};
  result.segments = segmentsOf(mesh, cut.value().cut, result.model.parts, kinds, result.tips);
  return result;
}

std::string segmentsJson(const LoadedMesh& loaded, const SegmentedModel& segmented,
                         std::string_view file) {
  JsonList segments(true), faces;
  for (std::size_t i = 0; i < segmented.segments.size(); ++i) {
    segments.add(segmentJson(loaded, segmented, i));
  }
  for (const Index label : partOfFaces(loaded, segmented.model)) {
    faces.add(label == kNoIndex ? "null" : std::to_string(label));
  }
  ResultJson json(file, loaded);
  json.addValue("thresholds", segmented.kinds.thresholds)
      .addValue("smoothing", segmented.kinds.smoothing)
      .addValue("crossing", Numbers{segmented.crossing})
      .addJson("segments", segments.text())
      .addJsonLine("faces", faces.text());
  return json.file();
}

std::string segmentsCsv(const LoadedMesh& loaded, const SegmentedModel& segmented) {
  const std::vector<Index> labels = partOfFaces(loaded, segmented.model);
  std::string text = "face,segment,kind,tips\n";
  for (std::size_t face = 0; face < labels.size(); ++face) {
    if (labels[face] == kNoIndex) continue;
    const Segment& segment = segmented.segments[labels[face]];
    text += std::to_string(face) + "," + std::to_string(labels[face]) + "," +
            std::string(kindText(segment)) + "," + tipsText(segment, " ") + "\n";
  }
  return text;
}

Result<std::string> segmentsGlb(const LoadedMesh& loaded, const SegmentedModel& segmented) {
  constexpr std::uint16_t kOpaque = 65535;
  GlbWriter writer;
  for (std::size_t i = 0; i < segmented.segments.size(); ++i) {
    const SurfaceMesh& mesh = segmented.model.parts[i].mesh;
    const Segment& segment = segmented.segments[i];
    std::vector<Vec3> places;
    std::vector<std::uint16_t> channels;
    const Colour& colour = kColours[i % kColours.size()];
    for (const Vertex v : mesh.vertices()) {
      places.push_back(mesh.position(v));
      channels.insert(channels.end(), {colour[0], colour[1], colour[2], kOpaque});
    }
    writer.addPositions(places);
    writer.addColours(channels);
    writer.addTriangles(mesh);
    writer.endMesh(TINYGLTF_MODE_TRIANGLES,
                   ResultJson()
                       .addValue("unit", loaded.unit)
                       .addMembers(segment)
                       .addJson("tips", "[" + tipsText(segment, ",") + "]")
                       .text(),
                   "segment_" + std::to_string(i));
  }
  return writer.file(loaded.unit);
}

}  // namespace girth::io
