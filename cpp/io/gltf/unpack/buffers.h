// The bytes behind a glTF document's buffers and buffer views.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "girth/io/read_mesh.h"
#include "gltf/document/document.h"
#include "gltf/unpack/soup_budget.h"

namespace girth::io {

/// Fetches buffers into the model and unpacks buffer views when they are first asked for, so that
/// bytes that no triangle needs may be missing.
class GltfBuffers {
 public:
  /// All must outlive the object; `binaryBytes` is the size of the GLB's binary chunk. Bytes
  /// fetched from outside the file, and what packed ones may become, are added to the budget.
  GltfBuffers(GltfDocument& document, std::size_t binaryBytes, const ResourceReader& resources,
              SoupBudget& budget);

  /// The bytes of a buffer view, unpacked. `user` is the place of the reference, as a JSON pointer.
  /// Errors: MALFORMED_FILE, MISSING_RESOURCE, UNSUPPORTED_FEATURE, LIMIT_EXCEEDED.
  Result<std::span<const std::byte>> view(std::uint32_t index, const std::string& user);

  /// Fetches all buffers that state where their bytes are: the first that cannot be had.
  std::optional<Error> firstFault();

 private:
  Result<std::span<const std::byte>> range(std::uint32_t buffer, std::uint64_t offset,
                                           std::uint64_t length, const std::string& user);
  Result<std::span<const std::byte>> buffer(std::uint32_t index);
  /// The buffer that holds the file of that uri: the first that refers to it.
  Result<std::uint32_t> fetched(const std::string& uri, std::uint32_t index,
                                const std::string& place);
  Result<std::span<const std::byte>> unpacked(std::uint32_t index, const GltfMeshopt& packed);

  GltfDocument& document_;
  std::size_t binaryBytes_;
  const ResourceReader& resources_;
  SoupBudget& budget_;
  std::vector<bool> decoded_;
  std::map<std::string, std::uint32_t> fetched_;
  std::map<std::uint32_t, std::vector<std::byte>> unpacked_;
};

/// Whether a name stays beside the model: relative, without scheme, and never up a folder.
bool staysInside(std::string_view name);

}  // namespace girth::io
