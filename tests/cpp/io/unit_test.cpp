// The unit of a model, there and back through every format that Girth writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "documents.h"
#include "girth/io/length_unit.h"
#include "girth/io/write_cut.h"
#include "girth/io/write_field.h"
#include "girth/io/write_mesh.h"

namespace girth::io::testing {
namespace {

LoadedMesh tetrahedronIn(std::string_view unit) {
  auto loaded = read("OFF\n4 4 6\n" + kVertexLines + kFaceLines, "tetrahedron.off");
  EXPECT_TRUE(loaded.ok()) << messageOf(loaded);
  loaded.value().unit = unit;
  return std::move(loaded).value();
}

double extentAlongX(const SurfaceMesh& mesh) {
  double high = 0;
  for (const Vertex v : mesh.vertices()) high = std::max(high, mesh.position(v).x);
  return high;
}

TEST(Unit, areListedInWords) { EXPECT_EQ(lengthUnitWords(), "um, mm, cm, m, km, in or ft"); }

/// All files of a surface, with the format that each has.
std::vector<std::pair<std::string, std::string>> filesOf(const LoadedMesh& loaded) {
  std::vector<std::pair<std::string, std::string>> files;
  const auto add = [&](const char* ending, const Result<std::string>& content) {
    EXPECT_TRUE(content.ok()) << ending;
    files.emplace_back(ending, content.value());
  };
  constexpr std::pair<const char*, Format> kFormats[]{{".obj", Format::Obj},
                                                      {".ply", Format::Ply},
                                                      {".stl", Format::Stl},
                                                      {".off", Format::Off},
                                                      {".glb", Format::Glb}};
  for (const auto& [ending, format] : kFormats) {
    add(ending, meshFile(loaded.mesh, format, loaded.unit));
  }
  const std::vector<double> values(4, 1.5);
  const VertexField field{"igf", values, loaded.unit, "exact", {}};
  add(".ply", fieldPly(loaded, std::span(&field, 1)));
  add(".glb", fieldGlb(loaded, std::span(&field, 1)));

  LoadedMesh coloured = tetrahedronIn(loaded.unit);
  coloured.attributes.push_back({"COLOR_0", 3, false, std::vector<double>(36, 0.5)});
  CutSurface cut{coloured.mesh, {}, {}};
  for (const Face f : coloured.mesh.faces()) cut.faces.push_back(f);
  for (const Vertex v : coloured.mesh.vertices()) cut.points.push_back(SurfacePoint::atVertex(v));
  const CutModel model = cutModel(cut);
  add(".obj", cutObj(coloured, model));
  add(".glb", cutGlb(coloured, model));
  for (const Format format : {Format::Obj, Format::Ply, Format::Glb}) {
    const char* ending = format == Format::Obj ? ".obj" : format == Format::Ply ? ".ply" : ".glb";
    add(ending, partFile(coloured, model, 0, format));
  }
  return files;
}

TEST(Unit, isReadAsItWasWritten) {
  std::vector<std::string_view> names{"", "parsec"};
  for (const LengthUnit& unit : lengthUnits()) names.push_back(unit.name);
  for (const std::string_view name : names) {
    for (const auto& [ending, content] : filesOf(tetrahedronIn(name))) {
      const auto again = read(content, "again" + ending);
      ASSERT_TRUE(again.ok()) << ending << ": " << messageOf(again);
      const LengthUnit* known = findLengthUnit(name);
      const bool isMetric = ending == ".glb" && known != nullptr;
      EXPECT_EQ(again.value().unit, known == nullptr ? "" : isMetric ? "metre" : name) << ending;
      EXPECT_EQ(extentAlongX(again.value().mesh), isMetric ? known->metres : 1) << ending;
    }
  }
}

TEST(Unit, mayBeASymbolInAComment) {
  const std::string faces = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const auto unitOf = [&](const std::string& head) {
    const auto model = modelOf(head + faces, "a.obj");
    EXPECT_TRUE(model.ok()) << messageOf(model);
    return model.ok() ? model.value().unit : "";
  };
  EXPECT_EQ(unitOf("# made by hand\r\n#unit: mm\r\n"), "millimetre");
  EXPECT_EQ(unitOf("#\tunit:in\n"), "inch");
  for (const char* head :
       {"# unit: mm or so\n", "# unit:\n", "# units: mm\n", "o unit: mm\n", ""}) {
    EXPECT_EQ(unitOf(head), "") << head;
  }
}

TEST(Unit, ofGltfIsTheMetreUnlessItsExtrasHaveAnother) {
  const auto unitOf = [&](const std::string& extras) {
    const TinyGltf tiny;
    std::string json = tiny.json();
    json.insert(json.find("\"primitives\""), extras);
    const auto model = modelOf(glb(json, tiny.binary), "a.glb");
    EXPECT_TRUE(model.ok()) << messageOf(model);
    return model.ok() ? model.value().unit : "";
  };
  for (const char* extras : {"", R"("extras":{},)", R"("extras":3,)", R"("extras":{"unit":3},)",
                             R"("extras":{"unit":"cm"},)"}) {
    EXPECT_EQ(unitOf(extras), "metre") << extras;
  }
  EXPECT_EQ(unitOf(R"("extras":{"unit":""},)"), "");
}

}  // namespace
}  // namespace girth::io::testing
