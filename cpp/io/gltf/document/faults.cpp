// A look through a whole document for what leads nowhere.
#include <algorithm>

#include "gltf/document/document.h"
#include "gltf/document/fault.h"
#include "gltf/unpack/accessor.h"

namespace girth::io {
namespace {

class FaultFinder {
 public:
  explicit FaultFinder(const GltfDocument& document)
      : document_(document), model_(document.model) {}

  std::optional<Error> run() {
    for (std::size_t i = 0; i < document_.sources.size(); ++i) {
      if (document_.sources[i].byteLength == 0) {
        report(placeOf("buffers", i) + "/byteLength", "is 0");
      }
    }
    for (std::size_t i = 0; i < model_.bufferViews.size() && !fault_; ++i) checkView(i);
    for (std::size_t i = 0; i < model_.accessors.size() && !fault_; ++i) checkAccessor(i);
    for (std::size_t i = 0; i < model_.meshes.size() && !fault_; ++i) checkMesh(i);
    for (std::size_t i = 0; i < model_.skins.size() && !fault_; ++i) checkSkin(i);
    for (std::size_t i = 0; i < model_.nodes.size() && !fault_; ++i) checkNode(i);
    for (std::size_t i = 0; i < model_.scenes.size() && !fault_; ++i) {
      checkAll(model_.scenes[i].nodes, model_.nodes.size(), "node",
               placeOf("scenes", i) + "/nodes");
    }
    check(referenceOf(model_.defaultScene), model_.scenes.size(), "scene", "/scene");
    checkParents();
    return fault_;
  }

 private:
  static std::string placeOf(const char* list, std::size_t number) {
    return "/" + std::string(list) + "/" + std::to_string(number);
  }

  void report(const std::string& place, const std::string& what) {
    if (!fault_) fault_ = faultAt(place, what);
  }

  bool check(const GltfReference& reference, std::size_t size, const char* what,
             const std::string& place) {
    if (!reference || *reference < size) return reference.has_value();
    report(place, "there is no " + std::string(what) + " " + std::to_string(*reference));
    return false;
  }

  void checkAll(const std::vector<int>& references, std::size_t size, const char* what,
                const std::string& place) {
    for (std::size_t i = 0; i < references.size(); ++i) {
      check(referenceOf(references[i]), size, what, place + "/" + std::to_string(i));
    }
  }

  void checkView(std::size_t number) {
    const tinygltf::BufferView& view = model_.bufferViews[number];
    const std::string place = placeOf("bufferViews", number);
    if (!check(referenceOf(view.buffer), document_.sources.size(), "buffer", place + "/buffer"))
      return;
    const std::uint64_t size = document_.sources[unsignedOf(view.buffer)].byteLength;
    if (view.byteOffset > size || view.byteLength > size - view.byteOffset) {
      report(place, "reaches beyond the end of buffer " + std::to_string(view.buffer));
    }
    if (view.byteLength == 0) report(place + "/byteLength", "is 0");
    const std::uint64_t stride = view.byteStride;
    if (stride != 0 && (stride < 4 || stride > 252 || stride % 4 != 0)) {
      report(place + "/byteStride",
             "is " + std::to_string(stride) + ", but has to be a multiple of 4 from 4 to 252");
    }
  }

  void checkElements(std::uint32_t viewNumber, std::uint64_t offset, std::uint64_t count,
                     std::size_t componentBytes, std::size_t elementBytes,
                     const std::string& viewPlace, const std::string& place) {
    if (!check(viewNumber, model_.bufferViews.size(), "buffer view", viewPlace)) return;
    const tinygltf::BufferView& view = model_.bufferViews[viewNumber];
    const std::uint64_t stride = view.byteStride == 0 ? elementBytes : view.byteStride;
    if (stride < elementBytes) {
      report(place, "has elements of " + std::to_string(elementBytes) + " bytes only " +
                        std::to_string(stride) + " bytes apart");
    } else if (offset > view.byteLength || elementBytes > view.byteLength - offset ||
               (count - 1) > (view.byteLength - offset - elementBytes) / stride) {
      report(place, "reaches beyond the end of buffer view " + std::to_string(viewNumber));
    } else if ((view.byteOffset + offset) % componentBytes != 0) {
      report(place, "begins at a byte that is not a multiple of " + std::to_string(componentBytes));
    }
  }

  void checkAccessor(std::size_t number) {
    const tinygltf::Accessor& accessor = model_.accessors[number];
    const std::string place = placeOf("accessors", number);
    const std::size_t componentBytes = bytesOf(accessor.componentType);
    const std::size_t elementBytes = componentBytes * componentsOf(accessor.type);
    if (accessor.count == 0) return report(place + "/count", "is 0");
    if (accessor.normalized && componentBytes > 2) {
      report(place + "/normalized", "is only for integers of one or two bytes");
    }
    if (const GltfReference view = referenceOf(accessor.bufferView)) {
      checkElements(*view, accessor.byteOffset, accessor.count, componentBytes, elementBytes,
                    place + "/bufferView", place);
    } else if (accessor.byteOffset != 0) {
      report(place + "/byteOffset", "is given, but no buffer view");
    }
    const auto& sparse = accessor.sparse;
    if (!sparse.isSparse) return;
    const std::string sparsePlace = place + "/sparse";
    const std::uint64_t count = unsignedOf(sparse.count);
    if (count == 0 || count > accessor.count) {
      return report(sparsePlace + "/count", "is " + std::to_string(count) + " of " +
                                                std::to_string(accessor.count) + " elements");
    }
    const std::size_t indexBytes = bytesOf(sparse.indices.componentType);
    checkElements(unsignedOf(sparse.indices.bufferView), unsignedOf(sparse.indices.byteOffset),
                  count, indexBytes, indexBytes, sparsePlace + "/indices/bufferView",
                  sparsePlace + "/indices");
    checkElements(unsignedOf(sparse.values.bufferView), unsignedOf(sparse.values.byteOffset), count,
                  componentBytes, elementBytes, sparsePlace + "/values/bufferView",
                  sparsePlace + "/values");
  }

  void checkMesh(std::size_t number) {
    const std::vector<GltfPrimitive>& primitives = document_.primitives[number];
    const std::string meshPlace = placeOf("meshes", number) + "/primitives";
    if (primitives.empty()) report(meshPlace, "is empty");
    const std::size_t size = model_.accessors.size();
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const GltfPrimitive& primitive = primitives[p];
      const std::string place = meshPlace + "/" + std::to_string(p);
      const std::string attributes = place + "/attributes/";
      check(primitive.indices, size, "accessor", place + "/indices");
      checkCount(primitive.position, primitive.position, attributes + "POSITION");
      for (std::size_t s = 0; s < primitive.joints.size(); ++s) {
        const std::string set = "_" + std::to_string(s);
        checkCount(primitive.joints[s], primitive.position, attributes + "JOINTS" + set);
        checkCount(primitive.weights[s], primitive.position, attributes + "WEIGHTS" + set);
        if (primitive.joints[s].has_value() != primitive.weights[s].has_value()) {
          report(place + "/attributes", "has joints without weights, or weights without joints");
        }
      }
      for (std::size_t t = 0; t < primitive.targets.size(); ++t) {
        checkCount(primitive.targets[t], primitive.position,
                   place + "/targets/" + std::to_string(t) + "/POSITION");
      }
    }
  }

  /// An accessor of as many elements as there are positions.
  void checkCount(const GltfReference& reference, const GltfReference& position,
                  const std::string& place) {
    const auto& accessors = model_.accessors;
    if (!check(reference, accessors.size(), "accessor", place)) return;
    if (!position || *position >= accessors.size()) return;
    const std::uint64_t count = accessors[*reference].count;
    if (count == accessors[*position].count) return;
    report(place, "has " + std::to_string(count) + " values for " +
                      std::to_string(accessors[*position].count) + " points");
  }

  void checkSkin(std::size_t number) {
    const tinygltf::Skin& skin = model_.skins[number];
    const std::string place = placeOf("skins", number);
    if (skin.joints.empty()) report(place, "has no joints");
    checkAll(skin.joints, model_.nodes.size(), "node", place + "/joints");
    const std::string matrices = place + "/inverseBindMatrices";
    if (!check(referenceOf(skin.inverseBindMatrices), model_.accessors.size(), "accessor",
               matrices))
      return;
    const tinygltf::Accessor& accessor = model_.accessors[unsignedOf(skin.inverseBindMatrices)];
    if (accessor.type != TINYGLTF_TYPE_MAT4 ||
        accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT) {
      report(matrices, "is not an accessor of MAT4 in floats");
    } else if (accessor.count < skin.joints.size()) {
      report(matrices, "has " + std::to_string(accessor.count) + " matrices for " +
                           std::to_string(skin.joints.size()) + " joints");
    }
  }

  void checkNode(std::size_t number) {
    const tinygltf::Node& node = model_.nodes[number];
    const std::string place = placeOf("nodes", number);
    checkAll(node.children, model_.nodes.size(), "node", place + "/children");
    check(referenceOf(node.mesh), model_.meshes.size(), "mesh", place + "/mesh");
    check(referenceOf(node.skin), model_.skins.size(), "skin", place + "/skin");
  }

  void checkParents() {
    std::vector<bool> isChild(model_.nodes.size(), false);
    for (std::size_t i = 0; i < model_.nodes.size() && !fault_; ++i) {
      for (const int number : model_.nodes[i].children) {
        const std::uint32_t child = unsignedOf(number);
        if (isChild[child]) {
          report(placeOf("nodes", i) + "/children",
                 "node " + std::to_string(child) + " has another parent already");
        }
        isChild[child] = true;
      }
    }
  }

  const GltfDocument& document_;
  const tinygltf::Model& model_;
  std::optional<Error> fault_;
};

}  // namespace

std::optional<Error> firstFaultOf(const GltfDocument& document) {
  return FaultFinder(document).run();
}

}  // namespace girth::io
