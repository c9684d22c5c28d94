#include <io.h>

#include "files/rights.h"

namespace girth::io {
namespace {

/// The mode of _waccess that asks whether the attribute "read-only" is not set.
constexpr int kWritable = 2;

}  // namespace

bool mayWriteFile(const std::filesystem::path& file) {
  return _waccess(file.c_str(), kWritable) == 0;
}

bool mayWriteFolder(const std::filesystem::path& folder) {
  return _waccess(folder.c_str(), kWritable) == 0;
}

bool copyRights(const std::filesystem::path&, std::FILE*) { return true; }

}  // namespace girth::io
