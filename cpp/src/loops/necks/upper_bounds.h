// Upper bounds of the girth along edges between places at which it is known.
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "geodesic/unfolding.h"
#include "girth/error.h"
#include "loops/necks/girth_at.h"
#include "loops/necks/pass_search.h"
#include "loops/tight/moved_loop.h"

namespace girth::loops {

/// For a PassSearch. The loops at its nodes give the bounds; each is traced once and kept.
class UpperBounds {
 public:
  /// Both must outlive this.
  UpperBounds(const geodesic::Unfolding& unfolding, GirthAt& girthAt)
      : unfolding_(unfolding), girthAt_(girthAt) {}

  /// PassSearch::UpperBound. Error: CANCELLED.
  Result<std::vector<double>> at(std::span<const PassSearch::Segment> segments);

 private:
  const geodesic::Unfolding& unfolding_;
  GirthAt& girthAt_;
  std::unordered_map<Index, MovedLoop> loops_;  ///< loops by node
};

}  // namespace girth::loops
