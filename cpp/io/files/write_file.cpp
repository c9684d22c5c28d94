#include "files/write_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "files/folder_of.h"
#include "files/open_file.h"
#include "files/path_of.h"
#include "files/rights.h"

namespace girth::io {
namespace {

namespace fs = std::filesystem;

/// The file that a name means: where its symbolic links lead to, whether there is something or not.
Result<fs::path> targetOf(const std::string& path) {
  constexpr int kMostLinks = 40;
  fs::path target = pathOf(path);
  for (int links = 0; links < kMostLinks; ++links) {
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(target, error))) return target;
    const fs::path next = fs::read_symlink(target, error);
    if (error) break;
    target = next.is_absolute() ? next : folderOf(target) / next;
  }
  return makeError(ErrorCode::FileUnwritable, -1, "its symbolic links lead nowhere");
}

Error writeError(const char* what) {
  return makeError(ErrorCode::FileUnwritable, -1, std::string(what) + ": " + std::strerror(errno));
}

/// Writes into the file that is there, or makes one. `like`: whose rights it is to have;
/// `keepsRights` becomes false where it cannot have them.
std::optional<Error> writeInto(const fs::path& path, std::string_view content, const fs::path* like,
                               bool& keepsRights) {
  OpenFile file = openFile(path, OpenFor::Writing);
  if (!file) return writeError("it cannot be opened for writing");
  if (like != nullptr) keepsRights = copyRights(*like, file.get());
  if (std::fwrite(content.data(), 1, content.size(), file.get()) != content.size() ||
      std::fflush(file.get()) != 0) {
    return writeError("it cannot be written");
  }
  if (std::fclose(file.release()) != 0) return writeError("it cannot be written");
  return std::nullopt;
}

}  // namespace

std::optional<Error> checkWritable(const std::string& path) {
  const auto target = targetOf(path);
  if (!target) return target.error();
  std::error_code ignored;
  const fs::path folder = folderOf(target.value());
  if (fs::is_directory(target.value(), ignored)) {
    return makeError(ErrorCode::FileUnwritable, -1, "it is a folder");
  }
  if (!fs::is_directory(folder, ignored)) {
    return makeError(ErrorCode::FileUnwritable, -1, "its folder does not exist");
  }
  const bool exists = fs::exists(target.value(), ignored);
  if (exists && !mayWriteFile(target.value())) {
    return writeError("it is there already and cannot be written");
  }
  const bool isReplaced = !exists || fs::is_regular_file(target.value(), ignored);
  if (isReplaced && !mayWriteFolder(folder)) {
    return writeError("its folder cannot be written");
  }
  return std::nullopt;
}

std::optional<Error> writeFile(const std::string& path, std::string_view content) {
  const auto target = targetOf(path);
  if (!target) return target.error();
  std::error_code failure;
  const fs::file_status before = fs::status(target.value(), failure);
  const bool exists = fs::exists(before);
  bool keepsRights = true;
  // /dev/stdout and the like cannot be replaced, only written.
  if (exists && !fs::is_regular_file(before)) {
    return writeInto(target.value(), content, nullptr, keepsRights);
  }
  fs::path temporary = target.value();
  temporary += ".part" + std::to_string(getpid());
  if (auto error = writeInto(temporary, content, exists ? &target.value() : nullptr, keepsRights)) {
    fs::remove(temporary, failure);
    return error;
  }
  if (!keepsRights) {
    // The file belongs to somebody else, who lets us write it. There is room for it, as shown.
    fs::remove(temporary, failure);
    return writeInto(target.value(), content, nullptr, keepsRights);
  }
  fs::rename(temporary, target.value(), failure);
  if (failure) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    return makeError(ErrorCode::FileUnwritable, -1, "it cannot be replaced: " + failure.message());
  }
  return std::nullopt;
}

}  // namespace girth::io
