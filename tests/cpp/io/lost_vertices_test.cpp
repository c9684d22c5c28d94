// Vertices without a place that no face has: organised scans have thousands of them.
#include <limits>
#include <string>

#include "documents.h"

namespace girth::io::testing {
namespace {

/// The tetrahedron, with vertex 4 unused, which comes after its own.
void expectOneUnused(const Result<LoadedMesh>& loaded, const std::string& what) {
  ASSERT_TRUE(loaded.ok()) << what << ": " << messageOf(loaded);
  EXPECT_EQ(loaded.value().report.unreferencedVertices, 1u) << what;
  EXPECT_EQ(loaded.value().mesh.faceCount(), 4u) << what;
  ASSERT_EQ(loaded.value().vertexOfInput.size(), 5u) << what;
  EXPECT_EQ(loaded.value().vertexOfInput[4], Vertex::none) << what;
}

TEST(LostVertices, areLeftOutOfText) {
  for (const std::string lost :
       {"nan nan nan", "0 -NaN 0", "inf 0 0", "nan(ind) 0 0", "-nan(snan) 0 0", "1.#QNAN 1.#QNAN 0",
        "-1.#IND00 0 0", "0 0 1.#INF", "1e999 0 0"}) {
    std::string obj = kTetrahedronObj;
    obj.insert(obj.find("f "), "v " + lost + "\n");
    expectOneUnused(read(obj, "a.obj"), lost);
    expectOneUnused(read("OFF\n5 4 0\n" + kVertexLines + lost + "\n" + kFaceLines, "a.off"), lost);
    expectOneUnused(read("ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\n"
                         "property float y\nproperty float z\nelement face 4\n"
                         "property list uchar int vertex_indices\nend_header\n" +
                             kVertexLines + lost + "\n" + kFaceLines,
                         "a.ply"),
                    lost);
  }
  expectOneUnused(
      read("4OFF\n5 4 0\n0 0 0 1\n1 0 0 1\n0 1 0 1\n0 0 1 1\n1 0 0 0\n" + kFaceLines, "a.off"),
      "at infinity");
}

TEST(LostVertices, areLeftOutOfBinaryFiles) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::string positions = packedFloats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, nan, 0, 0});
  std::string faces;
  for (std::size_t i = 0; i < 12; i += 3) {
    faces += "\x03" + packed({kTetrahedronTriangles[i], kTetrahedronTriangles[i + 1],
                              kTetrahedronTriangles[i + 2]},
                             4);
  }
  expectOneUnused(read("ply\nformat binary_little_endian 1.0\nelement vertex 5\n"
                       "property float x\nproperty float y\nproperty float z\nelement face 4\n"
                       "property list uchar int vertex_indices\nend_header\n" +
                           positions + faces,
                       "a.ply"),
                  "PLY");
  TinyGltf tiny;
  tiny.binary = positions + tiny.binary.substr(48);
  tiny.views = R"({"buffer":0,"byteLength":60},{"buffer":0,"byteOffset":60,"byteLength":24})";
  tiny.accessors.replace(tiny.accessors.find("\"count\":4"), 9, "\"count\":5");
  expectOneUnused(read(tiny.file(), "a.glb"), "GLB");
}

}  // namespace
}  // namespace girth::io::testing
