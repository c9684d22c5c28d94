// girth cut: along handles, contours and loops of a file, and a file for each part.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iomanip>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "command.h"
#include "known_models.h"

namespace girth::test {
namespace {

using Json = nlohmann::json;

TEST_F(Command, aFrameIsCutAlongItsHandle) {
  const std::string model = write("frame.obj", frame());
  // Cut round a bar it is a tube with two ends, and round its hole a band.
  const Json handles = Json::parse(run({"handles", model, "--json"}).output)["handles"];
  ASSERT_EQ(handles.size(), 2u);
  for (const std::string which : {"0", "1"}) {
    const Outcome outcome = run({"cut", model, "--handle", which, "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    const Json parts = Json::parse(outcome.output)["parts"];
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0]["genus"], 0);
    EXPECT_EQ(parts[0]["boundaries"], 2);
  }
  const Json parts =
      Json::parse(run({"cut", model, "--handles", "--cap", "--json"}).output)["parts"];
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0]["genus"], 0);
  EXPECT_EQ(parts[0]["boundaries"], 0);
  EXPECT_TRUE(contains(run({"cut", model, "--handle", "3"}).errors,
                       "there is no handle 3; handles are numbered from 0 to 1"));
  // Before 1.0 numbers counted from 1.
  EXPECT_TRUE(contains(run({"cut", model, "--handle", "2"}).errors,
                       "handles count from 0: 2 is taken as the last, 1, as before 1.0"));
  const Outcome none = run({"cut", kData + "/prism.obj", "--handle", "0"});
  EXPECT_EQ(none.exitCode, 1);
  EXPECT_TRUE(contains(none.errors, "there is no handle 0; the model has none")) << none.errors;
  // Nothing to cut along leaves the model whole.
  EXPECT_EQ(
      Json::parse(run({"cut", kData + "/prism.obj", "--handles", "--json"}).output)["parts"].size(),
      1u);
}

TEST_F(Command, anHourglassIsCutAtAContour) {
  const std::string model = write("hourglass.obj", hourglass());
  // Above and below the waist the girth passes 7 once each.
  const Outcome outcome = run({"cut", model, "--unit", "cm", "--at", "70mm", "--json"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  EXPECT_EQ(Json::parse(outcome.output)["parts"].size(), 3u);
  EXPECT_TRUE(contains(run({"cut", model, "--at", "7"}).output, "cut along 2 loops: 3 parts\n"));
  EXPECT_EQ(run({"cut", model, "--at", "0", "--json"}).exitCode, 2);
  for (const std::string level : {"-1", "nan", "inf", "wide", ""}) {
    const Outcome refused = run({"cut", model, "--at", level});
    EXPECT_EQ(refused.exitCode, 1) << level;
    EXPECT_FALSE(refused.errors.empty());
  }
}

TEST_F(Command, loopsOfAFileAreCutAlong) {
  const std::string model = write("hourglass.obj", hourglass());
  const Json expected = Json::parse(run({"cut", model, "--neck", "0", "--json"}).output)["parts"];
  for (const std::vector<std::string>& finding : {std::vector<std::string>{"necks", model},
                                                  {"loop", model, "6"},
                                                  {"loop", model, "8"},
                                                  {"bottleneck", model, "0", "12"}}) {
    std::vector<std::string> writing = finding;
    writing.insert(writing.end(), {"-o", path("curves.json")});
    ASSERT_EQ(run(writing).exitCode, 0);
    const Outcome outcome = run({"cut", model, "--along", path("curves.json"), "--json"});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    EXPECT_EQ(Json::parse(outcome.output)["parts"], expected);
  }
  // A loop across faces, based inside one.
  ASSERT_EQ(run({"loop", model, "--face", "3", "-o", path("curves.json")}).exitCode, 0);
  EXPECT_EQ(run({"cut", model, "--along", path("curves.json")}).exitCode, 0);
}

TEST_F(Command, damagedFilesOfLoopsAreNamed) {
  const std::string model = write("hourglass.obj", hourglass());
  const std::string point = R"({"vertices":[0],"weights":[1]})";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "it is no JSON"},
      {"{\"points\":", "it is no JSON"},
      {"[1]", "it is no JSON object"},
      {"{}", "no array \"points\""},
      {R"({"necks":3})", "\"necks\" is no array"},
      {R"({"necks":[3]})", "no array \"points\""},
      {R"({"points":[3]})", "has no \"vertices\""},
      {R"({"points":[{"vertices":[],"weights":[]}]})", "not one, two or three"},
      {R"({"points":[{"vertices":[0,1],"weights":[1]}]})", "not one, two or three"},
      {R"({"points":[{"vertices":[0],"weights":["a"]}]})", "is no number"},
      {R"({"points":[{"vertices":[99],"weights":[1]}]})", "does not have"},
      {R"({"points":[{"vertices":[-1],"weights":[1]}]})", "does not have"},
      {R"({"points":[{"vertices":[null],"weights":[1]}]})", "does not have"},
      {R"({"points":[{"vertices":[0,14],"weights":[0.5,0.5]}]})", "an edge that the model"},
      {R"({"points":[{"vertices":[0,1,14],"weights":[0.5,0.25,0.25]}]})", "a face that the model"},
      {R"({"points":[{"vertices":[0,1],"weights":[7,-6]},)" + point + "]}", "none of the surface"},
      {R"({"points":[)" + point + R"(,{"vertices":[14],"weights":[1]}]})", "no face of the point"}};
  for (const auto& [content, words] : cases) {
    const std::string file = write("curves.json", content);
    const Outcome outcome = run({"cut", model, "--along", file});
    EXPECT_NE(outcome.exitCode, 0) << content;
    EXPECT_TRUE(contains(outcome.errors, words)) << content << outcome.errors;
  }
  EXPECT_TRUE(contains(run({"cut", model, "--along", path("absent.json")}).errors,
                       "absent.json: FILE_NOT_FOUND"));
}

TEST_F(Command, eachPartHasAFile) {
  const std::string model = write("hourglass.obj", hourglass());
  for (const std::string ending : {"stl", "obj", "ply", "off", "glb"}) {
    const Outcome outcome =
        run({"cut", model, "--neck", "0", "--cap", "-o", path("half-*." + ending)});
    ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
    for (const char* number : {"0", "1"}) {
      const Outcome info =
          run({"info", path("half-" + std::string(number) + "." + ending), "--json"});
      ASSERT_EQ(info.exitCode, 0) << info.errors;
      EXPECT_EQ(Json::parse(info.output)["faces"], 16) << ending;  // twelve and a cap of four
    }
    EXPECT_FALSE(fs::exists(path("half-2." + ending)));
  }
  const auto refused = [&](const std::vector<std::string>& more, const std::string& words) {
    std::vector<std::string> arguments{"cut", model, "--neck", "0", "-o"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 1) << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, words)) << outcome.errors;
  };
  refused({path("parts.stl")}, "put a star into the name");
  refused({path("part-*.csv")}, "leave the star out");
  refused({path("part-*")}, "no known ending");
  // The second part would replace the model.
  fs::copy_file(model, path("glass-1.obj"));
  const Outcome outcome =
      run({"cut", path("glass-1.obj"), "--neck", "0", "-o", path("glass-*.obj")});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_TRUE(contains(outcome.errors, "it would replace the model that is read"));
  EXPECT_FALSE(fs::exists(path("glass-0.obj")));
  // No folder to write to.
  EXPECT_TRUE(contains(run({"cut", model, "--neck", "0", "-o", path("none/part-*.stl")}).errors,
                       "FILE_UNWRITABLE"));
}

TEST_F(Command, oneThingIsCutAlong) {
  const std::string model = write("hourglass.obj", hourglass());
  for (const std::vector<std::string>& two : {std::vector<std::string>{"6", "--necks"},
                                              {"--neck", "0", "--handles"},
                                              {"--at", "7", "--along", "x.json"},
                                              {"--neck", "0", "--necks"}}) {
    std::vector<std::string> arguments{"cut", model};
    arguments.insert(arguments.end(), two.begin(), two.end());
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_TRUE(contains(outcome.errors, "several things to cut along are named"));
  }
}

/// The hourglass as PLY with colours and a field. Red follows the height, and the field is linear
/// in space.
std::string colouredHourglass() {
  std::vector<std::string> vertices, faces;
  for (const std::string& line : linesOf(hourglass())) {
    if (line.rfind("v ", 0) == 0) {
      std::istringstream words(line.substr(2));
      double x = 0, y = 0, z = 0;
      words >> x >> y >> z;
      const int red = static_cast<int>(vertices.size() * 7 % 256);
      std::ostringstream text;
      text << std::setprecision(17) << x << ' ' << y << ' ' << z << ' ' << red << " 200 "
           << 255 - red << ' ' << 0.1 + 0.7 * x - 0.3 * y + 0.9 * z;
      vertices.push_back(text.str());
    } else if (line.rfind("f ", 0) == 0) {
      std::istringstream words(line.substr(2));
      std::vector<int> corners;
      for (int corner = 0; words >> corner;) corners.push_back(corner - 1);
      std::string text = std::to_string(corners.size());
      for (const int corner : corners) text += " " + std::to_string(corner);
      faces.push_back(text);
    }
  }
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(vertices.size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\n"
                     "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                     "property double quality\nelement face " +
                     std::to_string(faces.size()) +
                     "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const std::string& line : vertices) text += line + "\n";
  for (const std::string& line : faces) text += line + "\n";
  return text;
}

/// A vertex of a binary PLY with colours and one field.
struct ColouredVertex {
  double x, y, z, quality;
  std::array<int, 3> colour;
};
std::vector<ColouredVertex> colouredVertices(const std::string& ply) {
  const std::size_t count =
      std::stoul(ply.substr(ply.find("element vertex ") + std::strlen("element vertex ")));
  std::size_t at = ply.find("end_header\n") + std::strlen("end_header\n");
  const auto number = [&] {
    double value = 0;
    std::memcpy(&value, ply.data() + at, 8);
    at += 8;
    return value;
  };
  std::vector<ColouredVertex> vertices(count);
  for (ColouredVertex& v : vertices) {
    v.x = number();
    v.y = number();
    v.z = number();
    for (int& channel : v.colour) channel = static_cast<unsigned char>(ply[at++]);
    v.quality = number();
  }
  return vertices;
}

TEST_F(Command, partsKeepColoursAndFields) {
  const std::string model = write("coloured.ply", colouredHourglass());
  std::map<std::array<double, 3>, ColouredVertex> known;
  for (const std::string& line : linesOf(colouredHourglass())) {
    std::istringstream words(line);
    ColouredVertex v{};
    if (words >> v.x >> v.y >> v.z >> v.colour[0] >> v.colour[1] >> v.colour[2] >> v.quality) {
      known[{v.x, v.y, v.z}] = v;
    }
  }
  ASSERT_GE(known.size(), 12u);
  // Along a contour of the girth, which crosses edges.
  const Json necks = Json::parse(run({"necks", model, "--json"}).output)["necks"];
  ASSERT_FALSE(necks.empty());
  const double level = 1.13 * necks[0]["length"].get<double>();
  const Outcome outcome =
      run({"cut", model, "--at", std::to_string(level), "--cap", "-o", path("part-*.ply")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  std::size_t old = 0, made = 0;
  for (int part = 1; part <= 2; ++part) {
    for (const ColouredVertex& v :
         colouredVertices(contentOf(path("part-" + std::to_string(part) + ".ply")))) {
      const auto found = known.find({v.x, v.y, v.z});
      if (found != known.end()) {
        ++old;
        EXPECT_EQ(v.colour, found->second.colour);
        EXPECT_EQ(v.quality, found->second.quality);
        continue;
      }
      ++made;
      EXPECT_EQ(v.colour[1], 200);
      EXPECT_NEAR(v.colour[0] + v.colour[2], 255, 1);
      EXPECT_NEAR(v.quality, 0.1 + 0.7 * v.x - 0.3 * v.y + 0.9 * v.z, 1e-12);
    }
  }
  EXPECT_GE(old, known.size() / 2);
  EXPECT_GE(made, 8u);
  // Other formats have these numbers too.
  for (const std::string ending : {"glb", "obj"}) {
    const std::string file = path("parts." + ending);
    ASSERT_EQ(run({"cut", model, "--at", std::to_string(level), "-o", file}).exitCode, 0);
    const std::string content = contentOf(file);
    EXPECT_TRUE(contains(content, ending == "glb" ? "\"COLOR_0\"" : " 0.7843137254901961 "));
    if (ending == "glb") {
      EXPECT_TRUE(contains(content, "\"_quality\""));
    }
  }
  // A part is a coloured model again.
  ASSERT_EQ(run({"cut", path("part-0.ply"), "--handles", "-o", path("again-*.ply")}).exitCode, 0);
  std::vector<ColouredVertex> once = colouredVertices(contentOf(path("part-0.ply")));
  const std::vector<ColouredVertex> again = colouredVertices(contentOf(path("again-0.ply")));
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].colour, again[i].colour);
    EXPECT_EQ(once[i].quality, again[i].quality);
  }
}

/// Four bytes of a little-endian file.
template <class T>
void append(std::string& bytes, T number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// The hourglass as glTF: a colour, a texture coordinate and a field that are linear in space.
std::string gltfHourglass() {
  std::string positions, colours, texture, fields, indices;
  std::size_t vertices = 0, corners = 0;
  for (const std::string& line : linesOf(hourglass())) {
    std::istringstream words(line.substr(std::min<std::size_t>(2, line.size())));
    if (line.rfind("v ", 0) == 0) {
      float x = 0, y = 0, z = 0;
      words >> x >> y >> z;
      ++vertices;
      for (const float coordinate : {x, y, z}) append(positions, coordinate);
      for (const float channel : {0.5F + x / 64, 0.5F + y / 64, 0.5F + z / 64, 1.0F}) {
        append(colours, channel);
      }
      append(texture, 2 * x);
      append(texture, -y);
      append(fields, 4 + x - 2 * y + 8 * z);
    } else if (line.rfind("f ", 0) == 0) {
      std::vector<std::uint32_t> polygon;
      for (std::uint32_t corner = 0; words >> corner;) polygon.push_back(corner - 1);
      for (std::size_t k = 2; k < polygon.size(); ++k, corners += 3) {
        for (const std::size_t c : {std::size_t{0}, k - 1, k}) append(indices, polygon[c]);
      }
    }
  }
  const std::string binary = positions + colours + texture + fields + indices;
  Json document = {{"asset", {{"version", "2.0"}}},
                   {"scene", 0},
                   {"scenes", {{{"nodes", {0}}}}},
                   {"nodes", {{{"mesh", 0}}}}};
  std::size_t offset = 0;
  const auto add = [&](const std::string& bytes, int component, std::size_t count,
                       const char* type) {
    document["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
    document["accessors"].push_back({{"bufferView", document["accessors"].size()},
                                     {"componentType", component},
                                     {"count", count},
                                     {"type", type}});
    offset += bytes.size();
  };
  add(positions, 5126, vertices, "VEC3");
  add(colours, 5126, vertices, "VEC4");
  add(texture, 5126, vertices, "VEC2");
  add(fields, 5126, vertices, "SCALAR");
  add(indices, 5125, corners, "SCALAR");
  document["meshes"] = {
      {{"primitives",
        {{{"attributes", {{"POSITION", 0}, {"COLOR_0", 1}, {"TEXCOORD_0", 2}, {"_x", 3}}},
          {"indices", 4}}}}}};
  document["buffers"] = {{{"byteLength", binary.size()}}};
  std::string json = document.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string file = "glTF";
  append(file, std::uint32_t{2});
  append(file, static_cast<std::uint32_t>(28 + json.size() + binary.size()));
  append(file, static_cast<std::uint32_t>(json.size()));
  file += "JSON" + json;
  append(file, static_cast<std::uint32_t>(binary.size()));
  return file + std::string("BIN\0", 4) + binary;
}

/// The floats of an accessor of a GLB's first mesh.
std::vector<float> floatsOf(const std::string& file, const std::string& attribute) {
  std::uint32_t length = 0;
  std::memcpy(&length, file.data() + 12, 4);
  const Json document = Json::parse(file.substr(20, length));
  const Json& primitive = document["meshes"][0]["primitives"][0];
  const Json& accessor = document["accessors"][primitive["attributes"][attribute].get<int>()];
  const Json& view = document["bufferViews"][accessor["bufferView"].get<int>()];
  std::vector<float> floats(view["byteLength"].get<std::size_t>() / 4);
  std::memcpy(floats.data(), file.data() + 28 + length + view.value("byteOffset", 0),
              4 * floats.size());
  return floats;
}

TEST_F(Command, partsOfGltfKeepAttributes) {
  const std::string model = write("coloured.glb", gltfHourglass());
  const Json necks = Json::parse(run({"necks", model, "--json"}).output)["necks"];
  ASSERT_FALSE(necks.empty());
  const std::string level = std::to_string(1.13 * necks[0]["length"].get<double>());
  ASSERT_EQ(run({"cut", model, "--at", level, "-o", path("part-*.glb")}).exitCode, 0);
  const std::vector<std::pair<std::string, std::size_t>> attributes{
      {"COLOR_0", 4}, {"TEXCOORD_0", 2}, {"_x", 1}};
  const std::string whole = contentOf(model);
  const std::vector<float> places = floatsOf(whole, "POSITION");
  std::map<std::array<float, 3>, std::size_t> known;
  for (std::size_t v = 0; 3 * v < places.size(); ++v) {
    known[{places[3 * v], places[3 * v + 1], places[3 * v + 2]}] = v;
  }
  std::size_t old = 0, made = 0;
  for (const char* number : {"0", "1"}) {
    const std::string part = contentOf(path("part-" + std::string(number) + ".glb"));
    const std::vector<float> positions = floatsOf(part, "POSITION");
    for (const auto& [name, width] : attributes) {
      const std::vector<float> values = floatsOf(part, name), given = floatsOf(whole, name);
      ASSERT_EQ(values.size() / width, positions.size() / 3);
      for (std::size_t v = 0; v < values.size() / width; ++v) {
        const float x = positions[3 * v], y = positions[3 * v + 1], z = positions[3 * v + 2];
        const std::array<double, 4> colour{0.5 + x / 64, 0.5 + y / 64, 0.5 + z / 64, 1},
            texture{2 * x, -y}, field{4 + x - 2 * y + 8 * z};
        const auto& linear = name == "COLOR_0" ? colour : width == 2 ? texture : field;
        const auto found = known.find({x, y, z});
        ++(found != known.end() ? old : made);
        for (std::size_t k = 0; k < width; ++k) {
          // Values at the file's vertices keep their bits.
          if (found != known.end()) {
            EXPECT_EQ(values[width * v + k], given[width * found->second + k]);
          }
          EXPECT_NEAR(values[width * v + k], linear[k], 1e-4);
        }
      }
    }
  }
  EXPECT_GE(old, 3 * 12u);
  EXPECT_GE(made, 3 * 8u);
  // PLY has colours as on a screen, and a field beside its own x.
  ASSERT_EQ(run({"cut", model, "--at", level, "-o", path("part-*.ply")}).exitCode, 0);
  const std::string ply = contentOf(path("part-0.ply"));
  EXPECT_TRUE(contains(ply,
                       "property uchar alpha\nproperty double s\nproperty double t\n"
                       "property double _x\n"));
  // Back to GLB, a step of a byte away at most.
  ASSERT_EQ(run({"cut", path("part-0.ply"), "--handles", "-o", path("again-*.glb")}).exitCode, 0);
  const std::vector<float> before = floatsOf(contentOf(path("part-0.glb")), "COLOR_0"),
                           after = floatsOf(contentOf(path("again-0.glb")), "COLOR_0");
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(before[i], after[i], 0.005);
}

TEST_F(Command, partsKeepTheSeamOfATexture) {
  // The hourglass, whose faces each have texture coordinates of their own.
  std::string text;
  std::size_t faces = 0;
  for (const std::string& line : linesOf(hourglass())) {
    if (line.rfind("f ", 0) != 0) {
      text += line + "\n";
      continue;
    }
    std::istringstream words(line.substr(2));
    std::string face = "f";
    for (int corner = 0; words >> corner;) {
      face += " " + std::to_string(corner) + "/" + std::to_string(faces + 1);
    }
    text += "vt " + std::to_string(faces++) + " 0.5\n" + face + "\n";
  }
  const std::string model = write("seams.obj", text);
  const Json necks = Json::parse(run({"necks", model, "--json"}).output)["necks"];
  const std::string level = std::to_string(1.13 * necks[0]["length"].get<double>());
  const Outcome outcome = run({"cut", model, "--at", level, "-o", path("part-*.obj")});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.errors;
  // Each face still has one value, wherever it was cut.
  std::map<std::string, std::size_t> counts;
  for (const char* number : {"0", "1"}) {
    std::vector<std::string> texture;
    for (const std::string& line :
         linesOf(contentOf(path("part-" + std::string(number) + ".obj")))) {
      if (line.rfind("vt ", 0) == 0) texture.push_back(line);
      if (line.rfind("f ", 0) != 0) continue;
      std::vector<std::string> values;
      std::istringstream words(line.substr(2));
      for (std::string corner; words >> corner;) {
        values.push_back(texture.at(std::stoul(corner.substr(corner.find('/') + 1)) - 1));
      }
      ASSERT_EQ(values.size(), 3u);
      EXPECT_EQ(values[0], values[1]);
      EXPECT_EQ(values[0], values[2]);
      ++counts[values[0]];
    }
  }
  EXPECT_EQ(counts.size(), faces);
}

}  // namespace
}  // namespace girth::test
