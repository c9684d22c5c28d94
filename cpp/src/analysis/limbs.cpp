#include "girth/limbs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <mutex>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "analysis/level_rings.h"
#include "analysis/median.h"
#include "analysis/unreached_rest.h"
#include "girth/geodesic_solver.h"
#include "girth/girth_solver.h"
#include "girth/parallel.h"
#include "girth/transfer.h"
#include "infinity.h"
#include "least_between.h"
#include "loops/cut/faces_of_points.h"
#include "loops/tight/taut_loop.h"
#include "mesh/angles.h"
#include "mesh/check_vertex.h"
#include "mesh/neighbours.h"
#include "mesh/vector.h"
#include "no_value.h"
#include "solver/solver_factory.h"

namespace girth {

namespace {

constexpr Index kMostStations = 10'000;
/// From one level to the next, the disk takes up at most this share of its vertices more.
constexpr std::size_t kGrowth = 64;
/// Levels between two of those, to find the base more exactly.
constexpr int kFiner = 64;
/// Parts of a ring in which the girth is looked at.
constexpr std::size_t kShares = 8;
/// Shares of an edge that are no more than rounding.
constexpr double kAtEnd = 1e-9;
/// Lengths that differ by less than this share are equal.
constexpr double kEqualLength = 1e-9;
/// Rings at which loops are looked at, to find the first that has slipped off.
constexpr Index kSteps = 32;
/// Places are found to this share of their range, and lengths that differ by less are one.
constexpr double kExact = 1e-11;
constexpr double kHalf = 0.5;
/// Steps between the two neighbours of a narrow station, to see where it is narrowest.
constexpr int kBetween = 16;
/// How often the distance from the last that holds to that one is halved.
constexpr int kHalvings = 10;

/// How far a ring can go, and why no farther.
struct Reach {
  double distance{0};
  LimbEnd end{LimbEnd::Whole};
};

/// Distances of vertices up to a reach, denser where there are more vertices, and the reach.
std::vector<double> levelsUpTo(double reach, std::span<const double> distances) {
  std::vector<double> sorted;
  std::copy_if(distances.begin(), distances.end(), std::back_inserter(sorted),
               [&](double distance) { return distance > 0 && distance < reach; });
  std::sort(sorted.begin(), sorted.end());
  std::vector<double> levels;
  for (std::size_t i = 0; i < sorted.size(); i += 1 + i / kGrowth) levels.push_back(sorted[i]);
  levels.push_back(reach);
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

/// Until the ring falls apart, meets itself, or reaches the boundary or the end of the surface.
Reach reachOf(const SurfaceMesh& mesh, std::span<const double> distances,
              const UnreachedRest& rest) {
  Reach reach{distances[rest.last], LimbEnd::Whole};
  const auto stopAt = [&](Vertex v, LimbEnd end) {
    if (v != Vertex::none && distances[v] < reach.distance) reach = {distances[v], end};
  };
  stopAt(rest.boundary, LimbEnd::Boundary);
  stopAt(rest.handle, LimbEnd::Handle);

  const std::vector<double> levels = levelsUpTo(reach.distance, distances);
  const std::vector<double> lengths = ringLengths(mesh, distances, rest.leaves, levels);
  // The mean length of the rings so far, times the distance.
  double sum = 0, from = 0, before = 0;
  std::size_t i = 0;
  for (const RestSplit& split : rest.splits) {
    const double here = distances[split.vertex];
    if (here >= reach.distance) break;
    for (; levels[i] < here; ++i) {
      sum += (lengths[i] + before) / 2 * (levels[i] - from);
      from = levels[i];
      before = lengths[i];
    }
    const double mean = (sum + before * (here - from)) / here;
    // A part that is less deep is a bump: the ring passes it by.
    if (split.depth > mean / kPi) stopAt(split.vertex, LimbEnd::Splits);
  }
  return reach;
}

/// By how much a length exceeds the diameter of the circle that is as long as a ring.
double slenderness(double length, double ring) { return length - ring / kPi; }

/// Where the limb ends; nothing where it is nowhere longer than it is thick, beyond `tipLength`.
std::optional<double> baseOf(const SurfaceMesh& mesh, std::span<const double> distances,
                             const UnreachedRest& rest, double reach, double tipLength) {
  const std::vector<double> levels = levelsUpTo(reach, distances);
  const std::vector<double> lengths = ringLengths(mesh, distances, rest.leaves, levels);
  double most = 0;
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (levels[i] < tipLength) continue;
    const double here = slenderness(levels[i], lengths[i]);
    // Wider by more than the limb's radius: what follows is another thing.
    if (best && here < most - lengths[*best] / (2 * kPi)) break;
    if (here > most) {
      most = here;
      best = i;
    }
  }
  if (!best) return std::nullopt;
  const double from = *best > 0 ? levels[*best - 1] : 0;
  const double to = *best + 1 < levels.size() ? levels[*best + 1] : reach;
  std::vector<double> finer;
  for (int i = 1; i < kFiner; ++i) finer.push_back(from + (to - from) * i / kFiner);
  const std::vector<double> finerLengths = ringLengths(mesh, distances, rest.leaves, finer);
  double base = levels[*best];
  for (std::size_t i = 0; i < finer.size(); ++i) {
    const double here = slenderness(finer[i], finerLengths[i]);
    if (!(here > most)) continue;
    most = here;
    base = finer[i];
  }
  return base;
}

/// Measures one limb; keeps its memory.
class LimbMaker {
 public:
  LimbMaker(const std::shared_ptr<const geodesic::Unfolding>& unfolding,
            std::span<const double> girth, Index stations, const ExecutionContext& context)
      : unfolding_(unfolding),
        mesh_(unfolding->mesh()),
        girth_(girth),
        stations_(stations),
        context_(context),
        distanceSolver_(mesh_),
        loopSolver_(SolverFactory::onUnfolding(unfolding)),
        blockedEdge_(mesh_.halfedgeCount(), false),
        visited_(mesh_.vertexCount(), 0) {}

  /// The limb that a tip ends; nothing where there is none.
  Result<std::optional<Limb>> make(const Tip& tip) {
    auto distances = distanceSolver_.distances(SurfacePoint::atVertex(tip.apex),
                                               std::numeric_limits<double>::infinity(), context_);
    if (!distances) return distances.error();
    distances_ = std::move(distances).value();
    rest_ = unreachedRest(mesh_, distances_, tip.apex);
    reach_ = reachOf(mesh_, distances_, rest_);
    const auto base = baseOf(mesh_, distances_, rest_, reach_.distance, tip.apexDistance);
    if (!base) return std::optional<Limb>{};
    Limb limb;
    limb.apex = tip.apex;
    limb.length = *base;
    limb.end = *base < reach_.distance ? LimbEnd::Spreads : reach_.end;
    const auto held = lastThatHolds(limb.apex, tip.apexDistance, limb.length);
    if (!held) return held.error();
    if (!held.value()) return std::optional<Limb>{};
    const double halfWay = limb.length / 2;
    const RingGirth ring = ringsAt({&*held.value(), 1}).front();
    const double diameter = ring.length / kPi;
    // At the far end of a whole body no loop holds, since a tip is there or a round end.
    const bool isWhole = limb.end == LimbEnd::Whole &&
                         limb.length - *held.value() <=
                             std::max(diameter, ringsAt({&halfWay, 1}).front().length / kPi);
    if (!isWhole && *held.value() < limb.length) {
      if (*held.value() <= diameter) return std::optional<Limb>{};
      // A loop reaches no farther than half its length: up to there it slips over the end itself.
      const bool isOverEnd = limb.end == LimbEnd::Splits || limb.end == LimbEnd::Handle;
      if (!isOverEnd || limb.length - *held.value() > ring.middles.front().girth / 2) {
        limb.end = LimbEnd::Slips;
      }
      limb.length = *held.value();
    }
    if (auto error = measure(tip.apexDistance, limb)) return *std::move(error);
    return std::optional(std::move(limb));
  }

 private:
  std::vector<double> levelsOf(double from, double to, Index count) const {
    std::vector<double> levels;
    for (Index i = 1; i < count; ++i) levels.push_back(from + (to - from) * i / count);
    levels.push_back(to);
    return levels;
  }
  std::vector<RingGirth> ringsAt(std::span<const double> levels) const {
    return ringGirths(mesh_, distances_, rest_.leaves, levels, girth_, kShares);
  }

  /// The last ring before loops slip off, on the way from a tip to a length; none where no loop
  /// goes round the limb.
  Result<std::optional<double>> lastThatHolds(Vertex apex, double tipLength, double length) {
    const auto holds = [&](double level, const RingGirth& ring) -> Result<bool> {
      for (const RingPoint& point : ring.middles) {
        const auto loop = loopRound(apex, level, point.place);
        if (!loop) return loop.error();
        if (loop.value()) return true;
      }
      return false;
    };
    std::optional<double> held;
    double slipped = length, heldRadius = 0;
    const std::vector<double> levels = levelsOf(0, length, kSteps);
    const std::vector<RingGirth> rings = ringsAt(levels);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const double level = levels[i];
      if (level < std::min(tipLength, length)) continue;
      const auto isHeld = holds(level, rings[i]);
      if (!isHeld) return isHeld.error();
      if (isHeld.value()) {
        held = slipped = level;
        heldRadius = rings[i].length / (2 * kPi);
        continue;
      }
      if (!held) continue;
      if (slipped == *held) slipped = level;
      // On a shorter way it is a fold or a bump that the loops go round.
      if (level - *held > heldRadius) break;
    }
    for (int i = 0; i < kHalvings && held && *held < slipped; ++i) {
      const double middle = (*held + slipped) / 2;
      const auto isHeld = holds(middle, ringsAt({&middle, 1}).front());
      if (!isHeld) return isHeld.error();
      (isHeld.value() ? *held : slipped) = middle;
    }
    return held;
  }

  /// The loop at a point of the ring at a distance, where it goes round the limb.
  Result<std::optional<GirthLoop>> loopRound(Vertex apex, double distance,
                                             const SurfacePoint& place) {
    auto found = loopSolver_.loop(place, context_);
    if (!found) return found.error();
    GirthLoop& loop = found.value();
    if (loop.kind != LoopKind::Loop) return std::optional<GirthLoop>{};
    const bool isRound = separates(apex, loop.points, distance + loop.length / 2);
    return isRound ? std::optional(std::move(loop)) : std::nullopt;
  }

  /// The vertex that a point is, or an end of its edge that it cannot be distinguished from.
  Vertex vertexAt(const SurfacePoint& point) const {
    const Halfedge h = point.halfedge();
    if (h == Halfedge::none) return point.vertex();
    if (point.weights[1] < kAtEnd) return mesh_.from(h);
    return point.weights[0] < kAtEnd ? mesh_.to(h) : Vertex::none;
  }

  /// Whether no way from the apex leads past the loop to what is farther than `reach`, which no
  /// point of the loop exceeds. Parts that the ring has passed by do not count.
  bool separates(Vertex apex, std::span<const SurfacePoint> loop, double reach) {
    const auto block = [&](bool blocked) {
      for (const SurfacePoint& point : loop) {
        const Halfedge h = point.halfedge();
        if (h == Halfedge::none) continue;
        blockedEdge_[h] = blocked;
        if (mesh_.twin(h) != Halfedge::none) blockedEdge_[mesh_.twin(h)] = blocked;
      }
    };
    block(true);
    ++visit_;
    for (const SurfacePoint& point : loop) {
      const Vertex v = vertexAt(point);
      if (v != Vertex::none) visited_[v] = visit_;
    }
    std::vector<Vertex> reached;
    const auto go = [&](Vertex v) {
      if (visited_[v] == visit_) return;
      visited_[v] = visit_;
      reached.push_back(v);
    };
    go(apex);
    bool passed = reached.empty();
    for (std::size_t i = 0; i < reached.size() && !passed; ++i) {
      forEachEdge(mesh_, reached[i], [&](Halfedge h, Vertex neighbour) {
        if (blockedEdge_[h] || visited_[neighbour] == visit_) return;
        go(neighbour);
        passed =
            passed || (distances_[neighbour] > reach && rest_.leaves[neighbour] >= reach_.distance);
      });
    }
    block(false);
    return !passed;
  }

  /// A ring, and the loop that measures the least girth on it.
  struct Measured {
    GirthStation station;
    std::vector<SurfacePoint> loop;
  };

  /// The first of a ring's points whose loop goes round the limb.
  std::optional<Error> findLeast(Vertex apex, const std::vector<RingPoint>& points,
                                 Measured& ring) {
    for (const RingPoint& point : points) {
      auto loop = loopRound(apex, ring.station.distance, point.place);
      if (!loop) return loop.error();
      if (!loop.value()) continue;
      take(*std::move(loop).value(), point.place, ring);
      return measureExactly(apex, points, ring);
    }
    return std::nullopt;
  }

  static void take(GirthLoop loop, const SurfacePoint& place, Measured& ring) {
    ring.station.least = loop.length;
    ring.station.place = place;
    ring.loop = std::move(loop.points);
  }

  /// Where triangles are as large as the limb is thick, the girth is greater between vertices than
  /// at both, so a median between them may be less than the least. Then the points of equal shares
  /// are asked for the exact girth.
  std::optional<Error> measureExactly(Vertex apex, const std::vector<RingPoint>& points,
                                      Measured& ring) {
    GirthStation& station = ring.station;
    if (station.least <= station.median * (1 + kEqualLength)) return std::nullopt;
    std::vector<double> values;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto value = loopSolver_.value(points[i].place, context_);
      if (!value) return value.error();
      values.push_back(value.value().length);
      if (!(values.back() < station.least)) continue;
      auto loop = loopRound(apex, station.distance, points[i].place);
      if (!loop) return loop.error();
      if (loop.value()) take(*std::move(loop).value(), points[i].place, ring);
    }
    if (!values.empty()) station.median = medianOf(std::move(values));
    return std::nullopt;
  }

  /// The mean distance of a curve from the apex, by length.
  double meanDistance(std::span<const SurfacePoint> curve) const {
    const std::vector<double> at = interpolated(mesh_, distances_, curve);
    double sum = 0, length = 0;
    for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
      const double piece = norm(positionOf(mesh_, curve[i + 1]) - positionOf(mesh_, curve[i]));
      sum += piece * (at[i] + at[i + 1]) / 2;
      length += piece;
    }
    return sum / length;
  }

  /// The ring at a distance.
  Result<Measured> measuredAt(Vertex apex, double distance, const RingGirth& of) {
    Measured ring{{distance, of.length, of.median, kNoValue, {}}, {}};
    if (auto error = findLeast(apex, of.points, ring)) return *std::move(error);
    return ring;
  }

  /// The distance between two others where the least girth on the ring is least, as far as even
  /// steps show where to look; `start` is what is known.
  Result<Measured> narrowestBetween(Vertex apex, double from, double to, const Measured& start) {
    Measured best = start;
    std::optional<Error> failed;
    const auto leastAt = [&](double distance) {
      if (failed) return kInfinity;
      if (distance == best.station.distance) return best.station.least;
      auto ring = measuredAt(apex, distance, ringsAt({&distance, 1}).front());
      if (!ring) failed = ring.error();
      if (failed || std::isnan(ring.value().station.least)) return kInfinity;
      const double least = ring.value().station.least;
      if (least < best.station.least) best = std::move(ring).value();
      return least;
    };
    const double step = (to - from) / kBetween;
    for (int i = 0; i <= kBetween; ++i) leastAt(from + i * step);
    const double middle = best.station.distance;
    leastBetween(leastAt, std::max(from, middle - step), std::min(to, middle + step), middle,
                 kExact * (to - from));
    if (failed) return *std::move(failed);
    return best;
  }

  /// Moves the place of a ring's least girth along the ring to where the girth is least, exactly.
  std::optional<Error> refineAlong(Vertex apex, Measured& ring) {
    std::vector<RingSegment> segments =
        ringSegments(mesh_, distances_, rest_.leaves, ring.station.distance);
    std::optional<Error> failed;
    for (bool isLess = true; isLess && !failed;) {
      isLess = false;
      const Vec3 here = positionOf(mesh_, ring.station.place);
      const auto isHere = [&](const SurfacePoint& point) {
        return norm(positionOf(mesh_, point) - here) <= kEqualLength * ring.station.least;
      };
      const auto met = std::partition(segments.begin(), segments.end(), [&](const auto& segment) {
        return !isHere(segment.from) && !isHere(segment.to);
      });
      const std::vector<RingSegment> near(met, segments.end());
      segments.erase(met, segments.end());
      for (const RingSegment& segment : near) {
        const auto tryAt = [&](double share) {
          if (failed) return kInfinity;
          const SurfacePoint place =
              loops::pointBetween(mesh_, segment.face, segment.from, segment.to, share);
          auto loop = loopRound(apex, ring.station.distance, place);
          if (!loop) failed = loop.error();
          if (failed || !loop.value()) return kInfinity;
          const double length = loop.value()->length;
          if (length < ring.station.least * (1 - kExact)) {
            take(*std::move(loop).value(), place, ring);
            isLess = true;
          }
          return length;
        };
        tryAt(isHere(segment.from) ? 1 : 0);
        leastBetween(tryAt, 0, 1, kHalf, kExact);
      }
    }
    return failed;
  }

  /// The mean distance of a neck, where it goes round the limb between the tip and the base.
  std::optional<double> distanceOf(const loops::TautLoop& neck, double length, double from,
                                   const Limb& limb) {
    const std::vector<SurfacePoint> middle = loops::bandOf(*unfolding_, neck, mesh_.area()).middle;
    const double distance = meanDistance(middle);
    const bool isRound = distance >= from && distance <= limb.length &&
                         separates(limb.apex, middle, distance + length / 2);
    return isRound ? std::optional(distance) : std::nullopt;
  }

  /// Where the limb is narrowest: a neck, one of its ends, or a place where loops slip off. Each is
  /// near one of the rings, in rising order, that are narrower than both their neighbours.
  std::optional<Error> findNarrowest(double from, const std::vector<Measured>& rings, Limb& limb) {
    limb.narrowest = limb.narrowestDistance = kNoValue;
    const auto isLess = [](double a, double b) { return a < b * (1 - kEqualLength); };
    const auto consider = [&](const LeastValue& place) {
      if (std::isnan(limb.narrowest) || isLess(place.value, limb.narrowest)) {
        limb.narrowestDistance = place.at;
      }
      if (!(place.value >= limb.narrowest)) limb.narrowest = place.value;
    };
    for (std::size_t i = 0; i < rings.size(); ++i) {
      const GirthStation& station = rings[i].station;
      if (std::isnan(station.least)) continue;
      consider({station.distance, station.least});
      // Whether a neighbour has a wider loop or none; nothing where it has a narrower one.
      const auto isWider = [&](std::size_t k) -> std::optional<bool> {
        if (k >= rings.size()) return true;
        if (isLess(rings[k].station.least, station.least)) return std::nullopt;
        return !(rings[k].station.least <= station.least * (1 + kEqualLength));
      };
      const auto before = isWider(i - 1), behind = isWider(i + 1);
      if (!before || !behind) continue;
      if (const auto neck = loops::neckFrom(*unfolding_, rings[i].loop, mesh_.area())) {
        const double length = loops::lengthOf(*unfolding_, *neck);
        // Nothing that can be drawn tight to it is shorter.
        if (!isLess(length, limb.narrowest)) continue;
        if (const auto distance = distanceOf(*neck, length, from, limb)) {
          consider({*distance, length});
          continue;
        }
      }
      // Between equal ones a loop can be shifted along the limb.
      if (!*before && !*behind) continue;
      auto least = narrowestBetween(
          limb.apex, i > 0 ? rings[i - 1].station.distance : from,
          i + 1 < rings.size() ? rings[i + 1].station.distance : limb.length, rings[i]);
      if (!least) return least.error();
      if (auto error = refineAlong(limb.apex, least.value())) return error;
      consider({least.value().station.distance, least.value().station.least});
    }
    return std::nullopt;
  }

  /// Measures the part that the ring at the base cuts off, and how thick the limb is all along.
  /// Loops in the tip itself, up to `tipLength`, have slipped off it.
  std::optional<Error> measure(double tipLength, Limb& limb) {
    for (const Vertex v : mesh_.vertices()) {
      if (!std::isfinite(distances_[v])) continue;
      if (limb.end != LimbEnd::Whole && !(distances_[v] < limb.length) &&
          !(rest_.leaves[v] < limb.length)) {
        continue;
      }
      limb.vertices.push_back(v);
      limb.distances.push_back(distances_[v]);
    }
    const std::vector<double> levels = levelsOf(0, limb.length, stations_);
    const std::vector<RingGirth> rings = ringsAt(levels);
    const double from = std::min(tipLength, limb.length);
    std::vector<double> medians;
    std::vector<Measured> all;
    const auto add = [&](double level, const RingGirth& of) -> std::optional<Error> {
      auto ring = measuredAt(limb.apex, level, of);
      if (!ring) return ring.error();
      all.push_back(std::move(ring).value());
      return std::nullopt;
    };
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (levels[i] < from) {
        limb.profile.push_back({levels[i], rings[i].length, rings[i].median, kNoValue, {}});
        continue;
      }
      // The limb begins between two stations.
      if (all.empty() && from > 0 && from < levels[i]) {
        if (auto error = add(from, ringsAt({&from, 1}).front())) return error;
      }
      if (auto error = add(levels[i], rings[i])) return error;
      const GirthStation& station = limb.profile.emplace_back(all.back().station);
      if (!std::isnan(station.least)) medians.push_back(station.median);
    }
    limb.median = medians.empty() ? kNoValue : medianOf(std::move(medians));
    limb.middle = kNoValue;
    if (const double half = limb.length / 2; half >= from) {
      auto ring = measuredAt(limb.apex, half, ringsAt({&half, 1}).front());
      if (!ring) return ring.error();
      if (!std::isnan(ring.value().station.least)) {
        if (auto error = refineAlong(limb.apex, ring.value())) return error;
      }
      limb.middle = ring.value().station.least;
    }
    // A needle on the cap is not where the limb is narrowest.
    double body = from;
    if (const double cap = limb.middle / std::numbers::pi; cap > from && cap < limb.length) {
      body = cap;
      std::erase_if(all, [&](const Measured& ring) { return ring.station.distance < body; });
      if (all.empty() || all.front().station.distance > body) {
        auto ring = measuredAt(limb.apex, body, ringsAt({&body, 1}).front());
        if (!ring) return ring.error();
        all.insert(all.begin(), std::move(ring).value());
      }
    }
    if (auto error = findNarrowest(body, all, limb)) return error;
    limb.base = limb.end == LimbEnd::Whole ? kNoValue : limb.profile.back().least;
    return std::nullopt;
  }

  std::shared_ptr<const geodesic::Unfolding> unfolding_;
  const SurfaceMesh& mesh_;
  std::span<const double> girth_;
  Index stations_;
  const ExecutionContext& context_;
  GeodesicSolver distanceSolver_;
  GirthSolver loopSolver_;
  std::vector<double> distances_;  // from the apex
  UnreachedRest rest_;
  Reach reach_;
  std::vector<bool> blockedEdge_;  // by halfedge
  std::vector<Index> visited_;     // by vertex: the search that has visited it
  Index visit_{0};
};

bool limbContains(const Limb& limb, Vertex vertex) {
  return std::binary_search(limb.vertices.begin(), limb.vertices.end(), vertex);
}

}  // namespace

std::string_view toString(LimbEnd end) {
  switch (end) {
    case LimbEnd::Spreads:
      return "spreads";
    case LimbEnd::Slips:
      return "slips";
    case LimbEnd::Splits:
      return "splits";
    case LimbEnd::Handle:
      return "handle";
    case LimbEnd::Boundary:
      return "boundary";
    case LimbEnd::Whole:
      break;
  }
  return "whole";
}

Result<Limbs> findLimbs(const SurfaceMesh& mesh, std::span<const double> girth,
                        std::span<const Tip> tips, const LimbOptions& options,
                        const ExecutionContext& context) {
  if (girth.size() != mesh.vertexCount()) {
    return makeError(ErrorCode::Usage, -1,
                     std::to_string(girth.size()) + " values for " +
                         std::to_string(mesh.vertexCount()) + " vertices");
  }
  if (options.stations < 1 || options.stations > kMostStations) {
    return makeError(ErrorCode::InvalidOption, -1,
                     std::to_string(options.stations) + " stations: 1 to " +
                         std::to_string(kMostStations) + " are possible");
  }
  for (const Tip& tip : tips) {
    if (auto error = checkVertex(mesh, tip.apex)) return *std::move(error);
  }

  const auto unfolding = std::make_shared<const geodesic::Unfolding>(mesh);
  std::vector<std::optional<Limb>> found(tips.size());
  std::mutex mutex;
  std::optional<Error> failed;
  const bool done = parallelFor(tips.size(), 1, context, [&](std::size_t begin, std::size_t end) {
    LimbMaker maker(unfolding, girth, options.stations, context);
    for (std::size_t i = begin; i < end; ++i) {
      auto limb = maker.make(tips[i]);
      if (limb) {
        found[i] = std::move(limb).value();
        continue;
      }
      const std::lock_guard lock(mutex);
      if (!failed) failed = limb.error();
    }
  });
  if (context.cancelled() || !done) return makeError(ErrorCode::Cancelled, -1, "cancelled");
  if (failed) return *std::move(failed);

  Limbs result;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i]) {
      result.tipsWithoutLimb.push_back(static_cast<Index>(i));
      continue;
    }
    found[i]->tips.push_back(static_cast<Index>(i));
    result.limbs.push_back(*std::move(found[i]));
  }
  std::stable_sort(result.limbs.begin(), result.limbs.end(),
                   [](const Limb& a, const Limb& b) { return a.length > b.length; });
  // Equally long limbs, such as a spindle from both ends: first the one whose narrowest place is
  // nearer.
  for (auto begin = result.limbs.begin(); begin != result.limbs.end();) {
    const auto end = std::find_if(begin, result.limbs.end(), [&](const Limb& limb) {
      return limb.length < begin->length * (1 - kEqualLength);
    });
    const auto nearest = [](const Limb& limb) {
      return std::isnan(limb.narrowestDistance) ? kInfinity : limb.narrowestDistance;
    };
    std::stable_sort(begin, end,
                     [&](const Limb& a, const Limb& b) { return nearest(a) < nearest(b); });
    begin = end;
  }
  // Two tips may end one limb, such as the corners of a hoof: each lies in the limb of the other.
  std::vector<Limb> kept, candidates;
  candidates.swap(result.limbs);
  for (Limb& limb : candidates) {
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const Limb& other) {
      return limbContains(other, limb.apex) && limbContains(limb, other.apex);
    });
    if (same != kept.end()) {
      same->tips.insert(same->tips.end(), limb.tips.begin(), limb.tips.end());
    } else {
      kept.push_back(std::move(limb));
    }
  }
  // The whole of a component is no limb beside one that has a base.
  for (const Limb& limb : kept) {
    const bool isLimb = limb.end != LimbEnd::Whole ||
                        std::none_of(kept.begin(), kept.end(), [&](const Limb& other) {
                          return other.end != LimbEnd::Whole && limbContains(limb, other.apex);
                        });
    if (isLimb) {
      result.limbs.push_back(limb);
    } else {
      result.tipsWithoutLimb.insert(result.tipsWithoutLimb.end(), limb.tips.begin(),
                                    limb.tips.end());
    }
  }
  std::sort(result.tipsWithoutLimb.begin(), result.tipsWithoutLimb.end());
  return result;
}

}  // namespace girth
