// Numbers, fields and loops as text.
#include <array>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>

#include "documents.h"
#include "girth/io/number_text.h"
#include "girth/io/write_field.h"
#include "girth/io/write_loop.h"

namespace girth::io::testing {
namespace {

TEST(NumberText, reads) {
  EXPECT_EQ(parseNumber("0.1"), 0.1);
  EXPECT_EQ(parseNumber("-1.5e-3"), -1.5e-3);
  EXPECT_EQ(parseNumber("+.5"), 0.5);
  EXPECT_EQ(parseNumber("9007199254740993"), 9007199254740993.0);
  EXPECT_EQ(parseNumber("2.2250738585072011e-308"), 2.2250738585072011e-308);
  EXPECT_EQ(parseNumber("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(*parseNumber("NaN")));
  for (const char* text : {"", "-", ".", "e5", "1e", "1e+", "1.2.3", "0x10", "1,5", "12a", " 1"}) {
    EXPECT_FALSE(parseNumber(text).has_value()) << text;
  }
}

TEST(NumberText, readsAsTheStandardLibraryDoes) {
  std::uint64_t state = 1;
  const auto random = [&](std::uint64_t below) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (state >> 33) % below;
  };
  for (int i = 0; i < 200000; ++i) {
    // Up to 21 digits with the point anywhere, and every other number with an exponent.
    std::string text;
    const std::uint64_t digits = 1 + random(21), point = random(digits + 1);
    for (std::uint64_t d = 0; d < digits; ++d) {
      if (d == point) text += '.';
      text += static_cast<char>('0' + random(10));
    }
    if (random(2) == 0) text += "e" + std::to_string(static_cast<int>(random(80)) - 40);
    ASSERT_EQ(parseNumber(text), std::strtod(text.c_str(), nullptr)) << text;
  }
  // Halfway between two doubles, and a hair off.
  for (const char* text :
       {"9007199254740993e0", "9007199254740992.5", "9007199254740993.0001", "9007199254740991.5",
        "4503599627370496.5", "4503599627370497.5", "4503599627370497.499", "0.5000000000000000555",
        "1.00000000000000011", "1.000000000000000111022302462515654",
        "0.000000000000000000000000001", "900000000000000000.5", "999999999999999999e-27"}) {
    EXPECT_EQ(parseNumber(text), std::strtod(text, nullptr)) << text;
  }
}

TEST(NumberText, readsBackWhatItWrites) {
  std::uint64_t state = 12345;
  for (int i = 0; i < 20000; ++i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const double value = std::bit_cast<double>(state ^ state >> 29);
    if (!std::isfinite(value)) continue;
    ASSERT_EQ(parseNumber(formatNumber(value)), value) << formatNumber(value);
  }
  EXPECT_EQ(formatNumber(0.1), "0.1");
  EXPECT_EQ(formatNumber(1.0 / 3), "0.3333333333333333");
  EXPECT_EQ(formatNumber(-2), "-2");
}

/// Sets a locale with a decimal comma, made of `comma.locale` where the system has none of its own.
bool setDecimalComma() {
  std::string folder = (std::filesystem::temp_directory_path() / "girth-XXXXXX").string();
  if (mkdtemp(folder.data()) == nullptr) return false;
  // It complains of all that the locale does not say, and writes what it does.
  const std::string make = "localedef --quiet -c -i \"" GIRTH_TEST_DATA "/comma.locale\" \"" +
                           folder + "/comma\" 2> /dev/null";
  const bool made = std::system(make.c_str()) != -1;
  setenv("LOCPATH", folder.c_str(), 1);
  const bool set = made && std::setlocale(LC_NUMERIC, "comma") != nullptr;
  unsetenv("LOCPATH");
  std::filesystem::remove_all(folder);
  return set || std::setlocale(LC_NUMERIC, "de_DE.UTF-8") != nullptr;
}

TEST(NumberText, independentOfTheLocale) {
  if (!setDecimalComma()) GTEST_SKIP() << "skipped: no locale with a decimal comma can be had";
  std::array<char, 8> written{};
  std::snprintf(written.data(), written.size(), "%.1f", 1.5);
  EXPECT_STREQ(written.data(), "1,5");
  EXPECT_EQ(formatNumber(1.5), "1.5");
  EXPECT_EQ(formatNumber(1234567.25), "1234567.25");
  EXPECT_EQ(parseNumber("1.23456789012345678901"), 1.23456789012345678901);
  std::setlocale(LC_NUMERIC, "C");
}

/// A tetrahedron with a vertex that no face uses, and one that is welded onto the first.
LoadedMesh sample() {
  auto loaded = read(
      "v 0 0 0\nv 9 9 9\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 0\n"
      "f 1 4 3\nf 6 3 5\nf 1 5 4\nf 3 4 5\n",
      "sample.obj");
  EXPECT_TRUE(loaded.ok()) << messageOf(loaded);
  return std::move(loaded).value();
}

GirthField sampleField() {
  GirthField field;
  field.values = {1.5, 1.0 / 3, std::numeric_limits<double>::quiet_NaN(), 2};
  field.kinds = {LoopKind::Loop, LoopKind::Antipodal, LoopKind::Loop, LoopKind::Loop};
  field.computed = 3;
  return field;
}

TEST(WriteField, csvInTheFilesOrder) {
  EXPECT_EQ(fieldCsv(sample(), sampleField()),
            "vertex,igf,kind\n0,1.5,loop\n1,,\n2,0.3333333333333333,antipodal\n3,,\n4,2,loop\n"
            "5,1.5,loop\n");
}

TEST(WriteField, json) {
  EXPECT_EQ(fieldJson(sample(), sampleField(), {"a\"b.obj", GirthMethod::Exact}),
            "{\"file\":\"a\\\"b.obj\",\"field\":\"igf\",\"method\":\"exact\",\"unit\":\"\","
            "\"complete\":false,\"vertices\":6,\n"
            "\"igf\":[1.5,null,0.3333333333333333,null,2,1.5],\n"
            "\"kind\":[\"loop\",null,\"antipodal\",null,\"loop\",\"loop\"]}\n");
}

TEST(WriteField, plyOfTheSurface) {
  const std::string ply = fieldPly(sample(), sampleField());
  const std::string end = "end_header\n";
  const std::size_t header = ply.find(end) + end.size();
  EXPECT_TRUE(contains(ply.substr(0, header), "element vertex 4\n"));
  EXPECT_TRUE(contains(ply.substr(0, header), "property double igf\nproperty uchar kind\n"));
  EXPECT_EQ(ply.size(), header + 4 * 33 + 4 * 13);
  EXPECT_EQ(ply.substr(header + 24, 9), packed({std::bit_cast<std::int64_t>(1.5)}, 8) + '\0');
  EXPECT_EQ(ply[header + 2 * 33 + 32], '\xFF') << "not computed";
  EXPECT_EQ(ply.substr(ply.size() - 13), '\x03' + packed({1, 2, 3}, 4));
}

TEST(WriteLoop, allFormats) {
  const LoadedMesh loaded = sample();
  GirthLoop loop;
  loop.length = 2.5;
  loop.angle = 1;
  loop.base = SurfacePoint::atVertex(1);
  const SurfacePoint middle = SurfacePoint::onHalfedge(loaded.mesh.outgoing(0), 0.25);
  loop.points = {SurfacePoint::atVertex(1), middle, SurfacePoint::atVertex(1)};
  loop.midpoint = middle;
  const std::string json = loopJson(loaded, loop, "sample.obj", true);
  EXPECT_TRUE(contains(
      json,
      R"({"file":"sample.obj","vertex":2,"base":{"position":[1,0,0],"vertices":[2],"weights":[1]},"length":2.5,"kind":"loop","angle":1)"))
      << json;
  EXPECT_TRUE(contains(json, R"("vertices":[2],"weights":[1]})")) << json;
  EXPECT_TRUE(contains(json, R"("weights":[0.75,0.25]})")) << json;
  const std::string csv = loopCsv(loaded, loop);
  EXPECT_TRUE(contains(csv, "x,y,z\n1,0,0\n")) << csv;
  const std::string obj = loopObj(loaded, loop);
  EXPECT_TRUE(contains(obj, "v 1 0 0\n")) << obj;
  EXPECT_TRUE(contains(obj, "\nl 1 2 1\n")) << obj;
}

}  // namespace
}  // namespace girth::io::testing
