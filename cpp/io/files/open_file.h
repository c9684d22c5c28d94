// Files of the C library that close themselves.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>

namespace girth::io {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

/// Opens a file to be read or written as bytes; null, with a reason in errno, where that fails.
enum class OpenFor { Reading, Writing };
inline OpenFile openFile(const std::filesystem::path& path, OpenFor purpose) {
#ifdef _WIN32
  return OpenFile(_wfopen(path.c_str(), purpose == OpenFor::Reading ? L"rb" : L"wb"));
#else
  return OpenFile(std::fopen(path.c_str(), purpose == OpenFor::Reading ? "rb" : "wb"));
#endif
}

}  // namespace girth::io
