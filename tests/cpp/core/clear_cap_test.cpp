// Caps that cross nothing: against all triangulations of small polygons.
#include "loops/cut/clear_cap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/vector.h"
#include "shapes.h"

namespace girth {
namespace {

using Faces = std::vector<std::array<Vertex, 3>>;

double areaOf(const Faces& faces, const std::vector<Vec3>& places) {
  double area = 0;
  for (const auto& [a, b, c] : faces) {
    area += norm(cross(places[b] - places[a], places[c] - places[a])) / 2;
  }
  return area;
}

PlacedFace placed(const std::array<Vertex, 3>& face, const std::vector<Vec3>& places) {
  return {face, {places[face[0]], places[face[1]], places[face[2]]}};
}

/// Calls `visit` with each triangulation of the corners from..to of a polygon, behind `faces`.
template <class Visit>
void forEachTriangulation(const std::vector<Vertex>& polygon,
                          std::vector<std::pair<std::size_t, std::size_t>> todo, Faces& faces,
                          const Visit& visit) {
  while (!todo.empty() && todo.back().second - todo.back().first < 2) todo.pop_back();
  if (todo.empty()) return visit(faces);
  const auto [i, j] = todo.back();
  todo.pop_back();
  for (std::size_t k = i + 1; k < j; ++k) {
    faces.push_back({polygon[i], polygon[k], polygon[j]});
    auto more = todo;
    more.emplace_back(i, k);
    more.emplace_back(k, j);
    forEachTriangulation(polygon, more, faces, visit);
    faces.pop_back();
  }
}

TEST(ClearCap, isTheLeastOfAllTriangulationsThatCrossNothing) {
  int changed = 0, none = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    test::Random random(seed);
    // A bent polygon round the origin, and triangles that stand in it.
    constexpr std::size_t kCorners = 7;
    std::vector<Vec3> places;
    std::vector<Vertex> polygon;
    for (std::size_t i = 0; i < kCorners; ++i) {
      const double angle = 2 * M_PI * static_cast<double>(i) / kCorners;
      places.push_back({std::cos(angle), std::sin(angle), 0.8 * random()});
      polygon.push_back(Vertex(static_cast<Index>(i)));
    }
    std::vector<PlacedFace> others;
    for (int i = 0; i < 3; ++i) {
      const Vec3 middle{1.4 * random() - 0.7, 1.4 * random() - 0.7, 0.8 * random()};
      const auto first = static_cast<Index>(places.size());
      for (int k = 0; k < 3; ++k) {
        places.push_back(middle + Vec3{0.2 * random(), 0.2 * random(), 0.3 * random()});
      }
      others.push_back(placed({Vertex(first), Vertex(first + 1), Vertex(first + 2)}, places));
    }
    double least = std::numeric_limits<double>::infinity(), leastOfAll = least;
    Faces faces;
    forEachTriangulation(polygon, {{0, kCorners - 1}}, faces, [&](const Faces& triangulation) {
      const double area = areaOf(triangulation, places);
      leastOfAll = std::min(leastOfAll, area);
      for (const auto& face : triangulation) {
        for (const PlacedFace& other : others) {
          if (facesMeet(placed(face, places), other)) return;
        }
      }
      least = std::min(least, area);
    });
    const auto found = loops::clearCap(polygon, places, others);
    ASSERT_EQ(found.has_value(), least < std::numeric_limits<double>::infinity());
    if (!found) {
      ++none;
      continue;
    }
    EXPECT_EQ(found->size(), kCorners - 2);
    EXPECT_NEAR(areaOf(*found, places), least, 1e-12);
    if (least > leastOfAll) ++changed;
    // It fills the polygon, in its direction.
    std::vector<Vertex> again = loops::polygonOf(*found);
    const auto start = std::find(again.begin(), again.end(), polygon[0]);
    std::rotate(again.begin(), start, again.end());
    EXPECT_EQ(again, polygon);
  }
  EXPECT_GT(changed, 5);
  EXPECT_GT(none, 0);
}

TEST(ClearCap, doesNotJoinWhatIsJoined) {
  // The shorter diagonal of a square is an edge of another face, beside it.
  const std::vector<Vec3> places{
      {0, 0, 0}, {1, 0, 0.1}, {1.2, 1.2, 0}, {0, 1, 0.1}, {0.5, 0.5, -2}};
  const std::vector<Vertex> square{Vertex(0), Vertex(1), Vertex(2), Vertex(3)};
  const auto plain = loops::clearCap(square, places, {});
  ASSERT_TRUE(plain);
  const PlacedFace beside = placed({Vertex(1), Vertex(3), Vertex(4)}, places);
  const auto found = loops::clearCap(square, places, std::span(&beside, 1));
  const auto joins = [](const Faces& faces, Index a, Index b) {
    return std::all_of(faces.begin(), faces.end(), [&](const auto& face) {
      return std::count(face.begin(), face.end(), Vertex(a)) +
                 std::count(face.begin(), face.end(), Vertex(b)) ==
             2;
    });
  };
  EXPECT_TRUE(joins(*plain, 1, 3));
  if (found) {
    EXPECT_TRUE(joins(*found, 0, 2));
  }
}

TEST(ClearCap, polygonsOfOtherCapsAreNone) {
  using loops::polygonOf;
  const auto v = [](Index number) { return Vertex(number); };
  EXPECT_TRUE(polygonOf({}).empty());
  const Faces one{{v(0), v(1), v(2)}};
  EXPECT_EQ(polygonOf(one), (std::vector<Vertex>{v(0), v(1), v(2)}));
  // A fan round a vertex of its own; two triangles apart; two that touch.
  const Faces fan{{v(0), v(1), v(3)}, {v(1), v(2), v(3)}, {v(2), v(0), v(3)}};
  EXPECT_TRUE(polygonOf(fan).empty());
  const Faces apart{{v(0), v(1), v(2)}, {v(3), v(4), v(5)}};
  EXPECT_TRUE(polygonOf(apart).empty());
  const Faces touching{{v(0), v(1), v(2)}, {v(0), v(3), v(4)}};
  EXPECT_TRUE(polygonOf(touching).empty());
}

}  // namespace
}  // namespace girth
