// The segments that a body falls into at its necks, as a file's content: JSON, CSV or GLB.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "girth/export.h"
#include "girth/io/write_cut.h"
#include "girth/segments.h"

namespace girth::io {

/// A segmentation with all that is written of it.
struct SegmentedModel {
  /// The parts of the surface that was cut at its necks.
  CutModel model;
  /// One for each part.
  std::vector<Segment> segments;
  /// The tips that segments name.
  std::vector<Tip> tips;
  /// By which the kinds were told apart.
  PartOptions kinds;
  /// As in CutAtNecks.
  std::vector<Index> crossing;
};

/// Cuts a surface at its necks, and says what each part is. `kinds`: of the vertices (findParts
/// with `options`). Errors and time: those of cutAtNecks.
GIRTH_EXPORT Result<SegmentedModel> segmentedModel(
    const SurfaceMesh& mesh, std::span<const Neck> necks, std::span<const PartKind> kinds,
    const PartOptions& options, std::vector<Tip> tips, const ExecutionContext& context = {});

/// One JSON object: `file`, `unit`, `thresholds` (`girth`, `shapeDiameter`), `smoothing`,
/// `crossing` (numbers of necks that were passed over), `segments` and `faces`: for each face of
/// the file the segment that has most of its area, null where it is not on the surface. Each
/// segment has `area`, `volume`, `faces`, `genus` and `boundaries` as in cutJson, `kind`, `shares`
/// (of its area, `body`, `tube`, `plate` and `unknown`) and `tips`: of each its number `tip` and
/// its `apex`, as a point of `loopJson`.
GIRTH_EXPORT std::string segmentsJson(const LoadedMesh& loaded, const SegmentedModel& segmented,
                                      std::string_view file);

/// `face,segment,kind,tips` and a row for every face of the file that is on the surface: the
/// segment that has most of its area, what that is, and the numbers of its tips with spaces
/// between them.
GIRTH_EXPORT std::string segmentsCsv(const LoadedMesh& loaded, const SegmentedModel& segmented);

/// Each segment as a node `segment_0`, ... in one of eight colours, in turn, with `kind`, `shares`
/// and `tips` (numbers) in its mesh's extras. Error: as cutGlb.
GIRTH_EXPORT Result<std::string> segmentsGlb(const LoadedMesh& loaded,
                                             const SegmentedModel& segmented);

}  // namespace girth::io
