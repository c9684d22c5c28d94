// Findings of the fuzzers: each file is a surface or a coded error, and stays one.
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "documents.h"
#include "test_paths.h"

namespace girth::io::testing {
namespace {

namespace fs = std::filesystem;

TEST(Regression, everyFindingIsASurfaceOrACodedError) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(test::testData()) / "regressions")) {
    const std::string name = entry.path().filename().string();
    std::ifstream file(entry.path(), std::ios::binary);
    std::string content((std::istreambuf_iterator<char>(file)), {});
    PrepareOptions options;
    std::string ending = name.substr(0, name.find('-'));
    // As in tests/fuzz/fuzz_mesh.cpp.
    if (ending == "mesh" && !content.empty()) {
      constexpr std::array<const char*, 8> kEndings{"",    "obj", "ply",  "stl",
                                                    "off", "glb", "gltf", "zip"};
      const auto choice = static_cast<unsigned char>(content[0]);
      ending = kEndings[choice & 7];
      options.closeHoles = (choice & 8) != 0;
      options.weldDistance = (choice & 16) != 0 ? 0.125 : 0;
      if ((choice & 32) != 0) options.components = {0};
      content.erase(0, 1);
    }
    const auto result = readMesh(bytesOf(content), "model." + ending, {}, options);
    EXPECT_NE(codeOf(result), "INTERNAL") << name << messageOf(result);
    EXPECT_TRUE(result.ok() || (!messageOf(result).empty() && messageOf(result).size() < 400))
        << name;
    ++files;
  }
  EXPECT_GT(files, 0u);
}

}  // namespace
}  // namespace girth::io::testing
