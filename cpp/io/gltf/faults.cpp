// A look through a whole document for what leads nowhere.
#include <algorithm>

#include "gltf/accessor.h"
#include "gltf/document.h"
#include "gltf/json_fields.h"

namespace girth::io {
namespace {

class FaultFinder {
 public:
  explicit FaultFinder(const GltfDocument& document) : document_(document) {}

  std::optional<Error> run() {
    for (std::size_t i = 0; i < document_.buffers.size(); ++i) {
      if (document_.buffers[i].byteLength == 0) {
        report(placeOf("buffers", i) + "/byteLength", "is 0");
      }
    }
    for (std::size_t i = 0; i < document_.bufferViews.size() && !fault_; ++i) checkView(i);
    for (std::size_t i = 0; i < document_.accessors.size() && !fault_; ++i) checkAccessor(i);
    for (std::size_t i = 0; i < document_.meshes.size() && !fault_; ++i) checkMesh(i);
    for (std::size_t i = 0; i < document_.skins.size() && !fault_; ++i) checkSkin(i);
    for (std::size_t i = 0; i < document_.nodes.size() && !fault_; ++i) checkNode(i);
    for (std::size_t i = 0; i < document_.scenes.size() && !fault_; ++i) {
      checkAll(document_.scenes[i].nodes, document_.nodes.size(), "node",
               placeOf("scenes", i) + "/nodes");
    }
    check(document_.scene, document_.scenes.size(), "scene", "/scene");
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

  void checkAll(const std::vector<std::uint32_t>& references, std::size_t size, const char* what,
                const std::string& place) {
    for (std::size_t i = 0; i < references.size(); ++i) {
      check(references[i], size, what, place + "/" + std::to_string(i));
    }
  }

  void checkView(std::size_t number) {
    const GltfBufferView& view = document_.bufferViews[number];
    const std::string place = placeOf("bufferViews", number);
    if (!check(view.buffer, document_.buffers.size(), "buffer", place + "/buffer")) return;
    const std::uint64_t size = document_.buffers[view.buffer].byteLength;
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
    if (!check(viewNumber, document_.bufferViews.size(), "buffer view", viewPlace)) return;
    const GltfBufferView& view = document_.bufferViews[viewNumber];
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
    const GltfAccessor& accessor = document_.accessors[number];
    const std::string place = placeOf("accessors", number);
    const std::size_t componentBytes = bytesOf(accessor.component);
    const std::size_t elementBytes = componentBytes * componentsOf(accessor.shape);
    if (accessor.count == 0) return report(place + "/count", "is 0");
    if (accessor.normalized && componentBytes > 2) {
      report(place + "/normalized", "is only for integers of one or two bytes");
    }
    if (accessor.bufferView) {
      checkElements(*accessor.bufferView, accessor.byteOffset, accessor.count, componentBytes,
                    elementBytes, place + "/bufferView", place);
    } else if (accessor.byteOffset != 0) {
      report(place + "/byteOffset", "is given, but no buffer view");
    }
    if (!accessor.sparse) return;
    const GltfSparse& sparse = *accessor.sparse;
    const std::string sparsePlace = place + "/sparse";
    if (sparse.count == 0 || sparse.count > accessor.count) {
      return report(sparsePlace + "/count", "is " + std::to_string(sparse.count) + " of " +
                                                std::to_string(accessor.count) + " elements");
    }
    const std::size_t indexBytes = bytesOf(sparse.indicesComponent);
    checkElements(sparse.indicesView, sparse.indicesOffset, sparse.count, indexBytes, indexBytes,
                  sparsePlace + "/indices/bufferView", sparsePlace + "/indices");
    checkElements(sparse.valuesView, sparse.valuesOffset, sparse.count, componentBytes,
                  elementBytes, sparsePlace + "/values/bufferView", sparsePlace + "/values");
  }

  void checkMesh(std::size_t number) {
    const GltfMesh& mesh = document_.meshes[number];
    const std::string meshPlace = placeOf("meshes", number) + "/primitives";
    if (mesh.primitives.empty()) report(meshPlace, "is empty");
    const std::size_t size = document_.accessors.size();
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const GltfPrimitive& primitive = mesh.primitives[p];
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
    const auto& accessors = document_.accessors;
    if (!check(reference, accessors.size(), "accessor", place)) return;
    if (!position || *position >= accessors.size()) return;
    const std::uint64_t count = accessors[*reference].count;
    if (count == accessors[*position].count) return;
    report(place, "has " + std::to_string(count) + " values for " +
                      std::to_string(accessors[*position].count) + " points");
  }

  void checkSkin(std::size_t number) {
    const GltfSkin& skin = document_.skins[number];
    const std::string place = placeOf("skins", number);
    if (skin.joints.empty()) report(place, "has no joints");
    checkAll(skin.joints, document_.nodes.size(), "node", place + "/joints");
    const std::string matrices = place + "/inverseBindMatrices";
    if (!check(skin.inverseBindMatrices, document_.accessors.size(), "accessor", matrices)) return;
    const GltfAccessor& accessor = document_.accessors[*skin.inverseBindMatrices];
    if (accessor.shape != GltfShape::Mat4 || accessor.component != GltfComponent::Float) {
      report(matrices, "is not an accessor of MAT4 in floats");
    } else if (accessor.count < skin.joints.size()) {
      report(matrices, "has " + std::to_string(accessor.count) + " matrices for " +
                           std::to_string(skin.joints.size()) + " joints");
    }
  }

  void checkNode(std::size_t number) {
    const GltfNode& node = document_.nodes[number];
    const std::string place = placeOf("nodes", number);
    checkAll(node.children, document_.nodes.size(), "node", place + "/children");
    check(node.mesh, document_.meshes.size(), "mesh", place + "/mesh");
    check(node.skin, document_.skins.size(), "skin", place + "/skin");
  }

  void checkParents() {
    std::vector<bool> isChild(document_.nodes.size(), false);
    for (std::size_t i = 0; i < document_.nodes.size() && !fault_; ++i) {
      for (const std::uint32_t child : document_.nodes[i].children) {
        if (isChild[child]) {
          report(placeOf("nodes", i) + "/children",
                 "node " + std::to_string(child) + " has another parent already");
        }
        isChild[child] = true;
      }
    }
  }

  const GltfDocument& document_;
  std::optional<Error> fault_;
};

}  // namespace

std::optional<Error> firstFaultOf(const GltfDocument& document) {
  return FaultFinder(document).run();
}

}  // namespace girth::io
