#include "gltf/unpack/buffers.h"

#include <cstdint>
#include <string_view>
#include <utility>

#include "gltf/document/fault.h"
#include "gltf/document/tinygltf_model.h"
#include "gltf/unpack/meshopt.h"
#include "text/quoted_name.h"

namespace girth::io {
bool staysInside(std::string_view name) {
  if (name.empty() || name.front() == '/' || name.front() == '\\') return false;
  if (name.find('\0') != std::string_view::npos) return false;
  // A scheme or a drive; a colon has no other place in the names of buffers.
  if (name.find(':') != std::string_view::npos) return false;
  while (true) {
    const std::size_t end = name.find_first_of("/\\");
    if (name.substr(0, end) == "..") return false;
    if (end == std::string_view::npos) return true;
    name.remove_prefix(end + 1);
  }
}

GltfBuffers::GltfBuffers(GltfDocument& document, std::size_t binaryBytes,
                         const ResourceReader& resources, SoupBudget& budget)
    : document_(document),
      binaryBytes_(binaryBytes),
      resources_(resources),
      budget_(budget),
      decoded_(document.sources.size(), false) {}

Result<std::uint32_t> GltfBuffers::fetched(const std::string& uri, std::uint32_t index,
                                           const std::string& place) {
  if (const auto found = fetched_.find(uri); found != fetched_.end()) return found->second;
  const std::string name = percentDecoded(uri);
  const auto error = [&](const std::string& what) {
    return makeError(ErrorCode::MissingResource, -1, place + ": " + what);
  };
  if (!staysInside(name)) {
    return error("it refers to " + inQuotes(name) + ", which is not a file beside the model");
  }
  auto bytes = resources_ ? resources_(name) : std::nullopt;
  // Some exporters do not escape, and so a file's name may contain a percent sign.
  if (!bytes && resources_ && name != uri && staysInside(uri)) bytes = resources_(uri);
  if (!bytes) {
    return makeError(ErrorCode::MissingResource, -1,
                     "the file " + inQuotes(name) + " is missing: the model refers to it");
  }
  budget_.allowFor(bytes->size());
  document_.model.buffers[index] = bufferOf(*bytes);
  return fetched_.emplace(uri, index).first->second;
}

Result<std::span<const std::byte>> GltfBuffers::buffer(std::uint32_t index) {
  const GltfBufferSource& source = document_.sources[index];
  const std::string place = "/buffers/" + std::to_string(index);
  std::uint32_t holder = index;
  std::uint64_t available = 0;
  if (source.uri.empty()) {
    if (index != 0) return faultAt(place, "has no uri, and so no bytes");
    if (binaryBytes_ == 0) return faultAt(place, "has neither a uri nor a binary chunk");
    available = binaryBytes_;
  } else {
    if (source.uri.rfind("data:", 0) != 0) {
      auto found = fetched(source.uri, index, place + "/uri");
      if (!found) return found.error();
      holder = found.value();
    } else if (!decoded_[index]) {
      auto data = bufferOfData(source.uri);
      if (!data) return faultAt(place + "/uri", "is a data: URI that is not valid");
      document_.model.buffers[index] = std::move(*data);
      decoded_[index] = true;
    }
    available = document_.model.buffers[holder].data.size();
  }
  if (source.byteLength > available) {
    return faultAt(place + "/byteLength", "promises " + std::to_string(source.byteLength) +
                                              " bytes, but there are " + std::to_string(available));
  }
  return std::as_bytes(std::span<const unsigned char>(document_.model.buffers[holder].data))
      .first(static_cast<std::size_t>(source.byteLength));
}

Result<std::span<const std::byte>> GltfBuffers::range(std::uint32_t index, std::uint64_t offset,
                                                      std::uint64_t length,
                                                      const std::string& user) {
  if (index >= document_.sources.size()) {
    return faultAt(user + "/buffer", "there is no buffer " + std::to_string(index));
  }
  auto bytes = buffer(index);
  if (!bytes) return bytes.error();
  const std::span<const std::byte> all = bytes.value();
  if (offset > all.size() || length > all.size() - offset) {
    return faultAt(user, "reaches beyond the end of buffer " + std::to_string(index));
  }
  return all.subspan(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
}

std::optional<Error> GltfBuffers::firstFault() {
  for (std::uint32_t i = 0; i < document_.sources.size(); ++i) {
    // Where packed bytes would be unpacked to.
    const bool isPlaceholder = i > 0 && document_.sources[i].uri.empty();
    if (isPlaceholder) continue;
    if (auto bytes = buffer(i); !bytes) return bytes.error();
  }
  return std::nullopt;
}

Result<std::span<const std::byte>> GltfBuffers::unpacked(std::uint32_t index,
                                                         const GltfMeshopt& packed) {
  const tinygltf::BufferView& view = document_.model.bufferViews[index];
  const std::string place =
      "/bufferViews/" + std::to_string(index) + "/extensions/" + packed.extension;
  auto found = unpacked_.find(index);
  if (found == unpacked_.end()) {
    auto bytes = range(packed.buffer, packed.byteOffset, packed.byteLength, place);
    if (!bytes) return bytes.error();
    budget_.allowFor(bytes.value().size());
    auto content = unpackMeshopt(packed, bytes.value(), budget_, place);
    if (!content) return content.error();
    found = unpacked_.emplace(index, std::move(content).value()).first;
  }
  if (view.byteLength > found->second.size()) {
    return faultAt("/bufferViews/" + std::to_string(index) + "/byteLength",
                   "is " + std::to_string(view.byteLength) + ", but unpacked there are " +
                       std::to_string(found->second.size()) + " bytes");
  }
  return std::span<const std::byte>(found->second).first(view.byteLength);
}

Result<std::span<const std::byte>> GltfBuffers::view(std::uint32_t index, const std::string& user) {
  const auto& views = document_.model.bufferViews;
  if (index >= views.size()) {
    return faultAt(user, "there is no buffer view " + std::to_string(index));
  }
  const tinygltf::BufferView& view = views[index];
  if (const auto packed = meshoptOf(view)) return unpacked(index, *packed);
  return range(unsignedOf(view.buffer), view.byteOffset, view.byteLength,
               "/bufferViews/" + std::to_string(index));
}

}  // namespace girth::io
