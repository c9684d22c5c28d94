// The bytes behind a glTF document's buffers and buffer views.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "girth/io/read_mesh.h"
#include "gltf_document.h"
#include "soup_budget.h"

namespace girth::io {

/// Fetches buffers when they are first asked for, so that bytes that no triangle needs may be
/// missing.
class GltfBuffers {
 public:
  /// All must outlive the object; `binary` is the GLB's binary chunk. Bytes fetched from outside
  /// the file are added to the budget.
  GltfBuffers(const GltfDocument& document, std::span<const std::byte> binary,
              const ResourceReader& resources, SoupBudget& budget);

  /// The bytes of a buffer view. `user` names who asks, for messages.
  /// Errors: MALFORMED_FILE, MISSING_RESOURCE, UNSUPPORTED_FEATURE.
  Result<std::span<const std::byte>> view(int index, const std::string& user);

 private:
  Result<std::span<const std::byte>> buffer(std::size_t index);
  Result<std::span<const std::byte>> resource(const std::string& uri, std::size_t index);

  const GltfDocument& document_;
  std::span<const std::byte> binary_;
  const ResourceReader& resources_;
  SoupBudget& budget_;
  std::map<std::size_t, std::vector<std::byte>> decoded_;
  std::map<std::string, std::vector<std::byte>> fetched_;
};

/// A URI's percent escapes undone.
std::string percentDecoded(std::string_view uri);

/// Whether a name stays beside the model: relative, without scheme, and never up a folder.
bool staysInside(std::string_view name);

}  // namespace girth::io
