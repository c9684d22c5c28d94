#include "gltf/document/tinygltf_model.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <streambuf>
#include <utility>

// tinygltf names its streams even where it is compiled without files.
#include <fstream>
#include <nlohmann/json.hpp>

// Its own copies of that library lie elsewhere.
#define TINYGLTF_NO_INCLUDE_JSON
#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>

#include "bytes/append.h"

namespace girth::io {
namespace {

constexpr std::uint64_t kMostGlbBytes = std::numeric_limits<std::uint32_t>::max();

using Bytes = std::span<const std::byte>;

/// Reads each element of a list of the document, if there is one. False: tinygltf refuses one.
template <class Element, class Parse>
bool readList(nlohmann::json& document, const char* name, std::vector<Element>& elements,
              const Parse& parse) {
  const auto list = document.find(name);
  if (list == document.end()) return true;
  elements.reserve(list->size());
  for (nlohmann::json& element : *list) {
    if (!parse(element, elements.emplace_back())) return false;
  }
  return true;
}

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// The digits as tinygltf takes them; nothing where there are others.
std::optional<std::string> plainDigits(std::string_view text) {
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::string digits(text);
  for (char& c : digits) {
    if (c == '-') c = '+';
    if (c == '_') c = '/';
    const bool isDigit = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') ||
                         (c >= '0' && c <= '9') || c == '+' || c == '/';
    if (!isDigit) return std::nullopt;
  }
  return digits;
}

tinygltf::Value gltfValue(const nlohmann::json& json) {
  using tinygltf::Value;
  if (json.is_object()) {
    Value::Object object;
    for (const auto& [name, member] : json.items()) object.emplace(name, gltfValue(member));
    return Value(std::move(object));
  }
  if (json.is_array()) {
    Value::Array array;
    for (const auto& element : json) array.push_back(gltfValue(element));
    return Value(std::move(array));
  }
  if (json.is_string()) return Value(json.get<std::string>());
  if (json.is_boolean()) return Value(json.get<bool>());
  return json.is_number() ? Value(json.get<double>()) : Value();
}

/// Appends what is written to a text.
class TextBuffer : public std::streambuf {
 public:
  explicit TextBuffer(std::string& text) : text_(text) {}

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    text_.append(bytes, static_cast<std::size_t>(count));
    return count;
  }
  int_type overflow(int_type c) override {
    if (c != traits_type::eof()) text_ += traits_type::to_char_type(c);
    return traits_type::not_eof(c);
  }

 private:
  std::string& text_;
};

}  // namespace

Result<tinygltf::Model> loadModel(GeometryJson& document, Bytes binary) {
  namespace gltf = tinygltf;
  using Json = nlohmann::json;
  gltf::Model model;
  std::string error;
  Json& geometry = document.geometry;
  const auto readView = [&](Json& json, gltf::BufferView& view) {
    // It refuses strides that are not multiples of 4.
    const std::size_t stride = json.value("byteStride", std::size_t{0});
    json.erase("byteStride");
    const bool isRead = gltf::ParseBufferView(&view, &error, json, false);
    view.byteStride = stride;
    return isRead;
  };
  const auto readAccessor = [&](const Json& json, gltf::Accessor& accessor) {
    return gltf::ParseAccessor(&accessor, &error, json, false);
  };
  const auto readMesh = [&](const Json& json, gltf::Mesh& mesh) {
    return gltf::ParseMesh(&mesh, &model, &error, json, false);
  };
  const auto readNode = [&](const Json& json, gltf::Node& node) {
    return gltf::ParseNode(&node, &error, json, false);
  };
  const auto readSkin = [&](const Json& json, gltf::Skin& skin) {
    return gltf::ParseSkin(&skin, &error, json, false);
  };
  const auto readScene = [](const Json& json, gltf::Scene& scene) {
    scene.name = json.value("name", "");
    scene.nodes = json.at("nodes").get<std::vector<int>>();
    return true;
  };
  if (!readList(geometry, "bufferViews", model.bufferViews, readView) ||
      !readList(geometry, "accessors", model.accessors, readAccessor) ||
      !readList(geometry, "meshes", model.meshes, readMesh) ||
      !readList(geometry, "nodes", model.nodes, readNode) ||
      !readList(geometry, "skins", model.skins, readSkin) ||
      !readList(geometry, "scenes", model.scenes, readScene)) {
    return makeError(ErrorCode::Internal, -1, "tinygltf refuses it: " + error);
  }
  model.defaultScene = geometry.value("scene", -1);
  geometry = Json();  // it may be large
  model.buffers.resize(document.buffers.size());
  if (document.embeddedBytes > 0) {
    model.buffers[0] = bufferOf(binary.first(document.embeddedBytes));
  }
  return model;
}

tinygltf::Buffer bufferOf(Bytes content) {
  tinygltf::Buffer buffer;
  const auto* first = reinterpret_cast<const unsigned char*>(content.data());
  buffer.data.assign(first, first + content.size());
  return buffer;
}

std::optional<tinygltf::Buffer> bufferOfData(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const std::string_view head = uri.substr(0, comma);
  const std::string_view body = uri.substr(comma + 1);
  constexpr std::string_view kBase64 = ";base64";
  tinygltf::Buffer buffer;
  if (head.size() >= kBase64.size() && head.substr(head.size() - kBase64.size()) == kBase64) {
    auto digits = plainDigits(body);
    constexpr std::size_t kMostDigits = std::numeric_limits<int>::max();
    if (!digits || digits->size() > kMostDigits) return std::nullopt;
    // It takes data of less than a byte for a fault.
    if (digits->size() < 2) return buffer;
    std::string mediaType;
    const std::string known = "data:application/octet-stream;base64," + *digits;
    if (!tinygltf::DecodeDataURI(&buffer.data, mediaType, known, 0, false)) return std::nullopt;
  } else {
    const std::string text = percentDecoded(body);
    buffer.data.assign(text.begin(), text.end());
  }
  return buffer;
}

tinygltf::Value valueOf(std::string_view json) { return gltfValue(nlohmann::json::parse(json)); }

Result<std::string> glbOf(const tinygltf::Model& model) {
  const Error tooLarge = makeError(ErrorCode::LimitExceeded, -1, "a GLB file holds at most 4 GB");
  const std::size_t bytes = model.buffers.empty() ? 0 : model.buffers[0].data.size();
  if (bytes > kMostGlbBytes) return tooLarge;
  std::string content;
  constexpr std::size_t kUsualJson = 4096;
  content.reserve(bytes + kUsualJson);
  TextBuffer buffer(content);
  std::ostream stream(&buffer);
  tinygltf::TinyGLTF writer;
  writer.WriteGltfSceneToStream(&model, stream, false, true);
  if (content.size() > kMostGlbBytes) return tooLarge;
  return content;
}

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

}  // namespace girth::io
