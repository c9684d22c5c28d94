#include "analysis/inscribed_circle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <utility>

#include "infinity.h"

namespace girth {
namespace {

/// No square may exceed the best circle by more than this share of its radius.
constexpr double kEnoughOfCircle = 1e-12;
/// A corner within this share of the extent of the line through its neighbours is none.
constexpr double kStraightShare = 1e-15;
constexpr std::size_t kMostSquares = 100'000;
/// Sides are added to a linear program at most so often.
constexpr int kMostCircleSteps = 16;

struct PolygonSide {
  Point2 from, to;
};

/// How far a side lies from the centre of a square, and at most from its points: `distance` + slope
/// · y, for y from the centre, + `bend`.
struct AwayFromSide {
  double distance;
  Point2 slope;
  double bend;

  double at(const Point2& y) const { return distance + slope.x * y.x + slope.y * y.y; }
};

/// The sides of a ring, those of one line as one.
void addSidesOfRing(const std::vector<Point2>& ring, double extent,
                    std::vector<PolygonSide>& sides) {
  const auto isOnLine = [&](const Point2& a, const Point2& b, const Point2& c) {
    const double length = std::hypot(c.x - a.x, c.y - a.y);
    const double along = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
    return along >= 0 && std::fabs(cross(a, b, c)) <= kStraightShare * extent * length;
  };
  std::vector<Point2> corners;
  for (const Point2& p : ring) {
    while (corners.size() >= 2 && isOnLine(corners[corners.size() - 2], corners.back(), p)) {
      corners.pop_back();
    }
    corners.push_back(p);
  }
  while (corners.size() >= 3 && isOnLine(corners[corners.size() - 2], corners.back(), corners[0])) {
    corners.pop_back();
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sides.push_back({corners[i], corners[(i + 1) % corners.size()]});
  }
}

class CircleSearch {
 public:
  explicit CircleSearch(const std::vector<std::vector<Point2>>& rings) {
    Point2 low{kInfinity, kInfinity}, high{-kInfinity, -kInfinity};
    for (const auto& ring : rings) {
      for (const Point2& p : ring) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
    extent_ = std::max(high.x - low.x, high.y - low.y);
    if (!(extent_ > 0) || !std::isfinite(extent_)) return;
    for (const auto& ring : rings) addSidesOfRing(ring, extent_, sides_);
    Square whole{{(low.x + high.x) / 2, (low.y + high.y) / 2}, extent_ / 2, 0, false, {}};
    whole.sides.resize(sides_.size());
    for (std::size_t i = 0; i < sides_.size(); ++i) whole.sides[i] = static_cast<std::uint32_t>(i);
    add(std::move(whole), false);
  }

  InscribedCircle find() {
    for (std::size_t count = 0; !open_.empty() && count < kMostSquares; ++count) {
      if (open_.top().bound <= best_.radius * (1 + kEnoughOfCircle)) break;
      const Square square = open_.top();
      open_.pop();
      const double half = square.half / 2;
      if (!(half > kStraightShare * extent_)) continue;
      for (const double dx : {-half, half}) {
        for (const double dy : {-half, half}) {
          add({{square.centre.x + dx, square.centre.y + dy},
               half,
               0,
               square.isInside,
               square.sides},
              square.isInside);
        }
      }
    }
    return best_;
  }

 private:
  /// `sides`: all that are nearest to some point of it. `isInside`: all of it lies inside.
  struct Square {
    Point2 centre;
    double half, bound;
    bool isInside;
    std::vector<std::uint32_t> sides;

    bool operator<(const Square& other) const { return bound < other.bound; }
  };

  static double squareFrom(const Point2& p, const PolygonSide& side) {
    const double ux = side.to.x - side.from.x, uy = side.to.y - side.from.y;
    const double wx = p.x - side.from.x, wy = p.y - side.from.y;
    const double length = ux * ux + uy * uy;
    const double share = length > 0 ? std::clamp((ux * wx + uy * wy) / length, 0.0, 1.0) : 0;
    const double dx = wx - share * ux, dy = wy - share * uy;
    return dx * dx + dy * dy;
  }

  bool isInside(const Point2& p) const {
    bool isIn = false;
    for (const auto& [a, b] : sides_) {
      if ((a.y > p.y) == (b.y > p.y)) continue;
      if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) isIn = !isIn;
    }
    return isIn;
  }

  static AwayFromSide awayFrom(const Point2& p, const PolygonSide& side, double radius) {
    const double ux = side.to.x - side.from.x, uy = side.to.y - side.from.y;
    const double wx = p.x - side.from.x, wy = p.y - side.from.y;
    const double length = std::sqrt(ux * ux + uy * uy), along = (ux * wx + uy * wy) / length;
    if (along >= radius && along <= length - radius) {
      // The nearest point of the line lies on the side, from wherever in the square.
      const double height = (ux * wy - uy * wx) / length, sign = height < 0 ? -1 : 1;
      return {sign * height, {-sign * uy / length, sign * ux / length}, 0};
    }
    const double share = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
    const double dx = wx - share * ux, dy = wy - share * uy, distance = std::hypot(dx, dy);
    if (!(distance > 0)) return {0, {0, 0}, radius};
    return {distance, {dx / distance, dy / distance}, radius * radius / (2 * distance)};
  }

  /// Where the least of up to four linear functions is greatest in the square of half-width `half`
  /// round 0, and that value. The optimum is a corner, a point of an edge where two are equal, or
  /// one where three are.
  static std::pair<Point2, double> topOf(const std::vector<AwayFromSide>& among, double half) {
    std::pair<Point2, double> top{{0, 0}, -kInfinity};
    const auto take = [&](Point2 y) {
      if (!(std::fabs(y.x) <= half * (1 + 1e-9)) || !(std::fabs(y.y) <= half * (1 + 1e-9))) return;
      y = {std::clamp(y.x, -half, half), std::clamp(y.y, -half, half)};
      double least = kInfinity;
      for (const AwayFromSide& one : among) least = std::min(least, one.at(y));
      if (least > top.second) top = {y, least};
    };
    for (const double x : {-half, half}) {
      for (const double y : {-half, half}) take({x, y});
    }
    for (std::size_t i = 0; i < among.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        // Where i and j are equal: a · y = c.
        const Point2 a{among[i].slope.x - among[j].slope.x, among[i].slope.y - among[j].slope.y};
        const double c = among[j].distance - among[i].distance;
        for (const double edge : {-half, half}) {
          if (a.y != 0) take({edge, (c - a.x * edge) / a.y});
          if (a.x != 0) take({(c - a.y * edge) / a.x, edge});
        }
        for (std::size_t k = 0; k < j; ++k) {
          const Point2 b{among[i].slope.x - among[k].slope.x, among[i].slope.y - among[k].slope.y};
          const double d = among[k].distance - among[i].distance;
          const double area = a.x * b.y - a.y * b.x;
          if (area != 0) take({(c * b.y - d * a.y) / area, (a.x * d - b.x * c) / area});
        }
      }
    }
    return top;
  }

  /// Takes the circle round a point, if it is the largest so far.
  void propose(const Point2& centre, const std::vector<std::uint32_t>& near, bool isIn) {
    double square = kInfinity;
    const double least = best_.radius * best_.radius;
    for (const std::uint32_t i : near) {
      square = std::min(square, squareFrom(centre, sides_[i]));
      if (square <= least) return;
    }
    if (isIn || isInside(centre)) best_ = {centre, std::sqrt(square)};
  }

  /// Bounds a square, of which `square.sides` has too many sides, and keeps it where it may have a
  /// larger circle.
  void add(Square square, bool isWithin) {
    const double radius = square.half * std::sqrt(2.0);
    std::vector<double> distances;
    double least = kInfinity;
    for (const std::uint32_t i : square.sides) {
      distances.push_back(std::sqrt(squareFrom(square.centre, sides_[i])));
      least = std::min(least, distances.back());
    }
    if (least + radius <= best_.radius * (1 + kEnoughOfCircle)) return;
    const bool isIn = isWithin || isInside(square.centre);
    if (!isIn && least >= radius) return;
    std::size_t kept = 0;
    // A point of the square is at most `least` + radius from its nearest side.
    const double reach = (least + 2 * radius) * (1 + kEnoughOfCircle);
    for (std::size_t k = 0; k < distances.size(); ++k) {
      if (distances[k] <= reach) square.sides[kept++] = square.sides[k];
    }
    square.sides.resize(kept);
    square.isInside = isIn && least >= radius;
    square.bound = least + radius;
    if (square.isInside) {
      square.bound = std::min(square.bound, boundInside(square, radius));
    } else if (isIn) {
      propose(square.centre, square.sides, true);
    }
    if (square.bound > best_.radius * (1 + kEnoughOfCircle)) open_.push(std::move(square));
  }

  /// The linear program: sides are added while one of them is nearer at its optimum.
  double boundInside(const Square& square, double radius) {
    std::vector<AwayFromSide> all;
    for (const std::uint32_t i : square.sides) {
      all.push_back(awayFrom(square.centre, sides_[i], radius));
    }
    const auto nearestAt = [&](const Point2& y) {
      return std::min_element(all.begin(), all.end(),
                              [&](const AwayFromSide& one, const AwayFromSide& other) {
                                return one.at(y) < other.at(y);
                              });
    };
    std::vector<AwayFromSide> among{*nearestAt({0, 0})};
    double bound = kInfinity;
    std::pair<Point2, double> top{};
    for (int step = 0; step < kMostCircleSteps; ++step) {
      top = topOf(among, square.half);
      double bend = 0;
      for (const AwayFromSide& one : among) bend = std::max(bend, one.bend);
      bound = std::min(bound, top.second + bend);
      const auto nearest = nearestAt(top.first);
      if (nearest->at(top.first) >= top.second - kStraightShare * extent_) break;
      if (among.size() == 4) {
        among.erase(std::max_element(among.begin(), among.end(),
                                     [&](const AwayFromSide& one, const AwayFromSide& other) {
                                       return one.at(top.first) < other.at(top.first);
                                     }));
      }
      among.push_back(*nearest);
    }
    propose({square.centre.x + top.first.x, square.centre.y + top.first.y}, square.sides, true);
    return bound;
  }

  double extent_{0};
  std::vector<PolygonSide> sides_;
  InscribedCircle best_;
  std::priority_queue<Square> open_;
};

}  // namespace

InscribedCircle inscribedCircle(const std::vector<std::vector<Point2>>& rings) {
  return CircleSearch(rings).find();
}

}  // namespace girth
