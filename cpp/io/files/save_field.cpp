#include "girth/io/save_field.h"

#include <utility>

#include "files/write_file.h"
#include "text/ending.h"

namespace girth::io {
namespace {

std::optional<Error> saved(const std::string& path, const LoadedMesh& loaded,
                           std::span<const VertexField> fields, Columns columns) {
  const std::string ending = endingOf(path);
  const auto content =
      fieldFile(loaded, fields, ending.empty() ? "" : ending.substr(1), path, columns);
  if (!content) return content.error();
  return writeFile(path, content.value());
}

}  // namespace

std::optional<Error> saveField(const std::string& path, const LoadedMesh& loaded,
                               std::span<const VertexField> fields, Columns columns) {
  auto error = saved(path, loaded, fields, columns);
  if (error) error->file = path;
  return error;
}

std::optional<Error> saveField(const std::string& path, const LoadedMesh& loaded,
                               const VertexField& field, Columns columns) {
  return saveField(path, loaded, std::span(&field, 1), columns);
}

std::optional<Error> saveField(const std::string& path, const LoadedMesh& loaded,
                               const GirthField& field, GirthMethod method) {
  return saveField(path, loaded, girthVertexField(field, method, loaded.unit));
}

}  // namespace girth::io
