#include "girth/io/save_mesh.h"

#include "files/write_file.h"
#include "girth/io/write_mesh.h"
#include "text/ending.h"

namespace girth::io {

std::optional<Error> saveMesh(const std::string& path, const SurfaceMesh& mesh,
                              std::string_view unit) {
  const auto fault = [&]() -> std::optional<Error> {
    const auto format = meshFormat(endingOf(path));
    if (!format) {
      Error error = makeError(ErrorCode::Usage, -1, "no format of meshes has the file's ending");
      error.hint = "write .obj, .ply, .stl, .off or .glb";
      return error;
    }
    const auto content = meshFile(mesh, *format, unit);
    if (!content) return content.error();
    return writeFile(path, content.value());
  };
  auto error = fault();
  if (error) error->file = path;
  return error;
}

}  // namespace girth::io
