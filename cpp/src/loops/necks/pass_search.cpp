#include "loops/necks/pass_search.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "loops/cut/faces_of_points.h"
#include "mesh/vector.h"

namespace girth::loops {
namespace {

/// Searches of a way before what is known is taken.
constexpr int kMostRounds = 5000;

/// Searches of a way after which segments are no longer halved as they are. Nearly all end before.
/// In the others the halves make narrow cells, with long sides that are halved in turn for ever.
constexpr int kPlainRounds = 300;

/// Lengths of one loop agree to this share.
constexpr double kRounding = 1e-9;

/// How finely a height is known, as a share of its rise above the level.
constexpr double kFinestRise = 1e-2;

/// Nearer to a side of a cell than this share of the cell: on it.
constexpr double kOnSide = 1e-9;

double determinant(const Weights& a, const Weights& b, const Weights& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

}  // namespace

PassSearch::PassSearch(const SurfaceMesh& mesh, std::span<const double> girth, Girth girthAt,
                       UpperBound upperBoundOf)
    : mesh_(mesh),
      values_(girth.begin(), girth.end()),
      neighbours_(mesh.vertexCount()),
      coarsest_(mesh.meanEdgeLength()),
      girthAt_(std::move(girthAt)),
      upperBoundOf_(std::move(upperBoundOf)) {
  for (const Vertex v : mesh.vertices()) {
    places_.push_back(mesh.position(v));
    points_.push_back(SurfacePoint::atVertex(v));
  }
  cellsAt_.reserve(mesh.edgeCount());
  for (const Face f : mesh.faces()) {
    const auto corners = mesh.faceVertices(f);
    addCell({f, {corners[0], corners[1], corners[2]}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}});
  }
}

std::uint64_t PassSearch::segment(Index a, Index b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

double PassSearch::length(Index a, Index b) const { return norm(places_[a] - places_[b]); }

void PassSearch::addCell(const Cell& cell) {
  const auto number = static_cast<Index>(cells_.size());
  cells_.push_back(cell);
  for (std::size_t k = 0; k < 3; ++k) {
    const Index a = cell.nodes[k], b = cell.nodes[(k + 1) % 3];
    const auto [place, isNew] = cellsAt_.try_emplace(segment(a, b), std::array{number, kNoIndex});
    if (isNew) {
      neighbours_[a].push_back(b);
      neighbours_[b].push_back(a);
    } else if (place->second[0] == kNoIndex) {
      place->second[0] = number;
    } else {
      place->second[1] = number;
    }
  }
}

void PassSearch::removeCell(Index cell) {
  for (std::size_t k = 0; k < 3; ++k) {
    auto& sides = cellsAt_.at(segment(cells_[cell].nodes[k], cells_[cell].nodes[(k + 1) % 3]));
    std::replace(sides.begin(), sides.end(), cell, kNoIndex);
  }
  cells_[cell].face = kNoIndex;
}

std::array<double, 3> PassSearch::weightsBetween(const Cell& cell, Index a, Index b, double share) {
  std::array<double, 3> weights{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (cell.nodes[k] != a && cell.nodes[k] != b) continue;
    for (std::size_t j = 0; j < 3; ++j) {
      weights[j] += (cell.nodes[k] == a ? 1 - share : share) * cell.weights[k][j];
    }
  }
  return weights;
}

Index PassSearch::cellBeside(Index a, Index b) const {
  const auto& sides = cellsAt_.at(segment(a, b));
  return sides[0] != kNoIndex ? sides[0] : sides[1];
}

SurfacePoint PassSearch::middleOf(Index a, Index b) const {
  const Cell& cell = cells_[cellBeside(a, b)];
  return pointIn(Face(cell.face), weightsBetween(cell, a, b, 0.5));
}

Index PassSearch::addNode(const SurfacePoint& point, const Vec3& place, double value) {
  places_.push_back(place);
  points_.push_back(point);
  values_.push_back(value);
  neighbours_.emplace_back();
  return static_cast<Index>(places_.size() - 1);
}

void PassSearch::divide(Index a, Index b, double share, double value) {
  const auto sides = cellsAt_.at(segment(a, b));
  const auto node = static_cast<Index>(places_.size());
  std::vector<Cell> pieces;
  for (const Index number : sides) {
    if (number == kNoIndex) continue;
    const Cell& cell = cells_[number];
    const std::array<double, 3> weights = weightsBetween(cell, a, b, share);
    for (std::size_t k = 0; k < 3; ++k) {
      if (cell.nodes[k] != a && cell.nodes[k] != b) continue;
      pieces.push_back(cell);
      pieces.back().nodes[k] = node;
      pieces.back().weights[k] = weights;
    }
    removeCell(number);
  }
  cellsAt_.erase(segment(a, b));
  std::erase(neighbours_[a], b);
  std::erase(neighbours_[b], a);
  const Cell& piece = pieces.front();
  const auto corner = static_cast<std::size_t>(
      std::find(piece.nodes.begin(), piece.nodes.end(), node) - piece.nodes.begin());
  addNode(pointIn(Face(piece.face), piece.weights[corner]),
          (1 - share) * places_[a] + share * places_[b], value);
  for (const Cell& one : pieces) addCell(one);
  ways_.onDivision(a, b, node);
}

Index PassSearch::insert(const SurfacePoint& point, double value) {
  if (point.kind == SurfacePoint::Kind::AtVertex) return point.element;
  const Face face = faceAt(mesh_, point);
  const Weights weights = weightsIn(mesh_, face, point).value_or(Weights{});
  // The cell of the face that it lies in, or lies outside of least.
  Index best = kNoIndex;
  Weights shares{};
  for (Index c = 0; c < cells_.size(); ++c) {
    const Cell& cell = cells_[c];
    if (cell.face != face) continue;
    const auto& [a, b, d] = cell.weights;
    const double whole = determinant(a, b, d);
    const Weights own{determinant(weights, b, d) / whole, determinant(a, weights, d) / whole,
                      determinant(a, b, weights) / whole};
    if (best == kNoIndex || *std::min_element(own.begin(), own.end()) >
                                *std::min_element(shares.begin(), shares.end())) {
      best = c;
      shares = own;
    }
  }
  const Cell cell = cells_[best];
  for (std::size_t k = 0; k < 3; ++k) {
    if (shares[k] >= 1 - kOnSide) return cell.nodes[k];
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (shares[k] > kOnSide) continue;
    const double share = shares[(k + 2) % 3] / (shares[(k + 1) % 3] + shares[(k + 2) % 3]);
    divide(cell.nodes[(k + 1) % 3], cell.nodes[(k + 2) % 3], share, value);
    return static_cast<Index>(places_.size() - 1);
  }
  Vec3 place;
  for (std::size_t k = 0; k < 3; ++k) place = place + shares[k] * places_[cell.nodes[k]];
  const Index node = addNode(point, place, value);
  removeCell(best);
  for (std::size_t k = 0; k < 3; ++k) {
    Cell piece = cell;
    piece.nodes[k] = node;
    piece.weights[k] = weights;
    addCell(piece);
  }
  return node;
}

Result<double> PassSearch::height(std::span<const Vertex> starts, const std::vector<bool>& isEnd,
                                  double level, double finest) {
  const std::vector<Index> nodes(starts.begin(), starts.end());
  const auto way = refinedWay(nodes, isEnd, level, finest, kFinestRise);
  if (!way) return way.error();
  return way.value().height;
}

Result<PassSearch::Path> PassSearch::between(Index from, Index to, double finest) {
  std::vector<bool> isEnd(places_.size(), false);
  isEnd[to] = true;
  const auto way =
      refinedWay(std::span(&from, 1), isEnd, std::max(values_[from], values_[to]), finest, 0);
  if (!way) return way.error();
  Path path{way.value().height, {}, {}};
  for (auto node = way.value().nodes.rbegin(); node != way.value().nodes.rend(); ++node) {
    path.points.push_back(points_[*node]);
    path.values.push_back(values_[*node]);
  }
  return path;
}

Result<PassSearch::NodePath> PassSearch::refinedWay(std::span<const Index> starts,
                                                    const std::vector<bool>& isEnd, double level,
                                                    double finest, double share) {
  // From coarse to fine, so that only what can still be the lowest way is refined further.
  double step = finest;
  while (step < coarsest_) step *= 2;
  ways_.start(starts, level);
  for (int round = 0; round < kMostRounds;) {
    const NodePath way = ways_.to(isEnd);
    if (way.nodes.empty()) return way;
    auto found = coarseOn(way, step);
    if (!found) return found.error();
    std::vector<std::pair<Index, Index>> coarse = std::move(found).value();
    if (coarse.empty()) {
      if (step <= std::max(finest, share * (way.height - level))) return way;
      step /= 2;
      continue;
    }
    if (++round > kPlainRounds) {
      for (auto& [a, b] : coarse) std::tie(a, b) = longestFrom(a, b);
      std::sort(coarse.begin(), coarse.end());
      coarse.erase(std::unique(coarse.begin(), coarse.end()), coarse.end());
    }
    std::vector<SurfacePoint> middles;
    for (const auto& [a, b] : coarse) middles.push_back(middleOf(a, b));
    const auto values = girthAt_(middles);
    if (!values) return values.error();
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      divide(coarse[i].first, coarse[i].second, 0.5, values.value()[i]);
    }
  }
  return ways_.to(isEnd);
}

std::pair<Index, Index> PassSearch::longestFrom(Index a, Index b) const {
  double longest = length(a, b);
  for (bool isLonger = true; isLonger;) {
    isLonger = false;
    for (const Index number : cellsAt_.at(segment(a, b))) {
      if (number == kNoIndex) continue;
      const Cell& cell = cells_[number];
      for (std::size_t k = 0; k < 3; ++k) {
        const Index from = cell.nodes[k], to = cell.nodes[(k + 1) % 3];
        if (length(from, to) <= longest) continue;
        longest = length(from, to);
        a = std::min(from, to);
        b = std::max(from, to);
        isLonger = true;
      }
      if (isLonger) break;
    }
  }
  return {a, b};
}

std::optional<Error> PassSearch::dropBelow(double height,
                                           std::vector<std::pair<Index, Index>>& segments) {
  if (!upperBoundOf_) return std::nullopt;
  // From one end first, and from the other one where that does not suffice.
  for (int end = 0; end < 2; ++end) {
    const auto directed = [](const std::pair<Index, Index>& one) {
      return std::uint64_t{one.first} << 32 | one.second;
    };
    std::vector<Segment> unknown;
    std::vector<std::uint64_t> keys;
    for (const auto& one : segments) {
      const auto [a, b] = one;
      if (upperBounds_.contains(directed(one))) continue;
      unknown.push_back({a, points_[a], points_[b], Face(cells_[cellBeside(a, b)].face)});
      keys.push_back(directed(one));
    }
    const auto found = upperBoundOf_(unknown);
    if (!found) return found.error();
    for (std::size_t i = 0; i < keys.size(); ++i) upperBounds_[keys[i]] = found.value()[i];
    std::erase_if(segments, [&](const auto& one) {
      const double bound = upperBounds_.at(directed(one));
      // Where it is less than the girth, the girth has jumped on the way.
      return std::max(values_[one.first], bound) <= height &&
             bound >= values_[one.second] * (1 - kRounding);
    });
    for (auto& [a, b] : segments) std::swap(a, b);
  }
  return std::nullopt;
}

Result<std::vector<std::pair<Index, Index>>> PassSearch::coarseOn(const NodePath& way,
                                                                  double step) {
  std::vector<std::pair<Index, Index>> coarse;
  for (std::size_t i = 0; i + 1 < way.nodes.size(); ++i) {
    const Index a = way.nodes[i], b = way.nodes[i + 1];
    const double apart = length(a, b);
    const double mean = (std::min(values_[a], way.height) + std::min(values_[b], way.height)) / 2;
    if (apart > step && mean + apart > way.height + step) coarse.emplace_back(a, b);
  }
  if (auto error = dropBelow(way.height + step, coarse)) return *error;
  for (const Index node : way.nodes) {
    if (values_[node] < way.height) continue;
    for (const Index next : neighbours_[node]) {
      if (length(node, next) > step) coarse.emplace_back(node, next);
    }
  }
  // Each once, in an order of its own.
  for (auto& [a, b] : coarse) {
    if (a > b) std::swap(a, b);
  }
  std::sort(coarse.begin(), coarse.end());
  coarse.erase(std::unique(coarse.begin(), coarse.end()), coarse.end());
  return coarse;
}

}  // namespace girth::loops
