#include "files/write_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "files/folder_of.h"
#include "files/open_file.h"

namespace girth::io {
namespace {

namespace fs = std::filesystem;

/// The file that a name means: where its symbolic links lead to, whether there is something or not.
Result<fs::path> targetOf(const std::string& path) {
  constexpr int kMostLinks = 40;
  fs::path target = path;
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

/// Writes into the file that is there, or makes one. `like`: whose owner and mode it is to have;
/// `keepsOwner` becomes false where it cannot have that owner.
std::optional<Error> writeInto(const fs::path& path, std::string_view content,
                               const struct stat* like, bool& keepsOwner) {
  OpenFile file(std::fopen(path.c_str(), "wb"));
  if (!file) return writeError("it cannot be opened for writing");
  if (like != nullptr) {
    const int descriptor = fileno(file.get());
    struct stat made {};
    fstat(descriptor, &made);
    const bool isAlike = made.st_uid == like->st_uid && made.st_gid == like->st_gid;
    keepsOwner = isAlike || fchown(descriptor, like->st_uid, like->st_gid) == 0;
    // After the owner, whose change takes some of the rights away.
    if (keepsOwner && fchmod(descriptor, like->st_mode & 07777) != 0) keepsOwner = false;
  }
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
  if (exists && access(target.value().c_str(), W_OK) != 0) {
    return writeError("it is there already and cannot be written");
  }
  const bool isReplaced = !exists || fs::is_regular_file(target.value(), ignored);
  if (isReplaced && access(folder.c_str(), W_OK | X_OK) != 0) {
    return writeError("its folder cannot be written");
  }
  return std::nullopt;
}

std::optional<Error> writeFile(const std::string& path, std::string_view content) {
  const auto target = targetOf(path);
  if (!target) return target.error();
  struct stat before {};
  const bool exists = stat(target.value().c_str(), &before) == 0;
  bool keepsOwner = true;
  // /dev/stdout and the like cannot be replaced, only written.
  if (exists && !S_ISREG(before.st_mode)) {
    return writeInto(target.value(), content, nullptr, keepsOwner);
  }
  const fs::path temporary = target.value().string() + ".part" + std::to_string(getpid());
  std::error_code failure;
  if (auto error = writeInto(temporary, content, exists ? &before : nullptr, keepsOwner)) {
    fs::remove(temporary, failure);
    return error;
  }
  if (!keepsOwner) {
    // The file belongs to somebody else, who lets us write it. There is room for it, as shown.
    fs::remove(temporary, failure);
    return writeInto(target.value(), content, nullptr, keepsOwner);
  }
  if (std::rename(temporary.c_str(), target.value().c_str()) != 0) {
    const Error error = writeError("it cannot be replaced");
    fs::remove(temporary, failure);
    return error;
  }
  return std::nullopt;
}

}  // namespace girth::io
