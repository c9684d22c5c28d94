// Files that the OFF reader understands, and others that it refuses.
#include "documents.h"

namespace girth::io::testing {
namespace {

void expectTetrahedron(std::string_view text, std::string_view name = "a.off") {
  const auto model = modelOf(text, name);
  ASSERT_TRUE(model.ok()) << text << messageOf(model);
  EXPECT_EQ(model.value().format, Format::Off);
  EXPECT_EQ(model.value().soup.positions, kTetrahedronPositions) << text;
  EXPECT_EQ(model.value().soup.triangles, kTetrahedronTriangles) << text;
  for (const std::string& note : model.value().notes) {
    EXPECT_EQ(note, "Its colours were left out.") << text;
  }
}

TEST(Off, ascii) {
  expectTetrahedron("OFF\n4 4 6\n" + kVertexLines + kFaceLines);
  expectTetrahedron("OFF\n4 4 6\n" + kVertexLines + kFaceLines, "a.obj");
}

TEST(Off, headerVariants) {
  const std::string rest = "\n" + kVertexLines + kFaceLines;
  for (const char* begin : {"OFF 4 4 6", "OFF\n4 4", "OFF\n4\n4\n6", "OFF4 4 0", "off\n4 4 6",
                            "# first\n\nOFF # keyword\n# counts\n4 4 6 # edges"}) {
    expectTetrahedron(begin + rest);
  }
  expectTetrahedron("4 4 6" + rest, "no keyword.off");
}

TEST(Off, whatPrefixesAnnounceIsPassedOver) {
  expectTetrahedron(
      "COFF\n4 4 6\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n0 1 0 0 0 0 0\n0 0 1 1 0 0 1\n" + kFaceLines);
  expectTetrahedron("NOFF\n4 4 6\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 0 1 0 0 1\n" +
                    kFaceLines);
  expectTetrahedron("STOFF\n4 4 6\n0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n0 0 1 1 1\n" + kFaceLines);
  for (const char* keyword : {"CNOFF", "NCOFF", "STCNOFF"}) {
    expectTetrahedron(std::string(keyword) + "\n4 4 6\n" + kVertexLines + kFaceLines);
  }
  // Colours of vertices that no prefix announces, and of faces in every form.
  expectTetrahedron(
      "OFF\n4 4 6\n0 0 0 9 9 9\n1 0 0 9 9 9\n0 1 0 9 9 9\n0 0 1 9 9 9\n"
      "3 0 2 1 7\n3 0 1 3 255 0 0\n3 0 3 2 0.5 0.5 0.5 1.0 # red\n3 1 2 3\n");
}

TEST(Off, homogeneousCoordinatesAreDivided) {
  expectTetrahedron("4OFF\n4 4 6\n0 0 0 2\n2 0 0 2\n0 -3 0 -3\n0 0 0.5 0.5\n" + kFaceLines);
  const auto atInfinity = soupOf("4OFF\n3 1 0\n0 0 0 2\n2 0 0 0\n0 1 0 1\n3 0 1 2\n", "a.off");
  EXPECT_EQ(codeOf(atInfinity), "NON_FINITE_POSITION");
}

TEST(Off, linesMayBeBrokenAnywhere) {
  std::string everyNumber = "OFF 4 4 6 " + kVertexLines + kFaceLines;
  std::string oneLine = everyNumber, wrapped;
  for (char& c : everyNumber) c = c == ' ' ? '\n' : c;
  for (char& c : oneLine) c = c == '\n' ? ' ' : c;
  int numbers = 0;
  for (const char c : oneLine) wrapped += c == ' ' && ++numbers % 7 == 0 ? '\n' : c;
  const std::string twoALine = "0 0 0 1 0 0\n0 1 0 0 0 1\n";
  const std::string faceContinued = "3 0\n2 1\n3\n0 1 3\n3 0 3 2\n3 1 2 3\n";
  for (const std::string& text :
       {everyNumber, oneLine, wrapped, "OFF\n4 4 6\n" + twoALine + kFaceLines,
        "OFF\n4 4\n" + twoALine + kFaceLines, "OFF\n4 4\n6\n" + twoALine + kFaceLines,
        "OFF\n4\n4\n6\n" + twoALine + kFaceLines, "OFF\n4 4 6\n" + twoALine + faceContinued,
        "OFF\n4 4 6\n0\n0\n0 # first\n\n1 0\n0\n0 1 0 0\n0 1\n" + kFaceLines,
        "OFF\n4 4 6\n" + kVertexLines + faceContinued,
        "OFF\n4 4 6\n" + twoALine + "3 0 2 1 7\n3 0 1 3 255 0 0\n3 0 3 2 0.5 0.5 0.5 1\n3 1 2 3\n",
        "OFF\n4 4 6\n" + twoALine + "3 0 2 1 3 0 1 3\n3 0 3 2 3 1 2 3\n",
        "4OFF\n4 4 6\n0 0 0 2 2 0 0 2\n0 -3 0 -3 0 0 0.5\n0.5\n" + kFaceLines,
        std::string(
            "CNOFF\n4 4 6\n0 0 0 0 0 1\n1 1 1 1\n1 0 0 0 0 1 1 1 1 1 0 1 0 0 0 1 1 1 1 1\n") +
            "0 0 1 0 0 1\n1 1 1 1\n" + kFaceLines}) {
    expectTetrahedron(text);
  }
}

TEST(Off, whatIsMissingIsNoBrokenLine) {
  const std::string quads = "4 3 2 1 0\n4 3 2 1 0\n";
  for (const std::string& text :
       {"OFF\n4 4 6\n0 0 0\n1 0\n0 1 0\n0 0 1\n" + kFaceLines,
        "OFF\n4 4 6\n0 0 0\n1\n0 1 0\n0 0 1\n" + kFaceLines,
        "OFF\n4 4 6\n0 0 0\n0 1 0\n0 0 1\n" + kFaceLines,
        "OFF\n4 2 0\n0 0 0\n1 0\n0 1 0\n0 0 1\n" + quads,
        "OFF\n4 4 6\n0 0 0 1 0 0\n0 1 0 0 0 1\n" + kFaceLines + "9\n",
        "OFF\n4 4 6\n0 0 0 1 0 0\n0 1 0 0 0 1\n" + kFaceLines.substr(8)}) {
    const auto model = soupOf(text, "a.off");
    EXPECT_EQ(codeOf(model), "MALFORMED_FILE") << text;
  }
}

TEST(Off, binary) {
  const auto big = [](const std::string& little) {
    std::string bytes;
    for (std::size_t i = 0; i < little.size(); i += 4) {
      bytes += {little[i + 3], little[i + 2], little[i + 1], little[i]};
    }
    return bytes;
  };
  const std::string counts = packed({4, 4, 6}, 4);
  const std::string faces = packed({3, 0, 2, 1, 0, 3, 0, 1, 3, 3}, 4) + packedFloats({1, 0, 0}) +
                            packed({3, 0, 3, 2, 1}, 4) + packedFloats({1}) +
                            packed({3, 1, 2, 3, 0}, 4);
  const std::string plain = packedFloats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  expectTetrahedron("OFF BINARY\n" + big(counts + plain + faces));
  expectTetrahedron("OFF BINARY \r\n" + big(counts + plain + faces));
  const std::string coloured = packedFloats(
      {0, 0, 0, 1, 1, 1, 1, 1, 0, 0, 1, 1, 1, 1, 0, 1, 0, 1, 1, 1, 1, 0, 0, 1, 1, 1, 1, 1});
  expectTetrahedron("COFF BINARY\n" + big(counts + coloured + faces));
  const std::string homogeneous = packedFloats({0, 0, 0, 2, 2, 0, 0, 2, 0, 2, 0, 2, 0, 0, 2, 2});
  expectTetrahedron("4OFF BINARY\n" + big(counts + homogeneous + faces));
  const std::string whole = "OFF BINARY\n" + big(counts + plain + faces);
  for (std::size_t length = 11; length < whole.size(); ++length) {
    ASSERT_EQ(codeOf(soupOf(whole.substr(0, length), "a.off")), "MALFORMED_FILE") << length;
  }
  const auto outside = soupOf("OFF BINARY\n" + big(packed({1, 1, 0}, 4) + packedFloats({0, 0, 0}) +
                                                   packed({3, 0, 0, 1, 0}, 4)),
                              "a.off");
  EXPECT_EQ(codeOf(outside), "INDEX_OUT_OF_RANGE");
  EXPECT_TRUE(contains(messageOf(outside), "vertex 1 of 1")) << messageOf(outside);
  for (const auto& text :
       {big(packed({2147483647, 4, 6}, 4) + plain), big(packed({-1, 4, 6}, 4) + plain),
        big(packed({0, 2147483647, 6}, 4) + packed({2147483647}, 4))}) {
    EXPECT_EQ(codeOf(soupOf("OFF BINARY\n" + text, "a.off")), "MALFORMED_FILE");
  }
}

TEST(Off, coloursAreLeftOutWithANote) {
  const auto notesOf = [](const std::string& text) {
    const auto model = modelOf(text, "a.off");
    EXPECT_TRUE(model.ok()) << messageOf(model);
    return model.ok() ? model.value().notes : std::vector<std::string>();
  };
  const std::vector<std::string> note{"Its colours were left out."};
  const std::string some = "3 0 2 1\n3 0 1 3 7\n3 0 3 2\n3 1 2 3\n";
  EXPECT_EQ(notesOf("OFF\n4 4 6\n" + kVertexLines + some), note);
  EXPECT_EQ(notesOf("OFF\n4 4 6\n0 0 0 1 1 1\n1 0 0\n0 1 0\n0 0 1\n" + kFaceLines), note);
  EXPECT_EQ(notesOf("COFF\n4 4 6\n0 0 0 1 1 1 1\n1 0 0\n0 1 0\n0 0 1\n" + kFaceLines), note);
  EXPECT_TRUE(notesOf("OFF\n4 4 6\n" + kVertexLines + kFaceLines).empty());
  EXPECT_TRUE(
      notesOf("STOFF\n4 4 6\n0 0 0 1 1\n1 0 0 1 1\n0 1 0 1 1\n0 0 1 1 1\n" + kFaceLines).empty());
}

TEST(Off, polygonsAndFewerCorners) {
  const auto model =
      modelOf("OFF\n5 3 0\n0 0 0\n4 0 0\n4 4 0\n2 1 0\n0 4 0\n5 0 1 2 3 4\n2 0 1\n1 0\n", "a.off");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(model.value().soup.triangles.size(), 9u);
  ASSERT_EQ(model.value().notes.size(), 1u);
  EXPECT_TRUE(contains(model.value().notes[0], "2 faces"));
}

TEST(BadOff, codesAndLines) {
  expectRefused(
      "bad.off",
      {
          Refused{"OFF\n", "MALFORMED_FILE", 2, "number of vertices"},
          Refused{"OFF\n1\n", "MALFORMED_FILE", 3, "number of faces"},
          Refused{"OFF\nx 4 0\n", "MALFORMED_FILE", 2, "\"x\""},
          Refused{"OFF\n-4 4 0\n", "MALFORMED_FILE", 2, "\"-4\""},
          Refused{"OFF\n4000000000 4 0\n0 0 0\n", "MALFORMED_FILE", 2, "more than the file"},
          Refused{"OFF\n4 4 0\n" + kVertexLines.substr(0, 12), "MALFORMED_FILE", 5,
                  "ends after 2 of 4 vertices"},
          Refused{"OFF\n4 4 0\n0 0\n0 0 0\n0 0 0\n", "MALFORMED_FILE", 3, "fewer than 3"},
          Refused{"OFF\n4 4 0\n0 0 o\n0 0 0\n0 0 0\n", "MALFORMED_FILE", 3, "\"o\""},
          Refused{"OFF\n3 2 0\n0 0 inf\n0 0 0\n0 0 0\n2 1 2\n3 0 1 2\n", "NON_FINITE_POSITION", 3,
                  "line 3: vertex 0 of face 1 has"},
          Refused{"OFF\n4 4 0\n" + kVertexLines + "3 0 1 2\n", "MALFORMED_FILE", 8, "1 of 4 faces"},
          Refused{"OFF\n4 4 0\n" + kVertexLines + "3 0 1\n3 0 1 2\n", "MALFORMED_FILE", 7,
                  "2 corners in place of 3"},
          Refused{"OFF\n4 4 0\n" + kVertexLines + "3 0 1 4\n", "INDEX_OUT_OF_RANGE", 7,
                  "vertex 4 of 4"},
          Refused{"OFF\n4 4 0\n" + kVertexLines + "3 0 1 -1\n", "INDEX_OUT_OF_RANGE", 7,
                  "vertex -1"},
          Refused{"OFF\n4 0 0\n" + kVertexLines, "EMPTY_MESH", -1, "point cloud: 4 points"},
          Refused{"OFF\n0 0 0\n", "EMPTY_MESH", -1, "neither"},
          Refused{"nOFF\n4\n4 4 0\n", "UNSUPPORTED_FEATURE", 1, "nOFF"},
          Refused{"4nOFF\n4\n4 4 0\n", "UNSUPPORTED_FEATURE", 1, "nOFF"},
      });
}

TEST(BadOff, whatFollowsIsNoted) {
  const auto model = modelOf("OFF\n4 3 0\n" + kVertexLines + kFaceLines, "a.off");
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model.value().notes.size(), 1u);
}

}  // namespace
}  // namespace girth::io::testing
