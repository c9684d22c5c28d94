#include "tubes.h"

#include <cmath>

#include "mesh/vector.h"

namespace girth::test {

Shape tube(const std::function<Vec3(double)>& curve, double radius, Index around, Index across) {
  std::vector<Vec3> centres, tangents, normals;
  for (Index i = 0; i < around; ++i) {
    const double t = static_cast<double>(i) / around, step = 0.5 / around;
    centres.push_back(curve(t));
    const Vec3 along = curve(t + step) - curve(t - step);
    tangents.push_back((1 / norm(along)) * along);
  }
  // A normal carried along, and what it is turned by at the end, shared out.
  const auto carried = [&](const Vec3& normal, Index to) {
    const Vec3 flat = normal - dot(normal, tangents[to]) * tangents[to];
    return (1 / norm(flat)) * flat;
  };
  const Vec3 any = std::fabs(tangents[0].x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  normals.push_back(carried(any, 0));
  for (Index i = 1; i < around; ++i) normals.push_back(carried(normals.back(), i));
  const Vec3 end = carried(normals.back(), 0);
  const double turn = std::atan2(dot(tangents[0], cross(end, normals[0])), dot(end, normals[0]));
  Shape shape;
  for (Index i = 0; i < around; ++i) {
    const Vec3 side = cross(tangents[i], normals[i]);
    for (Index j = 0; j < across; ++j) {
      const double angle = 2 * M_PI * j / across + turn * i / around;
      const Vec3 p =
          centres[i] + (radius * std::cos(angle)) * normals[i] + (radius * std::sin(angle)) * side;
      shape.add(p.x, p.y, p.z);
    }
  }
  for (Index i = 0; i < around; ++i) {
    for (Index j = 0; j < across; ++j) {
      const Index a = i * across + j, b = i * across + (j + 1) % across;
      const Index c = (i + 1) % around * across + j,
                  d = (i + 1) % around * across + (j + 1) % across;
      shape.face(a, d, b);
      shape.face(a, c, d);
    }
  }
  return shape;
}

Shape wavyRing(Index narrow, Index sides) {
  constexpr Index kAround = 200, kWave = 8;
  Shape shape;
  for (Index i = 0; i < kAround; ++i) {
    const double t = 2 * M_PI * i / kAround;
    const double r = i == narrow ? 0.8 : 0.95 + 0.05 * std::cos(2 * M_PI * i / kWave);
    for (Index j = 0; j < sides; ++j) {
      const double u = 2 * M_PI * j / sides, out = 10 + r * std::cos(u);
      shape.add(out * std::cos(t), out * std::sin(t), r * std::sin(u));
    }
  }
  for (Index i = 0; i < kAround; ++i) {
    for (Index j = 0; j < sides; ++j) {
      const Index here = i * sides, next = (i + 1) % kAround * sides, k = (j + 1) % sides;
      shape.face(here + j, next + j, next + k);
      shape.face(here + j, next + k, here + k);
    }
  }
  return shape;
}

Vec3 trefoil(double t) {
  const double u = 2 * M_PI * t, rho = 2 + std::cos(3 * u);
  return {rho * std::cos(2 * u), rho * std::sin(2 * u), std::sin(3 * u)};
}

}  // namespace girth::test
