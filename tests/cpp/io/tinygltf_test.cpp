// Valid documents that tinygltf refuses or misreads, and what must not reach it.
#include <string>

#include "documents.h"

namespace girth::io::testing {
namespace {

void expectTetrahedron(const Result<ReadModel>& model) {
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(model.value().soup.positions,
            (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(model.value().soup.triangles.size(), 12u);
}

/// Answers from one file, and notes what was asked for.
struct OneFile {
  std::string name;
  std::string content;
  std::string asked;

  ResourceReader reader() {
    return [this](std::string_view wanted) -> std::optional<std::vector<std::byte>> {
      asked += std::string(wanted) + ";";
      if (wanted != name) return std::nullopt;
      return bytesOf(content);
    };
  }
};

/// The bytes of the tetrahedron in base64.
const std::string kBase64 =
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAA"
    "AIA/AAACAAEAAAABAAMAAAADAAIAAQACAAMA";

TEST(Tinygltf, dataOfAnyMediaType) {
  std::string urlDigits = kBase64;
  for (char& c : urlDigits) c = c == '/' ? '_' : c;
  std::string escaped;
  for (const char c : TinyGltf().binary) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(c);
    escaped += {'%', kDigits[byte / 16], kDigits[byte % 16]};
  }
  for (const std::string& uri :
       {"data:application/gltf-buffer;base64," + kBase64, "data:;base64," + kBase64,
        "data:model/x-anything;charset=none;base64," + kBase64,
        "data:application/octet-stream;base64," + urlDigits,
        // More than the document promises.
        "data:application/octet-stream;base64," + kBase64 + "AAAA", "data:," + escaped}) {
    TinyGltf tiny;
    tiny.bufferUri = uri;
    expectTetrahedron(modelOf(tiny.json(), "tiny.gltf"));
  }
  TinyGltf tiny;
  tiny.bufferUri = "data:application/octet-stream;base64,AAAA AAAA";
  const auto bad = modelOf(tiny.json(), "tiny.gltf");
  EXPECT_EQ(messageOf(bad), "/buffers/0/uri: is a data: URI that is not valid");
}

TEST(Tinygltf, filesBesideTheModel) {
  // Longer than it has to be, and with a name in which tinygltf would put a space.
  TinyGltf tiny;
  tiny.bufferUri = "a+b%2Bc.bin";
  OneFile file{"a+b+c.bin", tiny.binary + "more", ""};
  expectTetrahedron(modelOf(tiny.json(), "tiny.gltf", file.reader()));
  EXPECT_EQ(file.asked, "a+b+c.bin;");

  file.content = "short";
  const auto bad = modelOf(tiny.json(), "tiny.gltf", file.reader());
  EXPECT_EQ(messageOf(bad), "/buffers/0/byteLength: promises 72 bytes, but there are 5");

  // An empty name within tinygltf's own paths, and a folder above.
  for (const char* uri :
       {"./..//secret.bin", "..%2Fsecret.bin", "/etc/passwd", "file:///etc/passwd"}) {
    tiny.bufferUri = uri;
    OneFile none;
    EXPECT_EQ(codeOf(modelOf(tiny.json(), "tiny.gltf", none.reader())), "MISSING_RESOURCE") << uri;
    EXPECT_EQ(none.asked, "") << uri;
  }
}

TEST(Tinygltf, buffersAreFetchedWhenTheyAreNeeded) {
  TinyGltf tiny;
  tiny.bufferUri =
      R"(tiny.bin"},{"byteLength":72,"uri":"tiny.bin"},{"byteLength":9,"uri":"lost.bin)";
  tiny.views = R"({"buffer":0,"byteLength":48},{"buffer":1,"byteOffset":48,"byteLength":24},)"
               R"({"buffer":2,"byteLength":9})";
  OneFile file{"tiny.bin", tiny.binary, ""};
  expectTetrahedron(modelOf(tiny.json(), "tiny.gltf", file.reader()));
  EXPECT_EQ(file.asked, "tiny.bin;") << "once, and nothing that no triangle needs";
}

TEST(Tinygltf, buffersWithoutUri) {
  // As compressed files have them: what would be unpacked, which is nowhere.
  TinyGltf tiny;
  const std::string json = tiny.json();
  const std::size_t at = json.find("],\"bufferViews\"");
  const std::string file =
      glb(json.substr(0, at) + R"(,{"byteLength":99999})" + json.substr(at), tiny.binary);
  expectTetrahedron(modelOf(file, "tiny.glb"));

  tiny.views = R"({"buffer":0,"byteLength":48},{"buffer":1,"byteOffset":48,"byteLength":24})";
  const std::string other = tiny.json();
  const std::size_t place = other.find("],\"bufferViews\"");
  const auto bad = modelOf(
      glb(other.substr(0, place) + R"(,{"byteLength":72})" + other.substr(place), tiny.binary),
      "tiny.glb");
  EXPECT_EQ(messageOf(bad), "/buffers/1: has no uri, and so no bytes")
      << "only buffer 0 is in the binary chunk";
}

TEST(Tinygltf, containersOfUnusualChunks) {
  const TinyGltf tiny;
  const std::string file = tiny.file();
  const std::size_t jsonEnd = 20 + static_cast<std::size_t>(static_cast<unsigned char>(file[12])) +
                              256 * static_cast<unsigned char>(file[13]);
  const auto withLength = [](std::string content) {
    return content.replace(8, 4, packed({static_cast<std::int64_t>(content.size())}, 4));
  };
  const std::string foreign = packed({5}, 4) + "XYZW" + "12345";
  // Before the binary chunk, which then begins at an odd byte, and after it; and padding.
  expectTetrahedron(
      modelOf(withLength(file.substr(0, jsonEnd) + foreign + file.substr(jsonEnd)), "tiny.glb"));
  expectTetrahedron(modelOf(withLength(file + foreign), "tiny.glb"));
  expectTetrahedron(modelOf(withLength(file + std::string(4, '\0')), "tiny.glb"));
  expectTetrahedron(modelOf(file + "trailing bytes", "tiny.glb"));
}

TEST(Tinygltf, chunksThatClaimMoreThanThereIs) {
  std::string file = TinyGltf().file();
  const std::size_t at = file.size() - 72 - 8;
  file.replace(at, 4, packed({80}, 4));
  const auto bad = modelOf(file, "tiny.glb");
  EXPECT_EQ(codeOf(bad), "MALFORMED_FILE");
  EXPECT_TRUE(contains(messageOf(bad), "claims 80 bytes, but 72 are left")) << messageOf(bad);
}

TEST(Tinygltf, indicesWithoutABufferView) {
  TinyGltf tiny;
  tiny.accessors = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
                   R"({"componentType":5123,"count":3,"type":"SCALAR"})";
  const auto model = modelOf(tiny.file(), "tiny.glb");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(model.value().soup.triangles, (std::vector<Index>{0, 0, 0}));
}

TEST(Tinygltf, stridesOfAnySize) {
  TinyGltf tiny;
  tiny.binary = packedFloats({0, 0, 0}) + "xx" + packedFloats({1, 0, 0}) + "xx" +
                packedFloats({0, 1, 0}) + "xx" + packedFloats({0, 0, 1}) +
                packed({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, 2);
  tiny.views = R"({"buffer":0,"byteLength":54,"byteStride":14},)"
               R"({"buffer":0,"byteOffset":54,"byteLength":24})";
  expectTetrahedron(modelOf(tiny.file(), "tiny.glb"));
}

TEST(Tinygltf, membersThatNobodyAsksFor) {
  TinyGltf tiny;
  tiny.more =
      R"(,"images":[{"uri":"../../secret.png"},{"uri":"a.png","bufferView":7},{"bufferView":99},3],)"
      R"("materials":[1],"cameras":[{}],"animations":[{"channels":[{}]}],"textures":7,)"
      R"("extensions":{"KHR_lights_punctual":{"lights":[1]}},"extras":[[[[1e300]]]])";
  OneFile file;
  expectTetrahedron(modelOf(tiny.file(), "tiny.glb", file.reader()));
  EXPECT_EQ(file.asked, "");
}

TEST(Tinygltf, numbersBeyondItsIntegers) {
  // 2^32 + 48 bytes on: not byte 48.
  TinyGltf tiny;
  tiny.accessors = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
                   R"({"bufferView":1,"byteOffset":4294967344,"componentType":5123,"count":12,)"
                   R"("type":"SCALAR"})";
  EXPECT_EQ(codeOf(modelOf(tiny.file(), "tiny.glb")), "MALFORMED_FILE");
  tiny = TinyGltf();
  tiny.primitives = R"({"attributes":{"POSITION":4294967296},"indices":1})";
  const auto bad = modelOf(tiny.file(), "tiny.glb");
  EXPECT_EQ(messageOf(bad),
            "/meshes/0/primitives/0/attributes/POSITION: is out of range: 4294967296");
}

}  // namespace
}  // namespace girth::io::testing
