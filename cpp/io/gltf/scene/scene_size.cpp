#include "gltf/scene/scene_size.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace girth::io {
namespace {

constexpr std::uint64_t kLargest = std::numeric_limits<std::uint64_t>::max();

std::uint64_t sum(std::uint64_t a, std::uint64_t b) { return a > kLargest - b ? kLargest : a + b; }

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  return a != 0 && b > kLargest / a ? kLargest : a * b;
}

SceneSize sum(const SceneSize& a, const SceneSize& b) {
  return {sum(a.triangles, b.triangles), sum(a.elements, b.elements)};
}

class Counting {
 public:
  explicit Counting(const GltfDocument& document)
      : model_(document.model), sizes_(model_.nodes.size()), states_(model_.nodes.size()) {
    for (const auto& primitives : document.primitives) {
      SceneSize size;
      for (const GltfPrimitive& primitive : primitives) size = sum(size, sizeOf(primitive));
      meshes_.push_back(size);
    }
    isPlaced_.resize(meshes_.size(), false);
  }

  /// Depth first, without recursion: children before the nodes above them.
  SceneSizes run(const std::vector<int>& roots) {
    std::vector<std::uint32_t> pending;
    const auto enter = [&](const std::vector<int>& nodes) {
      for (const int node : nodes) {
        if (unsignedOf(node) < states_.size()) pending.push_back(unsignedOf(node));
      }
    };
    enter(roots);
    while (!pending.empty()) {
      const std::uint32_t node = pending.back();
      if (states_[node] == State::New) {
        states_[node] = State::Open;
        if (!isHidden(model_.nodes[node])) enter(model_.nodes[node].children);
        continue;
      }
      pending.pop_back();
      if (states_[node] == State::Open) finish(node);
    }
    SceneSizes all;
    all.placed = sumOf(roots);
    for (std::size_t m = 0; m < meshes_.size(); ++m) {
      if (isPlaced_[m]) all.once = sum(all.once, meshes_[m]);
    }
    return all;
  }

 private:
  enum class State : std::uint8_t { New, Open, Done };

  std::uint64_t countOf(const GltfReference& accessor) const {
    return accessor && *accessor < model_.accessors.size() ? model_.accessors[*accessor].count : 0;
  }

  SceneSize sizeOf(const GltfPrimitive& primitive) const {
    if (primitive.mode < TINYGLTF_MODE_TRIANGLES) return {};
    const std::uint64_t points = countOf(primitive.position);
    const std::uint64_t corners = primitive.indices ? countOf(primitive.indices) : points;
    const bool isList = primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.draco;
    const std::uint64_t lists = 1 + primitive.targets.size() + 2 * primitive.joints.size();
    return {isList ? corners / 3 : corners - std::min<std::uint64_t>(corners, 2),
            sum(product(lists, points), corners)};
  }

  std::uint64_t instancesOf(const tinygltf::Node& node) const {
    const auto instancing = instancingOf(node);
    if (!instancing) return 1;
    for (const GltfReference& list :
         {instancing->translation, instancing->rotation, instancing->scale}) {
      if (list) return countOf(list);
    }
    return 1;
  }

  SceneSize sumOf(const std::vector<int>& nodes) const {
    SceneSize all;
    for (const int node : nodes) {
      if (unsignedOf(node) < sizes_.size()) all = sum(all, sizes_[unsignedOf(node)]);
    }
    return all;
  }

  /// Adds up a node when all below it is known, but where the nodes form a cycle, which is reported
  /// elsewhere.
  void finish(std::uint32_t number) {
    const tinygltf::Node& node = model_.nodes[number];
    states_[number] = State::Done;
    SceneSize& size = sizes_[number];
    size = {0, 1 + node.children.size()};
    if (isHidden(node)) return;
    size = sum(size, sumOf(node.children));
    const GltfReference mesh = referenceOf(node.mesh);
    if (!mesh || *mesh >= meshes_.size()) return;
    isPlaced_[*mesh] = true;
    const std::uint64_t instances = instancesOf(node);
    size = sum(size, {product(instances, meshes_[*mesh].triangles),
                      product(instances, meshes_[*mesh].elements)});
  }

  const tinygltf::Model& model_;
  std::vector<SceneSize> meshes_;
  std::vector<SceneSize> sizes_;
  std::vector<State> states_;
  std::vector<bool> isPlaced_;
};

}  // namespace

SceneSizes sceneSizes(const GltfDocument& document, const std::vector<int>& roots) {
  return Counting(document).run(roots);
}

}  // namespace girth::io
