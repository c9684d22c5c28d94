// Small vectors in space.
#pragma once

#include <algorithm>
#include <cmath>

#include "girth/surface_mesh.h"

namespace girth {

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Vec3& a) { return std::sqrt(dot(a, a)); }
inline double squareOf(const Vec3& a) { return dot(a, a); }

/// The square of the distance of a point from a segment.
inline double squareFromSegment(const Vec3& point, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double square = squareOf(along);
  const double share = square > 0 ? std::clamp(dot(point - from, along) / square, 0.0, 1.0) : 0;
  return squareOf(point - (from + share * along));
}

}  // namespace girth
