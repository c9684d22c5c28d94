#include "files/read_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <new>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "files/folder_of.h"
#include "files/open_file.h"
#include "files/path_of.h"

namespace girth::io {

namespace fs = std::filesystem;

Result<std::vector<std::byte>> readFile(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(pathOf(path), ignored)) {
    return makeError(ErrorCode::FileUnreadable, -1, "it is a folder, not a file");
  }
  const OpenFile file = openFile(pathOf(path), OpenFor::Reading);
  if (!file) {
    if (errno == ENOENT || errno == ENOTDIR) {
      return makeError(ErrorCode::FileNotFound, -1, "there is no such file");
    }
    return makeError(ErrorCode::FileUnreadable, -1,
                     std::string("it cannot be opened: ") + std::strerror(errno));
  }
  return readToEnd(file.get());
}

Result<std::vector<std::byte>> readToEnd(std::FILE* file) {
  try {
    std::vector<std::byte> bytes;
    constexpr std::size_t kBlock = std::size_t{1} << 20;
    for (std::size_t got = kBlock; got == kBlock;) {
      const std::size_t before = bytes.size();
      bytes.resize(before + kBlock);
      got = std::fread(bytes.data() + before, 1, kBlock, file);
      bytes.resize(before + got);
    }
    if (std::ferror(file) != 0) {
      return makeError(ErrorCode::FileUnreadable, -1,
                       std::string("it cannot be read: ") + std::strerror(errno));
    }
    return bytes;
  } catch (const std::bad_alloc&) {
    return makeError(ErrorCode::OutOfMemory, -1, "there is not enough memory to hold the file");
  }
}

ResourceReader resourcesBeside(const std::string& modelPath) {
  return [folder = folderOf(pathOf(modelPath))](
             std::string_view name) -> std::optional<std::vector<std::byte>> {
    std::error_code error;
    const fs::path root = fs::canonical(folder, error);
    if (error) return std::nullopt;
    const fs::path target = fs::canonical(folder / pathOf(name), error);
    if (error || !fs::is_regular_file(target, error)) return std::nullopt;
    // The reader refuses names that lead outside; a link could still lead there.
    const fs::path relative = target.lexically_relative(root);
    if (relative.empty() || *relative.begin() == "..") return std::nullopt;
    auto bytes = readFile(target.string());
    if (!bytes) return std::nullopt;
    return std::move(bytes).value();
  };
}

}  // namespace girth::io
