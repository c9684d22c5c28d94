// Tiny documents that the tests of reading are made of: a tetrahedron in every disguise.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "girth/io/read_mesh.h"

namespace girth::io::testing {

/// The tetrahedron: as lines of text, and as what is read.
inline const std::string kVertexLines = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
inline const std::string kFaceLines = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
inline const std::vector<double> kTetrahedronPositions{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
inline const std::vector<Index> kTetrahedronTriangles{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

inline std::vector<std::byte> bytesOf(std::string_view text) {
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  return {first, first + text.size()};
}

/// A file's bytes; nothing where there is none.
inline std::optional<std::vector<std::byte>> contentOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) return std::nullopt;
  const std::string content((std::istreambuf_iterator<char>(file)), {});
  return bytesOf(content);
}

/// Reads text or binary content as a file of that name.
inline Result<LoadedMesh> read(std::string_view content, std::string_view name,
                               const ResourceReader& resources = {}) {
  return readMesh(bytesOf(content), name, resources);
}

inline Result<ReadModel> modelOf(std::string_view content, std::string_view name,
                                 const ResourceReader& resources = {}) {
  return readModel(bytesOf(content), name, resources);
}

/// The triangles of the file, without the reader's notes.
inline Result<TriangleSoup> soupOf(std::string_view content, std::string_view name,
                                   const ResourceReader& resources = {}) {
  auto model = modelOf(content, name, resources);
  if (!model) return model.error();
  return std::move(model).value().soup;
}

/// The code of the failure; "OK" where there is none.
template <class T>
std::string codeOf(const Result<T>& result) {
  return result ? "OK" : std::string(toString(result.error().code));
}

template <class T>
std::string messageOf(const Result<T>& result) {
  return result ? "" : result.error().message;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A document that cannot be read: the code, the place, and what the message speaks of.
struct Refused {
  std::string text;
  const char* code;
  std::int64_t place;
  const char* about;
};

/// Expects that each of them, read as a file of that name, is refused as it says.
inline void expectRefused(const char* name, std::initializer_list<Refused> cases) {
  for (const Refused& c : cases) {
    const auto result = soupOf(c.text, name);
    EXPECT_EQ(codeOf(result), c.code) << c.text << messageOf(result);
    if (result) continue;
    EXPECT_EQ(result.error().element, c.place) << c.text << messageOf(result);
    EXPECT_TRUE(contains(messageOf(result), c.about)) << c.text << messageOf(result);
  }
}

/// Little-endian numbers of `size` bytes.
inline std::string packed(std::initializer_list<std::int64_t> numbers, int size) {
  std::string bytes;
  for (const std::int64_t number : numbers) {
    for (int i = 0; i < size; ++i) {
      bytes += static_cast<char>(static_cast<std::uint64_t>(number) >> (8 * i) & 0xFFu);
    }
  }
  return bytes;
}

inline std::string packedFloats(std::initializer_list<float> numbers) {
  std::string bytes;
  for (const float number : numbers) bytes += packed({std::bit_cast<std::int32_t>(number)}, 4);
  return bytes;
}

/// A GLB file around a document and its bytes.
inline std::string glb(std::string json, std::string binary) {
  while (json.size() % 4 != 0) json += ' ';
  while (binary.size() % 4 != 0) binary += '\0';
  std::string chunks = packed({static_cast<std::int64_t>(json.size()), 0x4E4F534A}, 4) + json;
  if (!binary.empty()) {
    chunks += packed({static_cast<std::int64_t>(binary.size()), 0x004E4942}, 4) + binary;
  }
  return "glTF" + packed({2, static_cast<std::int64_t>(12 + chunks.size())}, 4) + chunks;
}

/// Corner (0,0,0) and three points on the axes; faces counter-clockwise from outside.
inline const std::string kTetrahedronObj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// The tetrahedron as a glTF document whose parts can be replaced one by one.
struct TinyGltf {
  std::string binary = packedFloats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}) +
                       packed({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, 2);
  std::string bufferUri;
  std::string views =
      R"({"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24})";
  std::string accessors = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
                          R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"})";
  std::string primitives = R"({"attributes":{"POSITION":0},"indices":1})";
  std::string nodes = R"({"mesh":0})";
  std::string scenes = R"("scene":0,"scenes":[{"nodes":[0]}])";
  /// Further top-level members, each with a comma before it.
  std::string more;

  std::string json() const {
    return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" +
           std::to_string(binary.size()) +
           (bufferUri.empty() ? "" : R"(,"uri":")" + bufferUri + "\"") + R"(}],"bufferViews":[)" +
           views + R"(],"accessors":[)" + accessors +
           R"(],"meshes":[{"name":"tiny","primitives":[)" + primitives + R"(]}],"nodes":[)" +
           nodes + "]" + (scenes.empty() ? "" : "," + scenes) + more + "}";
  }
  std::string file() const { return glb(json(), binary); }
};

}  // namespace girth::io::testing
