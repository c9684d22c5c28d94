// Files that the PLY reader understands, and others that it refuses.
#include <array>
#include <cstring>
#include <limits>

#include "documents.h"

namespace girth::io::testing {
namespace {

/// The header of the tetrahedron.
std::string header(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
         "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
}

void expectTetrahedron(const Result<TriangleSoup>& soup, const std::string& about = {}) {
  ASSERT_TRUE(soup.ok()) << messageOf(soup) << about;
  EXPECT_EQ(soup.value().positions, kTetrahedronPositions) << about;
  EXPECT_EQ(soup.value().triangles, kTetrahedronTriangles) << about;
}

/// A number as any scalar type of PLY, in either byte order.
template <class T>
std::string scalar(double number, bool bigEndian) {
  const T value = static_cast<T>(number);
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bigEndian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

std::string scalar(const std::string& type, double number, bool bigEndian) {
  if (type == "char" || type == "int8") return scalar<std::int8_t>(number, bigEndian);
  if (type == "uchar" || type == "uint8") return scalar<std::uint8_t>(number, bigEndian);
  if (type == "short" || type == "int16") return scalar<std::int16_t>(number, bigEndian);
  if (type == "ushort" || type == "uint16") return scalar<std::uint16_t>(number, bigEndian);
  if (type == "int" || type == "int32") return scalar<std::int32_t>(number, bigEndian);
  if (type == "uint" || type == "uint32") return scalar<std::uint32_t>(number, bigEndian);
  if (type == "int64") return scalar<std::int64_t>(number, bigEndian);
  if (type == "uint64" || type == "uint64_t") return scalar<std::uint64_t>(number, bigEndian);
  if (type == "float" || type == "float32") return scalar<float>(number, bigEndian);
  return scalar<double>(number, bigEndian);
}

TEST(Ply, ascii) {
  expectTetrahedron(soupOf(header("ascii") + kVertexLines + kFaceLines, "a.ply"));
  const auto model = modelOf(header("ascii") + kVertexLines + kFaceLines, "a.obj");
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model.value().format, Format::Ply);
  EXPECT_EQ(model.value().unit, "");
  EXPECT_TRUE(model.value().notes.empty());
}

TEST(Ply, everyScalarTypeInBothByteOrders) {
  const std::array<const char*, 19> types{"int64",  "uint64",  "uint64_t", "char",   "int8",
                                          "uchar",  "uint8",   "short",    "int16",  "ushort",
                                          "uint16", "int",     "int32",    "uint",   "uint32",
                                          "float",  "float32", "double",   "float64"};
  for (const bool big : {false, true}) {
    for (const std::string type : types) {
      const bool counts = type.find("float") == type.npos && type != "double";
      const std::string countType = counts ? type : "uchar";
      std::string file = std::string("ply\nformat ") +
                         (big ? "binary_big_endian" : "binary_little_endian") +
                         " 1.0\nelement vertex 4\nproperty " + type + " x\nproperty " + type +
                         " y\nproperty " + type + " z\nelement face 4\nproperty list " + countType +
                         " " + type + " vertex_index\nend_header\n";
      for (const double number : kTetrahedronPositions) file += scalar(type, number, big);
      for (std::size_t f = 0; f < 4; ++f) {
        file += scalar(countType, 3, big);
        for (std::size_t k = 0; k < 3; ++k)
          file += scalar(type, kTetrahedronTriangles[3 * f + k], big);
      }
      expectTetrahedron(soupOf(file, "a.ply"), type + (big ? " big" : " little"));
    }
  }
}

TEST(Ply, otherElementsAndPropertiesAnywhere) {
  const std::string ascii =
      "ply\nformat ascii 1.0\ncomment made by hand\nobj_info num_cols 3\n"
      "element camera 1\nproperty float view\nproperty list uchar float path\n"
      "element nothing 7\n"
      "element vertex 4\nproperty uchar red\nproperty float y\nproperty list uchar int ring\n"
      "property double x\nproperty float z\nproperty float quality\n"
      "element edge 2\nproperty int vertex1\nproperty int vertex2\n"
      "element face 4\nproperty uchar flags\nproperty list uchar uint vertex_indices\n"
      "property list uchar float texcoord\n"
      "element material 1\nproperty int id\nend_header\n"
      "1.5 3 0.1 0.2 0.3\n"
      "255 0 1 7 0 0 0.5\n255 0 0 1 0 0.5\n255 1 2 7 8 0 0 0.5\n255 0 0 0 1 0.5\n"
      "0 1\n1 2\n"
      "0 3 0 2 1 6 0 0 0 0 0 0\n0 3 0 1 3 0\n0 3 0 3 2 0\n0 3 1 2 3 0\n"
      "9\n";
  expectTetrahedron(soupOf(ascii, "a.ply"));

  std::string binary = ascii.substr(0, ascii.find("end_header\n") + 11);
  binary.replace(binary.find("ascii"), 5, "binary_big_endian");
  const auto add = [&](const char* type, std::initializer_list<double> numbers) {
    for (const double number : numbers) binary += scalar(type, number, true);
  };
  add("float", {1.5});
  add("uchar", {3});
  add("float", {0.1, 0.2, 0.3});
  for (std::size_t v = 0; v < 4; ++v) {
    add("uchar", {255});
    add("float", {kTetrahedronPositions[3 * v + 1]});
    add("uchar", {static_cast<double>(v)});
    for (std::size_t i = 0; i < v; ++i) add("int", {7});
    add("double", {kTetrahedronPositions[3 * v]});
    add("float", {kTetrahedronPositions[3 * v + 2], 0.5});
  }
  add("int", {0, 1, 1, 2});
  for (std::size_t f = 0; f < 4; ++f) {
    add("uchar", {0, 3});
    for (std::size_t k = 0; k < 3; ++k) add("uint", {double(kTetrahedronTriangles[3 * f + k])});
    add("uchar", {2});
    add("float", {0.5, 0.25});
  }
  add("int", {9});
  expectTetrahedron(soupOf(binary, "a.ply"));
}

TEST(Ply, typesThatNobodyReadsArePassedOver) {
  const auto fileWith = [](const std::string& format, const std::string& type) {
    return "ply\nformat " + format + " 1.0\nelement vertex 4\nproperty " + type +
           " before\nproperty float x\nproperty float y\nproperty float z\nproperty list uchar " +
           type + " some\nelement face 4\nproperty list uchar int vertex_indices\n" +
           "element other 1\nproperty list " + type + " string name\nend_header\n";
  };
  for (const std::string type : {"int64", "half", "float128", "quaternion", "string"}) {
    const std::string word = type == "string" ? "red " : "7 ";
    const std::string text = fileWith("ascii", type) + word + "0 0 0 0\n" + word + "1 0 0 1 " +
                             word + "\n" + word + "0 1 0 0\n" + word + "0 0 1 0\n" + kFaceLines +
                             "1 x\n";
    if (type == "int64" || type == "quaternion" || type == "string") {
      expectTetrahedron(soupOf(text, "a.ply"), type);
    } else {
      EXPECT_TRUE(contains(messageOf(soupOf(text, "a.ply")), "cannot be counted by"));
    }
    const auto kept = readModel(bytesOf(text), "a.ply", {}, {true});
    ASSERT_EQ(kept.ok(), type == "int64" || type == "quaternion" || type == "string");
    if (!kept) continue;
    EXPECT_EQ(kept.value().attributes.size(), type == "int64" ? 1u : 0u) << type;
  }
  for (const auto& [type, size] : {std::pair{"int64", 8u}, std::pair{"uint64", 8u},
                                   std::pair{"float16", 2u}, std::pair{"int128", 16u}}) {
    std::string file = fileWith("binary_little_endian", type);
    file.replace(file.find(std::string("list ") + type), 5 + std::string(type).size(), "list odd");
    for (std::size_t v = 0; v < 4; ++v) {
      file += std::string(size, 'b');
      for (std::size_t k = 0; k < 3; ++k)
        file += scalar("float", kTetrahedronPositions[3 * v + k], false);
      file += std::string("\1") + std::string(size, 's');
    }
    for (std::size_t f = 0; f < 4; ++f) {
      file += "\3";
      for (std::size_t k = 0; k < 3; ++k)
        file += scalar("int", kTetrahedronTriangles[3 * f + k], false);
    }
    expectTetrahedron(soupOf(file + "whatever", "a.ply"), type);
  }
  const auto unknown =
      soupOf(fileWith("binary_little_endian", "string") + std::string(500, '\0'), "a.ply");
  EXPECT_EQ(messageOf(unknown), "line 4: the type \"string\" is unknown");
  EXPECT_TRUE(contains(unknown.error().hint, "as text")) << unknown.error().hint;
  std::string needed = fileWith("binary_little_endian", "int64");
  needed.replace(needed.find("float y"), 5, "half");
  EXPECT_EQ(messageOf(soupOf(needed + std::string(500, '\0'), "a.ply")),
            "line 6: the type \"half\" is unknown");
  std::string many = fileWith("binary_little_endian", "int64");
  many.replace(many.find("list uchar int64"), 16, "list uint64 int64");
  EXPECT_EQ(codeOf(soupOf(many + std::string(20, '\0') + std::string(8, '\x7f'), "a.ply")),
            "MALFORMED_FILE");
}

TEST(Ply, moreValuesThanTheHeaderDeclaresArePassedOver) {
  // MeshLab wrote a list of colours behind each face without declaring it.
  const std::string faces = "3 0 2 1 3 255 0 0\n3 0 1 3 3 0 255 0\n3 0 3 2\n3 1 2 3 3 0 0 255\n";
  const auto model = modelOf(header("ascii") + kVertexLines + faces, "a.ply");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(model.value().soup.positions, kTetrahedronPositions);
  EXPECT_EQ(model.value().soup.triangles, kTetrahedronTriangles);
  EXPECT_EQ(
      model.value().notes,
      std::vector<std::string>{"Extra text on 3 lines was passed over, first \"3\" on line 14."});
  expectTetrahedron(
      soupOf(header("ascii") + "0 0 0 9\n" + kVertexLines.substr(6) + kFaceLines, "a.ply"));
}

TEST(Ply, facesBeforeVertices) {
  expectTetrahedron(soupOf(
      "ply\nformat ascii 1.0\nelement face 4\nproperty list uchar int vertex_indices\n"
      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nend_header\n" +
          kFaceLines + kVertexLines,
      "a.ply"));
}

TEST(Ply, lineEndsAndWhiteSpace) {
  std::string text = header("ascii") + kVertexLines + kFaceLines;
  for (const std::string end : {"\r\n", "\r", "\n\n", " \t\n"}) {
    // The first line takes no blank lines after it in the header's mark.
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    expectTetrahedron(soupOf(other, "a.ply"), end);
  }
  expectTetrahedron(soupOf("\xEF\xBB\xBF" + text, "a.ply"));
  // An element may go on on the next line.
  expectTetrahedron(
      soupOf(header("ascii") + "0\n0 0\n1 0\n\n0\n0 1 0\n0 0 1\n" + kFaceLines, "a.ply"));
}

TEST(Ply, binaryBodyBehindEveryLineEnd) {
  std::string body;
  for (const double number : kTetrahedronPositions) body += scalar<float>(number, false);
  for (std::size_t f = 0; f < 4; ++f) {
    body += '\x03';
    for (std::size_t k = 0; k < 3; ++k)
      body += scalar<std::int32_t>(kTetrahedronTriangles[3 * f + k], false);
  }
  const std::string lines = header("binary_little_endian");
  expectTetrahedron(soupOf(lines + body, "a.ply"));
  for (const std::string end : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : lines) other += c == '\n' ? end : std::string(1, c);
    expectTetrahedron(soupOf(other + body, "a.ply"), end);
  }
  // Only the last line ends otherwise.
  expectTetrahedron(soupOf(lines.substr(0, lines.size() - 1) + "\r\n" + body, "a.ply"));
  // A body that begins with a byte that could be a line's end: x is 0x0000000A.
  body[0] = '\n';
  std::string returns;
  for (const char c : lines) returns += c == '\n' ? '\r' : c;
  for (const std::string& beginning : {lines, returns}) {
    const auto soup = soupOf(beginning + body, "a.ply");
    ASSERT_TRUE(soup.ok()) << messageOf(soup);
    EXPECT_GT(soup.value().positions[0], 0);
    EXPECT_EQ(soup.value().triangles, kTetrahedronTriangles);
  }
}

TEST(Ply, polygonsAreCutInside) {
  const auto soup = soupOf(
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
      "property float z\nelement face 3\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n4 0 0\n4 4 0\n2 1 0\n0 4 0\n5 0 1 2 3 4\n2 0 1\n3 0 1 2\n",
      "a.ply");
  ASSERT_TRUE(soup.ok()) << messageOf(soup);
  double area = 0;
  const auto& p = soup.value().positions;
  const auto& t = soup.value().triangles;
  ASSERT_EQ(t.size(), 12u);
  for (std::size_t i = 0; i < 9; i += 3) {
    const double twice = (p[3 * t[i + 1]] - p[3 * t[i]]) * (p[3 * t[i + 2] + 1] - p[3 * t[i] + 1]) -
                         (p[3 * t[i + 1] + 1] - p[3 * t[i] + 1]) * (p[3 * t[i + 2]] - p[3 * t[i]]);
    EXPECT_GT(twice, 0);
    area += twice / 2;
  }
  EXPECT_DOUBLE_EQ(area, 10);
}

TEST(Ply, facesWithoutAnInsideAreCounted) {
  const auto model =
      modelOf(header("ascii") + kVertexLines + "3 0 2 1\n2 0 1\n0\n3 0 1 3\n", "a.ply");
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model.value().soup.triangles.size(), 6u);
  ASSERT_EQ(model.value().notes.size(), 1u);
  EXPECT_TRUE(contains(model.value().notes[0], "2 faces")) << model.value().notes[0];
}

TEST(Ply, triangleStrips) {
  // Two strips; the second turns a corner by naming a vertex twice.
  const std::string head =
      " 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n";
  const std::vector<Index> expected{0, 1, 2, 2, 1, 3, 1, 2, 3, 4, 3, 2};
  const auto ascii = soupOf("ply\nformat ascii" + head +
                                "0 0 0\n1 0 0\n0 1 0\n1 1 0\n2 2 1\n"
                                "10 0 1 2 3 -1 1 2 3 3 4\n",
                            "a.ply");
  ASSERT_TRUE(ascii.ok()) << messageOf(ascii);
  // 1 2 3 3 4: the triangle 2 3 3 only turns, 3 3 4 as well; so name it so that one is left.
  EXPECT_EQ(ascii.value().triangles, (std::vector<Index>{0, 1, 2, 2, 1, 3, 1, 2, 3}));
  std::string binary = "ply\nformat binary_little_endian" + head;
  for (int i = 0; i < 15; ++i) binary += scalar<float>(i % 4, false);
  binary += packed({10, 0, 1, 2, 3, -1, 1, 2, 3, 4}, 4);
  binary += packed({-1}, 4);
  const auto soup = soupOf(binary, "a.ply");
  ASSERT_TRUE(soup.ok()) << messageOf(soup);
  EXPECT_EQ(soup.value().triangles, (std::vector<Index>{0, 1, 2, 2, 1, 3, 1, 2, 3, 3, 2, 4}));
}

TEST(Ply, coordinatesInTextAreDoubles) {
  const auto soup = soupOf(
      header("ascii") + "0.1 1e-300 -0\n1.7976931348623157e308 0 0\n0 1 0\n0 0 1\n" + kFaceLines,
      "a.ply");
  ASSERT_TRUE(soup.ok()) << messageOf(soup);
  EXPECT_EQ(soup.value().positions[0], 0.1);
  EXPECT_EQ(soup.value().positions[1], 1e-300);
  EXPECT_EQ(soup.value().positions[3], 1.7976931348623157e308);
}

TEST(BadPly, codesAndPlaces) {
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string faces = "element face 1\nproperty list uchar int vertex_indices\n";
  expectRefused(
      "bad.ply",
      {
          Refused{"ply\nformat ascii 1.0\n", "MALFORMED_FILE", 2, "end_header"},
          Refused{"ply\n", "MALFORMED_FILE", 1, "end_header"},
          Refused{"ply\nelement vertex 4\nend_header\n", "MALFORMED_FILE", 3, "format"},
          Refused{"ply\nformat binary_middle_endian 1.0\n", "MALFORMED_FILE", 2, "middle"},
          Refused{"ply\nformat ascii 1.0\nproperty float x\n", "MALFORMED_FILE", 3, "before"},
          Refused{"ply\nformat ascii 1.0\nelement vertex -1\n", "MALFORMED_FILE", 3, "\"-1\""},
          Refused{"ply\nformat ascii 1.0\nelement vertex many\n", "MALFORMED_FILE", 3, "\"many\""},
          Refused{"ply\nformat ascii 1.0\nelement a 1\nproperty list float int x\n",
                  "MALFORMED_FILE", 4, "\"float\""},
          Refused{"ply\nformat ascii 1.0\nelement a 1\nelement a 1\n", "MALFORMED_FILE", 4,
                  "second"},
          Refused{"ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + xyz + faces +
                      "propertx\nend_header\n" + std::string(100, '\0'),
                  "MALFORMED_FILE", 9, "propertx"},
          Refused{"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n" + faces +
                      "end_header\n0\n3 0 0 0\n",
                  "MALFORMED_FILE", -1, "\"y\""},
          Refused{
              "ply\nformat ascii 1.0\nelement vertex 1\n" + xyz +
                  "element face 1\nproperty list uchar int corners\nend_header\n0 0 0\n3 0 0 0\n",
              "MALFORMED_FILE", -1, "vertex_indices"},
          Refused{header("ascii") + "0 0 0\n1 0 zero\n", "MALFORMED_FILE", 11, "\"zero\""},
          Refused{header("ascii") + "0 0 0 1 0 0\n0 1 0 0 0 1\n" + kFaceLines, "MALFORMED_FILE", 16,
                  "the first line with more values than the header declares is 10"},
          Refused{"ply\nformat ascii 1.0\nelement vertex 7\n" + xyz +
                      "property float f_dc_0\nproperty float opacity\nproperty float scale_0\n"
                      "property float rot_0\nend_header\n",
                  "EMPTY_MESH", -1, "Gaussian splats, 7 of them"},
          Refused{"ply\nformat binary_little_endian 1.0\nelement chunk 1\nproperty float min_x\n"
                  "element vertex 256\nproperty uint packed_position\n"
                  "property uint packed_rotation\nend_header\n",
                  "EMPTY_MESH", -1, "Gaussian splats, 256 of them"},
          Refused{header("ascii") + kVertexLines, "MALFORMED_FILE", 14, "ends before face 0 of 4"},
          Refused{header("ascii") + kVertexLines + "3 0 2\n", "MALFORMED_FILE", 15, "face 0 of 4"},
          Refused{header("ascii") + kVertexLines + "3 0 2 1.5\n", "MALFORMED_FILE", 14, "whole"},
          Refused{header("ascii") + kVertexLines + "-3 0 2 1\n", "MALFORMED_FILE", 14, "-3"},
          Refused{header("ascii") + kVertexLines + "3 0 2 4\n" + kFaceLines.substr(8),
                  "INDEX_OUT_OF_RANGE", 14, "vertex 4 of 4"},
          Refused{header("ascii") + kVertexLines + "3 0 2 -1\n", "INDEX_OUT_OF_RANGE", 14,
                  "vertex -1 of 4"},
          Refused{header("ascii") + kVertexLines + "3 0 2 4294967296\n", "INDEX_OUT_OF_RANGE", 14,
                  "vertex 4294967296"},
          Refused{header("ascii") + "0 0 0\n1 nan 0\n0 1 0\n0 0 1\n" + kFaceLines,
                  "NON_FINITE_POSITION", 1, "line 11: vertex 1 of face 0 has"},
          Refused{header("ascii") + "0 0 0\n1 1e999 0\n0 1 0\n0 0 1\n" + kFaceLines,
                  "NON_FINITE_POSITION", 1, "vertex 1"},
          Refused{"ply\nformat ascii 1.0\nelement vertex 9\n" + xyz + "end_header\n", "EMPTY_MESH",
                  -1, "point cloud: 9 points"},
          Refused{"ply\nformat ascii 1.0\nelement vertex 9\n" + xyz +
                      "element range_grid 2\nproperty list uchar int vertex_indices\nend_header\n",
                  "EMPTY_MESH", -1, "range scan"},
          Refused{"ply\nformat ascii 1.0\nend_header\n", "EMPTY_MESH", -1, "no vertices"},
          Refused{"ply\nformat ascii 1.0\nelement vertex 3\n" + xyz + faces +
                      "end_header\n0 0 0\n0 0 0\n0 0 0\n2 0 1\n",
                  "EMPTY_MESH", -1, "no face with three corners"},
          Refused{header("binary_little_endian") + std::string(20, '\0'), "MALFORMED_FILE", 189,
                  "vertex 1 of 4"},
          Refused{header("binary_little_endian") + std::string(48, '\0') + "\x03", "MALFORMED_FILE",
                  218, "face 0 of 4"},
          Refused{header("binary_little_endian") + std::string(48, '\0') + "\x03" +
                      packed({0, 1, 5}, 4) + std::string(99, '\0'),
                  "INDEX_OUT_OF_RANGE", 230, "vertex 5 of 4"},
          Refused{header("binary_little_endian") + packedFloats({0, 0, 0, 0, 0}) +
                      "\xFF\xFF\xFF\x7F" + packedFloats({0, 0, 0, 0, 0, 0}) + "\x03" +
                      packed({0, 2, 1}, 4) + std::string(39, '\0'),
                  "NON_FINITE_POSITION", 1, "vertex 1 of face 0"},
      });
}

TEST(Ply, coloursOfVerticesAreNoted) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n3 0 1 2\n";
  for (const bool attributes : {false, true}) {
    const auto model = readModel(bytesOf(text), "a.ply", {}, {attributes});
    ASSERT_TRUE(model.ok()) << messageOf(model);
    ASSERT_EQ(model.value().notes.size(), 1u);
    EXPECT_TRUE(contains(model.value().notes[0], "colours of its vertices"));
  }
}

TEST(Ply, coloursOfFacesAreLeftOutWithANote) {
  const auto model = modelOf(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element face 1\nproperty list uchar int vertex_indices\nproperty uchar red\n"
      "property uchar green\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0\n",
      "a.ply");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(model.value().notes,
            std::vector<std::string>{"Properties of its faces were left out: \"red\", \"green\"."});
}

TEST(BadPly, countsAreNotTrusted) {
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  for (const std::string format : {"ascii", "binary_little_endian"}) {
    const std::string begin = "ply\nformat " + format + " 1.0\n";
    const std::string end = "end_header\n0 0 0\n1 1 1\n2 2 2\n";
    for (const std::string& text :
         {begin + "element vertex 4000000000\n" + xyz +
              "element face 1\nproperty list uchar int vertex_indices\n" + end,
          begin + "element vertex 999999999999999999999\n" + xyz +
              "element face 1\nproperty list uchar int vertex_indices\n" + end,
          begin + "element vertex 1\n" + xyz +
              "element face 999999999999\nproperty list uchar int vertex_indices\n" + end,
          begin + "element vertex 1\n" + xyz +
              "element face 1\nproperty list uint int vertex_indices\n"
              "property list uint double weights\n" +
              end,
          // Elements without properties take no bytes, and must take no time.
          begin + "element vertex 4000000000\nelement face 999999999999\n" + end,
          begin + "element other 999999999999\nproperty double a\nelement face 1\n" + end}) {
      const auto result = soupOf(text, "bad.ply");
      EXPECT_TRUE(codeOf(result) == "MALFORMED_FILE" || codeOf(result) == "LIMIT_EXCEEDED" ||
                  codeOf(result) == "EMPTY_MESH" || codeOf(result) == "INDEX_OUT_OF_RANGE")
          << text << codeOf(result) << messageOf(result);
    }
  }
}

TEST(BadPly, truncatedAtEveryByte) {
  std::string whole = header("binary_little_endian");
  for (const double number : kTetrahedronPositions) whole += scalar<float>(number, false);
  for (std::size_t f = 0; f < 4; ++f) {
    whole += '\x03';
    for (std::size_t k = 0; k < 3; ++k)
      whole += scalar<std::int32_t>(kTetrahedronTriangles[3 * f + k], false);
  }
  for (std::size_t length = 5; length < whole.size(); ++length) {
    const auto result = soupOf(whole.substr(0, length), "a.ply");
    ASSERT_EQ(codeOf(result), "MALFORMED_FILE") << length;
  }
  for (std::size_t at = 4; at < whole.size(); ++at) {
    for (const char value : {'\0', '\x7F', '\xFF', '9', '\n'}) {
      std::string changed = whole;
      changed[at] = value;
      const auto result = soupOf(changed, "a.ply");
      ASSERT_TRUE(result.ok() || !result.error().message.empty()) << at;
    }
  }
}

}  // namespace
}  // namespace girth::io::testing
