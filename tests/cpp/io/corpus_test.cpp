// Files from everywhere: each becomes a surface or a coded error, and soon.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "documents.h"

namespace girth::io::testing {
namespace {

namespace fs = std::filesystem;

std::optional<std::vector<std::byte>> contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || fs::is_directory(path)) return std::nullopt;
  const std::string content((std::istreambuf_iterator<char>(file)), {});
  return bytesOf(content);
}

bool isModel(const fs::path& path) {
  const std::string extension = path.extension().string();
  return extension != ".bin" && extension != ".mtl";
}

TEST(Corpus, everyFileIsASurfaceOrACodedError) {
  const char* data = std::getenv("GIRTH_DATA");
  if (data == nullptr) GTEST_SKIP() << "skipped: no corpus";
  std::size_t surfaces = 0;
  std::size_t errors = 0;
  for (const char* folder : {"gltf", "bad", "models"}) {
    if (!fs::is_directory(fs::path(data) / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(data) / folder)) {
      if (!isModel(entry.path())) continue;
      const auto bytes = contentOf(entry.path());
      if (!bytes) continue;
      const auto start = std::chrono::steady_clock::now();
      const auto result = readMesh(*bytes, entry.path().string(), [&](std::string_view name) {
        return contentOf(entry.path().parent_path() / std::string(name));
      });
      const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
      EXPECT_LT(time.count(), 20) << entry.path();
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

}  // namespace
}  // namespace girth::io::testing
