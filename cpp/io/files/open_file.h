// Files of the C library that close themselves.
#pragma once

#include <cstdio>
#include <memory>

namespace girth::io {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

}  // namespace girth::io
