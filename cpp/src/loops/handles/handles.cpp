#include "girth/handles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "girth/barcode.h"
#include "girth/girth_solver.h"
#include "girth/parallel.h"
#include "girth/vertex_function.h"
#include "idle_pool.h"
#include "infinity.h"
#include "loops/handles/class_span.h"
#include "loops/handles/handles_up_to.h"
#include "loops/handles/homology.h"
#include "loops/necks/length_bounds.h"
#include "loops/tight/loop_shape.h"
#include "loops/tight/taut_loop.h"
#include "part_of_work.h"
#include "solver/solver_factory.h"

namespace girth {
namespace {

using geodesic::Unfolding;
using loops::ClassSpan;
using loops::Homology;
using loops::HomologyClass;
using loops::IntegerMatrix;
using loops::LengthBounds;
using loops::TautLoop;

/// Loops that are shorter by less than this share are not shorter.
constexpr double kEqualLength = 1e-9;

/// Vertices that are looked at before it is seen which others need not be: so many at first, and
/// later, as long as the budget suffices for so many.
constexpr std::size_t kAtFirst = 2, kAtOnce = 16;

/// Where the loops at a vertex are this share longer than those sought, its neighbours need not be
/// looked at; and how far they are looked at.
constexpr double kClearly = 0.1, kReach = 0.25;

/// The share of the work that is base points, and not the proof.
constexpr double kBaseShare = 0.5;

/// Loops to be joined into one of a wanted class, at most.
constexpr std::int64_t kMostJoined = 1000;

bool isZero(const HomologyClass& c) {
  return std::all_of(c.begin(), c.end(), [](std::int64_t x) { return x == 0; });
}

/// Whole numbers by which rows of numbers sum up to 0: a basis of all such (Euclid's algorithm on
/// one column after the other).
std::vector<HomologyClass> relations(const std::vector<HomologyClass>& rows) {
  struct Row {
    HomologyClass value, of;
  };
  std::vector<std::pair<std::size_t, Row>> echelon;
  std::vector<HomologyClass> result;
  const auto subtract = [](Row& a, const Row& b, std::int64_t times) {
    for (std::size_t i = 0; i < a.value.size(); ++i) a.value[i] -= times * b.value[i];
    for (std::size_t i = 0; i < a.of.size(); ++i) a.of[i] -= times * b.of[i];
  };
  for (std::size_t r = 0; r < rows.size(); ++r) {
    Row row{rows[r], HomologyClass(rows.size(), 0)};
    row.of[r] = 1;
    for (;;) {
      std::size_t column = 0;
      while (column < row.value.size() && row.value[column] == 0) ++column;
      if (column == row.value.size()) {
        result.push_back(std::move(row.of));
        break;
      }
      const auto known = std::find_if(echelon.begin(), echelon.end(),
                                      [&](const auto& e) { return e.first == column; });
      if (known == echelon.end()) {
        echelon.emplace_back(column, std::move(row));
        break;
      }
      subtract(row, known->second, row.value[column] / known->second.value[column]);
      if (row.value[column] != 0) std::swap(row, known->second);
    }
  }
  return result;
}

/// A closed geodesic, none near it is shorter.
struct Candidate {
  double length{0};
  TautLoop loop;
  HomologyClass homology;
};

/// Loops known at a vertex.
struct LoopsAt {
  /// Independent modulo 2, in the order of their lengths. All that are shorter than `upTo` are sums
  /// of these.
  std::vector<double> lengths;
  std::vector<HomologyClass> classes;
  double upTo{0};
};

/// Loops at one point.
struct Bundle {
  std::vector<std::vector<SurfacePoint>> curves;
  LoopsAt known;
};

/// A component with handles.
struct PartWithHandles {
  Index component{kNoIndex};
  double area{0};
  std::vector<Vertex> order;   ///< base points are taken from
  std::vector<Vertex> spread;  ///< all vertices, no neighbours one after the other
};

/// In rising order. The mesh is put in order once for all of them.
std::vector<PartWithHandles> partsWithHandles(const SurfaceMesh& mesh) {
  std::vector<PartWithHandles> parts;
  std::vector<Index> numberOf(mesh.componentCount(), kNoIndex);
  for (Index c = 0; c < mesh.componentCount(); ++c) {
    if (mesh.genus(c) == 0) continue;
    numberOf[c] = static_cast<Index>(parts.size());
    parts.emplace_back().component = c;
  }
  if (parts.empty()) return parts;
  const auto partWith = [&](Vertex v) {
    const Index part = numberOf[mesh.componentOf(v)];
    return part == kNoIndex ? nullptr : &parts[part];
  };
  for (const Face f : mesh.faces()) {
    if (PartWithHandles* part = partWith(mesh.faceVertices(f)[0])) part->area += mesh.area(f);
  }
  for (const Vertex v : coarseToFineOrder(mesh)) {
    if (PartWithHandles* part = partWith(v)) part->order.push_back(v);
  }
  for (const Vertex v : coarseToFineOrder(mesh, 1)) {
    if (PartWithHandles* part = partWith(v)) part->spread.push_back(v);
  }
  return parts;
}

/// The search on one component.
class HandleSearch {
 public:
  HandleSearch(const SurfaceMesh& mesh, const std::shared_ptr<const Unfolding>& unfolding,
               const Homology& homology, PartWithHandles part, std::size_t windows)
      : mesh_(mesh),
        unfolding_(unfolding),
        homology_(homology),
        area_(part.area),
        order_(std::move(part.order)),
        spread_(std::move(part.spread)),
        budget_(windows) {}

  /// False: cancelled.
  bool run(std::size_t basePoints, const ExecutionContext& context) {
    const auto linking = homology_.linking({context.threads, context.cancel, {}});
    if (!linking) return false;
    projection_ = linking.value();
    const bool isAll = basePoints >= order_.size();
    const std::size_t most = std::min(basePoints, order_.size());
    const std::size_t spread = isAll ? most : (most + 1) / 2;
    std::vector<Vertex> bases(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(spread));
    addBasis();
    while (!bases.empty()) {
      if (!addLoopsAt(bases, most, context)) return false;
      if (!complete(context)) return false;
      bases = nextBases(most);
    }
    return true;
  }

  /// Proves that no loop is shorter than those found that are shorter than a length. They are
  /// replaced where one is, as far as the budget goes. False: cancelled.
  bool proveAll(double upTo, const ExecutionContext& context) {
    for (;;) {
      // The shortest first: about these the least needs to be looked at.
      std::optional<HandleKind> next;
      double length = kInfinity;
      for (const HandleKind kind : kinds()) {
        const std::vector<Found> some = chosen(kind);
        std::vector<Proven>& proven = proven_[kind];
        std::size_t same = 0;
        while (same < proven.size() && proven[same].candidate == some[same].candidate) ++same;
        proven.resize(same);
        if (same == some.size() || !(some[same].candidate->length < length)) continue;
        next = kind;
        length = some[same].candidate->length;
      }
      if (!next || length >= upTo) return true;
      const std::size_t place = proven_[*next].size();
      const Candidate* const candidate = chosen(*next)[place].candidate;
      const auto least = leastBeyond(*next, place, length, context);
      if (!least) return false;
      // Where shorter ones were found, it is another one's turn.
      if (!least->isOfOthers) proven_[*next].push_back({candidate, least->length});
    }
  }

  /// No loop that is no sum of those found which are shorter than a length is shorter than this, at
  /// most the length itself; nothing: cancelled.
  std::optional<double> provenUpTo(double length, const ExecutionContext& context) {
    double proven = length;
    for (const HandleKind kind : kinds()) {
      for (bool isOfOthers = true; isOfOthers;) {
        const std::vector<Found> some = chosen(kind);
        std::size_t place = 0;
        while (place < some.size() && some[place].candidate->length < length) ++place;
        if (place == homology_.rank() / kinds().size()) break;
        const auto least = leastBeyond(kind, place, length, context);
        if (!least) return std::nullopt;
        isOfOthers = least->isOfOthers;
        if (!isOfOthers) proven = std::min(proven, least->length);
      }
    }
    return proven;
  }

  /// The loops found, by kinds, and what they are short of.
  struct Found {
    HandleKind kind;
    const Candidate* candidate;
  };
  std::vector<Found> found() const {
    std::vector<Found> all;
    for (const HandleKind kind : kinds()) {
      const std::vector<Found> some = chosen(kind);
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }
  /// By how much one of them may be longer than the shortest.
  double excessOf(const Found& found) const {
    const auto proven = proven_.find(found.kind);
    if (proven == proven_.end()) return found.candidate->length;
    for (const auto& [candidate, least] : proven->second) {
      if (candidate == found.candidate) return candidate->length - least;
    }
    return found.candidate->length;
  }

 private:
  std::vector<HandleKind> kinds() const {
    if (!projection_) return {HandleKind::Unknown};
    return {HandleKind::Handle, HandleKind::Tunnel};
  }

  /// A class by what keeps it from being of a kind, and then by what is of this kind.
  HomologyClass sortedBy(HandleKind kind, const HomologyClass& c) const {
    if (kind == HandleKind::Unknown) return c;
    HomologyClass tunnel = loops::product(c, *projection_), handle = c;
    for (std::size_t k = 0; k < c.size(); ++k) handle[k] -= tunnel[k];
    HomologyClass& first = kind == HandleKind::Handle ? tunnel : handle;
    const HomologyClass& second = kind == HandleKind::Handle ? handle : tunnel;
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }

  /// Lower bound on the loops at a vertex that are of a kind and no sum of others of it.
  struct LeastAt {
    double length;
    bool isReached;  ///< by such a loop, or the sum of several
  };
  LeastAt leastAt(const LoopsAt& known, HandleKind kind, ClassSpan others) const {
    const std::size_t own = kind == HandleKind::Unknown ? 0 : homology_.rank();
    for (std::size_t i = 0; i < known.classes.size(); ++i) {
      const auto place = others.add(sortedBy(kind, known.classes[i]));
      if (place && *place >= own) return {std::min(known.lengths[i], known.upTo), true};
    }
    return {known.upTo, false};
  }

  /// Looks at vertices until no loop of a kind, which is no sum of the first `place` found, can be
  /// shorter than a length, until one is found, or to the end of the budget. Nothing: cancelled.
  struct Least {
    double length;           ///< no such loop is shorter
    bool isOfOthers{false};  ///< whether it belongs to others than the first found by now
  };
  std::optional<Least> leastBeyond(HandleKind kind, std::size_t place, double length,
                                   const ExecutionContext& context) {
    const auto firstFound = [&] {
      std::vector<const Candidate*> found;
      for (const Found& one : chosen(kind)) {
        if (found.size() > place || !(found.size() < place || one.candidate->length < length))
          break;
        found.push_back(one.candidate);
      }
      return found;
    };
    const std::vector<const Candidate*> first = firstFound();
    ClassSpan others;
    for (std::size_t i = 0; i < place; ++i) others.add(sortedBy(kind, first[i]->homology));
    LengthBounds bounds(mesh_);
    std::vector<std::pair<Vertex, double>> known;
    for (const auto& [vertex, loops] : known_) {
      known.emplace_back(vertex, leastAt(loops, kind, others).length);
    }
    const double enough = length * (1 - kEqualLength);
    std::size_t atOnce = kAtFirst;
    for (std::size_t next = 0;;) {
      bounds.raise(known);
      std::vector<Vertex> pending;
      for (; next < spread_.size() && pending.size() < atOnce && windows_ < budget_; ++next) {
        const auto at = known_.find(spread_[next]);
        if (bounds.at(spread_[next]) < enough && (at == known_.end() || at->second.upTo < enough)) {
          pending.push_back(spread_[next]);
        }
      }
      if (pending.empty()) break;
      const std::size_t count = candidates_.size(), before = windows_;
      if (!lookAt(pending, kind, others, length, context)) return std::nullopt;
      if (candidates_.size() > count && firstFound() != first) return Least{0, true};
      const std::size_t each = std::max<std::size_t>(1, (windows_ - before) / pending.size());
      atOnce = std::clamp<std::size_t>((budget_ - std::min(windows_, budget_)) / each, 1, kAtOnce);
      known.clear();
      for (const Vertex v : pending)
        known.emplace_back(v, leastAt(known_.at(v), kind, others).length);
    }
    double least = length;
    for (const Vertex v : spread_) {
      if (bounds.at(v) < enough) least = std::min(least, bounds.at(v));
    }
    return Least{least};
  }

  /// Finds the loops at some vertices that are shorter than a length, or little longer, as far as
  /// it matters for a kind and what is no sum of others of it.
  bool lookAt(const std::vector<Vertex>& vertices, HandleKind kind, const ClassSpan& others,
              double length, const ExecutionContext& context) {
    struct Look {
      Bundle bundle;
      std::vector<Candidate> tight;
      std::size_t windows{0};
    };
    std::vector<Look> looks(vertices.size());
    const ExecutionContext alone = context.ofOneThread();
    const auto look = [&](GirthSolver& solver, std::size_t i) {
      auto& [bundle, tight, windows] = looks[i];
      const auto found = known_.find(vertices[i]);
      bool isEnough = false;
      if (found == known_.end()) {
        bundle = girthAt(solver, vertices[i], alone);
        windows += solver.statistics().windowsCrossed;
        isEnough = bundle.known.upTo > length * (1 + kClearly) ||
                   leastAt(bundle.known, kind, others).isReached;
      }
      if (!isEnough) {
        const auto all =
            SolverFactory::loopsUpTo(solver, vertices[i], length * (1 + kReach), alone);
        windows += solver.statistics().windowsCrossed;
        if (!all) return;  // cancelled
        bundle = {};
        bundle.known.upTo = all->length;
        ClassSpan independent;
        for (const GirthLoop& loop : all->loops) take(loop, independent, bundle);
      }
      for (const auto& curve : bundle.curves) {
        if (auto candidate = tightened(curve)) tight.push_back(*std::move(candidate));
      }
    };
    if (!eachWithSolver(vertices.size(), {context.threads, context.cancel, {}}, look)) return false;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      for (Candidate& candidate : looks[i].tight) add(std::move(candidate));
      known_[vertices[i]] = std::move(looks[i].bundle.known);
      windows_ += looks[i].windows;
    }
    if (context.onProgress) {
      context.onProgress(static_cast<double>(std::min(windows_, budget_)) /
                         static_cast<double>(budget_));
    }
    return true;
  }

  /// Calls `work(solver, i)` for all i below a count. False: cancelled.
  template <class Work>
  bool eachWithSolver(std::size_t count, const ExecutionContext& context, const Work& work) {
    const auto make = [&] {
      return std::make_unique<GirthSolver>(SolverFactory::onUnfolding(unfolding_));
    };
    return parallelFor(count, 1, context,
                       [&](std::size_t i, std::size_t) {
                         solvers_.use(make, [&](GirthSolver& solver) { work(solver, i); });
                       }) &&
           !context.cancelled();
  }

  bool isOf(HandleKind kind, const HomologyClass& c) const {
    if (kind == HandleKind::Unknown) return true;
    const HomologyClass image = loops::product(c, *projection_);
    return kind == HandleKind::Handle ? isZero(image) : image == c;
  }

  std::vector<Found> chosen(HandleKind kind) const {
    ClassSpan independent;
    std::vector<Found> result;
    for (const Candidate& candidate : candidates_) {
      if (isOf(kind, candidate.homology) && independent.add(candidate.homology)) {
        result.push_back({kind, &candidate});
      }
    }
    return result;
  }

  /// Draws a curve tight, and on to a neck.
  std::optional<Candidate> tightened(std::span<const SurfacePoint> points) const {
    std::optional<TautLoop> tight = loops::neckFrom(*unfolding_, points, area_);
    if (!tight) return std::nullopt;
    HomologyClass homology = homology_.classOf(*unfolding_, *tight);
    if (isZero(homology)) return std::nullopt;
    const double length = loops::lengthOf(*unfolding_, *tight);
    return Candidate{length, *std::move(tight), std::move(homology)};
  }

  void add(Candidate candidate) { candidates_.insert(std::move(candidate)); }

  /// The basis curves, all through one vertex.
  void addBasis() {
    Bundle bundle;
    for (std::size_t k = 0; k < homology_.rank(); ++k) {
      bundle.curves.push_back(homology_.basisCurve(k));
      HomologyClass c(homology_.rank(), 0);
      c[k] = 1;
      bundle.known.classes.push_back(std::move(c));
      if (auto candidate = tightened(bundle.curves.back())) add(*std::move(candidate));
    }
    bundles_.push_back(std::move(bundle));
  }

  /// The shortest loops at a base point that generate all others there: nothing if cancelled.
  std::optional<Bundle> bundleAt(GirthSolver& solver, Vertex base,
                                 const ExecutionContext& context) const {
    BarcodeOptions options;
    options.loops = true;
    const auto barcode = solver.barcode(base, options, context);
    if (!barcode) return std::nullopt;
    Bundle bundle;
    ClassSpan independent;
    for (const GirthLoop& loop : barcode.value().loops) {
      if (independent.size() == homology_.rank()) break;
      take(loop, independent, bundle);
    }
    bundle.known.upTo =
        independent.size() == homology_.rank() ? kInfinity : barcode.value().rest.length;
    return bundle;
  }

  /// The loop of the girth at a vertex; empty if cancelled.
  Bundle girthAt(GirthSolver& solver, Vertex base, const ExecutionContext& context) const {
    Bundle bundle;
    const auto loop = solver.loop(base, context);
    if (!loop) return bundle;
    bundle.known.upTo = loop.value().length;
    ClassSpan independent;
    if (loop.value().kind == LoopKind::Loop) take(loop.value(), independent, bundle);
    return bundle;
  }

  void take(const GirthLoop& loop, ClassSpan& independent, Bundle& bundle) const {
    const auto loose = loops::looseLoop(*unfolding_, loop.points);
    if (!loose) return;
    HomologyClass c = homology_.classOf(*unfolding_, *loose);
    if (!independent.add(c)) return;
    bundle.curves.push_back(loop.points);
    bundle.known.lengths.push_back(loop.length);
    bundle.known.classes.push_back(std::move(c));
  }

  /// At the first of some points, up to `most` in all, all their loops; at the others the girth's.
  bool addLoopsAt(const std::vector<Vertex>& bases, std::size_t most,
                  const ExecutionContext& context) {
    const std::size_t whole = std::min(bases.size(), most - std::min(most, used_));
    std::vector<Bundle> bundles(bases.size());
    std::vector<std::vector<Candidate>> tight(bases.size());
    ExecutionContext part{context.threads, context.cancel, {}};
    if (context.onProgress) {
      part.onProgress = [&](double share) {
        context.onProgress((static_cast<double>(used_) + share * static_cast<double>(whole)) /
                           static_cast<double>(most));
      };
    }
    const auto work = [&](GirthSolver& solver, std::size_t i) {
      if (i >= whole) {
        bundles[i] = girthAt(solver, bases[i], context.ofOneThread());
      } else if (auto bundle = bundleAt(solver, bases[i], context.ofOneThread())) {
        bundles[i] = *std::move(bundle);
      }
      for (const auto& curve : bundles[i].curves) {
        if (auto candidate = tightened(curve)) tight[i].push_back(*std::move(candidate));
      }
    };
    if (!eachWithSolver(bases.size(), part, work)) return false;
    for (std::size_t i = 0; i < bases.size(); ++i) {
      for (Candidate& candidate : tight[i]) add(std::move(candidate));
      known_[bases[i]] = bundles[i].known;
      if (bundles[i].curves.size() == homology_.rank()) bundles_.push_back(std::move(bundles[i]));
    }
    used_ += whole;
    return true;
  }

  /// Where loops of a kind are short of g, joins loops through one point into such.
  bool complete(const ExecutionContext& context) {
    if (!projection_) return true;
    for (const HandleKind kind : {HandleKind::Handle, HandleKind::Tunnel}) {
      for (auto bundle = bundles_.rbegin();
           bundle != bundles_.rend() && 2 * chosen(kind).size() < homology_.rank(); ++bundle) {
        std::vector<HomologyClass> rows;
        for (const HomologyClass& c : bundle->known.classes) {
          HomologyClass image = loops::product(c, *projection_);
          if (kind == HandleKind::Tunnel) {
            for (std::size_t k = 0; k < c.size(); ++k) image[k] -= c[k];
          }
          rows.push_back(std::move(image));
        }
        for (const HomologyClass& relation : relations(rows)) {
          if (context.cancelled()) return false;
          if (auto candidate = joined(*bundle, relation)) add(*std::move(candidate));
        }
      }
    }
    return true;
  }

  /// The loops of a bundle one behind the other, each so many times.
  std::optional<Candidate> joined(const Bundle& bundle, const HomologyClass& times) const {
    std::int64_t count = 0;
    for (const std::int64_t t : times) count += std::abs(t);
    if (count > kMostJoined) return std::nullopt;
    std::vector<SurfacePoint> points;
    for (std::size_t k = 0; k < times.size(); ++k) {
      std::vector<SurfacePoint> curve = bundle.curves[k];
      if (times[k] < 0) std::reverse(curve.begin(), curve.end());
      for (std::int64_t i = 0; i < std::abs(times[k]); ++i) {
        if (!points.empty()) points.pop_back();
        points.insert(points.end(), curve.begin(), curve.end());
      }
    }
    return tightened(points);
  }

  /// Points on the loops found so far that have not been base points.
  std::vector<Vertex> nextBases(std::size_t most) const {
    std::vector<Vertex> bases;
    std::set<Vertex> taken;
    for (const auto& [vertex, loops] : known_) taken.insert(vertex);
    if (most >= order_.size()) return bases;
    for (const Found& loop : found()) {
      const std::vector<Index>& vertices = loop.candidate->loop.vertices;
      const std::size_t step = (vertices.size() + kPerLoop - 1) / kPerLoop;
      for (std::size_t i = 0; i < vertices.size(); i += step) {
        const Vertex vertex(unfolding_->vertexInMesh(vertices[i]));
        if (taken.insert(vertex).second) bases.push_back(vertex);
      }
    }
    return bases;
  }

  /// Base points on one loop.
  static constexpr std::size_t kPerLoop = 4;

  /// The shortest first.
  struct ByLength {
    bool operator()(const Candidate& a, const Candidate& b) const {
      if (a.length != b.length) return a.length < b.length;
      return a.loop.vertices != b.loop.vertices ? a.loop.vertices < b.loop.vertices
                                                : a.loop.runs < b.loop.runs;
    }
  };

  const SurfaceMesh& mesh_;
  std::shared_ptr<const Unfolding> unfolding_;
  const Homology& homology_;
  double area_;
  std::vector<Vertex> order_, spread_;
  std::optional<IntegerMatrix> projection_;
  std::set<Candidate, ByLength> candidates_;
  std::vector<Bundle> bundles_;
  std::map<Vertex, LoopsAt> known_;
  std::size_t used_{0};
  std::size_t budget_, windows_{0};  // windows of the proof
  struct Proven {
    const Candidate* candidate;
    double least;  ///< no loop in its place is shorter
  };
  std::map<HandleKind, std::vector<Proven>> proven_;
  IdlePool<GirthSolver> solvers_;
};

}  // namespace

std::string_view toString(HandleKind kind) {
  switch (kind) {
    case HandleKind::Handle:
      return "handle";
    case HandleKind::Tunnel:
      return "tunnel";
    default:
      return "unknown";
  }
}

Result<loops::HandlesUpTo> loops::findHandlesUpTo(const SurfaceMesh& mesh,
                                                  std::optional<double> length,
                                                  const HandleOptions& options,
                                                  const ExecutionContext& context) {
  if (options.basePoints == 0) {
    return makeError(ErrorCode::InvalidOption, -1, "there is at least one base point");
  }
  std::vector<PartWithHandles> parts = partsWithHandles(mesh);
  HandlesUpTo result;
  if (length) result.proven = *length;
  Handles& handles = result.handles;
  const ClosedSurface closed(mesh);
  const auto unfolding = std::make_shared<const Unfolding>(mesh);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Index component = parts[i].component;
    const Homology homology(mesh, closed, component);
    HandleSearch search(mesh, unfolding, homology, std::move(parts[i]), options.windows);
    const double begin = static_cast<double>(i) / static_cast<double>(parts.size());
    const double share = 1 / static_cast<double>(parts.size());
    bool isDone =
        search.run(options.basePoints, partOf(context, begin, begin + kBaseShare * share));
    const ExecutionContext rest = partOf(context, begin + kBaseShare * share, begin + share);
    if (isDone && length != 0.0) isDone = search.proveAll(length.value_or(kInfinity), rest);
    if (isDone && length && *length > 0) {
      const auto proven = search.provenUpTo(*length, rest);
      isDone = proven.has_value();
      result.proven = std::min(result.proven, proven.value_or(0));
    }
    if (rest.onProgress) rest.onProgress(1);
    if (!isDone || context.cancelled()) {
      return makeError(ErrorCode::Cancelled, -1, "the search for handles was cancelled");
    }
    const auto found = search.found();
    handles.unresolved += static_cast<Index>(homology.rank() - found.size());
    for (const auto& one : found) {
      Handle handle;
      handle.length = one.candidate->length;
      handle.mayBeShorterBy = search.excessOf(one);
      handle.kind = one.kind;
      handle.component = component;
      handle.points = bandOf(*unfolding, one.candidate->loop, mesh.area()).middle;
      const LoopShape shape = shapeOf(placesOf(mesh, handle.points));
      handle.centre = shape.centre;
      handle.area = shape.area;
      handles.handles.push_back(std::move(handle));
    }
  }
  std::stable_sort(handles.handles.begin(), handles.handles.end(),
                   [](const Handle& a, const Handle& b) { return a.length < b.length; });
  if (context.onProgress) context.onProgress(1);
  return result;
}

Result<Handles> findHandles(const SurfaceMesh& mesh, const HandleOptions& options,
                            const ExecutionContext& context) {
  auto found = loops::findHandlesUpTo(mesh, std::nullopt, options, context);
  if (!found) return found.error();
  return std::move(found).value().handles;
}

}  // namespace girth
