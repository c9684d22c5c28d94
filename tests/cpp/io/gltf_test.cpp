// Files that the glTF reader understands.
#include <cmath>

#include "documents.h"

namespace girth::io::testing {
namespace {

/// Six times the enclosed volume; positive where the faces look outwards.
double sixfoldVolume(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const Face f : mesh.faces()) {
    const auto [a, b, c] = mesh.faceVertices(f);
    const Vec3 p = mesh.position(Vertex(a)), q = mesh.position(Vertex(b)),
               r = mesh.position(Vertex(c));
    sum += p.x * (q.y * r.z - q.z * r.y) - p.y * (q.x * r.z - q.z * r.x) +
           p.z * (q.x * r.y - q.y * r.x);
  }
  return sum;
}

void expectTetrahedron(const Result<LoadedMesh>& loaded) {
  ASSERT_TRUE(loaded.ok()) << messageOf(loaded);
  EXPECT_EQ(loaded.value().mesh.faceCount(), 4u);
  EXPECT_EQ(loaded.value().mesh.vertexCount(), 4u);
  EXPECT_DOUBLE_EQ(sixfoldVolume(loaded.value().mesh), 1.0);
}

TEST(Gltf, readsGlb) {
  const auto loaded = read(TinyGltf().file(), "tiny.glb");
  expectTetrahedron(loaded);
  EXPECT_EQ(loaded.value().format, Format::Glb);
  EXPECT_EQ(loaded.value().unit, "metre");
}

TEST(Gltf, recognisesGlbByContent) { expectTetrahedron(read(TinyGltf().file(), "tiny.obj")); }

TEST(Gltf, readsDataUri) {
  TinyGltf tiny;
  // These 72 bytes in base64.
  tiny.bufferUri =
      "data:application/"
      "octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAA"
      "AIA/AAACAAEAAAABAAMAAAADAAIAAQACAAMA";
  const auto loaded = read(tiny.json(), "tiny.gltf");
  expectTetrahedron(loaded);
  EXPECT_EQ(loaded.value().format, Format::Gltf);
}

TEST(Gltf, readsFileBesideTheModel) {
  TinyGltf tiny;
  tiny.bufferUri = "tiny%20buffer.bin";
  std::string asked;
  const ResourceReader resources = [&](std::string_view name) {
    asked = name;
    return std::optional(bytesOf(tiny.binary));
  };
  expectTetrahedron(read(tiny.json(), "tiny.gltf", resources));
  EXPECT_EQ(asked, "tiny buffer.bin");
}

TEST(Gltf, indicesOfAllSizes) {
  for (const auto& [type, size] : {std::pair{5121, 1}, {5123, 2}, {5125, 4}}) {
    TinyGltf tiny;
    tiny.binary = tiny.binary.substr(0, 48) + packed({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, size);
    tiny.views = R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":)" +
                 std::to_string(12 * size) + "}";
    tiny.accessors = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
                     R"({"bufferView":1,"componentType":)" +
                     std::to_string(type) + R"(,"count":12,"type":"SCALAR"})";
    expectTetrahedron(read(tiny.file(), "tiny.glb"));
  }
}

TEST(Gltf, quantisedPositions) {
  struct Kind {
    int type, size;
    std::int64_t one;
  };
  for (const Kind& kind :
       {Kind{5120, 1, 127}, {5121, 1, 255}, {5122, 2, 32767}, {5123, 2, 65535}}) {
    TinyGltf tiny;
    const std::int64_t o = kind.one;
    const int stride = kind.size == 1 ? 4 : 8;
    tiny.binary.clear();
    for (const auto& point :
         {std::array<std::int64_t, 3>{0, 0, 0}, {o, 0, 0}, {0, o, 0}, {0, 0, o}}) {
      tiny.binary += packed({point[0], point[1], point[2], 0}, kind.size);
    }
    tiny.binary += packed({0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, 2);
    const std::string bytes = std::to_string(4 * stride);
    tiny.views = R"({"buffer":0,"byteLength":)" + bytes + R"(,"byteStride":)" +
                 std::to_string(stride) + R"(},{"buffer":0,"byteOffset":)" + bytes +
                 R"(,"byteLength":24})";
    tiny.accessors = R"({"bufferView":0,"normalized":true,"componentType":)" +
                     std::to_string(kind.type) +
                     R"(,"count":4,"type":"VEC3"},)"
                     R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"})";
    tiny.more = R"(,"extensionsRequired":["KHR_mesh_quantization"])";
    expectTetrahedron(read(tiny.file(), "tiny.glb"));
  }
}

TEST(Gltf, sparsePositions) {
  TinyGltf tiny;
  // Without a buffer view all points are zero; the sparse part puts three of them in place.
  tiny.binary += packed({1, 2, 3, 0}, 1) + packedFloats({1, 0, 0, 0, 1, 0, 0, 0, 1});
  tiny.views += R"(,{"buffer":0,"byteOffset":72,"byteLength":3},)"
                R"({"buffer":0,"byteOffset":76,"byteLength":36})";
  tiny.accessors = R"({"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":3,)"
                   R"("indices":{"bufferView":2,"componentType":5121},"values":{"bufferView":3}}},)"
                   R"({"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"})";
  expectTetrahedron(read(tiny.file(), "tiny.glb"));
}

TEST(Gltf, stripsAndFans) {
  TinyGltf tiny;
  // A strip that turns round once, with a repeated vertex.
  tiny.binary = tiny.binary.substr(0, 48) + packed({0, 2, 1, 3, 0, 2}, 2);
  tiny.views = R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12})";
  tiny.accessors = R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
                   R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"})";
  tiny.primitives = R"({"attributes":{"POSITION":0},"indices":1,"mode":5})";
  expectTetrahedron(read(tiny.file(), "tiny.glb"));

  // A fan round vertex 0, and the face opposite as a list.
  tiny.binary = tiny.binary.substr(0, 48) + packed({0, 1, 3, 2, 1, 1, 2, 3}, 2);
  tiny.views = R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":16})";
  tiny.accessors =
      R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
      R"({"bufferView":1,"componentType":5123,"count":5,"type":"SCALAR"},)"
      R"({"bufferView":1,"byteOffset":10,"componentType":5123,"count":3,"type":"SCALAR"})";
  tiny.primitives = R"({"attributes":{"POSITION":0},"indices":1,"mode":6},)"
                    R"({"attributes":{"POSITION":0},"indices":2})";
  const auto loaded = read(tiny.file(), "tiny.glb");
  expectTetrahedron(loaded);
  EXPECT_EQ(loaded.value().vertexOfInput.size(), 4u) << "the primitives share their vertices";
}

TEST(Gltf, withoutIndices) {
  TinyGltf tiny;
  const auto corner = [](int v) {
    return packedFloats({v == 1 ? 1.f : 0.f, v == 2 ? 1.f : 0.f, v == 3 ? 1.f : 0.f});
  };
  tiny.binary.clear();
  for (const int v : {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}) tiny.binary += corner(v);
  tiny.views = R"({"buffer":0,"byteLength":144})";
  tiny.accessors = R"({"bufferView":0,"componentType":5126,"count":12,"type":"VEC3"})";
  tiny.primitives = R"({"attributes":{"POSITION":0}})";
  const auto loaded = read(tiny.file(), "tiny.glb");
  expectTetrahedron(loaded);
  EXPECT_EQ(loaded.value().report.weldedVertices, 8u);
}

TEST(Gltf, worldTransforms) {
  TinyGltf tiny;
  // Mirrored, turned by 90 degrees about z, and moved: the volume keeps its sign.
  tiny.nodes = R"({"children":[1],"translation":[10,0,0]},)"
               R"({"children":[2],"rotation":[0,0,0.7071067811865476,0.7071067811865476]},)"
               R"({"mesh":0,"matrix":[-2,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,5,1]})";
  const auto loaded = read(tiny.file(), "tiny.glb");
  ASSERT_TRUE(loaded.ok()) << messageOf(loaded);
  const SurfaceMesh& mesh = loaded.value().mesh;
  EXPECT_NEAR(sixfoldVolume(mesh), 2.0, 1e-12);
  EXPECT_NEAR(mesh.position(Vertex(0)).x, 10, 1e-12);
  EXPECT_NEAR(mesh.position(Vertex(0)).z, 5, 1e-12);
  EXPECT_NEAR(mesh.position(Vertex(1)).y, -2, 1e-12);
}

TEST(Gltf, mergesMeshesDepthFirst) {
  TinyGltf tiny;
  tiny.nodes = R"({"children":[1,2],"mesh":0},{"mesh":0,"translation":[5,0,0],"children":[3]},)"
               R"({"mesh":0,"translation":[0,5,0]},{"mesh":0,"translation":[5,0,0]})";
  const auto loaded = read(tiny.file(), "tiny.glb");
  ASSERT_TRUE(loaded.ok()) << messageOf(loaded);
  const SurfaceMesh& mesh = loaded.value().mesh;
  EXPECT_EQ(mesh.componentCount(), 4u);
  EXPECT_EQ(mesh.position(Vertex(4)).x, 5);
  EXPECT_EQ(mesh.position(Vertex(8)).x, 10);
  EXPECT_EQ(mesh.position(Vertex(12)).y, 5);
}

TEST(Gltf, choosesTheScene) {
  TinyGltf tiny;
  tiny.nodes = R"({"mesh":0},{"mesh":0,"translation":[7,0,0]})";
  tiny.scenes = R"("scene":1,"scenes":[{"nodes":[0]},{"nodes":[1]}])";
  EXPECT_EQ(read(tiny.file(), "t.glb").value().mesh.position(Vertex(0)).x, 7);
  tiny.scenes = R"("scenes":[{"nodes":[1]},{"nodes":[0]}])";
  EXPECT_EQ(read(tiny.file(), "t.glb").value().mesh.position(Vertex(0)).x, 7);
  tiny.scenes = "";
  EXPECT_EQ(read(tiny.file(), "t.glb").value().mesh.componentCount(), 2u);
}

TEST(Gltf, ignoresWhatIsNotGeometry) {
  TinyGltf tiny;
  tiny.more = R"(,"images":[{"bufferView":99}],"materials":[7],"animations":[{"channels":3}],)"
              R"("extras":{"anything":[[[]]]},"extensionsRequired":["KHR_materials_unlit"])";
  tiny.primitives += R"(,{"attributes":{"POSITION":0},"mode":0})";
  expectTetrahedron(read(tiny.file(), "tiny.glb"));
}

}  // namespace
}  // namespace girth::io::testing
