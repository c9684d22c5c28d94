// The numbers that a glTF primitive has for each of its points, packed or not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gltf/unpack/accessor.h"
#include "gltf/unpack/draco.h"
#include "gltf/unpack/soup_budget.h"

namespace girth::io {

/// Where the numbers of an attribute are: in an accessor; or, where both others are given, in a
/// packed mesh, which the accessor describes.
struct PointSource {
  std::uint32_t accessor{0};
  const DracoMesh* packed{nullptr};
  std::optional<std::uint32_t> packedNumber;
};

/// Reads attributes of points.
class PointNumbers {
 public:
  /// Both must outlive the object.
  PointNumbers(GltfAccessors& accessors, SoupBudget& budget)
      : accessors_(accessors), budget_(budget) {}

  /// Appends an attribute's numbers. `shape`: TINYGLTF_TYPE_... `user`: the attribute's place, as a
  /// JSON pointer. `count`: how many elements there must be; 0 as long as nobody knows, and then it
  /// is set. Errors: MALFORMED_FILE, and those of GltfAccessors.
  std::optional<Error> append(const PointSource& source, int shape, const std::string& user,
                              std::size_t& count, std::vector<double>& numbers);

  /// The error of an attribute with another number of elements.
  static Error otherCount(const std::string& user, std::uint64_t found, std::size_t count);

 private:
  GltfAccessors& accessors_;
  SoupBudget& budget_;
};

}  // namespace girth::io
