// Files that the OBJ reader understands, and others that it refuses.
#include <cmath>

#include "documents.h"

namespace girth::io::testing {
namespace {

TEST(Obj, readsTriangles) {
  const auto loaded = read(kTetrahedronObj, "tiny.obj");
  ASSERT_TRUE(loaded.ok()) << messageOf(loaded);
  EXPECT_EQ(loaded.value().mesh.faceCount(), 4u);
  EXPECT_EQ(loaded.value().format, Format::Obj);
  EXPECT_EQ(loaded.value().unit, "");
  EXPECT_EQ(loaded.value().mesh.position(Vertex(1)).x, 1);
}

TEST(Obj, readsAllWaysToWriteAFace) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  for (const char* faces :
       {"f 1/1 3/2 2/3\nf 1/4/1 2//2 4/3/1\nf 1// 4// 3//\nf 2 3 4\n",
        "f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n",
        "f 1 3 2 # comment\nf\t1  2 4 \nf 1 4 \\\n 3\nf 2 3 4",
        "g a b\ns off\nusemtl x\nf 1 3 2\r\nf 1 2 4\r\no c\r\nf 1 4 3\r\nf 2 3 4\r"}) {
    EXPECT_EQ(codeOf(read(vertices + faces, "tiny.obj")), "OK") << faces;
  }
}

TEST(Obj, oddWhiteSpace) {
  for (const char* text :
       {"\tv  0\t0 \v 0 \nv 1 0 0\n\n\nv 0 1 0\fv\n v 0 0 1 \r\n\r\n  f\t1 3 2\nf 1 2 4\n\tf 1 4 3 "
        "\nf 2 3 4",
        "v 0 0 0\rv 1 0 0\rv 0 1 0\rv 0 0 1\rf 1 3 2\rf 1 2 4\rf 1 4 3\rf 2 3 4",
        "v 0 0\\\n 0\nv 1 0 0\nv 0 1 0\nv \\\r\n0 \\\r\n0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 "
        "4\\"}) {
    const auto soup = soupOf(text, "odd.obj");
    ASSERT_TRUE(soup.ok()) << text << messageOf(soup);
    EXPECT_EQ(soup.value().positions, (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}));
    EXPECT_EQ(soup.value().triangles, (std::vector<Index>{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}));
  }
}

TEST(Obj, commentsAndOtherStatementsJoinNothing) {
  // Paths of Windows end in a backslash; the vertex after them must not be lost.
  const auto soup =
      soupOf("# C:\\models\\\nv 0 0 0\nusemtl C:\\\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "paths.obj");
  ASSERT_TRUE(soup.ok()) << messageOf(soup);
  EXPECT_EQ(soup.value().positions.size(), 9u);
}

TEST(Obj, longLines) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n# " + std::string(1 << 20, 'x') + "\nf 1 2 3";
  text += std::string(1 << 20, ' ') + "\n" + "g " + std::string(1 << 20, 'g') + "\n";
  const auto soup = soupOf(text, "long.obj");
  ASSERT_TRUE(soup.ok()) << messageOf(soup);
  EXPECT_EQ(soup.value().triangles.size(), 3u);
}

TEST(Obj, weightsAndColoursAreNoPositions) {
  const std::string face = "f 1 2 3\n";
  const auto notes = [&](const std::string& vertices) {
    const auto model = modelOf(vertices + face, "a.obj");
    EXPECT_TRUE(model.ok()) << vertices << messageOf(model);
    if (!model) return std::size_t{99};
    EXPECT_EQ(model.value().soup.positions, (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
    return model.value().notes.size();
  };
  EXPECT_EQ(notes("v 0 0 0 1\nv 1 0 0 1.0\nv 0 1 0 1\n"), 0u);
  EXPECT_EQ(notes("v 0 0 0 2\nv 1 0 0 0\nv 0 1 0 1\n"), 1u) << "w that is not 1";
  EXPECT_EQ(notes("v 0 0 0 0.5 0.5 0.5\nv 1 0 0 0 0 0\nv 0 1 0 255 0 0\n"), 1u);
  EXPECT_EQ(notes("v 0 0 0 1 0.5 0.5 0.5\nv 1 0 0 1 0 0 0\nv 0 1 0 1 1 0 0\n"), 1u);
}

TEST(Obj, facesMayComeBeforeVertices) {
  EXPECT_EQ(codeOf(read("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n",
                        "tiny.obj")),
            "OK");
}

TEST(Obj, recognisedByContent) {
  EXPECT_EQ(codeOf(read("# a comment\n\n  " + kTetrahedronObj, "noname")), "OK");
  EXPECT_EQ(codeOf(read("\xEF\xBB\xBF" + kTetrahedronObj, "tiny.glb")), "OK");
}

TEST(Obj, coordinatesAreRoundedCorrectly) {
  const auto soup = soupOf(
      "v 0.1234567891 -0.98765432101 1e-7\nv 1.7976931348623157e308 .5 -5.\n"
      "v 123456789012345678 4.9e-324 +3\nv 1 2 3 0.5 0.5 0.5\nf 1 2 3\n",
      "numbers.obj");
  ASSERT_TRUE(soup.ok()) << messageOf(soup);
  EXPECT_EQ(soup.value().positions,
            (std::vector<double>{0.1234567891, -0.98765432101, 1e-7, 1.7976931348623157e308, 0.5,
                                 -5, 123456789012345678.0, 4.9e-324, 3, 1, 2, 3}));
}

TEST(Obj, polygonsAreCutInside) {
  // A concave arrow, a convex octagon far from the origin, a quadrilateral with a reflex corner,
  // and a square with a point on one side: the areas add up, and no triangle is turned round.
  struct Case {
    const char* vertices;
    int corners;
    double area;
  };
  for (const Case& c : {Case{"v 0 0 5\nv 4 0 5\nv 4 4 5\nv 2 1 5\nv 0 4 5\n", 5, 10.0},
                        Case{"v 12 10 1\nv 14 10 1\nv 16 12 1\nv 16 14 1\nv 14 16 1\nv 12 16 1\nv "
                             "10 14 1\nv 10 12 1\n",
                             8, 28.0},
                        Case{"v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\n", 4, 1.0},
                        Case{"v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\n", 5, 4.0}}) {
    std::string face = "f";
    for (int i = 1; i <= c.corners; ++i) face += " " + std::to_string(i);
    const auto soup = soupOf(c.vertices + face + "\n", "polygon.obj");
    ASSERT_TRUE(soup.ok()) << messageOf(soup);
    const auto& triangles = soup.value().triangles;
    ASSERT_EQ(triangles.size(), 3u * static_cast<std::size_t>(c.corners - 2));
    double total = 0;
    for (std::size_t t = 0; t < triangles.size(); t += 3) {
      const auto x = [&](std::size_t k) { return soup.value().positions[3 * triangles[t + k]]; };
      const auto y = [&](std::size_t k) {
        return soup.value().positions[3 * triangles[t + k] + 1];
      };
      const double area = ((x(1) - x(0)) * (y(2) - y(0)) - (y(1) - y(0)) * (x(2) - x(0))) / 2;
      EXPECT_GT(area, 0) << c.vertices;
      total += area;
    }
    EXPECT_DOUBLE_EQ(total, c.area) << c.vertices;
  }
}

TEST(Obj, whatIsLeftOutIsNoted) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const auto model = modelOf(vertices +
                                 "o a\nusemtl red\nf 1 3 2\nf 1 2\ng b\ng c\nf 1 2 4\no empty\n"
                                 "usemtl blue\nf 1\n",
                             "a.obj");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(model.value().notes,
            (std::vector<std::string>{"2 faces with fewer than three corners were left out.",
                                      "Its 2 groups were put together.",
                                      "Its materials were left out."}));
  const auto coloured = modelOf("v 0 0 0 1 0.5 0\nv 1 0 0\nv 0 1 0\nf 1 3 2\n", "a.obj");
  ASSERT_TRUE(coloured.ok()) << messageOf(coloured);
  ASSERT_EQ(coloured.value().notes.size(), 1u);
  EXPECT_TRUE(contains(coloured.value().notes[0], "colours of its vertices"));
  const auto plain = modelOf("o a\ng b\n" + vertices + "f 1 3 2\nf 1 2 4\n", "a.obj");
  ASSERT_TRUE(plain.ok()) << messageOf(plain);
  EXPECT_TRUE(plain.value().notes.empty());
}

TEST(Obj, largePolygonsTakeNoTime) {
  std::string text;
  std::string face = "f";
  constexpr int kCorners = 2000;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 6.283185307179586 * i / kCorners;
    const double radius = i % 2 == 0 ? 1 : 2;
    text += "v " + std::to_string(radius * std::cos(angle)) + " " +
            std::to_string(radius * std::sin(angle)) + " 0\n";
    face += " " + std::to_string(i + 1);
  }
  const auto soup = soupOf(text + face + "\n", "star.obj");
  ASSERT_TRUE(soup.ok()) << messageOf(soup);
  EXPECT_EQ(soup.value().triangles.size(), 3u * (kCorners - 2));
}

TEST(BadObj, codesAndLines) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  struct Case {
    std::string text;
    const char* code;
    std::int64_t line;
  };
  for (const Case& c :
       {Case{vertices + "f 1 2 4\n", "INDEX_OUT_OF_RANGE", 4},
        Case{vertices + "f 0 1 2\n", "INDEX_OUT_OF_RANGE", 4},
        Case{vertices + "f -4 1 2\n", "INDEX_OUT_OF_RANGE", 4},
        Case{vertices + "f 4294967297 2 3\n", "INDEX_OUT_OF_RANGE", 4},
        Case{vertices + "f 99999999999999999999 2 3\n", "INDEX_OUT_OF_RANGE", 4},
        Case{vertices + "f 1 2\n", "EMPTY_MESH", -1},
        Case{vertices + "f 1 2 x\n", "MALFORMED_FILE", 4}, Case{"v 0 0\n", "MALFORMED_FILE", 1},
        Case{"v 0 0 zero\n", "MALFORMED_FILE", 1}, Case{"v 0 0 1,5\n", "MALFORMED_FILE", 1},
        Case{vertices + "\n\nv 0 0 nan\nf 1 2 4\n", "NON_FINITE_POSITION", 6},
        Case{"v 0 \\\n0 \\\n0\nv -inf 0 0\nv 0 1 0\nf 1 2 3\n", "NON_FINITE_POSITION", 4},
        Case{"v 1e999 0 0\n" + vertices + "f 1 2 3\n", "NON_FINITE_POSITION", 1},
        Case{"v nan 0 0\n", "EMPTY_MESH", -1}, Case{vertices, "EMPTY_MESH", -1},
        Case{"f 1 2 9\nf 1 2 12\n" + vertices, "INDEX_OUT_OF_RANGE", 1},
        Case{vertices + "l 1 2 3\np 1\n", "EMPTY_MESH", -1},
        Case{vertices + "curv 0 1 1 2 3\n", "UNSUPPORTED_FEATURE", -1},
        Case{"o nothing\n", "EMPTY_MESH", -1}}) {
    const auto result = read(c.text, "bad.obj");
    EXPECT_EQ(codeOf(result), c.code) << c.text;
    EXPECT_EQ(result.error().element, c.line) << c.text << messageOf(result);
  }
}

TEST(BadObj, vertexNowhereIsNamedWithItsFace) {
  const auto result =
      read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2\nv nan 0 0\nf 1 4 2 3\n", "a.obj");
  EXPECT_EQ(messageOf(result),
            "line 6: vertex 3 of face 2 has a coordinate that is not a finite number");
}

TEST(BadObj, twoCoordinatesAreNamed) {
  const auto flat = read("v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n", "flat.obj");
  EXPECT_EQ(messageOf(flat), "line 1: a vertex of two coordinates, but OBJ has three: x, y and z");
  EXPECT_TRUE(contains(flat.error().hint, "write a third one")) << flat.error().hint;
  EXPECT_TRUE(contains(messageOf(read("v 0\n", "flat.obj")), "fewer than three"));
}

TEST(BadObj, emptyFiles) {
  EXPECT_EQ(codeOf(read("", "a.obj")), "EMPTY_FILE");
  EXPECT_EQ(codeOf(read(" \n\t\r\n", "a.obj")), "EMPTY_FILE");
  EXPECT_EQ(codeOf(read("# only a comment\n", "a.obj")), "EMPTY_MESH");
  EXPECT_EQ(codeOf(read("hello\n", "a.obj")), "UNKNOWN_FORMAT");
  EXPECT_EQ(codeOf(read(std::string("v\0\0\0", 4), "a.obj")), "UNKNOWN_FORMAT");
}

}  // namespace
}  // namespace girth::io::testing
