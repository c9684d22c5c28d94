#include "spectral/eigenpairs.h"

#include <Spectra/SymEigsSolver.h>
#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <optional>

#include "mesh/angles.h"
#include "random.h"

namespace girth::spectral {

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Up to so many vertices, and wherever the pairs are more than a third of the vertices, all pairs
/// of the full matrix are computed: Lanczos would need as long.
constexpr Index kDense = 200;
/// Lanczos computes some pairs more than asked for, so that a gap can be found behind the last.
constexpr Index kExtraPairs = 12;
/// Relative accuracy of the eigenvalues of the inverse.
constexpr double kTolerance = 1e-11;
constexpr Eigen::Index kMostRestarts = 300;
/// Values nearer to each other than this share of the greater are not distinguished by counting.
constexpr double kGap = 1e-8;
/// How often what is missing is looked for.
constexpr int kRounds = 6;

struct CancelledException {};

/// A = M^-½ L M^-½, which has the same values as the pair (L, M); its vectors are M^½ φ.
SparseMatrix symmetricMatrix(const Laplacian& laplacian) {
  const auto n = static_cast<Eigen::Index>(laplacian.areas.size());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * laplacian.edges.size());
  for (const auto& [i, j, weight] : laplacian.edges) {
    const auto a = static_cast<int>(i), b = static_cast<int>(j);
    const double entry = -weight / std::sqrt(laplacian.areas[i] * laplacian.areas[j]);
    entries.emplace_back(a, b, entry);
    entries.emplace_back(b, a, entry);
    entries.emplace_back(a, a, weight / laplacian.areas[i]);
    entries.emplace_back(b, b, weight / laplacian.areas[j]);
  }
  SparseMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Vectors orthogonal to each other, of length 1.
class Basis {
 public:
  explicit Basis(const Vector& first) : columns_(first), size_(1) {}

  Eigen::Index size() const { return size_; }
  auto column(Eigen::Index k) const { return columns_.col(k); }

  /// Takes away what lies in the space of the basis.
  void project(Vector& x) const {
    const auto used = columns_.leftCols(size_);
    x.noalias() -= used * (used.transpose() * x).eval();
  }

  /// Takes away, twice for the sake of rounding, and adds what is left, if there is anything.
  bool add(Vector x) {
    const double before = x.norm();
    project(x);
    project(x);
    const double after = x.norm();
    if (!(after > 1e-6 * before)) return false;
    if (size_ == columns_.cols()) columns_.conservativeResize(Eigen::NoChange, 2 * size_);
    columns_.col(size_++) = x / after;
    return true;
  }

 private:
  Matrix columns_;
  Eigen::Index size_;
};

/// The operator that Spectra iterates with: (A − shift)^-1 in the space that is left beside a
/// basis.
class InverseOperator {
 public:
  using Scalar = double;

  template <class Solver>
  InverseOperator(const Solver& solver, const Basis& known, const ExecutionContext& context)
      : solve_([&solver](const Vector& x) -> Vector { return solver.solve(x); }),
        known_(known),
        context_(context) {}

  Eigen::Index rows() const { return known_.column(0).size(); }
  Eigen::Index cols() const { return rows(); }
  void perform_op(const double* input, double* output) const {  // NOLINT: Spectra's name
    if (context_.cancelled()) throw CancelledException{};
    Vector x = Eigen::Map<const Vector>(input, rows());
    known_.project(x);
    x = solve_(x);
    known_.project(x);
    Eigen::Map<Vector>(output, rows()) = x;
    ++steps_;
    // How many steps there will be is not known beforehand.
    if (context_.onProgress)
      context_.onProgress(steps_ / (steps_ + static_cast<double>(rows()) / 4));
  }

 private:
  std::function<Vector(const Vector&)> solve_;
  const Basis& known_;
  const ExecutionContext& context_;
  mutable double steps_{0};
};

/// Numbers between −½ and ½, the same everywhere.
Vector arbitraryVector(Eigen::Index n, std::uint64_t seed) {
  Random random(seed);
  Vector x(n);
  for (Eigen::Index i = 0; i < n; ++i) x[i] = random() - 0.5;
  return x;
}

/// φᵀ L φ by differences: exact to rounding for small values too, and never negative where no
/// weight is.
double rayleighQuotient(const Laplacian& laplacian, const double* phi) {
  double sum = 0;
  for (const auto& [i, j, weight] : laplacian.edges) {
    const double difference = phi[i] - phi[j];
    sum += weight * difference * difference;
  }
  return sum;
}

/// Pairs from the vectors of A, in the order of their values.
Eigenpairs pairsOf(const Laplacian& laplacian, const Basis& basis, Index count) {
  const std::size_t n = laplacian.areas.size();
  const auto columns = static_cast<std::size_t>(basis.size());
  std::vector<double> phi(n * columns), values(columns);
  for (std::size_t k = 0; k < columns; ++k) {
    for (std::size_t v = 0; v < n; ++v) {
      phi[k * n + v] = basis.column(static_cast<Eigen::Index>(k))[static_cast<Eigen::Index>(v)] /
                       std::sqrt(laplacian.areas[v]);
    }
    values[k] = k == 0 ? 0 : std::max(0.0, rayleighQuotient(laplacian, &phi[k * n]));
  }
  std::vector<std::size_t> order(columns);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  order.resize(count);
  Eigenpairs pairs;
  for (const std::size_t k : order) {
    pairs.values.push_back(values[k]);
    pairs.vectors.insert(pairs.vectors.end(), phi.begin() + static_cast<std::ptrdiff_t>(k * n),
                         phi.begin() + static_cast<std::ptrdiff_t>((k + 1) * n));
  }
  return pairs;
}

/// The vector of the value 0: constant φ.
Vector constantVector(const Laplacian& laplacian) {
  Vector x(static_cast<Eigen::Index>(laplacian.areas.size()));
  double sum = 0;
  for (const double area : laplacian.areas) sum += area;
  for (Eigen::Index v = 0; v < x.size(); ++v) {
    x[v] = std::sqrt(laplacian.areas[static_cast<std::size_t>(v)] / sum);
  }
  return x;
}

/// Below all values by what lies between two of them on average (Weyl's law).
double shiftFor(const Laplacian& laplacian) {
  double area = 0;
  for (const double share : laplacian.areas) area += share;
  return -4 * kPi / area;
}

Error incomplete() {
  return makeError(ErrorCode::Internal, -1, "the eigenvalues did not come out complete");
}

/// By the full inverse, since rounding harms the greatest values of a matrix least: where needles
/// make some values huge, those are not wanted.
Result<Eigenpairs> byFullMatrix(const Laplacian& laplacian, Index wanted) {
  const auto count = static_cast<Eigen::Index>(wanted);
  Matrix matrix(symmetricMatrix(laplacian));
  matrix.diagonal().array() -= shiftFor(laplacian);
  const Eigen::Index n = matrix.rows();
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(
      Eigen::LLT<Matrix>(matrix).solve(Matrix::Identity(n, n)));
  if (solver.info() != Eigen::Success) {
    return makeError(ErrorCode::Internal, -1, "the eigenvalues of the full matrix did not settle");
  }
  Basis basis(constantVector(laplacian));
  for (Eigen::Index k = n; k-- > 0 && basis.size() < count;)
    basis.add(solver.eigenvectors().col(k));
  if (basis.size() < count) return incomplete();
  return pairsOf(laplacian, basis, wanted);
}

/// Lanczos, again and again in the space that is left, until no pair is missing.
class Search {
 public:
  Search(const Laplacian& laplacian, Index count, const ExecutionContext& context)
      : laplacian_(laplacian),
        context_(context),
        count_(count),
        matrix_(symmetricMatrix(laplacian)),
        known_(constantVector(laplacian)),
        values_{0} {
    factors_.analyzePattern(matrix_);
  }

  Result<Eigenpairs> run() {
    const double shift = shiftFor(laplacian_);
    Index wanted = count_ - 1 + kExtraPairs;
    for (int round = 0; round < kRounds; ++round) {
      if (!factorise(shift)) break;
      if (!lanczos(wanted, shift, static_cast<std::uint64_t>(round))) break;
      const auto missing = countMissing();
      if (context_.cancelled()) throw CancelledException{};
      if (!missing) break;
      if (*missing == 0) return pairsOf(laplacian_, known_, count_);
      wanted = *missing + kExtraPairs;
    }
    return incomplete();
  }

 private:
  bool factorise(double shift) {
    factors_.setShift(-shift);
    factors_.factorize(matrix_);
    return factors_.info() == Eigen::Success;
  }

  /// Adds `wanted` pairs more. False where they did not settle.
  bool lanczos(Index wanted, double shift, std::uint64_t seed) {
    InverseOperator inverse(factors_, known_, context_);
    const Eigen::Index left = matrix_.rows() - known_.size();
    const Eigen::Index pairs = std::min<Eigen::Index>(wanted, left - 1);
    const Eigen::Index subspace = std::min(left, std::max<Eigen::Index>(2 * pairs, pairs + 20));
    if (pairs < 1) return true;
    Spectra::SymEigsSolver<InverseOperator> solver(inverse, pairs, subspace);
    Vector start = arbitraryVector(matrix_.rows(), seed);
    known_.project(start);
    solver.init(start.data());
    const Eigen::Index settled =
        solver.compute(Spectra::SortRule::LargestAlge, kMostRestarts, kTolerance);
    if (settled < pairs) return false;
    const Matrix vectors = solver.eigenvectors();
    const Vector inverses = solver.eigenvalues();
    for (Eigen::Index k = 0; k < pairs; ++k) {
      if (known_.add(vectors.col(k))) values_.push_back(1 / inverses[k] + shift);
    }
    return true;
  }

  /// How many values below some gap are not among those found: behind the last that is wanted if
  /// there is a gap, else before. Nothing where the matrix could not be factorised.
  std::optional<Index> countMissing() {
    std::vector<double> sorted = values_;
    std::sort(sorted.begin(), sorted.end());
    const auto gapBehind = [&](std::size_t k) {
      return (sorted[k + 1] - sorted[k]) / sorted[k + 1];
    };
    std::size_t at = 0;
    for (std::size_t k = count_ - 1; k + 1 < sorted.size(); ++k) {
      if (gapBehind(k) > (at == 0 ? kGap : gapBehind(at))) at = k;
    }
    for (std::size_t k = count_ - 1; at == 0 && k-- > 0;) {
      if (gapBehind(k) > kGap) at = k;
    }
    if (!factorise((sorted[at] + sorted[at + 1]) / 2)) return std::nullopt;
    const auto below = (factors_.vectorD().array() < 0).count();
    const auto found = static_cast<Eigen::Index>(at) + 1;
    return static_cast<Index>(below > found ? below - found : 0);
  }

  const Laplacian& laplacian_;
  const ExecutionContext& context_;
  const Index count_;
  const SparseMatrix matrix_;
  Eigen::SimplicialLDLT<SparseMatrix> factors_;
  Basis known_;
  std::vector<double> values_;  // eigenvalues of the basis
};

}  // namespace

Result<Eigenpairs> lowestEigenpairs(const Laplacian& laplacian, Index count,
                                    const ExecutionContext& context) {
  const auto n = static_cast<Index>(laplacian.areas.size());
  if (context.cancelled()) return makeError(ErrorCode::Cancelled, -1, "cancelled");
  if (n <= kDense || count > n / 3) return byFullMatrix(laplacian, count);
  try {
    return Search(laplacian, count, context).run();
  } catch (const CancelledException&) {
    return makeError(ErrorCode::Cancelled, -1, "cancelled");
  }
}

}  // namespace girth::spectral
