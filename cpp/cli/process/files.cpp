#include "process/files.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <system_error>

namespace girth::cli {
namespace {

namespace fs = std::filesystem;

Error fileError(ErrorCode code, const std::string& what) { return makeError(code, -1, what); }

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

Result<std::vector<std::byte>> allOf(std::FILE* file) {
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
      return fileError(ErrorCode::FileUnreadable,
                       std::string("it cannot be read: ") + std::strerror(errno));
    }
    return bytes;
  } catch (const std::bad_alloc&) {
    return fileError(ErrorCode::OutOfMemory, "there is not enough memory to hold the file");
  }
}

/// The folder that a file is to be put into.
fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

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
  return fileError(ErrorCode::FileUnwritable, "its symbolic links lead nowhere");
}

Error writeError(const char* what) {
  return fileError(ErrorCode::FileUnwritable, std::string(what) + ": " + std::strerror(errno));
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

Result<std::vector<std::byte>> readFile(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    return fileError(ErrorCode::FileUnreadable, "it is a folder, not a file");
  }
  const OpenFile file(std::fopen(path.c_str(), "rb"));
  if (!file) {
    if (errno == ENOENT || errno == ENOTDIR) {
      return fileError(ErrorCode::FileNotFound, "there is no such file");
    }
    return fileError(ErrorCode::FileUnreadable,
                     std::string("it cannot be opened: ") + std::strerror(errno));
  }
  return allOf(file.get());
}

Result<std::vector<std::byte>> readStandardInput() {
  static const Result<std::vector<std::byte>> kept = [] { return allOf(stdin); }();
  return kept;
}

io::ResourceReader resourcesBeside(const std::string& modelPath) {
  return [folder =
              folderOf(modelPath)](std::string_view name) -> std::optional<std::vector<std::byte>> {
    std::error_code error;
    const fs::path root = fs::canonical(folder, error);
    if (error) return std::nullopt;
    const fs::path target = fs::canonical(folder / std::string(name), error);
    if (error || !fs::is_regular_file(target, error)) return std::nullopt;
    // The reader refuses names that lead outside; a link could still lead there.
    const fs::path relative = target.lexically_relative(root);
    if (relative.empty() || *relative.begin() == "..") return std::nullopt;
    auto bytes = readFile(target.string());
    if (!bytes) return std::nullopt;
    return std::move(bytes).value();
  };
}

std::optional<Error> checkWritable(const std::string& path) {
  const auto target = targetOf(path);
  if (!target) return target.error();
  std::error_code ignored;
  const fs::path folder = folderOf(target.value());
  if (fs::is_directory(target.value(), ignored)) {
    return fileError(ErrorCode::FileUnwritable, "it is a folder");
  }
  if (!fs::is_directory(folder, ignored)) {
    return fileError(ErrorCode::FileUnwritable, "its folder does not exist");
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

std::optional<Error> makeFolderOf(const std::string& path) {
  std::error_code error;
  fs::create_directories(folderOf(path), error);
  if (!error) return std::nullopt;
  return fileError(ErrorCode::FileUnwritable, "its folder cannot be made: " + error.message());
}

bool isFile(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool isOrdinary(const std::string& path) {
  std::error_code ignored;
  return !fs::exists(path, ignored) || isFile(path);
}

void removeFile(const std::string& path) {
  std::error_code ignored;
  fs::remove(path, ignored);
}

bool isSameFile(const std::string& one, const std::string& other) {
  std::error_code ignored;
  return fs::equivalent(one, other, ignored);
}

std::string extensionOf(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

}  // namespace girth::cli
