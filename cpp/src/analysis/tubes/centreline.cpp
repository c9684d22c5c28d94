#include "analysis/tubes/centreline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include "analysis/median.h"
#include "analysis/plane_frame.h"
#include "analysis/polygon.h"
#include "analysis/tubes/local_fit.h"
#include "girth/parallel.h"
#include "mesh/vector.h"

namespace girth::tubes {
namespace {

/// Stations for each median diameter, where no spacing was asked for.
constexpr double kStationsPerDiameter = 8;
constexpr std::size_t kLeastStations = 16, kMostUsualStations = 1000, kMostStations = 100'000;
/// Level curves nearer to a closed end than so many of their radii lie in its cap.
constexpr double kCap = 1.5;
/// The line goes on into a cap for at most so many median radii, and while the cosine of the angle
/// that it turns by is more.
constexpr double kMostCap = 6, kMostTurn = 0.5;
/// The line is moved at most so often, and until no point moves by more than this share of the
/// median radius.
constexpr int kMostMoves = 48;
constexpr double kSettled = 1e-6;
/// Each move goes this share of the way: on a flank the centroid moves against the line's tilt, so
/// that whole ways swing to and fro. Where moves do not get shorter, the share is halved.
constexpr double kShare = 0.5, kLeastShare = 0.1, kShorter = 0.95;
/// A section beyond a cap's start that is smaller than this share of the branch's is none.
constexpr double kTip = 1e-6;

/// Points of a line at equal distances, as many as asked for.
std::vector<Vec3> resampled(const std::vector<Vec3>& line, std::size_t count) {
  std::vector<double> along{0};
  for (std::size_t i = 1; i < line.size(); ++i) {
    along.push_back(along.back() + norm(line[i] - line[i - 1]));
  }
  std::vector<Vec3> points;
  std::size_t i = 1;
  for (std::size_t k = 0; k < count; ++k) {
    const double wanted = along.back() * static_cast<double>(k) / static_cast<double>(count - 1);
    while (i + 1 < line.size() && along[i] < wanted) ++i;
    const double step = along[i] - along[i - 1];
    const double share = step > 0 ? std::clamp((wanted - along[i - 1]) / step, 0.0, 1.0) : 0;
    points.push_back(line[i - 1] + share * (line[i] - line[i - 1]));
  }
  return points;
}

double lengthOfLine(const std::vector<Vec3>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += norm(line[i] - line[i - 1]);
  return length;
}

class LineSearch {
 public:
  LineSearch(const SurfaceMesh& mesh, const TubeTree& tree, Index branch,
             const ExecutionContext& context)
      : mesh_(mesh), tree_(tree), branch_(branch), context_(context) {}

  Result<std::vector<LinePoint>> run(double spacing) {
    if (!begin()) return std::vector<LinePoint>{};
    const double length = lengthOfLine(line_);
    // Between caps that nearly meet there is no line.
    const bool hasCap = closed_.below || closed_.above;
    if (!(length > (hasCap ? radius_ : 0))) return std::vector<LinePoint>{};
    const double usual =
        std::clamp(length / (2 * radius_) * kStationsPerDiameter,
                   static_cast<double>(kLeastStations), static_cast<double>(kMostUsualStations));
    const double steps = spacing > 0 ? length / spacing : usual;
    if (!(steps < static_cast<double>(kMostStations))) {
      return makeError(ErrorCode::InvalidOption, -1,
                       "the spacing makes more than 100,000 stations: take a greater one");
    }
    const auto count = static_cast<std::size_t>(std::max(std::round(steps), 4.0)) + 1;
    line_ = resampled(line_, count);
    double share = kShare, before = std::numeric_limits<double>::infinity();
    for (int move = 0; move < kMostMoves; ++move) {
      const auto shift = moveLine(share);
      if (!shift) return cancelled();
      line_ = resampled(line_, count);
      if (*shift <= kSettled * radius_) break;
      if (*shift > kShorter * before) share = std::max(share / 2, kLeastShare);
      before = *shift;
    }
    std::vector<LinePoint> points = measured();
    if (context_.cancelled()) return cancelled();
    continueToClosedEnds(points);
    if (context_.cancelled()) return cancelled();
    return points;
  }

 private:
  static Error cancelled() {
    return makeError(ErrorCode::Cancelled, -1, "the search for tubes was cancelled");
  }

  /// The middles of the level curves, without those in the caps of closed ends. False where none
  /// are left.
  bool begin() {
    const TreeBranch& branch = tree_.branches[branch_];
    std::vector<TreeLevel> levels = branch.levels;
    const auto isInCap = [&](const TreeLevel& level, const TreeEnd& end) {
      return norm(level.centre - end.centre) < kCap * level.length / (2 * std::numbers::pi);
    };
    closed_ = tree_.closedEndsOf(branch);
    if (closed_.below) {
      const TreeEnd& end = tree_.ends[branch.bottom];
      levels.erase(levels.begin(), std::find_if(levels.begin(), levels.end(), [&](const auto& one) {
                     return !isInCap(one, end);
                   }));
    }
    if (closed_.above) {
      const TreeEnd& end = tree_.ends[branch.top];
      levels.erase(std::find_if(levels.rbegin(), levels.rend(),
                                [&](const auto& one) { return !isInCap(one, end); })
                       .base(),
                   levels.end());
    }
    if (levels.empty()) return false;
    if (branch.bottom != kNoIndex && !closed_.below) {
      line_.push_back(tree_.ends[branch.bottom].centre);
    }
    std::vector<double> lengths;
    for (const TreeLevel& level : levels) {
      line_.push_back(level.centre);
      lengths.push_back(level.length);
    }
    if (branch.top != kNoIndex && !closed_.above) {
      line_.push_back(tree_.ends[branch.top].centre);
    }
    radius_ = medianOf(std::move(lengths)) / (2 * std::numbers::pi);
    return line_.size() > 1;
  }

  /// The line's directions at its points, each by those within one and a half radii.
  std::vector<Vec3> directions() const {
    std::vector<double> steps;
    const double step = lengthOfLine(line_) / static_cast<double>(line_.size() - 1);
    for (std::size_t i = 0; i < line_.size(); ++i) steps.push_back(step * static_cast<double>(i));
    const auto reach =
        static_cast<std::size_t>(std::clamp(std::ceil(1.5 * radius_ / step), 2.0, 1000.0));
    std::vector<Vec3> all;
    for (std::size_t i = 0; i < line_.size(); ++i) {
      const Vec3 along = fitAt(line_, steps, i, reach).first;
      all.push_back((1 / norm(along)) * along);
    }
    return all;
  }

  /// Moves each point a share of the way to the centroid of its section. Returns the greatest way;
  /// nothing where cancelled.
  std::optional<double> moveLine(double share) {
    const std::vector<Vec3> along = directions();
    std::vector<Vec3> moved = line_;
    const bool isDone =
        parallelFor(line_.size(), 1, quietly(), [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            const auto curve = sectionOf(mesh_, tree_, branch_, line_[i], along[i], false);
            if (curve) moved[i] = line_[i] + share * (curve->centre - line_[i]);
          }
        });
    if (!isDone || context_.cancelled()) return std::nullopt;
    double greatest = 0;
    for (std::size_t i = 0; i < line_.size(); ++i) {
      greatest = std::max(greatest, norm(moved[i] - line_[i]) / share);
    }
    line_ = std::move(moved);
    return greatest;
  }

  /// The points that have a section, measured.
  std::vector<LinePoint> measured() {
    const std::vector<Vec3> along = directions();
    std::vector<std::optional<SectionCurve>> curves(line_.size());
    parallelFor(line_.size(), 1, quietly(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        curves[i] = sectionOf(mesh_, tree_, branch_, line_[i], along[i], true);
      }
    });
    std::vector<LinePoint> points;
    for (std::size_t i = 0; i < line_.size(); ++i) {
      if (curves[i]) points.push_back({curves[i]->centre, along[i], *std::move(curves[i])});
    }
    return points;
  }

  /// Continues the line into the caps of closed ends, as it bends before them.
  void continueToClosedEnds(std::vector<LinePoint>& points) {
    if (points.size() < 2) return;
    std::vector<Vec3> centres;
    std::vector<double> steps{0};
    for (const LinePoint& point : points) {
      if (!centres.empty()) steps.push_back(steps.back() + norm(point.centre - centres.back()));
      centres.push_back(point.centre);
    }
    const double step = steps.back() / static_cast<double>(points.size() - 1);
    const auto reach =
        static_cast<std::size_t>(std::clamp(std::ceil(2 * radius_ / step), 4.0, 1e4));
    std::vector<LinePoint> before, behind;
    if (closed_.below) before = beyond(centres, fitAt(centres, steps, 0, reach), 0, -step);
    if (closed_.above) {
      const std::size_t last = points.size() - 1;
      behind = beyond(centres, fitAt(centres, steps, last, reach), last, step);
    }
    std::reverse(before.begin(), before.end());
    points.insert(points.begin(), std::make_move_iterator(before.begin()),
                  std::make_move_iterator(before.end()));
    points.insert(points.end(), std::make_move_iterator(behind.begin()),
                  std::make_move_iterator(behind.end()));
  }

  /// The points beyond one of a line's ends.
  std::vector<LinePoint> beyond(const std::vector<Vec3>& centres, const LocalFit& fit,
                                std::size_t end, double step) {
    std::vector<LinePoint> points;
    Vec3 at = centres[end];
    const Vec3 straight = (1 / norm(fit.first)) * fit.first;
    for (double way = step; std::fabs(way) < kMostCap * radius_ && !context_.cancelled();
         way += step) {
      const Vec3 along = fit.first + way * fit.second;
      const Vec3 direction = (1 / norm(along)) * along;
      if (!(dot(direction, straight) > kMostTurn)) break;
      at = at + step * direction;
      auto curve = sectionOf(mesh_, tree_, branch_, at, direction, true);
      if (!curve || !(curve->area > kTip * radius_ * radius_)) break;
      at = curve->centre;
      points.push_back({at, direction, *std::move(curve)});
    }
    return points;
  }

  ExecutionContext quietly() const { return {context_.threads, context_.cancel, {}}; }

  const SurfaceMesh& mesh_;
  const TubeTree& tree_;
  const Index branch_;
  const ExecutionContext& context_;
  std::vector<Vec3> line_;
  double radius_{0};
  ClosedEnds closed_;
};

}  // namespace

std::optional<SectionCurve> sectionOf(const SurfaceMesh& mesh, const TubeTree& tree, Index branch,
                                      const Vec3& point, const Vec3& direction, bool inscribed) {
  auto section =
      findSections(mesh, {direction, {dot(direction, point)}, inscribed}, {1, nullptr, {}});
  if (!section) return std::nullopt;
  const PlaneFrame frame(section.value().sections.front().normal);
  const auto isOwn = [&](const SurfacePoint& one) {
    if (one.kind == SurfacePoint::Kind::AtVertex)
      return tree.branchOfVertex[one.vertex()] == branch;
    const Halfedge h = one.halfedge();
    return tree.branchOfVertex[mesh.from(h)] == branch && tree.branchOfVertex[mesh.to(h)] == branch;
  };
  SectionCurve* best = nullptr;
  bool isBestRound = false;
  for (SectionCurve& curve : section.value().sections.front().curves) {
    if (!curve.closed || curve.hole) continue;
    if (!std::all_of(curve.points.begin(), curve.points.end(), isOwn)) continue;
    std::vector<Point2> polygon;
    for (const SurfacePoint& one : curve.points)
      polygon.push_back(frame.flat(positionOf(mesh, one)));
    const bool isRound = isInside(frame.flat(point), polygon);
    if (isBestRound && !isRound) continue;
    const bool isNearer =
        best == nullptr || norm(curve.centre - point) < norm(best->centre - point);
    if (isNearer || (isRound && !isBestRound)) {
      best = &curve;
      isBestRound = isRound;
    }
  }
  if (best == nullptr) return std::nullopt;
  // Another part of the branch lies in the same plane.
  if (!isBestRound && norm(best->centre - point) > best->greatestWidth) return std::nullopt;
  return std::move(*best);
}

Result<std::vector<LinePoint>> centrelineOf(const SurfaceMesh& mesh, const TubeTree& tree,
                                            Index branch, double spacing,
                                            const ExecutionContext& context) {
  return LineSearch(mesh, tree, branch, context).run(spacing);
}

}  // namespace girth::tubes
