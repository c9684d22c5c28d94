#include "loops/pass_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "mesh/vector.h"

namespace girth::loops {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Searches of a way before what is known is taken.
constexpr int kMostRounds = 5000;

/// A point of a face by the weights of its corners: on an edge where one of them is 0.
SurfacePoint pointOf(Index face, const std::array<double, 3>& weights) {
  for (Index k = 0; k < 3; ++k) {
    if (weights[k] != 0) continue;
    return SurfacePoint::onHalfedge(SurfaceMesh::side(Face(face), (k + 1) % 3),
                                    weights[(k + 2) % 3]);
  }
  return SurfacePoint::inFace(Face(face), weights);
}

}  // namespace

PassSearch::PassSearch(const SurfaceMesh& mesh, std::span<const double> girth, Girth girthAt)
    : values_(girth.begin(), girth.end()),
      neighbours_(mesh.vertexCount()),
      coarsest_(mesh.meanEdgeLength()),
      girthAt_(std::move(girthAt)),
      reached_(mesh.vertexCount(), kInfinity),
      before_(mesh.vertexCount(), kNoIndex) {
  for (const Vertex v : mesh.vertices()) places_.push_back(mesh.position(v));
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
}

std::array<double, 3> PassSearch::middleIn(const Cell& cell, Index a, Index b) {
  std::array<double, 3> weights{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (cell.nodes[k] != a && cell.nodes[k] != b) continue;
    for (std::size_t j = 0; j < 3; ++j) weights[j] += cell.weights[k][j] / 2;
  }
  return weights;
}

SurfacePoint PassSearch::middleOf(Index a, Index b) const {
  const auto& sides = cellsAt_.at(segment(a, b));
  const Cell& cell = cells_[sides[0] != kNoIndex ? sides[0] : sides[1]];
  return pointOf(cell.face, middleIn(cell, a, b));
}

void PassSearch::halve(Index a, Index b, double value) {
  const auto sides = cellsAt_.at(segment(a, b));
  const auto middle = static_cast<Index>(places_.size());
  std::vector<Cell> halves;
  for (const Index number : sides) {
    if (number == kNoIndex) continue;
    const Cell& cell = cells_[number];
    const std::array<double, 3> weights = middleIn(cell, a, b);
    for (std::size_t k = 0; k < 3; ++k) {
      if (cell.nodes[k] != a && cell.nodes[k] != b) continue;
      halves.push_back(cell);
      halves.back().nodes[k] = middle;
      halves.back().weights[k] = weights;
    }
    removeCell(number);
  }
  cellsAt_.erase(segment(a, b));
  std::erase(neighbours_[a], b);
  std::erase(neighbours_[b], a);
  places_.push_back(0.5 * (places_[a] + places_[b]));
  values_.push_back(value);
  neighbours_.emplace_back();
  reached_.push_back(kInfinity);
  before_.push_back(kNoIndex);
  for (const Cell& half : halves) addCell(half);
}

PassSearch::Way PassSearch::lowestWay(std::span<const Vertex> starts,
                                      const std::vector<bool>& isEnd, double level) {
  for (const Index node : touched_) reached_[node] = kInfinity;
  touched_.clear();
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](Index node, double height, Index from) {
    if (!(height < reached_[node])) return;
    if (reached_[node] == kInfinity) touched_.push_back(node);
    reached_[node] = height;
    before_[node] = from;
    queue.emplace(height, node);
  };
  for (const Vertex v : starts) reach(v, level, kNoIndex);
  while (!queue.empty()) {
    const auto [height, node] = queue.top();
    queue.pop();
    if (height > reached_[node]) continue;
    if (node < isEnd.size() && isEnd[node]) {
      Way way{height, {}};
      for (Index at = node; at != kNoIndex; at = before_[at]) way.nodes.push_back(at);
      return way;
    }
    for (const Index next : neighbours_[node]) {
      // NaN is no way.
      if (values_[next] <= kInfinity) reach(next, std::max(height, values_[next]), node);
    }
  }
  return {kInfinity, {}};
}

Result<double> PassSearch::height(std::span<const Vertex> starts, const std::vector<bool>& isEnd,
                                  double level, double finest) {
  // From coarse to fine, so that only what can still be the lowest way is refined further.
  double step = finest;
  while (step < coarsest_) step *= 2;
  for (int round = 0; round < kMostRounds;) {
    const Way way = lowestWay(starts, isEnd, level);
    if (way.nodes.empty()) return way.height;
    const std::vector<std::pair<Index, Index>> coarse = coarseOn(way, step);
    if (coarse.empty()) {
      if (step <= finest) return way.height;
      step /= 2;
      continue;
    }
    ++round;
    std::vector<SurfacePoint> middles;
    for (const auto& [a, b] : coarse) middles.push_back(middleOf(a, b));
    const auto values = girthAt_(middles);
    if (!values) return values.error();
    for (std::size_t i = 0; i < coarse.size(); ++i) {
      halve(coarse[i].first, coarse[i].second, values.value()[i]);
    }
  }
  return lowestWay(starts, isEnd, level).height;
}

std::vector<std::pair<Index, Index>> PassSearch::coarseOn(const Way& way, double step) const {
  std::vector<std::pair<Index, Index>> coarse;
  for (std::size_t i = 0; i + 1 < way.nodes.size(); ++i) {
    const Index a = way.nodes[i], b = way.nodes[i + 1];
    const double apart = length(a, b);
    const double mean = (std::min(values_[a], way.height) + std::min(values_[b], way.height)) / 2;
    if (apart > step && mean + apart > way.height + step) coarse.emplace_back(a, b);
  }
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
