// Files that the STL reader understands, and others that it refuses.
#include <array>
#include <limits>

#include "documents.h"

namespace girth::io::testing {
namespace {

/// One triangle of a binary file.
std::string triangle(std::initializer_list<float> corners) {
  return packedFloats({0, 0, 0}) + packedFloats(corners) + std::string(2, '\0');
}

const std::string kFour =
    triangle({0, 0, 0, 0, 1, 0, 1, 0, 0}) + triangle({0, 0, 0, 1, 0, 0, 0, 0, 1}) +
    triangle({0, 0, 0, 0, 0, 1, 0, 1, 0}) + triangle({1, 0, 0, 0, 1, 0, 0, 0, 1});

std::string binary(std::string begin, std::int64_t count, const std::string& triangles) {
  begin.resize(80, ' ');
  return begin + packed({count}, 4) + triangles;
}

std::string facet(const std::string& corners) {
  return "facet normal 0 0 1\nouter loop\n" + corners + "endloop\nendfacet\n";
}

const std::string kTwoFacets = facet("vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n") +
                               facet("vertex 0 0 0\nvertex 0 1 0\nvertex 0 0 1\n");

TEST(Stl, binary) {
  const auto model = modelOf(binary("made by hand", 4, kFour), "a.stl");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(model.value().format, Format::Stl);
  EXPECT_EQ(model.value().soup.positions.size(), 36u);
  EXPECT_EQ(model.value().soup.positions[4], 1);
  EXPECT_EQ(model.value().soup.triangles,
            (std::vector<Index>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
  EXPECT_TRUE(model.value().notes.empty());
  EXPECT_EQ(codeOf(read(binary("", 4, kFour), "a.stl")), "OK") << "closed once welded";
}

TEST(Stl, binaryWhateverItBeginsWith) {
  for (const char* begin :
       {"solid", "solid cube", "SOLID\nfacet", "OFF", "v 0 0 0", "{", "#", "PK"}) {
    for (const char* name : {"a.stl", "a", "a.obj"}) {
      const auto model = modelOf(binary(begin, 4, kFour), name);
      ASSERT_TRUE(model.ok()) << begin << messageOf(model);
      EXPECT_EQ(model.value().format, Format::Stl);
      EXPECT_EQ(model.value().soup.triangles.size(), 12u);
    }
  }
}

TEST(Stl, sizeAndCountDiffer) {
  for (const char* begin : {"", "solid by content"}) {
    std::string file = binary(begin, 4, kFour + "more");
    file[79] = '\0';
    auto model = modelOf(file, "a.stl");
    ASSERT_TRUE(model.ok()) << messageOf(model);
    EXPECT_EQ(model.value().soup.triangles.size(), 12u);
    ASSERT_EQ(model.value().notes.size(), 1u);
    EXPECT_TRUE(contains(model.value().notes[0], "4 bytes"));
    file[80] = 5;
    model = modelOf(file, "a.stl");
    EXPECT_EQ(codeOf(model), "MALFORMED_FILE");
    EXPECT_TRUE(contains(messageOf(model), "counts 5 triangles")) << messageOf(model);
    EXPECT_TRUE(contains(messageOf(model), "ends after 4")) << messageOf(model);
  }
  for (const std::int64_t count : {0LL, 1LL, 5LL, 808525944LL, 0xFFFFFFFFLL}) {
    for (const char* begin : {"", "solid\n \1"}) {
      const auto model = modelOf(binary(begin, count, kFour), "a.stl");
      ASSERT_TRUE(model.ok()) << messageOf(model);
      EXPECT_EQ(model.value().soup.triangles.size(), 12u);
      ASSERT_EQ(model.value().notes.size(), 1u);
      EXPECT_TRUE(contains(model.value().notes[0], "counts " + std::to_string(count) +
                                                       " triangles, but its size is that of 4"));
      EXPECT_EQ(contains(model.value().notes[0], "cut off"), count == 5 || count == 808525944);
    }
  }
}

TEST(Stl, ascii) {
  const auto model = modelOf("solid two facets\n" + kTwoFacets + "endsolid two facets\n", "a");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(model.value().format, Format::Stl);
  EXPECT_EQ(model.value().soup.triangles, (std::vector<Index>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(model.value().soup.positions[3], 1);
  EXPECT_TRUE(model.value().notes.empty());
}

TEST(Stl, asciiInOddClothes) {
  const std::string whole = "solid\n" + kTwoFacets + "endsolid\n";
  std::string upper, windows, spaced;
  for (const char c : whole) {
    upper += c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
    windows += c == '\n' ? "\r\n" : std::string(1, c);
    spaced += c == '\n' ? "\n\n" : c == ' ' ? " \t " : std::string(1, c);
  }
  std::string normals = whole;
  normals.replace(normals.find("normal 0 0 1"), 12, "normal nan -nan(ind) 0");
  std::string none = whole;
  none.replace(none.find("normal 0 0 1"), 12, "");
  std::string joined = whole;
  for (std::size_t at = joined.find('\n', 6); at != joined.npos; at = joined.find('\n', at)) {
    joined[at] = ' ';
  }
  for (const std::string& text : {upper, windows, spaced, "  \n" + whole, normals, none, joined}) {
    const auto soup = soupOf(text, "a.stl");
    ASSERT_TRUE(soup.ok()) << text << messageOf(soup);
    EXPECT_EQ(soup.value().triangles.size(), 6u) << text;
  }
}

TEST(Stl, coloursAreLeftOutWithANote) {
  std::string coloured = kFour;
  coloured[149] = '\x80';
  const auto model = modelOf(binary("", 4, coloured), "a.stl");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  ASSERT_EQ(model.value().notes.size(), 1u);
  EXPECT_TRUE(contains(model.value().notes[0], "colours, were left out")) << model.value().notes[0];
}

TEST(Stl, endsInTwoWords) {
  std::string text = "solid a\n" + kTwoFacets + "endsolid a\n";
  for (const char* what : {"loop", "facet", "solid"}) {
    const std::string whole = std::string("end") + what;
    for (std::size_t at = text.find(whole); at != text.npos; at = text.find(whole)) {
      text.replace(at, whole.size(), std::string("END \t") + what);
    }
    const auto model = modelOf(text, "a.stl");
    ASSERT_TRUE(model.ok()) << text << messageOf(model);
    EXPECT_EQ(model.value().soup.triangles.size(), 6u);
    EXPECT_TRUE(model.value().notes.empty()) << model.value().notes[0];
  }
  EXPECT_TRUE(
      contains(messageOf(soupOf("solid\n" + kTwoFacets + "end part\n", "a.stl")), "\"end\""));
}

TEST(Stl, controlCharactersArePadding) {
  const std::string nothing(60, '\0');
  for (const std::string& text :
       {"solid a" + nothing + "\n" + kTwoFacets + "endsolid a" + nothing + "\n",
        "solid " + nothing + kTwoFacets + "endsolid\n",
        "solid \1\2\x1B[1m\n" + kTwoFacets + "endsolid\n",
        "solid a\n" + kTwoFacets + "endsolid" + nothing,
        "solid a\n" + kTwoFacets + "endsolid\n\x1A",
        "solid a\n" + nothing + kTwoFacets + nothing + "\nendsolid a\n"}) {
    for (const char* name : {"a.stl", "a"}) {
      const auto model = modelOf(text, name);
      ASSERT_TRUE(model.ok()) << text << messageOf(model);
      EXPECT_EQ(model.value().soup.triangles.size(), 6u) << text;
      EXPECT_TRUE(model.value().notes.empty()) << text << model.value().notes[0];
    }
  }
}

TEST(Stl, textBehindKeywordsIsPassedOver) {
  const std::string whole = "solid\n" + kTwoFacets + "endsolid\n";
  const auto with = [&](const std::string& before, const std::string& after) {
    std::string text = whole;
    text.replace(text.find(before), before.size(), after);
    return modelOf(text, "a.stl");
  };
  for (const auto& [before, after, word] :
       {std::array<const char*, 3>{"endfacet\n", "endfacet part7\n",
                                   "line 8 was passed over: \"part7\"."},
        std::array<const char*, 3>{"endloop\n", "endloop 1 2\n", "line 7 was passed over: \"1\"."},
        std::array<const char*, 3>{"outer loop\n", "outer loop # a\n",
                                   "line 3 was passed over: \"#\"."},
        std::array<const char*, 3>{"vertex 1 0 0\n", "vertex 1 0 0 0.5 0.5 0.5\n",
                                   "line 5 was passed over: \"0.5\"."}}) {
    const auto model = with(before, after);
    ASSERT_TRUE(model.ok()) << after << messageOf(model);
    EXPECT_EQ(model.value().soup.triangles.size(), 6u) << after;
    ASSERT_EQ(model.value().notes.size(), 1u) << after;
    EXPECT_EQ(model.value().notes[0], std::string("Extra text on ") + word);
  }
  std::string each = whole;
  for (std::size_t at = each.find("endfacet"); at != each.npos;
       at = each.find("endfacet", at + 1)) {
    each.insert(at + 8, " end");
  }
  const auto model = modelOf(each, "a.stl");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(
      model.value().notes,
      std::vector<std::string>{"Extra text on 2 lines was passed over, first \"end\" on line 8."});
}

TEST(Stl, severalSolids) {
  const auto model =
      modelOf("solid a\n" + kTwoFacets + "endsolid a\n\nsolid b\nendsolid\nsolid c\n" + kTwoFacets,
              "a.stl");
  ASSERT_TRUE(model.ok()) << messageOf(model);
  EXPECT_EQ(model.value().soup.triangles.size(), 12u);
  ASSERT_EQ(model.value().notes.size(), 2u);
  EXPECT_TRUE(contains(model.value().notes[0], "3 solids"));
  EXPECT_TRUE(contains(model.value().notes[1], "endsolid"));
}

TEST(Stl, polygonsAreCut) {
  const auto soup = soupOf(
      "solid\n" + facet("vertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n") + "endsolid\n",
      "a.stl");
  ASSERT_TRUE(soup.ok()) << messageOf(soup);
  EXPECT_EQ(soup.value().triangles.size(), 6u);
  EXPECT_EQ(soup.value().positions.size(), 12u);
}

TEST(BadStl, codesAndPlaces) {
  std::string notFinite = kFour;
  notFinite.replace(50 + 16, 4, packedFloats({std::numeric_limits<float>::infinity()}));
  expectRefused(
      "bad.stl",
      {
          Refused{"solid a\nendsolid a\n", "EMPTY_MESH", -1, "no facets"},
          Refused{"solid a\n", "EMPTY_MESH", -1, "no facets"},
          Refused{"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "MALFORMED_FILE", 5,
                  "ends within a facet"},
          Refused{"solid a\nfacet\nouter loop\nvertex 0 0", "MALFORMED_FILE", 4, "within a vertex"},
          Refused{"solid a\nfacet\nouter loop\nvertex 0 0 o\n", "MALFORMED_FILE", 4, "\"o\""},
          Refused{"solid a\nfacet\nouter loop\nvertex 0 0 1e999\n", "NON_FINITE_POSITION", 4,
                  "\"1e999\""},
          Refused{"solid a\nvertex 0 0 0\n", "MALFORMED_FILE", 2, "outside of a facet"},
          Refused{"solid a\n" + facet("vertex 0 0 0\nvertex 1 0 0\n"), "MALFORMED_FILE", 6,
                  "fewer than three"},
          Refused{"solid a\nhello\n", "MALFORMED_FILE", 2, "\"hello\""},
          Refused{"solid a\nfacet\nouter loop\nfacet\n", "MALFORMED_FILE", 4, "within a facet"},
          Refused{"solid a\nfacet\nouter loop\nendsolid\n", "MALFORMED_FILE", 4, "not ended"},
          Refused{binary("", 5, kFour + "0"), "MALFORMED_FILE", 285, "counts 5 triangles"},
          Refused{std::string(40, '\1'), "MALFORMED_FILE", 40, "within the header"},
          Refused{binary("", 0, ""), "EMPTY_MESH", -1, "no triangles"},
          Refused{binary("", 4, notFinite), "NON_FINITE_POSITION", 3, "triangle 1"},
      });
}

}  // namespace
}  // namespace girth::io::testing
