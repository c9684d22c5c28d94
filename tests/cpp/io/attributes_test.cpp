// Colours, texture coordinates and scalars that glTF and OBJ give vertices and corners.
#include <cmath>
#include <limits>
#include <map>

#include "documents.h"

namespace girth::io::testing {
namespace {

Result<ReadModel> attributed(const std::string& content, const std::string& name) {
  return readModel(bytesOf(content), name, {}, {true});
}

/// The numbers of one attribute at one corner of the triangles.
std::vector<double> at(const ReadModel& model, const std::string& name, std::size_t corner) {
  for (const Attribute& attribute : model.attributes) {
    if (attribute.name != name) continue;
    const Index number =
        attribute.corners.empty() ? model.soup.triangles[corner] : attribute.corners[corner];
    if (number == kNoIndex) return {};
    const auto first = attribute.values.begin() + std::ptrdiff_t{attribute.width} * number;
    return {first, first + attribute.width};
  }
  ADD_FAILURE() << "there is no " << name;
  return {};
}

/// A tetrahedron with further accessors, each over a buffer view of its own.
struct ColouredGltf : TinyGltf {
  int next = 2;

  /// The number of the new accessor.
  std::string add(const std::string& bytes, const std::string& members) {
    while (binary.size() % 4 != 0) binary += '\0';
    views += R"(,{"buffer":0,"byteOffset":)" + std::to_string(binary.size()) + R"(,"byteLength":)" +
             std::to_string(bytes.size()) + "}";
    binary += bytes;
    accessors += R"(,{"bufferView":)" + std::to_string(next) + "," + members + "}";
    return std::to_string(next++);
  }
  std::string addColours() {
    return add(packed({255, 0, 51, 0, 102, 0, 0, 255, 0, 0, 255, 255}, 1),
               R"("componentType":5121,"normalized":true,"count":4,"type":"VEC3")");
  }
  std::string addScalars(std::initializer_list<float> values) {
    return add(packedFloats(values), R"("componentType":5126,"count":)" +
                                         std::to_string(values.size()) + R"(,"type":"SCALAR")");
  }
  void setPrimitive(const std::string& attributes, const std::string& members = "") {
    primitives = R"({"attributes":{"POSITION":0)" + attributes + R"(},"indices":1)" + members + "}";
  }
};

TEST(Attributes, areReadOnlyWhereTheyAreAskedFor) {
  ColouredGltf tiny;
  tiny.setPrimitive(R"(,"COLOR_0":)" + tiny.addColours());
  const auto plain = modelOf(tiny.file(), "tiny.glb");
  ASSERT_TRUE(plain.ok()) << messageOf(plain);
  EXPECT_TRUE(plain.value().attributes.empty());
  const auto model = attributed(tiny.file(), "tiny.glb");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(model.value().soup.positions, plain.value().soup.positions);
  EXPECT_EQ(model.value().soup.triangles, plain.value().soup.triangles);
}

TEST(Attributes, integersAndFloatsOfGltf) {
  ColouredGltf tiny;
  const std::string texture =
      tiny.add(packed({0, 0, 65535, 0, 0, 13107, 26214, 65535}, 2),
               R"("componentType":5123,"normalized":true,"count":4,"type":"VEC2")");
  const std::string girth = tiny.addScalars({0.5F, -3, 7, 1e30F});
  tiny.setPrimitive(R"(,"COLOR_0":)" + tiny.addColours() + R"(,"TEXCOORD_0":)" + texture +
                    R"(,"_GIRTH":)" + girth);
  const auto model = attributed(tiny.file(), "tiny.glb");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  ASSERT_EQ(model.value().attributes.size(), 3u);
  EXPECT_TRUE(model.value().attributeNotes.empty());
  EXPECT_TRUE(model.value().attributes[0].isLinear);
  // Corners 0, 1, 4 and 5 are the vertices 0, 2, 1 and 3.
  EXPECT_EQ(at(model.value(), "COLOR_0", 0), (std::vector<double>{1, 0, 0.2}));
  EXPECT_EQ(at(model.value(), "COLOR_0", 4), (std::vector<double>{0, 0.4, 0}));
  EXPECT_EQ(at(model.value(), "TEXCOORD_0", 1), (std::vector<double>{0, 0.2}));
  EXPECT_EQ(at(model.value(), "TEXCOORD_0", 5), (std::vector<double>{0.4, 1}));
  EXPECT_EQ(at(model.value(), "_GIRTH", 0), (std::vector<double>{0.5}));
  EXPECT_EQ(at(model.value(), "_GIRTH", 5), (std::vector<double>{double{1e30F}}));
  // Floats of four channels, beyond what is finite too.
  ColouredGltf four;
  const std::string colours =
      four.add(packedFloats({0.25F, 0.5F, 0.75F, 0.5F, 1, 1, 1, 1, 0, 0, 0, 0,
                             std::numeric_limits<float>::infinity(), 0, 0, 1}),
               R"("componentType":5126,"count":4,"type":"VEC4")");
  four.setPrimitive(R"(,"COLOR_0":)" + colours);
  const auto opaque = attributed(four.file(), "four.glb");
  ASSERT_TRUE(opaque.ok()) << messageOf(opaque);
  EXPECT_EQ(at(opaque.value(), "COLOR_0", 0), (std::vector<double>{0.25, 0.5, 0.75, 0.5}));
  EXPECT_TRUE(std::isnan(at(opaque.value(), "COLOR_0", 5)[0]));
}

TEST(Attributes, sparseOnes) {
  ColouredGltf tiny;
  const std::string index = packed({2}, 1), value = packedFloats({9});
  tiny.add(index, R"("componentType":5121,"count":1,"type":"SCALAR")");
  tiny.add(value, R"("componentType":5126,"count":1,"type":"SCALAR")");
  tiny.accessors +=
      R"(,{"componentType":5126,"count":4,"type":"SCALAR","sparse":{"count":1,)"
      R"("indices":{"bufferView":2,"componentType":5121},"values":{"bufferView":3}}})";
  tiny.setPrimitive(R"(,"_S":4)");
  const auto model = attributed(tiny.file(), "tiny.glb");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(at(model.value(), "_S", 0), (std::vector<double>{0}));
  EXPECT_EQ(at(model.value(), "_S", 1), (std::vector<double>{9}));
}

TEST(Attributes, primitivesThatShareVerticesHaveTheirOwnValues) {
  ColouredGltf tiny;
  const std::string first = tiny.addScalars({1, 2, 3, 4}), second = tiny.addScalars({5, 6, 7, 8});
  const std::string index =
      tiny.add(packed({0, 2, 1, 0, 1, 3}, 2), R"("componentType":5123,"count":6,"type":"SCALAR")");
  const auto primitive = [&](const std::string& extras) {
    return R"({"attributes":{"POSITION":0)" + extras + R"(},"indices":)" + index + "}";
  };
  tiny.primitives =
      primitive(R"(,"_A":)" + first) + "," + primitive(R"(,"_A":)" + second) + "," + primitive("");
  tiny.nodes = R"({"mesh":0,"translation":[5,0,0]},{"mesh":0})";
  tiny.scenes = R"("scenes":[{"nodes":[0,1]}])";
  const auto model = attributed(tiny.file(), "tiny.glb");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  // Two instances of three primitives on four vertices.
  EXPECT_EQ(model.value().soup.positions.size(), 3 * 2 * 4u);
  ASSERT_EQ(model.value().soup.triangles.size(), 2 * 3 * 6u);
  for (const std::size_t instance : {0u, 18u}) {
    EXPECT_EQ(at(model.value(), "_A", instance + 1), (std::vector<double>{3}));
    EXPECT_EQ(at(model.value(), "_A", instance + 6 + 1), (std::vector<double>{7}));
    EXPECT_EQ(at(model.value(), "_A", instance + 12 + 1), (std::vector<double>{}));
  }
  // A mesh that is placed again is stored once.
  EXPECT_EQ(model.value().attributes[0].values.size(), 8u);
  ASSERT_EQ(model.value().attributeNotes.size(), 1u);
  EXPECT_EQ(model.value().attributeNotes[0],
            "The attribute \"_A\" has no value in 2 of 6 primitives.");
}

TEST(Attributes, materialsColourVertices) {
  ColouredGltf tiny;
  const std::string colours = tiny.addColours();
  const std::string plain = R"({"attributes":{"POSITION":0},"indices":1)";
  tiny.primitives = R"({"attributes":{"POSITION":0,"COLOR_0":)" + colours +
                    R"(},"indices":1,"material":0},)" + plain + R"(,"material":0},)" + plain +
                    R"(,"material":1},)" + plain + R"(,"material":7},)" + plain + "}";
  tiny.more = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,0.5]}},)"
              R"({"pbrMetallicRoughness":{"baseColorFactor":[2,0,0,1]}}])";
  const auto model = attributed(tiny.file(), "tiny.glb");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(at(model.value(), "COLOR_0", 4), (std::vector<double>{0, 0.25 * 0.4, 0, 0.5}));
  EXPECT_EQ(at(model.value(), "COLOR_0", 12 + 4), (std::vector<double>{0.5, 0.25, 1, 0.5}));
  // A colour that cannot be, a material that is not there, none at all: white, as glTF prescribes.
  for (const std::size_t primitive : {2u, 3u, 4u}) {
    EXPECT_EQ(at(model.value(), "COLOR_0", 12 * primitive), (std::vector<double>{1, 1, 1, 1}));
  }
  EXPECT_TRUE(model.value().attributeNotes.empty());
  // White materials are no colours.
  tiny.setPrimitive("", R"(,"material":1)");
  EXPECT_TRUE(attributed(tiny.file(), "tiny.glb").value().attributes.empty());
}

TEST(Attributes, whatCannotBeReadIsLeftOut) {
  const auto notesOf = [](ColouredGltf& tiny, const std::string& attributes) {
    tiny.setPrimitive(attributes);
    const auto model = attributed(tiny.file(), "tiny.glb");
    EXPECT_TRUE(model.ok()) << messageOf(model);
    std::string notes;
    if (!model) return notes;
    EXPECT_TRUE(model.value().attributes.empty()) << attributes;
    for (const std::string& note : model.value().attributeNotes) notes += note + "\n";
    return notes;
  };
  ColouredGltf tiny;
  const std::string few = tiny.addScalars({1, 2, 3});
  const std::string whole = tiny.add(packed({255, 0, 51, 0, 102, 0, 0, 255, 0, 0, 255, 255}, 1),
                                     R"("componentType":5121,"count":4,"type":"VEC3")");
  EXPECT_TRUE(contains(notesOf(tiny, R"(,"_A":)" + few), "3 values for 4 points"));
  EXPECT_TRUE(contains(notesOf(tiny, R"(,"_A":0)"), "needs SCALAR"));
  EXPECT_TRUE(contains(notesOf(tiny, R"(,"_A":99)"), "there is no accessor 99"));
  EXPECT_TRUE(contains(notesOf(tiny, R"(,"COLOR_0":)" + whole), "neither floats nor normalized"));
  EXPECT_TRUE(contains(notesOf(tiny, R"(,"TEXCOORD_0":0)"), "needs VEC2"));
  EXPECT_EQ(notesOf(tiny, R"(,"COLOR_1":0,"TEXCOORD_3":0,"_a\nb":2)"),
            "The attributes \"COLOR_1\", \"TEXCOORD_3\", \"_a?b\" are left out.\n");
  // No numbers of accessors, and normals, which follow from the surface.
  EXPECT_EQ(notesOf(tiny, R"(,"_A":"x","_B":-1,"_C":1.5,"COLOR_0":null,"NORMAL":0)"), "");
}

TEST(Attributes, manyOfThemStayWithinBounds) {
  ColouredGltf tiny;
  const std::string values = tiny.addScalars({1, 2, 3, 4});
  std::string attributes;
  for (int i = 10; i < 40; ++i) attributes += R"(,"_A)" + std::to_string(i) + R"(":)" + values;
  tiny.setPrimitive(attributes);
  const auto model = attributed(tiny.file(), "tiny.glb");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(model.value().attributes.size(), 16u);
  ASSERT_EQ(model.value().attributeNotes.size(), 1u);
  EXPECT_TRUE(contains(model.value().attributeNotes[0], "and 10 more are left out"));
  // Zeros that no byte stands behind: a million points, far more numbers than the file could hold.
  TinyGltf large;
  large.accessors = R"({"componentType":5126,"count":1200000,"type":"VEC3"},)"
                    R"({"componentType":5126,"count":1200000,"type":"SCALAR"},)"
                    R"({"componentType":5126,"count":1200000,"type":"VEC4"})";
  large.primitives = R"({"attributes":{"POSITION":0,"COLOR_0":2)";
  for (int i = 10; i < 40; ++i) large.primitives += R"(,"_A)" + std::to_string(i) + R"(":1)";
  large.primitives += "}}";
  const auto many = attributed(large.file(), "large.glb");
  ASSERT_TRUE(many.ok()) << messageOf(many);
  std::size_t numbers = 0;
  for (const Attribute& attribute : many.value().attributes) numbers += attribute.values.size();
  EXPECT_LT(numbers, 20'000'000u);
  EXPECT_FALSE(many.value().attributeNotes.empty());
}

TEST(Attributes, textureCoordinatesOfObj) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n";
  // A square of which one corner is on a seam, with what comes later, and from behind.
  const std::string text = vertices +
                           "vt 0.25 0.5\nvt 1\nf 1/1 2/2 3/3 4/-1/7\nf 1/4//1 5 2/2\n"
                           "vt 1 1 0.5\nvt nan 0\nf 2/9 5/x 3/0\n";
  EXPECT_TRUE(modelOf(text, "seam.obj").value().attributes.empty());
  const auto model = attributed(text, "seam.obj");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  const ReadModel& read = model.value();
  ASSERT_EQ(read.soup.triangles.size(), 12u);
  const std::map<Index, std::vector<double>> square{
      {0, {0.25, 0.5}}, {1, {1, 0}}, {2, {1, 1}}, {3, {1, 0}}};
  for (std::size_t c = 0; c < 6; ++c) {
    EXPECT_EQ(at(read, "TEXCOORD_0", c), square.at(read.soup.triangles[c])) << c;
  }
  EXPECT_TRUE(std::isnan(at(read, "TEXCOORD_0", 6)[0]));
  EXPECT_TRUE(at(read, "TEXCOORD_0", 7).empty());
  EXPECT_EQ(at(read, "TEXCOORD_0", 8), (std::vector<double>{1, 0}));
  for (std::size_t c = 9; c < 12; ++c) EXPECT_TRUE(at(read, "TEXCOORD_0", c).empty());
  ASSERT_EQ(read.attributeNotes.size(), 1u);
  EXPECT_EQ(read.attributeNotes[0],
            "3 corners of triangles name texture coordinates that the file does not have.");
  EXPECT_TRUE(attributed(vertices + "vt 1 1\nf 1 2 3\n", "none.obj").value().attributes.empty());
}

}  // namespace
}  // namespace girth::io::testing
