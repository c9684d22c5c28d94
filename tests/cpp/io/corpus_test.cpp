// Files from everywhere: each becomes a surface or a coded error.
#include <filesystem>

#include "documents.h"
#include "test_paths.h"

namespace girth::io::testing {
namespace {

namespace fs = std::filesystem;

bool isModel(const fs::path& path) {
  const std::string extension = path.extension().string();
  return extension != ".bin" && extension != ".mtl";
}

TEST(Corpus, everyFileIsASurfaceOrACodedError) {
  const std::string data = test::corpusFolder();
  if (data.empty()) GTEST_SKIP() << "skipped: no corpus";
  std::size_t surfaces = 0;
  std::size_t errors = 0;
  for (const char* folder : {"gltf", "bad", "models"}) {
    if (!fs::is_directory(fs::path(data) / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(data) / folder)) {
      if (!isModel(entry.path())) continue;
      const auto bytes = contentOf(entry.path());
      if (!bytes) continue;
      const auto result = readMesh(*bytes, entry.path().string(), [&](std::string_view name) {
        return contentOf(entry.path().parent_path() / std::string(name));
      });
      if (result) {
        ++surfaces;
        continue;
      }
      ++errors;
      const Error& error = result.error();
      EXPECT_NE(error.code, ErrorCode::Internal) << entry.path() << error.message;
      EXPECT_FALSE(error.message.empty() || error.hint.empty()) << entry.path();
      EXPECT_EQ(error.message.find('\n'), std::string::npos) << entry.path();
      EXPECT_LT(error.message.size(), 300u) << entry.path() << error.message;
    }
  }
  std::printf("%zu surfaces, %zu errors\n", surfaces, errors);
}

/// A file of the corpus, read; nothing where it is not there.
std::optional<Result<ReadModel>> modelAt(const std::string& data, const std::string& path) {
  const auto bytes = contentOf(fs::path(data) / path);
  if (!bytes) return std::nullopt;
  return readModel(*bytes, path);
}

TEST(Corpus, classesOfErrors) {
  const std::string data = test::corpusFolder();
  if (data.empty()) GTEST_SKIP() << "skipped: no corpus";
  const std::string assimp = "bad/assimp-models/", draco = "bad/draco-testdata/";
  const std::string tiny = "bad/tinyobjloader/models/";
  for (const auto& [path, code] : std::initializer_list<std::pair<std::string, const char*>>{
           {assimp + "invalid/empty.obj", "EMPTY_FILE"},
           {assimp + "invalid/empty.off", "EMPTY_FILE"},
           {assimp + "invalid/empty.ply", "EMPTY_FILE"},
           {assimp + "invalid/OutOfMemory.off", "MALFORMED_FILE"},
           {assimp + "OFF/invalid.off", "MALFORMED_FILE"},
           {assimp + "OBJ/box_UTF16BE.obj", "UNKNOWN_FORMAT"},
           {assimp + "OBJ/point_cloud.obj", "EMPTY_MESH"},
           {assimp + "OBJ/testline.obj", "EMPTY_MESH"},
           {assimp + "OBJ/testpoints.obj", "EMPTY_MESH"},
           {assimp + "PLY/points.ply", "EMPTY_MESH"},
           {assimp + "PLY/pond.0.ply", "EMPTY_MESH"},
           {draco + "float_inf_point_cloud.ply", "EMPTY_MESH"},
           {draco + "int_point_cloud.ply", "EMPTY_MESH"},
           {draco + "test_lines.obj", "EMPTY_MESH"},
           {draco + "inf_nan.obj", "NON_FINITE_POSITION"},
           {draco + "car.drc", "UNKNOWN_FORMAT"},
           {tiny + "invalid-face-definition.obj", "EMPTY_MESH"},
           {tiny + "invalid-relative-vertex-index.obj", "INDEX_OUT_OF_RANGE"},
           {tiny + "invalid-relative-texture-index.obj", "INDEX_OUT_OF_RANGE"},
           {tiny + "issue-140-zero-face-idx.obj", "INDEX_OUT_OF_RANGE"},
           {tiny + "line-prim.obj", "EMPTY_MESH"},
           {tiny + "points-prim.obj", "EMPTY_MESH"},
           {tiny + "test-nan.obj", "NON_FINITE_POSITION"}}) {
    const auto result = modelAt(data, path);
    if (!result) continue;
    EXPECT_EQ(codeOf(*result), code) << path << messageOf(*result);
  }
}

TEST(Corpus, sizesOfModels) {
  const std::string data = test::corpusFolder();
  if (data.empty()) GTEST_SKIP() << "skipped: no corpus";
  const std::string assimp = "bad/assimp-models/", draco = "bad/draco-testdata/";
  struct Case {
    std::string path;
    std::size_t vertices, triangles;
  };
  for (const Case& c :
       {Case{assimp + "OBJ/box.obj", 8, 12}, Case{assimp + "OBJ/concave_polygon.obj", 64, 64},
        Case{assimp + "OBJ/cube_with_vertexcolors.obj", 8, 12},
        Case{assimp + "OBJ/box_without_lineending.obj", 8, 12},
        Case{assimp + "OFF/Cube.off", 8, 12}, Case{assimp + "PLY/cube.ply", 8, 12},
        Case{assimp + "PLY/cube_binary.ply", 8, 12},
        Case{assimp + "PLY/cube_binary_header_with_RN_newline.ply", 8, 12},
        Case{assimp + "PLY/cube_binary_starts_with_nl.ply", 8, 12},
        Case{assimp + "PLY/Wuson.ply", 11184, 3732},
        Case{assimp + "STL/3DSMaxExport.STL", 6000, 2000},
        Case{assimp + "STL/triangle_with_two_solids.stl", 6, 2},
        Case{draco + "bun_zipper.ply", 35947, 69451}, Case{draco + "delim_test.ply", 24, 12},
        Case{draco + "test_extra_whitespace.ply", 3, 1},
        Case{"bad/geometry-central/dodecahedron_poly.obj", 20, 36},
        Case{"bad/geometry-central/stl_box_binary.stl", 36, 12},
        Case{"models/elephant_49918f_g3.off", 24955, 49918}}) {
    const auto result = modelAt(data, c.path);
    if (!result) continue;
    ASSERT_TRUE(result->ok()) << c.path << messageOf(*result);
    EXPECT_EQ(result->value().soup.positions.size(), 3 * c.vertices) << c.path;
    EXPECT_EQ(result->value().soup.triangles.size(), 3 * c.triangles) << c.path;
  }
}

TEST(Corpus, twinsInTextAndBinary) {
  const std::string data = test::corpusFolder();
  if (data.empty()) GTEST_SKIP() << "skipped: no corpus";
  for (const auto& [text, binary] : std::initializer_list<std::pair<std::string, std::string>>{
           {"bad/geometry-central/stl_box_ascii.stl", "bad/geometry-central/stl_box_binary.stl"},
           {"bad/assimp-models/STL/Spider_ascii.stl", "bad/assimp-models/STL/Spider_binary.stl"},
           {"bad/draco-testdata/test_pos_color_ascii.ply",
            "bad/draco-testdata/test_pos_color.ply"}}) {
    const auto a = modelAt(data, text), b = modelAt(data, binary);
    if (!a || !b) continue;
    ASSERT_TRUE(a->ok() && b->ok()) << text;
    const TriangleSoup &first = a->value().soup, &second = b->value().soup;
    ASSERT_EQ(first.positions.size(), second.positions.size()) << text;
    EXPECT_EQ(first.triangles, second.triangles) << text;
    for (std::size_t i = 0; i < first.positions.size(); ++i) {
      ASSERT_NEAR(first.positions[i], second.positions[i], 1e-5) << text << i;
    }
  }
}

}  // namespace
}  // namespace girth::io::testing
