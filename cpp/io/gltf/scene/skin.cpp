#include "gltf/scene/skin.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "gltf/document/fault.h"

namespace girth::io {
namespace {

/// Whether two maps are the same, but for what is lost where matrices are stored in single
/// precision.
bool areAlike(const Transform& a, const Transform& b) {
  constexpr double kTolerance = 1e-3;
  double size = 0, difference = 0;
  for (std::size_t i = 0; i < a.m.size(); ++i) {
    size = std::max(size, std::abs(a.m[i]));
    difference = std::max(difference, std::abs(a.m[i] - b.m[i]));
  }
  return difference <= kTolerance * size;
}

}  // namespace

WorldTransforms::WorldTransforms(const tinygltf::Model& model)
    : transforms_(model.nodes.size()), known_(model.nodes.size(), false) {
  const auto& nodes = model.nodes;
  std::vector<bool> isChild(nodes.size(), false);
  for (const tinygltf::Node& node : nodes) {
    for (const int child : node.children) {
      if (unsignedOf(child) < nodes.size()) isChild[unsignedOf(child)] = true;
    }
  }
  // Without recursion: a chain of nodes may be as long as the file.
  std::vector<std::uint32_t> pending;
  for (std::uint32_t n = 0; n < nodes.size(); ++n) {
    if (isChild[n]) continue;
    known_[n] = true;
    transforms_[n] = Transform::ofNode(nodes[n]);
    pending.push_back(n);
  }
  while (!pending.empty()) {
    const std::uint32_t parent = pending.back();
    pending.pop_back();
    for (const int number : nodes[parent].children) {
      const std::uint32_t child = unsignedOf(number);
      if (child >= nodes.size() || known_[child]) continue;
      known_[child] = true;
      transforms_[child] = transforms_[parent].after(Transform::ofNode(nodes[child]));
      pending.push_back(child);
    }
  }
}

const Transform* WorldTransforms::of(std::uint32_t node) const {
  return known_[node] ? &transforms_[node] : nullptr;
}

Result<SkinPose> poseOf(const tinygltf::Model& model, GltfAccessors& accessors,
                        const WorldTransforms& world, std::uint32_t number) {
  const tinygltf::Skin& skin = model.skins[number];
  const std::string place = "/skins/" + std::to_string(number);
  const std::size_t count = skin.joints.size();
  if (count == 0) return faultAt(place, "has no joints");

  std::vector<double> matrices;
  if (const GltfReference accessor = referenceOf(skin.inverseBindMatrices)) {
    const std::string matricesPlace = place + "/inverseBindMatrices";
    auto found = accessors.appendNumbers(*accessor, TINYGLTF_TYPE_MAT4, matricesPlace, matrices);
    if (!found) return found.error();
    if (found.value() < count) {
      return faultAt(matricesPlace, "has " + std::to_string(found.value()) + " matrices for " +
                                        std::to_string(count) + " joints");
    }
  }
  SkinPose pose;
  pose.joints.reserve(count);
  for (std::size_t j = 0; j < count; ++j) {
    const std::uint32_t node = unsignedOf(skin.joints[j]);
    const std::string jointPlace = place + "/joints/" + std::to_string(j);
    if (node >= model.nodes.size()) {
      return faultAt(jointPlace, "there is no node " + std::to_string(node));
    }
    const Transform* joint = world.of(node);
    if (joint == nullptr) return faultAt(jointPlace, "is a node in a cycle of nodes");
    pose.joints.push_back(*joint);
    if (!matrices.empty()) {
      const std::span<const double, 16> inverse(matrices.data() + 16 * j, 16);
      pose.joints.back() = joint->after(Transform::ofMatrix(inverse));
    }
    pose.isBindPose = pose.isBindPose && areAlike(pose.joints.front(), pose.joints.back());
  }
  return pose;
}

Result<std::size_t> applyPose(const SkinPose& pose, const std::vector<Influences>& sets,
                              double* points, std::size_t count, const std::string& place) {
  std::size_t mirrored = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Transform blend;
    blend.m.fill(0);
    double sum = 0;
    const Transform* first = nullptr;
    for (const Influences& set : sets) {
      for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
        const double weight = set.weights[k];
        if (!std::isfinite(weight)) {
          return faultAt(place,
                         "a weight of vertex " + std::to_string(i) + " is not a finite number");
        }
        const bool exists = set.joints[k] < static_cast<double>(pose.joints.size());
        if (weight == 0 && (first != nullptr || !exists)) continue;
        if (!exists) {
          return faultAt(place, "vertex " + std::to_string(i) + " hangs on joint " +
                                    std::to_string(static_cast<std::uint64_t>(set.joints[k])) +
                                    " of " + std::to_string(pose.joints.size()));
        }
        const Transform& joint = pose.joints[static_cast<std::size_t>(set.joints[k])];
        if (first == nullptr) first = &joint;
        for (std::size_t e = 0; e < blend.m.size(); ++e) blend.m[e] += weight * joint.m[e];
        sum += weight;
      }
    }
    if (sum > 0) {
      for (double& e : blend.m) e /= sum;
    } else {
      if (first == nullptr) first = &pose.joints.front();
      blend = *first;
    }
    const Vec3 moved = blend.apply({points[3 * i], points[3 * i + 1], points[3 * i + 2]});
    points[3 * i] = moved.x;
    points[3 * i + 1] = moved.y;
    points[3 * i + 2] = moved.z;
    if (blend.mirrors()) ++mirrored;
  }
  return mirrored;
}

}  // namespace girth::io
