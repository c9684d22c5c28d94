// When the saddles of the distance from p die: the merge tree of what the disk has not reached,
// from the cyclic order of shortest paths alone (web/docs/definitions.md, section 2).
//
// Shortest paths end on the cut locus of p; all else is an open disk. On the way round the rim of
// that disk each point of the cut locus is met once for each path that arrives there. Without its
// saddles the cut locus falls apart into pieces, of which each has a single maximum: the rim
// between two ends of saddles is one side of one piece; and just to the left of one half of a
// saddle's loop lies the same piece as just to the right of the other half. So the order in which
// the halves leave p decides which pieces there are, which two meet at each saddle, and to which
// one a maximum belongs. The rest is the elder rule.
#pragma once

#include <span>
#include <vector>

#include "solver/persistence/path_order.h"
#include "solver/search/local_maxima.h"

namespace girth {

/// A saddle of the distance from p: its height, and the halves of its loop.
struct SaddleEnds {
  double height;
  BentPath there, back;
};

/// The saddles' deaths, in their order. A saddle joins two components of the superlevel set, and
/// dies at the lower of their maxima; infinite: it joins no two, or neither has a maximum.
/// `boundaries`: paths that end at each boundary curve, which is never filled. `complete`: all
/// saddles, maxima and boundaries are known; otherwise those up to some height, and a component
/// without a maximum counts as unbounded. O(s log s) comparisons of paths.
std::vector<double> saddleDeaths(std::span<const SaddleEnds> saddles,
                                 std::span<const LocalMaximum> maxima,
                                 std::span<const BentPath> boundaries, bool complete);

}  // namespace girth
