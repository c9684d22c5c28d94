// Compressed glTF: what the encoders of Draco and meshoptimizer write is read again, and what is
// not theirs, or claims too much, is refused.
#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#include <meshoptimizer.h>

#include <array>
#include <cmath>

#include "documents.h"

namespace girth::io::testing {
namespace {

struct Grid {
  std::vector<float> positions;
  std::vector<std::uint32_t> triangles;
};

/// A bumpy square of size × size vertices.
Grid gridOf(int size) {
  Grid grid;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const float u = static_cast<float>(x), v = static_cast<float>(y);
      grid.positions.insert(grid.positions.end(), {u, v, std::sin(u) * std::cos(v)});
    }
  }
  for (int y = 0; y + 1 < size; ++y) {
    for (int x = 0; x + 1 < size; ++x) {
      const auto at = static_cast<std::uint32_t>(y * size + x);
      const auto above = at + static_cast<std::uint32_t>(size);
      grid.triangles.insert(grid.triangles.end(), {at, at + 1, above + 1, at, above + 1, above});
    }
  }
  return grid;
}

template <class T>
std::string bytesOfNumbers(const std::vector<T>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(T)};
}

/// A document with buffer views of packed bytes, all in the binary chunk.
struct PackedGltf : TinyGltf {
  PackedGltf() {
    binary.clear();
    views.clear();
    accessors.clear();
  }
  void addView(const std::string& bytes, const std::string& packing, std::size_t unpacked) {
    while (binary.size() % 4 != 0) binary += '\0';
    if (!views.empty()) views += ",";
    views += R"({"buffer":1,"byteLength":)" + std::to_string(unpacked) + R"(,"extensions":{")" +
             extension + R"(":{"buffer":0,"byteOffset":)" + std::to_string(binary.size()) +
             R"(,"byteLength":)" + std::to_string(bytes.size()) + "," + packing + "}}}";
    binary += bytes;
  }
  /// The buffer that the unpacked bytes would be in has none.
  std::string packedFile() const {
    std::string text = json();
    const std::size_t end = text.find(R"(],"bufferViews")");
    text.insert(end, R"(,{"byteLength":1000000})");
    return glb(text, binary);
  }
  std::string extension = "EXT_meshopt_compression";
};

std::string encodedVertices(const void* vertices, std::size_t count, std::size_t size) {
  std::string bytes(meshopt_encodeVertexBufferBound(count, size), '\0');
  bytes.resize(meshopt_encodeVertexBuffer(reinterpret_cast<unsigned char*>(bytes.data()),
                                          bytes.size(), vertices, count, size));
  return bytes;
}

std::string encodedTriangles(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
  meshopt_encodeIndexVersion(1);
  std::string bytes(meshopt_encodeIndexBufferBound(indices.size(), vertices), '\0');
  bytes.resize(meshopt_encodeIndexBuffer(reinterpret_cast<unsigned char*>(bytes.data()),
                                         bytes.size(), indices.data(), indices.size()));
  return bytes;
}

std::string encodedSequence(const std::vector<std::uint32_t>& indices, std::size_t vertices) {
  meshopt_encodeIndexVersion(1);
  std::string bytes(meshopt_encodeIndexSequenceBound(indices.size(), vertices), '\0');
  bytes.resize(meshopt_encodeIndexSequence(reinterpret_cast<unsigned char*>(bytes.data()),
                                           bytes.size(), indices.data(), indices.size()));
  return bytes;
}

std::string members(std::size_t stride, std::size_t count, const std::string& mode,
                    const std::string& filter = {}) {
  return R"("byteStride":)" + std::to_string(stride) + R"(,"count":)" + std::to_string(count) +
         R"(,"mode":")" + mode + "\"" + (filter.empty() ? "" : R"(,"filter":")" + filter + "\"");
}

std::string accessorsOf(std::size_t vertices, std::size_t indices, int indexType = 5125) {
  return R"({"bufferView":0,"componentType":5126,"count":)" + std::to_string(vertices) +
         R"(,"type":"VEC3"},{"bufferView":1,"componentType":)" + std::to_string(indexType) +
         R"(,"count":)" + std::to_string(indices) + R"(,"type":"SCALAR"})";
}

void expectGrid(const Result<TriangleSoup>& soup, const Grid& grid, double tolerance = 0) {
  ASSERT_TRUE(soup.ok()) << messageOf(soup);
  ASSERT_EQ(soup.value().positions.size(), grid.positions.size());
  for (std::size_t i = 0; i < grid.positions.size(); ++i) {
    ASSERT_NEAR(soup.value().positions[i], grid.positions[i], tolerance) << i;
  }
  EXPECT_EQ(soup.value().triangles, grid.triangles);
}

/// The codec of triangles turns them so that they begin at another corner; what is to be expected
/// is what the library itself decodes.
Grid decodedOnce(Grid grid) {
  const std::string bytes = encodedTriangles(grid.triangles, grid.positions.size() / 3);
  meshopt_decodeIndexBuffer(grid.triangles.data(), grid.triangles.size(), 4,
                            reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  return grid;
}

PackedGltf meshoptGrid(const Grid& grid) {
  const std::size_t vertices = grid.positions.size() / 3, indices = grid.triangles.size();
  PackedGltf packed;
  packed.addView(encodedVertices(grid.positions.data(), vertices, 12),
                 members(12, vertices, "ATTRIBUTES"), 12 * vertices);
  packed.addView(encodedTriangles(grid.triangles, vertices), members(4, indices, "TRIANGLES"),
                 4 * indices);
  packed.accessors = accessorsOf(vertices, indices);
  return packed;
}

TEST(Meshopt, attributesAndTriangles) {
  const Grid grid = gridOf(40);
  for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    PackedGltf packed;
    packed.extension = extension;
    const std::size_t vertices = grid.positions.size() / 3, indices = grid.triangles.size();
    packed.addView(encodedVertices(grid.positions.data(), vertices, 12),
                   members(12, vertices, "ATTRIBUTES"), 12 * vertices);
    packed.addView(encodedTriangles(grid.triangles, vertices), members(4, indices, "TRIANGLES"),
                   4 * indices);
    packed.accessors = accessorsOf(vertices, indices);
    packed.more = R"(,"extensionsRequired":[")" + std::string(extension) + "\"]";
    expectGrid(soupOf(packed.packedFile(), "grid.glb"), decodedOnce(grid));
  }
}

TEST(Meshopt, sequencesAndShortIndices) {
  const Grid grid = gridOf(12);
  const std::size_t vertices = grid.positions.size() / 3, indices = grid.triangles.size();
  for (const std::size_t size : {std::size_t{2}, std::size_t{4}}) {
    PackedGltf packed;
    packed.addView(encodedVertices(grid.positions.data(), vertices, 12),
                   members(12, vertices, "ATTRIBUTES"), 12 * vertices);
    packed.addView(encodedSequence(grid.triangles, vertices), members(size, indices, "INDICES"),
                   size * indices);
    packed.accessors = accessorsOf(vertices, indices, size == 2 ? 5123 : 5125);
    expectGrid(soupOf(packed.packedFile(), "grid.glb"), grid);
  }
}

TEST(Meshopt, exponentialFilter) {
  const Grid grid = gridOf(12);
  const std::size_t vertices = grid.positions.size() / 3, indices = grid.triangles.size();
  std::vector<std::uint32_t> filtered(3 * vertices);
  meshopt_encodeFilterExp(filtered.data(), vertices, 12, 20, grid.positions.data());
  PackedGltf packed;
  packed.addView(encodedVertices(filtered.data(), vertices, 12),
                 members(12, vertices, "ATTRIBUTES", "EXPONENTIAL"), 12 * vertices);
  packed.addView(encodedSequence(grid.triangles, vertices), members(4, indices, "INDICES"),
                 4 * indices);
  packed.accessors = accessorsOf(vertices, indices);
  expectGrid(soupOf(packed.packedFile(), "grid.glb"), grid, 1e-4);
}

TEST(Meshopt, quaternionFilterOfInstances) {
  Grid grid = gridOf(2);
  const std::array<float, 8> turns{0, 0, 0, 1, 0, 0, std::sqrt(.5f), std::sqrt(.5f)};
  std::array<std::int16_t, 8> filtered{};
  meshopt_encodeFilterQuat(filtered.data(), 2, 8, 16, turns.data());
  PackedGltf packed = meshoptGrid(grid);
  packed.addView(encodedVertices(filtered.data(), 2, 8), members(8, 2, "ATTRIBUTES", "QUATERNION"),
                 16);
  packed.accessors +=
      R"(,{"bufferView":2,"componentType":5122,"normalized":true,"count":2,"type":"VEC4"})";
  packed.nodes =
      R"({"mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"ROTATION":2}}}})";
  const auto soup = soupOf(packed.packedFile(), "grid.glb");
  ASSERT_TRUE(soup.ok()) << messageOf(soup);
  ASSERT_EQ(soup.value().positions.size(), 24u);
  EXPECT_NEAR(soup.value().positions[3], 1, 1e-3);
  EXPECT_NEAR(soup.value().positions[16], 1, 1e-3) << "turned from x to y";
}

/// The simplest encoder of the second version of vertex streams: for each byte of the vertices one
/// way of storing differences, for each four bytes one way of making them.
class SecondVersion {
 public:
  SecondVersion(const std::vector<std::uint8_t>& vertices, std::size_t stride)
      : vertices_(vertices), stride_(stride), count_(vertices.size() / stride) {}

  /// `controls`: 0 to 3 per byte; `modes`: the header of all groups, for controls 0 and 1;
  /// `channels`: per four bytes.
  std::string encode(const std::vector<int>& controls, int mode, const std::vector<int>& channels) {
    std::string bytes = "\xA1";
    const std::size_t block = std::min<std::size_t>(8192 / stride_ / 16 * 16, 256);
    for (std::size_t first = 0; first < count_; first += block) {
      const std::size_t size = std::min(block, count_ - first);
      for (std::size_t four = 0; four < stride_ / 4; ++four) {
        int packed = 0;
        for (std::size_t k = 0; k < 4; ++k) packed |= controls[4 * four + k] << (2 * k);
        bytes += static_cast<char>(packed);
      }
      for (std::size_t byte = 0; byte < stride_; ++byte) {
        std::vector<std::uint8_t> deltas;
        for (std::size_t v = first; v < first + size; ++v) {
          deltas.push_back(delta(v, byte, channels[byte / 4]));
        }
        append(bytes, deltas, controls[byte], mode);
      }
    }
    std::string tail(vertices_.begin(), vertices_.begin() + static_cast<std::ptrdiff_t>(stride_));
    for (const int channel : channels) tail += static_cast<char>(channel);
    if (tail.size() < 24) bytes += std::string(24 - tail.size(), '\0');
    return bytes + tail;
  }

 private:
  std::uint32_t word(std::size_t vertex, std::size_t four) const {
    std::uint32_t value = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      value |= std::uint32_t{vertices_[vertex * stride_ + four + k]} << (8 * k);
    }
    return value;
  }
  static std::uint32_t zigzag(std::uint32_t value, unsigned bits) {
    const bool negative = (value >> (bits - 1) & 1u) != 0;
    const std::uint32_t mask = (1u << bits) - 1;
    return ((value << 1) ^ (negative ? mask : 0u)) & mask;
  }
  std::uint8_t delta(std::size_t vertex, std::size_t byte, int channel) const {
    const std::size_t four = byte / 4 * 4;
    const std::uint32_t now = word(vertex, four), before = word(vertex == 0 ? 0 : vertex - 1, four);
    const std::size_t k = byte - four;
    std::uint32_t delta = 0;
    if ((channel & 3) == 0) {
      delta = zigzag(((now >> (8 * k)) - (before >> (8 * k))) & 0xFF, 8) << (8 * k);
    } else if ((channel & 3) == 1) {
      const std::size_t half = k / 2 * 16;
      delta = zigzag(((now >> half) - (before >> half)) & 0xFFFF, 16) << half;
    } else {
      const unsigned turn = static_cast<unsigned>(channel) >> 4;
      const std::uint32_t changed = now ^ before;
      delta = turn == 0 ? changed : changed << turn | changed >> (32 - turn);
    }
    return static_cast<std::uint8_t>(delta >> (8 * k));
  }
  static void append(std::string& bytes, const std::vector<std::uint8_t>& deltas, int control,
                     int mode) {
    if (control == 2) return;
    if (control == 3) {
      bytes.append(deltas.begin(), deltas.end());
      return;
    }
    const std::size_t groups = (deltas.size() + 15) / 16;
    std::string header((groups + 3) / 4, '\0');
    for (std::size_t g = 0; g < groups; ++g) {
      header[g / 4] = static_cast<char>(header[g / 4] | mode << (g % 4 * 2));
    }
    bytes += header;
    const unsigned bits = std::array<std::array<unsigned, 4>, 2>{
        {{0, 1, 2, 4},
         {1, 2, 4, 8}}}[static_cast<std::size_t>(control)][static_cast<std::size_t>(mode)];
    for (std::size_t g = 0; g < groups; ++g) {
      std::string coded(2 * bits, '\0'), whole;
      for (std::size_t i = 0; i < 16; ++i) {
        const unsigned value = 16 * g + i < deltas.size() ? deltas[16 * g + i] : 0;
        const unsigned mask = (1u << bits) - 1;
        if (bits == 0) continue;
        const unsigned stored = bits == 8 ? value : std::min(value, mask);
        const std::size_t perByte = 8 / bits;
        const std::size_t shift = bits == 1 ? i % perByte : 8 - bits * (i % perByte + 1);
        coded[i / perByte] = static_cast<char>(coded[i / perByte] | stored << shift);
        if (bits < 8 && value >= mask) whole += static_cast<char>(value);
      }
      bytes += coded + whole;
    }
  }

  const std::vector<std::uint8_t>& vertices_;
  std::size_t stride_;
  std::size_t count_;
};

TEST(Meshopt, secondVersionOfVertexStreams) {
  const Grid grid = gridOf(27);
  const std::size_t vertices = grid.positions.size() / 3, indices = grid.triangles.size();
  const std::string plain = bytesOfNumbers(grid.positions);
  const std::vector<std::uint8_t> content(plain.begin(), plain.end());
  SecondVersion encoder(content, 12);
  const auto expectRead = [&](const std::string& stream) {
    PackedGltf packed;
    packed.extension = "KHR_meshopt_compression";
    packed.addView(stream, members(12, vertices, "ATTRIBUTES"), 12 * vertices);
    packed.addView(encodedSequence(grid.triangles, vertices), members(4, indices, "INDICES"),
                   4 * indices);
    packed.accessors = accessorsOf(vertices, indices);
    expectGrid(soupOf(packed.packedFile(), "grid.glb"), grid);
  };
  for (const int channel : {0, 1, 2, 2 | 7 << 4, 2 | 15 << 4}) {
    const std::vector<int> channels(3, channel);
    expectRead(encoder.encode(std::vector<int>(12, 3), 0, channels));
    for (int mode = 0; mode < 4; ++mode) {
      // Where all bits are set, a whole byte follows; so every width can hold everything.
      expectRead(encoder.encode(std::vector<int>(12, 1), mode, channels));
      if (mode > 0) expectRead(encoder.encode(std::vector<int>(12, 0), mode, channels));
    }
  }
  // Bytes that never change need no bytes at all.
  std::vector<std::uint8_t> flat(12 * vertices, 0);
  for (std::size_t v = 0; v < vertices; ++v) flat[12 * v] = content[12 * v];
  std::vector<int> controls(12, 2);
  controls[0] = 3;
  PackedGltf packed;
  packed.addView(SecondVersion(flat, 12).encode(controls, 0, {0, 0, 0}),
                 members(12, vertices, "ATTRIBUTES"), 12 * vertices);
  packed.addView(encodedSequence(grid.triangles, vertices), members(4, indices, "INDICES"),
                 4 * indices);
  packed.accessors = accessorsOf(vertices, indices);
  const auto soup = soupOf(packed.packedFile(), "grid.glb");
  ASSERT_TRUE(soup.ok()) << messageOf(soup);
  EXPECT_EQ(soup.value().positions[1], 0);
}

TEST(Meshopt, badStreams) {
  const Grid grid = gridOf(6);
  const std::size_t vertices = grid.positions.size() / 3;
  const std::string plain = bytesOfNumbers(grid.positions);
  const std::vector<std::uint8_t> content(plain.begin(), plain.end());
  const std::string second =
      SecondVersion(content, 12).encode(std::vector<int>(12, 1), 2, {1, 2, 0});
  for (const std::string& stream : {encodedVertices(grid.positions.data(), vertices, 12), second}) {
    const auto codeWith = [&](const std::string& bytes, std::size_t count) {
      PackedGltf packed;
      packed.addView(bytes, members(12, count, "ATTRIBUTES"), 12 * count);
      packed.addView(encodedTriangles(grid.triangles, vertices),
                     members(4, grid.triangles.size(), "TRIANGLES"), 4 * grid.triangles.size());
      packed.accessors = accessorsOf(count, grid.triangles.size());
      return codeOf(soupOf(packed.packedFile(), "grid.glb"));
    };
    EXPECT_EQ(codeWith(stream, vertices), "OK");
    for (std::size_t length = 0; length < stream.size(); ++length) {
      ASSERT_EQ(codeWith(stream.substr(0, length), vertices), "MALFORMED_FILE") << length;
    }
    EXPECT_EQ(codeWith(stream + '\0', vertices), "MALFORMED_FILE");
    EXPECT_EQ(codeWith(stream, vertices + 100), "MALFORMED_FILE");
    EXPECT_EQ(codeWith(stream, 100000000), "MALFORMED_FILE") << "more than fits";
    for (std::size_t at = 0; at < stream.size(); ++at) {
      for (const char value : {'\0', '\x7F', '\xFF'}) {
        std::string changed = stream;
        changed[at] = value;
        ASSERT_NE(codeWith(changed, vertices), "INTERNAL") << at;
      }
    }
  }
}

TEST(Meshopt, membersThatAreNotAllowed) {
  const Grid grid = gridOf(6);
  const auto messageWith = [&](const std::string& more, std::size_t size) {
    PackedGltf packed;
    packed.addView(encodedVertices(grid.positions.data(), grid.positions.size() / 3, 12), more,
                   size);
    packed.accessors = R"({"bufferView":0,"componentType":5126,"count":36,"type":"VEC3"})";
    packed.primitives = R"({"attributes":{"POSITION":0}})";
    const auto soup = soupOf(packed.packedFile(), "grid.glb");
    EXPECT_EQ(codeOf(soup), "MALFORMED_FILE") << more;
    return messageOf(soup);
  };
  const std::string place = "/bufferViews/0/extensions/EXT_meshopt_compression";
  EXPECT_TRUE(contains(messageWith(members(12, 36, "TURNIPS"), 432), place + "/mode"));
  EXPECT_TRUE(contains(messageWith(members(12, 36, "ATTRIBUTES", "SEPIA"), 432), "/filter"));
  EXPECT_TRUE(contains(messageWith(members(10, 36, "ATTRIBUTES"), 432), "byteStride"));
  EXPECT_TRUE(contains(messageWith(members(260, 36, "ATTRIBUTES"), 432), "byteStride"));
  EXPECT_TRUE(contains(messageWith(members(12, 36, "ATTRIBUTES", "QUATERNION"), 432), "filter"));
  EXPECT_TRUE(contains(messageWith(members(12, 36, "TRIANGLES"), 432), "byteStride"));
  EXPECT_TRUE(contains(messageWith(members(4, 37, "TRIANGLES"), 432), "triangles"));
  EXPECT_TRUE(contains(messageWith(members(12, 0, "ATTRIBUTES"), 432), "count of 0"));
  EXPECT_TRUE(
      contains(messageWith(members(12, 36, "ATTRIBUTES"), 1000), "/bufferViews/0/byteLength"));
}

TEST(Meshopt, unpackedIndicesAreChecked) {
  Grid grid = gridOf(6);
  grid.triangles[5] = 36;
  PackedGltf packed = meshoptGrid(grid);
  EXPECT_EQ(codeOf(soupOf(packed.packedFile(), "grid.glb")), "INDEX_OUT_OF_RANGE");
}

/// The grid as a mesh of Draco's.
std::unique_ptr<draco::Mesh> builtGrid(const Grid& grid) {
  auto mesh = std::make_unique<draco::Mesh>();
  const std::size_t vertices = grid.positions.size() / 3;
  mesh->set_num_points(static_cast<std::uint32_t>(vertices));
  draco::GeometryAttribute kind;
  kind.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false, 12, 0);
  const int id = mesh->AddAttribute(kind, true, static_cast<std::uint32_t>(vertices));
  for (std::uint32_t v = 0; v < vertices; ++v) {
    mesh->attribute(id)->SetAttributeValue(draco::AttributeValueIndex(v),
                                           grid.positions.data() + std::size_t{3} * v);
  }
  for (std::size_t t = 0; t < grid.triangles.size(); t += 3) {
    mesh->AddFace({draco::PointIndex(grid.triangles[t]), draco::PointIndex(grid.triangles[t + 1]),
                   draco::PointIndex(grid.triangles[t + 2])});
  }
  return mesh;
}

std::string dracoBytes(const Grid& grid, int method, int bits) {
  const auto mesh = builtGrid(grid);
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  if (bits > 0) encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
  return {buffer.data(), buffer.size()};
}

/// `points` and `corners`: what the accessors say.
TinyGltf dracoGltf(const std::string& stream, std::size_t points, std::size_t corners) {
  TinyGltf tiny;
  tiny.binary = stream;
  tiny.views = R"({"buffer":0,"byteLength":)" + std::to_string(stream.size()) + "}";
  tiny.accessors = R"({"componentType":5126,"count":)" + std::to_string(points) +
                   R"(,"type":"VEC3"},{"componentType":5125,"count":)" + std::to_string(corners) +
                   R"(,"type":"SCALAR"})";
  tiny.primitives =
      R"({"attributes":{"POSITION":0},"indices":1,"extensions":)"
      R"({"KHR_draco_mesh_compression":{"bufferView":0,"attributes":{"POSITION":0}}}})";
  tiny.more = R"(,"extensionsRequired":["KHR_draco_mesh_compression"])";
  return tiny;
}

double areaOf(const std::vector<double>& positions, const std::vector<Index>& triangles) {
  double area = 0;
  for (std::size_t t = 0; t + 2 < triangles.size(); t += 3) {
    const double* a = positions.data() + std::size_t{3} * triangles[t];
    const double* b = positions.data() + std::size_t{3} * triangles[t + 1];
    const double* c = positions.data() + std::size_t{3} * triangles[t + 2];
    const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const double v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    area += std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                       u[0] * v[1] - u[1] * v[0]) /
            2;
  }
  return area;
}

TEST(Draco, bothMethods) {
  const Grid grid = gridOf(30);
  const double area = areaOf({grid.positions.begin(), grid.positions.end()}, grid.triangles);
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    for (const int bits : {0, 14}) {
      const std::string stream = dracoBytes(grid, method, bits);
      const auto soup = soupOf(dracoGltf(stream, 900, grid.triangles.size()).file(), "grid.glb");
      ASSERT_TRUE(soup.ok()) << messageOf(soup);
      EXPECT_EQ(soup.value().positions.size(), 2700u);
      EXPECT_NEAR(areaOf(soup.value().positions, soup.value().triangles), area,
                  bits == 0 ? 1e-9 : 0.2);
      if (method == draco::MESH_SEQUENTIAL_ENCODING && bits == 0) expectGrid(soup, grid);
    }
  }
}

TEST(Draco, sharedStreamsAndStrips) {
  const Grid grid = gridOf(8);
  TinyGltf tiny =
      dracoGltf(dracoBytes(grid, draco::MESH_EDGEBREAKER_ENCODING, 12), 64, grid.triangles.size());
  // Draco holds triangles, whatever the primitive would be without it.
  std::string strip = tiny.primitives;
  strip.insert(1, R"("mode":5,)");
  tiny.primitives += "," + strip;
  const auto soup = soupOf(tiny.file(), "grid.glb");
  ASSERT_TRUE(soup.ok()) << messageOf(soup);
  EXPECT_EQ(soup.value().positions.size(), 192u) << "points of one stream are there once";
  EXPECT_EQ(soup.value().triangles.size(), 2 * grid.triangles.size());
}

TEST(Draco, attributesOfPoints) {
  const Grid grid = gridOf(8);
  const auto mesh = builtGrid(grid);
  draco::GeometryAttribute kind;
  kind.Init(draco::GeometryAttribute::COLOR, nullptr, 3, draco::DT_UINT8, true, 3, 0);
  const int id = mesh->AddAttribute(kind, true, 64);
  for (std::uint32_t v = 0; v < 64; ++v) {
    const std::uint8_t colour[3] = {static_cast<std::uint8_t>(4 * v), 255, 51};
    mesh->attribute(id)->SetAttributeValue(draco::AttributeValueIndex(v), colour);
  }
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    draco::Encoder encoder;
    encoder.SetEncodingMethod(method);
    draco::EncoderBuffer buffer;
    ASSERT_TRUE(encoder.EncodeMeshToBuffer(*mesh, &buffer).ok());
    TinyGltf tiny = dracoGltf({buffer.data(), buffer.size()}, 64, grid.triangles.size());
    tiny.accessors += R"(,{"componentType":5121,"normalized":true,"count":64,"type":"VEC3"})";
    const auto write = [&](const std::string& number) {
      tiny.primitives = R"({"attributes":{"POSITION":0,"COLOR_0":2},"indices":1,"extensions":)"
                        R"({"KHR_draco_mesh_compression":{"bufferView":0,)"
                        R"("attributes":{"POSITION":0,"COLOR_0":)" +
                        number + "}}}}";
      return readModel(bytesOf(tiny.file()), "grid.glb", {}, {true});
    };
    const auto model = write(std::to_string(mesh->attribute(id)->unique_id()));
    ASSERT_TRUE(model.ok()) << messageOf(model);
    ASSERT_EQ(model.value().attributes.size(), 1u);
    const Attribute& colours = model.value().attributes[0];
    // Points may have another order; what stands where tells them apart.
    const TriangleSoup& soup = model.value().soup;
    for (std::size_t c = 0; c < soup.triangles.size(); ++c) {
      const double* place = soup.positions.data() + std::size_t{3} * soup.triangles[c];
      std::size_t v = 0;
      while (v < 64 && (double{grid.positions[3 * v]} != place[0] ||
                        double{grid.positions[3 * v + 1]} != place[1])) {
        ++v;
      }
      ASSERT_LT(v, 64u);
      const double* colour = colours.values.data() + std::size_t{3} * colours.corners[c];
      EXPECT_EQ(colour[0], 4.0 * static_cast<double>(v) / 255);
      EXPECT_EQ(colour[1], 1);
      EXPECT_EQ(colour[2], 0.2);
    }
    // The surface is read without it.
    const auto other = write("77");
    ASSERT_TRUE(other.ok()) << messageOf(other);
    EXPECT_TRUE(other.value().attributes.empty());
    ASSERT_EQ(other.value().attributeNotes.size(), 1u);
    EXPECT_TRUE(contains(other.value().attributeNotes[0], "its Draco stream has no attribute 77"));
  }
}

TEST(Draco, countsHaveToAgree) {
  const Grid grid = gridOf(8);
  const std::string stream = dracoBytes(grid, draco::MESH_EDGEBREAKER_ENCODING, 12);
  const auto points = soupOf(dracoGltf(stream, 65, grid.triangles.size()).file(), "grid.glb");
  EXPECT_EQ(messageOf(points), "/accessors/0/count: is 65, but its Draco stream holds 64");
  const auto corners = soupOf(dracoGltf(stream, 64, 3).file(), "grid.glb");
  EXPECT_TRUE(contains(messageOf(corners), "/accessors/1/count: is 3")) << messageOf(corners);
  TinyGltf other = dracoGltf(stream, 64, grid.triangles.size());
  other.primitives.replace(other.primitives.rfind(R"("POSITION":0)"), 12, R"("POSITION":5)");
  const auto attribute = soupOf(other.file(), "grid.glb");
  EXPECT_TRUE(contains(messageOf(attribute), "no attribute 5")) << messageOf(attribute);
}

TEST(Draco, badStreams) {
  const Grid grid = gridOf(6);
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    const std::string stream = dracoBytes(grid, method, 10);
    const auto codeWith = [&](const std::string& bytes) {
      return codeOf(soupOf(dracoGltf(bytes, 36, grid.triangles.size()).file(), "grid.glb"));
    };
    EXPECT_EQ(codeWith(stream), "OK");
    for (std::size_t length = 1; length < stream.size(); ++length) {
      ASSERT_NE(codeWith(stream.substr(0, length)), "OK") << length;
    }
    for (std::size_t at = 0; at < stream.size(); ++at) {
      for (const char value : {'\0', '\x7F', '\xFF', '\x80'}) {
        std::string changed = stream;
        changed[at] = value;
        ASSERT_NE(codeWith(changed), "INTERNAL") << at;
      }
    }
    std::string old = stream;
    old[6] = 1;
    EXPECT_EQ(codeWith(old), "UNSUPPORTED_FEATURE") << "bitstream 2.1";
  }
}

TEST(Draco, claimsAreCheckedBeforeMemoryIsAskedFor) {
  // Edgebreaker: 2 billion faces in 40 bytes.
  const std::string start = std::string("DRACO\2\2\1\1\0\0\0", 12);
  const std::string billions = "\xFF\xFF\xFF\xFF\7";
  const std::string stream = start + "\3" + billions + std::string(1, '\0') + "\1" +
                             std::string(1, '\0') + std::string(20, '\0');
  const auto soup = soupOf(dracoGltf(stream, 3, 3).file(), "grid.glb");
  EXPECT_EQ(codeOf(soup), "LIMIT_EXCEEDED") << messageOf(soup);
  EXPECT_TRUE(contains(messageOf(soup), "2147483647 faces")) << messageOf(soup);
}

}  // namespace
}  // namespace girth::io::testing
