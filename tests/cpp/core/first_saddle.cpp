#include "first_saddle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <unordered_map>
#include <utility>
#include <vector>

namespace girth::test {

namespace {

using Place = std::array<double, 2>;  // in the plane of a face of the mesh

struct Triangle {
  std::array<Index, 3> vertices;
  std::array<Place, 3> places;
  Index face;
  bool touched;  // the field may be below the limit in it
};

std::uint64_t keyOf(Index a, Index b) {
  return (static_cast<std::uint64_t>(std::max(a, b)) << 32) | std::min(a, b);
}

/// The subdivided surface, with the distance at its vertices.
class Samples {
 public:
  Samples(const SurfaceMesh& mesh, const TextbookMmp& field, double limit, double spacing)
      : field_(field), limit_(limit), spacing_(spacing) {
    distance.resize(mesh.vertexCount());
    for (const Vertex v : mesh.vertices()) {
      distance[v] = field.distanceTo(SurfacePoint::atVertex(v));
    }
    triangles.reserve(mesh.faceCount());
    for (const Face f : mesh.faces()) {
      bool touched = false;
      for (Index h = 3 * f; h < 3 * f + 3; ++h) touched = touched || field.leastOn(h) < limit;
      const auto [a, b, c] = mesh.faceVertices(f);
      triangles.push_back({{a, b, c}, field.corners(f), f, touched});
    }
    while (refine()) {
    }
  }

  std::vector<Triangle> triangles;
  std::vector<double> distance;

 private:
  /// Whether a side is to be halved.
  bool tooLong(const Triangle& t, int k) const {
    if (!t.touched) return false;
    const int n = (k + 1) % 3;
    const double length =
        std::hypot(t.places[n][0] - t.places[k][0], t.places[n][1] - t.places[k][1]);
    if (length <= spacing_) return false;
    // No point of it is nearer than this. Beyond limit + spacing, distances are not known.
    const auto known = [&](Index v) { return std::min(distance[v], limit_ + spacing_); };
    return (known(t.vertices[k]) + known(t.vertices[n]) - length) / 2 < limit_;
  }

  /// Halves all sides that are too long, whichever triangle says so, and parts the triangles that
  /// have them; false if there were none.
  bool refine() {
    std::unordered_map<std::uint64_t, Index> middles;
    for (const Triangle& t : triangles) {
      for (int k = 0; k < 3; ++k) {
        if (!tooLong(t, k)) continue;
        const int n = (k + 1) % 3;
        const auto [it, isNew] = middles.try_emplace(keyOf(t.vertices[k], t.vertices[n]),
                                                     static_cast<Index>(distance.size()));
        if (!isNew) continue;
        const Place middle = half(t.places[k], t.places[n]);
        distance.push_back(field_.distanceTo(t.face, middle[0], middle[1]));
      }
    }
    if (middles.empty()) return false;
    std::vector<Triangle> parts;
    parts.reserve(triangles.size() + 3 * middles.size());
    for (const Triangle& t : triangles) {
      std::array<Index, 3> middle{};
      int count = 0;
      for (int k = 0; k < 3; ++k) {
        const auto it = middles.find(keyOf(t.vertices[k], t.vertices[(k + 1) % 3]));
        middle[k] = it == middles.end() ? kNoIndex : it->second;
        if (it != middles.end()) ++count;
      }
      if (count == 0) {
        parts.push_back(t);
        continue;
      }
      // Turned so that its first side is halved, and its second one if there is another.
      int first = 0;
      while (middle[first] == kNoIndex || (count == 2 && middle[(first + 1) % 3] == kNoIndex)) {
        ++first;
      }
      const int i = first, j = (first + 1) % 3, k = (first + 2) % 3;
      const Index a = t.vertices[i], b = t.vertices[j], c = t.vertices[k];
      const Place pa = t.places[i], pb = t.places[j], pc = t.places[k];
      const Index ab = middle[i], bc = middle[j], ca = middle[k];
      const Place pab = half(pa, pb), pbc = half(pb, pc), pca = half(pc, pa);
      const auto add = [&](Index u, Place pu, Index v, Place pv, Index w, Place pw) {
        parts.push_back({{u, v, w}, {pu, pv, pw}, t.face, t.touched});
      };
      if (count == 1) {
        add(a, pa, ab, pab, c, pc);
        add(ab, pab, b, pb, c, pc);
      } else {
        add(ab, pab, b, pb, bc, pbc);
        if (count == 2) {
          add(a, pa, ab, pab, bc, pbc);
          add(a, pa, bc, pbc, c, pc);
        } else {
          add(a, pa, ab, pab, ca, pca);
          add(ca, pca, bc, pbc, c, pc);
          add(ab, pab, bc, pbc, ca, pca);
        }
      }
    }
    triangles.swap(parts);
    return true;
  }

  static Place half(Place a, Place b) { return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}; }

  const TextbookMmp& field_;
  double limit_, spacing_;
};

/// Sets of triangles, each known by the one that enters last.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index child, Index parent) { parent_[child] = parent; }

 private:
  std::vector<Index> parent_;
};

}  // namespace

SampledCycles sampledCycles(const SurfaceMesh& mesh, const TextbookMmp& field, double limit,
                            double spacing) {
  const Samples samples(mesh, field, limit, spacing);
  const auto vertices = static_cast<Index>(samples.distance.size());
  const auto triangles = static_cast<Index>(samples.triangles.size());

  SampledCycles result;
  result.error = spacing / std::sqrt(3.0);
  result.triangles = triangles;
  for (const double d : samples.distance) {
    if (d < limit) result.farthest = std::max(result.farthest, d);
  }

  // The order in which vertices enter the sublevel set, and with the last of its vertices each side
  // and each triangle.
  std::vector<Index> order(vertices), rank(vertices);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return std::pair(samples.distance[a], a) < std::pair(samples.distance[b], b);
  });
  for (Index i = 0; i < vertices; ++i) rank[order[i]] = i;

  // Cycles that are born with a side and filled with a triangle. Seen backwards in time, what is
  // outside the sublevel set grows; a side that joins two of its components, as it were from a
  // triangle to the next, bears the cycle between them, which fills when the component that appears
  // later in this sense, backwards, has gone. A hole in the surface is a component that never goes.
  constexpr double kForever = std::numeric_limits<double>::infinity();
  std::vector<double> filled(triangles);
  struct Side {
    std::uint64_t key;  // ranks of its ends, the later one first
    Index triangle;
  };
  std::vector<Side> sides;
  sides.reserve(3 * static_cast<std::size_t>(triangles));
  for (Index t = 0; t < triangles; ++t) {
    const auto& v = samples.triangles[t].vertices;
    filled[t] = std::max({samples.distance[v[0]], samples.distance[v[1]], samples.distance[v[2]]});
    for (int k = 0; k < 3; ++k) sides.push_back({keyOf(rank[v[k]], rank[v[(k + 1) % 3]]), t});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.key > b.key; });

  // Holes get numbers after those of the triangles: sides with one triangle, by common vertices.
  Sets holes(vertices);
  std::vector<bool> single(sides.size(), false);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    single[i] = (i == 0 || sides[i - 1].key != sides[i].key) &&
                (i + 1 == sides.size() || sides[i + 1].key != sides[i].key);
    if (!single[i]) continue;
    const Index a = holes.find(static_cast<Index>(sides[i].key >> 32));
    const Index b = holes.find(static_cast<Index>(sides[i].key));
    if (a != b) holes.join(a, b);
  }
  filled.resize(triangles + vertices, kForever);

  Sets outside(triangles + vertices), inside(vertices);
  std::vector<bool> bears(sides.size(), false);
  const auto consider = [&](double born, double gone) {
    if (gone > born) result.cycles.push_back({born, gone});
  };
  const auto bornWith = [&](const Side& side) { return samples.distance[order[side.key >> 32]]; };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    Index other = 0;
    if (single[i]) {
      other = triangles + holes.find(static_cast<Index>(sides[i].key));
    } else {
      other = sides[++i].triangle;
    }
    Index a = outside.find(sides[i - (single[i] ? 0 : 1)].triangle), b = outside.find(other);
    if (a == b) continue;
    if (filled[a] > filled[b]) std::swap(a, b);
    outside.join(a, b);
    bears[i] = true;
    consider(bornWith(sides[i]), filled[a]);
  }
  // Sides that join no components, neither outside nor inside: the cycles of handles.
  for (std::size_t i = sides.size(); i-- > 0;) {
    if (i + 1 < sides.size() && sides[i].key == sides[i + 1].key) continue;
    const Index a = inside.find(static_cast<Index>(sides[i].key >> 32));
    const Index b = inside.find(static_cast<Index>(sides[i].key));
    if (a != b) {
      inside.join(a, b);
    } else if (!bears[i]) {
      consider(bornWith(sides[i]), kForever);
    }
  }
  return result;
}

FirstSaddle firstSaddle(const SurfaceMesh& mesh, const TextbookMmp& field, double limit,
                        double spacing) {
  const SampledCycles samples = sampledCycles(mesh, field, limit, spacing);
  FirstSaddle result{{}, samples.error, samples.farthest, samples.triangles};
  for (const Cycle& cycle : samples.cycles) {
    const double lasts = std::min(cycle.filled, limit) - cycle.born;
    if (lasts > 2 * result.error && !(result.value && *result.value <= cycle.born)) {
      result.value = cycle.born;
    }
  }
  return result;
}

}  // namespace girth::test
