// Notes of the glTF reader: what it did and what it left out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gltf/document/tinygltf.h"

namespace girth::io {

/// Counted while a scene is walked.
struct GltfNotes {
  std::optional<std::size_t> scene;
  std::size_t hiddenNodes{0};
  std::size_t instances{0};
  std::size_t sharedNodes{0};
  std::size_t pointPrimitives{0};
  std::size_t linePrimitives{0};
  std::size_t primitivesWithoutPositions{0};
  /// By mesh: whether it stands in the pose in which it was bound to its joints.
  std::map<std::uint32_t, bool> skinnedMeshes;
  /// By mesh: whether its weights move it.
  std::map<std::uint32_t, bool> morphedMeshes;

  /// One sentence each.
  std::vector<std::string> sentences(const tinygltf::Model& model) const;

  /// Why nothing was found in a document without a fault.
  std::string whyEmpty(const tinygltf::Model& model) const;
};

}  // namespace girth::io
