#include "gltf/buffers.h"

#include <cstdint>
#include <string_view>
#include <utility>

#include "gltf/json_fields.h"
#include "gltf/meshopt.h"
#include "text/quoted_name.h"

namespace girth::io {
namespace {

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

int base64Digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return -1;
}

std::optional<std::vector<std::byte>> base64Decoded(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : text) {
    const int digit = base64Digit(c);
    if (digit < 0) return std::nullopt;
    bits = (bits << 6 | static_cast<std::uint32_t>(digit)) & 0xFFFFFFu;
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(static_cast<std::byte>(bits >> count & 0xFFu));
    }
  }
  return bytes;
}

/// The content of a data: URI.
std::optional<std::vector<std::byte>> dataOf(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const std::string_view head = uri.substr(0, comma);
  const std::string_view body = uri.substr(comma + 1);
  constexpr std::string_view kBase64 = ";base64";
  if (head.size() >= kBase64.size() && head.substr(head.size() - kBase64.size()) == kBase64) {
    return base64Decoded(body);
  }
  const std::string text = percentDecoded(body);
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return std::vector<std::byte>(first, first + text.size());
}

}  // namespace

std::string percentDecoded(std::string_view uri) {
  std::string text;
  text.reserve(uri.size());
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && hexDigit(uri[i + 1]) >= 0 &&
        hexDigit(uri[i + 2]) >= 0) {
      text += static_cast<char>(hexDigit(uri[i + 1]) * 16 + hexDigit(uri[i + 2]));
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

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

GltfBuffers::GltfBuffers(const GltfDocument& document, std::span<const std::byte> binary,
                         const ResourceReader& resources, SoupBudget& budget)
    : document_(document), binary_(binary), resources_(resources), budget_(budget) {}

Result<std::span<const std::byte>> GltfBuffers::resource(const std::string& uri,
                                                         const std::string& place) {
  if (const auto found = fetched_.find(uri); found != fetched_.end()) {
    return std::span<const std::byte>(found->second);
  }
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
  if (!bytes)
    return error("it refers to the file " + inQuotes(name) + ", which is missing beside the model");
  budget_.allowFor(bytes->size());
  return std::span<const std::byte>(fetched_.emplace(uri, std::move(*bytes)).first->second);
}

Result<std::span<const std::byte>> GltfBuffers::buffer(std::uint32_t index) {
  const GltfBuffer& source = document_.buffers[index];
  const std::string place = "/buffers/" + std::to_string(index);
  std::span<const std::byte> bytes;
  if (source.uri.empty()) {
    if (index != 0) return faultAt(place, "has no uri, and so no bytes");
    if (binary_.empty()) return faultAt(place, "has neither a uri nor a binary chunk");
    bytes = binary_;
  } else if (source.uri.rfind("data:", 0) == 0) {
    auto found = decoded_.find(index);
    if (found == decoded_.end()) {
      auto data = dataOf(source.uri);
      if (!data) return faultAt(place + "/uri", "is a data: URI that is not valid");
      found = decoded_.emplace(index, std::move(*data)).first;
    }
    bytes = found->second;
  } else {
    auto fetched = resource(source.uri, place + "/uri");
    if (!fetched) return fetched.error();
    bytes = fetched.value();
  }
  if (source.byteLength > bytes.size()) {
    return faultAt(place + "/byteLength", "promises " + std::to_string(source.byteLength) +
                                              " bytes, but there are " +
                                              std::to_string(bytes.size()));
  }
  return bytes.first(static_cast<std::size_t>(source.byteLength));
}

Result<std::span<const std::byte>> GltfBuffers::range(std::uint32_t index, std::uint64_t offset,
                                                      std::uint64_t length,
                                                      const std::string& user) {
  if (index >= document_.buffers.size()) {
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
  for (std::uint32_t i = 0; i < document_.buffers.size(); ++i) {
    // Where packed bytes would be unpacked to.
    const bool isPlaceholder = i > 0 && document_.buffers[i].uri.empty();
    if (isPlaceholder) continue;
    if (auto bytes = buffer(i); !bytes) return bytes.error();
  }
  return std::nullopt;
}

Result<std::span<const std::byte>> GltfBuffers::unpacked(std::uint32_t index) {
  const GltfBufferView& view = document_.bufferViews[index];
  const GltfMeshopt& packed = *view.packed;
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
  return std::span<const std::byte>(found->second).first(static_cast<std::size_t>(view.byteLength));
}

Result<std::span<const std::byte>> GltfBuffers::view(std::uint32_t index, const std::string& user) {
  if (index >= document_.bufferViews.size()) {
    return faultAt(user, "there is no buffer view " + std::to_string(index));
  }
  const GltfBufferView& view = document_.bufferViews[index];
  if (view.packed) return unpacked(index);
  return range(view.buffer, view.byteOffset, view.byteLength,
               "/bufferViews/" + std::to_string(index));
}

}  // namespace girth::io
