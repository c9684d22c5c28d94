#include "process/files.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
#include <system_error>

#include "process/report.h"

namespace girth::cli {
namespace {

namespace fs = std::filesystem;

Error fileError(ErrorCode code, const std::string& what) { return makeError(code, -1, what); }

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

/// The folder that a file is to be put into.
fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
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
  try {
    std::vector<std::byte> bytes;
    constexpr std::size_t kBlock = std::size_t{1} << 20;
    for (std::size_t got = kBlock; got == kBlock;) {
      const std::size_t before = bytes.size();
      bytes.resize(before + kBlock);
      got = std::fread(bytes.data() + before, 1, kBlock, file.get());
      bytes.resize(before + got);
    }
    if (std::ferror(file.get()) != 0) {
      return fileError(ErrorCode::FileUnreadable,
                       std::string("it cannot be read: ") + std::strerror(errno));
    }
    return bytes;
  } catch (const std::bad_alloc&) {
    return fileError(ErrorCode::OutOfMemory, "there is not enough memory to hold the file");
  }
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
  std::error_code ignored;
  const fs::path folder = folderOf(path);
  if (fs::is_directory(path, ignored)) {
    return fileError(ErrorCode::FileUnwritable, "it is a folder");
  }
  if (!fs::is_directory(folder, ignored)) {
    return fileError(ErrorCode::FileUnwritable, "its folder does not exist");
  }
  if (access(folder.c_str(), W_OK) != 0) {
    return fileError(ErrorCode::FileUnwritable,
                     std::string("its folder cannot be written: ") + std::strerror(errno));
  }
  return std::nullopt;
}

std::optional<Error> checkOutput(const std::string& path,
                                 std::initializer_list<std::string_view> endings) {
  if (std::find(endings.begin(), endings.end(), extensionOf(path)) != endings.end()) {
    return checkWritable(path);
  }
  std::string hint = "use ";
  for (const std::string_view& ending : endings) {
    if (&ending != endings.begin()) hint += &ending == endings.end() - 1 ? " or " : ", ";
    hint += ending;
  }
  return usageError("the output's name has no known ending", hint);
}

std::optional<Error> writeFile(const std::string& path, std::string_view content) {
  // /dev/stdout and the like cannot be replaced, only written.
  std::error_code ignored;
  const bool special = fs::exists(path, ignored) && !fs::is_regular_file(path, ignored);
  const std::string temporary = special ? path : path + ".part" + std::to_string(getpid());
  const auto failed = [&](const char* what) {
    const std::string message = std::string(what) + ": " + std::strerror(errno);
    if (!special) std::remove(temporary.c_str());
    return fileError(ErrorCode::FileUnwritable, message);
  };
  OpenFile file(std::fopen(temporary.c_str(), "wb"));
  if (!file) return failed("it cannot be opened for writing");
  if (std::fwrite(content.data(), 1, content.size(), file.get()) != content.size() ||
      std::fflush(file.get()) != 0) {
    return failed("it cannot be written");
  }
  if (std::fclose(file.release()) != 0) return failed("it cannot be written");
  if (!special && std::rename(temporary.c_str(), path.c_str()) != 0) {
    return failed("it cannot be replaced");
  }
  return std::nullopt;
}

std::string extensionOf(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  for (char& c : extension) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return extension;
}

}  // namespace girth::cli
