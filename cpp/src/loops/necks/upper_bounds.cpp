#include "loops/necks/upper_bounds.h"

#include <cstddef>

namespace girth::loops {

Result<std::vector<double>> UpperBounds::at(std::span<const PassSearch::Segment> segments) {
  std::vector<Index> nodes;
  std::vector<SurfacePoint> bases;
  for (const PassSearch::Segment& segment : segments) {
    const std::span<const SurfacePoint> notYet;
    if (!loops_.try_emplace(segment.node, unfolding_, notYet).second) continue;
    nodes.push_back(segment.node);
    bases.push_back(segment.from);
  }
  const auto found = girthAt_.loops(bases);
  if (!found) return found.error();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    loops_.at(nodes[i]) = MovedLoop(unfolding_, found.value()[i]);
  }
  std::vector<double> lengths;
  lengths.reserve(segments.size());
  for (const PassSearch::Segment& segment : segments) {
    lengths.push_back(loops_.at(segment.node).lengthAt(segment.face, segment.to));
  }
  return lengths;
}

}  // namespace girth::loops
