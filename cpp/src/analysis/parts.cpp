#include "girth/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "analysis/otsu.h"
#include "analysis/regions.h"
#include "girth/vertex_areas.h"
#include "infinity.h"
#include "mesh/angles.h"
#include "mesh/neighbours.h"
#include "no_value.h"

namespace girth {

namespace {

/// The share of the variance that must lie between two sides that really differ; values that are
/// spread evenly reach 3/4.
constexpr double kClearDivision = 0.8;
constexpr int kMostSweeps = 50;

std::optional<Error> checkSizes(const SurfaceMesh& mesh, std::span<const double> girth,
                                std::span<const double> diameter) {
  if (girth.size() == mesh.vertexCount() && diameter.size() == mesh.vertexCount()) {
    return std::nullopt;
  }
  return makeError(ErrorCode::Usage, -1,
                   std::to_string(girth.size()) + " girths and " + std::to_string(diameter.size()) +
                       " diameters for " + std::to_string(mesh.vertexCount()) + " vertices");
}

std::optional<Error> checkLength(double value, const char* name) {
  if (value >= 0) return std::nullopt;
  return makeError(
      ErrorCode::Usage, -1,
      std::string(name) + " " + std::to_string(value) + " is not a number of at least 0");
}

/// Median of a field over some vertices; NaN where none has a value.
double medianOver(const std::vector<Vertex>& vertices, std::span<const double> field) {
  std::vector<double> values;
  for (const Vertex v : vertices) {
    if (!std::isnan(field[v])) values.push_back(field[v]);
  }
  if (values.empty()) return kNoValue;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

/// The vertex with the least value; none where none has one.
Vertex leastOver(const std::vector<Vertex>& vertices, std::span<const double> field) {
  Vertex least;
  for (const Vertex v : vertices) {
    if (!std::isnan(field[v]) && (least == kNoIndex || field[v] < field[least])) least = v;
  }
  return least;
}

PartKind kindOf(double girth, double diameter, const PartThresholds& thresholds) {
  if (std::isnan(girth) || std::isnan(diameter)) return PartKind::Unknown;
  if (!(diameter < thresholds.shapeDiameter) || girth == thresholds.girth) return PartKind::Body;
  return girth < thresholds.girth ? PartKind::Tube : PartKind::Plate;
}

/// Lets neighbourhoods decide, vertex by vertex.
void smooth(const SurfaceMesh& mesh, const std::vector<PartKind>& plain, double weight,
            std::vector<PartKind>& kinds) {
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    bool changed = false;
    for (const Vertex v : mesh.vertices()) {
      if (plain[v] == PartKind::Unknown) continue;
      std::array<double, 4> votes{};
      int neighbours = 0;
      forEachNeighbour(mesh, v, [&](Index) { ++neighbours; });
      forEachNeighbour(mesh, v, [&](Index neighbour) {
        votes[static_cast<std::size_t>(kinds[neighbour])] += weight / neighbours;
      });
      votes[static_cast<std::size_t>(plain[v])] += 1;
      votes[static_cast<std::size_t>(PartKind::Unknown)] = 0;
      const auto best =
          static_cast<PartKind>(std::max_element(votes.begin(), votes.end()) - votes.begin());
      // A tie changes nothing, so that sweeps come to an end.
      if (best == kinds[v] ||
          !(votes[static_cast<std::size_t>(best)] > votes[static_cast<std::size_t>(kinds[v])])) {
        continue;
      }
      kinds[v] = best;
      changed = true;
    }
    if (!changed) return;
  }
}

double areaOver(const std::vector<Vertex>& vertices, const std::vector<double>& areas) {
  double area = 0;
  for (const Vertex v : vertices) area += areas[v];
  return area;
}

}  // namespace

std::string_view toString(PartKind kind) {
  switch (kind) {
    case PartKind::Body:
      return "body";
    case PartKind::Tube:
      return "tube";
    case PartKind::Plate:
      return "plate";
    case PartKind::Unknown:
      break;
  }
  return "unknown";
}

double Part::equivalentRadius() const { return medianGirth / (2 * kPi); }

PartThresholds suggestedThresholds(const SurfaceMesh& mesh, std::span<const double> girth,
                                   std::span<const double> diameter) {
  if (checkSizes(mesh, girth, diameter)) return {};
  const std::vector<double> areas = vertexAreas(mesh);
  std::vector<Index> known;
  std::vector<WeightedValue> values;
  for (const Vertex v : mesh.vertices()) {
    if (!(girth[v] > 0 && diameter[v] > 0)) continue;
    known.push_back(v);
    values.push_back({std::log(diameter[v]), areas[v]});
  }
  if (known.empty()) return {};

  PartThresholds thresholds;
  const auto byDiameter = bestDivision(values, kClearDivision);
  thresholds.shapeDiameter = byDiameter ? std::exp(*byDiameter) : kInfinity;
  double thickest = 0;
  std::vector<WeightedValue> thin;
  std::vector<double> diameters;
  for (const Index v : known) {
    thickest = std::max(thickest, diameter[v]);
    if (!(diameter[v] < thresholds.shapeDiameter)) continue;
    thin.push_back({std::log(girth[v]), areas[v]});
    diameters.push_back(diameter[v]);
  }
  if (!byDiameter) thresholds.shapeDiameter = 1.01 * thickest;
  if (const auto byGirth = bestDivision(std::move(thin), kClearDivision)) {
    thresholds.girth = std::exp(*byGirth);
    return thresholds;
  }
  const auto middle = diameters.begin() + static_cast<std::ptrdiff_t>(diameters.size() / 2);
  std::nth_element(diameters.begin(), middle, diameters.end());
  thresholds.girth = 2 * kPi * *middle;
  return thresholds;
}

Result<Parts> findParts(const SurfaceMesh& mesh, std::span<const double> girth,
                        std::span<const double> diameter, const PartOptions& options) {
  if (auto error = checkSizes(mesh, girth, diameter)) return *std::move(error);
  if (auto error = checkLength(options.thresholds.girth, "the girth's threshold")) return *error;
  if (auto error =
          checkLength(options.thresholds.shapeDiameter, "the threshold of the shape diameter")) {
    return *error;
  }
  if (auto error = checkLength(options.smoothing, "the smoothing")) return *error;

  Parts result;
  for (const Vertex v : mesh.vertices()) {
    result.kinds.push_back(kindOf(girth[v], diameter[v], options.thresholds));
  }
  if (options.smoothing > 0) {
    const std::vector<PartKind> plain = result.kinds;
    smooth(mesh, plain, options.smoothing, result.kinds);
  }
  const std::vector<double> areas = vertexAreas(mesh);
  for (std::vector<Vertex>& region :
       connectedRegions(mesh, [&](Vertex v) { return static_cast<Index>(result.kinds[v]); })) {
    Part part;
    part.kind = result.kinds[region.front()];
    part.area = areaOver(region, areas);
    part.medianGirth = medianOver(region, girth);
    part.medianShapeDiameter = medianOver(region, diameter);
    if (part.kind != PartKind::Unknown) {
      part.thinnest = leastOver(region, part.kind == PartKind::Tube ? girth : diameter);
    }
    part.vertices = std::move(region);
    result.parts.push_back(std::move(part));
  }
  std::stable_sort(result.parts.begin(), result.parts.end(),
                   [](const Part& a, const Part& b) { return a.area > b.area; });
  result.partOf.resize(mesh.vertexCount());
  for (Index p = 0; p < result.parts.size(); ++p) {
    for (const Index v : result.parts[p].vertices) result.partOf[v] = p;
  }
  return result;
}

}  // namespace girth
