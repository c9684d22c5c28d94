// Exact geodesic distances from points of a surface, growing outward: the engine under everything.
//
// A window is a bundle of straight paths that cross one sequence of faces (window.h). Windows
// are pending at the halfedge through which they enter a face. When the queue gives the halfedge
// out, all that are pending there cross the face at once (crossing_kernel.h), and what leaves
// through the other two sides is pending at their twins. A path that bends does so at a saddle, or
// at a corner of the boundary; there new windows start, with the vertex as their root.
//
// Invariants
// - Every window stands for real paths: sigma + |root − x| is the length of a path of the surface
//   for each x that the window covers, and so is the distance noted for a vertex. Nothing is ever
//   too short.
// - A window, or part of one, is dropped only where a path over an end of its edge is strictly
//   shorter at every point of it (trimming.h). A prefix of a shortest path is itself shortest, so
//   no window that carries a shortest path is lost, up to the point where the path stops being
//   shortest. (The rule of Chen and Han 1990 and those of Xin and Wang 2009 about the ends of the
//   edge are special cases of this trimming. Like them it looks at vertices only, never at other
//   windows. Xin and Wang's rule about the corner opposite would save 4 to 9% of the windows, and
//   costs as much as it saves.)
// - The queue gives halfedges out in the order of the nearest point of their pending windows, up
//   to one bucket. When the frontier stands at r, every window with a point
//   nearer than r has entered its face, and every vertex nearer than r that geodesics can pass has
//   been settled: its distance is final, and where it is a saddle its windows are on their way.
//   Some windows cross early, together with the rest of their halfedge; what they pass on is real
//   all the same.
// - A straight line is a path only as far as its window covers it. Beside the window's end, the
//   length of a path to a point is that of the way round this end (Window::pathTo): where the end
//   is a vertex, the surface goes on otherwise than the window's faces do, and the straight line
//   can be shorter than every path by as much as it passes beside the vertex.
// - At a vertex the directions of all paths count that tie but for rounding (Spread): lengths tell
//   directions only to the root of their rounding, and the loop may go on from any of them.
// - If a vertex becomes nearer after it was settled (possible within one bucket) it is settled
//   again; what it sent out before is too long, but still real.
// - A face may be forgotten once its every point is nearer than the frontier and than some vertex:
//   no shortest path ends in it any more (Keep::Front). How far its points can be is known from its
//   corners when windows cross it; nothing is sent into it after it has been passed, since what
//   comes then comes too late. Memory for windows and their lists is then in proportion to the
//   front; besides there is what is known of each vertex, and one word a halfedge.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "geodesic/bucket_queue.h"
#include "geodesic/crossing_kernel.h"
#include "geodesic/goal.h"
#include "geodesic/unfolding.h"
#include "geodesic/window.h"
#include "geodesic/window_list.h"
#include "geodesic/window_table.h"

namespace girth::geodesic {

/// How the best known path reaches a vertex.
struct Arrival {
  enum class Way : std::uint8_t {
    None,
    Window,    ///< across a face, in `bundle`
    Edge,      ///< along an edge, from the vertex `before`
    Straight,  ///< within the face or along the edge of source number `before`
    Source,    ///< it is source number `before`
  };
  Way way{Way::None};
  /// Where the path comes in: `corner` starts at the vertex, and `towards`, a vector of its frame,
  /// points back along the path. Known once settled.
  Index corner{kNoIndex};
  Vec2 towards;
  /// Where it can go on, at a saddle inside the surface: from a face to another, counter-clockwise,
  /// each identified by its halfedge that starts at the vertex. Known once settled; kNoIndex
  /// elsewhere.
  Index onwardsFrom{kNoIndex}, onwardsTo{kNoIndex};
  Index before{kNoIndex};
  Bundle bundle;
};

/// How the best path ends at a point of a face: in a bundle, straight from a corner, or straight
/// from a source within the face.
struct PathEnd {
  double distance{std::numeric_limits<double>::infinity()};
  Bundle bundle;
  Index corner{kNoIndex};
  Index source{kNoIndex};
};

/// Which windows are kept after they have crossed their face.
enum class Keep : std::uint8_t {
  Nothing,     ///< distances of vertices are all that is wanted
  Front,       ///< windows of faces that the front has not yet passed
  Everything,  ///< all: paths can be traced
};

/// One propagation at a time; memory is kept between them and cleared in proportion to what was
/// touched. Lengths are in `unfolding.unit()`, vertices, halfedges and faces in its numbers.
class Propagation {
 public:
  /// `bucketWidth`: of the queue, in mean edge lengths, those of the sources' components where
  /// these are far shorter than most. It decides how much is done in what order, and nothing else.
  explicit Propagation(const Unfolding& unfolding, double bucketWidth = kBucketWidth);

  /// Grows from the sources until the surface is covered or `visitor` has seen enough:
  ///   bool visitor.enough(double frontier)  everything nearer than the frontier is known; stop?
  ///   void visitor.onCrossing(Index halfedge, std::uint32_t first, const CrossingResult& result)
  ///                                         windows `first`, … of the halfedge enter its face
  ///   void visitor.onVertex(Index vertex)   a vertex that geodesics can pass is settled
  ///   std::size_t visitor.effort()          what it has done itself, in windows, for the budget
  ///   bool visitor.interrupted()            stop at once? Asked in the midst of a bucket, too
  ///   void visitor.restart()                all of this begins anew, in narrower buckets: where
  ///   the
  ///                                         surface is far thinner than its edges are long, paths
  ///                                         wind round it within one
  /// Towards a `goal` only paths go on that may reach it in time. Distances are then those of real
  /// paths; those of paths that reach the goal in time are right.
  template <class Visitor>
  void run(std::span<const SurfacePoint> sources, Keep keep, Visitor& visitor,
           const Goal* goal = nullptr) {
    goal_ = goal;
    for (double narrowing = 1;; narrowing *= kNarrower) {
      start(sources, keep, narrowing, [&](Index vertex) { visitor.onVertex(vertex); });
      if (grow(visitor, narrowing > kNarrowest)) break;
      visitor.restart();
    }
    goal_ = nullptr;
  }

  const Unfolding& unfolding() const { return *unfolding_; }
  /// Length of the best path to a vertex; infinite where none is known.
  double distance(Index vertex) const { return distance_[vertex]; }
  const Arrival& arrival(Index vertex) const { return arrival_[vertex]; }
  /// Whether the best path to a vertex has gone on from it: only from those that geodesics can
  /// pass, and from sources.
  bool settled(Index vertex) const { return reach_[vertex].settled; }
  /// Whether the one window that has reached a vertex is the one of its best path.
  bool reachedOnce(Index vertex) const {
    return reach_[vertex].windows == 1 && arrival_[vertex].way == Arrival::Way::Window;
  }
  /// Direction at a settled vertex in which its path comes in.
  double arrivalDirection(Index vertex) const {
    return unfolding_->directionOf(arrival_[vertex].corner, arrival_[vertex].towards);
  }
  bool isSource(Index vertex) const { return arrival_[vertex].way == Arrival::Way::Source; }
  /// Whether a vertex is settled, and its path goes on straight in a direction. At a source any
  /// will do.
  bool passesStraight(Index vertex, double leaving) const;
  /// The vertices that a path has reached.
  const std::vector<Index>& reachedVertices() const { return reached_; }
  /// The halfedges that windows have reached, where their face may have no corner that was reached.
  const std::vector<Index>& reachedHalfedges() const { return lists_.touched(); }

  /// How many windows have entered the face through a halfedge and are kept; and one of them.
  std::uint32_t enteredCount(Index halfedge) const {
    return gone(lists_[halfedge]) ? 0 : lists_[halfedge].entered;
  }
  Window window(Index halfedge, std::uint32_t number) const {
    return lists_[halfedge].window(number);
  }
  /// Visits them all, the newest first, until `visit(const Window&, std::uint32_t number)` returns
  /// true; returns whether one did. In time proportional to their number, which asking for one
  /// after the other is not.
  template <class Visit>
  bool findEntered(Index halfedge, Visit visit) const {
    const WindowList& list = lists_[halfedge];
    if (gone(list)) return false;
    for (const WindowRun* run = list.newest; run != nullptr; run = run->older) {
      if (run->begin >= list.entered) continue;  // pending
      for (std::uint32_t i = run->count; i-- > 0;) {
        if (visit(run->window(i), run->begin + i)) return true;
      }
    }
    return false;
  }
  template <class Visit>
  void eachEntered(Index halfedge, Visit visit) const {
    findEntered(halfedge, [&](const Window& w, std::uint32_t) {
      visit(w);
      return false;
    });
  }
  /// Appends them by number; `windows` holds the first `known` already.
  void entered(Index halfedge, std::vector<Window>& windows, std::size_t known = 0) const;
  /// The numbers among which windows lie that reached the opposite corner: `first` to `second` − 1.
  std::pair<std::uint32_t, std::uint32_t> apexWindows(Index halfedge) const {
    const WindowList& list = lists_[halfedge];
    return gone(list) ? std::pair{0u, 0u} : std::pair{list.apexBegin, list.apexEnd};
  }
  /// Whether windows of the face have been forgotten.
  bool forgotten(Index face) const {
    return gone(lists_[3 * face]) || gone(lists_[3 * face + 1]) || gone(lists_[3 * face + 2]);
  }

  /// A source inside a face or on one of its sides, in the frame of the face's first halfedge.
  struct Origin {
    Index face;
    Vec2 place;
    Index source;
  };
  const std::vector<Origin>& origins() const { return origins_; }
  const SurfacePoint& source(Index number) const { return sources_[number]; }

  /// The shortest path to a point of a face, given in the frame of one of its halfedges, from all
  /// windows that entered the face, its corners, and sources within; exact where the frontier has
  /// passed the point and the face is not forgotten.
  PathEnd pathTo(Index halfedge, Vec2 point) const;

  /// Whether some path to a point of a face is shorter than a length; `by` becomes its window, if
  /// it has one. Quicker than `pathTo` where the distance itself does not matter.
  bool findNearer(Index halfedge, Vec2 point, double length, WindowNumber& by) const;
  /// Whether that of one window of the face is.
  bool isNearer(Index halfedge, Vec2 point, double length, WindowNumber window) const;

  /// No point of a face is farther than this, as its corners show.
  double farthestWithin(Index face) const { return farthestBehind(unfolding_->crossing(3 * face)); }

  /// Windows made and windows that crossed their face, in this propagation.
  std::size_t windowsCreated() const { return created_; }
  std::size_t windowsCrossed() const { return crossed_; }
  /// From now on no face is forgotten that has a point farther than this; infinite: the front alone
  /// decides. Until the next run.
  void keepBeyond(double distance) { keptBeyond_ = distance; }

  /// From now on windows enter only faces for which this is not 0; null: all. So distances are
  /// those of real paths, the shortest among those through these faces.
  void stayWithin(const std::uint8_t* band) { band_ = band; }

  /// `run` gives up when the windows that have crossed a face and the visitor's effort exceed this
  /// number; `gaveUp` is true then. Default: 2^26.
  void setBudget(std::size_t windows) { budget_ = windows; }
  /// Gives it room for all windows of a large surface, of which there are about n^1.5: more than
  /// most sources of a girth may take.
  void allowWholeSurface() {
    const double faces = unfolding_->mesh().faceCount();
    setBudget(std::max(budget_, static_cast<std::size_t>(faces * std::sqrt(faces))));
  }
  std::size_t budget() const { return budget_; }
  bool gaveUp() const { return gaveUp_; }
  /// How far everything is known.
  double frontier() const { return queue_.frontier(); }
  std::size_t memoryBytes() const;

 private:
  static constexpr double kBucketWidth = 0.25;
  static constexpr std::size_t kLookEvery = 4096;  // windows and items: some 0.1 ms
  // Windows for each vertex that has been reached. On usual surfaces a bucket holds a few.
  static constexpr std::size_t kMostInBucket = 256;
  static constexpr double kNarrower = 1.0 / 16, kNarrowest = 1e-12;
  static constexpr Index kVertexItem = 0x80000000u;

  /// Grows until there is an end; false: a bucket holds too much, and may be `divided`.
  template <class Visitor>
  bool grow(Visitor& visitor, bool divided) {
    std::size_t popped = 0, looked = 0, bucketBegin = 0;
    const auto isTooMuch = [&] { return gaveUp_ = crossed_ + visitor.effort() > budget_; };
    while (!queue_.empty()) {
      if (queue_.bucketDone()) {
        queue_.advance();
        if (visitor.enough(queue_.frontier())) return true;
        if (isTooMuch()) return true;
        if (pool_.grown()) forgetPassed();
        bucketBegin = crossed_;
      } else if (crossed_ + ++popped >= looked + kLookEvery) {
        looked = crossed_ + popped;
        if (visitor.interrupted() || isTooMuch()) return true;
        if (divided && crossed_ - bucketBegin > kLookEvery + kMostInBucket * reached_.size()) {
          return false;
        }
      }
      const Index item = queue_.pop();
      lookAhead();
      if ((item & kVertexItem) != 0) {
        const Index vertex = item & ~kVertexItem;
        if (reach_[vertex].settled) continue;
        settle(vertex);
        visitor.onVertex(vertex);
      } else if (lists_[item].bucket == queue_.current()) {
        const std::uint32_t first = lists_[item].entered;
        const CrossingResult result = crossFace(item);
        visitor.onCrossing(item, first, result);
        if (keep_ == Keep::Nothing) lists_.close(item);
      }
    }
    visitor.enough(std::numeric_limits<double>::infinity());
    return true;
  }

  template <class OnVertex>
  void start(std::span<const SurfacePoint> sources, Keep keep, double narrowing,
             OnVertex onVertex) {
    clear();
    keep_ = keep;
    sources_.assign(sources.begin(), sources.end());
    queue_.setWidth(narrowing * bucketWidth());
    for (Index i = 0; i < sources_.size(); ++i) startFrom(i);
    for (Index i = 0; i < sources_.size(); ++i) {
      if (sources_[i].kind == SurfacePoint::Kind::AtVertex) {
        settle(sources_[i].element);
        onVertex(sources_[i].element);
      }
    }
  }
  double bucketWidth() const;
  void lookAhead() const;
  void clear();
  void startFrom(Index source);
  void startWithinFace(Index source, Index halfedge);
  Arrival* reach(Index vertex, double distance);
  void awaitSettling(Index vertex);
  template <class Direction>
  void tie(Index vertex, double distance, Direction direction);
  double directionOfArrival(const Arrival& arrival) const;
  Spread spreadAt(Index vertex) const { return reach_[vertex].spread ? spread_[vertex] : Spread{}; }
  void reachByWindows(Index halfedge, std::uint32_t first, const CrossingResult& result);
  void reachAlong(Index halfedge);
  void reachAgainst(Index halfedge);
  CrossingResult crossFace(Index halfedge);
  /// Whether windows can go to a halfedge: not across a boundary, not out of the band, and not into
  /// a face that the front has passed, where no path can be shortest any more.
  bool takesWindows(Index halfedge) const {
    return halfedge != kNoIndex && !gone(lists_[halfedge]) &&
           (band_ == nullptr || band_[faceOfSide(halfedge)] != 0);
  }
  void receive(Index halfedge, WindowRun* run, double nearest);
  void send(Index halfedge, Vec2 root, double sigma, double gapFrom, double gapTo);
  void settle(Index vertex);
  void fanBehind(Index vertex);
  void sendAround(Index first, const Vec2* low, Index last, const Vec2* high);
  void sendThrough(Index halfedge, const Vec2* low, const Vec2* high);
  double farthestBehind(const Crossing& c) const;
  void forgetPassed();

  /// Whether the windows of a halfedge have been forgotten: the front has passed its face.
  bool gone(const WindowList& list) const { return list.farthest < passed_; }

  /// The members of vertices that are read most often, small enough for the cache.
  struct Reach {
    bool settled{false};
    std::uint8_t windows{0};  // how many have reached it, nearest or not; counted up to kMany
    bool spread{false};       // whether paths that tie come in from several directions

    static constexpr std::uint8_t kMany = 2;
  };

  const Unfolding* unfolding_;
  CrossingKernel kernel_;
  double widthInEdges_;
  BucketQueue queue_;
  WindowPool pool_;
  Keep keep_{Keep::Everything};
  std::vector<SurfacePoint> sources_;
  std::vector<Origin> origins_;
  std::vector<double> distance_;       // by vertex
  std::vector<Reach> reach_;           // by vertex
  std::vector<Arrival> arrival_;       // by vertex
  std::vector<Spread> spread_;         // by vertex; valid where `reach_` says so
  WindowTable lists_;                  // by halfedge
  std::vector<Index> reached_;         // vertices to clear
  std::vector<Index> open_;            // vertices that the frontier may not have passed
  float passed_{0};                    // windows nearer than this are needed no longer
  const std::uint8_t* band_{nullptr};  // faces that windows enter; null: all
  const Goal* goal_{nullptr};          // the goal of all paths of a run; null: none
  double keptBeyond_{std::numeric_limits<double>::infinity()};  // but farther ones are
  std::size_t created_{0}, crossed_{0};
  std::size_t budget_{std::size_t{1} << 26};
  bool gaveUp_{false};
};

}  // namespace girth::geodesic
