// Skins: where a skinned mesh's points stand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "girth/error.h"
#include "gltf/document/document.h"
#include "gltf/scene/transform.h"
#include "gltf/unpack/accessor.h"

namespace girth::io {

/// A skin as the file's nodes hold it. glTF ignores the transform of the node that wears a skin:
/// the joints alone determine where its points stand.
struct SkinPose {
  /// For each joint, the map from the mesh's own space to the world.
  std::vector<Transform> joints;
  /// Whether all joints move the mesh alike, as they do in the pose in which it was bound to them.
  bool isBindPose{true};
};

/// The world transform of every node.
class WorldTransforms {
 public:
  explicit WorldTransforms(const tinygltf::Model& model);

  /// Nothing for a node in a cycle.
  const Transform* of(std::uint32_t node) const;

 private:
  std::vector<Transform> transforms_;
  std::vector<bool> known_;
};

/// Errors: MALFORMED_FILE, and those of GltfAccessors.
Result<SkinPose> poseOf(const tinygltf::Model& model, GltfAccessors& accessors,
                        const WorldTransforms& world, std::uint32_t skin);

/// Joints and weights of points: four of each per point and set.
struct Influences {
  std::vector<double> joints;
  std::vector<double> weights;
};

/// Moves `count` points, x, y, z each, from the mesh's own space into the world. A point's weights
/// are made to add up to one; where there are none, its first joint moves it. `place` names the
/// primitive in messages. Gives how many points are moved by maps that mirror.
/// Error: MALFORMED_FILE where a weight is no number or a joint does not exist.
Result<std::size_t> applyPose(const SkinPose& pose, const std::vector<Influences>& sets,
                              double* points, std::size_t count, const std::string& place);

}  // namespace girth::io
