#include "girth/girth_solver.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geodesic/corridor.h"
#include "geodesic/earlier_runs.h"
#include "geodesic/locate.h"
#include "geodesic/path_tracing.h"
#include "geodesic/propagation.h"
#include "geodesic/stop_at_distance.h"
#include "girth/barcode.h"
#include "infinity.h"
#include "solver/persistence/persistent_search.h"
#include "solver/search/farthest_point.h"
#include "solver/search/loop_search.h"
#include "solver/solver_factory.h"

namespace girth {

using geodesic::Keep;
using geodesic::Propagation;
using geodesic::samePoint;
using geodesic::Unfolding;

std::string_view toString(LoopKind kind) {
  switch (kind) {
    case LoopKind::Loop:
      return "loop";
    case LoopKind::Antipodal:
      return "antipodal";
    case LoopKind::Unresolved:
      break;
  }
  return "unresolved";
}

std::vector<Vec3> polyline(const SurfaceMesh& mesh, const GirthLoop& loop) {
  std::vector<Vec3> points(loop.points.size());
  std::transform(loop.points.begin(), loop.points.end(), points.begin(),
                 [&](const SurfacePoint& p) { return positionOf(mesh, p); });
  return points;
}

namespace {

/// A search for a loop that is known, among paths some of which have been left out: what is shorter
/// would have been refuted by one of those, or was found before it.
class KnownLoopSearch {
 public:
  KnownLoopSearch(LoopSearch& search, const Unfolding& unfolding, const LoopCandidate& known)
      : search_(&search),
        unfolding_(&unfolding),
        length_(known.length),
        middle_(placeOf(known)),
        near_(kNear * unfolding.unit() * length_ + geodesic::kTie * norm(middle_)) {}

  bool enough(double frontier) {
    while (search_->enough(frontier)) {
      if (search_->cancelled()) return true;
      const double length = search_->best().length;
      if (length > length_ * (1 + kSame)) return true;
      const double aside = norm(placeOf(search_->best()) - middle_);
      found_ = length >= length_ * (1 - kSame) && aside <= near_;
      if (found_) return true;
    }
    return false;
  }
  void onCrossing(Index halfedge, std::uint32_t first, const geodesic::CrossingResult& result) {
    search_->onCrossing(halfedge, first, result);
  }
  void onVertex(Index vertex) { search_->onVertex(vertex); }
  std::size_t effort() const { return search_->effort(); }
  bool interrupted() { return search_->interrupted(); }
  void restart() { search_->restart(); }
  bool found() const { return found_; }

 private:
  /// Lengths that differ by no more are the same, but for rounding; and midpoints by a share of the
  /// length.
  static constexpr double kSame = 1e-12, kNear = 1e-9;

  /// Its midpoint in space.
  Vec3 placeOf(const LoopCandidate& loop) const {
    const SurfacePoint middle = surfacePointAt(*unfolding_, loop.halfedge, loop.midpoint);
    return positionOf(unfolding_->mesh(), unfolding_->toMesh(middle));
  }

  LoopSearch* search_;
  const Unfolding* unfolding_;
  double length_;
  Vec3 middle_;
  double near_;
  bool found_{false};
};

}  // namespace

struct GirthSolver::State {
  std::shared_ptr<const Unfolding> unfolding;
  Propagation propagation;
  LoopSearch search;
  /// Where saddles are to last; made when first asked for.
  std::optional<PersistentSearch> persistent;
  double persistence{0};     // persistence of value and loop, in model units
  bool isPersistent{false};  // the last run
  geodesic::EarlierRuns earlier;
  /// `runLasting`, once a persistence is set. A program that sets none is linked without it.
  std::optional<Error> (State::*runPersistent)(const SurfacePoint&, Keep,
                                               const ExecutionContext&){nullptr};

  explicit State(std::shared_ptr<const Unfolding> shared)
      : unfolding(std::move(shared)), propagation(*unfolding), search(propagation) {}

  /// Propagates from a point until its loop is found or the surface is covered.
  std::optional<Error> run(const SurfacePoint& point, Keep keep, const ExecutionContext& context) {
    if (auto error = checkPersistence(persistence)) return error;
    isPersistent = persistence > 0;
    earlier = {};
    if (isPersistent) return (this->*runPersistent)(point, keep, context);
    const auto source = geodesic::locate(*unfolding, point);
    if (!source) return source.error();
    search.start(context.cancel);
    propagation.run(std::span(&source.value(), 1), keep, search);
    if (search.cancelled()) {
      return makeError(ErrorCode::Cancelled, point.element, "cancelled");
    }
    return std::nullopt;
  }

  /// Runs until a saddle is found that lasts as long as `persistence`.
  std::optional<Error> runLasting(const SurfacePoint& point, Keep keep,
                                  const ExecutionContext& context) {
    constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
    return runForSaddles(point, keep, persistence, kAll, false, context);
  }

  /// Runs until a saddle is found that lasts so long, or so many saddles have been.
  std::optional<Error> runForSaddles(const SurfacePoint& point, Keep keep, double atLeast,
                                     std::size_t mostSaddles, bool withDeaths,
                                     const ExecutionContext& context) {
    const auto source = geodesic::locate(*unfolding, point);
    if (!source) return source.error();
    if (!persistent) persistent.emplace(propagation, search);
    // A finite length stays one: a saddle that never dies lasts longer.
    constexpr double kGreatest = std::numeric_limits<double>::max();
    const double scaled =
        std::isinf(atLeast) ? atLeast : std::min(atLeast / unfolding->unit(), kGreatest);
    persistent->start(scaled, mostSaddles, withDeaths, kInfinity, context.cancel);
    propagation.run(std::span(&source.value(), 1), keep, *persistent);
    if (persistent->cancelled()) {
      return makeError(ErrorCode::Cancelled, point.element, "cancelled");
    }
    return std::nullopt;
  }

  /// SolverFactory::loopsUpTo.
  std::optional<LoopsUpTo> loopsUpTo(Vertex vertex, double length,
                                     const ExecutionContext& context) {
    const SurfacePoint source =
        geodesic::locate(*unfolding, SurfacePoint::atVertex(vertex)).value();
    if (!persistent) persistent.emplace(propagation, search);
    isPersistent = true;
    earlier = {};
    const bool keepsAll = unfolding->mesh().faceCount() <= geodesic::kMostFacesKept;
    persistent->start(kInfinity, std::numeric_limits<std::size_t>::max(), false,
                      length / 2 / unfolding->unit(), context.cancel);
    propagation.run(std::span(&source, 1), keepsAll ? Keep::Everything : Keep::Front, *persistent);
    if (persistent->cancelled()) return std::nullopt;
    LoopsUpTo result;
    result.length =
        std::min(length, inModelUnits(2 * std::min(propagation.frontier(), search.unjudged())));
    const std::vector<PersistentSearch::Saddle> saddles = persistent->saddles();
    for (const PersistentSearch::Saddle& saddle : saddles) {
      if (keepsAll) {
        result.loops.push_back(loopOf(saddle.loop));
      } else if (auto loop = loopAgain(source, saddle.loop, context)) {
        result.loops.push_back(*std::move(loop));
      } else if (context.cancelled()) {
        return std::nullopt;
      } else {
        result.length = std::min(result.length, inModelUnits(saddle.loop.length));
        break;
      }
    }
    return result;
  }

  /// The loop that was found; null: none.
  const LoopCandidate* found() const {
    if (!isPersistent) return search.found() ? &search.best() : nullptr;
    return persistent->found() ? &persistent->saddles()[persistent->decided() - 1].loop : nullptr;
  }
  /// Whether the budget was met: in the propagation, among the candidates, or among the maxima.
  bool gaveUp() const {
    return propagation.gaveUp() || (!search.found() && std::isfinite(search.unjudged())) ||
           (isPersistent && (persistent->gaveUp() || std::isfinite(search.unjudged())));
  }
  /// No loop is shorter than twice this: the frontier, the next candidate, or the saddle that was
  /// to be decided next.
  double reached() const {
    double reached = std::min(propagation.frontier(), search.unjudged());
    if (isPersistent && persistent->decided() < persistent->saddles().size()) {
      const LoopCandidate& next = persistent->saddles()[persistent->decided()].loop;
      reached = std::min(reached, next.length / 2);
    }
    return reached;
  }

  double inModelUnits(double length) const { return length * unfolding->unit(); }

  /// The farthest point, with what is left of the budget. Error: CANCELLED.
  Result<FarthestPoint> farthest(const ExecutionContext& context) const {
    const std::size_t done =
        propagation.windowsCrossed() + (isPersistent ? persistent->effort() : search.effort());
    const std::size_t left = propagation.budget() - std::min(done, propagation.budget());
    // Looking at a path into a face takes half as long as a window that crosses it.
    const FarthestPoint point = farthestPoint(propagation, 2 * left, context);
    if (!point.complete && context.cancelled()) {
      return makeError(ErrorCode::Cancelled, -1, "cancelled");
    }
    return point;
  }

  Result<GirthValue> value(const ExecutionContext& context) const {
    if (const LoopCandidate* best = found()) {
      const double length = inModelUnits(best->length);
      return GirthValue{length, LoopKind::Loop, length};
    }
    if (gaveUp()) {
      return GirthValue{inModelUnits(2 * reached()), LoopKind::Unresolved,
                        inModelUnits(2 * noPointIsFarther(propagation))};
    }
    const auto point = farthest(context);
    if (!point) return point.error();
    const double length = inModelUnits(2 * point.value().distance);
    if (point.value().complete) return GirthValue{length, LoopKind::Antipodal, length};
    return GirthValue{length, LoopKind::Unresolved, inModelUnits(2 * point.value().atMost)};
  }

  Result<GirthLoop> loop(const ExecutionContext& context) const {
    if (const LoopCandidate* best = found()) return loopOf(*best);
    if (gaveUp()) return unresolved(reached(), noPointIsFarther(propagation));
    const auto found = this->farthest(context);
    if (!found) return found.error();
    const FarthestPoint& farthest = found.value();
    if (!farthest.complete) return unresolved(farthest.distance, farthest.atMost);
    return antipodal(farthest);
  }

  /// To the farthest point and back, along a path that the last run has kept.
  GirthLoop antipodal(const FarthestPoint& farthest) const {
    GirthLoop result;
    result.base = propagation.source(0);
    result.length = result.atMost = inModelUnits(2 * farthest.distance);
    result.kind = LoopKind::Antipodal;
    result.midpoint = surfacePointAt(*unfolding, farthest.halfedge, farthest.point);
    std::vector<SurfacePoint> there;
    tracePath(propagation, propagation.pathTo(farthest.halfedge, farthest.point), farthest.halfedge,
              farthest.point, there);
    if (!samePoint(there.front(), result.midpoint)) there.insert(there.begin(), result.midpoint);
    join(there, there, result);
    return result;
  }

  /// A loop at a point that a run found without keeping what its points follow from: again, along
  /// paths to its midpoint alone. Nothing where the context was cancelled, or rounding decides.
  std::optional<GirthLoop> loopAgain(const SurfacePoint& source, const LoopCandidate& best,
                                     const ExecutionContext& context) {
    const double half = best.length / 2;
    const SurfacePoint middle = surfacePointAt(*unfolding, best.halfedge, best.midpoint);
    earlier.add(propagation);
    const auto goal = corridor(propagation, source, middle, half, context);
    if (!goal) return std::nullopt;
    search.start(context.cancel);
    KnownLoopSearch known(search, *unfolding, best);
    runTowards(*goal, source, known);
    if (!known.found()) return std::nullopt;
    return loopOf(search.best());
  }

  /// The loop where the last run has found none: a path to the farthest point. An error:
  /// CANCELLED.
  std::optional<Result<GirthLoop>> farthestAgain(const ExecutionContext& context) {
    const auto found = farthest(context);
    if (!found) return found.error();
    const FarthestPoint& point = found.value();
    if (!point.complete) return unresolved(point.distance, point.atMost);
    const SurfacePoint source = propagation.source(0);
    const SurfacePoint end = surfacePointAt(*unfolding, point.halfedge, point.point);
    earlier.add(propagation);
    const auto goal = corridor(propagation, source, end, point.distance, context);
    if (!goal) return std::nullopt;
    geodesic::StopAtDistance stop([&] { return point.distance; }, context);
    runTowards(*goal, source, stop);
    const double length = propagation.pathTo(point.halfedge, point.point).distance;
    if (stop.cancelled() || !(length <= point.distance * (1 + geodesic::kTie))) {
      return std::nullopt;
    }
    return antipodal(point);
  }

  /// Goes on with what may reach a goal, and keeps it.
  template <class Visitor>
  void runTowards(const geodesic::Goal& goal, const SurfacePoint& source, Visitor& visitor) {
    earlier.add(propagation);
    propagation.run(std::span(&source, 1), Keep::Everything, visitor, &goal);
  }

  /// A loop that was found, with its points.
  GirthLoop loopOf(const LoopCandidate& best) const {
    GirthLoop result;
    result.base = propagation.source(0);
    result.length = result.atMost = inModelUnits(best.length);
    result.kind = LoopKind::Loop;
    result.midpoint = surfacePointAt(*unfolding, best.halfedge, best.midpoint);
    std::vector<SurfacePoint> there, back;
    trace(best.there, best, there);
    trace(best.back, best, back);
    join(there, std::move(back), result);
    return result;
  }

  /// Joins the halves of a loop, which both run from its midpoint to the source, and numbers all of
  /// its points as the mesh does.
  void join(const std::vector<SurfacePoint>& there, std::vector<SurfacePoint> back,
            GirthLoop& result) const {
    // Where the midpoint is a vertex or turning point, both halves begin with it.
    if (back.size() > 1 && samePoint(there.front(), back.front())) back.erase(back.begin());
    result.points.assign(there.rbegin(), there.rend());
    result.points.insert(result.points.end(), back.begin(), back.end());
    result.angle = result.kind == LoopKind::Antipodal ? 0 : angleAtBase(result);

    result.base = unfolding->toMesh(result.base);
    result.midpoint = unfolding->toMesh(result.midpoint);
    for (SurfacePoint& point : result.points) point = unfolding->toMesh(point);
  }

  /// Saddles that the last run has decided and that die later than they are born.
  std::vector<PersistentSearch::Saddle> lastingSaddles() const {
    const auto& saddles = persistent->saddles();
    std::vector<PersistentSearch::Saddle> lasting;
    std::copy_if(saddles.begin(),
                 saddles.begin() + static_cast<std::ptrdiff_t>(persistent->decided()),
                 std::back_inserter(lasting), [](const PersistentSearch::Saddle& saddle) {
                   return saddle.death > saddle.loop.length / 2;
                 });
    return lasting;
  }

  /// The bars of the last run, which has kept nothing, and their loops, one after the other.
  /// Nothing where the context was cancelled, or rounding decides.
  std::optional<Result<Barcode>> barcodeAgain(BarcodeOptions options,
                                              const ExecutionContext& context) {
    options.loops = false;
    auto result = barcode(options, context);
    if (!result) return result;
    const SurfacePoint source = propagation.source(0);
    for (const PersistentSearch::Saddle& saddle : lastingSaddles()) {
      auto found = loopAgain(source, saddle.loop, context);
      if (!found) return std::nullopt;
      result.value().loops.push_back(*std::move(found));
    }
    return result;
  }

  /// The bars of the last run.
  Result<Barcode> barcode(const BarcodeOptions& options, const ExecutionContext& context) const {
    Barcode result;
    result.maxPersistence = options.maxPersistence;
    for (const PersistentSearch::Saddle& saddle : lastingSaddles()) {
      result.bars.push_back({inModelUnits(saddle.loop.length / 2), inModelUnits(saddle.death)});
      if (options.loops) result.loops.push_back(loopOf(saddle.loop));
    }
    result.rest = {inModelUnits(2 * reached()), LoopKind::Unresolved};
    if (persistent->found() || persistent->endedEarly() || gaveUp()) return result;
    const auto point = farthest(context);
    if (!point) return point.error();
    result.rest = {inModelUnits(2 * point.value().distance),
                   point.value().complete ? LoopKind::Antipodal : LoopKind::Unresolved};
    return result;
  }

  /// No loop is shorter than twice `distance`, and no point farther than `farthest`; that is all
  /// that is known.
  GirthLoop unresolved(double distance, double farthest) const {
    GirthLoop result;
    result.length = inModelUnits(2 * distance);
    result.atMost = inModelUnits(2 * farthest);
    result.kind = LoopKind::Unresolved;
    result.midpoint = result.base = unfolding->toMesh(propagation.source(0));
    return result;
  }

  /// Appends a half of a loop, from its midpoint to the source.
  void trace(const PathHalf& half, const LoopCandidate& loop,
             std::vector<SurfacePoint>& path) const {
    const Index h = half.bundle.halfedge;
    if (h != kNoIndex) {
      traceBundle(propagation, half.bundle, unfolding->toFrame(loop.halfedge, h, loop.midpoint),
                  path);
    } else if (half.vertex != kNoIndex) {
      traceVertex(propagation, half.vertex, path);
    } else {
      path.push_back(propagation.source(0));
    }
  }

  /// Direction at the base, counter-clockwise, in which a neighbouring point of the loop lies.
  double directionTo(const SurfacePoint& base, const SurfacePoint& point) const {
    if (base.kind == SurfacePoint::Kind::AtVertex) {
      const Index start = unfolding->outgoing(base.element);
      for (Index h = start; h != kNoIndex;) {
        if (const auto place = unfolding->placeIn(h, point))
          return unfolding->directionOf(h, *place);
        h = unfolding->turnLeft(h);
        if (h == start) break;
      }
      return 0;
    }
    // Seen from the halfedge of the base, or the first of its face: above it or below.
    const Index h = unfolding->home(base);
    const geodesic::Vec2 at = *unfolding->placeIn(h, base);
    if (const auto place = unfolding->placeIn(h, point)) {
      const geodesic::Vec2 d = *place - at;
      return fullAngleOf(d.x, d.y);
    }
    const Index twin = unfolding->twin(h);
    const geodesic::Vec2 d = *unfolding->placeIn(twin, point) - unfolding->toTwin(h, at);
    return kPi + angleOf(d.x, std::max(d.y, 0.0));
  }

  double angleAtBase(const GirthLoop& loop) const {
    const SurfacePoint& base = loop.base;
    const double between = std::fabs(directionTo(base, loop.points[1]) -
                                     directionTo(base, loop.points[loop.points.size() - 2]));
    const bool vertex = base.kind == SurfacePoint::Kind::AtVertex;
    const bool boundary = vertex ? unfolding->boundary(base.element)
                                 : base.kind == SurfacePoint::Kind::OnEdge &&
                                       unfolding->twin(base.element) == kNoIndex;
    const double total = vertex ? unfolding->totalAngle(base.element) : 2 * kPi;
    return boundary ? between : std::min(between, total - between);
  }
};

GirthSolver::GirthSolver(const SurfaceMesh& mesh)
    : GirthSolver(std::make_unique<State>(std::make_shared<const Unfolding>(mesh))) {}
GirthSolver::GirthSolver(std::unique_ptr<State> state) : state_(std::move(state)) {}
GirthSolver::~GirthSolver() = default;
GirthSolver::GirthSolver(GirthSolver&&) noexcept = default;
GirthSolver& GirthSolver::operator=(GirthSolver&&) noexcept = default;

Result<GirthValue> GirthSolver::value(Vertex vertex, const ExecutionContext& context) {
  return value(SurfacePoint::atVertex(vertex), context);
}
Result<GirthValue> GirthSolver::value(const SurfacePoint& point, const ExecutionContext& context) {
  if (auto error = state_->run(point, Keep::Front, context)) return *std::move(error);
  return state_->value(context);
}

Result<GirthLoop> GirthSolver::loop(Vertex vertex, const ExecutionContext& context) {
  return loop(SurfacePoint::atVertex(vertex), context);
}
Result<GirthLoop> GirthSolver::loop(const SurfacePoint& point, const ExecutionContext& context) {
  if (state_->unfolding->mesh().faceCount() > geodesic::kMostFacesKept) {
    if (auto error = state_->run(point, Keep::Front, context)) return *std::move(error);
    if (const LoopCandidate* const found = state_->found()) {
      const LoopCandidate best = *found;
      const SurfacePoint source = state_->propagation.source(0);
      if (auto loop = state_->loopAgain(source, best, context)) return *std::move(loop);
    } else if (state_->gaveUp()) {
      return state_->loop(context);  // a second time it would give up as well
    } else if (auto path = state_->farthestAgain(context)) {
      return *std::move(path);
    }
    if (context.cancelled()) return makeError(ErrorCode::Cancelled, point.element, "cancelled");
  }
  if (auto error = state_->run(point, Keep::Everything, context)) return *std::move(error);
  return state_->loop(context);
}

Result<Barcode> GirthSolver::barcode(Vertex vertex, const BarcodeOptions& options,
                                     const ExecutionContext& context) {
  return barcode(SurfacePoint::atVertex(vertex), options, context);
}
Result<Barcode> GirthSolver::barcode(const SurfacePoint& point, const BarcodeOptions& options,
                                     const ExecutionContext& context) {
  if (!(options.maxPersistence >= 0)) return *checkPersistence(options.maxPersistence);
  state_->isPersistent = true;
  state_->earlier = {};
  const auto run = [&](Keep keep) {
    return state_->runForSaddles(point, keep, options.maxPersistence, options.maxSaddles, true,
                                 context);
  };
  if (options.loops && state_->unfolding->mesh().faceCount() > geodesic::kMostFacesKept) {
    if (auto error = run(Keep::Front)) return *std::move(error);
    if (auto barcode = state_->barcodeAgain(options, context)) return *std::move(barcode);
    if (context.cancelled()) return makeError(ErrorCode::Cancelled, point.element, "cancelled");
  }
  if (auto error = run(options.loops ? Keep::Everything : Keep::Front)) return *std::move(error);
  return state_->barcode(options, context);
}

void GirthSolver::setPersistence(double tau) {
  state_->persistence = tau;
  state_->runPersistent = &State::runLasting;
}
void GirthSolver::setBudget(std::size_t windows) { state_->propagation.setBudget(windows); }

SearchStatistics GirthSolver::statistics() const {
  const Propagation& p = state_->propagation;
  return {1, p.windowsCreated() + state_->earlier.created,
          p.windowsCrossed() + state_->earlier.crossed,
          p.memoryBytes() + state_->search.memoryBytes() +
              (state_->persistent ? state_->persistent->memoryBytes() : 0)};
}

GirthSolver SolverFactory::onUnfolding(std::shared_ptr<const Unfolding> unfolding) {
  return GirthSolver(std::make_unique<GirthSolver::State>(std::move(unfolding)));
}

Propagation& SolverFactory::propagationOf(GirthSolver& solver) {
  return solver.state_->propagation;
}

std::optional<GirthLoop> SolverFactory::loopWithin(GirthSolver& solver, const SurfacePoint& point,
                                                   const std::uint8_t* band,
                                                   const ExecutionContext& context) {
  GirthSolver::State& state = *solver.state_;
  state.propagation.stayWithin(band);
  const auto error = state.run(point, Keep::Everything, context);
  state.propagation.stayWithin(nullptr);
  const LoopCandidate* best = error ? nullptr : state.found();
  if (best == nullptr) return std::nullopt;
  return state.loopOf(*best);
}

std::optional<LoopsUpTo> SolverFactory::loopsUpTo(GirthSolver& solver, Vertex vertex, double length,
                                                  const ExecutionContext& context) {
  return solver.state_->loopsUpTo(vertex, length, context);
}

Result<GirthLoop> girthLoop(const SurfaceMesh& mesh, Vertex vertex) {
  return GirthSolver(mesh).loop(vertex);
}

}  // namespace girth
