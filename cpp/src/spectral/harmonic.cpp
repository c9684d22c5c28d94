#include "spectral/harmonic.h"

#include <Eigen/Sparse>

#include <algorithm>
#include <cmath>

#include "no_value.h"

namespace girth::spectral {
namespace {

/// The range of the weights.
constexpr double kLeastWeight = 1e-3, kMostWeight = 1e3;

/// The cotangent of the angle opposite to a halfedge.
double cotangentOpposite(const SurfaceMesh& mesh, Halfedge h) {
  return 1 / std::tan(mesh.cornerAngle(SurfaceMesh::previous(h)));
}

double weightOf(const SurfaceMesh& mesh, Halfedge h) {
  const Halfedge twin = mesh.twin(h);
  double sum = cotangentOpposite(mesh, h);
  if (twin != Halfedge::none) sum += cotangentOpposite(mesh, twin);
  return std::clamp(sum / 2, kLeastWeight, kMostWeight);
}

}  // namespace

std::vector<double> harmonicFunction(const SurfaceMesh& mesh, std::span<const FixedValue> fixed) {
  std::vector<double> values(mesh.vertexCount(), kNoValue);
  std::vector<bool> hasFixed(mesh.componentCount(), false);
  for (const auto& [vertex, value] : fixed) {
    values[vertex] = value;
    hasFixed[mesh.componentOf(vertex)] = true;
  }
  // Unknowns are numbered in the order of the vertices.
  std::vector<int> unknown(mesh.vertexCount(), -1);
  std::vector<Vertex> vertexOf;
  for (const Vertex v : mesh.vertices()) {
    if (!hasFixed[mesh.componentOf(v)] || !std::isnan(values[v])) continue;
    unknown[v] = static_cast<int>(vertexOf.size());
    vertexOf.push_back(v);
  }
  if (vertexOf.empty()) return values;
  const auto count = static_cast<Eigen::Index>(vertexOf.size());
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> diagonal(vertexOf.size(), 0);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(count);
  const auto addAt = [&](Vertex at, Vertex other, double weight) {
    const int row = unknown[at];
    if (row < 0) return;
    diagonal[static_cast<std::size_t>(row)] += weight;
    if (unknown[other] >= 0) {
      entries.emplace_back(row, unknown[other], -weight);
    } else {
      right[row] += weight * values[other];
    }
  };
  for (const Halfedge h : mesh.halfedges()) {
    const Halfedge twin = mesh.twin(h);
    if (twin != Halfedge::none && twin < h) continue;
    const double weight = weightOf(mesh, h);
    addAt(mesh.from(h), mesh.to(h), weight);
    addAt(mesh.to(h), mesh.from(h), weight);
  }
  for (int i = 0; i < static_cast<int>(diagonal.size()); ++i) {
    entries.emplace_back(i, i, diagonal[static_cast<std::size_t>(i)]);
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
  if (factors.info() != Eigen::Success) return {};
  const Eigen::VectorXd found = factors.solve(right);
  for (std::size_t i = 0; i < vertexOf.size(); ++i) {
    values[vertexOf[i]] = found[static_cast<Eigen::Index>(i)];
  }
  return values;
}

}  // namespace girth::spectral
