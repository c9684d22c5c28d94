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

// The name under which tinygltf asks for the one file that it may have.
constexpr const char* kFileName = "buffer";

using Bytes = std::span<const std::byte>;

/// Callbacks that answer from `content` and refuse everything else.
tinygltf::FsCallbacks callbacksFor(Bytes& content) {
  tinygltf::FsCallbacks callbacks;
  callbacks.FileExists = [](const std::string& name, void*) { return name == kFileName; };
  callbacks.ExpandFilePath = [](const std::string& name, void*) { return name; };
  callbacks.ReadWholeFile = [](std::vector<unsigned char>* bytes, std::string*,
                               const std::string& name, void* user) {
    if (name != kFileName) return false;
    const Bytes& file = *static_cast<const Bytes*>(user);
    const auto* first = reinterpret_cast<const unsigned char*>(file.data());
    bytes->assign(first, first + file.size());
    return true;
  };
  callbacks.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&,
                                void*) { return false; };
  callbacks.user_data = &content;
  return callbacks;
}

/// What a chunk has to be filled up with.
std::size_t paddingOf(std::size_t bytes) { return (4 - bytes % 4) % 4; }

/// The size of a GLB file.
std::uint64_t glbBytes(std::size_t json, std::size_t binary) {
  constexpr std::uint64_t kHeader = 12, kChunkHeader = 8;
  return kHeader + 2 * kChunkHeader + json + paddingOf(json) + binary + paddingOf(binary);
}

/// Reads JSON, or a GLB of JSON and a binary chunk, with a file beside it.
Result<tinygltf::Model> load(std::string_view json, Bytes binary, Bytes file) {
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks(callbacksFor(file));
  tinygltf::Model model;
  std::string error, warning;
  bool isLoaded = false;
  const std::uint64_t size = glbBytes(json.size(), binary.size());
  if (size > kMostGlbBytes) {
    return makeError(ErrorCode::LimitExceeded, -1, "its geometry takes more than 4 GB of glTF");
  }
  if (binary.empty()) {
    isLoaded = loader.LoadASCIIFromString(&model, &error, &warning, json.data(),
                                          static_cast<unsigned>(json.size()), "");
  } else {
    std::string glb;
    glb.reserve(static_cast<std::size_t>(size));
    const auto appendChunk = [&glb](std::string_view type, std::string_view content, char filler) {
      const std::size_t padding = paddingOf(content.size());
      appendBytes(glb, content.size() + padding, 4);
      glb.append(type).append(content).append(padding, filler);
    };
    glb += "glTF";
    appendBytes(glb, 2, 4);
    appendBytes(glb, size, 4);
    appendChunk("JSON", json, ' ');
    appendChunk({"BIN\0", 4}, {reinterpret_cast<const char*>(binary.data()), binary.size()}, '\0');
    isLoaded = loader.LoadBinaryFromMemory(&model, &error, &warning,
                                           reinterpret_cast<const unsigned char*>(glb.data()),
                                           static_cast<unsigned>(glb.size()));
  }
  if (!isLoaded) return makeError(ErrorCode::Internal, -1, "tinygltf refuses it: " + error);
  return model;
}

/// Puts what travelled in "extras" back in its place.
void putBack(tinygltf::Model& model) {
  for (tinygltf::BufferView& view : model.bufferViews) {
    if (!view.extras.Has("byteStride")) continue;
    view.byteStride = static_cast<std::size_t>(view.extras.Get("byteStride").GetNumberAsDouble());
  }
  for (tinygltf::Mesh& mesh : model.meshes) {
    for (tinygltf::Primitive& primitive : mesh.primitives) {
      if (!primitive.extras.Has("indices")) continue;
      primitive.indices = primitive.extras.Get("indices").GetNumberAsInt();
    }
  }
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

Result<tinygltf::Model> loadModel(const GeometryJson& document, Bytes binary) {
  auto model = load(document.text, binary.first(document.embeddedBytes), {});
  if (!model) return model.error();
  putBack(model.value());
  model.value().buffers.resize(document.buffers.size());
  return model;
}

tinygltf::Buffer bufferOfFile(Bytes content) {
  if (content.empty()) return {};
  const std::string json = std::string(R"({"asset":{"version":"2.0"},"buffers":[{"uri":")") +
                           kFileName + R"(","byteLength":)" + std::to_string(content.size()) +
                           "}]}";
  auto model = load(json, {}, content);
  return model && !model.value().buffers.empty() ? std::move(model.value().buffers[0])
                                                 : tinygltf::Buffer();
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
