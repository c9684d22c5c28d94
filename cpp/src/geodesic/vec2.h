// Vectors of the plane, for faces laid flat.
#pragma once

#include <cmath>

namespace girth::geodesic {

struct Vec2 {
  double x{0}, y{0};
};

inline Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
inline double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// Positive where b lies to the left of a.
inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
inline double norm(Vec2 a) { return std::sqrt(dot(a, a)); }

/// A vector turned by the angle of a unit vector, counter-clockwise; and back again.
inline Vec2 turned(Vec2 a, Vec2 by) { return {a.x * by.x - a.y * by.y, a.x * by.y + a.y * by.x}; }
inline Vec2 turnedBack(Vec2 a, Vec2 by) {
  return {a.x * by.x + a.y * by.y, a.y * by.x - a.x * by.y};
}

}  // namespace girth::geodesic
