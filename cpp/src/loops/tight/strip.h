// Strips of faces laid flat, and the shortest way through them.
//
// A run is a list of halfedges: each leaves its own face and enters that of its twin, which the
// next one leaves. From above, its end is on the left of who crosses it and its start on the right.
// Numbers are those of the unfolding.
#pragma once

#include <cstddef>
#include <vector>

#include "geodesic/unfolding.h"

namespace girth::loops {

using geodesic::Unfolding;
using geodesic::Vec2;
using Run = std::vector<Index>;

/// A corner of a strip: a vertex of the surface where it lies in the plane, and the portals (the
/// crossed edges, numbered from 0) that it is an end of. A vertex that the strip passes twice is
/// two corners.
struct Corner {
  Vec2 place;
  Index vertex{kNoIndex};
  std::size_t firstPortal{0}, lastPortal{0};
};

/// The faces of a run side by side in the plane.
class Strip {
 public:
  /// Lays the run flat: portal i is crossed by run[i]. `closed`: the run comes back to the face
  /// that it starts in, and its first edge is laid flat once more as portal run.size().
  Strip(const Unfolding& unfolding, const Run& run, bool closed);

  std::size_t portals() const { return left_.size(); }
  const Corner& corner(std::size_t number) const { return corners_[number]; }
  std::size_t corners() const { return corners_.size(); }
  /// The corners at the ends of a portal.
  std::size_t left(std::size_t portal) const { return left_[portal]; }
  std::size_t right(std::size_t portal) const { return right_[portal]; }
  /// The vertices opposite the first portal, in front of it, and behind the last one.
  Vec2 start() const { return start_; }
  Vec2 end() const { return end_; }

  /// Where the line from a to b meets a portal: its share from the right end to the left one.
  double share(std::size_t portal, Vec2 a, Vec2 b) const;

  /// The corners at which the shortest path from a to b bends, b behind portal `last` and a in
  /// front of portal `first` or on it (Lee and Preparata 1984). O(portals).
  std::vector<std::size_t> bends(Vec2 a, std::size_t first, Vec2 b, std::size_t last) const;

 private:
  std::vector<Corner> corners_;
  std::vector<std::size_t> left_, right_;
  Vec2 start_, end_;
};

/// The run the other way round.
Run reversed(const Unfolding& unfolding, const Run& run);

/// Takes out edges that are crossed and at once crossed back; of a closed run also across its end.
void cancelReturns(const Unfolding& unfolding, Run& run, bool closed);

}  // namespace girth::loops
