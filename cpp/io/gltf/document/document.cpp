#include "gltf/document/document.h"

#include <algorithm>
#include <array>

namespace girth::io {
namespace {

using tinygltf::Value;

std::uint64_t countIn(const Value& object, const char* name) {
  return static_cast<std::uint64_t>(object.Get(name).GetNumberAsDouble());
}

GltfReference referenceIn(const std::map<std::string, int>& attributes, const std::string& name) {
  const auto found = attributes.find(name);
  return found == attributes.end() ? GltfReference() : referenceOf(found->second);
}

GltfReference referenceIn(const Value& attributes, const std::string& name) {
  return attributes.Has(name) ? referenceOf(attributes.Get(name).GetNumberAsInt())
                              : GltfReference();
}

/// PREFIX_0, PREFIX_1, ...
template <class Attributes>
std::vector<GltfReference> setsIn(const Attributes& attributes, const std::string& prefix) {
  constexpr std::size_t kMostSets = 16;
  std::vector<GltfReference> found;
  for (std::size_t set = 0; set < kMostSets; ++set) {
    const GltfReference reference = referenceIn(attributes, prefix + std::to_string(set));
    if (!reference) continue;
    found.resize(set + 1);
    found[set] = reference;
  }
  return found;
}

/// Which of the words it is: their order is that of the enumerators.
template <class Choice, std::size_t kCount>
Choice choiceOf(const std::string& word, const std::array<std::string_view, kCount>& words) {
  const auto at = std::find(words.begin(), words.end(), word) - words.begin();
  return static_cast<Choice>(at < static_cast<std::ptrdiff_t>(kCount) ? at : 0);
}

}  // namespace

std::string_view shapeText(int shape) {
  switch (shape) {
    case TINYGLTF_TYPE_SCALAR:
      return "SCALAR";
    case TINYGLTF_TYPE_VEC2:
      return "VEC2";
    case TINYGLTF_TYPE_VEC3:
      return "VEC3";
    case TINYGLTF_TYPE_VEC4:
      return "VEC4";
    case TINYGLTF_TYPE_MAT2:
      return "MAT2";
    case TINYGLTF_TYPE_MAT3:
      return "MAT3";
    default:
      return "MAT4";
  }
}

std::optional<GltfMeshopt> meshoptOf(const tinygltf::BufferView& view) {
  for (const char* name : {"KHR_meshopt_compression", "EXT_meshopt_compression"}) {
    const auto found = view.extensions.find(name);
    if (found == view.extensions.end()) continue;
    const Value& extension = found->second;
    GltfMeshopt packed;
    packed.extension = name;
    packed.buffer = static_cast<std::uint32_t>(countIn(extension, "buffer"));
    packed.byteOffset = countIn(extension, "byteOffset");
    packed.byteLength = countIn(extension, "byteLength");
    packed.byteStride = countIn(extension, "byteStride");
    packed.count = countIn(extension, "count");
    packed.mode = choiceOf<GltfMeshopt::Mode, 3>(extension.Get("mode").Get<std::string>(),
                                                 {"ATTRIBUTES", "TRIANGLES", "INDICES"});
    packed.filter = choiceOf<GltfMeshopt::Filter, 5>(
        extension.Get("filter").Get<std::string>(),
        {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "COLOR"});
    return packed;
  }
  return std::nullopt;
}

GltfPrimitive::GltfPrimitive(const tinygltf::Primitive& primitive)
    : mode(primitive.mode),
      position(referenceIn(primitive.attributes, "POSITION")),
      indices(referenceOf(primitive.indices)),
      joints(setsIn(primitive.attributes, "JOINTS_")),
      weights(setsIn(primitive.attributes, "WEIGHTS_")) {
  const std::size_t sets = std::max(joints.size(), weights.size());
  joints.resize(sets);
  weights.resize(sets);
  for (const auto& target : primitive.targets) targets.push_back(referenceIn(target, "POSITION"));
  material = referenceOf(primitive.material);
  for (const auto& [name, accessor] : primitive.attributes) {
    if (isExtraAttribute(name)) extras.emplace(name, unsignedOf(accessor));
  }
  const auto found = primitive.extensions.find("KHR_draco_mesh_compression");
  if (found == primitive.extensions.end()) return;
  const Value& attributes = found->second.Get("attributes");
  draco.emplace();
  draco->bufferView = static_cast<std::uint32_t>(countIn(found->second, "bufferView"));
  if (attributes.IsObject()) {
    draco->position = referenceIn(attributes, "POSITION");
    draco->joints = setsIn(attributes, "JOINTS_");
    draco->weights = setsIn(attributes, "WEIGHTS_");
    for (const std::string& name : attributes.Keys()) {
      if (isExtraAttribute(name)) draco->extras.emplace(name, *referenceIn(attributes, name));
    }
  }
  draco->joints.resize(sets);
  draco->weights.resize(sets);
}

std::optional<GltfInstancing> instancingOf(const tinygltf::Node& node) {
  const auto found = node.extensions.find("EXT_mesh_gpu_instancing");
  if (found == node.extensions.end()) return std::nullopt;
  const Value& attributes = found->second.Get("attributes");
  if (!attributes.IsObject()) return std::nullopt;
  return GltfInstancing{referenceIn(attributes, "TRANSLATION"), referenceIn(attributes, "ROTATION"),
                        referenceIn(attributes, "SCALE")};
}

bool isHidden(const tinygltf::Node& node) {
  const auto found = node.extensions.find("KHR_node_visibility");
  if (found == node.extensions.end()) return false;
  const Value& visible = found->second.Get("visible");
  return visible.IsBool() && !visible.Get<bool>();
}

}  // namespace girth::io
