#include "gltf/scene/transform.h"

#include <algorithm>
#include <cmath>

namespace girth::io {

Transform Transform::ofParts(const std::array<double, 3>& translation,
                             const std::array<double, 4>& rotation,
                             const std::array<double, 3>& scale) {
  const double length = std::sqrt(rotation[0] * rotation[0] + rotation[1] * rotation[1] +
                                  rotation[2] * rotation[2] + rotation[3] * rotation[3]);
  const double one = length > 0 ? 1 / length : 0;
  const double x = rotation[0] * one, y = rotation[1] * one, z = rotation[2] * one;
  const double w = rotation[3] * one;
  Transform transform;
  auto& m = transform.m;
  m = {1 - 2 * (y * y + z * z), 2 * (x * y - z * w),     2 * (x * z + y * w),     0,
       2 * (x * y + z * w),     1 - 2 * (x * x + z * z), 2 * (y * z - x * w),     0,
       2 * (x * z - y * w),     2 * (y * z + x * w),     1 - 2 * (x * x + y * y), 0};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) m[4 * r + c] *= scale[c];
    m[4 * r + 3] = translation[r];
  }
  return transform;
}

Transform Transform::ofNode(const tinygltf::Node& node) {
  if (!node.matrix.empty()) return ofMatrix(std::span<const double, 16>(node.matrix));
  std::array<double, 3> translation{0, 0, 0}, scale{1, 1, 1};
  std::array<double, 4> rotation{0, 0, 0, 1};
  std::copy(node.translation.begin(), node.translation.end(), translation.begin());
  std::copy(node.rotation.begin(), node.rotation.end(), rotation.begin());
  std::copy(node.scale.begin(), node.scale.end(), scale.begin());
  return ofParts(translation, rotation, scale);
}

}  // namespace girth::io
