// What the girth is no more than between the places at which it is known.
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "geodesic/unfolding.h"
#include "girth/error.h"
#include "loops/girth_at.h"
#include "loops/moved_loop.h"
#include "loops/pass_search.h"

namespace girth::loops {

/// For a PassSearch, by the loops at its nodes, each of which is traced once and kept.
class Ceilings {
 public:
  /// Both must outlive this.
  Ceilings(const geodesic::Unfolding& unfolding, GirthAt& girthAt)
      : unfolding_(unfolding), girthAt_(girthAt) {}

  /// PassSearch::Ceiling. Error: CANCELLED.
  Result<std::vector<double>> at(std::span<const PassSearch::Segment> segments);

 private:
  const geodesic::Unfolding& unfolding_;
  GirthAt& girthAt_;
  std::unordered_map<Index, MovedLoop> loops_;  ///< of nodes
};

}  // namespace girth::loops
