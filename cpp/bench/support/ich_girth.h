// The reference implementation of the benchmarks: the paper's own algorithm, as the paper words it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "girth/girth_solver.h"
#include "girth/surface_mesh.h"

namespace girth::bench {

/// When windows are filtered.
enum class IchFilter : std::uint8_t {
  /// Before a window enters the queue, as Xin and Wang publish it.
  AtCreation,
  /// Only before a window is propagated, after its pairs have been tested: the reading of the paper
  /// that misses the fewest loops, and therefore also ends earlier.
  AtPropagation,
};

/// Algorithm 2 of the paper on top of the improved Chen–Han propagation (Xin and Wang, 'Improving
/// Chen and Han's algorithm on the discrete geodesic problem', ACM TOG 28(4), 2009): windows in a
/// heap, one split per angle, windows dropped that a vertex of their face makes useless; the search
/// ends once the radius has passed half of the best loop (4.3.1), pairs are formed only with
/// windows near the frontier (4.3.2), and a loop counts by Lemmas 4.1 and 4.2 read to the letter.
///
/// Where the paper leaves a choice, the one that finds more loops: a window is listed at its edge
/// as soon as it is made, and stays there, even if the filter stops it later, until condition 1 of
/// Lemma 4.2 deletes it. When the filter is asked is the caller's choice.
///
/// Read so, the lemmas are *not right* at every vertex: the filters drop windows that a loop needs,
/// and windows that survive form loops whose halves are not shortest. The benchmark counts these
/// vertices; the library itself proves every loop (GirthSolver).
///
/// Keeps its memory between calls, clears only what a call has touched, and recycles windows. The
/// mesh must outlive it.
class IchGirth {
 public:
  explicit IchGirth(const SurfaceMesh& mesh, IchFilter filter = IchFilter::AtCreation);
  ~IchGirth();
  IchGirth(const IchGirth&) = delete;
  IchGirth& operator=(const IchGirth&) = delete;

  /// The value that Algorithm 2 returns for a vertex. Where it finds no loop: twice the distance of
  /// the farthest vertex (the paper's farthest *point* can only lie a little beyond), `Antipodal`.
  GirthValue value(Index vertex);

  /// Exact distances from a vertex to all vertices, in model units; infinity in other components.
  /// Valid until the next call.
  std::span<const double> distances(Index source);

  /// Windows that the last call took from the queue and worked on.
  std::size_t windowCount() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace girth::bench
