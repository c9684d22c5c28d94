#include "girth/spectrum.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <optional>
#include <string>

#include "spectral/eigenpairs.h"
#include "spectral/laplacian.h"

namespace girth {

namespace {

using spectral::ComponentLaplacian;
using spectral::Eigenpairs;

/// Pairs of one component: all of them, or the lowest.
struct Solved {
  Index asked{0};
  Eigenpairs pairs;
};

/// Which pair of which component.
struct Place {
  double value;
  std::size_t component, pair;
};

/// The lowest pairs of all components together. It asks each first for as many as its share of the
/// area lets expect (Weyl's law: value k is near 4π k / area), and for more where its last one
/// comes before the last that is wanted.
class Merging {
 public:
  Merging(const std::vector<ComponentLaplacian>& parts, Index wanted,
          const ExecutionContext& context)
      : parts_(parts), wanted_(wanted), context_(context), solved_(parts.size()) {}

  std::optional<Error> run() {
    double area = 0;
    for (const ComponentLaplacian& part : parts_) area += areaOf(part);
    for (std::size_t c = 0; c < parts_.size(); ++c) {
      const double expected = wanted_ * (areaOf(parts_[c]) / area);
      const Index more = parts_.size() == 1 ? 0 : 4 + static_cast<Index>(expected / 10);
      if (auto error = solve(c, static_cast<Index>(std::ceil(expected)) + more)) return error;
    }
    for (;;) {
      const std::optional<std::size_t> shortest = endsTooSoon();
      if (!shortest) return std::nullopt;
      if (auto error = solve(*shortest, 2 * solved_[*shortest].asked)) return error;
    }
  }

  const std::vector<Solved>& solved() const { return solved_; }

  std::vector<Place> lowest() const {
    std::vector<Place> places;
    for (std::size_t c = 0; c < solved_.size(); ++c) {
      const std::vector<double>& values = solved_[c].pairs.values;
      for (std::size_t k = 0; k < values.size(); ++k) places.push_back({values[k], c, k});
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const Place& a, const Place& b) { return a.value < b.value; });
    places.resize(std::min<std::size_t>(places.size(), wanted_));
    return places;
  }

 private:
  static double areaOf(const ComponentLaplacian& part) {
    return std::accumulate(part.laplacian.areas.begin(), part.laplacian.areas.end(), 0.0);
  }

  std::optional<Error> solve(std::size_t c, Index count) {
    const auto all = static_cast<Index>(parts_[c].vertices.size());
    solved_[c].asked = std::clamp<Index>(count, 1, std::min(all, wanted_));
    ExecutionContext inner;
    inner.cancel = context_.cancel;
    inner.onProgress = [&](double fraction) {
      const double now = (static_cast<double>(c) + fraction) / static_cast<double>(parts_.size());
      if (!context_.onProgress || now < progress_ + 0.01) return;
      progress_ = now;
      context_.onProgress(now);
    };
    auto pairs = spectral::lowestEigenpairs(parts_[c].laplacian, solved_[c].asked, inner);
    if (!pairs) return pairs.error();
    solved_[c].pairs = std::move(pairs).value();
    return std::nullopt;
  }

  /// The component, not yet asked for all that can be wanted, whose last value is the lowest such,
  /// if it lies below the last that is wanted.
  std::optional<std::size_t> endsTooSoon() const {
    const std::vector<Place> places = lowest();
    const bool enough = places.size() == wanted_;
    std::optional<std::size_t> found;
    for (std::size_t c = 0; c < solved_.size(); ++c) {
      const auto most = std::min<std::size_t>(parts_[c].vertices.size(), wanted_);
      if (solved_[c].asked >= most) continue;
      const double last = solved_[c].pairs.values.back();
      if (enough && last >= places.back().value) continue;
      if (!found || last < solved_[*found].pairs.values.back()) found = c;
    }
    return found;
  }

  const std::vector<ComponentLaplacian>& parts_;
  const Index wanted_;
  const ExecutionContext& context_;
  std::vector<Solved> solved_;
  double progress_{0};
};

/// 1, or −1 for a function to be turned over (spectrum.h).
double signOf(const double* phi, std::size_t n) {
  double greatest = 0;
  for (std::size_t v = 0; v < n; ++v) greatest = std::max(greatest, std::fabs(phi[v]));
  std::size_t v = 0;
  while (std::fabs(phi[v]) < (1 - 1e-6) * greatest) ++v;
  return phi[v] < 0 ? -1 : 1;
}

Result<Spectrum> compute(const SurfaceMesh& mesh, Index wanted, const ExecutionContext& context) {
  const Error cancelled = makeError(ErrorCode::Cancelled, -1, "cancelled");
  spectral::IntrinsicTriangulation triangles(mesh);
  if (!triangles.makeDelaunay(context)) return cancelled;
  spectral::Laplacian laplacian = cotangentLaplacian(triangles, mesh.vertexCount());
  // Lengths were multiplied by the unit.
  const double unit = triangles.unit();
  Spectrum result;
  for (const double area : laplacian.areas) result.areas.push_back(area / unit / unit);

  const auto parts = byComponent(std::move(laplacian), mesh);
  Merging merging(parts, wanted, context);
  if (auto error = merging.run()) return *std::move(error);
  const std::size_t n = mesh.vertexCount();
  const std::vector<Place> places = merging.lowest();
  result.vectors.assign(n * places.size(), 0);
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto& [value, component, pair] = places[k];
    const std::vector<Index>& vertices = parts[component].vertices;
    const double* phi = &merging.solved()[component].pairs.vectors[pair * vertices.size()];
    const double factor = signOf(phi, vertices.size()) * unit;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      result.vectors[k * n + vertices[i]] = factor * phi[i];
    }
    result.values.push_back(value * unit * unit);
  }
  if (context.onProgress) context.onProgress(1);
  return result;
}

}  // namespace

Result<Spectrum> laplaceSpectrum(const SurfaceMesh& mesh, const SpectrumOptions& options,
                                 const ExecutionContext& context) {
  if (options.pairs < 1) {
    return makeError(ErrorCode::InvalidOption, -1, "0 eigenpairs; at least 1");
  }
  try {
    return compute(mesh, std::min(options.pairs, mesh.vertexCount()), context);
  } catch (const std::bad_alloc&) {
    return makeError(ErrorCode::OutOfMemory, -1,
                     "there is not enough memory for " + std::to_string(options.pairs) +
                         " eigenfunctions of " + std::to_string(mesh.vertexCount()) + " vertices");
  }
}

}  // namespace girth
