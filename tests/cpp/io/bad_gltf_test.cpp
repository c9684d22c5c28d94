// Files that the glTF reader refuses, and how it says so.
#include "documents.h"

namespace girth::io::testing {
namespace {

std::string codeOfFile(const TinyGltf& tiny) { return codeOf(read(tiny.file(), "tiny.glb")); }

TEST(BadGltf, truncatedAtEveryByte) {
  const std::string whole = TinyGltf().file();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const auto result = read(whole.substr(0, length), "tiny.glb");
    ASSERT_EQ(codeOf(result), length == 0 ? "EMPTY_FILE" : "MALFORMED_FILE") << length;
    ASSERT_FALSE(messageOf(result).empty());
  }
}

TEST(BadGltf, everyByteChanged) {
  const std::string whole = TinyGltf().file();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const char value : {'\0', '\x7F', '\xFF', '9', '{', '"'}) {
      std::string changed = whole;
      changed[at] = value;
      const auto result = read(changed, "tiny.glb");
      if (!result) {
        ASSERT_FALSE(result.error().message.empty());
        ASSERT_NE(codeOf(result), "INTERNAL") << at;
      }
    }
  }
}

TEST(BadGltf, textNamedGlb) {
  const auto result = read("Dear reader,\nthis is no model.\n", "letter.glb");
  EXPECT_EQ(codeOf(result), "UNKNOWN_FORMAT");
  EXPECT_TRUE(contains(messageOf(result), ".glb")) << messageOf(result);
}

TEST(BadGltf, jsonThatIsNotGltf) {
  EXPECT_EQ(codeOf(read(R"({"name":"package"})", "package.json")), "UNKNOWN_FORMAT");
  EXPECT_EQ(codeOf(read(R"({"asset":)", "broken.gltf")), "MALFORMED_FILE");
  EXPECT_EQ(codeOf(read(R"({"asset":{"version":"2.0"}} trailing)", "broken.gltf")),
            "MALFORMED_FILE");
  EXPECT_EQ(codeOf(read(R"({"asset":{"version":"2.0"}})", "empty.gltf")), "EMPTY_MESH");
}

TEST(BadGltf, deepNesting) {
  const std::string deep = R"({"asset":{"version":"2.0"},"extras":)" + std::string(40000, '[') +
                           std::string(40000, ']') + "}";
  EXPECT_EQ(codeOf(read(deep, "deep.gltf")), "LIMIT_EXCEEDED");
  EXPECT_EQ(codeOf(read(std::string(40000, '{'), "deep.gltf")), "LIMIT_EXCEEDED");
  // Brackets inside strings are not nesting.
  TinyGltf tiny;
  tiny.more = R"(,"extras":"\")" + std::string(500, '[') + "\"";
  EXPECT_EQ(codeOfFile(tiny), "OK");
}

TEST(BadGltf, otherVersions) {
  EXPECT_EQ(codeOf(read(R"({"asset":{"version":"1.0"},"meshes":{}})", "old.gltf")),
            "UNSUPPORTED_FEATURE");
  EXPECT_EQ(codeOf(read(R"({"asset":{},"meshes":{"a":{}}})", "old.gltf")), "UNSUPPORTED_FEATURE");
  std::string old = TinyGltf().file();
  old[4] = 1;
  EXPECT_EQ(codeOf(read(old, "old.glb")), "UNSUPPORTED_FEATURE");
}

TEST(BadGltf, unknownRequiredExtensionsAreNamed) {
  TinyGltf tiny;
  tiny.more = R"(,"extensionsRequired":["KHR_materials_unlit","ACME_implicit_surface"])";
  const auto result = read(tiny.file(), "tiny.glb");
  EXPECT_EQ(codeOf(result), "UNSUPPORTED_FEATURE");
  EXPECT_TRUE(contains(messageOf(result), "\"ACME_implicit_surface\"")) << messageOf(result);
}

TEST(BadGltf, pointsAndLinesOnly) {
  TinyGltf tiny;
  tiny.primitives =
      R"({"attributes":{"POSITION":0},"mode":0},{"attributes":{"POSITION":0},"mode":1})";
  const auto result = read(tiny.file(), "tiny.glb");
  EXPECT_EQ(codeOf(result), "EMPTY_MESH");
  EXPECT_TRUE(contains(messageOf(result), "only points and lines")) << messageOf(result);
}

TEST(BadGltf, nodeCycles) {
  TinyGltf tiny;
  tiny.nodes = R"({"mesh":0,"children":[1]},{"children":[0]})";
  EXPECT_EQ(codeOfFile(tiny), "MALFORMED_FILE");
  tiny.scenes = "";
  EXPECT_EQ(codeOfFile(tiny), "MALFORMED_FILE");
  tiny = TinyGltf();
  tiny.nodes = R"({"mesh":0,"children":[0]})";
  EXPECT_EQ(codeOfFile(tiny), "MALFORMED_FILE");
}

TEST(BadGltf, longChainsOfNodes) {
  TinyGltf tiny;
  tiny.nodes = "";
  constexpr int kLength = 20000;
  for (int i = 0; i < kLength; ++i)
    tiny.nodes += R"({"children":[)" + std::to_string(i + 1) + "]},";
  tiny.nodes += R"({"mesh":0})";
  EXPECT_EQ(codeOfFile(tiny), "OK");
}

TEST(BadGltf, missingElements) {
  const auto with = [](auto change) {
    TinyGltf tiny;
    change(tiny);
    return codeOfFile(tiny);
  };
  EXPECT_EQ(with([](TinyGltf& t) { t.nodes = R"({"mesh":1})"; }), "MALFORMED_FILE");
  EXPECT_EQ(with([](TinyGltf& t) { t.nodes = R"({"mesh":4294967296})"; }), "MALFORMED_FILE");
  EXPECT_EQ(with([](TinyGltf& t) { t.nodes = R"({"mesh":0,"children":[1]})"; }), "MALFORMED_FILE");
  EXPECT_EQ(with([](TinyGltf& t) { t.nodes = R"({"mesh":0,"children":[-1]})"; }), "MALFORMED_FILE");
  EXPECT_EQ(with([](TinyGltf& t) { t.nodes = R"({"mesh":0,"scale":[1,2]})"; }), "MALFORMED_FILE");
  EXPECT_EQ(with([](TinyGltf& t) { t.scenes = R"("scene":3,"scenes":[{"nodes":[0]}])"; }),
            "MALFORMED_FILE");
  EXPECT_EQ(with([](TinyGltf& t) { t.primitives = R"({"attributes":{"POSITION":5}})"; }),
            "MALFORMED_FILE");
  EXPECT_EQ(
      with([](TinyGltf& t) { t.primitives = R"({"attributes":{"POSITION":0},"indices":9})"; }),
      "MALFORMED_FILE");
  EXPECT_EQ(with([](TinyGltf& t) { t.primitives = R"({"attributes":{"POSITION":0},"mode":9})"; }),
            "MALFORMED_FILE");
  EXPECT_EQ(with([](TinyGltf& t) { t.primitives = R"({"indices":1})"; }), "MALFORMED_FILE");
  EXPECT_EQ(with([](TinyGltf& t) { t.primitives = "7"; }), "MALFORMED_FILE");
  EXPECT_EQ(with([](TinyGltf& t) { t.views = R"({"buffer":1,"byteLength":48})"; }),
            "MALFORMED_FILE");
}

TEST(BadGltf, accessorsThatReachTooFar) {
  const auto withPositions = [](const std::string& accessor, const std::string& view = {}) {
    TinyGltf tiny;
    tiny.accessors =
        accessor + R"(,{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"})";
    if (!view.empty()) tiny.views = view + R"(,{"buffer":0,"byteOffset":48,"byteLength":24})";
    return codeOfFile(tiny);
  };
  const std::string plain = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})";
  EXPECT_EQ(withPositions(plain), "OK");
  EXPECT_EQ(withPositions(R"({"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"})"),
            "MALFORMED_FILE");
  EXPECT_EQ(withPositions(R"({"bufferView":0,"componentType":5126,"count":0,"type":"VEC3"})"),
            "MALFORMED_FILE");
  EXPECT_EQ(
      withPositions(R"({"bufferView":0,"componentType":5126,"count":2147483647,"type":"VEC3"})"),
      "MALFORMED_FILE");
  EXPECT_EQ(
      withPositions(
          R"({"bufferView":0,"componentType":5126,"count":18446744073709551615,"type":"VEC3"})"),
      "MALFORMED_FILE");
  EXPECT_EQ(withPositions(
                R"({"bufferView":0,"byteOffset":4,"componentType":5126,"count":4,"type":"VEC3"})"),
            "MALFORMED_FILE");
  EXPECT_EQ(
      withPositions(
          R"({"bufferView":0,"byteOffset":2147483647,"componentType":5126,"count":4,"type":"VEC3"})"),
      "MALFORMED_FILE");
  EXPECT_EQ(withPositions(R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC2"})"),
            "MALFORMED_FILE");
  EXPECT_EQ(withPositions(R"({"bufferView":0,"componentType":5127,"count":4,"type":"VEC3"})"),
            "MALFORMED_FILE");
  EXPECT_EQ(withPositions(R"({"componentType":5126,"count":900000000,"type":"VEC3"})"),
            "LIMIT_EXCEEDED");
  EXPECT_EQ(withPositions(plain, R"({"buffer":0,"byteLength":48,"byteStride":8})"),
            "MALFORMED_FILE");
  EXPECT_EQ(withPositions(plain, R"({"buffer":0,"byteOffset":40,"byteLength":48})"),
            "MALFORMED_FILE");
  EXPECT_EQ(withPositions(plain, R"({"buffer":0,"byteOffset":2147483647,"byteLength":2147483647})"),
            "MALFORMED_FILE");
}

TEST(BadGltf, sparsePartsThatReachTooFar) {
  const auto withSparse = [](const std::string& sparse) {
    TinyGltf tiny;
    tiny.binary += packed({9, 0, 0, 0}, 1);
    tiny.views += R"(,{"buffer":0,"byteOffset":72,"byteLength":4})";
    tiny.accessors = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":)" +
                     sparse +
                     R"(},{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"})";
    return codeOfFile(tiny);
  };
  const std::string values = R"("values":{"bufferView":0}})";
  EXPECT_EQ(withSparse(R"({"count":1,"indices":{"bufferView":2,"componentType":5121},)" + values),
            "MALFORMED_FILE")
      << "element 9 of 4";
  EXPECT_EQ(withSparse(R"({"count":5,"indices":{"bufferView":2,"componentType":5121},)" + values),
            "MALFORMED_FILE");
  EXPECT_EQ(withSparse(R"({"count":-1,"indices":{"bufferView":2,"componentType":5121},)" + values),
            "MALFORMED_FILE");
  EXPECT_EQ(withSparse(R"({"count":1,"indices":{"bufferView":2,"componentType":5126},)" + values),
            "MALFORMED_FILE");
  EXPECT_EQ(withSparse(R"({"count":1,"indices":{"bufferView":-2,"componentType":5121},)" + values),
            "MALFORMED_FILE");
  EXPECT_EQ(withSparse("{}"), "MALFORMED_FILE");
  EXPECT_EQ(withSparse("3"), "MALFORMED_FILE");
}

TEST(BadGltf, indexOutOfRange) {
  TinyGltf tiny;
  tiny.binary[48] = 4;
  const auto result = read(tiny.file(), "tiny.glb");
  EXPECT_EQ(codeOf(result), "INDEX_OUT_OF_RANGE");
  EXPECT_TRUE(contains(messageOf(result), "vertex 4 of 4")) << messageOf(result);
  EXPECT_TRUE(contains(messageOf(result), "\"tiny\"")) << messageOf(result);
}

TEST(BadGltf, notFinite) {
  TinyGltf tiny;
  tiny.binary.replace(12, 4, packedFloats({std::numeric_limits<float>::quiet_NaN()}));
  const auto result = read(tiny.file(), "tiny.glb");
  EXPECT_EQ(codeOf(result), "NON_FINITE_POSITION");
  EXPECT_EQ(result.error().element, 1);
  tiny = TinyGltf();
  tiny.nodes = R"({"mesh":0,"scale":[1e308,1e308,1e308],"translation":[1.7e308,0,0]})";
  EXPECT_EQ(codeOfFile(tiny), "NON_FINITE_POSITION");
}

TEST(BadGltf, partOfATriangle) {
  TinyGltf tiny;
  tiny.accessors = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
                   R"({"bufferView":1,"componentType":5123,"count":11,"type":"SCALAR"})";
  EXPECT_EQ(codeOfFile(tiny), "MALFORMED_FILE");
}

TEST(BadGltf, namesThatLeadOutside) {
  bool asked = false;
  const ResourceReader resources = [&](std::string_view) {
    asked = true;
    return std::optional<std::vector<std::byte>>();
  };
  for (const char* uri :
       {"../secret.bin", "a/../../secret.bin", "/etc/passwd", "file:///etc/passwd", "C:\\\\secret",
        "http://example.org/a.bin", "..%2Fsecret.bin", "%2e%2e/secret.bin", "a\\\\..\\\\..\\\\b",
        "\\\\\\\\server\\\\share", "a%00b"}) {
    TinyGltf tiny;
    tiny.bufferUri = uri;
    EXPECT_EQ(codeOf(read(tiny.json(), "tiny.gltf", resources)), "MISSING_RESOURCE") << uri;
    EXPECT_FALSE(asked) << uri;
  }
}

TEST(BadGltf, missingFileIsNamed) {
  TinyGltf tiny;
  tiny.bufferUri = "lost.bin";
  const auto result = read(tiny.json(), "tiny.gltf");
  EXPECT_EQ(codeOf(result), "MISSING_RESOURCE");
  EXPECT_TRUE(contains(messageOf(result), "\"lost.bin\"")) << messageOf(result);
  // Too short a file is another matter.
  const auto shortFile = [](std::string_view) { return std::optional(bytesOf("abc")); };
  EXPECT_EQ(codeOf(read(tiny.json(), "tiny.gltf", shortFile)), "MALFORMED_FILE");
}

TEST(BadGltf, manyCopiesOfOneMesh) {
  // 4 vertices and 12 indices each: a file of some megabytes asks for far more than it holds only
  // where its mesh is large.
  TinyGltf tiny;
  tiny.accessors = R"({"componentType":5126,"count":200000,"type":"VEC3"},)"
                   R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"})";
  tiny.nodes = "";
  tiny.scenes = "";
  for (int i = 0; i < 1000; ++i) tiny.nodes += R"({"mesh":0},)";
  tiny.nodes += R"({"mesh":0})";
  EXPECT_EQ(codeOfFile(tiny), "LIMIT_EXCEEDED");
}

TEST(BadGltf, namesStayOnOneLine) {
  TinyGltf tiny;
  tiny.bufferUri = R"(a\nb\u001b[31m)" + std::string(500, 'x');
  const auto result = read(tiny.json(), "tiny.gltf");
  EXPECT_EQ(codeOf(result), "MISSING_RESOURCE");
  EXPECT_LT(messageOf(result).size(), 200u);
  EXPECT_FALSE(contains(messageOf(result), "\n"));
  EXPECT_FALSE(contains(messageOf(result), "\x1b"));
}

}  // namespace
}  // namespace girth::io::testing
