#include <sys/stat.h>
#include <unistd.h>

#include "files/rights.h"

namespace girth::io {

bool mayWriteFile(const std::filesystem::path& file) { return access(file.c_str(), W_OK) == 0; }

bool mayWriteFolder(const std::filesystem::path& folder) {
  return access(folder.c_str(), W_OK | X_OK) == 0;
}

bool copyRights(const std::filesystem::path& from, std::FILE* to) {
  const int descriptor = fileno(to);
  struct stat like {
  }, made{};
  if (stat(from.c_str(), &like) != 0 || fstat(descriptor, &made) != 0) return false;
  const bool isAlike = made.st_uid == like.st_uid && made.st_gid == like.st_gid;
  if (!isAlike && fchown(descriptor, like.st_uid, like.st_gid) != 0) return false;
  // After the owner, whose change takes some of the rights away.
  return fchmod(descriptor, like.st_mode & 07777) == 0;
}

}  // namespace girth::io
