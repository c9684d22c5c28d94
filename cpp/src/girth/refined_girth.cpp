#include "girth/refined_girth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <numeric>
#include <queue>
#include <span>
#include <utility>

#include "geodesic/unfolding.h"
#include "girth/carried_loops.h"
#include "girth/face_band.h"
#include "girth/parallel.h"
#include "girth/remesh.h"
#include "girth/site_graph.h"
#include "girth/solver_factory.h"
#include "girth/transfer.h"
#include "girth/vertex_function.h"
#include "idle_pool.h"
#include "mesh/flat_vertices.h"
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
/// Flat vertices are left out where that leaves no more than this share of the triangles.
constexpr double kLeanShare = 0.6;
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
constexpr double kMostExact = 3;
/// And of that, those that are only to check.
constexpr double kMostChecks = 0.15;
/// Vertices that are computed exactly at a time, before the work is added up.
constexpr std::size_t kExactAtATime = 64;
/// On surfaces of more triangles an exact search does not keep what it needs to draw the loop.
constexpr Index kMostFacesForLoops = 200'000;
/// Where flat vertices are left out, so many vertices of the audit are also computed with them.
constexpr std::size_t kAuditOnAllFaces = 8;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// What is known of a site.
struct Known {
  double length{kNone};  // in model units
  LoopKind kind{LoopKind::Unresolved};
  bool isProved{false};
  bool isDoubted{false};     // and so is to be computed exactly
  bool isLow{false};         // shorter than its floor, as that of a neighbour that is proved
  std::vector<Index> faces;  // of its loop, in rising order; empty where there is none to spread

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

/// Loops are looked for on the ground: the surface, or the same without its flat vertices. Their
/// bases are sites: first the vertices of the ground, in the numbers of its unfolding, then the
/// flat vertices, which lie in its faces.
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
        unfolding_(std::make_shared<const Unfolding>(ground_)) {
    if (isLean_) result_.leanFaces = ground_.faceCount();
    layOutSites(lean);
  }

  Result<RefinedGirth> run() {
    if (ground_.faceCount() < kFewFaces) {
      stage_ = partOf(context_, 0, kProved);
      computeAll();
    } else {
      if (auto error = computeOnGround()) return *std::move(error);
      if (isLean_) computeFlatSites();
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
  // And of the progress of a stage that its steps end at.
  static constexpr double kCoarse = 0.05, kSeeded = 0.15, kSpread = 0.75;

  const Unfolding& unfolding() const { return *unfolding_; }
  Index groundSites() const { return unfolding().vertexCount(); }

  void layOutSites(const LeanSurface* lean) {
    const Index count = mesh_.vertexCount();
    vertexOf_.resize(count);
    places_.resize(count);
    std::vector<Index> flat;
    for (Index v = 0; v < count; ++v) {
      const SurfacePoint place =
          lean != nullptr ? lean->places[v] : SurfacePoint::atVertex(Vertex(v));
      if (place.kind != SurfacePoint::Kind::AtVertex) {
        flat.push_back(v);
        continue;
      }
      const Index site = unfolding().fromMesh(place).element;
      vertexOf_[site] = v;
      places_[site] = place;
    }
    // What is near on the surface is near in memory.
    const auto faceOf = [&](Index v) { return unfolding().fromMesh(lean->places[v]).element; };
    std::stable_sort(flat.begin(), flat.end(),
                     [&](Index a, Index b) { return faceOf(a) < faceOf(b); });
    for (Index i = 0; i < flat.size(); ++i) {
      vertexOf_[groundSites() + i] = flat[i];
      places_[groundSites() + i] = lean->places[flat[i]];
    }
    known_.resize(groundSites());
  }

  /// The exact girth at every site: the ground is small.
  void computeAll() {
    connectVertices();
    known_.resize(places_.size());
    std::vector<Index> all(known_.size());
    std::iota(all.begin(), all.end(), Index{0});
    makeExact(all, stage_);
  }

  std::optional<Error> computeOnGround() {
    stage_ = partOf(context_, 0, isLean_ ? kGround : kProved);
    std::vector<Index> siteOf(groundSites());
    for (Index site = 0; site < siteOf.size(); ++site)
      siteOf[unfolding().vertexInMesh(site)] = site;
    graph_ = SiteGraph(ground_, siteOf);
    if (auto error = seed()) return error;
    spread(kSeeded, kSpread);
    prove(ground_, siteOf);
    return std::nullopt;
  }

  /// Flat vertices, beginning at what is known of the corners of their faces.
  void computeFlatSites() {
    stage_ = partOf(context_, kGround, kProved);
    const std::vector<Index> siteOf = connectVertices();
    known_.resize(places_.size());
    floor_.resize(places_.size());
    for (Index site = groundSites(); site < floor_.size(); ++site) {
      const Index face = faceOf(site);
      floor_[site] = std::numeric_limits<double>::infinity();
      for (Index h = 3 * face; h < 3 * face + 3; ++h) {
        floor_[site] = std::min(floor_[site], floor_[unfolding().crossing(h).from()]);
      }
    }
    for (Index site = 0; site < groundSites(); ++site) {
      if (!known_[site].faces.empty()) changed_.push_back(site);
    }
    spread(0, kSpread);
    prove(mesh_, siteOf);
  }

  /// All sites are neighbours as the vertices of the surface are. Returns the site of each vertex.
  std::vector<Index> connectVertices() {
    std::vector<Index> siteOf(vertexOf_.size());
    for (Index site = 0; site < siteOf.size(); ++site) siteOf[vertexOf_[site]] = site;
    graph_ = SiteGraph(mesh_, siteOf);
    return siteOf;
  }

  /// The face that a flat vertex lies in.
  Index faceOf(Index site) const { return unfolding().fromMesh(places_[site]).element; }

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
    const std::vector<Vertex> nearest = nearestVertices(coarse, nearestPoints(coarse, ground_));
    floor_.resize(groundSites());
    for (Index v = 0; v < groundSites(); ++v) {
      floor_[v] = kCoarseAtLeast * least[nearest[unfolding().vertexInMesh(v)]];
    }
  }

  /// From neighbour to neighbour, from the sites that have changed on, until no loop becomes
  /// shorter. Reports from `begin` to `end` of the stage, where they differ. Returns the sites at
  /// which it did.
  std::vector<Index> spread(double begin, double end) {
    std::vector<Index> all;
    auto reached = static_cast<std::size_t>(
        std::count_if(known_.begin(), known_.end(), [](const Known& k) { return k.isThere(); }));
    while (!changed_.empty() && !context_.cancelled()) {
      const std::vector<Beside> besides = besidesOf(changed_);
      std::vector<Known> found(besides.size());
      eachOf(besides.size(), silent(),
             [&](std::size_t i, Scratch& scratch) { search(besides[i], scratch, found[i]); });
      changed_.clear();
      for (std::size_t i = 0; i < besides.size(); ++i) {
        if (!found[i].isThere()) continue;
        Known& known = known_[besides[i].site];
        reached += known.isThere() ? 0 : 1;
        known = std::move(found[i]);
        changed_.push_back(besides[i].site);
      }
      all.insert(all.end(), changed_.begin(), changed_.end());
      const double share = static_cast<double>(reached) / static_cast<double>(known_.size());
      if (begin < end) report(begin + (end - begin) * share);
    }
    return all;
  }

  /// A site beside others whose loops have changed.
  struct Beside {
    Index site;
    std::vector<Neighbour> changed;
  };

  std::vector<Beside> besidesOf(const std::vector<Index>& changed) const {
    std::vector<std::pair<Index, Neighbour>> pairs;
    for (const Index site : changed) {
      for (const Neighbour& other : graph_.neighbours(site)) {
        if (!known_[other.site].isProved) pairs.push_back({other.site, {site, other.distance}});
      }
    }
    std::sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first < b.first : a.second.site < b.second.site;
    });
    std::vector<Beside> besides;
    for (const auto& [site, other] : pairs) {
      if (besides.empty() || besides.back().site != site) besides.push_back({site, {}});
      besides.back().changed.push_back(other);
    }
    return besides;
  }

  /// A shorter loop for a site from the bands of its neighbours; `found` stays empty without.
  void search(const Beside& beside, Scratch& scratch, Known& found) {
    const Known& own = known_[beside.site];
    FaceBand& band = scratch.band;
    if (own.isThere()) {
      // Loops within the band round its own have been looked at.
      band.clear();
      band.add(own.faces);
      band.grow(kRings);
      if (std::all_of(beside.changed.begin(), beside.changed.end(), [&](const Neighbour& other) {
            return band.hasAll(known_[other.site].faces);
          })) {
        return;
      }
    }
    band.clear();
    double floor = floor_[beside.site];
    for (const Neighbour& other : beside.changed) {
      const Known& known = known_[other.site];
      band.add(known.faces);
      // The loop beside one that is proved may be as short, but for the way there and back.
      if (known.isProved || known.isLow) {
        floor = std::min(floor, (known.length - 2 * other.distance) * (1 - kSame));
      }
    }
    addAround(beside.site, band);
    band.grow(kRings);
    found.length = own.length;
    settle(beside.site, floor, scratch, found);
    if (isSame(found.length, own.length)) found.length = kNone;
  }

  void addAround(Index site, FaceBand& band) const {
    if (site < groundSites()) {
      band.addAround(site);
    } else {
      band.add(faceOf(site));
    }
  }

  /// The shortest loop in a band, and then in one round that loop where it reaches the rim; into
  /// `known`, if it is shorter, but not below `floor`.
  void settle(Index site, double floor, Scratch& scratch, Known& known) {
    for (int bands = 0; bands < kMostBands; ++bands) {
      const auto loop = loopWithin(site, scratch);
      if (!loop || loop->length >= known.length * (1 - kSame)) return;
      if (loop->length < floor) return;
      take(*loop, known);
      known.isLow = known.length < floor_[site];
      if (!scratch.band.reachesRim(known.faces)) return;
      scratch.band.clear();
      scratch.band.add(known.faces);
      scratch.band.grow(kRings);
    }
  }

  std::optional<GirthLoop> loopWithin(Index site, Scratch& scratch) {
    auto loop = SolverFactory::loopWithin(scratch.solver, places_[site], scratch.band.data(),
                                          context_.ofOneThread());
    count(scratch.solver.statistics());
    return loop;
  }

  void take(const GirthLoop& loop, Known& known) const {
    known.length = loop.length;
    known.kind = loop.kind;
    known.faces = loop.kind == LoopKind::Loop ? facesOf(unfolding(), loop) : std::vector<Index>{};
  }

  /// Exactly: sites that are contradicted, or have no loop, and then some evenly spread over the
  /// surface, since a region may be wrong as a whole without a contradiction. A loop that was
  /// missed spreads from there; where one was too short, the neighbours' may be too. Within bounds;
  /// what is left is suspect. `mesh`: whose vertices the sites are.
  void prove(const SurfaceMesh& mesh, const std::vector<Index>& siteOf) {
    const auto before = static_cast<double>(windows());
    const double most = kMostExact * before;
    Doubts doubts(known_.size());
    const auto report = [&] {
      const double share = std::min(1.0, (static_cast<double>(windows()) - before) / most);
      this->report(kSpread + (1 - kSpread) * share);
    };
    const auto settleAll = [&] {
      while (!doubts.empty() && static_cast<double>(windows()) - before < most &&
             !context_.cancelled()) {
        std::vector<Index> some;
        while (!doubts.empty() && some.size() < kExactAtATime) {
          const Index site = doubts.take();
          // What has spread meanwhile may have put an end to the contradiction.
          if (!known_[site].isProved && (known_[site].isDoubted || contradicts(site))) {
            some.push_back(site);
          }
        }
        settleExactly(some, doubts);
        report();
      }
    };
    // Evenly spread, since what is wrong is so in regions, and most contradictions are jumps.
    const std::vector<Vertex> order = coarseToFineOrder(mesh, 1);
    for (const Vertex v : order) {
      if (contradicts(siteOf[v])) doubts.add(siteOf[v], known_[siteOf[v]].length);
    }
    settleAll();
    const double settled = static_cast<double>(windows());
    double checks = 0;
    for (std::size_t i = 0; i < order.size() && checks < kMostChecks * settled;) {
      std::vector<Index> some;
      for (; i < order.size() && some.size() < kExactAtATime; ++i) {
        const Index site = siteOf[order[i]];
        if (!known_[site].isProved) some.push_back(site);
      }
      const auto start = static_cast<double>(windows());
      settleExactly(some, doubts);
      checks += static_cast<double>(windows()) - start;
      settleAll();
      report();
      if (context_.cancelled()) return;
    }
    this->report(1);
  }

  /// Sites that are to be looked at, each once at a time: those with the shortest loops first,
  /// which cost least.
  class Doubts {
   public:
    explicit Doubts(std::size_t sites) : isQueued_(sites, false) {}
    bool empty() const { return queue_.empty(); }
    void add(Index site, double length) {
      if (isQueued_[site]) return;
      isQueued_[site] = true;
      queue_.emplace(std::isnan(length) ? std::numeric_limits<double>::infinity() : length, site);
    }
    Index take() {
      const Index site = queue_.top().second;
      queue_.pop();
      isQueued_[site] = false;
      return site;
    }

   private:
    std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>,
                        std::greater<>>
        queue_;
    std::vector<bool> isQueued_;
  };

  /// The exact values of some sites, and what follows from them for others.
  void settleExactly(const std::vector<Index>& sites, Doubts& doubts) {
    std::vector<double> lengths;
    for (const Index site : sites) lengths.push_back(known_[site].length);
    makeExact(sites, silent());
    std::vector<Index> changed;
    for (std::size_t i = 0; i < sites.size(); ++i) {
      const Known& known = known_[sites[i]];
      if (!known.isProved || isSame(lengths[i], known.length)) continue;
      changed.push_back(sites[i]);
      if (!(known.length > lengths[i])) {
        if (!known.faces.empty()) changed_.push_back(sites[i]);
        continue;
      }
      for (const Neighbour& other : graph_.neighbours(sites[i])) {
        if (known_[other.site].isProved) continue;
        if (known_[other.site].isDoubted) continue;
        known_[other.site].isDoubted = true;
        doubts.add(other.site, known_[other.site].length);
      }
    }
    const std::vector<Index> spreadTo = spread(0, 0);
    changed.insert(changed.end(), spreadTo.begin(), spreadTo.end());
    for (const Index site : changed) {
      if (contradicts(site)) doubts.add(site, known_[site].length);
      for (const Neighbour& other : graph_.neighbours(site)) {
        if (!known_[other.site].isProved && contradicts(other.site))
          doubts.add(other.site, known_[other.site].length);
      }
    }
  }

  void makeExact(const std::vector<Index>& sites, const ExecutionContext& context) {
    // The loops of vertices of the ground are where flat vertices begin.
    const bool isBeginning = isLean_ && known_.size() == groundSites();
    const bool withLoops = ground_.faceCount() <= kMostFacesForLoops;
    eachOf(sites.size(), context, [&](std::size_t i, Scratch& scratch) {
      const SurfacePoint& place = places_[sites[i]];
      const auto value = scratch.solver.value(place, context_.ofOneThread());
      if (!value) return;  // cancelled
      count(scratch.solver.statistics());
      Known& known = known_[sites[i]];
      const bool isOther = !isSame(value.value().length, known.length);
      const bool isShorter = !(value.value().length > known.length);
      known.isProved = value.value().kind != LoopKind::Unresolved;
      if (known.isProved || !known.isThere()) {
        known.kind = value.value().kind;
        known.length = value.value().length;
      }
      if (!isOther) return;
      known.faces.clear();
      if (known.kind != LoopKind::Loop || !withLoops || !(isShorter || isBeginning)) return;
      const auto loop = scratch.solver.loop(place, context_.ofOneThread());
      if (!loop) return;
      count(scratch.solver.statistics());
      known.faces = facesOf(unfolding(), loop.value());
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
    for (const Index site : drawn) before.push_back(known_[site].length);
    const ExecutionContext onGround = partOf(stage_, 0, isLean_ ? 0.5 : 1);
    makeExact(drawn, onGround);
    if (isLean_) auditOnAllFaces(drawn);
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

  /// The first of the drawn sites on the surface with its flat vertices.
  void auditOnAllFaces(const std::vector<Index>& drawn) {
    const auto all = std::make_shared<const Unfolding>(mesh_);
    const ExecutionContext context = partOf(stage_, 0.5, 1);
    const std::size_t count = std::min(drawn.size(), kAuditOnAllFaces);
    parallelFor(count, 1, context, [&](std::size_t begin, std::size_t end) {
      GirthSolver solver = SolverFactory::onUnfolding(all);
      for (std::size_t i = begin; i < end; ++i) {
        const auto value = solver.value(Vertex(vertexOf_[drawn[i]]), context_.ofOneThread());
        if (!value) return;  // cancelled
        Known& known = known_[drawn[i]];
        if (value.value().kind != LoopKind::Unresolved) known.length = value.value().length;
        this->count(solver.statistics());
      }
    });
  }

  void collect() {
    GirthField& field = result_.field;
    field.values.assign(known_.size(), kNone);
    field.kinds.assign(known_.size(), LoopKind::Unresolved);
    result_.states.assign(known_.size(), GirthState::Suspect);
    for (Index site = 0; site < known_.size(); ++site) {
      const Known& known = known_[site];
      const Index vertex = vertexOf_[site];
      field.values[vertex] = known.length;
      field.kinds[vertex] = known.kind;
      if (known.isProved) {
        result_.states[vertex] = GirthState::Proved;
      } else if (known.isThere() && known.kind == LoopKind::Loop && !known.isDoubted &&
                 !contradicts(site)) {
        result_.states[vertex] = GirthState::Consistent;
      }
    }
    field.computed = known_.size();
  }

  /// Whether a site has no loop, or its neighbours' values cannot be true together with its own:
  /// but for jumps, the girth changes by at most twice the way.
  bool contradicts(Index site) const {
    const Known& own = known_[site];
    if (!own.isThere()) return true;
    const auto neighbours = graph_.neighbours(site);
    return std::any_of(neighbours.begin(), neighbours.end(), [&](const Neighbour& other) {
      const double difference = std::fabs(known_[other.site].length - own.length);
      return difference > 2 * other.distance * (1 + kSame);
    });
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
  std::shared_ptr<const Unfolding> unfolding_;  // of the ground
  std::vector<Index> vertexOf_;                 // the vertex of the surface at each site
  std::vector<SurfacePoint> places_;            // of the sites, on the ground
  SiteGraph graph_;
  std::vector<Known> known_;   // of the sites
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
    if (mesh.faceCount() < kFewFaces) return Refinement(mesh, nullptr, options, context).run();
    for (const double turn : {kTurnOfDoubles, kTurnOfSingles}) {
      const auto lean = withoutFlatVertices(mesh, turn, context.ofOneThread());
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
