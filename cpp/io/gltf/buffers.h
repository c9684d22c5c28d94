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
#include "gltf/document.h"
#include "gltf/soup_budget.h"

namespace girth::io {

/// Fetches buffers and unpacks buffer views when they are first asked for, so that bytes that no
/// triangle needs may be missing. Nothing that is in the file already is copied.
class GltfBuffers {
 public:
  /// All must outlive the object; `binary` is the GLB's binary chunk. Bytes fetched from outside
  /// the file, and what packed ones may become, are added to the budget.
  GltfBuffers(const GltfDocument& document, std::span<const std::byte> binary,
              const ResourceReader& resources, SoupBudget& budget);

  /// The bytes of a buffer view, unpacked. `user` is the place of the reference, as a JSON pointer.
  /// Errors: MALFORMED_FILE, MISSING_RESOURCE, UNSUPPORTED_FEATURE, LIMIT_EXCEEDED.
  Result<std::span<const std::byte>> view(std::uint32_t index, const std::string& user);

  /// Fetches all buffers that say where their bytes are: the first that cannot be had.
  std::optional<Error> firstFault();

 private:
  Result<std::span<const std::byte>> range(std::uint32_t buffer, std::uint64_t offset,
                                           std::uint64_t length, const std::string& user);
  Result<std::span<const std::byte>> buffer(std::uint32_t index);
  Result<std::span<const std::byte>> resource(const std::string& uri, const std::string& place);
  Result<std::span<const std::byte>> unpacked(std::uint32_t index);

  const GltfDocument& document_;
  std::span<const std::byte> binary_;
  const ResourceReader& resources_;
  SoupBudget& budget_;
  std::map<std::uint32_t, std::vector<std::byte>> decoded_;
  std::map<std::uint32_t, std::vector<std::byte>> unpacked_;
  std::map<std::string, std::vector<std::byte>> fetched_;
};

/// A URI's percent escapes undone.
std::string percentDecoded(std::string_view uri);

/// Whether a name stays beside the model: relative, without scheme, and never up a folder.
bool staysInside(std::string_view name);

}  // namespace girth::io
