#include "girth/refined_girth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <numeric>
#include <span>
#include <utility>

#include "geodesic/unfolding.h"
#include "girth/carried_loops.h"
#include "girth/face_band.h"
#include "girth/parallel.h"
#include "girth/remesh.h"
#include "girth/solver_factory.h"
#include "girth/transfer.h"
#include "idle_pool.h"
#include "part_of_work.h"
#include "random.h"

namespace girth {

using geodesic::Crossing;
using geodesic::Unfolding;

std::string_view toString(GirthState state) {
  constexpr std::array<std::string_view, 3> names{"proved", "consistent", "suspect"};
  return names[static_cast<std::size_t>(state)];
}

Index RefinedGirth::count(GirthState state) const {
  return static_cast<Index>(std::count(states.begin(), states.end(), state));
}

namespace {

/// Surfaces of fewer triangles are computed exactly as a whole.
constexpr Index kFewFaces = 2'000;
/// Rings of faces round the loop of a neighbour, and round one that was carried from the coarse
/// surface.
constexpr int kRings = 2, kCarriedRings = 3;
/// The girth is no less than such a share of the coarse girth around.
constexpr double kCoarseAtLeast = 0.93;
/// How often a band is laid anew round a loop that reaches its rim.
constexpr int kMostBands = 4;
/// Lengths that differ by less, as shares, are equal.
constexpr double kSame = 1e-9;
/// The same for the audit.
constexpr double kAuditSame = 1e-6;
/// Exact values take at most so many times the windows of what was done before: about as long.
constexpr std::size_t kMostExact = 2;
/// Vertices that are computed exactly at a time, before the work is added up.
constexpr std::size_t kExactAtATime = 64;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// What is known of a vertex.
struct Known {
  double length{kNone};  // in model units
  LoopKind kind{LoopKind::Unresolved};
  bool isProved{false};
  bool isDoubted{false};     // and so is to be computed exactly
  std::vector<Index> faces;  // of its loop, in rising order

  bool isThere() const { return !std::isnan(length); }
};

bool isSame(double a, double b) { return std::fabs(a - b) <= kSame * b; }

/// What a thread works with.
struct Scratch {
  explicit Scratch(const std::shared_ptr<const Unfolding>& unfolding)
      : solver(SolverFactory::onUnfolding(unfolding)), band(*unfolding) {}
  GirthSolver solver;
  FaceBand band;
};

class Refinement {
 public:
  Refinement(const SurfaceMesh& mesh, const RefinedOptions& options,
             const ExecutionContext& context)
      : mesh_(mesh),
        options_(options),
        context_(context),
        unfolding_(std::make_shared<const Unfolding>(mesh)),
        known_(mesh.vertexCount()) {}

  Result<RefinedGirth> run() {
    if (mesh_.faceCount() < kFewFaces) {
      computeAll();
    } else {
      if (auto error = seed()) return *std::move(error);
      spread();
      prove();
    }
    audit();
    if (context_.cancelled()) return makeError(ErrorCode::Cancelled, -1, "cancelled");
    collect();
    if (context_.onProgress) context_.onProgress(1);
    return std::move(result_);
  }

 private:
  // Shares of the progress that the steps end at.
  static constexpr double kCoarse = 0.05, kSeeded = 0.15, kSpread = 0.7, kProved = 0.9;

  const Unfolding& unfolding() const { return *unfolding_; }

  /// The exact girth of every vertex: there are few.
  void computeAll() {
    std::vector<Index> all(known_.size());
    std::iota(all.begin(), all.end(), Index{0});
    makeExact(all, partOf(context_, 0, kProved));
  }

  /// The loops of the coarse surface, each in a band of the fine one.
  std::optional<Error> seed() {
    RemeshOptions options;
    options.faces = std::clamp(options_.coarseFaces, Index{4}, mesh_.faceCount() / 4);
    const ExecutionContext remeshing = partOf(context_, 0, kCoarse);
    auto coarse = remesh(mesh_, options, remeshing);
    if (!coarse) return coarse.error();
    result_.coarseFaces = coarse.value().mesh.faceCount();
    const ExecutionContext carrying = partOf(context_, kCoarse, (kCoarse + kSeeded) / 2);
    const auto girth = carriedGirth(coarse.value().mesh, unfolding(), carrying);
    if (!girth) return girth.error();
    setFloor(coarse.value().mesh, girth.value().lengths);
    const ExecutionContext searching = partOf(context_, (kCoarse + kSeeded) / 2, kSeeded);
    const std::vector<CarriedLoop>& carried = girth.value().loops;
    eachOf(carried.size(), searching, [&](std::size_t i, Scratch& scratch) {
      scratch.band.clear();
      scratch.band.add(carried[i].faces);
      scratch.band.addAround(carried[i].vertex);
      scratch.band.grow(kCarriedRings);
      settle(carried[i].vertex, scratch, known_[carried[i].vertex]);
    });
    for (const CarriedLoop& loop : carried) {
      if (known_[loop.vertex].isThere()) changed_.push_back(loop.vertex);
    }
    return std::nullopt;
  }

  /// What is far below the coarse girth around is no loop of which the halves are shortest.
  void setFloor(const SurfaceMesh& coarse, const std::vector<double>& lengths) {
    // Of each coarse vertex the least value within two edges: the girth jumps, and where it does is
    // known to within an edge.
    std::vector<double> least = lengths;
    for (int ring = 0; ring < 2; ++ring) {
      const std::vector<double> before = least;
      for (const Face face : coarse.faces()) {
        const auto corners = coarse.faceVertices(face);
        for (const Vertex to : corners) {
          for (const Vertex from : corners) least[to] = std::min(least[to], before[from]);
        }
      }
    }
    const std::vector<Vertex> nearest = nearestVertices(coarse, nearestPoints(coarse, mesh_));
    floor_.resize(known_.size());
    for (Index v = 0; v < known_.size(); ++v) {
      floor_[v] = kCoarseAtLeast * least[nearest[unfolding().vertexInMesh(v)]];
    }
  }

  /// From neighbour to neighbour, until no loop becomes shorter.
  void spread() {
    std::size_t reached = changed_.size();
    while (!changed_.empty() && !context_.cancelled()) {
      const std::vector<Beside> besides = besidesOf(changed_);
      std::vector<Known> found(besides.size());
      eachOf(besides.size(), silent(),
             [&](std::size_t i, Scratch& scratch) { search(besides[i], scratch, found[i]); });
      changed_.clear();
      for (std::size_t i = 0; i < besides.size(); ++i) {
        if (!found[i].isThere()) continue;
        Known& known = known_[besides[i].vertex];
        reached += known.isThere() ? 0 : 1;
        known = std::move(found[i]);
        changed_.push_back(besides[i].vertex);
      }
      const double share = static_cast<double>(reached) / static_cast<double>(known_.size());
      report(kSeeded + (kSpread - kSeeded) * share);
    }
  }

  /// A vertex beside others whose loops have changed.
  struct Beside {
    Index vertex;
    std::vector<Index> changed;
  };

  std::vector<Beside> besidesOf(const std::vector<Index>& changed) const {
    std::vector<std::pair<Index, Index>> pairs;
    for (const Index vertex : changed) {
      eachNeighbour(vertex, [&](Index other, double) { pairs.emplace_back(other, vertex); });
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::vector<Beside> besides;
    for (const auto& [vertex, other] : pairs) {
      if (besides.empty() || besides.back().vertex != vertex) besides.push_back({vertex, {}});
      besides.back().changed.push_back(other);
    }
    return besides;
  }

  /// A shorter loop for a vertex from the bands of its neighbours; `found` stays empty without.
  void search(const Beside& beside, Scratch& scratch, Known& found) {
    const Known& own = known_[beside.vertex];
    FaceBand& band = scratch.band;
    if (own.isThere()) {
      // Loops within the band round its own have been looked at.
      band.clear();
      band.add(own.faces);
      band.grow(kRings);
      if (std::all_of(beside.changed.begin(), beside.changed.end(),
                      [&](Index other) { return band.hasAll(known_[other].faces); })) {
        return;
      }
    }
    band.clear();
    for (const Index other : beside.changed) band.add(known_[other].faces);
    band.addAround(beside.vertex);
    band.grow(kRings);
    found.length = own.length;
    settle(beside.vertex, scratch, found);
    if (isSame(found.length, own.length)) found.length = kNone;
  }

  /// The shortest loop in a band, and then in one round that loop where it reaches the rim; into
  /// `known`, if it is shorter.
  void settle(Index vertex, Scratch& scratch, Known& known) {
    for (int bands = 0; bands < kMostBands; ++bands) {
      const auto loop = loopWithin(vertex, scratch);
      if (!loop || loop->length >= known.length * (1 - kSame)) return;
      if (loop->length < floor_[vertex]) return;
      take(*loop, known);
      if (!scratch.band.reachesRim(known.faces)) return;
      scratch.band.clear();
      scratch.band.add(known.faces);
      scratch.band.grow(kRings);
    }
  }

  std::optional<GirthLoop> loopWithin(Index vertex, Scratch& scratch) {
    auto loop = SolverFactory::loopWithin(scratch.solver, Vertex(unfolding().vertexInMesh(vertex)),
                                          scratch.band.data(), context_.ofOneThread());
    const SearchStatistics cost = scratch.solver.statistics();
    const std::lock_guard lock(mutex_);
    result_.field.statistics += cost;
    return loop;
  }

  void take(const GirthLoop& loop, Known& known) const {
    known.length = loop.length;
    known.kind = loop.kind;
    known.faces = loop.kind == LoopKind::Loop ? facesOf(unfolding(), loop) : std::vector<Index>{};
  }

  /// Vertices that are still contradicted, or have no loop, exactly, and their neighbours where
  /// that changes them, within bounds. What is left is suspect.
  void prove() {
    const std::size_t most = kMostExact * result_.field.statistics.windowsCreated;
    std::size_t done = 0;
    std::vector<Index> queue = contradicted();
    std::erase_if(queue, [&](Index v) { return known_[v].isProved; });
    for (const Index v : queue) known_[v].isDoubted = true;
    while (!queue.empty() && done < most && !context_.cancelled()) {
      const std::size_t count = std::min(queue.size(), kExactAtATime);
      const std::vector<Index> some(queue.begin(),
                                    queue.begin() + static_cast<std::ptrdiff_t>(count));
      queue.erase(queue.begin(), queue.begin() + static_cast<std::ptrdiff_t>(count));
      std::vector<double> before;
      for (const Index v : some) before.push_back(known_[v].length);
      const std::size_t windows = result_.field.statistics.windowsCreated;
      makeExact(some, silent());
      done += result_.field.statistics.windowsCreated - windows;
      for (std::size_t i = 0; i < some.size(); ++i) {
        if (isSame(before[i], known_[some[i]].length)) continue;
        eachNeighbour(some[i], [&](Index other, double) {
          if (known_[other].isProved) return;
          if (!known_[other].isDoubted) queue.push_back(other);
          known_[other].isDoubted = true;
        });
      }
      report(kSpread + (kProved - kSpread) *
                           std::min(1.0, static_cast<double>(done) / static_cast<double>(most)));
    }
    report(kProved);
  }

  void makeExact(const std::vector<Index>& vertices, const ExecutionContext& context) {
    eachOf(vertices.size(), context, [&](std::size_t i, Scratch& scratch) {
      const Vertex vertex(unfolding().vertexInMesh(vertices[i]));
      const auto value = scratch.solver.value(vertex, context_.ofOneThread());
      if (!value) return;  // cancelled
      Known& known = known_[vertices[i]];
      known.isProved = value.value().kind != LoopKind::Unresolved;
      if (known.isProved || !known.isThere()) {
        known.kind = value.value().kind;
        known.length = value.value().length;
      }
      const SearchStatistics cost = scratch.solver.statistics();
      const std::lock_guard lock(mutex_);
      result_.field.statistics += cost;
    });
  }

  /// Vertices drawn at random, compared with exact values, which they keep.
  void audit() {
    std::vector<Index> drawn(known_.size());
    std::iota(drawn.begin(), drawn.end(), Index{0});
    Random random(options_.seed);
    const std::size_t count = std::min<std::size_t>(options_.audit, drawn.size());
    for (std::size_t i = 0; i < count; ++i) {
      const auto rest = static_cast<double>(drawn.size() - i);
      std::swap(drawn[i], drawn[i + static_cast<std::size_t>(random() * rest)]);
    }
    drawn.resize(count);
    std::vector<double> before;
    for (const Index v : drawn) before.push_back(known_[v].length);
    makeExact(drawn, partOf(context_, kProved, 1));
    std::vector<double> differences;
    GirthAudit& result = result_.audit;
    for (std::size_t i = 0; i < count; ++i) {
      const Known& known = known_[drawn[i]];
      if (!known.isProved) continue;
      const double difference = std::isnan(before[i]) ? 1 : std::fabs(before[i] / known.length - 1);
      differences.push_back(difference);
      if (difference <= kAuditSame) ++result.equal;
    }
    if (differences.empty()) return;
    std::sort(differences.begin(), differences.end());
    const std::size_t last = differences.size() - 1;
    result.vertices = static_cast<Index>(differences.size());
    result.median = differences[last / 2];
    result.percentile95 = differences[std::min(last, differences.size() * 95 / 100)];
    result.greatest = differences[last];
    // Wilson's interval, for 95 %.
    constexpr double z = 1.959963984540054;
    const double n = result.vertices, share = result.equal / n;
    const double centre = (share + z * z / (2 * n)) / (1 + z * z / n);
    const double reach =
        z / (1 + z * z / n) * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
    result.atLeast = std::clamp(centre - reach, 0.0, share);
    result.atMost = std::clamp(centre + reach, share, 1.0);
  }

  void collect() {
    GirthField& field = result_.field;
    field.values.assign(known_.size(), kNone);
    field.kinds.assign(known_.size(), LoopKind::Unresolved);
    result_.states.assign(known_.size(), GirthState::Suspect);
    for (Index v = 0; v < known_.size(); ++v) {
      const Known& known = known_[v];
      const Index inMesh = unfolding().vertexInMesh(v);
      field.values[inMesh] = known.length;
      field.kinds[inMesh] = known.kind;
      if (known.isProved) {
        result_.states[inMesh] = GirthState::Proved;
      } else if (known.isThere() && known.kind == LoopKind::Loop && !known.isDoubted &&
                 !contradicts(v)) {
        result_.states[inMesh] = GirthState::Consistent;
      }
    }
    field.computed = known_.size();
  }

  std::vector<Index> contradicted() const {
    std::vector<Index> vertices;
    for (Index v = 0; v < known_.size(); ++v) {
      if (contradicts(v)) vertices.push_back(v);
    }
    return vertices;
  }

  /// Whether a vertex has no loop, or its neighbours' values cannot be true together with its own:
  /// but for jumps, the girth changes by at most twice the way.
  bool contradicts(Index vertex) const {
    const Known& own = known_[vertex];
    if (!own.isThere()) return true;
    bool result = false;
    eachNeighbour(vertex, [&](Index other, double length) {
      const double difference = std::fabs(known_[other].length - own.length);
      if (difference > 2 * length * (1 + kSame)) result = true;
    });
    return result;
  }

  /// Calls `visit(neighbour, length of the edge)`, twice for most.
  template <class Visit>
  void eachNeighbour(Index vertex, Visit visit) const {
    for (const Index h : unfolding().fan(vertex)) {
      const Crossing along = unfolding().crossing(h);
      visit(along.to(), along.length() * unfolding().unit());
      const Crossing back = unfolding().crossing(Unfolding::previous(h));
      visit(back.from(), back.length() * unfolding().unit());
    }
  }

  /// Calls `work(i, scratch)` for all numbers below `count`, on all threads.
  template <class Work>
  void eachOf(std::size_t count, const ExecutionContext& context, Work work) {
    constexpr std::size_t kGrain = 8;
    parallelFor(count, kGrain, context, [&](std::size_t begin, std::size_t end) {
      const auto makeScratch = [&] { return std::make_unique<Scratch>(unfolding_); };
      scratches_.use(makeScratch, [&](Scratch& scratch) {
        for (std::size_t i = begin; i < end && !context_.cancelled(); ++i) work(i, scratch);
      });
    });
  }
  /// The same threads, without progress.
  ExecutionContext silent() const { return {context_.threads, context_.cancel, {}}; }
  void report(double share) const {
    if (context_.onProgress) context_.onProgress(share);
  }

  const SurfaceMesh& mesh_;
  RefinedOptions options_;
  const ExecutionContext& context_;
  std::shared_ptr<const Unfolding> unfolding_;
  std::vector<Known> known_;   // in the numbers of the unfolding
  std::vector<double> floor_;  // shorter loops do not count, until all of the surface is searched
  std::vector<Index> changed_;
  RefinedGirth result_;
  std::mutex mutex_;  // for what it costs
  IdlePool<Scratch> scratches_;
};

}  // namespace

Result<RefinedGirth> refinedGirth(const SurfaceMesh& mesh, const RefinedOptions& options,
                                  const ExecutionContext& context) {
  if (options.coarseFaces < 4) {
    return makeError(ErrorCode::InvalidOption, -1, "a coarse surface has at least 4 triangles");
  }
  try {
    return Refinement(mesh, options, context).run();
  } catch (const std::bad_alloc&) {
    return makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory for all loops");
  }
}

}  // namespace girth
