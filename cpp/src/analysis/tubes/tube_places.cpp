#include "analysis/tubes/tube_places.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

#include "analysis/tubes/centreline.h"
#include "infinity.h"
#include "least_between.h"
#include "mesh/vector.h"
#include "no_value.h"

namespace girth::tubes {
namespace {

/// A side is where the diameter rises no more than a tube tapers: by this share of the way ...
constexpr double kTaper = 0.05;
/// ... and this share of itself, for rounding and rough surfaces, ...
constexpr double kRough = 0.005;
/// ... along so many diameters, and at least to the next station.
constexpr double kSideLength = 0.3;
/// From there on, the best place within this share of the way to the narrowing is taken.
constexpr double kFarther = 0.5;
/// Places whose ranges overlap by more than this share of one of them exclude each other.
constexpr double kOverlap = 0.25;
/// The place of the least section is found to this share of the stations' distance.
constexpr double kExact = 1e-6;

/// Looks for places of one kind along one branch.
class PlaceSearch {
 public:
  PlaceSearch(const SurfaceMesh& mesh, const TubeTree& tree, Index branch,
              std::span<const TubeStation> stations, const TubesOptions& options, TubeChange change)
      : mesh_(mesh),
        tree_(tree),
        branch_(branch),
        stations_(stations),
        closed_(tree.closedEndsOf(tree.branches[branch])),
        options_(options),
        change_(change) {}

  std::vector<TubePlace> run() const {
    std::vector<std::size_t> order;
    for (std::size_t i = 1; i + 1 < stations_.size(); ++i) {
      if (height(i) <= height(i - 1) && height(i) <= height(i + 1)) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return height(a) < height(b); });
    std::vector<TubePlace> found;
    for (const std::size_t i : order) {
      const double at = stations_[i].distance;
      const bool isWithin = std::any_of(found.begin(), found.end(), [&](const TubePlace& place) {
        return at >= place.beforeDistance && at <= place.beyondDistance;
      });
      if (isWithin) continue;
      if (auto place = placeAt(i)) found.push_back(*std::move(place));
    }
    return found;
  }

 private:
  /// A number that is least at the places that are looked for.
  double height(std::size_t i) const { return sign() * stations_[i].equivalentDiameter; }
  double sign() const { return change_ == TubeChange::Narrowing ? 1 : -1; }

  /// The side of a place: the nearest station from which the height rises no more. Nothing at a
  /// closed end.
  std::optional<std::size_t> sideOf(std::size_t place, bool isBeyond) const {
    const std::size_t last = isBeyond ? stations_.size() - 1 : 0;
    const auto next = [&](std::size_t i) { return isBeyond ? i + 1 : i - 1; };
    const auto way = [&](std::size_t a, std::size_t b) {
      return std::fabs(stations_[a].distance - stations_[b].distance);
    };
    const auto isSide = [&](std::size_t i) {
      const double diameter = stations_[i].equivalentDiameter;
      for (std::size_t k = i; k != last;) {
        k = next(k);
        if (k != next(i) && way(k, i) > kSideLength * diameter) break;
        if (height(k) - height(i) > kTaper * way(k, i) + kRough * diameter) return false;
      }
      return true;
    };
    std::size_t side = place;
    do {
      if (side == last) break;
      side = next(side);
    } while (!isSide(side));
    // The rest of the rise, which is flatter than a taper.
    std::size_t best = side;
    for (std::size_t k = side; k != last;) {
      k = next(k);
      if (way(k, side) > kFarther * way(side, place) || !isSide(k)) break;
      if (height(k) > height(best)) best = k;
    }
    const bool isClosed = isBeyond ? closed_.above : closed_.below;
    // A cap is as long as half its diameter, or shorter.
    if (isClosed && way(best, last) < stations_[best].equivalentDiameter / 2) return std::nullopt;
    return best;
  }

  /// The section between two stations, a share of the way from the first.
  std::optional<SectionCurve> between(std::size_t first, double share, bool inscribed) const {
    const TubeStation &a = stations_[first], &b = stations_[first + 1];
    const Vec3 direction = (1 - share) * a.direction + share * b.direction;
    return sectionOf(mesh_, tree_, branch_, a.centre + share * (b.centre - a.centre),
                     (1 / norm(direction)) * direction, inscribed);
  }

  std::optional<TubePlace> placeAt(std::size_t i) const {
    const auto before = sideOf(i, false), beyond = sideOf(i, true);
    if (!before || !beyond) return std::nullopt;
    TubePlace place;
    place.change = change_;
    const TubeStation &one = stations_[*before], &other = stations_[*beyond];
    place.beforeDistance = one.distance;
    place.beyondDistance = other.distance;
    place.beforeDiameter = one.equivalentDiameter;
    place.beyondDiameter = other.equivalentDiameter;
    place.girth = kNoValue;
    measure(i, place);
    place.reference = referenceAt(place, place.distance);
    const double ratio = place.equivalentDiameter / place.reference;
    place.degreeByDiameter = sign() * (1 - ratio);
    place.degreeByArea = sign() * (1 - ratio * ratio);
    // The side that differs less.
    const double nearer =
        sign() * std::min(sign() * place.beforeDiameter, sign() * place.beyondDiameter);
    const double least = sign() * (1 - place.equivalentDiameter / nearer);
    if (!(std::min(least, place.degreeByDiameter) >= options_.leastDegree)) return std::nullopt;
    place.length = lengthOf(place, i);
    return place;
  }

  /// Finds where the section is least, or greatest, near a station.
  void measure(std::size_t i, TubePlace& place) const {
    const auto areaAt = [&](double t) {
      const std::size_t first = t < 0 ? i - 1 : i;
      const auto curve = between(first, t < 0 ? t + 1 : t, false);
      return curve ? sign() * curve->area : kInfinity;
    };
    const LeastValue least = leastBetween(areaAt, -1, 1, 0, kExact);
    const double t = least.at;
    const std::size_t first = t < 0 ? i - 1 : i;
    const double share = t < 0 ? t + 1 : t;
    const TubeStation &a = stations_[first], &b = stations_[first + 1];
    place.distance = a.distance + share * (b.distance - a.distance);
    const auto take = [&](auto&& from) {
      place.equivalentDiameter = from.equivalentDiameter;
      place.area = from.area;
      place.perimeter = from.perimeter;
      place.inscribedDiameter = from.inscribedDiameter;
      place.leastWidth = from.leastWidth;
      place.centre = from.centre;
      place.points = std::forward<decltype(from)>(from).points;
    };
    auto curve = between(first, share, true);
    if (curve && sign() * curve->area <= sign() * stations_[i].area) {
      take(*std::move(curve));
    } else {
      place.distance = stations_[i].distance;
      take(stations_[i]);
    }
  }

  double taperAt(const TubePlace& place, double distance) const {
    const double share =
        (distance - place.beforeDistance) / (place.beyondDistance - place.beforeDistance);
    return (1 - share) * place.beforeDiameter + share * place.beyondDiameter;
  }

  double referenceAt(const TubePlace& place, double distance) const {
    switch (options_.reference) {
      case TubeReference::Taper:
        return taperAt(place, distance);
      case TubeReference::Mean:
        return (place.beforeDiameter + place.beyondDiameter) / 2;
      case TubeReference::Beyond:
        return place.beyondDiameter;
      case TubeReference::Before:
        return place.beforeDiameter;
    }
    return kNoValue;
  }

  /// How far the half of the difference from the taper reaches.
  double lengthOf(const TubePlace& place, std::size_t i) const {
    const auto difference = [&](std::size_t k) {
      return sign() * (taperAt(place, stations_[k].distance) - stations_[k].equivalentDiameter);
    };
    const double half = sign() * (taperAt(place, place.distance) - place.equivalentDiameter) / 2;
    const auto reach = [&](bool isBeyond) {
      std::size_t k = i;
      for (;;) {
        const std::size_t next = isBeyond ? k + 1 : k - 1;
        if (next >= stations_.size()) return stations_[k].distance;
        if (difference(next) < half) {
          const double share = (difference(k) - half) / (difference(k) - difference(next));
          return stations_[k].distance +
                 std::clamp(share, 0.0, 1.0) * (stations_[next].distance - stations_[k].distance);
        }
        k = next;
      }
    };
    return reach(true) - reach(false);
  }

  const SurfaceMesh& mesh_;
  const TubeTree& tree_;
  const Index branch_;
  std::span<const TubeStation> stations_;
  const ClosedEnds closed_;
  const TubesOptions& options_;
  const TubeChange change_;
};

/// Leaves out what lies between two places of the other kind: a sound part between two narrowings
/// is no widening. Where a narrowing and a widening overlap, the one nearer to the median goes.
void dropBetween(std::vector<TubePlace>& places, double median) {
  const auto deviation = [&](const TubePlace& place) {
    return std::fabs(std::log(place.equivalentDiameter / median));
  };
  const auto isWorse = [&](const TubePlace& one, const TubePlace& other) {
    const double overlap = std::min(one.beyondDistance, other.beyondDistance) -
                           std::max(one.beforeDistance, other.beforeDistance);
    return one.change != other.change &&
           overlap > kOverlap * (one.beyondDistance - one.beforeDistance) &&
           deviation(one) < deviation(other);
  };
  std::vector<TubePlace> kept;
  for (const TubePlace& one : places) {
    const bool isDropped = std::any_of(places.begin(), places.end(),
                                       [&](const TubePlace& other) { return isWorse(one, other); });
    if (!isDropped) kept.push_back(one);
  }
  places = std::move(kept);
}

}  // namespace

std::vector<TubePlace> findPlaces(const SurfaceMesh& mesh, const TubeTree& tree, Index treeBranch,
                                  std::span<const TubeStation> stations, double median,
                                  const TubesOptions& options) {
  std::vector<TubePlace> all;
  for (const TubeChange change : {TubeChange::Narrowing, TubeChange::Widening}) {
    const PlaceSearch search(mesh, tree, treeBranch, stations, options, change);
    for (TubePlace& place : search.run()) all.push_back(std::move(place));
  }
  dropBetween(all, median);
  std::stable_sort(all.begin(), all.end(), [](const TubePlace& one, const TubePlace& other) {
    return one.distance < other.distance;
  });
  return all;
}

}  // namespace girth::tubes
