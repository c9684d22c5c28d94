// Models and fields as files, each in one line.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "../model_folder.h"
#include "girth/io/load_mesh.h"
#include "girth/io/save_field.h"
#include "girth/io/save_mesh.h"
#include "girth/io/write_mesh.h"

namespace girth::io {
namespace {

namespace fs = std::filesystem;

class Files : public test::ModelFolder {
 protected:
  Files() {
    write("tetrahedron.obj",
          "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  }

  std::string read(const std::string& name) const {
    std::ifstream file(models / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::string pathOf(const std::string& name) const { return (models / name).string(); }
};

TEST_F(Files, ALoadedModelHasItsSurface) {
  const auto loaded = loadMesh(pathOf("tetrahedron.obj"));
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded.value().mesh.faceCount(), 4u);
  PrepareOptions larger;
  larger.scale = 2;
  EXPECT_EQ(loadMesh(pathOf("tetrahedron.obj"), larger).value().mesh.area(),
            4 * loaded.value().mesh.area());
}

TEST_F(Files, BuffersAreFoundInTheModelsFolderAndNowhereElse) {
  writeBuffer(models / "model.bin");
  writeBuffer(models / "parts" / "inner.bin");
  writeBuffer(outside / "outer.bin");
  fs::create_symlink(outside / "outer.bin", models / "link.bin");
  EXPECT_TRUE(loadMesh(gltfWith("model.bin")).ok());
  EXPECT_TRUE(loadMesh(gltfWith("parts/inner.bin")).ok());
  for (const std::string uri : {"../outer.bin", "link.bin", "absent.bin"}) {
    const auto loaded = loadMesh(gltfWith(uri));
    ASSERT_FALSE(loaded.ok()) << uri;
    EXPECT_EQ(loaded.error().code, ErrorCode::MissingResource) << uri;
    EXPECT_EQ(loaded.error().file, pathOf("model.gltf"));
  }
  const fs::path before = fs::current_path();
  fs::current_path(models);
  EXPECT_TRUE(loadMesh((gltfWith("model.bin"), "model.gltf")).ok());
  fs::current_path(before);
}

TEST_F(Files, NamesAreUtf8) {
  const fs::path folder = models / u8"Größe 寸";
  fs::create_directory(folder);
  fs::copy_file(models / "tetrahedron.obj", folder / u8"körper.obj");
  const auto loaded = loadMesh((folder / u8"körper.obj").string());
  ASSERT_TRUE(loaded.ok());
  const std::string output = (folder / u8"wert é.csv").string();
  EXPECT_FALSE(saveField(output, loaded.value(), girthField(loaded.value().mesh)).has_value());
  EXPECT_TRUE(fs::exists(folder / u8"wert é.csv"));
}

TEST_F(Files, ErrorsOfLoadingNameFileElementAndRemedy) {
  const auto absent = loadMesh(pathOf("absent.obj"));
  ASSERT_FALSE(absent.ok());
  EXPECT_EQ(absent.error().code, ErrorCode::FileNotFound);
  EXPECT_EQ(absent.error().file, pathOf("absent.obj"));
  EXPECT_EQ(loadMesh(models.string()).error().code, ErrorCode::FileUnreadable);

  const auto bad = loadMesh(write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 nan 0\nf 1 2 3\n"));
  ASSERT_FALSE(bad.ok());
  EXPECT_EQ(bad.error().code, ErrorCode::NonFinitePosition);
  EXPECT_EQ(bad.error().element, 3);
  EXPECT_EQ(bad.error().file, pathOf("bad.obj"));
  EXPECT_FALSE(bad.error().hint.empty());
  const auto unknown = loadMesh(write("words.xyz", "no model at all"));
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().code, ErrorCode::UnknownFormat);
  EXPECT_NE(unknown.error().hint.find("GLB, glTF, OBJ, PLY, STL or OFF"), std::string::npos);
}

TEST_F(Files, AFieldIsSavedAsItsFilesNameEnds) {
  const LoadedMesh loaded = loadMesh(pathOf("tetrahedron.obj")).value();
  const GirthField girth = girthField(loaded.mesh);
  const VertexField field = girthVertexField(girth, GirthMethod::Exact, "");
  const auto wanted = [&](const char* format, const std::string& path) {
    return fieldFile(loaded, std::span(&field, 1), format, path).value();
  };
  for (const std::string format : {"csv", "json", "npy", "ply", "glb"}) {
    ASSERT_FALSE(saveField(pathOf("values." + format), loaded, girth).has_value()) << format;
    EXPECT_EQ(read("values." + format), wanted(format.c_str(), pathOf("values." + format)));
  }
  ASSERT_FALSE(saveField(pathOf("CAPITALS.CSV"), loaded, field).has_value());
  EXPECT_EQ(read("CAPITALS.CSV"), read("values.csv"));
  ASSERT_FALSE(saveField(pathOf("places.csv"), loaded, field, Columns::Positions).has_value());
  EXPECT_EQ(read("places.csv").substr(0, 18), "vertex,x,y,z,igf,k");
}

TEST_F(Files, ASurfaceIsSavedAsItsFilesNameEnds) {
  const LoadedMesh loaded = loadMesh(pathOf("tetrahedron.obj")).value();
  for (const std::string ending : {".obj", ".ply", ".stl", ".off", ".glb"}) {
    ASSERT_FALSE(saveMesh(pathOf("body" + ending), loaded.mesh, "millimetre").has_value());
    EXPECT_EQ(read("body" + ending),
              meshFile(loaded.mesh, *meshFormat(ending), "millimetre").value());
    const LoadedMesh again = loadMesh(pathOf("body" + ending)).value();
    EXPECT_EQ(again.mesh.faceCount(), loaded.mesh.faceCount());
    EXPECT_EQ(again.unit, ending == ".glb" ? "metre" : "millimetre");
  }
  ASSERT_FALSE(saveMesh(pathOf("BODY.OBJ"), loaded.mesh, "millimetre").has_value());
  EXPECT_EQ(read("BODY.OBJ"), read("body.obj"));
  for (const std::string name : {"body.gltf", "body.csv", "body"}) {
    const auto error = saveMesh(pathOf(name), loaded.mesh);
    ASSERT_TRUE(error.has_value()) << name;
    EXPECT_EQ(error->code, ErrorCode::Usage);
    EXPECT_EQ(error->file, pathOf(name));
    EXPECT_EQ(error->hint, "write .obj, .ply, .stl, .off or .glb");
  }
}

TEST_F(Files, WhatCannotBeSavedLeavesTheOldFile) {
  const LoadedMesh loaded = loadMesh(pathOf("tetrahedron.obj")).value();
  const GirthField girth = girthField(loaded.mesh);
  for (const std::string name : {"values.xyz", "values", "values.obj"}) {
    const auto error = saveField(pathOf(name), loaded, girth);
    ASSERT_TRUE(error.has_value()) << name;
    EXPECT_EQ(error->code, ErrorCode::Usage);
    EXPECT_EQ(error->file, pathOf(name));
    EXPECT_EQ(error->hint, "use .csv, .json, .npy, .ply or .glb");
    EXPECT_FALSE(fs::exists(pathOf(name)));
  }
  write("old.csv", "whole");
  const std::vector<double> tooFew(2);
  const auto error = saveField(pathOf("old.csv"), loaded, VertexField{"sdf", tooFew, "", "", {}});
  ASSERT_TRUE(error.has_value());
  EXPECT_EQ(error->code, ErrorCode::Usage);
  EXPECT_EQ(read("old.csv"), "whole");
  const auto absent = saveField(pathOf("absent/values.csv"), loaded, girth);
  ASSERT_TRUE(absent.has_value());
  EXPECT_EQ(absent->code, ErrorCode::FileUnwritable);
}

}  // namespace
}  // namespace girth::io
