// The affine maps of glTF's nodes, instances and joints.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "girth/surface_mesh.h"
#include "gltf/document/tinygltf.h"

namespace girth::io {

/// The upper three rows of a 4 × 4 matrix, row by row. Starts as the identity.
struct Transform {
  std::array<double, 12> m{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  Vec3 apply(const Vec3& p) const {
    return {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3],
            m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
            m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
  }
  /// First `inner`, then this.
  Transform after(const Transform& inner) const {
    Transform result;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 4; ++c) {
        double sum = c == 3 ? m[4 * r + 3] : 0.0;
        for (std::size_t k = 0; k < 3; ++k) sum += m[4 * r + k] * inner.m[4 * k + c];
        result.m[4 * r + c] = sum;
      }
    }
    return result;
  }
  /// Whether it turns left hands into right ones.
  bool mirrors() const {
    return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[1] * (m[4] * m[10] - m[6] * m[8]) +
               m[2] * (m[4] * m[9] - m[5] * m[8]) <
           0;
  }

  /// The transform of 16 numbers, column by column.
  static Transform ofMatrix(std::span<const double, 16> columns) {
    Transform transform;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 4; ++c) transform.m[4 * r + c] = columns[4 * c + r];
    }
    return transform;
  }
  /// First the scale, then the rotation (a quaternion x, y, z, w, made one of unit length), then
  /// the translation.
  static Transform ofParts(const std::array<double, 3>& translation,
                           const std::array<double, 4>& rotation,
                           const std::array<double, 3>& scale);

  /// A node's own: its matrix, or its parts.
  static Transform ofNode(const tinygltf::Node& node);
};

}  // namespace girth::io
