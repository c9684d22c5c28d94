#include "solver/persistence/superlevel_pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace girth {

using geodesic::cross;
using geodesic::Crossing;
using geodesic::dot;
using geodesic::kTouch;
using geodesic::norm;
using geodesic::Propagation;
using geodesic::Unfolding;
using geodesic::Vec2;

namespace {

constexpr std::size_t kMostCells = 128;
/// Paths of lengths and directions so near each other arrive as one.
constexpr double kSamePoint = 1e-8, kSameRay = 1e-6;
constexpr std::size_t kNoPie = static_cast<std::size_t>(-1);

/// The part of a segment that lies in a disk: from one share of it to another. False: none.
bool crossesDisk(Vec2 centre, double radius, Vec2 from, Vec2 to, double& begin, double& end) {
  const Vec2 along = to - from, start = from - centre;
  const double square = dot(along, along);
  if (!(square > 0)) return norm(start) <= radius;
  const double off = cross(along, start), rest = radius * radius - off * off / square;
  if (!(rest >= 0)) return false;
  const double middle = -dot(start, along) / square, half = std::sqrt(rest / square);
  begin = std::max(begin, middle - half);
  end = std::min(end, middle + half);
  return begin <= end;
}

/// Keeps of a convex polygon the points x with cross(direction, x − origin) ≥ −slack.
void clip(std::vector<Vec2>& polygon, std::vector<Vec2>& kept, Vec2 origin, Vec2 direction,
          double slack) {
  kept.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double atA = cross(direction, a - origin) + slack;
    const double atB = cross(direction, b - origin) + slack;
    if (atA >= 0) kept.push_back(a);
    if ((atA < 0) != (atB < 0)) kept.push_back(a + (atA / (atA - atB)) * (b - a));
  }
  polygon.swap(kept);
}

}  // namespace

void SuperlevelPieces::find(const Propagation& propagation, Index face, double height,
                            double longest) {
  gather(propagation, face, longest);
  block(height, nullptr);
}

bool SuperlevelPieces::findBeside(const Propagation& propagation, const SaddleSide& side,
                                  double height, double longest) {
  const Index face = faceOfSide(side.halfedge);
  gather(propagation, face, longest);
  const Unfolding& unfolding = propagation.unfolding();
  const auto place = [&](Vec2 p) { return unfolding.toFrame(side.halfedge, 3 * face, p); };
  const Vec2 point = place(side.point);
  const SaddleSide inFace{3 * face,
                          point,
                          {place(side.roots[0]), place(side.roots[1])},
                          place(side.point + side.direction) - point};
  const bool isWhole = cutAlong(inFace);
  block(height, &inFace);
  return isWhole;
}

/// The sources, up to paths so long, and the sides of the whole face.
void SuperlevelPieces::gather(const Propagation& propagation, Index face, double longest) {
  propagation_ = &propagation;
  const Unfolding& unfolding = propagation.unfolding();
  findPseudosources(propagation, face, longest, sources_);
  const std::array<Vec2, 3> corners = cornersOf(unfolding, face);
  sides_.clear();
  slack_ = 0;
  for (Index k = 0; k < 3; ++k) {
    const Crossing c = unfolding.crossing(3 * face + k);
    sides_.push_back({corners[k], corners[(k + 1) % 3], 3 * face + k, 0, c.length(), -1});
    slack_ = std::max(slack_, kTouch * c.length());
    // A path that has reached a corner bounds distances, also where the corner sends out none.
    const double distance = propagation.distance(c.from());
    if (!propagation.settled(c.from()) && std::isfinite(distance)) {
      sources_.push_back({corners[k], distance, {0, 0}, {0, 0}, k});
    }
  }
  isCut_ = false;
  work_ += 1 + sources_.size();
}

/// Leaves of the sides what lies beside the saddle, from the saddle round to it.
bool SuperlevelPieces::cutAlong(const SaddleSide& side) {
  isCut_ = true;
  const std::array<Side, 3> whole{sides_[0], sides_[1], sides_[2]};
  sides_.clear();
  const double size = norm(side.direction);
  const auto ahead = [&](Vec2 x) { return dot(side.direction, x - side.point) / size; };
  const auto halfTowards = [&](Vec2 x) {
    return dot(x - side.point, side.roots[0] - side.point) > 0 ? 0 : 1;
  };
  bool isInside = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Side& s = whole[k];
    const double off = cross(s.to - s.from, side.point - s.from) / s.end;
    if (off > kSaddleOnSide * s.end) continue;
    isInside = false;
    if (std::fabs(ahead(s.from)) > kSaddleOnSide * s.end ||
        std::fabs(ahead(s.to)) > kSaddleOnSide * s.end) {
      continue;
    }
    // The loop runs along this side.
    if (ahead(whole[(k + 1) % 3].to) < 0) return false;
    sides_ = {{side.point, s.to, kNoIndex, 0, 0, halfTowards(s.to)},
              whole[(k + 1) % 3],
              whole[(k + 2) % 3],
              {s.from, side.point, kNoIndex, 0, 0, halfTowards(s.from)}};
    return true;
  }
  // Where the rim comes over to this side of the line, and the sides from there on.
  std::size_t first = 3;
  for (std::size_t k = 0; k < 3; ++k) {
    if (ahead(whole[k].from) <= 0 && ahead(whole[k].to) > 0) first = k;
  }
  if (first == 3) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    Side s = whole[(first + i) % 3];
    const double atFrom = ahead(s.from), atTo = ahead(s.to);
    if (atFrom <= 0 && atTo <= 0) continue;
    const double share = atFrom / (atFrom - atTo), length = s.end;
    const Vec2 crossing = s.from + share * (s.to - s.from);
    if (atFrom < 0) {
      s.begin = share * length;
      s.from = crossing;
    }
    if (atTo < 0) {
      s.end = share * length;
      s.to = crossing;
    }
    sides_.push_back(s);
  }
  const Vec2 begin = sides_.front().from, end = sides_.back().to;
  if (norm(begin - side.point) > slack_) {
    sides_.insert(sides_.begin(), {side.point, begin, kNoIndex, 0, 0, halfTowards(begin)});
  }
  if (norm(end - side.point) > slack_) {
    sides_.push_back({end, side.point, kNoIndex, 0, 0, halfTowards(end)});
  }
  return isInside;
}

void SuperlevelPieces::block(double height, const SaddleSide* side) {
  pies_.clear();
  blocked_.clear();
  for (const Pseudosource& source : sources_) {
    Pie pie{source, height - source.sigma, -1, 0};
    if (!(pie.reach > 0)) continue;
    // The disks of the two halves touch at the saddle, and there alone; so do those of other roots
    // on the halves, as of vertices that they pass.
    for (int k = 0; side != nullptr && k < 2; ++k) {
      const Vec2 half = side->roots[k] - side->point, ray = source.root - side->point;
      const double far = norm(ray);
      if (std::fabs(far - pie.reach) <= kSamePoint * height && dot(half, ray) > 0 &&
          std::fabs(cross(half, ray)) <= kSameRay * norm(half) * far) {
        pie.half = k;
      }
    }
    bool isOnRim = false;
    if (sides_.empty()) break;
    const Sight first = sightOf(pie, sides_.front().from);
    Sight from = first;
    for (std::size_t k = 0; k < sides_.size(); ++k) {
      const Side& s = sides_[k];
      const Sight to = k + 1 < sides_.size() ? sightOf(pie, s.to) : first;
      double begin = 0, end = 1;
      const bool isOther = s.halfedge == kNoIndex && pie.half == 1 - s.half;
      if (!isOther && covers(pie, s.from, s.to, from, to, begin, end)) {
        const auto at = static_cast<double>(k);
        blocked_.push_back({at + begin, at + end, pies_.size()});
        isOnRim = true;
      }
      from = to;
    }
    if (isOnRim) pies_.push_back(pie);
  }
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const auto at = static_cast<double>(k);
    if (sides_[k].halfedge == kNoIndex) blocked_.push_back({at, at + 1, kNoPie});
  }
  findArcs();
  findPieces();
}

SuperlevelPieces::Sight SuperlevelPieces::sightOf(const Pie& pie, Vec2 point) const {
  const Vec2 ray = point - pie.source.root;
  return {dot(ray, ray), slack_ - cross(pie.source.left, ray),
          slack_ + cross(pie.source.right, ray)};
}

/// Whether a pie covers a part of a segment: from one share of it to another.
bool SuperlevelPieces::covers(const Pie& pie, Vec2 from, Vec2 to, const Sight& atFrom,
                              const Sight& atTo, double& begin, double& end) {
  const auto keepPositive = [&](double a, double b) {
    if (a < 0 && b < 0) return false;
    if (a < 0) begin = std::max(begin, a / (a - b));
    if (b < 0) end = std::min(end, a / (a - b));
    return begin <= end;
  };
  if (!keepPositive(atFrom.left, atTo.left) || !keepPositive(atFrom.right, atTo.right)) {
    return false;
  }
  const double square = pie.reach * pie.reach;
  if (atFrom.square <= square && atTo.square <= square) return true;
  return crossesDisk(pie.source.root, pie.reach, from, to, begin, end);
}

bool SuperlevelPieces::isClear(const Piece& piece, Vec2 point) const {
  const Vec2 from = middleOf(piece);
  return std::none_of(pies_.begin(), pies_.end(), [&](const Pie& pie) {
    double begin = 0, end = 1;
    return covers(pie, from, point, sightOf(pie, from), sightOf(pie, point), begin, end);
  });
}

Vec2 SuperlevelPieces::middleOf(const Piece& piece) const {
  const auto side = std::find_if(sides_.begin(), sides_.end(),
                                 [&](const Side& s) { return s.halfedge == piece.halfedge; });
  const double at = (piece.begin + piece.end) / 2;
  return side->from + (at - side->begin) / (side->end - side->begin) * (side->to - side->from);
}

/// Joins what is blocked to arcs.
void SuperlevelPieces::findArcs() {
  std::sort(blocked_.begin(), blocked_.end(),
            [](const Blocked& a, const Blocked& b) { return a.begin < b.begin; });
  arcs_.clear();
  // Two halves of a loop do not block the saddle between them.
  const auto count = static_cast<double>(sides_.size());
  for (const Blocked& b : blocked_) {
    if (arcs_.empty() || b.begin > arcs_.back().end) {
      arcs_.push_back(b);
    } else {
      arcs_.back().end = std::max(arcs_.back().end, b.end);
    }
  }
  if (!isCut_ && arcs_.size() > 1 && arcs_.front().begin <= 0 && arcs_.back().end >= count) {
    arcs_.front().begin = arcs_.back().begin - count;
    arcs_.pop_back();
  }
  isJoined_ = false;
}

/// Joins arcs whose pies meet to sets.
void SuperlevelPieces::joinArcs() {
  isJoined_ = true;
  parent_.resize(arcs_.size());
  std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  if (arcs_.size() < 2) return;

  const auto join = [&](std::size_t a, std::size_t b) { parent_[setOf(a)] = setOf(b); };
  const auto arcAt = [&](double place) {
    const auto after =
        std::upper_bound(arcs_.begin(), arcs_.end(), place,
                         [](double at, const Blocked& arc) { return at < arc.begin; });
    return after == arcs_.begin() ? std::size_t{0}
                                  : static_cast<std::size_t>(after - arcs_.begin()) - 1;
  };
  for (Pie& pie : pies_) pie.arc = kNoPie;
  for (const Blocked& b : blocked_) {
    if (b.pie == kNoPie) continue;
    // The first arc may begin before the first side.
    const std::size_t arc = b.begin > arcs_.back().end && !isCut_ ? 0 : arcAt(b.begin);
    Pie& pie = pies_[b.pie];
    if (pie.arc == kNoPie) {
      pie.arc = arc;
    } else {
      join(arc, pie.arc);
    }
  }
  for (std::size_t i = 0; i < pies_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Pie &a = pies_[i], &b = pies_[j];
      if (setOf(a.arc) == setOf(b.arc)) continue;
      if (a.half >= 0 && b.half >= 0) continue;
      ++work_;
      if (meet(a, b)) join(a.arc, b.arc);
    }
  }
}

std::size_t SuperlevelPieces::setOf(std::size_t arc) const {
  while (parent_[arc] != arc) arc = parent_[arc];
  return arc;
}

/// Whether two pies have a point in common.
bool SuperlevelPieces::meet(const Pie& a, const Pie& b) {
  const Vec2 across = b.source.root - a.source.root;
  const double distance = norm(across);
  if (distance > a.reach + b.reach) return false;
  polygon_.clear();
  for (const Side& side : sides_) polygon_.push_back(side.from);
  for (const Pseudosource* source : {&a.source, &b.source}) {
    clip(polygon_, clipped_, source->root, -1 * source->left, slack_);
    clip(polygon_, clipped_, source->root, source->right, slack_);
  }
  if (polygon_.empty()) return false;
  // The intersection of the disks meets the rim of the polygon, or lies inside as a whole.
  for (std::size_t i = 0; i < polygon_.size(); ++i) {
    const Vec2 from = polygon_[i], to = polygon_[(i + 1) % polygon_.size()];
    double begin = 0, end = 1;
    if (crossesDisk(a.source.root, a.reach, from, to, begin, end) &&
        crossesDisk(b.source.root, b.reach, from, to, begin, end)) {
      return true;
    }
  }
  const double low = std::max(-a.reach, distance - b.reach);
  const double high = std::min(a.reach, distance + b.reach);
  const Vec2 common =
      distance > 0 ? a.source.root + ((low + high) / 2 / distance) * across : a.source.root;
  for (std::size_t i = 0; i < polygon_.size(); ++i) {
    const Vec2 from = polygon_[i], to = polygon_[(i + 1) % polygon_.size()];
    if (cross(to - from, common - from) < 0) return false;
  }
  return true;
}

/// Finds the pieces that are left between the arcs, side by side.
void SuperlevelPieces::findPieces() {
  pieces_.clear();
  const std::size_t sideCount = sides_.size();
  const auto count = static_cast<double>(sideCount);
  const auto add = [&](double begin, double end, std::size_t gap) {
    const auto first = static_cast<std::size_t>(std::max(begin, 0.0));
    for (std::size_t k = first; k < sideCount && static_cast<double>(k) < end; ++k) {
      const Side& s = sides_[k];
      if (s.halfedge == kNoIndex) continue;
      const auto at = static_cast<double>(k);
      const double from = std::max(0.0, begin - at), to = std::min(1.0, end - at);
      if (!(from < to)) continue;
      const double length = s.end - s.begin;
      pieces_.push_back({s.halfedge, from > 0 ? s.begin + from * length : s.begin,
                         to < 1 ? s.begin + to * length : s.end, gap});
    }
  };
  if (arcs_.empty()) {
    add(0, count, 0);
    return;
  }
  for (std::size_t k = 0; k + 1 < arcs_.size(); ++k) add(arcs_[k].end, arcs_[k + 1].begin, k);
  const std::size_t last = arcs_.size() - 1;
  if (arcs_.front().begin < 0) {
    add(arcs_.back().end, count + arcs_.front().begin, last);
  } else {
    add(arcs_.back().end, count, last);
    add(0, arcs_.front().begin, last);
  }
}

bool SuperlevelPieces::together(std::size_t gap, std::size_t other) {
  if (gap == other) return true;
  if (!isJoined_) joinArcs();
  // Gap k lies between arc k and the next one.
  const std::size_t low = std::min(gap, other), high = std::max(gap, other);
  for (std::size_t i = low + 1; i <= high; ++i) {
    for (std::size_t j = 0; j < arcs_.size(); ++j) {
      if ((j <= low || j > high) && setOf(i) == setOf(j)) return false;
    }
  }
  return true;
}

bool SuperlevelPieces::isWithin(double high) {
  cells_.clear();
  above_.reset();
  for (std::size_t k = 1; k + 1 < sides_.size(); ++k) {
    cells_.push_back({sides_[0].from, sides_[k].from, sides_[k + 1].from});
  }
  for (std::size_t done = 0; !cells_.empty(); ++done) {
    if (done == kMostCells) return false;
    const Triangle cell = cells_.back();
    cells_.pop_back();
    const Vec2 centre = (1.0 / 3) * (cell[0] + cell[1] + cell[2]);
    double radius = 0;
    for (const Vec2 corner : cell) radius = std::max(radius, norm(corner - centre));
    work_ += sources_.size() / 2;
    double atCentre = 2 * high, atMost = 2 * high;
    for (const Pseudosource& source : sources_) {
      if (!(source.sigma < high) || !source.meetsDisk(centre, slack_)) continue;
      atCentre = std::min(atCentre, source.distanceTo(centre));
      // A cell that one root sees as a whole is no farther from it than its farthest corner.
      double farthest = 0;
      for (const Vec2 corner : cell) {
        farthest = source.meetsDisk(corner, slack_) ? std::max(farthest, source.distanceTo(corner))
                                                    : 2 * high;
      }
      atMost = std::min(atMost, farthest);
    }
    if (atCentre > high) {
      above_ = centre;
      return false;
    }
    if (std::min(atMost, atCentre + radius) <= high) continue;
    std::size_t from = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (norm(cell[(k + 1) % 3] - cell[k]) > norm(cell[(from + 1) % 3] - cell[from])) from = k;
    }
    const std::size_t to = (from + 1) % 3;
    const Vec2 half = 0.5 * (cell[from] + cell[to]);
    Triangle part = cell;
    part[from] = half;
    cells_.push_back(part);
    part = cell;
    part[to] = half;
    cells_.push_back(part);
  }
  return true;
}

std::size_t SuperlevelPieces::takeWork() {
  const std::size_t work = work_;
  work_ = 0;
  return work;
}

std::size_t SuperlevelPieces::memoryBytes() const {
  return sources_.capacity() * sizeof(Pseudosource) + sides_.capacity() * sizeof(Side) +
         pies_.capacity() * sizeof(Pie) +
         (blocked_.capacity() + arcs_.capacity()) * sizeof(Blocked) +
         parent_.capacity() * sizeof(std::size_t) + pieces_.capacity() * sizeof(Piece) +
         (polygon_.capacity() + clipped_.capacity()) * sizeof(Vec2) +
         cells_.capacity() * sizeof(Triangle);
}

}  // namespace girth
