// Closed curves drawn tight: from any closed curve to a closed geodesic that it can be moved to
// while it only gets shorter (Xin, He and Fu 2012, "Efficiently computing exact geodesic loops
// within finite steps"), and the bands of parallel geodesics around it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "girth/execution.h"
#include "girth/surface_point.h"
#include "loops/tight/strip.h"

namespace girth::loops {

/// The outcome for a curve.
enum class Tightened : std::uint8_t {
  Geodesic,    ///< a closed geodesic: at every vertex each side within the surface has at least π
  Contracted,  ///< a point: the curve bounds a disk that it slips off
  GaveUp,      ///< more steps than its size explains, as where rounding decides about them
};

/// A closed curve by the vertices that it passes and the edges that it crosses between: run i leads
/// from vertex i to the next, the last to the first. Numbers are those of the unfolding. Once it is
/// tight each run is straight, and it passes at least one vertex; but `tightenInPlace`, and loose
/// curves, may have one closed run alone.
struct TautLoop {
  std::vector<Index> vertices;
  std::vector<Run> runs;

  friend bool operator==(const TautLoop&, const TautLoop&) = default;
};

/// The curve through points in order (of the mesh; the last equals the first), each two neighbours
/// in one face. Nothing where they are not.
std::optional<TautLoop> looseLoop(const Unfolding& unfolding, std::span<const SurfacePoint> points);

/// Outcomes for curves, by how they ran on the way: a curve that comes to where another has been
/// ends as that one did. May be used by several threads at once; what it gives depends on the curve
/// alone, and not on what it was asked before. 48 bytes for each step that was made.
class TightenedBefore {
 public:
  /// 128 bits that stand for a loop in its canonical form.
  struct Key {
    std::uint64_t high{0}, low{0};
    friend bool operator==(const Key&, const Key&) = default;
  };
  static Key keyOf(const TautLoop& canonical);

  struct Outcome {
    Tightened kind{Tightened::Contracted};
    std::shared_ptr<const TautLoop> loop;  ///< the loop of a geodesic
    std::uint32_t steps{0};                ///< steps that lead to it
  };
  std::optional<Outcome> find(const Key& key) const;
  /// `way`: what a loop was on the way, in order.
  void add(const std::vector<Key>& way, Outcome end);

 private:
  struct Hash {
    std::size_t operator()(const Key& key) const { return static_cast<std::size_t>(key.low); }
  };
  mutable std::mutex mutex_;
  std::unordered_map<Key, Outcome, Hash> outcomes_;
};

/// Draws a curve tight, vertex by vertex; every step makes it shorter. Each step is linear in the
/// strip that it changes.
Tightened tighten(const Unfolding& unfolding, TautLoop& loop);

/// Draws a loop tight with the outcomes for other curves. The loop is canonical then.
Tightened tighten(const Unfolding& unfolding, TautLoop& loop, TightenedBefore& before);

/// Draws a curve tight, but leaves it where it closes straight within its strip, in the middle of
/// the strip: it is not moved on until it passes a vertex. `GaveUp`: also where it is cancelled.
Tightened tightenInPlace(const Unfolding& unfolding, TautLoop& loop,
                         const ExecutionContext& context);

/// One form of a loop, whatever vertex it is begun at and whichever way it runs.
TautLoop canonical(const Unfolding& unfolding, const TautLoop& loop);

/// Its length, in model units.
double lengthOf(const Unfolding& unfolding, const TautLoop& loop);

/// Its points, of the mesh, from its first vertex round to it.
std::vector<SurfacePoint> pointsOf(const Unfolding& unfolding, const TautLoop& loop);

/// The geodesics parallel to one.
struct Band {
  /// From one side to the other, in model units; 0 where there is none but the loop itself.
  double width{0};
  /// The one in the middle, as points of the mesh, the last equal to the first.
  std::vector<SurfacePoint> middle;
  /// The vertices of the mesh that the outermost two pass, in rising order.
  std::vector<Vertex> vertices;
  /// Where a side of the band can be pushed on, over a convex vertex, to what is shorter: that, not
  /// yet drawn tight. Then the geodesics are no neck.
  std::optional<TautLoop> shorter;
};

/// The band of a tight loop: all closed geodesics that it can be moved to without getting longer.
/// `area`: of the component, in squared model units, which no band exceeds.
Band bandOf(const Unfolding& unfolding, const TautLoop& loop, double area);

/// A curve drawn tight, and on to a neck, where it is pushed over convex vertices: canonical.
/// Nothing where it contracts. `area`: as of bandOf.
std::optional<TautLoop> neckFrom(const Unfolding& unfolding, std::span<const SurfacePoint> points,
                                 double area);

}  // namespace girth::loops
