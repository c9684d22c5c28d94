#include "mesh/remesh/quadric.h"

#include <cmath>

namespace girth::remeshing {

Quadric Quadric::ofPlane(const Vec3& point, const Vec3& normal, double weight) {
  Quadric q;
  const Vec3& n = normal;
  const double d = -dot(n, point);
  q.a_ = {weight * n.x * n.x, weight * n.x * n.y, weight * n.x * n.z,
          weight * n.y * n.y, weight * n.y * n.z, weight * n.z * n.z};
  q.b_ = weight * d * n;
  q.c_ = weight * d * d;
  return q;
}

Quadric Quadric::ofPoint(const Vec3& point, double weight) {
  Quadric q;
  q.a_ = {weight, 0, 0, weight, 0, weight};
  q.b_ = -weight * point;
  q.c_ = weight * dot(point, point);
  return q;
}

Quadric& Quadric::operator+=(const Quadric& other) {
  for (std::size_t i = 0; i < a_.size(); ++i) a_[i] += other.a_[i];
  b_ = b_ + other.b_;
  c_ += other.c_;
  return *this;
}

double Quadric::at(const Vec3& x) const {
  const Vec3 ax{a_[0] * x.x + a_[1] * x.y + a_[2] * x.z, a_[1] * x.x + a_[3] * x.y + a_[4] * x.z,
                a_[2] * x.x + a_[4] * x.y + a_[5] * x.z};
  return dot(ax, x) + 2 * dot(b_, x) + c_;
}

std::optional<Vec3> Quadric::least() const {
  // Cramer's rule: A is positive definite where points have weight.
  const Vec3 one{a_[0], a_[1], a_[2]}, two{a_[1], a_[3], a_[4]}, three{a_[2], a_[4], a_[5]};
  const double determinant = dot(one, cross(two, three));
  if (!(determinant > 0)) return std::nullopt;
  const Vec3 r = -1.0 * b_;
  const Vec3 place =
      1 / determinant * (r.x * cross(two, three) + r.y * cross(three, one) + r.z * cross(one, two));
  if (!std::isfinite(place.x + place.y + place.z)) return std::nullopt;
  return place;
}

}  // namespace girth::remeshing
