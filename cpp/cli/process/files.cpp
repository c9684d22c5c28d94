#include "process/files.h"

#include <cstdio>
#include <filesystem>
#include <system_error>

#include "files/folder_of.h"
#include "files/path_of.h"
#include "files/read_file.h"

namespace girth::cli {

namespace fs = std::filesystem;

Result<std::vector<std::byte>> readStandardInput() {
  static const Result<std::vector<std::byte>> kept = [] { return io::readToEnd(stdin); }();
  return kept;
}

std::optional<Error> makeFolderOf(const std::string& path) {
  std::error_code error;
  fs::create_directories(io::folderOf(io::pathOf(path)), error);
  if (!error) return std::nullopt;
  return makeError(ErrorCode::FileUnwritable, -1, "its folder cannot be made: " + error.message());
}

bool isFile(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(io::pathOf(path), ignored);
}

bool isOrdinary(const std::string& path) {
  std::error_code ignored;
  return !fs::exists(io::pathOf(path), ignored) || isFile(path);
}

void removeFile(const std::string& path) {
  std::error_code ignored;
  fs::remove(io::pathOf(path), ignored);
}

Result<std::string> keepAside(const std::string& path) {
  const fs::path old = io::pathOf(path);
  std::error_code error;
  for (std::size_t number = 2;; ++number) {
    fs::path name = old;
    name.replace_filename(
        io::pathOf(old.stem().string() + "-" + std::to_string(number) + old.extension().string()));
    if (fs::exists(fs::symlink_status(name, error))) continue;
    fs::rename(old, name, error);
    if (!error) return name.string();
    return makeError(ErrorCode::FileUnwritable, -1, "it cannot be renamed: " + error.message());
  }
}

bool isSameFile(const std::string& one, const std::string& other) {
  std::error_code ignored;
  return fs::equivalent(io::pathOf(one), io::pathOf(other), ignored);
}

}  // namespace girth::cli
