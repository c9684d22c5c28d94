#include "isosurface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "mesh/vector.h"

namespace girth::test {

Shape isosurface(const std::function<double(const Vec3&)>& f, double size, Index cells) {
  const Index n = cells + 1;
  const auto number = [&](Index i, Index j, Index k) { return (i * n + j) * n + k; };
  std::vector<Vec3> places;
  std::vector<double> values;
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      for (Index k = 0; k < n; ++k) {
        const double step = 2 * size / cells;
        places.push_back({i * step - size, j * step - size, k * step - size});
        values.push_back(f(places.back()));
      }
    }
  }
  Shape shape;
  std::map<std::pair<Index, Index>, Index> made;
  // Never nearer to a grid point than a tenth of the edge: no slivers.
  const auto vertex = [&](Index in, Index out) {
    const auto [place, isNew] = made.try_emplace({in, out}, shape.vertexCount());
    if (isNew) {
      const double t = std::clamp(values[in] / (values[in] - values[out]), 0.1, 0.9);
      const Vec3 p = (1 - t) * places[in] + t * places[out];
      shape.add(p.x, p.y, p.z);
    }
    return place->second;
  };
  const auto face = [&](std::array<std::pair<Index, Index>, 3> edges) {
    const auto place = [&](std::size_t e) {
      return 0.5 * (places[edges[e].first] + places[edges[e].second]);
    };
    Vec3 outwards;
    for (const auto& [in, out] : edges) outwards = outwards + (places[out] - places[in]);
    if (dot(cross(place(1) - place(0), place(2) - place(0)), outwards) < 0)
      std::swap(edges[1], edges[2]);
    shape.face(vertex(edges[0].first, edges[0].second), vertex(edges[1].first, edges[1].second),
               vertex(edges[2].first, edges[2].second));
  };
  const auto tetrahedron = [&](const std::array<Index, 4>& corners) {
    std::vector<Index> in, out;
    for (const Index c : corners) (values[c] < 0 ? in : out).push_back(c);
    if (in.size() == 1) {
      face({{{in[0], out[0]}, {in[0], out[1]}, {in[0], out[2]}}});
    } else if (in.size() == 3) {
      face({{{in[0], out[0]}, {in[1], out[0]}, {in[2], out[0]}}});
    } else if (in.size() == 2) {
      face({{{in[0], out[0]}, {in[0], out[1]}, {in[1], out[0]}}});
      face({{{in[1], out[0]}, {in[0], out[1]}, {in[1], out[1]}}});
    }
  };
  for (Index i = 0; i < cells; ++i) {
    for (Index j = 0; j < cells; ++j) {
      for (Index k = 0; k < cells; ++k) {
        // From the lowest corner to the highest, along the three axes in each of their orders.
        std::array<int, 3> order{0, 1, 2};
        do {
          std::array<Index, 3> at{i, j, k};
          std::array<Index, 4> corners{number(i, j, k)};
          for (std::size_t s = 0; s < 3; ++s) {
            ++at[static_cast<std::size_t>(order[s])];
            corners[s + 1] = number(at[0], at[1], at[2]);
          }
          tetrahedron(corners);
        } while (std::next_permutation(order.begin(), order.end()));
      }
    }
  }
  return shape;
}

double torusDistance(const Vec3& p, const Vec3& centre, const Vec3& axis, double R, double r) {
  const Vec3 d = p - centre;
  const double height = dot(d, axis);
  const double rho = norm(d - height * axis);
  return std::sqrt((rho - R) * (rho - R) + height * height) - r;
}

}  // namespace girth::test
