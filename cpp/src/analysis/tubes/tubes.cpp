#include "girth/tubes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

#include "analysis/median.h"
#include "analysis/tubes/centreline.h"
#include "analysis/tubes/local_fit.h"
#include "analysis/tubes/tube_places.h"
#include "analysis/tubes/tube_tree.h"
#include "girth/girth_solver.h"
#include "girth/parallel.h"
#include "loops/tight/taut_loop.h"
#include "mesh/vector.h"
#include "no_value.h"
#include "part_of_work.h"
#include "solver/solver_factory.h"

namespace girth {
namespace {

/// A tube is at least so many times as long as wide, where it has a closed end.
constexpr double kLeastLength = 2.5;
/// The sections of a tube are less than so many times as wide as thick, in the median.
constexpr double kMostWidth = 4;
/// Curvature and torsion are those of the line within so many diameters.
constexpr double kBendReach = 1;
/// A line bends where its curvature times the diameter is more.
constexpr double kStraight = 1e-3;
/// Lengths that differ by less than this share are equal.
constexpr double kEqualLength = 1e-9;
/// The share of the work that is the lines; the rest is the girth.
constexpr double kLinesShare = 0.6;

Error cancelledTubes() {
  return makeError(ErrorCode::Cancelled, -1, "the search for tubes was cancelled");
}

SurfacePoint nearestOf(const SurfaceMesh& mesh, const std::vector<SurfacePoint>& points,
                       const Vec3& centre) {
  return *std::min_element(points.begin(), points.end(),
                           [&](const SurfacePoint& one, const SurfacePoint& other) {
                             return squareOf(positionOf(mesh, one) - centre) <
                                    squareOf(positionOf(mesh, other) - centre);
                           });
}

/// The tubes of one surface.
class TubeSearch {
 public:
  TubeSearch(const SurfaceMesh& mesh, const TubesOptions& options, const ExecutionContext& context)
      : mesh_(mesh), options_(options), context_(context) {}

  Result<Tubes> run() {
    auto tree = tubes::growTree(mesh_, options_.ends, context_);
    if (!tree) return tree.error();
    tree_ = std::move(tree).value();
    found_.others = tree_.others;
    for (std::size_t b = 0; b < tree_.branches.size(); ++b) {
      auto line =
          tubes::centrelineOf(mesh_, tree_, static_cast<Index>(b), options_.spacing, context_);
      if (!line) return line.error();
      lines_.push_back(std::move(line).value());
      const double share = static_cast<double>(b + 1) / static_cast<double>(tree_.branches.size());
      if (context_.onProgress) context_.onProgress(kLinesShare * share);
    }
    for (std::size_t first = 0; first < tree_.branches.size();) {
      std::size_t last = first;
      const Index component = tree_.branches[first].component;
      while (last < tree_.branches.size() && tree_.branches[last].component == component) ++last;
      addComponent(component, first, last);
      first = last;
    }
    std::sort(found_.others.begin(), found_.others.end(),
              [](const auto& one, const auto& other) { return one.component < other.component; });
    if (context_.cancelled()) return cancelledTubes();
    if (!addGirths()) return cancelledTubes();
    if (context_.onProgress) context_.onProgress(1);
    return std::move(found_);
  }

 private:
  /// Adds the branches from `first` to before `last`, of one component, if it is a tube.
  void addComponent(Index component, std::size_t first, std::size_t last) {
    Tubes own;
    std::vector<std::size_t> treeBranches;
    std::vector<Index> numberOf(last - first, kNoIndex);
    const auto before = static_cast<Index>(found_.branches.size());
    double longest = 0;
    bool isClosed = false;
    for (std::size_t b = first; b < last; ++b) {
      const tubes::TreeBranch& from = tree_.branches[b];
      const auto [closedBelow, closedAbove] = tree_.closedEndsOf(from);
      isClosed = isClosed || closedBelow || closedAbove;
      // The branch that it leaves: the nearest one that has stations.
      Index parent = kNoIndex;
      for (Index p = from.parent; p != kNoIndex && parent == kNoIndex;
           p = tree_.branches[p].parent) {
        parent = numberOf[p - first];
      }
      if (lines_[b].empty()) continue;
      TubeBranch branch;
      branch.component = component;
      branch.parent = parent == kNoIndex ? kNoIndex : before + parent;
      branch.ends = from.top != kNoIndex;
      branch.open = branch.ends && !closedAbove;
      if (branch.ends) branch.end = tree_.ends[from.top].vertices.front();
      double distance = 0;
      if (parent != kNoIndex) {
        const TubeStation& station = own.stations[own.branches[parent].endStation - 1];
        distance = station.distance + norm(lines_[b].front().centre - station.centre);
      }
      branch.firstStation = static_cast<Index>(own.stations.size());
      addStations(lines_[b], before + static_cast<Index>(own.branches.size()), distance,
                  own.stations);
      branch.endStation = static_cast<Index>(own.stations.size());
      branch.firstDistance = own.stations[branch.firstStation].distance;
      branch.lastDistance = own.stations.back().distance;
      longest = std::max(longest, branch.lastDistance);
      std::vector<double> diameters;
      for (Index i = branch.firstStation; i < branch.endStation; ++i) {
        diameters.push_back(own.stations[i].equivalentDiameter);
      }
      branch.median = medianOf(std::move(diameters));
      numberOf[b - first] = static_cast<Index>(own.branches.size());
      own.branches.push_back(branch);
      treeBranches.push_back(b);
    }
    if (own.stations.empty()) {
      found_.others.push_back({component, isClosed ? NoTube::Blunt : NoTube::Coarse});
      return;
    }
    double widest = 0;
    std::vector<double> shapes;
    for (const TubeStation& station : own.stations) {
      widest = std::max(widest, station.equivalentDiameter);
      shapes.push_back(station.greatestWidth / station.leastWidth);
    }
    if (medianOf(std::move(shapes)) > kMostWidth) {
      found_.others.push_back({component, NoTube::Flat});
      return;
    }
    if (isClosed && longest < kLeastLength * widest) {
      found_.others.push_back({component, NoTube::Blunt});
      return;
    }
    for (std::size_t i = 0; i < own.branches.size(); ++i) {
      TubeBranch& branch = own.branches[i];
      const auto stations =
          std::span<const TubeStation>(own.stations)
              .subspan(branch.firstStation, branch.endStation - branch.firstStation);
      const std::size_t b = treeBranches[i];
      for (TubePlace& place : tubes::findPlaces(mesh_, tree_, static_cast<Index>(b), stations,
                                                branch.median, options_)) {
        place.branch = before + static_cast<Index>(i);
        found_.places.push_back(std::move(place));
      }
      const auto behind = static_cast<Index>(found_.stations.size());
      branch.firstStation += behind;
      branch.endStation += behind;
    }
    for (const TubeBranch& branch : own.branches) found_.branches.push_back(branch);
    for (TubeStation& station : own.stations) found_.stations.push_back(std::move(station));
  }

  /// Adds the stations of a branch, which begins at a distance.
  void addStations(std::vector<tubes::LinePoint>& line, Index branch, double distance,
                   std::vector<TubeStation>& stations) const {
    std::vector<Vec3> centres;
    std::vector<double> steps;
    for (const tubes::LinePoint& point : line) {
      if (!centres.empty()) distance += norm(point.centre - centres.back());
      centres.push_back(point.centre);
      steps.push_back(distance);
    }
    const double mean =
        line.size() > 1 ? (steps.back() - steps.front()) / static_cast<double>(line.size() - 1) : 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      SectionCurve& curve = line[i].curve;
      TubeStation station;
      station.branch = branch;
      station.distance = steps[i];
      station.centre = line[i].centre;
      station.direction = line[i].direction;
      station.equivalentDiameter = curve.equivalentDiameter;
      station.area = curve.area;
      station.perimeter = curve.perimeter;
      station.inscribedDiameter = curve.inscribedDiameter;
      station.leastWidth = curve.leastWidth;
      station.greatestWidth = curve.greatestWidth;
      station.girth = kNoValue;
      station.place = nearestOf(mesh_, curve.points, station.centre);
      station.points = std::move(curve.points);
      station.torsion = kNoValue;
      if (mean > 0) bend(centres, steps, i, mean, station);
      stations.push_back(std::move(station));
    }
  }

  /// Finds curvature and torsion.
  static void bend(const std::vector<Vec3>& centres, const std::vector<double>& steps,
                   std::size_t i, double mean, TubeStation& station) {
    const double wanted = std::ceil(kBendReach * station.equivalentDiameter / mean);
    const auto reach = static_cast<std::size_t>(std::clamp(wanted, 4.0, 1e4));
    const tubes::LocalFit fit = tubes::fitAt(centres, steps, i, reach);
    const Vec3 across = cross(fit.first, fit.second);
    const double speed = norm(fit.first), area = norm(across);
    if (!(speed > 0)) return;
    station.curvature = area / (speed * speed * speed);
    if (station.curvature * station.equivalentDiameter < kStraight) return;
    station.torsion = dot(across, fit.third) / (area * area);
  }

  /// Finds the girth at stations and places. False where cancelled.
  bool addGirths() {
    if (!options_.girth) return true;
    const auto unfolding = std::make_shared<const geodesic::Unfolding>(mesh_);
    // A loop that goes round here is no longer than the outline.
    const auto girthAt = [&](GirthSolver& solver, const SurfacePoint& point, double perimeter) {
      const auto value = solver.value(point, context_.ofOneThread());
      const bool isRound = value && value.value().kind == LoopKind::Loop &&
                           value.value().length <= perimeter * (1 + kEqualLength);
      return isRound ? value.value().length : kNoValue;
    };
    const double area = mesh_.area();
    const std::size_t stations = found_.stations.size();
    return parallelFor(
        stations + found_.places.size(), 1, partOf(context_, kLinesShare, 1),
        [&](std::size_t begin, std::size_t end) {
          GirthSolver solver = SolverFactory::onUnfolding(unfolding);
          for (std::size_t i = begin; i < end; ++i) {
            if (i < stations) {
              TubeStation& station = found_.stations[i];
              station.girth = girthAt(solver, station.place, station.perimeter);
              continue;
            }
            TubePlace& place = found_.places[i - stations];
            if (place.change == TubeChange::Widening) {
              place.girth =
                  girthAt(solver, nearestOf(mesh_, place.points, place.centre), place.perimeter);
            } else if (const auto neck = loops::neckFrom(*unfolding, place.points, area)) {
              place.girth = loops::lengthOf(*unfolding, *neck);
            }
          }
        });
  }

  const SurfaceMesh& mesh_;
  const TubesOptions& options_;
  const ExecutionContext& context_;
  tubes::TubeTree tree_;
  std::vector<std::vector<tubes::LinePoint>> lines_;  // by branch of the tree
  Tubes found_;
};

}  // namespace

std::string_view toString(TubeChange change) {
  return change == TubeChange::Narrowing ? "narrowing" : "widening";
}

std::string_view toString(TubeReference reference) {
  switch (reference) {
    case TubeReference::Taper:
      return "taper";
    case TubeReference::Mean:
      return "mean";
    case TubeReference::Beyond:
      return "beyond";
    case TubeReference::Before:
      return "before";
  }
  return "";
}

std::string_view toString(NoTube reason) {
  switch (reason) {
    case NoTube::Handle:
      return "handle";
    case NoTube::Blunt:
      return "blunt";
    case NoTube::Flat:
      return "flat";
    case NoTube::Coarse:
      return "coarse";
  }
  return "";
}

Result<Tubes> findTubes(const SurfaceMesh& mesh, const TubesOptions& options,
                        const ExecutionContext& context) {
  if (!(options.spacing >= 0) || !std::isfinite(options.spacing)) {
    return makeError(ErrorCode::InvalidOption, -1, "the spacing is a length of 0 or more");
  }
  if (!(options.leastDegree > 0) || !std::isfinite(options.leastDegree)) {
    return makeError(ErrorCode::InvalidOption, -1, "the least degree is a share above 0");
  }
  return TubeSearch(mesh, options, context).run();
}

}  // namespace girth
