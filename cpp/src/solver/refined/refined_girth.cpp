#include "girth/refined_girth.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "geodesic/unfolding.h"
#include "girth/parallel.h"
#include "girth/remesh.h"
#include "girth/transfer.h"
#include "girth/vertex_function.h"
#include "idle_pool.h"
#include "mesh/flat_vertices.h"
#include "mesh/shifted_paths.h"
#include "no_value.h"
#include "part_of_work.h"
#include "random.h"
#include "solver/refined/base_graph.h"
#include "solver/refined/carried_loops.h"
#include "solver/refined/face_set.h"
#include "solver/refined/girth_audit.h"
#include "solver/refined/known_loop.h"
#include "solver/refined/refined_bases.h"
#include "solver/refined/verification_queue.h"
#include "solver/search/loop_check.h"
#include "solver/solver_factory.h"

namespace girth {

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
/// Flat vertices are left out where that leaves no more than this share of the triangles.
constexpr double kLeanShare = 0.6;
/// Rings of faces round the loop of a neighbour, and round one that was carried from the coarse
/// surface.
constexpr int kRings = 2, kCarriedRings = 3;
/// The girth is no less than such a share of the coarse girth around.
constexpr double kCoarseAtLeast = 0.93;
/// How often a band is laid anew round a loop that reaches its rim.
constexpr int kMostBands = 4;
/// Exact values take at most so many times the windows of what was done before, or so many, some
/// minutes of one core: surfaces like spheres have no loops, and all values are exact.
constexpr double kMostExact = 3, kMostExactWindows = 1e10;
/// The share of that budget that exact values may take which only check others.
constexpr double kMostChecks = 0.15;
/// Vertices that are looked at in one go, before what follows from them spreads and the work is
/// added up.
constexpr std::size_t kAtATime = 64;
/// On surfaces of more triangles an exact search does not keep what it needs to draw the loop.
constexpr Index kMostFacesForLoops = 200'000;
/// Where flat vertices are left out, so many vertices of the audit are also computed with them.
constexpr std::size_t kAuditOnAllFaces = 8;

/// The memory that a thread works with.
struct Scratch {
  explicit Scratch(const std::shared_ptr<const Unfolding>& unfolding)
      : solver(SolverFactory::onUnfolding(unfolding)),
        check(SolverFactory::propagationOf(solver)),
        band(*unfolding) {}
  GirthSolver solver;
  LoopCheck check;  // with the memory of the solver
  FaceSet band;
  std::vector<bool> isRefuted;  // by base, while others are looked for
};

/// Loops are looked for on the ground: the surface, or the same without its flat vertices.
class Refinement {
 public:
  /// `lean`: the surface without its flat vertices; null: loops are looked for on `mesh`.
  Refinement(const SurfaceMesh& mesh, const LeanSurface* lean, const RefinedOptions& options,
             const ExecutionContext& context)
      : mesh_(mesh),
        ground_(lean != nullptr ? lean->mesh : mesh),
        isLean_(lean != nullptr),
        options_(options),
        context_(context),
        unfolding_(std::make_shared<const Unfolding>(ground_)),
        bases_(basesOn(*unfolding_, lean)),
        known_(bases_.onGround),
        refuted_(bases_.onGround, 0) {
    if (lean == nullptr) return;
    result_.leanFaces = ground_.faceCount();
    shifted_.emplace(mesh, *lean);
    if (shifted_->isEmpty()) shifted_.reset();
  }

  Result<RefinedGirth> run() {
    if (ground_.faceCount() < kFewFaces) {
      stage_ = partOf(context_, 0, kProved);
      computeAll();
    } else {
      if (auto error = computeOnGround()) return *std::move(error);
      if (isLean_) computeFlatBases();
    }
    stage_ = partOf(context_, kProved, 1);
    audit();
    if (context_.cancelled()) return makeError(ErrorCode::Cancelled, -1, "cancelled");
    collect();
    if (context_.onProgress) context_.onProgress(1);
    return std::move(result_);
  }

 private:
  // Shares of the whole progress that the stages end at.
  static constexpr double kGround = 0.3, kProved = 0.9;
  // Shares of a stage's progress that its steps end at.
  static constexpr double kCoarse = 0.05, kSeeded = 0.15, kSpread = 0.75;

  const Unfolding& unfolding() const { return *unfolding_; }

  /// The exact girth at every base: the ground is small.
  void computeAll() {
    graph_ = BaseGraph(mesh_, bases_.ofVertices());
    known_.resize(bases_.places.size());
    std::vector<Index> all(known_.size());
    std::iota(all.begin(), all.end(), Index{0});
    makeExact(all, stage_);
  }

  std::optional<Error> computeOnGround() {
    stage_ = partOf(context_, 0, isLean_ ? kGround : kProved);
    std::vector<Index> baseOf(bases_.onGround);
    for (Index base = 0; base < baseOf.size(); ++base)
      baseOf[unfolding().vertexInMesh(base)] = base;
    graph_ = BaseGraph(ground_, baseOf);
    if (auto error = seed()) return error;
    spread(kSeeded, kSpread);
    prove(ground_, baseOf);
    return std::nullopt;
  }

  /// Flat vertices, beginning at what is known of the corners of their faces.
  void computeFlatBases() {
    stage_ = partOf(context_, kGround, kProved);
    const std::vector<Index> baseOf = bases_.ofVertices();
    graph_ = BaseGraph(mesh_, baseOf);
    known_.resize(bases_.places.size());
    refuted_.resize(bases_.places.size(), 0);
    floor_.resize(bases_.places.size());
    for (Index base = bases_.onGround; base < floor_.size(); ++base) {
      const Index face = faceOf(base);
      floor_[base] = std::numeric_limits<double>::infinity();
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        floor_[base] = std::min(floor_[base], floor_[unfolding().crossing(h).from()]);
      }
    }
    for (Index base = 0; base < bases_.onGround; ++base) {
      if (!known_[base].faces.empty()) changed_.push_back(base);
    }
    spread(0, kSpread);
    prove(mesh_, baseOf);
  }

  /// A face that a flat vertex lies in; of two, when it lies on their edge, either.
  Index faceOf(Index base) const {
    return faceOfSide(unfolding().home(unfolding().fromMesh(bases_.places[base])));
  }

  /// The loops of the coarse surface, each in a band of the ground.
  std::optional<Error> seed() {
    RemeshOptions options;
    options.faces = std::clamp(options_.coarseFaces, Index{4}, ground_.faceCount() / 4);
    const ExecutionContext remeshing = partOf(stage_, 0, kCoarse);
    auto coarse = remesh(ground_, options, remeshing);
    if (!coarse) return coarse.error();
    result_.coarseFaces = coarse.value().mesh.faceCount();
    const ExecutionContext carrying = partOf(stage_, kCoarse, (kCoarse + kSeeded) / 2);
    const auto girth = carriedGirth(coarse.value().mesh, unfolding(), carrying);
    if (!girth) return girth.error();
    setFloor(coarse.value().mesh, girth.value().lengths);
    const ExecutionContext searching = partOf(stage_, (kCoarse + kSeeded) / 2, kSeeded);
    const std::vector<CarriedLoop>& carried = girth.value().loops;
    eachOf(carried.size(), searching, [&](std::size_t i, Scratch& scratch) {
      scratch.band.clear();
      scratch.band.add(carried[i].faces);
      scratch.band.addAround(carried[i].vertex);
      scratch.band.grow(kCarriedRings);
      settle(carried[i].vertex, floor_[carried[i].vertex], scratch, known_[carried[i].vertex]);
    });
    for (const CarriedLoop& loop : carried) {
      if (known_[loop.vertex].isThere()) changed_.push_back(loop.vertex);
    }
    return std::nullopt;
  }

  /// Sets the floor: a loop far below the coarse girth around has no halves that are shortest
  /// paths.
  void setFloor(const SurfaceMesh& coarse, const std::vector<double>& lengths) {
    // The least value within two edges of each coarse vertex: the girth jumps, and where it does is
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
    const std::vector<Vertex> nearest = nearestVertices(coarse, nearestPoints(coarse, ground_));
    floor_.resize(bases_.onGround);
    for (Index v = 0; v < bases_.onGround; ++v) {
      floor_[v] = kCoarseAtLeast * least[nearest[unfolding().vertexInMesh(v)]];
    }
  }

  /// From neighbour to neighbour, from the bases that have changed on, until no loop becomes
  /// shorter. Reports from `begin` to `end` of the stage, where they differ. Returns the bases at
  /// which it did.
  std::vector<Index> spread(double begin, double end) {
    std::vector<Index> all;
    const bool isReported = begin < end;
    std::size_t reached = 0;
    if (isReported) {
      reached = static_cast<std::size_t>(std::count_if(
          known_.begin(), known_.end(), [](const KnownLoop& k) { return k.isThere(); }));
    }
    while (!changed_.empty() && !context_.cancelled()) {
      const std::vector<Beside> besides = besidesOf(changed_);
      std::vector<KnownLoop> found(besides.size());
      eachOf(besides.size(), silent(),
             [&](std::size_t i, Scratch& scratch) { search(besides[i], scratch, found[i]); });
      changed_.clear();
      for (std::size_t i = 0; i < besides.size(); ++i) {
        if (!found[i].isThere()) continue;
        KnownLoop& known = known_[besides[i].base];
        reached += known.isThere() ? 0 : 1;
        known = std::move(found[i]);
        changed_.push_back(besides[i].base);
      }
      all.insert(all.end(), changed_.begin(), changed_.end());
      const double share = static_cast<double>(reached) / static_cast<double>(known_.size());
      if (isReported) report(begin + (end - begin) * share);
    }
    return all;
  }

  /// A base beside others whose loops have changed.
  struct Beside {
    Index base;
    std::vector<Neighbour> changed;
  };

  std::vector<Beside> besidesOf(const std::vector<Index>& changed) const {
    std::vector<std::pair<Index, Neighbour>> pairs;
    for (const Index base : changed) {
      for (const Neighbour& other : graph_.neighbours(base)) {
        if (!known_[other.base].isProved) pairs.push_back({other.base, {base, other.distance}});
      }
    }
    std::sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first < b.first : a.second.base < b.second.base;
    });
    std::vector<Beside> besides;
    for (const auto& [base, other] : pairs) {
      if (besides.empty() || besides.back().base != base) besides.push_back({base, {}});
      besides.back().changed.push_back(other);
    }
    return besides;
  }

  /// A shorter loop for a base from the bands of its neighbours; `found` stays empty without.
  void search(Beside beside, Scratch& scratch, KnownLoop& found) {
    const KnownLoop& own = known_[beside.base];
    FaceSet& band = scratch.band;
    if (own.isThere()) {
      leaveOutNoGain(beside);
      if (beside.changed.empty()) return;
      // Loops within the band round its own have been looked at.
      band.clear();
      band.add(own.faces);
      band.grow(kRings);
      if (std::all_of(beside.changed.begin(), beside.changed.end(), [&](const Neighbour& other) {
            return band.hasAll(known_[other.base].faces);
          })) {
        return;
      }
    }
    band.clear();
    double floor = floor_[beside.base];
    for (const Neighbour& other : beside.changed) {
      const KnownLoop& known = known_[other.base];
      band.add(known.faces);
      // The loop beside one that is proved may be as short, but for the way there and back.
      if (known.isProved || known.isLow) {
        floor = std::min(floor, (known.length - 2 * other.distance) * (1 - kSameLength));
      }
    }
    floor = std::max(floor, refuted_[beside.base]);
    addAround(beside.base, band);
    band.grow(kRings);
    found.length = own.length;
    settle(beside.base, floor, scratch, found);
    if (isSameLength(found.length, own.length)) found.length = kNoValue;
  }

  /// Leaves out neighbours that have changed and whose loops cannot be shorter at the base. A value
  /// that is proved counts always: it may lower the floor.
  void leaveOutNoGain(Beside& beside) const {
    const auto positionOfBase = [&](Index base) {
      return mesh_.position(Vertex(bases_.vertices[base]));
    };
    const Vec3 place = positionOfBase(beside.base);
    std::erase_if(beside.changed, [&](const Neighbour& other) {
      const KnownLoop& loop = known_[other.base];
      return !loop.isProved &&
             isNoGain(known_[beside.base], loop, place - positionOfBase(other.base));
    });
  }

  void addAround(Index base, FaceSet& band) const {
    if (base < bases_.onGround) {
      band.addAround(base);
    } else {
      band.add(faceOf(base));
    }
  }

  /// The shortest loop in a band, and then in one round that loop where it reaches the rim; into
  /// `known`, if it is shorter, but not below `floor`.
  void settle(Index base, double floor, Scratch& scratch, KnownLoop& known) {
    for (int bands = 0; bands < kMostBands; ++bands) {
      const auto loop = loopWithin(base, scratch);
      if (!loop || loop->length >= known.length * (1 - kSameLength)) return;
      if (loop->length < floor) return;
      take(base, *loop, known);
      known.isLow = known.length < floor_[base];
      if (!scratch.band.reachesRim(known.faces)) return;
      scratch.band.clear();
      scratch.band.add(known.faces);
      scratch.band.grow(kRings);
    }
  }

  double excessOf(Index base, const GirthLoop& loop) const {
    return shifted_ ? shifted_->excess(Vertex(bases_.vertices[base]), loop.points) : 0;
  }

  std::optional<GirthLoop> loopWithin(Index base, Scratch& scratch) {
    auto loop = SolverFactory::loopWithin(scratch.solver, bases_.places[base], scratch.band.data(),
                                          context_.ofOneThread());
    count(scratch.solver.statistics());
    return loop;
  }

  void take(Index base, const GirthLoop& loop, KnownLoop& known) const {
    known.length = loop.length;
    known.excess = excessOf(base, loop);
    known.kind = loop.kind;
    known.stands = false;
    known.faces = loop.kind == LoopKind::Loop ? facesOf(unfolding(), loop) : std::vector<Index>{};
    known.middle = loop.midpoint;
    known.pull = pullOf(ground_, loop);
  }

  Question question(Index base) const { return questionAt(base, known_, graph_); }

  /// Proves values that contradict those of neighbours: first whether the short loop of two
  /// stands, then, exactly, what the long one is, and what has no loop. Then some bases evenly
  /// spread over the surface, exactly, since a region may be wrong as a whole without a
  /// contradiction. Within bounds; what is left is suspect. `mesh`: whose vertices the bases are.
  void prove(const SurfaceMesh& mesh, const std::vector<Index>& baseOf) {
    const auto before = static_cast<double>(windows());
    const double most = std::max(kMostExact * before, kMostExactWindows);
    VerificationQueue queue(known_.size());
    const auto report = [&] {
      const double share = std::min(1.0, (static_cast<double>(windows()) - before) / most);
      this->report(kSpread + (1 - kSpread) * share);
    };
    const auto settleAll = [&] {
      while (!queue.empty() && static_cast<double>(windows()) - before < most &&
             !context_.cancelled()) {
        settleSome(queue);
        report();
      }
    };
    for (Index base = 0; base < known_.size(); ++base) enqueue(base, queue);
    settleAll();
    const std::vector<Vertex> order = coarseToFineOrder(mesh, 1);
    const double settled = static_cast<double>(windows());
    double checks = 0;
    for (std::size_t i = 0; i < order.size() && checks < kMostChecks * settled;) {
      std::vector<Index> some;
      for (; i < order.size() && some.size() < kAtATime; ++i) {
        const Index base = baseOf[order[i]];
        if (!known_[base].isProved) some.push_back(base);
      }
      const auto start = static_cast<double>(windows());
      settleExactly(some, queue);
      checks += static_cast<double>(windows()) - start;
      settleAll();
      report();
      if (context_.cancelled()) return;
    }
    this->report(1);
  }

  /// Adds a base to the queue, if there is a question.
  void enqueue(Index base, VerificationQueue& queue) const {
    if (question(base) != Question::None) queue.add(base, known_[base].length);
  }
  void enqueueAround(Index base, VerificationQueue& queue) const {
    enqueue(base, queue);
    for (const Neighbour& other : graph_.neighbours(base)) enqueue(other.base, queue);
  }

  void settleSome(VerificationQueue& queue) {
    std::vector<Index> asked, exact;
    // Loops that have spread meanwhile may have put an end to a question.
    for (const Index base : queue.take(kAtATime, graph_, [&](Index candidate) {
           return question(candidate) != Question::None;
         })) {
      (question(base) == Question::DoesItStand ? asked : exact).push_back(base);
    }
    settleByAsking(asked, queue);
    settleExactly(exact, queue);
  }

  /// The answer about a loop.
  struct Answer {
    bool stands{false};
    std::vector<Index> refuted;  // it and others, where it does not
  };

  /// Whether the loops of some bases stand. Loops that fail are forgotten, together with those
  /// around that they refute, and there the longer loops beside them spread; what is as short
  /// beside them is doubted.
  void settleByAsking(const std::vector<Index>& bases, VerificationQueue& queue) {
    std::vector<Answer> answers(bases.size());
    eachOf(bases.size(), silent(),
           [&](std::size_t i, Scratch& scratch) { answers[i] = answerAt(bases[i], scratch); });
    if (context_.cancelled()) return;
    std::vector<std::pair<Index, double>> forgotten;
    for (std::size_t i = 0; i < bases.size(); ++i) {
      KnownLoop& own = known_[bases[i]];
      if (answers[i].stands) {
        own.stands = true;
        own.isDoubted = false;
        enqueueAround(bases[i], queue);
      }
      for (const Index base : answers[i].refuted) {
        const double length = known_[base].length;
        if (std::isnan(length)) continue;  // by another one
        forgotten.emplace_back(base, length);
        refuted_[base] = std::max(refuted_[base], length * (1 + 2 * kSameLength));
        known_[base] = {};
      }
    }
    for (const auto& [base, length] : forgotten) {
      for (const Neighbour& other : graph_.neighbours(base)) {
        KnownLoop& loop = known_[other.base];
        if (isContradicted(length, loop.length, other.distance)) {
          if (!loop.faces.empty()) changed_.push_back(other.base);
        } else if (loop.isThere() && !loop.isProved && !loop.stands) {
          loop.isDoubted = true;
          queue.add(other.base, loop.length);
        }
      }
    }
    std::sort(changed_.begin(), changed_.end());
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
    for (const Index base : spread(0, 0)) enqueueAround(base, queue);
    for (const auto& [base, length] : forgotten) enqueue(base, queue);
  }

  Answer answerAt(Index base, Scratch& scratch) {
    const KnownLoop& own = known_[base];
    const auto stands =
        scratch.check.stands(bases_.places[base], own.length, own.middle, context_.ofOneThread());
    SearchStatistics cost;
    cost.windowsCreated = scratch.check.windows();
    count(cost);
    if (!stands) return {};
    if (*stands) return {true, {}};
    // From base to base, as long as loops are refuted.
    std::vector<Index> refuted{base};
    std::vector<double> away{0};
    std::vector<bool>& isRefuted = scratch.isRefuted;
    isRefuted.resize(known_.size());
    isRefuted[base] = true;
    for (std::size_t i = 0; i < refuted.size(); ++i) {
      for (const Neighbour& other : graph_.neighbours(refuted[i])) {
        const KnownLoop& loop = known_[other.base];
        if (isRefuted[other.base] || loop.isProved || loop.stands || loop.faces.empty()) continue;
        const double way = away[i] + other.distance;
        if (!scratch.check.refutes(way, loop.length, loop.middle)) continue;
        isRefuted[other.base] = true;
        refuted.push_back(other.base);
        away.push_back(way);
      }
    }
    for (const Index other : refuted) isRefuted[other] = false;
    return {false, std::move(refuted)};
  }

  /// The exact values of some bases, and what follows from them for others: what was missed
  /// spreads from there; where a loop was too short, those of the neighbours may be, too.
  void settleExactly(const std::vector<Index>& bases, VerificationQueue& queue) {
    std::vector<double> lengths;
    for (const Index base : bases) lengths.push_back(known_[base].length);
    makeExact(bases, silent());
    std::vector<Index> changed;
    for (std::size_t i = 0; i < bases.size(); ++i) {
      const KnownLoop& known = known_[bases[i]];
      if (!known.isProved || isSameLength(lengths[i], known.length)) continue;
      changed.push_back(bases[i]);
      if (!(known.length > lengths[i])) {
        if (!known.faces.empty()) changed_.push_back(bases[i]);
        continue;
      }
      for (const Neighbour& other : graph_.neighbours(bases[i])) {
        KnownLoop& loop = known_[other.base];
        if (loop.isProved || loop.stands) continue;
        loop.isDoubted = true;
        queue.add(other.base, loop.length);
      }
    }
    const std::vector<Index> spreadTo = spread(0, 0);
    changed.insert(changed.end(), spreadTo.begin(), spreadTo.end());
    for (const Index base : changed) enqueueAround(base, queue);
  }

  void makeExact(const std::vector<Index>& bases, const ExecutionContext& context) {
    // The loops of vertices of the ground are where flat vertices begin.
    const bool isBeginning = isLean_ && known_.size() == bases_.onGround;
    const bool withLoops = ground_.faceCount() <= kMostFacesForLoops;
    eachOf(bases.size(), context, [&](std::size_t i, Scratch& scratch) {
      const SurfacePoint& place = bases_.places[bases[i]];
      const auto value = scratch.solver.value(place, context_.ofOneThread());
      if (!value) return;  // cancelled
      count(scratch.solver.statistics());
      KnownLoop& known = known_[bases[i]];
      const bool isOther = !isSameLength(value.value().length, known.length);
      const bool isShorter = !(value.value().length > known.length);
      known.isProved = value.value().kind != LoopKind::Unresolved;
      if (!known.isProved && known.isThere()) return;
      known.kind = value.value().kind;
      known.length = value.value().length;
      if (!isOther) return;
      known.faces.clear();
      known.excess = 0;
      if (!withLoops || !(isShorter || isBeginning || shifted_)) return;
      const auto loop = scratch.solver.loop(place, context_.ofOneThread());
      if (!loop) return;
      count(scratch.solver.statistics());
      take(bases[i], loop.value(), known);
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
    for (const Index base : drawn) before.push_back(known_[base].value());
    const ExecutionContext onGround = partOf(stage_, 0, isLean_ ? 0.5 : 1);
    makeExact(drawn, onGround);
    if (isLean_) auditOnAllFaces(drawn);
    std::vector<double> found, exact;
    for (std::size_t i = 0; i < count; ++i) {
      if (!known_[drawn[i]].isProved) continue;
      found.push_back(before[i]);
      exact.push_back(known_[drawn[i]].value());
    }
    result_.audit = auditOf(found, exact);
  }

  /// The first of the drawn bases on the surface with its flat vertices.
  void auditOnAllFaces(const std::vector<Index>& drawn) {
    const auto all = std::make_shared<const Unfolding>(mesh_);
    const ExecutionContext context = partOf(stage_, 0.5, 1);
    const std::size_t count = std::min(drawn.size(), kAuditOnAllFaces);
    parallelFor(count, 1, context, [&](std::size_t begin, std::size_t end) {
      GirthSolver solver = SolverFactory::onUnfolding(all);
      for (std::size_t i = begin; i < end; ++i) {
        const auto value = solver.value(Vertex(bases_.vertices[drawn[i]]), context_.ofOneThread());
        if (!value) return;  // cancelled
        KnownLoop& known = known_[drawn[i]];
        if (value.value().kind == LoopKind::Unresolved) continue;
        known.length = value.value().length;
        known.excess = 0;
        this->count(solver.statistics());
      }
    });
  }

  void collect() {
    GirthField& field = result_.field;
    field.values.assign(known_.size(), kNoValue);
    field.kinds.assign(known_.size(), LoopKind::Unresolved);
    result_.states.assign(known_.size(), GirthState::Suspect);
    for (Index base = 0; base < known_.size(); ++base) {
      const KnownLoop& known = known_[base];
      const Index vertex = bases_.vertices[base];
      field.values[vertex] = known.value();
      field.kinds[vertex] = known.kind;
      if (known.isProved) {
        result_.states[vertex] = GirthState::Proved;
      } else if (question(base) == Question::None) {
        result_.states[vertex] = GirthState::Consistent;
      }
    }
    field.computed = known_.size();
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
  /// A context with the same threads, without progress.
  ExecutionContext silent() const { return {context_.threads, context_.cancel, {}}; }
  void report(double share) const {
    if (stage_.onProgress) stage_.onProgress(share);
  }

  std::size_t windows() const { return result_.field.statistics.windowsCreated; }
  void count(const SearchStatistics& cost) {
    const std::lock_guard lock(mutex_);
    result_.field.statistics += cost;
  }

  const SurfaceMesh& mesh_;
  const SurfaceMesh& ground_;
  bool isLean_;
  RefinedOptions options_;
  const ExecutionContext& context_;
  ExecutionContext stage_;                      // the part of the progress that runs
  std::shared_ptr<const Unfolding> unfolding_;  // unfolding of the ground
  RefinedBases bases_;
  std::optional<ShiftedPaths> shifted_;  // where flat vertices are a little off
  BaseGraph graph_;
  std::vector<KnownLoop> known_;  // by base
  std::vector<double> floor_;    // shorter loops do not count, until all of the surface is searched
  std::vector<double> refuted_;  // nor do loops that are no longer than one that does not stand
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
    if (mesh.faceCount() < kFewFaces) return Refinement(mesh, nullptr, options, context).run();
    for (const double rounding : {kRoundedDoubles, kRoundedSingles}) {
      const auto lean = withoutFlatVertices(mesh, rounding, context.ofOneThread());
      if (!lean) return lean.error();
      if (lean.value().mesh.faceCount() > kLeanShare * mesh.faceCount()) continue;
      return Refinement(mesh, &lean.value(), options, context).run();
    }
    return Refinement(mesh, nullptr, options, context).run();
  } catch (const std::bad_alloc&) {
    return makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory for all loops");
  }
}

}  // namespace girth
