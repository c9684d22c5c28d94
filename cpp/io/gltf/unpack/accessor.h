// Reading the numbers behind glTF accessors, with every count, stride and offset checked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "girth/surface_mesh.h"
#include "gltf/document/document.h"
#include "gltf/unpack/buffers.h"
#include "gltf/unpack/soup_budget.h"

namespace girth::io {

/// Reads accessors of any component type, normalised or not, sparse or not. Elements without bytes
/// behind them are zero, as glTF prescribes.
class GltfAccessors {
 public:
  /// All must outlive the object.
  GltfAccessors(const tinygltf::Model& model, GltfBuffers& buffers, SoupBudget& budget)
      : model_(model), buffers_(buffers), budget_(budget) {}

  /// The accessor of that number. `shape`: TINYGLTF_TYPE_... `user` is the place of the reference,
  /// as a JSON pointer. Errors: MALFORMED_FILE where there is none or where its elements have
  /// another shape.
  Result<const tinygltf::Accessor*> find(std::uint32_t number, int shape,
                                         const std::string& user) const;

  /// Appends the accessor's numbers, component by component, and gives how many elements there
  /// were. Normalised integers map onto [0, 1] or [-1, 1]. The elements are taken from the budget.
  /// Errors: MALFORMED_FILE, LIMIT_EXCEEDED and those of GltfBuffers.
  Result<std::size_t> appendNumbers(std::uint32_t number, int shape, const std::string& user,
                                    std::vector<double>& numbers);

  /// Appends the vertex numbers of an index accessor, not compared with the number of vertices.
  /// Errors as above.
  Result<std::size_t> appendIndices(std::uint32_t number, const std::string& user,
                                    std::vector<Index>& indices);

 private:
  struct Elements;
  Result<Elements> elementsOf(std::uint32_t view, const std::string& viewUser, std::uint64_t offset,
                              std::uint64_t count, std::size_t elementBytes,
                              const std::string& place);
  template <class Put>
  Result<std::size_t> forEachRun(const tinygltf::Accessor& accessor, const std::string& place,
                                 const Put& put);

  const tinygltf::Model& model_;
  GltfBuffers& buffers_;
  SoupBudget& budget_;
};

/// Appends numbers of a component type that follow each other without gaps.
void appendComponents(std::span<const std::byte> bytes, int componentType, bool normalized,
                      std::vector<double>& numbers);

}  // namespace girth::io
