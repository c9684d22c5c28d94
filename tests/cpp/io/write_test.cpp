// Numbers, fields and loops as text.
#include <array>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <string>
#include <utility>

#include "documents.h"
#include "girth/io/write_barcodes.h"
#include "girth/io/write_field.h"
#include "girth/io/write_loop.h"
#include "girth/io/write_mesh.h"
#include "test_paths.h"
#include "text/number_text.h"

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

TEST(NumberText, readsAnyLengthRoundedCorrectly) {
  const std::string zeros(700, '0');
  const double least = std::numeric_limits<double>::denorm_min();
  const double greatest = std::numeric_limits<double>::max();
  const double none = std::numeric_limits<double>::infinity();
  for (const auto& [text, value] : {
           // Halfway goes to the even one; the least digit behind it decides, however far behind.
           std::pair{"9007199254740993." + zeros, 0x1p53},
           {"9007199254740993." + zeros + "1", 0x1p53 + 2},
           {"-9007199254740995." + zeros, -0x1p53 - 4},
           {"0." + zeros + "1e701", 1.0},
           {"1" + zeros + "e-700", 1.0},
           {"3" + zeros + "1e-701", 3.0},
           // Half of the least number, and a little more; numbers that are not normal.
           {"2.4703282292062327e-324", 0.0},
           {"2.4703282292062328e-324", least},
           {"2.2250738585072011e-308", 0x0.fffffffffffffp-1022},
           {"2.2250738585072014e-308", 0x1p-1022},
           {"1e-400", 0.0},
           // The greatest number, and what is rounded beyond it.
           {"1.7976931348623158079e308", greatest},
           {"1.7976931348623158080e308", none},
           {"-1e310", -none},
       }) {
    EXPECT_EQ(parseNumber(text), value) << text;
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
#ifdef _WIN32
  return std::setlocale(LC_NUMERIC, "German_Germany") != nullptr;
#else
  const std::string folder = test::newFolder().string();
  // It complains of all that the locale does not say, and writes what it does.
  const std::string make = "localedef --quiet -c -i " +
                           test::quoted(test::testData() + "/comma.locale") + " " +
                           test::quoted(folder + "/comma") + " 2> /dev/null";
  const bool made = std::system(make.c_str()) != -1;
  setenv("LOCPATH", folder.c_str(), 1);
  const bool set = made && std::setlocale(LC_NUMERIC, "comma") != nullptr;
  unsetenv("LOCPATH");
  std::filesystem::remove_all(folder);
  return set || std::setlocale(LC_NUMERIC, "de_DE.UTF-8") != nullptr;
#endif
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

using Json = nlohmann::json;

/// The document of a GLB file whose container is as it should be.
Json jsonOf(const std::string& file) {
  const auto numberAt = [&](std::size_t at) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      number |= std::size_t{static_cast<unsigned char>(file[at + i])} << (8 * i);
    }
    return number;
  };
  EXPECT_EQ(file.substr(0, 4), "glTF");
  EXPECT_EQ(numberAt(4), 2u);
  EXPECT_EQ(numberAt(8), file.size());
  const std::size_t length = numberAt(12);
  EXPECT_EQ(length % 4, 0u);
  EXPECT_EQ(numberAt(16), 0x4E4F534Au);
  EXPECT_EQ(numberAt(20 + length), file.size() - 28 - length);
  EXPECT_EQ(numberAt(24 + length), 0x004E4942u);
  Json document = Json::parse(file.substr(20, length));
  EXPECT_EQ(document["buffers"][0]["byteLength"], numberAt(20 + length));
  return document;
}

/// Where in a GLB file an accessor's values begin.
std::size_t offsetOf(const std::string& file, const Json& accessor) {
  const Json document = jsonOf(file);
  const Json& view = document["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  const std::size_t offset = view.value("byteOffset", std::size_t{0});
  EXPECT_EQ(offset % 4, 0u);
  return file.size() - document["buffers"][0]["byteLength"].get<std::size_t>() + offset;
}

/// The values of an accessor of floats.
std::vector<float> floatsOf(const std::string& file, const Json& number) {
  const Json document = jsonOf(file);
  const Json& accessor = document["accessors"][number.get<std::size_t>()];
  EXPECT_EQ(accessor["componentType"], 5126);
  const std::size_t count =
      accessor["count"].get<std::size_t>() * (accessor["type"] == "VEC3" ? 3 : 1);
  std::vector<float> values(count);
  std::memcpy(values.data(), file.data() + offsetOf(file, accessor), 4 * count);
  return values;
}

std::vector<float> floatsOf(const std::vector<Vec3>& points) {
  std::vector<float> values;
  for (const Vec3& p : points) {
    values.insert(values.end(),
                  {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  }
  return values;
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

/// The fields that are written about sampleField.
std::vector<VertexField> fieldsOf(const GirthField& field) {
  return {girthVertexField(field, GirthMethod::Exact, "")};
}

TEST(WriteField, csvInTheFilesOrder) {
  const GirthField field = sampleField();
  EXPECT_EQ(fieldCsv(sample(), fieldsOf(field)),
            "vertex,igf,kind\n0,1.5,loop\n1,,\n2,0.3333333333333333,antipodal\n3,,\n4,2,loop\n"
            "5,1.5,loop\n");
}

TEST(WriteField, json) {
  const GirthField field = sampleField();
  EXPECT_EQ(
      fieldJson(sample(), fieldsOf(field), "a\"b.obj"),
      "{\"file\":\"a\\\"b.obj\",\"unit\":\"\",\"complete\":false,\"vertices\":6,"
      "\"fields\":[{\"name\":\"igf\",\"method\":\"exact\",\"unit\":\"\",\"complete\":false}],\n"
      "\"igf\":[1.5,null,0.3333333333333333,null,2,1.5],\n"
      "\"kind\":[\"loop\",null,\"antipodal\",null,\"loop\",\"loop\"]}\n");
}

TEST(WriteField, plyOfTheSurface) {
  const GirthField field = sampleField();
  const std::string ply = fieldPly(sample(), fieldsOf(field));
  const std::string end = "end_header\n";
  const std::size_t header = ply.find(end) + end.size();
  EXPECT_TRUE(contains(ply.substr(0, header), "element vertex 4\n"));
  EXPECT_TRUE(contains(ply.substr(0, header), "property double igf\nproperty uchar kind\n"));
  EXPECT_EQ(ply.size(), header + 4 * 33 + 4 * 13);
  EXPECT_EQ(ply.substr(header + 24, 9), packed({std::bit_cast<std::int64_t>(1.5)}, 8) + '\0');
  EXPECT_EQ(ply[header + 2 * 33 + 32], '\xFF') << "not computed";
  EXPECT_EQ(ply.substr(ply.size() - 13), '\x03' + packed({1, 2, 3}, 4));
}

/// A field whose values need every bit, on a shape of many vertices.
struct Wild {
  LoadedMesh loaded;
  std::vector<double> values;
};

Wild wild() {
  // A pyramid over a polygon, so that there is a vertex for every value.
  std::vector<double> values{0.1,
                             1.0 / 3,
                             -1e-300,
                             4.9406564584124654e-324,
                             1.7976931348623157e308,
                             2.2250738585072014e-308,
                             -0.0,
                             9007199254740992.0,
                             3.0000000000000004,
                             std::nextafter(1.0, 2.0)};
  std::uint64_t state = 99;
  while (values.size() < 400) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    const double value = std::bit_cast<double>(state ^ state >> 29);
    if (std::isfinite(value)) values.push_back(value);
  }
  values[200] = std::numeric_limits<double>::quiet_NaN();
  std::string text = "v 0 0 1\nv 0 0 -1\n";
  const std::size_t ring = values.size() - 2;
  for (std::size_t i = 0; i < ring; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(ring);
    text += "v " + formatNumber(std::cos(angle)) + " " + formatNumber(std::sin(angle)) + " 0\n";
  }
  for (std::size_t i = 0; i < ring; ++i) {
    const std::string a = std::to_string(3 + i), b = std::to_string(3 + (i + 1) % ring);
    text += "f 1 " + a + " " + b + "\nf 2 " + b + " " + a + "\n";
  }
  auto loaded = read(text, "wild.obj");
  EXPECT_TRUE(loaded.ok()) << messageOf(loaded);
  return {std::move(loaded).value(), std::move(values)};
}

/// The bits, so that 0 and -0, and NaN and NaN, compare as they should.
std::vector<std::uint64_t> bitsOf(std::span<const double> values) {
  std::vector<std::uint64_t> bits;
  for (const double value : values) bits.push_back(std::bit_cast<std::uint64_t>(value));
  return bits;
}

double doubleAt(const std::string& bytes, std::size_t at) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    bits |= std::uint64_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  }
  return std::bit_cast<double>(bits);
}

TEST(WriteField, csvKeepsEveryBit) {
  const Wild w = wild();
  const VertexField field{"wild", w.values, "", "", {}};
  std::istringstream lines(fieldCsv(w.loaded, std::span(&field, 1)));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "vertex,wild");
  std::vector<double> values;
  while (std::getline(lines, line)) {
    const std::size_t comma = line.find(',');
    EXPECT_EQ(line.substr(0, comma), std::to_string(values.size()));
    // The C library's own conversion, which is exact.
    values.push_back(comma + 1 == line.size() ? std::numeric_limits<double>::quiet_NaN()
                                              : std::strtod(line.c_str() + comma + 1, nullptr));
  }
  EXPECT_EQ(bitsOf(values), bitsOf(w.values));
}

TEST(WriteField, npyKeepsEveryBit) {
  const Wild w = wild();
  const VertexField field{"wild", w.values, "", "", {}};
  const std::string npy = fieldNpy(w.loaded, field);
  ASSERT_EQ(npy.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t length =
      static_cast<unsigned char>(npy[8]) + 256u * static_cast<unsigned char>(npy[9]);
  EXPECT_EQ((10 + length) % 64, 0u);
  EXPECT_EQ(npy.substr(10, 61), "{'descr': '<f8', 'fortran_order': False, 'shape': (400,), }  ");
  EXPECT_EQ(npy[10 + length - 1], '\n');
  ASSERT_EQ(npy.size(), 10 + length + 8 * w.values.size());
  std::vector<double> values;
  for (std::size_t i = 0; i < w.values.size(); ++i) {
    values.push_back(doubleAt(npy, 10 + length + 8 * i));
  }
  EXPECT_EQ(bitsOf(values), bitsOf(w.values));
}

TEST(WriteField, npyIsOfTheFile) {
  const GirthField field = sampleField();
  const std::string npy = fieldNpy(sample(), fieldsOf(field)[0]);
  ASSERT_EQ(npy.size(), 128u + 6 * 8);
  const auto at = [&](std::size_t i) { return doubleAt(npy, 128 + 8 * i); };
  EXPECT_EQ(at(0), 1.5);
  EXPECT_TRUE(std::isnan(at(1))) << "no face uses it";
  EXPECT_EQ(at(2), 1.0 / 3);
  EXPECT_TRUE(std::isnan(at(3))) << "not computed";
  EXPECT_EQ(at(5), 1.5) << "welded";
}

TEST(WriteField, plyKeepsEveryBit) {
  const Wild w = wild();
  const VertexField field{"wild", w.values, "metre", "exact", {}};
  const std::string ply = fieldPly(w.loaded, std::span(&field, 1));
  const std::size_t body = ply.find("end_header\n") + 11;
  EXPECT_TRUE(contains(ply.substr(0, body), "comment wild (metre, exact)\n"));
  EXPECT_TRUE(contains(ply.substr(0, body), "property double z\nproperty double wild\n"));
  std::vector<double> values;
  for (std::size_t i = 0; i < w.values.size(); ++i) {
    values.push_back(doubleAt(ply, body + 32 * i + 24));
  }
  EXPECT_EQ(bitsOf(values), bitsOf(w.values));
  // The surface itself comes back through our own reader.
  const auto again = read(ply, "wild.ply");
  ASSERT_TRUE(again.ok()) << messageOf(again);
  ASSERT_EQ(again.value().mesh.vertexCount(), w.loaded.mesh.vertexCount());
  for (const Vertex v : w.loaded.mesh.vertices()) {
    ASSERT_EQ(again.value().mesh.position(v).x, w.loaded.mesh.position(v).x);
    ASSERT_EQ(again.value().mesh.position(v).y, w.loaded.mesh.position(v).y);
  }
}

TEST(WriteField, severalFields) {
  const GirthField girth = sampleField();
  const std::vector<double> other{-1, 2, 3, 4};
  std::vector<VertexField> fields = fieldsOf(girth);
  fields.push_back({"sdf", other, "metre", "", {}});
  EXPECT_EQ(fieldCsv(sample(), fields).substr(0, 41),
            "vertex,igf,kind,sdf\n0,1.5,loop,-1\n1,,,\n2,");
  const Json json = Json::parse(fieldJson(sample(), fields, "a"));
  EXPECT_EQ(json["sdf"], Json::parse("[-1,null,2,3,4,-1]"));
  EXPECT_EQ(json["fields"][1]["unit"], "metre");
  EXPECT_TRUE(contains(fieldPly(sample(), fields),
                       "property double igf\nproperty uchar kind\nproperty double sdf\n"));
}

TEST(WriteField, whatFilesCannotHoldIsSaid) {
  const LoadedMesh loaded = sample();
  const GirthField girth = sampleField();
  const std::vector<double> other{-1, 2, 3, 4}, few{1, 2, 3};
  const std::vector<VertexField> igf = fieldsOf(girth);
  const auto check = [&](std::vector<VertexField> fields) -> std::string {
    const auto error = checkFields(loaded, fields);
    if (!error) return "";
    EXPECT_EQ(error->code, ErrorCode::Usage);
    return error->message;
  };
  EXPECT_EQ(check({igf[0], {"part_2", other, "", "", {}}}), "");
  EXPECT_EQ(check({}), "there is no field to write");
  for (const char* name : {"", "2a", "A", "a,b", "a b", "\xc3\xa4", "_a", "a\n"}) {
    EXPECT_TRUE(contains(check({{name, other, "", "", {}}}), "is not a name")) << name;
  }
  for (const char* name : {"vertex", "kind", "x", "igf"}) {
    EXPECT_TRUE(contains(check({igf[0], {name, other, "", "", {}}}), "is taken")) << name;
  }
  EXPECT_TRUE(contains(check({{"sdf", few, "", "", {}}}), "3 values"));
  EXPECT_TRUE(
      contains(check({{"sdf", other, "", "", std::span(girth.kinds).first(2)}}), "2 kinds"));
  EXPECT_TRUE(contains(check({igf[0], {"again", other, "", "", girth.kinds}}), "several"));
}

TEST(WriteField, glb) {
  const GirthField girth = sampleField();
  const LoadedMesh loaded = sample();
  const auto glb = fieldGlb(loaded, fieldsOf(girth));
  ASSERT_TRUE(glb.ok());
  const std::string& file = glb.value();
  const Json document = jsonOf(file);
  const Json& primitive = document["meshes"][0]["primitives"][0];
  const Json& attributes = primitive["attributes"];
  EXPECT_EQ(attributes.size(), 4u);
  EXPECT_EQ(floatsOf(file, attributes["_IGF"]),
            (std::vector<float>{1.5f, static_cast<float>(1.0 / 3), -1, 2}));
  EXPECT_EQ(floatsOf(file, attributes["_KIND"]), (std::vector<float>{0, 1, -1, 0}));
  EXPECT_EQ(primitive["mode"], 4);
  EXPECT_EQ(document["meshes"][0]["extras"]["fields"]["_IGF"]["method"], "exact");
  // The darkest colour of the map where the value is least, the lightest where it is greatest.
  const Json& colours = document["accessors"][attributes["COLOR_0"].get<std::size_t>()];
  EXPECT_EQ(colours["componentType"], 5123);
  EXPECT_TRUE(colours["normalized"]);
  EXPECT_EQ(colours["count"], 4);
  const std::size_t begin = offsetOf(file, colours);
  EXPECT_EQ(file.substr(begin + 8, 8), packed({3788, 20, 5810, 65535}, 2));
  EXPECT_EQ(file.substr(begin + 16, 8), packed({14027, 14027, 14027, 65535}, 2)) << "no value";
  EXPECT_EQ(file.substr(begin + 24, 8), packed({64372, 52369, 1212, 65535}, 2));
  // The bounds are those of the floats that are there.
  for (const auto& [name, accessor] : attributes.items()) {
    if (name == "COLOR_0") continue;
    const Json& about = document["accessors"][accessor.get<std::size_t>()];
    const std::vector<float> values = floatsOf(file, accessor);
    const std::size_t components = about["min"].size();
    for (std::size_t k = 0; k < components; ++k) {
      float low = values[k], high = values[k];
      for (std::size_t i = k; i < values.size(); i += components) {
        low = std::min(low, values[i]);
        high = std::max(high, values[i]);
      }
      EXPECT_EQ(about["min"][k].get<double>(), static_cast<double>(low)) << name;
      EXPECT_EQ(about["max"][k].get<double>(), static_cast<double>(high)) << name;
    }
  }
  // The surface comes back through our own reader.
  const auto again = read(file, "field.glb");
  ASSERT_TRUE(again.ok()) << messageOf(again);
  EXPECT_EQ(again.value().mesh.vertexCount(), 4u);
  EXPECT_EQ(again.value().mesh.faceVertices(Face(2)), loaded.mesh.faceVertices(Face(2)));
}

TEST(WriteField, glbWithLoopsAndTips) {
  const GirthField girth = sampleField();
  LoadedMesh loaded = sample();
  loaded.unit = "millimetre";
  GirthLoop loop;
  loop.length = 2.5;
  loop.base = SurfacePoint::atVertex(Vertex(2));
  loop.midpoint = SurfacePoint::atVertex(Vertex(1));
  loop.points = {loop.base, loop.midpoint, loop.base};
  GirthLoop unresolved = loop;
  unresolved.points.clear();
  Tip tip;
  tip.vertices = {Vertex(0), Vertex(3)};
  tip.apex = Vertex(3);
  tip.jump = 0.5;
  const auto at = [](Index v) { return SurfacePoint::atVertex(Vertex(v)); };
  tip.contour = {{{at(0), at(1), at(2)}, true}};
  Tips tips;
  tips.tips = {tip};
  tips.arcs = {{{{at(1), at(3)}, false}, 4, 0.25}};
  tips.crossedEdges = 5;
  const std::vector<GirthLoop> loops{loop, unresolved};
  const auto glb = fieldGlb(loaded, fieldsOf(girth), std::nullopt, {loops, &tips});
  ASSERT_TRUE(glb.ok());
  const std::string& file = glb.value();
  const Json document = jsonOf(file);
  ASSERT_EQ(document["nodes"].size(), 4u);
  EXPECT_EQ(document["scenes"][0]["nodes"], Json::parse("[0,1,2,3]"));
  for (const Json& node : document["nodes"]) {
    EXPECT_EQ(node["scale"], Json::parse("[0.001,0.001,0.001]"));
  }
  const Json& surface = document["meshes"][0]["extras"];
  EXPECT_EQ(surface["crossedEdges"], 5);
  EXPECT_EQ(surface["tips"][0]["vertices"], Json::parse("[0,3]"));
  EXPECT_EQ(surface["tips"][0]["apex"], 3);
  EXPECT_EQ(surface["tips"][0]["jump"], 0.5);
  EXPECT_EQ(document["nodes"][1]["name"], "loop 2");
  const Json& aboutLoop = document["meshes"][1]["extras"]["loop"];
  EXPECT_EQ(aboutLoop["vertex"], 2);
  EXPECT_EQ(aboutLoop["length"], 2.5);
  EXPECT_EQ(aboutLoop["kind"], "loop");
  EXPECT_EQ(aboutLoop["midpoint"].size(), 3u);
  EXPECT_EQ(document["nodes"][2]["name"], "tip 0");
  EXPECT_EQ(document["meshes"][2]["extras"]["contour"], Json::parse(R"({"tip":0,"closed":true})"));
  EXPECT_EQ(document["nodes"][3]["name"], "arc 0");
  EXPECT_EQ(document["meshes"][3]["extras"]["arc"], Json::parse(R"({"length":4,"jump":0.25})"));
  // Three points and the first one again.
  const auto positions = [&](std::size_t mesh) {
    const Json& primitive = document["meshes"][mesh]["primitives"][0];
    EXPECT_EQ(primitive["mode"], 3);
    return floatsOf(file, primitive["attributes"]["POSITION"]).size() / 3;
  };
  EXPECT_EQ(positions(1), 3u);
  EXPECT_EQ(positions(2), 4u);
  EXPECT_EQ(positions(3), 2u);
  // Lines are no surface.
  const auto again = read(file, "figure.glb");
  ASSERT_TRUE(again.ok()) << messageOf(again);
  EXPECT_EQ(again.value().mesh.vertexCount(), 4u);
  EXPECT_EQ(again.value().vertexOfInput.size(), 4u);
}

TEST(WriteField, glbInOtherUnits) {
  LoadedMesh loaded = sample();
  loaded.unit = "millimetre";
  const GirthField girth = sampleField();
  const auto glb = fieldGlb(loaded, fieldsOf(girth), ColourRange{0, 4});
  ASSERT_TRUE(glb.ok());
  EXPECT_EQ(jsonOf(glb.value())["nodes"][0]["scale"], Json::parse("[0.001,0.001,0.001]"));
  const auto again = read(glb.value(), "field.glb");
  ASSERT_TRUE(again.ok()) << messageOf(again);
  EXPECT_EQ(again.value().mesh.position(Vertex(1)).x, 0.001);
}

TEST(WriteField, glbOfNumbersThatFloatsDoNotHold) {
  Wild w = wild();
  w.values[3] = std::numeric_limits<double>::infinity();
  const VertexField field{"wild", w.values, "", "", {}};
  const auto glb = fieldGlb(w.loaded, std::span(&field, 1));
  ASSERT_TRUE(glb.ok());
  const Json attributes = jsonOf(glb.value())["meshes"][0]["primitives"][0]["attributes"];
  for (const float value : floatsOf(glb.value(), attributes["_WILD"])) {
    EXPECT_TRUE(std::isfinite(value));
  }
}

TEST(WriteBarcodes, allFormats) {
  const LoadedMesh loaded = sample();
  const double never = std::numeric_limits<double>::infinity();
  std::vector<Barcode> barcodes(loaded.mesh.vertexCount());
  for (Barcode& barcode : barcodes) barcode.rest = {7, LoopKind::Antipodal};
  barcodes[1].bars = {{1, 1.25}, {2, never}};
  for (Barcode& barcode : barcodes) barcode.maxPersistence = 0.5;
  const Json json = Json::parse(barcodesJson(loaded, barcodes, "sample.obj"));
  EXPECT_EQ(json["file"], "sample.obj");
  EXPECT_EQ(json["maxPersistence"], 0.5);
  const std::size_t inputs = loaded.vertexOfInput.size();
  EXPECT_EQ(json["vertices"], inputs);
  std::string rows = "vertex,birth,death\n";
  std::vector<double> numbers;
  for (std::size_t i = 0; i < inputs; ++i) {
    const Vertex vertex = loaded.vertexOfInput[i];
    if (vertex == Vertex::none) {
      EXPECT_TRUE(json["bars"][i].is_null() && json["rest"][i].is_null());
      EXPECT_TRUE(json["restKind"][i].is_null());
      continue;
    }
    const bool has = vertex == Vertex(1);
    EXPECT_EQ(json["bars"][i], has ? Json::parse("[[1,1.25],[2,null]]") : Json::array());
    EXPECT_EQ(json["rest"][i], 7);
    EXPECT_EQ(json["restKind"][i], "antipodal");
    if (!has) continue;
    rows += std::to_string(i) + ",1,1.25\n" + std::to_string(i) + ",2,\n";
    const auto number = static_cast<double>(i);
    numbers.insert(numbers.end(), {number, 1, 1.25, number, 2, never});
  }
  EXPECT_GE(numbers.size(), 6u);
  EXPECT_EQ(barcodesCsv(loaded, barcodes), rows);
  const std::string npy = barcodesNpy(loaded, barcodes);
  EXPECT_TRUE(contains(npy, "'shape': (" + std::to_string(numbers.size() / 3) + ", 3), }"));
  ASSERT_EQ(npy.size() % 64, 8 * numbers.size() % 64);
  std::vector<double> read(numbers.size());
  std::memcpy(read.data(), npy.data() + npy.size() - 8 * read.size(), 8 * read.size());
  EXPECT_EQ(read, numbers);
  for (Barcode& barcode : barcodes) barcode.maxPersistence = never;
  EXPECT_TRUE(Json::parse(barcodesJson(loaded, barcodes, ""))["maxPersistence"].is_null());
}

TEST(WriteMesh, everyFormatIsReadAgain) {
  const LoadedMesh& loaded = wild().loaded;
  const SurfaceMesh& mesh = loaded.mesh;
  for (const Format format : {Format::Obj, Format::Ply, Format::Off, Format::Glb, Format::Stl}) {
    const auto file = meshFile(mesh, format, "");
    ASSERT_TRUE(file.ok());
    const auto again = modelOf(file.value(), "without a name");
    ASSERT_TRUE(again.ok()) << toString(format) << messageOf(again);
    EXPECT_EQ(again.value().format, format);
    EXPECT_TRUE(again.value().notes.empty()) << again.value().notes[0];
    const TriangleSoup& soup = again.value().soup;
    ASSERT_EQ(soup.triangles.size(), 3u * mesh.faceCount());
    const bool doubles = format != Format::Glb && format != Format::Stl;
    for (const Face f : mesh.faces()) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Index vertex = soup.triangles[3 * f + k];
        if (format != Format::Stl) {
          ASSERT_EQ(vertex, mesh.faceVertices(f)[k]);
        }
        const Vec3& position = mesh.position(Vertex(mesh.faceVertices(f)[k]));
        const double x = doubles ? position.x : static_cast<double>(static_cast<float>(position.x));
        ASSERT_EQ(soup.positions[3 * vertex], x) << toString(format);
      }
    }
    const auto surface = read(file.value(), "without a name");
    ASSERT_TRUE(surface.ok()) << toString(format) << messageOf(surface);
    EXPECT_EQ(surface.value().mesh.vertexCount(), mesh.vertexCount());
  }
  EXPECT_EQ(codeOf(meshFile(mesh, Format::Gltf)), "USAGE");
}

TEST(WriteMesh, unitsAreNamed) {
  const LoadedMesh loaded = sample();
  for (const Format format : {Format::Obj, Format::Ply, Format::Off, Format::Stl, Format::Glb}) {
    const auto file = meshFile(loaded.mesh, format, "millimetre");
    ASSERT_TRUE(file.ok());
    EXPECT_TRUE(contains(file.value(), "millimetre"));
    EXPECT_EQ(codeOf(modelOf(file.value(), "a")), "OK");
  }
}

TEST(WriteLoop, allFormats) {
  const LoadedMesh loaded = sample();
  GirthLoop loop;
  loop.length = 2.5;
  loop.angle = 1;
  loop.base = SurfacePoint::atVertex(Vertex(1));
  const SurfacePoint middle = SurfacePoint::onHalfedge(loaded.mesh.outgoing(Vertex(0)), 0.25);
  loop.points = {SurfacePoint::atVertex(Vertex(1)), middle, SurfacePoint::atVertex(Vertex(1))};
  loop.midpoint = middle;
  const std::string json = loopJson(loaded, loop, "sample.obj", true);
  EXPECT_TRUE(contains(
      json,
      R"({"file":"sample.obj","vertex":2,"unit":"","base":{"position":[1,0,0],"vertices":[2],"weights":[1]},"length":2.5,"kind":"loop","angle":1)"))
      << json;
  EXPECT_TRUE(contains(json, R"("vertices":[2],"weights":[1]})")) << json;
  EXPECT_TRUE(contains(json, R"("weights":[0.75,0.25]})")) << json;
  const std::string csv = loopCsv(loaded, loop);
  EXPECT_TRUE(contains(csv, "x,y,z\n1,0,0\n")) << csv;
  const std::string obj = loopObj(loaded, loop);
  EXPECT_TRUE(contains(obj, "v 1 0 0\n")) << obj;
  EXPECT_TRUE(contains(obj, "\nl 1 2 1\n")) << obj;
  const auto glb = loopGlb(loaded, loop);
  ASSERT_TRUE(glb.ok());
  const Json document = jsonOf(glb.value());
  const Json& primitive = document["meshes"][0]["primitives"][0];
  EXPECT_EQ(primitive["mode"], 3);
  EXPECT_EQ(floatsOf(glb.value(), primitive["attributes"]["POSITION"]),
            floatsOf(polyline(loaded.mesh, loop)));
  EXPECT_EQ(document["meshes"][0]["extras"]["length"], 2.5);
  loop.points.clear();
  EXPECT_EQ(codeOf(loopGlb(loaded, loop)), "EMPTY_MESH");
}

}  // namespace
}  // namespace girth::io::testing
