// Meshes packed with KHR_draco_mesh_compression.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "girth/error.h"
#include "girth/surface_mesh.h"
#include "gltf/document/document.h"
#include "gltf/unpack/soup_budget.h"

namespace girth::io {

/// A mesh as Draco unpacks it: points, triangles between them, and attributes of the points.
class DracoMesh {
 public:
  /// Unpacks faces and the attributes of those numbers; a stream's last attributes, where nobody
  /// asks for them, are not even looked at. How many points and faces a stream claims is looked up
  /// before memory is asked for, and the budget pays for them. `place` is the JSON pointer of the
  /// extension, for messages.
  /// Errors: MALFORMED_FILE, LIMIT_EXCEEDED, OUT_OF_MEMORY, and UNSUPPORTED_FEATURE where the
  /// stream is of another version than glTF's (2.2); also in WebAssembly, where the page unpacks
  /// before the reader sees a file.
  static Result<DracoMesh> unpack(std::span<const std::byte> bytes,
                                  const std::vector<std::uint32_t>& numbers, SoupBudget& budget,
                                  const std::string& place);

  std::size_t pointCount() const;
  std::size_t faceCount() const;

  /// Appends three points per face. Every one is below pointCount().
  void appendFaces(std::vector<Index>& corners) const;

  /// An attribute that was asked for, for all points, as components of that type
  /// (TINYGLTF_COMPONENT_TYPE_...) without gaps; nothing where there is no such attribute, or not
  /// of so many components.
  std::optional<std::vector<std::byte>> attribute(std::uint32_t number, std::size_t components,
                                                  int componentType) const;

  DracoMesh(DracoMesh&&) noexcept;
  DracoMesh& operator=(DracoMesh&&) noexcept;
  ~DracoMesh();

 private:
  struct Content;
  explicit DracoMesh(std::unique_ptr<Content> content);

  std::unique_ptr<Content> content_;
};

}  // namespace girth::io
