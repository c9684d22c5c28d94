#include "spectral/intrinsic_triangulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>

#include "mesh/face_shape.h"
#include "mesh/sides.h"

namespace girth::spectral {

namespace {

/// A face's sum of two sides is longer than the third by at least this share of its longest side.
constexpr double kFlattest = 1e-8;
/// The sum of two cotangents is negative only if it is so by this share of their magnitudes.
constexpr double kRounding = 1e-12;
constexpr std::size_t kFlipsPerEdge = 100;
constexpr std::size_t kStepsBetweenLooks = 4096;

/// Heron's formula in the order of operations that keeps its accuracy for flat triangles (Kahan).
double areaOf(double a, double b, double c) {
  if (a < b) std::swap(a, b);
  if (b < c) std::swap(b, c);
  if (a < b) std::swap(a, b);
  const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
  return product > 0 ? std::sqrt(product) / 4 : 0;
}

}  // namespace

IntrinsicTriangulation::IntrinsicTriangulation(const SurfaceMesh& mesh) {
  const Index count = mesh.halfedgeCount();
  from_.reserve(count);
  twin_.reserve(count);
  length_.reserve(count);
  double longest = 0;
  for (Index h = 0; h < count; ++h) {
    from_.push_back(mesh.from(Halfedge(h)));
    twin_.push_back(mesh.twin(Halfedge(h)));
    length_.push_back(mesh.length(Halfedge(h)));
    longest = std::max(longest, mesh.length(Halfedge(h)));
  }
  unit_ = scaleFor(longest);
  for (double& length : length_) length *= unit_;
  lengthenFlatFaces();
}

void IntrinsicTriangulation::lengthenFlatFaces() {
  double missing = 0;
  for (Index h = 0; h < halfedgeCount(); h += 3) {
    const auto [shortest, longest] = std::minmax({length_[h], length_[h + 1], length_[h + 2]});
    const double middle = std::max(std::min(length_[h], length_[h + 1]),
                                   std::min(std::max(length_[h], length_[h + 1]), length_[h + 2]));
    missing = std::max(missing, kFlattest * longest - (shortest - (longest - middle)));
  }
  if (missing > 0) {
    for (double& length : length_) length += missing;
  }
}

double IntrinsicTriangulation::area(Index face) const {
  return areaOf(length_[3 * face], length_[3 * face + 1], length_[3 * face + 2]);
}

double IntrinsicTriangulation::oppositeCotangent(Index halfedge) const {
  const double a = length_[halfedge], b = length_[nextSide(halfedge)],
               c = length_[previousSide(halfedge)];
  // The law of cosines, with the difference of squares in factors.
  return ((b - a) * (b + a) + c * c) / (4 * area(faceOfSide(halfedge)));
}

bool IntrinsicTriangulation::isDelaunay(Index halfedge) const {
  if (twin_[halfedge] == kNoIndex) return true;
  const double one = oppositeCotangent(halfedge), other = oppositeCotangent(twin_[halfedge]);
  return one + other >= -kRounding * (std::fabs(one) + std::fabs(other));
}

bool IntrinsicTriangulation::flip(Index halfedge) {
  // The faces abc and bad become dbc and cad.
  const Index h = halfedge, t = twin_[halfedge];
  const Index f = faceOfSide(h), g = faceOfSide(t);
  if (f == g) return false;
  const std::array<Index, 4> old{nextSide(t), previousSide(t), nextSide(h), previousSide(h)};
  const std::array<Index, 4> now{3 * g + 1, 3 * f, 3 * f + 1, 3 * g};
  std::array<Index, 4> twins{}, starts{};
  std::array<double, 4> lengths{};
  for (std::size_t i = 0; i < 4; ++i) {
    twins[i] = twin_[old[i]];
    starts[i] = from_[old[i]];
    lengths[i] = length_[old[i]];
  }
  // Unfolded with a at the origin and b on the x axis: c above, d below.
  const auto [ad, db, bc, ca] = lengths;
  const double ab = length_[h];
  const double cx = ((ca - bc) * (ca + bc) / ab + ab) / 2;
  const double dx = ((ad - db) * (ad + db) / ab + ab) / 2;
  const double x = cx - dx, y = 2 * (area(f) + area(g)) / ab;
  const double cd = std::sqrt(x * x + y * y);
  if (!(areaOf(db, bc, cd) > 0 && areaOf(ca, ad, cd) > 0)) return false;

  for (std::size_t i = 0; i < 4; ++i) {
    from_[now[i]] = starts[i];
    length_[now[i]] = lengths[i];
  }
  for (std::size_t i = 0; i < 4; ++i) {
    // A side may be glued to another of the four.
    const auto glued = std::find(old.begin(), old.end(), twins[i]);
    const Index twin = glued == old.end() ? twins[i] : now[std::size_t(glued - old.begin())];
    twin_[now[i]] = twin;
    if (twin != kNoIndex) twin_[twin] = now[i];
  }
  const Index one = 3 * f + 2, other = 3 * g + 2;
  from_[one] = starts[3];    // c
  from_[other] = starts[1];  // d
  length_[one] = length_[other] = cd;
  twin_[one] = other;
  twin_[other] = one;
  return true;
}

bool IntrinsicTriangulation::makeDelaunay(const ExecutionContext& context) {
  std::deque<Index> queue;
  std::vector<bool> queued(halfedgeCount(), false);
  const auto enqueue = [&](Index h) {
    if (twin_[h] == kNoIndex || queued[h] || queued[twin_[h]]) return;
    queued[h] = true;
    queue.push_back(h);
  };
  for (Index h = 0; h < halfedgeCount(); ++h) enqueue(h);
  std::size_t flips = 0, steps = 0;
  while (!queue.empty() && flips < kFlipsPerEdge * length_.size()) {
    if (++steps % kStepsBetweenLooks == 0 && context.cancelled()) return false;
    const Index h = queue.front();
    queue.pop_front();
    queued[h] = false;
    if (isDelaunay(h)) continue;
    const Index f = faceOfSide(h), g = faceOfSide(twin_[h]);
    if (!flip(h)) continue;
    ++flips;
    for (const Index side : {3 * f, 3 * f + 1, 3 * g, 3 * g + 1}) enqueue(side);
  }
  return !context.cancelled();
}

}  // namespace girth::spectral
